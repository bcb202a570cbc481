// The messages of the SDK, and its errors as exceptions.
#pragma once

#include "agaa_sdk.h"

#include <string>
#include <vector>

namespace harness {

// Keeps the messages of the log callback.
class SdkLog {
public:
    AgaaLog log();
    // Throws std::runtime_error with the SDK's sentence if the result is an error.
    void check(AgaaResult result, const char* call);
    // Returns the warnings and errors so far.
    const std::vector<std::string>& texts() const { return texts_; }

private:
    static void AGAA_CALL onMessage(void* user, uint32_t severity, AgaaResult code, const char* message);

    std::vector<std::string> texts_;
    std::string lastError_;
};

} // namespace harness
