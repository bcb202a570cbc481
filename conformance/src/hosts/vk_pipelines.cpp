#include "vk_pipelines.h"

#include "drawing.h"
#include "host_shaders.h"

#include <cstddef>

namespace agaa::conformance {

namespace {

struct Attribute {
    VkFormat format;
    uint32_t offset;
};
constexpr Attribute attributes[] = {{VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
                                    {VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
                                    {VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, diffuse)},
                                    {VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, specular)},
                                    {VK_FORMAT_R32_SFLOAT, offsetof(Vertex, roughness)},
                                    {VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, emissive)}};

VkPipelineDepthStencilStateCreateInfo depthStencilState(const AgaaDrawState& state, bool isMasked) {
    constexpr VkCompareOp compareOps[] = {VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER, VK_COMPARE_OP_EQUAL,
                                          VK_COMPARE_OP_ALWAYS};
    VkPipelineDepthStencilStateCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    info.depthTestEnable = VK_TRUE;
    info.depthWriteEnable = state.depthWrite != 0;
    info.depthCompareOp = compareOps[state.depthCompare & 3];
    info.stencilTestEnable = (isMasked ? state.stencilTestMasked : state.stencilTest) != 0;
    info.front.passOp = VK_STENCIL_OP_INCREMENT_AND_CLAMP;
    info.front.compareOp = VK_COMPARE_OP_EQUAL;
    info.front.compareMask = info.front.writeMask = 0xFF;
    info.back = info.front;
    return info;
}

VkPipelineColorBlendAttachmentState blendState(const AgaaDrawState& state, bool blends) {
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask = state.colorWriteMask;
    blend.blendEnable = state.keepFirst || state.additive || blends;
    blend.srcColorBlendFactor = blend.srcAlphaBlendFactor = blends           ? VK_BLEND_FACTOR_SRC_ALPHA
                                                            : state.additive ? VK_BLEND_FACTOR_ONE
                                                                             : VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
    blend.dstColorBlendFactor = blend.dstAlphaBlendFactor =
        blends ? VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
    return blend;
}

VkPipelineRenderingCreateInfo renderingState(const AgaaDrawState& state, const AgaaVkDrawPass& native) {
    static_assert(sizeof(VkFormat) == sizeof native.colorFormats[0]);
    VkPipelineRenderingCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    info.colorAttachmentCount = state.colorAttachmentCount;
    info.pColorAttachmentFormats = reinterpret_cast<const VkFormat*>(native.colorFormats);
    info.depthAttachmentFormat = VkFormat(native.depthStencilFormat);
    const bool hasStencil = native.depthStencilFormat == VK_FORMAT_D24_UNORM_S8_UINT ||
                            native.depthStencilFormat == VK_FORMAT_D32_SFLOAT_S8_UINT ||
                            native.depthStencilFormat == VK_FORMAT_D16_UNORM_S8_UINT;
    info.stencilAttachmentFormat = hasStencil ? info.depthAttachmentFormat : VK_FORMAT_UNDEFINED;
    return info;
}

} // namespace

VulkanPipelines::VulkanPipelines(const VulkanApi& api, const Mistakes& mistakes)
    : api_(api), mistakes_(mistakes), shaders_(api) {
    VkDescriptorSetLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    checkVk(vkCreateDescriptorSetLayout(api.device, &layout, nullptr, &emptySet_), "vkCreateDescriptorSetLayout");
    VkPipelineCacheCreateInfo cache{};
    cache.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    checkVk(vkCreatePipelineCache(api.device, &cache, nullptr, &cache_), "vkCreatePipelineCache");
}

VulkanPipelines::~VulkanPipelines() {
    for (const auto& [key, pipeline] : pipelines_)
        destroy(pipeline);
    vkDestroyPipelineCache(api_.device, cache_, nullptr);
    vkDestroyDescriptorSetLayout(api_.device, emptySet_, nullptr);
}

