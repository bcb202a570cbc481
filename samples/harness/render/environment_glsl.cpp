#include "render/environment_glsl.h"

#include "embedded.h"
#include "environment/radiance_levels.h"

namespace harness {

std::string environmentGlsl(const EnvironmentBindings& bindings, const AgaaSceneFacts& facts, bool hasClasses) {
    const bool isSpecular = (facts.flags & AGAA_FACT_SPECULAR) != 0;
    std::string defines = "#define ENVIRONMENT_MAP_AT " + bindings.map + "\n";
    defines += "#define ENVIRONMENT_LIGHT_AT " + bindings.light + "\n";
    defines += "#define ENVIRONMENT_LEVELS " + std::to_string(radianceLevelCount) + "\n";
    defines += "#define ENVIRONMENT_SPECULAR " + std::to_string(int(isSpecular)) + "\n";
    return defines + (hasClasses ? classDefine : "") + embedded::environment_glsl;
}

} // namespace harness
