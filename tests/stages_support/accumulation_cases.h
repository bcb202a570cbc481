// Generation: the sums in the AG-buffer against what the visible triangles say, bit for bit. Each graphics API
// instantiates these.
#pragma once

#include "agreement.h"
#include "setting_share.h"
#include "truth.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace agaa::test {

namespace sums {

struct Case {
    uint32_t samples, aggregates;
    const char* layout = "precise";
    AgaaTier tier = AGAA_TIER_AUTO;
    uint64_t flags = 0;
};

inline std::string nameOf(const Case& c) {
    return "n=" + std::to_string(c.samples) + " c=" + std::to_string(c.aggregates) + " " + c.layout + " " +
           agaaTierName(c.tier) + " flags " + std::to_string(c.flags);
}

inline uint32_t code(double value, uint32_t bits) {
    const double top = double((1u << bits) - 1);
    return uint32_t(std::floor(std::min(std::max(value, 0.0), 1.0) * top + 0.5));
}

// Of a value in [-1,1]: 0 has a code of its own.
inline uint32_t signedCode(double value, uint32_t bits) {
    const double middle = double(1u << (bits - 1));
    return uint32_t(std::floor(std::min(std::max(value, -1.0), 1.0) * (middle - 1) + 0.5) + middle);
}

inline bool isSigned(size_t channel) { return channel >= ChannelNormalX && channel <= ChannelNormalZ; }

// The channels of a material as the layout stores them, in [0,1], or in [-1,1] of a normal. Written from the
// description of the layouts, not from the shader.
inline std::array<double, ChannelCount> channels(const Material& m, const Layout& layout) {
    std::array<double, ChannelCount> v{};
    const glm::dvec3 d(m.diffuse), e(m.emissive), n = glm::normalize(glm::dvec3(m.normal));
    glm::dvec3 s(m.specular);
    const double alpha2 = double(m.normal.w);
    if (layout.specularIsYCbCr()) {
        const double y = 0.299 * s.x + 0.587 * s.y + 0.114 * s.z;
        s = {y, (s.z - y) / 1.772 + 0.5, (s.x - y) / 1.402 + 0.5};
    }
    const double length = layout.foldsRoughness() ? std::max(2 * (1 - alpha2) / (2 - alpha2), 1.0 / 256) : 1;
    const double range = double(layout.emissiveRange());
    for (int i = 0; i < 3; ++i) {
        v[size_t(ChannelDiffuseR + i)] = d[i];
        v[size_t(ChannelSpecularR + i)] = s[i];
        v[size_t(ChannelNormalX + i)] = n[i] * length;
        v[size_t(ChannelEmissiveR + i)] = std::min(e[i], range) / range;
    }
    v[ChannelRoughness] = alpha2;
    if (layout[AGAA_SEMANTIC_EMISSIVE].channels == 1) {
        const glm::dvec3 luma(0.2126, 0.7152, 0.0722);
        v[ChannelEmissiveR] = glm::dot(e, luma) / (std::max(glm::dot(d, luma), 1e-3) * range);
    }
    return v;
}

inline ViewSettings settingsOf(const Case& c, AgaaLayout& layout) {
    agaaGetBuiltinLayout(c.layout, &layout);
    ViewSettings settings;
    settings.config.samples = c.samples;
    settings.config.aggregates = c.aggregates;
    settings.config.layout = &layout;
    settings.config.generationTier = c.tier;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.config.measurement.flags = c.flags;
    settings.facts.shadowMapCount = 0;
    return settings;
}

inline uint32_t idOf(const std::vector<glm::uvec4>& metadata, size_t pixel, uint32_t i, uint32_t n, uint32_t c) {
    if (c == 1)
        return 0;
    // Bit planes, side by side while they fit one channel.
    const glm::uvec4 texel = metadata[pixel];
    const uint64_t planes = n < 32 ? texel.x : texel.x | uint64_t(texel.y) << 32;
    return uint32_t(planes >> i & 1) | (c > 2 ? uint32_t(planes >> (n + i) & 1) << 1 : 0);
}

template <class Host>
void expectExactSums(typename Host::Context& context, const Case& c, const std::vector<Triangle>& scene) {
    SCOPED_TRACE(nameOf(c));
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    const ViewSettings settings = settingsOf(c, layout);
    const Truth truth = visibleTriangles<Host>(context, settings, scene);
    typename Host::View view(context, settings);
    view.setTriangles(scene);
    view.render(view.frame());
    const Plan& plan = view.plan();
    const uint32_t n = plan.view.samples, count = plan.view.aggregates;
    const AggregatePacking packing = packAggregate(plan.view.layout, n);
    const std::vector<uint32_t> words = view.readBuffer("aggregates");
    const auto metadata = count > 1 ? view.readSurface("metadata") : std::vector<glm::uvec4>();
    const uint32_t growth = uint32_t(std::bit_width(n) - 1);

    size_t wrongFields = 0, wrongMasks = 0, covered = 0;
    for (uint32_t y = 0; y < plan.view.height; ++y)
        for (uint32_t x = 0; x < plan.view.width; ++x) {
            const size_t pixel = size_t(y) * plan.view.width + x;
            for (uint32_t a = 0; a < count; ++a) {
                uint32_t mask = 0;
                std::array<uint64_t, ChannelCount> sums{};
                for (uint32_t i = 0; i < n; ++i) {
                    const uint32_t triangle = truth.at(x, y, i);
                    if (triangle == noTriangle || idOf(metadata, pixel, i, n, count) != a)
                        continue;
                    mask |= 1u << i;
                    const auto values = channels(scene[triangle].material, plan.view.layout);
                    for (size_t k = 0; k < ChannelCount; ++k)
                        if (packing.fields[k].bits)
                            sums[k] += isSigned(k) ? signedCode(values[k], packing.fields[k].bits)
                                                   : code(values[k], packing.fields[k].bits);
                }
                covered += size_t(std::popcount(mask));
                const uint32_t* own = &words[(pixel * count + a) * packing.words];
                const auto field = [&](const Field& f, uint32_t bits) {
                    const uint64_t word = own[f.word] >> f.shift;
                    return bits >= 32 ? word : word & ((uint64_t(1) << bits) - 1);
                };
                wrongMasks += field(packing.coverage, n) != mask;
                for (size_t k = 0; k < ChannelCount; ++k)
                    if (packing.fields[k].bits)
                        wrongFields += field(packing.fields[k], packing.fields[k].bits + growth) != sums[k];
            }
        }
    EXPECT_GT(covered, size_t(plan.view.width) * plan.view.height * n / 4) << "the scene must cover the view";
    EXPECT_LT(covered, size_t(plan.view.width) * plan.view.height * n) << "and leave holes";
    EXPECT_EQ(wrongMasks, 0u);
    EXPECT_EQ(wrongFields, 0u);
    const AgaaCounters counters = view.statistics().counters;
    EXPECT_EQ(counters.visible, covered);
    EXPECT_EQ(counters.once, covered);
    EXPECT_EQ(counters.uncovered, 0u);
    EXPECT_EQ(counters.overlapping, 0u);
}

} // namespace sums

