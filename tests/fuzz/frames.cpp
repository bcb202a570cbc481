// Renders whole frames of random scenes with random settings through the sample engine, valid or not:
//   agaa-fuzz-frames vk|gl CASES|SECONDSs [SEED [FIRST]]
// A case is a view and up to 120 frames of it, because views take longer than frames. Pixels must be finite and at most
// 65504, the validation layers silent. A refused case must have one sentence and leave the renderer as it was: it then
// renders a plain frame bit for bit.
#include "choices.h"
#include "gl_host_text.h"

#include "render/messages.h"
#include "render/renderer.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>

using namespace harness;

namespace {

uint64_t seed = 1, run = 0, frames = 0, refusals = 0, findings = 0;
std::map<std::string, uint64_t> reasons; // of refusals

void report(const std::string& text) {
    if (++findings <= 20)
        std::printf("frames: seed %llu, case %llu: %s\n", static_cast<unsigned long long>(seed),
                    static_cast<unsigned long long>(run), text.c_str());
}

float unit(fuzz::Choices& choices) { return float(choices.below(1 << 20)) / (1 << 20); }
float within(fuzz::Choices& choices, float low, float high) { return low + (high - low) * unit(choices); }
glm::vec3 point(fuzz::Choices& choices, float size) {
    return {within(choices, -size, size), within(choices, -size, size), within(choices, -size, size)};
}

// Returns a value in [0, 1], or one that materials must not have.
float anyChannel(fuzz::Choices& choices) {
    static const float odd[] = {0,
                                1,
                                -1,
                                2,
                                65504,
                                1e30f,
                                std::numeric_limits<float>::quiet_NaN(),
                                1e-8f,
                                1e-40f,
                                -1e30f,
                                0.00001f,
                                std::numeric_limits<float>::infinity()};
    return choices.oneIn(8) ? choices.of(odd) : unit(choices);
}

Material anyMaterial(fuzz::Choices& choices, size_t textures) {
    Material material;
    for (int i = 0; i < 4; ++i)
        material.baseColor[i] = anyChannel(choices);
    material.metallic = anyChannel(choices);
    material.roughness = anyChannel(choices);
    if (choices.oneIn(3))
        for (int i = 0; i < 3; ++i)
            material.emissive[i] = anyChannel(choices) * (choices.oneIn(3) ? 100.0f : 1.0f);
    material.alphaMode = AlphaMode(choices.below(3));
    material.alphaCutoff = anyChannel(choices);
    material.doubleSided = choices.oneIn(2);
    for (int* texture :
         {&material.baseColorTexture, &material.normalTexture, &material.metalRoughTexture, &material.emissiveTexture})
        *texture = textures > 0 && choices.oneIn(3) ? int(choices.below(textures)) : -1;
    return material;
}

Texture anyTexture(fuzz::Choices& choices) {
    Texture texture;
    texture.width = uint32_t(1 + choices.below(5));
    texture.height = uint32_t(1 + choices.below(5));
    texture.wrapU = Wrap(choices.below(3));
    texture.wrapV = Wrap(choices.below(3));
    texture.srgb = choices.oneIn(2);
    texture.filters.minify = Filter(choices.below(2));
    texture.filters.mips = MipFilter(choices.below(3));
    for (uint32_t i = 0; i < 4 * texture.width * texture.height; ++i)
        texture.rgba.push_back(uint8_t(choices.below(256)));
    return texture;
}

// Triangles of all sizes: long, without area, coplanar, around the eye, few or none.
Scene anyScene(fuzz::Choices& choices) {
    Scene scene;
    for (uint64_t i = choices.below(3); i > 0; --i)
        scene.textures.push_back(anyTexture(choices));
    for (uint64_t i = 1 + choices.below(4); i > 0; --i)
        scene.materials.push_back(anyMaterial(choices, scene.textures.size()));
    for (uint64_t meshes = choices.oneIn(20) ? 0 : 1 + choices.below(6); meshes > 0; --meshes) {
        Mesh mesh;
        mesh.firstIndex = uint32_t(scene.indices.size());
        mesh.firstVertex = uint32_t(scene.vertices.size());
        mesh.material = uint32_t(choices.below(scene.materials.size()));
        const uint32_t triangles = uint32_t(1 + choices.below(choices.oneIn(10) ? 400 : 20));
        for (uint32_t i = 0; i < triangles; ++i) {
            const glm::vec3 centre = point(choices, 3);
            static const float sizes[] = {1e-6f, 0.01f, 0.1f, 1, 10, 1000};
            const float size = choices.of(sizes);
            const bool isFlat = choices.oneIn(10), isCopy = i > 0 && choices.oneIn(10);
            for (uint32_t corner = 0; corner < 3; ++corner) {
                Vertex vertex;
                vertex.position = centre + (isFlat && corner == 2 ? glm::vec3(0) : point(choices, size));
                if (isCopy)
                    vertex.position = scene.vertices[scene.vertices.size() - 3].position;
                vertex.normal = point(choices, 1);
                vertex.normal = choices.oneIn(50) ? glm::vec3(0) : glm::normalize(vertex.normal + 1e-6f);
                vertex.tangent =
                    choices.oneIn(50) ? glm::vec4(0) : glm::vec4(glm::normalize(point(choices, 1) + 1e-6f), 1);
                vertex.uv =
                    glm::vec2(within(choices, -4, 4), within(choices, -4, 4)) * (choices.oneIn(50) ? 1e6f : 1.0f);
                scene.vertices.push_back(vertex);
                scene.indices.push_back(3 * i + corner);
            }
        }
        mesh.indexCount = mesh.vertexCount = 3 * triangles;
        scene.meshes.push_back(mesh);
        for (uint64_t i = 1 + choices.below(2); i > 0; --i) {
            Instance instance;
            instance.mesh = uint32_t(scene.meshes.size() - 1);
            instance.transform[3] = glm::dvec4(point(choices, 2), 1);
            scene.instances.push_back(instance);
        }
    }
    updateBounds(scene);
    return scene;
}

Camera anyCamera(fuzz::Choices& choices) {
    Camera camera;
    camera.eye = point(choices, 6);
    camera.target = choices.oneIn(200) ? camera.eye : glm::dvec3(point(choices, 2));
    if (choices.oneIn(10))
        camera.up = camera.target - camera.eye;
    camera.fovDegrees = choices.oneIn(10) ? 179 : within(choices, 1, 120);
    if (choices.oneIn(6))
        camera.height = choices.oneIn(5) ? 1e6 : within(choices, 0.01f, 20);
    return camera;
}

std::vector<Light> anyLights(fuzz::Choices& choices, uint64_t count) {
    std::vector<Light> lights;
    for (uint64_t i = 0; i < count; ++i) {
        Light light;
        light.type = LightType(choices.below(3));
        light.position = point(choices, 5);
        light.direction = glm::normalize(point(choices, 1) + 1e-3f);
        static const float strengths[] = {0, 1e-6f, 1, 1, 1, 100, 65504, 1e30f};
        light.color = glm::vec3(unit(choices), unit(choices), unit(choices)) * choices.of(strengths);
        light.range = choices.oneIn(3) ? 0 : within(choices, 0.01f, 20);
        light.radius = choices.oneIn(4) ? 0 : within(choices, 0, 0.5f);
        light.outerCone = within(choices, 0, 1.57f);
        light.innerCone = choices.oneIn(3) ? light.outerCone : light.outerCone * unit(choices);
        light.castsShadow = i == 0;
        lights.push_back(light);
    }
    return lights;
}

uint32_t anyTier(fuzz::Choices& choices, std::string_view technique) {
    if (choices.oneIn(8))
        return uint32_t(16 + choices.below(11));
    if (technique == "dcaa" || technique == "sgbc")
        return uint32_t(choices.oneIn(2) ? AGAA_TIER_FRAGMENT_LISTS : AGAA_TIER_MATERIAL_LISTS);
    if (technique != "agaa" && technique != "sbaa" && technique != "adaptive")
        return AGAA_TIER_AUTO;
    static const uint32_t tiers[] = {AGAA_TIER_AUTO, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS};
    return choices.of(tiers);
}

RenderSettings anySettings(fuzz::Choices& choices) {
    RenderSettings settings;
    static const char* const techniques[] = {"single", "fxaa",     "msaa", "ssaa", "simple_complex", "sbaa", "agaa",
                                             "smaa",   "adaptive", "dcaa", "sgbc", "visibility",     "taa"};
    static const uint32_t counts[] = {1, 2, 4, 4, 8, 8, 16, 32}, coverageCounts[] = {32, 64, 128};
    TechniqueConfig& config = settings.config;
    config.technique = choices.of(techniques);
    const std::string_view technique = config.technique;
    config.generationTier = anyTier(choices, technique);
    const bool countsCoverage = technique == "dcaa" || technique == "sgbc" || (technique == "agaa" && choices.oneIn(6));
    config.samples = countsCoverage ? choices.of(coverageCounts) : choices.of(counts);
    if (countsCoverage && technique == "agaa")
        config.generationTier = AGAA_TIER_FRAGMENTS;
    config.aggregates = uint32_t(1 + choices.below(technique == "agaa" ? 4 : 6));
    config.flags = AGAA_CONFIG_COUNTERS;
    if (choices.oneIn(3))
        config.flags |= choices.below(128);
    config.ndf = choices.oneIn(2) ? uint32_t(AGAA_NDF_TOKSVIG) : uint32_t(choices.below(4));
    config.brdf = uint32_t(choices.below(2));
    if (choices.oneIn(4)) {
        config.surfaceCosine = unit(choices);
        config.surfaceDistance = choices.oneIn(4) ? 1e6f : 3 * unit(choices);
        config.surfaceMaterial = unit(choices);
    }
    if (choices.oneIn(4)) {
        config.aggregation.characteristicLength = choices.oneIn(4) ? 1e-30f : 2 * unit(choices);
        config.aggregation.aggregateThreshold = unit(choices);
        config.aggregation.litShadows = uint32_t(choices.below(2));
        config.aggregation.glossWeight = choices.oneIn(2) ? 16 * unit(choices) : 0;
    }
    if (choices.oneIn(3)) {
        config.coverage.merge = uint32_t(choices.below(4));
        config.coverage.maxBatches = uint32_t(1 + choices.below(4));
        config.coverage.fragmentsPerPixel = 1 + 20 * unit(choices);
        config.coverage.flags = choices.below(16); // AGAA_COVERAGE_…
    }
    if (choices.oneIn(3)) {
        config.adaptive.flags = choices.below(0x1000);
        config.adaptive.glossWeight = 16 * unit(choices);
        config.adaptive.countMemory = choices.oneIn(3) ? 0.9f * unit(choices) : 0;
    }
    if (choices.oneIn(10))
        config.measurement.debugView = uint32_t(choices.below(9));
    if (choices.oneIn(6))
        config.measurement.flags = choices.below(64);
    static const std::pair<uint32_t, uint32_t> sizes[] = {{1, 1},   {1, 300}, {300, 1},  {7, 9},   {8, 8},     {64, 3},
                                                          {33, 17}, {64, 48}, {1, 8191}, {513, 3}, {16385, 1}, {0, 5}};
    if (choices.oneIn(4)) {
        std::tie(settings.width, settings.height) = choices.of(sizes);
    } else {
        settings.width = uint32_t(1 + choices.below(48));
        settings.height = uint32_t(1 + choices.below(48));
    }
    settings.reversedZ = !choices.oneIn(3);
    settings.vertexPulling = choices.oneIn(4);
    settings.switchFacts = choices.oneIn(12);
    settings.splitSegments = choices.oneIn(3);
    settings.unfetchedEvery = config.generationTier == AGAA_TIER_IDS && choices.oneIn(3) ? 2 : 0;
    settings.background.a = choices.oneIn(5) ? 0 : unit(choices);
    if (choices.oneIn(5))
        settings.ambient = glm::vec3(0);
    return settings;
}

// Changes what differs between the frames of one view.
void changeFrame(fuzz::Choices& choices, RenderSettings& settings, uint64_t lights) {
    settings.camera = anyCamera(choices);
    settings.lights = anyLights(choices, lights);
    settings.drawOrderSeed = uint32_t(choices.below(4));
    settings.ditherFrame = uint32_t(choices.bits(4));
    settings.jitter = glm::dvec2(unit(choices), unit(choices)) - 0.5;
    settings.worldOffset = choices.oneIn(6) ? glm::dvec3(1e6, -1e6, 1e6) : glm::dvec3(0);
    static const uint32_t points[] = {1, 4, 16};
    settings.alphaPoints = choices.of(points);
    settings.frames = 1; // the image of the last frame is checked
}

void checkImage(const Image& image, const RenderSettings& settings) {
    if (image.width != settings.width || image.height != settings.height)
        return report("the image has another size");
    for (const float value : image.rgb)
        if (!(std::abs(value) <= 65504)) // NaN is not
            return report("a pixel is " + std::to_string(value) + ", technique " + settings.config.technique);
}

void takeMessages(Renderer& renderer) {
    for (const ApiMessage& message : renderer.takeMessages())
        report("message " + message.id + ": " + message.text);
}

class Engine {
public:
    Engine(const std::string& backend, fuzz::Choices& choices) {
        RendererOptions options;
        options.renderPass = choices.oneIn(4);
        options.inlineRecording = choices.oneIn(4);
        options.noConditionalRendering = choices.oneIn(4);
        options.shadowMapSize = 64;
        options.keptViews = 3; // that of the plain frame, too
        options.clipZFromMinusOne = choices.oneIn(4);
        options.compatibilityProfile = choices.oneIn(4);
        renderer_ = backend == "vk" ? makeVulkanRenderer(options) : makeGlRenderer(options);
        fuzz::Choices fixed(7, 7);
        plainScene_ = anyScene(fixed);
        plain_.config.technique = "single";
        plain_.config.samples = 1;
        plain_.width = plain_.height = 16;
        plain_.camera.eye = {0, 0, 8};
        expected_ = renderPlain();
    }
    Renderer& get() { return *renderer_; }
    void checkPlain() {
        if (renderPlain() != expected_)
            report("a plain frame differs after a refusal");
    }

private:
    std::vector<float> renderPlain() {
        renderer_->load(plainScene_);
        return renderer_->render(plain_).image.rgb;
    }

