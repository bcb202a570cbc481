// Hard cases 60 and 62 to 64 of docs/numerics.md: decisions that passes make about materials, colours and positions.
#include <bit>
#include <cfloat>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

// Returns the share of a pixel's samples that a masked surface covers. Its alpha is the same in the whole pixel.
double maskedShare(bool isCutout, float alpha, float cutoff, unsigned texels, unsigned samples, unsigned hash) {
    if (isCutout)
        return math_f::agaa_isInCutout(alpha, cutoff, {0, 0}, {0, 0}) ? 1 : 0;
    int covered = 0;
    for (unsigned texel = 0; texel < texels; ++texel)
        covered += glm::bitCount(math_f::agaa_translucentMask(alpha, samples, texel, texels, hash));
    return covered / double(texels * samples);
}

TEST(HardCase60_MasksOfPasses, FactsDecideBeforeMaterials) {
    Random random(60);
    // A share is rounded to a sample of 32.
    HardCaseFigures figures(60, "share of a pixel by which a pass differs from the mask that the facts state", 0.032);
    const auto check = [&](float alpha, float cutoff, bool noTranslucency, bool noCutouts) {
        const auto valueOf = [](float x) { return std::isnormal(x) ? std::clamp(double(x), -65504.0, 65504.0) : 0.0; };
        double share = std::clamp(valueOf(alpha), 0.0, 1.0);
        if (noTranslucency || (valueOf(cutoff) > 0 && !noCutouts))
            share = valueOf(alpha) >= valueOf(cutoff) ? 1 : 0;
        const float a = math_f::agaa_sanitiseAlpha(alpha), c = math_f::agaa_sanitiseAlpha(cutoff);
        const unsigned hash = math_f::agaa_translucencyHash(random.below(8192), random.below(8192), 1, 2);
        // The samples of four texels, and coverage samples in two words.
        for (const auto& [texels, samples] : {std::pair{4u, 8u}, {2u, 32u}}) {
            const bool isCutout = math_f::agaa_isCutoutByFacts(c, noTranslucency, noCutouts);
            figures.add(std::abs(maskedShare(c > 0, a, c, texels, samples, hash) - share),
                        std::abs(maskedShare(isCutout, a, c, texels, samples, hash) - share));
        }
    };
    std::vector<float> extremes = extremeFloats();
    extremes.insert(extremes.end(), {nanF(), -nanF(), infinityF(), -infinityF()});
    for (const float alpha : extremes)
        for (const float cutoff : extremes)
            for (unsigned facts = 0; facts < 4; ++facts)
                check(alpha, cutoff, facts & 1, facts & 2);
    for (int i = 0; i < 100000; ++i) {
        const float cutoff = i % 4 ? random.rangeF(-0.2, 1) : 0;
        check(random.rangeF(0, 1), cutoff, random.below(2), random.below(2));
    }
}

TEST(HardCase62_ColorsOfEqualLuma, ChannelsDiffer) {
    Random random(62);
    HardCaseFigures figures(
        62, "displayed difference of two colours of equal luma that the comparison of classified samples lacks", 1e-6);
    const auto displayed = [](double x) { return std::pow(x / (1 + x), 1 / 2.2); };
    // Gives b the luma of a.
    const auto check = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
        const glm::vec3 one(a), other(b * (glm::dot(a, weights) / glm::dot(b, weights)));
        double truth = 0;
        for (int k = 0; k < 3; ++k)
            truth = std::max(truth, std::abs(displayed(double(one[k])) - displayed(double(other[k]))));
        const float byLuma = math_f::agaa_displayLuma(one) - math_f::agaa_displayLuma(other);
        const float byChannels =
            math_f::agaa_colorDifference(math_f::agaa_displayed(one), math_f::agaa_displayed(other));
        figures.add(std::abs(truth - std::abs(double(byLuma))), std::abs(truth - double(byChannels)));
    };
    for (const double size : {0.0, double(FLT_MIN), 1e-7, 1.0, 1e3, 65504.0})
        for (const glm::dvec3& b : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1)})
            check(glm::dvec3(size, 0, 0), b);
    const auto channel = [&] { return random.below(4) ? random.decades(1e-3, 100) : 0.0; };
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 a(channel(), channel(), channel());
        check(a, {channel(), channel(), random.decades(1e-3, 100)});
    }
}

