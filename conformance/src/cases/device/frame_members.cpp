#include "frame_members.h"

#include <cmath>

namespace agaa::conformance {

FrameParts::FrameParts(const Rig& rig) : frame(rig.nextFrame()) {
    const AgaaLight light = AGAA_LIGHT_INIT;
    const AgaaShadow shadow = AGAA_SHADOW_INIT;
    for (int i = 0; i < 2; ++i) {
        lights[i] = light;
        shadows[i] = shadow;
    }
}

namespace {

// "single" has the fewest pipelines.
void allowLights(ViewDescription& description) {
    setTechnique(description, "single", 1);
    description.facts.maxLights = 4;
    description.facts.shadowMapCount = 2;
}

void expectFinite(Test& test, const Image& image, const std::string& what) {
    for (const float value : image)
        if (!test.check(std::isfinite(value), what + " gives an output that is not finite."))
            return;
}

void accept(Rig& rig, const FrameMember& row, double value) {
    FrameParts parts(rig);
    row.set(parts, value);
    const std::string what = rig.function() + " with " + row.member + " = " + numberText(value);
    rig.context.log.lines.clear();
    const AgaaResult result = rig.record(parts.frame);
    const std::vector<LogLine> errors = rig.context.log.errors();
    rig.test.result(result, AGAA_OK, what + (errors.empty() ? "" : " (\"" + errors[0].text + "\")"));
    rig.expectNoMessages(what);
    expectFinite(rig.test, rig.device().readOutput(), what);
}

void refuse(MemberRig& rig, const FrameMember& row, double value) {
    FrameParts parts(rig);
    row.set(parts, value);
    const std::string what = rig.function() + " with " + row.member + " = " + numberText(value);
    expectFrameRefused(rig, parts.frame, {row.error, what, row.words}, rig.expected);
}

} // namespace

MemberRig::MemberRig(Test& test) : Rig(test, allowLights), expected(render()) {}

void testFrameMember(MemberRig& rig, const FrameMember& row) {
    for (const double value : row.accepted)
        accept(rig, row, value);
    for (const double value : row.refused)
        refuse(rig, row, value);
    if (isSameVersion(rig.test))
        for (const double value : row.refusedToday)
            refuse(rig, row, value);
}

void addFrameMembers(Suite& suite, const std::string& promise, const std::vector<FrameMember>& rows) {
    suite.both(promise, [rows](Test& test) {
        MemberRig rig(test);
        for (const FrameMember& row : rows)
            testFrameMember(rig, row);
    });
}

void addFrameMember(Suite& suite, const FrameMember& row) { addFrameMembers(suite, row.promise, {row}); }

} // namespace agaa::conformance
