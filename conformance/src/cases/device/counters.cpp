// Counters of flat scenes against numbers computed by hand.
#include "cases.h"
#include "frame_rig.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr uint32_t columns = 8, rows = 6, pixels = columns * rows;

void expectCount(Test& test, const char* counter, uint64_t got, uint64_t least, uint64_t most,
                 const std::string& what) {
    const std::string promised =
        least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
    test.check(got >= least && got <= most,
               what + ": AgaaCounters::" + counter + " is " + std::to_string(got) + " in place of " + promised + ".");
}

void addRectangles(Rig& rig, const std::vector<float>& normal = {0, 0, 1}) {
    rig.scene.clear();
    Surface surface;
    std::copy(normal.begin(), normal.end(), surface.normal);
    addRectangle(rig.scene, 32, 24, 4, 4, 4 + columns, 4 + rows, 8, surface);
}

// The name must live as long as the rig.
Rig::ChangeView withTechnique(const std::string& technique, uint32_t samples) {
    return [&technique, samples](ViewDescription& description) { setTechnique(description, technique, samples); };
}

uint32_t texelsOf(Rig& rig) { // per pixel
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(8, initial);
    uint32_t count = 8;
    rig.test.requireOk(rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, passes.data()), "agaaGetDrawPasses");
    return passes[0].scaleX * passes[0].scaleY;
}

// A rectangle on whole pixels, of one surface. All of its samples are visible once, and one event shades a pixel.
// Techniques that shade samples have an event per sample. "msaa" shades fragments: two where the triangles of the
// rectangle meet.
void expectRectangle(Rig& rig, const std::string& technique) {
    Test& test = rig.test;
    const uint32_t n = rig.description().config.samples;
    addRectangles(rig);
    rig.render();
    const AgaaCounters c = rig.counters();
    const std::string what = "a rectangle of 48 pixels, \"" + technique + "\", n = " + std::to_string(n);
    const bool shadesFragments = technique == "msaa", shadesSamples = technique == "ssaa";
    const bool aggregates = technique == "agaa" || technique == "sbaa" || hasCoverageSamples(technique);
    expectCount(test, "visible", c.visible, pixels * n, pixels * n, what);
    expectCount(test, "once", c.once, pixels * n, pixels * n, what);
    expectCount(test, "uncovered", c.uncovered, 0, 0, what);
    expectCount(test, "overlapping", c.overlapping, 0, 0, what);
    expectCount(test, "ties", c.ties, 0, 0, what);
    expectCount(test, "sanitised", c.sanitised, 0, 0, what);
    const uint64_t events = shadesSamples ? pixels * n : shadesFragments ? pixels * texelsOf(rig) : pixels;
    expectCount(test, "shadingEvents", c.shadingEvents, events, shadesFragments ? 2 * events : events, what);
    expectCount(test, "shadedPixels", c.shadedPixels, pixels, pixels, what);
    const uint64_t most = shadesFragments ? 0 : shadesSamples ? n : 1;
    expectCount(test, "maxEventsPerPixel", c.maxEventsPerPixel, most, most, what);
    uint64_t counted = 0;
    for (const uint64_t number : c.pixelsByEvents)
        counted += number;
    expectCount(test, "pixelsByEvents, in all", counted, shadesFragments ? 0 : pixels, shadesFragments ? 0 : pixels,
                what);
    const uint64_t alone = shadesSamples || shadesFragments ? 0 : pixels; // n is more than 1
    expectCount(test, "pixelsByEvents[0]", c.pixelsByEvents[0], alone, alone, what);
    expectCount(test, "aggregates", c.aggregates, aggregates ? pixels : 0, aggregates ? pixels : 0, what);
    expectCount(test, "shadowTaps", c.shadowTaps, 0, 0, what);
    expectCount(test, "widenedLobes", c.widenedLobes, 0, 0, what);
    expectCount(test, "primitives", c.primitives, 0, 0, what);
    // "dcaa" has a fragment for each triangle that covers a sample of a pixel. Both fragments belong to one surface.
    const bool hasFragments = hasCoverageSamples(technique);
    expectCount(test, "fragments", c.fragments, hasFragments ? pixels : 0, hasFragments ? 2 * pixels : 0, what);
    expectCount(test, "materials", c.materials, c.fragments, c.fragments, what);
    expectCount(test, "mergedFirst", c.mergedFirst, hasFragments ? c.fragments - pixels : 0,
                hasFragments ? c.fragments - pixels : 0, what);
    expectCount(test, "mergedSecond", c.mergedSecond, 0, 0, what);
    expectCount(test, "discarded", c.discarded, 0, 0, what);
    expectCount(test, "lostSamples", c.lostSamples, 0, 0, what);
    expectCount(test, "lostFragments", c.lostFragments, 0, 0, what);
    expectCount(test, "batches", c.batches, hasFragments ? 1 : 0, hasFragments ? 1 : 0, what);
    expectCount(test, "misplaced", c.misplaced, 0, 0, what);
    expectCount(test, "unannounced", c.unannounced, 0, 0, what);
}