    std::unique_ptr<Renderer> renderer_;
    Scene plainScene_;
    RenderSettings plain_;
    std::vector<float> expected_;
};

// The sentence of the library names the function; the engine has few sentences of its own. After the first image of a
// view, only frames may be refused.
void checkRefusal(const std::string& text, bool hasRendered) {
    ++refusals;
    ++reasons[text.substr(0, 60)];
    const bool isOfFrame = text.starts_with("agaaVkRecordFrame:") || text.starts_with("agaaGlRecordFrame:") ||
                           text.starts_with("The camera's eye");
    const bool isOfView = text.starts_with("agaa") || text.find("larger than") != std::string::npos ||
                          text.find("needs") != std::string::npos;
    const bool isKnown = isOfFrame || (isOfView && !hasRendered);
    if (!isKnown || !text.ends_with('.') || text.find('\n') != std::string::npos ||
        text.find("internal") != std::string::npos || text.starts_with("agaaGetFrameStatistics"))
        report("refused with: " + text);
}

void runCase(Engine& engine, fuzz::Choices& choices) {
    RenderSettings settings = anySettings(choices);
    const uint64_t lights = choices.below(choices.oneIn(4) ? 40 : 5);
    bool hasRendered = false;
    try {
        for (int scenes = 0; scenes < 3; ++scenes) {
            engine.get().load(anyScene(choices));
            for (int repeats = 0; repeats < 40; ++repeats) {
                changeFrame(choices, settings, lights);
                checkImage(engine.get().render(settings).image, settings);
                frames += settings.frames;
                hasRendered = true;
            }
        }
    } catch (const std::runtime_error& error) {
        checkRefusal(error.what(), hasRendered);
        engine.checkPlain();
    }
    takeMessages(engine.get());
}

} // namespace

