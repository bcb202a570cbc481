#include "render/sdk_log.h"

#include <stdexcept>
#include <utility>

namespace harness {

AgaaLog SdkLog::log() {
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onMessage;
    log.user = this;
    return log;
}

void SdkLog::check(AgaaResult result, const char* call) {
    if (result >= 0) {
        lastError_.clear();
        return;
    }
    std::string sentence = std::exchange(lastError_, {});
    if (sentence.empty())
        sentence = std::string(call) + " failed: " + agaaResultString(result) + ".";
    throw std::runtime_error(sentence);
}

void AGAA_CALL SdkLog::onMessage(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity < AGAA_SEVERITY_WARNING)
        return;
    SdkLog& log = *static_cast<SdkLog*>(user);
    log.texts_.emplace_back(message ? message : "");
    if (severity >= AGAA_SEVERITY_ERROR)
        log.lastError_ = log.texts_.back();
}

} // namespace harness
