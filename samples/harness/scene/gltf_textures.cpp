#include "scene/gltf_textures.h"

#include "scene/gltf_document.h"

#include <cmath>
#include <limits>

namespace harness {

namespace {

Wrap wrapOf(int mode) {
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::Clamp
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::Mirror
                                                           : Wrap::Repeat;
}

// Unknown numbers and absent filters are linear.
TextureFilters filtersOf(const tinygltf::Sampler& sampler) {
    TextureFilters filters;
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
        filters.magnify = Filter::Nearest;
    switch (sampler.minFilter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
        filters.minify = Filter::Nearest;
        [[fallthrough]];
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
        filters.mips = MipFilter::None;
        break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        filters.minify = Filter::Nearest;
        [[fallthrough]];
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
        filters.mips = MipFilter::Nearest;
        break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        filters.minify = Filter::Nearest;
        break;
    default:
        break;
    }
    return filters;
}

glm::dvec2 pairOf(const tinygltf::Value& value, const char* name, const glm::dvec2& initial) {
    const tinygltf::Value& list = value.Get(name);
    if (!list.IsArray() || list.ArrayLen() != 2 || !list.Get(0).IsNumber() || !list.Get(1).IsNumber())
        return initial;
    return {finiteFloat(list.Get(0).GetNumberAsDouble()), finiteFloat(list.Get(1).GetNumberAsDouble())};
}

} // namespace

glm::vec2 TextureCoordinates::of(const glm::dvec2& uv) const {
    const glm::dvec2 scaled = scale * uv;
    const double c = std::cos(rotation), s = std::sin(rotation);
    // Positive angles turn counter-clockwise where v grows downwards.
    const glm::dvec2 moved = offset + glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
    return {finiteFloat(moved.x), finiteFloat(moved.y)};
}

TextureCoordinates coordinatesOf(const GltfReader& reader, int set, const tinygltf::ExtensionMap& extensions) {
    TextureCoordinates coordinates;
    coordinates.set = set;
    if (const auto found = extensions.find("KHR_texture_transform"); found != extensions.end()) {
        const tinygltf::Value& transform = found->second;
        coordinates.offset = pairOf(transform, "offset", coordinates.offset);
        coordinates.scale = pairOf(transform, "scale", coordinates.scale);
        if (transform.Get("rotation").IsNumber())
            coordinates.rotation = finiteFloat(transform.Get("rotation").GetNumberAsDouble());
        if (transform.Get("texCoord").IsInt())
            coordinates.set = transform.Get("texCoord").GetNumberAsInt();
    }
    if (coordinates.set < 0)
        reader.fail("a texture names a negative set of texture coordinates");
    return coordinates;
}

int TextureTable::find(int index, bool srgb) {
    if (index < 0)
        return -1;
    const tinygltf::Texture& texture = reader_.at(reader_.model.textures, index, "textures");
    if (texture.source < 0) {
        reader_.drop("textures without an image of a supported format are white");
        return -1;
    }
    Wrap u = Wrap::Repeat, v = Wrap::Repeat;
    TextureFilters filters;
    if (texture.sampler >= 0) {
        const auto& sampler = reader_.at(reader_.model.samplers, texture.sampler, "samplers");
        u = wrapOf(sampler.wrapS);
        v = wrapOf(sampler.wrapT);
        filters = filtersOf(sampler);
    }
    const auto key = std::tuple(texture.source, u, v, filters, srgb);
    const auto [entry, isNew] = known_.try_emplace(key, int(reader_.scene.textures.size()));
    if (isNew) {
        Texture made = decode(texture.source);
        made.srgb = srgb;
        made.wrapU = u;
        made.wrapV = v;
        made.filters = filters;
        reader_.scene.textures.push_back(std::move(made));
    }
    return entry->second;
}

// Returns the bytes of an image file.
std::span<const unsigned char> TextureTable::encoded(const tinygltf::Image& image, const std::string& name) const {
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

Texture TextureTable::decode(int index) const {
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

} // namespace harness
