// render: frames through the SDK, with times, counters and bytes.
#include "cli/commands.h"
#include "render/fragment_capacity.h"
#include "render/quantiles.h"

#include "image/image.h"
#include "scene/shortened.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace harness {

using nlohmann::json;

void removeEffect(const std::string& effect, AgaaSceneFacts& facts) {
    if (effect == "specular")
        facts.flags &= ~AGAA_FACT_SPECULAR;
    else if (effect == "emissive")
        facts.flags &= ~AGAA_FACT_EMISSIVE;
    else if (effect == "ambient")
        facts.flags &= ~AGAA_FACT_AMBIENT;
    else if (effect == "shadows")
        facts.shadowMapCount = 0;
    else if (effect == "shading-normals")
        facts.flags |= AGAA_FACT_PLANE_NORMALS;
    else if (effect == "local-lights")
        facts.flags |= AGAA_FACT_NO_LOCAL_LIGHTS;
    else
        throw BadArgument("--without names \"" + effect +
                          "\"; it can be specular, emissive, ambient, shadows, shading-normals or local-lights.");
}

std::vector<Light> remainingLights(const RenderArguments& arguments, std::vector<Light> lights) {
    for (const std::string& effect : arguments.without) {
        if (effect == "local-lights")
            std::erase_if(lights, [](const Light& light) { return light.type != LightType::Directional; });
        for (Light& light : lights)
            light.castsShadow = light.castsShadow && effect != "shadows";
    }
    return lights;
}

void changeFacts(const RenderArguments& arguments, AgaaSceneFacts& facts) {
    for (const std::string& effect : arguments.without)
        removeEffect(effect, facts);
    if (arguments.plainFacts)
        facts.flags &= AGAA_FACT_ALL_SHADED | AGAA_FACT_CUSTOM_DEPTH;
}

// Returns the text of the file, or nothing without a file.
std::string readShadingFunction(const std::string& path) {
    if (path.empty())
        return {};
    std::ifstream file(path);
    std::stringstream text;
    if (!file || !(text << file.rdbuf()))
        throw BadArgument("--shading-function: cannot read " + path + ", or it is empty.");
    return text.str();
}

// Returns the filtered light of the arguments, or null.
std::shared_ptr<const Environment> environmentOf(const RenderArguments& arguments) {
    if (arguments.environment.empty())
        return nullptr;
    if (!arguments.shadingFunction.empty())
        throw BadArgument("--environment has a shading function of its own; it excludes --shading-function.");
    return std::make_shared<const Environment>(loadEnvironment(arguments.environment));
}

Scene sceneOf(const RenderArguments& arguments) {
    Scene scene = loadSceneArgument(arguments.scene);
    if (!arguments.clearCoat.empty() && arguments.environment.empty())
        throw BadArgument("--clear-coat needs --environment.");
    for (const std::string& name : arguments.clearCoat) {
        std::string known;
        bool isFound = false;
        for (Material& material : scene.materials) {
            material.hasClearCoat |= material.name == name;
            isFound |= material.name == name;
            known += (known.empty() ? "" : ", ") + shortened(material.name);
        }
        if (!isFound)
            throw BadArgument("--clear-coat names \"" + name + "\"; the scene has the materials " + known + ".");
    }
    return scene;
}

AgaaResolvedValue resolvedValue(const std::string& name) {
    return name == "nearest-depth" ? AGAA_RESOLVED_NEAREST_DEPTH
           : name == "mean-depth"  ? AGAA_RESOLVED_MEAN_DEPTH
           : name == "normal"      ? AGAA_RESOLVED_NORMAL
                                   : AGAA_RESOLVED_COVERAGE;
}

void writeResolved(const RenderArguments& arguments, const std::vector<Image>& images) {
    for (size_t i = 0; i < images.size(); ++i) {
        std::filesystem::path path = arguments.exr;
        path.replace_filename(path.stem().string() + "-" + arguments.resolved[i] + ".exr");
        writeExr(path, images[i]);
    }
}

