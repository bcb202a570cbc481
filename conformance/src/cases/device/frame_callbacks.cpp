// Draw callbacks that fail.
#include "cases.h"
#include "frame_rig.h"

#include <stdexcept>

namespace agaa::conformance {

namespace {

// A draw callback that fails in one of its calls.
struct FailingDraw {
    Device& device;
    uint32_t failingCall; // index of the failing call, from 1; 0: none
    AgaaResult result = AGAA_ERROR_CALLBACK;
    bool throws = false;
    uint32_t calls = 0;

    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<FailingDraw*>(user);
        if (++self.calls != self.failingCall)
            return self.device.draw(*target);
        if (self.throws)
            throw std::runtime_error("the draw callback throws");
        return self.result;
    }
    void use(AgaaFrame& frame) {
        frame.draw = draw;
        frame.drawUser = this;
    }
};

struct DrawFailure {
    const char* technique;
    uint32_t call;
    AgaaResult result;
};
// "agaa" draws twice, unless the device aggregates from a G-buffer.
const DrawFailure drawFailures[] = {{"agaa", 1, AGAA_ERROR_CALLBACK},   {"agaa", 2, AGAA_ERROR_CALLBACK},
                                    {"agaa", 2, AGAA_NOT_READY},        {"agaa", 1, 12345},
                                    {"agaa", 1, AGAA_ERROR_INTERNAL},   {"msaa", 1, AGAA_ERROR_CALLBACK},
                                    {"single", 1, AGAA_ERROR_CALLBACK}, {"dcaa", 1, AGAA_ERROR_CALLBACK}};

std::string callText(const DrawFailure& row) {
    return "a draw callback of \"" + std::string(row.technique) + "\" that returns " + std::to_string(row.result) +
           " at call " + std::to_string(row.call);
}

Rig::ChangeView withTechnique(const std::string& technique) {
    return [technique](ViewDescription& description) { setTechnique(description, technique, 4); };
}

void expectDrawFailure(Rig& rig, FailingDraw draw, const std::string& what, AgaaResult code, const Image& expected) {
    AgaaFrame frame = rig.nextFrame();
    draw.use(frame);
    expectFrameRefused(rig, frame, {code, rig.function() + " with " + what}, expected);
    rig.test.check(draw.calls == draw.failingCall,
                   what + ": " + std::to_string(draw.calls) + " draw calls; none is promised after one that fails.");
}

void testFailures(Test& test, AgaaResult code, const Rig::ChangeContext& changeContext = {}) {
    for (const char* technique : {"agaa", "msaa", "single", "dcaa"}) {
        if (!unsupportedReason(test, technique).empty())
            continue;
        Rig rig(test, withTechnique(technique), changeContext);
        const Image expected = rig.render();
        const uint32_t passes = rig.statistics().geometryPasses;
        for (const DrawFailure& row : drawFailures)
            if (std::string(row.technique) == technique && row.call <= passes)
                expectDrawFailure(rig, {rig.device(), row.call, row.result}, callText(row), code, expected);
    }
}

void testException(Test& test, AgaaResult code, const Rig::ChangeContext& changeContext = {}) {
    Rig rig(test, {}, changeContext);
    const Image expected = rig.render();
    expectDrawFailure(rig, {rig.device(), 1, AGAA_OK, true}, "a draw callback that throws", code, expected);
}

void recordInline(ContextDescription& description) { description.vk.recording = AGAA_VK_RECORDING_INLINE; }

// No command of the segment is recorded, and the frame continues with this segment.
void testSegment(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.segments = AGAA_SEGMENT_PREPASS;
    test.requireOk(rig.record(frame), rig.function() + " with AGAA_SEGMENT_PREPASS");
    AgaaFrame rest = frame;
    rest.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
    FailingDraw draw{rig.device(), 1};
    draw.use(rest);
    rig.context.log.lines.clear();
    const AgaaResult result = rig.record(rest);
    if (!draw.calls)
        test.skip("the segments after the prepass have no draw pass on this device.");
    const std::string what = rig.function() + " with a draw callback that fails in a later segment";
    expectRefused(test, result, AGAA_ERROR_CALLBACK, rig.context.log, rig.function(), what);
    rest.draw = nullptr;
    test.requireOk(rig.record(rest), "the same segments after " + what);
    expectSame(test, rig.device().readOutput(), expected, rig.description().desc.width, "the frame after " + what);
    expectNextFrame(rig, expected, what);
}

// A frame cannot continue if a later segment was recorded in part. The next frame can start.
void testPartialSegment(Test& test) {
    Rig rig(test, {}, recordInline);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.segments = AGAA_SEGMENT_PREPASS;
    test.requireOk(rig.record(frame), rig.function() + " with AGAA_SEGMENT_PREPASS");
    AgaaFrame rest = frame;
    rest.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
    FailingDraw draw{rig.device(), 1};
    draw.use(rest);
    rig.context.log.lines.clear();
    const AgaaResult result = rig.record(rest);
    if (!draw.calls)
        test.skip("the segments after the prepass have no draw pass on this device.");
    const std::string what = rig.function() + " with a draw callback that fails in a later segment";
    expectRefused(test, result, AGAA_ERROR_PARTIAL, rig.context.log, rig.function(), what);
    expectNextFrame(rig, expected, what);
}

// Failed frames use neither frames in flight nor indices.
void testManyFailures(Test& test, AgaaResult code, const Rig::ChangeContext& changeContext) {
    Rig rig(test, {}, changeContext);
    const Image expected = rig.render();
    for (int i = 0; i < 10; ++i) {
        AgaaFrame frame = rig.nextFrame();
        frame.completedFrame = 0;
        FailingDraw draw{rig.device(), 1};
        draw.use(frame);
        rig.context.log.lines.clear();
        test.result(rig.record(frame), code,
                    rig.function() + " with a draw callback that fails, time " + std::to_string(i));
    }
    AgaaFrame frame = rig.nextFrame();
    frame.completedFrame = 0;
    test.requireOk(rig.record(frame), "the second of two frames in flight after ten that failed");
    expectSame(test, rig.device().readOutput(), expected, rig.description().desc.width,
               "the frame after ten that failed");
    const AgaaFrameStatistics statistics = rig.statistics();
    test.check(statistics.frameIndex == rig.recorded, "the statistics are of frame " +
                                                          std::to_string(statistics.frameIndex) + " in place of " +
                                                          std::to_string(rig.recorded) + ".");
}

} // namespace

