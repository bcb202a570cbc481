// Images of edges, masks, emission and the background against values computed by hand.
#include "cases.h"
#include "frame_rig.h"

#include <cmath>

namespace agaa::conformance {

namespace {

struct Size {
    uint32_t width, height;
};
Size sizeOf(const Rig& rig) { return {rig.description().desc.width, rig.description().desc.height}; }

void addSurface(Rig& rig, float x0, float y0, float x1, float y1, float distance, const Surface& surface) {
    addRectangle(rig.scene, sizeOf(rig).width, sizeOf(rig).height, x0, y0, x1, y1, distance, surface);
}

Surface white(float alpha = 1) {
    Surface surface;
    for (int i = 0; i < 3; ++i)
        surface.diffuse[i] = 1;
    surface.diffuse[3] = alpha;
    return surface;
}

void expectBackground(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    for (const float scale : {0.0f, 0.125f, 1.0f, 1000.0f}) {
        const float background[] = {scale, 0.5f * scale, 2 * scale};
        const Image image =
            rig.render([&](AgaaFrame& frame) { std::copy(background, background + 3, frame.background); });
        expectColor(rig.test, image, sizeOf(rig).width, {0, 0, sizeOf(rig).width, sizeOf(rig).height}, background,
                    0.001f, "the background of " + technique);
        for (size_t i = 3; i < image.size(); i += 4)
            if (!rig.test.check(image[i] == 1.0f, "alpha of " + technique + " is not 1."))
                break;
    }
}

void expectLargest(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    addSurface(rig, 0, 0, 16, 24, 8, white());
    const Image image = rig.render([&](AgaaFrame& frame) {
        for (int i = 0; i < 3; ++i)
            frame.ambient[i] = frame.background[i] = 65504;
    });
    const float largest[] = {65504, 65504, 65504};
    expectColor(rig.test, image, sizeOf(rig).width, {0, 0, sizeOf(rig).width, sizeOf(rig).height}, largest, 0.005f,
                "the largest ambient light and background of " + technique);
    for (const float value : image)
        if (!rig.test.check(value <= 65504, technique + " gives a value above 65504."))
            break;
}

void expectEmission(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    Surface surface;
    const float emitted[] = {1, 2, 8};
    std::copy(emitted, emitted + 3, surface.emissive);
    addSurface(rig, 0, 0, 16, 24, 8, surface);
    for (int i = 0; i < 3; ++i)
        surface.emissive[i] = 4 * emitted[i]; // (4, 8, 32): beyond the range of the layout, 16
    addSurface(rig, 16, 0, 32, 24, 8, surface);
    const Image image = rig.render([](AgaaFrame& frame) { std::fill(frame.ambient, frame.ambient + 3, 0.0f); });
    // "fxaa" mixes both colours at the edge.
    expectColor(rig.test, image, 32, {0, 0, 14, 24}, emitted, 0.02f, "emission of " + technique);
    const float scaled[] = {2, 4, 16};
    expectColor(rig.test, image, 32, {18, 0, 32, 24}, scaled, 0.02f, "emission beyond the range, of " + technique);
}

// Returns the share of the pixels of a column that the rectangle from x0 on covers.
void expectEdge(Rig& rig, float fraction, const std::string& technique) {
    rig.scene.clear();
    addSurface(rig, 10 + fraction, 0, 32, 24, 8, white());
    const Image image = rig.render();
    const float none[] = {0, 0, 0}, full[] = {1, 1, 1};
    const std::string what = "an edge at " + std::to_string(fraction) + " of a pixel, of " + technique;
    expectColor(rig.test, image, 32, {0, 0, 10, 24}, none, 0.001f, what);
    expectColor(rig.test, image, 32, {11, 0, 32, 24}, full, 0.005f, what);
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(2, initial);
    uint32_t count = 2;
    rig.test.requireOk(rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, passes.data()), "agaaGetDrawPasses");
    // Columns of the pattern.
    const uint32_t perTexel = hasCoverageSamples(rig.description().config.technique) ? rig.description().config.samples
                                                                                     : passes[0].state.samples;
    const float step = 1.0f / float(perTexel * passes[0].scaleX);
    for (uint32_t y = 0; y < 24; ++y) {
        const float share = *pixel(image, 32, 10, y);
        rig.test.check(std::fabs(share - (1 - fraction)) <= step + 0.01f,
                       what + ": the pixel shows the share " + std::to_string(share) + ".");
    }
}

void expectEdges(Rig& rig, const std::string& technique) {
    for (const float fraction : {0.3f, 0.5f, 0.8f})
        expectEdge(rig, fraction, technique + ", n = " + std::to_string(rig.description().config.samples));
}

void testManySamples(Test& test) {
    for (const std::string technique : {"ssaa", "agaa"})
        for (const uint32_t samples : {8u, 16u}) {
            Rig rig(test, [&](ViewDescription& description) { setTechnique(description, technique, samples); });
            expectEdges(rig, "\"" + technique + "\"");
        }
}

void testCoverageSamples(Test& test) {
    for (const uint32_t samples : {32u, 64u, 128u}) {
        Rig rig(test, [&](ViewDescription& description) {
            setTechnique(description, "dcaa", 4);
            description.config.samples = samples;
        });
        expectEdges(rig, "\"dcaa\"");
    }
}

// With one sample, the pixel shows all or nothing, by the position of the sample.
void testOneSample(Test& test) {
    Rig rig(test, [](ViewDescription& description) { setTechnique(description, "single", 1); });
    for (const float fraction : {0.25f, 0.75f}) {
        rig.scene.clear();
        addSurface(rig, 10 + fraction, 0, 32, 24, 8, white());
        const float expected = fraction < 0.5f ? 1.0f : 0.0f, color[] = {expected, expected, expected};
        expectColor(test, rig.render(), 32, {10, 0, 11, 24}, color, 0.005f, "an edge in a pixel with one sample");
    }
}

// alphaCutoff is 0.5: a cut-out covers where alpha >= alphaCutoff.
void expectMasks(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    Surface behind;
    behind.diffuse[0] = behind.diffuse[1] = behind.diffuse[2] = 0.25f;
    addSurface(rig, 0, 0, 32, 24, 8, behind);
    const float alphas[] = {0.25f, 0.5f, 0.75f, 1.0f};
    for (int i = 0; i < 4; ++i) {
        Surface surface = white(alphas[i]);
        surface.isMasked = true;
        addSurface(rig, 8.0f * float(i), 4, 8.0f * float(i) + 8, 20, 4, surface);
    }
    const Image image = rig.render();
    for (uint32_t i = 0; i < 4; ++i) {
        const float value = alphas[i] >= 0.5f ? 1.0f : 0.25f, color[] = {value, value, value};
        expectColor(rig.test, image, 32, {8 * i + 2, 6, 8 * i + 6, 18}, color, 0.01f,
                    "a mask of alpha " + std::to_string(alphas[i]) + ", of " + technique);
    }
    const float color[] = {0.25f, 0.25f, 0.25f};
    expectColor(rig.test, image, 32, {0, 0, 32, 2}, color, 0.01f, "what is behind the masks, of " + technique);
}

// Non-finite materials are replaced by the lowest values and affect nothing else.
void expectFinite(Rig& rig, float bad, const std::string& technique) {
    Surface broken = white();
    for (int i = 0; i < 3; ++i)
        broken.diffuse[i] = broken.specular[i] = broken.emissive[i] = broken.normal[i] = bad;
    broken.roughness = bad;
    rig.scene.clear();
    addSurface(rig, 0, 0, 32, 24, 8, white());
    addSurface(rig, 8, 4, 24, 20, 4, broken);
    const AgaaLight light = AGAA_LIGHT_INIT;
    const Image image = rig.render([&](AgaaFrame& frame) {
        frame.lights = &light;
        frame.lightCount = 1;
    });
    const std::string what = "a material of " + std::to_string(bad) + ", of " + technique;
    for (const float value : image)
        if (!rig.test.check(std::isfinite(value), what + " gives an output that is not finite."))
            break;
    const uint64_t sanitised = rig.counters().sanitised;
    rig.test.check(sanitised >= 16 * 16,
                   what + ": AgaaCounters::sanitised is " + std::to_string(sanitised) + " for 256 pixels.");
}

void expectFiniteImages(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY})
        expectFinite(rig, bad, technique);
}

void testImages(Test& test, const char* name) {
    Rig rig(test, [&](ViewDescription& description) { setTechnique(description, name, 4); });
    const std::string technique = "\"" + std::string(name) + "\"";
    expectBackground(rig, technique);
    expectLargest(rig, technique);
    expectEmission(rig, technique);
    expectMasks(rig, technique);
    expectFiniteImages(rig, technique);
    if (!needsOneSample(name))
        expectEdges(rig, technique);
}

} // namespace

void addCoverageImageCases(Suite& suite) {
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"})
        suite.both("general/images_of_surfaces/" + std::string(technique),
                   [technique](Test& test) { testImages(test, technique); });
    suite.both("general/image_of_an_edge/many_samples", testManySamples);
    suite.both("general/image_of_an_edge/coverage_samples", testCoverageSamples);
    suite.both("general/image_of_an_edge/one_sample", testOneSample);
}

} // namespace agaa::conformance
