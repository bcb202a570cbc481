#include "geometry_checks.h"

#include "findings.h"

namespace agaa::conformance {

// Counts do not distinguish a mirrored image from another projection, so the sentence states what the user can compare
// with the image.
void checkCamera(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaFrameValidation v = view.validate();
    const std::string up = std::string(" This projection places what is above the camera at ") +
                           (view.projection()[5] < 0 ? "row 0" : "the last row") + " of the output.";
    if (!test.check(v.misplaced <= v.visible / 100, v.explanation + figures(v) + up))
        hostTest.blockedBy = "integration/camera";
}

// Returns the findings. Skips the test if the engine has no two geometry passes.
static const Findings& findingsOfTwoPasses(Test& test, HostTest& hostTest) {
    const Findings& found = findingsOf(test, hostTest);
    if (found.passes < 2)
        test.skip("\"agaa\" has one geometry pass here, and no other can disagree.");
    return found;
}

void checkDepthTest(Test& test, HostTest& hostTest) {
    const Findings& found = findingsOfTwoPasses(test, hostTest);
    if (!test.check(!found.missesAll(),
                    "The material pass writes none of the visible samples" + figures(found.twoPasses) +
                        ". Usual causes: the depth test is not AgaaDrawState::depthCompare, which is EQUAL "
                        "there, or positions differ in the last bit (`invariant gl_Position`)."))
        return;
    if (!found.isCovered())
        test.skip("it cannot be judged while the passes draw other geometry or other masks.");
    const double share = found.twoPassesAgainstGBuffer;
    if (!test.check(share <= maxDifferingShare || found.isWrittenOnce(),
                    percent(share) +
                        " of the image differ between \"agaa\" and \"ssaa\", and without the stencil test " +
                        std::to_string(found.ties) +
                        " samples are written again. Usual cause: the depth test of the material pass is not "
                        "AgaaDrawState::depthCompare, which is EQUAL there: hidden surfaces show."))
        return;
    if (share <= maxDifferingShare && found.forwardAgainstGBuffer)
        test.check(*found.forwardAgainstGBuffer <= maxDifferingShare,
                   percent(*found.forwardAgainstGBuffer) +
                       " of the image differ between \"msaa\" and \"ssaa\". Usual cause: the depth test of the forward "
                       "pass is "
                       "not AgaaDrawState::depthCompare, which is EQUAL there, or its keepFirst is not followed.");
}

void checkSameGeometry(Test& test, HostTest& hostTest) {
    const Findings& found = findingsOfTwoPasses(test, hostTest);
    if (found.missesAll() || found.isColorless())
        test.skip("it cannot be judged while integration/depth_test or integration/blending fails.");
    if (found.isCovered())
        return; // the passes agree
    const bool areMasks = found.twoPassesUnmasked && Findings::isCovered(*found.twoPassesUnmasked);
    test.check(areMasks, found.twoPasses.explanation + figures(found.twoPasses)); // or alpha_masks reports it
}

void checkAlphaMasks(Test& test, HostTest& hostTest) {
    if (!hostTest.host.hideMasked)
        test.skip("the host has no hideMasked.");
    const Findings& found = findingsOfTwoPasses(test, hostTest);
    if (found.missesAll() || found.isColorless())
        test.skip("it cannot be judged while integration/depth_test or integration/blending fails.");
    if (found.isCovered())
        return; // the passes agree
    test.check(
        !Findings::isCovered(*found.twoPassesUnmasked),
        "The geometry passes agree only without alpha-masked objects" + figures(found.twoPasses) +
            ". Usual causes: one pass discards and the other does not, AGAA_ALPHA_MASKED is not defined in all passes, "
            "or alpha is not computed from the same values.");
}

// The attachments of G-buffers and of the prepass hold no colours, so blended fragments corrupt them. The material pass
// of "agaa" has no attachments.
void checkBlending(Test& test, HostTest& hostTest) {
    const Findings& found = findingsOf(test, hostTest);
    const std::string causes =
        " Usual cause: the attachments mix fragments: disable blending (unless AgaaDrawState::keepFirst), "
        "dithering, logic operations, alpha-to-coverage and sRGB conversion.";
    bool isRight = true;
    if (found.isColorless())
        isRight = test.check(false, "The prepass of \"agaa\" writes depth and leaves its attachment as it was" +
                                        figures(found.twoPasses) + "." + causes);
    else if (found.isCovered() && found.isWrittenOnce()) // otherwise the error is in "agaa"
        isRight = test.check(found.twoPassesAgainstGBuffer <= maxDifferingShare,
                             percent(found.twoPassesAgainstGBuffer) +
                                 " of the image of \"ssaa\" differ from \"agaa\", whose passes agree." + causes);
    if (!isRight)
        hostTest.blockedBy = "integration/blending"; // the materials are corrupt
}

// Without the stencil test, a second draw of a primitive ties with the first one. Surfaces of the scene may also tie,
// but they remain visible.
void checkDrawnOnce(Test& test, HostTest& hostTest) {
    const Findings& found = findingsOfTwoPasses(test, hostTest);
    if (!found.isCovered() || found.twoPassesAgainstGBuffer > maxDifferingShare)
        test.skip("it cannot be judged while another check fails: hidden surfaces tie, too.");
    test.check(found.isWrittenOnce(),
               std::to_string(found.ties) + " sample writes were refused because an equal depth came first" +
                   figures(found.twoPasses) + ". Usual cause: the callback draws the same primitives more than once.");
}

} // namespace agaa::conformance
