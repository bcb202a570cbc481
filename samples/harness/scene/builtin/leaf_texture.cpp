#include "scene/builtin/leaf_texture.h"

#include "scene/builtin/mesh_builder.h"
#include "scene/random.h"

#include <algorithm>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kSize = 256;
constexpr float kSoftness = 2.5f / kSize; // half the width of the alpha ramp

struct Leaf {
    glm::vec2 foot, axis; // axis is unit
    float length, halfWidth;
    float youth; // blend of the texture's two colours, [0, 1]
};

// Leaves alternate between left and right along the twig; one is at its tip.
std::vector<Leaf> leavesOf(const LeafPicture& picture) {
    Random random(picture.seed);
    std::vector<Leaf> leaves;
    for (int i = 0; i < picture.leaves; ++i) {
        const bool tip = i + 1 == picture.leaves;
        const float along = float(i) / float(picture.leaves);
        const float side = i % 2 ? 1.0f : -1.0f;
        const float angle = tip ? 0.0f : side * random.in(0.7f, 1.15f);
        const float length = picture.length * random.in(0.8f, 1.0f) * (1 - 0.35f * along);
        Leaf leaf;
        leaf.foot = {0.5f, 0.06f + 0.6f * along};
        leaf.axis = {std::sin(angle), std::cos(angle)};
        leaf.length = length;
        leaf.halfWidth = 0.5f * picture.slenderness * length;
        leaf.youth = random.in(0.0f, 1.0f);
        leaves.push_back(leaf);
    }
    return leaves;
}

struct LeafPoint {
    float inside; // distance to the outline, positive inside
    float along;  // 0 at the foot, 1 at the tip
    float across; // -1 to 1 between the edges
};

LeafPoint leafPoint(const Leaf& leaf, const glm::vec2& p) {
    const glm::vec2 d = p - leaf.foot;
    const float along = glm::dot(d, leaf.axis) / leaf.length;
    const float across = d.x * leaf.axis.y - d.y * leaf.axis.x;
    const float s = std::clamp(along, 0.0f, 1.0f);
    const float half = leaf.halfWidth * std::sqrt(s) * (1 - s) * 2.6f; // the leaf is broadest at a third of its length
    const float beyond = std::max({0.0f, -along, along - 1}) * leaf.length;
    return {half - std::fabs(across) - beyond, s, half > 0 ? std::clamp(across / half, -1.0f, 1.0f) : 0.0f};
}

} // namespace

Texture leafTexture(const LeafPicture& picture) {
    const std::vector<Leaf> leaves = leavesOf(picture);
    const glm::vec3 old = linearFromSrgb(picture.color), young = linearFromSrgb(picture.youngColor);
    const glm::vec3 wood = linearFromSrgb(0x6b5433);
    Texture texture;
    texture.name = "leaves";
    texture.width = texture.height = kSize;
    texture.srgb = true;
    texture.wrapU = texture.wrapV = Wrap::Clamp;
    texture.rgba.reserve(size_t(kSize) * kSize * 4);
    for (int row = 0; row < kSize; ++row)
        for (int column = 0; column < kSize; ++column) {
            const glm::vec2 p{(float(column) + 0.5f) / kSize, 1 - (float(row) + 0.5f) / kSize};
            // The twig, a little thinner towards its tip.
            const float twig = p.y < 0.7f ? 0.012f - 0.008f * p.y - std::fabs(p.x - 0.5f) : -1.0f;
            float inside = twig;
            glm::vec3 color = wood;
            float nearest = twig;
            for (const Leaf& leaf : leaves) {
                const LeafPoint at = leafPoint(leaf, p);
                inside = std::max(inside, at.inside);
                // Later leaves lie above earlier ones.
                if (at.inside <= nearest && at.inside < 0)
                    continue;
                nearest = at.inside;
                const float rib = std::fabs(at.across) < 0.08f ? 1.3f : 1.0f;
                const float veins = 0.88f + 0.12f * std::cos(60 * (at.along - 0.25f * std::fabs(at.across)));
                color = rib * veins * glm::mix(old, young, leaf.youth);
            }
            const float alpha = std::clamp(0.5f + 0.5f * inside / kSoftness, 0.0f, 1.0f);
            for (int c = 0; c < 3; ++c)
                texture.rgba.push_back(srgbByte(color[c]));
            texture.rgba.push_back(uint8_t(std::lround(255 * alpha)));
        }
    return texture;
}

} // namespace harness::builtin
