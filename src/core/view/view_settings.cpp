#include "core/view/view_settings.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/structs.h"
#include "core/view/facts.h"
#include "core/view/technique.h"

#include <algorithm>
#include <bit>
#include <string_view>

namespace agaa {

static void readMeasurement(const AgaaConfig& config, ViewSettings& view) {
    const std::optional<AgaaMeasurement> chained = readChained<AgaaMeasurement>(&config);
    if (!chained)
        return;
    const AgaaMeasurement& m = view.measurement = *chained;
    view.measurement.pNext = nullptr;
    checkRange(uint64_t(m.shadingCost), 1, 64, "AgaaMeasurement::shadingCost");
    checkRange(uint64_t(m.debugView), 0, AGAA_DEBUG_VIEW_FACTS, "AgaaMeasurement::debugView");
    checkRange(uint64_t(m.seeds), 0, AGAA_SEEDS_SUM_OF_SQUARES, "AgaaMeasurement::seeds");
    checkRange(uint64_t(m.lanes), 0, AGAA_LANES_SAMPLE_SUBGROUP, "AgaaMeasurement::lanes");
    checkFlags(m.flags,
               AGAA_MEASURE_NO_DIFFUSE_FILTER | AGAA_MEASURE_NO_SHADOW_FILTER | AGAA_MEASURE_SHADOW_ALONG_DEPTH |
                   AGAA_MEASURE_NO_STENCIL | AGAA_MEASURE_FIRST_SAMPLE_ROUTING | AGAA_MEASURE_NO_LIGHT_CULLING |
                   AGAA_MEASURE_LIGHT_DIRECTIONS | AGAA_MEASURE_SHADOW_COVARIANCE | AGAA_MEASURE_STORED_DEPTH |
                   AGAA_MEASURE_DEPTH_PLANES,
               "AgaaMeasurement::flags");
    checkRange(uint64_t(m.diffuseFilter), 0, AGAA_DIFFUSE_SGGX, "AgaaMeasurement::diffuseFilter");
    checkReserved(m.reserved, "AgaaMeasurement::reserved");
    require(
        !(m.flags & AGAA_MEASURE_SHADOW_COVARIANCE) ||
            !(m.flags & (AGAA_MEASURE_SHADOW_ALONG_DEPTH | AGAA_MEASURE_STORED_DEPTH | AGAA_MEASURE_NO_SHADOW_FILTER)),
        AGAA_ERROR_INVALID_ARGUMENT,
        "AgaaMeasurement::flags: AGAA_MEASURE_SHADOW_COVARIANCE excludes the other places of shadow taps.");
}

static void readSettings(const AgaaConfig& config, TechniqueTable table, ViewSettings& view) {
    readMeasurement(config, view);
    for (const Technique* technique : table)
        for (const TechniqueSettings* settings : technique->settings)
            settings->read(config, view);
}

static void checkTier(uint32_t tier, const char* name) {
    if (!isTier(tier))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %u, which is not an AgaaTier.", name, tier));
}

static AgaaConfig checkConfig(const AgaaConfig* pointer, TechniqueTable table) {
    const AgaaConfig config = readStruct(pointer, configChain(table));
    require(config.technique, AGAA_ERROR_INVALID_ARGUMENT, "AgaaConfig::technique is null.");
    if (!findTechnique(table, config.technique))
        fail(AGAA_ERROR_UNSUPPORTED, format("no technique is called \"%s\".", printable(config.technique).c_str()));
    checkRange(uint64_t(config.aggregates), 1, 8, "AgaaConfig::aggregates");
    checkRange(uint64_t(config.brdf), 0, AGAA_BRDF_GGX, "AgaaConfig::brdf");
    checkRange(uint64_t(config.ndf), 0, AGAA_NDF_SGGX, "AgaaConfig::ndf");
    checkTier(config.visibilityTier, "AgaaConfig::visibilityTier");
    checkTier(config.generationTier, "AgaaConfig::generationTier");
    checkRange(uint64_t(config.shadowTaps), 0, 32, "AgaaConfig::shadowTaps");
    checkRange(double(config.surfaceCosine), 0.0, 1.0, "AgaaConfig::surfaceCosine");
    checkRange(double(config.surfaceDistance), 0.0, 1e6, "AgaaConfig::surfaceDistance");
    checkRange(double(config.surfaceMaterial), 0.0, 1.0, "AgaaConfig::surfaceMaterial");
    checkFlags(config.flags,
               AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_READBACK | AGAA_CONFIG_SPLIT_SURFACES |
                   AGAA_CONFIG_BUFFERED | AGAA_CONFIG_FINE_MATERIALS | AGAA_CONFIG_CHECK_FACTS |
                   AGAA_CONFIG_ACCUMULATE | AGAA_CONFIG_HDR_RESOLVE | AGAA_CONFIG_BREADCRUMBS,
               "AgaaConfig::flags");
    return config;
}

static uint32_t checkSamples(uint32_t samples, const Technique& technique, uint32_t generationTier) {
    if (!technique.countsCoverage(generationTier, samples)) {
        if (samples == gridOnlySamples && technique.allowsGridOnlySamples())
            return std::min(samples, technique.maxSamples);
        checkSampleCount(samples, "AgaaConfig::samples");
        return std::min(samples, technique.maxSamples);
    }
    const bool isEither = generationTier == AGAA_TIER_AUTO && technique.maxSamples > 0;
    if (samples != 32 && samples != 64 && samples != 128)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaConfig::samples is %u; \"%s\" takes %s32, 64 or 128 coverage samples.", samples,
                    technique.name, isEither ? "1, 2, 4, 8, 16 or 32 samples, or " : ""));
    return samples;
}

