// Queries of a view agree with each other: bytes, surfaces, targets and the plan.
#include "cases.h"
#include "capabilities.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace agaa::conformance {

namespace {

std::string nameOf(const ViewParts& p) {
    return std::string("\"") + p.config.technique + "\", n = " + std::to_string(p.config.samples) + ", tier " +
           std::to_string(p.config.generationTier) + ", " + std::to_string(p.desc.width) + " x " +
           std::to_string(p.desc.height) + (p.coverage.samplePositions ? ", own positions" : "");
}

// Returns whether the technique supports 9 samples.
bool hasOrderedGrid(const std::string& technique) {
    return technique == "msaa" || technique == "ssaa" || technique == "simple_complex" || technique == "adaptive";
}

// Views of every technique, n and tier that an ideal device runs.
void forEachView(Test& test, const std::function<void(ViewParts&)>& check) {
    for (const char* technique : allTechniques)
        for (const uint32_t samples : hasCoverageSamples(technique) ? std::vector<uint32_t>{32, 64, 128}
                                      : technique == std::string("agaa")
                                          ? std::vector<uint32_t>{1, 2, 4, 8, 16, 32, 64, 128}
                                      : hasOrderedGrid(technique) ? std::vector<uint32_t>{1, 2, 4, 8, 9, 16, 32}
                                                                  : std::vector<uint32_t>{1, 2, 4, 8, 16, 32})
            for (const uint32_t tier :
                 {AGAA_TIER_AUTO, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS,
                  AGAA_TIER_NV_MIXED_SAMPLES, AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_FRAGMENTS, AGAA_TIER_MATERIAL_LISTS,
                  AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_RASTER_ORDER}) {
                const bool isList = tier == AGAA_TIER_FRAGMENT_LISTS || tier == AGAA_TIER_MATERIAL_LISTS ||
                                    tier == AGAA_TIER_FRAGMENT_INTERLOCK || tier == AGAA_TIER_RASTER_ORDER;
                const bool isFragments =
                    tier == AGAA_TIER_FRAGMENTS || (samples > 32 && technique == std::string("agaa"));
                if (isFragments && (samples < 32 || technique != std::string("agaa") ||
                                    (tier != AGAA_TIER_FRAGMENTS && tier != AGAA_TIER_AUTO)))
                    continue;
                const bool isAgaa = technique == std::string("agaa"), isSbaa = technique == std::string("sbaa");
                if (tier != AGAA_TIER_AUTO && !(isAgaa && !isList) && !(isSbaa && !isList && tier != AGAA_TIER_IDS) &&
                    !(isList && hasCoverageSamples(technique)))
                    continue;
                const bool mergesInOrder = tier == AGAA_TIER_FRAGMENT_INTERLOCK || tier == AGAA_TIER_RASTER_ORDER;
                if (mergesInOrder && technique == std::string("sgbc")) // which has lists only
                    continue;
                ViewParts parts(test.sdk, nullptr);
                parts.setTechnique(technique, samples);
                parts.config.samples = samples;
                parts.config.generationTier = tier;
                if (tier == AGAA_TIER_RASTER_ORDER)
                    parts.config.aggregates = 2; // attachments hold two surfaces
                if (tier == AGAA_TIER_IDS || isFragments)
                    parts.chain(parts.fetch);
                check(parts);
                if (!countsCoverage(parts.config))
                    continue;
                const std::vector<float> positions(2 * samples, 0.5f); // a pattern of the host
                parts.coverage.samplePositions = positions.data();
                check(parts);
            }
}

AgaaMemoryReport reportOf(Test& test, const ViewParts& parts) {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    test.requireOk(test.sdk.agaaQueryMemory(&parts.desc, &parts.caps, nullptr, &report, nullptr, nullptr),
                   callWith("agaaQueryMemory", nameOf(parts)));
    return report;
}

// Sums of the surfaces are the totals of the report.
void checkBytes(Test& test, ViewParts& parts) {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    const std::vector<AgaaSurface> surfaces = surfacesOf(test, parts, &report);
    uint64_t total = 0, constant = 0, largest = 0;
    for (const AgaaSurface& s : surfaces) {
        (s.isPerPixel ? total : constant) += s.bytes;
        if (s.isPerPixel)
            largest = std::max(largest, s.bytes);
    }
    const std::string call = callWith("agaaQueryMemory", nameOf(parts));
    test.check(total == report.totalBytes, call + ": per-pixel surfaces have " + std::to_string(total) +
                                               " bytes, and totalBytes is " + std::to_string(report.totalBytes) + ".");
    test.check(constant == report.constantBytes, call + ": constant surfaces have " + std::to_string(constant) +
                                                     " bytes, and constantBytes is " +
                                                     std::to_string(report.constantBytes) + ".");
    test.check(report.peakBytes <= total, call + ": peakBytes exceeds totalBytes.");
    test.check(report.peakBytes >= largest, call + ": peakBytes is below the bytes of one surface.");
    const double perPixel = double(total) / (double(parts.desc.width) * parts.desc.height);
    test.check(std::fabs(report.bytesPerPixel - perPixel) <= 1e-9 * perPixel,
               call + ": bytesPerPixel is not totalBytes by pixels.");
}

bool hasEnd(const char* text, size_t size) { return std::memchr(text, 0, size) != nullptr; }

void checkSurfaces(Test& test, ViewParts& parts) {
    AgaaTarget target = AGAA_TARGET_INIT;
    test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, nullptr, &target), "agaaQueryTarget");
    std::set<std::string> names;
    for (const AgaaSurface& s : surfacesOf(test, parts)) {
        const std::string what = callWith("agaaQueryMemory", nameOf(parts)) + ": the surface \"" + s.name + "\"";
        test.require(hasEnd(s.name, sizeof s.name) && hasEnd(s.format, sizeof s.format),
                     "a surface's name does not end.");
        test.check(s.name[0] && names.insert(s.name).second, what + " has no name of its own.");
        test.check(s.firstPass <= s.lastPass, what + " ends before it begins.");
        test.check(s.reserved == 0, what + ": the reserved member is not 0.");
        test.check(s.isPerPixel <= 1 && s.bytes > 0, what + " has a wrong isPerPixel or no bytes.");
        const bool isBuffer = s.format[0] == 0;
        test.check(!isBuffer || (s.width == 0 && s.height == 0), what + " is a buffer and has a size in texels.");
        test.check(!isBuffer || (s.scaleX == 0 && s.scaleY == 0), what + " is a buffer and has a scale.");
        test.check(s.isPerPixel || (s.scaleX == 0 && s.scaleY == 0),
                   what + " does not grow with the view and has a scale.");
        test.check(isBuffer || !s.isPerPixel ||
                       (s.width == parts.desc.width * s.scaleX && s.height == parts.desc.height * s.scaleY),
                   what + ": the size is not the scale times the view's.");
    }
    const bool hasDepth = target.geometryPasses > 0 && !countsCoverage(parts.config);
    test.check(names.count("depth") == hasDepth,
               callWith("agaaQueryMemory", nameOf(parts)) +
                   ": \"depth\" does not exist in exactly the views that draw into depth.");
}

