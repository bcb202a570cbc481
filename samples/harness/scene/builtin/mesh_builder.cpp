#include "scene/builtin/mesh_builder.h"

#include "scene/tangents.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr float kTurn = 6.28318531f;

glm::vec3 anyAcross(const glm::vec3& n) {
    const glm::vec3 axis = std::fabs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(n, axis));
}

// Returns the tangent at a point of a polyline.
glm::vec3 directionAt(std::span<const glm::vec3> points, size_t i) {
    const size_t before = i > 0 ? i - 1 : 0;
    const size_t after = std::min(i + 1, points.size() - 1);
    return glm::normalize(points[after] - points[before]);
}

} // namespace

uint32_t MeshBuilder::add(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
    Vertex vertex;
    vertex.position = position;
    vertex.normal = normal;
    vertex.uv = uv;
    vertex.color = color;
    vertices.push_back(vertex);
    return uint32_t(vertices.size() - 1);
}

void MeshBuilder::triangle(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

void MeshBuilder::quad(const glm::vec3& corner, const glm::vec3& edgeU, const glm::vec3& edgeV,
                       const glm::vec2& uvScale) {
    const glm::vec3 n = glm::normalize(glm::cross(edgeU, edgeV));
    const uint32_t a = add(corner, n, {0, uvScale.y});
    const uint32_t b = add(corner + edgeU, n, {uvScale.x, uvScale.y});
    const uint32_t c = add(corner + edgeU + edgeV, n, {uvScale.x, 0});
    const uint32_t d = add(corner + edgeV, n, {0, 0});
    triangle(a, b, c);
    triangle(a, c, d);
}

void MeshBuilder::polygon(std::span<const glm::vec3> corners, const glm::vec3& normal) {
    const uint32_t first = uint32_t(vertices.size());
    const glm::vec3 u = anyAcross(normal), v = glm::cross(normal, u);
    for (const glm::vec3& p : corners)
        add(p, normal, {glm::dot(p, u), glm::dot(p, v)});
    for (uint32_t i = 1; i + 1 < corners.size(); ++i)
        triangle(first, first + i, first + i + 1);
}

void MeshBuilder::box(const glm::vec3& low, const glm::vec3& high, float uvPerMetre) {
    const glm::vec3 d = high - low;
    const glm::vec3 x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
    const float s = uvPerMetre;
    quad({low.x, low.y, high.z}, x, y, {s * d.x, s * d.y});
    quad({high.x, low.y, low.z}, -x, y, {s * d.x, s * d.y});
    quad(high - y, -z, y, {s * d.z, s * d.y});
    quad(low, z, y, {s * d.z, s * d.y});
    quad({low.x, high.y, high.z}, x, -z, {s * d.x, s * d.z});
    quad(low, x, z, {s * d.x, s * d.z});
}

void MeshBuilder::cap(const glm::vec3& centre, const glm::vec3& normal, uint32_t firstRing, int sides, bool reversed) {
    const uint32_t middle = add(centre, normal, {0.5f, 0.5f});
    for (int j = 0; j < sides; ++j) {
        const float a = kTurn * float(j) / float(sides);
        const glm::vec3 p = vertices[firstRing + uint32_t(j)].position; // add() may reallocate the list
        add(p, normal, {0.5f + 0.5f * std::cos(a), 0.5f + 0.5f * std::sin(a)});
    }
    for (uint32_t j = 0; j < uint32_t(sides); ++j) {
        const uint32_t a = middle + 1 + j, b = middle + 1 + (j + 1) % uint32_t(sides);
        reversed ? triangle(middle, b, a) : triangle(middle, a, b);
    }
}

void MeshBuilder::tube(std::span<const glm::vec3> points, std::span<const float> radii, int sides, bool capped) {
    if (points.size() < 2)
        return;
    float length = 0;
    for (size_t i = 1; i < points.size(); ++i)
        length += glm::distance(points[i - 1], points[i]);
    glm::vec3 t = directionAt(points, 0);
    glm::vec3 u = anyAcross(t);
    float travelled = 0;
    const uint32_t ring = uint32_t(sides) + 1; // the seam has separate vertices for u = 1
    const uint32_t first = uint32_t(vertices.size());
    const glm::vec3 start = t;
    for (size_t i = 0; i < points.size(); ++i) {
        const size_t before = i > 0 ? i - 1 : 0;
        const size_t after = std::min(i + 1, points.size() - 1);
        t = directionAt(points, i);
        u = glm::normalize(u - t * glm::dot(u, t)); // transported without twist
        const glm::vec3 v = glm::cross(t, u);
        // The normal leans forward if the radius shrinks.
        const float slope = (radii[after] - radii[before]) / glm::distance(points[after], points[before]);
        if (i > 0)
            travelled += glm::distance(points[i - 1], points[i]);
        for (int j = 0; j <= sides; ++j) {
            const float a = kTurn * float(j % sides) / float(sides);
            const glm::vec3 radial = std::cos(a) * u + std::sin(a) * v;
            add(points[i] + radii[i] * radial, glm::normalize(radial - slope * t),
                {float(j) / float(sides), travelled / length});
        }
    }
    for (uint32_t i = 0; i + 1 < points.size(); ++i)
        for (uint32_t j = 0; j < uint32_t(sides); ++j) {
            const uint32_t a = first + i * ring + j, b = a + 1, c = b + ring, d = a + ring;
            if (radii[i] > 0)
                triangle(a, b, c);
            if (radii[i + 1] > 0)
                triangle(a, c, d);
            else if (!(radii[i] > 0))
                continue;
        }
    if (!capped)
        return;
    if (radii.front() > 0)
        cap(points.front(), -start, first, sides, true);
    if (radii.back() > 0)
        cap(points.back(), t, first + uint32_t(points.size() - 1) * ring, sides, false);
}

void MeshBuilder::tube(std::span<const glm::vec3> points, float radius, int sides, bool capped) {
    const std::vector<float> radii(points.size(), radius);
    tube(points, radii, sides, capped);
}

void MeshBuilder::cylinder(const glm::vec3& bottom, const glm::vec3& top, float radius, int sides) {
    const std::array points{bottom, top};
    tube(points, radius, sides, true);
}

void MeshBuilder::sphere(const glm::vec3& centre, float radius, int rings, int sides) {
    const uint32_t first = uint32_t(vertices.size());
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= sides; ++j) {
            const float down = 0.5f * kTurn * float(i) / float(rings);
            const float around = kTurn * float(j % sides) / float(sides);
            const glm::vec3 n{std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)};
            add(centre + radius * n, glm::normalize(n), {float(j) / float(sides), float(i) / float(rings)});
        }
    const uint32_t row = uint32_t(sides) + 1;
    for (uint32_t i = 0; i < uint32_t(rings); ++i)
        for (uint32_t j = 0; j < uint32_t(sides); ++j) {
            const uint32_t a = first + i * row + j, b = a + row;
            if (i + 1 < uint32_t(rings))
                triangle(a, b, b + 1);
            if (i > 0)
                triangle(a, b + 1, a + 1);
        }
}