TEST(HardCase63_EmissionOfAnyExposure, NothingThatLayoutsStoreIsLost) {
    Random random(63);
    // Half a step of 16 bits may be lost.
    HardCaseFigures figures(63, "emission that counts as none, as a share of the layout's range", 7.63e-6);
    // The exposure of a host scales its radiance and the range of its layout alike.
    const auto check = [&](const glm::dvec3& share, double range) {
        unsigned bad = 0;
        const float layoutRange = float(range);
        const glm::vec3 e = math_f::agaa_sanitiseEmission(glm::vec3(share * range), layoutRange, bad);
        const float largest = std::max(e.x, std::max(e.y, e.z));
        const auto lost = [&](bool isEmissive) { return isEmissive ? 0 : double(largest) / double(layoutRange); };
        const bool isEmissive = math_f::agaa_isEmissive(e, layoutRange);
        figures.add(lost(largest > 0.002f), lost(isEmissive));
        ASSERT_EQ(isEmissive, math_f::agaa_isEmissive(e * 0.25f, layoutRange * 0.25f)) << largest << " of " << range;
        if (!isEmissive) {
            ASSERT_EQ(math_f::agaa_quantise(largest / layoutRange, 16), 0u) << largest << " of " << range;
        }
    };
    for (const double range : {1e-6, 1.0, 16.0, 65504.0}) {
        EXPECT_FALSE(math_f::agaa_isEmissive(glm::vec3(0), float(range)));
        for (const double share : {0.0, 1e-30, 7.5e-6, 7.7e-6, 1.0 / 65535, 1.0, 1e6})
            check(glm::dvec3(share, 0, 0), range);
    }
    for (int i = 0; i < 100000; ++i)
        check({random.decades(1e-9, 1), random.decades(1e-9, 1), random.decades(1e-9, 1)}, random.decades(1e-6, 65504));
}

TEST(HardCase64_PositionsThatAreNotFinite, AreMisplaced) {
    Random random(64);
    HardCaseFigures figures(64, "share of positions that are not finite and pass", 0.0);
    Share passed, comparisonPassed;
    const glm::vec2 size(1920, 1080), scale(1.0f, 16.0f / 9);
    const auto notFinite = [&] {
        const unsigned payload = random.below(2) ? random.below(1u << 23) : 0; // 0: an infinity
        return std::bit_cast<float>(0x7F800000u | payload | (random.below(2) << 31));
    };
    for (int i = 0; i < 100000; ++i) {
        const float depthZ = float(-random.decades(0.01, 1e4)), quantum = depthZ * depthZ * 6e-7f;
        const glm::vec2 pixel(random.rangeF(0, 1920), random.rangeF(0, 1080));
        const glm::vec3 right((pixel / size * 2.0f - 1.0f) / scale * -depthZ, depthZ);
        const auto awayOf = [&](const glm::vec3& p) {
            const glm::vec2 ndc = -glm::vec2(p) * scale / p.z;
            return glm::abs((ndc * 0.5f + 0.5f) * size - pixel);
        };
        const auto isElsewhere = [&](const glm::vec3& p) {
            return math_f::agaa_isElsewhere(awayOf(p), p.z, depthZ, 0.0f, quantum);
        };
        const auto comparesElsewhere = [&](const glm::vec3& p) {
            const glm::vec2 away = awayOf(p);
            return away.x > 2 || away.y > 2 || std::abs(depthZ - p.z) - (0.05f * std::abs(p.z) + 4 * quantum) > 0;
        };
        ASSERT_FALSE(isElsewhere(right)) << depthZ;
        ASSERT_TRUE(isElsewhere(right * 1.5f + glm::vec3(0, 0, -8 * quantum))) << depthZ;
        glm::vec3 bad = right;
        const unsigned components = 1 + random.below(7);
        for (int k = 0; k < 3; ++k)
            bad[k] = components >> k & 1u ? notFinite() : bad[k];
        passed.add(!isElsewhere(bad));
        comparisonPassed.add(!comparesElsewhere(bad));
        for (const float x : {FLT_MAX, -FLT_MAX}) { // far outside the image, or not finite there
            bad = right;
            bad[int(random.below(2))] = x;
            ASSERT_TRUE(isElsewhere(bad)) << depthZ;
        }
    }
    figures.naive(comparisonPassed.value());
    figures.ours(passed.value(), passed.inputs());
}

} // namespace