void checkTarget(Test& test, ViewParts& parts) {
    AgaaTarget t = AGAA_TARGET_INIT;
    const std::string call = callWith("agaaQueryTarget", nameOf(parts));
    test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, nullptr, &t), call);
    test.check(t.width == parts.desc.width * t.scaleX && t.height == parts.desc.height * t.scaleY,
               call + ": the size is not the scale times the view's.");
    const bool isOne = needsOneSample(parts.config.technique) || countsCoverage(parts.config);
    const uint32_t promised = isOne ? 1 : parts.config.samples;
    test.check(t.layers == 1 && t.reserved == 0, call + " says layers where no tier has them.");
    test.check(t.scaleX * t.scaleY * t.samples == promised,
               call + ": a pixel has " + std::to_string(t.scaleX * t.scaleY * t.samples) + " samples where " +
                   std::to_string(promised) + " are promised.");
}

// A device with 4 samples makes 8, 16 and 32 of them in 2, 4 and 8 layers of the same bytes as a scaled target's.
void testLayers(Test& test) {
    for (const uint32_t tier : {AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST})
        for (const uint32_t samples : {8u, 16u, 32u}) {
            ViewParts parts(test.sdk, nullptr);
            parts.caps.sampleCounts = 5;
            parts.setTechnique("agaa", samples);
            const auto bytes = [&](uint32_t visibility) {
                parts.config.visibilityTier = visibility;
                AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
                surfacesOf(test, parts, &report);
                return report.totalBytes;
            };
            const uint64_t scaled = bytes(AGAA_TIER_SCALED_TARGET), layered = bytes(tier);
            AgaaTarget t = AGAA_TARGET_INIT;
            test.requireOk(test.sdk.agaaQueryTarget(&parts.desc, &parts.caps, nullptr, &t), "agaaQueryTarget");
            const std::string what = "agaaQueryTarget with " + std::to_string(samples) + " samples in layers";
            test.check(t.samples == 4 && t.layers == samples / 4 && t.scaleX == 1 && t.scaleY == 1 && t.reserved == 0,
                       what + " says another number of layers.");
            test.check(t.width == parts.desc.width && t.height == parts.desc.height * t.layers,
                       what + " says another size.");
            test.check(layered == scaled, what + " takes other bytes than with a scaled target.");
        }
}