template <class Host> class AccumulationCases : public testing::Test, protected SettingCounter<Host> {
protected:
    void expectExactSums(const sums::Case& c, const std::vector<Triangle>& scene) {
        sums::expectExactSums<Host>(context, c, scene);
    }
    typename Host::Context context;
};

TYPED_TEST_SUITE_P(AccumulationCases);

// Hard cases 29 (three aggregates), 30 (64 bits of metadata) and 31: no id is lost, and no sum is rounded.
TYPED_TEST_P(AccumulationCases, IsExactForEverySampleAndAggregateCount) {
    const auto scene = randomTriangles({.triangles = 300}, 1);
    for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u})
        for (uint32_t c = 1; c <= 4; ++c)
            if (this->rendersNext() || c == 3 || (n == 32 && c == 4))
                this->expectExactSums({n, c}, scene);
}

TYPED_TEST_P(AccumulationCases, IsExactInLayoutPaper16) {
    const auto scene = randomTriangles({.triangles = 300}, 2);
    for (uint32_t n : {4u, 8u, 16u, 32u})
        if (this->rendersNext())
            for (uint32_t c : {2u, 3u})
                this->expectExactSums({n, c, "paper16"}, scene);
}

TYPED_TEST_P(AccumulationCases, IsExactWithPerSampleShading) {
    const auto scene = randomTriangles({.triangles = 300, .duplicates = 0.1f}, 3);
    for (uint32_t n : {4u, 8u, 32u})
        for (uint32_t c : {1u, 2u, 4u})
            if (this->rendersNext())
                this->expectExactSums({n, c, "precise", AGAA_TIER_PER_SAMPLE}, scene);
}

