// Shots by the Vulkan host.
#pragma once

#include "ids_view.h"

#include <cstring>
#include <deque>

namespace agaa::test {

// A storage buffer that a function of the host's reads.
class FunctionBuffer {
public:
    static constexpr const char* place = "set = 1, binding = 0";
    explicit FunctionBuffer(const std::vector<glm::vec4>& data);
    uint64_t layout() const { return (uint64_t)set_.layout(); }
    void bind(AgaaVkFrame& frame) const { frame.functionSet = (uint64_t)set_.get(); }

private:
    harness::vk::Arena arena_;
    harness::vk::BufferResource buffer_;
    StorageSet set_;
};

// Images for AgaaResolvedOutputs.
class ResolvedImages {
public:
    ResolvedImages(uint32_t width, uint32_t height, size_t count) {
        for (size_t i = 0; i < count; ++i) {
            images_.emplace_back(sharedDevice(), width, height);
            chained_.images[i] = (uint64_t)images_.back().image();
            chained_.views[i] = (uint64_t)images_.back().view();
            chained_.layoutsOut[i] = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        }
    }
    void chain(AgaaVkFrame& frame) const { frame.pNext = &chained_; }
    std::vector<glm::vec3> read(size_t i) const {
        const std::vector<float> rgb = images_.at(i).read().rgb;
        std::vector<glm::vec3> texels(rgb.size() / 3);
        std::memcpy(texels.data(), rgb.data(), rgb.size() * sizeof(float));
        return texels;
    }
    AgaaVkResolvedImages& chained() { return chained_; }

private:
    std::deque<harness::vk::OutputImage> images_;
    AgaaVkResolvedImages chained_ = AGAA_VK_RESOLVED_IMAGES_INIT;
};

struct VulkanHost {
    using ResolvedImages = test::ResolvedImages;
    using Context = StageContext;
    using View = StageView;
    using Options = HostOptions;
    using Frame = AgaaVkFrame;
    using ShadowMap = ShadowLayers;
    using FunctionData = FunctionBuffer;
    using Ids = IdsView;
    static constexpr auto recordFrame = agaaVkRecordFrame;
    static constexpr bool runsAll = true;
    static constexpr size_t settingShare = 0;
    static constexpr bool runsAtOnce = false;

    // Of a context that change(desc) changes.
    template <class Change> static HostOptions changed(const Change& change) { return {.change = change}; }
    // Whether turns of a group that have nothing to do are skipped.
    static constexpr bool endsRepetitions = false;
    static constexpr bool isCalledOnce = true; // for all turns of a draw
    static bool skips(const Context& context) {
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        EXPECT_EQ(agaaVkGetContextCaps(context.get(), &caps), AGAA_OK);
        return caps.flags & AGAA_DEVICE_CONDITIONAL_RENDERING;
    }
    // Returns the number of fractional bits of a vertex's position in the rasteriser.
    static uint32_t subPixelBits() { return sharedDevice().limits().subPixelPrecisionBits; }
    static std::vector<float> rgba(const View& view) { return withAlpha(view.image().rgb); }
    static ShadowMap shadowMap(const Context&, float depth) { return ShadowMap({depth}, 4); }
    static void setShadowMap(Frame& frame, const ShadowMap& map) { frame.shadowViews[0] = map.view(); }
    template <class Work> static void run(View& view, const Work& work) {
        sharedDevice().runCommands([&](VkCommandBuffer commands) {
            Frame frame = view.vkFrame(commands);
            work(frame);
        });
    }
    // Messages fail the tests whose contexts they come from.
    static void forgetMessages() {}
};

inline Shown show(StageContext& context, const ViewSettings& settings, const Shot& shot) {
    return showBy<VulkanHost>(context, settings, shot);
}

// By render passes, and callbacks that record into the host's command buffer.
struct RenderPassContext : StageContext {
    RenderPassContext() : StageContext({.renderPass = true, .inlineRecording = true}) {}
};
struct VulkanRenderPassHost {
    using Context = RenderPassContext;
    using View = StageView;
    static constexpr bool endsRepetitions = false;
    static constexpr bool isCalledOnce = false;
    static bool skips(const Context& context) { return VulkanHost::skips(context); }
    static std::vector<float> rgba(const View& view) { return VulkanHost::rgba(view); }
};

// Whose device runs turns that have nothing to do.
struct UnconditionalContext : StageContext {
    UnconditionalContext() : StageContext({.change = [](auto& desc) { desc.device.enabledFeatures = nullptr; }}) {}
};
struct VulkanUnconditionalHost {
    using Context = UnconditionalContext;
    using View = StageView;
    static constexpr bool endsRepetitions = false;
    static constexpr bool isCalledOnce = true;
    static bool skips(const Context& context) { return VulkanHost::skips(context); }
    static std::vector<float> rgba(const View& view) { return VulkanHost::rgba(view); }
};

} // namespace agaa::test
