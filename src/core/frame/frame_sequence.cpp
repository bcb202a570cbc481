#include "core/frame/frame_sequence.h"

#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "core/view/facts.h"

#include <algorithm>

namespace agaa {

static std::array<float, 32> cameraOf(const AgaaFrame& frame) {
    std::array<float, 32> camera;
    std::copy_n(frame.view, 16, camera.begin());
    std::copy_n(frame.projection, 16, camera.begin() + 16);
    return camera;
}

static bool areEqual(const AgaaSceneFacts& a, const AgaaSceneFacts& b) { return isWithin(a, b) && isWithin(b, a); }

static FrameExtent sizeOf(const AgaaFrame& frame) { return {frame.width, frame.height}; }

void FrameSequence::startAfter(const FrameSequence& other) {
    frame_ = other.frame_;
    segments_ = AGAA_SEGMENT_ALL;
}

void FrameSequence::check(const AgaaFrame& frame) const {
    const uint64_t lowest = frame.segments & (~frame.segments + 1);
    // Segments must be contiguous: 101 would shade aggregates that were not generated.
    const uint64_t run = frame.segments / lowest;
    require((run & (run + 1)) == 0, AGAA_ERROR_WRONG_ORDER, "AgaaFrame::segments leaves one out between others.");
    if (frame.frameIndex == frame_) {
        require((frame.segments & segments_) == 0, AGAA_ERROR_WRONG_ORDER,
                "a segment of this frame was recorded before.");
        // Segments must come in order: each bit needs all lower ones.
        require((segments_ & (lowest - 1)) == lowest - 1, AGAA_ERROR_WRONG_ORDER,
                "an earlier segment of this frame is missing.");
        require(cameraOf(frame) == camera_, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaFrame::view or projection is not that of the frame's earlier segments.");
        require(frame.ditherFrame == ditherFrame_, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaFrame::ditherFrame is not that of the frame's earlier segments.");
        require(sizeOf(frame) == extent_, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaFrame::width or height is not that of the frame's earlier segments.");
        require(areEqual(*frame.facts, facts_), AGAA_ERROR_OUT_OF_RANGE,
                "AgaaFrame::facts are not those of the frame's earlier segments.");
        return;
    }
    require(frame.frameIndex > frame_, AGAA_ERROR_WRONG_ORDER, "AgaaFrame::frameIndex does not increase.");
    require((frame.segments & AGAA_SEGMENT_PREPASS) != 0, AGAA_ERROR_WRONG_ORDER,
            "a frame begins with AGAA_SEGMENT_PREPASS.");
    const Slot& slot = slots_[slotOf(frame)];
    if (slot.frame > frame.completedFrame)
        fail(AGAA_ERROR_WRONG_ORDER,
             format("frame %llu uses what frame %llu has not finished with; wait for it or create "
                    "the context with more framesInFlight.",
                    static_cast<unsigned long long>(frame.frameIndex), static_cast<unsigned long long>(slot.frame)));
}

uint32_t FrameSequence::slotOf(const AgaaFrame& frame) const {
    return begins(frame) ? (slot_ + 1) % uint32_t(slots_.size()) : slot_;
}

HistoryTurn FrameSequence::turnOf(const AgaaFrame& frame) const {
    const bool isNew = begins(frame);
    const uint64_t previous = isNew ? (hasGap_ || changesSize(frame) ? 0 : frame_) : previousFrame_;
    return {uint32_t((frames_ + (isNew ? 1 : 0)) & 1), previous};
}

bool FrameSequence::changesSize(const AgaaFrame& frame) const {
    return begins(frame) && extent_.width != 0 && extent_ != sizeOf(frame);
}

static FrameContent contentOf(const AgaaFrame& frame) {
    FrameContent content{.lights = frame.lightCount, .shadows = frame.shadowCount};
    for (uint32_t i = 0; i < frame.lightCount; ++i)
        content.localLights += lightOf(frame, i).type != AGAA_LIGHT_DIRECTIONAL;
    content.hasAmbient = std::ranges::any_of(frame.ambient, [](float value) { return value != 0; });
    return content;
}

void FrameSequence::recorded(const AgaaFrame& frame) {
    if (begins(frame)) {
        slot_ = slotOf(frame);
        previousFrame_ = hasGap_ || changesSize(frame) ? 0 : frame_;
        hasGap_ = false;
        ++frames_;
        frame_ = frame.frameIndex;
        camera_ = cameraOf(frame);
        extent_ = sizeOf(frame);
        ditherFrame_ = frame.ditherFrame;
        facts_ = *frame.facts;
        segments_ = 0;
        slots_[slot_] = {frame.frameIndex, false, {}};
    }
    segments_ |= frame.segments;
    if (frame.segments & AGAA_SEGMENT_SHADING)
        slots_[slot_].content = contentOf(frame);
    slots_[slot_].complete = segments_ == AGAA_SEGMENT_ALL;
}

void FrameSequence::failed(const AgaaFrame& frame) {
    hasGap_ = true;
    if (!begins(frame))
        segments_ = AGAA_SEGMENT_ALL;
}

void FrameSequence::abortedAfterExecution(const AgaaFrame& frame) {
    hasGap_ = true;
    extent_ = sizeOf(frame);
    slots_[slotOf(frame)].complete = false;
    segments_ = AGAA_SEGMENT_ALL;
}

const FrameSequence::Slot* FrameSequence::find(uint64_t frame) const {
    const auto found = std::ranges::find(slots_, frame, &Slot::frame);
    return found == slots_.end() ? nullptr : &*found;
}

const FrameSequence::Slot* FrameSequence::newest(uint64_t completedFrame) const {
    const Slot* newest = nullptr;
    for (const Slot& slot : slots_)
        if (slot.complete && slot.frame <= completedFrame && (!newest || slot.frame > newest->frame))
            newest = &slot;
    return newest;
}

} // namespace agaa