// The validation agrees with the counters.
void expectValid(Rig& rig, const std::string& technique) {
    AgaaFrameValidation v = AGAA_FRAME_VALIDATION_INIT;
    rig.test.requireOk(rig.test.sdk.agaaValidateFrame(rig.view.get(), rig.recorded, &v), "agaaValidateFrame");
    const AgaaCounters c = rig.counters();
    const std::string what = "a right frame of \"" + technique + "\"";
    rig.test.check(v.isValid == 1 && v.invalidPixels == 0 && v.pixelCount == 0,
                   what + " is not valid: " + v.explanation);
    rig.test.check(v.visible == c.visible && v.once == c.once && v.uncovered == c.uncovered &&
                       v.overlapping == c.overlapping && v.ties == c.ties && v.misplaced == c.misplaced &&
                       v.unannounced == c.unannounced,
                   what + " has other counts in AgaaFrameValidation than in AgaaCounters.");
    rig.test.check(v.frameIndex == rig.recorded, what + " is not the frame that was validated.");
}

// The scene is empty.
void expectEmpty(Rig& rig, const std::string& technique) {
    rig.scene.clear();
    rig.render();
    AgaaCounters c = rig.counters();
    const AgaaCounters none = {};
    rig.test.check(c.batches == hasCoverageSamples(technique),
                   "AgaaCounters::batches of an empty frame is " + std::to_string(c.batches) + ".");
    c.batches = 0; // the SDK draws the empty scene once
    rig.test.check(!std::memcmp(&c, &none, sizeof c), "a counter of an empty frame is not 0 (\"" + technique + "\").");
}

void testTechnique(Test& test, const std::string& technique) {
    const bool hasScale = technique == "agaa" || technique == "msaa";
    for (const uint32_t n : hasScale ? std::vector<uint32_t>{4, 8} : std::vector<uint32_t>{4}) {
        Rig rig(test, withTechnique(technique, n));
        expectRectangle(rig, technique);
        expectEmpty(rig, technique);
        rig.scene = smallScene(32, 24);
        rig.render();
        expectValid(rig, technique);
    }
}

void testNoCounters(Test& test) {
    Rig rig(test, [](ViewDescription& description) { description.config.flags &= ~AGAA_CONFIG_COUNTERS; });
    rig.render();
    const AgaaCounters c = rig.counters(), none = {};
    test.check(!std::memcmp(&c, &none, sizeof c), "a counter is not 0 without AGAA_CONFIG_COUNTERS.");
}

// A column of pixels shows half of a second wall with another depth and normal, so it has two aggregates.
void testTwoSurfaces(Test& test) {
    for (const std::string technique : {"agaa", "sbaa", "dcaa", "sgbc"}) {
        if (!unsupportedReason(test, technique).empty())
            continue;
        Rig rig(test, withTechnique(technique, 4));
        const uint64_t n = rig.description().config.samples;
        rig.scene.clear();
        Surface wall, side;
        side.normal[0] = 0.8f;
        side.normal[2] = 0.6f;
        side.diffuse[0] = 0.9f;
        addRectangle(rig.scene, 32, 24, 0, 0, 32, 24, 12, wall);
        addRectangle(rig.scene, 32, 24, 10.5f, 0, 32, 24, 4, side);
        rig.render();
        const AgaaCounters c = rig.counters();
        const std::string what = "an edge in a column of 24 pixels, \"" + technique + "\"";
        expectCount(test, "visible", c.visible, 768 * n, 768 * n, what);
        expectCount(test, "once", c.once, 768 * n, 768 * n, what);
        expectCount(test, "aggregates", c.aggregates, 768 + 24, 768 + 24, what);
        expectCount(test, "shadingEvents", c.shadingEvents, 768 + 24, 768 + 24, what);
        expectCount(test, "shadedPixels", c.shadedPixels, 768, 768, what);
        expectCount(test, "maxEventsPerPixel", c.maxEventsPerPixel, 2, 2, what);
    }
}

// An event of a flat pixel takes at least one tap, and at most one per sample.
void testShadowTaps(Test& test) {
    for (const char* technique : {"single", "ssaa", "agaa", "dcaa"}) {
        if (!unsupportedReason(test, technique).empty())
            continue;
        Rig rig(test, [&](ViewDescription& description) {
            setTechnique(description, technique, 4);
            description.facts.shadowMapCount = 1;
        });
        addRectangles(rig);
        const AgaaShadow shadow = AGAA_SHADOW_INIT;
        AgaaLight light = AGAA_LIGHT_INIT;
        light.shadowMap = 0;
        rig.render([&](AgaaFrame& frame) {
            frame.lights = &light;
            frame.shadows = &shadow;
            frame.lightCount = frame.shadowCount = 1;
        });
        const uint64_t n = rig.description().config.samples;
        const bool isShared = std::string(technique) == "agaa" || std::string(technique) == "dcaa";
        const uint64_t least = isShared ? pixels : pixels * n;
        expectCount(test, "shadowTaps", rig.counters().shadowTaps, least, pixels * n,
                    "a rectangle of 48 pixels in a shadow map, \"" + std::string(technique) + "\"");
    }
}

} // namespace

void addCounterCases(Suite& suite) {
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"})
        suite.both("general/counters_of_flat_scenes/" + std::string(technique),
                   [technique](Test& test) { testTechnique(test, technique); });
    suite.both("general/counters_are_0_if_not_requested", testNoCounters);
    suite.both("general/counters_of_two_surfaces", testTwoSurfaces);
    suite.both("general/counters_of_shadow_taps", testShadowTaps);
}

} // namespace agaa::conformance
