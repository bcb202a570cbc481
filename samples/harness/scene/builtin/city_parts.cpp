#include "scene/builtin/city_parts.h"

#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

void addBar(MeshBuilder& mesh, const glm::vec3& from, const glm::vec3& to, float radius) {
    mesh.cylinder(from, to, radius, 6);
}

// Returns the profile of a fluted shaft at an angle: the distance from the axis and its derivative.
glm::vec2 flute(float angle, float radius) {
    constexpr float count = 20, depth = 0.045f;
    const float wave = std::cos(count * angle);
    return {radius * (1 - depth * (1 + wave) / 2), radius * depth * count * std::sin(count * angle) / 2};
}

void addShaft(MeshBuilder& mesh, float radius, float bottom, float top) {
    constexpr uint32_t sides = 120, rings = 3;
    const uint32_t first = uint32_t(mesh.vertices.size());
    for (uint32_t i = 0; i <= rings; ++i)
        for (uint32_t j = 0; j <= sides; ++j) {
            const float s = float(i) / rings;
            const float taper = 1 - 0.15f * s;
            const float a = 6.28318531f * float(j % sides) / sides;
            const glm::vec2 profile = taper * flute(a, radius);
            const glm::vec3 out{std::sin(a), 0, std::cos(a)}, along{std::cos(a), 0, -std::sin(a)};
            Vertex vertex;
            vertex.position = profile.x * out + glm::vec3(0, bottom + s * (top - bottom), 0);
            // The normal is perpendicular to the profile's tangent (r' out + r along) and leans up with the taper.
            const glm::vec3 n = glm::normalize(profile.x * out - profile.y * along);
            vertex.normal = glm::normalize(n + glm::vec3(0, 0.15f * radius / (top - bottom), 0));
            vertex.uv = {float(j) / sides, s};
            mesh.vertices.push_back(vertex);
        }
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            const uint32_t a = first + i * (sides + 1) + j, b = a + sides + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
}

} // namespace

MeshBuilder windowFrame(float width, float height) {
    MeshBuilder mesh;
    const float x = 0.5f * width, t = 0.06f;
    mesh.box({-x - t, 0, 0}, {-x, height, 0.08f});
    mesh.box({x, 0, 0}, {x + t, height, 0.08f});
    mesh.box({-x - t, height, 0}, {x + t, height + t, 0.1f});
    mesh.box({-x - 2 * t, -t, 0}, {x + 2 * t, 0, 0.2f});
    mesh.box({-0.012f, 0, 0.02f}, {0.012f, height, 0.05f});
    for (int i = 1; i <= 3; ++i) {
        const float y = 0.25f * float(i) * height;
        mesh.box({-x, y - 0.01f, 0.02f}, {x, y + 0.01f, 0.045f});
    }
    return mesh;
}

MeshBuilder balcony(float width) {
    MeshBuilder mesh;
    const float x = 0.5f * width, depth = 0.7f;
    mesh.box({-x, -0.16f, 0}, {x, -0.08f, depth});
    for (const float y : {0.0f, 0.95f}) {
        addBar(mesh, {-x, y, depth}, {x, y, depth}, 0.015f);
        addBar(mesh, {-x, y, 0}, {-x, y, depth}, 0.015f);
        addBar(mesh, {x, y, 0}, {x, y, depth}, 0.015f);
    }
    constexpr int bars = 16, sideBars = 6;
    for (int i = 0; i <= bars; ++i) {
        const float at = -x + width * float(i) / bars;
        addBar(mesh, {at, -0.08f, depth}, {at, 0.95f, depth}, 0.007f);
    }
    for (int i = 1; i < sideBars; ++i)
        for (const float side : {-x, x}) {
            const float at = depth * float(i) / sideBars;
            addBar(mesh, {side, -0.08f, at}, {side, 0.95f, at}, 0.007f);
        }
    return mesh;
}

MeshBuilder flutedColumn(float radius, float height) {
    MeshBuilder mesh;
    const float block = 1.35f * radius;
    mesh.box({-block, 0, -block}, {block, 0.12f, block});
    mesh.cylinder({0, 0.12f, 0}, {0, 0.24f, 0}, 1.2f * radius, 32);
    addShaft(mesh, radius, 0.24f, height - 0.26f);
    const std::array flare{glm::vec3(0, height - 0.3f, 0), glm::vec3(0, height - 0.2f, 0),
                           glm::vec3(0, height - 0.12f, 0)};
    const std::array radii{0.84f * radius, 0.98f * radius, 1.25f * radius};
    mesh.tube(flare, radii, 32, true);
    mesh.box({-block, height - 0.12f, -block}, {block, height, block});
    return mesh;
}

MeshBuilder fencePanel(float width, float height, int bars, bool spikes) {
    MeshBuilder mesh;
    const float x = 0.5f * width;
    const float rail = spikes ? height - 0.18f : height;
    addBar(mesh, {-x, 0.12f, 0}, {x, 0.12f, 0}, 0.014f);
    addBar(mesh, {-x, rail, 0}, {x, rail, 0}, spikes ? 0.014f : 0.022f);
    addBar(mesh, {-x, 0, 0}, {-x, height, 0}, 0.025f);
    for (int i = 1; i < bars; ++i) {
        const float at = -x + width * float(i) / float(bars);
        const float tip = spikes ? height - 0.1f : rail;
        addBar(mesh, {at, spikes ? 0.04f : 0.12f, 0}, {at, tip, 0}, 0.008f);
        if (!spikes)
            continue;
        const std::array points{glm::vec3(at, tip, 0), glm::vec3(at, tip + 0.03f, 0), glm::vec3(at, tip + 0.12f, 0)};
        const std::array radii{0.009f, 0.016f, 0.0f};
        mesh.tube(points, radii, 6, false);
    }
    return mesh;
}

