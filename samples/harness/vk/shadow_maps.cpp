#include "vk/shadow_maps.h"

#include "render/draw_list.h"
#include "render/lights.h"
#include "render/shadow_fit.h"
#include "embedded.h"
#include "vk/barrier.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>

namespace harness::vk {

namespace {

constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

RenderPass makeRenderPass(const Device& device) {
    VkAttachmentDescription depth{};
    depth.format = depthFormat;
    depth.samples = VK_SAMPLE_COUNT_1_BIT;
    depth.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    depth.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    depth.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    depth.finalLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.pDepthStencilAttachment = &reference;
    VkSubpassDependency read{};
    read.srcSubpass = 0;
    read.dstSubpass = VK_SUBPASS_EXTERNAL;
    read.srcStageMask = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    read.srcAccessMask = VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    read.dstStageMask = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    read.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &depth;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 1;
    info.pDependencies = &read;
    return make<RenderPass>(device.get(), vkCreateRenderPass, info, "create a render pass");
}

} // namespace

ShadowMaps::ShadowMaps(const Device& device, uint32_t size)
    : device_(&device), size_(size), renderPass_(makeRenderPass(device)),
      vertex_(makeShader(device, ShaderStage::Vertex, vulkanText(embedded::shadow_vert), "shadow.vert")),
      fragment_(makeShader(device, ShaderStage::Fragment, vulkanText(embedded::shadow_frag), "shadow.frag")),
      arena_(device) {}

void ShadowMaps::invalidate() {
    key_.clear();
    opaque_ = {};
}

void ShadowMaps::createPipelines(VkDescriptorSetLayout materialLayout) {
    const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(glm::mat4)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &materialLayout;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &constants;
    layout_ = make<PipelineLayout>(device_->get(), vkCreatePipelineLayout, info, "create a pipeline layout");

    PipelineState state(0);
    state.vertexLocations = 1 << 0 | 1 << 3 | 1 << 4;
    state.depthStencil.depthTestEnable = VK_TRUE;
    state.depthStencil.depthWriteEnable = VK_TRUE;
    state.depthStencil.depthCompareOp = VK_COMPARE_OP_LESS;
    state.rasterization.depthBiasEnable = VK_TRUE;
    state.rasterization.depthBiasSlopeFactor = 1.5f;
    opaque_ = state.create(*device_, vertex_.get(), VK_NULL_HANDLE, layout_.get(), renderPass_.get());
    masked_ = state.create(*device_, vertex_.get(), fragment_.get(), layout_.get(), renderPass_.get());
}

void ShadowMaps::update(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                        const CameraMatrices& camera, uint64_t placement) {
    std::vector<double> key = shadowKey(settings.lights, settings.worldOffset, camera, placement);
    if (key == key_)
        return;
    key_.clear();
    shadows_.clear();
    maps_.clear();
    arena_ = Arena(*device_);
    if (!opaque_)
        createPipelines(gpuScene.materialLayout());
    for (const size_t i : shadowedLights(settings.lights)) {
        const ShadowFit fit = fitShadow(settings.lights[i], scene, camera, settings.worldOffset, size_);
        renderMap(gpuScene, scene, settings, camera.eye, fit.layers);
        shadows_.push_back(toAgaaShadow(fit));
    }
    key_ = std::move(key);
    ++version_;
}

std::vector<float> ShadowMaps::readDepths(size_t shadow) const {
    const uint32_t layers = shadows_[shadow].layerCount;
    std::vector<float> depths(size_t(size_) * size_ * layers);
    Arena arena(*device_);
    const BufferResource buffer =
        arena.hostBuffer(depths.size() * sizeof(float), VK_BUFFER_USAGE_TRANSFER_DST_BIT, true);
    const VkImage map = maps_[shadow].image.get();
    constexpr ImageUse sampled{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                               VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    constexpr ImageUse read{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT,
                            VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
    device_->runCommands([&](VkCommandBuffer commands) {
        imageBarrier(commands, map, VK_IMAGE_ASPECT_DEPTH_BIT, sampled, read);
        VkBufferImageCopy copy{};
        copy.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, layers};
        copy.imageExtent = {size_, size_, 1};
        vkCmdCopyImageToBuffer(commands, map, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer.get(), 1, &copy);
        imageBarrier(commands, map, VK_IMAGE_ASPECT_DEPTH_BIT, read, sampled);
    });
    std::memcpy(depths.data(), buffer.mapped, depths.size() * sizeof(float));
    return depths;
}

void ShadowMaps::renderMap(const GpuScene& gpuScene, const Scene& scene, const RenderSettings& settings,
                           const glm::dvec3& eye, const std::vector<glm::dmat4>& layers) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = depthFormat;
    info.extent = {size_, size_, 1};
    info.mipLevels = 1;
    info.arrayLayers = uint32_t(layers.size());
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT; // for readDepths()
    maps_.push_back(arena_.image(info, VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_ASPECT_DEPTH_BIT));

    std::vector<ImageView> views;
    std::vector<Framebuffer> framebuffers;
    for (uint32_t layer = 0; layer < layers.size(); ++layer) {
        VkImageViewCreateInfo view{};
        view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        view.image = maps_.back().image.get();
        view.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view.format = depthFormat;
        view.subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, layer, 1};
        views.push_back(make<ImageView>(device_->get(), vkCreateImageView, view, "create an image view"));
        const VkImageView attachment = views.back().get();
        VkFramebufferCreateInfo framebuffer{};
        framebuffer.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
        framebuffer.renderPass = renderPass_.get();
        framebuffer.attachmentCount = 1;
        framebuffer.pAttachments = &attachment;
        framebuffer.width = size_;
        framebuffer.height = size_;
        framebuffer.layers = 1;
        framebuffers.push_back(
            make<Framebuffer>(device_->get(), vkCreateFramebuffer, framebuffer, "create a framebuffer"));
    }

