// Saves and restores the host's OpenGL state.
#pragma once

#include "gl/state_context.h"

#include <vector>

namespace agaa::gl {

// Its context must be current whenever it is created, used or destroyed; gl must outlive it. If no transform feedback
// is active, capture and restore neither allocate, wait for the device, nor query or raise an OpenGL error. Pending
// errors stay pending.
class StateGuard {
public:
    StateGuard(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile);

    // Reads every row of the table.
    void capture();
    // Sets every row to the value that was captured last. Bindings of objects deleted since then become 0.
    void restore() noexcept;

    const StateContext& context() const { return context_; }
    // Values in the order of the table's rows and of their elements; rows that the context lacks are omitted.
    const std::vector<StateValue>& captured() const { return values_; }

private:
    StateContext context_;
    std::vector<StateValue> values_;
};

} // namespace agaa::gl
