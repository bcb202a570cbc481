// The smallest host that can look inside: it draws known triangles through the public interface and
// reads the SDK's own surfaces back.
#pragma once

#include "agaa_vk.h"
#include "context_desc.h"
#include "storage_set.h"
#include "surfaces.h"
#include "view_settings.h"

#include "vk/arena.h"
#include "vk/device.h"
#include "vk/output_image.h"
#include "vk/pipeline_state.h"
// The library's own, for reading surfaces back.
#include "../../../src/vk/view.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace agaa::test {

using VulkanContextDesc = ContextDesc<AgaaVkDeviceDesc>;

struct HostOptions {
    bool renderPass = false;
    bool inlineRecording = false;
    uint32_t framesInFlight = 2;
    AgaaVkGetInstanceProcAddr getProcAddr = harness::vk::Device::getProcAddr;
    std::function<void(VulkanContextDesc&)> change = nullptr;
};

// Without a log, and unchanged.
VulkanContextDesc contextDesc(const HostOptions& options = {});

// One Vulkan device with validation for the process; messages of any kind fail the test at hand.
harness::vk::Device& sharedDevice();

class StageContext {
public:
    explicit StageContext(const HostOptions& options = {});
    ~StageContext();
    StageContext(const StageContext&) = delete;
    StageContext& operator=(const StageContext&) = delete;

    AgaaContext get() const { return context_; }
    const AgaaDeviceCaps& caps() const { return caps_; }
    AgaaResult createView(const AgaaViewDesc& desc, AgaaView& view) const {
        return agaaVkCreateView(context_, &desc, &view);
    }
    std::vector<LogLine> lines; // warnings and errors that the SDK logged
    uint32_t warnings = 0;

private:
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
};

// Depth array images for AgaaVkFrame::shadowViews, each layer filled with one value.
class ShadowLayers {
public:
    ShadowLayers(const std::vector<float>& layers, uint32_t size);
    uint64_t view() const { return (uint64_t)image_.view.get(); }

private:
    harness::vk::Arena arena_;
    harness::vk::ImageResource image_;
};

class StageView {
public:
    StageView(StageContext& context, const ViewSettings& settings);
    ~StageView();
    StageView(const StageView&) = delete;
    StageView& operator=(const StageView&) = delete;

    void setTriangles(const std::vector<Triangle>& triangles);
    // Next frame's structs, complete but for what the test wants to change. Lights and shadows are the
    // test's.
    AgaaFrame frame();
    AgaaVkFrame vkFrame(VkCommandBuffer commands);

    // Records by one call, or a call a segment, runs and waits. Throws where the SDK refuses.
    void render(const AgaaFrame& frame, const std::function<void(AgaaVkFrame&)>& change = nullptr,
                bool splitSegments = false);
    // The image just rendered.
    harness::Image image() const { return output_.read(); }
    AgaaFrameStatistics statistics() const;

    const agaa::Plan& plan() const { return view_->current->plan; }
    const agaa::vk::View& executor() const { return static_cast<const agaa::vk::View&>(*view_->current); }
    const agaa::SamplePositions& positions() const { return executor().positions; }
    AgaaView get() const { return view_; }
    uint64_t frameIndex() const { return frameIndex_; }
    const ViewSettings& settings() const { return settings_; }
    const harness::vk::OutputImage& output() const { return output_; }
    // Two vectors a vertex, position and texture coordinates; a Material a triangle.
    VkBuffer vertices() const { return vertices_.buffer.get(); }
    VkBuffer materials() const { return materials_.buffer.get(); }

    // A surface by its name in the plan, texel by texel, sample by sample; floats as their bits.
    std::vector<glm::uvec4> readSurface(const std::string& name) const;
    // The words of a buffer, or of an image of whole numbers with several layers: pixel by pixel, layer by layer.
    std::vector<uint32_t> readBuffer(const std::string& name) const;
    // Index of sample i of a pixel in what readSurface returns.
    size_t sampleIndex(uint32_t x, uint32_t y, uint32_t i) const { return test::sampleIndex(plan(), x, y, i); }

    // Makes the draw callback of a pass return this; a pass that is called counts.
    std::map<uint32_t, AgaaResult> drawResults;
    uint32_t drawCalls = 0;
    std::vector<uint32_t> batches;     // of the calls
    std::vector<AgaaDrawState> states; // of the calls

private:
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    AgaaResult draw(const AgaaDrawTarget& target);
    // The pipelines of a pass. The first draw of each kind creates its own, so that kinds that are not drawn cost
    // nothing.
    struct PassPipelines {
        harness::DrawPass<AgaaVkDrawPass> pass; // without its texts, which a resized view replaces
        std::string extensions, declarations, vertexText, geometryText, name;
        harness::vk::PipelineLayout layout;
        harness::vk::ShaderModule vertex, geometry;
        harness::vk::Pipeline pipelines[2]; // opaque, masked
    };
    void addPass(const harness::DrawPass<AgaaVkDrawPass>& pass);
    VkPipeline pipelineOf(PassPipelines& made, bool isMasked);
    void drawAll(const AgaaDrawTarget& target, VkCommandBuffer commands, PassPipelines& pass);

    StageContext& context_;
    ViewSettings settings_;
    AgaaView view_ = nullptr;
    uint64_t frameIndex_ = 0;
    harness::vk::OutputImage output_;
    harness::vk::Arena arena_;
    harness::vk::BufferResource vertices_, materials_;
    StorageSet set_;
    std::map<uint64_t, PassPipelines> passes_;  // by pipeline key
    std::map<uint32_t, std::vector<Run>> runs_; // by AgaaDrawPassId
};

} // namespace agaa::test
