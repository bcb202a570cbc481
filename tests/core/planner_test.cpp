// What the planner decides: tiers, formats, passes, and what it leaves out.
#include "plan_support.h"

#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/glsl/host_glsl.h"
#include "core/plan/plan_builder.h"
#include "core/plan/sample_patterns.h"
#include "core/view/tiers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <tuple>

using namespace agaa;
using namespace agaa::test;

namespace {

TEST(Planner, ScaledTargetsGiveTheAskedSamplesOnAFourSampleDevice) {
    const std::pair<uint32_t, std::pair<uint32_t, uint32_t>> expected[] = {{8, {1, 2}}, {16, {2, 2}}, {32, {2, 4}}};
    for (const auto& [samples, scale] : expected) {
        ViewSpec spec;
        spec.samples = samples;
        const Plan plan = planFor(spec, fourSampleDevice());
        EXPECT_EQ(plan.view.visibilityTier, AGAA_TIER_SCALED_TARGET);
        EXPECT_EQ(plan.view.hwSamples, 4u);
        EXPECT_EQ(std::pair(plan.view.scaleX, plan.view.scaleY), scale);
    }
    ViewSpec four;
    four.samples = 4;
    EXPECT_EQ(planFor(four, fourSampleDevice()).view.visibilityTier, AGAA_TIER_NATIVE);
}

// A bit of AgaaDeviceCaps::sampleCounts names a power of two only.
TEST(Planner, TiersRefuseNumbersOfSamplesThatNoTargetHas) {
    const auto expectRefused = [](uint32_t samples, const auto& choose) {
        try {
            choose();
            ADD_FAILURE() << samples;
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_OUT_OF_RANGE) << samples;
            EXPECT_NE(error.message.find("not one of 1, 2, 4, 8, 16, 32"), std::string::npos) << error.message;
        }
    };
    for (uint32_t samples : {0u, 3u, 10u, 24u, 64u})
        for (uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_NATIVE, AGAA_TIER_SCALED_TARGET, AGAA_TIER_ORDERED_GRID,
                              AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST}) {
            expectRefused(samples, [&] { chooseVisibility(idealDevice(), samples, tier); });
            expectRefused(samples, [&] {
                const AgaaDeviceCaps caps = idealDevice();
                chooseGeneration(techniques(), *findTechnique(techniques(), "agaa"),
                                 {.caps = caps, .hwSamples = samples}, AGAA_TIER_AUTO);
            });
        }
}

// The CPU writes them when it records their segment, while the device may run the segments before.
TEST(Planner, UploadsAreReadInOneSegmentEach) {
    for (const Technique* technique : techniques())
        for (uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED | AGAA_CONFIG_COUNTERS}) {
            ViewSpec spec{.technique = technique->name, .configFlags = flags};
            spec.samples = technique->maxSamples ? std::min(technique->maxSamples, 8u) : 32u;
            const Plan plan = planFor(spec, fourSampleDevice());
            for (const Resource& resource : plan.resources) {
                const bool isUpload = resource.content != UploadContent::None;
                EXPECT_TRUE(!isUpload || std::popcount(resource.segments) <= 1)
                    << technique->name << ", " << resource.name;
            }
        }
}

// AgaaFrameStatistics has room for AGAA_MAX_PASSES times, and none may be left out in silence.
TEST(Planner, APlanHasNoMorePassesThanStatisticsHold) {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = view.height = 64;
    view.config = &config;
    view.facts = &facts;
    const auto build = [&](size_t passes) {
        PlanBuilder builder(resolveForDevice(resolveView(&view, techniques()), idealDevice(), techniques()),
                            idealDevice(), 2);
        const ResourceId buffer = builder.pixelBuffer("words", 4);
        while (builder.plan.passes.size() < passes)
            builder.fill("clear", AGAA_STAGE_OTHER, buffer, AGAA_SEGMENT_SHADING);
        return builder.finish();
    };
    EXPECT_EQ(build(AGAA_MAX_PASSES).passes.size(), size_t(AGAA_MAX_PASSES));
    try {
        build(AGAA_MAX_PASSES + 1);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code, AGAA_ERROR_INTERNAL);
        EXPECT_NE(error.message.find(std::to_string(AGAA_MAX_PASSES + 1) + " passes"), std::string::npos)
            << error.message;
    }
}

