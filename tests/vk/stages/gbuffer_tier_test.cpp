// Generation from a multisampled G-buffer: the sums against the samples it was made from.
#include "stage_host.h"

#include "shader_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace agaa::test {
namespace {

ViewSettings gbufferSettings(uint32_t n, uint32_t c, const AgaaLayout* layout = nullptr) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.layout = layout;
    settings.config.generationTier = AGAA_TIER_GBUFFER;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

// Values of a sample by channel, in [0,1], or in [-1,1] of a normal.
std::array<double, ChannelCount> storedValues(const Layout& layout, const GBufferPacking& packing,
                                              const std::vector<std::vector<glm::uvec4>>& attachments, size_t sample) {
    std::array<double, ChannelCount> raw{};
    for (size_t i = 0; i < ChannelCount; ++i) {
        const Field& f = packing.fields[i];
        if (f.bits)
            raw[i] = double(std::bit_cast<float>(attachments[f.word][sample][int(f.shift)]));
    }
    std::array<double, ChannelCount> out = raw;
    const double alpha2 = raw[ChannelRoughness];
    const glm::dvec3 n =
        math_d::agaa_decodeOct({raw[ChannelNormalX], raw[ChannelNormalY]}, packing.fields[ChannelNormalX].bits) *
        (layout.foldsRoughness() ? math_d::agaa_foldedLength(alpha2) : 1.0);
    for (int i = 0; i < 3; ++i)
        out[size_t(ChannelNormalX + i)] = n[i];
    if (layout.specularIsYCbCr()) {
        const glm::dvec3 c =
            math_d::agaa_rgbToYCbCr({raw[ChannelSpecularR], raw[ChannelSpecularG], raw[ChannelSpecularB]});
        for (int i = 0; i < 3; ++i)
            out[size_t(ChannelSpecularR + i)] = c[i];
    }
    return out;
}

// As the aggregates' fields take it.
double codeOf(size_t channel, double value, uint32_t bits) {
    if (channel < ChannelNormalX || channel > ChannelNormalZ)
        return std::floor(std::min(std::max(value, 0.0), 1.0) * double((1u << bits) - 1) + 0.5);
    const double middle = double(1u << (bits - 1));
    return std::floor(std::min(std::max(value, -1.0), 1.0) * (middle - 1) + 0.5) + middle;
}

void expectSums(StageContext& context, uint32_t n, uint32_t c, const char* layoutName) {
    SCOPED_TRACE("n=" + std::to_string(n) + " c=" + std::to_string(c) + " " + layoutName);
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout(layoutName, &layout);
    ViewSettings settings = gbufferSettings(n, c, &layout);
    settings.config.flags |= AGAA_CONFIG_BUFFERED;
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 300, .duplicates = 0.1f, .masked = 0.2f}, 61));
    view.render(view.frame());
    const Plan& plan = view.plan();
    const GBufferPacking source = packGBuffer(plan.view.layout);
    const AggregatePacking packing = packAggregate(plan.view.layout, n);
    std::vector<std::vector<glm::uvec4>> attachments;
    for (size_t i = 0; i < source.attachments.size(); ++i)
        attachments.push_back(view.readSurface("gbuffer-" + std::to_string(i)));
    const auto words = view.readBuffer("aggregates");
    const auto metadata = plan.view.aggregates > 1 ? view.readSurface("metadata")
                                                   : std::vector<glm::uvec4>(plan.view.width * plan.view.height);
    const Field& normal = source.fields[ChannelNormalX];
    const uint32_t growth = uint32_t(std::bit_width(n) - 1);
    size_t wrongMasks = 0, far = 0, inexact = 0, fields = 0, covered = 0;
    for (uint32_t y = 0; y < plan.view.height; ++y)
        for (uint32_t x = 0; x < plan.view.width; ++x) {
            const size_t pixel = size_t(y) * plan.view.width + x;
            const glm::uvec4 texel = metadata[pixel];
            const uint64_t planes = n < 32 ? texel.x : texel.x | uint64_t(texel.y) << 32;
            for (uint32_t a = 0; a < plan.view.aggregates; ++a) {
                uint32_t mask = 0;
                std::array<double, ChannelCount> sums{};
                for (uint32_t i = 0; i < n; ++i) {
                    const uint32_t id = uint32_t(planes >> i & 1) | (c > 2 ? uint32_t(planes >> (n + i) & 1) << 1 : 0);
                    const size_t s = view.sampleIndex(x, y, i);
                    if (id != a || attachments[normal.word][s][int(normal.shift)] == 0)
                        continue;
                    mask |= 1u << i;
                    const auto values = storedValues(plan.view.layout, source, attachments, s);
                    for (size_t k = 0; k < ChannelCount; ++k)
                        if (packing.fields[k].bits)
                            sums[k] += codeOf(k, values[k], packing.fields[k].bits);
                }
                covered += size_t(std::popcount(mask));
                const uint32_t* own = &words[(pixel * plan.view.aggregates + a) * packing.words];
                const auto field = [&](const Field& f, uint32_t bits) {
                    const uint64_t word = own[f.word] >> f.shift;
                    return bits >= 32 ? word : word & ((uint64_t(1) << bits) - 1);
                };
                wrongMasks += field(packing.coverage, n) != mask;
                for (size_t k = 0; k < ChannelCount; ++k) {
                    if (!packing.fields[k].bits)
                        continue;
                    const double gpu = double(field(packing.fields[k], packing.fields[k].bits + growth));
                    ++fields;
                    inexact += gpu != sums[k];
                    far += std::fabs(gpu - sums[k]) > std::popcount(mask);
                }
            }
        }
    EXPECT_EQ(wrongMasks, 0u);
    EXPECT_EQ(far, 0u) << "each sample may round by one code";
    EXPECT_LE(inexact, fields / 50) << "codes of 8 bits meet the rounding steps of the sums";
    const AgaaCounters counters = view.statistics().counters;
    EXPECT_EQ(counters.visible, covered);
    EXPECT_EQ(counters.once, covered);
    EXPECT_EQ(counters.uncovered, 0u);
}

