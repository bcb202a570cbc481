// Meshes of a glTF file in the shapes and poses in which its nodes show them.
#pragma once

#include "scene/gltf_reader.h"

#include <map>
#include <tuple>

namespace harness {

struct PlacedMesh {
    uint32_t mesh;        // index into Scene::meshes
    glm::dvec3 origin{0}; // of the vertices, in the space of the node, or in the world if the mesh is skinned
    bool isSkinned = false;
};

// Creates one Mesh for each primitive, morph weights and skin of the nodes that ask for it.
class MeshTable {
public:
    explicit MeshTable(GltfReader& reader) : reader_(reader) {}

    const std::vector<PlacedMesh>& find(const tinygltf::Node& node);

private:
    GltfReader& reader_;
    std::map<std::tuple<int, std::vector<double>, int>, std::vector<PlacedMesh>> known_;
};

// The shape and pose of a mesh.
struct MeshPose {
    std::vector<double> weights;    // of the morph targets
    std::vector<glm::dmat4> joints; // empty: not skinned
};

// Appends a primitive to the scene.
PlacedMesh readPrimitive(GltfReader& reader, const tinygltf::Primitive& primitive, const MeshPose& pose);

} // namespace harness