void VulkanPipelines::destroy(const VulkanPipeline& pipeline) const {
    vkDestroyPipeline(api_.device, pipeline.opaque, nullptr);
    vkDestroyPipeline(api_.device, pipeline.masked, nullptr);
    vkDestroyPipelineLayout(api_.device, pipeline.layout, nullptr);
}

VulkanPipelines::Key VulkanPipelines::keyOf(AgaaView view, uint64_t pipelineKey, uint32_t pass) const {
    return mistakes_.keysByPass ? Key(nullptr, pass) : Key(view, pipelineKey);
}

void VulkanPipelines::prepare(const Functions& sdk, AgaaView view, uint32_t descriptorSet) {
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    const AgaaVkDrawPass initialNative = AGAA_VK_DRAW_PASS_INIT;
    const DrawPasses<AgaaVkDrawPass> list(sdk, view, initial, initialNative);
    views_.insert(view);
    for (size_t i = 0; i < list.passes.size(); ++i) {
        const Key key = keyOf(view, list.passes[i].pipelineKey, list.passes[i].pass);
        if (!pipelines_.count(key))
            pipelines_[key] = create(list.passes[i], list.natives[i], descriptorSet);
    }
}

void VulkanPipelines::forget(AgaaView view) {
    views_.erase(view);
    for (auto i = pipelines_.begin(); i != pipelines_.end();) {
        const AgaaView owner = i->first.first;
        if (owner == view || (!owner && views_.empty())) {
            destroy(i->second);
            i = pipelines_.erase(i);
        } else
            ++i;
    }
}

const VulkanPipeline* VulkanPipelines::find(AgaaView view, uint64_t pipelineKey, uint32_t pass) const {
    const auto found = pipelines_.find(keyOf(view, pipelineKey, pass));
    return found == pipelines_.end() ? nullptr : &found->second;
}

