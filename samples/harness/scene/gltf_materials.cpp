#include "scene/gltf_textures.h"

#include <set>

namespace harness {

namespace {

// Emission that half floats cannot hold keeps its hue: its largest channel becomes their maximum.
glm::vec3 scaledEmission(const glm::vec3& factor, float strength) {
    constexpr double brightest = 65504;
    const glm::dvec3 emission = glm::dvec3(factor) * double(strength);
    const double largest = std::max({emission.r, emission.g, emission.b});
    return glm::vec3(largest > brightest ? emission * (brightest / largest) : emission);
}

float share(double factor) { return float(std::clamp(factor, 0.0, 1.0)); }

Material materialOf(const tinygltf::Material& source) {
    Material material;
    material.name = source.name;
    const auto& pbr = source.pbrMetallicRoughness;
    for (int i = 0; i < 4 && size_t(i) < pbr.baseColorFactor.size(); ++i)
        material.baseColor[i] = share(pbr.baseColorFactor[size_t(i)]);
    material.metallic = share(pbr.metallicFactor);
    material.roughness = share(pbr.roughnessFactor);
    for (int i = 0; i < 3 && size_t(i) < source.emissiveFactor.size(); ++i)
        material.emissive[i] = std::max(finiteFloat(source.emissiveFactor[size_t(i)]), 0.0f);
    float emissiveStrength = 1;
    const auto strength = source.extensions.find("KHR_materials_emissive_strength");
    if (strength != source.extensions.end() && strength->second.Has("emissiveStrength"))
        emissiveStrength = std::max(finiteFloat(strength->second.Get("emissiveStrength").GetNumberAsDouble()), 0.0f);
    material.emissive = scaledEmission(material.emissive, emissiveStrength);
    const auto coat = source.extensions.find("KHR_materials_clearcoat");
    if (coat != source.extensions.end() && coat->second.Has("clearcoatFactor"))
        material.hasClearCoat = coat->second.Get("clearcoatFactor").GetNumberAsDouble() >= 0.5;
    material.alphaMode = source.alphaMode == "MASK"    ? AlphaMode::Mask
                         : source.alphaMode == "BLEND" ? AlphaMode::Blend
                                                       : AlphaMode::Opaque;
    material.alphaCutoff = finiteFloat(source.alphaCutoff);
    if (material.alphaMode == AlphaMode::Mask && material.alphaCutoff <= 0)
        material.alphaMode = AlphaMode::Opaque; // every alpha passes
    material.doubleSided = source.doubleSided;
    material.normalScale = finiteFloat(source.normalTexture.scale);
    return material;
}

// Sets the textures. Vertices have one pair of texture coordinates, that of the first texture.
TextureCoordinates readTextures(const GltfReader& reader, const tinygltf::Material& source, TextureTable& textures,
                                Material& material) {
    std::optional<TextureCoordinates> first;
    const auto find = [&](const auto& info, bool srgb) {
        const int texture = textures.find(info.index, srgb);
        if (texture < 0)
            return texture;
        const TextureCoordinates coordinates = coordinatesOf(reader, info.texCoord, info.extensions);
        if (!first)
            first = coordinates;
        else if (!(*first == coordinates))
            reader.drop("all textures of a material use the coordinates of its first texture");
        return texture;
    };
    const auto& pbr = source.pbrMetallicRoughness;
    material.baseColorTexture = find(pbr.baseColorTexture, true);
    material.normalTexture = find(source.normalTexture, false);
    material.metalRoughTexture = find(pbr.metallicRoughnessTexture, false);
    material.emissiveTexture = find(source.emissiveTexture, true);
    return first.value_or(TextureCoordinates{});
}

// Returns the materials of all primitives. A file may hold materials for other programs.
std::set<size_t> usedMaterials(const tinygltf::Model& model) {
    std::set<size_t> used;
    for (const tinygltf::Mesh& mesh : model.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (primitive.material >= 0)
                used.insert(size_t(primitive.material));
    return used;
}

} // namespace

void readMaterials(GltfReader& reader) {
    TextureTable textures(reader);
    const std::set<size_t> used = usedMaterials(reader.model);
    for (size_t i = 0; i < reader.model.materials.size(); ++i) {
        reader.scene.materials.push_back(materialOf(reader.model.materials[i]));
        reader.coordinates.emplace_back();
        if (used.contains(i))
            reader.coordinates[i] =
                readTextures(reader, reader.model.materials[i], textures, reader.scene.materials[i]);
    }
    Material plain; // material of primitives without one
    plain.name = "default";
    plain.metallic = 1;
    reader.scene.materials.push_back(plain);
    reader.coordinates.emplace_back();
}

} // namespace harness
