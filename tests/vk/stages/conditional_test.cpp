// Batches that a frame does not need: the device skips them with conditional rendering, and runs them without.
#include "show.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string_view>

namespace agaa::test {
namespace {

using QueryPool = harness::vk::Owned<VkQueryPool, vkDestroyQueryPool>;
constexpr uint32_t batchCount = 10;

void dropConditionalRendering(VulkanContextDesc& desc) {
    static std::vector<const char*> extensions;
    extensions.clear();
    for (uint32_t i = 0; i < desc.device.enabledExtensionCount; ++i)
        if (desc.device.enabledExtensions[i] != std::string_view(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME))
            extensions.push_back(desc.device.enabledExtensions[i]);
    desc.device.enabledExtensions = extensions.data();
    desc.device.enabledExtensionCount = uint32_t(extensions.size());
}

// The host's draw callback, with a query around each batch.
struct QueriedDraw {
    AgaaDrawCallback draw;
    void* user;
    VkQueryPool queries;
    static AgaaResult AGAA_CALL call(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<QueriedDraw*>(user);
        const auto commands = static_cast<VkCommandBuffer>(target->commandBuffer);
        vkCmdBeginQuery(commands, self.queries, target->batch, 0);
        const AgaaResult result = self.draw(self.user, target);
        vkCmdEndQuery(commands, self.queries, target->batch);
        return result;
    }
};

struct Batches {
    std::vector<float> rgb;
    std::vector<bool> drawn; // whether fragments of the batch ran; with inline recording, where batches have calls
    AgaaCounters counters;
};

// Five layers over the whole view, more than a pool of the smallest size has room for.
Batches render(const HostOptions& options, float fragmentsPerPixel) {
    ViewSettings settings;
    settings.width = 322;
    settings.height = 242;
    settings.projection = pixelOrthographic(322, 242, 10);
    settings.config.technique = "dcaa";
    settings.config.samples = 64;
    settings.config.aggregates = 4;
    settings.config.generationTier = AGAA_TIER_FRAGMENT_LISTS;
    settings.config.coverage.fragmentsPerPixel = fragmentsPerPixel;
    settings.config.coverage.maxBatches = batchCount;
    settings.config.flags = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS;
    settings.facts.shadowMapCount = 0;
    Shot shot;
    std::mt19937 random(5);
    for (int layer = 0; layer < 5; ++layer)
        for (const Triangle& t :
             rectangle(float(10 * layer), float(7 * layer), 322, 242, float(1 + layer), randomMaterial(random)))
            shot.triangles.push_back(t);
    StageContext context(options);
    IdsView ids(context, settings, shot);
    StageView& view = ids.view();
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_OCCLUSION;
    info.queryCount = batchCount;
    const VkDevice device = sharedDevice().get();
    const QueryPool queries = harness::vk::make<QueryPool>(device, vkCreateQueryPool, info, "create a query pool");
    AgaaFrame frame = view.frame();
    const AgaaLight light = sun();
    setLight(frame, light);
    QueriedDraw queried{frame.draw, frame.drawUser, queries.get()};
    if (options.inlineRecording) {
        frame.draw = QueriedDraw::call;
        frame.drawUser = &queried;
    }
    VulkanHost::run(view, [&](AgaaVkFrame& native) {
        vkCmdResetQueryPool(static_cast<VkCommandBuffer>(native.commandBuffer), queries.get(), 0, batchCount);
        ids.bind(native);
        EXPECT_EQ(agaaVkRecordFrame(view.get(), &frame, &native), AGAA_OK);
    });
    Batches out{view.image().rgb, {}, view.statistics().counters};
    EXPECT_EQ(view.batches.size(), options.inlineRecording ? batchCount : 1);
    if (!options.inlineRecording)
        return out;
    uint64_t samples[batchCount] = {};
    EXPECT_EQ(vkGetQueryPoolResults(device, queries.get(), 0, batchCount, sizeof samples, samples, sizeof samples[0],
                                    VK_QUERY_RESULT_64_BIT),
              VK_SUCCESS);
    for (const uint64_t count : samples)
        out.drawn.push_back(count != 0);
    return out;
}

TEST(ConditionalRendering, SkipsBatchesThatAreNotNeeded) {
    {
        const StageContext context;
        if (!VulkanHost::skips(context))
            GTEST_SKIP() << "the device has no VK_EXT_conditional_rendering";
        const StageContext without({.change = dropConditionalRendering});
        EXPECT_FALSE(VulkanHost::skips(without));
        const StageContext unknown({.change = [](auto& desc) { desc.device.enabledFeatures = nullptr; }});
        EXPECT_FALSE(VulkanHost::skips(unknown)) << "the host does not say that it enabled the feature";
    }
    for (const float fragmentsPerPixel : {1.0f, 8.0f}) {
        SCOPED_TRACE(fragmentsPerPixel);
        const Batches all = render({.inlineRecording = true, .change = dropConditionalRendering}, fragmentsPerPixel);
        EXPECT_EQ(all.drawn, std::vector<bool>(batchCount, true));
        for (const bool renderPass : {false, true})
            for (const bool inlineRecording : {false, true}) {
                const HostOptions options{.renderPass = renderPass, .inlineRecording = inlineRecording};
                const Batches needed = render(options, fragmentsPerPixel);
                const auto drawn =
                    inlineRecording ? uint64_t(std::ranges::count(needed.drawn, true)) : needed.counters.batches;
                if (fragmentsPerPixel > 1) {
                    EXPECT_EQ(drawn, 1u);
                } else { // the first counts five layers, which lists of little more than a fragment a pixel divide
                    EXPECT_GE(drawn, 5u);
                    EXPECT_LT(drawn, batchCount);
                }
                EXPECT_TRUE(std::ranges::is_sorted(needed.drawn, std::greater())) << "the first ones";
                EXPECT_TRUE(needed.rgb == all.rgb);
                EXPECT_EQ(needed.counters.fragments, all.counters.fragments);
                EXPECT_EQ(needed.counters.lostFragments, 0u);
            }
    }
}

} // namespace
} // namespace agaa::test
