// Images of small scenes against values computed by hand.
#include "cases.h"
#include "frame_rig.h"

#include <cmath>

namespace agaa::conformance {

namespace {

constexpr float pi = 3.14159265f;
constexpr float nothing[] = {0, 0, 0};

struct Rgb {
    float v[3];
    Rgb operator*(float f) const { return {{v[0] * f, v[1] * f, v[2] * f}}; }
};
constexpr Rgb albedo = {{0.25f, 0.5f, 0.75f}};
constexpr float distance = 8;

// The scene has diffuse materials only.
void diffuseFacts(ViewDescription& description) {
    description.facts.flags = AGAA_FACT_AMBIENT | AGAA_FACT_ALPHA_MASKED;
    description.facts.shadowMapCount = 2;
}

Scene wall(const Rig& rig, const float* normal = nullptr) {
    const AgaaViewDesc& desc = rig.description().desc;
    Surface surface;
    std::copy(albedo.v, albedo.v + 3, surface.diffuse);
    if (normal)
        std::copy(normal, normal + 3, surface.normal);
    Scene scene;
    addRectangle(scene, desc.width, desc.height, 0, 0, float(desc.width), float(desc.height), distance, surface);
    return scene;
}

Area whole(const Rig& rig) { return {0, 0, rig.description().desc.width, rig.description().desc.height}; }

// Returns the middle of a pixel of the wall in shading space.
void placeOf(const Rig& rig, uint32_t x, uint32_t y, float* place) {
    const AgaaViewDesc& desc = rig.description().desc;
    place[0] = float(x) + 0.5f - float(desc.width) / 2;
    place[1] = float(desc.height) / 2 - float(y) - 0.5f;
    place[2] = -distance;
}

AgaaLight lightOfType(uint32_t type) {
    AgaaLight light = AGAA_LIGHT_INIT;
    light.type = type;
    return light;
}

Image renderLight(Rig& rig, const AgaaLight& light, const AgaaShadow* shadow = nullptr) {
    return rig.render([&](AgaaFrame& frame) {
        std::copy(nothing, nothing + 3, frame.ambient);
        frame.lights = &light;
        frame.lightCount = 1;
        frame.shadows = shadow;
        frame.shadowCount = shadow ? 1 : 0;
    });
}

using Irradiance = std::function<float(const float* place)>;

// The light that a pixel receives, times albedo / pi. Techniques shade a pixel at one or more points, so the value is
// between the minimum and the maximum over the pixel's corners.
void expectLightAt(Rig& rig, const Image& image, uint32_t x, uint32_t y, const Irradiance& irradiance,
                   const std::string& what) {
    float least = INFINITY, greatest = 0;
    for (const float dx : {-0.5f, 0.0f, 0.5f})
        for (const float dy : {-0.5f, 0.0f, 0.5f}) {
            float place[3];
            placeOf(rig, x, y, place);
            place[0] += dx;
            place[1] += dy;
            least = std::min(least, irradiance(place) / pi);
            greatest = std::max(greatest, irradiance(place) / pi);
        }
    const Rgb middle = albedo * (0.5f * (least + greatest));
    expectColor(rig.test, image, whole(rig).x1, {x, y, x + 1, y + 1}, middle.v, 0.003f + 0.5f * (greatest - least),
                what);
}

void expectLight(Rig& rig, const Image& image, const Irradiance& irradiance, const std::string& what) {
    const Area area = whole(rig);
    for (uint32_t y = area.y0; y < area.y1; y += 3)
        for (uint32_t x = area.x0; x < area.x1; x += 3)
            expectLightAt(rig, image, x, y, irradiance, what);
}

std::string named(const Rig& rig, const std::string& what) {
    return what + " (\"" + rig.description().config.technique + "\")";
}

void expectAmbient(Rig& rig) {
    const Image image = rig.render([](AgaaFrame& frame) {
        frame.ambient[0] = 0.5f;
        frame.ambient[1] = 2;
        frame.ambient[2] = 0;
    });
    const float expected[] = {0.5f * albedo.v[0], 2 * albedo.v[1], 0};
    expectColor(rig.test, image, whole(rig).x1, whole(rig), expected, 0.005f, named(rig, "ambient light (0.5, 2, 0)"));
}

void expectDirectional(Rig& rig) {
    AgaaLight light = lightOfType(AGAA_LIGHT_DIRECTIONAL);
    light.color[0] = light.color[1] = light.color[2] = 4;
    expectLight(
        rig, renderLight(rig, light), [](const float*) { return 4.0f; }, named(rig, "a light from the eye"));
    light.direction[0] = 0.6f;
    light.direction[2] = -0.8f;
    expectLight(
        rig, renderLight(rig, light), [](const float*) { return 4 * 0.8f; }, named(rig, "a slanting light"));
    light.direction[0] = 0;
    light.direction[2] = 1;
    expectLight(
        rig, renderLight(rig, light), [](const float*) { return 0.0f; }, named(rig, "a light from behind"));
}

// The result is intensity times cosine over the squared distance, outside the lamp and within the range.
float pointLight(const float* place, const AgaaLight& light) {
    float squared = 0;
    for (int i = 0; i < 3; ++i)
        squared += (light.position[i] - place[i]) * (light.position[i] - place[i]);
    const float cosine = (light.position[2] - place[2]) / std::sqrt(squared);
    return light.color[0] * cosine / std::max(squared, light.radius * light.radius);
}

AgaaLight lamp() {
    AgaaLight light = lightOfType(AGAA_LIGHT_POINT);
    light.color[0] = light.color[1] = light.color[2] = 300;
    light.position[0] = 3;
    light.position[1] = -2;
    return light;
}

void expectPoint(Rig& rig) {
    AgaaLight light = lamp();
    expectLight(
        rig, renderLight(rig, light), [&](const float* place) { return pointLight(place, light); },
        named(rig, "a point light"));
    light.radius = 12;
    expectLight(
        rig, renderLight(rig, light), [&](const float* place) { return pointLight(place, light); },
        named(rig, "a point light with a radius"));
    light.radius = 0;
    light.range = 7.5f;
    expectLight(
        rig, renderLight(rig, light), [](const float*) { return 0.0f; }, named(rig, "a point light out of its range"));
}

void expectSpot(Rig& rig) {
    AgaaLight light = lamp();
    light.type = AGAA_LIGHT_SPOT;
    light.cosInner = 0.86f; // the cone is a circle of radius 4.7 on the wall
    light.cosOuter = 0.84f;
    const Image image = renderLight(rig, light);
    const auto cosine = [&](const float* p) {
        const float x = p[0] - light.position[0], y = p[1] - light.position[1], z = p[2] - light.position[2];
        return -z / std::sqrt(x * x + y * y + z * z);
    };
    const Area area = whole(rig);
    for (uint32_t y = 0; y < area.y1; ++y)
        for (uint32_t x = 0; x < area.x1; ++x) {
            float place[3];
            placeOf(rig, x, y, place);
            const float c = cosine(place);
            if (c < 0.89f && c > 0.80f) // close to the edge of the cone
                continue;
            const bool isInside = c > 0.85f;
            expectLightAt(
                rig, image, x, y, [&](const float* p) { return isInside ? pointLight(p, light) : 0.0f; },
                named(rig, "a spot light"));
        }
}

// All points have this position in a layer.
void project(float* matrix, float x, float depth) {
    std::fill(matrix, matrix + 16, 0.0f);
    matrix[12] = x;
    matrix[14] = depth;
    matrix[15] = 1;
}

void expectShadows(Rig& rig) {
    struct Row {
        const char* what;
        float x0, depth0, bias, x1, depth1;
        bool isLit;
    };
    // The stored depth is 0.5.
    const Row rows[] = {{"in front of the stored depth", 0, 0.25f, 0, 9, 0, true},
                        {"at the stored depth", 0, 0.5f, 0, 9, 0, true},
                        {"behind the stored depth", 0, 0.75f, 0, 9, 0, false},
                        {"behind the stored depth by less than depthBias", 0, 0.75f, 0.3f, 9, 0, true},
                        {"behind the stored depth by more than depthBias", 0, 0.75f, 0.2f, 9, 0, false},
                        {"outside all layers", 9, 0.75f, 0, 9, 0.75f, true},
                        {"in the first of two layers", 0, 0.75f, 0, 0, 0.25f, false},
                        {"in the second layer only", 9, 0.25f, 0, 0, 0.75f, false},
                        {"beyond the depths of the first layer", 0, 1.5f, 0, 0, 0.75f, false}};
    rig.device().setShadowDepth(0.5f);
    AgaaLight light = lightOfType(AGAA_LIGHT_DIRECTIONAL);
    light.color[0] = light.color[1] = light.color[2] = 4;
    light.shadowMap = 0;
    for (const Row& row : rows) {
        AgaaShadow shadow = AGAA_SHADOW_INIT;
        shadow.layerCount = 2;
        shadow.depthBias = row.bias;
        project(shadow.matrices[0], row.x0, row.depth0);
        project(shadow.matrices[1], row.x1, row.depth1);
        expectLight(
            rig, renderLight(rig, light, &shadow), [&](const float*) { return row.isLit ? 4.0f : 0.0f; },
            named(rig, std::string("a wall ") + row.what));
        light.shadowMap = AGAA_NO_SHADOW;
        expectLight(
            rig, renderLight(rig, light, &shadow), [&](const float*) { return 4.0f; },
            named(rig, "a light without a shadow"));
        light.shadowMap = 0;
    }
    rig.device().setShadowDepth(1.0f);
}

void testLights(Test& test, const char* technique) {
    Rig rig(test, [&](ViewDescription& description) {
        setTechnique(description, technique, 4);
        diffuseFacts(description);
    });
    rig.scene = wall(rig);
    expectAmbient(rig);
    expectDirectional(rig);
    expectPoint(rig);
    expectSpot(rig);
    expectShadows(rig);
}

} // namespace

void addImageCases(Suite& suite) {
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"})
        suite.both("general/images_of_lights/" + std::string(technique),
                   [technique](Test& test) { testLights(test, technique); });
}

} // namespace agaa::conformance