MeshBuilder wirePole() {
    MeshBuilder mesh;
    const std::array points{glm::vec3(0), glm::vec3(0, 0.6f, 0), glm::vec3(0, 0.62f, 0), glm::vec3(0, 6.6f, 0)};
    const std::array radii{0.11f, 0.1f, 0.07f, 0.05f};
    mesh.tube(points, radii, 16, true);
    for (const float y : {5.7f, 6.2f}) {
        mesh.box({-0.75f, y - 0.04f, -0.03f}, {0.75f, y + 0.04f, 0.03f});
        for (int i = 0; i < 4; ++i) {
            const float x = 0.4f * (float(i) - 1.5f);
            mesh.cylinder({x, y + 0.04f, 0}, {x, y + 0.13f, 0}, 0.025f, 8);
        }
    }
    const std::array arm{glm::vec3(0, 4.4f, 0), glm::vec3(0.3f, 4.75f, 0), glm::vec3(0.7f, 4.8f, 0),
                         glm::vec3(0.9f, 4.5f, 0)};
    mesh.tube(smoothCurve(arm, 6), 0.018f, 8, true);
    return mesh;
}

MeshBuilder roofAntenna() {
    MeshBuilder mesh;
    addBar(mesh, {0, 0, 0}, {0, 3.4f, 0}, 0.018f);
    addBar(mesh, {-0.2f, 3.2f, 0}, {1.1f, 3.2f, 0}, 0.01f);
    for (int i = 0; i < 12; ++i) {
        const float x = -0.15f + 0.1f * float(i), half = 0.42f - 0.018f * float(i);
        addBar(mesh, {x, 3.2f, -half}, {x, 3.2f, half}, 0.005f);
    }
    addBar(mesh, {0, 2.5f, -0.5f}, {0, 2.5f, 0.5f}, 0.008f);
    for (int i = 0; i < 5; ++i) {
        const float z = 0.22f * (float(i) - 2);
        addBar(mesh, {-0.35f, 2.5f, z}, {0.35f, 2.5f, z}, 0.005f);
    }
    return mesh;
}

void addWire(MeshBuilder& mesh, const glm::vec3& from, const glm::vec3& to, float sag) {
    std::array<glm::vec3, 21> points;
    for (size_t i = 0; i < points.size(); ++i) {
        const float s = float(i) / float(points.size() - 1);
        points[i] = glm::mix(from, to, s) - glm::vec3(0, 4 * sag * s * (1 - s), 0);
    }
    mesh.tube(points, 0.009f, 5, false);
}

CafeChair cafeChair() {
    CafeChair chair;
    constexpr float radius = 0.009f;
    for (const float x : {-0.2f, 0.2f}) {
        // One bent tube makes a front leg, a side of the seat and the back.
        const std::array side{glm::vec3(x * 1.1f, 0, 0.24f),     glm::vec3(x, 0.25f, 0.21f),
                              glm::vec3(x, 0.44f, 0.19f),        glm::vec3(x, 0.455f, 0.0f),
                              glm::vec3(x, 0.46f, -0.17f),       glm::vec3(x, 0.62f, -0.21f),
                              glm::vec3(x * 0.9f, 0.86f, -0.27f)};
        chair.tubes.tube(smoothCurve(side, 2), radius, 6, true);
        const std::array back{glm::vec3(x * 1.1f, 0, -0.26f), glm::vec3(x, 0.25f, -0.2f), glm::vec3(x, 0.45f, -0.12f)};
        chair.tubes.tube(smoothCurve(back, 2), radius, 6, true);
    }
    const std::array top{glm::vec3(-0.18f, 0.86f, -0.27f), glm::vec3(-0.1f, 0.9f, -0.29f),
                         glm::vec3(0.1f, 0.9f, -0.29f), glm::vec3(0.18f, 0.86f, -0.27f)};
    chair.tubes.tube(smoothCurve(top, 2), radius, 6, true);
    addBar(chair.tubes, {-0.2f, 0.2f, -0.21f}, {0.2f, 0.2f, -0.21f}, 0.006f);
    addBar(chair.tubes, {-0.2f, 0.2f, 0.215f}, {0.2f, 0.2f, 0.215f}, 0.006f);
    for (int i = 0; i < 6; ++i) {
        const float z = -0.16f + 0.06f * float(i);
        chair.slats.box({-0.21f, 0.465f, z}, {0.21f, 0.48f, z + 0.045f});
    }
    for (int i = 0; i < 3; ++i) {
        const float y = 0.62f + 0.085f * float(i), z = -0.205f - 0.02f * float(i);
        chair.slats.box({-0.19f, y, z - 0.012f}, {0.19f, y + 0.05f, z});
    }
    return chair;
}

CafeTable cafeTable() {
    CafeTable table;
    for (int i = 0; i < 3; ++i) {
        const float a = 6.28318531f * float(i) / 3;
        const glm::vec3 out{std::sin(a), 0, std::cos(a)};
        const std::array leg{0.34f * out, 0.12f * out + glm::vec3(0, 0.3f, 0), 0.1f * out + glm::vec3(0, 0.5f, 0),
                             0.28f * out + glm::vec3(0, 0.72f, 0)};
        table.tubes.tube(smoothCurve(leg, 5), 0.01f, 8, true);
    }
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= 24; ++i) {
        const float a = 6.28318531f * float(i) / 24;
        ring.push_back({0.13f * std::sin(a), 0.4f, 0.13f * std::cos(a)});
    }
    table.tubes.tube(ring, 0.006f, 6, false);
    table.top.cylinder({0, 0.72f, 0}, {0, 0.745f, 0}, 0.36f, 40);
    return table;
}

} // namespace harness::builtin
