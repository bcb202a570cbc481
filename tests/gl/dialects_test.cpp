// What hosts may be written in and how: every choice gives the same image.
#include "support.h"

#include "agaa_gl.h"

#include "scene/gltf.h"

#include <gtest/gtest.h>

namespace harness::test {
namespace {

struct Choice {
    const char* name;
    RendererOptions options;
};

RendererOptions choice(uint32_t glslVersion, bool images = false, bool outputs = false, bool compatibility = false) {
    RendererOptions options;
    options.glslVersion = glslVersion;
    options.storageImages = images;
    options.hostOutputs = outputs;
    options.compatibilityProfile = compatibility;
    return options;
}

// Without uniform blocks, and without storage blocks: no block at all.
RendererOptions blockless(uint32_t glslVersion, uint32_t constants) {
    RendererOptions options = choice(glslVersion, true);
    options.constants = constants;
    return options;
}

const Choice choices[] = {
    {"330", choice(330)},
    {"400", choice(400)},
    {"430", choice(430)},
    {"images", choice(450, true)},
    {"outputs", choice(450, false, true)},
    {"330, uniforms", blockless(330, AGAA_GL_CONSTANTS_UNIFORMS)},
    {"450, uniforms", blockless(450, AGAA_GL_CONSTANTS_UNIFORMS)},
    {"330, texels", blockless(330, AGAA_GL_CONSTANTS_TEXELS)},
    {"450, texels", blockless(450, AGAA_GL_CONSTANTS_TEXELS)},
    {"compatibility", choice(450, false, false, true)},
    {"330, images, outputs, compatibility", choice(330, true, true, true)},
};

class Dialects : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        scene_ = loadScene(GetParam());
        settings_ = settingsFor({GetParam(), GetParam(), {}}, scene_, 96, 54);
    }
    RenderResult render(Renderer& renderer) const {
        renderer.load(scene_);
        const RenderResult result = renderer.render(settings_);
        expectEverySampleOnce(result.statistics.back().counters);
        expectNoMessages(renderer);
        return result;
    }
    RenderResult render(const RendererOptions& options) const { return render(*makeGlRenderer(options)); }

    Scene scene_;
    RenderSettings settings_;
};

TEST_P(Dialects, GiveTheSameImage) {
    for (const uint32_t samples : {2u, 8u}) { // one and four samples a texel on Mesa
        settings_.config.samples = samples;
        const Image expected = render(sharedGlRenderer()).image;
        for (const Choice& choice : choices) {
            const Difference d = differenceOf(expected, render(choice.options).image);
            std::printf("%-8s n=%u %-36s %zu pixels differ, at most by %.3f/255\n", GetParam(), samples, choice.name,
                        d.pixels, 255 * d.largest);
            EXPECT_EQ(d.pixels, 0u) << choice.name;
        }
    }
}

// Places of coverage samples, in rows that are shifted by sevenths of a pixel.
std::vector<float> sevenths(uint32_t samples) {
    std::vector<float> pairs;
    for (uint32_t i = 0; i < samples; ++i) {
        pairs.push_back(float(i * 3 % 7) / 7);
        pairs.push_back(float(i) / float(samples));
    }
    return pairs;
}

// Of vertex shaders that expand triangles, beside geometry shaders of GLSL 450; with masks, by the host's own pattern,
// too. Every second dialect is rendered, others in the other scene.
TEST_P(Dialects, PulledVerticesGiveTheSameImage) {
    settings_.config.technique = "dcaa";
    settings_.config.samples = 64;
    settings_.config.coverage.fragmentsPerPixel = 64;
    const std::vector<float> pattern = sevenths(64);
    for (const AgaaTier tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS}) {
        settings_.config.generationTier = uint32_t(tier);
        const bool hasOwnPattern = tier == AGAA_TIER_FRAGMENT_LISTS && GetParam() == std::string("foliage");
        settings_.config.coverage.samplePositions = hasOwnPattern ? pattern.data() : nullptr;
        settings_.vertexPulling = false;
        const Image expected = render(sharedGlRenderer()).image;
        settings_.vertexPulling = true;
        for (const Choice& choice : choices) {
            if (tier == AGAA_TIER_MATERIAL_LISTS && choice.options.glslVersion != 330)
                continue; // the oldest
            if (tier == AGAA_TIER_FRAGMENT_LISTS &&
                !rendersSetting(size_t(&choice - choices) + (GetParam() == std::string("foliage"))))
                continue;
            SCOPED_TRACE(std::string(agaaTierName(tier)) + ", " + choice.name);
            expectSameBySamples(render(choice.options).image, expected, sharedGlRenderer());
        }
    }
}

// Depth keeps other bits: what lies close together may show other samples, and shadows move by a rounding.
TEST_P(Dialects, EitherClipConventionAgrees) {
    RendererOptions options;
    options.clipZFromMinusOne = true;
    const std::unique_ptr<Renderer> renderer = makeGlRenderer(options);
    for (const bool reversed : {false, true}) {
        settings_.reversedZ = reversed;
        const double mean = meanDifference(render(sharedGlRenderer()).image, render(*renderer).image);
        std::printf("%-8s z/w in [-1;1], %s depth: mean difference %.3f/255\n", GetParam(),
                    reversed ? "reversed" : "standard", 255 * mean);
        EXPECT_LE(mean, 0.1 / 255);
    }
}

// masked, opaque
INSTANTIATE_TEST_SUITE_P(All, Dialects, testing::Values("foliage", "bamboo"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
} // namespace harness::test
