#include "core/validate.h"

#include "core/technique.h"

#include <algorithm>
#include <bit>
#include <regex>
#include <sstream>
#include <string>

namespace agaa {

void checkHeader(const void* structure, uint32_t sType, size_t structSize, const char* name,
                 std::initializer_list<uint32_t> known) {
    if (!structure)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s is null.", name));
    const auto* header = static_cast<const AgaaStructHeader*>(structure);
    if (header->sType != sType)
        fail(AGAA_ERROR_STRUCT, format("%s has sType %u where %u is expected; start from its _INIT.",
                                       name, header->sType, sType));
    if (header->structSize != structSize)
        fail(AGAA_ERROR_STRUCT, format("%s has structSize %u where this library's is %zu.", name,
                                       header->structSize, structSize));
    uint32_t length = 0;
    std::vector<uint32_t> seen;
    for (const auto* next = static_cast<const AgaaStructHeader*>(header->pNext); next;
         next = static_cast<const AgaaStructHeader*>(next->pNext)) {
        if (++length > 64) // a chain that closes on itself
            fail(AGAA_ERROR_UNKNOWN_STRUCT, format("the chain of %s does not end.", name));
        if (std::find(known.begin(), known.end(), next->sType) != known.end()) {
            if (std::find(seen.begin(), seen.end(), next->sType) != seen.end())
                fail(AGAA_ERROR_UNKNOWN_STRUCT,
                     format("the chain of %s holds two structs of type %u.", name, next->sType));
            seen.push_back(next->sType);
        } else if (!(next->sType & AGAA_STRUCTURE_TYPE_OPTIONAL_BIT))
            fail(AGAA_ERROR_UNKNOWN_STRUCT,
                 format("the chain of %s holds a struct of type %u, which is not known here.", name,
                        next->sType));
    }
}

const void* findChained(const void* structure, uint32_t sType) {
    for (const void* next = static_cast<const AgaaStructHeader*>(structure)->pNext; next;
         next = static_cast<const AgaaStructHeader*>(next)->pNext)
        if (static_cast<const AgaaStructHeader*>(next)->sType == sType)
            return next;
    return nullptr;
}

void checkRange(double value, double low, double high, const char* name) {
    if (!(value >= low && value <= high)) // false for NaN too
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %g, outside [%g;%g].", name, value, low, high));
}

void checkRange(uint64_t value, uint64_t low, uint64_t high, const char* name) {
    if (value < low || value > high)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("%s is %llu, outside [%llu;%llu].", name, static_cast<unsigned long long>(value),
                    static_cast<unsigned long long>(low), static_cast<unsigned long long>(high)));
}

void checkSampleCount(uint32_t samples, const char* name) {
    if (samples < 1 || samples > 32 || !std::has_single_bit(samples))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %u, not one of 1, 2, 4, 8, 16, 32.", name, samples));
}

void checkHeaderVersion(uint32_t version) {
    if ((version >> 12) != (AGAA_HEADER_VERSION >> 12))
        fail(AGAA_ERROR_VERSION,
             format("the host was built for version %u.%u, this library is %u.%u.", version >> 22,
                    version >> 12 & 0x3FF, AGAA_VERSION_MAJOR, AGAA_VERSION_MINOR));
}

