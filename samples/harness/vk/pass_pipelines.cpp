#include "vk/pass_pipelines.h"

#include "embedded.h"

#include <algorithm>
#include <stdexcept>

namespace harness::vk {

namespace {

std::string fragmentText(const DrawPass<AgaaVkDrawPass>& pass, const Variant& variant) {
    return std::string("#version 450\n") + pass.glslExtensions + "\n#define AGAA_ALPHA_MASKED " +
           (variant.isMasked ? "1\n" : "0\n") + "#define MOTION_OUTPUT " + std::to_string(int(variant.motion)) + "\n" +
           pass.glslDeclarations + "\n" + classDefineOf(pass) + embedded::interface_glsl + embedded::material_glsl +
           embedded::material_inputs_glsl +
           (pass.pass == AGAA_DRAW_PASS_FRAGMENTS ? embedded::corners_frag : embedded::material_frag);
}

std::string geometryText(const DrawPass<AgaaVkDrawPass>& pass) {
    return std::string("#version 450\n") + pass.glslExtensions + pass.glslGeometry + "\n" + embedded::interface_glsl +
           embedded::corner_outputs_glsl + embedded::corners_geom;
}

std::string pullingText(const DrawPass<AgaaVkDrawPass>& pass) {
    return std::string("#version 450\n") + pass.glslExtensions + pass.glslVertex + "\n" + embedded::interface_glsl +
           embedded::object_glsl + embedded::corner_outputs_glsl + embedded::corners_vert;
}

std::string multicastText(const DrawPass<AgaaVkDrawPass>& pass) {
    return std::string("#version 450\n") + pass.glslExtensions + pass.glslVertex + "\n" + embedded::interface_glsl +
           "#define FOR_CORNERS 0\n#define MULTICAST\n" + embedded::object_glsl + embedded::material_vert;
}

} // namespace

PassPipelines::PassPipelines(const Device& device, VkDescriptorSetLayout cameraLayout)
    : device_(&device), cameraLayout_(cameraLayout) {}

void PassPipelines::prepare(const DrawPass<AgaaVkDrawPass>& pass, const Scene& scene, const std::vector<Draw>& draws,
                            VkDescriptorSetLayout materialLayout, VkDescriptorSetLayout lastLayout) {
    Program& program = programs_[pass.pipelineKey];
    const std::string text = std::string(pass.glslExtensions) + pass.glslDeclarations;
    if (!program.layout) {
        program.text = text;
        program.layout = makeLayout(pass, materialLayout, lastLayout);
        ShaderModule& vertex = pass.glslVertex ? program.ownVertex : vertices_[size_t(cornerOutputs(pass))];
        if (pass.state.multicast) {
            vertex = makeShader(*device_, ShaderStage::Vertex, multicastText(pass), "material.vert");
        } else if (pass.glslVertex) {
            vertex = makeShader(*device_, ShaderStage::Vertex, pullingText(pass), "corners.vert");
        } else if (!vertex) {
            const std::string body = "#define FOR_CORNERS " + std::to_string(cornerOutputs(pass)) + "\n" +
                                     embedded::object_glsl + embedded::material_vert;
            vertex = makeShader(*device_, ShaderStage::Vertex, vulkanText(body.c_str()), "material.vert");
        }
        program.vertex = &vertex;
        if (pass.glslGeometry)
            program.geometry = makeShader(*device_, ShaderStage::Geometry, geometryText(pass), "corners.geom");
    }
    if (program.text != text)
        throw std::runtime_error(std::string("The SDK gave two shaders of the pass \"") + pass.name +
                                 "\" the same pipeline key.");
    for (const Draw& draw : draws) {
        const Variant variant = variantOf(scene, draw);
        Pipeline& pipeline = program.pipelines[variant];
        if (pipeline)
            continue;
        ShaderModule& fragment = program.fragments[{variant.isMasked, variant.motion}];
        if (!fragment)
            fragment = makeShader(*device_, ShaderStage::Fragment, fragmentText(pass, variant),
                                  std::string("material.frag, ") + pass.name);
        pipeline = makePipeline(pass, program, variant);
    }
}

PipelineLayout PassPipelines::makeLayout(const DrawPass<AgaaVkDrawPass>& pass, VkDescriptorSetLayout materials,
                                         VkDescriptorSetLayout last) const {
    std::array<VkDescriptorSetLayout, 4> sets{};
    sets[cameraSetIndex] = cameraLayout_;
    sets[agaaSetIndex] = (VkDescriptorSetLayout)pass.native.descriptorSetLayout;
    sets[materialSetIndex] = materials;
    static_assert(stripSetIndex == environmentSetIndex);
    sets[stripSetIndex] = last;
    const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(DrawConstants)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = uint32_t(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &constants;
    return make<PipelineLayout>(device_->get(), vkCreatePipelineLayout, info, "create a pipeline layout");
}

Pipeline PassPipelines::makePipeline(const DrawPass<AgaaVkDrawPass>& pass, const Program& program,
                                     const Variant& variant) const {
    PipelineState state(pass, variant.isMasked);
    state.rasterization.cullMode = variant.isDoubleSided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
    state.rasterization.frontFace = variant.isMirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
    state.fragmentConstant = variant.features;
    state.geometry = program.geometry.get();
    if (pass.state.vertexPulling)
        state.vertexLocations = 0;
    const VkRenderPass renderPass = (VkRenderPass)pass.native.renderPass;
    return state.create(*device_, program.vertex->get(), program.fragments.at({variant.isMasked, variant.motion}).get(),
                        program.layout.get(), renderPass, renderPass == VK_NULL_HANDLE ? &state.rendering : nullptr);
}

const PassPipelines::Program& PassPipelines::program(uint64_t pipelineKey) const {
    const auto found = programs_.find(pipelineKey);
    if (found == programs_.end())
        throw std::runtime_error("The SDK asked for a draw with a pipeline key that it had not told.");
    return found->second;
}

VkPipelineLayout PassPipelines::layout(uint64_t pipelineKey) const { return program(pipelineKey).layout.get(); }

VkPipeline PassPipelines::pipeline(uint64_t pipelineKey, const Variant& variant) const {
    const auto& pipelines = program(pipelineKey).pipelines;
    const auto found = pipelines.find(variant);
    if (found == pipelines.end())
        throw std::runtime_error("A pipeline was not prepared before its draw.");
    return found->second.get();
}

} // namespace harness::vk
