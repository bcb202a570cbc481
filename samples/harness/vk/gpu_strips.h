// Resources of draws that pull vertices: a descriptor set with the scene's vertices and indices, and an index buffer.
#pragma once

#include "vk/descriptor_set.h"
#include "vk/gpu_scene.h"

namespace harness::vk {

class GpuStrips {
public:
    GpuStrips(const Device& device, const Scene& scene, const GpuScene& gpuScene);
    GpuStrips(const GpuStrips&) = delete;
    GpuStrips& operator=(const GpuStrips&) = delete;

    VkDescriptorSetLayout layout() const { return layout_.get(); }
    void bind(VkCommandBuffer commands, VkPipelineLayout layout, uint32_t setIndex) const;
    void draw(VkCommandBuffer commands, const Mesh& mesh) const;

private:
    Arena arena_;
    BufferResource indices_;
    BufferView texels_[2]; // vertices, indices
    DescriptorSetLayout layout_;
    DescriptorSet set_;
};

} // namespace harness::vk
