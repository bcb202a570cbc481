// A left-handed host that follows docs/integration/coordinate-systems.md shows the image of a right-handed one. Each
// graphics API instantiates these for its host.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <cstring>
#include <optional>

namespace agaa::test {

// The scene and its camera in right-handed axes. A left-handed host has the same with z the other way.
struct HandedScene {
    std::vector<Triangle> triangles;
    glm::vec3 forward = glm::normalize(glm::vec3(0.5f, 0.3f, -0.6f));
    glm::vec3 up = glm::normalize(glm::vec3(0.4f, 1.0f, 0.2f));
    std::vector<AgaaLight> lights;
    glm::vec4 shadowPlane{0.02f, -0.03f, 0.04f, 0.5f}; // depth of a point in the shadow map
};

// What the host calls its own, in its own axes.
struct HandedHost {
    std::vector<Triangle> triangles;
    std::vector<AgaaLight> lights;
    glm::mat4 view{1}, projection{1}, shadow{0};
};

// What a left-handed host may forget of the recipe.
enum class Forgotten { Nothing, Positions, Normals, LightPositions, LightDirections, ShadowMatrices };

inline const glm::mat4 negatedZ =
    glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 0, 0, 1)); // F
inline glm::vec3 otherHand(const glm::vec3& v) { return {v.x, v.y, -v.z}; }

inline glm::mat4 rotationOfRows(const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
    return glm::mat4(glm::transpose(glm::mat3(x, y, z)));
}

inline HandedHost rightHandedHost(const HandedScene& scene) {
    const glm::vec3 right = glm::normalize(glm::cross(scene.forward, scene.up));
    HandedHost host;
    host.triangles = scene.triangles;
    host.lights = scene.lights;
    host.view = rotationOfRows(right, glm::cross(right, scene.forward), -scene.forward);
    host.projection = perspective(60, 1.5f, 0.1f, 100);
    for (int i = 0; i < 4; ++i)
        host.shadow[i][2] = scene.shadowPlane[i];
    host.shadow[3][3] = 1;
    return host;
}

// Its view space has x to the right, y up, and looks along +z.
inline HandedHost leftHandedHost(const HandedScene& scene) {
    const glm::vec3 forward = otherHand(scene.forward);
    const glm::vec3 right = glm::normalize(glm::cross(otherHand(scene.up), forward));
    HandedHost host;
    host.triangles = scene.triangles;
    for (Triangle& t : host.triangles) {
        for (glm::vec3& position : t.position)
            position = otherHand(position);
        t.material.normal.z = -t.material.normal.z;
    }
    host.lights = scene.lights;
    for (AgaaLight& light : host.lights) {
        light.position[2] = -light.position[2];
        light.direction[2] = -light.direction[2];
    }
    host.view = rotationOfRows(right, glm::cross(forward, right), forward);
    const float near = 0.1f, far = 100, focal = 1 / std::tan(glm::radians(60.0f) / 2);
    host.projection = glm::mat4(0);
    host.projection[0][0] = focal / 1.5f;
    host.projection[1][1] = -focal;
    host.projection[2] = glm::vec4(0, 0, far / (far - near), 1);
    host.projection[3][2] = -near * far / (far - near);
    for (int i = 0; i < 4; ++i)
        host.shadow[i][2] = (i == 2 ? -1.0f : 1.0f) * scene.shadowPlane[i];
    host.shadow[3][3] = 1;
    return host;
}

inline HandedScene handedScene() {
    HandedScene scene;
    scene.triangles = randomTriangles({.triangles = 60}, 91);
    const glm::mat3 toShading = glm::transpose(glm::mat3(rightHandedHost(scene).view));
    for (Triangle& t : scene.triangles) {
        for (glm::vec3& position : t.position)
            position = toShading * position; // from in front of the camera
        // Shading normals near that of the plane, so that specular light is seen.
        const glm::vec3 normal = glm::normalize(planeNormal(t) + 0.2f * glm::vec3(t.material.normal));
        t.material.normal = glm::vec4(normal, 0.05f + 0.3f * t.material.normal.w);
        t.material.emissive = glm::vec4(0);
    }
    const auto add = [&](uint32_t type, const glm::vec3& position, const glm::vec3& direction, float color) {
        AgaaLight light = AGAA_LIGHT_INIT;
        light.type = type;
        std::memcpy(light.position, &position, sizeof light.position);
        std::memcpy(light.direction, &direction, sizeof light.direction);
        light.color[0] = light.color[1] = light.color[2] = color;
        scene.lights.push_back(light);
    };
    const glm::vec3 middle = 6.0f * scene.forward;
    add(AGAA_LIGHT_POINT, middle + glm::vec3(1, 2, 1.5f), glm::vec3(0, 0, 1), 40);
    add(AGAA_LIGHT_DIRECTIONAL, {}, glm::normalize(glm::vec3(0.2f, -0.5f, -0.8f)), 3);
    scene.lights.back().shadowMap = 0;
    add(AGAA_LIGHT_SPOT, glm::vec3(-1, 1, 2), glm::normalize(middle), 60);
    scene.lights.back().cosInner = 0.95f;
    scene.lights.back().cosOuter = 0.8f;
    return scene;
}

