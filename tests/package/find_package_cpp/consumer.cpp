// All public headers in C++, and a call into each.
#include "agaa_gl.h"
#include "agaa_vk.h"

int main() {
    AgaaVkRequirements vk = AGAA_VK_REQUIREMENTS_INIT;
    AgaaGlRequirements gl = AGAA_GL_REQUIREMENTS_INIT;
    if (agaaGetVersion() != AGAA_HEADER_VERSION)
        return 1;
    if (agaaVkGetRequirements(&vk) != AGAA_OK || vk.requiredFeatureCount == 0)
        return 2;
    return agaaGlGetRequirements(&gl) == AGAA_OK && gl.majorVersion == 4 ? 0 : 3;
}
