// Features of glTF files that the loader does not have. docs/sample-engine.md lists them.
#include "scene/gltf_document.h"
#include "scene/gltf_reader.h"

namespace harness {

void GltfReader::drop(const std::string& what) const {
    const std::string sentence = file + ": " + what + ".";
    if (std::find(scene.dropped.begin(), scene.dropped.end(), sentence) == scene.dropped.end())
        scene.dropped.push_back(sentence);
}

namespace {

void dropOfPrimitive(const GltfReader& reader, const tinygltf::Primitive& primitive) {
    const bool isOfPoints = primitive.mode == TINYGLTF_MODE_POINTS;
    const bool isOfLines = primitive.mode == TINYGLTF_MODE_LINE || primitive.mode == TINYGLTF_MODE_LINE_LOOP ||
                           primitive.mode == TINYGLTF_MODE_LINE_STRIP;
    if (isOfPoints)
        reader.drop("points are not drawn");
    if (isOfLines)
        reader.drop("lines are not drawn");
    if (primitive.attributes.contains("JOINTS_1"))
        reader.drop("vertices follow four joints only");
    if (primitive.attributes.contains("COLOR_1"))
        reader.drop("the second set of vertex colours is ignored");
    for (const auto& target : primitive.targets)
        for (const auto& [name, accessor] : target)
            if (name.starts_with("TEXCOORD_") || name.starts_with("COLOR_"))
                reader.drop("morph targets change positions, normals and tangents only");
}

} // namespace

void dropUnsupportedFeatures(const GltfReader& reader) {
    for (const std::string& name : reader.model.extensionsUsed)
        if (std::find(knownExtensions.begin(), knownExtensions.end(), name) == knownExtensions.end())
            reader.drop("the optional extension " + shortened(name) + " is ignored");
    for (const tinygltf::Mesh& mesh : reader.model.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            dropOfPrimitive(reader, primitive);
    for (const tinygltf::Material& material : reader.model.materials)
        if (material.occlusionTexture.index >= 0)
            reader.drop("occlusion textures are ignored");
    if (!reader.model.animations.empty())
        reader.drop("animations are not played");
}

} // namespace harness
