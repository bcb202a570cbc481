#include "render/host_renderer.h"

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
    if (settings.ambient == glm::vec3(0))
        facts.flags &= ~uint64_t(AGAA_FACT_AMBIENT);
    facts.maxLights = found.maxLights;
    facts.shadowMapCount = found.shadowMapCount;
    return facts;
}

void HostRenderer::load(const Scene& scene) {
    isLoaded_ = false;
    scene_ = scene;
    upload();
    isLoaded_ = true;
}

RenderResult HostRenderer::render(const RenderSettings& settings) {
    if (!isLoaded_)
        throw std::runtime_error("No scene is loaded.");
    const AgaaSceneFacts facts = completeFacts(scene_, settings);
    TechniqueConfig config = settings.config;
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = settings.width;
    desc.height = settings.height;
    desc.config = &config;
    desc.facts = &facts;
    desc.flags = viewFlags() | (settings.reversedZ ? AGAA_VIEW_REVERSED_Z : 0) |
                 (settings.background.a == 0 ? AGAA_VIEW_COMPOSITE : 0) |
                 (settings.vertexPulling ? AGAA_VIEW_VERTEX_PULLING : 0);
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    if (settings.config.fetches()) {
        fetch = *fetchFunction(settings.config.coversByEdges());
        fetch.flags = settings.unfetchedEvery ? AGAA_FETCH_NOT_ALL_DRAWS : 0;
        if (!settings.computesTriangles)
            fetch.maxTriangles = 0;
        desc.pNext = &fetch;
    }
    const AgaaView view = useView(desc);
    RenderResult result;
    result.memory = predictMemory(desc, caps(), log());
    result.plan = summarisePlan(desc, caps(), log());

    FrameInput input{settings, cameraMatrices(scene_, settings, clipY())};
    input.lights = input.unshadowed = toAgaaLights(settings.lights, settings.worldOffset, input.camera.eye);
    for (AgaaLight& light : input.unshadowed)
        light.shadowMap = AGAA_NO_SHADOW;
    DrawListOptions options;
    options.useMasked = input.useMasked = (facts.flags & AGAA_FACT_ALPHA_MASKED) != 0;
    options.alphaPoints = settings.alphaPoints;
    // Some targets are a pixel wider than the image on each side, or shifted by a part of a pixel.
    options.clipMargin = 4.0 / std::min(settings.width, settings.height);
    options.shuffleSeed = settings.drawOrderSeed;
    input.draws = makeDrawList(scene_, settings.worldOffset, input.camera.eye, input.camera.viewProjection, options);
    for (size_t i = 0; settings.unfetchedEvery && i < input.draws.size(); i += settings.unfetchedEvery)
        input.draws[i].isFetched = false;
    prepare(input);
    setCamera(input);
    const std::vector<AgaaSceneFacts> switched =
        settings.switchFacts ? switchedFacts(facts) : std::vector<AgaaSceneFacts>();
    if (!switched.empty())
        log().check(agaaPrepareVariants(view, uint32_t(switched.size()), switched.data()), "agaaPrepareVariants");
    for (uint32_t frame = 0; frame < settings.warmup + std::max(settings.frames, 1u); ++frame) {
        input.facts = switched.empty() ? nullptr : &switched[frame % switched.size()];
        if (settings.config.accumulates())
            moveCamera(input, frame), setCamera(input);
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
    return result;
}

// Jitters the camera of a frame, and sets the camera of the frame before.
void HostRenderer::moveCamera(FrameInput& input, uint32_t frame) const {
    RenderSettings settings = input.settings;
    if (frame > 0) { // the first forgets what earlier calls rendered
        RenderSettings before = settings;
        before.jitter = glm::dvec2(0);
        input.previousCamera = cameraMatrices(scene_, before, clipY());
    }
    float offset[2];
    agaaGetJitter(frame, settings.jitterPositions, offset);
    settings.jitter += glm::dvec2(offset[0], offset[1]);
    input.jitter = settings.jitter;
    input.camera = cameraMatrices(scene_, settings, clipY());
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
    frame.shadows = shadows().data();
    frame.shadowCount = isShadowed ? uint32_t(shadows().size()) : 0;
    frame.facts = input.facts;
    std::copy_n(glm::value_ptr(input.settings.ambient), 3, frame.ambient);
    std::copy_n(glm::value_ptr(input.settings.background), 4, frame.background);
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
