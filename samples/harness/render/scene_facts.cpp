#include "render/draw_list.h"
#include "render/lights.h"
#include "render/renderer.h"

namespace harness {

AgaaSceneFacts sceneFacts(const Scene& scene, const std::vector<Light>& lights) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    // Dielectrics reflect too, so every metallic-roughness material is specular. Ambient light is
    // no property of the scene; the renderer drops it where the settings have none.
    facts.flags = AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes.at(instance.mesh);
        if (mesh.material >= scene.materials.size())
            continue;
        const glm::vec3& emissive = scene.materials[mesh.material].emissive;
        if (emissive.r > 0 || emissive.g > 0 || emissive.b > 0)
            facts.flags |= AGAA_FACT_EMISSIVE;
        if (isMasked(scene, mesh))
            facts.flags |= AGAA_FACT_ALPHA_MASKED;
    }
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
