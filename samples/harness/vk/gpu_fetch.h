// The resources that the SDK's fetching passes read: a descriptor set with the scene's buffers and texture arrays.
#pragma once

#include "render/fetch_scene.h"
#include "vk/descriptor_set.h"
#include "vk/gpu_scene.h"

namespace harness::vk {

class GpuFetch {
public:
    GpuFetch(const Device& device, const Scene& scene, const GpuScene& gpuScene);
    GpuFetch(const GpuFetch&) = delete;
    GpuFetch& operator=(const GpuFetch&) = delete;

    const AgaaFetchFunction& function() const { return function_; }
    VkDescriptorSet set() const { return set_.get(); }
    // Sets the data of the next frame. The previous frame must have finished.
    void update(const Scene& scene, const std::vector<Draw>& draws, const FetchCamera& camera);

private:
    BufferView texels(VkBuffer buffer, VkDeviceSize size, VkFormat format) const;
    void createSet();

    const Device* device_;
    Arena arena_;
    std::string glsl_;
    AgaaFetchFunction function_ = AGAA_FETCH_FUNCTION_INIT;
    BufferResource camera_, draws_, materials_, vertices_;
    BufferView drawTexels_, materialTexels_, vertexTexels_, indexTexels_;
    ImageResource textures_[4]; // colours, values, small colours, small values
    Sampler sampler_;
    DescriptorSetLayout layout_;
    DescriptorSet set_;
};

} // namespace harness::vk