RenderSettings renderSettings(const RenderArguments& arguments, const Configuration& configuration,
                              const Scene& scene) {
    RenderSettings settings;
    settings.config = configuration.config;
    settings.width = configuration.size.width;
    settings.height = configuration.size.height;
    settings.camera = !arguments.camera.empty() ? parseCamera(arguments.camera)
                      : !scene.cameras.empty()  ? scene.cameras[0]
                                                : defaultCamera(scene);
    settings.lights = scene.lights.empty() ? defaultLights(scene, settings.camera) : scene.lights;
    for (const Light& light : smallLights(scene, settings.camera, arguments.lights))
        settings.lights.push_back(light);
    settings.lights = remainingLights(arguments, std::move(settings.lights));
    settings.facts = sceneFacts(scene, settings.lights);
    changeFacts(arguments, settings.facts);
    settings.reversedZ = arguments.plan.reversedZ;
    settings.vertexPulling = configuration.vertexPulling;
    settings.computesTriangles = configuration.computesTriangles;
    settings.shadingGlsl = readShadingFunction(arguments.shadingFunction);
    settings.shadingLevel = parseShadingLevel(arguments.shadingLevel);
    settings.environment = environmentOf(arguments);
    settings.filtersShadows = arguments.filteredShadows;
    for (const std::string& name : arguments.resolved)
        settings.resolved.push_back(resolvedValue(name));
    settings.hasLayers = arguments.layers;
    settings.drawOrderSeed = arguments.drawOrderSeed;
    settings.alphaPoints = arguments.alphaPoints;
    settings.ditherFrame = arguments.ditherFrame;
    settings.unfetchedEvery = arguments.plan.unfetchedEvery;
    settings.frames = arguments.frames;
    settings.warmup = arguments.warmup;
    settings.switchFacts = arguments.switchFacts;
    const auto jitter = parseNumbers(arguments.jitter, 2, "--jitter");
    settings.jitter = {jitter[0], jitter[1]};
    settings.jitterPositions = arguments.plan.temporal.jitterPositions;
    settings.exposure = float(arguments.plan.exposure);
    return settings;
}

std::shared_ptr<const Motion> sceneMotion(const std::string& name, Scene& scene, const RenderSettings& settings) {
    std::shared_ptr<const Motion> motion = makeMotion(name, scene, settings.camera, settings.height);
    if (motion)
        return motion;
    std::string known;
    for (const MotionName& each : motionNames())
        known += (known.empty() ? "" : ", ") + std::string(each.name);
    throw BadArgument("--motion names \"" + name + "\"; it can be " + known + ".");
}

Image shownImage(Image image, const TechniqueConfig& config) {
    const uint32_t view = config.measurement.debugView;
    if (view == AGAA_DEBUG_VIEW_EVENTS || view == AGAA_DEBUG_VIEW_AGGREGATES || view == AGAA_DEBUG_VIEW_PRIMITIVES)
        for (float& value : image.rgb) // one event is mid-grey, eight are near white
            value *= 0.25f;
    return image;
}

