// Calls of the host's functions.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

// Callbacks must not throw. One that does counts as failed, because what the SDK began around it must come to an end.
template <typename Call>
AgaaResult contained(Call&& call) noexcept {
    try {
        return call();
    } catch (...) {
        return AGAA_ERROR_CALLBACK;
    }
}

} // namespace agaa
