#include "checks.h"

#include "engine_view.h"

#include <memory>
#include <sstream>

namespace agaa::conformance {

bool isComplete(const AgaaConformanceHost* host) {
    return host && host->structSize == sizeof *host && host->context && host->view && host->renderFrame &&
           host->api <= AGAA_CONFORMANCE_OPENGL;
}

namespace {

constexpr ViewChoice oneSample = {.technique = "single"};
constexpr ViewChoice allSamples = {.technique = "ssaa", .samples = 4};
constexpr ViewChoice twoPasses = {.technique = "agaa", .samples = 4};

// Of several surfaces of the image, some may differ for reasons of the engine's own, for example texture filters.
constexpr double largestShare = 0.05;

std::string figures(const AgaaFrameValidation& v) {
    std::ostringstream text;
    text << " (visible " << v.visible << ", uncovered " << v.uncovered << ", overlapping " << v.overlapping << ", misplaced "
         << v.misplaced << ")";
    return text.str();
}

// ---- pipelines and descriptor sets, without which nothing else can be judged ----------------------

void checkFrames(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaFrameValidation v = view.validate();
    if (!test.check(v.visible != 0, v.explanation))
        hostTest.blockedBy = "integration/frames";
}

// Two layouts have different shaders in the same pass: their images agree unless the pipelines of one serve the other.
void checkKeys(Test& test, HostTest& hostTest) {
    Image images[2];
    const char* layouts[2] = {"precise", "paper16"};
    for (int i = 0; i < 2; ++i) {
        ViewChoice choice = oneSample;
        choice.layout = layouts[i];
        images[i] = EngineView(test, hostTest, choice).renderAlbedo();
    }
    const double share = differingShare(images[0], images[1]);
    if (!test.check(share <= largestShare,
                    percent(share) + " of the image differ between two layouts. Usual cause: pipelines are kept by pass or by "
                                     "name. Keep them by AgaaDrawPass::pipelineKey."))
        hostTest.blockedBy = "integration/pipeline_keys";
}

// Views of equal configuration have equal keys and pipelines; what differs are their descriptor sets and framebuffers.
void checkSets(Test& test, HostTest& hostTest) {
    EngineView first(test, hostTest, twoPasses);
    const Image expected = first.renderAlbedo();
    first.renderAlbedo(); // the other frame in flight
    EngineView second(test, hostTest, twoPasses);
    const Image image = second.renderAlbedo();
    const double share = differingShare(expected, image, 0);
    const AgaaFrameValidation before = first.validate(), after = second.validate();
    if (!test.check(share == 0 && after.once == before.once,
                    percent(share) + " of the image differ between two views of the same configuration" + figures(after) +
                        ". Usual cause: the host binds the descriptor set or the framebuffer of an earlier view or frame. "
                        "Use AgaaDrawTarget::descriptorSet and AgaaDrawTarget::framebuffer of each callback."))
        hostTest.blockedBy = "integration/descriptor_sets";
}

// ---- what validation layers and debug output say ---------------------------------------------------

void checkMessages(Test& test, HostTest& hostTest) {
    if (!hostTest.host.takeMessages)
        test.skip("the host has no takeMessages.");
    hostTest.host.takeMessages(hostTest.host.user);
    for (const ViewChoice& choice : {oneSample, allSamples, twoPasses}) {
        EngineView(test, hostTest, choice).renderAlbedo();
        const char* messages = hostTest.host.takeMessages(hostTest.host.user);
        std::istringstream lines(messages ? messages : "");
        for (std::string line; std::getline(lines, line);) {
            const bool isHazard = line.find("SYNC-HAZARD") != std::string::npos;
            test.check(false, isHazard ? "A barrier of the host is missing: " + line : line);
        }
    }
}

// ---- geometry ----------------------------------------------------------------------------------------

void checkCamera(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaFrameValidation v = view.validate();
    if (!test.check(v.misplaced <= v.visible / 100, v.explanation + figures(v)))
        hostTest.blockedBy = "integration/camera";
}

AgaaFrameValidation validationOf(Test& test, HostTest& hostTest, const ViewChoice& choice) {
    EngineView view(test, hostTest, choice);
    view.renderAlbedo();
    return view.validate();
}

bool missesAll(const AgaaFrameValidation& v) { return v.uncovered > v.visible - v.visible / 1000; }
bool isCovered(const AgaaFrameValidation& v) { return v.uncovered == 0 && v.overlapping == 0; }

void checkSameGeometry(Test& test, HostTest& hostTest) {
    const AgaaFrameValidation v = validationOf(test, hostTest, twoPasses);
    if (missesAll(v) || isCovered(v))
        return; // the depth test's check, or nothing to find
    ViewChoice unmasked = twoPasses;
    unmasked.ignoresMasks = true;
    test.check(isCovered(validationOf(test, hostTest, unmasked)), v.explanation + figures(v)); // otherwise the masks' check
}

void checkAlphaMasks(Test& test, HostTest& hostTest) {
    const AgaaFrameValidation v = validationOf(test, hostTest, twoPasses);
    if (missesAll(v) || isCovered(v))
        return;
    ViewChoice unmasked = twoPasses;
    unmasked.ignoresMasks = true;
    test.check(!isCovered(validationOf(test, hostTest, unmasked)),
               "The geometry passes agree only without alpha masks" + figures(v) +
                   ". Usual causes: one pass discards and the other does not, AGAA_ALPHA_MASKED is not defined in all passes, "
                   "or alpha is not computed from the same values.");
}

// Images of the same samples by different passes.
struct Agreement {
    double twoPassesAgainstAll = 0;
    std::optional<double> forwardAgainstAll, forwardAgainstTwoPasses;
};

Agreement compareTechniques(Test& test, HostTest& hostTest) {
    Agreement agreement;
    const Image all = EngineView(test, hostTest, allSamples).renderAlbedo();
    const Image two = EngineView(test, hostTest, twoPasses).renderAlbedo();
    agreement.twoPassesAgainstAll = differingShare(two, all);
    try {
        const Image forward =
            EngineView(test, hostTest, {.technique = "msaa", .samples = 4}).renderAlbedo();
        agreement.forwardAgainstAll = differingShare(forward, all);
        agreement.forwardAgainstTwoPasses = differingShare(forward, two);
    } catch (const Skipped&) { // without "msaa" the two others decide
    }
    return agreement;
}

bool isGBufferAlone(const Agreement& a) {
    return a.twoPassesAgainstAll > largestShare && a.forwardAgainstTwoPasses.value_or(1) <= largestShare;
}

void checkDepthTest(Test& test, HostTest& hostTest) {
    const AgaaFrameValidation v = validationOf(test, hostTest, twoPasses);
    if (!test.check(!missesAll(v), "The material pass writes none of the visible samples" + figures(v) +
                                       ". Usual causes: the depth test is not AgaaDrawState::depthCompare, which is EQUAL "
                                       "there, or positions differ in the last bit (`invariant gl_Position`)."))
        return;
    const Agreement agreement = compareTechniques(test, hostTest);
    test.check(agreement.twoPassesAgainstAll <= largestShare || isGBufferAlone(agreement),
               percent(agreement.twoPassesAgainstAll) +
                   " of the image differ between \"agaa\" and \"ssaa\", although every sample is written once. Usual cause: the "
                   "depth test of the material pass is not AgaaDrawState::depthCompare, which is EQUAL there: hidden surfaces "
                   "show.");
}

// G-buffers mix fragments, while passes that write no attachment do not.
void checkBlending(Test& test, HostTest& hostTest) {
    const Agreement agreement = compareTechniques(test, hostTest);
    test.check(!isGBufferAlone(agreement),
               percent(agreement.twoPassesAgainstAll) +
                   " of the image of \"ssaa\" differ from \"agaa\" and \"msaa\", which agree. Usual cause: the G-buffer pass "
                   "mixes fragments: disable blending (unless AgaaDrawState::keepFirst), dithering, logic operations, "
                   "alpha-to-coverage and sRGB conversion.");
}

// Without the stencil test the second draw of a primitive ties with the first.
void checkDrawnOnce(Test& test, HostTest& hostTest) {
    ViewChoice choice = twoPasses;
    choice.isWithoutStencil = true;
    const AgaaFrameValidation v = validationOf(test, hostTest, choice);
    test.check(v.ties <= v.visible / 50,
               std::to_string(v.ties) + " sample writes were refused because an equal depth came first" + figures(v) +
                   ". Usual cause: the callback draws the same primitives more than once.");
}

// ---- materials -----------------------------------------------------------------------------------------

void checkNormals(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    const Image albedo = view.renderAlbedo(), headlight = view.renderHeadlight();
    size_t shown = 0, dark = 0;
    for (size_t i = 0; i < albedo.pixels.size(); i += 4) {
        const float a = albedo.pixels[i] + albedo.pixels[i + 1] + albedo.pixels[i + 2];
        const float h = headlight.pixels[i] + headlight.pixels[i + 1] + headlight.pixels[i + 2];
        shown += a > 0.01f;
        dark += a > 0.01f && h < 0.02f * a;
    }
    test.require(shown > 0, "Nothing is brighter than 0.01 in ambient light of 1: the albedo of all surfaces is black.");
    test.check(dark * 2 <= shown, percent(double(dark) / double(shown)) +
                                      " of the visible pixels are dark in a light that shines from the camera. Usual cause: "
                                      "AgaaSurfaceInput::normal points away from the eye, or is not in shading space.");
}

void checkFinite(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaCounters counters = view.counters();
    test.check(counters.sanitised == 0, std::to_string(counters.sanitised) +
                                            " fragments have an attribute that is not finite. Usual causes: normals of length "
                                            "0 that are normalised, or roughness and colours that are computed by a division.");
}

void checkRepeats(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, twoPasses);
    const Image first = view.renderAlbedo(), second = view.renderAlbedo();
    test.check(differingShare(first, second, 0) == 0,
               "Two frames of the same scene differ. Usual causes: the scene moves, or a buffer of the host is not initialised.");
}

} // namespace

Suite makeHostChecks(const AgaaConformanceHost& host, const Functions& functions) {
    // In this order: the mistakes that spoil all else come first.
    const std::pair<const char*, void (*)(Test&, HostTest&)> checks[] = {
        {"frames", checkFrames},       {"pipeline_keys", checkKeys},  {"descriptor_sets", checkSets},
        {"messages", checkMessages},   {"camera", checkCamera},       {"depth_test", checkDepthTest},
        {"same_geometry", checkSameGeometry}, {"alpha_masks", checkAlphaMasks}, {"blending", checkBlending},
        {"drawn_once", checkDrawnOnce}, {"normals", checkNormals},    {"finite_attributes", checkFinite},
        {"repeated_frames", checkRepeats}};
    auto hostTest = std::make_shared<HostTest>(HostTest{host, functions});
    Suite suite;
    for (const auto& [name, check] : checks)
        suite.add(std::string("integration/") + name, {Backend::Host}, [hostTest, check = check](Test& test) {
            if (!hostTest->blockedBy.empty())
                test.skip("it cannot be judged while " + hostTest->blockedBy + " fails.");
            check(test, *hostTest);
        });
    return suite;
}

} // namespace agaa::conformance
