#include "render/host_renderer.h"

#include "render/host_material.h"
#include "render/layers.h"
#include "render/lights.h"
#include "render/sdk_queries.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <chrono>

namespace harness {

// Combines the facts of the settings and the scene. An effect is set if both have it. Numbers of lights come from the
// scene.
static AgaaSceneFacts completeFacts(const Scene& scene, const RenderSettings& settings) {
    const AgaaSceneFacts found = sceneFacts(scene, settings.lights);
    AgaaSceneFacts facts = settings.facts;
    facts.flags &= found.flags | ~uint64_t(AGAA_FACT_ALL_SHADED);
    if (settings.ambient == glm::vec3(0) || settings.environment)
        facts.flags &= ~uint64_t(AGAA_FACT_AMBIENT);
    if (settings.showsMotionSince)
        facts.flags |= AGAA_FACT_EMISSIVE;
    facts.maxLights = found.maxLights;
    facts.shadowMapCount = found.shadowMapCount;
    return facts;
}

// The layout's attribute for motion vectors, as material.frag names it.
static constexpr const char* motionAttribute = "velocity";

static bool movesInstances(const RenderSettings& settings) { return settings.motion && settings.motion->placement; }

// Returns whether materials write motion vectors.
static bool writesMotion(const RenderSettings& settings) {
    return movesInstances(settings) && settings.config.accumulates();
}

// Returns a layout with the attribute; null stands for "precise".
static AgaaLayout withAttribute(const AgaaLayout* own, const AgaaLayoutAttribute& attribute, const char* shows) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    if (own)
        layout = *own;
    else
        agaaGetBuiltinLayout("precise", &layout);
    if (layout.attributeCount >= AGAA_MAX_LAYOUT_ATTRIBUTES)
        throw std::runtime_error(std::string("The layout has no room for the attribute of ") + shows + ".");
    layout.attributes[layout.attributeCount++] = attribute;
    return layout;
}

static AgaaLayout withMotion(const AgaaLayout* own) {
    AgaaLayoutAttribute velocity = AGAA_LAYOUT_ATTRIBUTE_INIT;
    velocity.semantic = AGAA_SEMANTIC_CUSTOM;
    velocity.channels = 2;
    velocity.sampleBits = 16;
    velocity.name = motionAttribute;
    return withAttribute(own, velocity, "motion vectors");
}

static AgaaLayout withClass(const AgaaLayout* own) {
    AgaaLayoutAttribute materialClass = AGAA_LAYOUT_ATTRIBUTE_INIT;
    materialClass.semantic = AGAA_SEMANTIC_CUSTOM;
    materialClass.channels = 1;
    materialClass.sampleBits = 8;
    materialClass.range = 255;
    materialClass.filter = AGAA_FILTER_CLASS;
    materialClass.name = classAttribute;
    // Layouts with wide channels have room for one more of them, but not for a fifth attachment.
    const AgaaLayout narrow = withAttribute(own, materialClass, "classes of materials");
    for (uint32_t i = 0; i + 1 < narrow.attributeCount; ++i)
        if (narrow.attributes[i].sampleBits == 16)
            materialClass.sampleBits = 16;
    return withAttribute(own, materialClass, "classes of materials");
}

void HostRenderer::load(const Scene& scene) {
    isLoaded_ = false;
    scene_ = scene;
    rest_ = scene.instances;
    placedMotion_ = nullptr;
    ++placement_;
    upload();
    isLoaded_ = true;
}

