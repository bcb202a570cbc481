// Plans of frames with fewer effects: the passes, resources and bindings of the view's plan, with other programs. And
// which variant frames run with.
#include "plan_support.h"

#include "core/glsl/compile_glsl.h"
#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/view/facts.h"
#include "core/glsl/glsl_text.h"
#include "core/frame/variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace agaa::test {
namespace {

AgaaSceneFacts factsOf(uint64_t flags, uint32_t shadows, uint32_t lights = 4) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = flags;
    facts.shadowMapCount = shadows;
    facts.maxLights = lights;
    return facts;
}

Plan variantFor(const ViewSpec& spec, const AgaaSceneFacts& facts) {
    ViewSettings settings = settingsFor(spec);
    settings.variantFacts = computeFactsOf(facts, settings.facts);
    return makePlan(settings, fourSampleDevice(), 2);
}

constexpr const char* shadowText = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
constexpr const char* fetchText =
    "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
    "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}";

// Functions that are chained to views.
struct Functions {
    AgaaShadowFunction shadow = AGAA_SHADOW_FUNCTION_INIT;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT, some = AGAA_FETCH_FUNCTION_INIT;
    AgaaGBufferFunction gbuffer = AGAA_GBUFFER_FUNCTION_INIT;

    Functions() {
        shadow.glsl = shadowText;
        shadow.shadows = 1;
        fetch.glsl = fetchText;
        fetch.maxDraws = fetch.maxPrimitives = 100;
        some = fetch;
        some.flags = AGAA_FETCH_NOT_ALL_DRAWS;
        gbuffer.glsl =
            "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return true; }";
    }
};

// Each technique in each of its ways, with two shadow maps.
std::vector<ViewSpec> everyWay(const Functions& functions) {
    std::vector<ViewSpec> specs;
    const auto add = [&](const char* technique, uint32_t tier, const void* chained, uint64_t flags = 0,
                         uint32_t lit = 0, const char* layout = "precise") {
        for (const uint32_t lights : {4u, 40u}) {
            ViewSpec spec;
            spec.technique = technique;
            spec.layout = layout;
            spec.generationTier = tier;
            spec.chained = chained;
            spec.configFlags = flags;
            spec.shadowMaps = 2;
            spec.maxLights = lights;
            spec.change = [=](TechniqueConfig& config) {
                config.aggregation.litShadows = lit;
                config.ndf = lit ? AGAA_NDF_LEAN : AGAA_NDF_TOKSVIG;
                config.aggregation.glossWeight = lit ? 3.0f : 0.0f;
            };
            specs.push_back(spec);
        }
    };
    for (const Technique* technique : techniques())
        add(technique->name, AGAA_TIER_AUTO, nullptr, AGAA_CONFIG_COUNTERS);
    for (const char* technique : {"single", "ssaa", "simple_complex", "adaptive"})
        add(technique, AGAA_TIER_AUTO, &functions.shadow);
    for (const char* layout : {"precise", "paper16"})
        add("agaa", AGAA_TIER_PER_SAMPLE, nullptr, 0, 0, layout);
    for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED})
        for (const uint32_t lit : {0u, 2u, 3u}) {
            if (lit && flags)
                continue;
            add("agaa", AGAA_TIER_GBUFFER, nullptr, flags, lit);
            add("agaa", AGAA_TIER_GBUFFER, &functions.gbuffer, flags, lit);
            add("agaa", AGAA_TIER_IDS, &functions.fetch, flags, lit);
            add("agaa", AGAA_TIER_IDS, &functions.some, flags, lit);
        }
    add("agaa", AGAA_TIER_FRAGMENTS, &functions.fetch, 0, 1);
    add("sbaa", AGAA_TIER_GBUFFER, nullptr);
    add("adaptive", AGAA_TIER_IDS, &functions.fetch);
    add("dcaa", AGAA_TIER_MATERIAL_LISTS, nullptr);
    add("dcaa", AGAA_TIER_FRAGMENT_LISTS, &functions.fetch);
    return specs;
}

std::vector<AgaaSceneFacts> everyFewer() {
    std::vector<AgaaSceneFacts> list;
    for (uint64_t flags = 0; flags <= AGAA_FACT_ALL_SHADED; ++flags)
        for (uint32_t shadows : {0u, 1u, 2u})
            list.push_back(factsOf(flags, shadows));
    return list;
}

