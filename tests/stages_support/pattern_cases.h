// Patterns of coverage samples of the host's own, whose masks come from a table of half-planes. Each graphics API
// instantiates these.
#pragma once

#include "carried_cases.h"
#include "setting_share.h"

namespace agaa::test {

// Points that lie evenly (R2) in a part of the pixel, from its corner at (0, 0) on.
inline std::vector<float> ownPattern(uint32_t samples, glm::vec2 part = glm::vec2(1)) {
    std::vector<float> pairs;
    for (uint32_t i = 0; i < samples; ++i) {
        pairs.push_back(part.x * std::fmod(0.5f + float(i) * 0.754877666f, 1.0f));
        pairs.push_back(part.y * std::fmod(0.5f + float(i) * 0.569840291f, 1.0f));
    }
    return pairs;
}

template <class Host> class PatternCases : public testing::Test {
protected:
    ViewSettings settings(uint32_t samples, uint32_t surfaces, uint32_t tier = AGAA_TIER_FRAGMENT_LISTS,
                          glm::vec2 part = glm::vec2(1)) {
        ViewSettings settings = dcaaSettings(samples, surfaces, tier);
        pattern = ownPattern(samples, part);
        settings.config.coverage.samplePositions = pattern.data();
        return settings;
    }
    ViewSettings inPixels(ViewSettings settings) {
        settings.projection = pixelOrthographic(48, 32, 10);
        return settings;
    }
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    Kept keep(const ViewSettings& settings, const Shot& shot) { return keepFrame<Host>(context, settings, shot); }

    std::vector<float> pattern;
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(PatternCases);

// The table, once more on the CPU.
class CpuTable {
public:
    CpuTable(uint32_t size, const std::vector<float>& positions)
        : size_(size), samples_(uint32_t(positions.size() / 2)) {
        masks_.resize(size_t(size) * size + 1);
        for (uint32_t entry = 0; entry < size * size; ++entry)
            for (uint32_t i = 0; i < samples_; ++i)
                if (math_f::agaa_isInTableEntry(entry, size, {positions[2 * i] - 0.5f, positions[2 * i + 1] - 0.5f}))
                    masks_[entry][int(i >> 5)] |= 1u << (i & 31);
    }
    // Corners in pixels.
    paper::Bits maskOf(const Triangle& t, glm::vec2 centre) const {
        glm::vec3 v[3];
        for (int i = 0; i < 3; ++i)
            v[i] = math_f::agaa_vertexFromCentre({t.position[i].x, t.position[i].y, 1}, centre);
        const glm::uvec4 mask =
            math_f::agaa_joinEdges(v[0], v[1], v[2], edge(v[1], v[2]), edge(v[2], v[0]), edge(v[0], v[1]), samples_);
        paper::Bits bits;
        for (uint32_t i = 0; i < samples_; ++i)
            bits[i] = math_f::agaa_isCovered(mask, i);
        return bits;
    }

private:
    glm::uvec4 edge(const glm::vec3& a, const glm::vec3& b) const {
        const math_f::agaa_CoverageLookup found = math_f::agaa_findCoverage(a, b, size_);
        return math_f::agaa_foundCoverage(found, masks_[found.entry], samples_);
    }
    uint32_t size_, samples_;
    std::vector<glm::uvec4> masks_;
};

// Triangles in pixels that lie apart, so that each fragment stays a surface of its own.
inline std::vector<Triangle> scattered(uint32_t count) {
    std::mt19937 random(11);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    std::vector<Triangle> list;
    for (uint32_t i = 0; i < count; ++i) {
        Triangle t;
        const glm::vec2 centre(uniform(2, 46), uniform(2, 30));
        for (glm::vec3& corner : t.position)
            corner = {centre.x + uniform(-5, 5), centre.y + uniform(-5, 5), -2 - 0.1f * float(i)};
        list.push_back(t);
    }
    return list;
}

TYPED_TEST_P(PatternCases, MasksAreThoseOfTheTable) {
    const std::vector<Triangle> triangles = scattered(30);
    for (size_t setting = 0; const auto& [samples, size] : {std::pair{64u, 0u}, {32u, 37u}, {128u, 256u}}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(samples);
        ViewSettings settings = this->inPixels(this->settings(samples, 8));
        settings.config.coverage.tableSize = size;
        settings.config.surfaceCosine = 1;                         // nothing merges
        settings.config.coverage.flags = AGAA_COVERAGE_DRAW_ORDER; // hidden fragments stay
        const Kept kept = this->keep(settings, {.triangles = triangles});
        ASSERT_EQ(kept.counters.discarded + kept.counters.mergedFirst + kept.counters.mergedSecond, 0u);
        const CpuTable table(size ? size : 128, this->pattern);
        size_t covered = 0, different = 0;
        for (size_t p = 0; p < kept.pixels.size(); ++p) {
            const glm::vec2 centre(float(p % 48) + 0.5f, float(p / 48) + 0.5f);
            std::vector<paper::Bits> expected;
            for (const Triangle& t : triangles)
                if (const paper::Bits mask = table.maskOf(t, centre); mask.any())
                    expected.push_back(mask);
            ASSERT_EQ(kept.pixels[p].size(), expected.size()) << p;
            for (size_t i = 0; i < expected.size(); ++i) {
                covered += expected[i].count();
                different += (expected[i] ^ kept.pixels[p][i].coverage).count();
            }
        }
        EXPECT_GT(covered, 30u * samples);
        EXPECT_LE(double(different), 2e-4 * double(covered)) << "edges that two roundings give to different entries";
        std::printf("%u samples, %u entries a side: %zu of %zu covered samples differ\n", samples, size, different,
                    covered);
    }
}

// Hard case 47. A sheet of triangles of all directions. Only near a vertex may rounded edges miss a sample, or cover it
// twice.
TYPED_TEST_P(PatternCases, SharedEdgesSplitTheSamples) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> shift(-0.9f, 0.9f); // no quadrangle folds
    constexpr int columns = 15, rows = 11;
    glm::vec3 grid[rows + 1][columns + 1];
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
            grid[r][c] = {4.0f * float(c) - 6 + shift(random), 4.0f * float(r) - 6 + shift(random), -5};
    Shot shot;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            for (const bool isSecond : {false, true}) {
                Triangle t;
                t.position[0] = grid[r][c];
                t.position[1] = isSecond ? grid[r + 1][c + 1] : grid[r][c + 1];
                t.position[2] = isSecond ? grid[r + 1][c] : grid[r + 1][c + 1];
                shot.triangles.push_back(t);
            }
    for (const uint32_t samples : {32u, 64u, 128u}) {
        if (!rendersSetting<TypeParam>(samples / 64))
            continue;
        SCOPED_TRACE(samples);
        const Shown shown = this->render(this->inPixels(this->settings(samples, 8)), shot);
        const uint64_t pixels = 48 * 32;
        EXPECT_GE(shown.counters.visible + 2, pixels * samples) << "samples that no triangle covers";
        EXPECT_LE(shown.counters.shadingEvents, pixels + 2) << "fragments that share a sample do not merge";
        EXPECT_GT(shown.counters.mergedFirst, 400u);
    }
}

// All samples lie in a half of their pixels, so that a card over six tenths of a pixel covers all of it.
TYPED_TEST_P(PatternCases, PlacesAreThoseOfTheHost) {
    Material material;
    material.diffuse = glm::vec4(0, 0, 0, 1);
    material.specular = glm::vec4(0);
    material.emissive = glm::vec4(1);
    for (const bool isUpper : {false, true})
        for (const bool isCutout : {false, true}) {
            SCOPED_TRACE(std::to_string(isUpper) + std::to_string(isCutout));
            ViewSettings settings = this->inPixels(
                this->settings(64, 4, AGAA_TIER_FRAGMENT_LISTS, isUpper ? glm::vec2(1, 0.5f) : glm::vec2(0.5f, 1)));
            settings.surface = isUpper ? "s.alpha = 11.1 - gl_FragCoord.y; s.alphaCutoff = 0.5;" // one half at 10.6
                                       : "s.alpha = 11.1 - gl_FragCoord.x; s.alphaCutoff = 0.5;";
            const float end = isCutout ? 30.0f : 10.6f;
            Shot shot{.triangles = isUpper ? rectangle(3, 2.6f, 20, end, 5, material)
                                           : rectangle(2.6f, 3, end, 20, 5, material)};
            for (Triangle& t : shot.triangles)
                t.isMasked = isCutout;
            const auto at = [&](const Shown& shown, uint32_t i) {
                return shown.rgb[3 * (isUpper ? 48 * i + 8 : 48 * 8 + i)];
            };
            const Shown shown = this->render(settings, shot);
            for (uint32_t i = 0; i < 32; ++i)
                EXPECT_NEAR(at(shown, i), i >= 3 && i <= 10 ? 1 : 0, 1e-3) << i;
            settings.config.coverage.samplePositions = nullptr;
            EXPECT_NEAR(at(this->render(settings, shot), 10), 0.6, 0.05);
        }
}

// Where the host evaluates a material that fills its pixel.
TYPED_TEST_P(PatternCases, MiddlesAreThoseOfThePositions) {
    ViewSettings settings = this->inPixels(this->settings(64, 1, AGAA_TIER_MATERIAL_LISTS, glm::vec2(0.5f, 0.25f)));
    settings.surface = "s.emissive = vec3(agaa_coveredMiddle(s) + 0.5, 0.0); s.diffuse = s.specular = vec3(0.0);";
    glm::vec2 middle(0);
    for (size_t i = 0; i < this->pattern.size(); i += 2)
        middle += glm::vec2(this->pattern[i], this->pattern[i + 1]) / 64.0f;
    const Shown shown = this->render(settings, {.triangles = rectangle(4, 4, 40, 28, 5, {})});
    const float* rgb = &shown.rgb[3 * (48 * 10 + 30)]; // one triangle covers the pixel
    EXPECT_NEAR(rgb[0], middle.x, 1e-3);
    EXPECT_NEAR(rgb[1], middle.y, 1e-3);
    EXPECT_NEAR(middle.x, 0.25, 0.01);
}

// Tiers show the same, as with the library's pattern; and a finer table shows more of what 32 samples a pixel show.
TYPED_TEST_P(PatternCases, TiersAgree) {
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    ViewSettings many;
    many.config.technique = "ssaa";
    many.config.samples = 32;
    many.facts.shadowMapCount = 0;
    const Shown truth = this->render(many, shot);
    const ViewSettings fetched = this->settings(64, 8);
    const Shown lists = this->render(fetched, shot);
    ViewSettings other = fetched;
    other.config.generationTier = AGAA_TIER_MATERIAL_LISTS;
    const Shown carried = this->render(other, shot);
    EXPECT_EQ(carried.counters.fragments, lists.counters.fragments);
    EXPECT_EQ(carried.counters.visible, lists.counters.visible);
    const double tiers = compare(carried.rgb, lists.rgb).psnr;
    std::printf("PSNR between the tiers: %.1f dB\n", tiers);
    EXPECT_GT(tiers, 100);
    other = fetched;
    other.config.coverage.flags = AGAA_COVERAGE_EXACT;
    const double exact = compare(this->render(other, shot).rgb, truth.rgb).psnr;
    other.config.coverage.tableSize = 16;
    const double coarse = compare(this->render(other, shot).rgb, truth.rgb).psnr;
    other = fetched;
    other.config.technique = "agaa";
    other.config.aggregates = 4;
    other.config.generationTier = AGAA_TIER_FRAGMENTS;
    const Shown grouped = this->render(other, shot);
    EXPECT_EQ(grouped.counters.fragments, lists.counters.fragments);
    EXPECT_EQ(nonFinite(grouped.rgb), 0u);
    other.config.coverage.samplePositions = nullptr;
    const double library = compare(this->render(other, shot).rgb, truth.rgb).psnr;
    const double own = compare(grouped.rgb, truth.rgb).psnr;
    std::printf(
        "PSNR to 32 samples: exact %.1f dB, by 16 directions %.1f dB; agaa %.1f dB, of the library's pattern %.1f dB\n",
        exact, coarse, own, library);
    EXPECT_GT(exact, coarse + 1.5);
    EXPECT_GT(own, library - 0.5);
}

REGISTER_TYPED_TEST_SUITE_P(PatternCases, MasksAreThoseOfTheTable, SharedEdgesSplitTheSamples, PlacesAreThoseOfTheHost,
                            MiddlesAreThoseOfThePositions, TiersAgree);

} // namespace agaa::test
