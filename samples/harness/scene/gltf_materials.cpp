#include "scene/gltf_document.h"
#include "scene/gltf_reader.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <tuple>

namespace harness {

namespace {

Wrap wrapOf(int mode) {
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::Clamp
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::Mirror
                                                           : Wrap::Repeat;
}

// Creates a texture for each image, wrap mode and colour space that materials use.
class TextureTable {
public:
    explicit TextureTable(GltfReader& reader) : reader_(reader) {}

    // Returns -1 if the material has no texture, or one whose only image has the format of an optional extension.
    int find(int index, bool srgb) {
        if (index < 0)
            return -1;
        const tinygltf::Texture& texture = reader_.at(reader_.model.textures, index, "textures");
        if (texture.source < 0)
            return -1;
        Wrap u = Wrap::Repeat, v = Wrap::Repeat;
        if (texture.sampler >= 0) {
            const auto& sampler = reader_.at(reader_.model.samplers, texture.sampler, "samplers");
            u = wrapOf(sampler.wrapS);
            v = wrapOf(sampler.wrapT);
        }
        const auto key = std::tuple(texture.source, u, v, srgb);
        const auto [entry, isNew] = known_.try_emplace(key, int(reader_.scene.textures.size()));
        if (isNew) {
            reader_.scene.textures.push_back(decode(texture.source));
            reader_.scene.textures.back().srgb = srgb;
            reader_.scene.textures.back().wrapU = u;
            reader_.scene.textures.back().wrapV = v;
        }
        return entry->second;
    }

private:
    // Returns the bytes of an image file.
    std::span<const unsigned char> encoded(const tinygltf::Image& image, const std::string& name) const {
        if (image.bufferView < 0) {
            if (image.image.empty() && !image.uri.starts_with("data:"))
                reader_.fail("the image file \"" + shortened(image.uri) + "\" is missing or empty");
            return image.image;
        }
        const auto& view = reader_.at(reader_.model.bufferViews, image.bufferView, "bufferViews");
        const std::vector<unsigned char>& bytes = reader_.at(reader_.model.buffers, view.buffer, "buffers").data;
        if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
            reader_.fail(name + " reaches beyond its buffer");
        return std::span(bytes).subspan(view.byteOffset, view.byteLength);
    }

    Texture decode(int index) const {
        const tinygltf::Image& source = reader_.at(reader_.model.images, index, "images");
        Texture out;
        out.name = shortened(!source.name.empty()  ? source.name
                             : !source.uri.empty() ? source.uri
                                                   : "image " + std::to_string(index));
        const std::string name = "the image \"" + out.name + "\"";
        const std::span<const unsigned char> bytes = encoded(source, name);
        tinygltf::Image image; // 4 channels
        std::string error, warning;
        if (bytes.size() > size_t(std::numeric_limits<int>::max()) ||
            !tinygltf::LoadImageData(&image, index, &error, &warning, 0, 0, bytes.data(), int(bytes.size()), nullptr))
            reader_.fail(name + " could not be decoded");
        out.width = uint32_t(image.width);
        out.height = uint32_t(image.height);
        const size_t step = image.bits == 16 ? 2 : 1; // the high byte of little-endian shorts
        out.rgba.resize(size_t(out.width) * out.height * 4);
        for (size_t i = 0; i < out.rgba.size(); ++i)
            out.rgba[i] = image.image[i * step + step - 1];
        return out;
    }

    GltfReader& reader_;
    std::map<std::tuple<int, Wrap, Wrap, bool>, int> known_;
};

// Numbers in a file may exceed the range of float.
float finiteFloat(double value) { return float(std::clamp(value, -1e15, 1e15)); }

// Emission that half floats cannot hold keeps its hue: its largest channel becomes their maximum.
glm::vec3 scaledEmission(const glm::vec3& factor, float strength) {
    constexpr double brightest = 65504;
    const glm::dvec3 emission = glm::dvec3(factor) * double(strength);
    const double largest = std::max({emission.r, emission.g, emission.b});
    return glm::vec3(largest > brightest ? emission * (brightest / largest) : emission);
}

Material materialOf(const tinygltf::Material& source) {
    Material material;
    material.name = source.name;
    const auto& pbr = source.pbrMetallicRoughness;
    for (int i = 0; i < 4 && size_t(i) < pbr.baseColorFactor.size(); ++i)
        material.baseColor[i] = float(pbr.baseColorFactor[size_t(i)]);
    material.metallic = float(pbr.metallicFactor);
    material.roughness = float(pbr.roughnessFactor);
    for (int i = 0; i < 3 && size_t(i) < source.emissiveFactor.size(); ++i)
        material.emissive[i] = finiteFloat(source.emissiveFactor[size_t(i)]);
    float emissiveStrength = 1;
    const auto strength = source.extensions.find("KHR_materials_emissive_strength");
    if (strength != source.extensions.end() && strength->second.Has("emissiveStrength"))
        emissiveStrength = finiteFloat(strength->second.Get("emissiveStrength").GetNumberAsDouble());
    material.emissive = scaledEmission(material.emissive, emissiveStrength);
    material.alphaMode = source.alphaMode == "MASK"    ? AlphaMode::Mask
                         : source.alphaMode == "BLEND" ? AlphaMode::Blend
                                                       : AlphaMode::Opaque;
    material.alphaCutoff = float(source.alphaCutoff);
    if (material.alphaMode == AlphaMode::Mask && material.alphaCutoff <= 0)
        material.alphaMode = AlphaMode::Opaque; // every alpha passes
    material.doubleSided = source.doubleSided;
    material.normalScale = float(source.normalTexture.scale);
    return material;
}

void readTextures(Material& material, const tinygltf::Material& source, TextureTable& textures) {
    const auto& pbr = source.pbrMetallicRoughness;
    material.baseColorTexture = textures.find(pbr.baseColorTexture.index, true);
    material.normalTexture = textures.find(source.normalTexture.index, false);
    material.metalRoughTexture = textures.find(pbr.metallicRoughnessTexture.index, false);
    material.emissiveTexture = textures.find(source.emissiveTexture.index, true);
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
        if (used.contains(i))
            readTextures(reader.scene.materials.back(), reader.model.materials[i], textures);
    }
    Material plain; // material of primitives without one
    plain.name = "default";
    plain.metallic = 1;
    reader.scene.materials.push_back(plain);
}

} // namespace harness
