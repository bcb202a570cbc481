// Tests of single members of the description of a frame: accepted and refused values.
#pragma once

#include "cases/core/members.h"
#include "frame_rig.h"

namespace agaa::conformance {

// A valid frame, and two lights and two shadows to which it does not point yet.
struct FrameParts {
    explicit FrameParts(const Rig& rig);
    AgaaFrame frame;
    AgaaLight lights[2];
    AgaaShadow shadows[2];
    void useLights() {
        frame.lights = lights;
        frame.lightCount = 2;
    }
    void useShadows() {
        frame.shadows = shadows;
        frame.shadowCount = 2;
    }
};

// Values are doubles, which hold every float and every uint32_t.
struct FrameMember {
    std::string promise; // for example AgaaFrame.ambient/range
    std::string member;  // name in the test's sentences, for example AgaaFrame::ambient
    std::string words;   // part of the log's sentence
    std::function<void(FrameParts&, double)> set;
    std::vector<double> accepted, refused;
    std::vector<double> refusedToday = {}; // a later library may accept them
    AgaaResult error = AGAA_ERROR_OUT_OF_RANGE;
};

// A view for the rows, with at most 4 lights and 2 shadow maps, and the image of a valid frame.
struct MemberRig : Rig {
    explicit MemberRig(Test& test);
    Image expected;
};
void testFrameMember(MemberRig& rig, const FrameMember& row);
void addFrameMember(Suite& suite, const FrameMember& row);
// Adds one test with all rows. The promises of the rows are not used.
void addFrameMembers(Suite& suite, const std::string& promise, const std::vector<FrameMember>& rows);

} // namespace agaa::conformance
