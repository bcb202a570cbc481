// The order of frames and segments, and members that must be equal in the segments of a frame.
#include "cases.h"
#include "frame_rig.h"

namespace agaa::conformance {

namespace {

constexpr uint64_t pre = AGAA_SEGMENT_PREPASS, gen = AGAA_SEGMENT_GENERATION, shade = AGAA_SEGMENT_SHADING;

std::string segmentsText(uint64_t segments) {
    std::string text;
    if (segments & pre)
        text += " PREPASS";
    if (segments & gen)
        text += " GENERATION";
    if (segments & shade)
        text += " SHADING";
    return text;
}

// Records the segments `first` of a frame, or none if 0. Then `second` must fail, and the rest of the frame must
// succeed.
void expectSegmentsRefused(Rig& rig, uint64_t first, uint64_t second, const Image& expected) {
    AgaaFrame frame = rig.nextFrame();
    const std::string what = rig.function() + " with" + segmentsText(second) +
                             (first ? " after" + segmentsText(first) : " at the beginning of a frame");
    rig.device().fillOutput(0.25f);
    if (first) {
        frame.segments = first;
        rig.test.requireOk(rig.record(frame), rig.function() + " with" + segmentsText(first));
    }
    rig.context.log.lines.clear();
    frame.segments = second;
    const AgaaResult result = rig.record(frame);
    expectRefused(rig.test, result, AGAA_ERROR_WRONG_ORDER, rig.context.log, rig.function(), what);
    frame.segments = AGAA_SEGMENT_ALL & ~first;
    if (frame.segments)
        rig.test.requireOk(rig.record(frame), rig.function() + " with the other segments after " + what);
    if (first != AGAA_SEGMENT_ALL)
        expectSame(rig.test, rig.device().readOutput(), expected, rig.description().desc.width,
                   "the frame after " + what);
    rig.expectNoMessages(what);
    expectNextFrame(rig, expected, what);
}

void testSegmentOrder(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    const struct {
        uint64_t first, second;
    } rows[] = {{0, gen},
                {0, shade},
                {0, gen | shade},
                {0, pre | shade},
                {pre, pre},
                {pre, shade},
                {pre, pre | gen},
                {pre, AGAA_SEGMENT_ALL},
                {pre | gen, pre},
                {pre | gen, gen},
                {pre | gen, gen | shade},
                {AGAA_SEGMENT_ALL, pre},
                {AGAA_SEGMENT_ALL, shade},
                {AGAA_SEGMENT_ALL, AGAA_SEGMENT_ALL}};
    for (const auto& row : rows)
        expectSegmentsRefused(rig, row.first, row.second, expected);
}

// The host gives a frame up after its first segments. The next frame must be complete.
void testAbandonedFrame(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    for (const uint64_t first : {pre, pre | gen}) {
        AgaaFrame frame = rig.nextFrame();
        frame.segments = first;
        test.requireOk(rig.record(frame), rig.function() + " with" + segmentsText(first));
        expectNextFrame(rig, expected, "a frame with only" + segmentsText(first));
    }
}

void testIndices(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    rig.render();
    rig.render([](AgaaFrame& frame) { // indices may have gaps
        frame.completedFrame = frame.frameIndex - 1;
        frame.frameIndex += 10;
    });
    for (const uint64_t index : {rig.recorded - 1, uint64_t(1)}) {
        AgaaFrame frame = rig.nextFrame();
        frame.frameIndex = index;
        frame.completedFrame = index - 1;
        expectFrameRefused(
            rig, frame,
            {AGAA_ERROR_WRONG_ORDER,
             rig.function() + " with frameIndex = " + std::to_string(index) + " after " + std::to_string(rig.recorded),
             "frameIndex"},
            expected);
    }
}

// The frame index 0 is invalid.
void testFirstIndex(Test& test) {
    Rig rig(test);
    for (const uint64_t completed : {UINT64_C(0), UINT64_C(1)}) {
        AgaaFrame frame = rig.nextFrame();
        frame.frameIndex = 0;
        frame.completedFrame = completed;
        rig.context.log.lines.clear();
        const AgaaResult result = rig.record(frame);
        rig.test.check(result == AGAA_ERROR_WRONG_ORDER || result == AGAA_ERROR_OUT_OF_RANGE,
                       rig.function() + " with frameIndex = 0 returns " + test.sdk.agaaResultName(result) + ".");
        expectRefused(test, result, result, rig.context.log, rig.function(), rig.function() + " with frameIndex = 0");
    }
    rig.render();
}

void testFramesInFlight(Test& test) {
    for (const uint32_t inFlight : {1u, 2u, 3u}) {
        Rig rig(test, {}, [inFlight](ContextDescription& c) { c.desc.framesInFlight = inFlight; });
        const Image expected = rig.render(); // frame 1
        const std::string with = rig.function() + ", framesInFlight = " + std::to_string(inFlight) + ", ";
        for (uint32_t i = 2; i <= inFlight; ++i)
            rig.render([](AgaaFrame& frame) { frame.completedFrame = 0; });
        AgaaFrame frame = rig.nextFrame();
        frame.completedFrame = 0;
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_WRONG_ORDER, with + "none of " + std::to_string(inFlight) + " frames finished"},
                           expected);
        // Exactly the frame that is framesInFlight earlier is finished.
        rig.render([inFlight](AgaaFrame& f) { f.completedFrame = f.frameIndex - inFlight; });
    }
}

