// "agaa" over fragments at coverage samples, against all fragments shaded by themselves. Each graphics API instantiates
// these.
#pragma once

#include "dcaa_cases.h"

namespace agaa::test {

inline ViewSettings fragmentsSettings(uint32_t samples, uint32_t aggregates) {
    ViewSettings settings;
    settings.config.technique = "agaa";
    settings.config.samples = samples;
    settings.config.aggregates = aggregates;
    settings.config.generationTier = AGAA_TIER_FRAGMENTS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

inline ViewSettings exactSettings(uint32_t samples) {
    ViewSettings settings = dcaaSettings(samples);
    settings.config.coverage.flags = AGAA_COVERAGE_EXACT;
    return settings;
}

template <class Host> class FragmentsCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(FragmentsCases);

// Emission is linear: whatever is grouped, the image is that of all fragments, by the samples that show them.
TYPED_TEST_P(FragmentsCases, MeansWeighFragmentsByTheirSamples) {
    Shot shot{.triangles = tangle(400), .lights = {}};
    std::mt19937 random(4);
    for (Triangle& t : shot.triangles)
        t.material.emissive = randomMaterial(random).diffuse;
    for (const uint32_t samples : {32u, 64u, 128u}) {
        const Shown exact = this->render(exactSettings(samples), shot);
        EXPECT_GT(sumOf(exact.rgb), 100);
        for (const uint32_t aggregates : {1u, 4u}) {
            SCOPED_TRACE(std::to_string(samples) + " samples, " + std::to_string(aggregates) + " aggregates");
            const Shown shown = this->render(fragmentsSettings(samples, aggregates), shot);
            double largest = 0;
            for (size_t i = 0; i < shown.rgb.size(); ++i)
                largest = std::max(largest, double(std::abs(shown.rgb[i] - exact.rgb[i])));
            EXPECT_LE(largest, 2e-6);
            EXPECT_EQ(shown.counters.visible, exact.counters.visible);
            EXPECT_EQ(shown.counters.fragments, exact.counters.fragments);
            EXPECT_EQ(shown.counters.primitives, exact.counters.shadingEvents);
            EXPECT_EQ(shown.counters.maxEventsPerPixel, aggregates);
            EXPECT_EQ(shown.geometryPasses, 1u);
            EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
        }
    }
}

// Returns triangles with more fragments in a pixel than are clustered, on two layers of different colour and normal.
// The projection must be pixelOrthographic(48, 32, 10).
inline std::vector<Triangle> manyFragments() {
    Material layers[2];
    layers[0].diffuse = {0.9f, 0.1f, 0.1f, 1}, layers[1].diffuse = {0.1f, 0.2f, 0.9f, 1};
    const glm::vec3 normals[2] = {glm::normalize(glm::vec3(0.5f, 0.2f, 1)), glm::normalize(glm::vec3(-0.6f, 0.3f, 1))};
    std::vector<Triangle> triangles;
    for (int i = 0; i < 64; ++i) {
        Material& material = layers[i & 1];
        material.specular = glm::vec4(0);
        material.normal = glm::vec4(normals[i & 1], 1);
        const float x = 20 + float(i) / 64;
        for (const Triangle& t : rectangle(x, 10, x + 1.0f / 64, 11, i & 1 ? 8.0f : 2.0f, material))
            triangles.push_back(t);
    }
    return triangles;
}

// Fragments that are not clustered join their layer: were layers mixed, a mean colour would meet a mean normal.
TYPED_TEST_P(FragmentsCases, ManyFragmentsJoinTheNearestAggregate) {
    const Shot shot{.triangles = manyFragments()};
    for (const uint32_t samples : {64u, 128u}) {
        SCOPED_TRACE(samples);
        ViewSettings exact = exactSettings(samples), grouped = fragmentsSettings(samples, 2);
        exact.projection = grouped.projection = pixelOrthographic(48, 32, 10);
        const Shown every = this->render(exact, shot);
        const Shown shown = this->render(grouped, shot);
        EXPECT_GT(shown.counters.primitives, 40u) << "there are more than 32 to cluster";
        EXPECT_EQ(shown.counters.shadingEvents, 2u);
        EXPECT_GE(compare(shown.rgb, every.rgb).psnr, 110);
        // One aggregate mixes them: the picture can tell.
        grouped.config.aggregates = 1;
        EXPECT_GT(std::abs(sumOf(this->render(grouped, shot).rgb) - sumOf(every.rgb)), 1e-3);
    }
}

// Returns triangles of four layers, whose 65 or more fragments of each pixel of a tile all show. The projection must be
// pixelOrthographic(48, 32, 10).
inline std::vector<Triangle> manyFragmentsInTile() {
    const glm::vec3 normals[] = {{0.5f, 0.2f, 1}, {-0.6f, 0.3f, 1}, {0.1f, -0.7f, 1}, {0, 0.8f, 1}};
    std::vector<Triangle> triangles;
    for (int i = 0; i < 512; ++i) {
        Material material;
        material.normal = glm::vec4(glm::normalize(normals[i & 3]), 1);
        const float x = 8 + float(i) / 64;
        for (const Triangle& t : rectangle(x, 8, x + 1.0f / 64, 16, 2.0f + 2 * float(i & 3), material))
            triangles.push_back(t);
    }
    return triangles;
}

// Software rasterisers of Mesa end all loops of an invocation after 65535 iterations in total.
TYPED_TEST_P(FragmentsCases, LoopsOverManyFragmentsEnd) {
    ViewSettings settings = fragmentsSettings(128, 4);
    settings.projection = pixelOrthographic(48, 32, 10);
    const Shown shown = this->render(settings, {.triangles = manyFragmentsInTile()});
    EXPECT_EQ(shown.counters.lostFragments, 0u);
    EXPECT_GE(shown.counters.primitives, 64u * 65);
    EXPECT_EQ(shown.counters.visible, 64u * 128);
    EXPECT_EQ(shown.counters.shadingEvents, 64u * 4);
    EXPECT_EQ(shown.counters.materials, shown.counters.primitives);
}

// Where settings ask for what no list of fragments gives.
TYPED_TEST_P(FragmentsCases, SaysWhatItDoesNotDo) {
    ViewSettings buffered = fragmentsSettings(64, 2), few = buffered;
    buffered.config.flags |= AGAA_CONFIG_BUFFERED;
    expectRefused(this->context, buffered, AGAA_ERROR_UNSUPPORTED, "aggregates in memory");
    few.config.samples = 8;
    expectRefused(this->context, few, AGAA_ERROR_OUT_OF_RANGE, "8 samples");
}

REGISTER_TYPED_TEST_SUITE_P(FragmentsCases, MeansWeighFragmentsByTheirSamples, ManyFragmentsJoinTheNearestAggregate,
                            LoopsOverManyFragmentsEnd, SaysWhatItDoesNotDo);

} // namespace agaa::test
