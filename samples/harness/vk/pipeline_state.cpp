#include "vk/pipeline_state.h"

#include <algorithm>
#include <stdexcept>

namespace harness::vk {

namespace {

VkCompareOp compareOp(uint32_t compare) {
    switch (compare) {
    case AGAA_COMPARE_LESS:
        return VK_COMPARE_OP_LESS;
    case AGAA_COMPARE_GREATER:
        return VK_COMPARE_OP_GREATER;
    case AGAA_COMPARE_EQUAL:
        return VK_COMPARE_OP_EQUAL;
    case AGAA_COMPARE_ALWAYS:
        return VK_COMPARE_OP_ALWAYS;
    }
    throw std::runtime_error("The SDK asks for an unknown depth comparison.");
}

bool hasStencil(VkFormat format) {
    return format == VK_FORMAT_S8_UINT || format == VK_FORMAT_D16_UNORM_S8_UINT ||
           format == VK_FORMAT_D24_UNORM_S8_UINT || format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

} // namespace

ShaderModule makeShader(const Device& device, std::span<const uint32_t> spirv) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.size_bytes();
    info.pCode = spirv.data();
    return make<ShaderModule>(device.get(), vkCreateShaderModule, info, "create a shader module");
}

ShaderModule makeShader(const Device& device, ShaderStage stage, const std::string& source, const std::string& name) {
    return makeShader(device, compileGlsl(stage, source, name));
}

PipelineState::PipelineState(uint32_t colorAttachments) {
    rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    rasterization.polygonMode = VK_POLYGON_MODE_FILL;
    rasterization.cullMode = VK_CULL_MODE_NONE;
    rasterization.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    rasterization.lineWidth = 1;
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    depthStencil.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    blends.resize(colorAttachments);
}

PipelineState::PipelineState(const DrawPass<AgaaVkDrawPass>& pass, bool isMasked)
    : PipelineState(pass.state.colorAttachmentCount) {
    const AgaaDrawState& wanted = pass.state;
    multisample.rasterizationSamples = VkSampleCountFlagBits(wanted.samples);
    multisample.sampleShadingEnable = wanted.sampleShading != 0;
    multisample.minSampleShading = 1;
    if (wanted.colorSamples) { // coverage modulation is off by default
        reduction.sType = VK_STRUCTURE_TYPE_PIPELINE_COVERAGE_REDUCTION_STATE_CREATE_INFO_NV;
        reduction.coverageReductionMode = VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV;
        multisample.pNext = &reduction;
        colorSamples.assign(wanted.colorAttachmentCount, VkSampleCountFlagBits(wanted.colorSamples));
        mixed.sType = VK_STRUCTURE_TYPE_ATTACHMENT_SAMPLE_COUNT_INFO_NV;
        mixed.colorAttachmentCount = wanted.colorAttachmentCount;
        mixed.pColorAttachmentSamples = colorSamples.data();
        mixed.depthStencilAttachmentSamples = multisample.rasterizationSamples;
        rendering.pNext = &mixed;
    }
    if (wanted.sampleLocations) { // the SDK sets them in each command buffer
        locations.sType = VK_STRUCTURE_TYPE_PIPELINE_SAMPLE_LOCATIONS_STATE_CREATE_INFO_EXT;
        locations.pNext = multisample.pNext;
        locations.sampleLocationsEnable = VK_TRUE;
        locations.sampleLocationsInfo.sType = VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT;
        multisample.pNext = &locations;
    }
    viewports = std::max(wanted.multicast, 1u);
    if (wanted.conservative) {
        conservative.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_CONSERVATIVE_STATE_CREATE_INFO_EXT;
        conservative.conservativeRasterizationMode = VK_CONSERVATIVE_RASTERIZATION_MODE_OVERESTIMATE_EXT;
        rasterization.pNext = &conservative;
    }
    depthStencil.depthTestEnable = VK_TRUE;
    depthStencil.depthWriteEnable = wanted.depthWrite != 0;
    depthStencil.depthCompareOp = compareOp(wanted.depthCompare);
    if (isMasked ? wanted.stencilTestMasked : wanted.stencilTest) {
        depthStencil.stencilTestEnable = VK_TRUE;
        depthStencil.front.failOp = VK_STENCIL_OP_KEEP;
        depthStencil.front.depthFailOp = VK_STENCIL_OP_KEEP;
        depthStencil.front.passOp = VK_STENCIL_OP_INCREMENT_AND_CLAMP;
        depthStencil.front.compareOp = VK_COMPARE_OP_EQUAL;
        depthStencil.front.compareMask = 0xFF;
        depthStencil.front.writeMask = 0xFF;
        depthStencil.front.reference = 0;
        depthStencil.back = depthStencil.front;
    }
    if (wanted.readsAttachments)
        blendFlags |= VK_PIPELINE_COLOR_BLEND_STATE_CREATE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_BIT_EXT;
    // The bits of the SDK's mask equal VkColorComponentFlags.
    for (VkPipelineColorBlendAttachmentState& blend : blends) {
        blend.colorWriteMask = wanted.colorWriteMask;
        if (wanted.keepFirst) {
            blend.blendEnable = VK_TRUE;
            blend.srcColorBlendFactor = blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
            blend.dstColorBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
        }
        if (wanted.additive) {
            blend.blendEnable = VK_TRUE;
            blend.srcColorBlendFactor = blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
            blend.dstColorBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
        }
    }

    static_assert(sizeof(VkFormat) == sizeof pass.native.colorFormats[0]);
    const VkFormat depthFormat = VkFormat(pass.native.depthStencilFormat);
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = wanted.colorAttachmentCount;
    rendering.pColorAttachmentFormats = reinterpret_cast<const VkFormat*>(pass.native.colorFormats);
    rendering.depthAttachmentFormat = depthFormat;
    rendering.stencilAttachmentFormat = hasStencil(depthFormat) ? depthFormat : VK_FORMAT_UNDEFINED;
}

Pipeline PipelineState::create(const Device& device, VkShaderModule vertex, VkShaderModule fragment,
                               VkPipelineLayout layout, VkRenderPass renderPass, const void* next) {
    VkPipelineShaderStageCreateInfo stages[3]{};
    stages[0].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[0].pName = "main";
    stages[1] = stages[0];
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;
    const VkSpecializationMapEntry entry{0, 0, sizeof fragmentConstant};
    const VkSpecializationInfo constants{1, &entry, sizeof fragmentConstant, &fragmentConstant};
    stages[1].pSpecializationInfo = &constants;
    uint32_t stageCount = fragment == VK_NULL_HANDLE ? 1 : 2;
    if (geometry != VK_NULL_HANDLE) {
        stages[stageCount] = stages[0];
        stages[stageCount].stage = VK_SHADER_STAGE_GEOMETRY_BIT;
        stages[stageCount++].module = geometry;
    }

    const VertexInput vertexInput(vertexLocations);
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = topology;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = viewport.scissorCount = viewports;
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.flags = blendFlags;
    blend.attachmentCount = uint32_t(blends.size());
    blend.pAttachments = blends.data();
    const VkDynamicState dynamics[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_SAMPLE_LOCATIONS_EXT};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = locations.sampleLocationsEnable ? 3 : 2;
    dynamic.pDynamicStates = dynamics;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = next;
    info.stageCount = stageCount;
    info.pStages = stages;
    info.pVertexInputState = &vertexInput.state;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &rasterization;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depthStencil;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout;
    info.renderPass = renderPass;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "create a graphics pipeline");
    return Pipeline(device.get(), pipeline);
}

void setViewport(VkCommandBuffer commands, uint32_t width, uint32_t height) {
    const VkViewport viewport{0, 0, float(width), float(height), 0, 1};
    const VkRect2D scissor{{0, 0}, {width, height}};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

void setViewports(VkCommandBuffer commands, std::span<const AgaaViewport> list) {
    std::vector<VkViewport> viewports;
    std::vector<VkRect2D> scissors;
    for (const AgaaViewport& v : list) {
        viewports.push_back({v.x, v.y, v.width, v.height, 0, 1});
        scissors.push_back({{int32_t(v.scissorX), int32_t(v.scissorY)}, {v.scissorWidth, v.scissorHeight}});
    }
    vkCmdSetViewport(commands, 0, uint32_t(viewports.size()), viewports.data());
    vkCmdSetScissor(commands, 0, uint32_t(scissors.size()), scissors.data());
}

} // namespace harness::vk
