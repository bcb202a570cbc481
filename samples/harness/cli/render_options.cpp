#include "cli/render_options.h"

#include "cli/plan_options.h"
#include "scene/motion.h"

namespace harness {

void addDeviceOptions(CLI::App& app, DeviceArguments& a) {
    app.add_option("--backend", a.backend, "vk or gl");
    app.add_flag("--render-pass", a.renderPass, "VkRenderPass instead of dynamic rendering");
    app.add_flag("--inline-recording", a.inlineRecording);
    app.add_flag("--no-conditional-rendering", a.noConditionalRendering, "vk: run all batches, needed or not");
    app.add_flag("--no-geometry-shaders", a.noGeometryShaders, "vk: do not enable them");
    app.add_flag("--no-d24", a.noD24, "vk: as on devices without D24_UNORM_S8_UINT");
    app.add_flag("--no-validation", a.noValidation);
    app.add_flag("--compatibility-profile", a.compatibilityProfile, "gl");
    app.add_flag("--clip-z-from-minus-one", a.clipZFromMinusOne, "gl: its default depth convention");
    app.add_flag("--storage-images", a.storageImages, "gl: materials without storage blocks");
    app.add_option("--constants", a.constants, "gl: of the frame, for materials: block, uniforms or texels");
    app.add_flag("--host-outputs", a.hostOutputs, "gl: materials declare their outputs themselves");
    app.add_option("--state-policy", a.statePolicy, "gl: restore, callbacks or none");
    app.add_option("--glsl", a.glslVersion, "gl: version of the materials, 330 to 460");
}

void addRenderOptions(CLI::App& app, RenderArguments& a) {
    addPlanOptions(app, a.plan);
    addShadingOptions(app, a.plan);
    addDeviceOptions(app, a.device);
    app.add_option("--scene", a.scene, "a built-in scene, blades-N, .gltf or .glb");
    app.add_option("--camera", a.camera, "ex,ey,ez,tx,ty,tz,fovDegrees");
    app.add_option("--lights", a.lights, "number of added lights of short range, 0 to 4000")
        ->check(CLI::Range(0u, 4000u));
    app.add_option("--jitter", a.jitter, "x,y in pixels");
    app.add_option("--frames", a.frames)->check(CLI::Range(1u, 100000u));
    app.add_option("--warmup", a.warmup);
    app.add_option("--without", a.without,
                   "specular, emissive, ambient, shadows, shading-normals or local-lights; repeatable");
    app.add_flag("--plain-facts", a.plainFacts, "as if materials and lights of the scene had nothing in common");
    app.add_option("--draw-order-seed", a.drawOrderSeed, "shuffle draws");
    app.add_option("--dither-frame", a.ditherFrame, "selects the random numbers of translucent surfaces");
    app.add_option("--png", a.png);
    app.add_option("--exr", a.exr);
    app.add_flag("--no-counters", a.noCounters);
    app.add_flag("--no-timestamps", a.noTimestamps);
}

void addEnvironmentOptions(CLI::App& app, RenderArguments& a) {
    app.add_option("--environment", a.environment,
                   "light by a .hdr or .exr image of longitude and latitude, in place of the ambient light");
    app.add_option("--clear-coat", a.clearCoat,
                   "materials of the scene that get a clear coat, as those with KHR_materials_clearcoat have")
        ->delimiter(',');
}

void addMotionOption(CLI::App& app, std::string& motion) {
    std::string text = "what moves";
    for (const MotionName& each : motionNames())
        text += "; " + std::string(each.name) + ": " + std::string(each.shows);
    app.add_option("--motion", motion, text);
}

void addRenderCommandOptions(CLI::App& app, RenderArguments& a) {
    addRenderOptions(app, a);
    addEnvironmentOptions(app, a);
    app.add_option("--alpha-points", a.alphaPoints,
                   "where cut-outs read alpha in a texel: 1, 4 or, of dcaa, which has 4 at least, 16")
        ->check(CLI::IsMember({1u, 4u, 16u}));
    app.add_option("--shading-function", a.shadingFunction,
                   "GLSL file with agaaShade() or agaaReflect(), which replaces the library's model");
    app.add_option("--shading-level", a.shadingLevel, "event or reflectance: what the file defines");
    app.add_option("--resolve", a.resolved,
                   "values of pixels beside the image: nearest-depth, mean-depth, normal, coverage; --exr FILE.exr "
                   "writes FILE-VALUE.exr, too")
        ->delimiter(',')
        ->expected(1, 4)
        ->check(CLI::IsMember({"nearest-depth", "mean-depth", "normal", "coverage"}));
    app.add_flag("--filtered-shadows", a.filteredShadows,
                 "look shadows up once for each shading event, in maps that are filtered in advance");
    app.add_flag("--layers", a.layers,
                 "draw a transparent pane and particles over the image, by its mean depth and coverage");
    addMotionOption(app, a.motion);
    app.add_flag("--switch-facts", a.switchFacts,
                 "each frame has other facts than the one before, whose variants are prepared");
}

} // namespace harness