    device_->runCommands([&](VkCommandBuffer commands) {
        for (size_t layer = 0; layer < layers.size(); ++layer) {
            VkClearValue clear{};
            clear.depthStencil.depth = 1;
            VkRenderPassBeginInfo begin{};
            begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
            begin.renderPass = renderPass_.get();
            begin.framebuffer = framebuffers[layer].get();
            begin.renderArea.extent = {size_, size_};
            begin.clearValueCount = 1;
            begin.pClearValues = &clear;
            vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
            renderLayer(commands, gpuScene, scene, settings, eye, layers[layer]);
            vkCmdEndRenderPass(commands);
        }
    });
}

void ShadowMaps::renderLayer(VkCommandBuffer commands, const GpuScene& gpuScene, const Scene& scene,
                             const RenderSettings& settings, const glm::dvec3& eye, const glm::dmat4& toClip) const {
    setViewport(commands, size_, size_);
    gpuScene.bindGeometry(commands);
    VkPipeline bound = VK_NULL_HANDLE;
    uint32_t material = UINT32_MAX;
    for (const Draw& draw : makeDrawList(scene, settings.worldOffset, eye, toClip, {})) {
        const VkPipeline pipeline = draw.isMasked ? masked_.get() : opaque_.get();
        if (pipeline != bound)
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        bound = pipeline;
        const Mesh& mesh = scene.meshes[draw.mesh];
        if (draw.isMasked && mesh.material != material) {
            material = mesh.material;
            const VkDescriptorSet set = gpuScene.materialSet(material);
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0, nullptr);
        }
        const glm::mat4 matrix(toClip * draw.toShading);
        vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof matrix,
                           glm::value_ptr(matrix));
        vkCmdDrawIndexed(commands, mesh.indexCount, 1, mesh.firstIndex, int32_t(mesh.firstVertex), 0);
    }
}

} // namespace harness::vk
