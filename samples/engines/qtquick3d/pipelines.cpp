/* Pipelines that draw meshes of Qt Quick 3D in the SDK's draw passes.
 * SPDX-License-Identifier: MIT
 */
#include "mesh_renderer.h"

#include "glsl.h"

namespace agaaQt {

namespace {

VkCullModeFlags cullModeOf(const QSSGRenderCustomMaterial& material) {
    return material.m_cullMode == QSSGCullFaceMode::Back    ? VK_CULL_MODE_BACK_BIT
           : material.m_cullMode == QSSGCullFaceMode::Front ? VK_CULL_MODE_FRONT_BIT
                                                            : VK_CULL_MODE_NONE;
}

} // namespace

/* The fragment shader consists of the version, the SDK's extensions and declarations, and the engine's text. */
VkPipeline MeshRenderer::createPipeline(size_t pass, const Draw& draw, const QSSGRenderCustomMaterial& material,
                                        const std::string& text) const {
    const AgaaDrawState& state = m_passes[pass].state;
    const bool isMasked = text.find("#define AGAA_ALPHA_MASKED") == 0;
    const size_t line = isMasked ? text.find('\n') + 1 : 0;
    const VkShaderModule fragment =
        compile(m_device, VK_SHADER_STAGE_FRAGMENT_BIT,
                std::string("#version 450\n") + m_passes[pass].glslExtensions + text.substr(0, line) +
                    m_passes[pass].glslDeclarations + text.substr(line));
    VkPipelineShaderStageCreateInfo stages[2] = {{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO},
                                                 {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}};
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT, stages[0].module = m_vertexShader, stages[0].pName = "main";
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT, stages[1].module = fragment, stages[1].pName = "main";
    const VkVertexInputBindingDescription binding = {0, draw.vertices[0], VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription attributes[] = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, draw.vertices[1]},
                                                            {1, 0, VK_FORMAT_R32G32B32_SFLOAT, draw.vertices[2]},
                                                            {2, 0, VK_FORMAT_R32G32_SFLOAT, draw.vertices[3]}};
    VkPipelineVertexInputStateCreateInfo input = {VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    input.vertexBindingDescriptionCount = 1, input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = 3, input.pVertexAttributeDescriptions = attributes;
    VkPipelineInputAssemblyStateCreateInfo assembly = {VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport = {VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo rasterization = {VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    rasterization.cullMode = cullModeOf(material), rasterization.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo multisample = {VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples = VkSampleCountFlagBits(state.samples);
    multisample.sampleShadingEnable = state.sampleShading, multisample.minSampleShading = 1.0f;
    constexpr VkCompareOp compare[] = {VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER, VK_COMPARE_OP_EQUAL,
                                       VK_COMPARE_OP_ALWAYS};
    VkPipelineDepthStencilStateCreateInfo depth = {VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = VK_TRUE, depth.depthWriteEnable = state.depthWrite;
    depth.depthCompareOp = compare[state.depthCompare];
    depth.stencilTestEnable = isMasked ? state.stencilTestMasked : state.stencilTest;
    depth.front.passOp = VK_STENCIL_OP_INCREMENT_AND_CLAMP, depth.front.compareOp = VK_COMPARE_OP_EQUAL;
    depth.front.compareMask = depth.front.writeMask = 0xFF;
    depth.back = depth.front;
    VkPipelineColorBlendAttachmentState target = {};
    target.blendEnable = state.keepFirst, target.colorWriteMask = state.colorWriteMask;
    target.srcColorBlendFactor = target.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
    target.dstColorBlendFactor = target.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    VkPipelineColorBlendAttachmentState targets[8];
    std::fill(std::begin(targets), std::end(targets), target);
    VkPipelineColorBlendStateCreateInfo blend = {VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = state.colorAttachmentCount, blend.pAttachments = targets;
    const VkDynamicState dynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = {VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = 2, dynamic.pDynamicStates = dynamicStates;
    VkGraphicsPipelineCreateInfo info = {VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.stageCount = 2, info.pStages = stages, info.pVertexInputState = &input, info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport, info.pRasterizationState = &rasterization, info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth, info.pColorBlendState = &blend, info.pDynamicState = &dynamic;
    info.layout = m_layouts[pass];
    info.renderPass = VkRenderPass(static_cast<const AgaaVkDrawPass*>(m_passes[pass].pNext)->renderPass);
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = vkCreateGraphicsPipelines(m_device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    vkDestroyShaderModule(m_device, fragment, nullptr);
    require(result, "vkCreateGraphicsPipelines");
    return pipeline;
}

} // namespace agaaQt
