// The order of frames and segments, and the slots of frames in flight.
#pragma once

#include "agaa_sdk.h"
#include "core/frame/temporal.h"
#include "core/plan/plan.h"

#include <array>
#include <cstdint>
#include <vector>

namespace agaa {

// The lighting of a frame, for fact reports.
struct FrameContent {
    uint32_t lights = 0, localLights = 0, shadows = 0;
    bool hasAmbient = false;
};

class FrameSequence {
public:
    explicit FrameSequence(uint32_t slotCount) : slots_(slotCount) {}

    // Continues the frame numbers of another sequence. A frame that it began cannot continue.
    void startAfter(const FrameSequence& other);
    // Throws Error if the frame may not follow what was recorded before. frame.facts, width and height must be set.
    void check(const AgaaFrame& frame) const;
    bool begins(const AgaaFrame& frame) const { return frame.frameIndex != frame_; }
    uint32_t slotOf(const AgaaFrame& frame) const;
    HistoryTurn turnOf(const AgaaFrame& frame) const;
    // Returns whether what the view remembers of earlier frames is of another size.
    bool changesSize(const AgaaFrame& frame) const;

    void recorded(const AgaaFrame& frame);
    // Recording failed, and the host discards the commands. If earlier segments were recorded, the frame cannot
    // continue.
    void failed(const AgaaFrame& frame);
    // Commands of a segment were executed before it failed: the previous contents of the slot and of the surfaces are
    // lost. Neither this frame nor an earlier one whose segments are missing can continue.
    void abortedAfterExecution(const AgaaFrame& frame);

    struct Slot {
        uint64_t frame = 0; // that used the slot last
        bool complete = false;
        FrameContent content;
    };
    // Returns the newest completely recorded frame up to completedFrame, or null if there is none.
    const Slot* newest(uint64_t completedFrame) const;
    // Returns the slot that the frame used last, or null if a later frame uses it.
    const Slot* find(uint64_t frame) const;
    uint32_t indexOf(const Slot& slot) const { return uint32_t(&slot - slots_.data()); }

private:
    std::vector<Slot> slots_;
    uint64_t frame_ = 0;
    uint64_t previousFrame_ = 0; // recorded before it
    uint64_t frames_ = 0;        // number of frames that were begun
    bool hasGap_ = false;        // the frame after frame_ failed
    uint32_t slot_ = 0;
    uint64_t segments_ = 0;          // of the frame that were recorded
    std::array<float, 32> camera_{}; // view and projection of the frame
    uint32_t ditherFrame_ = 0;       // of the frame
    AgaaSceneFacts facts_{};         // of the frame
    FrameExtent extent_;             // of the frame
};

} // namespace agaa
