// Plans whose compute passes fetch and expand triangles (AgaaFetchFunction::maxTriangles).
#include "plan_support.h"

#include "core/base/error.h"
#include "shaders/tables/layouts.inc"

#include <gtest/gtest.h>

#include <algorithm>

namespace agaa::test {
namespace {

constexpr uint32_t draws = 7, triangles = 1000;

AgaaFetchFunction expandingFetch(uint32_t maxTriangles = triangles) {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "";
    fetch.maxDraws = draws;
    fetch.maxPrimitives = 100;
    fetch.maxTriangles = maxTriangles;
    return fetch;
}

ViewSpec specOf(const char* technique, AgaaTier tier, const AgaaFetchFunction& fetch) {
    return {
        .technique = technique, .samples = 64, .aggregates = 2, .generationTier = uint32_t(tier), .chained = &fetch};
}

// Configurations whose fragments are fetched by id.
std::vector<ViewSpec> expandedSpecs(const AgaaFetchFunction& fetch) {
    std::vector<ViewSpec> specs;
    for (const uint32_t samples : {32u, 64u, 128u}) {
        for (const uint64_t flags : {UINT64_C(0), AGAA_COVERAGE_EXACT})
            for (const uint32_t batches : {0u, 1u, 8u}) {
                ViewSpec spec = specOf("dcaa", AGAA_TIER_FRAGMENT_LISTS, fetch);
                spec.samples = samples;
                spec.change = [=](TechniqueConfig& config) {
                    config.coverage.flags = flags;
                    config.coverage.maxBatches = batches;
                };
                specs.push_back(spec);
            }
        specs.push_back(specOf("agaa", AGAA_TIER_FRAGMENTS, fetch));
        specs.back().samples = samples;
    }
    return specs;
}

size_t passAt(const Plan& plan, const std::string& name) {
    return size_t(std::ranges::find(plan.passes, name, &Pass::name) - plan.passes.begin());
}

const Resource* find(const Plan& plan, const std::string& name) {
    const auto found = std::ranges::find(plan.resources, name, &Resource::name);
    return found == plan.resources.end() ? nullptr : &*found;
}

const std::vector<std::string> expansion = {"count triangles", "expand triangles", "list large triangles",
                                            "expand large triangles"};

void expectExpanded(const Plan& plan) {
    EXPECT_EQ(plan.geometryPasses(), 0u);
    const size_t first = passAt(plan, expansion[0]);
    ASSERT_LE(first + expansion.size(), plan.passes.size());
    for (size_t i = 0; i < expansion.size(); ++i) {
        const Pass& pass = plan.passes[first + i];
        EXPECT_EQ(pass.name, expansion[i]);
        ASSERT_EQ(pass.kind(), PassKind::Compute);
        // The sums of one workgroup say how many workgroups the next pass has.
        EXPECT_EQ(pass.compute().dispatch.kind, i % 2 ? DispatchKind::Indirect : DispatchKind::Items);
    }
    const Resource* const buffer = find(plan, "triangles");
    ASSERT_NE(buffer, nullptr);
    EXPECT_EQ(AGAA_TRIANGLE_SUMS, 12u);
    EXPECT_EQ(buffer->bytes, 4 * (12 + draws + 2 * triangles));
    const auto argumentsOf = [&](size_t i) {
        return &plan.resources[plan.passes[first + i].compute().dispatch.arguments];
    };
    EXPECT_EQ(argumentsOf(1), find(plan, "fragments")) << "empty once no draw is left";
    EXPECT_EQ(argumentsOf(3), buffer);
    EXPECT_TRUE(std::ranges::any_of(plan.notes, [](const std::string& note) {
        return note.find("AgaaFetchFunction::maxTriangles") != std::string::npos;
    }));
}

TEST(ComputeTriangles, PlansHaveNoDraws) {
    const AgaaFetchFunction fetch = expandingFetch();
    for (const ViewSpec& spec : expandedSpecs(fetch)) {
        SCOPED_TRACE(std::string(spec.technique) + std::to_string(spec.samples));
        const Plan plan = planFor(spec, idealDevice());
        expectExpanded(plan);
        // All else is as with a draw.
        const AgaaFetchFunction drawing = expandingFetch(0);
        ViewSpec drawn = spec;
        drawn.chained = &drawing;
        const Plan other = planFor(drawn, idealDevice());
        EXPECT_EQ(other.geometryPasses(), 1u);
        EXPECT_EQ(find(other, "triangles"), nullptr);
        EXPECT_EQ(plan.totalBytes(), other.totalBytes() + find(plan, "triangles")->bytes);
        std::vector<std::string> names, otherNames;
        for (const Pass& pass : plan.passes)
            if (std::ranges::find(expansion, pass.name) == expansion.end())
                names.push_back(pass.name);
        for (const Pass& pass : other.passes)
            if (pass.kind() != PassKind::HostDraw)
                otherNames.push_back(pass.name);
        EXPECT_EQ(names, otherNames);
    }
}

// The triangles are counted once.
TEST(ComputeTriangles, RepeatsBeginAfterTheCount) {
    const AgaaFetchFunction fetch = expandingFetch();
    size_t repeating = 0;
    for (const ViewSpec& spec : expandedSpecs(fetch)) {
        const Plan plan = planFor(spec, idealDevice());
        ASSERT_EQ(plan.repeats.size(), plan.view.coverage.maxBatches > 1 ? 1u : 0u);
        for (const Repeat& repeat : plan.repeats) {
            ++repeating;
            EXPECT_EQ(plan.passes[repeat.firstPass].name, "expand triangles");
            EXPECT_GT(repeat.lastPass, passAt(plan, "expand large triangles"));
        }
    }
    EXPECT_GT(repeating, 10u);
}

TEST(ComputeTriangles, DevicesNeedNeitherGeometryShadersNorFragmentAtomics) {
    const AgaaFetchFunction fetch = expandingFetch(), drawing = expandingFetch(0);
    for (const uint64_t without : {uint64_t(AGAA_DEVICE_GEOMETRY_SHADERS), uint64_t(AGAA_DEVICE_FRAGMENT_ATOMICS),
                                   AGAA_DEVICE_GEOMETRY_SHADERS | AGAA_DEVICE_FRAGMENT_ATOMICS}) {
        AgaaDeviceCaps caps = idealDevice();
        caps.flags &= ~without;
        for (ViewSpec spec : expandedSpecs(fetch)) {
            SCOPED_TRACE(std::string(spec.technique) + std::to_string(spec.samples));
            expectExpanded(planFor(spec, caps));
            spec.chained = &drawing;
            EXPECT_THROW(planFor(spec, caps), Error);
        }
        // AUTO selects the tiers, too.
        for (const char* technique : {"dcaa", "agaa"})
            expectExpanded(planFor(specOf(technique, AGAA_TIER_AUTO, fetch), caps));
    }
}

// Depths of samples are found first, then ids, and later passes read both from one buffer.
TEST(ComputeTriangles, IdsOfSamplesNeedNoDraws) {
    const AgaaFetchFunction fetch = expandingFetch(), drawing = expandingFetch(0);
    for (const uint32_t samples : {1u, 4u, 8u, 16u, 32u})
        for (const uint64_t flags : {UINT64_C(0), AGAA_CONFIG_BUFFERED}) {
            SCOPED_TRACE(samples);
            ViewSpec spec = specOf("agaa", AGAA_TIER_IDS, fetch);
            spec.samples = samples;
            spec.configFlags = flags;
            const Plan plan = planFor(spec, idealDevice());
            EXPECT_EQ(plan.geometryPasses(), 0u);
            std::vector<std::string> names;
            for (const Pass& pass : plan.passes)
                if (pass.stage == AGAA_STAGE_PREPASS)
                    names.push_back(pass.name);
            EXPECT_EQ(names,
                      (std::vector<std::string>{"clear samples", "count triangles", "expand triangles for depths",
                                                "list large triangles for depths", "expand large triangles for depths",
                                                "begin ids", "expand triangles for ids", "list large triangles for ids",
                                                "expand large triangles for ids"}));
            const Pass& begin = plan.passes[passAt(plan, "begin ids")];
            EXPECT_EQ(begin.fill().bytes, 4u);
            EXPECT_EQ(&plan.resources[begin.fill().destination], find(plan, "triangles"));
            EXPECT_EQ(find(plan, "depth"), nullptr);
            EXPECT_EQ(find(plan, "ids"), nullptr);
            const Resource* const visible = find(plan, "visible-samples");
            ASSERT_NE(visible, nullptr);
            EXPECT_EQ(visible->bytes, uint64_t(8) * samples * spec.width * spec.height);
            spec.chained = &drawing;
            const Plan drawn = planFor(spec, idealDevice());
            EXPECT_EQ(drawn.geometryPasses(), 1u);
            EXPECT_EQ(plan.view.samplePositions, drawn.view.samplePositions);
            EXPECT_EQ(plan.view.hwSamples, drawn.view.hwSamples) << "samples lie where the rasteriser has them";
        }
}

// Fragments that carry their materials come from shaders of the host, and depth that materials write, draws that cannot
// be fetched and the samples of "adaptive" from the rasteriser.
TEST(ComputeTriangles, OtherTiersAreDrawn) {
    const AgaaFetchFunction fetch = expandingFetch();
    const auto expectDrawn = [](const ViewSpec& spec) {
        SCOPED_TRACE(agaaTierName(spec.generationTier));
        const Plan plan = planFor(spec, idealDevice());
        EXPECT_GE(plan.geometryPasses(), 1u);
        EXPECT_EQ(find(plan, "triangles"), nullptr);
        for (const std::string& name : expansion)
            EXPECT_EQ(passAt(plan, name), plan.passes.size()) << name;
    };
    for (const AgaaTier tier : {AGAA_TIER_MATERIAL_LISTS, AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER})
        expectDrawn(specOf("dcaa", tier, fetch));
    ViewSpec ids = specOf("agaa", AGAA_TIER_IDS, fetch);
    ids.samples = 8;
    AgaaFetchFunction some = fetch;
    some.flags = AGAA_FETCH_NOT_ALL_DRAWS;
    ids.chained = &some;
    expectDrawn(ids);
    ids.chained = &fetch;
    ids.facts = AGAA_FACT_CUSTOM_DEPTH;
    expectDrawn(ids);
    ids.facts = AGAA_FACT_ALL_SHADED;
    ids.configFlags = AGAA_CONFIG_ACCUMULATE;
    expectDrawn(ids);
    ViewSpec adaptive = specOf("adaptive", AGAA_TIER_IDS, fetch);
    adaptive.samples = 8;
    expectDrawn(adaptive);
}

AgaaResult refusal(const ViewSpec& spec, const AgaaDeviceCaps& caps, std::string& message) {
    try {
        planFor(spec, caps);
    } catch (const Error& error) {
        message = error.message;
        return error.code;
    }
    return AGAA_OK;
}

TEST(ComputeTriangles, WrongMembersAreRefused) {
    std::string message;
    for (const auto& [technique, tier] :
         {std::pair{"dcaa", AGAA_TIER_FRAGMENT_LISTS}, {"dcaa", AGAA_TIER_MATERIAL_LISTS}, {"agaa", AGAA_TIER_IDS}}) {
        AgaaFetchFunction fetch = expandingFetch();
        ViewSpec spec = specOf(technique, tier, fetch);
        spec.samples = tier == AGAA_TIER_IDS ? 8 : 64;
        EXPECT_EQ(refusal(spec, idealDevice(), message), AGAA_OK);
        for (const uint32_t wrong : {1u << 31, 0xFFFFFFFFu}) {
            fetch.maxTriangles = wrong;
            EXPECT_EQ(refusal(spec, idealDevice(), message), AGAA_ERROR_OUT_OF_RANGE) << wrong;
            EXPECT_NE(message.find("AgaaFetchFunction::maxTriangles"), std::string::npos) << message;
        }
        fetch = expandingFetch();
        fetch.reserved = 1;
        EXPECT_EQ(refusal(spec, idealDevice(), message), AGAA_ERROR_OUT_OF_RANGE);
        EXPECT_NE(message.find("AgaaFetchFunction::reserved"), std::string::npos) << message;
    }
}

// Each triangle takes 8 bytes of one buffer.
TEST(ComputeTriangles, ListsFitAStorageBuffer) {
    AgaaDeviceCaps caps = fourSampleDevice();
    const uint32_t words = uint32_t(caps.maxStorageRange / 4), most = (words - AGAA_TRIANGLE_SUMS - draws) / 2;
    AgaaFetchFunction fetch = expandingFetch(most);
    const ViewSpec spec = specOf("dcaa", AGAA_TIER_FRAGMENT_LISTS, fetch);
    std::string message;
    EXPECT_EQ(refusal(spec, caps, message), AGAA_OK) << message;
    for (const uint32_t tooMany : {most + 1, (1u << 31) - 1}) {
        fetch.maxTriangles = tooMany;
        EXPECT_EQ(refusal(spec, caps, message), AGAA_ERROR_TOO_LARGE);
        EXPECT_NE(message.find("AgaaFetchFunction::maxTriangles is " + std::to_string(tooMany)), std::string::npos)
            << message;
        EXPECT_NE(message.find(std::to_string(4 * (AGAA_TRIANGLE_SUMS + draws + 2 * uint64_t(tooMany))) + " bytes"),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find(std::to_string(caps.maxStorageRange)), std::string::npos) << message;
        EXPECT_EQ(message.back(), '.');
    }
    // 8 bytes for each of 16 samples of 1024x1024 pixels are 128 MiB.
    fetch.maxTriangles = 1;
    ViewSpec ids = specOf("agaa", AGAA_TIER_IDS, fetch);
    ids.samples = 16;
    ids.width = 1024;
    ids.height = 1025;
    EXPECT_EQ(refusal(ids, caps, message), AGAA_ERROR_TOO_LARGE);
    EXPECT_NE(message.find("AgaaFetchFunction::maxTriangles"), std::string::npos) << message;
    ids.height = 1024;
    EXPECT_EQ(refusal(ids, caps, message), AGAA_OK) << message;
    // Views whose host draws have no list.
    EXPECT_EQ(refusal(specOf("dcaa", AGAA_TIER_MATERIAL_LISTS, fetch), caps, message), AGAA_OK);
}

} // namespace
} // namespace agaa::test
