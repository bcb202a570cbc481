#include "log.h"

namespace agaa::conformance {

LogRecorder::LogRecorder() {
    const AgaaLog initial = AGAA_LOG_INIT;
    log_ = initial;
    log_.callback = receive;
    log_.user = this;
}

void AGAA_CALL LogRecorder::receive(void* user, uint32_t severity, AgaaResult code, const char* message) {
    static_cast<LogRecorder*>(user)->lines.push_back({severity, code, message ? message : ""});
}

std::vector<LogLine> LogRecorder::errors() const {
    std::vector<LogLine> errors;
    for (const LogLine& line : lines)
        if (line.severity == AGAA_SEVERITY_ERROR)
            errors.push_back(line);
    return errors;
}

void expectRefused(Test& test, AgaaResult got, AgaaResult expected, LogRecorder& log, const std::string& function,
                   const std::string& what, const std::string& words) {
    test.result(got, expected, what);
    const std::vector<LogLine> errors = log.errors();
    log.lines.clear();
    if (!test.check(errors.size() == 1,
                    what + ": the log has " + std::to_string(errors.size()) + " error messages where one is promised."))
        return;
    const std::string& text = errors[0].text;
    test.check(errors[0].code == got, what + ": the log has another code than the result.");
    test.check(text.rfind(function, 0) == 0, what + ": the message does not begin with " + function + ": " + text);
    test.check(!text.empty() && text.back() == '.', what + ": the message is no sentence: " + text);
    test.check(text.find(words) != std::string::npos, what + ": the message does not name " + words + ": " + text);
}

} // namespace agaa::conformance
