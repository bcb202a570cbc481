// Saves the host's OpenGL state and sets it again.
#pragma once

#include "gl/state_context.h"

#include <vector>

namespace agaa::gl {

// Made, used and destroyed while the context that it is for is current; gl must live longer.
// Neither capture nor restore allocates, waits for the device, asks for or raises an OpenGL error,
// provided that no transform feedback is active. Errors that are pending stay so.
class StateGuard {
public:
    StateGuard(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile);

    // Reads every row of the table.
    void capture();
    // Sets every row to what was last captured. Objects deleted since become 0.
    void restore() noexcept;

    const StateContext& context() const { return context_; }
    // Row by row of the table, those that the context has, and element by element.
    const std::vector<StateValue>& captured() const { return values_; }

private:
    StateContext context_;
    std::vector<StateValue> values_;
};

} // namespace agaa::gl
