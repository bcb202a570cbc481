// The shading function for the light of an environment (shaders/environment.glsl).
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace harness {

// The layout's attribute for the class of a material, as the shaders name it.
inline constexpr const char* classAttribute = "materialClass";
// Precedes the texts of views whose layout has the attribute.
inline constexpr const char* classDefine = "#define MATERIAL_CLASSES 1\n";

// The places where a graphics API binds the environment.
struct EnvironmentBindings {
    std::string map, light;           // layout qualifiers
    uint64_t descriptorSetLayout = 0; // AgaaShadingFunction::descriptorSetLayout
};

// Returns the text for AgaaShadingFunction::glsl.
std::string environmentGlsl(const EnvironmentBindings& bindings, const AgaaSceneFacts& facts, bool hasClasses);

} // namespace harness
