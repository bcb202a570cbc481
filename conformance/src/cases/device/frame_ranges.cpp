// Members of AgaaFrame, except the members of lights and shadows.
#include "cases.h"
#include "frame_members.h"

namespace agaa::conformance {

namespace {

using Set = std::function<void(FrameParts&, double)>;

Set projection(int i) {
    return [i](FrameParts& parts, double v) { parts.frame.projection[i] = float(v); };
}
Set view(int i) {
    return [i](FrameParts& parts, double v) { parts.frame.view[i] = float(v); };
}

std::string elementText(const char* member, int i) { return std::string(member) + "[" + std::to_string(i) + "]"; }

// The pixel camera is orthographic: elements 0, 5, 10 scale, elements 12, 13, 14 shift. On OpenGL element 14 may be -1.
void testProjection(Test& test) {
    MemberRig rig(test);
    FrameMember row{"", "", "AgaaFrame::projection", {}, {}, {}};
    const auto refuse = [&](int i, std::vector<double> values, const std::string& condition = "") {
        row.member = elementText("AgaaFrame::projection", i) + condition;
        row.set = projection(i);
        row.refused = std::move(values);
        testFrameMember(rig, row);
    };
    for (const int i : {1, 2, 3, 4, 6, 7, 8, 9}) // shear, roll, an oblique near plane
        refuse(i, notNumbers({1, -0.25}));
    for (const int i : {0, 5})
        refuse(i, notNumbers({0}));
    for (const int i : {12, 13, 14})
        refuse(i, notNumbers({}));
    refuse(10, notNumbers({0, 0.05})); // swaps the near and the far plane
    refuse(11, notNumbers({-1, 1}), ", with [15] = 1,");
    refuse(15, notNumbers({0, 2}), ", with [11] = 0,");
}

void perspective(FrameParts& parts, double distance) {
    float* p = parts.frame.projection;
    std::fill(p, p + 16, 0.0f);
    p[0] = float(distance) / 16;
    p[5] = -float(distance) / 12;
    p[8] = 0.01f; // sub-pixel jitter
    p[9] = -0.01f;
    p[10] = -1.01f;
    p[11] = -1;
    p[14] = -0.2f;
}

void testPerspective(Test& test) {
    MemberRig rig(test);
    const auto with = [](int i) {
        return [i](FrameParts& parts, double v) {
            perspective(parts, 8);
            parts.frame.projection[i] = float(v);
        };
    };
    testFrameMember(rig, {"",
                          "AgaaFrame::projection for a screen at the distance",
                          "AgaaFrame::projection",
                          perspective,
                          {4, 8, 100},
                          {}});
    for (const int i : {1, 2, 3, 4, 6, 7, 12, 13})
        testFrameMember(rig, {"",
                              elementText("AgaaFrame::projection", i) + " of a perspective",
                              "AgaaFrame::projection",
                              with(i),
                              {},
                              notNumbers({1})});
    testFrameMember(rig, {"",
                          "AgaaFrame::projection[14] of a perspective",
                          "AgaaFrame::projection",
                          with(14),
                          {},
                          notNumbers({0, 0.2})});
    testFrameMember(
        rig,
        {"", "AgaaFrame::projection[15] of a perspective", "AgaaFrame::projection", with(15), {}, notNumbers({1, -1})});
}

void testViewMatrix(Test& test) {
    MemberRig rig(test);
    FrameMember row{"", "", "AgaaFrame::view", {}, {}, {}};
    for (int i = 0; i < 16; ++i) {
        row.member = elementText("AgaaFrame::view", i) + " of the identity";
        row.set = view(i);
        row.refused = notNumbers({i % 5 == 0 ? 0.5 : 1.0, -1});
        testFrameMember(rig, row);
    }
    row.refused.clear();
    row.accepted = {0, 1, 2}; // quarter turns
    row.member = "AgaaFrame::view turned about its z, in quarters,";
    row.set = [](FrameParts& parts, double quarters) {
        const int cosines[] = {1, 0, -1}, sines[] = {0, 1, 0};
        float* v = parts.frame.view;
        v[0] = v[5] = float(cosines[int(quarters)]);
        v[1] = float(sines[int(quarters)]);
        v[4] = -v[1];
    };
    testFrameMember(rig, row);
}

void addExposure(Suite& suite) {
    suite.both("AgaaFrame.exposure/range", [](Test& test) {
        MemberRig rig(test);
        testFrameMember(rig, {"",
                              "AgaaFrame::exposure",
                              "AgaaFrame::exposure",
                              [](FrameParts& parts, double v) { parts.frame.exposure = float(v); },
                              {0, 1e-30f, 1, 1e9f},
                              notNumbers({-1e-20, -1, above(1e9f)})});
    });
    const double outside = 1u << 30; // beyond any image
    addFrameMember(suite, {"AgaaFrame.width/range",
                           "AgaaFrame::width",
                           "AgaaFrame::width",
                           [](FrameParts& parts, double v) {
                               parts.frame.width = uint32_t(v);
                               parts.frame.height = 1;
                           },
                           {1, 31, 32},
                           {0, 33, 4294967295.0}});
    addFrameMember(suite, {"AgaaFrame.height/range",
                           "AgaaFrame::height",
                           "AgaaFrame::height",
                           [](FrameParts& parts, double v) {
                               parts.frame.width = 1;
                               parts.frame.height = uint32_t(v);
                           },
                           {1, 23, 24},
                           {0, 25, 4294967295.0}});
    const auto place = [](uint32_t AgaaFrame::*member, uint32_t size) {
        return [member, size](FrameParts& parts, double v) {
            parts.frame.width = parts.frame.height = size;
            parts.frame.*member = uint32_t(v);
        };
    };
    addFrameMembers(
        suite, "AgaaFrame.outputX/range",
        {{"", "AgaaFrame::outputX", "AgaaFrame::outputX", place(&AgaaFrame::outputX, 8), {0, 1, 24}, {outside}},
         {"", "AgaaFrame::outputX without width", "AgaaFrame::outputX", place(&AgaaFrame::outputX, 0), {0}, {1}}});
    addFrameMembers(
        suite, "AgaaFrame.outputY/range",
        {{"", "AgaaFrame::outputY", "AgaaFrame::outputY", place(&AgaaFrame::outputY, 8), {0, 1, 16}, {outside}},
         {"", "AgaaFrame::outputY without height", "AgaaFrame::outputX", place(&AgaaFrame::outputY, 0), {0}, {1}}});
    suite.both("AgaaFrame.reserved/zero", [](Test& test) {
        MemberRig rig(test);
        testFrameMember(rig, {"",
                              "AgaaFrame::reserved",
                              "AgaaFrame::reserved",
                              [](FrameParts& parts, double v) { parts.frame.reserved = uint32_t(v); },
                              {0},
                              {1, 4294967295.0}});
    });
}

void addColors(Suite& suite) {
    suite.both("AgaaFrame.ambient/range", [](Test& test) {
        MemberRig rig(test);
        for (int i = 0; i < 3; ++i)
            testFrameMember(rig, {"",
                                  elementText("AgaaFrame::ambient", i),
                                  "AgaaFrame::ambient",
                                  [i](FrameParts& parts, double v) { parts.frame.ambient[i] = float(v); },
                                  {0, 1e-30f, 65504},
                                  notNumbers({-1e-20, -1, above(65504)})});
    });
    suite.both("AgaaFrame.background/range", [](Test& test) {
        MemberRig rig(test);
        for (int i = 0; i < 4; ++i)
            testFrameMember(rig, {"",
                                  elementText("AgaaFrame::background", i),
                                  "AgaaFrame::background",
                                  [i](FrameParts& parts, double v) { parts.frame.background[i] = float(v); },
                                  {1e-30f, 1, 65504},
                                  notNumbers({-1e-20, -1, above(65504)})});
        for (int i = 0; i < 3; ++i)
            testFrameMember(rig, {"",
                                  elementText("AgaaFrame::background", i),
                                  "AgaaFrame::background",
                                  [i](FrameParts& parts, double v) { parts.frame.background[i] = float(v); },
                                  {0},
                                  {}});
    });
}

} // namespace

void addFrameRangeCases(Suite& suite) {
    suite.both("AgaaFrame.projection/range", testProjection);
    suite.both("AgaaFrame.projection/range/perspective", testPerspective);
    suite.both("AgaaFrame.view/range", testViewMatrix);
    addColors(suite);
    addExposure(suite);
}

} // namespace agaa::conformance