TEST(Planner, SamplesLieApartInsideThePixel) {
    for (auto [hw, sx, sy] : {std::tuple{4u, 1u, 2u},
                              {4u, 2u, 2u},
                              {4u, 2u, 4u},
                              {8u, 2u, 2u},
                              {1u, 4u, 8u},
                              {16u, 1u, 2u},
                              {32u, 1u, 1u}}) {
        const auto positions = samplePositions(standardPositions(hw), sx, sy);
        std::set<std::pair<float, float>> distinct;
        for (uint32_t i = 0; i < hw * sx * sy; ++i) {
            EXPECT_GE(positions[i].x, 0);
            EXPECT_LT(positions[i].x, 1);
            EXPECT_GE(positions[i].y, 0);
            EXPECT_LT(positions[i].y, 1);
            distinct.insert({positions[i].x, positions[i].y});
        }
        EXPECT_EQ(distinct.size(), hw * sx * sy);
    }
}

TEST(Planner, GenerationFallsBackToOneInvocationPerSample) {
    AgaaDeviceCaps caps = fourSampleDevice();
    ViewSpec spec;
    EXPECT_EQ(planFor(spec, caps).view.generationTier, AGAA_TIER_POST_DEPTH_ATOMICS);
    caps.flags &= ~AGAA_DEVICE_POST_DEPTH_COVERAGE;
    EXPECT_EQ(planFor(spec, caps).view.generationTier, AGAA_TIER_PER_SAMPLE);
    caps.flags &= ~AGAA_DEVICE_SAMPLE_RATE_SHADING;
    EXPECT_EQ(planFor(spec, caps).view.generationTier, AGAA_TIER_GBUFFER);
    spec.generationTier = AGAA_TIER_PER_SAMPLE;
    EXPECT_THROW(planFor(spec, caps), Error);
}

// What is said to run, runs; the first row of a stage says what is taken by itself.
TEST(Planner, EveryCapabilityCanBePlanned) {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "";
    fetch.maxDraws = fetch.maxPrimitives = 1;
    AgaaFetchFunction expanding = fetch;
    expanding.maxTriangles = 1;
    AgaaDeviceCaps poor = fourSampleDevice();
    poor.flags &= ~(AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS);
    AgaaDeviceCaps noGeometryShaders = fourSampleDevice();
    noGeometryShaders.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    AgaaDeviceCaps computeOnly = poor;
    computeOnly.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    for (const AgaaDeviceCaps& caps : {idealDevice(), fourSampleDevice(), poor, noGeometryShaders, computeOnly}) {
        uint32_t count = 0;
        ASSERT_EQ(agaaQueryCapabilities(&caps, &count, nullptr), AGAA_OK);
        std::vector<AgaaCapability> rows(count, AgaaCapability AGAA_CAPABILITY_INIT);
        ASSERT_EQ(agaaQueryCapabilities(&caps, &count, rows.data()), AGAA_OK);
        std::set<std::tuple<std::string, uint32_t, uint32_t>> stages;
        std::set<uint32_t> generation;
        for (const AgaaCapability& row : rows) {
            SCOPED_TRACE(std::string(row.technique) + " " + std::to_string(row.samples) + " " +
                         agaaStageName(row.stage) + " " + agaaTierName(row.tier));
            EXPECT_EQ(std::string(row.reason).back(), '.');
            const bool isFirst = stages.emplace(row.technique, row.samples, row.stage).second;
            ViewSpec spec;
            spec.technique = row.technique;
            spec.samples = row.samples;
            spec.height = 180; // a storage buffer of these devices has room for the depths of 128 samples
            spec.fetches = false;
            const bool isVisibility = row.stage == AGAA_STAGE_PREPASS;
            const bool isGeneration = row.stage == AGAA_STAGE_GENERATION;
            if (!isVisibility && !isGeneration)
                continue;
            const bool runs = std::none_of(rows.begin(), rows.end(), [&](const AgaaCapability& other) {
                return other.tier == AGAA_TIER_AUTO && other.samples == row.samples &&
                       std::string_view(other.technique) == row.technique;
            });
            if (!runs) {
                EXPECT_THROW(planFor(spec, caps), Error);
                continue;
            }
            if (!isFirst)
                (isVisibility ? spec.visibilityTier : spec.generationTier) = row.tier;
            const bool isFragments = std::string_view(row.technique) == "agaa" && row.samples > 32;
            const std::string_view name = row.technique;
            const bool isCoverage = isFragments || name == "dcaa" || name == "sgbc";
            if (row.tier == AGAA_TIER_IDS || row.tier == AGAA_TIER_FRAGMENT_LISTS || isFragments)
                spec.chained = &fetch;
            const bool expands = isCoverage && !(caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS);
            const bool pulls = isCoverage && !expands && !(caps.flags & AGAA_DEVICE_GEOMETRY_SHADERS);
            if (isGeneration) {
                EXPECT_EQ(std::string(row.reason).starts_with("with an AgaaFetchFunction and its maxTriangles, "),
                          expands)
                    << row.reason;
                EXPECT_EQ(std::string(row.reason).find("AGAA_VIEW_VERTEX_PULLING") != std::string::npos, pulls)
                    << row.reason;
                EXPECT_EQ(std::string(row.reason).find("with an AgaaFetchFunction") != std::string::npos,
                          isFirst ? isFragments || expands : spec.chained != nullptr)
                    << row.reason;
            }
            if (pulls) {
                EXPECT_THROW(planFor(spec, caps), Error);
                spec.viewFlags = AGAA_VIEW_VERTEX_PULLING;
            }
            if (expands) {
                spec.chained = &fetch;
                EXPECT_THROW(planFor(spec, caps), Error);
                spec.chained = &expanding;
            }
            const Plan plan = planFor(spec, caps);
            EXPECT_EQ(uint32_t(isVisibility ? plan.view.visibilityTier : plan.view.generationTier), row.tier);
            if (isGeneration && std::string(row.technique) == "agaa")
                generation.insert(row.tier);
        }
        EXPECT_TRUE(generation.contains(AGAA_TIER_IDS));
        EXPECT_TRUE(generation.contains(AGAA_TIER_GBUFFER));
        EXPECT_EQ(generation.contains(AGAA_TIER_PER_SAMPLE), bool(caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS));
    }
}

