// The light around a scene, from an image file, in the form that shaders read.
#pragma once

#include "environment/irradiance.h"
#include "environment/radiance_levels.h"
#include "environment/reflectance_table.h"

#include <filesystem>

namespace harness {

// A level as texels of four half floats.
struct HalfLevel {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint16_t> rgba;
};

// Matches the block EnvironmentLight of shaders/environment.glsl (std140).
struct EnvironmentConstants {
    glm::vec4 irradiance[9];                                        // Irradiance
    glm::vec4 reflectance[reflectanceSteps * reflectanceSteps / 2]; // makeReflectanceTable(), two entries each
};

struct Environment {
    std::vector<HalfLevel> levels; // radianceLevelCount
    EnvironmentConstants constants;

    std::filesystem::path file;
    uint32_t fileWidth = 0;
    uint32_t fileHeight = 0;
    uint64_t replacedValues = 0; // of the file, that were not finite or were below 0
    double milliseconds = 0;     // of reading and filtering

    uint64_t bytes() const; // on the device
};

// Filters an image. Radiance above the largest half float is clamped to it.
Environment makeEnvironment(const Image& image);

// Reads a Radiance file (.hdr) or an OpenEXR file (.exr). The image must be twice as wide as high. Throws
// std::runtime_error with one sentence that names the file.
Environment loadEnvironment(const std::filesystem::path& path);

} // namespace harness
