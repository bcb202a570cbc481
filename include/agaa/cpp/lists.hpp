// C functions that are called twice, for a length and for the contents. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_LISTS_HPP
#define AGAA_CPP_LISTS_HPP

#include "agaa/cpp/result.hpp"

#include <string>
#include <vector>

namespace agaa::detail {

// call      AgaaResult(Count* count, T* elements).
// initial   Each element before the second call.
template <class Count, class T, class Call> Result<std::vector<T>> list(const T& initial, Call call) {
    Count count = 0;
    AgaaResult result = call(&count, static_cast<T*>(nullptr));
    if (result != AGAA_OK)
        return Failure{result};
    std::vector<T> elements(count, initial);
    if (count == 0)
        return elements;
    result = call(&count, elements.data());
    if (result != AGAA_OK)
        return Failure{result};
    elements.resize(count, initial);
    return elements;
}

// call      AgaaResult(size_t* size, char* text), where the size includes the zero.
template <class Call> Result<std::string> text(Call call) {
    size_t size = 0;
    AgaaResult result = call(&size, static_cast<char*>(nullptr));
    if (result != AGAA_OK)
        return Failure{result};
    std::string written(size, '\0');
    result = call(&size, written.data());
    if (result != AGAA_OK)
        return Failure{result};
    written.resize(size - 1);
    return written;
}

// Returns a struct that a call fills.
template <class T, class Call> Result<T> filled(T initial, Call call) {
    const AgaaResult result = call(&initial);
    if (result != AGAA_OK)
        return Failure{result};
    return initial;
}

} // namespace agaa::detail

#endif // AGAA_CPP_LISTS_HPP
