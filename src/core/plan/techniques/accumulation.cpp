// `taa`, and the accumulation of other techniques' images.
#include "core/plan/techniques/accumulation.h"

#include "core/base/arguments.h"
#include "core/base/names.h"
#include "core/base/structs.h"
#include "core/plan/techniques/per_sample.h"
#include "core/plan/techniques/techniques.h"
#include "core/view/custom_glsl.h"

#include <algorithm>
#include <bit>

namespace agaa {

namespace {

void readTemporal(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaTemporal> chained = readChained<AgaaTemporal>(&config);
    if (!chained)
        return;
    AgaaTemporal& t = view.temporal = *chained;
    t.pNext = nullptr;
    checkFlags(t.flags, AGAA_TEMPORAL_LAST_FRAME_ONLY, "AgaaTemporal::flags");
    checkRange(double(t.currentShare), double(0.001f), 1.0, "AgaaTemporal::currentShare");
    checkRange(double(t.clipDeviations), 0.0, 1e6, "AgaaTemporal::clipDeviations");
    checkRange(double(t.depthTolerance), 0.0, 1e6, "AgaaTemporal::depthTolerance");
    checkReserved(t.reserved, "AgaaTemporal::reserved");
    require(!t.motion || *t.motion, AGAA_ERROR_LAYOUT, "AgaaTemporal::motion is an empty name.");
    if (t.motion)
        view.motionAttribute = t.motion;
    t.motion = nullptr; // the host's pointer does not outlive the call
}

// Returns the first channel of the attribute with motion vectors.
uint32_t motionChannel(const ResolvedView& view) {
    uint32_t channel = ChannelCustom0;
    for (const CustomAttribute& custom : view.layout.customs) {
        const AgaaLayoutAttribute& a = custom.attribute;
        if (custom.name == view.motionAttribute) {
            require(a.channels == 2 && a.sampleBits == 16 && a.range == 1.0f, AGAA_ERROR_LAYOUT,
                    "AgaaTemporal::motion names an attribute without 2 channels of 16 bits and range 1.");
            return channel;
        }
        channel += a.channels;
    }
    fail(AGAA_ERROR_LAYOUT,
         format("AgaaTemporal::motion is \"%s\", and no custom attribute of the layout has this name.",
                printable(view.motionAttribute).c_str()));
}

void bindMotion(PlanBuilder& b, Pass& pass) {
    const uint32_t channel = motionChannel(b.view());
    if (b.view().hostGBuffer) {
        pass.compute().defines += "#define AGAA_MOTION_MEMBER " + b.view().motionAttribute + "\n";
        return;
    }
    if (b.sceneAttachments.empty())
        fail(AGAA_ERROR_UNSUPPORTED,
             format("AgaaTemporal::motion needs a G-buffer of all draws, which \"%s\" has not with "
                    "these settings; leave it null, or select the tier GBUFFER.",
                    b.view().technique->name));
    const Fields fields = packGBuffer(b.view().layout).fields;
    const Field &x = fields[channel], &y = fields[channel + 1];
    b.bind(pass, slot::MotionX, BindingType::Texture, b.sceneAttachments[x.word]);
    b.bind(pass, slot::MotionY, BindingType::Texture, b.sceneAttachments[y.word]);
    pass.constants[AGAA_MOTION_X] = x.shift;
    pass.constants[AGAA_MOTION_Y] = y.shift;
}

void bindDepth(PlanBuilder& b, Pass& pass) {
    if (b.view().hostGBuffer)
        return b.bindHostGBuffer(pass);
    if (b.sceneDepth == noResource)
        fail(AGAA_ERROR_UNSUPPORTED,
             format("frames of \"%s\" cannot be accumulated with these settings, because it has no depth buffer.",
                    b.view().technique->name));
    b.bind(pass, slot::Depth, BindingType::Texture, b.sceneDepth);
}

constexpr uint32_t historyHeaderWords = 2, historyPixelWords = 3; // of accumulate.comp

void resolveTaa(ResolvedView& view) {
    if (view.measurement.debugView == AGAA_DEBUG_VIEW_NONE)
        view.config.flags |= AGAA_CONFIG_ACCUMULATE;
}

} // namespace

void accumulateFrames(PlanBuilder& b) {
    const AgaaTemporal& settings = b.view().temporal;
    const bool hasMotion = !b.view().motionAttribute.empty();
    Pass& pass =
        b.compute("accumulate", AGAA_STAGE_OTHER, "accumulate", AGAA_SEGMENT_SHADING, {{Switch::Motion, hasMotion}});
    b.bindCommon(pass);
    b.bind(pass, slot::Color, BindingType::Texture, b.techniqueImage());
    bindDepth(b, pass);
    if (hasMotion)
        bindMotion(b, pass);
    const uint64_t pixels = uint64_t(b.view().width) * b.view().height;
    const ResourceId history = b.itemBuffer("history", 2 * historyPixelWords * pixels + historyHeaderWords, 4);
    b.plan.resources[history].isPersistent = true;
    b.bind(pass, slot::History, BindingType::StorageBuffer, history, true);
    b.bind(pass, slot::Output, BindingType::StorageImage, b.output(), true);
    pass.constants[AGAA_CURRENT_SHARE] =
        std::bit_cast<uint32_t>(settings.flags & AGAA_TEMPORAL_LAST_FRAME_ONLY ? 0.5f : settings.currentShare);
    pass.constants[AGAA_CLIP_DEVIATIONS] = std::bit_cast<uint32_t>(settings.clipDeviations);
    pass.constants[AGAA_DEPTH_TOLERANCE] = std::bit_cast<uint32_t>(settings.depthTolerance);
    pass.constants[AGAA_LAST_FRAME_ONLY] = (settings.flags & AGAA_TEMPORAL_LAST_FRAME_ONLY) != 0;
}

const TechniqueSettings temporalSettings = {.sType = AGAA_STRUCTURE_TYPE_TEMPORAL, .read = readTemporal};
static constexpr const TechniqueSettings* settings[] = {&temporalSettings};
const Technique taaTechnique = {.name = "taa",
                                .maxSamples = 1,
                                .settings = settings,
                                .build = buildPerSample,
                                .work = workOfSamples,
                                .resolve = resolveTaa};

} // namespace agaa