RenderResult HostRenderer::render(const RenderSettings& settings) {
    if (!isLoaded_)
        throw std::runtime_error("No scene is loaded.");
    const AgaaSceneFacts facts = completeFacts(scene_, settings);
    TechniqueConfig config = settings.config;
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    if (writesMotion(settings)) {
        layout = withMotion(config.layout);
        config.layout = &layout;
        config.temporal.motion = motionAttribute;
    }
    const bool writesClass = settings.environment && hasClasses(scene_);
    AgaaLayout classLayout = AGAA_LAYOUT_INIT;
    if (writesClass) {
        classLayout = withClass(config.layout);
        config.layout = &classLayout;
    }
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = settings.width;
    desc.height = settings.height;
    desc.config = &config;
    desc.facts = &facts;
    desc.flags = viewFlags() | (settings.reversedZ ? AGAA_VIEW_REVERSED_Z : 0) |
                 (settings.background.a == 0 ? AGAA_VIEW_COMPOSITE : 0) |
                 (settings.vertexPulling ? AGAA_VIEW_VERTEX_PULLING : 0);
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    std::string fetchText;
    if (settings.config.fetches()) {
        fetch = *fetchFunction(settings.config.coversByEdges());
        fetch.flags = settings.unfetchedEvery ? AGAA_FETCH_NOT_ALL_DRAWS : 0;
        if (!settings.computesTriangles)
            fetch.maxTriangles = 0;
        if (writesClass) {
            fetchText = std::string(classDefine) + fetch.glsl;
            fetch.glsl = fetchText.c_str();
        }
        desc.pNext = &fetch;
    }
    AgaaShadingFunction shading = AGAA_SHADING_FUNCTION_INIT;
    std::string shadingText = settings.shadingGlsl;
    if (settings.environment) {
        const std::string_view techniqueName = config.technique;
        const EnvironmentBindings bindings = useEnvironment(settings.environment, techniqueName == "msaa");
        shadingText = environmentGlsl(bindings, facts, writesClass);
        shading.descriptorSetLayout = bindings.descriptorSetLayout;
    }
    if (!shadingText.empty()) {
        shading.glsl = shadingText.c_str();
        shading.level = settings.environment ? AGAA_SHADING_EVENT : settings.shadingLevel;
        shading.pNext = desc.pNext;
        desc.pNext = &shading;
    }
    AgaaShadowFunction filtered = AGAA_SHADOW_FUNCTION_INIT;
    std::string filteredText;
    if (settings.filtersShadows && facts.shadowMapCount > 0) {
        const FilteredShadowBindings bindings = useFilteredShadows();
        filteredText = filteredShadowGlsl(bindings);
        filtered.glsl = filteredText.c_str();
        filtered.shadows = filtered.footprints = (1u << facts.shadowMapCount) - 1;
        filtered.descriptorSetLayout = bindings.descriptorSetLayout;
        filtered.pNext = desc.pNext;
        desc.pNext = &filtered;
    }
    AgaaResolvedOutputs resolved = AGAA_RESOLVED_OUTPUTS_INIT;
    if (const std::vector<AgaaResolvedValue> values = resolvedValues(settings); !values.empty()) {
        resolved.count = uint32_t(values.size());
        for (uint32_t i = 0; i < resolved.count; ++i)
            resolved.outputs[i].value = values[i];
        resolved.pNext = desc.pNext;
        desc.pNext = &resolved;
    }
    const AgaaView view = useView(desc);
    RenderResult result;
    result.memory = predictMemory(desc, caps(), log());
    result.plan = summarisePlan(desc, caps(), log());

    FrameInput input{settings};
    input.useMasked = (facts.flags & AGAA_FACT_ALPHA_MASKED) != 0;
    const std::vector<AgaaSceneFacts> switched =
        settings.switchFacts ? switchedFacts(facts) : std::vector<AgaaSceneFacts>();
    if (!switched.empty())
        log().check(agaaPrepareVariants(view, uint32_t(switched.size()), switched.data()), "agaaPrepareVariants");
    for (uint32_t frame = 0; frame < settings.warmup + std::max(settings.frames, 1u); ++frame) {
        input.facts = switched.empty() ? nullptr : &switched[frame % switched.size()];
        input.index = settings.firstFrame + frame;
        const bool isPlaced = frame > 0 && !settings.motion;
        if (!isPlaced)
            placeFrame(input);
        if (!isPlaced || settings.config.accumulates()) {
            moveCamera(input);
            setCamera(input);
        }
        const auto start = std::chrono::steady_clock::now();
        const double milliseconds = renderFrame(input);
        const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - start;
        if (frame < settings.warmup)
            continue;
        result.frameMs.push_back(milliseconds);
        result.recordToFinishMs.push_back(whole.count());
        result.recordMs.push_back(std::chrono::duration<double, std::milli>(recordTime_ - drawTime_).count());
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        log().check(agaaGetFrameStatistics(view, frameIndex_, &statistics), "agaaGetFrameStatistics");
        if (statistics.frameIndex != frameIndex_)
            throw std::runtime_error("The SDK's statistics are not of the frame that has finished.");
        result.statistics.push_back(statistics);
    }
    if (config.flags & AGAA_CONFIG_CHECK_FACTS || config.measurement.debugView == AGAA_DEBUG_VIEW_FACTS) {
        result.facts.emplace(AgaaFactReport AGAA_FACT_REPORT_INIT);
        log().check(agaaGetFactReport(view, frameIndex_, &*result.facts), "agaaGetFactReport");
    }
    result.image = readOutput();
    for (size_t i = 0; i < settings.resolved.size(); ++i)
        result.resolved.push_back(readResolved(i));
    return result;
}

