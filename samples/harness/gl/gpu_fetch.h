// The resources that the SDK's fetching passes read: the scene's buffers and texture arrays. They are bound to points
// that the SDK does not use.
#pragma once

#include "gl/gpu_scene.h"
#include "render/fetch_scene.h"

namespace harness::gl {

class GpuFetch {
public:
    GpuFetch(const GladGLContext& gl, const Scene& scene, const GpuScene& gpuScene);
    GpuFetch(const GpuFetch&) = delete;
    GpuFetch& operator=(const GpuFetch&) = delete;

    const AgaaFetchFunction& function() const { return function_; }
    void update(const Scene& scene, const std::vector<Draw>& draws, const FetchCamera& camera);
    // Must be called before each frame.
    void bind() const;

private:
    Texture makeArray(const TextureLayers& layers, bool srgb) const;
    Texture texels(GLuint buffer, GLenum format) const;

    const GladGLContext* gl_;
    std::string glsl_;
    AgaaFetchFunction function_ = AGAA_FETCH_FUNCTION_INIT;
    Buffer camera_, draws_, materials_, vertices_;
    Texture textures_[8]; // colours, values; draws, materials, vertices, indices; small colours, small values
    Sampler sampler_;
};

} // namespace harness::gl
