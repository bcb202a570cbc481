// Definition: the aggregate of every sample against the same clustering in double on the CPU.
#include "stage_host.h"

#include "core/frame_data.h"
#include "shader_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>

namespace agaa::test {
namespace {

struct Ids {
    uint32_t covered = 0;
    std::array<uint32_t, 32> id{};
};

// What the GPU defined.
Ids storedIds(const std::vector<glm::uvec4>& metadata, size_t pixel, uint32_t n, uint32_t c,
              uint32_t covered) {
    Ids ids{covered, {}};
    const glm::uvec4 texel = metadata[pixel];
    const uint64_t planes = n < 32 ? texel.x : texel.x | uint64_t(texel.y) << 32;
    for (uint32_t i = 0; i < n; ++i)
        ids.id[i] = uint32_t(planes >> i & 1) | (c > 2 ? uint32_t(planes >> (n + i) & 1) << 1 : 0);
    return ids;
}

// Samples of a pixel as the definition pass sees them, in double.
struct Pixel {
    std::unique_ptr<math_d::Clustering> clustering = std::make_unique<math_d::Clustering>();
    uint32_t covered = 0;
    double k = 0;
    double width = 0; // of one surface
};

class Oracle {
public:
    Oracle(StageView& view, const AgaaFrame& frame)
        : view_(view), constants_(frameConstants(view.plan(), frame, view.positions())),
          depth_(view.readSurface("depth")), normals_(view.readSurface("normals")) {}

    Pixel load(uint32_t x, uint32_t y) const {
        using namespace math_d;
        const Plan& plan = view_.plan();
        const float* p = constants_.projection;
        const bool orthographic = p[6] != 0.0f;
        Pixel pixel;
        double nearest2 = 1e300, quantum = 0;
        for (uint32_t i = 0; i < plan.samples; ++i) {
            const size_t s = view_.sampleIndex(x, y, i);
            const glm::uvec2 code(channel(normals_[s].x), channel(normals_[s].y));
            if (code.x + code.y == 0)
                continue;
            pixel.covered |= 1u << i;
            const double depth = double(std::bit_cast<float>(depth_[s].x));
            const double z = agaa_viewZFromDepth(depth, double(p[4]), double(p[5]), orthographic);
            const rvec2 ndc((x + double(constants_.samples[i][0])) / plan.width * 2 - 1,
                            (y + double(constants_.samples[i][1])) / plan.height * 2 - 1);
            const rvec3 position =
                agaa_viewPosition(ndc, z, double(p[0]), double(p[1]), double(p[2]), double(p[3]),
                                  orthographic);
            auto& c = *pixel.clustering;
            c.agaa_samplePosition[i] = position;
            c.agaa_sampleNormal[i] = agaa_decodeHemiOct8(code);
            c.agaa_sampleKeyA[i] = depth_[s].x;
            c.agaa_sampleKeyB[i] = code.x << 24 | code.y << 16 |
                                   uint32_t(constants_.samples[i][0] * 128) << 8 |
                                   uint32_t(constants_.samples[i][1] * 128);
            nearest2 = std::min(nearest2, glm::dot(position, position));
            const double step = p[7] < 0 ? double(-p[7]) * depth : double(p[7]);
            quantum = std::max(quantum, agaa_depthQuantum(z, depth, double(p[4]), double(p[5]),
                                                          orthographic, step));
        }
        const AgaaConfig& config = plan.config;
        pixel.k = agaa_characteristicLength(double(config.characteristicLength),
                                            double(config.characteristicLengthPerDistance),
                                            std::sqrt(nearest2), quantum,
                                            double(config.aggregateThreshold));
        const double scale = orthographic ? 1.0 : std::sqrt(nearest2);
        pixel.width = double(config.surfaceDistance) * scale * 2 / (std::abs(double(p[0])) * plan.width) + quantum;
        return pixel;
    }

private:
    static uint32_t channel(uint32_t bits) {
        return uint32_t(std::lround(std::bit_cast<float>(bits) * 255));
    }

    StageView& view_;
    FrameConstants constants_;
    std::vector<glm::uvec4> depth_, normals_;
};

// The same partition, whatever the aggregates are called.
bool samePartition(const Ids& a, const Ids& b, uint32_t n) {
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = 0; j < i; ++j)
            if ((a.covered >> i & 1) && (a.covered >> j & 1) &&
                (a.id[i] == a.id[j]) != (b.id[i] == b.id[j]))
                return false;
    return true;
}

void expectOracle(StageContext& context, const ViewSettings& settings,
                  const std::vector<Triangle>& scene) {
    StageView view(context, settings);
    view.setTriangles(scene);
    const AgaaFrame frame = view.frame();
    view.render(frame);
    const Oracle oracle(view, frame);
    const auto metadata = view.readSurface("metadata");
    const uint32_t n = view.plan().samples, c = view.plan().aggregates;
    SCOPED_TRACE("n=" + std::to_string(n) + " c=" + std::to_string(c));
    size_t pixels = 0, several = 0, ofOneSurface = 0, different = 0, outOfRange = 0, stray = 0;
    for (uint32_t y = 0; y < view.plan().height; ++y)
        for (uint32_t x = 0; x < view.plan().width; ++x) {
            const Pixel pixel = oracle.load(x, y);
            const size_t index = size_t(y) * view.plan().width + x;
            const Ids gpu = storedIds(metadata, index, n, c, pixel.covered);
            for (uint32_t i = 0; i < n; ++i) {
                outOfRange += gpu.id[i] >= c;
                stray += !(pixel.covered >> i & 1) && gpu.id[i] != 0;
            }
            if (!pixel.covered)
                continue;
            const AgaaConfig& config = view.plan().config;
            Ids cpu{pixel.covered, {}};
            const bool one = pixel.clustering->agaa_areAllOneSurface(n, pixel.covered, double(config.surfaceCosine),
                                                                     pixel.width);
            const uint32_t count = one ? 1
                                       : pixel.clustering->agaa_defineAggregates(
                                             n, pixel.covered, c, pixel.k, double(config.aggregateThreshold),
                                             config.seeds);
            for (uint32_t i = 0; i < n && !one; ++i)
                cpu.id[i] = pixel.clustering->agaa_sampleAggregate[i];
            ++pixels;
            several += count > 1;
            ofOneSurface += one && std::popcount(pixel.covered) > 1;
            different += !samePartition(gpu, cpu, n);
        }
    EXPECT_EQ(ofOneSurface == 0, (settings.config.flags & AGAA_CONFIG_SPLIT_SURFACES) != 0) << ofOneSurface;
    EXPECT_EQ(outOfRange, 0u);
    EXPECT_EQ(stray, 0u) << "samples without geometry belong to aggregate 0";
    EXPECT_GT(several, pixels / 5);
    // Distances are compared in 14 bits, so that only rounding across such a step can decide otherwise.
    EXPECT_LE(different, pixels / 200);
}

ViewSettings settingsFor(uint32_t n, uint32_t c) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.flags = AGAA_CONFIG_READBACK;
    settings.facts.shadowMapCount = 0;
    return settings;
}

