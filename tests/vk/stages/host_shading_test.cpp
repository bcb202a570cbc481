// A host that records the segments up to GENERATION and shades the aggregates by a pass of its own, against the SDK's
// shading; synchronisation validation sees both.
#include "compute_pass.h"
#include "host_shading.h"
#include "ids_view.h"
#include "stage_host.h"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <span>

using namespace harness::vk;

namespace agaa::test {
namespace {

std::string declarations(const ViewSettings& settings) {
    return R"(#version 450
layout(std430, binding = 0) readonly buffer Aggregates { uint words[]; } aggregates;
layout(std430, binding = 1) writeonly buffer Shown { vec4 colors[]; } shown;
#define AGAA_AGGREGATE_WORD(i) aggregates.words[i]
void show(uvec2 pixel, vec3 color) { shown.colors[pixel.y * )" +
           std::to_string(settings.width) + "u + pixel.x] = vec4(color, 1.0); }\n";
}

// Shades what a view left in "aggregates", in the command buffer that recorded it.
class HostPass {
public:
    HostPass(StageContext& context, const ViewSettings& settings, StageView& view, const char* light = ambientLight)
        : settings_(settings), arena_(sharedDevice()), set_(sharedDevice(), 2, VK_SHADER_STAGE_COMPUTE_BIT) {
        const Device& device = sharedDevice();
        AgaaVkSurface surface = AGAA_VK_SURFACE_INIT;
        EXPECT_EQ(agaaVkGetSurface(view.get(), "aggregates", &surface), AGAA_OK);
        shown_ = arena_.hostBuffer(size_t(settings.width) * settings.height * 4 * sizeof(float),
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
        set_.write({(VkBuffer)surface.buffer, shown_.buffer.get()});
        pass_.emplace(device, set_.layout(), hostShadingText(viewDesc(settings), context.caps(), declarations(settings), light),
                      "host shading");
    }

    // writer: the stage that wrote the aggregates.
    void record(VkCommandBuffer commands, VkPipelineStageFlags writer) const {
        barrier(commands, writer, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
        pass_->record(commands, set_.get(), settings_.width, settings_.height);
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
        // The next frame's writes come after these reads.
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
    }

    void clear() const { std::memset(shown_.mapped, 0xFF, size_t(settings_.width) * settings_.height * 4 * sizeof(float)); }
    std::span<const float> rgba() const {
        return {reinterpret_cast<const float*>(shown_.mapped), size_t(settings_.width) * settings_.height * 4};
    }

private:
    static void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to, VkAccessFlags reads) {
        VkMemoryBarrier b{};
        b.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        b.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        b.dstAccessMask = reads;
        vkCmdPipelineBarrier(commands, from, to, 0, 1, &b, 0, nullptr, 0, nullptr);
    }

    const ViewSettings& settings_;
    Arena arena_;
    BufferResource shown_;
    StorageSet set_;
    std::optional<ComputePass> pass_;
};

TEST(HostShading, ReadsWhatTheSdkShades) {
    StageContext context;
    forHostShading(AGAA_TIER_POST_DEPTH_ATOMICS, [&](const ViewSettings& settings) {
        const bool isGBuffer = settings.config.generationTier == AGAA_TIER_GBUFFER;
        StageView whole(context, settings);
        whole.setTriangles(hostShadingScene());
        AgaaFrame frame = whole.frame();
        lightForHost(frame);
        whole.render(frame);
        const std::vector<float> sdk = whole.image().rgb;

        StageView view(context, settings);
        view.setTriangles(hostShadingScene());
        const HostPass pass(context, settings, view);
        for (int i = 0; i < 2; ++i) {
            pass.clear();
            frame = view.frame();
            lightForHost(frame);
            frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
            sharedDevice().runCommands([&](VkCommandBuffer commands) {
                const AgaaVkFrame vk = view.vkFrame(commands);
                ASSERT_EQ(agaaVkRecordFrame(view.get(), &frame, &vk), AGAA_OK);
                pass.record(commands, isGBuffer ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT
                                                : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT);
            });
            expectShadedAlike(sdk, 3, pass.rgba());
        }
    });
}

// change: sets what the view's functions read.
void expectOwnAttributes(StageContext& context, StageView& view, CustomImages& images,
                         const std::function<void(AgaaVkFrame&)>& change) {
    const HostPass pass(context, view.settings(), view, customLight);
    const AgaaFrame frame = view.frame();
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = view.vkFrame(commands);
        change(vk);
        ASSERT_EQ(agaaVkRecordFrame(view.get(), &frame, &vk), AGAA_OK);
        pass.record(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    });
    images.add(view.settings(), pass.rgba());
}

TEST(HostShading, ReadsAttributesOfItsOwn) {
    StageContext context;
    CustomImages images;
    const std::vector<uint32_t> tiers = {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER,
                                         AGAA_TIER_IDS};
    forCustomAttributes(tiers, [&](const ViewSettings& settings) {
        if (settings.config.generationTier == AGAA_TIER_IDS) {
            for (uint32_t flags : {0u, uint32_t(AGAA_FETCH_NOT_ALL_DRAWS)}) {
                ViewSettings some = settings;
                some.shader = flags ? ViewSettings::Shader::ThirdUnfetched : ViewSettings::Shader::Material;
                IdsView ids(context, some,
                            {.triangles = hostShadingScene(), .material = customMaterial, .fetchFlags = flags});
                expectOwnAttributes(context, ids.view(), images, [&](AgaaVkFrame& vk) { ids.bind(vk); });
            }
            return;
        }
        StageView view(context, settings);
        view.setTriangles(hostShadingScene());
        expectOwnAttributes(context, view, images, [](AgaaVkFrame&) {});
    });
}

} // namespace
} // namespace agaa::test
