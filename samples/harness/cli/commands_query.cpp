// caps, memory, plan and scenes: queries without rendering.
#include "cli/commands.h"
#include "cli/planned_view.h"

#include "scene/builtin.h"
#include "scene/gltf.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace harness {

using nlohmann::json;

namespace {

json surfaceJson(const AgaaSurface& s) {
    return {{"name", s.name},   {"format", s.format}, {"samples", s.samples}, {"layers", s.layers},
            {"width", s.width}, {"height", s.height}, {"bytes", s.bytes}};
}

// Names of the bits of AgaaDeviceCaps::flags.
json featuresJson(uint64_t flags) {
    json names = json::array();
    for (const auto& [flag, name] : {std::pair{AGAA_DEVICE_POST_DEPTH_COVERAGE, "post-depth-coverage"},
                                     {AGAA_DEVICE_FRAGMENT_ATOMICS, "fragment-atomics"},
                                     {AGAA_DEVICE_SAMPLE_RATE_SHADING, "sample-rate-shading"},
                                     {AGAA_DEVICE_DYNAMIC_RENDERING, "dynamic-rendering"},
                                     {AGAA_DEVICE_STORAGE_FORMATS, "storage-formats"},
                                     {AGAA_DEVICE_NV_MIXED_SAMPLES, "nv-mixed-samples"},
                                     {AGAA_DEVICE_D24S8, "d24s8"},
                                     {AGAA_DEVICE_D32S8, "d32s8"},
                                     {AGAA_DEVICE_NO_ALIASING, "no-aliasing"},
                                     {AGAA_DEVICE_SOFTWARE, "software"},
                                     {AGAA_DEVICE_GEOMETRY_SHADERS, "geometry-shaders"},
                                     {AGAA_DEVICE_CONDITIONAL_RENDERING, "conditional-rendering"},
                                     {AGAA_DEVICE_FRAGMENT_INTERLOCK, "fragment-interlock"},
                                     {AGAA_DEVICE_FRAMEBUFFER_FETCH, "framebuffer-fetch"},
                                     {AGAA_DEVICE_SAMPLE_LOCATIONS, "sample-locations"},
                                     {AGAA_DEVICE_NV_MULTICAST, "nv-multicast"}})
        if (flags & flag)
            names.push_back(name);
    return names;
}

void print(const json& object) { std::cout << object.dump(2) << '\n'; }

} // namespace

void runCaps(const DeviceArguments& arguments, bool asJson) {
    const AgaaDeviceCaps caps = makeRenderer(arguments)->caps();
    uint32_t count = 0;
    agaaQueryCapabilities(&caps, &count, nullptr);
    std::vector<AgaaCapability> rows(count, AgaaCapability AGAA_CAPABILITY_INIT);
    agaaQueryCapabilities(&caps, &count, rows.data());
    json counts = json::array();
    for (uint32_t i = 0; i < 6; ++i)
        if (caps.sampleCounts >> i & 1)
            counts.push_back(1u << i);
    json tiers = json::array();
    for (const AgaaCapability& row : rows)
        tiers.push_back({{"technique", row.technique},
                         {"samples", row.samples},
                         {"stage", agaaStageName(row.stage)},
                         {"tier", row.tier ? agaaTierName(row.tier) : "none"},
                         {"native", row.isNative != 0},
                         {"relativeCost", row.relativeCost},
                         {"reason", row.reason}});
    if (asJson) {
        print({{"backend", arguments.backend},
               {"device", caps.deviceName},
               {"driver", caps.driverName},
               {"sampleCounts", counts},
               {"features", featuresJson(caps.flags)},
               {"tiers", tiers}});
        return;
    }
    std::printf("%s, %s\nsamples per pixel: %s\nfeatures: %s\n", caps.deviceName, caps.driverName,
                counts.dump().c_str(), featuresJson(caps.flags).dump().c_str());
    for (const AgaaCapability& row : rows)
        std::printf("%-7s n=%-2u %-10s %-18s %s\n", row.technique, row.samples, agaaStageName(row.stage),
                    row.tier ? agaaTierName(row.tier) : "none", row.reason);
}

void runMemory(const PlanArguments& arguments, const DeviceArguments& device, bool asJson) {
    const Configuration configuration(arguments);
    const auto caps = planningDevice(configuration, device);
    const AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    const AgaaFetchFunction fetch = anyFetch(arguments.unfetchedEvery == 0, configuration.computesTriangles);
    const AgaaViewDesc view = viewOf(configuration, facts, fetch, arguments.reversedZ, device.clipZFromMinusOne);
    Sdk sdk;
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    uint32_t count = 0;
    const AgaaDeviceCaps* device_ = caps ? &*caps : nullptr;
    sdk.check(agaaQueryMemory(&view, device_, sdk.log(), &report, &count, nullptr));
    std::vector<AgaaSurface> list(count, AgaaSurface AGAA_SURFACE_INIT);
    sdk.check(agaaQueryMemory(&view, device_, sdk.log(), &report, &count, list.data()));
    if (!asJson) {
        for (const AgaaSurface& s : list) {
            char size[32] = "";
            if (s.width)
                std::snprintf(size, sizeof size, "%ux%u x%u", s.width, s.height, s.samples);
            std::printf("%-34s %-18s %16s %12llu bytes%s\n", s.name, s.width ? s.format : "buffer", size,
                        static_cast<unsigned long long>(s.bytes), s.isPerPixel ? "" : " (constant)");
        }
        std::printf("%.3f bytes per pixel, %llu in all, %llu at the peak\n", report.bytesPerPixel,
                    static_cast<unsigned long long>(report.totalBytes),
                    static_cast<unsigned long long>(report.peakBytes));
        return;
    }
    json surfaces = json::array(), constants = json::array();
    for (const AgaaSurface& s : list)
        (s.isPerPixel ? surfaces : constants).push_back(surfaceJson(s));
    print({{"bytesPerPixel", report.bytesPerPixel},
           {"totalBytes", report.totalBytes},
           {"peakBytes", report.peakBytes},
           {"constantBytes", report.constantBytes},
           {"bytesPerAggregate", report.bytesPerAggregate},
           {"surfaces", surfaces},
           {"constants", constants}});
}

