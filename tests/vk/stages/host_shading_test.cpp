// A host that records the segments up to GENERATION and shades the aggregates by a pass of its own, against the SDK's
// shading; synchronisation validation sees both.
#include "host_shading.h"
#include "stage_host.h"

#include "vk/glsl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

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
    HostPass(StageContext& context, const ViewSettings& settings, StageView& view)
        : settings_(settings), arena_(sharedDevice()), set_(sharedDevice(), 2, VK_SHADER_STAGE_COMPUTE_BIT) {
        const Device& device = sharedDevice();
        AgaaVkSurface surface = AGAA_VK_SURFACE_INIT;
        EXPECT_EQ(agaaVkGetSurface(view.get(), "aggregates", &surface), AGAA_OK);
        shown_ = arena_.hostBuffer(size_t(settings.width) * settings.height * 4 * sizeof(float),
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
        set_.write({(VkBuffer)surface.buffer, shown_.buffer.get()});
        const VkDescriptorSetLayout sets[] = {set_.layout()};
        VkPipelineLayoutCreateInfo layout{};
        layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        layout.setLayoutCount = 1;
        layout.pSetLayouts = sets;
        layout_ = make<PipelineLayout>(device.get(), vkCreatePipelineLayout, layout, "create a pipeline layout");
        const ShaderModule shader =
            makeShader(device, ShaderStage::Compute,
                       hostShadingText(viewDesc(settings), context.caps(), declarations(settings)), "host shading");
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = shader.get();
        info.stage.pName = "main";
        info.layout = layout_.get();
        VkPipeline handle = VK_NULL_HANDLE;
        check(vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &handle), "create a pipeline");
        pipeline_ = Pipeline(device.get(), handle);
    }

    // writer: the stage that wrote the aggregates.
    void record(VkCommandBuffer commands, VkPipelineStageFlags writer) const {
        barrier(commands, writer, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
        const VkDescriptorSet set = set_.get();
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set, 0, nullptr);
        vkCmdDispatch(commands, (settings_.width + 7) / 8, (settings_.height + 7) / 8, 1);
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
        // The next frame's writes come after these reads.
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
    }

    void clear() const { std::memset(shown_.mapped, 0xFF, size_t(settings_.width) * settings_.height * 4 * sizeof(float)); }
    const float* rgba() const { return reinterpret_cast<const float*>(shown_.mapped); }

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
    PipelineLayout layout_;
    Pipeline pipeline_;
};

TEST(HostShading, ReadsWhatTheSdkShades) {
    StageContext context;
    for (const char* layoutName : {"precise", "paper16"})
        for (const auto& [tier, flags] : {std::pair{AGAA_TIER_POST_DEPTH_ATOMICS, uint64_t(0)},
                                          {AGAA_TIER_GBUFFER, uint64_t(AGAA_CONFIG_BUFFERED)}})
            for (const auto& [n, c] : {std::pair{1u, 1u}, {8u, 2u}, {32u, 4u}}) {
                SCOPED_TRACE(std::string(layoutName) + " " + agaaTierName(tier) + " n=" + std::to_string(n));
                AgaaLayout layout;
                agaaGetBuiltinLayout(layoutName, &layout);
                ViewSettings settings;
                settings.config.layout = &layout;
                settings.config.samples = n;
                settings.config.aggregates = c;
                settings.config.generationTier = tier;
                settings.config.flags = flags;
                settings.facts.shadowMapCount = 0;
                const auto triangles = randomTriangles({.triangles = 150, .masked = 0.2f}, 61);
                const auto nextFrame = [](StageView& view) {
                    AgaaFrame frame = view.frame();
                    std::copy_n(hostAmbient, 3, frame.ambient);
                    std::fill_n(frame.background, 3, 0.0f);
                    return frame;
                };
                StageView whole(context, settings);
                whole.setTriangles(triangles);
                whole.render(nextFrame(whole));
                const std::vector<float> sdk = whole.image().rgb;

                StageView view(context, settings);
                view.setTriangles(triangles);
                const HostPass pass(context, settings, view);
                const VkPipelineStageFlags writer = tier == AGAA_TIER_GBUFFER ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT
                                                                              : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
                for (int i = 0; i < 2; ++i) {
                    pass.clear();
                    AgaaFrame frame = nextFrame(view);
                    frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
                    sharedDevice().runCommands([&](VkCommandBuffer commands) {
                        const AgaaVkFrame vk = view.vkFrame(commands);
                        ASSERT_EQ(agaaVkRecordFrame(view.get(), &frame, &vk), AGAA_OK);
                        pass.record(commands, writer);
                    });
                    double sum = 0;
                    for (size_t k = 0; k < sdk.size(); ++k) {
                        const float host = pass.rgba()[k / 3 * 4 + k % 3];
                        ASSERT_NEAR(sdk[k], host, 2e-3f * std::max(1.0f, sdk[k])) << k; // the output is of half floats
                        sum += double(host);
                    }
                    EXPECT_GT(sum, 100);
                }
            }
}

} // namespace
} // namespace agaa::test
