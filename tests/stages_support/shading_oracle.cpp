#include "shading_oracle.h"

#include "shader_math.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace agaa::test {

using math_d::agaa_Surface;

glm::dvec3 ShadingOracle::pixel(uint32_t x, uint32_t y) const {
    return plan_.view.aggregates ? aggregatedPixel(x, y) : perSamplePixel(x, y);
}

glm::dvec3 ShadingOracle::position(uint32_t x, uint32_t y, uint32_t i) const {
    using namespace math_d;
    const FrameConstants& c = constants_;
    const double depth = double(std::bit_cast<float>(depth_[sampleIndex(plan_, x, y, i)].x));
    const rvec2 ndc((x + double(constants_.sampleLocations[i][0])) / plan_.view.width * 2 - 1,
                    (y + double(constants_.sampleLocations[i][1])) / plan_.view.height * 2 - 1);
    const rvec3 v = agaa_viewPosition(
        ndc, agaa_viewZFromDepth(depth, double(c.projection22), double(c.projection32), c.isOrthographic),
        double(c.projectionScale[0]), double(c.projectionScale[1]), double(c.projectionOffset[0]),
        double(c.projectionOffset[1]), c.isOrthographic);
    glm::mat4 view;
    std::memcpy(&view, frame_.view, sizeof view);
    return glm::transpose(glm::dmat3(glm::mat3(view))) * v;
}

static glm::dvec3 towardsEye(const glm::dvec3& position, const FrameConstants& constants) {
    if (!constants.isOrthographic)
        return -glm::normalize(position);
    return {double(constants.view[2]), double(constants.view[6]), double(constants.view[10])};
}

// The layout's description in words: integer sums of codes, each of so many bits.
ShadingOracle::Shaded ShadingOracle::aggregate(const uint32_t* words, uint32_t count, const glm::dvec3& toEye) const {
    const AggregatePacking packing = packAggregate(plan_.view.layout, plan_.view.samples);
    const uint32_t growth = uint32_t(std::bit_width(plan_.view.samples) - 1);
    const auto sumOf = [&](const Field& f) {
        return double(uint64_t(words[f.word]) >> f.shift & ((uint64_t(1) << (f.bits + growth)) - 1));
    };
    const auto mean = [&](uint32_t channel) {
        const Field& f = packing.fields[channel];
        return f.bits ? sumOf(f) / (double(count) * double((1u << f.bits) - 1)) : 0.0;
    };
    // Around a code in the middle that stands for 0.
    const auto signedMean = [&](uint32_t channel) {
        const Field& f = packing.fields[channel];
        const double middle = double(1u << (f.bits - 1));
        return (sumOf(f) / double(count) - middle) / (middle - 1);
    };
    const auto mean3 = [&](uint32_t first) { return glm::dvec3(mean(first), mean(first + 1), mean(first + 2)); };
    Shaded s;
    s.diffuse = mean3(ChannelDiffuseR);
    const glm::dvec3 normal(signedMean(ChannelNormalX), signedMean(ChannelNormalY), signedMean(ChannelNormalZ));
    double length = 0;
    math_d::agaa_meanDirection(normal, toEye, s.normal, length);
    s.meanLength =
        math_d::agaa_varianceFloor(length, math_d::agaa_storedLengthBound(1, packing.fields[ChannelNormalX].bits));
    s.specular = mean3(ChannelSpecularR);
    if (plan_.view.layout.specularIsYCbCr())
        s.specular = glm::max(math_d::agaa_yCbCrToRgb(s.specular), glm::dvec3(0));
    if (plan_.view.layout.foldsRoughness()) {
        s.alpha2 = math_d::agaa_alpha2FromFoldedLength(length);
        s.meanLength = 1;
    } else {
        const double own = packing.fields[ChannelRoughness].bits ? mean(ChannelRoughness) : 1.0;
        s.alpha2 = plan_.view.config.ndf ? math_d::agaa_toksvigAlpha2(own, s.meanLength) : own;
    }
    const double range = double(plan_.view.layout.emissiveRange());
    s.emissive = range * mean3(ChannelEmissiveR);
    if (plan_.view.layout[AGAA_SEMANTIC_EMISSIVE].channels == 1)
        s.emissive = range * mean(ChannelEmissiveR) * s.diffuse;
    return s;
}

