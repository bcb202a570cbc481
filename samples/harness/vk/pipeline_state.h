// What the sample engine's graphics pipelines have in common.
#pragma once

#include "render/draw_pass.h"
#include "agaa_vk.h"
#include "vk/check.h"
#include "vk/glsl.h"
#include "vk/gpu_scene.h"

#include <string>
#include <vector>

namespace harness::vk {

ShaderModule makeShader(const Device& device, ShaderStage stage, const std::string& source,
                        const std::string& name);

// Lists of triangles, dynamic viewport and scissor, no depth, stencil or colour until the user sets them.
class PipelineState {
public:
    explicit PipelineState(uint32_t colorAttachments);
    // Everything that the SDK asks of a draw pass's pipelines. The pass must live as long as this.
    PipelineState(const DrawPass<AgaaVkDrawPass>& pass, bool isMasked);
    PipelineState(const PipelineState&) = delete;
    PipelineState& operator=(const PipelineState&) = delete;

    // fragment may be null.
    Pipeline create(const Device& device, VkShaderModule vertex, VkShaderModule fragment,
                    VkPipelineLayout layout, VkRenderPass renderPass, const void* next = nullptr);

    uint32_t fragmentConstant = 0;   // specialisation constant 0 of the fragment shader
    uint32_t vertexLocations = 0x1F; // bits of the attributes that the vertex shader reads
    VkShaderModule geometry = VK_NULL_HANDLE; // may be null
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineRasterizationStateCreateInfo rasterization{};
    VkPipelineRasterizationConservativeStateCreateInfoEXT conservative{};
    VkPipelineMultisampleStateCreateInfo multisample{};
    VkPipelineDepthStencilStateCreateInfo depthStencil{};
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    VkPipelineColorBlendStateCreateFlags blendFlags = 0;
    VkPipelineRenderingCreateInfo rendering{}; // with dynamic rendering
};

// The whole target.
void setViewport(VkCommandBuffer commands, uint32_t width, uint32_t height);

} // namespace harness::vk