const std::set<uint32_t> constantsOfFacts = {AGAA_HAS_SPECULAR, AGAA_EMISSIVE_CHANNELS, AGAA_HAS_AMBIENT,
                                             AGAA_SHADOW_MAPS, AGAA_LIT_SHADOWS};

void expectTheSame(const AgaaDrawState& a, const AgaaDrawState& b) { EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0); }

// All but the programs of compute passes.
void expectTheSameView(const Plan& base, const Plan& variant) {
    EXPECT_EQ(base.resources, variant.resources);
    EXPECT_EQ(base.effects, variant.effects);
    EXPECT_EQ(base.view.generationTier, variant.view.generationTier);
    EXPECT_EQ(base.feedback, variant.feedback);
    ASSERT_EQ(base.passes.size(), variant.passes.size());
    EXPECT_EQ(base.steps().size(), variant.steps().size());
    for (size_t i = 0; i < base.passes.size(); ++i) {
        const Pass &a = base.passes[i], &b = variant.passes[i];
        SCOPED_TRACE(a.name);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.kind(), b.kind());
        EXPECT_EQ(a.stage, b.stage);
        EXPECT_EQ(a.segment, b.segment);
        EXPECT_EQ(a.bindings, b.bindings);
        if (a.kind() == PassKind::HostDraw) {
            EXPECT_EQ(a.draw().extensions, b.draw().extensions);
            EXPECT_EQ(a.draw().colorTargets, b.draw().colorTargets);
            EXPECT_EQ(a.draw().depthTarget, b.draw().depthTarget);
            expectTheSame(a.draw().state, b.draw().state);
        }
        if (a.kind() == PassKind::Fill) {
            EXPECT_EQ(a.fill().value, b.fill().value);
        }
        for (uint32_t c = 0; c < ConstantCount; ++c)
            if (a.kind() != PassKind::Compute || !constantsOfFacts.contains(c)) {
                EXPECT_EQ(a.constants[c], b.constants[c]) << c;
            }
        if (a.kind() != PassKind::Compute)
            continue;
        EXPECT_EQ(a.compute().dispatch, b.compute().dispatch);
        EXPECT_EQ(a.compute().file, b.compute().file);
        EXPECT_EQ(a.compute().hostCode, b.compute().hostCode);
        if (b.compute().hostCode.empty()) {
            EXPECT_TRUE(hasSpirv(b.compute().shader)) << b.compute().shader;
        }
    }
    EXPECT_TRUE(isVariantOf(variant, base));
}

TEST(VariantPlan, OnlyProgramsDiffer) {
    const Functions functions;
    for (const ViewSpec& spec : everyWay(functions)) {
        const Plan base = planFor(spec, fourSampleDevice());
        for (const AgaaSceneFacts& facts : everyFewer()) {
            SCOPED_TRACE(std::string(spec.technique) + " " + agaaTierName(base.view.generationTier) + " " +
                         std::to_string(facts.flags) + " " + std::to_string(facts.shadowMapCount));
            expectTheSameView(base, variantFor(spec, facts));
        }
    }
}

uint32_t differingPasses(const Plan& a, const Plan& b) {
    uint32_t count = 0;
    const auto shaderOf = [](const Pass& pass) {
        return pass.kind() == PassKind::Compute ? pass.compute().shader : std::string();
    };
    for (size_t i = 0; i < a.passes.size(); ++i)
        count += shaderOf(a.passes[i]) != shaderOf(b.passes[i]) || a.passes[i].constants != b.passes[i].constants;
    return count;
}

// Passes that do not shade, and effects that the layout has not, leave programs as they are.
TEST(VariantPlan, PassesThatReadNoFactKeepTheirPrograms) {
    const auto differing = [](const ViewSpec& spec, const AgaaSceneFacts& facts) {
        return differingPasses(planFor(spec, fourSampleDevice()), variantFor(spec, facts));
    };
    const AgaaSceneFacts none = factsOf(0, 0);
    EXPECT_EQ(differing({.technique = "ssaa", .maxLights = 40}, none), 1u) << "lights are culled as ever";
    EXPECT_EQ(differing({.technique = "msaa"}, none), 0u) << "the host shades";
    EXPECT_EQ(differing({.technique = "fxaa"}, none), 1u) << "the filter stays";
    EXPECT_EQ(differing({.technique = "agaa", .generationTier = AGAA_TIER_PER_SAMPLE}, none), 1u);
    const uint64_t all = AGAA_FACT_ALL_SHADED;
    EXPECT_EQ(differing({.technique = "ssaa"}, factsOf(all & ~AGAA_FACT_ALPHA_MASKED, 1)), 0u);
    EXPECT_EQ(differing({.technique = "ssaa"}, factsOf(all, 1, 0)), 0u) << "lights are counted by the frame";
    EXPECT_EQ(differing({.technique = "ssaa"}, factsOf(all & ~AGAA_FACT_AMBIENT, 1)), 1u);
    EXPECT_EQ(differing({.technique = "ssaa", .facts = AGAA_FACT_AMBIENT}, factsOf(AGAA_FACT_AMBIENT, 1)), 0u);
}

