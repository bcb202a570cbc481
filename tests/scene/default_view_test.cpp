// Bounds, and the camera and lights of scenes that bring none.
#include "render/camera_matrices.h"
#include "scene_support.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace harness;
using namespace scene_test;

namespace {

// Two triangles between two corners.
Scene sheet(const glm::vec3& low, const glm::vec3& high) {
    Scene scene;
    scene.vertices.resize(4);
    scene.vertices[0].position = low;
    scene.vertices[1].position = {high.x, low.y, low.z};
    scene.vertices[2].position = high;
    scene.vertices[3].position = {low.x, high.y, high.z};
    scene.indices = {0, 1, 2, 0, 2, 3};
    Mesh mesh;
    mesh.indexCount = 6;
    mesh.vertexCount = 4;
    scene.meshes.push_back(mesh);
    scene.materials.emplace_back();
    scene.instances.push_back({0, glm::dmat4(1)});
    updateBounds(scene);
    return scene;
}

void expectUsableRig(const Scene& scene, const std::vector<Light>& lights, double reach) {
    ASSERT_EQ(lights.size(), 17u);
    EXPECT_EQ(lights[0].type, LightType::Directional);
    EXPECT_TRUE(lights[0].castsShadow);
    EXPECT_NEAR(glm::length(lights[0].direction), 1, 1e-6);
    for (size_t i = 1; i < lights.size(); ++i) {
        const Light& light = lights[i];
        EXPECT_EQ(light.type, LightType::Point);
        EXPECT_FALSE(light.castsShadow);
        EXPECT_TRUE(inside(scene, light.position));
        EXPECT_GE(light.range, 0.249 * reach);
        EXPECT_LE(light.range, 0.401 * reach);
        // Irradiance at half the range with the window of the falloff, mean over the channels.
        const float mean = (light.color.r + light.color.g + light.color.b) / 3;
        const float irradiance = mean * (15.0f / 16) * (15.0f / 16) * 4 / (light.range * light.range);
        EXPECT_GT(irradiance, 0.3f);
        EXPECT_LT(irradiance, 0.6f);
    }
}

} // namespace

TEST(Bounds, CoverRotatedAndMirroredInstances) {
    Scene scene = sheet({0, 0, 0}, {1, 2, 0});
    scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(1e6, 0, 0))});
    scene.instances.push_back({0, glm::scale(glm::dmat4(1), glm::dvec3(-3, 1, 1))});
    scene.instances.push_back({0, glm::rotate(glm::dmat4(1), 1.5707963267948966, glm::dvec3(1, 0, 0))});
    updateBounds(scene);
    EXPECT_EQ(scene.meshes[0].boundsMax, glm::vec3(1, 2, 0));
    EXPECT_DOUBLE_EQ(scene.boundsMin.x, -3);
    EXPECT_DOUBLE_EQ(scene.boundsMax.x, 1e6 + 1);
    EXPECT_DOUBLE_EQ(scene.boundsMax.z, 2);
    EXPECT_EQ(scene.placedTriangles(), 8u);
}

// A stray vertex or instance is drawn, but it sets neither the view nor the shadows.
TEST(Bounds, LeaveOutStrayVerticesAndInstances) {
    const Scene sane = sheet({-3, 0, -3}, {3, 2, 3});
    Scene vertex = sane, instance = sane;
    vertex.vertices.push_back({});
    vertex.vertices.back().position = {1e12f, -1e12f, 1e12f};
    ++vertex.meshes[0].vertexCount;
    updateBounds(vertex);
    for (const glm::dvec3& offset : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1e12, 0, 0)})
        instance.instances.push_back({0, glm::translate(glm::dmat4(1), offset)});
    updateBounds(instance);
    EXPECT_EQ(vertex.boundsMin, sane.boundsMin);
    EXPECT_EQ(vertex.boundsMax, sane.boundsMax);
    EXPECT_EQ(vertex.meshes[0].boundsMax.x, 1e12f) << "culling needs all vertices";
    EXPECT_EQ(instance.boundsMax, glm::dvec3(4, 3, 3));
    RenderSettings settings;
    settings.camera = defaultCamera(vertex);
    EXPECT_LT(cameraMatrices(vertex, settings, ClipY::Down).farPlane, 100);
}

TEST(Bounds, OfAnEmptySceneAreZero) {
    Scene scene;
    updateBounds(scene);
    EXPECT_EQ(scene.boundsMin, glm::dvec3(0));
    EXPECT_EQ(scene.boundsMax, glm::dvec3(0));
    EXPECT_EQ(scene.placedTriangles(), 0u);
}

