// `single` and `ssaa`: a G-buffer at n samples, every covered sample shaded. Materials are evaluated once
// per fragment, lighting once per sample, as multisampled deferred engines do.
#include "core/techniques/techniques.h"

#include <algorithm>

namespace agaa {

static void build(PlanBuilder& b) {
    const GBufferPacking packing = packGBuffer(b.plan.layout);
    const ResourceId depth = b.depth(false);
    std::vector<ResourceId> attachments;
    for (size_t i = 0; i < packing.attachments.size(); ++i)
        attachments.push_back(
            b.image("gbuffer-" + std::to_string(i), packing.attachments[i], true));

    Pass& draw = b.hostDraw("gbuffer", AGAA_STAGE_GENERATION, AGAA_DRAW_PASS_GBUFFER,
                            AGAA_SEGMENT_PREPASS);
    b.bindCommon(draw);
    draw.drawState.depthCompare = b.plan.reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    draw.drawState.depthWrite = 1;
    draw.drawState.colorAttachmentCount = uint32_t(attachments.size());
    draw.colorTargets = attachments;
    draw.depthTarget = depth;
    draw.clear = true;
    setFields(draw.constants, packing.fields);

    Pass& shade = b.compute("shade samples", AGAA_STAGE_SHADING, "shade_samples", "mscb",
                            AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bind(shade, slot::Depth, BindingType::Texture, depth);
    // The shader names four attachments; slots beyond the layout's repeat the last and are not used.
    for (uint32_t i = 0; i < 4; ++i)
        b.bind(shade, slot::Surface0 + i, BindingType::Texture,
               attachments[std::min<size_t>(i, attachments.size() - 1)]);
    setFields(shade.constants, packing.fields);
    b.copyCounters();
}

const Technique singleTechnique = {"single", false, false, build};
const Technique ssaaTechnique = {"ssaa", false, true, build};

} // namespace agaa