TEST(GBufferTier, SumsItsSamples) {
    StageContext context;
    for (const char* layout : {"precise", "paper16"})
        for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u})
            for (uint32_t c : {1u, 2u, 3u, 4u})
                if (c <= n)
                    expectSums(context, n, c, layout);
}

struct Rendered {
    harness::Image image;
    AgaaCounters counters;
};

Rendered render(StageContext& context, const ViewSettings& settings) {
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 300}, 62));
    AgaaFrame frame = view.frame();
    const AgaaLight light = sun();
    setLight(frame, light);
    view.render(frame);
    return {view.image(), view.statistics().counters};
}

double meanDifference(const harness::Image& a, const harness::Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::fabs(double(a.rgb[i]) / (1 + double(a.rgb[i])) - double(b.rgb[i]) / (1 + double(b.rgb[i])));
    return sum / double(a.rgb.size());
}

// Four samples in four aggregates at most: what is left is the rounding of sums.
TEST(GBufferTier, ServesMaterialsThatWriteDepthAndDiscard) {
    StageContext context;
    ViewSettings settings = gbufferSettings(4, 4);
    settings.config.generationTier = AGAA_TIER_AUTO;
    settings.config.aggregation.aggregateThreshold = 0;
    settings.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
    settings.shader = ViewSettings::Shader::OwnDepth;
    const Rendered aggregated = render(context, settings);
    EXPECT_GT(aggregated.counters.visible, 1000u);
    EXPECT_EQ(aggregated.counters.once, aggregated.counters.visible);
    settings.config.technique = "ssaa";
    const Rendered samples = render(context, settings);
    EXPECT_EQ(aggregated.counters.visible, samples.counters.visible);
    EXPECT_LT(meanDifference(aggregated.image, samples.image), 2e-3);
    settings.shader = ViewSettings::Shader::Material;
    const Rendered plain = render(context, settings);
    EXPECT_GT(meanDifference(plain.image, samples.image), 2e-2) << "the materials must matter";
}

// Sums in memory and means in registers differ by how sums are rounded.
TEST(GBufferTier, BufferedShowsTheSame) {
    StageContext context;
    for (const auto& [n, c] : {std::pair{1u, 1u}, {8u, 1u}, {8u, 2u}, {32u, 4u}}) {
        ViewSettings settings = gbufferSettings(n, c);
        const Rendered fused = render(context, settings);
        settings.config.flags |= AGAA_CONFIG_BUFFERED;
        const Rendered buffered = render(context, settings);
        EXPECT_EQ(fused.counters.visible, buffered.counters.visible);
        EXPECT_EQ(fused.counters.once, fused.counters.visible);
        EXPECT_EQ(fused.counters.shadingEvents, buffered.counters.shadingEvents);
        EXPECT_EQ(fused.counters.aggregates, buffered.counters.aggregates);
        EXPECT_LT(meanDifference(fused.image, buffered.image), 1e-4);
    }
}

// Two tiers of one stage: the same samples, and images that agree.
TEST(GBufferTier, AgreesWithTheTwoPassTiers) {
    StageContext context;
    for (uint32_t n : {4u, 8u, 32u}) {
        ViewSettings settings = gbufferSettings(n, 2);
        const Rendered gbuffer = render(context, settings);
        settings.config.generationTier = AGAA_TIER_AUTO;
        const Rendered atomics = render(context, settings);
        EXPECT_EQ(gbuffer.counters.visible, atomics.counters.visible);
        // Shading normals decide over aggregates here, geometric ones there.
        EXPECT_LT(meanDifference(gbuffer.image, atomics.image), 2e-2);
    }
}

} // namespace
} // namespace agaa::test
