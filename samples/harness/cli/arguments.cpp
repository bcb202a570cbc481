#include "cli/arguments.h"

#include "agaa_gl.h"
#include "cli/layout_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace harness {

namespace {

uint32_t choice(const std::string& value, const char* option,
                std::initializer_list<std::pair<const char*, uint32_t>> choices) {
    std::string list;
    for (const auto& [name, number] : choices) {
        if (value == name)
            return number;
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    throw BadArgument(std::string(option) + " is \"" + value + "\"; it can be " + list + ".");
}

uint32_t parseDimension(const std::string& text, const std::string& whole) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == 0)
        throw BadArgument("--size is \"" + whole + "\"; it is written WxH, both at least 1.");
    return value;
}

void checkTechnique(const std::string& technique) {
    uint32_t count = 0;
    agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, nullptr);
    std::vector<const char*> names(count);
    agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, names.data());
    std::string list;
    for (const char* name : names) {
        if (technique == name)
            return;
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    throw BadArgument("--technique is \"" + technique + "\"; it can be " + list + ".");
}

void checkCounts(const PlanArguments& arguments, bool isCoverage) {
    const uint32_t n = arguments.samples;
    if (isCoverage && n != 32 && n != 64 && n != 128)
        throw BadArgument("--samples is " + std::to_string(n) + "; coverage samples can be 32, 64 or 128.");
    const bool hasGrid = arguments.technique != "agaa" && arguments.technique != "sbaa";
    const bool isGrid = hasGrid && n == 9; // 3 by 3
    if (!isCoverage && !isGrid && (n == 0 || n > 32 || (n & (n - 1))))
        throw BadArgument("--samples is " + std::to_string(n) + "; it can be 1, 2, 4, 8, " + (hasGrid ? "9, " : "") +
                          "16 or 32.");
    const uint32_t most = arguments.technique == "dcaa" || arguments.technique == "sgbc" ? 8
                          : arguments.technique == "sbaa"                                ? 6
                                                                                         : 4;
    if (arguments.aggregates < 1 || arguments.aggregates > most)
        throw BadArgument("--aggregates is " + std::to_string(arguments.aggregates) + "; it can be 1 to " +
                          std::to_string(most) + ".");
}

void setTier(TechniqueConfig& config, const std::string& text, bool& isModel) {
    if (text == "auto")
        return;
    if (text == "native") {
        isModel = true;
        config.visibilityTier = AGAA_TIER_NATIVE;
        config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
        return;
    }
    const size_t equals = text.find('=');
    uint32_t tier = 0;
    if (equals == std::string::npos || agaaTierFromName(text.substr(equals + 1).c_str(), &tier) != AGAA_OK)
        throw BadArgument("--tier is \"" + text +
                          "\"; it is native, auto or stage=tier with a tier that `caps` names.");
    const std::string stage = text.substr(0, equals);
    if (stage == "visibility" || stage == "prepass")
        config.visibilityTier = tier;
    else if (stage == "generation")
        config.generationTier = tier;
    else
        throw BadArgument("--tier names the stage \"" + stage + "\"; it can be visibility or generation.");
}

float finite(double value, const char* option) {
    if (!std::isfinite(value) || value < 0)
        throw BadArgument(std::string(option) + " must be a number of at least 0.");
    return float(value);
}

} // namespace

Size parseSize(const std::string& text) {
    const size_t cross = text.find('x');
    if (cross == std::string::npos)
        throw BadArgument("--size is \"" + text + "\"; it is written WxH, both at least 1.");
    return {parseDimension(text.substr(0, cross), text), parseDimension(text.substr(cross + 1), text)};
}

std::vector<double> parseNumbers(const std::string& text, size_t count, const char* option) {
    std::vector<double> numbers;
    size_t begin = 0;
    while (begin <= text.size()) {
        const size_t end = std::min(text.find(',', begin), text.size());
        double value = 0;
        const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
        if (error != std::errc() || stop != text.data() + end || !std::isfinite(value))
            break;
        numbers.push_back(value);
        begin = end + 1;
    }
    if (numbers.size() != count || begin != text.size() + 1)
        throw BadArgument(std::string(option) + " is \"" + text + "\"; it takes " + std::to_string(count) +
                          " numbers with commas between them.");
    return numbers;
}

Camera parseCamera(const std::string& text) {
    const std::vector<double> v = parseNumbers(text, 7, "--camera");
    Camera camera;
    camera.name = "command line";
    camera.eye = {v[0], v[1], v[2]};
    camera.target = {v[3], v[4], v[5]};
    camera.fovDegrees = v[6];
    if (camera.eye == camera.target || !(camera.fovDegrees > 0 && camera.fovDegrees < 180))
        throw BadArgument("--camera needs an eye apart from its target and a field of view between "
                          "0 and 180 degrees.");
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    if (std::fabs(forward.y) > 0.9999)
        camera.up = {0, 0, -1};
    return camera;
}

