#include "scene/tangents.h"

#include <cmath>

namespace harness {

static glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
    const float length2 = glm::dot(v, v);
    return length2 > 1e-30f && std::isfinite(length2) ? v / std::sqrt(length2) : fallback;
}

static glm::vec3 across(const glm::vec3& n) {
    const glm::vec3 axis = std::fabs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(n, axis));
}

glm::vec3 tangentAcross(const glm::vec3& normal, const glm::vec3& tangent) {
    return unitOr(tangent - normal * glm::dot(normal, tangent), across(normal));
}

void makeFlat(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices) {
    std::vector<Vertex> flat;
    flat.reserve(indices.size());
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto corner = [&](size_t c) { return glm::dvec3(vertices[indices[i + c]].position); };
        const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        const double length = glm::length(n);
        for (size_t c = 0; c < 3; ++c) {
            flat.push_back(vertices[indices[i + c]]);
            flat.back().normal = length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
        }
    }
    for (size_t i = 0; i < flat.size(); ++i)
        indices[i] = uint32_t(i);
    indices.resize(flat.size());
    vertices = std::move(flat);
}

void generateTangents(std::span<Vertex> vertices, std::span<const uint32_t> indices) {
    std::vector<glm::vec3> tangents(vertices.size(), glm::vec3(0));
    std::vector<glm::vec3> bitangents(vertices.size(), glm::vec3(0));
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vertex& a = vertices[indices[i]];
        const Vertex& b = vertices[indices[i + 1]];
        const Vertex& c = vertices[indices[i + 2]];
        const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
        const glm::vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
        const float area = d1.x * d2.y - d2.x * d1.y;
        if (!(std::fabs(area) > 1e-20f))
            continue;
        const float sign = area < 0 ? -1.0f : 1.0f;
        const glm::vec3 t = sign * (e1 * d2.y - e2 * d1.y);
        const glm::vec3 u = sign * (e2 * d1.x - e1 * d2.x);
        for (size_t corner = 0; corner < 3; ++corner) {
            tangents[indices[i + corner]] += t;
            bitangents[indices[i + corner]] += u;
        }
    }
    for (size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3 n = vertices[i].normal;
        const glm::vec3 t = tangentAcross(n, tangents[i]);
        // v grows downwards in a texture, while the green channel of a normal map points upwards.
        const float handedness = glm::dot(glm::cross(n, t), bitangents[i]) > 0 ? -1.0f : 1.0f;
        vertices[i].tangent = glm::vec4(t, handedness);
    }
}

} // namespace harness