VulkanPipeline VulkanPipelines::create(const AgaaDrawPass& pass, const AgaaVkDrawPass& native, uint32_t descriptorSet) {
    std::vector<VkDescriptorSetLayout> sets(descriptorSet, emptySet_);
    sets.push_back((VkDescriptorSetLayout)native.descriptorSetLayout);
    const VkPushConstantRange push = {VK_SHADER_STAGE_VERTEX_BIT, 0, 16 * sizeof(float)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = uint32_t(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &push;
    VulkanPipeline pipeline;
    checkVk(vkCreatePipelineLayout(api_.device, &info, nullptr, &pipeline.layout), "vkCreatePipelineLayout");
    try {
        pipeline.opaque = createOne(pass, native, pipeline.layout, false);
        pipeline.masked = createOne(pass, native, pipeline.layout, true);
    } catch (...) {
        destroy(pipeline);
        throw;
    }
    return pipeline;
}

VkPipeline VulkanPipelines::createOne(const AgaaDrawPass& pass, const AgaaVkDrawPass& native, VkPipelineLayout layout,
                                      bool isMasked) {
    AgaaDrawState state = pass.state;
    if (mistakes_.changeState)
        mistakes_.changeState(pass.pass, state);
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    const auto addStage = [&](VkShaderStageFlagBits stage, const std::string& text) {
        VkPipelineShaderStageCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage = stage;
        info.module = shaders_.find(stage, "#version 450\n" + text);
        info.pName = "main";
        stages.push_back(info);
    };
    const bool pulls = state.vertexPulling;
    const std::string own = pass.glslVertex ? std::string(pass.glslExtensions) + pass.glslVertex : std::string();
    addStage(VK_SHADER_STAGE_VERTEX_BIT, pulls             ? own + pullingShader
                                         : state.multicast ? own + "#define MULTICAST\n" + vertexShader
                                                           : vertexShader);
    if (pass.glslGeometry)
        addStage(VK_SHADER_STAGE_GEOMETRY_BIT, std::string(pass.glslExtensions) + pass.glslGeometry + geometryShader);
    std::string fragment = std::string(pass.glslExtensions) + (isMasked ? "#define AGAA_ALPHA_MASKED 1\n" : "") +
                           pass.glslDeclarations + fragmentShader;
    if (mistakes_.changeFragmentShader)
        mistakes_.changeFragmentShader(fragment);
    addStage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment);
    VkVertexInputBindingDescription binding = {0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    std::vector<VkVertexInputAttributeDescription> inputs;
    for (const Attribute& attribute : attributes)
        inputs.push_back({uint32_t(inputs.size()), 0, attribute.format, attribute.offset});
    if (pulls) {
        binding = {0, 3 * sizeof(Vertex), VK_VERTEX_INPUT_RATE_INSTANCE};
        for (const uint32_t corner : {1u, 2u})
            inputs.push_back({uint32_t(inputs.size()), 0, attributes[0].format,
                              attributes[0].offset + corner * uint32_t(sizeof(Vertex))});
    }
    VkPipelineVertexInputStateCreateInfo input{};
    input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = uint32_t(inputs.size());
    input.pVertexAttributeDescriptions = inputs.data();
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = pulls ? VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = viewport.scissorCount = std::max(state.multicast, 1u);
    VkPipelineRasterizationStateCreateInfo rasterization{};
    rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    rasterization.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VkSampleCountFlagBits(state.samples);
    multisample.sampleShadingEnable = state.sampleShading != 0;
    multisample.minSampleShading = 1.0f;
    // Coverage modulation is off by default.
    VkPipelineCoverageReductionStateCreateInfoNV reduction{};
    reduction.sType = VK_STRUCTURE_TYPE_PIPELINE_COVERAGE_REDUCTION_STATE_CREATE_INFO_NV;
    reduction.coverageReductionMode = VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV;
    const std::vector<VkSampleCountFlagBits> colorSamples(state.colorAttachmentCount,
                                                          VkSampleCountFlagBits(state.colorSamples));
    VkAttachmentSampleCountInfoNV mixed{};
    mixed.sType = VK_STRUCTURE_TYPE_ATTACHMENT_SAMPLE_COUNT_INFO_NV;
    mixed.colorAttachmentCount = state.colorAttachmentCount;
    mixed.pColorAttachmentSamples = colorSamples.data();
    mixed.depthStencilAttachmentSamples = multisample.rasterizationSamples;
    if (state.colorSamples)
        multisample.pNext = &reduction;
    VkPipelineSampleLocationsStateCreateInfoEXT locations{};
    locations.sType = VK_STRUCTURE_TYPE_PIPELINE_SAMPLE_LOCATIONS_STATE_CREATE_INFO_EXT;
    locations.sampleLocationsEnable = VK_TRUE;
    locations.sampleLocationsInfo.sType = VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT;
    if (state.sampleLocations)
        multisample.pNext = &locations;
    const VkPipelineDepthStencilStateCreateInfo depthStencil = depthStencilState(state, isMasked);
    const std::vector<VkPipelineColorBlendAttachmentState> targets(state.colorAttachmentCount,
                                                                   blendState(state, mistakes_.blends));
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.flags =
        state.readsAttachments ? VK_PIPELINE_COLOR_BLEND_STATE_CREATE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_BIT_EXT : 0;
    blend.attachmentCount = state.colorAttachmentCount;
    blend.pAttachments = targets.data();
    const VkDynamicState dynamics[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_SAMPLE_LOCATIONS_EXT};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = state.sampleLocations ? 3 : 2;
    dynamic.pDynamicStates = dynamics;
    VkPipelineRenderingCreateInfo rendering = renderingState(state, native);
    if (state.colorSamples)
        rendering.pNext = &mixed;
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = native.renderPass ? nullptr : &rendering;
    info.stageCount = uint32_t(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &rasterization;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depthStencil;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout;
    info.renderPass = (VkRenderPass)native.renderPass;
    VkPipeline pipeline;
    checkVk(vkCreateGraphicsPipelines(api_.device, cache_, 1, &info, nullptr, &pipeline), "vkCreateGraphicsPipelines");
    return pipeline;
}

} // namespace agaa::conformance
