#include "checks.h"

#include "findings.h"
#include "geometry_checks.h"

#include <algorithm>
#include <sstream>

namespace agaa::conformance {

namespace {

// Returns whether the view has sample positions, which the engine cannot provide for a number of samples that the suite
// chooses.
bool hasSamplePositions(const AgaaViewDesc& view) {
    for (const auto* link = static_cast<const AgaaStructHeader*>(view.pNext); link;
         link = static_cast<const AgaaStructHeader*>(link->pNext))
        if (link->sType == AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION &&
            reinterpret_cast<const AgaaGBufferFunction*>(link)->samplePositions)
            return true;
    return false;
}

} // namespace

bool isComplete(const AgaaConformanceHost* host) {
    return host && host->structSize == sizeof *host && host->context && host->view && host->renderFrame &&
           host->api <= AGAA_CONFORMANCE_OPENGL && !hasSamplePositions(*host->view);
}

namespace {

// ---- pipelines and descriptor sets, without which nothing else can be judged ----------------------

void checkFrames(Test& test, HostTest& hostTest) {
    hostTest.blockedBy = "integration/frames"; // blocks other checks until a frame succeeds
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaFrameValidation v = view.validate();
    if (test.check(v.visible != 0, v.explanation))
        hostTest.blockedBy.clear();
}

// Checks compare images of different frames.
void checkRepeats(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    const Image first = view.renderAlbedo(), second = view.renderAlbedo(), third = view.renderAlbedo();
    const double share = std::max(differingShare(first, second, 0), differingShare(first, third, 0));
    if (!test.check(share == 0,
                    percent(share) +
                        " of the image differ between frames of the same scene. Usual causes: the scene moves, or "
                        "a buffer of the host is not initialised."))
        hostTest.blockedBy = "integration/repeated_frames";
}

// Two layouts have different shaders in the same pass. Their images agree unless the engine uses the pipelines of one
// for the other. The material pass of "agaa" has no attachments, so blending does not affect it. The smaller layout
// comes first, because its shaders do not write beyond the surfaces of the other. Both views exist at the same time,
// because an engine may release objects with their view.
void checkKeys(Test& test, HostTest& hostTest) {
    ViewChoice choice = twoPasses;
    choice.layout = "paper16";
    EngineView first(test, hostTest, choice);
    choice.layout = "precise";
    EngineView second(test, hostTest, choice);
    const double share = differingShare(first.renderAlbedo(), second.renderAlbedo());
    if (!test.check(share <= maxDifferingShare,
                    percent(share) +
                        " of the image differ between two layouts. Usual cause: pipelines are kept by pass or by "
                        "name. Keep them by AgaaDrawPass::pipelineKey."))
        hostTest.blockedBy = "integration/pipeline_keys";
}

// Views of equal configuration have equal keys and pipelines. Their descriptor sets and framebuffers differ.
void checkSets(Test& test, HostTest& hostTest) {
    EngineView first(test, hostTest, twoPasses);
    const Image expected = first.renderAlbedo();
    first.renderAlbedo(); // uses the other frame in flight
    EngineView second(test, hostTest, twoPasses);
    const Image image = second.renderAlbedo();
    const double share = differingShare(expected, image, 0);
    const AgaaFrameValidation before = first.validate(), after = second.validate();
    if (!test.check(
            share == 0 && after.once == before.once,
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
    test.require(shown > 0,
                 "Nothing is brighter than 0.01 in ambient light of 1: the albedo of all surfaces is black.");
    test.check(dark * 2 <= shown,
               percent(double(dark) / double(shown)) +
                   " of the visible pixels are dark in a light that shines from the camera. Usual cause: "
                   "AgaaSurfaceInput::normal points away from the eye, or is not in shading space.");
}

void checkFinite(Test& test, HostTest& hostTest) {
    EngineView view(test, hostTest, oneSample);
    view.renderAlbedo();
    const AgaaCounters counters = view.counters();
    test.check(counters.sanitised == 0,
               std::to_string(counters.sanitised) +
                   " fragments have an attribute that is not finite. Usual causes: normals of length "
                   "0 that are normalised, or roughness and colours that are computed by a division.");
}

} // namespace

Suite makeHostChecks(const AgaaConformanceHost& host, const Functions& functions) {
    // Mistakes that affect all other checks come first.
    const struct {
        const char* name;
        void (*check)(Test&, HostTest&);
    } checks[] = {
        {"frames", checkFrames},           {"repeated_frames", checkRepeats},    {"pipeline_keys", checkKeys},
        {"descriptor_sets", checkSets},    {"messages", checkMessages},          {"camera", checkCamera},
        {"depth_test", checkDepthTest},    {"same_geometry", checkSameGeometry}, {"alpha_masks", checkAlphaMasks},
        {"blending", checkBlending},       {"drawn_once", checkDrawnOnce},       {"normals", checkNormals},
        {"finite_attributes", checkFinite}};
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
