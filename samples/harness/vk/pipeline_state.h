// The common state of the sample engine's graphics pipelines.
#pragma once

#include "render/draw_pass.h"
#include "agaa_vk.h"
#include "vk/check.h"
#include "vk/glsl.h"
#include "vk/gpu_scene.h"

#include <span>
#include <string>
#include <vector>

namespace harness::vk {

ShaderModule makeShader(const Device& device, std::span<const uint32_t> spirv);
ShaderModule makeShader(const Device& device, ShaderStage stage, const std::string& source, const std::string& name);

// State with triangle lists, dynamic viewport and scissor, and without depth, stencil or colour until the user sets
// them.
class PipelineState {
public:
    explicit PipelineState(uint32_t colorAttachments);
    // Sets the state that the SDK requires from the pipelines of a draw pass. The pass must outlive this object.
    PipelineState(const DrawPass<AgaaVkDrawPass>& pass, bool isMasked);
    PipelineState(const PipelineState&) = delete;
    PipelineState& operator=(const PipelineState&) = delete;

    // `fragment` may be null.
    Pipeline create(const Device& device, VkShaderModule vertex, VkShaderModule fragment, VkPipelineLayout layout,
                    VkRenderPass renderPass, const void* next = nullptr);

    uint32_t fragmentConstant = 0;            // specialisation constant 0 of the fragment shader
    uint32_t vertexLocations = 0x1F;          // bits of the attributes that the vertex shader reads
    VkShaderModule geometry = VK_NULL_HANDLE; // may be null
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineRasterizationStateCreateInfo rasterization{};
    VkPipelineRasterizationConservativeStateCreateInfoEXT conservative{};
    VkPipelineMultisampleStateCreateInfo multisample{};
    VkPipelineCoverageReductionStateCreateInfoNV reduction{};
    VkPipelineSampleLocationsStateCreateInfoEXT locations{}; // chained if a draw pass sets sample locations
    uint32_t viewports = 1;
    VkPipelineDepthStencilStateCreateInfo depthStencil{};
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    VkPipelineColorBlendStateCreateFlags blendFlags = 0;
    VkPipelineRenderingCreateInfo rendering{}; // used with dynamic rendering
    VkAttachmentSampleCountInfoNV mixed{};     // chained to it if colours have fewer samples than depth
    std::vector<VkSampleCountFlagBits> colorSamples;
};

// Sets viewport and scissor to the whole target.
void setViewport(VkCommandBuffer commands, uint32_t width, uint32_t height);
// Sets the first viewports and scissors of a draw pass.
void setViewports(VkCommandBuffer commands, std::span<const AgaaViewport> list);

} // namespace harness::vk
