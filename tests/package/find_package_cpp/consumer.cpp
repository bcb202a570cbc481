// All public headers in C++, and a call into each.
#include "agaa_gl.hpp"
#include "agaa_vk.hpp"

int main() {
    AgaaVkRequirements vk = AGAA_VK_REQUIREMENTS_INIT;
    AgaaGlRequirements gl = AGAA_GL_REQUIREMENTS_INIT;
    if (agaaGetVersion() != AGAA_HEADER_VERSION)
        return 1;
    if (agaaVkGetRequirements(&vk) != AGAA_OK || vk.requiredFeatureCount == 0)
        return 2;
    if (agaaGlGetRequirements(&gl) != AGAA_OK || gl.majorVersion != 4)
        return 3;
    const auto vkAgain = agaa::vk::getRequirements();
    const auto glAgain = agaa::gl::getRequirements();
    return vkAgain && vkAgain->requiredFeatureCount == vk.requiredFeatureCount && glAgain &&
                   glAgain->majorVersion == gl.majorVersion
               ? 0
               : 4;
}
