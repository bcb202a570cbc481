#include "vk/vulkan_renderer.h"

#include "vk/barrier.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>

namespace harness {

using namespace vk;

namespace {

constexpr uint32_t motionBinding = 1;    // MOTION_AT of shaders/interface.glsl
constexpr uint32_t functionSetIndex = 1; // of the SDK's compute passes

DescriptorSetLayout makeCameraLayout(const Device& device) {
    const VkDescriptorSetLayoutBinding bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, nullptr},
        {motionBinding, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}};
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = uint32_t(std::size(bindings));
    info.pBindings = bindings;
    return make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, info, "create a descriptor set layout");
}

} // namespace

VulkanRenderer::VulkanRenderer(const RendererOptions& options)
    : device_(options), environmentLayout_(makeEnvironmentLayout(device_)), sdk_(device_, options, agaaSetIndex),
      arena_(device_), cameraLayout_(makeCameraLayout(device_)), pipelines_(device_, cameraLayout_.get()),
      shadowMaps_(device_, options.shadowMapSize) {
    createCameraSet();
}

void VulkanRenderer::createCameraSet() {
    cameraConstants_ = arena_.hostBuffer(sizeof(CameraConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, 1}};
    cameraSet_ = DescriptorSet(device_.get(), cameraLayout_.get(), sizes);
    const VkDescriptorBufferInfo buffer{cameraConstants_.buffer.get(), 0, sizeof(CameraConstants)};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = cameraSet_.get();
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    write.pBufferInfo = &buffer;
    vkUpdateDescriptorSets(device_.get(), 1, &write, 0, nullptr);
    motion_.emplace(device_, cameraSet_.get(), motionBinding);
}

void VulkanRenderer::upload() {
    shadowMaps_.invalidate();
    fetch_.reset();
    strips_.reset();
    gpuScene_.reset();
    gpuScene_.emplace(device_, scene());
}

const AgaaFetchFunction* VulkanRenderer::fetchFunction(bool coversByEdges) {
    if (!device_.hasPrimitiveIds() && !coversByEdges)
        throw std::runtime_error("The device has no gl_PrimitiveID in fragment shaders (the feature geometryShader), "
                                 "by which the sample engine tells the ids of the tier ids.");
    if (!fetch_)
        fetch_.emplace(device_, scene(), *gpuScene_);
    return &fetch_->function();
}

EnvironmentBindings VulkanRenderer::useEnvironment(const std::shared_ptr<const Environment>& environment,
                                                   bool inDraws) {
    if (environmentSource_ != environment) {
        environment_.reset();
        environment_.emplace(device_, environmentLayout_.get(), *environment);
        environmentSource_ = environment;
    }
    if (fetch_) // functions of a view share a set, so that views use this one whether they fetch or not
        environment_->write(fetch_->set());
    const std::string set =
        "set = " + std::to_string(inDraws ? environmentSetIndex : functionSetIndex) + ", binding = ";
    EnvironmentBindings bindings{set + std::to_string(environmentBinding), set + std::to_string(environmentBinding + 1),
                                 0};
    if (!inDraws)
        bindings.descriptorSetLayout =
            fetch_ ? fetch_->function().descriptorSetLayout : (uint64_t)environmentLayout_.get();
    return bindings;
}

FilteredShadowBindings VulkanRenderer::useFilteredShadows() {
    if (!filteredShadows_)
        filteredShadows_.emplace(device_, environmentLayout_.get());
    const std::string at = "set = " + std::to_string(functionSetIndex) + ", binding = ";
    return {at + std::to_string(filteredShadowBinding), at + std::to_string(filteredShadowBinding + 1),
            fetch_ ? fetch_->function().descriptorSetLayout : (uint64_t)environmentLayout_.get()};
}

AgaaView VulkanRenderer::useView(const AgaaViewDesc& desc) {
    view_ = &sdk_.view(desc);
    return view_->view;
}

void VulkanRenderer::prepare(const FrameInput& input) {
    const RenderSettings& settings = input.settings;
    layers_.reset(); // it refers to the images
    if (!output_ || output_->width() != settings.width || output_->height() != settings.height) {
        output_.reset();
        output_.emplace(device_, settings.width, settings.height);
        resolved_.clear();
    }
    const size_t count = resolvedValues(settings).size();
    while (resolved_.size() < count)
        resolved_.emplace_back(device_, settings.width, settings.height);
    if (settings.hasLayers)
        layers_.emplace(device_, *output_, resolved_[count - 2], resolved_[count - 1]);
    shadowMaps_.update(*gpuScene_, scene(), settings, input.camera, input.placement);
    if (settings.filtersShadows && filteredShadows_) {
        filteredShadows_->update(shadowMaps_);
        if (fetch_) // functions of a view share a set
            filteredShadows_->write(fetch_->set());
        if (environment_)
            filteredShadows_->write(environment_->set());
    }
    for (const DrawPass<AgaaVkDrawPass>& pass : view_->passes) {
        if (pass.state.vertexPulling && !strips_)
            strips_.emplace(device_, scene(), *gpuScene_);
        pipelines_.prepare(pass, scene(), input.draws, gpuScene_->materialLayout(),
                           pass.state.vertexPulling ? strips_->layout() : environmentLayout_.get());
    }
}

