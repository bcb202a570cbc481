#include "cli/planned_view.h"

namespace harness {

void Sdk::check(AgaaResult result) const {
    if (result < 0)
        throw std::runtime_error(message_.empty() ? agaaResultString(result) : message_);
}

void AGAA_CALL Sdk::keepMessage(void* user, uint32_t, AgaaResult, const char* message) {
    *static_cast<std::string*>(user) = message;
}

std::optional<AgaaDeviceCaps> planningDevice(const Configuration& configuration, const DeviceArguments& device) {
    if (configuration.fitsFragmentCapacity)
        throw BadArgument("--fragments-per-pixel auto draws a frame; it is for render and reference.");
    if (!device.backend.empty())
        return makeRenderer(device)->caps();
    if (configuration.isModel)
        return std::nullopt;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.sampleCounts = 0b101;
    caps.maxImageSize = 16384;
    caps.maxStorageRange = uint64_t(128) << 20;
    caps.subgroupSize = 32;
    caps.flags = AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                 AGAA_DEVICE_DYNAMIC_RENDERING | AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8 |
                 (device.noGeometryShaders ? 0 : AGAA_DEVICE_GEOMETRY_SHADERS);
    return caps;
}

AgaaViewDesc viewOf(const Configuration& configuration, const AgaaSceneFacts& facts, const AgaaFetchFunction& fetch,
                    bool reversedZ, bool clipZFromMinusOne) {
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = configuration.size.width;
    view.height = configuration.size.height;
    view.config = &configuration.config;
    view.facts = &facts;
    view.flags = reversedZ && !configuration.isModel ? AGAA_VIEW_REVERSED_Z : 0;
    view.flags |= configuration.vertexPulling ? AGAA_VIEW_VERTEX_PULLING : 0;
    view.flags |= clipZFromMinusOne ? AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE : 0;
    if (configuration.config.fetches())
        view.pNext = &fetch;
    return view;
}

AgaaFetchFunction anyFetch(bool forAllDraws, bool computesTriangles) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "";
    function.maxDraws = function.maxPrimitives = 1u << 15;
    function.maxTriangles = computesTriangles ? 1u << 20 : 0;
    function.flags = forAllDraws ? 0 : AGAA_FETCH_NOT_ALL_DRAWS;
    return function;
}

AgaaSceneFacts plannedFacts(const RenderArguments& arguments, bool sceneGiven) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    if (sceneGiven) {
        const Scene scene = loadSceneArgument(arguments.scene);
        facts =
            sceneFacts(scene, remainingLights(arguments, scene.lights.empty() ? defaultLights(scene) : scene.lights));
    }
    changeFacts(arguments, facts);
    return facts;
}

} // namespace harness
