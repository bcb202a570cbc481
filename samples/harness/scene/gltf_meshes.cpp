#include "scene/gltf_meshes.h"

#include "scene/gltf_accessor.h"

namespace harness {

std::vector<glm::dmat4> jointMatrices(const GltfReader& reader, int skin) {
    const tinygltf::Skin& source = reader.at(reader.model.skins, skin, "skins");
    std::vector<glm::dmat4> matrices;
    for (const int joint : source.joints) {
        const auto& transform = reader.at(reader.transforms, joint, "nodes");
        if (!transform)
            reader.drop("joints outside of the scene are at its origin");
        matrices.push_back(transform.value_or(glm::dmat4(1)));
    }
    if (source.inverseBindMatrices < 0)
        return matrices;
    const AccessorView inverse(reader, source.inverseBindMatrices);
    if (inverse.components() != 16 || inverse.count() < matrices.size())
        reader.fail("a skin has fewer matrices than joints");
    for (size_t i = 0; i < matrices.size(); ++i) {
        glm::dmat4 bind;
        for (int k = 0; k < 16; ++k)
            bind[k / 4][k % 4] = inverse.number(i, size_t(k));
        matrices[i] *= bind;
    }
    return matrices;
}

const std::vector<PlacedMesh>& MeshTable::find(const tinygltf::Node& node) {
    const tinygltf::Mesh& mesh = reader_.at(reader_.model.meshes, node.mesh, "meshes");
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    const auto [entry, isNew] = known_.try_emplace({node.mesh, weights, node.skin});
    if (!isNew)
        return entry->second;
    MeshPose pose{weights, {}};
    if (node.skin >= 0)
        pose.joints = jointMatrices(reader_, node.skin);
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
        const bool hasTriangles =
            primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
            primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN || primitive.mode == -1; // triangles by default
        if (hasTriangles && primitive.attributes.contains("POSITION"))
            entry->second.push_back(readPrimitive(reader_, primitive, pose));
    }
    return entry->second;
}

} // namespace harness
