// Hard cases 36, 38, 54, 55 and 57 of docs/numerics.md: packed sums, sizes, sample positions, workgroups and
// timestamps.
#include "../math/hard_case_figures.h"
#include "plan_support.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/base/timestamps.h"
#include "core/plan/sample_patterns.h"
#include "core/view/layout.h"

#include <gtest/gtest.h>

#include <random>

using namespace agaa;
using namespace agaa::test;
using test_math::HardCaseFigures;

namespace {

class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    uint32_t below(uint32_t n) { return uint32_t(engine_() % n); }
    uint64_t bits() { return engine_(); }
    double unit() { return double(engine_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

uint32_t largestCode(const Field& field) { return (1u << field.bits) - 1; }

// A field of a sum has the bits of n codes.
uint32_t fieldOf(uint32_t word, const Field& field, uint32_t n) {
    const uint32_t bits = field.bits + uint32_t(std::countr_zero(n));
    return word >> field.shift & (bits == 32 ? ~0u : (1u << bits) - 1);
}

} // namespace

// The table of docs/numerics.md.
TEST(HardCase31_RoundingOfSums, LayoutsKeepTheBitsOfTheGuide) {
    struct Row {
        const char* layout;
        Channel channel;
        double errors[5];
    };
    const uint32_t samples[] = {1, 4, 8, 16, 32};
    for (const auto& [name, channel, errors] :
         {Row{"precise", ChannelDiffuseR, {7.6e-6, 3.1e-5, 6.1e-5, 1.2e-4, 2.4e-4}},
          {"precise", ChannelSpecularB, {7.6e-6, 3.1e-5, 6.1e-5, 1.2e-4, 2.4e-4}},
          {"precise", ChannelNormalX, {1.5e-5, 6.1e-5, 1.2e-4, 2.4e-4, 4.9e-4}},
          {"precise", ChannelRoughness, {7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6}},
          {"precise", ChannelEmissiveB, {7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6}},
          {"paper16", ChannelDiffuseG, {4.9e-4, 4.9e-4, 4.9e-4, 4.9e-4, 4.9e-4}},
          {"paper16", ChannelNormalZ, {1.5e-5, 1.5e-5, 1.5e-5, 1.5e-5, 1.5e-5}},
          {"paper16", ChannelSpecularR, {7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6, 7.6e-6}},
          {"paper16", ChannelSpecularG, {2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3}},
          {"paper16", ChannelEmissiveR, {2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3}},
          {"dcaa28", ChannelDiffuseR, {2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3}},
          {"dcaa28", ChannelRoughness, {2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3, 2.0e-3}}}) {
        const AgaaLayout layout = builtinLayout(name);
        for (size_t i = 0; i < std::size(samples); ++i) {
            const Field field = packAggregate(checkLayout(&layout), samples[i]).fields[channel];
            const double codes = field.isSigned ? (1u << (field.bits - 1)) - 1 : largestCode(field);
            EXPECT_NEAR(0.5 / codes, errors[i], 0.04 * errors[i]) << name << ' ' << channel << " n=" << samples[i];
        }
    }
}

TEST(HardCase36_CarriesBetweenPackedFields, FieldsHoldTheSums) {
    Random random(836);
    HardCaseFigures figures(36, "error of a packed sum of n values, in its largest code", 0.0);
    for (const char* name : layoutNames()) {
        const AgaaLayout layout = builtinLayout(name);
        for (const uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u}) {
            const AggregatePacking packing = packAggregate(checkLayout(&layout), n);
            for (int i = 0; i < 6000; ++i) {
                // Every fragment has the largest codes in some inputs. Duplicates do not count (case 25), so that an
                // aggregate has at most n.
                std::vector<uint32_t> words(packing.words);
                std::vector<uint64_t> sums(packing.fields.size());
                uint32_t pair = 0; // two fields of 16 bits, whose values have 16 bits
                uint64_t low = 0, high = 0;
                for (uint32_t s = 0; s < n; ++s) {
                    for (size_t c = 0; c < packing.fields.size(); ++c) {
                        const Field& field = packing.fields[c];
                        if (field.bits == 0 || field.isUnfiltered)
                            continue;
                        const uint32_t code = i % 8 ? random.below(largestCode(field) + 1) : largestCode(field);
                        words[field.word] += code << field.shift;
                        sums[c] += code;
                    }
                    const uint32_t a = random.below(65536), b = random.below(65536);
                    pair += a | b << 16;
                    low += a;
                    high += b;
                }
                for (size_t c = 0; c < packing.fields.size(); ++c)
                    if (const Field& field = packing.fields[c]; field.bits != 0 && !field.isUnfiltered)
                        figures.ours(std::abs(double(fieldOf(words[field.word], field, n)) - double(sums[c])) /
                                         largestCode(field),
                                     c == 0);
                figures.naive(std::max(std::abs(double(pair & 0xFFFFu) - double(low)),
                                       std::abs(double(pair >> 16) - double(high))) /
                              65535);
            }
        }
    }
}

TEST(HardCase38_SizesBeyondThirtyTwoBits, ProductsAreExactOrErrors) {
    Random random(838);
    HardCaseFigures figures(38, "relative error of the size of a surface", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const uint32_t width = 1 + random.below(32768), height = 1 + random.below(32768);
        const uint32_t samples = 1u << random.below(6), bytes = 1 + random.below(64);
        const long double exact = (long double)(width)*height * samples * bytes;
        const uint64_t size = checkedMultiply(checkedMultiply(uint64_t(width) * height, samples), bytes);
        figures.add(double(std::abs(exact - (long double)(width * height * samples * bytes)) / exact),
                    double(std::abs(exact - (long double)(size)) / exact));
    }
    EXPECT_EQ(checkedMultiply(UINT64_C(7680) * 4320, 8 * 24), UINT64_C(6370099200));
    EXPECT_EQ(checkedMultiply(UINT64_C(16384) * 16384, 32 * 16), UINT64_C(137438953472));
    EXPECT_THROW(checkedMultiply(UINT64_C(1) << 40, UINT64_C(1) << 24), Error);
    EXPECT_THROW(checkedAdd(~UINT64_C(0), 1), Error);
}

TEST(HardCase54_OffsetsOfScaledTargets, SamplesAreThoseOfTheDevice) {
    Random random(854);
    HardCaseFigures figures(54, "distance of a sample from its position on the grid of the rasteriser, in texels",
                            1e-6);
    for (int i = 0; i < 100000; ++i) {
        // Viewport offsets: the rasteriser rounds vertices to 1/256 of a pixel.
        const double parts = 3 + random.below(14), offset = double(random.below(uint32_t(parts))) / parts;
        figures.naive(std::abs(offset * 256 - std::round(offset * 256)) / 256);
        // A target of several texels per pixel has the samples of the device in each texel.
        const uint32_t hwSamples = 1u << random.below(5), side = 1 + random.below(3);
        const std::vector<SamplePosition> texel = standardPositions(hwSamples);
        const SamplePositions positions = samplePositions(texel, side, side);
        const uint32_t sample = random.below(std::min(hwSamples * side * side, 128u)), group = sample / hwSamples;
        const double x = double(positions[sample].x) * side - group % side,
                     y = double(positions[sample].y) * side - group / side;
        figures.ours(std::max(std::abs(x * 16 - std::round(x * 16)), std::abs(y * 16 - std::round(y * 16))) / 16);
        figures.ours(std::max(std::abs(x - double(texel[sample % hwSamples].x)),
                              std::abs(y - double(texel[sample % hwSamples].y))),
                     0);
    }
}

TEST(HardCase55_OddSizes, EveryPixelHasAnInvocation) {
    Random random(855);
    HardCaseFigures figures(55, "pixels without an invocation", 0.0);
    const uint32_t listed[][2] = {{1, 1}, {4097, 3}, {1, 8191}, {129, 1}, {16384, 16384}, {1, ~0u}};
    Plan plan;
    for (uint32_t i = 0; i < 100000; ++i) {
        plan.view.width = i < std::size(listed) ? listed[i][0] : 1 + random.below(16384);
        plan.view.height = i < std::size(listed) ? listed[i][1] : 1 + random.below(16384);
        const uint32_t side = 8u << random.below(3);
        const auto [across, down] = plan.groups({.groupSide = side}, plan.extent());
        const double pixels = double(plan.view.width) * plan.view.height;
        const auto missing = [&](double columns, double rows) {
            return pixels -
                   std::min(columns * side, double(plan.view.width)) * std::min(rows * side, double(plan.view.height));
        };
        // Whole tiles only, as a division rounds.
        figures.add(missing(plan.view.width / side, plan.view.height / side), missing(across, down));
        EXPECT_LT(double(across) * side - plan.view.width, side);
        // Passes over items cover them in rows, with fewer groups than two rows too many.
        const uint64_t items = 1 + random.bits() % (UINT64_C(1) << 37);
        const auto [columns, rows] = plan.groups({.kind = DispatchKind::Items, .items = items}, plan.extent());
        ASSERT_GE(uint64_t(columns) * rows * itemsPerGroup, items);
        ASSERT_LE(columns, groupsPerRow);
    }
    ViewSpec spec;
    for (const auto& [width, height] : {std::pair{0u, 0u}, {0u, 16u}, {16u, 0u}}) {
        spec.width = width;
        spec.height = height;
        try {
            planFor(spec, fourSampleDevice());
            FAIL() << width << 'x' << height << " was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_OUT_OF_RANGE) << error.message;
        }
    }
}

TEST(HardCase57_TimestampsThatWrap, DifferencesUnderTheValidBits) {
    Random random(857);
    HardCaseFigures figures(57, "error of the time of a pass, in milliseconds", 0.0);
    for (int i = 0; i < 100000; ++i) {
        const uint32_t bits = i % 4 ? 32 + random.below(33) : 64;
        const uint64_t mask = bits == 64 ? ~UINT64_C(0) : (UINT64_C(1) << bits) - 1;
        const uint64_t ticks = random.below(1u << 30);
        const uint64_t wide = i % 2 ? mask - random.below(1u << 20) : random.bits(); // about to wrap
        const uint64_t begin = wide & mask, end = (wide + ticks) & mask;
        // The bits above those that are valid are undefined.
        const uint64_t noise = i % 8 ? 0 : random.bits() & ~mask;
        figures.add(std::abs(double(end) - double(begin) - double(ticks)) * 1e-6,
                    std::abs(double(elapsedTicks(begin | noise, end | (random.bits() & ~mask), bits)) - double(ticks)) *
                        1e-6);
    }
    // The end of an earlier frame: negative, not the 584 years that a mask makes of it, and not the time of a pass.
    for (const uint32_t bits : {36u, 48u, 64u}) {
        EXPECT_EQ(elapsedTicks(1000, 999, bits), -1);
        EXPECT_FALSE(isPassTime(double(elapsedTicks(1000, 999, bits)) * 1e-6));
    }
    EXPECT_TRUE(isPassTime(0.0));
    EXPECT_TRUE(isPassTime(16.6));
    EXPECT_FALSE(isPassTime(std::nan("")));
    EXPECT_FALSE(isPassTime(double(~UINT64_C(0)) * 1e-6));
}
