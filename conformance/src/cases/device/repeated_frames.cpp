// Frames with the same input are equal, bit by bit.
#include "cases.h"
#include "frame_rig.h"

#include <cmath>
#include <cstring>

namespace agaa::conformance {

namespace {

// Many small rectangles, which overlap in depth and share pixels, with all that materials have.
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
        addRectangle(scene, width, height, x, y, x + 0.3f + 6 * random(), y + 0.3f + 5 * random(),
                     1 + float(int(12 * random())), surface);
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

Image renderLit(Rig& rig) {
    static const Lights lights;
    return rig.render([](AgaaFrame& frame) { lights.use(frame); });
}

void allowLights(ViewDescription& description) {
    description.facts.shadowMapCount = 1;
}

void testRepeated(Test& test, const std::string& technique, uint32_t samples) {
    const auto change = [&](ViewDescription& description) {
        setTechnique(description, technique, samples);
        allowLights(description);
    };
    Image expected;
    AgaaCounters counters{};
    for (int view = 0; view < 2; ++view) {
        Rig rig(test, change);
        rig.device().setShadowDepth(0.4f);
        rig.scene = busyScene(32, 24);
        for (int i = 0; i < 4; ++i) {
            const Image image = renderLit(rig);
            const AgaaCounters now = rig.counters();
            if (expected.empty()) {
                expected = image;
                counters = now;
            }
            const std::string what = "frame " + std::to_string(i + 1) + " of view " +
                                     std::to_string(view + 1) + " of \"" + technique +
                                     "\", n = " + std::to_string(samples);
            expectSame(test, image, expected, 32, what);
            test.check(!std::memcmp(&now, &counters, sizeof now), what + " has other counters.");
        }
        rig.device().setShadowDepth(1.0f);
    }
}

// Another scene in between leaves no trace.
void testHistory(Test& test) {
    for (const std::string& technique : techniques(test.sdk)) {
        Rig rig(test, [&](ViewDescription& description) {
            setTechnique(description, technique, 4);
            allowLights(description);
        });
        const Scene small = rig.scene;
        const Image expected = rig.render();
        rig.scene = busyScene(32, 24);
        renderLit(rig);
        rig.scene.clear();
        rig.render();
        rig.scene = small;
        expectSame(test, rig.render(), expected, 32,
                   "a frame of \"" + technique + "\" after frames of other scenes");
    }
}

// Two frames in flight, and the order of segments, change nothing.
void testSegments(Test& test) {
    for (const std::string& technique : techniques(test.sdk)) {
        Rig rig(test,
                [&](ViewDescription& description) { setTechnique(description, technique, 4); });
        const Image expected = rig.render();
        AgaaFrame frame = rig.nextFrame();
        rig.device().fillOutput(0.5f);
        for (const uint64_t segment :
             {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING}) {
            frame.segments = segment;
            test.requireOk(rig.record(frame), rig.function());
            rig.expectNoMessages(rig.function());
        }
        expectSame(test, rig.device().readOutput(), expected, 32,
                   "a frame of \"" + technique + "\" in three segments");
    }
}

} // namespace

void addRepeatedFrameCases(Suite& suite) {
    for (const char* technique :
         {"single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa"})
        suite.both("general/repeated_frames_are_equal/" + std::string(technique),
                   [technique](Test& test) {
                       const bool isOne = needsOneSample(technique);
                       for (const uint32_t samples : {4u, 8u})
                           if (!isOne || samples == 4)
                               testRepeated(test, technique, samples);
                   });
    suite.both("general/repeated_frames_are_equal", [](Test& test) {
        for (const std::string& technique : techniques(test.sdk))
            testRepeated(test, technique, 2);
    });
    suite.both("general/frames_have_no_history", testHistory);
    suite.both("general/segments_give_the_same_image", testSegments);
}

} // namespace agaa::conformance
