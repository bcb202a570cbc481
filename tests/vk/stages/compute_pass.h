// A compute pipeline over one descriptor set, in groups of 8 x 8.
#pragma once

#include "vk/check.h"
#include "vk/device.h"

#include <string>

namespace agaa::test {

class ComputePass {
public:
    ComputePass(const harness::vk::Device& device, VkDescriptorSetLayout set, const std::string& text,
                const std::string& name);
    void record(VkCommandBuffer commands, VkDescriptorSet set, uint32_t width, uint32_t height) const;

private:
    harness::vk::PipelineLayout layout_;
    harness::vk::Pipeline pipeline_;
};

} // namespace agaa::test