TEST(DefaultCamera, FramesFlatHugeAndTinyScenes) {
    for (const Scene& scene :
         {sheet({-1, 0, -1}, {1, 0, 1}), sheet({0, 0, 0}, {0, 7, 0}), sheet({5, 5, 5}, {6, 7, 8}),
          sheet({-1e6f, -10, -1e6f}, {1e6f, 10, 1e6f}), sheet({1e-5f, 0, 0}, {2e-5f, 1e-5f, 1e-5f})}) {
        const Camera camera = defaultCamera(scene);
        EXPECT_EQ(shareInView(scene, camera), 1.0);
        EXPECT_GT(camera.eye.y, camera.target.y);
        EXPECT_DOUBLE_EQ(camera.fovDegrees, 50);
        // Neither lost in the distance.
        const double distance = glm::length(camera.eye - camera.target);
        EXPECT_LT(distance, 1.5 * glm::length(scene.boundsMax - scene.boundsMin));
    }
}

TEST(DefaultCamera, StandsSomewhereInAnEmptyScene) {
    Scene scene;
    const Camera camera = defaultCamera(scene);
    EXPECT_GT(glm::length(camera.eye - camera.target), 0.1);
    EXPECT_TRUE(std::isfinite(camera.eye.x));
}

TEST(DefaultLights, FillTheSceneTheCameraFrames) {
    const Scene scene = sheet({-3, 0, -3}, {3, 2, 3});
    expectUsableRig(scene, defaultLights(scene), glm::length(glm::dvec3(6, 2, 6)));
}

TEST(DefaultLights, GatherAroundTheViewOfAVastScene) {
    const Scene scene = sheet({-1000, -5, -1000}, {1000, 400, 1000});
    Camera camera;
    camera.eye = {100, 8, 100};
    camera.target = {100, 6, 80};
    const std::vector<Light> lights = defaultLights(scene, camera);
    const double reach = 1.5 * glm::length(camera.target - camera.eye);
    expectUsableRig(scene, lights, reach);
    for (size_t i = 1; i < lights.size(); ++i)
        EXPECT_LT(glm::length(lights[i].position - camera.target), reach);
}

TEST(DefaultLights, AreEqualForEqualScenes) {
    const Scene scene = sheet({-3, 0, -3}, {3, 2, 3});
    const std::vector<Light> a = defaultLights(scene), b = defaultLights(scene);
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].position, b[i].position);
        EXPECT_EQ(a[i].color, b[i].color);
    }
}

TEST(DefaultLights, AreFiniteInAnEmptyScene) {
    const std::vector<Light> lights = defaultLights(Scene{});
    for (const Light& light : lights) {
        EXPECT_TRUE(std::isfinite(light.position.x));
        EXPECT_TRUE(std::isfinite(light.color.r));
        EXPECT_TRUE(light.type == LightType::Directional || light.range > 0);
    }
}

TEST(CameraMatrices, OrthographicViewsCoverTheirHeight) {
    const Scene scene = sheet({-1, -1, 0}, {1, 1, 0});
    RenderSettings settings;
    settings.width = 200;
    settings.height = 100;
    settings.camera.eye = {0, 0, 3};
    settings.camera.height = 4;
    settings.jitter = {0.5, 0.25};
    for (const bool reversedZ : {false, true}) {
        settings.reversedZ = reversedZ;
        const CameraMatrices m = cameraMatrices(scene, settings, ClipY::Down);
        EXPECT_EQ(m.viewer, glm::dvec4(0, 0, 1, 0));
        for (const double depth : {1.0, 3.0}) {
            const glm::dvec4 clip = m.viewProjection * glm::dvec4(4, 2, -depth, 1);
            EXPECT_DOUBLE_EQ(clip.w, 1);
            EXPECT_DOUBLE_EQ(clip.x, 1 + 1.0 / 200); // a jitter of half a pixel
            EXPECT_DOUBLE_EQ(clip.y, -1 + 0.5 / 100);
            EXPECT_NEAR(clip.z, reversedZ ? 1 - depth / m.farPlane : depth / m.farPlane, 1e-12);
        }
    }
    // A perspective view has its viewer at the origin.
    settings.camera.height = 0;
    EXPECT_EQ(cameraMatrices(scene, settings, ClipY::Down).viewer, glm::dvec4(0, 0, 0, 1));
}
