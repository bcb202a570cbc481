// The choice of the lanes of passes that group the samples of pixels, and of the memory of passes that merge fragments.
#include "plan_support.h"

#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/glsl_text.h"
#include "core/plan/permutations.h"
#include "core/view/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace agaa;
using namespace agaa::test;

namespace {

AgaaDeviceCaps deviceWith(uint32_t subgroupSize, uint32_t sharedBytes = 49152, uint64_t flags = 0) {
    AgaaDeviceCaps caps = idealDevice();
    caps.subgroupSize = subgroupSize;
    caps.maxSharedBytes = sharedBytes;
    caps.flags |= flags;
    return caps;
}

ViewSpec specWith(uint32_t samples, AgaaLanes lanes, AgaaTier tier = AGAA_TIER_GBUFFER) {
    ViewSpec spec;
    spec.samples = samples;
    spec.generationTier = tier;
    spec.change = [=](TechniqueConfig& config) { config.measurement.lanes = lanes; };
    return spec;
}

std::string noteOf(const Plan& plan) {
    const auto note = std::ranges::find_if(plan.notes, [](const std::string& n) { return n.starts_with("lanes: "); });
    return note == plan.notes.end() ? "" : *note;
}

std::string messageOf(const ViewSpec& spec, const AgaaDeviceCaps& caps, AgaaResult result) {
    try {
        planFor(spec, caps);
    } catch (const Error& error) {
        EXPECT_EQ(error.code, result) << error.message;
        return error.message;
    }
    ADD_FAILURE() << "the plan succeeds";
    return "";
}

TEST(Lanes, AutoTakesTheFastestThatTheDeviceRuns) {
    struct Row {
        AgaaDeviceCaps caps;
        uint32_t samples;
        AgaaLanes lanes;
        const char* words; // of the note
    };
    const Row rows[] = {
        {deviceWith(32), 32, AGAA_LANES_SAMPLE_SUBGROUP, "in subgroups of 32."},
        {deviceWith(8), 8, AGAA_LANES_SAMPLE_SUBGROUP, "in subgroups of 8."},
        {deviceWith(64), 2, AGAA_LANES_SAMPLE_SUBGROUP, "in subgroups of 64."},
        {deviceWith(8), 16, AGAA_LANES_SAMPLE_SHARED, "subgroups of the device have 8 lanes, and 16 to 64 are needed"},
        {deviceWith(128), 8, AGAA_LANES_SAMPLE_SHARED, "subgroups of the device have 128 lanes"},
        {deviceWith(0), 8, AGAA_LANES_SAMPLE_SHARED, "no subgroup operations, or no full subgroups"},
        {deviceWith(0, 16384), 8, AGAA_LANES_SAMPLE_SHARED, "with shared memory"},
        {deviceWith(32, 16384), 32, AGAA_LANES_PIXEL, "16384 bytes of shared memory"},
        {deviceWith(32), 1, AGAA_LANES_PIXEL, "one sample"},
        {deviceWith(32, 49152, AGAA_DEVICE_SOFTWARE), 8, AGAA_LANES_PIXEL, "software"},
    };
    for (const Row& row : rows) {
        const Plan plan = planFor(specWith(row.samples, AGAA_LANES_AUTO), row.caps);
        EXPECT_EQ(plan.view.lanes, row.lanes) << noteOf(plan);
        EXPECT_NE(noteOf(plan).find(row.words), std::string::npos) << noteOf(plan);
        EXPECT_TRUE(noteOf(plan).ends_with('.')) << noteOf(plan);
        EXPECT_NE(planToJson(plan).find(format("\"lanes\":\"%s\"", lanesName(row.lanes))), std::string::npos);
    }
}

TEST(Lanes, AForcedChoiceRunsOrFails) {
    for (const AgaaLanes lanes : {AGAA_LANES_PIXEL, AGAA_LANES_SAMPLE_SHARED, AGAA_LANES_SAMPLE_SUBGROUP}) {
        const Plan plan = planFor(specWith(8, lanes), deviceWith(8, 49152, AGAA_DEVICE_SOFTWARE));
        EXPECT_EQ(plan.view.lanes, lanes);
        EXPECT_NE(noteOf(plan).find("AgaaMeasurement::lanes"), std::string::npos) << noteOf(plan);
    }
    const auto refused = [](uint32_t samples, AgaaLanes lanes, const AgaaDeviceCaps& caps, const char* words) {
        const std::string message = messageOf(specWith(samples, lanes), caps, AGAA_ERROR_UNSUPPORTED);
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    refused(8, AGAA_LANES_SAMPLE_SUBGROUP, deviceWith(0), "no full subgroups.");
    refused(32, AGAA_LANES_SAMPLE_SUBGROUP, deviceWith(16), "16 lanes");
    refused(32, AGAA_LANES_SAMPLE_SUBGROUP, deviceWith(32, 16384), "16384 bytes");
    refused(32, AGAA_LANES_SAMPLE_SHARED, deviceWith(32, 16384), "16384 bytes");
    const std::string message =
        messageOf(specWith(8, AgaaLanes(AGAA_LANES_SAMPLE_SUBGROUP + 1)), deviceWith(32), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_NE(message.find("AgaaMeasurement::lanes"), std::string::npos) << message;
}

TEST(Lanes, OtherTechniquesDoNotUseTheSetting) {
    for (const char* technique : {"ssaa", "fxaa"}) {
        ViewSpec spec = specWith(4, AGAA_LANES_SAMPLE_SUBGROUP, AGAA_TIER_AUTO);
        spec.technique = technique;
        const Plan plan = planFor(spec, deviceWith(0));
        EXPECT_EQ(plan.view.lanes, AGAA_LANES_AUTO) << technique;
        EXPECT_EQ(noteOf(plan), "") << technique;
        EXPECT_EQ(planToJson(plan).find("\"lanes\""), std::string::npos) << technique;
    }
}

// The first dimension of a module's workgroups (OpExecutionMode LocalSize).
uint32_t workgroupWidth(std::span<const uint32_t> words) {
    for (size_t at = 5; at < words.size(); at += words[at] >> 16)
        if ((words[at] & 0xFFFF) == 16 && words[at + 2] == 17)
            return words[at + 3];
    return 0;
}

// VUID-VkPipelineShaderStageCreateInfo-flags-02759.
TEST(Lanes, FullSubgroupsFillTheWidthOfWorkgroups) {
    const AgaaDeviceCaps caps = deviceWith(32);
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                 "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
    fetch.maxDraws = fetch.maxPrimitives = 1000;
    size_t passes = 0;
    struct Row {
        const char* technique;
        AgaaTier tier;
        uint64_t flags = 0;
    };
    const Row rows[] = {{"agaa", AGAA_TIER_POST_DEPTH_ATOMICS},
                        {"agaa", AGAA_TIER_GBUFFER},
                        {"agaa", AGAA_TIER_IDS},
                        {"agaa", AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED},
                        {"sbaa", AGAA_TIER_POST_DEPTH_ATOMICS},
                        {"adaptive", AGAA_TIER_GBUFFER},
                        {"adaptive", AGAA_TIER_IDS}};
    for (const Row& row : rows)
        for (const uint32_t n : {2u, 8u, 32u}) {
            ViewSpec spec = specWith(n, AGAA_LANES_AUTO, row.tier);
            spec.technique = row.technique;
            spec.configFlags |= row.flags;
            if (row.tier == AGAA_TIER_IDS)
                spec.chained = &fetch;
            for (const Pass& pass : planFor(spec, caps).passes) {
                if (pass.kind() != PassKind::Compute || !pass.compute().fullSubgroups)
                    continue;
                std::vector<uint32_t> compiled;
                const ComputePart& program = pass.compute();
                if (!program.text.empty() || !program.hostCode.empty())
                    compiled = compileCompute(passGlsl(pass), pass.name.c_str());
                const std::vector<uint32_t> words = compiled.empty() ? embeddedSpirv(program.shader) : compiled;
                EXPECT_EQ(workgroupWidth(words), 64u) << row.technique << " " << n << ": " << pass.name;
                ++passes;
            }
        }
    EXPECT_GT(passes, 10u);
}

// Executors read only ComputePart::fullSubgroups.
TEST(Lanes, PassesAreCompiledForTheChoice) {
    for (const AgaaLanes lanes : {AGAA_LANES_PIXEL, AGAA_LANES_SAMPLE_SHARED, AGAA_LANES_SAMPLE_SUBGROUP}) {
        uint32_t passes = 0;
        for (const AgaaTier tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_GBUFFER}) {
            const Plan plan = planFor(specWith(8, lanes, tier), deviceWith(32));
            for (const Pass& pass : plan.passes) {
                if (pass.kind() != PassKind::Compute)
                    continue;
                const ComputePart& program = pass.compute();
                const bool has = program.defines.find("AGAA_SAMPLE_LANES") != std::string::npos;
                EXPECT_EQ(program.fullSubgroups, has && lanes == AGAA_LANES_SAMPLE_SUBGROUP) << pass.name;
                EXPECT_EQ(has && hasSampleLanes(lanes),
                          program.defines.find("#define AGAA_SAMPLE_LANES 1") != std::string::npos)
                    << pass.name;
                EXPECT_TRUE(hasSpirv(program.shader)) << program.shader;
                passes += has;
            }
        }
        EXPECT_EQ(passes, 2u);
    }
}

// Returns the SPIR-V of all permutations of a pass that have a switch.
std::vector<std::vector<uint32_t>> permutationsWith(const std::string& shader, Switch which) {
    const std::span<const Switch> switches = passSwitches(shader);
    std::vector<std::vector<uint32_t>> found;
    for (uint32_t bits = 0; bits < 1u << switches.size(); ++bits) {
        std::string name = shader + '_';
        bool isOn = false;
        for (size_t i = 0; i < switches.size(); ++i) {
            name += {switchLetter(switches[i]), char('0' + (bits >> i & 1u))};
            isOn |= switches[i] == which && (bits >> i & 1u);
        }
        if (isOn && hasSpirv(name))
            found.push_back(embeddedSpirv(name));
    }
    return found;
}

// Returns the size of the workgroups of a module, or zeros.
std::array<uint32_t, 3> localSize(std::span<const uint32_t> spirv) {
    constexpr uint32_t header = 5, executionMode = 16, localSizeMode = 17;
    for (size_t i = header; i < spirv.size() && spirv[i] >> 16 > 0; i += spirv[i] >> 16)
        if ((spirv[i] & 0xFFFF) == executionMode && spirv[i + 2] == localSizeMode)
            return {spirv[i + 3], spirv[i + 4], spirv[i + 5]};
    return {};
}

// Vulkan requires that the size of subgroups divides the width of workgroups with full subgroups. The passes require
// rows of 64 lanes, which hold whole pixels.
TEST(Lanes, WorkgroupsWithFullSubgroupsAreRowsOf64Lanes) {
    const char* const shaders[] = {
#define AGAA_SWITCH(...)
#define AGAA_PASS(folder, shader, ...) #shader,
#define AGAA_NEVER(...)
#define AGAA_HOST_PASS(...)
#include "shaders/tables/permutations.inc"
#undef AGAA_SWITCH
#undef AGAA_PASS
#undef AGAA_NEVER
#undef AGAA_HOST_PASS
    };
    size_t modules = 0;
    for (const char* shader : shaders)
        for (const std::span<const uint32_t> spirv : permutationsWith(shader, Switch::Subgroups)) {
            ++modules;
            EXPECT_EQ(localSize(spirv), (std::array<uint32_t, 3>{64, 1, 1})) << shader;
        }
    EXPECT_GT(modules, 40u);
}

ViewSpec mergingSpec(uint32_t samples, uint32_t surfaces, AgaaLanes lanes, AgaaTier tier) {
    ViewSpec spec = specWith(samples, lanes, tier);
    spec.technique = "dcaa";
    spec.aggregates = surfaces;
    return spec;
}

// Returns whether the pass that merges fragments has its surfaces in shared memory.
bool mergesInSharedMemory(const Plan& plan) {
    const auto pass = std::ranges::find(plan.passes, "merge fragments", &Pass::name);
    const ComputePart& program = pass->compute();
    EXPECT_FALSE(program.fullSubgroups);
    EXPECT_EQ(!hasSpirv(program.shader), plan.view.generationTier == AGAA_TIER_FRAGMENT_LISTS);
    const bool isShared = program.defines.find("#define AGAA_SHARED_SURFACES 1") != std::string::npos;
    EXPECT_TRUE(program.shader.ends_with(isShared ? "k1" : "k0")) << program.shader;
    return isShared;
}

TEST(Lanes, SurfacesOfMergingAreInSharedMemoryOfGpus) {
    struct Row {
        AgaaDeviceCaps caps;
        AgaaLanes lanes;
        uint32_t samples, surfaces;
        bool isShared;
        const char* words; // of the note
    };
    const AgaaDeviceCaps software = deviceWith(8, 32768, AGAA_DEVICE_SOFTWARE);
    const Row rows[] = {
        {deviceWith(0), AGAA_LANES_AUTO, 64, 4, true, "in shared memory."},
        {software, AGAA_LANES_AUTO, 64, 4, false, "software"},
        {deviceWith(0), AGAA_LANES_PIXEL, 64, 4, false, "AgaaMeasurement::lanes"},
        {software, AGAA_LANES_SAMPLE_SHARED, 64, 4, true, "AgaaMeasurement::lanes"},
        {software, AGAA_LANES_SAMPLE_SUBGROUP, 128, 8, true, "AgaaMeasurement::lanes"},
        {deviceWith(0, 16384), AGAA_LANES_AUTO, 128, 7, true, "in shared memory."},
        {deviceWith(0, 16384), AGAA_LANES_AUTO, 128, 8, false,
         "have 16384 bytes of shared memory, and 16640 are needed."},
    };
    for (const AgaaTier tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS})
        for (const Row& row : rows) {
            const Plan plan = planFor(mergingSpec(row.samples, row.surfaces, row.lanes, tier), row.caps);
            EXPECT_EQ(mergesInSharedMemory(plan), row.isShared) << noteOf(plan);
            EXPECT_NE(noteOf(plan).find(row.words), std::string::npos) << noteOf(plan);
            EXPECT_TRUE(noteOf(plan).ends_with('.')) << noteOf(plan);
        }
    const std::string message = messageOf(mergingSpec(128, 8, AGAA_LANES_SAMPLE_SHARED, AGAA_TIER_FRAGMENT_LISTS),
                                          deviceWith(0, 16384), AGAA_ERROR_UNSUPPORTED);
    EXPECT_NE(message.find("AgaaMeasurement::lanes cannot run: workgroups of the device have 16384 bytes"),
              std::string::npos)
        << message;
}

TEST(Lanes, MergingWithoutListsDoesNotUseTheSetting) {
    ViewSpec spec = mergingSpec(64, 4, AGAA_LANES_SAMPLE_SHARED, AGAA_TIER_FRAGMENT_INTERLOCK);
    EXPECT_EQ(noteOf(planFor(spec, deviceWith(0, 16384))), "");
}

// Lists of fragments have no variant with subgroup operations.
TEST(Lanes, ListsUseSharedMemory) {
    const auto listSpec = [](const char* technique, AgaaLanes lanes) {
        const bool isDcaa = std::string_view(technique) == "dcaa";
        ViewSpec spec = specWith(64, lanes, isDcaa ? AGAA_TIER_AUTO : AGAA_TIER_FRAGMENTS);
        spec.technique = technique;
        spec.change = [=](TechniqueConfig& config) {
            config.measurement.lanes = lanes;
            config.coverage.flags |= isDcaa ? AGAA_COVERAGE_EXACT : 0;
        };
        return spec;
    };
    for (const char* technique : {"agaa", "dcaa"}) {
        SCOPED_TRACE(technique);
        const auto lanesOf = [&](AgaaLanes lanes, uint64_t flags) {
            return planFor(listSpec(technique, lanes), deviceWith(64, 16384, flags)).view.lanes;
        };
        EXPECT_EQ(lanesOf(AGAA_LANES_AUTO, 0), AGAA_LANES_SAMPLE_SHARED);
        EXPECT_EQ(lanesOf(AGAA_LANES_AUTO, AGAA_DEVICE_SOFTWARE), AGAA_LANES_PIXEL);
        EXPECT_EQ(lanesOf(AGAA_LANES_PIXEL, 0), AGAA_LANES_PIXEL);
        EXPECT_EQ(lanesOf(AGAA_LANES_SAMPLE_SHARED, AGAA_DEVICE_SOFTWARE), AGAA_LANES_SAMPLE_SHARED);
        const std::string message =
            messageOf(listSpec(technique, AGAA_LANES_SAMPLE_SUBGROUP), deviceWith(64), AGAA_ERROR_UNSUPPORTED);
        EXPECT_NE(message.find("no variant with subgroup operations"), std::string::npos) << message;
    }
}

TEST(Lanes, AdaptiveComparesSamplesByLanes) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "";
    function.maxDraws = function.maxPrimitives = 1024;
    for (const AgaaTier tier : {AGAA_TIER_IDS, AGAA_TIER_GBUFFER}) {
        SCOPED_TRACE(agaaTierName(tier));
        ViewSpec spec = specWith(16, AGAA_LANES_AUTO, tier);
        spec.technique = "adaptive";
        spec.chained = tier == AGAA_TIER_IDS ? &function : nullptr;
        const Plan subgroup = planFor(spec, deviceWith(32)), shared = planFor(spec, deviceWith(8));
        EXPECT_EQ(subgroup.view.lanes, AGAA_LANES_SAMPLE_SUBGROUP);
        EXPECT_EQ(shared.view.lanes, AGAA_LANES_SAMPLE_SHARED);
        EXPECT_EQ(planFor(spec, deviceWith(32, 49152, AGAA_DEVICE_SOFTWARE)).view.lanes, AGAA_LANES_PIXEL);
        const auto isFull = [](const Plan& plan, std::string_view name) {
            for (const Pass& pass : plan.passes)
                if (pass.name == name)
                    return pass.compute().fullSubgroups;
            ADD_FAILURE() << "no pass " << name;
            return false;
        };
        EXPECT_TRUE(isFull(subgroup, "shade further samples"));
        EXPECT_FALSE(isFull(shared, "shade further samples"));
        EXPECT_EQ(isFull(subgroup, "shade first samples"), tier == AGAA_TIER_IDS);
    }
}

TEST(Lanes, WordsOfLanesTakeRoomFromTheList) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "";
    function.maxDraws = function.maxPrimitives = 1024;
    const auto lengthWith = [&](uint32_t samples, AgaaLanes lanes) {
        ViewSpec spec = specWith(samples, lanes, AGAA_TIER_IDS);
        spec.chained = &function;
        const Plan plan = planFor(spec, deviceWith(32, 32768, AGAA_DEVICE_SOFTWARE));
        const std::string& defines = plan.passes.back().compute().defines;
        return std::stoul(defines.substr(defines.find("AGAA_LIST_LENGTH ") + 17));
    };
    EXPECT_EQ(lengthWith(32, AGAA_LANES_PIXEL), 192u);
    EXPECT_EQ(lengthWith(8, AGAA_LANES_SAMPLE_SUBGROUP), 160u) << "9 words a lane";
    EXPECT_EQ(lengthWith(8, AGAA_LANES_SAMPLE_SHARED), 160u) << "12 words a lane";
    EXPECT_EQ(lengthWith(32, AGAA_LANES_SAMPLE_SHARED), 128u) << "32 words a lane";
}

} // namespace