CameraMatrices HostRenderer::cameraAt(const RenderSettings& settings, uint32_t index, const glm::dvec2& jitter) const {
    RenderSettings there = settings;
    there.jitter = jitter;
    if (settings.motion && settings.motion->camera)
        there.camera = settings.motion->camera(index);
    return cameraMatrices(scene_, there, clipY());
}

glm::dmat4 HostRenderer::transformAt(const RenderSettings& settings, uint32_t instance, uint32_t index) const {
    const glm::dmat4& rest = rest_[instance].transform;
    return movesInstances(settings) ? settings.motion->placement(instance, index) * rest : rest;
}

void HostRenderer::placeFrame(FrameInput& input) {
    const RenderSettings& settings = input.settings;
    const std::shared_ptr<const Motion> motion = movesInstances(settings) ? settings.motion : nullptr;
    if (motion != placedMotion_ || (motion && input.index != placedIndex_)) {
        for (uint32_t i = 0; i < rest_.size(); ++i)
            scene_.instances[i].transform = transformAt(settings, i, input.index);
        placedMotion_ = motion;
        placedIndex_ = input.index;
        ++placement_;
    }
    input.placement = placement_;
    input.camera = cameraAt(settings, input.index, settings.jitter);
    std::vector<Light> lights = settings.lights;
    for (uint32_t i = 0; settings.motion && settings.motion->brightness && i < lights.size(); ++i)
        lights[i].color *= settings.motion->brightness(i, input.index);
    input.lights = input.unshadowed = toAgaaLights(lights, settings.worldOffset, input.camera.eye);
    for (AgaaLight& light : input.unshadowed)
        light.shadowMap = AGAA_NO_SHADOW;
    DrawListOptions options;
    options.useMasked = input.useMasked;
    options.alphaPoints = settings.alphaPoints;
    // Some targets are a pixel wider than the image on each side, or shifted by a part of a pixel.
    options.clipMargin = 4.0 / std::min(settings.width, settings.height);
    options.shuffleSeed = settings.drawOrderSeed;
    input.draws = makeDrawList(scene_, settings.worldOffset, input.camera.eye, input.camera.viewProjection, options);
    for (size_t i = 0; settings.unfetchedEvery && i < input.draws.size(); i += settings.unfetchedEvery)
        input.draws[i].isFetched = false;
    describeMotion(input);
    prepare(input);
    if (settings.filtersShadows)
        input.shadows = answeredByFunction(shadows());
}

