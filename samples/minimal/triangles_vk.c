/* The smallest Vulkan host that draws nothing: the SDK's compute passes fetch the triangles and expand them to coverage
 * samples. The device needs no geometry shaders.
 *   triangles_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "ids_set_vk.h"

static const char fetchCode[] = FETCH_CODE("set = 1, binding = 0") TRIANGLES_CODE;

static void createView(Host* host, const Fetch* fetch) {
    AgaaViewDesc desc = describeView();
    AgaaConfig config = *desc.config;
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    config.technique = "dcaa";
    config.samples = 64;
    function.glsl = fetchCode;
    function.maxDraws = drawCount;
    function.maxPrimitives = vertexCount / 3; /* upper bound for one draw */
    function.maxTriangles = vertexCount / 3;  /* upper bound for all draws together */
    function.descriptorSetLayout = (uint64_t)fetch->layout;
    desc.config = &config;
    desc.pNext = &function;
    CHECK(agaaVkCreateView(host->context, &desc, &host->view));
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    Fetch fetch;
    require(argumentCount == 2, "Usage: triangles_vk IMAGE.ppm");
    createDevice(&host);
    const float* pixels = createOutput(&host);
    createContext(&host);
    createGeometry(&host, &fetch);
    createSet(&host, &fetch);
    createView(&host, &fetch);
    renderFrames(&host); /* passCount is 0: there is no draw callback */
    writeImage(arguments[1], pixels);
    destroyFetch(&host, &fetch);
    destroy(&host);
    return EXIT_SUCCESS;
}
