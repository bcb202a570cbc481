#include "vk/vulkan_renderer.h"

#include "render/lights.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace harness {

using namespace vk;

namespace {

DescriptorSetLayout makeCameraLayout(const Device& device) {
    const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1,
                                               VK_SHADER_STAGE_VERTEX_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = 1;
    info.pBindings = &binding;
    return make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, info,
                                     "create a descriptor set layout");
}

// What the settings name and the scene has: an effect counts where both agree. Numbers of lights
// are the scene's own.
AgaaSceneFacts completeFacts(const Scene& scene, const RenderSettings& settings) {
    const AgaaSceneFacts found = sceneFacts(scene, settings.lights);
    AgaaSceneFacts facts = settings.facts;
    facts.flags &= found.flags | ~uint64_t(AGAA_FACT_ALL_SHADED);
    if (settings.ambient == glm::vec3(0))
        facts.flags &= ~uint64_t(AGAA_FACT_AMBIENT);
    facts.maxLights = found.maxLights;
    facts.shadowMapCount = found.shadowMapCount;
    return facts;
}

} // namespace

struct VulkanRenderer::FrameInput {
    const RenderSettings& settings;
    const SdkView& view;
    CameraMatrices camera;
    std::vector<AgaaLight> lights;
};

VulkanRenderer::VulkanRenderer(const RendererOptions& options)
    : device_(options), sdk_(device_, options, agaaSetIndex), arena_(device_),
      cameraLayout_(makeCameraLayout(device_)), pipelines_(device_, cameraLayout_.get()),
      shadowMaps_(device_, options.shadowMapSize) {
    createCameraSet();
}

void VulkanRenderer::createCameraSet() {
    cameraConstants_ = arena_.hostBuffer(sizeof(glm::mat4), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1};
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = 1;
    pool.poolSizeCount = 1;
    pool.pPoolSizes = &size;
    cameraPool_ = make<DescriptorPool>(device_.get(), vkCreateDescriptorPool, pool,
                                       "create a descriptor pool");
    const VkDescriptorSetLayout layout = cameraLayout_.get();
    VkDescriptorSetAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocation.descriptorPool = cameraPool_.get();
    allocation.descriptorSetCount = 1;
    allocation.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device_.get(), &allocation, &cameraSet_),
          "allocate a descriptor set");
    const VkDescriptorBufferInfo buffer{cameraConstants_.buffer.get(), 0, sizeof(glm::mat4)};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = cameraSet_;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    write.pBufferInfo = &buffer;
    vkUpdateDescriptorSets(device_.get(), 1, &write, 0, nullptr);
}

void VulkanRenderer::load(const Scene& scene) {
    shadowMaps_.invalidate();
    gpuScene_.reset();
    scene_ = scene;
    gpuScene_.emplace(device_, scene_);
}

RenderResult VulkanRenderer::render(const RenderSettings& settings) {
    if (!gpuScene_)
        throw std::runtime_error("No scene is loaded.");
    const AgaaSceneFacts facts = completeFacts(scene_, settings);
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = settings.width;
    desc.height = settings.height;
    desc.config = &settings.config;
    desc.facts = &facts;
    desc.flags = (settings.reversedZ ? AGAA_VIEW_REVERSED_Z : 0) |
                 (settings.background.a == 0 ? AGAA_VIEW_COMPOSITE : 0);

    // First of all, so that the SDK refuses what it cannot do, in its own words.
    const SdkView& view = sdk_.view(desc);
    RenderResult result;
    result.memory = sdk_.memory(desc);
    result.tiers = sdk_.tiers(desc);
    if (!output_ || output_->width() != settings.width || output_->height() != settings.height) {
        output_.reset();
        output_.emplace(device_, settings.width, settings.height);
    }

    FrameInput input{settings, view, cameraMatrices(scene_, settings, ClipY::Down), {}};
    input.lights = toAgaaLights(settings.lights, settings.worldOffset, input.camera.eye);
    shadowMaps_.update(*gpuScene_, scene_, settings, input.camera);

    DrawListOptions options;
    options.useMasked = (facts.flags & AGAA_FACT_ALPHA_MASKED) != 0;
    // Some targets are a pixel wider than the image on each side, or shifted by a part of one.
    options.clipMargin = 4.0 / std::min(settings.width, settings.height);
    options.shuffleSeed = settings.drawOrderSeed;
    draws_ = makeDrawList(scene_, settings.worldOffset, input.camera.eye,
                          input.camera.viewProjection, options);
    for (const AgaaVkDrawPass& pass : view.passes)
        pipelines_.prepare(pass, scene_, draws_, gpuScene_->materialLayout());
    const glm::mat4 viewProjection(input.camera.viewProjection);
    std::memcpy(cameraConstants_.mapped, glm::value_ptr(viewProjection), sizeof viewProjection);

    for (uint32_t frame = 0; frame < settings.warmup + std::max(settings.frames, 1u); ++frame) {
        const double milliseconds = renderFrame(input);
        if (frame < settings.warmup)
            continue;
        result.frameMs.push_back(milliseconds);
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        sdk_.log().check(agaaGetFrameStatistics(view.view, frameIndex_, &statistics),
                         "agaaGetFrameStatistics");
        if (statistics.frameIndex != frameIndex_)
            throw std::runtime_error(
                "The SDK's statistics are not of the frame that has finished.");
        result.statistics.push_back(statistics);
    }
    result.image = output_->read();
    return result;
}

