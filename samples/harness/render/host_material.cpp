#include "render/host_material.h"

#include <algorithm>
#include <stdexcept>

namespace harness {

int classOf(const Material& material) { return material.hasClearCoat ? 1 : 0; }

bool hasClasses(const Scene& scene) {
    return std::ranges::any_of(scene.materials, [](const Material& material) { return classOf(material) != 0; });
}

MaterialConstants materialConstants(const Material& material) {
    MaterialConstants c;
    c.baseColor = material.baseColor;
    c.emissive = material.emissive;
    c.metallic = material.metallic;
    c.roughness = material.roughness;
    c.normalScale = material.normalScale;
    c.alphaCutoff = material.alphaMode == AlphaMode::Mask ? material.alphaCutoff : -1;
    c.materialClass = float(classOf(material));
    return c;
}

std::array<int, materialTextureCount> materialTextures(const Scene& scene, const Material& material) {
    std::array<int, materialTextureCount> textures = {material.baseColorTexture, material.normalTexture,
                                                      material.metalRoughTexture, material.emissiveTexture};
    for (int& texture : textures)
        texture = texture < int(scene.textures.size()) ? texture : -1;
    return textures;
}

uint32_t materialFeatures(const Scene& scene, uint32_t material) {
    if (material >= scene.materials.size())
        return 0;
    const Material& m = scene.materials[material];
    const auto textures = materialTextures(scene, m);
    uint32_t features = m.alphaMode == AlphaMode::Mask ? 1u << materialTextureCount : 0;
    for (size_t i = 0; i < textures.size(); ++i)
        features |= textures[i] >= 0 ? 1u << i : 0u;
    return features;
}

void checkMeshes(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        if (uint64_t(mesh.firstIndex) + mesh.indexCount > scene.indices.size() ||
            uint64_t(mesh.firstVertex) + mesh.vertexCount > scene.vertices.size())
            throw std::runtime_error("A mesh of the scene \"" + scene.name +
                                     "\" reaches beyond its vertices or indices.");
    }
}

void checkTextureSizes(const Scene& scene, uint32_t most) {
    const auto text = [](uint32_t n) { return std::to_string(n); };
    for (const Texture& texture : scene.textures)
        if (std::max(texture.width, texture.height) > most)
            throw std::runtime_error("The texture \"" + texture.name + "\" of the scene \"" + scene.name + "\" has " +
                                     text(texture.width) + "x" + text(texture.height) + " texels; the device allows " +
                                     text(most) + "x" + text(most) + ".");
}

std::vector<MotionRows> motionRows(const std::vector<Draw>& draws) {
    std::vector<MotionRows> list;
    for (const Draw& draw : draws) {
        MotionRows& rows = list.emplace_back();
        for (int column = 0; draw.toPreviousClip && column < 4; ++column) {
            const glm::dvec4& c = (*draw.toPreviousClip)[column];
            rows[0][column] = float(c.x);
            rows[1][column] = float(c.y);
            rows[2][column] = float(c.w);
        }
    }
    return list;
}

DrawConstants drawConstants(const Scene& scene, const Draw& draw, uint32_t index) {
    DrawConstants c{};
    const glm::dmat3 linear(draw.toShading);
    // Cofactors give the inverse transpose, also for flattened objects.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double sign = draw.isMirrored ? -1 : 1;
    // The shader normalises normals. The scale here only keeps them within the range of float.
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, glm::length(cofactors[i]));
    const double scale = largest > 0 ? sign / largest : sign;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            c.toShading[size_t(row)][column] = float(draw.toShading[column][row]);
        for (int column = 0; column < 3; ++column)
            c.normalToShading[size_t(row)][column] = float(cofactors[column][row] * scale);
    }
    c.seed = drawSeed(draw.instance);
    c.handedness = draw.isMirrored ? -1.0f : 1.0f;
    c.index = draw.isFetched ? index : UINT32_MAX; // AGAA_UNFETCHED
    c.firstIndex = scene.meshes[draw.mesh].firstIndex;
    c.firstVertex = scene.meshes[draw.mesh].firstVertex;
    return c;
}

Variant variantOf(const Scene& scene, const Draw& draw) {
    Variant variant;
    variant.isMasked = draw.isMasked;
    variant.isMirrored = draw.isMirrored;
    variant.motion = draw.motionOutput;
    const uint32_t material = scene.meshes[draw.mesh].material;
    variant.features = materialFeatures(scene, material);
    const uint32_t tested = 1u << materialTextureCount;
    if (draw.alphaPoints > 1 && (variant.features & tested))
        variant.features |= tested << 1;
    if (draw.alphaPoints > 4 && (variant.features & tested))
        variant.features |= tested << 2;
    variant.isDoubleSided = material < scene.materials.size() && scene.materials[material].doubleSided;
    return variant;
}

} // namespace harness
