#include "moving_scenes.h"

#include "render/camera_matrices.h"
#include "render/motion_error.h"
#include "render/reference.h"
#include "scene/builtin.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace harness::test {

namespace {

struct MovingScene {
    Scene scene;
    RenderSettings settings;
};

MovingScene movingScene(const char* source, const char* motion, uint32_t width, uint32_t height) {
    MovingScene made;
    made.scene = *makeBuiltinScene(source);
    made.settings = settingsFor({source, source, {}}, made.scene, width, height);
    made.settings.config.flags &= ~AGAA_CONFIG_COUNTERS;
    made.settings.motion = makeMotion(motion, made.scene, made.settings.camera, height);
    return made;
}

CameraMatrices cameraOf(const MovingScene& moving, uint32_t frame) {
    RenderSettings settings = moving.settings;
    if (settings.motion->camera)
        settings.camera = settings.motion->camera(frame);
    return cameraMatrices(moving.scene, settings, ClipY::Down);
}

glm::dmat4 placementOf(const MovingScene& moving, uint32_t frame) {
    return moving.settings.motion->placement ? moving.settings.motion->placement(0, frame) : glm::dmat4(1);
}

// Computes the place and the distance in the previous frame from the distance in this one. All instances move alike.
glm::dvec3 previousPlace(const MovingScene& moving, uint32_t frame, const glm::dvec2& place, double distance) {
    const glm::dvec2 size(moving.settings.width, moving.settings.height);
    const CameraMatrices now = cameraOf(moving, frame), before = cameraOf(moving, frame - 1);
    const glm::dvec2 ndc = place / size * 2.0 - 1.0;
    const glm::dvec3 view(ndc.x * distance / now.projection[0][0], ndc.y * distance / now.projection[1][1], -distance);
    const glm::dvec3 world = glm::transpose(glm::dmat3(now.view)) * view + now.eye;
    const glm::dvec3 moved =
        glm::dvec3(placementOf(moving, frame - 1) * glm::inverse(placementOf(moving, frame)) * glm::dvec4(world, 1));
    const glm::dvec4 clip = before.viewProjection * glm::dvec4(moved - before.eye, 1);
    return {(glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size, clip.w};
}

} // namespace

void expectMotionIsShown(Renderer& renderer) {
    for (const char* motion : {"walk", "turn"}) {
        MovingScene moving = movingScene("metal", motion, 96, 54);
        renderer.load(moving.scene);
        moving.settings.firstFrame = 7;
        const MotionImage image = renderMotion(renderer, moving.settings);
        double largest = 0, moved = 0, depth = 0;
        size_t surfaces = 0;
        for (size_t i = 0; i < image.distance.size(); ++i) {
            if (std::isinf(image.distance[i]))
                continue;
            ++surfaces;
            const glm::dvec2 place = glm::dvec2(i % image.width, i / image.width) + 0.5;
            const glm::dvec3 expected = previousPlace(moving, 7, place, double(image.distance[i]));
            const glm::dvec2 shown = place + glm::dvec2(image.toPrevious[i]);
            largest = std::max(largest, glm::length(shown - glm::dvec2(expected)));
            depth = std::max(depth, std::abs(double(image.previousDistance[i]) / expected.z - 1));
            moved = std::max(moved, double(glm::length(image.toPrevious[i])));
        }
        EXPECT_GT(surfaces, image.distance.size() / 4);
        EXPECT_GT(moved, 0.5) << motion;
        EXPECT_LT(largest, 0.002) << motion;
        EXPECT_LT(depth, 2e-4) << motion;
        std::printf("%s: places within %.4f pixels, distances within %.5f\n", motion, largest, depth);
    }
}

void expectAccumulationFollowsMotion(Renderer& renderer) {
    MovingScene moving = movingScene("bamboo", "pass", 128, 72);
    renderer.load(moving.scene);
    RenderSettings single = moving.settings, taa = moving.settings;
    single.config.technique = "single";
    taa.config.technique = "taa";
    Disocclusion disocclusion;
    MotionErrorMeter ofSingle, ofTaa;
    for (uint32_t frame = 0; frame < 16; ++frame) {
        moving.settings.firstFrame = single.firstFrame = taa.firstFrame = frame;
        const MotionImage motion = renderMotion(renderer, moving.settings);
        disocclusion.add(motion);
        const Image reference = renderReference(renderer, moving.settings, 16).image;
        ofSingle.add(renderer.render(single).image, reference, motion, disocclusion);
        ofTaa.add(renderer.render(taa).image, reference, motion, disocclusion);
    }
    const MotionError a = ofTaa.result(), b = ofSingle.result();
    ASSERT_TRUE(a.ghosting && b.ghosting);
    std::printf("taa by single: error %.3f, ghosting %.3f; sharpness %.3f and %.3f\n", a.error / b.error,
                *a.ghosting / *b.ghosting, a.sharpness, b.sharpness);
    EXPECT_LT(a.error, 0.17 * b.error);
    EXPECT_LT(*a.ghosting, 0.3 * *b.ghosting);
    EXPECT_GT(a.sharpness, 0.35);
}

} // namespace harness::test