void testCompletedFrame(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    for (const uint64_t beyond : {UINT64_C(0), UINT64_C(1), UINT64_MAX - 10}) {
        AgaaFrame frame = rig.nextFrame();
        frame.completedFrame = frame.frameIndex + beyond;
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_OUT_OF_RANGE,
                            rig.function() + " with completedFrame = " + std::to_string(frame.completedFrame) +
                                ", frameIndex = " + std::to_string(frame.frameIndex),
                            "completedFrame"},
                           expected);
    }
}

// Camera and ditherFrame must be the same in all segments.
void testSameCamera(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    const struct {
        const char* what;
        std::function<void(AgaaFrame&)> change;
        const char* words;
    } rows[] = {{"another projection", [](AgaaFrame& f) { f.projection[12] += 0.01f; }, "projection"},
                {"another view", [](AgaaFrame& f) { f.view[0] = f.view[5] = -1; }, "view"},
                {"another ditherFrame", [](AgaaFrame& f) { f.ditherFrame = 1; }, "ditherFrame"}};
    for (const auto& row : rows)
        for (const uint64_t first : {pre, pre | gen}) {
            AgaaFrame frame = rig.nextFrame();
            frame.segments = first;
            test.requireOk(rig.record(frame), rig.function() + " with" + segmentsText(first));
            AgaaFrame rest = frame;
            rest.segments = AGAA_SEGMENT_ALL & ~first;
            row.change(rest);
            rig.context.log.lines.clear();
            const AgaaResult result = rig.record(rest);
            const std::string what = rig.function() + " with " + row.what + " after" + segmentsText(first);
            expectRefused(test, result, AGAA_ERROR_OUT_OF_RANGE, rig.context.log, rig.function(), what, row.words);
            frame.segments = AGAA_SEGMENT_ALL & ~first;
            test.requireOk(rig.record(frame), rig.function() + " with the camera of the first segment after " + what);
            expectSame(test, rig.device().readOutput(), expected, rig.description().desc.width,
                       "the frame after " + what);
        }
}

// A view without AGAA_VIEW_COMPOSITE keeps nothing of the output.
void testComposite(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.background[3] = 0;
    expectFrameRefused(rig, frame,
                       {AGAA_ERROR_OUT_OF_RANGE, rig.function() + " with background[3] = 0 and no AGAA_VIEW_COMPOSITE",
                        "AGAA_VIEW_COMPOSITE"},
                       expected);
}

} // namespace

void addFrameOrderCases(Suite& suite) {
    addRecordCase(suite, "AGAA_ERROR_WRONG_ORDER", testSegmentOrder);
    addRecordCase(suite, "AGAA_ERROR_WRONG_ORDER/abandoned_frame", testAbandonedFrame);
    addRecordCase(suite, "AGAA_ERROR_WRONG_ORDER/frame_index", testIndices);
    addRecordCase(suite, "AGAA_ERROR_WRONG_ORDER/first_index", testFirstIndex);
    addRecordCase(suite, "AGAA_ERROR_WRONG_ORDER/frames_in_flight", testFramesInFlight);
    addRecordCase(suite, "AGAA_ERROR_OUT_OF_RANGE", testSameCamera);
    addRecordCase(suite, "AGAA_ERROR_OUT_OF_RANGE/completed_frame", testCompletedFrame);
    addRecordCase(suite, "AGAA_ERROR_OUT_OF_RANGE/composite", testComposite);
}

} // namespace agaa::conformance