// The plan is JSON and names what agaaQueryMemory lists.
void checkPlan(Test& test, ViewParts& parts) {
    const std::string call = callWith("agaaPlanToJson", nameOf(parts));
    const auto plan = nlohmann::json::parse(planText(test, parts), nullptr, false);
    test.require(!plan.is_discarded() && plan.is_object(), call + ": the text is no JSON object.");
    for (const char* key : {"tiers", "resources", "passes", "notes"})
        test.require(plan.contains(key), call + ": the plan has no \"" + key + "\".");
    std::set<std::string> inPlan;
    for (const auto& resource : plan["resources"])
        if (resource.at("kind") != "host")
            inPlan.insert(resource.at("name").get<std::string>());
    std::set<std::string> listed;
    for (const AgaaSurface& surface : surfacesOf(test, parts))
        listed.insert(surface.name);
    test.check(inPlan == listed, call + ": the resources are not the surfaces of agaaQueryMemory.");
}

// More pixels take more bytes, and never a lower peak.
void checkGrowth(Test& test, ViewParts& parts) {
    const AgaaMemoryReport small = reportOf(test, parts);
    for (const auto& [width, height] : {std::pair<uint32_t, uint32_t>{parts.desc.width + 8, parts.desc.height},
                                        {parts.desc.width, parts.desc.height + 8},
                                        {1920, 1080}}) {
        ViewParts larger(test.sdk, nullptr);
        larger.setTechnique(parts.config.technique, 4);
        larger.config.samples = parts.config.samples;
        larger.config.generationTier = parts.config.generationTier;
        larger.coverage.samplePositions = parts.coverage.samplePositions;
        if (parts.desc.pNext)
            larger.chainAlone(larger.fetch);
        larger.desc.width = width;
        larger.desc.height = height;
        const AgaaMemoryReport report = reportOf(test, larger);
        const std::string call = callWith("agaaQueryMemory", nameOf(larger));
        test.check(report.totalBytes > small.totalBytes, call + ": totalBytes does not exceed that of fewer pixels.");
        test.check(report.peakBytes > small.peakBytes, call + ": peakBytes does not exceed that of fewer pixels.");
        test.check(report.constantBytes == small.constantBytes, call + ": constantBytes changes with the target.");
    }
}

