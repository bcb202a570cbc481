/* The smallest Vulkan host: draws a few triangles through the SDK, without a window, and writes an image.
 *   minimal_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "vk.h"

int main(int argumentCount, char** arguments) {
    Host host = {0};
    const AgaaViewDesc view = describeView();
    require(argumentCount == 2, "Usage: minimal_vk IMAGE.ppm");
    createDevice(&host);
    const float* pixels = createOutput(&host);
    createContext(&host);
    CHECK(agaaVkCreateView(host.context, &view, &host.view));
    createPasses(&host, NULL, vertexCode, materialCode);
    renderFrames(&host);
    writeImage(arguments[1], pixels);
    destroy(&host);
    return EXIT_SUCCESS;
}
