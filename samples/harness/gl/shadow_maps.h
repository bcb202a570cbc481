// Depth maps of the lights that cast shadows, rendered once for a scene, its lights and a camera.
#pragma once

#include "gl/gpu_scene.h"
#include "gl/program.h"
#include "render/shadow_fit.h"

namespace harness::gl {

class ShadowMaps {
public:
    ShadowMaps(const GladGLContext& gl, uint32_t size);

    // Renders if the lights, the camera, the offset or the placement of the instances differ from the last call.
    void update(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                const CameraMatrices& camera, uint64_t placement);
    // Must be called when the scene changes.
    void invalidate() { key_.clear(); }

    const std::vector<AgaaShadow>& shadows() const { return shadows_; }
    GLuint texture(size_t shadow) const { return maps_[shadow].get(); }
    uint32_t size() const { return size_; } // width and height of a map
    // Another number after each rendering of the maps.
    uint64_t version() const { return version_; }
    // Returns the depths of all layers of a map, row by row.
    std::vector<float> readDepths(size_t shadow) const;

private:
    void renderMap(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings, const glm::dvec3& eye,
                   const std::vector<glm::dmat4>& layers);
    void renderLayer(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                     const glm::dvec3& eye, const glm::dmat4& toClip) const;

    const GladGLContext* gl_;
    uint32_t size_;
    Program opaque_;
    Program masked_;
    Framebuffer framebuffer_;
    std::vector<Texture> maps_;
    std::vector<AgaaShadow> shadows_;
    std::vector<double> key_; // key of the rendered maps
    uint64_t version_ = 0;
};

} // namespace harness::gl
