#include "environment/radiance_levels.h"

#include "environment/hammersley.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace harness {

namespace {

constexpr double pi = std::numbers::pi;
// Images of this width are summed as they are: their texels are small against the lobe of level 3, which has alpha 1/4.
constexpr uint32_t summedWidth = 128;
constexpr uint32_t firstSummedLevel = 3;

// A direction of the lobe around +z, as the shaders of Karis 2013 sample it.
struct LobeSample {
    glm::vec3 direction;
    float weight; // cosine of the angle to the axis
    double solidAngle;
};

// All texels use the same Hammersley points, so that neighbours have the same error and the result is repeatable.
std::vector<LobeSample> lobeSamples(double alpha, uint32_t count) {
    std::vector<LobeSample> samples;
    const double a2 = alpha * alpha;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 point = hammersley(i, count);
        const double angle = 2 * pi * point.y;
        const double c2 = (1 - point.x) / (1 + (a2 - 1) * point.x); // squared cosine of the half vector
        const double z = 2 * c2 - 1;
        if (z <= 0)
            continue;
        const double across = 2 * std::sqrt(c2 * (1 - c2));
        const double d = c2 * (a2 - 1) + 1;
        const double density = a2 / (pi * d * d) / 4; // of the reflected direction, seen along the normal
        samples.push_back(
            {glm::vec3(across * std::cos(angle), across * std::sin(angle), z), float(z), 1 / (count * density)});
    }
    return samples;
}

// Samples read from the halved image whose texels are as large as the part of the lobe that they stand for (Krivanek
// and Colbert 2008, "Real-time Shading with Filtered Importance Sampling"), because a small bright spot would fall
// between them otherwise.
struct FilteredSample {
    glm::vec3 direction;
    float weight;
    size_t fine; // indices in the list of halved images
    size_t coarse;
    float share; // of the coarse one
};

std::vector<FilteredSample> filtered(const std::vector<LobeSample>& samples, const std::vector<SphereImage>& images) {
    std::vector<FilteredSample> result;
    const double texel = 2 * pi * pi / (double(images[0].width) * images[0].height);
    const size_t last = images.size() - 1;
    for (const LobeSample& s : samples) {
        const double lod = std::clamp(0.5 * std::log2(s.solidAngle / texel), 0.0, double(last));
        const size_t fine = size_t(lod);
        result.push_back({s.direction, s.weight, fine, std::min(fine + 1, last), float(lod - double(fine))});
    }
    return result;
}

// A sample of the lobes of one row of texels: their samples differ in longitude only.
struct PlacedSample {
    glm::vec2 place; // of the lobe at longitude 0
    float weight;
    const SphereImage* fine;
    const SphereImage* coarse;
    float share;
};

std::vector<PlacedSample> placed(const std::vector<FilteredSample>& samples, double colatitude,
                                 const std::vector<SphereImage>& images) {
    const glm::vec3 axis(sphereDirection(0, colatitude)), east(1, 0, 0), north = glm::cross(axis, east);
    std::vector<PlacedSample> result;
    for (const FilteredSample& s : samples) {
        const glm::vec3 direction = s.direction.x * east + s.direction.y * north + s.direction.z * axis;
        result.push_back({spherePlace(direction), s.weight, &images[s.fine], &images[s.coarse], s.share});
    }
    return result;
}

glm::vec3 sampledLobe(float longitude, const std::vector<PlacedSample>& samples) {
    glm::vec3 sum(0);
    float weights = 0;
    for (const PlacedSample& s : samples) {
        const glm::vec2 place(s.place.x + longitude, s.place.y);
        glm::vec3 radiance = s.fine->lookup(place);
        if (s.share > 0)
            radiance += s.share * (s.coarse->lookup(place) - radiance);
        sum += s.weight * radiance;
        weights += s.weight;
    }
    return sum / weights;
}

// The texels of an image as lights, in arrays that compilers vectorise.
struct Lights {
    std::vector<float> x, y, z, solidAngle;
    std::vector<float> radiance[3];
};

void addLight(Lights& lights, const SphereImage& image, uint32_t x, uint32_t y, const glm::vec3& radiance) {
    const glm::vec3 d = image.directionOf(x, y);
    lights.x.push_back(d.x);
    lights.y.push_back(d.y);
    lights.z.push_back(d.z);
    lights.solidAngle.push_back(float(image.solidAngle(y)));
    for (int c = 0; c < 3; ++c)
        lights.radiance[c].push_back(radiance[c]);
}

Lights lightsOf(const SphereImage& image) {
    Lights lights;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            addLight(lights, image, x, y, image.at(x, y));
    return lights;
}

