#include "core/reports/frame_validation.h"

#include "core/base/error.h"
#include "core/reports/frame_statistics.h"

#include <algorithm>
#include <cstring>

namespace agaa {

// Some fragments of slivers lie outside their primitives. A wrong camera displaces nearly all fragments.
static bool isMisplaced(const AgaaFrameValidation& v) { return v.misplaced > v.visible / 100; }

// The cause on OpenGL that the image does not show: the draws are not executed at all.
static constexpr const char* failedDraws =
    "on OpenGL its draws failed (glGetError; an engine that sets every sampler and image uniform overrides "
    "layout(binding))";

static bool isDraw(const Pass& pass) { return pass.kind() == PassKind::HostDraw; }

// Returns the name of the draw pass that decides what is visible.
static const char* nameOfVisiblePass(const Plan& plan) {
    const auto listsFragments = [](const Pass& pass) {
        return isDraw(pass) && pass.draw().id == AGAA_DRAW_PASS_FRAGMENTS;
    };
    auto found = std::ranges::find_if(plan.passes, listsFragments);
    if (found == plan.passes.end())
        found = std::ranges::find_if(plan.passes, isDraw);
    return found == plan.passes.end() ? "" : found->name.c_str();
}

// Returns the name of the draw pass that writes what another one shows.
static const char* nameOfLastDrawPass(const Plan& plan) {
    const auto found = std::find_if(plan.passes.rbegin(), plan.passes.rend(), isDraw);
    return found == plan.passes.rend() ? "" : found->name.c_str();
}

// Returns the most basic mistake that was found and its usual causes.
static std::string explain(const AgaaFrameValidation& v, const Plan& plan) {
    const uint32_t geometryPasses = plan.geometryPasses();
    if (v.visible == 0 && geometryPasses == 0)
        return "Nothing is visible: the host's functions, agaaHostSample or agaaHostDraw and agaaHostTriangle, provide "
               "no geometry in the view. Usual causes: their resources are not those of the frame, or were not "
               "readable by compute yet.";
    if (v.visible == 0)
        return format("Nothing is visible: the draw pass \"%s\" produced no fragment in the target. Usual causes: "
                      "framebuffer, viewport or projection are not those of the pass, the depth test is not that of "
                      "AgaaDrawState, AGAA_VIEW_REVERSED_Z does not fit the projection, or %s.",
                      nameOfVisiblePass(plan), failedDraws);
    if (isMisplaced(v))
        return "Fragments do not lie where AgaaFrame's camera puts AgaaSurfaceInput::position. Usual causes: "
               "AgaaFrame::projection is not the rasteriser's (direction of y, clip correction, "
               "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE), positions are not relative to the eye, or another viewport "
               "or view matrix was drawn with.";
    if (v.unannounced)
        return "Fragments have a draw or primitive that AgaaFetchFunction did not announce, and show the last that it "
               "did, or primitives beyond what it announced were not drawn. Usual causes: more draws or instances than "
               "maxDraws, an object of more primitives than "
               "maxPrimitives, AgaaSurfaceInput::draw that does not start at 0, or AGAA_UNFETCHED without "
               "AGAA_FETCH_NOT_ALL_DRAWS.";
    if (v.uncovered && v.overlapping)
        return "Samples were missed and others written where they are not visible. Usual causes: the passes "
               "do not compute the same position (one expression and `invariant gl_Position` in both), or "
               "draw different objects, instances or animation states.";
    if (v.uncovered == v.visible)
        return format("The draw pass \"%s\" wrote none of the visible samples. Usual causes: positions differ in the "
                      "last bit (`invariant gl_Position`, one expression in both passes), the depth test is not EQUAL, "
                      "cull modes differ, the material is discarded, or %s.",
                      nameOfLastDrawPass(plan), failedDraws);
    if (v.uncovered)
        return "Samples that the prepass shows were never written. Usual causes: an object is left out of "
               "the material pass, positions differ in the last bit (`invariant gl_Position`, one expression "
               "in both passes), the depth test is not EQUAL, cull modes differ, or an alpha mask is not "
               "computed from the same values in both passes.";
    if (v.overlapping)
        return "Samples were written twice or where nothing is visible. Usual causes: objects are drawn that "
               "the prepass left out with the depth test off, or an alpha mask differs between the passes.";
    if (geometryPasses == 0)
        return "Every sample that agaaHostSample shows was accumulated exactly once. Whether its depth fits "
               "AgaaFrame's "
               "camera cannot be told.";
    if (geometryPasses == 1)
        return "Every visible sample was written exactly once, by the only geometry pass: there is no other that "
               "it could disagree with. Its fragments lie where AgaaFrame's camera puts them.";
    return "Every visible sample was written exactly once. What this cannot show is a depth test other than "
           "EQUAL in the material pass: then the image differs from that of \"ssaa\".";
}

AgaaResult frameValidation(const ViewState& view, uint64_t completedFrame, AgaaFrameValidation& out) {
    const Plan& plan = view.plan;
    require(plan.view.config.flags & AGAA_CONFIG_COUNTERS, AGAA_ERROR_WRONG_ORDER,
            "the view was created without AGAA_CONFIG_COUNTERS.");
    const FrameSequence::Slot* newest = view.finished(completedFrame);
    if (!newest)
        return AGAA_NOT_READY;
    const CounterBuffer buffer = view.readCounters(view.sequence.indexOf(*newest));
    const AgaaCounters counters = countersOf(buffer);
    out.frameIndex = newest->frame;
    out.visible = counters.visible;
    out.once = counters.once;
    out.uncovered = counters.uncovered;
    out.overlapping = counters.overlapping;
    out.ties = counters.ties;
    out.misplaced = counters.misplaced;
    out.unannounced = counters.unannounced;
    out.invalidPixels = buffer.invalidPixels;
    out.isValid =
        out.visible != 0 && out.uncovered == 0 && out.overlapping == 0 && out.unannounced == 0 && !isMisplaced(out);
    out.pixelCount = std::min<uint32_t>(buffer.invalidPixels, AGAA_MAX_INVALID_PIXELS);
    for (uint32_t i = 0; i < AGAA_MAX_INVALID_PIXELS; ++i) {
        out.pixels[i] = {};
        if (i < out.pixelCount)
            std::memcpy(&out.pixels[i], buffer.pixels[i], sizeof buffer.pixels[i]);
    }
    std::strncpy(out.explanation, explain(out, plan).c_str(), sizeof out.explanation - 1);
    out.explanation[sizeof out.explanation - 1] = 0;
    return AGAA_OK;
}

} // namespace agaa
