// Facts that suffice for a frame, and those of many frames.
#include "plan_support.h"

#include "core/reports/fact_report.h"
#include "core/view/facts.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace agaa::test {
namespace {

constexpr uint64_t effectBits = AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT;

// A random frame: few kinds of material, so that many facts hold.
AgaaFactReport randomReport(std::mt19937& random) {
    const auto happens = [&](double share) { return std::bernoulli_distribution(share)(random); };
    AgaaFactReport frame = AGAA_FACT_REPORT_INIT;
    frame.inspected = 100;
    frame.withSpecular = happens(0.5) ? 30 : 0;
    frame.withEmission = happens(0.3) ? 10 : 0;
    frame.translucent = happens(0.3) ? 5 : 0;
    frame.cutouts = happens(0.3) ? 6 : 0;
    frame.alphaMasked = frame.translucent + frame.cutouts;
    frame.otherRoughness = happens(0.4) ? 7 : 0;
    frame.coloredSpecular = frame.withSpecular && happens(0.3) ? 8 : 0;
    frame.otherSpecular = frame.coloredSpecular || happens(0.4) ? 9 : 0;
    frame.withDiffuse = happens(0.7) ? 90 : 0;
    frame.otherNormals = happens(0.5) ? 50 : 0;
    frame.localLights = happens(0.5);
    frame.hasAmbient = happens(0.5);
    return frame;
}

// Adds the counts of a frame to those of a level.
void add(AgaaFactReport& level, const AgaaFactReport& frame) {
    for (const auto member :
         {&AgaaFactReport::inspected, &AgaaFactReport::withSpecular, &AgaaFactReport::withEmission,
          &AgaaFactReport::alphaMasked, &AgaaFactReport::otherRoughness, &AgaaFactReport::coloredSpecular,
          &AgaaFactReport::otherSpecular, &AgaaFactReport::withDiffuse, &AgaaFactReport::translucent,
          &AgaaFactReport::cutouts, &AgaaFactReport::otherNormals})
        level.*member += frame.*member;
    level.localLights += frame.localLights;
    level.hasAmbient |= frame.hasAmbient;
}

// The facts of many frames: effects that any frame needs, and common values that all frames have. They are the facts of
// one frame with the materials of all.
TEST(FactReport, FactsOfManyFramesAreThoseOfAllMaterials) {
    std::mt19937 random(1);
    uint32_t lost = 0;
    for (int level = 0; level < 20000; ++level) {
        AgaaFactReport all = AGAA_FACT_REPORT_INIT;
        uint64_t effects = 0, common = ~UINT64_C(0);
        for (uint32_t frames = 1 + uint32_t(level) % 8; frames > 0; --frames) {
            const AgaaFactReport frame = randomReport(random);
            const uint64_t facts = sufficientFacts(frame, 0);
            effects |= facts & effectBits;
            common &= facts & ~effectBits;
            add(all, frame);
        }
        lost += (effects | common) != sufficientFacts(all, 0);
    }
    EXPECT_EQ(lost, 0u) << "of 20000 levels";
}

TEST(FactReport, ImpliedFactsAreKept) {
    AgaaFactReport frame = AGAA_FACT_REPORT_INIT;
    frame.inspected = 100;
    EXPECT_EQ(sufficientFacts(frame, AGAA_FACT_CUSTOM_DEPTH), commonValues | AGAA_FACT_CUSTOM_DEPTH)
        << "no material contradicts a common value";
    frame.withSpecular = 100;
    EXPECT_EQ(sufficientFacts(frame, 0), commonValues | AGAA_FACT_SPECULAR)
        << "materials with one reflectance are grey";
    frame.otherSpecular = 1;
    EXPECT_EQ(sufficientFacts(frame, 0), (commonValues & ~AGAA_FACT_ONE_SPECULAR) | AGAA_FACT_SPECULAR);
}

// Facts without those that others imply.
uint64_t withoutImplied(uint64_t flags) {
    if (!(flags & AGAA_FACT_SPECULAR))
        flags &= ~(AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR | AGAA_FACT_ONE_SPECULAR);
    if (!(flags & AGAA_FACT_ALPHA_MASKED))
        flags &= ~(AGAA_FACT_NO_TRANSLUCENCY | AGAA_FACT_NO_CUTOUTS);
    return flags & AGAA_FACT_ONE_SPECULAR ? flags & ~AGAA_FACT_GREY_SPECULAR : flags;
}

// The constant of the facts themselves is the only difference between plans with and without implied facts.
TEST(FactReport, ImpliedFactsDoNotChangeThePlan) {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "";
    fetch.maxDraws = fetch.maxPrimitives = 1;
    std::mt19937 random(2);
    uint32_t changed = 0;
    for (int run = 0; run < 200; ++run) {
        const uint64_t flags = random() & (AGAA_FACT_ALL_SHADED | AGAA_FACT_ALPHA_MASKED | commonValues);
        changed += withoutImplied(flags) != flags;
        for (const ViewSpec& spec : {ViewSpec{.technique = "ssaa"},
                                     {.generationTier = AGAA_TIER_PER_SAMPLE},
                                     {.generationTier = AGAA_TIER_GBUFFER},
                                     {.generationTier = AGAA_TIER_IDS, .chained = &fetch},
                                     {.technique = "dcaa", .samples = 64, .generationTier = AGAA_TIER_MATERIAL_LISTS},
                                     {.technique = "adaptive", .samples = 4}}) {
            SCOPED_TRACE(spec.technique);
            ViewSpec all = spec, few = spec;
            all.facts = flags;
            few.facts = withoutImplied(flags);
            Plan a = planFor(all, idealDevice());
            const Plan b = planFor(few, idealDevice());
            ASSERT_EQ(a.resources, b.resources) << std::hex << flags;
            ASSERT_EQ(a.passes.size(), b.passes.size());
            EXPECT_EQ(a.effects, b.effects);
            EXPECT_EQ(a.totalBytes(), b.totalBytes());
            EXPECT_EQ(a.bytesPerAggregate, b.bytesPerAggregate);
            for (size_t i = 0; i < a.passes.size(); ++i) {
                Pass& pass = a.passes[i];
                const Pass& other = b.passes[i];
                EXPECT_EQ(pass.name, other.name);
                EXPECT_EQ(pass.bindings, other.bindings) << pass.name;
                pass.constants[AGAA_FACTS] = other.constants[AGAA_FACTS];
                EXPECT_EQ(pass.constants, other.constants) << pass.name << ' ' << std::hex << flags;
            }
        }
    }
    EXPECT_GT(changed, 100u) << "few flags implied others";
}

} // namespace
} // namespace agaa::test