int main(int count, char** arguments) {
    const std::string backend = count > 1 ? arguments[1] : "", length = count > 2 ? arguments[2] : "";
    const uint64_t number = std::strtoull(length.c_str(), nullptr, 10);
    if ((backend != "vk" && backend != "gl") || number == 0 || count > 5) {
        std::fprintf(stderr, "usage: agaa-fuzz-frames vk|gl CASES|SECONDSs [SEED [FIRST]]\n");
        return 2;
    }
    seed = count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1;
    const uint64_t first = count > 4 ? std::strtoull(arguments[4], nullptr, 10) : 0;
    const bool isTimed = length.ends_with('s');
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(isTimed ? number : 0);
    if (backend == "gl")
        fuzz::checkGlHostText(report);
    std::unique_ptr<Engine> engine;
    for (run = first; isTimed ? std::chrono::steady_clock::now() < end : run < first + number; ++run) {
        try {
            constexpr uint64_t casesPerDevice = 50;
            if (fuzz::Choices device(seed, UINT64_MAX - run / casesPerDevice); !engine || run % casesPerDevice == 0) {
                engine.reset();
                engine = std::make_unique<Engine>(backend, device);
            }
            fuzz::Choices choices(seed, run);
            runCase(*engine, choices);
        } catch (const std::exception& error) {
            report(std::string("an exception left the engine: ") + error.what());
            engine.reset();
        }
        std::fflush(stdout);
    }
    engine.reset();
    for (const ApiMessage& message : takeLeftoverMessages())
        report("message " + message.id + ": " + message.text);
    std::printf("frames: %s, seed %llu, cases %llu, frames %llu, refused cases %llu, findings %llu\n", backend.c_str(),
                static_cast<unsigned long long>(seed), static_cast<unsigned long long>(run - first),
                static_cast<unsigned long long>(frames), static_cast<unsigned long long>(refusals),
                static_cast<unsigned long long>(findings));
    if (std::getenv("AGAA_FUZZ_REASONS"))
        for (const auto& [reason, times] : reasons)
            std::printf("%6llu %s\n", static_cast<unsigned long long>(times), reason.c_str());
    return findings != 0;
}