AgaaConfig checkConfig(const AgaaConfig* pointer) {
    const AgaaConfig& config = checkStruct(pointer, AGAA_STRUCTURE_TYPE_CONFIG, "AgaaConfig");
    require(config.technique, AGAA_ERROR_INVALID_ARGUMENT, "AgaaConfig::technique is null.");
    if (!findTechnique(config.technique))
        fail(AGAA_ERROR_UNSUPPORTED, format("no technique is called \"%.64s\".", config.technique));
    checkSampleCount(config.samples, "AgaaConfig::samples");
    checkRange(uint64_t(config.aggregates), 1, 6, "AgaaConfig::aggregates");
    checkRange(uint64_t(config.brdf), 0, AGAA_BRDF_GGX, "AgaaConfig::brdf");
    checkRange(uint64_t(config.ndf), 0, AGAA_NDF_SGGX, "AgaaConfig::ndf");
    checkRange(uint64_t(config.seeds), 0, AGAA_SEEDS_SUM_OF_SQUARES, "AgaaConfig::seeds");
    checkRange(uint64_t(config.shadowTaps), 0, 32, "AgaaConfig::shadowTaps");
    checkRange(uint64_t(config.shadingCost), 1, 64, "AgaaConfig::shadingCost");
    checkFinite(config.characteristicLength, "AgaaConfig::characteristicLength");
    checkRange(double(config.characteristicLength), 0.0, 3.4e38, "AgaaConfig::characteristicLength");
    checkRange(double(config.characteristicLengthPerDistance), 0.0, 1.0,
               "AgaaConfig::characteristicLengthPerDistance");
    // k = 0 divides by zero in equation 1 (hard case 21).
    require(config.characteristicLength > 0 || config.characteristicLengthPerDistance > 0,
            AGAA_ERROR_OUT_OF_RANGE,
            "AgaaConfig::characteristicLength and its share per distance are both 0; k must be > 0.");
    checkRange(double(config.aggregateThreshold), 0.0, 1e6, "AgaaConfig::aggregateThreshold");
    checkRange(double(config.surfaceCosine), 0.0, 1.0, "AgaaConfig::surfaceCosine");
    checkRange(double(config.surfaceDistance), 0.0, 1e6, "AgaaConfig::surfaceDistance");
    checkRange(double(config.surfaceMaterial), 0.0, 1.0, "AgaaConfig::surfaceMaterial");
    checkRange(uint64_t(config.litShadows), 0, (1u << AGAA_MAX_SHADOW_MAPS) - 1, "AgaaConfig::litShadows");
    checkRange(double(config.glossWeight), 0.0, 16.0, "AgaaConfig::glossWeight");
    checkRange(uint64_t(config.debugView), 0, AGAA_DEBUG_VIEW_TIER, "AgaaConfig::debugView");
    constexpr uint64_t known = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_READBACK |
                               AGAA_CONFIG_NO_DIFFUSE_FILTER | AGAA_CONFIG_NO_SHADOW_FILTER |
                               AGAA_CONFIG_SHADOW_ALONG_DEPTH | AGAA_CONFIG_NO_STENCIL |
                               AGAA_CONFIG_FIRST_SAMPLE_ROUTING | AGAA_CONFIG_SPLIT_SURFACES |
                               AGAA_CONFIG_BUFFERED | AGAA_CONFIG_FINE_MATERIALS;
    require((config.flags & ~known) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaConfig::flags has bits that are not known here.");
    return config;
}

AgaaSceneFacts checkFacts(const AgaaSceneFacts* pointer) {
    const AgaaSceneFacts& facts =
        checkStruct(pointer, AGAA_STRUCTURE_TYPE_SCENE_FACTS, "AgaaSceneFacts");
    checkRange(uint64_t(facts.maxLights), 0, 4096, "AgaaSceneFacts::maxLights");
    checkRange(uint64_t(facts.shadowMapCount), 0, AGAA_MAX_SHADOW_MAPS,
               "AgaaSceneFacts::shadowMapCount");
    constexpr uint64_t known = AGAA_FACT_ALL_SHADED | AGAA_FACT_CUSTOM_DEPTH;
    require((facts.flags & ~known) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaSceneFacts::flags has bits that are not known here.");
    return facts;
}

void checkViewDesc(const AgaaViewDesc* pointer) {
    checkHeader(pointer, AGAA_STRUCTURE_TYPE_VIEW, sizeof *pointer, "AgaaViewDesc",
                {AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION, AGAA_STRUCTURE_TYPE_FETCH_FUNCTION,
                 AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION});
    const AgaaViewDesc& desc = *pointer;
    require(desc.width > 0 && desc.height > 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaViewDesc has no pixels: width and height must be at least 1.");
    constexpr uint64_t known =
        AGAA_VIEW_REVERSED_Z | AGAA_VIEW_COMPOSITE | AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    require((desc.flags & ~known) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaViewDesc::flags has bits that are not known here.");
}

// Text of the host's, and the lines that go before all else.
static void checkGlsl(const char* glsl, const char* extensions, const char* structure) {
    if (!glsl)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s::glsl is null.", structure));
    static const std::regex directive(R"([ \t]*\r?|#extension +\w+ *: *\w+[ \t]*\r?)");
    std::istringstream lines(extensions ? extensions : "");
    for (std::string line; std::getline(lines, line);)
        if (line.size() > 200 || !std::regex_match(line, directive))
            fail(AGAA_ERROR_INVALID_ARGUMENT,
                 format("%s::glslExtensions has more than lines \"#extension NAME : BEHAVIOUR\".", structure));
}

const AgaaShadowFunction* checkShadowFunction(const AgaaViewDesc& desc) {
    const void* chained = findChained(&desc, AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION);
    if (!chained)
        return nullptr;
    const auto* function = static_cast<const AgaaShadowFunction*>(chained);
    require(function->structSize == sizeof *function, AGAA_ERROR_STRUCT,
            "AgaaShadowFunction has another structSize than this library's.");
    checkGlsl(function->glsl, function->glslExtensions, "AgaaShadowFunction");
    require(function->reserved == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaShadowFunction::reserved is not 0.");
    const uint32_t declared = (1u << desc.facts->shadowMapCount) - 1;
    require(function->shadows != 0 && (function->shadows & ~declared) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaShadowFunction::shadows names no shadow, or more than AgaaSceneFacts declares.");
    return function;
}

const AgaaGBufferFunction* checkGBufferFunction(const AgaaViewDesc& desc, uint32_t samples) {
    const void* chained = findChained(&desc, AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION);
    if (!chained)
        return nullptr;
    const auto* function = static_cast<const AgaaGBufferFunction*>(chained);
    require(function->structSize == sizeof *function, AGAA_ERROR_STRUCT,
            "AgaaGBufferFunction has another structSize than this library's.");
    checkGlsl(function->glsl, function->glslExtensions, "AgaaGBufferFunction");
    require(function->reserved == 0, AGAA_ERROR_OUT_OF_RANGE, "AgaaGBufferFunction::reserved is not 0.");
    require(function->depthBits == 0 || function->depthBits == 16 || function->depthBits == 24,
            AGAA_ERROR_OUT_OF_RANGE, "AgaaGBufferFunction::depthBits is not one of 0, 16, 24.");
    for (uint32_t i = 0; function->samplePositions && i < 2 * samples; ++i)
        require(function->samplePositions[i] >= 0 && function->samplePositions[i] < 1, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaGBufferFunction::samplePositions holds a place outside the pixel, [0;1).");
    return function;
}

const AgaaFetchFunction* checkFetchFunction(const AgaaViewDesc& desc) {
    const void* chained = findChained(&desc, AGAA_STRUCTURE_TYPE_FETCH_FUNCTION);
    if (!chained)
        return nullptr;
    const auto* function = static_cast<const AgaaFetchFunction*>(chained);
    require(function->structSize == sizeof *function, AGAA_ERROR_STRUCT,
            "AgaaFetchFunction has another structSize than this library's.");
    checkGlsl(function->glsl, function->glslExtensions, "AgaaFetchFunction");
    require(function->maxDraws >= 1 && function->maxPrimitives >= 1, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFetchFunction::maxDraws or ::maxPrimitives is 0.");
    require((function->flags & ~AGAA_FETCH_NOT_ALL_DRAWS) == 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFetchFunction::flags has bits that are not known here.");
    const int bits = std::bit_width(function->maxPrimitives - 1);
    // One id is of what cannot be fetched, one of no geometry.
    const uint32_t ids = function->flags & AGAA_FETCH_NOT_ALL_DRAWS ? 0xFFFFFFFEu : 0xFFFFFFFFu;
    if ((uint64_t(function->maxDraws) << bits) > ids)
        fail(AGAA_ERROR_TOO_LARGE,
             format("%u draws of up to %u primitives each, which take %d bits, are more than 32-bit ids can tell.",
                    function->maxDraws, function->maxPrimitives, bits));
    return function;
}

static void checkMatrices(const AgaaFrame& frame, bool reversedZ) {
    for (float element : frame.view)
        checkFinite(element, "AgaaFrame::view");
    for (float element : frame.projection)
        checkFinite(element, "AgaaFrame::projection");
    const float* v = frame.view;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            const float dot =
                v[4 * i] * v[4 * j] + v[4 * i + 1] * v[4 * j + 1] + v[4 * i + 2] * v[4 * j + 2];
            if (std::fabs(dot - (i == j ? 1.0f : 0.0f)) > 1e-3f)
                fail(AGAA_ERROR_OUT_OF_RANGE, "AgaaFrame::view is not a rotation.");
        }
    if (v[12] != 0 || v[13] != 0 || v[14] != 0)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             "AgaaFrame::view has a translation; shading space has its origin at the eye.");
    const float* p = frame.projection;
    const bool perspective = p[11] == -1.0f && p[15] == 0.0f;
    const bool orthographic = p[11] == 0.0f && p[15] == 1.0f;
    require(perspective || orthographic, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::projection is neither perspective (looking down -z) nor orthographic.");
    // Elements that are zero in every projection without shear, roll or an oblique near plane.
    bool plain = p[1] == 0 && p[2] == 0 && p[3] == 0 && p[4] == 0 && p[6] == 0 && p[7] == 0;
    plain = plain && (perspective ? p[12] == 0 && p[13] == 0 : p[8] == 0 && p[9] == 0);
    require(plain, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::projection has shear, roll or an oblique near plane.");
    // Depth grows away from the eye, or falls.
    const bool reversed = (perspective ? p[14] : p[10]) > 0;
    require(reversed == reversedZ, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::projection and AGAA_VIEW_REVERSED_Z do not agree on which depth is near.");
    require(p[0] != 0 && p[5] != 0 && (perspective ? p[14] : p[10]) != 0, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::projection is singular.");
}

static void checkLight(const AgaaLight& light, uint32_t index, uint32_t shadowCount) {
    const auto bad = [&](const char* what) {
        fail(AGAA_ERROR_OUT_OF_RANGE, format("light %u: %s.", index, what));
    };
    if (light.type > AGAA_LIGHT_SPOT)
        bad("its type is not known");
    if (light.shadowMap != AGAA_NO_SHADOW && light.shadowMap >= shadowCount)
        bad("its shadow map is not among the frame's shadows");
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(light.position[i]) <= 1e18f)) // its square is a float
            bad("its position is not in [-1e18;1e18]");
        if (!std::isfinite(light.direction[i]))
            bad("its direction is not finite");
        if (!(light.color[i] >= 0 && light.color[i] <= 1e30f))
            bad("its colour is not in [0;1e30]");
    }
    if (!(light.range >= 0 && light.range <= 1e18f))
        bad("its range is not in [0;1e18]");
    if (light.reserved != 0)
        bad("its reserved member is not 0");
    if (!(light.radius >= 0 && light.radius <= 1e15f))
        bad("its radius is not in [0;1e15]");
    if (light.type != AGAA_LIGHT_POINT) {
        const float* d = light.direction;
        if (std::fabs(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - 1.0f) > 1e-2f)
            bad("its direction is not a unit vector");
    }
    if (light.type == AGAA_LIGHT_SPOT &&
        !(light.cosInner >= light.cosOuter && light.cosOuter >= -1 && light.cosInner <= 1))
        bad("its cone is not inner cosine >= outer cosine in [-1;1]");
}

void checkFrame(const AgaaFrame* pointer, const Plan& plan) {
    const AgaaSceneFacts& facts = plan.facts;
    const AgaaFrame& frame = checkStruct(pointer, AGAA_STRUCTURE_TYPE_FRAME, "AgaaFrame");
    require(frame.segments != 0 && (frame.segments & ~AGAA_SEGMENT_ALL) == 0,
            AGAA_ERROR_OUT_OF_RANGE, "AgaaFrame::segments names no segment or an unknown one.");
    require(frame.completedFrame < frame.frameIndex, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::completedFrame is not before frameIndex.");
    require(frame.reserved == 0, AGAA_ERROR_OUT_OF_RANGE, "AgaaFrame::reserved is not 0.");
    require(frame.draw || plan.geometryPasses() == 0, AGAA_ERROR_INVALID_ARGUMENT, "AgaaFrame::draw is null.");
    checkMatrices(frame, plan.reversedZ);
    checkRange(uint64_t(frame.lightCount), 0, facts.maxLights,
               "AgaaFrame::lightCount (against AgaaSceneFacts::maxLights)");
    checkRange(uint64_t(frame.shadowCount), 0, facts.shadowMapCount,
               "AgaaFrame::shadowCount (against AgaaSceneFacts::shadowMapCount)");
    require(!frame.lightCount || frame.lights, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaFrame::lights is null.");
    require(!frame.shadowCount || frame.shadows, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaFrame::shadows is null.");
    for (uint32_t i = 0; i < frame.lightCount; ++i)
        checkLight(frame.lights[i], i, frame.shadowCount);
    for (uint32_t i = 0; i < frame.shadowCount; ++i) {
        if (plan.functionShadows >> i & 1) {
            checkRange(uint64_t(frame.shadows[i].layerCount), 0, 0,
                       "AgaaShadow::layerCount (of a shadow that AgaaShadowFunction answers for)");
            continue;
        }
        checkRange(uint64_t(frame.shadows[i].layerCount), 1, AGAA_MAX_SHADOW_LAYERS,
                   "AgaaShadow::layerCount");
        checkRange(double(frame.shadows[i].depthBias), 0.0, 1.0, "AgaaShadow::depthBias");
        for (uint32_t j = 0; j < 16 * frame.shadows[i].layerCount; ++j)
            checkFinite(frame.shadows[i].matrices[0][j], "AgaaShadow::matrices");
    }
    for (float value : frame.ambient)
        checkRange(double(value), 0.0, 65504.0, "AgaaFrame::ambient");
    for (float value : frame.background)
        checkRange(double(value), 0.0, 65504.0, "AgaaFrame::background");
}

} // namespace agaa
