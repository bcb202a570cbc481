// Plans of "dcaa" whose fragments carry their materials.
#include "plan_support.h"

#include "core/error.h"
#include "core/host_glsl.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

ViewSpec carried() {
    return {.technique = "dcaa", .samples = 64, .aggregates = 4, .layout = "dcaa28",
            .generationTier = AGAA_TIER_MATERIAL_LISTS, .fetches = false};
}

uint64_t bytesOf(const Plan& plan, const std::string& name) { return plan.resources[plan.surface(name.c_str())].bytes; }

// Number, next fragment, coverage, depth plane, normal and material.
TEST(CoveragePlan, FragmentsWithMaterialsAreOf36Bytes) {
    ViewSpec spec = carried();
    const Plan plan = planFor(spec, idealDevice());
    const uint64_t pixels = uint64_t(spec.width) * spec.height;
    EXPECT_EQ(plan.bytesPerAggregate, 28u);
    EXPECT_EQ(bytesOf(plan, "surfaces"), 112 * pixels);
    EXPECT_EQ(bytesOf(plan, "fragments"), (4 + 8 * 36) * pixels + 64);
    for (const auto& [samples, bytes] : {std::pair{32u, 32u}, {128u, 44u}}) {
        spec.samples = samples;
        EXPECT_EQ(bytesOf(planFor(spec, idealDevice()), "fragments"), (4 + 8 * bytes) * pixels + 64) << samples;
    }
}

// AUTO fetches where the host can for all draws. Otherwise fragments carry their materials.
TEST(CoveragePlan, FragmentsCarryMaterialsThatCannotBeFetched) {
    AgaaFetchFunction all = AGAA_FETCH_FUNCTION_INIT;
    all.glsl = "";
    all.maxDraws = all.maxPrimitives = 1;
    AgaaFetchFunction some = all;
    some.flags = AGAA_FETCH_NOT_ALL_DRAWS;
    ViewSpec spec = carried();
    const auto tierWith = [&](const AgaaFetchFunction* fetch, uint32_t tier) {
        spec.chained = fetch;
        spec.generationTier = tier;
        return planFor(spec, fourSampleDevice()).generationTier;
    };
    EXPECT_EQ(tierWith(&all, AGAA_TIER_AUTO), AGAA_TIER_FRAGMENT_LISTS);
    for (const AgaaFetchFunction* fetch : std::initializer_list<const AgaaFetchFunction*>{&some, nullptr})
        EXPECT_EQ(tierWith(fetch, AGAA_TIER_AUTO), AGAA_TIER_MATERIAL_LISTS);
    EXPECT_EQ(tierWith(&all, AGAA_TIER_MATERIAL_LISTS), AGAA_TIER_MATERIAL_LISTS);
}

TEST(CoveragePlan, WhatFragmentsCannotCarryIsRefused) {
    const auto refusal = [](const ViewSpec& spec, const AgaaDeviceCaps& caps) {
        try {
            planFor(spec, caps);
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_UNSUPPORTED);
            return error.message;
        }
        return std::string("none");
    };
    ViewSpec depth = carried();
    depth.facts |= AGAA_FACT_CUSTOM_DEPTH;
    EXPECT_NE(refusal(depth, idealDevice()).find("discard on their own"), std::string::npos);
    ViewSpec other = carried();
    other.technique = "agaa";
    other.samples = 8;
    EXPECT_NE(refusal(other, idealDevice()).find("the tier material-lists is for"), std::string::npos);
    for (const uint64_t flag : {AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_DEVICE_GEOMETRY_SHADERS}) {
        AgaaDeviceCaps caps = idealDevice();
        caps.flags &= ~flag;
        EXPECT_NE(refusal(carried(), caps).find("the device has no"), std::string::npos) << flag;
    }
}

// Hosts evaluate materials where the text says so.
TEST(CoveragePlan, DeclarationsAskForMaterials) {
    const auto declarations = [](const ViewSpec& spec) {
        const Plan plan = planFor(spec, idealDevice());
        for (const Pass& pass : plan.passes)
            if (pass.kind == PassKind::HostDraw)
                return hostDeclarations(plan, pass, {});
        return std::string();
    };
    ViewSpec fetched = carried();
    fetched.generationTier = AGAA_TIER_FRAGMENT_LISTS;
    fetched.fetches = true;
    EXPECT_NE(declarations(fetched).find("#define AGAA_NEEDS_MATERIAL 0\n"), std::string::npos);
    EXPECT_NE(declarations(carried()).find("#define AGAA_NEEDS_MATERIAL 1\n"), std::string::npos);
}

} // namespace
} // namespace agaa::test