void VulkanRenderer::setCamera(const FrameInput& input) {
    const glm::mat4 viewProjection(input.camera.viewProjection);
    const CameraConstants camera{viewProjection, glm::vec4(input.camera.viewer), float(input.settings.footprint),
                                 float(input.camera.targetDistance), glm::vec2(input.camera.jitter)};
    std::memcpy(cameraConstants_.mapped, &camera, sizeof camera);
    motion_->update(input.draws);
    if (fetch_)
        fetch_->update(scene(), input.draws, {viewProjection, camera.viewer});
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
    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    vkFrame.commandBuffer = commands;
    vkFrame.outputImage = (uint64_t)output_->image();
    vkFrame.outputView = (uint64_t)output_->view();
    vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED;
    vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    for (size_t i = 0; i < shadowMaps_.shadows().size(); ++i)
        vkFrame.shadowViews[i] = (uint64_t)shadowMaps_.view(i);
    AgaaVkResolvedImages resolved = AGAA_VK_RESOLVED_IMAGES_INIT;
    const size_t count = resolvedValues(settings).size();
    for (size_t i = 0; i < count; ++i) {
        resolved.images[i] = (uint64_t)resolved_[i].image();
        resolved.views[i] = (uint64_t)resolved_[i].view();
        resolved.layoutsOut[i] = i < settings.resolved.size() ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL
                                                              : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    }
    vkFrame.pNext = count == 0 ? nullptr : &resolved;
    if (layers_)
        vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    if (fetch_)
        vkFrame.functionSet = (uint64_t)fetch_->set();
    else if (environment_)
        vkFrame.functionSet = (uint64_t)environment_->set();
    else if (filteredShadows_)
        vkFrame.functionSet = (uint64_t)filteredShadows_->set();
    if (settings.background.a == 0) {
        output_->recordClear(commands, glm::vec3(settings.background));
        vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_GENERAL;
    }

    record(input, "agaaVkRecordFrame",
           [&](const AgaaFrame& frame) { return agaaVkRecordFrame(view_->view, &frame, &vkFrame); });
    if (layers_) {
        layers_->draw(commands, layerConstants(input.camera, input.camera.projection));
        constexpr ImageUse drawn{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
        constexpr ImageUse read{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT,
                                VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
        imageBarrier(commands, output_->image(), VK_IMAGE_ASPECT_COLOR_BIT, drawn, read);
    }
}

void VulkanRenderer::draw(const AgaaDrawTarget& target, const FrameInput& input) {
    const auto commands = static_cast<VkCommandBuffer>(target.commandBuffer);
    const VkPipelineLayout layout = pipelines_.layout(target.pipelineKey);
    if (target.state.vertexPulling)
        strips_->bind(commands, layout, stripSetIndex);
    else
        gpuScene_->bindGeometry(commands);
    std::array<VkDescriptorSet, 2> sets{};
    sets[cameraSetIndex] = cameraSet_.get();
    sets[agaaSetIndex] = (VkDescriptorSet)target.descriptorSet;
    static_assert(cameraSetIndex + 1 == agaaSetIndex);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, cameraSetIndex, uint32_t(sets.size()),
                            sets.data(), 0, nullptr);

    if (environment_ && !target.state.vertexPulling) {
        const VkDescriptorSet environment = environment_->set();
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, environmentSetIndex, 1, &environment,
                                0, nullptr);
    }

    for (const std::span<const AgaaViewport> viewports : viewportGroups(target)) {
        setViewports(commands, viewports);
        drawScene(target, input, commands, layout);
    }
}

void VulkanRenderer::drawScene(const AgaaDrawTarget& target, const FrameInput& input, VkCommandBuffer commands,
                               VkPipelineLayout layout) {
    VkPipeline bound = VK_NULL_HANDLE;
    VkDescriptorSet boundMaterial = VK_NULL_HANDLE;
    for (uint32_t index = 0; index < input.draws.size(); ++index) {
        const Draw& draw = input.draws[index];
        if (!isDrawnIn(target, draw))
            continue;
        const Mesh& mesh = scene().meshes[draw.mesh];
        const VkPipeline pipeline = pipelines_.pipeline(target.pipelineKey, variantOf(scene(), draw));
        if (pipeline != bound)
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        bound = pipeline;
        const VkDescriptorSet material = gpuScene_->materialSet(mesh.material);
        if (material != boundMaterial)
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, materialSetIndex, 1, &material,
                                    0, nullptr);
        boundMaterial = material;
        const DrawConstants constants = drawConstants(scene(), draw, index);
        vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof constants, &constants);
        if (target.state.vertexPulling)
            strips_->draw(commands, mesh);
        else
            vkCmdDrawIndexed(commands, mesh.indexCount, 1, mesh.firstIndex, int32_t(mesh.firstVertex), 0);
    }
}

std::unique_ptr<Renderer> makeVulkanRenderer(const RendererOptions& options) {
    return std::make_unique<VulkanRenderer>(options);
}

} // namespace harness