// Moves the radiance of the sun and of lamps above a limit from the image to the result, which is summed without
// samples: a few texels may have most of the energy, and samples would find them by chance.
Lights takeBrightTexels(SphereImage& image) {
    constexpr size_t most = 256;
    const auto largest = [](const glm::vec3& v) { return std::max({v.r, v.g, v.b}); };
    std::vector<float> values;
    double mean = 0;
    for (const glm::vec3& texel : image.texels) {
        values.push_back(largest(texel));
        mean += double(values.back()) / double(image.texels.size());
    }
    std::ranges::nth_element(values, values.begin() + most, std::greater<>());
    const float limit = std::max(values[most], float(8 * mean));
    Lights lights;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            glm::vec3& texel = image.at(x, y);
            if (largest(texel) <= limit)
                continue;
            const glm::vec3 kept = glm::min(texel, glm::vec3(limit));
            addLight(lights, image, x, y, texel - kept);
            texel = kept;
        }
    return lights;
}

// Returns the integral of the weights of summedLobe() over all directions.
double lobeIntegral(double alpha2) {
    constexpr int steps = 20000; // against narrow lobes
    constexpr double step = pi / 4 / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double angle = step * (i + 0.5); // of the half vector
        const double d = std::cos(angle) * std::cos(angle) * (alpha2 - 1) + 1;
        sum += std::cos(2 * angle) / (d * d) * std::sin(2 * angle) * 2 * step;
    }
    return 2 * pi * sum;
}

struct LobeSum {
    glm::dvec3 radiance{0};
    double weight = 0;
};

LobeSum summedLobe(const glm::vec3& axis, float alpha2, const Lights& lights) {
    double sum[4] = {};
    constexpr size_t block = 64; // partial sums in float, which many small ones would exhaust
    for (size_t begin = 0; begin < lights.x.size(); begin += block) {
        const size_t end = std::min(begin + block, lights.x.size());
        float part[4] = {};
        for (size_t i = begin; i < end; ++i) {
            const float cosine = axis.x * lights.x[i] + axis.y * lights.y[i] + axis.z * lights.z[i];
            const float c2 = 0.5f + 0.5f * cosine; // squared cosine of the half vector
            const float d = c2 * (alpha2 - 1) + 1;
            const float weight = std::max(cosine, 0.0f) * lights.solidAngle[i] / (d * d);
            part[0] += weight * lights.radiance[0][i];
            part[1] += weight * lights.radiance[1][i];
            part[2] += weight * lights.radiance[2][i];
            part[3] += weight;
        }
        for (int k = 0; k < 4; ++k)
            sum[k] += double(part[k]);
    }
    return {{sum[0], sum[1], sum[2]}, sum[3]};
}

// The texels of a pole are one direction. They get one value, the mean over the frames of all longitudes.
void levelPoles(RadianceLevel& level) {
    for (const size_t first : {size_t(0), size_t(level.height - 1) * level.width}) {
        glm::dvec3 mean(0);
        for (size_t x = 0; x < level.width; ++x)
            mean += glm::dvec3(level.texels[first + x]);
        std::fill_n(level.texels.begin() + ptrdiff_t(first), level.width, glm::vec3(mean / double(level.width)));
    }
}

} // namespace

glm::dvec3 RadianceLevel::directionOf(uint32_t x, uint32_t y) const {
    return sphereDirection(2 * pi * ((x + 0.5) / width - 0.5), pi * y / (height - 1.0));
}

double alphaOfLevel(uint32_t level) {
    const double roughness = double(level) / (radianceLevelCount - 1);
    return roughness * roughness;
}

std::vector<RadianceLevel> makeRadianceLevels(const SphereImage& image, uint32_t width) {
    std::vector<SphereImage> images = {image};
    const Lights bright = takeBrightTexels(images[0]);
    while (images.back().width >= 4)
        images.push_back(halved(images.back()));
    const Lights others =
        lightsOf(*std::ranges::find_if(images, [](const SphereImage& i) { return i.width <= summedWidth; }));

    std::vector<RadianceLevel> levels;
    for (uint32_t i = 0; i < radianceLevelCount; ++i) {
        RadianceLevel level{width >> i, width >> (i + 1), {}};
        const double alpha = alphaOfLevel(i);
        const float alpha2 = float(alpha * alpha);
        const double integral = lobeIntegral(alpha * alpha);
        std::vector<FilteredSample> samples;
        if (i > 0 && i < firstSummedLevel)
            samples = filtered(lobeSamples(alpha, i == 1 ? 48 : 96), images);
        for (uint32_t y = 0; y < level.height; ++y) {
            const auto row = placed(samples, pi * y / (level.height - 1.0), images);
            for (uint32_t x = 0; x < level.width; ++x) {
                const glm::vec3 axis(level.directionOf(x, y));
                if (i == 0) {
                    level.texels.push_back(image.lookup(axis));
                    continue;
                }
                glm::vec3 radiance(summedLobe(axis, alpha2, bright).radiance / integral);
                if (i < firstSummedLevel) {
                    radiance += sampledLobe((float(x) + 0.5f) / float(level.width) - 0.5f, row);
                } else {
                    const LobeSum sum = summedLobe(axis, alpha2, others);
                    radiance += glm::vec3(sum.radiance / sum.weight);
                }
                level.texels.push_back(radiance);
            }
        }
        levelPoles(level);
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace harness