template <class Host> class LeftHandedCases : public testing::Test {
protected:
    static ViewSettings settingsOf(const HandedHost& host, const char* technique, uint32_t tier) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.generationTier = tier;
        settings.config.samples = 4;
        settings.config.flags = AGAA_CONFIG_COUNTERS;
        settings.view = host.view;
        settings.projection = host.projection;
        return settings;
    }

    // What the host passes on, by matrices and lights of the SDK's.
    Shown render(const ViewSettings& settings, const Shot& shot, const std::vector<AgaaLight>& lights,
                 const glm::mat4& view, const glm::mat4& projection, const glm::mat4& shadowMatrix) {
        std::optional<typename Host::Ids> ids;
        std::optional<typename Host::View> own;
        if (settings.config.generationTier == AGAA_TIER_IDS)
            ids.emplace(context, settings, shot);
        else
            own.emplace(context, settings).setTriangles(shot.triangles);
        typename Host::View& made = ids ? ids->view() : *own;
        AgaaShadow shadow{};
        shadow.layerCount = 1;
        std::memcpy(shadow.matrices[0], &shadowMatrix, sizeof shadow.matrices[0]);
        AgaaFrame frame = made.frame();
        std::memcpy(frame.view, &view, sizeof frame.view);
        std::memcpy(frame.projection, &projection, sizeof frame.projection);
        frame.lights = lights.data();
        frame.lightCount = uint32_t(lights.size());
        frame.shadows = &shadow;
        frame.shadowCount = 1;
        const typename Host::ShadowMap map = Host::shadowMap(context, 0.5f);
        Host::run(made, [&](typename Host::Frame& native) {
            if (ids)
                ids->bind(native);
            Host::setShadowMap(native, map);
            EXPECT_EQ(Host::recordFrame(made.get(), &frame, &native), AGAA_OK);
        });
        Shown shown;
        shown.rgb = withoutAlpha(Host::rgba(made));
        EXPECT_EQ(agaaValidateFrame(made.get(), frame.frameIndex, &shown.validation), AGAA_OK);
        return shown;
    }

    Shown byRightHand(const char* technique, uint32_t tier) {
        const HandedHost host = rightHandedHost(scene);
        ViewSettings settings = settingsOf(host, technique, tier);
        settings.surface = "s.geometricNormal = agaa_planeNormal(position);";
        const Shot shot{.triangles = host.triangles,
                        .material = "m.normalDx = vec3(0.02, 0.01, -0.03); m.normalDy = vec3(0.01, -0.02, 0.01);"};
        return render(settings, shot, host.lights, host.view, host.projection, host.shadow);
    }

    // By the recipe. isReflecting: its view matrix looks along -z.
    Shown byLeftHand(const char* technique, uint32_t tier, Forgotten forgotten = Forgotten::Nothing,
                     bool isReflecting = false) {
        const HandedHost host = leftHandedHost(scene);
        ViewSettings settings = settingsOf(host, technique, tier);
        settings.surface = forgotten == Forgotten::Positions
                               ? "s.normal.z = -s.normal.z; s.geometricNormal = agaa_planeNormal(position);"
                           : forgotten == Forgotten::Normals
                               ? "s.position.z = -s.position.z; s.geometricNormal = agaa_planeNormal(s.position);"
                               : "s.position.z = -s.position.z; s.normal.z = -s.normal.z; "
                                 "s.geometricNormal = agaa_planeNormal(s.position);";
        const Shot shot{.triangles = host.triangles,
                        .material = "m.normal.z = -m.normal.z; "
                                    "m.normalDx = vec3(0.02, 0.01, 0.03); m.normalDx.z = -m.normalDx.z; "
                                    "m.normalDy = vec3(0.01, -0.02, -0.01); m.normalDy.z = -m.normalDy.z;"};
        std::vector<AgaaLight> lights = host.lights;
        for (AgaaLight& light : lights) {
            if (forgotten != Forgotten::LightPositions)
                light.position[2] = -light.position[2];
            if (forgotten != Forgotten::LightDirections)
                light.direction[2] = -light.direction[2];
        }
        glm::mat4 view = negatedZ * host.view * negatedZ, projection = host.projection * negatedZ;
        if (isReflecting) {
            settings.view = negatedZ * host.view;
            settings.projection = host.projection * negatedZ;
            view = settings.view * negatedZ;
            projection = settings.projection;
        }
        return render(settings, shot, lights, view, projection,
                      forgotten == Forgotten::ShadowMatrices ? host.shadow : host.shadow * negatedZ);
    }

    // Share of values that differ by more than a thousandth.
    static double differing(const Shown& a, const Shown& b) {
        size_t count = 0;
        for (size_t i = 0; i < a.rgb.size(); ++i)
            count += !(std::fabs(a.rgb[i] - b.rgb[i]) <= 1e-3f * std::max(std::fabs(a.rgb[i]), 0.01f));
        return double(count) / double(a.rgb.size());
    }

    typename Host::Context context;
    const HandedScene scene = handedScene();
};
TYPED_TEST_SUITE_P(LeftHandedCases);