void addFrameCallbackCases(Suite& suite) {
    addRecordCase(suite, "AGAA_ERROR_CALLBACK", [](Test& test) { testFailures(test, AGAA_ERROR_CALLBACK); });
    addRecordCase(suite, "AGAA_ERROR_CALLBACK/exception", [](Test& test) { testException(test, AGAA_ERROR_CALLBACK); });
    addRecordCase(suite, "AGAA_ERROR_CALLBACK/many",
                  [](Test& test) { testManyFailures(test, AGAA_ERROR_CALLBACK, {}); });
    suite.add("agaaVkRecordFrame/AGAA_ERROR_CALLBACK/segment", {Backend::Vulkan}, testSegment);
    suite.add("agaaVkRecordFrame/AGAA_ERROR_PARTIAL", {Backend::Vulkan}, testPartialSegment);
    suite.add("AGAA_VK_RECORDING_INLINE/AGAA_ERROR_PARTIAL", {Backend::Vulkan},
              [](Test& test) { testFailures(test, AGAA_ERROR_PARTIAL, recordInline); });
    suite.add("AGAA_VK_RECORDING_INLINE/AGAA_ERROR_PARTIAL/exception", {Backend::Vulkan},
              [](Test& test) { testException(test, AGAA_ERROR_PARTIAL, recordInline); });
    suite.add("AGAA_VK_RECORDING_INLINE/AGAA_ERROR_PARTIAL/many", {Backend::Vulkan},
              [](Test& test) { testManyFailures(test, AGAA_ERROR_PARTIAL, recordInline); });
}

} // namespace agaa::conformance
