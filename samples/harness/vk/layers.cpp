#include "vk/layers.h"

#include "embedded.h"
#include "vk/pipeline_state.h"

#include <cstring>

namespace harness::vk {

namespace {

const std::string head = "#version 450\n#define AT(n) set = 0, binding = n\n#define VERTEX gl_VertexIndex\n"
                         "#define INSTANCE gl_InstanceIndex\n";
constexpr uint32_t meanDepthBinding = 1, coverageBinding = 2;

DescriptorSetLayout makeSetLayout(const Device& device) {
    constexpr VkShaderStageFlags fragment = VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorSetLayoutBinding bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT | fragment, nullptr},
        {meanDepthBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, fragment, nullptr},
        {coverageBinding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, fragment, nullptr}};
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = uint32_t(std::size(bindings));
    info.pBindings = bindings;
    return make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, info, "create a descriptor set layout");
}

Sampler makeSampler(const Device& device) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    return make<Sampler>(device.get(), vkCreateSampler, info, "create a sampler");
}

Framebuffer makeFramebuffer(const Device& device, VkRenderPass renderPass, const OutputImage& image) {
    const VkImageView view = image.view();
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = renderPass;
    info.attachmentCount = 1;
    info.pAttachments = &view;
    info.width = image.width();
    info.height = image.height();
    info.layers = 1;
    return make<Framebuffer>(device.get(), vkCreateFramebuffer, info, "create a framebuffer");
}

PipelineLayout makeLayout(const Device& device, VkDescriptorSetLayout set) {
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    return make<PipelineLayout>(device.get(), vkCreatePipelineLayout, info, "create a pipeline layout");
}

Pipeline makePipeline(const Device& device, VkPipelineLayout layout, VkRenderPass renderPass) {
    const ShaderModule vertex =
        makeShader(device, ShaderStage::Vertex, layerText(head, embedded::layers_vert), "layers.vert");
    const ShaderModule fragment =
        makeShader(device, ShaderStage::Fragment, layerText(head, embedded::layers_frag), "layers.frag");
    PipelineState state(1);
    state.vertexLocations = 0;
    state.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    VkPipelineColorBlendAttachmentState& blend = state.blends[0];
    blend.blendEnable = VK_TRUE;
    blend.srcColorBlendFactor = VK_BLEND_FACTOR_ONE;
    blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    blend.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
    return state.create(device, vertex.get(), fragment.get(), layout, renderPass);
}

} // namespace

Layers::Layers(const Device& device, const OutputImage& image, const OutputImage& meanDepth,
               const OutputImage& coverage)
    : device_(&device), width_(image.width()), height_(image.height()), arena_(device),
      constants_(arena_.hostBuffer(sizeof(LayerConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)),
      sampler_(makeSampler(device)), setLayout_(makeSetLayout(device)) {
    makeRenderPass();
    framebuffer_ = makeFramebuffer(device, renderPass_.get(), image);
    layout_ = makeLayout(device, setLayout_.get());
    pipeline_ = makePipeline(device, layout_.get(), renderPass_.get());
    writeSet(meanDepth.view(), coverage.view());
}

void Layers::makeRenderPass() {
    VkAttachmentDescription attachment{};
    attachment.format = OutputImage::format;
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    attachment.initialLayout = attachment.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &attachment;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    renderPass_ = make<RenderPass>(device_->get(), vkCreateRenderPass, info, "create a render pass");
}

void Layers::writeSet(VkImageView meanDepth, VkImageView coverage) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2}};
    set_ = DescriptorSet(device_->get(), setLayout_.get(), sizes);
    const VkDescriptorBufferInfo buffer{constants_.buffer.get(), 0, sizeof(LayerConstants)};
    const VkDescriptorImageInfo images[] = {{sampler_.get(), meanDepth, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
                                            {sampler_.get(), coverage, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
    VkWriteDescriptorSet writes[2]{};
    for (VkWriteDescriptorSet& write : writes) {
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set_.get();
        write.descriptorCount = 1;
    }
    writes[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    writes[0].pBufferInfo = &buffer;
    writes[1].dstBinding = meanDepthBinding; // and the binding after it
    writes[1].descriptorCount = 2;
    writes[1].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[1].pImageInfo = images;
    vkUpdateDescriptorSets(device_->get(), 2, writes, 0, nullptr);
}

void Layers::draw(VkCommandBuffer commands, const LayerConstants& constants) const {
    std::memcpy(constants_.mapped, &constants, sizeof constants);
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = renderPass_.get();
    begin.framebuffer = framebuffer_.get();
    begin.renderArea.extent = {width_, height_};
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    setViewport(commands, width_, height_);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    const VkDescriptorSet set = set_.get();
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0, nullptr);
    vkCmdDraw(commands, 4, layerQuadCount, 0, 0);
    vkCmdEndRenderPass(commands);
}

} // namespace harness::vk
