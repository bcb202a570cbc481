#include "environment/environment.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <stdexcept>
#include <string>

namespace harness {

namespace {

constexpr float largestHalf = 65504;

HalfLevel toHalf(const RadianceLevel& level) {
    HalfLevel half{level.width, level.height, {}};
    half.rgba.reserve(4 * level.texels.size());
    for (const glm::vec3& texel : level.texels) {
        for (int c = 0; c < 3; ++c)
            half.rgba.push_back(glm::packHalf1x16(std::min(texel[c], largestHalf)));
        half.rgba.push_back(glm::packHalf1x16(1.0f));
    }
    return half;
}

Image readImage(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".exr")
        return readExr(path);
    if (extension == ".hdr")
        return readHdr(path);
    throw std::runtime_error("The environment \"" + path.string() + "\" is neither a .hdr nor an .exr file.");
}

} // namespace

uint64_t Environment::bytes() const {
    uint64_t sum = sizeof(EnvironmentConstants);
    for (const HalfLevel& level : levels)
        sum += level.rgba.size() * sizeof(uint16_t);
    return sum;
}

Environment makeEnvironment(const Image& image) {
    Environment environment;
    environment.fileWidth = image.width;
    environment.fileHeight = image.height;
    const SphereImage sphere = makeSphereImage(image, radianceWidth, environment.replacedValues);
    const Irradiance irradiance = makeIrradiance(sphere);
    for (size_t i = 0; i < irradiance.size(); ++i)
        environment.constants.irradiance[i] = glm::vec4(irradiance[i], 0);
    const std::vector<glm::vec2> table = makeReflectanceTable();
    for (size_t i = 0; i < table.size(); i += 2)
        environment.constants.reflectance[i / 2] = glm::vec4(table[i], table[i + 1]);
    for (const RadianceLevel& level : makeRadianceLevels(sphere))
        environment.levels.push_back(toHalf(level));
    return environment;
}

Environment loadEnvironment(const std::filesystem::path& path) {
    const auto start = std::chrono::steady_clock::now();
    const Image image = readImage(path);
    if (image.width != 2 * image.height)
        throw std::runtime_error("The environment \"" + path.string() + "\" has " + std::to_string(image.width) + "x" +
                                 std::to_string(image.height) + " pixels; it must be twice as wide as high.");
    Environment environment = makeEnvironment(image);
    environment.file = path;
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    environment.milliseconds = elapsed.count();
    return environment;
}

} // namespace harness