// Without shared memory the peak is the total.
void testNoSharing(Test& test) {
    for (const char* technique : allTechniques) {
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique(technique, 4);
        parts.config.flags = AGAA_CONFIG_READBACK;
        const AgaaMemoryReport report = reportOf(test, parts);
        test.check(report.peakBytes == report.totalBytes,
                   callWith("agaaQueryMemory", nameOf(parts)) +
                       " and AGAA_CONFIG_READBACK: peakBytes is not totalBytes.");
        parts.config.flags = 0;
        parts.caps.flags |= AGAA_DEVICE_NO_ALIASING;
        const AgaaMemoryReport deviceReport = reportOf(test, parts);
        test.check(deviceReport.peakBytes == deviceReport.totalBytes,
                   callWith("agaaQueryMemory", nameOf(parts)) +
                       " and AGAA_DEVICE_NO_ALIASING: peakBytes is not totalBytes.");
    }
}

// ---- names and capabilities ----------------------------------------------------------------------

void testEqualNames(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    parts.config.technique = "simple_complex";
    const std::string expected = planText(test, parts);
    parts.config.technique = "simple-complex";
    test.check(planText(test, parts) == expected,
               "agaaPlanToJson writes different plans for \"simple-complex\" and \"simple_complex\".");
}

// Returns whether the technique needs geometry shaders for coverage samples and the device has none.
bool needsPulling(const ViewParts& parts) {
    return countsCoverage(parts.config) && !(parts.caps.flags & AGAA_DEVICE_GEOMETRY_SHADERS);
}

// Returns whether only compute passes can expand triangles for coverage samples.
bool needsExpansion(const ViewParts& parts) {
    return countsCoverage(parts.config) && !(parts.caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS);
}

// Sets the member of the struct that is chained.
void expandTriangles(ViewParts& parts) { parts.fetch.maxTriangles = parts.sceneFetch.maxTriangles = 1000; }

// A row that can run has a plan with its tier; any other row is refused with a sentence. canRun is true if all stages
// of the technique and n can run; otherwise there is no plan.
void checkCapability(Test& test, const AgaaDeviceCaps& caps, const AgaaCapability& row, bool canRun) {
    ViewParts parts(test.sdk, nullptr);
    parts.caps = caps;
    parts.setTechnique(row.technique, 4);
    parts.config.samples = row.samples;
    parts.config.flags = 0;
    const bool isVisibility = row.stage == AGAA_STAGE_PREPASS;
    if (isVisibility)
        parts.config.visibilityTier = row.tier;
    else if (row.stage == AGAA_STAGE_GENERATION)
        parts.config.generationTier = row.tier;
    if (row.tier == AGAA_TIER_IDS || (countsCoverage(parts.config) && !hasCoverageSamples(row.technique)))
        parts.chain(parts.fetch);
    const std::string what =
        nameOf(parts) + ", stage " + std::to_string(row.stage) + ", tier " + std::to_string(row.tier);
    if (row.tier == AGAA_TIER_AUTO || !canRun)
        return expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what);
    if (needsExpansion(parts)) {
        expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what + ", without maxTriangles");
        expandTriangles(parts);
        test.check(row.stage != AGAA_STAGE_GENERATION ||
                       std::strstr(row.reason, "an AgaaFetchFunction and its maxTriangles"),
                   what + " runs with AgaaFetchFunction::maxTriangles alone, which the reason does not name.");
    } else if (needsPulling(parts)) {
        expectViewRefused(test, parts, AGAA_ERROR_UNSUPPORTED, what + ", without AGAA_VIEW_VERTEX_PULLING");
        parts.desc.flags |= AGAA_VIEW_VERTEX_PULLING;
        test.check(row.stage != AGAA_STAGE_GENERATION || std::strstr(row.reason, "AGAA_VIEW_VERTEX_PULLING"),
                   what + " runs with AGAA_VIEW_VERTEX_PULLING alone, which the reason does not name.");
    }
    expectAccepted(test, parts, what);
    const auto plan = nlohmann::json::parse(planText(test, parts));
    if (!isVisibility && row.stage != AGAA_STAGE_GENERATION)
        return;
    const std::string tier = plan.at("tiers").value(isVisibility ? "visibility" : "generation", "");
    test.check(tier == test.sdk.agaaTierName(row.tier),
               callWith("agaaPlanToJson", what) + " names the tier " + tier + ".");
}

