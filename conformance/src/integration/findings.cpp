#include "findings.h"

#include <sstream>

namespace agaa::conformance {

namespace {

// The engine leaves out alpha-masked objects during the lifetime of this object.
class HiddenMasks {
public:
    explicit HiddenMasks(const AgaaConformanceHost& host) : host_(host) { host_.hideMasked(host_.user, 1); }
    ~HiddenMasks() { host_.hideMasked(host_.user, 0); }
    HiddenMasks(const HiddenMasks&) = delete;
    HiddenMasks& operator=(const HiddenMasks&) = delete;

private:
    const AgaaConformanceHost& host_;
};

AgaaFrameValidation validationOf(Test& test, HostTest& hostTest, const ViewChoice& choice) {
    EngineView view(test, hostTest, choice);
    view.renderAlbedo();
    return view.validate();
}

} // namespace

const Findings& findingsOf(Test& test, HostTest& hostTest) {
    if (hostTest.findings)
        return *hostTest.findings;
    auto found = std::make_shared<Findings>();
    const Image gBuffer = EngineView(test, hostTest, allSamples).renderAlbedo();
    {
        EngineView view(test, hostTest, twoPasses);
        found->twoPassesAgainstGBuffer = differingShare(view.renderAlbedo(), gBuffer);
        found->twoPasses = view.validate();
        found->passes = view.drawPasses();
    }
    if (!found->isCovered() && hostTest.host.hideMasked) {
        const HiddenMasks hidden(hostTest.host);
        found->twoPassesUnmasked = validationOf(test, hostTest, twoPasses);
    }
    ViewChoice withoutStencil = twoPasses;
    withoutStencil.isWithoutStencil = true;
    found->ties = validationOf(test, hostTest, withoutStencil).ties;
    try {
        const Image forward = EngineView(test, hostTest, {.technique = "msaa", .samples = 4}).renderAlbedo();
        found->forwardAgainstGBuffer = differingShare(forward, gBuffer);
    } catch (const Skipped&) { // the checks do not need "msaa"
    }
    hostTest.findings = found;
    return *hostTest.findings;
}

std::string figures(const AgaaFrameValidation& v) {
    std::ostringstream text;
    text << " (visible " << v.visible << ", uncovered " << v.uncovered << ", overlapping " << v.overlapping
         << ", misplaced " << v.misplaced << ")";
    return text.str();
}

} // namespace agaa::conformance