TEST(Definition, AgreesWithDoubleForEverySampleAndAggregateCount) {
    StageContext context;
    const auto scene = randomTriangles({.triangles = 400}, 21);
    for (uint32_t n : {2u, 4u, 8u, 16u, 32u})
        for (uint32_t c : {2u, 3u, 4u})
            expectOracle(context, settingsFor(n, c), scene);
}

// As the paper has it: distance alone may part the samples of one surface.
TEST(Definition, AgreesWhereSurfacesMayBeSplit) {
    StageContext context;
    ViewSettings settings = settingsFor(8, 2);
    settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES;
    expectOracle(context, settings, randomTriangles({.triangles = 400}, 26));
}

TEST(Definition, AgreesForSeedsAsPrinted) {
    StageContext context;
    ViewSettings settings = settingsFor(8, 4);
    settings.config.seeds = AGAA_SEEDS_SUM_OF_SQUARES;
    expectOracle(context, settings, randomTriangles({.triangles = 400}, 22));
}

TEST(Definition, AgreesForAFixedLength) {
    StageContext context;
    ViewSettings settings = settingsFor(8, 3);
    settings.config.characteristicLength = 0.1f;
    settings.config.characteristicLengthPerDistance = 0;
    settings.config.aggregateThreshold = 0.1f;
    expectOracle(context, settings, randomTriangles({.triangles = 400}, 23));
}

TEST(Definition, HardCase16AgreesForReversedDepthAndInfiniteFarPlane) {
    StageContext context;
    ViewSettings settings = settingsFor(8, 4);
    settings.flags = AGAA_VIEW_REVERSED_Z;
    settings.projection = reversedInfinite(60, 1.5f, 0.01f);
    expectOracle(context, settings, randomTriangles({.triangles = 400}, 24));
}

TEST(Definition, HardCase55AgreesAtOddSizes) {
    StageContext context;
    const auto scene = randomTriangles({.triangles = 400}, 25);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {31u, 17u}, {97u, 1u}}) {
        ViewSettings settings = settingsFor(8, 3);
        settings.width = width;
        settings.height = height;
        StageView view(context, settings);
        view.setTriangles(scene);
        view.render(view.frame());
        EXPECT_EQ(view.readSurface("metadata").size(), size_t(width) * height);
    }
    ViewSettings settings = settingsFor(8, 3);
    settings.width = 31;
    settings.height = 17;
    expectOracle(context, settings, scene);
}

// The depth buffer puts samples of a distant wall steps of many metres apart: it stays one aggregate.
TEST(Definition, HardCase20AWallStaysOneAggregate) {
    StageContext context;
    for (float distance : {10.0f, 100.0f, 1000.0f, 4000.0f}) {
        ViewSettings settings = settingsFor(8, 4);
        settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES; // by their distance, were it not for k
        settings.projection = perspective(5, 1.5f, 0.01f, 10000);
        const float s = distance;
        std::vector<Triangle> wall;
        const glm::vec3 corners[4] = {{-s, -s, -1.1f * distance},
                                      {s, -s, -0.9f * distance},
                                      {s, s, -0.9f * distance},
                                      {-s, s, -1.1f * distance}};
        for (const auto& index : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            Triangle t;
            for (size_t i = 0; i < 3; ++i)
                t.position[i] = corners[index[i]];
            t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
            wall.push_back(t);
        }
        StageView view(context, settings);
        view.setTriangles(wall);
        view.render(view.frame());
        const auto depth = view.readSurface("depth");
        const auto metadata = view.readSurface("metadata");
        size_t split = 0, stepped = 0;
        for (uint32_t y = 0; y < settings.height; ++y)
            for (uint32_t x = 0; x < settings.width; ++x) {
                split += metadata[size_t(y) * settings.width + x].x != 0;
                stepped += depth[view.sampleIndex(x, y, 0)].x != depth[view.sampleIndex(x, y, 7)].x;
            }
        EXPECT_GT(stepped, 0u) << "the wall must cross steps of the depth buffer";
        EXPECT_EQ(split, 0u) << "at " << distance;
    }
}

} // namespace
} // namespace agaa::test