uint32_t parseStatePolicy(const std::string& name) {
    return choice(
        name, "--state-policy",
        {{"restore", AGAA_GL_STATE_RESTORE}, {"callbacks", AGAA_GL_STATE_CALLBACKS}, {"none", AGAA_GL_STATE_NONE}});
}

uint32_t parseConstants(const std::string& name) {
    return choice(name, "--constants",
                  {{"block", AGAA_GL_CONSTANTS_BLOCK},
                   {"uniforms", AGAA_GL_CONSTANTS_UNIFORMS},
                   {"texels", AGAA_GL_CONSTANTS_TEXELS}});
}

AgaaShadingLevel parseShadingLevel(const std::string& name) {
    return AgaaShadingLevel(
        choice(name, "--shading-level", {{"event", AGAA_SHADING_EVENT}, {"reflectance", AGAA_SHADING_REFLECTANCE}}));
}

void requireBackend(const std::string& name) {
    if (name != "vk" && name != "gl")
        throw BadArgument("--backend is \"" + name + "\"; it can be vk or gl.");
}

// Returns the host's pattern. Any number of its first points is evenly distributed (Roberts 2018, "The Unreasonable
// Effectiveness of Quasirandom Sequences": R2).
static const std::vector<float>& quasirandomPositions() {
    static const std::vector<float> positions = [] {
        constexpr uint32_t most = 128;
        std::vector<float> pairs;
        for (uint32_t i = 0; i < most; ++i)
            for (const double step : {0.7548776662466927, 0.5698402909980532})
                pairs.push_back(float(std::fmod(0.5 + i * step, 1.0)));
        return pairs;
    }();
    return positions;
}

