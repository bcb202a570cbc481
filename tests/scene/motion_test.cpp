// Tests of motions: calls agree in any order, and speeds are as stated.
#include "scene/builtin.h"
#include "scene/motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace harness {
namespace {

Camera cameraOf(const Scene& scene) { return scene.cameras.empty() ? defaultCamera(scene) : scene.cameras[0]; }

TEST(Motion, NamesMakeMotions) {
    for (const MotionName& name : motionNames()) {
        Scene scene = *makeBuiltinScene("metal");
        EXPECT_TRUE(makeMotion(name.name, scene, cameraOf(scene), 180)) << name.name;
        EXPECT_FALSE(name.shows.empty());
    }
    Scene scene = *makeBuiltinScene("metal");
    EXPECT_FALSE(makeMotion("fall", scene, cameraOf(scene), 180));
    EXPECT_FALSE(makeMotion("", scene, cameraOf(scene), 180));
}

TEST(Motion, CallsAgree) {
    for (const MotionName& name : motionNames()) {
        Scene scene = *makeBuiltinScene("foliage"), second = scene;
        const auto forward = makeMotion(name.name, scene, cameraOf(scene), 180);
        const auto other = makeMotion(name.name, second, cameraOf(second), 180);
        for (uint32_t frame : {63u, 0u, 9u}) // the other one begins elsewhere
            for (uint32_t i = 0; forward->placement && i < scene.instances.size(); ++i) {
                other->placement(i, 71 - frame);
                EXPECT_EQ(forward->placement(i, frame), other->placement(i, frame));
            }
        if (forward->camera) {
            other->camera(9);
            EXPECT_EQ(forward->camera(5).eye, other->camera(5).eye);
        }
    }
}

TEST(Motion, WindMovesTopsAndLeavesTheGround) {
    Scene scene = *makeBuiltinScene("foliage");
    const auto motion = makeMotion("wind", scene, cameraOf(scene), 180);
    const double bottom = scene.boundsMin.y, height = scene.boundsMax.y - bottom;
    double largest = 0;
    for (uint32_t frame = 0; frame < 40; ++frame) {
        const glm::dmat4 placed = motion->placement(3, frame);
        EXPECT_NEAR(glm::length(glm::dvec3(placed * glm::dvec4(2, bottom, 3, 1)) - glm::dvec3(2, bottom, 3)), 0, 1e-12);
        largest = std::max(largest, std::abs((placed * glm::dvec4(0, bottom + height, 0, 1)).x));
        EXPECT_NEAR(glm::determinant(placed), 1, 1e-12) << "shears keep volumes";
    }
    EXPECT_NEAR(largest, height / 15, 0.01 * height);
    EXPECT_NE(motion->placement(3, 5), motion->placement(40, 5)) << "instances sway after one another";
}

TEST(Motion, TurnsAroundTheTarget) {
    Scene scene = *makeBuiltinScene("metal");
    const Camera camera = cameraOf(scene);
    const auto motion = makeMotion("turn", scene, camera, 180);
    const glm::dvec3 there = camera.target + glm::dvec3(2, 0, 0);
    const glm::dvec3 placed = motion->placement(0, 270) * glm::dvec4(there, 1); // a quarter of a turn
    EXPECT_NEAR(glm::length(placed - camera.target - glm::dvec3(0, 0, -2)), 0, 1e-12);
    EXPECT_EQ(motion->placement(0, 0), glm::dmat4(1));
}

TEST(Motion, TheBoxPassesByFourPixelsAFrame) {
    Scene scene = *makeBuiltinScene("bamboo");
    const size_t instances = scene.instances.size(), meshes = scene.meshes.size();
    const Camera camera = cameraOf(scene);
    const auto motion = makeMotion("pass", scene, camera, 180);
    ASSERT_EQ(scene.instances.size(), instances + 1);
    ASSERT_EQ(scene.meshes.size(), meshes + 1);
    EXPECT_EQ(motion->placement(0, 9), glm::dmat4(1)) << "the others stand";
    const glm::dvec3 step =
        glm::dvec3(motion->placement(uint32_t(instances), 10)[3] - motion->placement(uint32_t(instances), 9)[3]);
    const double distance = glm::length(glm::dvec3(scene.instances.back().transform[3]) - camera.eye);
    const double pixel = 2 * std::tan(glm::radians(camera.fovDegrees) / 2) * distance / 180;
    EXPECT_NEAR(glm::length(step) / pixel, 4, 1e-9);
}

TEST(Motion, TheFirstLightIsSwitchedOn) {
    Scene scene = *makeBuiltinScene("metal");
    const auto motion = makeMotion("light", scene, cameraOf(scene), 180);
    EXPECT_EQ(motion->brightness(0, switchedOnFrame - 1), 0);
    EXPECT_EQ(motion->brightness(0, switchedOnFrame), 1);
    EXPECT_EQ(motion->brightness(1, 0), 1);
}

// The target's image stands still. The image of a point on the plane before the walk moves by 1.3 pixels a frame.
TEST(Motion, TheCameraWalksToTheSide) {
    Camera camera;
    camera.eye = {3, 4, 5};
    camera.target = {-2, 1, 0.5};
    camera.fovDegrees = 50;
    for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0.3, -2, 1), camera.target - camera.eye})
        for (uint32_t frame : {0u, 1u, 5u}) {
            camera.up = up;
            const Camera moved = walkingCamera(camera, frame, 360);
            const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
            const glm::dvec3 step = moved.eye - camera.eye;
            EXPECT_NEAR(glm::dot(step, forward), 0, 1e-12);
            EXPECT_NEAR(glm::length((moved.target - moved.eye) - (camera.target - camera.eye)), 0, 1e-12);
            const double distance = glm::length(camera.target - camera.eye);
            const double pixels = glm::length(step) / distance / std::tan(glm::radians(25.0)) * 180;
            EXPECT_NEAR(pixels, 1.3 * frame, 1e-9);
        }
    camera.target = camera.eye + glm::dvec3(2, 2, 2);
    camera.up = glm::dvec3(1, 1, 1);
    EXPECT_GT(glm::length(walkingCamera(camera, 1, 360).eye - camera.eye), 0);
    camera.target = camera.eye;
    EXPECT_EQ(walkingCamera(camera, 3, 360).eye, camera.eye) << "aims at nothing";
}

} // namespace
} // namespace harness
