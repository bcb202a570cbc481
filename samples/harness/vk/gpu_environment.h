// The light of an environment on the device, for shaders/environment.glsl.
#pragma once

#include "environment/environment.h"
#include "vk/descriptor_set.h"
#include "vk/upload.h"

namespace harness::vk {

// Bindings in the set of the functions, after those of GpuFetch: the map, then the constants.
constexpr uint32_t environmentBinding = 9;

// Returns the two bindings of the environment, from `first` on.
std::array<VkDescriptorSetLayoutBinding, 2> environmentLayoutBindings(uint32_t first, VkShaderStageFlags stages);
// Returns the layout of a set for views whose functions read nothing else.
DescriptorSetLayout makeEnvironmentLayout(const Device& device);

class GpuEnvironment {
public:
    GpuEnvironment(const Device& device, VkDescriptorSetLayout layout, const Environment& environment);
    GpuEnvironment(const GpuEnvironment&) = delete;
    GpuEnvironment& operator=(const GpuEnvironment&) = delete;

    VkDescriptorSet set() const { return set_.get(); }
    // Writes the bindings `first` and `first` + 1. No command that uses the set may be pending.
    void write(VkDescriptorSet set, uint32_t first) const;

private:
    const Device* device_;
    Arena arena_;
    ImageResource map_;
    BufferResource constants_;
    Sampler sampler_;
    DescriptorSet set_;
};

} // namespace harness::vk