uint64_t bytesOf(const Plan& plan, const std::string& name) {
    for (const Resource& resource : plan.resources)
        if (resource.name == name)
            return resource.bytes;
    return 0;
}

// DCAA section 5: four surfaces of 28 bytes, whatever the number of samples of a G-buffer of the same quality would be.
TEST(Planner, FourCoveredSurfacesAre112BytesAPixel) {
    const ViewSpec spec{.technique = "dcaa", .samples = 64, .aggregates = 4, .layout = "dcaa28"};
    const Plan plan = planFor(spec, idealDevice());
    const uint64_t pixels = uint64_t(spec.width) * spec.height;
    EXPECT_EQ(plan.bytesPerAggregate, 28u);
    EXPECT_EQ(bytesOf(plan, "surfaces"), 112 * pixels);
    EXPECT_EQ(bytesOf(plan, "fragments"), listBytes(spec, 20));
    EXPECT_EQ(plan.geometryPasses(), 1u);
    EXPECT_EQ(plan.view.hwSamples, 1u);
}

// A pool that one storage buffer of the device does not hold is made smaller, but not below a fragment a pixel.
TEST(Planner, ListsFitAStorageBuffer) {
    ViewSpec spec{.technique = "dcaa", .samples = 64, .aggregates = 4, .width = 1920, .height = 1080};
    AgaaDeviceCaps caps = idealDevice();
    caps.maxStorageRange = UINT64_C(128) << 20;
    EXPECT_THROW(planFor(spec, caps), Error) << "the surfaces";
    spec.layout = "dcaa28";
    spec.aggregates = 2;
    const Plan plan = planFor(spec, caps);
    EXPECT_LE(bytesOf(plan, "fragments"), caps.maxStorageRange);
    EXPECT_GT(bytesOf(plan, "fragments"), caps.maxStorageRange - 64);
    EXPECT_TRUE(std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
        return note.find("lists: room for 2.6 fragments a pixel") != std::string::npos;
    }));
    caps.maxStorageRange = UINT64_C(32) << 20;
    EXPECT_THROW(planFor(spec, caps), Error);
}

TEST(Planner, CoverageSamplesAre32Or64Or128) {
    for (const uint32_t samples : {33u, 48u, 96u, 256u})
        EXPECT_THROW(planFor({.technique = "dcaa", .samples = samples}, idealDevice()), Error) << samples;
    EXPECT_THROW(
        planFor({.technique = "dcaa", .samples = 64, .visibilityTier = AGAA_TIER_SCALED_TARGET}, idealDevice()), Error);
    AgaaDeviceCaps caps = idealDevice();
    caps.flags &= ~AGAA_DEVICE_GEOMETRY_SHADERS;
    EXPECT_THROW(planFor({.technique = "dcaa", .samples = 64}, caps), Error);
}

