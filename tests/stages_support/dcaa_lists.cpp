#include "dcaa_lists.h"

#include "shader_math.h"
#include "shaders/tables/layouts.inc"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace agaa::test {

namespace {

constexpr uint32_t countWords = AGAA_LIST_HEADS; // before the first fragments

uint32_t packNormal(const float (&normal)[3]) {
    const glm::vec2 code = math_f::agaa_encodeOct({normal[0], normal[1], normal[2]}, 16) * 65535.0f + 0.5f;
    return uint32_t(code.x) | uint32_t(code.y) << 16;
}

void setNormal(paper::Surface& s, uint32_t word) {
    const glm::vec3 n = math_f::agaa_decodeOct(glm::vec2(float(word & 0xFFFFu), float(word >> 16)) / 65535.0f, 16);
    for (int i = 0; i < 3; ++i)
        s.normal[i] = n[i];
}

// The centroid of the samples that a surface covers.
glm::vec2 middleOf(const paper::Surface& s, uint32_t samples) {
    glm::uvec4 mask(0u);
    for (uint32_t i = 0; i < samples; ++i)
        mask[int(i / 32)] |= uint32_t(s.coverage[i]) << (i % 32);
    return math_f::agaa_coverageMiddle(mask, samples);
}

void setPlane(paper::Surface& s, const math_f::agaa_StoredPlane& stored, uint32_t samples) {
    const glm::vec3 plane = math_f::agaa_storedPlane(stored);
    const glm::vec3 depths = math_f::agaa_storedDepths(stored, middleOf(s, samples));
    s.depth = plane.x;
    s.slopeX = plane.y;
    s.slopeY = plane.z;
    s.middle = depths.x;
    s.below = depths.y;
    s.above = depths.z;
}

// Returns the facet normal in view space, by three points of the plane. Depths are those of a buffer that is cleared
// to 1.
glm::dvec3 facetOf(const ViewSettings& settings, const paper::Surface& s, size_t pixel) {
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(settings.projection));
    const auto point = [&](double x, double y) {
        const double depth = double(s.depth) + double(s.slopeX) * x + double(s.slopeY) * y;
        const glm::dvec2 at(double(pixel % settings.width) + 0.5 + x, double(pixel / settings.width) + 0.5 + y);
        const glm::dvec4 p =
            inverse * glm::dvec4(2.0 * at.x / settings.width - 1, 2.0 * at.y / settings.height - 1, depth, 1);
        return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 origin = point(0, 0);
    return glm::normalize(glm::cross(point(0.5, 0) - origin, point(0, 0.5) - origin));
}

} // namespace

std::vector<uint32_t> withoutRests(const std::vector<uint32_t>& words, size_t pixels, size_t wordsOfPixel) {
    const size_t step = words.size() / pixels;
    std::vector<uint32_t> kept;
    for (size_t p = 0; p < pixels; ++p)
        kept.insert(kept.end(), words.begin() + ptrdiff_t(p * step),
                    words.begin() + ptrdiff_t(p * step + wordsOfPixel));
    return kept;
}

Kept keptOf(const ViewSettings& settings, const KeptBuffers& buffers, const AgaaCounters& counters) {
    Kept kept;
    kept.counters = counters;
    const uint32_t masks = settings.config.samples / 32, pixels = settings.width * settings.height;
    const std::vector<uint32_t>& fragments = buffers.fragments;
    for (uint32_t p = 0; p < pixels; ++p) {
        std::vector<uint32_t>& list = kept.lists.emplace_back();
        for (uint32_t at = fragments.empty() ? 0 : fragments[countWords + p]; at != 0;) {
            const uint32_t record = countWords + AGAA_LIST_PIXEL_WORDS * pixels +
                                    (at - 1) * (AGAA_FRAGMENT_MASK_AT + masks + buffers.payloadWords);
            list.push_back(fragments[record]);
            at = fragments[record + AGAA_FRAGMENT_NEXT_AT];
        }
        std::vector<paper::Surface>& own = kept.pixels.emplace_back();
        std::vector<uint32_t>& payloadWords = kept.words.emplace_back();
        for (uint32_t a = 0; a < settings.config.aggregates; ++a) {
            const uint32_t* words = &buffers.surfaces[(size_t(p) * settings.config.aggregates + a) * buffers.stride];
            paper::Surface s{};
            for (uint32_t i = 0; i < 32 * masks; ++i)
                s.coverage[i] = words[i / 32] >> (i % 32) & 1;
            if (s.coverage.none())
                break;
            setPlane(s, {std::bit_cast<float>(words[masks]), words[masks + 1]}, settings.config.samples);
            setNormal(s, words[masks + 2]);
            own.push_back(s);
            payloadWords.insert(payloadWords.end(), words, words + buffers.stride);
        }
    }
    return kept;
}

void storeSurface(paper::Surface& s, uint32_t samples) {
    setPlane(s,
             math_f::agaa_storePlane({s.depth, s.slopeX, s.slopeY}, {s.middle, s.below, s.above}, middleOf(s, samples)),
             samples);
    setNormal(s, packNormal(s.normal));
}

paper::Rules rulesOf(const ViewSettings& settings, const paper::Surface& fragment, size_t pixel) {
    return {settings.config.aggregates, settings.config.surfaceCosine, std::fabs(fragment.depth) * 9.5367e-7f,
            decltype(paper::Rules::rule)(settings.config.coverage.merge),
            [settings, pixel](const paper::Surface& a, const paper::Surface& b) {
                return float(glm::dot(facetOf(settings, a, pixel), facetOf(settings, b, pixel)));
            }};
}

void expectSame(const std::vector<paper::Surface>& got, const std::vector<paper::Surface>& expected, size_t pixel,
                bool isRounded) {
    ASSERT_EQ(got.size(), expected.size()) << "pixel " << pixel;
    for (size_t i = 0; i < got.size(); ++i) {
        SCOPED_TRACE("pixel " + std::to_string(pixel) + ", surface " + std::to_string(i));
        EXPECT_EQ(got[i].coverage, expected[i].coverage);
        const float slopes[] = {std::fabs(expected[i].slopeX), std::fabs(expected[i].slopeY)};
        const float step = isRounded ? std::max(slopes[0], slopes[1]) / 64 + 3e-8f : 1e-9f;
        // Depths are kept at the middle of samples, and slopes lead to the pixel's centre.
        EXPECT_NEAR(got[i].depth, expected[i].depth,
                    isRounded ? 1e-6f * std::fabs(expected[i].depth) + step : 4e-7f * std::fabs(expected[i].depth));
        EXPECT_NEAR(got[i].slopeX, expected[i].slopeX, 0.008f * slopes[0] + step);
        EXPECT_NEAR(got[i].slopeY, expected[i].slopeY, 0.008f * slopes[1] + step);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(got[i].normal[k], expected[i].normal[k], 1e-4f);
    }
}

} // namespace agaa::test
