// The sample engine on OpenGL: a host of the SDK.
#pragma once

#include "gl/gpu_environment.h"
#include "gl/gpu_fetch.h"
#include "gl/gpu_filtered_shadows.h"
#include "gl/gpu_motion.h"
#include "gl/gpu_strips.h"
#include "gl/layers.h"
#include "gl/pass_programs.h"
#include "gl/sdk_context.h"
#include "gl/shadow_maps.h"
#include "render/host_renderer.h"

#include <optional>

namespace harness {

class GlRenderer : public HostRenderer {
public:
    explicit GlRenderer(const RendererOptions& options);
    ~GlRenderer() override;

    const AgaaDeviceCaps& caps() const override { return sdk_.caps(); }
    std::vector<ApiMessage> takeMessages() override { return device_.takeMessages(); }
    const gl::Device& device() const { return device_; }

private:
    SdkLog& log() override { return sdk_.log(); }
    // Row 0 of a texture is at y = -1. With y down, images are the same as on Vulkan.
    ClipY clipY() const override { return ClipY::Down; }
    uint64_t viewFlags() const override;
    void upload() override;
    const AgaaFetchFunction* fetchFunction(bool coversByEdges) override;
    EnvironmentBindings useEnvironment(const std::shared_ptr<const Environment>& environment, bool inDraws) override;
    FilteredShadowBindings useFilteredShadows() override;
    AgaaView useView(const AgaaViewDesc& desc) override;
    void prepare(const FrameInput& input) override;
    void setCamera(const FrameInput& input) override;
    double renderFrame(const FrameInput& input) override;
    Image readOutput() override { return read(output_); }
    Image readResolved(size_t index) override { return read(resolved_.at(index)); }
    const std::vector<AgaaShadow>& shadows() const override { return shadowMaps_.shadows(); }
    glm::dmat4 rasterised(const glm::dmat4& projection) const override;
    void draw(const AgaaDrawTarget& target, const FrameInput& input) override;
    void drawScene(const AgaaDrawTarget& target, const FrameInput& input);

    gl::Texture makeOutput() const; // of the size of the output
    Image read(const gl::Texture& texture) const;

    RendererOptions options_;
    gl::Device device_;
    gl::SdkContext sdk_;
    gl::PassPrograms programs_;
    gl::ShadowMaps shadowMaps_;
    gl::GpuMotion motion_;
    gl::Buffer cameraConstants_;
    gl::Texture output_;
    std::vector<gl::Texture> resolved_; // in the order of resolvedValues()
    std::optional<gl::Layers> layers_;
    uint32_t outputWidth_ = 0;
    uint32_t outputHeight_ = 0;
    std::optional<gl::GpuScene> gpuScene_;
    std::optional<gl::GpuFetch> fetch_;                    // set if a view fetches materials by id
    std::shared_ptr<const Environment> environmentSource_; // of environment_
    std::optional<gl::GpuEnvironment> environment_;
    std::optional<gl::GpuFilteredShadows> filteredShadows_; // set if a view filters them
    std::optional<gl::GpuStrips> strips_;                   // set if a pass pulls vertices
    const gl::GlSdkView* view_ = nullptr;                   // view in use
};

} // namespace harness