// Of "agaa": at 64 and 128 AUTO takes coverage samples, at 32 the device's.
TEST(Planner, FragmentsAreATierOfCoverageSamples) {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "";
    fetch.maxDraws = fetch.maxPrimitives = 1;
    ViewSpec spec{.technique = "agaa", .samples = 64, .aggregates = 2, .chained = &fetch};
    for (const uint32_t samples : {64u, 128u}) {
        spec.samples = samples;
        const Plan plan = planFor(spec, idealDevice());
        EXPECT_EQ(plan.view.generationTier, AGAA_TIER_FRAGMENTS);
        EXPECT_EQ(plan.view.hwSamples, 1u);
        EXPECT_EQ(plan.geometryPasses(), 1u);
        // A fragment has its id, next fragment, depth, mask, plane and aggregate.
        EXPECT_EQ(bytesOf(plan, "fragments"), listBytes(spec, 32 + samples / 8));
        EXPECT_EQ(plan.totalBytes(), bytesOf(plan, "fragments"));
    }
    spec.samples = 32;
    EXPECT_EQ(planFor(spec, idealDevice()).view.generationTier, AGAA_TIER_IDS);
    spec.generationTier = AGAA_TIER_FRAGMENTS;
    EXPECT_EQ(planFor(spec, idealDevice()).view.generationTier, AGAA_TIER_FRAGMENTS);
    spec.technique = "sbaa";
    EXPECT_THROW(planFor(spec, idealDevice()), Error);
}

// Such materials are drawn once: no pass can test against a depth that they have yet to write.
TEST(Planner, MaterialsOfTheirOwnDepthGoThroughAGBuffer) {
    ViewSpec spec;
    spec.facts |= AGAA_FACT_CUSTOM_DEPTH;
    const Plan plan = planFor(spec, fourSampleDevice());
    EXPECT_EQ(plan.view.generationTier, AGAA_TIER_GBUFFER);
    EXPECT_EQ(plan.geometryPasses(), 1u);
    spec.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
    EXPECT_THROW(planFor(spec, fourSampleDevice()), Error);
}

// The row of a technique says which facts views may announce.
TEST(Planner, FactsThatATechniqueCannotShowAreRefused) {
    for (const Technique* technique : techniques())
        for (const uint64_t fact :
             {AGAA_FACT_CUSTOM_DEPTH, AGAA_FACT_ONE_ROUGHNESS, AGAA_FACT_NO_DIFFUSE, AGAA_FACT_PLANE_NORMALS}) {
            ViewSpec spec;
            spec.technique = technique->name;
            spec.samples = technique->maxSamples == 0 ? 64 : 1;
            spec.facts |= fact;
            SCOPED_TRACE(std::string(technique->name) + " " + std::to_string(fact));
            if (technique->facts & fact) {
                EXPECT_NO_THROW(planFor(spec, idealDevice()));
            } else {
                EXPECT_THROW(planFor(spec, idealDevice()), Error);
            }
        }
    EXPECT_FALSE(findTechnique(techniques(), "msaa")->facts & AGAA_FACT_CUSTOM_DEPTH);
}

TEST(Planner, AggregatesThatNoBufferHoldsAreNotKept) {
    const AgaaDeviceCaps caps = fourSampleDevice();
    EXPECT_NE(planFor({}, caps).view.generationTier, uint32_t(AGAA_TIER_GBUFFER));
    const ViewSpec large{.width = 1920, .height = 1080};
    const Plan plan = planFor(large, caps);
    EXPECT_EQ(plan.view.generationTier, uint32_t(AGAA_TIER_GBUFFER));
    EXPECT_EQ(plan.bytesPerAggregate, 0u);
    EXPECT_TRUE(std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
        return note.find("aggregates would take 149299200 bytes") != std::string::npos;
    }));
    ViewSpec asked = large;
    asked.generationTier = AGAA_TIER_PER_SAMPLE;
    try {
        planFor(asked, caps);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code, AGAA_ERROR_TOO_LARGE);
        EXPECT_NE(error.message.find("149299200 bytes"), std::string::npos) << error.message;
    }
    asked = large;
    asked.configFlags = AGAA_CONFIG_BUFFERED;
    EXPECT_THROW(planFor(asked, caps), Error);
    EXPECT_NO_THROW(planFor({.technique = "ssaa", .width = 1920, .height = 1080}, caps));
}