// What a shading pass is compiled for.
TEST(VariantPlan, EffectsAreLeftOut) {
    ViewSpec spec{.generationTier = AGAA_TIER_GBUFFER, .shadowMaps = 2};
    spec.change = [](TechniqueConfig& config) { config.aggregation.litShadows = 2; };
    const auto shading = [&](const AgaaSceneFacts& facts) {
        const Plan plan = variantFor(spec, facts);
        return *std::ranges::find(plan.passes, "aggregate and shade", &Pass::name);
    };
    const Pass all = shading(factsOf(AGAA_FACT_ALL_SHADED, 2));
    EXPECT_NE(all.compute().shader.find("s1"), std::string::npos);
    EXPECT_NE(all.compute().shader.find("l1"), std::string::npos);
    EXPECT_EQ(all.constants[AGAA_LIT_SHADOWS], 2u);
    EXPECT_EQ(all.constants[AGAA_SHADOW_MAPS], 2u);
    const Pass one = shading(factsOf(AGAA_FACT_ALL_SHADED, 1));
    EXPECT_NE(one.compute().shader.find("s1"), std::string::npos);
    EXPECT_NE(one.compute().shader.find("l0"), std::string::npos);
    EXPECT_NE(one.compute().defines.find("#define AGAA_LIT 0"), std::string::npos);
    EXPECT_EQ(one.constants[AGAA_SHADOW_MAPS], 1u);
    const Pass none = shading(factsOf(0, 0));
    EXPECT_NE(none.compute().shader.find("s0"), std::string::npos);
    for (const Constant constant : {AGAA_HAS_SPECULAR, AGAA_EMISSIVE_CHANNELS, AGAA_HAS_AMBIENT}) {
        EXPECT_NE(all.constants[constant], 0u);
        EXPECT_EQ(none.constants[constant], 0u);
    }
}

// Functions for shadows that no frame of the variant has.
TEST(VariantPlan, PassesWithFunctionsOfTheHostCompile) {
    const Functions functions;
    for (const void* chained :
         {static_cast<const void*>(&functions.shadow), static_cast<const void*>(&functions.fetch)})
        for (const AgaaSceneFacts& facts : {factsOf(0, 0), factsOf(AGAA_FACT_EMISSIVE, 1)}) {
            ViewSpec spec{.chained = chained};
            spec.shadowMaps = 2;
            if (chained == &functions.shadow)
                spec.technique = "ssaa";
            uint32_t compiled = 0;
            for (const Pass& pass : variantFor(spec, facts).passes)
                if (pass.kind() == PassKind::Compute && !pass.compute().hostCode.empty()) {
                    EXPECT_FALSE(compileCompute(passGlsl(pass), pass.name.c_str()).empty());
                    ++compiled;
                }
            EXPECT_GT(compiled, 0u);
        }
}

TEST(Facts, LieWithinOthersWhereNothingIsMore) {
    const AgaaSceneFacts outer = factsOf(AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT, 2, 10);
    EXPECT_TRUE(isWithin(outer, outer));
    EXPECT_TRUE(isWithin(factsOf(0, 0, 0), outer));
    EXPECT_TRUE(isWithin(factsOf(AGAA_FACT_AMBIENT, 2, 9), outer));
    EXPECT_FALSE(isWithin(factsOf(AGAA_FACT_EMISSIVE, 0, 0), outer));
    EXPECT_FALSE(isWithin(factsOf(0, 3, 0), outer));
    EXPECT_FALSE(isWithin(factsOf(0, 0, 11), outer));
    EXPECT_THROW(checkWithin(factsOf(0, 3, 0), outer, "AgaaFrame::facts"), Error);
    EXPECT_NO_THROW(checkWithin(outer, outer, "AgaaFrame::facts"));
}

