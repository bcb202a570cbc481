// Calls of the host's functions.
#pragma once

#include "agaa_sdk.h"

namespace agaa {

// Calls a host function. Callbacks must not throw; one that does counts as failed, so that the SDK can finish what it
// began.
template <typename Call> AgaaResult contained(Call&& call) noexcept {
    try {
        return call();
    } catch (...) {
        return AGAA_ERROR_CALLBACK;
    }
}

} // namespace agaa
