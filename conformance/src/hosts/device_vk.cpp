// The suite's host on Vulkan.
#include "drawing.h"
#include "host_shaders.h"
#include "vk_memory.h"
#include "vk_pipelines.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr VkFormat outputFormatVk = VK_FORMAT_R32G32B32A32_SFLOAT;

class VulkanDevice : public Device {
public:
    VulkanDevice(const Functions& sdk, const std::string& name, bool withOptions)
        : api_(sdk, name, withOptions), pipelines_(api_, mistakes), commands_(api_), functionSet_(api_) {
        setShadowDepth(1.0f);
    }
    ~VulkanDevice() override { vkDeviceWaitIdle(api_.device); }

    AgaaFetchFunction sceneFetch() const override {
        static const std::string text = fetchShader("set = 1, binding = 0");
        AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
        fetch.glsl = text.c_str();
        fetch.maxDraws = 1;
        fetch.maxPrimitives = maxScenePrimitives;
        fetch.descriptorSetLayout = (uint64_t)functionSet_.layout;
        return fetch;
    }

    Backend backend() const override { return Backend::Vulkan; }
    std::string deviceName() const override { return api_.deviceName; }
    std::string driverName() const override { return api_.driverName; }
    uint64_t viewFlags() const override {
        return api_.enabledFeatures.features.geometryShader ? 0 : AGAA_VIEW_VERTEX_PULLING;
    }
    bool testsMessages() const override { return api_.isValidated; }
    std::vector<std::string> takeMessages() override { return api_.messages.take(); }

    ContextDescription description() override {
        const AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
        const AgaaVkDeviceDesc vk = AGAA_VK_DEVICE_DESC_INIT;
        const AgaaGlDeviceDesc gl = AGAA_GL_DEVICE_DESC_INIT;
        ContextDescription description = {desc, vk, gl};
        description.vk.instance = api_.instance;
        description.vk.physicalDevice = api_.physicalDevice;
        description.vk.device = api_.device;
        description.vk.getProcAddr = reinterpret_cast<AgaaVkGetInstanceProcAddr>(vkGetInstanceProcAddr);
        description.vk.queueFamily = api_.queueFamily;
        description.vk.apiVersion = api_.apiVersion;
        description.vk.enabledExtensions = api_.enabledExtensions.data();
        description.vk.enabledExtensionCount = uint32_t(api_.enabledExtensions.size());
        description.vk.enabledFeatures = &api_.enabledFeatures;
        description.vk.descriptorSet = 1; // 1 shows wrong uses of set 0
        return description;
    }

    AgaaResult createContext(const Functions& sdk, uint32_t headerVersion, ContextDescription& description,
                             AgaaContext* outContext) override {
        description.vk.pNext = description.desc.pNext;
        description.desc.pNext = &description.vk;
        const AgaaResult result = sdk.agaaVkCreateContext(headerVersion, &description.desc, outContext);
        if (result == AGAA_OK)
            setOfContext_[*outContext] = description.vk.descriptorSet;
        return result;
    }

    AgaaResult createView(const Functions& sdk, AgaaContext context, const AgaaViewDesc* desc,
                          AgaaView* outView) override {
        const AgaaResult result = sdk.agaaVkCreateView(context, desc, outView);
        if (result == AGAA_OK)
            adopt(context, *outView);
        return result;
    }

    void adopt(AgaaContext context, AgaaView view) override { setOfView_[view] = setOfContext_[context]; }

    AgaaResult getContextCaps(const Functions& sdk, AgaaContext context, AgaaDeviceCaps* outCaps) override {
        return sdk.agaaVkGetContextCaps(context, outCaps);
    }

    AgaaResult getDeviceCaps(const Functions& sdk, const AgaaLog* log, AgaaDeviceCaps* outCaps) override {
        return sdk.agaaVkGetDeviceCaps(api_.instance, api_.physicalDevice,
                                       reinterpret_cast<AgaaVkGetInstanceProcAddr>(vkGetInstanceProcAddr), log,
                                       outCaps);
    }

    void prepare(const Functions& sdk, AgaaView view) override { pipelines_.prepare(sdk, view, setOfView_[view]); }

    void forget(AgaaView view) override {
        pipelines_.forget(view);
        setOfView_.erase(view);
        if (firstView_ == view)
            firstSets_.clear();
    }

    void setOutput(uint32_t width, uint32_t height) override {
        if (!output_ || output_->width != width || output_->height != height)
            output_ = makeOutput(width, height);
        fillOutput(0.0f);
    }