Configuration::Configuration(const PlanArguments& arguments) {
    checkTechnique(arguments.technique);
    size = parseSize(arguments.size);
    layout = readLayout(arguments.layout);
    config.layout = &layout;
    technique = arguments.technique;
    config.technique = technique.c_str();
    config.samples = arguments.samples;
    config.aggregates = arguments.aggregates;
    config.brdf = choice(arguments.brdf, "--brdf", {{"blinn-phong", AGAA_BRDF_BLINN_PHONG}, {"ggx", AGAA_BRDF_GGX}});
    config.ndf = choice(
        arguments.ndf, "--ndf",
        {{"none", AGAA_NDF_NONE}, {"toksvig", AGAA_NDF_TOKSVIG}, {"lean", AGAA_NDF_LEAN}, {"sggx", AGAA_NDF_SGGX}});
    config.measurement.seeds = choice(arguments.seeds, "--seeds",
                                      {{"maximin", AGAA_SEEDS_MAXIMIN}, {"sum-of-squares", AGAA_SEEDS_SUM_OF_SQUARES}});
    config.measurement.lanes = choice(arguments.lanes, "--lanes",
                                      {{"auto", AGAA_LANES_AUTO},
                                       {"pixel", AGAA_LANES_PIXEL},
                                       {"shared", AGAA_LANES_SAMPLE_SHARED},
                                       {"subgroup", AGAA_LANES_SAMPLE_SUBGROUP}});
    config.aggregation.characteristicLength = finite(arguments.k, "--k");
    if (arguments.kPerDistance)
        config.aggregation.characteristicLengthPerDistance = finite(*arguments.kPerDistance, "--k-per-distance");
    if (arguments.threshold)
        config.aggregation.aggregateThreshold = finite(*arguments.threshold, "--threshold");
    const std::vector<double> surface = parseNumbers(arguments.surface, 3, "--surface");
    config.surfaceCosine = float(surface[0]);
    config.surfaceDistance = float(surface[1]);
    config.surfaceMaterial = float(surface[2]);
    config.shadowTaps = arguments.shadowTaps;
    config.measurement.shadingCost = arguments.shadingCost;
    config.aggregation.glossWeight = finite(arguments.glossWeight, "--gloss-weight");
    config.coverage.merge = choice(arguments.merge, "--merge",
                                   {{"visible", AGAA_MERGE_VISIBLE},
                                    {"paper", AGAA_MERGE_PAPER},
                                    {"none", AGAA_MERGE_NONE},
                                    {"color", AGAA_MERGE_COLOR}});
    const int expansion = choice(arguments.expand, "--expand", {{"geometry", 0}, {"pulling", 1}, {"compute", 2}});
    vertexPulling = expansion == 1;
    computesTriangles = expansion == 2;
    fitsFragmentCapacity = arguments.fragmentsPerPixel == "auto";
    if (!fitsFragmentCapacity)
        config.coverage.fragmentsPerPixel =
            finite(parseNumbers(arguments.fragmentsPerPixel, 1, "--fragments-per-pixel")[0], "--fragments-per-pixel");
    config.coverage.maxBatches = arguments.maxBatches;
    config.coverage.flags = (arguments.exact ? AGAA_COVERAGE_EXACT : 0) |
                            (arguments.drawOrder ? AGAA_COVERAGE_DRAW_ORDER : 0) |
                            (arguments.reverseOrder ? AGAA_COVERAGE_REVERSE_ORDER : 0) |
                            (arguments.depthPrepass ? AGAA_COVERAGE_DEPTH_PREPASS : 0);
    if (choice(arguments.coveragePattern, "--coverage-pattern", {{"library", 0}, {"r2", 1}}))
        config.coverage.samplePositions = quasirandomPositions().data();
    config.coverage.tableSize = arguments.tableSize;
    arguments.adaptive.apply(config);
    arguments.temporal.apply(config);
    config.aggregation.litShadows = arguments.lit ? 1 : 0; // bit 0: a scene has one shadow map
    const auto flag = [&](bool on, uint64_t bit) { config.flags |= on ? bit : 0; };
    flag(arguments.splitSurfaces, AGAA_CONFIG_SPLIT_SURFACES);
    flag(arguments.fineMaterials, AGAA_CONFIG_FINE_MATERIALS);
    flag(arguments.buffered, AGAA_CONFIG_BUFFERED);
    flag(arguments.hdrResolve, AGAA_CONFIG_HDR_RESOLVE);
    flag(arguments.checkFacts, AGAA_CONFIG_CHECK_FACTS);
    const auto measure = [&](bool on, uint64_t bit) { config.measurement.flags |= on ? bit : 0; };
    measure(arguments.noStencil, AGAA_MEASURE_NO_STENCIL);
    measure(arguments.noCulling, AGAA_MEASURE_NO_LIGHT_CULLING);
    measure(arguments.firstSampleRouting, AGAA_MEASURE_FIRST_SAMPLE_ROUTING);
    measure(arguments.noDiffuseFilter, AGAA_MEASURE_NO_DIFFUSE_FILTER);
    measure(arguments.noShadowFilter, AGAA_MEASURE_NO_SHADOW_FILTER);
    measure(arguments.shadowAlongDepth, AGAA_MEASURE_SHADOW_ALONG_DEPTH);
    measure(arguments.shadowCovariance, AGAA_MEASURE_SHADOW_COVARIANCE);
    measure(arguments.lightDirections, AGAA_MEASURE_LIGHT_DIRECTIONS);
    measure(arguments.storedDepth, AGAA_MEASURE_STORED_DEPTH);
    measure(arguments.depthPlanes, AGAA_MEASURE_DEPTH_PLANES);
    config.measurement.diffuseFilter = choice(arguments.diffuseFilter, "--diffuse-filter",
                                              {{"rectified", AGAA_DIFFUSE_RECTIFIED},
                                               {"mises-fisher", AGAA_DIFFUSE_MISES_FISHER},
                                               {"sggx", AGAA_DIFFUSE_SGGX}});
    config.measurement.debugView = choice(arguments.view, "--view",
                                          {{"none", AGAA_DEBUG_VIEW_NONE},
                                           {"events", AGAA_DEBUG_VIEW_EVENTS},
                                           {"aggregates", AGAA_DEBUG_VIEW_AGGREGATES},
                                           {"clusters", AGAA_DEBUG_VIEW_CLUSTERS},
                                           {"primitives", AGAA_DEBUG_VIEW_PRIMITIVES},
                                           {"lit", AGAA_DEBUG_VIEW_LIT},
                                           {"widened", AGAA_DEBUG_VIEW_WIDENED},
                                           {"tier", AGAA_DEBUG_VIEW_TIER},
                                           {"facts", AGAA_DEBUG_VIEW_FACTS}});
    for (const std::string& tier : arguments.tiers)
        setTier(config, tier, isModel);
    checkCounts(arguments, config.coversByEdges());
    if (arguments.preset.empty())
        return;
    if (config.applyPreset(arguments.preset.c_str()) != AGAA_OK)
        throw BadArgument("--preset is \"" + arguments.preset + "\"; it can be paper, fast, balanced or accurate.");
    // The sample engine has fetch functions. It uses them if a preset needs them.
    if (arguments.preset != "paper" && config.generationTier == AGAA_TIER_AUTO && !config.coversByEdges())
        config.generationTier = AGAA_TIER_IDS;
}

} // namespace harness
