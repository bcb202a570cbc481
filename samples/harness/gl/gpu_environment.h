// The light of an environment on the device, for shaders/environment.glsl. It is bound to points that the SDK does not
// use.
#pragma once

#include "environment/environment.h"
#include "gl/objects.h"

namespace harness::gl {

class GpuEnvironment {
public:
    GpuEnvironment(const GladGLContext& gl, const Environment& environment);

    static constexpr GLuint mapUnit = 31, constantsBinding = 10;
    // Must be called before each frame.
    void bind() const;

private:
    const GladGLContext* gl_;
    Texture map_;
    Buffer constants_;
    Sampler sampler_;
};

} // namespace harness::gl
