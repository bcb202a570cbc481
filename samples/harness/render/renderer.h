// The interface of a backend's sample engine for the command line and the tests: load a scene, render frames through
// the SDK, read back the image and the statistics.
#pragma once

#include "agaa_sdk.h"
#include "environment/environment.h"
#include "render/technique_config.h"
#include "image/image.h"
#include "scene/motion.h"

#include <memory>
#include <string>
#include <optional>
#include <vector>

namespace harness {

struct RendererOptions {
    bool validation = true;              // API validation and synchronisation validation, where installed
    bool renderPass = false;             // Vulkan: VkRenderPass instead of dynamic rendering
    bool inlineRecording = false;        // Vulkan: callbacks record into the host's command buffer
    bool noConditionalRendering = false; // Vulkan: the device runs all batches, needed or not
    bool noGeometryShaders = false;      // Vulkan: do not enable geometry shaders
    bool noD24 = false;                  // Vulkan: hide D24_UNORM_S8_UINT, which some devices lack, from the SDK
    uint32_t shadowMapSize = 2048;
    uint32_t keptViews = 2; // views of the SDK that are kept: measurements alternate between views
    // OpenGL
    bool compatibilityProfile = false;
    bool clipZFromMinusOne = false; // the default of OpenGL, instead of z/w in [0, 1]
    bool storageImages = false;     // material shaders without storage blocks
    uint32_t constants = 0;         // AgaaGlConstants
    bool hostOutputs = false;       // material shaders that declare their outputs themselves
    uint32_t glslVersion = 450;     // GLSL version of material shaders
    uint32_t statePolicy = 0;       // AgaaGlStatePolicy
};

struct RenderSettings {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT; // completed from the scene by the renderer
    uint32_t width = 640;
    uint32_t height = 360;
    Camera camera;
    std::vector<Light> lights;
    glm::vec3 ambient{0.25f};
    glm::vec4 background{0.32f, 0.45f, 0.65f, 1.0f};
    float exposure = 1;    // read with AGAA_CONFIG_HDR_RESOLVE
    bool reversedZ = true; // reversed depth with an infinite far plane
    glm::dvec2 jitter{0};  // offset of the image plane, in pixels
    // Views that accumulate frames: each frame adds a position of agaaGetJitter() to the jitter.
    uint32_t jitterPositions = 16;
    std::shared_ptr<const Motion> motion; // of the loaded scene; null: nothing moves
    // Index of the first frame in the motion and in the positions of the jitter. If it is not 0, that frame follows the
    // last one that the view rendered.
    uint32_t firstFrame = 0;
    std::optional<uint32_t> showsMotionSince; // the image shows the motion since this frame; see motion_image.h
    uint32_t drawOrderSeed = 0;               // != 0: draws are shuffled by this seed
    glm::dvec3 worldOffset{0};                // offset of scene, lights and camera, which tests precision far from 0
    uint32_t frames = 1;
    uint32_t warmup = 0;
    bool switchFacts = false;       // each frame has the next facts of switchedFacts()
    double footprint = 1;           // width over which textures are filtered, in pixels, (0, 1]; not for the tier IDS
    uint32_t alphaPoints = 1;       // alpha reads of cut-outs per texel of the target: 1, 4 or 16
    uint32_t ditherFrame = 0;       // AgaaFrame::ditherFrame
    uint32_t unfetchedEvery = 0;    // tier IDS: every unfetchedEvery-th draw cannot be fetched; 0: none
    bool splitSegments = false;     // record each segment in a separate call
    bool vertexPulling = false;     // AGAA_VIEW_VERTEX_PULLING
    bool computesTriangles = false; // AgaaFetchFunction::maxTriangles
    std::string shadingGlsl;        // AgaaShadingFunction::glsl; empty: the library's model
    AgaaShadingLevel shadingLevel = AGAA_SHADING_EVENT;
    std::vector<AgaaResolvedValue> resolved;        // AgaaResolvedOutputs, at most 4; not CUSTOM
    std::shared_ptr<const Environment> environment; // replaces `ambient` and shadingGlsl; null: none
    bool filtersShadows = false;                    // in advance; see filtered_shadows.h
    bool hasLayers = false;                         // a transparent pane and particles over the image; see layers.h
};

// The result of a configuration in the SDK.
struct PlanSummary {
    uint32_t samples = 0;
    uint32_t aggregates = 0; // aggregates, or surfaces of "sbaa"; 0 if the technique has none
    std::vector<std::pair<std::string, std::string>> tiers; // stage, tier
};

struct RenderResult {
    Image image;                          // image of the last frame, linear
    std::vector<Image> resolved;          // of the last frame, by RenderSettings::resolved
    std::vector<double> frameMs;          // time from submission to completion per counted frame, without warm-up
    std::vector<double> recordToFinishMs; // time from the beginning of recording to completion
    std::vector<double> recordMs;         // time in the SDK's recording calls, without the draw callbacks
    std::vector<AgaaFrameStatistics> statistics;       // per counted frame
    std::optional<AgaaFactReport> facts;               // report of the last frame, with AGAA_CONFIG_CHECK_FACTS
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT; // predicted for this device
    PlanSummary plan;
};

// One line per message of the API's validation that the allow-list does not excuse.
struct ApiMessage {
    std::string severity;
    std::string id;
    std::string text;
};

class Renderer {
public:
    virtual ~Renderer() = default;
    virtual const AgaaDeviceCaps& caps() const = 0;
    // Replaces the scene on the device. Throws std::runtime_error.
    virtual void load(const Scene& scene) = 0;
    // Throws std::runtime_error with the SDK's sentence if the SDK reports an error.
    virtual RenderResult render(const RenderSettings& settings) = 0;
    // Returns the messages since the last call.
    virtual std::vector<ApiMessage> takeMessages() = 0;
};

std::unique_ptr<Renderer> makeVulkanRenderer(const RendererOptions& options);
std::unique_ptr<Renderer> makeGlRenderer(const RendererOptions& options);

// Returns the facts of a scene and its lights for the SDK.
AgaaSceneFacts sceneFacts(const Scene& scene, const std::vector<Light>& lights);
// Returns the facts between which frames alternate: the facts of the view, then each effect left out, then all of them.
std::vector<AgaaSceneFacts> switchedFacts(const AgaaSceneFacts& view);

} // namespace harness
