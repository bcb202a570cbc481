#include "scene/builtin.h"

#include "scene/builtin/scenes.h"
#include "scene/hard/scenes.h"

#include <charconv>
#include <span>

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

const Entry kHardEntries[] = {
    {{"hard-mirror", "A mirror and a polished plane in many triangles per pixel."}, hard::makeMirror},
    {{"hard-mirror-whole", "The planes of hard-mirror in two triangles each."}, hard::makeWholeMirror},
    {{"hard-opposite-normals", "Columns of a quarter of a pixel whose normals cancel."}, hard::makeOppositeNormals},
    {{"hard-needles", "Ellipsoids seen along their axes, with all normals of a half sphere in a pixel."},
     hard::makeNeedles},
    {{"hard-duplicates", "Slanted cards and blades, each drawn twice in one place."}, hard::makeDuplicates},
    {{"hard-duplicates-once", "The cards and blades of hard-duplicates, drawn once."}, hard::makeSingles},
    {{"hard-primitives", "Cells of a sixth of a pixel, each of its own colour and normal."},
     hard::makePrimitivePerSample},
    {{"hard-specks", "Glowing squares of a sixth of a pixel, which cover a sample or none."}, hard::makeSpecks},
    {{"hard-sweep", "Ridges and steps whose angles and heights pass all thresholds."}, hard::makeSweep},
    {{"hard-far-wall", "A wall at 10 km beside a fence at 10 cm."}, hard::makeFarWall},
    {{"hard-railings", "Metal bars of a third of a pixel before tiles, with a shadow."}, hard::makeRailings},
    {{"hard-hair", "Hair of an eighth of a pixel."}, hard::makeHair},
    {{"hard-cut-outs", "A thousand layers of cut-outs."}, hard::makeCutouts},
    {{"hard-light-on-surface", "Lamps less than a pixel above a floor."}, hard::makeLightOnSurface},
    {{"hard-light-in-surface", "Lamps in a floor, and in walls and slopes that cross it."}, hard::makeLightInSurface},
    {{"hard-light-inside", "Lamps with shadows inside closed shapes."}, hard::makeLightInside},
    {{"hard-light-radius-0", "Lamps without radius in and above a floor."}, hard::makeLightWithoutRadius},
    {{"hard-spots", "Spot lights with equal inner and outer cones."}, hard::makeSpots},
    {{"hard-checker", "A checker of pixels, green in the light and red in the shadow."}, hard::makeChecker},
    {{"hard-dark-ramp", "A ramp of albedo from 1/16 of 1/255 to 1/255."}, hard::makeDarkRamp},
    {{"hard-emission", "Bars that emit 65504 and more."}, hard::makeEmission},
    {{"hard-hdr-edges", "Slanted bars that emit 1, 10 and 100."}, hard::makeHdrEdges},
    {{"hard-stripes", "Coloured strips, for images of extreme sizes."}, hard::makeStripes},
    {{"hard-empty", "No geometry."}, hard::makeEmpty},
};

std::vector<BuiltinScene> descriptionsOf(std::span<const Entry> entries) {
    std::vector<BuiltinScene> list;
    for (const Entry& entry : entries)
        list.push_back(entry.description);
    return list;
}

} // namespace

const std::vector<BuiltinScene>& builtinScenes() {
    static const std::vector<BuiltinScene> scenes = descriptionsOf(kEntries);
    return scenes;
}

const std::vector<BuiltinScene>& hardScenes() {
    static const std::vector<BuiltinScene> scenes = descriptionsOf(kHardEntries);
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
    for (const std::span<const Entry> entries :
         {std::span<const Entry>(kEntries), std::span<const Entry>(kHardEntries)})
        for (const Entry& entry : entries)
            if (entry.description.name == name)
                return finished(entry.make(), name, entry.description.stresses);
    if (const std::optional<uint32_t> count = bladesOf(name))
        return finished(builtin::makeBlades(*count), name,
                        "Blades of grass behind a railing, as many as the name says.");
    return std::nullopt;
}

} // namespace harness
