// Depth maps of the lights that cast shadows, rendered once for a scene, its lights and a camera.
#pragma once

#include "render/camera_matrices.h"
#include "vk/gpu_scene.h"
#include "vk/pipeline_state.h"

#include <vector>

namespace harness::vk {

class ShadowMaps {
public:
    ShadowMaps(const Device& device, uint32_t size);

    // Renders if the lights, the camera, the offset or the placement of the instances differ from the last call. The
    // camera's jitter and image size do not matter: all frames of a scene at rest share their maps.
    void update(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                const CameraMatrices& camera, uint64_t placement);
    // Must be called when the scene changes.
    void invalidate();

    const std::vector<AgaaShadow>& shadows() const { return shadows_; }
    VkImageView view(size_t shadow) const { return maps_[shadow].view.get(); }
    uint32_t size() const { return size_; } // width and height of a map
    // Another number after each rendering of the maps.
    uint64_t version() const { return version_; }
    // Returns the depths of all layers of a map, row by row.
    std::vector<float> readDepths(size_t shadow) const;

private:
    void renderMap(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings, const glm::dvec3& eye,
                   const std::vector<glm::dmat4>& layers);
    void createPipelines(VkDescriptorSetLayout materialLayout);
    void renderLayer(VkCommandBuffer commands, const GpuScene& gpuScene, const Scene& scene,
                     const RenderSettings& settings, const glm::dvec3& eye, const glm::dmat4& toClip) const;

    const Device* device_;
    uint32_t size_;
    RenderPass renderPass_;
    ShaderModule vertex_;
    ShaderModule fragment_;
    PipelineLayout layout_;
    Pipeline opaque_;
    Pipeline masked_;
    Arena arena_;
    std::vector<ImageResource> maps_;
    std::vector<AgaaShadow> shadows_;
    std::vector<double> key_; // key of the rendered maps
    uint64_t version_ = 0;
};

} // namespace harness::vk
