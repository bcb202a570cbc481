// Two sample engines, each with a device and a context of its own, on two threads: their images are those of one
// thread.
#include "queries.h"

#include "render/messages.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

using namespace harness;

namespace agaa::test {
namespace {

// Two triangles of each material before a third, with cut-outs.
Scene smallScene() {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].roughness = 0.2f;
    scene.materials[1].metallic = 1;
    scene.materials[2].alphaMode = AlphaMode::Mask;
    scene.materials[2].baseColor.a = 0.6f;
    for (uint32_t i = 0; i < 6; ++i) {
        Mesh mesh;
        mesh.firstIndex = mesh.firstVertex = 3 * i;
        mesh.indexCount = mesh.vertexCount = 3;
        mesh.material = i % 3;
        for (uint32_t corner = 0; corner < 3; ++corner) {
            Vertex vertex;
            vertex.position = {0.4f * float(i) + (corner == 1 ? 1.3f : -1), corner == 2 ? 1.2f : -0.8f,
                               -0.3f * float(i)};
            vertex.normal = {0, 0, 1};
            scene.vertices.push_back(vertex);
            scene.indices.push_back(corner);
        }
        scene.meshes.push_back(mesh);
        scene.instances.push_back({i, glm::dmat4(1)});
    }
    updateBounds(scene);
    return scene;
}

RenderSettings settingsOf(const char* technique, uint32_t samples, uint32_t tier, const Scene& scene) {
    RenderSettings settings;
    settings.config.technique = technique;
    settings.config.samples = samples;
    settings.config.generationTier = tier;
    settings.config.flags = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS;
    settings.width = 20;
    settings.height = 12;
    settings.camera.eye = {0.5, 0, 4};
    settings.camera.target = {0.5, 0, 0};
    settings.lights = defaultLights(scene, settings.camera);
    settings.lights.resize(3);
    settings.frames = 2;
    return settings;
}

// Returns the images of several techniques. AGAA_ALL_TECHNIQUES adds those whose pipelines take long to create.
std::vector<std::vector<float>> imagesOf(const std::string& backend, bool backwards) {
    const Scene scene = smallScene();
    std::vector<RenderSettings> list = {settingsOf("agaa", 4, AGAA_TIER_PER_SAMPLE, scene),
                                        settingsOf("dcaa", 32, AGAA_TIER_MATERIAL_LISTS, scene)};
    if (std::getenv("AGAA_ALL_TECHNIQUES"))
        for (const RenderSettings& settings :
             {settingsOf("agaa", 4, AGAA_TIER_IDS, scene), settingsOf("adaptive", 4, AGAA_TIER_AUTO, scene),
              settingsOf("msaa", 4, AGAA_TIER_AUTO, scene), settingsOf("sbaa", 4, AGAA_TIER_AUTO, scene),
              settingsOf("simple_complex", 4, AGAA_TIER_AUTO, scene)})
            list.push_back(settings);
    RendererOptions options;
    options.shadowMapSize = 64;
    const std::unique_ptr<Renderer> renderer = backend == "vk" ? makeVulkanRenderer(options) : makeGlRenderer(options);
    std::vector<std::vector<float>> images(list.size());
    renderer->load(scene);
    for (size_t i = 0; i < list.size(); ++i) {
        const size_t index = backwards ? list.size() - 1 - i : i;
        images[index] = renderer->render(list[index]).image.rgb;
        for (const ApiMessage& message : renderer->takeMessages())
            ADD_FAILURE() << message.id << ": " << message.text;
    }
    return images;
}

class TwoEngines : public testing::TestWithParam<const char*> {};

// The order of the views differs between the threads.
TEST_P(TwoEngines, RenderTheSameImages) {
    std::vector<std::vector<float>> first, second;
    {
        const ConcurrentQueries queries;
        runTogether([&] { first = imagesOf(GetParam(), false); }, [&] { second = imagesOf(GetParam(), true); });
    }
    EXPECT_EQ(first, second);
    EXPECT_FALSE(first.empty());
    for (const std::vector<float>& image : first)
        EXPECT_NE(image, std::vector<float>(image.size(), image.empty() ? 0 : image[0]));
    for (const ApiMessage& message : takeLeftoverMessages())
        ADD_FAILURE() << message.id << ": " << message.text;
}

INSTANTIATE_TEST_SUITE_P(Backends, TwoEngines, testing::Values("vk", "gl"));

} // namespace
} // namespace agaa::test