static AgaaViewDesc checkViewDesc(const AgaaViewDesc* pointer) {
    const AgaaViewDesc desc =
        readStruct(pointer, {AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION, AGAA_STRUCTURE_TYPE_FETCH_FUNCTION,
                             AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION, AGAA_STRUCTURE_TYPE_SHADING_FUNCTION,
                             AGAA_STRUCTURE_TYPE_RESOLVED_OUTPUTS});
    require(desc.width > 0 && desc.height > 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaViewDesc has no pixels: width and height must be at least 1.");
    checkFlags(desc.flags,
               AGAA_VIEW_REVERSED_Z | AGAA_VIEW_COMPOSITE | AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE | AGAA_VIEW_VERTEX_PULLING,
               "AgaaViewDesc::flags");
    return desc;
}

// Returns whether a line is blank or "#extension NAME : BEHAVIOUR". std::regex is not used, because threads that
// compile or match one at the same time write to a table of the locale.
static bool isExtensionLine(std::string_view line) {
    const auto skip = [&](auto isSkipped) {
        const auto end = std::find_if_not(line.begin(), line.end(), isSkipped);
        const auto count = size_t(end - line.begin());
        line.remove_prefix(count);
        return count > 0;
    };
    const auto isSpace = [](char c) { return c == ' '; };
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    while (line.ends_with(' ') || line.ends_with('\t'))
        line.remove_suffix(1);
    if (line.empty())
        return true;
    constexpr std::string_view keyword = "#extension";
    if (!line.starts_with(keyword))
        return false;
    line.remove_prefix(keyword.size());
    if (!skip(isSpace) || !skip(isWordByte))
        return false;
    skip(isSpace);
    if (!line.starts_with(':'))
        return false;
    line.remove_prefix(1);
    skip(isSpace);
    return skip(isWordByte) && line.empty();
}

// Checks the text of a host's function and its extension lines.
static void checkGlsl(const char* glsl, const char* extensions, const char* structure) {
    if (!glsl)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s::glsl is null.", structure));
    std::string_view rest(extensions ? extensions : "");
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (line.size() > 200 || !isExtensionLine(line))
            fail(AGAA_ERROR_INVALID_ARGUMENT,
                 format("%s::glslExtensions has more than lines \"#extension NAME : BEHAVIOUR\".", structure));
    }
}

// Returns a host's function that is chained to the view, after its text was checked.
template <typename Function> static std::optional<Function> chainedFunction(const AgaaViewDesc& desc) {
    const std::optional<Function> function = readChained<Function>(&desc);
    if (function)
        checkGlsl(function->glsl, function->glslExtensions, StructOf<Function>::row.name);
    return function;
}

