// The boundary of the C ABI. Nothing throws across it, and each failure is logged in one sentence.
#pragma once

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/structs.h"

#include <new>

namespace agaa {

template <typename Body> AgaaResult guarded(const Log& log, const char* function, Body&& body) noexcept {
    const auto report = [&](AgaaResult code, const char* text) {
        try {
            log.write(AGAA_SEVERITY_ERROR, code, std::string(function) + ": " + text);
        } catch (...) {
            // Memory ran out while the message was made. The host gets the code only.
        }
        return code;
    };
    try {
        return body();
    } catch (const Error& error) {
        return report(error.code, error.message.c_str());
    } catch (const std::bad_alloc&) {
        return report(AGAA_ERROR_OUT_OF_MEMORY, "host memory is exhausted.");
    } catch (...) {
        return report(AGAA_ERROR_INTERNAL, "an unexpected internal failure.");
    }
}

// Does what guarded() above does, for functions that get the host's log. An invalid log is an error.
template <typename Body> AgaaResult guarded(const AgaaLog* log, const char* function, Body&& body) noexcept {
    return guarded(checkedLog(log), function, [&]() -> AgaaResult {
        if (log)
            readStruct(log);
        return body();
    });
}

// Writes by the two-call convention: without an array, the count; with an array, all elements. Throws Error if *count
// is too small.
template <typename Container, typename Element>
AgaaResult writeArray(const Container& source, uint32_t* count, Element* destination) {
    require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
    const uint32_t available = uint32_t(source.size());
    if (!destination) {
        *count = available;
        return AGAA_OK;
    }
    if (*count < available)
        fail(AGAA_ERROR_BUFFER_TOO_SMALL,
             format("the array holds %u elements where %u are needed.", *count, available));
    for (uint32_t i = 0; i < available; ++i)
        destination[i] = source[i];
    *count = available;
    return AGAA_OK;
}

} // namespace agaa