TYPED_TEST_P(LeftHandedCases, TheRecipeShowsTheImageOfARightHandedHost) {
    struct Way {
        const char* technique;
        uint32_t tier;
    };
    for (const Way way : {Way{"ssaa", AGAA_TIER_AUTO}, Way{"msaa", AGAA_TIER_AUTO}, Way{"agaa", AGAA_TIER_PER_SAMPLE},
                          Way{"agaa", AGAA_TIER_GBUFFER}, Way{"agaa", AGAA_TIER_IDS}}) {
        SCOPED_TRACE(way.technique + std::string(" ") + agaaTierName(way.tier));
        const Shown right = this->byRightHand(way.technique, way.tier);
        const Shown left = this->byLeftHand(way.technique, way.tier);
        EXPECT_EQ(right.validation.isValid, 1u) << right.validation.explanation;
        EXPECT_EQ(left.validation.isValid, 1u) << left.validation.explanation;
        EXPECT_GT(right.validation.visible, 1000u);
        EXPECT_EQ(nonFinite(left.rgb), 0u);
        EXPECT_GT(sumOf(right.rgb), 0.05 * double(right.rgb.size()));
        EXPECT_EQ(this->differing(right, left), 0);
    }
}

TYPED_TEST_P(LeftHandedCases, TheRecipeForReflectingViewsShowsIt) {
    const Shown right = this->byRightHand("agaa", AGAA_TIER_GBUFFER);
    const Shown left = this->byLeftHand("agaa", AGAA_TIER_GBUFFER, Forgotten::Nothing, true);
    EXPECT_EQ(left.validation.isValid, 1u) << left.validation.explanation;
    EXPECT_EQ(this->differing(right, left), 0);
}

// The scene depends on each line of the recipe.
TYPED_TEST_P(LeftHandedCases, WhatIsForgottenShows) {
    const Shown right = this->byRightHand("agaa", AGAA_TIER_PER_SAMPLE);
    for (const Forgotten forgotten :
         {Forgotten::Normals, Forgotten::LightPositions, Forgotten::LightDirections, Forgotten::ShadowMatrices}) {
        const Shown left = this->byLeftHand("agaa", AGAA_TIER_PER_SAMPLE, forgotten);
        EXPECT_GT(this->differing(right, left), 0.02) << int(forgotten);
    }
    const Shown left = this->byLeftHand("agaa", AGAA_TIER_PER_SAMPLE, Forgotten::Positions);
    EXPECT_EQ(left.validation.isValid, 0u);
    EXPECT_GT(left.validation.misplaced, left.validation.visible / 4);
}

TYPED_TEST_P(LeftHandedCases, MatricesThatAreNotConvertedAreRefused) {
    const HandedHost host = leftHandedHost(this->scene);
    typename TypeParam::View view(this->context, this->settingsOf(host, "ssaa", AGAA_TIER_AUTO));
    view.setTriangles(host.triangles);
    struct Row {
        const char* what;
        glm::mat4 view, projection;
        const char* said;
    };
    const Row rows[] = {
        {"as they are", host.view, host.projection, "perspective"},
        {"a view along -z", negatedZ * host.view, host.projection * negatedZ, "reflection"},
        {"a view with its axes converted on one side", host.view * negatedZ, host.projection * negatedZ, "reflection"},
        {"a projection that is not converted", negatedZ * host.view * negatedZ, host.projection, "perspective"},
    };
    for (const Row& row : rows) {
        AgaaFrame frame = view.frame();
        std::memcpy(frame.view, &row.view, sizeof frame.view);
        std::memcpy(frame.projection, &row.projection, sizeof frame.projection);
        this->context.lines.clear();
        TypeParam::run(view, [&](typename TypeParam::Frame& native) {
            EXPECT_EQ(TypeParam::recordFrame(view.get(), &frame, &native), AGAA_ERROR_OUT_OF_RANGE) << row.what;
        });
        expectOneSentence(this->context.lines, AGAA_ERROR_OUT_OF_RANGE, row.what, row.said);
    }
    EXPECT_EQ(view.drawCalls, 0u);
}

REGISTER_TYPED_TEST_SUITE_P(LeftHandedCases, TheRecipeShowsTheImageOfARightHandedHost,
                            TheRecipeForReflectingViewsShowsIt, WhatIsForgottenShows,
                            MatricesThatAreNotConvertedAreRefused);

} // namespace agaa::test
