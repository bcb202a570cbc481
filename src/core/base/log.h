// The host's log callback.
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace agaa {

// A copy of the host's log. It stays valid when the host's struct is gone.
class Log {
public:
    Log() = default;
    explicit Log(const AgaaLog* log) {
        if (log) {
            callback_ = log->callback;
            user_ = log->user;
        }
    }
    void write(AgaaSeverity severity, AgaaResult code, const std::string& message) const {
        if (callback_)
            callback_(user_, severity, code, message.c_str());
    }

private:
    AgaaLogCallback callback_ = nullptr;
    void* user_ = nullptr;
};

// Returns the host's log, or a log that writes nothing if the struct is not valid.
inline Log checkedLog(const AgaaLog* log) {
    constexpr uint32_t firstSize = 32; // in version 0.2, as in structs.inc
    const bool valid =
        log && log->sType == AGAA_STRUCTURE_TYPE_LOG && log->structSize >= firstSize && log->structSize % 8 == 0;
    return valid ? Log(log) : Log();
}

} // namespace agaa