    void fillOutput(float value) override {
        const VkCommandBuffer commands = commands_.begin();
        imageBarrier(commands, *output_, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        clearOutput(commands, value);
        imageBarrier(commands, *output_, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_GENERAL);
        commands_.submit();
    }

    std::vector<float> readOutput() override { return readImage(*output_); }

    void setResolvedOutputs(uint32_t count) override {
        resolved_.clear();
        resolvedImages_ = AGAA_VK_RESOLVED_IMAGES_INIT;
        for (uint32_t i = 0; i < count; ++i) {
            resolved_.push_back(makeOutput(output_->width, output_->height));
            resolvedImages_.images[i] = (uint64_t)resolved_[i]->image;
            resolvedImages_.views[i] = (uint64_t)resolved_[i]->view;
            resolvedImages_.layoutsIn[i] = resolvedImages_.layoutsOut[i] = VK_IMAGE_LAYOUT_GENERAL;
        }
    }

    std::vector<float> readResolvedOutput(uint32_t i) override { return readImage(*resolved_.at(i)); }

    void setShadowDepth(float depth) override {
        shadow_ = std::make_unique<VulkanImage>(api_, 4, 4, AGAA_MAX_SHADOW_LAYERS, VK_FORMAT_D32_SFLOAT,
                                                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                                VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        const VkCommandBuffer commands = commands_.begin();
        imageBarrier(commands, *shadow_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkClearDepthStencilValue value = {depth, 0};
        const VkImageSubresourceRange range = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, AGAA_MAX_SHADOW_LAYERS};
        vkCmdClearDepthStencilImage(commands, shadow_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1, &range);
        imageBarrier(commands, *shadow_, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        commands_.submit();
    }

    AgaaResult record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) override;
    AgaaResult draw(const AgaaDrawTarget& target) override;
    static void setViewports(VkCommandBuffer commands, const AgaaViewport* list, uint32_t count);
    static void drawRangesOf(const Scene& scene, const VulkanPipeline& pipeline, const AgaaDrawTarget& target,
                             VkCommandBuffer commands);

private:
    std::unique_ptr<VulkanImage> makeOutput(uint32_t width, uint32_t height) {
        auto image =
            std::make_unique<VulkanImage>(api_, width, height, 1, outputFormatVk,
                                          VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                              VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                          VK_IMAGE_VIEW_TYPE_2D);
        imageBarrier(commands_.begin(), *image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
        commands_.submit();
        return image;
    }

    std::vector<float> readImage(const VulkanImage& image) {
        std::vector<float> pixels(size_t(image.width) * image.height * 4);
        const VulkanBuffer buffer(api_, pixels.size() * sizeof(float), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {image.width, image.height, 1};
        const VkCommandBuffer commands = commands_.begin();
        imageBarrier(commands, image, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        vkCmdCopyImageToBuffer(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer, 1, &region);
        imageBarrier(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_GENERAL);
        allBarrier(commands);
        commands_.submit();
        std::memcpy(pixels.data(), buffer.mapped, pixels.size() * sizeof(float));
        return pixels;
    }

    void clearOutput(VkCommandBuffer commands, float value) const {
        const VkClearColorValue color = {{value, value, value, value}};
        const VkImageSubresourceRange range = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, output_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1, &range);
    }

    VkBuffer upload(const Scene& scene) {
        uploads_.push_back(std::make_unique<VulkanBuffer>(
            api_, sceneBytes(scene),
            VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT));
        writeScene(uploads_.back()->mapped, clipFromShading_, scene);
        return uploads_.back()->buffer;
    }

    VkDescriptorSet setOf(const AgaaDrawTarget& target) {
        const auto set = (VkDescriptorSet)target.descriptorSet;
        if (!mistakes.keepsFirstSet)
            return set;
        if (firstSets_.empty())
            firstView_ = view_;
        return firstSets_.emplace(std::pair(target.pipelineKey, target.batch), set).first->second;
    }

    VulkanApi api_;
    VulkanPipelines pipelines_;
    VulkanCommands commands_;
    VulkanFunctionSet functionSet_;
    std::unique_ptr<VulkanImage> output_, shadow_;
    std::vector<std::unique_ptr<VulkanImage>> resolved_;
    AgaaVkResolvedImages resolvedImages_ = AGAA_VK_RESOLVED_IMAGES_INIT;
    std::map<AgaaContext, uint32_t> setOfContext_;
    std::map<AgaaView, uint32_t> setOfView_;
    std::map<std::pair<uint64_t, uint32_t>, VkDescriptorSet> firstSets_;
    AgaaView firstView_ = nullptr;
    // Set during record().
    AgaaView view_ = nullptr;
    const Scene* scene_ = nullptr;
    VkBuffer vertices_ = VK_NULL_HANDLE;
    float clipFromShading_[16];
    std::vector<std::unique_ptr<VulkanBuffer>> uploads_;
};

AgaaResult VulkanDevice::record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) {
    view_ = view;
    scene_ = &scene;
    clipFromShading(frame, mistakes, clipFromShading_);
    const bool isOurs = !frame.draw;
    if (isOurs) {
        frame.draw = drawCallback;
        frame.drawUser = this;
    }
    const VkCommandBuffer commands = commands_.begin();
    vertices_ = upload(scene);
    functionSet_.write(vertices_);
    if (mistakes.forgetsBarrier && !scene.empty()) // copies without a barrier
        vkCmdUpdateBuffer(commands, vertices_, matrixBytes,
                          std::min<size_t>(scene.size() * sizeof(Vertex), 65536) & ~size_t(3), scene.data());
    AgaaVkFrame native = AGAA_VK_FRAME_INIT;
    native.commandBuffer = commands;
    native.outputImage = (uint64_t)output_->image;
    native.outputView = (uint64_t)output_->view;
    native.outputLayoutIn = native.outputLayoutOut = VK_IMAGE_LAYOUT_GENERAL;
    for (uint64_t& map : native.shadowViews)
        map = (uint64_t)shadow_->view;
    native.functionSet = (uint64_t)functionSet_.set;
    if (!resolved_.empty())
        native.pNext = &resolvedImages_;
    if (changeVkFrame)
        changeVkFrame(native);
    const AgaaResult result = sdk.agaaVkRecordFrame(view, &frame, &native);
    if (result == AGAA_ERROR_PARTIAL || discardsCommands)
        commands_.discard();
    else
        commands_.submit();
    uploads_.clear();
    if (isOurs) {
        frame.draw = nullptr;
        frame.drawUser = nullptr;
    }
    return result;
}

AgaaResult VulkanDevice::draw(const AgaaDrawTarget& target) {
    const VulkanPipeline* pipeline = pipelines_.find(view_, target.pipelineKey, target.pass);
    if (!pipeline)
        return AGAA_ERROR_CALLBACK;
    Scene changed;
    const Scene* scene = scene_;
    VkBuffer vertices = vertices_;
    if (mistakes.changeScene) {
        changed = mistakes.changeScene(target, *scene_);
        scene = &changed;
        vertices = upload(changed);
    }
    const auto commands = static_cast<VkCommandBuffer>(target.commandBuffer);
    const VkDescriptorSet set = setOf(target);
    const VkDeviceSize offset = matrixBytes;
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->layout, setOfView_[view_], 1, &set, 0,
                            nullptr);
    vkCmdPushConstants(commands, pipeline->layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof clipFromShading_,
                       clipFromShading_);
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
    const uint32_t together = std::max(target.state.multicast, 1u);
    for (uint32_t first = 0; first < target.viewportCount; first += together) {
        setViewports(commands, target.viewports + first, together);
        drawRangesOf(*scene, *pipeline, target, commands);
    }
    return AGAA_OK;
}

void VulkanDevice::setViewports(VkCommandBuffer commands, const AgaaViewport* list, uint32_t count) {
    std::vector<VkViewport> viewports;
    std::vector<VkRect2D> scissors;
    for (uint32_t i = 0; i < count; ++i) {
        const AgaaViewport& v = list[i];
        viewports.push_back({v.x, v.y, v.width, v.height, 0.0f, 1.0f});
        scissors.push_back({{int32_t(v.scissorX), int32_t(v.scissorY)}, {v.scissorWidth, v.scissorHeight}});
    }
    vkCmdSetViewport(commands, 0, count, viewports.data());
    vkCmdSetScissor(commands, 0, count, scissors.data());
}

void VulkanDevice::drawRangesOf(const Scene& scene, const VulkanPipeline& pipeline, const AgaaDrawTarget& target,
                                VkCommandBuffer commands) {
    for (const DrawRange& range : drawRanges(scene)) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          range.isMasked ? pipeline.masked : pipeline.opaque);
        if (target.state.vertexPulling)
            vkCmdDraw(commands, stripVertices, range.count / 3, 0, range.first / 3);
        else
            vkCmdDraw(commands, range.count, 1, range.first, 0);
    }
}

} // namespace

std::unique_ptr<Device> makeVulkanDevice(const Functions& sdk, const std::string& name, bool withOptions) {
    return std::make_unique<VulkanDevice>(sdk, name, withOptions);
}

} // namespace agaa::conformance
