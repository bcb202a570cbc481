// The host's bindings where draw callbacks find the SDK's, for hosts that save and restore their state
// themselves: their popState comes before the SDK binds there, so it cannot bring these back.
#pragma once

#include "gl/bindings.h"

#include <vector>

namespace agaa::gl {

// As StateGuard; only of the numbered places, so what a callback does elsewhere stays.
class HostBindings {
public:
    HostBindings(const GladGLContext& gl, const HostDialect& dialect, bool compatibilityProfile);

    void capture();
    void restore() noexcept;

private:
    StateContext context_;
    std::vector<StateRow> rows_;
    std::vector<StateValue> values_;
};

} // namespace agaa::gl
