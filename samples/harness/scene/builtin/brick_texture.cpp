#include "scene/builtin/brick_texture.h"

#include "scene/builtin/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kSize = 256;
constexpr int kRows = 8, kColumns = 4;

struct Brick {
    int row, column;
    float edge; // distance to the joint in texels, negative in the joint
};

Brick brickAt(int x, int y) {
    const float width = float(kSize) / kColumns, height = float(kSize) / kRows;
    const int row = y * kRows / kSize;
    float left = float(x) + 0.5f + (row % 2 ? 0.5f * width : 0.0f);
    if (left >= kSize)
        left -= kSize;
    const int column = int(left / width);
    const float u = left - float(column) * width, v = float(y) + 0.5f - float(row) * height;
    return {row, column, std::min({u, width - u, v, height - v}) - 2.5f};
}

int wrapped(int i) { return (i + kSize) % kSize; }

// Returns the height in texels: rounded bricks with a rough face in flat, sandy mortar.
float heightAt(int x, int y) {
    const Brick brick = brickAt(wrapped(x), wrapped(y));
    const float u = float(wrapped(x)) / kSize, v = float(wrapped(y)) / kSize;
    const float grain = tileableNoise(64 * u, 64 * v, 64, 5) + tileableNoise(24 * u, 24 * v, 24, 9);
    return 3.0f * std::clamp(0.35f * brick.edge + 0.3f, 0.0f, 1.0f) + 0.9f * grain;
}

Texture blank(const char* name, bool srgb) {
    Texture texture;
    texture.name = name;
    texture.width = texture.height = kSize;
    texture.srgb = srgb;
    texture.rgba.reserve(size_t(kSize) * kSize * 4);
    return texture;
}

} // namespace

BrickTextures brickTextures() {
    BrickTextures result{blank("brick colour", true), blank("brick normals", false)};
    const glm::vec3 mortar = linearFromSrgb(0xb9b0a2);
    const glm::vec3 dark = linearFromSrgb(0x7d3f30), light = linearFromSrgb(0xb8694a);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Brick brick = brickAt(x, y);
            const float burnt = tileableNoise(float(brick.column), float(brick.row), 64, 21);
            const float stain = 0.8f + 0.4f * tileableNoise(16.0f * float(x) / kSize, 16.0f * float(y) / kSize, 16, 3);
            const float isBrick = std::clamp(0.5f + brick.edge, 0.0f, 1.0f);
            const glm::vec3 color = stain * glm::mix(mortar, glm::mix(dark, light, burnt), isBrick);
            for (int c = 0; c < 3; ++c)
                result.color.rgba.push_back(srgbByte(color[c]));
            result.color.rgba.push_back(255);
            // Green points upwards in the texture, towards smaller y.
            const glm::vec3 n = glm::normalize(
                glm::vec3(heightAt(x - 1, y) - heightAt(x + 1, y), heightAt(x, y + 1) - heightAt(x, y - 1), 2.0f));
            for (int c = 0; c < 3; ++c)
                result.normal.rgba.push_back(uint8_t(std::lround(127.5f + 127.5f * n[c])));
            result.normal.rgba.push_back(255);
        }
    return result;
}

} // namespace harness::builtin
