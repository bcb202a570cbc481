// Reference images against coverage that is known: everything else is judged by them.
#include "support.h"

#include "render/reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace harness::test {
namespace {

constexpr uint32_t width = 96, height = 64;
constexpr float background = 0.2f;

// A card of radiance 1 that fills the view of a camera at distance 1. Alpha goes from 0 at the left to 1 at the right
// over the card's height too, so that its contours lean.
Scene card(AlphaMode mode, float alpha) {
    Scene scene;
    scene.name = "card";
    Material material;
    material.baseColor = glm::vec4(0, 0, 0, alpha);
    material.emissive = glm::vec3(1);
    material.alphaMode = mode;
    material.doubleSided = true;
    scene.materials.push_back(material);
    for (int corner = 0; corner < 4; ++corner) {
        Vertex v;
        v.position = glm::vec3(corner & 1 ? 3 : -3, corner & 2 ? 3 : -3, 0);
        v.normal = glm::vec3(0, 0, 1);
        const uint8_t own = mode == AlphaMode::Blend ? 255
                            : corner & 1             ? (corner & 2 ? 255 : 204)
                                                     : (corner & 2 ? 51 : 0);
        v.color = glm::u8vec4(255, 255, 255, own);
        scene.vertices.push_back(v);
    }
    scene.indices = {0, 1, 2, 1, 3, 2};
    scene.meshes.push_back({0, 6, 0, 4, 0});
    scene.instances.push_back({0});
    updateBounds(scene);
    return scene;
}

RenderSettings settingsOf(const Scene& scene) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.camera.eye = {0, 0, 1};
    settings.camera.target = {0, 0, 0};
    settings.lights.clear();
    settings.ambient = glm::vec3(0);
    settings.background = glm::vec4(background, background, background, 1);
    settings.facts = sceneFacts(scene, settings.lights);
    return settings;
}

// Mean over a pixel of whether alpha, linear over the card, reaches one half.
double cutoutCoverage(uint32_t px, uint32_t py) {
    constexpr int side = 64;
    int covered = 0;
    const double half = std::tan(glm::radians(30.0));
    for (int i = 0; i < side * side; ++i) {
        const double u = (px + (i % side + 0.5) / side) / width * 2 - 1,
                     v = 1 - (py + (i / side + 0.5) / side) / height * 2;
        const double x = u * half * width / height, y = v * half;
        covered += 0.8 * (x + 3) / 6 + 0.2 * (y + 3) / 6 >= 0.5;
    }
    return double(covered) / (side * side);
}

struct Outcome {
    double error = 0; // mean squared, against the exact image
    Reference reference;
};

Outcome judge(const Scene& scene, const std::function<double(uint32_t, uint32_t)>& coverage) {
    sharedRenderer().load(scene);
    Outcome out;
    out.reference = renderReference(sharedRenderer(), settingsOf(scene), 128);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double exact = background + coverage(x, y) * (1.0 - double(background));
            out.error += std::pow(double(out.reference.image.rgb[3 * (y * width + x)]) - exact, 2) / (width * height);
        }
    std::printf("[ measured ] mean squared error %.3g, by the reference itself %.3g\n", out.error,
                out.reference.splitHalfMse);
    EXPECT_TRUE(sharedRenderer().takeMessages().empty());
    return out;
}

// Frames that share a pattern would leave its whole variance, 0.13, and say that the error is 0.
TEST(ReferenceImage, TranslucentCardsConvergeAndTheErrorIsKnown) {
    const Outcome o = judge(card(AlphaMode::Blend, 0.3f), [](uint32_t, uint32_t) { return 0.3; });
    const double expected = 0.3 * 0.7 * std::pow(1 - double(background), 2) / 128; // of 128 independent frames
    EXPECT_LT(o.error, 1.5 * expected);
    EXPECT_LT(o.error, 1.5 * o.reference.splitHalfMse);
    EXPECT_GT(o.error, 0.6 * o.reference.splitHalfMse);
}

// The mean over the card shows a bias that is far below the error of a pixel.
TEST(ReferenceImage, TranslucentCardsAreNotThinned) {
    for (const float alpha : {0.05f, 0.3f}) {
        const Outcome o = judge(card(AlphaMode::Blend, alpha), [&](uint32_t, uint32_t) { return double(alpha); });
        double mean = 0;
        for (float value : o.reference.image.rgb)
            mean += double(value) / double(o.reference.image.rgb.size());
        const double coverage = (mean - double(background)) / (1 - double(background));
        const double deviation = std::sqrt(double(alpha) * (1 - double(alpha)) / (128.0 * width * height));
        EXPECT_NEAR(coverage, double(alpha), 4 * deviation);
    }
}

// A second reference of another ditherFrame shares no random number with the first.
TEST(ReferenceImage, ReferencesOfOtherDitherFramesAreIndependent) {
    const Scene scene = card(AlphaMode::Blend, 0.3f);
    sharedRenderer().load(scene);
    RenderSettings settings = settingsOf(scene);
    const Reference one = renderReference(sharedRenderer(), settings, 16);
    settings.ditherFrame = 1;
    const Reference two = renderReference(sharedRenderer(), settings, 16);
    double difference = 0;
    for (size_t i = 0; i < one.image.rgb.size(); ++i)
        difference += std::pow(double(one.image.rgb[i]) - double(two.image.rgb[i]), 2) / double(one.image.rgb.size());
    EXPECT_NEAR(difference / (one.splitHalfMse + two.splitHalfMse), 1, 0.1);
}

TEST(ReferenceImage, CutoutsAreHardTestsAtEachPosition) {
    const Outcome o = judge(card(AlphaMode::Mask, 1), cutoutCoverage);
    EXPECT_LT(o.error, 1.5 * o.reference.splitHalfMse + 1e-9);
    EXPECT_LT(o.error, 2e-6);
}

double meanRatio(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        sum += double(a.rgb[i]) / double(b.rgb[i]);
    return sum / double(a.rgb.size());
}

// Materials by id are not rounded. Of the specular reflectance 0.04, 10 bits make 0.0401, and less if they are
// truncated.
TEST(ReferenceImage, SpecularReflectanceIsNotRounded) {
    Scene scene = card(AlphaMode::Opaque, 1);
    scene.materials[0].emissive = glm::vec3(0);
    sharedRenderer().load(scene);
    RenderSettings settings = settingsOf(scene);
    settings.lights = {Light{}};
    settings.lights[0].type = LightType::Directional;
    settings.lights[0].direction = {0, 0, -1};
    settings.facts = sceneFacts(scene, settings.lights);
    const Image reference = renderReference(sharedRenderer(), settings, 4).image;
    settings.config.technique = "agaa";
    settings.config.samples = 8;
    settings.config.generationTier = AGAA_TIER_IDS;
    const Image byId = sharedRenderer().render(settings).image;
    EXPECT_NEAR(meanRatio(reference, byId), 1, 3e-4);
    settings.config.technique = "ssaa";
    EXPECT_NEAR(meanRatio(sharedRenderer().render(settings).image, byId), 1,
                0.25 / 1023 / 0.04); // its own code is nearest
}

} // namespace
} // namespace harness::test