double VulkanRenderer::renderFrame(const FrameInput& input) {
    const VkCommandBuffer commands = device_.beginCommands();
    try {
        recordFrame(input, commands);
    } catch (...) {
        device_.discardCommands(commands);
        throw;
    }
    return device_.submitAndWait(commands);
}

void VulkanRenderer::recordFrame(const FrameInput& input, VkCommandBuffer commands) {
    const RenderSettings& settings = input.settings;
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.completedFrame = frameIndex_;
    frame.frameIndex = ++frameIndex_;
    const glm::mat4 viewMatrix(input.camera.view);
    const glm::mat4 projection(input.camera.projection);
    std::copy_n(glm::value_ptr(viewMatrix), 16, frame.view);
    std::copy_n(glm::value_ptr(projection), 16, frame.projection);
    frame.lights = input.lights.data();
    frame.lightCount = uint32_t(input.lights.size());
    frame.shadows = shadowMaps_.shadows().data();
    frame.shadowCount = uint32_t(shadowMaps_.shadows().size());
    std::copy_n(glm::value_ptr(settings.ambient), 3, frame.ambient);
    std::copy_n(glm::value_ptr(settings.background), 4, frame.background);
    frame.draw = onDraw;
    frame.drawUser = this;

    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    vkFrame.commandBuffer = commands;
    vkFrame.outputImage = (uint64_t)output_->image();
    vkFrame.outputView = (uint64_t)output_->view();
    vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED;
    vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    for (size_t i = 0; i < shadowMaps_.shadows().size(); ++i)
        vkFrame.shadowViews[i] = (uint64_t)shadowMaps_.view(i);
    if (settings.background.a == 0) {
        output_->recordClear(commands, glm::vec3(settings.background));
        vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_GENERAL;
    }

    std::vector<uint64_t> calls = {AGAA_SEGMENT_ALL};
    if (settings.splitSegments)
        calls = {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING};
    for (const uint64_t segments : calls) {
        frame.segments = segments;
        drawError_.clear();
        const AgaaResult recorded = agaaVkRecordFrame(input.view.view, &frame, &vkFrame);
        if (!drawError_.empty())
            throw std::runtime_error(drawError_);
        sdk_.log().check(recorded, "agaaVkRecordFrame");
    }
}

AgaaResult AGAA_CALL VulkanRenderer::onDraw(void* user, const AgaaDrawTarget* target) {
    auto& renderer = *static_cast<VulkanRenderer*>(user);
    try {
        renderer.draw(*target);
        return AGAA_OK;
    } catch (const std::exception& error) {
        renderer.drawError_ = error.what();
        return AGAA_ERROR_CALLBACK;
    }
}

void VulkanRenderer::draw(const AgaaDrawTarget& target) const {
    const auto commands = static_cast<VkCommandBuffer>(target.commandBuffer);
    const VkPipelineLayout layout = pipelines_.layout(target.pipelineKey);
    setViewport(commands, target.width, target.height);
    gpuScene_->bindGeometry(commands);
    std::array<VkDescriptorSet, 2> sets{};
    sets[cameraSetIndex] = cameraSet_;
    sets[agaaSetIndex] = (VkDescriptorSet)target.descriptorSet;
    static_assert(cameraSetIndex + 1 == agaaSetIndex);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, cameraSetIndex,
                            uint32_t(sets.size()), sets.data(), 0, nullptr);

    VkPipeline bound = VK_NULL_HANDLE;
    VkDescriptorSet boundMaterial = VK_NULL_HANDLE;
    for (const Draw& draw : draws_) {
        const Mesh& mesh = scene_.meshes[draw.mesh];
        const VkPipeline pipeline =
            pipelines_.pipeline(target.pipelineKey, variantOf(scene_, draw));
        if (pipeline != bound)
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        bound = pipeline;
        const VkDescriptorSet material = gpuScene_->materialSet(mesh.material);
        if (material != boundMaterial)
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout,
                                    materialSetIndex, 1, &material, 0, nullptr);
        boundMaterial = material;
        const DrawConstants constants = drawConstants(draw);
        vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof constants,
                           &constants);
        vkCmdDrawIndexed(commands, mesh.indexCount, 1, mesh.firstIndex, int32_t(mesh.firstVertex),
                         0);
    }
}

std::unique_ptr<Renderer> makeVulkanRenderer(const RendererOptions& options) {
    return std::make_unique<VulkanRenderer>(options);
}

} // namespace harness
