// Attributes of primitives thinner than a pixel. Each graphics API instantiates these.
#pragma once

#include "surfaces.h"
#include "view_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace agaa::test {

namespace hair {

inline constexpr uint32_t width = 64, height = 16;

// Upright hairs an eighth of a pixel wide, each at another place between the pixel's samples, with
// texture coordinates from 1/4 to 3/4 across.
inline std::vector<Triangle> hairs() {
    std::vector<Triangle> list;
    for (uint32_t i = 0; i < width; ++i) {
        const float x = float(i) + float(i) / float(width) * 0.875f;
        for (Triangle t : rectangle(x, 0, x + 0.125f, height, 1, {})) {
            for (glm::vec2& uv : t.uv)
                uv = 0.25f + 0.5f * uv;
            list.push_back(t);
        }
    }
    return list;
}

// Samples in a row of pixels that hairs cover, each wider by `more` on both sides.
template <class View> uint64_t samplesInHairs(const View& view, float more) {
    uint64_t count = 0;
    for (uint32_t i = 0; i < width; ++i)
        for (uint32_t s = 0; s < view.plan().view.samples; ++s) {
            const float across = view.positions()[s].x - float(i) / float(width) * 0.875f;
            count += across >= -more && across <= 0.125f + more;
        }
    return count;
}

struct Found {
    size_t values = 0;
    float lowest = 1, highest = 0;
};

// Texture coordinates of all samples that hairs cover.
template <class Host> Found acrossHairs(typename Host::Context& context, uint32_t n, ViewSettings::Shader shader) {
    ViewSettings settings;
    settings.width = width;
    settings.height = height;
    settings.shader = shader;
    settings.projection = pixelOrthographic(width, height, 10);
    settings.config.technique = "ssaa";
    settings.config.samples = n;
    settings.config.flags = AGAA_CONFIG_READBACK;
    settings.facts.shadowMapCount = 0;
    typename Host::View view(context, settings);
    view.setTriangles(hairs());
    view.render(view.frame());
    const GBufferPacking packing = packGBuffer(view.plan().view.layout);
    const Field& u = packing.fields[ChannelDiffuseR];
    const Field& normal = packing.fields[ChannelNormalX];
    const auto texels = view.readSurface("gbuffer-" + std::to_string(u.word));
    const auto normals = view.readSurface("gbuffer-" + std::to_string(normal.word));
    Found found;
    for (size_t i = 0; i < texels.size(); ++i) {
        if (normals[i][int(normal.shift)] == 0)
            continue;
        const float value = std::bit_cast<float>(texels[i][int(u.shift)]);
        ++found.values;
        found.lowest = std::min(found.lowest, value);
        found.highest = std::max(found.highest, value);
    }
    return found;
}

} // namespace hair

template <class Host> class HairCases : public testing::Test {
protected:
    typename Host::Context context;
};

TYPED_TEST_SUITE_P(HairCases);

// A value at the pixel's centre is up to four hairs' widths away and is clamped at 0 or 1.
TYPED_TEST_P(HairCases, HardCase59AttributesComeFromInside) {
    for (uint32_t n : {4u, 8u, 16u, 32u}) {
        const hair::Found inside = hair::acrossHairs<TypeParam>(this->context, n, ViewSettings::Shader::UvInside);
        EXPECT_GT(inside.values, size_t(hair::height) * n) << "hairs must cover samples";
        EXPECT_GE(inside.lowest, 0.25f - 1.0f / 255) << "n=" << n;
        EXPECT_LE(inside.highest, 0.75f + 1.0f / 255) << "n=" << n;
        const hair::Found centre = hair::acrossHairs<TypeParam>(this->context, n, ViewSettings::Shader::UvAtCentre);
        EXPECT_EQ(centre.lowest, 0.0f) << "the test must be able to fail";
        EXPECT_EQ(centre.highest, 1.0f) << "the test must be able to fail";
    }
}

// Every sample that a hair covers is found in every pass.
TYPED_TEST_P(HairCases, HardCase26CoverageIsThatOfThePrepass) {
    for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u}) {
        ViewSettings settings;
        settings.width = hair::width;
        settings.height = hair::height;
        settings.projection = pixelOrthographic(hair::width, hair::height, 10);
        settings.config.samples = n;
        settings.config.flags = AGAA_CONFIG_COUNTERS;
        settings.facts.shadowMapCount = 0;
        typename TypeParam::View view(this->context, settings);
        view.setTriangles(hair::hairs());
        view.render(view.frame());
        const AgaaCounters counters = view.statistics().counters;
        EXPECT_EQ(counters.once, counters.visible);
        EXPECT_EQ(counters.uncovered + counters.overlapping, 0u);
        const float snap = 1.0f / float(1u << TypeParam::subPixelBits()); // of corners
        EXPECT_GE(counters.visible, hair::height * hair::samplesInHairs(view, -snap)) << "n=" << n;
        EXPECT_LE(counters.visible, hair::height * hair::samplesInHairs(view, snap)) << "n=" << n;
        EXPECT_GT(hair::samplesInHairs(view, -snap), 0u) << "n=" << n;
    }
}

REGISTER_TYPED_TEST_SUITE_P(HairCases, HardCase59AttributesComeFromInside, HardCase26CoverageIsThatOfThePrepass);

} // namespace agaa::test
