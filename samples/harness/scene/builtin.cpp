#include "scene/builtin.h"

#include "scene/builtin/scenes.h"

namespace harness {

namespace {

struct Entry {
    BuiltinScene description;
    Scene (*make)();
};

const Entry kEntries[] = {
    {{"bamboo", "Glossy stalks and narrow leaves thinner than a pixel, with specular highlights "
                "that flicker in every lower-rate method."},
     builtin::makeBamboo},
    {{"foliage", "Alpha-masked leaf cards with soft edges over geometric grass: coverage from "
                 "textures and from triangles in the same pixel."},
     builtin::makeFoliage},
    {{"furball", "Tens of thousands of sub-pixel hairs: many surfaces and normals in every pixel."},
     builtin::makeFurball},
    {{"metal", "Tangled thin polished metal tubes: strong curvature, narrow highlights and several "
               "metals in a pixel."},
     builtin::makeMetal},
    {{"city", "A street of bars, wires, flutes and normal-mapped brick: regular thin structures "
              "from near to far, where missing samples show as moire."},
     builtin::makeCity},
};

} // namespace

const std::vector<BuiltinScene>& builtinScenes() {
    static const std::vector<BuiltinScene> scenes = [] {
        std::vector<BuiltinScene> list;
        for (const Entry& entry : kEntries)
            list.push_back(entry.description);
        return list;
    }();
    return scenes;
}

std::optional<Scene> makeBuiltinScene(std::string_view name) {
    for (const Entry& entry : kEntries)
        if (entry.description.name == name) {
            Scene scene = entry.make();
            scene.name = std::string(entry.description.name);
            scene.stresses = std::string(entry.description.stresses);
            updateBounds(scene);
            return scene;
        }
    return std::nullopt;
}

} // namespace harness
