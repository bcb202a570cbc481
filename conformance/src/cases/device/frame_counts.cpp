// Numbers of lights and shadows, and segments.
#include "cases.h"
#include "frame_members.h"

namespace agaa::conformance {

namespace {

void addCounts(Suite& suite) {
    addFrameMember(suite, {"AgaaFrame.lightCount/range",
                           "AgaaFrame::lightCount, with maxLights = 4,",
                           "AgaaFrame::lightCount",
                           [](FrameParts& parts, double v) {
                               static const AgaaLight light = AGAA_LIGHT_INIT;
                               static const AgaaLight lights[] = {light, light, light, light};
                               parts.frame.lights = lights;
                               parts.frame.lightCount = uint32_t(v);
                           },
                           {0, 1, 4},
                           largeNumbers({5})});
    addFrameMember(suite, {"AgaaFrame.shadowCount/range",
                           "AgaaFrame::shadowCount, with shadowMapCount = 2,",
                           "AgaaFrame::shadowCount",
                           [](FrameParts& parts, double v) {
                               parts.useShadows();
                               parts.frame.shadowCount = uint32_t(v);
                           },
                           {0, 1, 2},
                           largeNumbers({3, AGAA_MAX_SHADOW_MAPS + 1})});
    addFrameMember(suite, {"AgaaFrame.lightSize/range",
                           "AgaaFrame::lightSize",
                           "AgaaFrame::lightSize",
                           [](FrameParts& parts, double v) {
                               parts.useLights();
                               parts.frame.lightCount = 1;
                               parts.frame.lightSize = uint32_t(v);
                           },
                           {sizeof(AgaaLight)},
                           largeNumbers({0, 4, 60, 65})});
    addFrameMember(suite, {"AgaaFrame.lightSize/range/without_lights",
                           "AgaaFrame::lightSize without lights",
                           "",
                           [](FrameParts& parts, double v) { parts.frame.lightSize = uint32_t(v); },
                           largeNumbers({0, 1}),
                           {}});
    addFrameMember(suite, {"AgaaFrame.shadowSize/range",
                           "AgaaFrame::shadowSize",
                           "AgaaFrame::shadowSize",
                           [](FrameParts& parts, double v) {
                               parts.useShadows();
                               parts.frame.shadowCount = 1;
                               parts.frame.shadowSize = uint32_t(v);
                           },
                           {sizeof(AgaaShadow)},
                           largeNumbers({0, 4, 388, 393})});
    addFrameMember(suite, {"AgaaFrame.shadowSize/range/without_shadows",
                           "AgaaFrame::shadowSize without shadows",
                           "",
                           [](FrameParts& parts, double v) { parts.frame.shadowSize = uint32_t(v); },
                           largeNumbers({0, 1}),
                           {}});
    // The value is the number of lights or shadows behind the null pointer.
    addFrameMember(suite, {"AgaaFrame.lights/null",
                           "AgaaFrame::lights = null and lightCount",
                           "AgaaFrame::lights",
                           [](FrameParts& parts, double v) { parts.frame.lightCount = uint32_t(v); },
                           {0},
                           {1, 4},
                           {},
                           AGAA_ERROR_INVALID_ARGUMENT});
    addFrameMember(suite, {"AgaaFrame.shadows/null",
                           "AgaaFrame::shadows = null and shadowCount",
                           "AgaaFrame::shadows",
                           [](FrameParts& parts, double v) { parts.frame.shadowCount = uint32_t(v); },
                           {0},
                           {1, 2},
                           {},
                           AGAA_ERROR_INVALID_ARGUMENT});
}

void testSegments(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    rig.device().fillOutput(0.25f);
    for (const uint64_t segment : {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING}) {
        frame.segments = segment;
        test.requireOk(rig.record(frame), rig.function() + " with AgaaFrame::segments = " + std::to_string(segment));
    }
    expectSame(test, rig.device().readOutput(), expected, rig.description().desc.width, "a frame in three segments");
    frame = rig.nextFrame();
    frame.segments = 0;
    expectFrameRefused(
        rig, frame, {AGAA_ERROR_OUT_OF_RANGE, rig.function() + " with AgaaFrame::segments = 0", "AgaaFrame::segments"},
        expected);
    for (int bit = isSameVersion(test) ? 3 : 48; bit < 64; ++bit) {
        frame = rig.nextFrame();
        frame.segments = AGAA_SEGMENT_ALL | UINT64_C(1) << bit;
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_OUT_OF_RANGE,
                            rig.function() + " with AgaaFrame::segments = " + std::to_string(frame.segments),
                            "AgaaFrame::segments"},
                           expected);
    }
}

void testLocalLights(Test& test) {
    Rig rig(test, [](ViewDescription& description) { description.facts.flags |= AGAA_FACT_NO_LOCAL_LIGHTS; });
    const Image expected = rig.render();
    for (const uint32_t type : {AGAA_LIGHT_POINT, AGAA_LIGHT_SPOT}) {
        AgaaFrame frame = rig.nextFrame();
        AgaaLight light = AGAA_LIGHT_INIT;
        light.type = type;
        frame.lights = &light;
        frame.lightCount = 1;
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_OUT_OF_RANGE,
                            rig.function() + " with a local light, against AGAA_FACT_NO_LOCAL_LIGHTS,", "light 0"},
                           expected);
    }
}

} // namespace

void addFrameCountCases(Suite& suite) {
    addCounts(suite);
    suite.both("AgaaFrame.segments/flags", testSegments);
    suite.both("AGAA_FACT_NO_LOCAL_LIGHTS/AGAA_ERROR_OUT_OF_RANGE", testLocalLights);
}

} // namespace agaa::conformance