// Drawn twice at equal depth: the first fragment keeps the sample.
TYPED_TEST_P(AccumulationCases, HardCase25CoplanarDuplicatesCountOnce) {
    const auto scene = randomTriangles({.triangles = 300, .duplicates = 0.3f}, 4);
    for (uint32_t n : {4u, 8u, 32u}) {
        if (!this->rendersNext())
            continue;
        this->expectExactSums({n, 2}, scene);
        // By atomics on the coverage, without a promise which is the first.
        const auto settled = settleTies(scene, this->context.caps(), Ties::All);
        this->expectExactSums({n, 2, "precise", AGAA_TIER_AUTO, AGAA_MEASURE_NO_STENCIL}, settled);
        this->expectExactSums({n, 2, "precise", AGAA_TIER_PER_SAMPLE, AGAA_MEASURE_NO_STENCIL}, settled);
    }
}

TYPED_TEST_P(AccumulationCases, HardCase36FullScaleDuplicatesDoNotCarry) {
    auto scene = randomTriangles({.triangles = 200, .duplicates = 0.5f}, 5);
    for (Triangle& t : scene) {
        t.material.diffuse = glm::vec4(1);
        t.material.emissive = glm::vec4(1e6f);
    }
    for (const char* layout : {"paper16", "precise"})
        for (uint32_t n : {8u, 16u, 32u})
            if (this->rendersNext())
                for (uint64_t flags : {uint64_t(0), uint64_t(AGAA_MEASURE_NO_STENCIL)})
                    this->expectExactSums({n, 1, layout, AGAA_TIER_AUTO, flags},
                                          flags ? settleTies(scene, this->context.caps(), Ties::All) : scene);
}

// Hashed masks: prepass and generation must drop the same samples.
TYPED_TEST_P(AccumulationCases, HardCase53MaskedMaterialsKeepTheirSamples) {
    const auto scene =
        settleTies(randomTriangles({.triangles = 300, .duplicates = 0.1f, .masked = 0.5f}, 6), this->context.caps());
    for (uint32_t n : {4u, 8u, 16u, 32u})
        if (this->rendersNext())
            for (AgaaTier tier : {AGAA_TIER_AUTO, AGAA_TIER_PER_SAMPLE})
                this->expectExactSums({n, 2, "precise", tier}, scene);
}

// The paper's rule sends a whole fragment to one aggregate: coverage of the others is lost to it, which
// the exact split is measured against. Every sample still counts once.
TYPED_TEST_P(AccumulationCases, HardCase27FirstSampleRoutingMovesCoverage) {
    const auto scene = randomTriangles({.triangles = 300}, 7);
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    ViewSettings settings =
        sums::settingsOf({8, 2, "precise", AGAA_TIER_AUTO, AGAA_MEASURE_FIRST_SAMPLE_ROUTING}, layout);
    typename TypeParam::View literal(this->context, settings);
    literal.setTriangles(scene);
    literal.render(literal.frame());
    settings.config.measurement.flags &= ~AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
    typename TypeParam::View exact(this->context, settings);
    exact.setTriangles(scene);
    exact.render(exact.frame());
    EXPECT_EQ(literal.statistics().counters.once, exact.statistics().counters.once);
    EXPECT_EQ(literal.statistics().counters.uncovered, 0u);
    EXPECT_NE(literal.readBuffer("aggregates"), exact.readBuffer("aggregates"));
}

REGISTER_TYPED_TEST_SUITE_P(AccumulationCases, IsExactForEverySampleAndAggregateCount, IsExactInLayoutPaper16,
                            IsExactWithPerSampleShading, HardCase25CoplanarDuplicatesCountOnce,
                            HardCase36FullScaleDuplicatesDoNotCarry, HardCase53MaskedMaterialsKeepTheirSamples,
                            HardCase27FirstSampleRoutingMovesCoverage);

} // namespace agaa::test