// Programs by numbers.
class Counting {
public:
    void add(const ViewSpec& spec, const AgaaSceneFacts& facts) {
        variants.add(variantFor(spec, facts), [&](const Pass&, size_t) {
            return Compiled{++compiled, compiled % 2 == 0};
        });
    }
    explicit Counting(const ViewSpec& spec) : base(planFor(spec, fourSampleDevice())), variants(base) {
        add(spec, base.view.facts);
    }

    uint64_t compiled = 0;
    Plan base;
    Variants variants;
};

uint64_t flagsOf(const Counting& counting, uint64_t flags, uint32_t shadows) {
    return counting.variants.smallest(computeFactsOf(factsOf(flags, shadows), counting.base.view.facts)).facts.flags;
}

TEST(Variants, FramesRunWithTheSmallestThatHasTheirEffects) {
    const ViewSpec spec{.technique = "ssaa"};
    Counting counting(spec);
    constexpr uint64_t all = AGAA_FACT_ALL_SHADED, masked = AGAA_FACT_ALPHA_MASKED;
    EXPECT_EQ(flagsOf(counting, 0, 0), all) << "none is prepared";
    counting.add(spec, factsOf(AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT, 1));
    counting.add(spec, factsOf(AGAA_FACT_SPECULAR, 1));
    counting.add(spec, factsOf(AGAA_FACT_EMISSIVE, 0));
    EXPECT_EQ(flagsOf(counting, AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT, 1),
              AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT | masked);
    EXPECT_EQ(flagsOf(counting, AGAA_FACT_AMBIENT, 0), AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT | masked);
    EXPECT_EQ(flagsOf(counting, AGAA_FACT_SPECULAR, 0), AGAA_FACT_SPECULAR | masked);
    EXPECT_EQ(flagsOf(counting, 0, 0), AGAA_FACT_EMISSIVE | masked);
    EXPECT_EQ(flagsOf(counting, AGAA_FACT_EMISSIVE, 1), all) << "no smaller one has a shadow";
    EXPECT_EQ(counting.variants.figures().variants, 4u);
    const uint64_t compiled = counting.compiled;
    counting.add(spec, factsOf(AGAA_FACT_SPECULAR, 1, 2));
    counting.add(spec, factsOf(AGAA_FACT_SPECULAR | masked, 1));
    EXPECT_EQ(counting.variants.figures().variants, 4u) << "lights and masks change nothing";
    EXPECT_EQ(counting.compiled, compiled);
}

TEST(Variants, EqualPassesShareAProgram) {
    const ViewSpec spec{.technique = "ssaa", .maxLights = 40};
    Counting counting(spec);
    EXPECT_EQ(counting.compiled, 2u) << "cull, shade";
    counting.add(spec, factsOf(0, 0));
    EXPECT_EQ(counting.compiled, 3u);
    const CompileFigures figures = counting.variants.figures();
    EXPECT_EQ(figures.programs, 3u);
    EXPECT_EQ(figures.cached, 1u);
    EXPECT_GE(figures.milliseconds, 0);
    EXPECT_EQ(counting.variants.programs(), (std::vector<uint64_t>{1, 2, 3}));
}

// What was compiled before is kept, for it has an owner, and used by the next attempt's variants.
TEST(Variants, AFailureLeavesThoseThatWere) {
    const ViewSpec spec{.technique = "ssaa"};
    Counting counting(spec);
    const Plan fewer = variantFor(spec, factsOf(0, 0));
    EXPECT_THROW(counting.variants.add(fewer, [](const Pass&, size_t) -> Compiled { fail(AGAA_ERROR_DEVICE, "no."); }),
                 Error);
    EXPECT_EQ(counting.variants.figures().variants, 1u);
    EXPECT_EQ(flagsOf(counting, 0, 0), AGAA_FACT_ALL_SHADED);
    counting.add(spec, factsOf(0, 0));
    EXPECT_EQ(flagsOf(counting, 0, 0), AGAA_FACT_ALPHA_MASKED);
}

TEST(Variants, AnotherPlansAreRefused) {
    Counting counting({.technique = "ssaa"});
    const Plan other = planFor({.technique = "ssaa", .samples = 4, .shadowMaps = 0}, fourSampleDevice());
    EXPECT_THROW(counting.variants.add(other, [](const Pass&, size_t) { return Compiled{9}; }), Error);
}

} // namespace
} // namespace agaa::test
