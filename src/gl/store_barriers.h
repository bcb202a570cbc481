// OpenGL orders all that a context does but for what shaders store: that needs a barrier for each way in which
// it is used next.
#pragma once

#include "core/plan/plan.h"

#include <glad/gl.h>

#include <vector>

namespace agaa::gl {

class StoreBarriers {
public:
    explicit StoreBarriers(size_t resourceCount) : states_(resourceCount) {}

    // What must be made visible before the pass; the caller issues it.
    GLbitfield before(const Plan& plan, const Pass& pass, bool drawsUseImages);
    // The pass is issued next, or was.
    void after(const Plan& plan, const Pass& pass);

private:
    struct State {
        bool stored = false;
        bool read = false;      // by a shader, since the last barrier: stores must not overtake it
        GLbitfield visible = 0; // barriers issued since the last store
    };
    std::vector<State> states_;
};

} // namespace agaa::gl
