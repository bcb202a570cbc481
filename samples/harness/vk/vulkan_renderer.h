// The sample engine on Vulkan: the host that the SDK is built into.
#pragma once

#include "render/draw_list.h"
#include "vk/gpu_scene.h"
#include "vk/output_image.h"
#include "vk/pass_pipelines.h"
#include "vk/sdk_context.h"
#include "vk/shadow_maps.h"

#include <optional>

namespace harness {

class VulkanRenderer : public Renderer {
public:
    explicit VulkanRenderer(const RendererOptions& options);

    const AgaaDeviceCaps& caps() const override { return sdk_.caps(); }
    void load(const Scene& scene) override;
    RenderResult render(const RenderSettings& settings) override;
    std::vector<ApiMessage> takeMessages() override { return device_.takeMessages(); }

    // The SDK's warnings and errors so far.
    const std::vector<std::string>& sdkTexts() { return sdk_.log().texts(); }
    const vk::Device& device() const { return device_; }

private:
    struct FrameInput;

    void createCameraSet();
    double renderFrame(const FrameInput& input);
    void recordFrame(const FrameInput& input, VkCommandBuffer commands);
    // The SDK's callback: no exception may leave it, so errors wait in drawError_.
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    void draw(const AgaaDrawTarget& target) const;

    vk::Device device_;
    vk::SdkContext sdk_;
    vk::Arena arena_;
    vk::BufferResource cameraConstants_;
    vk::DescriptorSetLayout cameraLayout_;
    vk::DescriptorPool cameraPool_;
    VkDescriptorSet cameraSet_ = VK_NULL_HANDLE;
    vk::PassPipelines pipelines_;
    vk::ShadowMaps shadowMaps_;
    std::optional<vk::OutputImage> output_;
    Scene scene_;
    std::optional<vk::GpuScene> gpuScene_;

    uint64_t frameIndex_ = 0; // of the newest frame; all are waited for
    std::vector<Draw> draws_; // of the frame being recorded
    std::string drawError_;
};

} // namespace harness
