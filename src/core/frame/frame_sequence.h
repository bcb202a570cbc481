// Which frame and segments may come next, and which of the frames in flight's slots they use.
#pragma once

#include "agaa_sdk.h"

#include <array>
#include <cstdint>
#include <vector>

namespace agaa {

// What a frame's lights call for.
struct FrameContent {
    uint32_t lights = 0, localLights = 0, shadows = 0;
    bool hasAmbient = false;
};

class FrameSequence {
public:
    explicit FrameSequence(uint32_t slotCount) : slots_(slotCount) {}

    // The frames of another sequence are over: one that it began cannot go on.
    void startAfter(const FrameSequence& other);
    // Throws where frame, which has its facts, does not follow from what was recorded before.
    void check(const AgaaFrame& frame) const;
    bool begins(const AgaaFrame& frame) const { return frame.frameIndex != frame_; }
    uint32_t slotOf(const AgaaFrame& frame) const;

    void recorded(const AgaaFrame& frame);
    // The frame's commands are discarded or in part: one that began before cannot go on.
    void failed(const AgaaFrame& frame);
    // The same where what came before the failure has run: the slot no longer holds the frame it did.
    void abortedAfterExecution(const AgaaFrame& frame);

    // Newest frame recorded whole, not after completedFrame; null where there is none.
    struct Slot {
        uint64_t frame = 0; // that used it last
        bool complete = false;
        FrameContent content;
    };
    const Slot* newest(uint64_t completedFrame) const;
    uint32_t indexOf(const Slot& slot) const { return uint32_t(&slot - slots_.data()); }

private:
    std::vector<Slot> slots_;
    uint64_t frame_ = 0;
    uint32_t slot_ = 0;
    uint64_t segments_ = 0;           // recorded of the frame
    std::array<float, 32> camera_{};  // view and projection of the frame
    uint32_t ditherFrame_ = 0;        // of the frame
    AgaaSceneFacts facts_{};          // of the frame
};

} // namespace agaa