// Copies the text of a function. All functions of a view use the same set of resources.
template <typename Function> static HostText copyFunction(const Function& function, ViewSettings& view) {
    const uint64_t setLayout = function.descriptorSetLayout;
    require(!setLayout || !view.functionSetLayout || setLayout == view.functionSetLayout, AGAA_ERROR_INVALID_ARGUMENT,
            "functions of the view have different set layouts; all find their resources in set 1.");
    if (setLayout)
        view.functionSetLayout = setLayout;
    return {function.glsl, function.glslExtensions ? function.glslExtensions : ""};
}

static void readShadowFunction(const AgaaViewDesc& desc, ViewSettings& view) {
    const std::optional<AgaaShadowFunction> function = chainedFunction<AgaaShadowFunction>(desc);
    if (!function)
        return;
    const uint32_t declared = (1u << view.facts.shadowMapCount) - 1;
    require(function->shadows != 0 && (function->shadows & ~declared) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaShadowFunction::shadows names no shadow, or more than AgaaSceneFacts declares.");
    require((function->footprints & ~function->shadows) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaShadowFunction::footprints names shadows that AgaaShadowFunction::shadows does not.");
    view.functionShadows = function->shadows;
    view.footprintShadows = function->footprints;
    view.shadowFunction = copyFunction(*function, view);
}

static void readShadingFunction(const AgaaViewDesc& desc, ViewSettings& view) {
    const std::optional<AgaaShadingFunction> function = chainedFunction<AgaaShadingFunction>(desc);
    if (!function)
        return;
    checkReserved(function->reserved, "AgaaShadingFunction::reserved");
    checkRange(uint64_t(function->level), 0, AGAA_SHADING_EVENT, "AgaaShadingFunction::level");
    view.hostShadesEvents = function->level == AGAA_SHADING_EVENT;
    view.shadingFunction = copyFunction(*function, view);
}

// Custom attributes are members of AgaaSurface, too.
static void checkNamesOfCustoms(const Layout& layout) {
    static constexpr std::string_view members[] = {"normalLength",     "alpha2Along",    "axis",
                                                   "positionSpread",   "materialAlpha2", "pixel",
                                                   "coverage",         "shadows",        "positionSquares",
                                                   "positionProducts", "depthVariance"};
    for (const CustomAttribute& custom : layout.customs)
        if (std::ranges::find(members, custom.name) != std::end(members))
            fail(AGAA_ERROR_LAYOUT,
                 format("custom layout attribute \"%s\": AgaaSurface, which an AgaaShadingFunction receives, has a "
                        "member of this name.",
                        custom.name.c_str()));
}

static void readGBufferFunction(const AgaaViewDesc& desc, ViewSettings& view) {
    const std::optional<AgaaGBufferFunction> function = chainedFunction<AgaaGBufferFunction>(desc);
    if (!function)
        return;
    checkReserved(function->reserved, "AgaaGBufferFunction::reserved");
    require(function->depthBits == 0 || function->depthBits == 16 || function->depthBits == 24, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaGBufferFunction::depthBits is not one of 0, 16, 24.");
    for (uint32_t i = 0; function->samplePositions && i < 2 * view.samples; ++i)
        require(function->samplePositions[i] >= 0 && function->samplePositions[i] < 1, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaGBufferFunction::samplePositions holds a place outside the pixel, [0;1).");
    view.hostGBuffer = true;
    view.depthBits = function->depthBits;
    if (const float* positions = function->samplePositions)
        view.samplePositions.assign(positions, positions + 2 * view.samples);
    view.gbufferFunction = copyFunction(*function, view);
}

static void readFetchFunction(const AgaaViewDesc& desc, ViewSettings& view) {
    const std::optional<AgaaFetchFunction> function = chainedFunction<AgaaFetchFunction>(desc);
    if (!function)
        return;
    require(function->maxDraws >= 1 && function->maxPrimitives >= 1, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFetchFunction::maxDraws or ::maxPrimitives is 0.");
    checkFlags(function->flags, AGAA_FETCH_NOT_ALL_DRAWS, "AgaaFetchFunction::flags");
    const int bits = std::bit_width(function->maxPrimitives - 1);
    // One id is reserved for samples without geometry, and one for draws that cannot be fetched.
    const uint32_t ids = function->flags & AGAA_FETCH_NOT_ALL_DRAWS ? 0xFFFFFFFEu : 0xFFFFFFFFu;
    if ((uint64_t(function->maxDraws) << bits) > ids)
        fail(AGAA_ERROR_TOO_LARGE,
             format("%u draws of up to %u primitives each, which take %d bits, are more than 32-bit ids can tell.",
                    function->maxDraws, function->maxPrimitives, bits));
    require(!view.hostGBuffer, AGAA_ERROR_INVALID_ARGUMENT,
            "the view has an AgaaGBufferFunction and an AgaaFetchFunction; materials come by one of them.");
    checkReserved(function->reserved, "AgaaFetchFunction::reserved");
    require(function->maxTriangles < 1u << 31, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFetchFunction::maxTriangles is 2^31 or more.");
    view.maxTriangles = function->maxTriangles;
    view.maxDraws = function->maxDraws;
    view.maxPrimitives = function->maxPrimitives;
    view.someUnfetched = function->flags & AGAA_FETCH_NOT_ALL_DRAWS;
    view.primitiveBits = uint32_t(bits);
    view.fetchFunction = copyFunction(*function, view);
}

std::vector<uint32_t> configChain(TechniqueTable table) {
    std::vector<uint32_t> types = settingsTypes(table);
    types.push_back(AGAA_STRUCTURE_TYPE_MEASUREMENT);
    return types;
}

void setCounts(ViewSettings& view, uint32_t samples, uint32_t aggregates) {
    view.samples = view.config.samples = samples;
    view.config.aggregates = aggregates;
    view.aggregates = view.technique->maxAggregates ? std::min(aggregates, samples) : 0;
}

void changeSamples(ViewSettings& view, uint32_t samples) {
    require(view.samplePositions.empty() || samples == view.samples, AGAA_ERROR_UNSUPPORTED,
            "AgaaGBufferFunction::samplePositions has the positions of the described samples alone.");
    const bool countsCoverage = view.technique->countsCoverage(view.config.generationTier, samples);
    require(view.coveragePositions.empty() || samples == view.samples || !countsCoverage, AGAA_ERROR_UNSUPPORTED,
            "AgaaDecoupledCoverage::samplePositions has the positions of the described samples alone.");
    if (!countsCoverage)
        view.coveragePositions.clear();
    setCounts(view, samples, view.config.aggregates);
}

ViewSettings resolveView(const AgaaViewDesc* pointer, TechniqueTable table) {
    const AgaaViewDesc desc = checkViewDesc(pointer);
    ViewSettings view;
    view.width = desc.width;
    view.height = desc.height;
    view.reversedZ = desc.flags & AGAA_VIEW_REVERSED_Z;
    view.composite = desc.flags & AGAA_VIEW_COMPOSITE;
    view.clipZFromMinusOne = desc.flags & AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    view.vertexPulling = desc.flags & AGAA_VIEW_VERTEX_PULLING;
    view.config = checkConfig(desc.config, table);
    readSettings(view.config, table, view);
    view.config.pNext = nullptr;
    view.facts = view.variantFacts = checkFacts(desc.facts);
    const Technique& technique = *findTechnique(table, view.config.technique);
    view.config.technique = technique.name; // static storage
    view.technique = &technique;
    setCounts(view, checkSamples(view.config.samples, technique, view.config.generationTier), view.config.aggregates);
    if (!technique.countsCoverage(view.config.generationTier, view.samples))
        view.coveragePositions.clear();
    readShadowFunction(desc, view);
    readShadingFunction(desc, view);
    readGBufferFunction(desc, view);
    readFetchFunction(desc, view);
    view.layout = checkLayout(view.config.layout);
    if (view.shadingFunction)
        checkNamesOfCustoms(view.layout);
    view.resolvedOutputs = readResolvedOutputs(desc, view.layout);
    view.config.layout = nullptr; // the host's pointer does not outlive the call
    if (technique.maxAggregates && view.config.aggregates > technique.maxAggregates)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("AgaaConfig::aggregates is %u; \"%s\" takes %u at most.",
                                             view.config.aggregates, technique.name, technique.maxAggregates));
    return view;
}

} // namespace agaa
