#include "core/tiers.h"

#include "core/error.h"
#include "core/technique.h"
#include "core/validate.h"

#include <bit>
#include <cstring>

namespace agaa {

// Whole frames against those by post-depth atomics: medians of the scenes of docs/results/lavapipe/sweep, n = 8, c = 2.
constexpr float gbufferCost = 0.64f, idsCost = 0.61f;

static bool hasSamples(const AgaaDeviceCaps& caps, uint32_t samples) {
    return (caps.sampleCounts >> std::countr_zero(samples)) & 1;
}

static VisibilityChoice scaledTarget(const AgaaDeviceCaps& caps, uint32_t samples) {
    VisibilityChoice choice;
    for (uint32_t hw = samples / 2; hw >= 1; hw /= 2) {
        if (!hasSamples(caps, hw))
            continue;
        const uint32_t groups = samples / hw;
        // 1x2, 2x2, 2x4, 4x4, 4x8: of these the taller ones measured better near vertical edges.
        choice.scaleX = 1u << (std::bit_width(groups) - 1) / 2;
        choice.scaleY = groups / choice.scaleX;
        choice.hwSamples = hw;
        choice.tier = AGAA_TIER_SCALED_TARGET;
        choice.relativeCost = 1; // 0.9 to 1.0 of native at n = 4 on lavapipe
        choice.reason =
            format("a target of %ux%u sub-pixels at %u samples each gives %u per pixel.",
                   choice.scaleX, choice.scaleY, hw, samples);
        return choice;
    }
    choice.reason = format("%u samples cannot be made of the device's sample counts.", samples);
    return choice;
}

VisibilityChoice chooseVisibility(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced) {
    checkSampleCount(samples, "the number of samples per pixel");
    VisibilityChoice choice;
    if (forced == AGAA_TIER_NATIVE || forced == AGAA_TIER_AUTO) {
        if (hasSamples(caps, samples)) {
            choice.tier = AGAA_TIER_NATIVE;
            choice.hwSamples = samples;
            choice.reason = format("the device rasterises %u samples per pixel.", samples);
            return choice;
        }
        choice.reason = format("the device has no %u samples per pixel.", samples);
        if (forced == AGAA_TIER_NATIVE)
            return choice;
    }
    if (forced == AGAA_TIER_SCALED_TARGET || forced == AGAA_TIER_AUTO)
        return scaledTarget(caps, samples);
    choice.reason = format("the tier %s is not built for visibility.", agaaTierName(forced));
    return choice;
}

GenerationChoice chooseGeneration(const AgaaDeviceCaps& caps, uint32_t hwSamples, uint32_t forced,
                                  bool customDepth) {
    checkSampleCount(hwSamples, "the number of samples per texel");
    GenerationChoice choice;
    const auto accept = [&](AgaaTier tier, float price, const char* reason) {
        choice.tier = tier;
        choice.relativeCost = price;
        choice.reason = reason;
        return choice;
    };
    const auto refuse = [&](const char* reason) {
        choice.reason = reason;
        return choice;
    };
    const auto fromGBuffer = [&](const char* reason) {
        return accept(AGAA_TIER_GBUFFER, gbufferCost, reason);
    };
    if (forced == AGAA_TIER_GBUFFER)
        return fromGBuffer("a multisampled G-buffer is aggregated by a compute pass.");
    if (customDepth)
        return forced == AGAA_TIER_AUTO
                   ? fromGBuffer("materials that write depth or discard on their own are drawn once, "
                                 "into a multisampled G-buffer.")
                   : refuse("materials that write depth or discard on their own need the tier "
                            "gbuffer.");
    if (forced == AGAA_TIER_NV_MIXED_SAMPLES) {
        if (!(caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES))
            return refuse("the device has no mixed samples with coverage override.");
        choice.runnable = false;
        return accept(AGAA_TIER_NV_MIXED_SAMPLES, 1,
                      "mixed samples with additive blending; priced, not yet run.");
    }
    if (!(caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS))
        return forced == AGAA_TIER_AUTO
                   ? fromGBuffer("without atomics in fragment shaders a multisampled G-buffer is "
                                 "aggregated by a compute pass.")
                   : refuse("the device has no atomics in fragment shaders.");
    const bool postDepth = caps.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE;
    switch (forced) {
    case AGAA_TIER_AUTO:
    case AGAA_TIER_POST_DEPTH_ATOMICS:
        if (hwSamples == 1)
            return accept(AGAA_TIER_POST_DEPTH_ATOMICS, 1,
                          "one sample a texel: the early depth test leaves exact coverage.");
        if (postDepth)
            return accept(AGAA_TIER_POST_DEPTH_ATOMICS, 1,
                          "post-depth coverage and integer atomics split a fragment exactly.");
        if (forced != AGAA_TIER_AUTO)
            return refuse("the device has no post-depth coverage.");
        [[fallthrough]];
    case AGAA_TIER_PER_SAMPLE:
        if (hwSamples == 1)
            return accept(AGAA_TIER_PER_SAMPLE, 1, "one sample a texel.");
        if (caps.flags & AGAA_DEVICE_SAMPLE_RATE_SHADING)
            return accept(AGAA_TIER_PER_SAMPLE, 2, // 376 against 183 ms: bamboo, n = 4, lavapipe
                          "one invocation per sample with integer atomics.");
        return forced == AGAA_TIER_AUTO
                   ? fromGBuffer("without post-depth coverage and sample-rate shading a multisampled "
                                 "G-buffer is aggregated by a compute pass.")
                   : refuse("the device has no sample-rate shading.");
    default:
        break;
    }
    choice.reason = format("the tier %s is not built for generation.", agaaTierName(forced));
    return choice;
}

static AgaaCapability capability(const Technique& technique, uint32_t samples, AgaaStage stage,
                                 AgaaTier tier, bool native, float price,
                                 const std::string& reason) {
    AgaaCapability row{};
    row.technique = technique.name;
    row.samples = samples;
    row.stage = stage;
    row.tier = tier;
    row.isNative = native;
    row.relativeCost = price;
    std::strncpy(row.reason, reason.c_str(), sizeof row.reason - 1);
    return row;
}

// What is taken where the host neither asks nor offers anything, then all else that it can have.
static std::vector<GenerationChoice> generationChoices(const AgaaDeviceCaps& caps, uint32_t hwSamples,
                                                       const Technique& technique) {
    std::vector<GenerationChoice> choices = {chooseGeneration(caps, hwSamples, AGAA_TIER_AUTO, false)};
    for (uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER}) {
        const GenerationChoice choice = chooseGeneration(caps, hwSamples, tier, false);
        if (choice.tier != AGAA_TIER_AUTO && choice.tier != choices.front().tier)
            choices.push_back(choice);
    }
    if (technique.groupsSamples)
        choices.push_back({AGAA_TIER_IDS, true, idsCost,
                           "with an AgaaFetchFunction, materials are fetched by the ids that the only geometry pass "
                           "leaves."});
    return choices;
}

