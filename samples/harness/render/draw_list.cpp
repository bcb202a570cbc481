#include "render/draw_list.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <tuple>

namespace harness {

namespace {

// Tests the corners against the six planes in homogeneous space, in which corners behind the eye need no special case.
bool isOutside(const Mesh& mesh, const glm::dmat4& objectToClip, double margin) {
    std::array<int, 6> outside{};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) ? mesh.boundsMax.x : mesh.boundsMin.x,
                           (corner & 2) ? mesh.boundsMax.y : mesh.boundsMin.y,
                           (corner & 4) ? mesh.boundsMax.z : mesh.boundsMin.z);
        const glm::dvec4 c = objectToClip * glm::dvec4(p, 1);
        const double slack = margin * std::abs(c.w);
        outside[0] += c.x > c.w + slack;
        outside[1] += c.x < -c.w - slack;
        outside[2] += c.y > c.w + slack;
        outside[3] += c.y < -c.w - slack;
        outside[4] += c.z > c.w + slack;
        outside[5] += c.z < -slack;
    }
    return std::any_of(outside.begin(), outside.end(), [](int count) { return count == 8; });
}

// The shuffle is written out because std::shuffle differs between implementations, and images must not.
void shuffle(std::vector<Draw>::iterator begin, std::vector<Draw>::iterator end, uint32_t seed) {
    std::mt19937 random(seed);
    for (auto remaining = end - begin; remaining > 1; --remaining)
        std::swap(begin[remaining - 1], begin[random() % uint32_t(remaining)]);
}

} // namespace

bool isMasked(const Scene& scene, const Mesh& mesh) {
    return mesh.material < scene.materials.size() && scene.materials[mesh.material].alphaMode != AlphaMode::Opaque;
}

bool isDrawnIn(const AgaaDrawTarget& target, const Draw& draw) {
    const bool isOfUnfetched = target.pass == AGAA_DRAW_PASS_GBUFFER && target.state.depthCompare == AGAA_COMPARE_EQUAL;
    return !isOfUnfetched || !draw.isFetched;
}

uint32_t drawSeed(uint32_t instance) {
    uint32_t x = (instance + 1) * 0x9E3779B9u;
    x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
    x = (x ^ (x >> 13)) * 0xC2B2AE35u;
    return x ^ (x >> 16);
}

std::vector<Draw> makeDrawList(const Scene& scene, const glm::dvec3& worldOffset, const glm::dvec3& eye,
                               const glm::dmat4& clip, const DrawListOptions& options) {
    std::vector<Draw> draws;
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes.at(instance.mesh);
        if (mesh.indexCount == 0)
            continue;
        Draw draw;
        draw.mesh = instance.mesh;
        draw.instance = i;
        draw.isMasked = options.useMasked && isMasked(scene, mesh);
        draw.alphaPoints = draw.isMasked ? options.alphaPoints : 1;
        draw.isMirrored = glm::determinant(glm::dmat3(instance.transform)) < 0;
        draw.toShading = toShadingSpace(instance.transform, worldOffset, eye);
        if (!isOutside(mesh, clip * draw.toShading, options.clipMargin))
            draws.push_back(draw);
    }

    const auto order = [&](const Draw& d) {
        return std::tuple(d.isMasked, scene.meshes[d.mesh].material, d.isMirrored, d.instance);
    };
    std::sort(draws.begin(), draws.end(), [&](const Draw& a, const Draw& b) { return order(a) < order(b); });
    if (options.shuffleSeed != 0) {
        const auto masked = std::find_if(draws.begin(), draws.end(), [](const Draw& d) { return d.isMasked; });
        shuffle(draws.begin(), masked, options.shuffleSeed);
        shuffle(masked, draws.end(), options.shuffleSeed);
    }
    return draws;
}

} // namespace harness