ShadingOracle::Shaded ShadingOracle::sample(size_t index) const {
    const GBufferPacking packing = packGBuffer(plan_.view.layout);
    const auto value = [&](uint32_t channel) {
        const Field& f = packing.fields[channel];
        return f.bits ? double(std::bit_cast<float>(gbuffer_[f.word][index][int(f.shift)])) : 0.0;
    };
    const auto value3 = [&](uint32_t first) { return glm::dvec3(value(first), value(first + 1), value(first + 2)); };
    Shaded s;
    s.diffuse = value3(ChannelDiffuseR);
    s.specular = value3(ChannelSpecularR);
    s.normal =
        math_d::agaa_decodeOct({value(ChannelNormalX), value(ChannelNormalY)}, packing.fields[ChannelNormalX].bits);
    s.alpha2 = packing.fields[ChannelRoughness].bits ? value(ChannelRoughness) : 1.0;
    const double range = double(plan_.view.layout.emissiveRange());
    s.emissive = range * value3(ChannelEmissiveR);
    if (plan_.view.layout[AGAA_SEMANTIC_EMISSIVE].channels == 1)
        s.emissive = range * value(ChannelEmissiveR) * s.diffuse;
    return s;
}

// At most the square of the pixel's width there.
double ShadingOracle::spreadOf(const std::vector<glm::dvec3>& samples, const glm::dvec3& mean) const {
    double spread = 0;
    for (const glm::dvec3& sample : samples)
        spread += glm::dot(sample - mean, sample - mean) / double(samples.size());
    const glm::dvec3 axis(frame_.view[2], frame_.view[6], frame_.view[10]);
    const double scale = constants_.isOrthographic ? 1 : std::fabs(glm::dot(axis, mean));
    const double width = scale * 2 / (std::fabs(double(constants_.projectionScale[0])) * plan_.view.width);
    return std::min(spread, width * width);
}

static math_d::agaa_SecondMoments momentsOf(const std::vector<glm::dvec3>& samples, const glm::dvec3& mean) {
    math_d::agaa_SecondMoments moments = math_d::agaa_noSecondMoments();
    for (const glm::dvec3& sample : samples)
        math_d::agaa_addSecondMoments(moments, 1 / double(samples.size()), sample - mean);
    return moments;
}

glm::dvec3 ShadingOracle::light(const Shaded& s, const glm::dvec3& position, const std::vector<glm::dvec3>& samples,
                                const std::vector<double>& visibility) const {
    const double spread = spreadOf(samples, position);
    const math_d::agaa_SecondMoments moments = momentsOf(samples, position);
    const glm::dvec3 toEye = towardsEye(position, constants_);
    const AgaaConfig& config = plan_.view.config;
    const agaa_Surface widened{s.diffuse, s.specular, s.emissive, s.normal, s.meanLength, s.alpha2, 0, glm::dvec3(0)};
    const AgaaMeasurement& measurement = plan_.view.measurement;
    const uint32_t filterDiffuse =
        measurement.flags & AGAA_MEASURE_NO_DIFFUSE_FILTER ? 0 : 1 + measurement.diffuseFilter;
    glm::dvec3 sum = s.emissive;
    for (int i = 0; i < 3; ++i)
        sum[i] += double(frame_.ambient[i]) * (s.diffuse[i] + s.specular[i]);
    for (uint32_t i = 0; i < frame_.lightCount; ++i) {
        const AgaaLight& light = frame_.lights[i];
        const glm::dvec3 direction(light.direction[0], light.direction[1], light.direction[2]);
        glm::dvec3 toLight = -direction;
        double intensity = 1;
        agaa_Surface surface = widened;
        if (light.type != AGAA_LIGHT_DIRECTIONAL) {
            const glm::dvec3 d = glm::dvec3(light.position[0], light.position[1], light.position[2]) - position;
            intensity = math_d::agaa_pointAttenuation(math_d::agaa_spreadDistance2(glm::dot(d, d), spread),
                                                      double(light.range), double(light.radius * light.radius));
            toLight = glm::normalize(d);
            if (light.type == AGAA_LIGHT_SPOT)
                intensity *= math_d::agaa_spotCone(glm::dot(-toLight, direction), double(light.cosInner),
                                                   double(light.cosOuter));
            if (measurement.flags & AGAA_MEASURE_LIGHT_DIRECTIONS)
                math_d::agaa_addDirectionVariance(surface, math_d::agaa_directionVariance(moments, d));
            if (spread > 0)
                toLight = glm::normalize(math_d::agaa_nearestToLight(d, s.normal, spread));
        }
        if (light.shadowMap != AGAA_NO_SHADOW)
            intensity *= visibility[light.shadowMap];
        if (intensity <= 0)
            continue;
        const glm::dvec3 brdf = plan_.view.layout.hasSpecularLight
                                    ? math_d::agaa_shade(surface, toEye, toLight, config.brdf, filterDiffuse, 0u)
                                    : math_d::agaa_shadeDiffuse(surface, toLight, filterDiffuse);
        sum += brdf * glm::dvec3(light.color[0], light.color[1], light.color[2]) * intensity;
    }
    return sum;
}

