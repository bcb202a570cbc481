// AgaaTemporalFrame: frames of views that accumulate.
#include "cases.h"
#include "cases/core/members.h"
#include "frame_rig.h"

#include <cstring>
#include <limits>

namespace agaa::conformance {

namespace {

struct TemporalRig : Rig {
    explicit TemporalRig(Test& test)
        : Rig(test, [](ViewDescription& d) { setTechnique(d, "taa", 1); }), expected(render()) {
        const AgaaFrame frame = nextFrame();
        valid = AGAA_TEMPORAL_FRAME_INIT;
        valid.resets = 0;
        std::memcpy(valid.previousProjection, frame.projection, sizeof frame.projection);
    }
    AgaaResult recordWith(const AgaaTemporalFrame& temporal) {
        AgaaFrame frame = nextFrame();
        frame.pNext = &temporal;
        return record(frame);
    }
    void accept(const AgaaTemporalFrame& temporal, const std::string& what) {
        test.result(recordWith(temporal), AGAA_OK, what);
        expectNoMessages(what);
        expectAlike(test, device().readOutput(), expected, 1e-3f, what);
    }
    void refuse(const AgaaTemporalFrame& temporal, const std::string& what, const std::string& words) {
        AgaaFrame frame = nextFrame();
        frame.pNext = &temporal;
        expectFrameRefused(*this, frame, {AGAA_ERROR_OUT_OF_RANGE, what, words}, expected);
    }
    // The next valid frame forgets earlier frames, so that it is the same whatever was recorded before.
    Image expected;
    AgaaTemporalFrame valid;
};

void testMissingStruct(Test& test) {
    TemporalRig rig(test);
    AgaaFrame frame = rig.nextFrame();
    frame.pNext = nullptr;
    expectFrameRefused(
        rig, frame,
        {AGAA_ERROR_INVALID_ARGUMENT, rig.function() + " without an AgaaTemporalFrame", "AgaaTemporalFrame"},
        rig.expected);
}

void testReservedOfTemporalFrames(Test& test) {
    TemporalRig rig(test);
    AgaaTemporalFrame temporal = rig.valid;
    rig.accept(temporal, "an AgaaTemporalFrame");
    temporal.reserved = 1;
    rig.refuse(temporal, "AgaaTemporalFrame::reserved = 1", "AgaaTemporalFrame::reserved");
    temporal = rig.valid;
    temporal.resets = 2;
    rig.refuse(temporal, "AgaaTemporalFrame::resets = 2", "AgaaTemporalFrame::resets");
}

void testJitter(Test& test) {
    TemporalRig rig(test);
    for (int i = 0; i < 2; ++i) {
        AgaaTemporalFrame temporal = rig.valid;
        for (const float value : {-1.0f, 0.0f, 1.0f}) {
            temporal.resets = 1;
            temporal.jitter[i] = value;
            rig.accept(temporal, "AgaaTemporalFrame::jitter = " + std::to_string(value));
        }
        for (const double value : notNumbers({below(-1), above(1)})) {
            temporal.jitter[i] = float(value);
            rig.refuse(temporal, "AgaaTemporalFrame::jitter = " + std::to_string(value), "AgaaTemporalFrame::jitter");
        }
    }
}

void testMatrices(Test& test) {
    TemporalRig rig(test);
    for (int i = 0; i < 16; ++i) {
        AgaaTemporalFrame temporal = rig.valid;
        const bool isTranslation = i >= 12 && i < 15;
        std::vector<double> refused = notNumbers({above(1e18f), below(-1e18f)});
        if (!isTranslation)
            refused.insert(refused.end(), {i % 5 == 0 ? 0.5 : 1.0, -1.0}); // -1 on the diagonal: a reflection
        for (const double value : refused) {
            temporal.toPreviousView[i] = float(value);
            rig.refuse(temporal, "AgaaTemporalFrame::toPreviousView[" + std::to_string(i) + "]",
                       "AgaaTemporalFrame::toPreviousView");
        }
        temporal = rig.valid;
        temporal.previousProjection[i] = std::numeric_limits<float>::quiet_NaN();
        rig.refuse(temporal, "AgaaTemporalFrame::previousProjection[" + std::to_string(i) + "]",
                   "AgaaTemporalFrame::previousProjection");
        // A frame that forgets earlier ones does not read the camera.
        temporal.resets = 1;
        rig.accept(temporal, "AgaaTemporalFrame::previousProjection that is not read");
    }
    // A camera far away saw nothing of this frame: the image is that of the frame alone.
    for (const float far : {-1e18f, 1e18f}) {
        AgaaTemporalFrame temporal = rig.valid;
        temporal.toPreviousView[12] = far;
        rig.accept(temporal, "AgaaTemporalFrame::toPreviousView[12] = " + std::to_string(far));
    }
}

} // namespace

void addTemporalFrameCases(Suite& suite) {
    suite.both("AgaaTemporalFrame/AGAA_ERROR_INVALID_ARGUMENT", testMissingStruct);
    suite.both("AgaaTemporalFrame.reserved/zero", testReservedOfTemporalFrames);
    suite.both("AgaaTemporalFrame.jitter/range", testJitter);
    suite.both("AgaaTemporalFrame.toPreviousView/range", testMatrices);
}

} // namespace agaa::conformance
