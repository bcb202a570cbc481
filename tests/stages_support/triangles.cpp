#include "triangles.h"

#include <array>
#include <cmath>

namespace agaa::test {

glm::vec3 planeNormal(const Triangle& t) {
    const glm::vec3 n = glm::normalize(glm::cross(t.position[1] - t.position[0], t.position[2] - t.position[0]));
    return glm::dot(n, t.position[0]) > 0 ? -n : n;
}

glm::mat4 perspective(float fovYDegrees, float aspect, float near, float far) {
    const float f = 1 / std::tan(glm::radians(fovYDegrees) / 2);
    glm::mat4 m(0);
    m[0][0] = f / aspect;
    m[1][1] = -f;
    m[2][2] = far / (near - far);
    m[2][3] = -1;
    m[3][2] = near * far / (near - far);
    return m;
}

glm::mat4 reversedInfinite(float fovYDegrees, float aspect, float near) {
    glm::mat4 m = perspective(fovYDegrees, aspect, near, 2 * near);
    m[2][2] = 0;
    m[3][2] = near;
    return m;
}

glm::mat4 pixelOrthographic(float width, float height, float depth) {
    glm::mat4 m(1);
    m[0][0] = 2 / width;
    m[1][1] = 2 / height;
    m[2][2] = -1 / depth;
    m[3] = glm::vec4(-1, -1, 0, 1);
    return m;
}

namespace {

float uniform(std::mt19937& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

// Steps of 6 to 16 bits.
bool isSafe(double value) {
    for (uint32_t bits = 6; bits <= 16; ++bits) {
        const double scaled = value * double((1u << bits) - 1);
        if (std::fabs(scaled - std::floor(scaled) - 0.5) < 0.002 * (bits > 12 ? 5 : 1))
            return false;
    }
    return true;
}

// Steps of signed codes.
bool isSafeSigned(double value) {
    for (uint32_t bits = 6; bits <= 16; ++bits) {
        const double scaled = value * double((1u << (bits - 1)) - 1);
        if (std::fabs(scaled - std::floor(scaled) - 0.5) < 0.002 * (bits > 12 ? 5 : 1))
            return false;
    }
    return true;
}

float safeUniform(std::mt19937& random, float low, float high) {
    for (;;) {
        const float value = uniform(random, low, high);
        if (isSafe(double(value)))
            return value;
    }
}

bool isSafeYCbCr(const glm::dvec3& c) {
    const double y = 0.299 * c.x + 0.587 * c.y + 0.114 * c.z;
    return isSafe(y) && isSafe((c.z - y) / 1.772 + 0.5) && isSafe((c.x - y) / 1.402 + 0.5);
}

} // namespace

Material randomMaterial(std::mt19937& random) {
    Material m;
    for (int i = 0; i < 3; ++i)
        m.diffuse[i] = safeUniform(random, 0, 1);
    do
        for (int i = 0; i < 3; ++i)
            m.specular[i] = safeUniform(random, 0, 1);
    while (!isSafeYCbCr(glm::dvec3(m.specular)));
    for (int i = 0; i < 3; ++i)
        m.emissive[i] = 16 * safeUniform(random, 0, 1);
    for (;;) {
        const float alpha2 = safeUniform(random, 0.001f, 1);
        const glm::vec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        if (glm::length(v) < 0.1f)
            continue;
        const glm::dvec3 n = glm::normalize(glm::dvec3(v));
        const double folded = 2 * (1 - double(alpha2)) / (2 - double(alpha2));
        bool safe = true;
        for (int i = 0; i < 3; ++i)
            safe &= isSafeSigned(n[i]) && isSafeSigned(n[i] * folded);
        if (!safe)
            continue;
        m.normal = glm::vec4(glm::vec3(n), alpha2);
        return m;
    }
}

std::vector<Triangle> randomTriangles(const RandomScene& scene, uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Triangle> list;
    while (list.size() < scene.triangles) {
        Triangle t;
        if (!list.empty() && uniform(random, 0, 1) < scene.duplicates) {
            const Triangle& other = list[random() % list.size()];
            std::copy(other.position, other.position + 3, t.position);
        } else {
            const float distance = uniform(random, 1.0f, 20.0f);
            // Half of them slivers that are thinner than a pixel.
            const float size = distance * uniform(random, 0.05f, 0.4f);
            const float width = random() % 2 ? size : distance * uniform(random, 0.001f, 0.02f);
            const glm::vec3 centre(distance * uniform(random, -0.8f, 0.8f), distance * uniform(random, -0.55f, 0.55f),
                                   -distance);
            const glm::vec3 along =
                size * glm::vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -0.5f, 0.5f));
            const glm::vec3 across =
                width * glm::vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -0.5f, 0.5f));
            t.position[0] = centre - along;
            t.position[1] = centre + along;
            t.position[2] = centre + across;
        }
        const glm::vec3 cross = glm::cross(t.position[1] - t.position[0], t.position[2] - t.position[0]);
        if (glm::length(cross) < 1e-5f)
            continue;
        t.material = randomMaterial(random);
        t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
        t.isMasked = uniform(random, 0, 1) < scene.masked;
        if (t.isMasked)
            t.material.diffuse.w = uniform(random, 0.1f, 0.9f);
        list.push_back(t);
    }
    return list;
}

std::vector<Triangle> rectangle(float x0, float y0, float x1, float y1, float depth, const Material& material) {
    const glm::vec3 corners[4] = {{x0, y0, -depth}, {x1, y0, -depth}, {x1, y1, -depth}, {x0, y1, -depth}};
    const glm::vec2 uvs[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Triangle> list;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        Triangle t;
        int i = 0;
        for (int corner : {a, b, c}) {
            t.position[i] = corners[corner];
            t.uv[i++] = uvs[corner];
        }
        t.material = material;
        list.push_back(t);
    }
    return list;
}

} // namespace agaa::test
