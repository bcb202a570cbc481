#include "render/fetch_scene.h"

#include "embedded.h"

#include <algorithm>

namespace harness {

namespace {

// Bits of a sampler code for wrap modes and filters other than those of the arrays' sampler, as in fetch.glsl.
constexpr uint32_t ownSampling = 0xF00F;

// Kinds of textures of a material: base colour, normal, metallic-roughness, emissive.
bool isColor(size_t i) { return i == 0 || i == 3; }

uint32_t samplerCode(const Texture& texture, const TextureLayer& at) {
    const auto wrap = [](Wrap w) { return w == Wrap::Repeat ? 0u : w == Wrap::Mirror ? 1u : 2u; };
    const uint32_t code = wrap(texture.wrapU) | wrap(texture.wrapV) << 2 | at.repeatsU << 4 | at.repeatsV << 8;
    const TextureFilters& f = texture.filters;
    const uint32_t mips = f.mips == MipFilter::Linear ? 0u : f.mips == MipFilter::Nearest ? 1u : 2u;
    return code | uint32_t(f.magnify == Filter::Nearest) << 12 | uint32_t(f.minify == Filter::Nearest) << 13 |
           mips << 14;
}

} // namespace

FetchScene makeFetchScene(const Scene& scene) {
    FetchScene fetch;
    std::vector<Material> materials = scene.materials;
    materials.emplace_back();
    std::set<int> colors, values;
    for (const Material& material : materials) {
        const auto textures = materialTextures(scene, material);
        for (size_t i = 0; i < textures.size(); ++i)
            if (textures[i] >= 0)
                (isColor(i) ? colors : values).insert(textures[i]);
    }
    const std::vector<MipOptions> options = mipOptions(scene);
    fetch.colors = makeTextureArrays(scene, colors, options);
    fetch.values = makeTextureArrays(scene, values, options);
    for (const Material& material : materials) {
        const auto textures = materialTextures(scene, material);
        FetchMaterial made{materialConstants(material), {}, {}};
        for (size_t i = 0; i < textures.size(); ++i) {
            const TextureLayer at = (isColor(i) ? fetch.colors : fetch.values).layerOf(textures[i]);
            made.layers[int(i)] = at.layer;
            made.samplers[int(i)] = textures[i] >= 0 ? samplerCode(scene.textures[size_t(textures[i])], at) : 0;
        }
        fetch.materials.push_back(made);
    }
    for (const Vertex& v : scene.vertices)
        fetch.vertices.push_back({v.position,
                                  glm::u8vec4(glm::u8vec3(v.color), (v.color.a & 0xFE) | (v.tangent.w < 0 ? 0 : 1)),
                                  v.normal, v.uv.x, glm::vec3(v.tangent), v.uv.y});
    if (fetch.vertices.empty())
        fetch.vertices.push_back({});
    fetch.maxDraws = std::max<uint32_t>(uint32_t(scene.instances.size()), 1);
    for (const Mesh& mesh : scene.meshes)
        fetch.maxPrimitives = std::max(fetch.maxPrimitives, mesh.indexCount / 3);
    uint64_t triangles = 1;
    for (const Instance& instance : scene.instances)
        triangles += scene.meshes[instance.mesh].indexCount / 3;
    fetch.maxTriangles = uint32_t(std::min<uint64_t>(triangles, INT32_MAX));
    return fetch;
}

std::vector<FetchDraw> fetchDraws(const Scene& scene, const std::vector<Draw>& draws) {
    std::vector<FetchDraw> out;
    for (const Draw& draw : draws) {
        const Mesh& mesh = scene.meshes[draw.mesh];
        const DrawConstants c = drawConstants(scene, draw, uint32_t(out.size()));
        const Variant variant = variantOf(scene, draw);
        const uint32_t material = std::min(mesh.material, uint32_t(scene.materials.size()));
        const bool isTested = variant.features >> materialTextureCount & 1;
        const uint32_t flags = uint32_t(variant.isDoubleSided) | uint32_t(draw.isMasked) << 1 |
                               uint32_t(draw.alphaPoints > 4 && isTested) << 2 | uint32_t(isTested) << 3;
        out.push_back({c.toShading, c.normalToShading, c.firstIndex, c.firstVertex, material, c.handedness,
                       mesh.indexCount / 3, flags, c.seed, isTested ? scene.materials[material].alphaCutoff : 0});
    }
    out.resize(std::max(scene.instances.size(), size_t(1))); // instances outside of the view have no primitives
    return out;
}

std::string fetchGlsl(const FetchScene& fetch, bool openGl) {
    int large = 0, small = 0; // bit i: textures of kind i are in these arrays
    for (const FetchMaterial& material : fetch.materials)
        for (int i = 0; i < 4; ++i)
            if (material.layers[i] >= 0)
                (material.layers[i] >= firstSmallLayer ? small : large) |= 1 << i;
    const bool own = std::ranges::any_of(fetch.materials, [](const FetchMaterial& m) {
        return ((m.samplers.x | m.samplers.y | m.samplers.z | m.samplers.w) & ownSampling) != 0;
    });
    std::string defines = openGl ? "#define HARNESS_GL\n" : "";
    defines += "#define FETCH_FIRST_SMALL " + std::to_string(firstSmallLayer) + "\n";
    defines += "#define FETCH_OWN_SAMPLING " + std::to_string(int(own)) + "\n";
    defines += "#define FETCH_LARGE " + std::to_string(large) + "\n";
    defines += "#define FETCH_SMALL " + std::to_string(small) + "\n";
    return defines + embedded::interface_glsl + embedded::material_glsl + embedded::fetch_glsl;
}

} // namespace harness