namespace {

json quantilesJson(const std::vector<double>& values) {
    return {{"median", quantile(values, 0.5)}, {"p95", quantile(values, 0.95)}};
}

const char* timeSourceName(uint32_t source) {
    return source == AGAA_TIME_DEVICE ? "device" : source == AGAA_TIME_CPU_FINISH ? "cpu-finish" : "none";
}

json passesJson(const RenderResult& timed) {
    json passes = json::array();
    const AgaaFrameStatistics& first = timed.statistics.front();
    for (uint32_t i = 0; i < first.passCount; ++i) {
        std::vector<double> values;
        for (const AgaaFrameStatistics& frame : timed.statistics)
            values.push_back(frame.passes[i].milliseconds);
        json pass = {{"name", first.passes[i].name}, {"stage", agaaStageName(first.passes[i].stage)}};
        pass["ms"] = first.passes[i].isTimed ? quantilesJson(values) : json();
        passes.push_back(pass);
    }
    return passes;
}

json countersJson(const AgaaCounters& c) {
    return {{"visible", c.visible},
            {"once", c.once},
            {"uncovered", c.uncovered},
            {"overlapping", c.overlapping},
            {"missed", c.uncovered}, // names of earlier versions
            {"multi", c.overlapping},
            {"ties", c.ties},
            {"sanitised", c.sanitised},
            {"shadingEvents", c.shadingEvents},
            {"lightEvaluations", c.lightEvaluations},
            {"joinedClasses", c.joinedClasses},
            {"shadowTaps", c.shadowTaps},
            {"widenedLobes", c.widenedLobes},
            {"shadedPixels", c.shadedPixels},
            {"maxEventsPerPixel", c.maxEventsPerPixel},
            {"pixelsByEvents", c.pixelsByEvents},
            {"aggregates", c.aggregates},
            {"primitives", c.primitives},
            {"materials", c.materials},
            {"misplaced", c.misplaced},
            {"unannounced", c.unannounced},
            {"fragments", c.fragments},
            {"mergedFirst", c.mergedFirst},
            {"mergedSecond", c.mergedSecond},
            {"discarded", c.discarded},
            {"lostSamples", c.lostSamples},
            {"lostFragments", c.lostFragments},
            {"batches", c.batches}};
}

json factsJson(const AgaaFactReport& r) {
    return {{"inspected", r.inspected},           {"withSpecular", r.withSpecular},
            {"withEmission", r.withEmission},     {"alphaMasked", r.alphaMasked},
            {"otherRoughness", r.otherRoughness}, {"coloredSpecular", r.coloredSpecular},
            {"otherSpecular", r.otherSpecular},   {"withDiffuse", r.withDiffuse},
            {"translucent", r.translucent},       {"cutouts", r.cutouts},
            {"otherNormals", r.otherNormals},     {"lightCount", r.lightCount},
            {"localLights", r.localLights},       {"shadowCount", r.shadowCount},
            {"hasAmbient", r.hasAmbient != 0},    {"contradicted", r.contradicted},
            {"sufficient", r.sufficient},         {"explanation", r.explanation}};
}

json environmentJson(const Environment& e) {
    return {{"file", e.file.string()},
            {"size", std::to_string(e.fileWidth) + "x" + std::to_string(e.fileHeight)},
            {"replacedValues", e.replacedValues},
            {"milliseconds", e.milliseconds},
            {"bytes", e.bytes()}};
}

json messagesJson(Renderer& renderer) {
    json messages = json::array();
    for (const ApiMessage& message : renderer.takeMessages())
        messages.push_back({{"severity", message.severity}, {"id", message.id}, {"text", message.text}});
    return messages;
}

// The results of three runs. Frame times come from frames without pass times and counters, pass times from frames
// without counters.
struct Measurement {
    RenderResult plain;
    std::optional<RenderResult> timed;
    std::optional<RenderResult> counted;
};

Measurement measure(Renderer& renderer, RenderSettings settings, const RenderArguments& arguments) {
    Measurement m;
    m.plain = renderer.render(settings);
    if (!arguments.noTimestamps) {
        settings.config.flags |= AGAA_CONFIG_TIMESTAMPS;
        m.timed = renderer.render(settings);
        settings.config.flags &= ~AGAA_CONFIG_TIMESTAMPS;
    }
    if (!arguments.noCounters) {
        settings.config.flags |= AGAA_CONFIG_COUNTERS;
        if (settings.motion) // the frame that the image shows
            settings.firstFrame += settings.warmup + settings.frames - 1;
        settings.frames = 1;
        settings.warmup = 0;
        m.counted = renderer.render(settings);
    }
    return m;
}

json resultJson(const Measurement& m, const RenderArguments& arguments, Renderer& renderer, const Size& size) {
    const AgaaFrameStatistics& last = m.plain.statistics.back();
    json tiers = json::object();
    for (const auto& [stage, tier] : m.plain.plan.tiers)
        tiers[stage] = tier;
    json out = {{"device", renderer.caps().deviceName},
                {"driver", renderer.caps().driverName},
                {"backend", arguments.device.backend},
                {"scene", arguments.scene},
                {"technique", arguments.plan.technique},
                {"samples", m.plain.plan.samples},
                {"aggregates", m.plain.plan.aggregates},
                {"size", std::to_string(size.width) + "x" + std::to_string(size.height)},
                {"frameMs", quantilesJson(m.plain.frameMs)},
                {"recordMs", quantilesJson(m.plain.recordMs)},
                {"geometryPasses", last.geometryPasses},
                {"bytesPerPixel", m.plain.memory.bytesPerPixel},
                {"bytesPerAggregate", m.plain.memory.bytesPerAggregate},
                {"predictedBytes", m.plain.memory.totalBytes},
                {"memoryBytes", last.payloadBytes},
                {"driverBytes", last.driverBytes},
                {"peakBytes", last.peakBytes},
                {"tiers", tiers}};
    out["variants"] = last.variantCount;
    out["compiledPipelines"] = last.compiledPipelines;
    out["compileMilliseconds"] = last.compileMilliseconds;
    if (arguments.switchFacts)
        out["frameMilliseconds"] = m.plain.recordToFinishMs;
    if (m.plain.facts)
        out["facts"] = factsJson(*m.plain.facts);
    out["passes"] = m.timed ? passesJson(*m.timed) : json::array();
    out["timeSource"] = timeSourceName(m.timed ? m.timed->statistics.front().timeSource : 0u);
    if (m.counted) {
        const AgaaCounters& c = m.counted->statistics.back().counters;
        out["shadingEventsPerPixel"] = double(c.shadingEvents) / (double(size.width) * double(size.height));
        out["shadingEventsPerCoveredPixel"] = c.shadedPixels ? double(c.shadingEvents) / double(c.shadedPixels) : 0.0;
        out["maxEventsPerPixel"] = c.maxEventsPerPixel;
        out["counters"] = countersJson(c);
    }
    out["apiMessages"] = messagesJson(renderer);
    return out;
}

} // namespace

