#include "host_shading.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace agaa::test {

void forHostShading(uint32_t drawnTier, const std::function<void(const ViewSettings&)>& check) {
    for (const char* layoutName : {"precise", "paper16"})
        for (const auto& [tier, flags] :
             {std::pair{drawnTier, uint64_t(0)}, {uint32_t(AGAA_TIER_GBUFFER), uint64_t(AGAA_CONFIG_BUFFERED)}})
            for (const auto& [n, c] : {std::pair{1u, 1u}, {8u, 2u}, {32u, 4u}}) {
                SCOPED_TRACE(std::string(layoutName) + " " + agaaTierName(tier) + " n=" + std::to_string(n));
                AgaaLayout layout = AGAA_LAYOUT_INIT;
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

std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations,
                            const char* light) {
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
        vec3 light = )" +
           light + R"(;
        if (g.samples != 0u)
            color += light * float(bitCount(g.samples)) / float(AGAA_SAMPLES);
    }
    show(pixel, color);
}
)";
}

void forCustomAttributes(const std::vector<uint32_t>& tiers, const std::function<void(ViewSettings)>& check) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout("precise", &layout);
    layout.attributeCount = 4; // no emission: attachments are four
    const auto add = [&](const char* name, uint32_t channels, uint32_t bits, float range, uint32_t filter) {
        layout.attributes[layout.attributeCount++] = {AGAA_SEMANTIC_CUSTOM,
                                                      channels,
                                                      bits,
                                                      filter == AGAA_FILTER_NONE ? 8u : 0u,
                                                      0,
                                                      AGAA_ENCODING_UNORM,
                                                      range,
                                                      filter,
                                                      name,
                                                      {}};
    };
    add("wind", 2, 16, 4.0f, AGAA_FILTER_MEAN);
    add("tangent", 3, 8, 1.0f, AGAA_FILTER_NORMAL);
    add("part", 1, 8, 1.0f, AGAA_FILTER_NONE);
    for (const auto& [n, c] : {std::pair{1u, 1u}, {8u, 1u}, {32u, 4u}})
        for (const uint32_t tier : tiers) {
            SCOPED_TRACE(std::string(agaaTierName(tier)) + " n=" + std::to_string(n) + " c=" + std::to_string(c));
            ViewSettings settings;
            settings.config.layout = &layout;
            settings.config.samples = n;
            settings.config.aggregates = c;
            settings.config.generationTier = tier;
            settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_BUFFERED;
            settings.facts.shadowMapCount = 0;
            settings.surface = "s.wind = 4.0 * s.diffuse.xy; s.tangent = s.normal; s.part = s.diffuse.z;";
            check(settings);
            if (testing::Test::HasFatalFailure())
                return;
        }
}

void CustomImages::add(const ViewSettings& settings, std::span<const float> rgba) {
    ASSERT_EQ(rgba.size(), size_t(settings.width) * settings.height * 4);
    std::vector<float> parts;
    double excess = 0;
    for (size_t i = 0; i < rgba.size(); i += 4) {
        // Sums of 11 bits; of the tangent 8 bits a sample from a G-buffer.
        ASSERT_LE(rgba[i], 2e-3f) << i / 4;
        ASSERT_GE(rgba[i + 1], -3e-3f) << i / 4; // 8 bits
        excess += double(rgba[i + 1]);
        parts.push_back(rgba[i + 2]);
    }
    EXPECT_GT(*std::max_element(parts.begin(), parts.end()), 0.5f);
    if (settings.config.aggregates > 1)
        return;
    // A sample's part is its own; the largest of several is not their mean.
    EXPECT_EQ(excess / double(parts.size()) > 2e-3, settings.config.samples > 1);
    const auto [first, isNew] = parts_.try_emplace(settings.config.samples, parts);
    for (size_t i = 0; i < parts.size() && !isNew; ++i)
        ASSERT_NEAR(first->second[i], parts[i], 1e-6f) << i;
}

void expectMoments(const ViewSettings& settings, std::span<const float> rgba) {
    ASSERT_EQ(rgba.size(), size_t(settings.width) * settings.height * 4);
    float furthest = 0, variance = 0, least = 1;
    for (size_t i = 0; i < rgba.size(); i += 4) {
        if (settings.config.ndf <= AGAA_NDF_TOKSVIG) {
            ASSERT_EQ(rgba[i], 0.0f) << i / 4;
        }
        ASSERT_LE(rgba[i], 1.0f + 1e-3f) << i / 4; // the shares of a pixel's aggregates sum to at most 1
        furthest = std::max(furthest, rgba[i + 1]);
        variance = std::max(variance, rgba[i + 2]);
        least = std::min(least, rgba[i + 2]);
    }
    if (settings.config.ndf <= AGAA_NDF_TOKSVIG)
        return;
    EXPECT_GT(least, -2e-3f); // the mean has 11 bits
    if (settings.config.samples == 1) {
        EXPECT_LT(furthest, 3e-3f); // the moments are those of the only normal
    } else {
        EXPECT_GT(variance, 0.05f);
    }
}

void expectShadedAlike(const std::vector<float>& sdk, const std::vector<float>& host) {
    ASSERT_EQ(host.size(), sdk.size());
    double sum = 0;
    for (size_t i = 0; i < sdk.size(); ++i) {
        ASSERT_NEAR(sdk[i], host[i], 2e-3f * std::max(1.0f, sdk[i])) << i; // the output is of half floats
        sum += i % 4 < 3 ? double(host[i]) : 0;
    }
    EXPECT_GT(sum, 100);
}

} // namespace agaa::test