TEST(Planner, ForcedTiersAreKeptOrRefused) {
    ViewSpec spec;
    spec.generationTier = AGAA_TIER_PER_SAMPLE;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).view.generationTier, AGAA_TIER_PER_SAMPLE);
    spec.generationTier = AGAA_TIER_GBUFFER;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).view.generationTier, AGAA_TIER_GBUFFER);
    spec.generationTier = AGAA_TIER_NATIVE; // of another stage
    EXPECT_THROW(planFor(spec, fourSampleDevice()), Error);
    spec.generationTier = AGAA_TIER_AUTO;
    spec.visibilityTier = AGAA_TIER_NATIVE;
    EXPECT_THROW(planFor(spec, fourSampleDevice()), Error); // no 8 samples
    spec.visibilityTier = AGAA_TIER_SCALED_TARGET;
    spec.samples = 4;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).view.hwSamples, 1u);
    spec.samples = 1;
    EXPECT_THROW(planFor(spec, fourSampleDevice()), Error);
}

TEST(Planner, ReversedZGetsAFloatFormat) {
    ViewSpec spec;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).depthFormat, Format::D24S8);
    spec.viewFlags = AGAA_VIEW_REVERSED_Z;
    EXPECT_EQ(planFor(spec, fourSampleDevice()).depthFormat, Format::D32S8);
    spec.technique = "ssaa";
    EXPECT_EQ(planFor(spec, fourSampleDevice()).depthFormat, Format::D32);
}

TEST(Planner, LightsAreCulledWhereThereAreManyAndADepth) {
    const auto passesOf = [](const ViewSpec& spec) {
        const Plan plan = planFor(spec, fourSampleDevice());
        const auto isCulling = [](const Pass& pass) {
            return pass.kind() == PassKind::Compute && pass.compute().file == "common/cull_lights.comp";
        };
        const auto cull = std::ranges::find_if(plan.passes, isCulling);
        const bool culls = cull != plan.passes.end();
        for (const Pass& pass : plan.passes)
            for (const Binding& binding : pass.bindings)
                if (pass.kind() == PassKind::Compute && binding.slot == slot::LightMasks && !isCulling(pass)) {
                    EXPECT_EQ(pass.constants[AGAA_LIGHT_WORDS], culls ? (spec.maxLights + 31) / 32 : 0) << pass.name;
                    EXPECT_FALSE(binding.writes);
                }
        EXPECT_EQ(std::ranges::find(plan.effects, "light-culling") != plan.effects.end(), culls);
        if (culls) {
            const uint64_t tiles = (640 / 8) * (360 / 8), words = (spec.maxLights + 31) / 32;
            EXPECT_EQ(plan.resources[plan.surface("light-masks")].bytes, tiles * (words + 1) * 4);
        }
        return std::ranges::count_if(plan.passes, isCulling);
    };
    for (const char* technique : {"single", "fxaa", "ssaa", "simple_complex", "adaptive", "agaa", "sbaa"}) {
        ViewSpec spec{.technique = technique};
        for (const uint32_t lights : {0u, 7u, 8u, 33u, 4096u}) {
            spec.maxLights = lights;
            EXPECT_EQ(passesOf(spec), lights >= 8) << technique << lights;
        }
        spec.change = [](TechniqueConfig& config) { config.measurement.flags |= AGAA_MEASURE_NO_LIGHT_CULLING; };
        EXPECT_EQ(passesOf(spec), 0) << technique;
    }
    EXPECT_EQ(passesOf({.technique = "msaa", .maxLights = 64}), 0);
}