void MeshBuilder::blade(std::span<const glm::vec3> points, std::span<const float> widths, const glm::vec3& across) {
    const uint32_t first = uint32_t(vertices.size());
    const size_t last = points.size() - 1;
    for (size_t i = 0; i <= last; ++i) {
        const glm::vec3 t = directionAt(points, i);
        const glm::vec3 side = glm::normalize(across - t * glm::dot(across, t));
        const glm::vec3 n = glm::normalize(glm::cross(side, t));
        const float v = float(i) / float(last);
        if (i == last && !(widths[i] > 0)) {
            add(points[i], n, {0.5f, v});
            continue;
        }
        add(points[i] - 0.5f * widths[i] * side, n, {0, v});
        add(points[i] + 0.5f * widths[i] * side, n, {1, v});
    }
    for (uint32_t i = 0; i < uint32_t(last); ++i) {
        const uint32_t a = first + 2 * i;
        triangle(a, a + 1, a + 2);
        if (i + 1 < last || widths[last] > 0)
            triangle(a + 1, a + 3, a + 2);
    }
}

void MeshBuilder::ground(float halfSize, int cells, const Height& height, float uvPerMetre) {
    const uint32_t first = uint32_t(vertices.size());
    const float step = 2 * halfSize / float(cells);
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const float x = -halfSize + step * float(j), z = -halfSize + step * float(i);
            const float e = 0.5f * step;
            const glm::vec3 n{height(x - e, z) - height(x + e, z), 2 * e, height(x, z - e) - height(x, z + e)};
            add({x, height(x, z), z}, glm::normalize(n), uvPerMetre * glm::vec2(x, z));
        }
    const uint32_t row = uint32_t(cells) + 1;
    for (uint32_t i = 0; i < uint32_t(cells); ++i)
        for (uint32_t j = 0; j < uint32_t(cells); ++j) {
            const uint32_t a = first + i * row + j, b = a + row;
            triangle(a, b, b + 1);
            triangle(a, b + 1, a + 1);
        }
}

