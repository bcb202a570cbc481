#include "render/fetch_scene.h"

#include "embedded.h"

#include <algorithm>
#include <bit>
#include <map>

namespace harness {

namespace {

constexpr uint32_t largestLayer = 1024;

uint32_t layerSide(uint32_t size) { return std::min(std::bit_ceil(size), largestLayer); }

// Textures of one colour space, each once.
class Layers {
public:
    explicit Layers(const Scene& scene) : scene_(scene) {}

    // The layer of a texture, or -1 of none.
    int add(int texture) {
        if (texture < 0)
            return -1;
        const auto [place, isNew] = layers_.try_emplace(texture, int(order_.size()));
        if (isNew)
            order_.push_back(texture);
        return place->second;
    }

    TextureLayers make(const std::vector<MipOptions>& options) const {
        uint32_t width = 1, height = 1;
        for (const int texture : order_) {
            width = std::max(width, layerSide(scene_.textures[size_t(texture)].width));
            height = std::max(height, layerSide(scene_.textures[size_t(texture)].height));
        }
        TextureLayers made;
        for (const int texture : order_) {
            const Texture& source = scene_.textures[size_t(texture)];
            made.push_back(resizeMipChain(makeMipChain(source, options[size_t(texture)]), source.srgb, width, height));
        }
        if (made.empty())
            made.push_back({{1, 1, {255, 255, 255, 255}}});
        return made;
    }

private:
    const Scene& scene_;
    std::map<int, int> layers_;
    std::vector<int> order_;
};

uint32_t wrapCode(const Texture& texture) {
    const auto code = [](Wrap wrap) { return wrap == Wrap::Repeat ? 0u : wrap == Wrap::Mirror ? 1u : 2u; };
    return code(texture.wrapU) | code(texture.wrapV) << 2;
}

} // namespace

FetchScene makeFetchScene(const Scene& scene) {
    FetchScene fetch;
    Layers colors(scene), values(scene);
    std::vector<Material> materials = scene.materials;
    materials.emplace_back();
    for (const Material& material : materials) {
        const auto textures = materialTextures(scene, material); // base colour, normal, metallic-roughness, emissive
        FetchMaterial made{materialConstants(material), {}, {}};
        for (int i = 0; i < int(textures.size()); ++i) {
            const bool isColor = i == 0 || i == 3;
            made.layers[i] = (isColor ? colors : values).add(textures[size_t(i)]);
            made.wraps[i] = textures[size_t(i)] >= 0 ? wrapCode(scene.textures[size_t(textures[size_t(i)])]) : 0;
        }
        fetch.materials.push_back(made);
    }
    for (const Vertex& v : scene.vertices)
        fetch.vertices.push_back({v.position, glm::u8vec4(glm::u8vec3(v.color), v.tangent.w < 0 ? 0 : 255), v.normal, v.uv.x,
                                  glm::vec3(v.tangent), v.uv.y});
    if (fetch.vertices.empty())
        fetch.vertices.push_back({});
    const std::vector<MipOptions> options = mipOptions(scene);
    fetch.colors = colors.make(options);
    fetch.values = values.make(options);
    fetch.maxDraws = std::max<uint32_t>(uint32_t(scene.instances.size()), 1);
    for (const Mesh& mesh : scene.meshes)
        fetch.maxPrimitives = std::max(fetch.maxPrimitives, mesh.indexCount / 3);
    return fetch;
}

std::vector<FetchDraw> fetchDraws(const Scene& scene, const std::vector<Draw>& draws) {
    std::vector<FetchDraw> out;
    for (const Draw& draw : draws) {
        const Mesh& mesh = scene.meshes[draw.mesh];
        const DrawConstants c = drawConstants(draw, uint32_t(out.size()));
        out.push_back({c.toShading, c.normalToShading, mesh.firstIndex, mesh.firstVertex,
                       std::min(mesh.material, uint32_t(scene.materials.size())), c.handedness});
    }
    return out;
}

std::string fetchGlsl(bool openGl) {
    return std::string(openGl ? "#define HARNESS_GL\n" : "") + embedded::interface_glsl + embedded::material_glsl +
           embedded::fetch_glsl;
}

} // namespace harness
