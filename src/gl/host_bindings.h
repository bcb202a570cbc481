// The host's objects at the binding points that the SDK uses during draw callbacks. Needed with
// AGAA_GL_STATE_CALLBACKS: popState runs before the SDK binds its resources there, so it cannot restore these bindings.
#pragma once

#include "gl/bindings.h"

#include <vector>

namespace agaa::gl {

// Works like StateGuard, but for numbered binding points only: other changes of a callback persist.
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