std::vector<AgaaCapability> listCapabilities(const AgaaDeviceCaps& caps) {
    std::vector<AgaaCapability> rows;
    for (const Technique* technique : techniques())
        for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u}) {
            if (!technique->multisampled && samples > 1)
                continue;
            const VisibilityChoice visibility = chooseVisibility(caps, samples, AGAA_TIER_AUTO);
            const auto addVisibility = [&](const VisibilityChoice& choice) {
                rows.push_back(capability(*technique, samples, AGAA_STAGE_PREPASS, choice.tier,
                                          choice.tier == AGAA_TIER_NATIVE, choice.relativeCost, choice.reason));
            };
            addVisibility(visibility);
            if (visibility.tier == AGAA_TIER_AUTO)
                continue; // no later stage can run either
            const VisibilityChoice scaled = chooseVisibility(caps, samples, AGAA_TIER_SCALED_TARGET);
            if (scaled.tier != AGAA_TIER_AUTO && scaled.tier != visibility.tier)
                addVisibility(scaled);
            if (technique->maxAggregates) {
                rows.push_back(capability(*technique, samples, AGAA_STAGE_DEFINITION,
                                          AGAA_TIER_NATIVE, true, 1, "a compute pass."));
                for (const GenerationChoice& choice : generationChoices(caps, visibility.hwSamples, *technique))
                    rows.push_back(capability(*technique, samples, AGAA_STAGE_GENERATION, choice.tier, false,
                                              choice.relativeCost, choice.reason));
            }
            rows.push_back(capability(*technique, samples, AGAA_STAGE_SHADING, AGAA_TIER_NATIVE, true,
                                      1, "a compute pass."));
        }
    return rows;
}

} // namespace agaa