void runPlan(const RenderArguments& arguments, bool sceneGiven, bool asJson) {
    const Configuration configuration(arguments.plan);
    const AgaaSceneFacts facts = plannedFacts(arguments, sceneGiven);
    const auto caps = planningDevice(configuration, arguments.device);
    const AgaaFetchFunction fetch = anyFetch(arguments.plan.unfetchedEvery == 0, configuration.computesTriangles);
    const AgaaViewDesc view =
        viewOf(configuration, facts, fetch, arguments.plan.reversedZ, arguments.device.clipZFromMinusOne);
    Sdk sdk;
    size_t size = 0;
    sdk.check(agaaPlanToJson(&view, caps ? &*caps : nullptr, sdk.log(), &size, nullptr));
    std::string text(size, '\0');
    sdk.check(agaaPlanToJson(&view, caps ? &*caps : nullptr, sdk.log(), &size, text.data()));
    text.resize(size - 1);
    const json plan = json::parse(text);
    if (asJson) {
        print(plan);
        return;
    }
    for (const auto& note : plan["notes"])
        std::printf("%s\n", note.get<std::string>().c_str());
    for (const auto& pass : plan["passes"])
        std::printf("%-20s %-10s reads %s writes %s\n", pass["name"].get<std::string>().c_str(),
                    pass["stage"].get<std::string>().c_str(), pass["reads"].dump().c_str(),
                    pass["writes"].dump().c_str());
}

static json scenesJson(const std::vector<BuiltinScene>& rows) {
    json list = json::array();
    for (const BuiltinScene& row : rows) {
        const Scene scene = *makeBuiltinScene(row.name);
        const Camera camera = scene.cameras.empty() ? defaultCamera(scene) : scene.cameras[0];
        list.push_back({{"name", row.name},
                        {"triangles", scene.placedTriangles()},
                        {"materials", scene.materials.size()},
                        {"lights", (scene.lights.empty() ? defaultLights(scene) : scene.lights).size()},
                        {"camera",
                         {camera.eye.x, camera.eye.y, camera.eye.z, camera.target.x, camera.target.y, camera.target.z,
                          camera.fovDegrees}},
                        {"whatItStresses", row.stresses}});
    }
    return list;
}

void runScenes(bool asJson) {
    const json scenes = scenesJson(builtinScenes()), hard = scenesJson(hardScenes());
    if (asJson) {
        print({{"scenes", scenes}, {"hardScenes", hard}});
        return;
    }
    for (const json& list : {scenes, hard})
        for (const auto& scene : list)
            std::printf("%-21s %8llu triangles, %2llu materials, %2llu lights: %s\n",
                        scene["name"].get<std::string>().c_str(), static_cast<unsigned long long>(scene["triangles"]),
                        static_cast<unsigned long long>(scene["materials"]),
                        static_cast<unsigned long long>(scene["lights"]),
                        scene["whatItStresses"].get<std::string>().c_str());
}

std::unique_ptr<Renderer> makeRenderer(const DeviceArguments& arguments) {
    requireBackend(arguments.backend);
    RendererOptions options;
    options.validation = !arguments.noValidation;
    options.keptViews = arguments.keptViews;
    options.renderPass = arguments.renderPass;
    options.noConditionalRendering = arguments.noConditionalRendering;
    options.noGeometryShaders = arguments.noGeometryShaders;
    options.noD24 = arguments.noD24;
    options.inlineRecording = arguments.inlineRecording;
    options.compatibilityProfile = arguments.compatibilityProfile;
    options.clipZFromMinusOne = arguments.clipZFromMinusOne;
    options.storageImages = arguments.storageImages;
    options.constants = parseConstants(arguments.constants);
    options.hostOutputs = arguments.hostOutputs;
    options.glslVersion = arguments.glslVersion;
    options.statePolicy = parseStatePolicy(arguments.statePolicy);
    return arguments.backend == "gl" ? makeGlRenderer(options) : makeVulkanRenderer(options);
}

Scene loadSceneArgument(const std::string& nameOrPath) {
    if (auto scene = makeBuiltinScene(nameOrPath))
        return std::move(*scene);
    if (!isGltfName(nameOrPath))
        throw BadArgument("--scene is \"" + nameOrPath +
                          "\"; it is a name that `scenes` lists, or a .gltf or .glb file.");
    Scene scene = loadGltf(nameOrPath);
    for (const std::string& sentence : scene.dropped)
        std::fprintf(stderr, "warning: %s\n", sentence.c_str());
    return scene;
}

} // namespace harness
