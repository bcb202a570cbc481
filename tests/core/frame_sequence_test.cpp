// The turns of a view's history.
#include "core/frame/frame_sequence.h"

#include <gtest/gtest.h>

namespace agaa {
namespace {

class Turns : public testing::Test {
protected:
    AgaaFrame frame(uint64_t index, uint64_t segments = AGAA_SEGMENT_ALL) {
        AgaaFrame out = AGAA_FRAME_INIT;
        out.frameIndex = index;
        out.segments = segments;
        out.facts = &facts_;
        return out;
    }
    FrameSequence sequence_{2};
    AgaaSceneFacts facts_ = AGAA_SCENE_FACTS_INIT;
};

TEST_F(Turns, AlternateAndNameTheFrameBefore) {
    EXPECT_EQ(sequence_.turnOf(frame(5)).previousFrame, 0u);
    const uint32_t first = sequence_.turnOf(frame(5)).slot;
    sequence_.recorded(frame(5));
    EXPECT_EQ(sequence_.turnOf(frame(9)).previousFrame, 5u);
    EXPECT_NE(sequence_.turnOf(frame(9)).slot, first);
    sequence_.recorded(frame(9));
    EXPECT_EQ(sequence_.turnOf(frame(10)).previousFrame, 9u);
    EXPECT_EQ(sequence_.turnOf(frame(10)).slot, first);
}

// All segments of a frame have its turn.
TEST_F(Turns, AreThoseOfTheFrame) {
    sequence_.recorded(frame(1));
    const HistoryTurn turn = sequence_.turnOf(frame(2, AGAA_SEGMENT_PREPASS));
    sequence_.recorded(frame(2, AGAA_SEGMENT_PREPASS));
    EXPECT_EQ(sequence_.turnOf(frame(2, AGAA_SEGMENT_SHADING)).slot, turn.slot);
    EXPECT_EQ(sequence_.turnOf(frame(2, AGAA_SEGMENT_SHADING)).previousFrame, 1u);
}

// The host's camera of the frame before may be that of the frame that failed.
TEST_F(Turns, FailedFramesLeaveNoHistory) {
    sequence_.recorded(frame(1));
    sequence_.failed(frame(2));
    EXPECT_EQ(sequence_.turnOf(frame(3)).previousFrame, 0u);
    sequence_.recorded(frame(3));
    EXPECT_EQ(sequence_.turnOf(frame(4)).previousFrame, 3u);
    sequence_.abortedAfterExecution(frame(4));
    EXPECT_EQ(sequence_.turnOf(frame(5)).previousFrame, 0u);
}

} // namespace
} // namespace agaa
