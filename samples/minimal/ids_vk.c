/* The smallest Vulkan host with materials by id: the scene is drawn once, for depth and ids, and the SDK fetches the
 * materials.
 *   ids_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "ids_set_vk.h"

#define GEOMETRY_AT "set = 1, binding = 0"

static const char numberedVertexCode[] = "#define DRAW uint(gl_InstanceIndex)\n" ID_VERTEX_CODE(GEOMETRY_AT);
static const char fetchCode[] = FETCH_CODE(GEOMETRY_AT);

static void createView(Host* host, const Fetch* fetch) {
    AgaaViewDesc desc = describeView();
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = fetchCode;
    function.maxDraws = drawCount;
    function.maxPrimitives = vertexCount / 3; /* upper bound for one draw */
    function.descriptorSetLayout = (uint64_t)fetch->layout;
    desc.pNext = &function;
    CHECK(agaaVkCreateView(host->context, &desc, &host->view));
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    Fetch fetch;
    require(argumentCount == 2, "Usage: ids_vk IMAGE.ppm");
    enabledFeatures.features.geometryShader = VK_TRUE; /* gl_PrimitiveID requires the feature */
    createDevice(&host);
    const float* pixels = createOutput(&host);
    createContext(&host);
    createGeometry(&host, &fetch);
    createSet(&host, &fetch);
    host.vertexSet = fetch.layout; /* the vertex shader reads the geometry, too */
    createView(&host, &fetch);
    createPasses(&host, NULL, numberedVertexCode, idCode);
    renderFrames(&host);
    writeImage(arguments[1], pixels);
    destroyFetch(&host, &fetch);
    destroy(&host);
    return EXIT_SUCCESS;
}
