// Filtered shadow maps on the device, for shaders/filtered_shadows.glsl. They are bound to points that the SDK does not
// use.
#pragma once

#include "gl/shadow_maps.h"
#include "render/filtered_shadows.h"

namespace harness::gl {

class GpuFilteredShadows {
public:
    explicit GpuFilteredShadows(const GladGLContext& gl);

    static constexpr GLuint mapUnit = 30, constantsBinding = 11;
    // Filters maps that have changed.
    void update(const ShadowMaps& maps);
    // Must be called before each frame.
    void bind() const;

private:
    const GladGLContext* gl_;
    Texture moments_;
    Buffer constants_;
    Sampler sampler_;
    uint64_t version_ = 0; // of the maps
};

} // namespace harness::gl
