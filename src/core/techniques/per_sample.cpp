// `single` and `ssaa`: a G-buffer at n samples, every covered sample shaded. Materials are evaluated once
// per fragment, lighting once per sample, as multisampled deferred engines do.
#include "core/techniques/gbuffer.h"
#include "core/techniques/techniques.h"

namespace agaa {

static void build(PlanBuilder& b) {
    const GBuffer gbuffer = drawGBuffer(b);
    Pass& shade = b.compute("shade samples", AGAA_STAGE_SHADING, "shade_samples", "mscb",
                            AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    gbuffer.bind(b, shade);
    b.copyCounters();
}

const Technique singleTechnique = {"single", false, false, build};
const Technique ssaaTechnique = {"ssaa", false, true, build};

} // namespace agaa
