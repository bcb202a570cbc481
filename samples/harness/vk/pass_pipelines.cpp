#include "vk/pass_pipelines.h"

#include "vk_embedded.h"

#include <algorithm>
#include <stdexcept>

namespace harness::vk {

namespace {

std::string fragmentText(const AgaaVkDrawPass& pass, bool isMasked) {
    return std::string("#version 450\n") + pass.glslExtensions + "\n#define AGAA_ALPHA_MASKED " +
           (isMasked ? "1\n" : "0\n") + pass.glslDeclarations + "\n" + embedded::material_frag;
}

} // namespace

DrawConstants drawConstants(const Draw& draw) {
    DrawConstants c{};
    const glm::dmat3 linear(draw.toShading);
    // The inverse transpose by cofactors: defined for flattened objects too.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double sign = draw.isMirrored ? -1 : 1;
    // Normals are made unit length in the shader; here they only must not leave float's range.
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, glm::length(cofactors[i]));
    const double scale = largest > 0 ? sign / largest : sign;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            c.toShading[size_t(row)][column] = float(draw.toShading[column][row]);
        for (int column = 0; column < 3; ++column)
            c.normalToShading[size_t(row)][column] = float(cofactors[column][row] * scale);
    }
    c.seed = drawSeed(draw.instance);
    c.handedness = draw.isMirrored ? -1.0f : 1.0f;
    return c;
}

Variant variantOf(const Scene& scene, const Draw& draw) {
    Variant variant;
    variant.isMasked = draw.isMasked;
    variant.isMirrored = draw.isMirrored;
    const uint32_t material = scene.meshes[draw.mesh].material;
    variant.features = materialFeatures(scene, material);
    variant.isDoubleSided =
        material < scene.materials.size() && scene.materials[material].doubleSided;
    return variant;
}

PassPipelines::PassPipelines(const Device& device, VkDescriptorSetLayout cameraLayout)
    : device_(&device), cameraLayout_(cameraLayout),
      vertex_(makeShader(device, ShaderStage::Vertex, embedded::material_vert, "material.vert")) {}

void PassPipelines::prepare(const AgaaVkDrawPass& pass, const Scene& scene,
                            const std::vector<Draw>& draws, VkDescriptorSetLayout materialLayout) {
    Program& program = programs_[pass.pipelineKey];
    const std::string text = std::string(pass.glslExtensions) + pass.glslDeclarations;
    if (!program.layout) {
        program.text = text;
        program.layout = makeLayout(pass, materialLayout);
    }
    if (program.text != text)
        throw std::runtime_error(std::string("The SDK gave two shaders of the pass \"") +
                                 pass.name + "\" the same pipeline key.");
    for (const Draw& draw : draws) {
        const Variant variant = variantOf(scene, draw);
        Pipeline& pipeline = program.pipelines[variant];
        if (pipeline)
            continue;
        ShaderModule& fragment = program.fragments[variant.isMasked];
        if (!fragment)
            fragment =
                makeShader(*device_, ShaderStage::Fragment, fragmentText(pass, variant.isMasked),
                           std::string("material.frag, ") + pass.name);
        pipeline = makePipeline(pass, program, variant);
    }
}

PipelineLayout PassPipelines::makeLayout(const AgaaVkDrawPass& pass,
                                         VkDescriptorSetLayout materials) const {
    std::array<VkDescriptorSetLayout, 3> sets{};
    sets[cameraSetIndex] = cameraLayout_;
    sets[agaaSetIndex] = (VkDescriptorSetLayout)pass.descriptorSetLayout;
    sets[materialSetIndex] = materials;
    const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(DrawConstants)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = uint32_t(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &constants;
    return make<PipelineLayout>(device_->get(), vkCreatePipelineLayout, info,
                                "create a pipeline layout");
}

Pipeline PassPipelines::makePipeline(const AgaaVkDrawPass& pass, const Program& program,
                                     const Variant& variant) const {
    PipelineState state(pass, variant.isMasked);
    state.rasterization.cullMode =
        variant.isDoubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
    state.rasterization.frontFace =
        variant.isMirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
    state.fragmentConstant = variant.features;
    const VkRenderPass renderPass = (VkRenderPass)pass.renderPass;
    return state.create(*device_, vertex_.get(), program.fragments[variant.isMasked].get(),
                        program.layout.get(), renderPass,
                        renderPass == VK_NULL_HANDLE ? &state.rendering : nullptr);
}

const PassPipelines::Program& PassPipelines::program(uint64_t pipelineKey) const {
    const auto found = programs_.find(pipelineKey);
    if (found == programs_.end())
        throw std::runtime_error(
            "The SDK asked for a draw with a pipeline key that it had not told.");
    return found->second;
}

VkPipelineLayout PassPipelines::layout(uint64_t pipelineKey) const {
    return program(pipelineKey).layout.get();
}

VkPipeline PassPipelines::pipeline(uint64_t pipelineKey, const Variant& variant) const {
    const auto& pipelines = program(pipelineKey).pipelines;
    const auto found = pipelines.find(variant);
    if (found == pipelines.end())
        throw std::runtime_error("A pipeline was not prepared before its draw.");
    return found->second.get();
}

} // namespace harness::vk
