// The light of an environment on the device, for shaders/environment.glsl.
#pragma once

#include "environment/environment.h"
#include "vk/descriptor_set.h"
#include "vk/upload.h"

namespace harness::vk {

// The map, then the constants, after the bindings of GpuFetch.
constexpr uint32_t environmentBinding = 9;

// The bindings of functions that shade: these, and those of GpuFilteredShadows.
std::array<VkDescriptorSetLayoutBinding, 4> environmentLayoutBindings(VkShaderStageFlags stages);
// Returns the layout of a set with these bindings alone: for views whose functions read nothing else, and for draws.
DescriptorSetLayout makeEnvironmentLayout(const Device& device);

class GpuEnvironment {
public:
    GpuEnvironment(const Device& device, VkDescriptorSetLayout layout, const Environment& environment);
    GpuEnvironment(const GpuEnvironment&) = delete;
    GpuEnvironment& operator=(const GpuEnvironment&) = delete;

    VkDescriptorSet set() const { return set_.get(); }
    // Writes the bindings of a set that has others too. No command that uses the set may be pending.
    void write(VkDescriptorSet set, uint32_t binding = environmentBinding) const;

private:
    const Device* device_;
    Arena arena_;
    ImageResource map_;
    BufferResource constants_;
    Sampler sampler_;
    DescriptorSet set_;
};

} // namespace harness::vk
