// `adaptive`: a G-buffer at n samples, one of which is shaded in each pixel, and further ones where geometry or shading say so
// (Hollaender et al., "Adaptive Supersampling for Deferred Anti-Aliasing", JCGT 2013).
#include "core/error.h"
#include "core/sample_order.h"
#include "core/structs.h"
#include "core/techniques/gbuffer.h"
#include "core/techniques/techniques.h"
#include "core/validate.h"

#include <bit>

namespace agaa {

namespace {

void readAdaptive(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaAdaptiveSampling> chained = readChained<AgaaAdaptiveSampling>(&config);
    if (!chained)
        return;
    const AgaaAdaptiveSampling& a = view.adaptive = *chained;
    view.adaptive.pNext = nullptr;
    checkFlags(a.flags,
               AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING | AGAA_ADAPTIVE_PRINTED_METRIC | AGAA_ADAPTIVE_IN_ORDER |
                   AGAA_ADAPTIVE_EQUAL_WEIGHTS | AGAA_ADAPTIVE_LOOP | AGAA_ADAPTIVE_DEVICE_PATTERN,
               "AgaaAdaptiveSampling::flags");
    checkRange(double(a.depthScale), 0.0, 1e12, "AgaaAdaptiveSampling::depthScale");
    checkRange(double(a.normalScale), 0.0, 1e6, "AgaaAdaptiveSampling::normalScale");
    checkRange(double(a.shadingScale), 0.0, 1e6, "AgaaAdaptiveSampling::shadingScale");
    checkRange(double(a.shadingThreshold), 0.0, 1.0, "AgaaAdaptiveSampling::shadingThreshold");
    checkRange(double(a.shadingMinimum), 0.0, 1.0, "AgaaAdaptiveSampling::shadingMinimum");
    checkRange(double(a.glossWeight), 0.0, 16.0, "AgaaAdaptiveSampling::glossWeight");
    checkReserved(a.reserved, "AgaaAdaptiveSampling::reserved");
}

void setOrder(Constants& constants, const Plan& plan) {
    const std::vector<uint32_t> order = sampleOrder(positionsOf(plan));
    for (size_t j = 0; j < order.size(); ++j)
        constants[AGAA_ORDER0 + j / 4] |= order[j] << 8 * (j % 4);
}

Pass& addPass(PlanBuilder& b, const char* name, const char* shader, const GBuffer& gbuffer) {
    Pass& pass = b.compute(name, AGAA_STAGE_SHADING, shader, AGAA_SEGMENT_SHADING);
    b.bindCommon(pass);
    b.bindLighting(pass);
    gbuffer.bind(b, pass);
    const AgaaAdaptiveSampling& a = b.plan.adaptive;
    Constants& c = pass.constants;
    c[AGAA_ADAPTIVE_FLAGS] = uint32_t(a.flags);
    c[AGAA_GLOSS_WEIGHT] = std::bit_cast<uint32_t>(a.glossWeight);
    c[AGAA_DEPTH_SCALE] = std::bit_cast<uint32_t>(a.depthScale);
    c[AGAA_NORMAL_SCALE] = std::bit_cast<uint32_t>(a.normalScale);
    c[AGAA_SHADING_SCALE] = std::bit_cast<uint32_t>(a.shadingScale);
    c[AGAA_SHADING_THRESHOLD] = std::bit_cast<uint32_t>(a.shadingThreshold);
    c[AGAA_SHADING_MINIMUM] = std::bit_cast<uint32_t>(a.shadingMinimum);
    setOrder(c, b.plan);
    return pass;
}

// Of a pixel's choice (src/shaders/passes/stored_choice.glsl).
uint32_t choiceWords(uint32_t samples) {
    const uint32_t ownersPerWord = 32 / (samples > 16 ? 5 : 4);
    return 1 + (samples + ownersPerWord - 1) / ownersPerWord;
}

void build(PlanBuilder& b) {
    b.defaultSurface(0.95f, 1.5f, 0.08f);
    const GBuffer gbuffer = makeGBuffer(b);
    const ResourceId firstSamples = b.image("first-samples", Format::RGBA16F, false);
    const ResourceId choices = b.pixelBuffer("sample-choices", 4 * choiceWords(b.plan.samples));
    Pass& first = addPass(b, "shade first samples", "shade_first", gbuffer);
    b.bind(first, slot::Output, BindingType::StorageImage, firstSamples, true);
    b.bind(first, slot::Fragments, BindingType::StorageBuffer, choices, true);
    Pass& further = addPass(b, "shade further samples", "shade_further", gbuffer);
    b.bind(further, slot::Metadata, BindingType::Texture, firstSamples);
    b.bind(further, slot::Fragments, BindingType::StorageBuffer, choices);
    b.bindOutput(further);
    b.copyCounters();
}

} // namespace

static bool prefersOrderedGrid(const ViewSettings& view) { return !(view.adaptive.flags & AGAA_ADAPTIVE_DEVICE_PATTERN); }

static const TechniqueSettings adaptiveSettings = {AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING, readAdaptive};
static constexpr const TechniqueSettings* settings[] = {&adaptiveSettings};
const Technique adaptiveTechnique = {"adaptive", 32, 0, false, {}, settings, build,
                                     prefersOrderedGrid};

} // namespace agaa
