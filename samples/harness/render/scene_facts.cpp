// The effects that a scene uses, and the properties that all of its materials and lights share.
#include "render/draw_list.h"
#include "render/lights.h"
#include "render/renderer.h"

#include <algorithm>
#include <cmath>

namespace harness {

namespace {

struct UsedMaterial {
    Material material;
    bool isMasked = false;
};

std::vector<UsedMaterial> usedMaterials(const Scene& scene) {
    std::vector<UsedMaterial> used;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes.at(instance.mesh);
        const bool hasMaterial = mesh.material < scene.materials.size();
        used.push_back({hasMaterial ? scene.materials[mesh.material] : Material{}, isMasked(scene, mesh)});
    }
    return used;
}

// Matches shaders/material.glsl.
float alpha2Of(float roughness) {
    const float alpha = std::max(roughness, 0.089f) * std::max(roughness, 0.089f);
    return std::min(alpha * alpha, 1.0f);
}

// Returns whether the vertex normals of a mesh equal the normals of its triangles within the tolerance of the SDK.
bool isFlat(const Scene& scene, const Mesh& mesh) {
    constexpr float least = 0.9998f;
    for (uint32_t i = 0; i + 2 < mesh.indexCount; i += 3) {
        const auto vertex = [&](uint32_t corner) -> const Vertex& {
            return scene.vertices[mesh.firstVertex + scene.indices[mesh.firstIndex + i + corner]];
        };
        const glm::dvec3 a(vertex(0).position);
        const glm::dvec3 n = glm::cross(glm::dvec3(vertex(1).position) - a, glm::dvec3(vertex(2).position) - a);
        const double size = glm::length(n);
        for (uint32_t corner = 0; corner < 3 && size > 0; ++corner)
            if (std::abs(glm::dot(n, glm::dvec3(vertex(corner).normal))) <
                least * size * glm::length(vertex(corner).normal))
                return false;
    }
    return true;
}

uint64_t commonValues(const Scene& scene, const std::vector<UsedMaterial>& used, AgaaSceneFacts& facts) {
    const auto all = [&](const auto& has) { return !used.empty() && std::ranges::all_of(used, has); };
    const auto isGrey = [](const Material& m) {
        return m.baseColorTexture < 0 && m.baseColor.r == m.baseColor.g && m.baseColor.g == m.baseColor.b;
    };
    uint64_t flags = 0;
    const bool isDielectric = all([](const UsedMaterial& u) { return u.material.metallic == 0; });
    if (isDielectric)
        flags |= AGAA_FACT_ONE_SPECULAR; // 0.04, the default
    else if (all([&](const UsedMaterial& u) { return u.material.metallic == 0 || isGrey(u.material); }) &&
             std::ranges::all_of(scene.vertices,
                                 [](const Vertex& v) { return v.color.r == v.color.g && v.color.g == v.color.b; }))
        flags |= AGAA_FACT_GREY_SPECULAR;
    if (all([](const UsedMaterial& u) { return u.material.metallic == 1 && u.material.metalRoughTexture < 0; }))
        flags |= AGAA_FACT_NO_DIFFUSE;
    if (all([&](const UsedMaterial& u) {
            return u.material.metalRoughTexture < 0 && u.material.normalTexture < 0 && // a normal map widens lobes
                   u.material.roughness == used[0].material.roughness;
        })) {
        flags |= AGAA_FACT_ONE_ROUGHNESS;
        facts.alpha2 = alpha2Of(used[0].material.roughness);
    }
    if (all([](const UsedMaterial& u) { return u.material.normalTexture < 0; }) &&
        std::ranges::all_of(scene.meshes, [&](const Mesh& mesh) { return isFlat(scene, mesh); }))
        flags |= AGAA_FACT_PLANE_NORMALS;
    if (all([](const UsedMaterial& u) { return !u.isMasked || u.material.alphaMode == AlphaMode::Mask; }))
        flags |= AGAA_FACT_NO_TRANSLUCENCY;
    else if (all([](const UsedMaterial& u) { return !u.isMasked || u.material.alphaMode == AlphaMode::Blend; }))
        flags |= AGAA_FACT_NO_CUTOUTS;
    return flags;
}

} // namespace

AgaaSceneFacts sceneFacts(const Scene& scene, const std::vector<Light>& lights) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    // Dielectrics reflect too, so every metallic-roughness material is specular. Ambient light is not a property of the
    // scene; the renderer drops it if the settings have none.
    facts.flags = AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT;
    const std::vector<UsedMaterial> used = usedMaterials(scene);
    for (const UsedMaterial& u : used) {
        const glm::vec3& emissive = u.material.emissive;
        if (emissive.r > 0 || emissive.g > 0 || emissive.b > 0)
            facts.flags |= AGAA_FACT_EMISSIVE;
        if (u.isMasked)
            facts.flags |= AGAA_FACT_ALPHA_MASKED;
    }
    facts.flags |= commonValues(scene, used, facts);
    if (std::ranges::all_of(lights, [](const Light& light) { return light.type == LightType::Directional; }))
        facts.flags |= AGAA_FACT_NO_LOCAL_LIGHTS;
    facts.maxLights = uint32_t(lights.size());
    facts.shadowMapCount = uint32_t(shadowedLights(lights).size());
    return facts;
}

std::vector<AgaaSceneFacts> switchedFacts(const AgaaSceneFacts& view) {
    constexpr uint64_t effects[] = {AGAA_FACT_SPECULAR, AGAA_FACT_EMISSIVE, AGAA_FACT_AMBIENT};
    std::vector<AgaaSceneFacts> list = {view};
    AgaaSceneFacts none = view;
    for (const uint64_t effect : effects) {
        none.flags &= ~effect;
        if (!(view.flags & effect))
            continue;
        list.push_back(view);
        list.back().flags &= ~effect;
    }
    none.shadowMapCount = 0;
    if (view.shadowMapCount) {
        list.push_back(view);
        list.back().shadowMapCount = 0;
    }
    list.push_back(none);
    return list;
}

} // namespace harness
