// A host's own shading of aggregates on Vulkan; synchronisation validation sees both passes.
#include "compute_pass.h"
#include "host_shading_cases.h"
#include "show.h"

#include <cstring>
#include <optional>

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

class HostPass {
public:
    HostPass(StageContext& context, const ViewSettings& settings, StageView& view, const char* light)
        : settings_(settings), arena_(sharedDevice()), set_(sharedDevice(), 2, VK_SHADER_STAGE_COMPUTE_BIT) {
        const Device& device = sharedDevice();
        AgaaVkSurface surface = AGAA_VK_SURFACE_INIT;
        AgaaSurface common = AGAA_SURFACE_INIT;
        common.pNext = &surface;
        EXPECT_EQ(agaaGetSurface(view.get(), "aggregates", &common), AGAA_OK);
        shown_ = arena_.hostBuffer(size_t(settings.width) * settings.height * 4 * sizeof(float),
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
        set_.write({(VkBuffer)surface.buffer, shown_.buffer.get()});
        pass_.emplace(device, set_.layout(),
                      hostShadingText(viewDesc(settings), context.caps(), declarations(settings), light),
                      "host shading");
    }

    void record(const AgaaVkFrame& frame) const {
        const auto commands = static_cast<VkCommandBuffer>(frame.commandBuffer);
        const uint32_t tier = settings_.config.generationTier;
        const bool isCompute = tier == AGAA_TIER_GBUFFER || tier == AGAA_TIER_IDS;
        barrier(commands, isCompute ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
                VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT);
        pass_->record(commands, set_.get(), settings_.width, settings_.height);
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
        // The next frame's writes come after these reads.
        barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
    }

    void clear() const {
        std::memset(shown_.mapped, 0xFF, size_t(settings_.width) * settings_.height * 4 * sizeof(float));
    }
    std::vector<float> rgba() const {
        const auto* first = reinterpret_cast<const float*>(shown_.mapped);
        return {first, first + size_t(settings_.width) * settings_.height * 4};
    }

private:
    static void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                        VkAccessFlags reads) {
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

struct ShadingHost : VulkanHost {
    static constexpr uint32_t drawnTier = AGAA_TIER_POST_DEPTH_ATOMICS;
    static constexpr uint64_t readback = 0;
    using Pass = HostPass;
};
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HostShadingCases, ShadingHost);

} // namespace
} // namespace agaa::test