TEST(Planner, PassesWithoutDepthFindTheirLights) {
    const auto expectCulling = [](const ViewSpec& spec, const char* pass, bool culls) {
        SCOPED_TRACE(format("%s, %u lights", pass, spec.maxLights));
        const Plan plan = planFor(spec, fourSampleDevice());
        const auto shade = std::ranges::find(plan.passes, pass, &Pass::name);
        ASSERT_NE(shade, plan.passes.end());
        EXPECT_EQ(shade->constants[AGAA_LIGHT_WORDS], culls ? (spec.maxLights + 31) / 32 : 0);
        EXPECT_EQ(std::ranges::find(plan.effects, "light-culling") != plan.effects.end(), culls);
        for (const Resource& resource : plan.resources)
            EXPECT_NE(resource.name, "light-masks");
    };
    struct Way {
        const char* technique;
        const char* pass;
        AgaaTier tier;
        uint64_t coverage;
    };
    for (const auto& [technique, pass, tier, coverage] :
         {Way{"dcaa", "shade surfaces", AGAA_TIER_AUTO, 0},
          {"dcaa", "shade fragments", AGAA_TIER_MATERIAL_LISTS, AGAA_COVERAGE_EXACT},
          {"agaa", "aggregate and shade", AGAA_TIER_FRAGMENTS, 0}}) {
        ViewSpec spec{.technique = technique, .samples = 32};
        const auto change = [=](TechniqueConfig& config) {
            config.generationTier = tier;
            config.coverage.flags = coverage;
        };
        spec.change = change;
        for (const uint32_t lights : {7u, 8u, 33u}) {
            spec.maxLights = lights;
            expectCulling(spec, pass, lights >= 8);
        }
        spec.change = [=](TechniqueConfig& config) {
            change(config);
            config.measurement.flags |= AGAA_MEASURE_NO_LIGHT_CULLING;
        };
        expectCulling(spec, pass, false);
        spec.change = change;
        spec.facts |= AGAA_FACT_NO_LOCAL_LIGHTS;
        expectCulling(spec, pass, false);
    }
}

// OpenGL has few places of a kind, so that slots share them: never in one pass. Hosts have storage buffers from place 4
// on, but where there are lists of fragments.
TEST(Planner, SlotsOfAPassHavePlacesOfTheirOwn) {
    const auto check = [](const ViewSpec& spec, uint32_t ends) {
        const Plan plan = planFor(spec, idealDevice());
        for (const Pass& pass : plan.passes) {
            std::map<std::pair<BindingKind, uint32_t>, uint32_t> slots;
            for (const Binding& binding : pass.bindings) {
                if (pass.kind() != PassKind::Compute)
                    continue;
                const BindingRow& row = bindingTable[binding.slot];
                const uint32_t first = slots.try_emplace({row.kind, row.openGl}, binding.slot).first->second;
                EXPECT_EQ(first, binding.slot) << spec.technique << ": " << pass.name;
                if (row.kind == BindingKind::Storage) {
                    EXPECT_LT(row.openGl, ends) << spec.technique << ": " << pass.name;
                }
            }
        }
    };
    for (const char* technique : {"single", "fxaa", "ssaa", "simple_complex", "adaptive", "agaa", "sbaa"})
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_COUNTERS})
            for (const uint32_t lights : {4u, 64u})
                check({.technique = technique, .samples = 4, .configFlags = flags, .maxLights = lights}, 4);
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "void agaaHostTriangle";
    function.maxDraws = function.maxPrimitives = 100;
    for (const char* technique : {"adaptive", "agaa"})
        for (const uint64_t flags : {AGAA_CONFIG_COUNTERS, AGAA_CONFIG_COUNTERS | AGAA_CONFIG_BUFFERED})
            check({.technique = technique,
                   .generationTier = AGAA_TIER_IDS,
                   .configFlags = flags,
                   .maxLights = 64,
                   .chained = &function},
                  4);
    check({.technique = "dcaa", .samples = 64, .configFlags = AGAA_CONFIG_COUNTERS, .maxLights = 64}, 5);
    check({.technique = "agaa", .samples = 64, .configFlags = AGAA_CONFIG_COUNTERS, .maxLights = 64}, 5);
}

TEST(Planner, EffectsTheSceneDoesNotCallForLeaveNoTrace) {
    ViewSpec all;
    ViewSpec none;
    none.facts = 0;
    none.shadowMaps = 0;
    const Plan rich = planFor(all, fourSampleDevice());
    const Plan poor = planFor(none, fourSampleDevice());
    EXPECT_LT(poor.bytesPerAggregate, rich.bytesPerAggregate);
    for (const Resource& resource : poor.resources)
        EXPECT_NE(resource.kind, ResourceKind::ShadowMap);
    for (const std::string& effect : poor.effects)
        EXPECT_TRUE(effect == "filtered-diffuse") << effect;
    for (const char* effect : {"specular", "emissive", "ambient", "shadows", "shadow-filter"})
        EXPECT_NE(std::find(rich.effects.begin(), rich.effects.end(), effect), rich.effects.end());
}

