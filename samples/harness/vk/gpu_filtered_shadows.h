// Filtered shadow maps on the device, for shaders/filtered_shadows.glsl.
#pragma once

#include "render/filtered_shadows.h"
#include "vk/descriptor_set.h"
#include "vk/shadow_maps.h"
#include "vk/upload.h"

namespace harness::vk {

// The texture, then the constants, after the bindings of GpuEnvironment.
constexpr uint32_t filteredShadowBinding = 11;

class GpuFilteredShadows {
public:
    // The layout is that of makeEnvironmentLayout().
    GpuFilteredShadows(const Device& device, VkDescriptorSetLayout layout);
    GpuFilteredShadows(const GpuFilteredShadows&) = delete;
    GpuFilteredShadows& operator=(const GpuFilteredShadows&) = delete;

    // Filters maps that have changed. No command that uses the set may be pending.
    void update(const ShadowMaps& maps);
    VkDescriptorSet set() const { return set_.get(); }
    // Writes the bindings of a set that has others too. No command that uses the set may be pending.
    void write(VkDescriptorSet set, uint32_t binding = filteredShadowBinding) const;

private:
    const Device* device_;
    Arena arena_, constantArena_;
    ImageResource moments_;
    BufferResource constants_;
    Sampler sampler_;
    DescriptorSet set_;
    uint64_t version_ = 0; // of the maps
};

} // namespace harness::vk
