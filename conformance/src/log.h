// Recorder of the SDK's messages.
#pragma once

#include "suite.h"

namespace agaa::conformance {

struct LogLine {
    uint32_t severity;
    AgaaResult code;
    std::string text;
};

class LogRecorder {
public:
    LogRecorder();
    LogRecorder(const LogRecorder&) = delete;
    LogRecorder& operator=(const LogRecorder&) = delete;

    const AgaaLog* get() const { return &log_; }
    std::vector<LogLine> lines;
    std::vector<LogLine> errors() const;

private:
    static void AGAA_CALL receive(void* user, uint32_t severity, AgaaResult code, const char* message);
    AgaaLog log_;
};

// Checks the result of a call that must fail, and clears the log. The log must hold exactly one sentence, which begins
// with the function's name, ends with a full stop and has the code of the result. `words` is a part of the sentence,
// for example the member's name; it may be empty.
void expectRefused(Test& test, AgaaResult got, AgaaResult expected, LogRecorder& log, const std::string& function,
                   const std::string& what, const std::string& words = "");
// Checks only the result, for functions without a log.
inline void expectRefused(Test& test, AgaaResult got, AgaaResult expected, const std::string& what) {
    test.result(got, expected, what);
}

} // namespace agaa::conformance
