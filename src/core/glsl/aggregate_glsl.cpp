#include "core/glsl/aggregate_glsl.h"

#include "core/base/error.h"
#include "core/base/glsl_number.h"
#include "core/glsl/glsl_text.h"
#include "core/view/custom_glsl.h"

#include <set>

namespace agaa {

std::string aggregateGlsl(const Plan& plan) {
    const Pass* shade = nullptr;
    for (const Pass& pass : plan.passes)
        if (pass.kind() == PassKind::Compute && pass.compute().shadesAggregates)
            shade = &pass;
    // Surfaces of "sbaa" have records in addition to their words. Aggregates in attachments have no words.
    const auto isSummed = [](const Constants& c) {
        return c[AGAA_STRIDE] && c[AGAA_STRIDE] == c[AGAA_WORDS] + c[AGAA_SPREAD_WORDS] + c[AGAA_DEPTH_WORDS];
    };
    require(shade && isSummed(shade->constants), AGAA_ERROR_UNSUPPORTED,
            "the view leaves no aggregates in memory: it is not of \"agaa\" by two passes, and not of the tiers ids "
            "or gbuffer with AGAA_CONFIG_BUFFERED; the tier nv-mixed-samples leaves them in attachments.");
    require(!shade->constants[AGAA_PREPASS_NORMALS], AGAA_ERROR_UNSUPPORTED,
            "the aggregates keep no normals, because the view has AGAA_FACT_PLANE_NORMALS and "
            "AGAA_FACT_NO_LOCAL_LIGHTS, and no "
            "AGAA_FACT_SPECULAR.");
    std::string out;
#define AGAA_CONSTANT(id, name, value) out += format("#define %s %uu\n", #name, shade->constants[name]);
#include "shaders/tables/constants.inc"
#undef AGAA_CONSTANT
    out += format("#define AGAA_REPRESENTED 0\n#ifndef AGAA_IMAGE_WIDTH\n#define AGAA_IMAGE_WIDTH %uu\n#endif\n"
                  "#define AGAA_EMISSIVE_RANGE %s\n",
                  plan.view.width, glslNumber(plan.view.layout.emissiveRange()).c_str());
    out += customGlsl(plan.view.layout);
    std::set<std::string> seen;
    appendGlsl(out, "host/read_aggregate.glsl", seen);
    return out;
}

} // namespace agaa
