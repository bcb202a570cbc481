// Errors inside the library. They are thrown as values; the ABI turns them into result codes (api_guard.h).
#pragma once

#include "agaa_sdk.h"

#include <cstdarg>
#include <cstdio>
#include <new>
#include <string>
#include <utility>

namespace agaa {

struct Error {
    AgaaResult code;
    std::string message; // one sentence
};

// MinGW's printf is the one of C99, which its compiler must be told.
#if defined(__MINGW32__)
#define AGAA_PRINTF gnu_printf
#else
#define AGAA_PRINTF printf
#endif

// Formats sentences. It uses the locale: text for compilers and parsers must not contain its floating-point output.
[[gnu::format(AGAA_PRINTF, 1, 2)]] inline std::string format(const char* pattern, ...) {
    va_list arguments;
    va_start(arguments, pattern);
    char text[1024];
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

[[noreturn]] inline void fail(AgaaResult code, std::string message) { throw Error{code, std::move(message)}; }

// The code reaches the host even if there is no memory for the sentence.
[[noreturn]] inline void failPartial(const char* message) {
    Error error{AGAA_ERROR_PARTIAL, {}};
    try {
        error.message = message;
    } catch (const std::bad_alloc&) {
    }
    throw error;
}

inline void require(bool condition, AgaaResult code, const char* message) {
    if (!condition)
        fail(code, message);
}

} // namespace agaa