// Of aggregates in memory, the length of a normal that roughness is folded into does not tell how normals spread.
TEST(Planner, FoldedAggregatesInMemoryAreNotFiltered) {
    const auto filters = [](const ViewSpec& spec) {
        const std::vector<std::string>& effects = planFor(spec, fourSampleDevice()).effects;
        return std::find(effects.begin(), effects.end(), "filtered-diffuse") != effects.end();
    };
    for (const uint32_t tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER})
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            if (tier == AGAA_TIER_PER_SAMPLE && flags)
                continue;
            const bool isInMemory = tier == AGAA_TIER_PER_SAMPLE || flags;
            EXPECT_TRUE(filters({.generationTier = tier, .configFlags = flags}));
            EXPECT_EQ(filters({.layout = "paper16", .generationTier = tier, .configFlags = flags}), !isInMemory);
        }
}

void expectShadersOf(const ViewSpec& spec) {
    for (const Pass& pass : planFor(spec, fourSampleDevice()).passes)
        EXPECT_TRUE(pass.kind() != PassKind::Compute || !pass.compute().hostCode.empty() ||
                    hasSpirv(pass.compute().shader))
            << pass.compute().shader;
}

TEST(Planner, EveryShaderOfEveryPlanIsInTheLibrary) {
    for (const Technique* technique : techniques())
        for (uint32_t samples : {1u, 4u, 8u, 32u})
            for (uint32_t maps : {0u, 1u, 4u})
                for (uint64_t flags : {UINT64_C(0), AGAA_CONFIG_COUNTERS})
                    for (uint64_t view : {UINT64_C(0), AGAA_VIEW_COMPOSITE}) {
                        ViewSpec spec;
                        spec.technique = technique->name;
                        spec.samples = samples;
                        spec.shadowMaps = maps;
                        spec.configFlags = flags;
                        spec.viewFlags = view;
                        expectShadersOf(spec);
                    }
}

// Passes that call functions of the host's are compiled with them; these call none.
TEST(Planner, EveryShaderOfEveryWayOfAgaaIsInTheLibrary) {
    for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
        for (uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER})
            for (uint64_t flags : {UINT64_C(0), AGAA_CONFIG_COUNTERS, AGAA_CONFIG_SPLIT_SURFACES, AGAA_CONFIG_BUFFERED,
                                   AGAA_CONFIG_BUFFERED | AGAA_CONFIG_COUNTERS})
                for (const char* preset : {"", "paper", "fast", "balanced", "accurate"}) {
                    const bool isLit = std::string_view(preset) == "balanced" || std::string_view(preset) == "accurate";
                    if (isLit && (tier != AGAA_TIER_GBUFFER || flags & AGAA_CONFIG_BUFFERED))
                        continue; // is refused
                    ViewSpec spec;
                    spec.samples = samples;
                    spec.change = [&](TechniqueConfig& config) {
                        if (*preset) {
                            ASSERT_EQ(config.applyPreset(preset), AGAA_OK);
                        }
                        config.generationTier = tier;
                        config.flags |= flags;
                    };
                    expectShadersOf(spec);
                }
}

TEST(Planner, SingleRunsAtOneSampleWhateverIsAsked) {
    ViewSpec spec;
    spec.technique = "single";
    EXPECT_EQ(planFor(spec, fourSampleDevice()).view.samples, 1u);
}

TEST(Planner, PipelineKeysChangeOnlyWithWhatPipelinesDependOn) {
    const auto keys = [](const ViewSpec& spec) {
        const Plan plan = planFor(spec, fourSampleDevice());
        std::vector<uint64_t> list;
        for (const Pass& pass : plan.passes)
            if (pass.kind() == PassKind::HostDraw)
                list.push_back(hostPassKey(plan, pass, {}));
        return list;
    };
    ViewSpec spec;
    const auto base = keys(spec);
    spec.width = 100;
    EXPECT_EQ(keys(spec), base);
    spec.shadowMaps = 0; // only shading depends on it
    EXPECT_EQ(keys(spec), base);
    spec.aggregates = 3;
    EXPECT_EQ(keys(spec)[0], base[0]);
    EXPECT_NE(keys(spec)[1], base[1]);
    spec.samples = 16;
    EXPECT_NE(keys(spec)[0], base[0]);
}

} // namespace
