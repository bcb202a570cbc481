// Frames with the same input are bitwise equal.
#include "cases.h"
#include "frame_rig.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace agaa::conformance {

namespace {

// Many small rectangles that overlap and share pixels, with all material properties. No two have the same depth, at
// which a device may show either of two masked surfaces.
Scene busyScene(uint32_t width, uint32_t height) {
    Scene scene = smallScene(width, height);
    uint32_t state = 1;
    const auto random = [&state] {
        state = state * 1664525u + 1013904223u;
        return float(state >> 8) / float(1 << 24);
    };
    for (int i = 0; i < 60; ++i) {
        Surface surface;
        for (int k = 0; k < 3; ++k) {
            surface.diffuse[k] = random();
            surface.specular[k] = 0.2f * random();
            surface.emissive[k] = random() > 0.8f ? random() : 0;
        }
        const float angle = 6.28f * random(), slope = 0.7f * random();
        surface.normal[0] = slope * std::cos(angle);
        surface.normal[1] = slope * std::sin(angle);
        surface.normal[2] = std::sqrt(1 - slope * slope);
        surface.roughness = 0.01f + 0.5f * random();
        surface.isMasked = i % 3 == 0;
        const float x = float(width) * random(), y = float(height) * random();
        addRectangle(scene, width, height, x, y, x + 0.3f + 6 * random(), y + 0.3f + 5 * random(), 1 + 12 * random(),
                     surface);
    }
    return scene;
}

struct Lights {
    AgaaLight lights[3];
    AgaaShadow shadow = AGAA_SHADOW_INIT;
    Lights() {
        const AgaaLight initial = AGAA_LIGHT_INIT;
        for (AgaaLight& light : lights)
            light = initial;
        lights[0].shadowMap = 0;
        lights[1].type = AGAA_LIGHT_POINT;
        lights[1].color[0] = 40;
        lights[1].position[0] = 4;
        lights[2].type = AGAA_LIGHT_SPOT;
        lights[2].color[1] = 60;
        lights[2].cosOuter = 0.5f;
        shadow.matrices[0][0] = shadow.matrices[0][5] = 1.0f / 16;
        shadow.matrices[0][10] = -1.0f / 16;
    }
    void use(AgaaFrame& frame) const {
        frame.lights = lights;
        frame.lightCount = 3;
        frame.shadows = &shadow;
        frame.shadowCount = 1;
    }
};

const Lights& lights() {
    static const Lights all;
    return all;
}

Image renderLit(Rig& rig) {
    return rig.render([](AgaaFrame& frame) { lights().use(frame); });
}

std::string named(const std::string& what, const std::string& technique) { return what + " of \"" + technique + "\""; }

void expectSameCounters(Rig& rig, const AgaaCounters& expected, const std::string& what) {
    const AgaaCounters now = rig.counters();
    rig.test.check(!std::memcmp(&now, &expected, sizeof now), what + " has other counters.");
}

// A frame of another scene in between changes nothing.
void expectNoHistory(Rig& rig, const Image& expected, const std::string& technique) {
    const Scene scene = rig.scene;
    rig.scene = smallScene(32, 24);
    rig.render();
    rig.scene.clear();
    rig.render();
    rig.scene = scene;
    expectSame(rig.test, renderLit(rig), expected, 32, named("a frame after frames of other scenes,", technique));
}

void expectSameSegments(Rig& rig, const Image& expected, const std::string& technique) {
    AgaaFrame frame = rig.nextFrame();
    lights().use(frame);
    rig.device().fillOutput(0.5f);
    for (const uint64_t segment : {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING}) {
        frame.segments = segment;
        rig.test.requireOk(rig.record(frame), rig.function());
        rig.expectNoMessages(rig.function());
    }
    expectSame(rig.test, rig.device().readOutput(), expected, 32, named("a frame in three segments,", technique));
}

void testTechnique(Test& test, const char* technique) {
    const std::string obstacle = unsupportedReason(test, technique);
    if (!obstacle.empty())
        test.skip(obstacle);
    const std::vector<std::string> names = techniques(test);
    if (std::find(names.begin(), names.end(), technique) == names.end())
        test.skip("the library has no technique of this name.");
    Image expected;
    AgaaCounters counters{};
    for (int view = 0; view < 2; ++view) {
        Rig rig(test, [&](ViewDescription& description) {
            setTechnique(description, technique, 4);
            description.facts.shadowMapCount = 1;
        });
        rig.device().setShadowDepth(0.4f);
        rig.scene = busyScene(32, 24);
        if (view == 0) {
            expected = renderLit(rig);
            counters = rig.counters();
        }
        for (int i = 0; i < (view == 0 ? 4 : 1); ++i) {
            const std::string what = named("a repeated frame of view " + std::to_string(view + 1), technique);
            expectSame(test, renderLit(rig), expected, 32, what);
            expectSameCounters(rig, counters, what);
        }
        if (view == 0) {
            expectNoHistory(rig, expected, technique);
            expectSameSegments(rig, expected, technique);
        }
        rig.device().setShadowDepth(1.0f);
    }
}

// Surfaces that write only the attributes that frames without effects may have.
Scene plainScene() {
    Scene scene = busyScene(32, 24);
    for (Vertex& vertex : scene) {
        std::fill_n(vertex.specular, 3, 0.0f);
        std::fill_n(vertex.emissive, 3, 0.0f);
        vertex.roughness = 1;
    }
    return scene;
}

// AgaaFrame::facts, before and after agaaPrepareVariants.
void testFacts(Test& test, const char* technique) {
    const std::string obstacle = unsupportedReason(test, technique);
    if (!obstacle.empty())
        test.skip(obstacle);
    Rig rig(test, [&](ViewDescription& description) {
        setTechnique(description, technique, 4);
        description.facts.shadowMapCount = 1;
    });
    rig.scene = plainScene();
    AgaaSceneFacts fewer = rig.description().facts;
    fewer.flags &= AGAA_FACT_ALPHA_MASKED;
    const auto renderFewer = [&] {
        return rig.render([&](AgaaFrame& frame) {
            lights().use(frame);
            frame.facts = &fewer;
        });
    };
    const Image all = renderLit(rig), expected = renderFewer();
    test.requireOk(test.sdk.agaaPrepareVariants(rig.view.get(), 1, &fewer), "agaaPrepareVariants");
    rig.expectNoErrors("agaaPrepareVariants");
    const uint32_t compiled = rig.statistics().compiledPipelines;
    // The variant is a separate program, which may round differently.
    expectAlike(test, renderFewer(), expected, 2e-5f,
                named("a frame of fewer facts with a variant of its own,", technique));
    const uint64_t ran = rig.statistics().variantFlags;
    test.check(ran == fewer.flags, "AgaaFrameStatistics::variantFlags are not those of the variant that was prepared.");
    expectSame(test, renderLit(rig), all, 32, named("a frame of all facts after one of fewer,", technique));
    test.check(rig.statistics().compiledPipelines == compiled, "a frame compiled a pipeline.");
    fewer.shadowMapCount = 2;
    const Image unlit = rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.facts = &fewer;
    expectFrameRefused(rig, frame, {AGAA_ERROR_OUT_OF_RANGE, "a frame of more facts than its view", "AgaaFrame::facts"},
                       unlit);
}

} // namespace

void addRepeatedFrameCases(Suite& suite) {
    const std::vector<const char*> tested = {"single",         "fxaa", "smaa", "taa",  "msaa", "ssaa",    "visibility",
                                             "simple_complex", "sbaa", "agaa", "dcaa", "sgbc", "adaptive"};
    for (const char* technique : tested)
        suite.both("general/repeated_frames_are_equal/" + std::string(technique),
                   [technique](Test& test) { testTechnique(test, technique); });
    for (const char* technique : {"ssaa", "agaa"})
        suite.both("general/frames_may_leave_effects_out/" + std::string(technique),
                   [technique](Test& test) { testFacts(test, technique); });
}

} // namespace agaa::conformance
