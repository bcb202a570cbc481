// The sample engine on Vulkan: a host of the SDK.
#pragma once

#include "render/host_renderer.h"
#include "vk/gpu_environment.h"
#include "vk/gpu_fetch.h"
#include "vk/gpu_filtered_shadows.h"
#include "vk/gpu_motion.h"
#include "vk/gpu_strips.h"
#include "vk/layers.h"
#include "vk/output_image.h"
#include "vk/pass_pipelines.h"
#include "vk/sdk_context.h"
#include "vk/shadow_maps.h"

#include <deque>
#include <optional>

namespace harness {

class VulkanRenderer : public HostRenderer {
public:
    explicit VulkanRenderer(const RendererOptions& options);

    const AgaaDeviceCaps& caps() const override { return sdk_.caps(); }
    std::vector<ApiMessage> takeMessages() override { return device_.takeMessages(); }
    const vk::Device& device() const { return device_; }

private:
    SdkLog& log() override { return sdk_.log(); }
    ClipY clipY() const override { return ClipY::Down; }
    void upload() override;
    const AgaaFetchFunction* fetchFunction(bool coversByEdges) override;
    EnvironmentBindings useEnvironment(const std::shared_ptr<const Environment>& environment, bool inDraws) override;
    FilteredShadowBindings useFilteredShadows() override;
    AgaaView useView(const AgaaViewDesc& desc) override;
    void prepare(const FrameInput& input) override;
    void setCamera(const FrameInput& input) override;
    double renderFrame(const FrameInput& input) override;
    Image readOutput() override { return output_->read(); }
    Image readResolved(size_t index) override { return resolved_.at(index).read(); }
    const std::vector<AgaaShadow>& shadows() const override { return shadowMaps_.shadows(); }
    void draw(const AgaaDrawTarget& target, const FrameInput& input) override;
    void drawScene(const AgaaDrawTarget& target, const FrameInput& input, VkCommandBuffer commands,
                   VkPipelineLayout layout);

    void createCameraSet();
    void recordFrame(const FrameInput& input, VkCommandBuffer commands);

    vk::Device device_;
    vk::DescriptorSetLayout environmentLayout_; // outlives the views
    vk::SdkContext sdk_;
    vk::Arena arena_;
    vk::BufferResource cameraConstants_;
    vk::DescriptorSetLayout cameraLayout_;
    vk::DescriptorSet cameraSet_;
    vk::PassPipelines pipelines_;
    vk::ShadowMaps shadowMaps_;
    std::optional<vk::OutputImage> output_;
    std::deque<vk::OutputImage> resolved_; // in the order of resolvedValues()
    std::optional<vk::Layers> layers_;
    std::optional<vk::GpuScene> gpuScene_;
    std::optional<vk::GpuMotion> motion_;
    std::optional<vk::GpuFetch> fetch_;                    // set if a view fetches materials by id
    std::shared_ptr<const Environment> environmentSource_; // of environment_
    std::optional<vk::GpuEnvironment> environment_;
    std::optional<vk::GpuFilteredShadows> filteredShadows_; // set if a view filters them
    std::optional<vk::GpuStrips> strips_;                   // set if a pass pulls vertices
    const vk::VkSdkView* view_ = nullptr;                   // view in use
};

} // namespace harness
