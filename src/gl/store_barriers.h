// Barriers after shader stores. OpenGL orders all other commands of a context; stores need a barrier for each kind of
// later access.
#pragma once

#include "core/plan/plan.h"

#include <glad/gl.h>

#include <vector>

namespace agaa::gl {

class StoreBarriers {
public:
    explicit StoreBarriers(size_t resourceCount) : states_(resourceCount) {}

    // Returns the barrier bits that the pass needs. The caller issues the barrier.
    GLbitfield before(const Plan& plan, const Pass& pass, bool drawsUseImages);
    // Records the accesses of a pass, immediately before or after it is issued.
    void after(const Plan& plan, const Pass& pass);

private:
    struct State {
        bool stored = false;
        bool read = false;      // by a shader since the last barrier: later stores need a barrier
        GLbitfield visible = 0; // barriers issued since the last store
    };
    std::vector<State> states_;
};

} // namespace agaa::gl
