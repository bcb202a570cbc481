// The vertices and triangles of a glTF primitive: morphed, skinned, with normals and tangents.
#include "scene/gltf_accessor.h"
#include "scene/gltf_meshes.h"
#include "scene/tangents.h"

#include <cmath>
#include <span>

namespace harness {

namespace {

int attribute(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

std::vector<uint32_t> triangleList(const GltfReader& reader, const tinygltf::Primitive& primitive, size_t vertexCount) {
    std::vector<uint32_t> source;
    if (primitive.indices >= 0) {
        const AccessorView view(reader, primitive.indices);
        if (view.components() != 1)
            reader.fail("indices are not scalars");
        source.resize(view.count());
        for (size_t i = 0; i < source.size(); ++i)
            source[i] = view.index(i);
    } else {
        source.resize(vertexCount);
        for (size_t i = 0; i < source.size(); ++i)
            source[i] = uint32_t(i);
    }
    for (uint32_t index : source)
        if (index >= vertexCount)
            reader.fail("an index reaches beyond the vertices");
    std::vector<uint32_t> list;
    const size_t n = source.size();
    switch (primitive.mode) {
    case TINYGLTF_MODE_TRIANGLE_STRIP:
        for (size_t i = 0; i + 2 < n; ++i) {
            list.push_back(source[i]);
            list.push_back(source[i + 1 + (i & 1)]);
            list.push_back(source[i + 2 - (i & 1)]);
        }
        break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
        for (size_t i = 1; i + 1 < n; ++i)
            list.insert(list.end(), {source[0], source[i], source[i + 1]});
        break;
    default:
        list.assign(source.begin(), source.begin() + std::ptrdiff_t(n / 3 * 3));
    }
    return list;
}

uint8_t byteOf(float value) { return uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

glm::dvec3 vectorOf(const AccessorView& view, size_t i) {
    return {view.number(i, 0), view.number(i, 1), view.number(i, 2)};
}

class PrimitiveReader {
public:
    PrimitiveReader(GltfReader& reader, const tinygltf::Primitive& primitive, const MeshPose& pose)
        : reader_(reader), primitive_(primitive), pose_(pose) {}

    std::vector<Vertex> vertices;
    std::vector<glm::dvec3> positions;
    bool hasNormals = false;
    bool hasTangents = false;
    bool isSkinned = false;

    void read(const TextureCoordinates& coordinates) {
        const AccessorView view(reader_, attribute(primitive_.attributes, "POSITION"));
        if (view.count() > mostVertices - reader_.scene.vertices.size())
            reader_.fail("it has more than " + std::to_string(mostVertices) + " vertices");
        vertices.resize(view.count());
        positions = vectors("POSITION");
        const std::vector<glm::dvec3> normals = vectors("NORMAL");
        hasNormals = !normals.empty();
        for (size_t i = 0; i < normals.size(); ++i)
            vertices[i].normal = normals[i];
        readCoordinates(coordinates);
        forEach(primitive_.attributes, "COLOR_0", 3, [&](const AccessorView& a, size_t i) {
            for (int c = 0; c < 4; ++c)
                vertices[i].color[c] = size_t(c) < a.components() ? byteOf(a.number(i, size_t(c))) : uint8_t(255);
        });
        if (hasNormals) // tangents without normals are ignored
            readTangents();
        isSkinned = !pose_.joints.empty() && attribute(primitive_.attributes, "JOINTS_0") >= 0 &&
                    attribute(primitive_.attributes, "WEIGHTS_0") >= 0;
        if (isSkinned)
            skin();
        for (Vertex& v : vertices) {
            const float squared = glm::dot(v.normal, v.normal);
            v.normal = squared > 1e-20f ? v.normal / std::sqrt(squared) : glm::vec3(0, 1, 0);
            if (hasTangents)
                v.tangent = {tangentAcross(v.normal, v.tangent), v.tangent.w};
        }
    }

private:
    // Returns false if there is no such attribute.
    template <typename Visit>
    bool forEach(const std::map<std::string, int>& attributes, const std::string& name, size_t components,
                 Visit visit) const {
        const int index = attribute(attributes, name);
        if (index < 0)
            return false;
        const AccessorView view(reader_, index);
        if (view.components() < components)
            reader_.fail(name + " has too few components");
        if (view.count() < vertices.size())
            reader_.fail(name + " has fewer elements than POSITION");
        for (size_t i = 0; i < vertices.size(); ++i)
            visit(view, i);
        return true;
    }

    // Returns an attribute of three components with its morph targets, or nothing if the vertices do not have it.
    std::vector<glm::dvec3> vectors(const std::string& name) const {
        std::vector<glm::dvec3> values(vertices.size());
        if (!forEach(primitive_.attributes, name, 3,
                     [&](const AccessorView& a, size_t i) { values[i] = vectorOf(a, i); }))
            return {};
        for (size_t t = 0; t < std::min(primitive_.targets.size(), pose_.weights.size()); ++t) {
            const double weight = std::clamp(pose_.weights[t], -largestNumber, largestNumber);
            if (weight != 0)
                forEach(primitive_.targets[t], name, 3,
                        [&](const AccessorView& a, size_t i) { values[i] += weight * vectorOf(a, i); });
        }
        for (glm::dvec3& v : values)
            v = glm::clamp(v, -largestNumber, largestNumber);
        return values;
    }

    void readCoordinates(const TextureCoordinates& coordinates) {
        const std::string name = "TEXCOORD_" + std::to_string(coordinates.set);
        forEach(primitive_.attributes, name, 2, [&](const AccessorView& a, size_t i) {
            vertices[i].uv = coordinates.of({a.number(i, 0), a.number(i, 1)});
        });
    }

    void readTangents() {
        const std::vector<glm::dvec3> tangents = vectors("TANGENT");
        hasTangents = forEach(primitive_.attributes, "TANGENT", 4, [&](const AccessorView& a, size_t i) {
            vertices[i].tangent = glm::vec4(glm::vec3(tangents[i]), a.number(i, 3) < 0 ? -1.0f : 1.0f);
        });
    }

    // Moves the vertices to the world. Weights are divided by their sum.
    void skin() {
        std::vector<glm::dmat4> blended(vertices.size(), glm::dmat4(0));
        std::vector<double> sums(vertices.size(), 0);
        const AccessorView joints(reader_, attribute(primitive_.attributes, "JOINTS_0"));
        if (joints.components() < 4 || joints.count() < vertices.size())
            reader_.fail("JOINTS_0 has fewer elements than POSITION");
        forEach(primitive_.attributes, "WEIGHTS_0", 4, [&](const AccessorView& a, size_t i) {
            for (size_t k = 0; k < 4; ++k) {
                const double weight = a.number(i, k);
                if (weight <= 0)
                    continue;
                const uint32_t joint = joints.index(i, k);
                if (joint >= pose_.joints.size())
                    reader_.fail("a vertex names a joint that its skin does not have");
                blended[i] += weight * pose_.joints[joint];
                sums[i] += weight;
            }
        });
        for (size_t i = 0; i < vertices.size(); ++i)
            if (sums[i] > 0)
                transform(i, blended[i] / sums[i]);
    }

    void transform(size_t i, const glm::dmat4& m) {
        positions[i] = glm::clamp(glm::dvec3(m * glm::dvec4(positions[i], 1)), -largestNumber, largestNumber);
        const glm::dmat3 linear(m);
        // Cofactors give the direction of the inverse transpose, also for flattened objects.
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const double sign = glm::dot(linear[0], cofactors[0]) < 0 ? -1 : 1;
        const glm::dvec3 normal = cofactors * glm::dvec3(vertices[i].normal) * sign;
        const double length = glm::length(normal);
        vertices[i].normal = length > 0 ? normal / length : glm::dvec3(0);
        const glm::dvec3 tangent = linear * glm::dvec3(vertices[i].tangent);
        const double tangentLength = glm::length(tangent);
        vertices[i].tangent =
            glm::vec4(tangentLength > 0 ? tangent / tangentLength : glm::dvec3(0), vertices[i].tangent.w * float(sign));
    }

    GltfReader& reader_;
    const tinygltf::Primitive& primitive_;
    const MeshPose& pose_;
};

// Returns an origin near the vertices if they are far from that of their space. Floats relative to it are as exact as
// their neighbours, while the transforms of instances have double precision.
glm::dvec3 originOf(const std::vector<glm::dvec3>& positions) {
    constexpr double farAway = 16; // sizes
    if (positions.empty())
        return glm::dvec3(0);
    glm::dvec3 low = positions[0], high = positions[0];
    for (const glm::dvec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 middle = 0.5 * (low + high);
    return glm::length(middle) > farAway * glm::length(high - low) ? middle : glm::dvec3(0);
}

} // namespace

PlacedMesh readPrimitive(GltfReader& reader, const tinygltf::Primitive& primitive, const MeshPose& pose) {
    Scene& scene = reader.scene;
    Mesh mesh;
    mesh.material = primitive.material >= 0 ? uint32_t(primitive.material) : uint32_t(scene.materials.size() - 1);
    if (mesh.material >= scene.materials.size())
        reader.fail("a primitive names a material that is not there");
    PrimitiveReader source(reader, primitive, pose);
    source.read(reader.coordinates[mesh.material]);
    std::vector<uint32_t> indices = triangleList(reader, primitive, source.positions.size());
    if (indices.size() > mostIndices - scene.indices.size())
        reader.fail("it has more than " + std::to_string(mostIndices) + " indices");
    const glm::dvec3 origin = originOf(source.positions);
    for (size_t i = 0; i < source.vertices.size(); ++i)
        source.vertices[i].position = glm::vec3(source.positions[i] - origin);
    if (!source.hasNormals) {
        if (indices.size() > mostVertices - scene.vertices.size())
            reader.fail("it has more than " + std::to_string(mostVertices) + " vertices");
        makeFlat(source.vertices, indices);
    }
    if (!source.hasTangents && scene.materials[mesh.material].normalTexture >= 0)
        generateTangents(source.vertices, indices);
    mesh.firstVertex = uint32_t(scene.vertices.size());
    mesh.vertexCount = uint32_t(source.vertices.size());
    mesh.firstIndex = uint32_t(scene.indices.size());
    mesh.indexCount = uint32_t(indices.size());
    scene.vertices.insert(scene.vertices.end(), source.vertices.begin(), source.vertices.end());
    scene.indices.insert(scene.indices.end(), indices.begin(), indices.end());
    scene.meshes.push_back(mesh);
    return {uint32_t(scene.meshes.size() - 1), origin, source.isSkinned};
}

} // namespace harness