// Draws that stand still have no motion of their own, except in an image of the motion.
void HostRenderer::describeMotion(FrameInput& input) const {
    const RenderSettings& settings = input.settings;
    const bool shows = settings.showsMotionSince.has_value();
    if (!shows && !writesMotion(settings))
        return;
    const uint32_t before = settings.showsMotionSince.value_or(std::max(input.index, 1u) - 1);
    const CameraMatrices camera = cameraAt(settings, before, glm::dvec2(0));
    for (Draw& draw : input.draws) {
        draw.motionOutput = shows ? MotionOutput::Emission : MotionOutput::Attribute;
        const glm::dmat4 transform = transformAt(settings, draw.instance, before);
        if (glm::determinant(draw.toShading) == 0) // flattened
            continue;
        if (shows || transform != scene_.instances[draw.instance].transform)
            draw.toPreviousClip = camera.viewProjection * toShadingSpace(transform, settings.worldOffset, camera.eye) *
                                  glm::inverse(draw.toShading);
    }
}

void HostRenderer::moveCamera(FrameInput& input) const {
    const RenderSettings& settings = input.settings;
    input.jitter = settings.jitter;
    if (settings.config.accumulates()) {
        float offset[2];
        agaaGetJitter(input.index, settings.jitterPositions, offset);
        input.jitter += glm::dvec2(offset[0], offset[1]);
        input.previousCamera.reset();
        if (input.index > 0) // the first frame forgets what the view rendered before
            input.previousCamera = cameraAt(settings, input.index - 1, glm::dvec2(0));
    }
    input.camera = cameraAt(settings, input.index, input.jitter);
}

AgaaTemporalFrame HostRenderer::describeHistory(const FrameInput& input) const {
    AgaaTemporalFrame history = AGAA_TEMPORAL_FRAME_INIT;
    history.jitter[0] = float(input.jitter.x);
    history.jitter[1] = float(clipY() == ClipY::Down ? input.jitter.y : -input.jitter.y);
    if (!input.previousCamera)
        return history;
    const CameraMatrices& previous = *input.previousCamera;
    history.resets = 0;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), input.camera.eye - previous.eye);
    const glm::mat4 toPreviousView(previous.view * moved);
    const glm::mat4 projection(rasterised(previous.projection));
    std::copy_n(glm::value_ptr(toPreviousView), 16, history.toPreviousView);
    std::copy_n(glm::value_ptr(projection), 16, history.previousProjection);
    return history;
}

AgaaFrame HostRenderer::describeFrame(const FrameInput& input) const {
    AgaaFrame frame = AGAA_FRAME_INIT;
    const glm::mat4 viewMatrix(input.camera.view);
    const glm::mat4 projection(rasterised(input.camera.projection));
    std::copy_n(glm::value_ptr(viewMatrix), 16, frame.view);
    std::copy_n(glm::value_ptr(projection), 16, frame.projection);
    const bool isShadowed = !input.facts || input.facts->shadowMapCount > 0;
    frame.lights = isShadowed ? input.lights.data() : input.unshadowed.data();
    frame.lightCount = uint32_t(input.lights.size());
    frame.shadows = input.shadows.empty() ? shadows().data() : input.shadows.data();
    frame.shadowCount = isShadowed ? uint32_t(shadows().size()) : 0;
    frame.facts = input.facts;
    std::copy_n(glm::value_ptr(input.settings.ambient), 3, frame.ambient);
    std::copy_n(glm::value_ptr(input.settings.background), 4, frame.background);
    frame.exposure = input.settings.exposure;
    frame.ditherFrame = input.settings.ditherFrame;
    frame.draw = onDraw;
    frame.drawUser = const_cast<HostRenderer*>(this);
    return frame;
}

AgaaResult AGAA_CALL HostRenderer::onDraw(void* user, const AgaaDrawTarget* target) {
    auto& renderer = *static_cast<HostRenderer*>(user);
    try {
        const Clock::time_point start = Clock::now();
        renderer.draw(*target, *renderer.input_);
        renderer.drawTime_ += Clock::now() - start;
        return AGAA_OK;
    } catch (const std::exception& error) {
        renderer.drawError_ = error.what();
        return AGAA_ERROR_CALLBACK;
    }
}

} // namespace harness