glm::dvec3 ShadingOracle::perSamplePixel(uint32_t x, uint32_t y) const {
    const GBufferPacking packing = packGBuffer(plan_.view.layout);
    const Field& normal = packing.fields[ChannelNormalX];
    glm::dvec3 sum(0);
    uint32_t covered = 0;
    for (uint32_t i = 0; i < plan_.view.samples; ++i) {
        const size_t index = sampleIndex(plan_, x, y, i);
        if (gbuffer_[normal.word][index][int(normal.shift)] == 0)
            continue;
        ++covered;
        const glm::dvec3 at = position(x, y, i);
        std::vector<double> visibility;
        for (uint32_t map = 0; map < frame_.shadowCount; ++map) {
            visibility.push_back(visibility_(map, at));
            ++shadowTaps_;
        }
        sum += light(sample(index), at, {}, visibility);
    }
    events_ += covered;
    const glm::dvec3 background(frame_.background[0], frame_.background[1], frame_.background[2]);
    return (sum + background * double(plan_.view.samples - covered)) / double(plan_.view.samples);
}

// By the moments that fragments sum, in place of the samples' depths.
std::pair<glm::dvec3, std::vector<glm::dvec3>>
ShadingOracle::storedTapsOf(const std::vector<glm::dvec3>& samples) const {
    const double p22 = double(constants_.projection22), p32 = double(constants_.projection32);
    const uint32_t orthographic = constants_.isOrthographic;
    const float* v = frame_.view;
    const glm::dmat3 view(v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]);
    const uint32_t count = uint32_t(samples.size());
    glm::uvec4 sums(0);
    glm::dvec2 aside(0);
    for (const glm::dvec3& sample : samples) {
        const glm::dvec3 at = view * sample;
        const uint32_t code =
            math_d::agaa_depthCode(math_d::agaa_depthOfViewZ(at.z, p22, p32, orthographic), p22, p32, orthographic);
        for (uint32_t m = 0; m < 4; ++m)
            sums[int(m)] += math_d::agaa_depthTerm(m, code);
        aside += glm::dvec2(at) / (orthographic ? 1.0 : at.z) / double(count);
    }
    const auto depth = math_d::agaa_storedDepth(math_d::agaa_momentsOfCodes(sums, count), p22, p32, orthographic);
    const auto placed = [&](double z) {
        return glm::transpose(view) * glm::dvec3(aside * (orthographic ? 1.0 : z), z);
    };
    std::vector<glm::dvec3> taps;
    for (const double quantile : {-1.34, -0.45, 0.45, 1.34})
        if (depth.deviation > 0 && !(plan_.view.measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER))
            taps.push_back(placed(std::clamp(depth.mean + quantile * depth.deviation, depth.farthest, depth.nearest)));
    if (taps.empty())
        taps.push_back(placed(depth.mean));
    return {placed(depth.mean), taps};
}