glm::vec3 linearFromSrgb(uint32_t rgb) {
    glm::vec3 linear;
    for (int c = 0; c < 3; ++c) {
        const float s = float(rgb >> (16 - 8 * c) & 255) / 255.0f;
        linear[c] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    }
    return linear;
}

uint8_t srgbByte(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    const float s = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    return uint8_t(s * 255.0f + 0.5f);
}

Material& addMaterial(Scene& scene, std::string name, uint32_t srgbColor, float roughness, float metallic) {
    Material material;
    material.name = std::move(name);
    material.baseColor = glm::vec4(linearFromSrgb(srgbColor), 1);
    material.roughness = roughness;
    material.metallic = metallic;
    scene.materials.push_back(material);
    return scene.materials.back();
}

uint32_t lastMaterial(const Scene& scene) { return uint32_t(scene.materials.size() - 1); }

uint32_t addMesh(Scene& scene, const MeshBuilder& builder, uint32_t material) {
    Mesh mesh;
    mesh.firstIndex = uint32_t(scene.indices.size());
    mesh.indexCount = uint32_t(builder.indices.size());
    mesh.firstVertex = uint32_t(scene.vertices.size());
    mesh.vertexCount = uint32_t(builder.vertices.size());
    mesh.material = material;
    scene.vertices.insert(scene.vertices.end(), builder.vertices.begin(), builder.vertices.end());
    scene.indices.insert(scene.indices.end(), builder.indices.begin(), builder.indices.end());
    generateTangents(std::span(scene.vertices).subspan(mesh.firstVertex), builder.indices);
    scene.meshes.push_back(mesh);
    return uint32_t(scene.meshes.size() - 1);
}

void place(Scene& scene, uint32_t mesh, const glm::dmat4& transform) { scene.instances.push_back({mesh, transform}); }

glm::dmat4 placement(const glm::dvec3& position, double turn, double scale, double lean) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), position);
    m = glm::rotate(m, turn, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, lean, glm::dvec3(1, 0, 0));
    return glm::scale(m, glm::dvec3(scale));
}

std::vector<glm::vec3> smoothCurve(std::span<const glm::vec3> points, int steps) {
    std::vector<glm::vec3> curve;
    const size_t last = points.size() - 1;
    for (size_t i = 0; i < last; ++i) {
        const glm::vec3 &a = points[i > 0 ? i - 1 : 0], &b = points[i], &c = points[i + 1],
                        &d = points[std::min(i + 2, last)];
        for (int s = 0; s < steps; ++s) {
            const float t = float(s) / float(steps);
            curve.push_back(0.5f * (2.0f * b + t * (c - a) + t * t * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                                    t * t * t * (3.0f * b - a - 3.0f * c + d)));
        }
    }
    curve.push_back(points[last]);
    return curve;
}

glm::vec3 unitVector(Random& random) {
    const float y = random.in(-1, 1);
    const float a = kTurn * random.unit();
    const float r = std::sqrt(std::max(0.0f, 1 - y * y));
    return glm::normalize(glm::vec3{r * std::cos(a), y, r * std::sin(a)});
}

float tileableNoise(float x, float y, int period, uint32_t seed) {
    const auto lattice = [&](int i, int j) {
        i = ((i % period) + period) % period;
        j = ((j % period) + period) % period;
        uint32_t h = seed + uint32_t(i) * 0x9e3779b9u + uint32_t(j) * 0x85ebca6bu;
        h = (h ^ (h >> 16)) * 0x7feb352du;
        h = (h ^ (h >> 15)) * 0x846ca68bu;
        return float((h ^ (h >> 16)) >> 8) * (1.0f / 16777216.0f);
    };
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float s = ease(x - float(i)), t = ease(y - float(j));
    return glm::mix(glm::mix(lattice(i, j), lattice(i + 1, j), s),
                    glm::mix(lattice(i, j + 1), lattice(i + 1, j + 1), s), t);
}

} // namespace harness::builtin
