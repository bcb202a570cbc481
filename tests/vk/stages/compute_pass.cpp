#include "compute_pass.h"

#include "vk/pipeline_state.h"

using namespace harness::vk;

namespace agaa::test {

ComputePass::ComputePass(const Device& device, VkDescriptorSetLayout set, const std::string& text,
                         const std::string& name) {
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set;
    layout_ = make<PipelineLayout>(device.get(), vkCreatePipelineLayout, layout, "create a pipeline layout");
    const ShaderModule shader = makeShader(device, ShaderStage::Compute, text, name);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader.get();
    info.stage.pName = "main";
    info.layout = layout_.get();
    VkPipeline handle = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &handle),
          "create a compute pipeline");
    pipeline_ = Pipeline(device.get(), handle);
}

void ComputePass::record(VkCommandBuffer commands, VkDescriptorSet set, uint32_t width, uint32_t height) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set, 0, nullptr);
    vkCmdDispatch(commands, (width + 7) / 8, (height + 7) / 8, 1);
}

} // namespace agaa::test