void runRender(const RenderArguments& arguments, bool asJson) {
    const Configuration configuration(arguments.plan);
    requireBackend(arguments.device.backend);
    if (!arguments.camera.empty())
        parseCamera(arguments.camera); // fails before the scene is loaded
    Scene scene = sceneOf(arguments);
    RenderSettings settings = renderSettings(arguments, configuration, scene);
    if (arguments.motion != "still")
        settings.motion = sceneMotion(arguments.motion, scene, settings);
    const auto renderer = makeRenderer(arguments.device);
    renderer->load(scene);
    if (configuration.fitsFragmentCapacity)
        fitFragmentCapacity(*renderer, settings);
    const Measurement m = measure(*renderer, settings, arguments);
    if (!arguments.png.empty())
        writePng(arguments.png, shownImage(m.plain.image, settings.config));
    if (!arguments.exr.empty()) {
        writeExr(arguments.exr, m.plain.image);
        writeResolved(arguments, m.plain.resolved);
    }
    json out = resultJson(m, arguments, *renderer, configuration.size);
    if (settings.config.keepsLists())
        out["fragmentsPerPixel"] = settings.config.coverage.fragmentsPerPixel;
    if (settings.environment)
        out["environment"] = environmentJson(*settings.environment);
    if (asJson) {
        std::cout << out.dump(2) << '\n';
        return;
    }
    std::printf("%s on %s\n", arguments.scene.c_str(), renderer->caps().deviceName);
    std::printf("frame %.1f ms (median), %.1f bytes per pixel, %u geometry passes\n",
                out["frameMs"]["median"].get<double>(), m.plain.memory.bytesPerPixel,
                m.plain.statistics.back().geometryPasses);
    if (arguments.switchFacts)
        std::printf("%u variants; recorded and run in %.1f ms (median), %.1f ms at most\n",
                    m.plain.statistics.back().variantCount, quantile(m.plain.recordToFinishMs, 0.5),
                    quantile(m.plain.recordToFinishMs, 1));
    if (settings.environment)
        std::printf("environment of %ux%u pixels filtered in %.0f ms, %.1f MB\n", settings.environment->fileWidth,
                    settings.environment->fileHeight, settings.environment->milliseconds,
                    double(settings.environment->bytes()) / 1e6);
    if (m.plain.facts)
        std::printf("%s\n", m.plain.facts->explanation);
    if (configuration.fitsFragmentCapacity && out.contains("fragmentsPerPixel"))
        std::printf("lists have room for %.2f fragments per pixel\n", out["fragmentsPerPixel"].get<double>());
    for (const json& pass : out["passes"])
        if (!pass["ms"].is_null())
            std::printf("  %-20s %8.2f ms\n", pass["name"].get<std::string>().c_str(),
                        pass["ms"]["median"].get<double>());
    if (out.contains("counters"))
        std::printf("%.3f shading events per pixel, counters %s\n", out["shadingEventsPerPixel"].get<double>(),
                    out["counters"].dump().c_str());
    for (const json& message : out["apiMessages"])
        std::printf("API message: %s\n", message.dump().c_str());
}

} // namespace harness
