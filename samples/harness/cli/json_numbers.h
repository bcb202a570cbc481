// Numbers in JSON files.
#pragma once

#include "scene/shortened.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>

namespace harness {

// Returns a count. Throws std::runtime_error with one sentence for other numbers, which casts would change or not
// allow.
template <class T> T countOf(const nlohmann::json& number) {
    if (!number.is_number_unsigned() || number.get<uint64_t>() > std::numeric_limits<T>::max())
        throw std::runtime_error(shortened(number.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) +
                                 " is not a whole number from 0 to " + std::to_string(std::numeric_limits<T>::max()) +
                                 ".");
    return number.get<T>();
}

} // namespace harness
