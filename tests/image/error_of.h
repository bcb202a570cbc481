// The message of a failure.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

// Returns the message with which `action` fails, or "" if it succeeds.
inline std::string errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}
