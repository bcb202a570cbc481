// Cameras, camera paths, and the pixels of two images beside each other.
#include "camera_control.h"
#include "camera_path.h"
#include "cli/arguments.h"
#include "compose.h"
#include "frame_history.h"

#include <gtest/gtest.h>

namespace viewer {
namespace {

harness::Camera someCamera() { return harness::parseCamera("4,2,-3,0.1,0.7,1,55"); }

void expectNear(const glm::dvec3& a, const glm::dvec3& b) { EXPECT_LT(glm::length(a - b), 1e-9); }

TEST(CameraControl, TextsGiveTheSameNumbers) {
    harness::Camera camera = someCamera();
    camera.eye.x = 0.1 + 0.2;
    camera.target.z = -1.0 / 3;
    const harness::Camera read = harness::parseCamera(cameraText(camera));
    EXPECT_EQ(read.eye, camera.eye);
    EXPECT_EQ(read.target, camera.target);
    EXPECT_EQ(read.fovDegrees, camera.fovDegrees);
}

TEST(CameraControl, OrbitKeepsTargetAndDistance) {
    const harness::Camera camera = someCamera(), turned = orbited(camera, 0.7, 5);
    expectNear(turned.target, camera.target);
    EXPECT_NEAR(glm::length(turned.eye - turned.target), glm::length(camera.eye - camera.target), 1e-9);
    const glm::dvec3 direction = glm::normalize(turned.eye - turned.target);
    EXPECT_LT(direction.y, 0.9999); // the pitch is limited
    expectNear(orbited(camera, 0, 0).eye, camera.eye);
}

TEST(CameraControl, FlyingKeepsTheEyeAndMovesForward) {
    const harness::Camera camera = someCamera();
    expectNear(turned(camera, 0.3, 0.1).eye, camera.eye);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    expectNear(moved(camera, {0, 0, 2}).eye, camera.eye + 2.0 * forward);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    expectNear(moved(camera, {2, 0, 0}).eye, camera.eye + 2.0 * right);
    expectNear(zoomed(camera, 0.5).eye, 0.5 * (camera.eye + camera.target));
}

TEST(CameraPath, RecordsCamerasThatMove) {
    CameraPath path;
    path.record("not recording");
    path.toggleRecording();
    for (const char* camera : {"a", "a", "b", "b", "a"})
        path.record(camera);
    path.toggleRecording();
    path.record("c");
    EXPECT_EQ(path.cameras, (std::vector<std::string>{"a", "b", "a"}));
}

TEST(CameraPath, PlaysOnceOrLoops) {
    CameraPath path;
    path.togglePlaying();
    EXPECT_FALSE(path.isPlaying); // there is nothing to play
    path.cameras = {"a", "b", "c"};
    path.position = 2;
    path.togglePlaying();
    std::string played;
    while (const auto camera = path.next())
        played += *camera;
    EXPECT_EQ(played, "abc");
    EXPECT_FALSE(path.isPlaying);
    path.loops = true;
    path.togglePlaying();
    played.clear();
    for (int i = 0; i < 7; ++i)
        played += path.next().value();
    EXPECT_EQ(played, "abcabca");
    EXPECT_TRUE(path.isPlaying);
}

harness::Image filled(uint32_t width, uint32_t height, float value) {
    return {width, height, std::vector<float>(3 * size_t(width) * height, value)};
}

TEST(Compose, ShowsBothSidesOfTheLine) {
    const harness::Image a = filled(8, 2, 0), b = filled(8, 2, 1);
    ViewerState state;
    state.mode = Mode::Split;
    state.split = 0.25;
    const std::vector<harness::Pixel> pixels = composed(a, &b, state);
    const harness::Pixel left = displayPixels(a)[0], right = displayPixels(b)[0];
    ASSERT_NE(left, right);
    for (size_t i = 0; i < pixels.size(); ++i)
        EXPECT_EQ(pixels[i], i % 8 < 2 ? left : right) << i;
}

TEST(Compose, ShowsTheDifferenceWithItsGain) {
    const harness::Image a = filled(2, 2, 0.5f), b = filled(2, 2, 0.55f);
    ViewerState state;
    state.mode = Mode::Difference;
    state.gain = 1;
    const harness::Pixel once = composed(a, &b, state)[0];
    state.gain = 8;
    const harness::Pixel more = composed(a, &b, state)[0];
    EXPECT_GT(once[0], 0);
    EXPECT_NEAR(more[0], 8 * once[0], 8);
}

TEST(Compose, ShowsAWhileBHasAnotherSize) {
    const harness::Image a = filled(4, 2, 0.5f), b = filled(2, 2, 0);
    ViewerState state;
    for (const Mode mode : {Mode::B, Mode::Split, Mode::Difference}) {
        state.mode = mode;
        EXPECT_EQ(composed(a, &b, state), displayPixels(a));
        EXPECT_EQ(composed(a, nullptr, state), displayPixels(a));
    }
}

TEST(FrameHistory, KeepsFramesOfTheSamePasses) {
    FrameHistory history;
    for (size_t i = 0; i < FrameHistory::length + 5; ++i)
        history.add({{"prepass", "prepass", double(i)}, {"shade", "shading", 1}});
    ASSERT_EQ(history.rows().size(), 2u);
    EXPECT_EQ(history.rows()[0].milliseconds.size(), FrameHistory::length);
    EXPECT_EQ(history.rows()[0].newest(), float(FrameHistory::length + 4));
    history.add({{"gbuffer", "prepass", 3}});
    ASSERT_EQ(history.rows().size(), 1u);
    EXPECT_EQ(history.rows()[0].milliseconds.size(), 1u);
}

} // namespace
} // namespace viewer