std::pair<glm::dvec3, std::vector<glm::dvec3>>
ShadingOracle::shadowTapsOf(const std::vector<glm::dvec3>& samples) const {
    if (plan_.view.measurement.flags & AGAA_MEASURE_STORED_DEPTH)
        return storedTapsOf(samples);
    const AgaaConfig& config = plan_.view.config;
    const bool alongDepth = plan_.view.measurement.flags & AGAA_MEASURE_SHADOW_ALONG_DEPTH;
    const size_t count = samples.size();
    const size_t most = alongDepth ? count : config.shadowTaps ? config.shadowTaps : 8;
    const size_t taps = std::min(count, most);
    std::vector<glm::dvec3> chosen;
    for (size_t j = 0; j < taps; ++j)
        chosen.push_back(samples[(2 * j + 1) * count / (2 * taps)]);
    glm::dvec3 mean(0);
    for (const glm::dvec3& sample : samples)
        mean += sample / double(count);
    if (plan_.view.measurement.flags & AGAA_MEASURE_NO_SHADOW_FILTER)
        return {mean, {mean}};
    if (plan_.view.measurement.flags & AGAA_MEASURE_SHADOW_COVARIANCE) {
        glm::dvec3 axis;
        const double sigma = std::sqrt(math_d::agaa_longestAxis(momentsOf(samples, mean), axis));
        if (sigma == 0)
            return {mean, {mean}};
        return {mean,
                {mean - 1.34 * sigma * axis, mean - 0.45 * sigma * axis, mean + 0.45 * sigma * axis,
                 mean + 1.34 * sigma * axis}};
    }
    if (!alongDepth)
        return {mean, chosen};
    const glm::dvec3 axis(frame_.view[2], frame_.view[6], frame_.view[10]);
    double variance = 0, lowest = 1e300, highest = -1e300; // of the offset from the mean
    for (const glm::dvec3& sample : samples) {
        const double offset = glm::dot(axis, sample - mean);
        variance += offset * offset / double(count);
        lowest = std::min(lowest, offset);
        highest = std::max(highest, offset);
    }
    if (variance < 1e-15) // of equal depths, whose mean rounds
        return {mean, {mean}};
    chosen.clear();
    const bool orthographic = frame_.projection[15] == 1.0f;
    for (double quantile : {-1.34, -0.45, 0.45, 1.34}) {
        const double offset = std::clamp(quantile * std::sqrt(variance), lowest, highest);
        chosen.push_back(orthographic ? mean + offset * axis : mean * (1 + offset / glm::dot(axis, mean)));
    }
    return {mean, chosen};
}

glm::dvec3 ShadingOracle::aggregatedPixel(uint32_t x, uint32_t y) const {
    const AggregatePacking packing = packAggregate(plan_.view.layout, plan_.view.samples);
    glm::dvec3 sum(0);
    uint32_t covered = 0;
    for (uint32_t a = 0; a < plan_.view.aggregates; ++a) {
        const uint32_t* words =
            &words_[((size_t(y) * plan_.view.width + x) * plan_.view.aggregates + a) * (plan_.bytesPerAggregate / 4)];
        const uint64_t field = words[packing.coverage.word] >> packing.coverage.shift;
        const uint32_t mask = uint32_t(field & ((uint64_t(1) << plan_.view.samples) - 1));
        if (!mask)
            continue;
        ++events_;
        const uint32_t count = uint32_t(std::popcount(mask));
        covered += count;
        std::vector<glm::dvec3> places;
        for (uint32_t i = 0; i < plan_.view.samples; ++i)
            if (mask >> i & 1)
                places.push_back(position(x, y, i));
        const auto [mean, taps] = shadowTapsOf(places);
        std::vector<double> visibility;
        for (uint32_t map = 0; map < frame_.shadowCount; ++map) {
            double lit = 0;
            for (const glm::dvec3& tap : taps)
                lit += visibility_(map, tap) / double(taps.size());
            visibility.push_back(lit);
            shadowTaps_ += taps.size();
        }
        sum += double(count) * light(aggregate(words, count, towardsEye(mean, constants_)), mean, places, visibility);
    }
    const glm::dvec3 background(frame_.background[0], frame_.background[1], frame_.background[2]);
    return (sum + background * double(plan_.view.samples - covered)) / double(plan_.view.samples);
}

} // namespace agaa::test
