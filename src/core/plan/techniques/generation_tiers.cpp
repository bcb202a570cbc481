#include "core/plan/techniques/generation_tiers.h"

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/view/layout.h"

namespace agaa {

namespace {

// Times of whole frames relative to post-depth atomics, with n = 8 and c = 2. They are medians of the scenes of
// docs/results/lavapipe/sweep.
constexpr float gbufferCost = 0.64f, idsCost = 0.54f;
// Times relative to lists, n = 64, S = 4: on lavapipe, foliage and metal, 320x180; on an NVIDIA H200 (not kept), bamboo
// and metal, 1280x720. Material lists take 2.8 on the H200.
constexpr float materialListsCost = 1.15f;
constexpr float interlockCost = 8.5f;   // H200
constexpr float rasterOrderCost = 2.5f; // lavapipe, bamboo and metal
constexpr float perSampleCost = 2;      // 376 ms relative to 183 ms: bamboo, n = 4, lavapipe

constexpr const char* hostGBufferReason = "a G-buffer that the host draws leaves only the tier gbuffer.";

bool hasAtomics(const GenerationQuery& q) { return q.caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS; }
bool isTooLarge(const GenerationQuery& q) { return q.aggregateBytes > q.caps.maxStorageRange; }

// Returns why two geometry passes cannot run on any device, or empty text if they can.
std::string twoPassRefusal(const GenerationQuery& q) {
    if (q.hostGBuffer)
        return hostGBufferReason;
    if (!q.isForced && q.needsMaterials)
        return "settings need materials where samples are grouped.";
    if (q.customDepth)
        return "materials that write depth or discard on their own need the tier gbuffer.";
    return {};
}

// Returns why passes that accumulate by atomics cannot run, or empty text if they can.
std::string atomicsRefusal(const GenerationQuery& q) {
    if (std::string refusal = twoPassRefusal(q); !refusal.empty())
        return refusal;
    if (!hasAtomics(q))
        return "the device has no atomics in fragment shaders.";
    if (!q.isForced && isTooLarge(q))
        return "the device has no storage buffer that holds the aggregates.";
    return {};
}

TierAnswer answerPostDepth(const GenerationQuery& q) {
    if (std::string refusal = atomicsRefusal(q); !refusal.empty())
        return {false, refusal};
    if (q.hwSamples == 1)
        return {true, "one sample a texel: the early depth test leaves exact coverage."};
    if (q.caps.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE)
        return {true, "post-depth coverage and integer atomics split a fragment exactly."};
    return {false, "the device has no post-depth coverage."};
}

TierAnswer answerPerSample(const GenerationQuery& q) {
    if (std::string refusal = atomicsRefusal(q); !refusal.empty())
        return {false, refusal};
    if (q.hwSamples == 1)
        return {true, "one sample a texel."};
    if (q.caps.flags & AGAA_DEVICE_SAMPLE_RATE_SHADING)
        return {true, "one invocation per sample with integer atomics."};
    return {false, "the device has no sample-rate shading."};
}

constexpr const char* noMixedSamplesReason =
    "the device has no mixed samples with coverage override (AGAA_DEVICE_NV_MIXED_SAMPLES).";

TierAnswer answerMixedSamples(const GenerationQuery& q) {
    if (std::string refusal = twoPassRefusal(q); !refusal.empty())
        return {false, refusal};
    if (!(q.caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES))
        return {false, noMixedSamplesReason};
    if (q.hwSamples > 1 && !(q.caps.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE))
        return {false, "the device has no post-depth coverage."};
    if (q.hasScaledTarget)
        return {false, "mixed samples need a target of the device's own n samples."};
    if (q.lacksStencil)
        return {false, "additive blending would count samples of coplanar fragments twice without a stencil test."};
    if (q.hasUnfiltered)
        return {false, "additive blending has no attributes of AGAA_FILTER_NONE and AGAA_FILTER_CLASS, which are no "
                       "sums."};
    if (q.keepsMoments)
        return {false, "AgaaConfig::ndf asks for elliptic lobes, or AgaaMeasurement::diffuseFilter for SGGX, whose "
                       "moments of normals the tier nv-mixed-samples does not keep."};
    if (q.attachments > maxAttachments)
        return {false, format("the aggregates of this layout need %u attachments; a draw has %u.", q.attachments,
                              maxAttachments)};
    return {true, "mixed samples sum aggregates by additive blending in attachments; not yet run on a device."};
}

TierAnswer answerPricedMixedSamples(const GenerationQuery& q) {
    if (std::string refusal = twoPassRefusal(q); !refusal.empty())
        return {false, refusal};
    if (!(q.caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES))
        return {false, noMixedSamplesReason};
    return {true,
            "the memory of the papers; it is never run, because a surface has the attributes of one sample, which "
            "additive blending cannot select."};
}

// The tier always runs. The reason says why AUTO selected it.
TierAnswer answerGBuffer(const GenerationQuery& q) {
    const std::string aggregated = "a multisampled G-buffer is aggregated by a compute pass.";
    if (q.hostGBuffer)
        return {true, "the host's multisampled G-buffer is aggregated by a compute pass."};
    if (q.isForced)
        return {true, aggregated};
    if (q.needsMaterials)
        return {true,
                "lit shadows, the weight of gloss and elliptic lobes want materials where samples are grouped, so "
                "that " +
                    aggregated};
    if (q.customDepth)
        return {true,
                "materials that write depth or discard on their own are drawn once, into a multisampled G-buffer."};
    if (!hasAtomics(q))
        return {true, "without atomics in fragment shaders " + aggregated};
    if (isTooLarge(q))
        return {true, format("aggregates would take %llu bytes, and the device allows %llu in one storage buffer, so "
                             "that ",
                             static_cast<unsigned long long>(q.aggregateBytes),
                             static_cast<unsigned long long>(q.caps.maxStorageRange)) +
                          aggregated};
    return {true, "without post-depth coverage and sample-rate shading " + aggregated};
}

TierAnswer answerIds(const GenerationQuery& q) {
    if (q.hostGBuffer)
        return {false, hostGBufferReason};
    if (!q.fetches)
        return {false, "the tier ids needs an AgaaFetchFunction."};
    if (q.expandsTriangles && !q.someUnfetched && !q.customDepth && !q.accumulates)
        return {true,
                "materials are fetched by the ids of samples, which compute passes find; the host draws nothing."};
    return {true, q.someUnfetched
                      ? "materials are fetched by the ids that the first geometry pass leaves; draws that cannot be "
                        "fetched (AGAA_FETCH_NOT_ALL_DRAWS) are drawn again, into a whole multisampled G-buffer."
                      : "materials are fetched by the ids that the only geometry pass leaves."};
}

TierAnswer answerSampleIds(const GenerationQuery& q) {
    if (q.hostGBuffer)
        return {false, hostGBufferReason};
    if (!q.fetches)
        return {false, "the tier ids needs an AgaaFetchFunction."};
    if (q.someUnfetched)
        return {false, "the materials of all draws are fetched; AGAA_FETCH_NOT_ALL_DRAWS must not be set."};
    return {true,
            "materials of the samples that are shaded are fetched by the ids that the only geometry pass leaves."};
}

TierAnswer answerSampleGBuffer(const GenerationQuery& q) {
    return {true, q.hostGBuffer ? "samples of the host's multisampled G-buffer are shaded."
                                : "samples of a multisampled G-buffer are shaded."};
}

constexpr const char* noCoverageReason = "a G-buffer that the host draws has no coverage beyond its samples.";
// Returns whether the host can expand triangles to cover every pixel that they touch.
bool drawsHulls(const GenerationQuery& q) { return q.vertexPulling || q.caps.flags & AGAA_DEVICE_GEOMETRY_SHADERS; }
constexpr const char* noExpansionReason = "the device has no geometry shaders, which give a fragment to every pixel "
                                          "that a triangle touches; vertex shaders of the "
                                          "host can (AGAA_VIEW_VERTEX_PULLING).";

// Returns why fetched fragments cannot be stored in lists, or empty text if they can.
std::string listsRefusal(const GenerationQuery& q, AgaaTier tier) {
    if (q.hostGBuffer)
        return noCoverageReason;
    if (!q.fetches)
        return format("the tier %s needs an AgaaFetchFunction.", tierName(tier));
    if (q.someUnfetched)
        return format("the tier %s fetches the materials of all draws; AGAA_FETCH_NOT_ALL_DRAWS must not be set.",
                      tierName(tier));
    if (q.customDepth)
        return "materials that write depth or discard on their own cannot be fetched by id with their depth.";
    if (q.expandsTriangles)
        return {};
    if (!hasAtomics(q))
        return "the device has no atomics in fragment shaders; compute passes can expand triangles "
               "(AgaaFetchFunction::maxTriangles).";
    if (!drawsHulls(q))
        return noExpansionReason;
    return {};
}

TierAnswer answerFragmentLists(const GenerationQuery& q) {
    if (std::string refusal = listsRefusal(q, AGAA_TIER_FRAGMENT_LISTS); !refusal.empty())
        return {false, refusal};
    return {true, "fragments are appended to a list for each pixel and merged from front to back."};
}

TierAnswer answerFragments(const GenerationQuery& q) {
    if (std::string refusal = listsRefusal(q, AGAA_TIER_FRAGMENTS); !refusal.empty())
        return {false, refusal};
    return {true, "fragments are appended to a list for each pixel; those that show are clustered by a compute pass."};
}

TierAnswer answerMaterialLists(const GenerationQuery& q) {
    if (q.hostGBuffer)
        return {false, noCoverageReason};
    if (!hasAtomics(q))
        return {false, "the device has no atomics in fragment shaders."};
    if (!drawsHulls(q))
        return {false, noExpansionReason};
    return {true, "fragments carry their materials in a list for each pixel and are merged from front to back."};
}

TierAnswer answerInterlock(const GenerationQuery& q) {
    if (const TierAnswer lists = answerMaterialLists(q); !lists.runs)
        return lists;
    if (!(q.caps.flags & AGAA_DEVICE_FRAGMENT_INTERLOCK))
        return {false, "the device has no interlock of fragment shaders, which orders the fragments of a pixel."};
    return {true, "fragments are merged in the order of the draws by the shader that draws them."};
}

TierAnswer answerRasterOrder(const GenerationQuery& q) {
    if (const TierAnswer lists = answerMaterialLists(q); !lists.runs)
        return lists;
    if (!(q.caps.flags & AGAA_DEVICE_FRAMEBUFFER_FETCH))
        return {false, "fragment shaders cannot read what attachments hold: that takes "
                       "VK_EXT_rasterization_order_attachment_access on Vulkan, with its feature in "
                       "AgaaVkDeviceDesc::enabledFeatures, and on OpenGL GL_EXT_shader_framebuffer_fetch and "
                       "AGAA_GL_OUTPUTS_SDK."};
    return {true, "fragments are merged in the order of the draws by the shader that draws them, in attachments."};
}

} // namespace

const GenerationTier idsTier = {.tier = AGAA_TIER_IDS,
                                .relativeCost = idsCost,
                                .isAutomatic = true,
                                .knowsMaterials = true,
                                .countsPrimitives = true,
                                .answer = answerIds};
const GenerationTier postDepthTier = {
    .tier = AGAA_TIER_POST_DEPTH_ATOMICS, .isAutomatic = true, .sumsFragments = true, .answer = answerPostDepth};
const GenerationTier perSampleTier = {.tier = AGAA_TIER_PER_SAMPLE,
                                      .relativeCost = perSampleCost,
                                      .isAutomatic = true,
                                      .sumsFragments = true,
                                      .answer = answerPerSample};
const GenerationTier gbufferTier = {.tier = AGAA_TIER_GBUFFER,
                                    .relativeCost = gbufferCost,
                                    .isAutomatic = true,
                                    .knowsMaterials = true,
                                    .readsGBuffer = true,
                                    .answer = answerGBuffer};
const GenerationTier sampleIdsTier = {
    .tier = AGAA_TIER_IDS, .isAutomatic = true, .knowsMaterials = true, .answer = answerSampleIds};
const GenerationTier sampleGBufferTier = {.tier = AGAA_TIER_GBUFFER,
                                          .isAutomatic = true,
                                          .knowsMaterials = true,
                                          .readsGBuffer = true,
                                          .answer = answerSampleGBuffer};
// It is not automatic, because no device has run it. Its cost is unknown, too.
const GenerationTier mixedSamplesTier = {.tier = AGAA_TIER_NV_MIXED_SAMPLES, .answer = answerMixedSamples};
const GenerationTier pricedMixedSamplesTier = {
    .tier = AGAA_TIER_NV_MIXED_SAMPLES, .isModel = true, .answer = answerPricedMixedSamples};
const GenerationTier fragmentListsTier = {.tier = AGAA_TIER_FRAGMENT_LISTS,
                                          .isAutomatic = true,
                                          .knowsMaterials = true,
                                          .hasCoverageSamples = true,
                                          .answer = answerFragmentLists};
const GenerationTier fragmentsTier = {.tier = AGAA_TIER_FRAGMENTS,
                                      .isAutomatic = true,
                                      .knowsMaterials = true,
                                      .countsPrimitives = true,
                                      .hasCoverageSamples = true,
                                      .answer = answerFragments};
const GenerationTier materialListsTier = {.tier = AGAA_TIER_MATERIAL_LISTS,
                                          .relativeCost = materialListsCost,
                                          .isAutomatic = true,
                                          .knowsMaterials = true,
                                          .hasCoverageSamples = true,
                                          .answer = answerMaterialLists};
// Neither is automatic: both take longer than lists.
const GenerationTier interlockTier = {.tier = AGAA_TIER_FRAGMENT_INTERLOCK,
                                      .relativeCost = interlockCost,
                                      .knowsMaterials = true,
                                      .hasCoverageSamples = true,
                                      .answer = answerInterlock};
const GenerationTier rasterOrderTier = {.tier = AGAA_TIER_RASTER_ORDER,
                                        .relativeCost = rasterOrderCost,
                                        .knowsMaterials = true,
                                        .hasCoverageSamples = true,
                                        .answer = answerRasterOrder};

} // namespace agaa