// The first entry is the tier that AUTO selects without functions of the host that its reason does not name.
void checkFirst(Test& test, const AgaaDeviceCaps& caps, const AgaaCapability& row) {
    ViewParts parts(test.sdk, nullptr);
    parts.caps = caps;
    parts.setTechnique(row.technique, 4);
    parts.config.samples = row.samples;
    parts.config.flags = 0;
    parts.desc.pNext = nullptr;
    if (countsCoverage(parts.config) && (!hasCoverageSamples(row.technique) || needsExpansion(parts)))
        parts.chain(parts.fetch);
    if (needsExpansion(parts))
        expandTriangles(parts);
    else if (needsPulling(parts))
        parts.desc.flags |= AGAA_VIEW_VERTEX_PULLING;
    const auto plan = nlohmann::json::parse(planText(test, parts));
    const std::string tier = plan.at("tiers").value(row.stage == AGAA_STAGE_PREPASS ? "visibility" : "generation", "");
    test.check(tier == test.sdk.agaaTierName(row.tier),
               "agaaQueryCapabilities lists another tier first than AUTO selects for " + nameOf(parts) +
                   ": the plan names " + tier + ".");
}

void testCapabilities(Test& test) {
    for (const AgaaDeviceCaps& caps : capsOfDevices(test)) {
        const std::vector<AgaaCapability> rows = capabilitiesOf(test, &caps);
        std::set<std::string> seen, failing; // technique and n of rows that cannot run
        const auto nameOfPlan = [](const AgaaCapability& row) {
            return std::string(row.technique) + std::to_string(row.samples);
        };
        for (const AgaaCapability& row : rows)
            if (row.tier == AGAA_TIER_AUTO)
                failing.insert(nameOfPlan(row));
        for (const AgaaCapability& row : rows) {
            const bool canRun = !failing.count(nameOfPlan(row));
            checkCapability(test, caps, row, canRun);
            const std::string key = nameOfPlan(row) + '/' + std::to_string(row.stage);
            const bool isChoice = row.stage == AGAA_STAGE_PREPASS || row.stage == AGAA_STAGE_GENERATION;
            if (seen.insert(key).second && isChoice && canRun)
                checkFirst(test, caps, row);
        }
    }
}

} // namespace

void addPlanCases(Suite& suite) {
    suite.core("AgaaTarget.reserved/zero", testLayers);
    struct Row {
        const char* name;
        void (*check)(Test&, ViewParts&);
    };
    for (const Row& row : {Row{"agaaQueryMemory/sums", checkBytes}, Row{"agaaQueryMemory/surfaces", checkSurfaces},
                           Row{"AgaaSurface.reserved/zero", checkSurfaces}, Row{"agaaQueryMemory/growth", checkGrowth},
                           Row{"agaaQueryTarget/samples", checkTarget}, Row{"agaaPlanToJson/plan", checkPlan}})
        suite.core(row.name,
                   [row](Test& test) { forEachView(test, [&](ViewParts& parts) { row.check(test, parts); }); });
    suite.core("agaaQueryMemory/no_sharing", testNoSharing);
    suite.core("AgaaNameKind/equal_names", testEqualNames);
    suite.core("agaaQueryCapabilities/plans", testCapabilities);
}

} // namespace agaa::conformance
