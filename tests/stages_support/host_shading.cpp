#include "host_shading.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace agaa::test {

void forHostShading(uint32_t drawnTier, const std::function<void(const ViewSettings&)>& check) {
    for (const char* layoutName : {"precise", "paper16"})
        for (const auto& [tier, flags] : {std::pair{drawnTier, uint64_t(0)},
                                          {uint32_t(AGAA_TIER_GBUFFER), uint64_t(AGAA_CONFIG_BUFFERED)}})
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
                check(settings);
                if (testing::Test::HasFatalFailure())
                    return;
            }
}

std::vector<Triangle> hostShadingScene() { return randomTriangles({.triangles = 150, .masked = 0.2f}, 61); }

void lightForHost(AgaaFrame& frame) {
    constexpr float ambient[3] = {0.5f, 0.4f, 0.3f}; // as below
    std::copy_n(ambient, 3, frame.ambient);
    std::fill_n(frame.background, 3, 0.0f);
}

std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations) {
    size_t size = 0;
    EXPECT_EQ(agaaGetAggregateGlsl(&desc, &caps, nullptr, &size, nullptr), AGAA_OK);
    std::string aggregates(size, '\0');
    EXPECT_EQ(agaaGetAggregateGlsl(&desc, &caps, nullptr, &size, aggregates.data()), AGAA_OK);
    aggregates.pop_back(); // the final zero
    return declarations + "layout(local_size_x = 8, local_size_y = 8) in;\nconst uvec2 hostSize = uvec2(" +
           std::to_string(desc.width) + "u, " + std::to_string(desc.height) + "u);\n" + aggregates + R"(
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, hostSize)))
        return;
    vec3 color = vec3(0.0);
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
        AgaaAggregate g = agaaAggregate(pixel, a);
        vec3 light = g.emissive + vec3(0.5, 0.4, 0.3) * (g.diffuse + g.specular);
        color += light * float(bitCount(g.samples)) / float(AGAA_SAMPLES);
    }
    show(pixel, color);
}
)";
}

void expectShadedAlike(const std::vector<float>& sdk, size_t channels, std::span<const float> host) {
    ASSERT_EQ(host.size(), sdk.size() / channels * 4);
    double sum = 0;
    for (size_t i = 0; i < sdk.size(); ++i) {
        const float shaded = host[i / channels * 4 + i % channels];
        ASSERT_NEAR(sdk[i], shaded, 2e-3f * std::max(1.0f, sdk[i])) << i; // the output is of half floats
        sum += double(shaded);
    }
    EXPECT_GT(sum, 100);
}

} // namespace agaa::test
