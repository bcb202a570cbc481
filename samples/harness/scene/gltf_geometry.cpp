#include "scene/gltf_reader.h"
#include "scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace harness {

namespace {

// Reads elements of an accessor as floats or indices, and checks every range.
class AccessorView {
public:
    AccessorView(const GltfReader& reader, int index) : reader_(reader) {
        accessor_ = &reader.at(reader.model.accessors, index, "accessors");
        if (accessor_->sparse.isSparse)
            reader.fail("sparse accessors are not supported");
        components_ = size_t(tinygltf::GetNumComponentsInType(uint32_t(accessor_->type)));
        size_ = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(accessor_->componentType)));
        if (accessor_->bufferView < 0)
            reader.fail("an accessor has no data");
        const auto& view = reader.at(reader.model.bufferViews, accessor_->bufferView, "bufferViews");
        const auto& buffer = reader.at(reader.model.buffers, view.buffer, "buffers");
        const int stride = accessor_->ByteStride(view);
        if (stride <= 0)
            reader.fail("an accessor has no valid stride");
        stride_ = size_t(stride);
        // Each check bounds the next term, so that no sum or product of a file's numbers can overflow.
        const size_t bytes = buffer.data.size();
        const bool inside =
            view.byteOffset <= bytes && view.byteLength <= bytes - view.byteOffset &&
            accessor_->byteOffset <= view.byteLength && count() <= bytes &&
            (count() == 0 || (count() - 1) * stride_ + components_ * size_ <= view.byteLength - accessor_->byteOffset);
        if (!inside)
            reader.fail("an accessor reaches beyond its buffer");
        data_ = buffer.data.data() + view.byteOffset + accessor_->byteOffset;
    }

    size_t count() const { return accessor_->count; }
    size_t components() const { return components_; }

    float number(size_t element, size_t component) const {
        const unsigned char* p = data_ + element * stride_ + component * size_;
        const auto read = [&](auto value, float scale) {
            std::memcpy(&value, p, sizeof value);
            return accessor_->normalized ? std::max(float(value) / scale, -1.0f) : float(value);
        };
        switch (accessor_->componentType) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT: {
            float value;
            std::memcpy(&value, p, sizeof value);
            return std::isfinite(value) ? value : 0.0f;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return read(uint8_t(0), 255.0f);
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return read(int8_t(0), 127.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return read(uint16_t(0), 65535.0f);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return read(int16_t(0), 32767.0f);
        default:
            reader_.fail("an accessor has a component type that vertices do not use");
        }
    }

    uint32_t index(size_t element) const {
        const unsigned char* p = data_ + element * stride_;
        uint32_t value = 0;
        if (accessor_->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
            accessor_->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
            accessor_->componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
            reader_.fail("indices have a component type that is not an unsigned integer");
        std::memcpy(&value, p, size_); // little-endian, as the format is
        return value;
    }

private:
    const GltfReader& reader_;
    const tinygltf::Accessor* accessor_;
    size_t components_ = 0;
    size_t size_ = 0;
    size_t stride_ = 0;
    const unsigned char* data_ = nullptr;
};

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

int attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

template <typename Set>
bool readAttribute(const GltfReader& reader, const tinygltf::Primitive& primitive, const char* name, size_t components,
                   std::span<Vertex> vertices, Set set) {
    const int index = attribute(primitive, name);
    if (index < 0)
        return false;
    const AccessorView view(reader, index);
    if (view.components() < components)
        reader.fail(std::string(name) + " has too few components");
    if (view.count() < vertices.size())
        reader.fail(std::string(name) + " has fewer elements than POSITION");
    for (size_t i = 0; i < vertices.size(); ++i)
        set(vertices[i], view, i);
    return true;
}

uint8_t byteOf(float value) { return uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

void readPrimitive(GltfReader& reader, const tinygltf::Primitive& primitive) {
    Scene& scene = reader.scene;
    const AccessorView positions(reader, attribute(primitive, "POSITION"));
    if (positions.count() > std::numeric_limits<uint32_t>::max() - scene.vertices.size())
        reader.fail("it has more vertices than 32-bit indices reach");
    Mesh mesh;
    mesh.firstVertex = uint32_t(scene.vertices.size());
    mesh.vertexCount = uint32_t(positions.count());
    mesh.firstIndex = uint32_t(scene.indices.size());
    mesh.material = primitive.material >= 0 ? uint32_t(primitive.material) : uint32_t(scene.materials.size() - 1);
    if (mesh.material >= scene.materials.size())
        reader.fail("a primitive names a material that is not there");
    const std::vector<uint32_t> indices = triangleList(reader, primitive, positions.count());
    if (indices.size() > std::numeric_limits<uint32_t>::max() - scene.indices.size())
        reader.fail("it has more indices than 32 bits count");
    mesh.indexCount = uint32_t(indices.size());
    scene.vertices.resize(scene.vertices.size() + mesh.vertexCount);
    const std::span<Vertex> vertices = std::span(scene.vertices).subspan(mesh.firstVertex);
    readAttribute(reader, primitive, "POSITION", 3, vertices, [](Vertex& v, const AccessorView& a, size_t i) {
        v.position = {a.number(i, 0), a.number(i, 1), a.number(i, 2)};
    });
    if (!readAttribute(reader, primitive, "NORMAL", 3, vertices, [](Vertex& v, const AccessorView& a, size_t i) {
            const glm::vec3 n(a.number(i, 0), a.number(i, 1), a.number(i, 2));
            const float length2 = glm::dot(n, n);
            v.normal = length2 > 1e-20f ? n / std::sqrt(length2) : glm::vec3(0, 1, 0);
        }))
        generateNormals(vertices, indices);
    readAttribute(reader, primitive, "TEXCOORD_0", 2, vertices, [](Vertex& v, const AccessorView& a, size_t i) {
        v.uv = {a.number(i, 0), a.number(i, 1)};
    });
    readAttribute(reader, primitive, "COLOR_0", 3, vertices, [](Vertex& v, const AccessorView& a, size_t i) {
        for (int c = 0; c < 4; ++c)
            v.color[c] = size_t(c) < a.components() ? byteOf(a.number(i, size_t(c))) : uint8_t(255);
    });
    const bool hasTangents =
        readAttribute(reader, primitive, "TANGENT", 4, vertices, [](Vertex& v, const AccessorView& a, size_t i) {
            const glm::vec3 t(a.number(i, 0), a.number(i, 1), a.number(i, 2));
            v.tangent = {tangentAcross(v.normal, t), a.number(i, 3) < 0 ? -1.0f : 1.0f};
        });
    if (!hasTangents && scene.materials[mesh.material].normalTexture >= 0)
        generateTangents(vertices, indices);
    scene.indices.insert(scene.indices.end(), indices.begin(), indices.end());
    scene.meshes.push_back(mesh);
}

} // namespace

std::vector<uint32_t> readMeshes(GltfReader& reader) {
    std::vector<uint32_t> first;
    for (const tinygltf::Mesh& mesh : reader.model.meshes) {
        first.push_back(uint32_t(reader.scene.meshes.size()));
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const bool triangles =
                primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN || primitive.mode == -1; // triangles by default
            if (triangles && attribute(primitive, "POSITION") >= 0)
                readPrimitive(reader, primitive);
        }
    }
    first.push_back(uint32_t(reader.scene.meshes.size()));
    return first;
}

} // namespace harness
