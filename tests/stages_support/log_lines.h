// What the library tells a host's log.
#pragma once

#include "agaa_sdk.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace agaa::test {

struct LogLine {
    AgaaResult code;
    std::string text;
};

inline void AGAA_CALL collectLines(void* user, uint32_t severity, AgaaResult code, const char* message) {
    if (severity >= AGAA_SEVERITY_WARNING)
        static_cast<std::vector<LogLine>*>(user)->push_back({code, message});
}

inline AgaaLog logInto(std::vector<LogLine>& lines) {
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = collectLines;
    log.user = &lines;
    return log;
}

// As AgaaLogCallback says: it begins with the name of the function.
inline void expectOneSentence(const std::vector<LogLine>& lines, AgaaResult code, const char* what,
                              const char* contained = "") {
    ASSERT_EQ(lines.size(), 1u) << what;
    const std::string& text = lines[0].text;
    EXPECT_EQ(lines[0].code, code) << what;
    EXPECT_EQ(text.rfind("agaa", 0), 0u) << text;
    EXPECT_NE(text.find(": "), std::string::npos) << text;
    EXPECT_NE(text.find(contained), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.') << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_GT(text.size(), 30u) << text;
}

} // namespace agaa::test
