#include "scene/builtin.h"

#include "scene/builtin/scenes.h"

#include <charconv>

namespace harness {

namespace {

constexpr std::string_view bladesName = "blades-";

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

namespace {

Scene finished(Scene scene, std::string_view name, std::string_view stresses) {
    scene.name = std::string(name);
    scene.stresses = std::string(stresses);
    updateBounds(scene);
    return scene;
}

// Returns N of "blades-N", [0, 100000]; empty for other names.
std::optional<uint32_t> bladesOf(std::string_view name) {
    if (!name.starts_with(bladesName))
        return std::nullopt;
    name.remove_prefix(bladesName.size());
    uint32_t count = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), count);
    if (error != std::errc() || end != name.data() + name.size() || count > 100000)
        return std::nullopt;
    return count;
}

} // namespace

std::optional<Scene> makeBuiltinScene(std::string_view name) {
    for (const Entry& entry : kEntries)
        if (entry.description.name == name)
            return finished(entry.make(), name, entry.description.stresses);
    if (const std::optional<uint32_t> count = bladesOf(name))
        return finished(builtin::makeBlades(*count), name,
                        "Blades of grass behind a railing, as many as the name says.");
    return std::nullopt;
}

} // namespace harness
