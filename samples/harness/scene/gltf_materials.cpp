#include "scene/gltf_reader.h"

#include <algorithm>
#include <map>
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

    int find(int index, bool srgb) {
        if (index < 0)
            return -1;
        const tinygltf::Texture& texture = reader_.at(reader_.model.textures, index, "textures");
        Wrap u = Wrap::Repeat, v = Wrap::Repeat;
        if (texture.sampler >= 0) {
            const auto& sampler = reader_.at(reader_.model.samplers, texture.sampler, "samplers");
            u = wrapOf(sampler.wrapS);
            v = wrapOf(sampler.wrapT);
        }
        const auto key = std::tuple(texture.source, u, v, srgb);
        const auto [entry, isNew] = known_.try_emplace(key, int(reader_.scene.textures.size()));
        if (isNew)
            reader_.scene.textures.push_back(decode(texture.source, u, v, srgb));
        return entry->second;
    }

private:
    Texture decode(int source, Wrap u, Wrap v, bool srgb) const {
        const tinygltf::Image& image = reader_.at(reader_.model.images, source, "images");
        if (image.width <= 0 || image.height <= 0 || image.image.empty())
            reader_.fail("the image \"" + image.uri + image.name + "\" could not be decoded");
        Texture out;
        out.name = image.name.empty() ? image.uri : image.name;
        out.width = uint32_t(image.width);
        out.height = uint32_t(image.height);
        out.srgb = srgb;
        out.wrapU = u;
        out.wrapV = v;
        const size_t pixels = size_t(image.width) * size_t(image.height);
        const size_t channels = size_t(image.component);
        const size_t step = image.bits == 16 ? 2 : 1; // the high byte of little-endian shorts
        if (channels == 0 || image.image.size() < pixels * channels * step)
            reader_.fail("an image has fewer bytes than pixels");
        out.rgba.assign(pixels * 4, 255);
        for (size_t i = 0; i < pixels; ++i)
            for (size_t c = 0; c < 4; ++c) {
                const bool isGrey = channels < 3;
                const size_t from = isGrey ? (c < 3 ? 0 : 1) : c;
                if (from < channels)
                    out.rgba[4 * i + c] = image.image[(i * channels + from) * step + step - 1];
            }
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

Material materialOf(const tinygltf::Material& source, TextureTable& textures) {
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
    material.baseColorTexture = textures.find(pbr.baseColorTexture.index, true);
    material.normalTexture = textures.find(source.normalTexture.index, false);
    material.metalRoughTexture = textures.find(pbr.metallicRoughnessTexture.index, false);
    material.emissiveTexture = textures.find(source.emissiveTexture.index, true);
    return material;
}

} // namespace

void readMaterials(GltfReader& reader) {
    TextureTable textures(reader);
    for (const tinygltf::Material& material : reader.model.materials)
        reader.scene.materials.push_back(materialOf(material, textures));
    Material plain; // material of primitives without one
    plain.name = "default";
    plain.metallic = 1;
    reader.scene.materials.push_back(plain);
}

} // namespace harness
