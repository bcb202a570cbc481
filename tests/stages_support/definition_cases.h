// Definition: the aggregate of every sample against the same clustering in double on the CPU. Each graphics
// API instantiates these.
#pragma once

#include "agreement.h"
#include "setting_share.h"
#include "surfaces.h"
#include "view_settings.h"

#include "core/frame/frame_data.h"
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

namespace agaa::test {

namespace definition {
namespace { // internal, because the types of shader_math.h are

struct Ids {
    uint32_t covered = 0;
    std::array<uint32_t, 32> id{};
};

// What the GPU defined.
Ids storedIds(const std::vector<glm::uvec4>& metadata, size_t pixel, uint32_t n, uint32_t c, uint32_t covered) {
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

glm::dvec3 viewPosition(const Plan& plan, const FrameConstants& constants, uint32_t x, uint32_t y, uint32_t i,
                        double depth) {
    const FrameConstants& c = constants;
    const double z =
        math_d::agaa_viewZFromDepth(depth, double(c.projection22), double(c.projection32), c.isOrthographic);
    const glm::dvec2 ndc((x + double(constants.sampleLocations[i][0])) / plan.view.width * 2 - 1,
                         (y + double(constants.sampleLocations[i][1])) / plan.view.height * 2 - 1);
    return math_d::agaa_viewPosition(ndc, z, double(c.projectionScale[0]), double(c.projectionScale[1]),
                                     double(c.projectionOffset[0]), double(c.projectionOffset[1]), c.isOrthographic);
}

template <class View> class Oracle {
public:
    Oracle(View& view, const AgaaFrame& frame)
        : view_(view), constants_(frameConstants(view.plan(), frame, view.positions())),
          depth_(view.readSurface("depth")), normals_(view.readSurface("normals")) {}

    Pixel load(uint32_t x, uint32_t y) const {
        using namespace math_d;
        const Plan& plan = view_.plan();
        const FrameConstants& f = constants_;
        const bool orthographic = f.isOrthographic;
        const double p00 = double(f.projectionScale[0]);
        Pixel pixel;
        double nearest2 = 1e300, nearestZ = 1e300;
        const rvec2 centre((x + 0.5) / plan.view.width * 2 - 1, (y + 0.5) / plan.view.height * 2 - 1);
        const rvec3 ray = agaa_viewPosition(centre, -1.0, p00, double(f.projectionScale[1]),
                                            double(f.projectionOffset[0]), double(f.projectionOffset[1]), orthographic);
        const rvec3 v = orthographic ? rvec3(0, 0, 1) : glm::normalize(-ray);
        rvec3 t, b;
        agaa_viewBasis(v, t, b);
        for (uint32_t i = 0; i < plan.view.samples; ++i) {
            const size_t s = view_.sampleIndex(x, y, i);
            const glm::uvec2 code(channel(normals_[s].x), channel(normals_[s].y));
            if (code.x + code.y == 0)
                continue;
            pixel.covered |= 1u << i;
            const double depth = double(std::bit_cast<float>(depth_[s].x));
            const rvec3 position = viewPosition(plan, constants_, x, y, i, depth);
            const double z = position.z;
            auto& c = *pixel.clustering;
            c.agaa_samplePosition[i] = position;
            c.agaa_sampleNormal[i] = glm::dmat3(t, b, v) * agaa_decodeHemiOct8(code);
            c.agaa_sampleKeyA[i] = depth_[s].x;
            c.agaa_sampleKeyB[i] = code.x << 24 | code.y << 16 | uint32_t(constants_.sampleLocations[i][0] * 128) << 8 |
                                   uint32_t(constants_.sampleLocations[i][1] * 128);
            nearest2 = std::min(nearest2, glm::dot(position, position));
            nearestZ = std::min(nearestZ, std::abs(z));
            const double step = f.depthQuantum < 0 ? double(-f.depthQuantum) * depth : double(f.depthQuantum);
            c.agaa_sampleStep[i] =
                agaa_depthQuantum(z, depth, double(f.projection22), double(f.projection32), orthographic, step);
        }
        const AgaaConfig& config = plan.view.config;
        pixel.k = agaa_characteristicLength(double(plan.view.aggregation.characteristicLength),
                                            double(plan.view.aggregation.characteristicLengthPerDistance),
                                            orthographic ? 1 / std::abs(p00) : std::sqrt(nearest2));
        const double scale = orthographic ? 1.0 : nearestZ;
        pixel.width = double(config.surfaceDistance) * scale * 2 / (std::abs(p00) * plan.view.width);
        return pixel;
    }

private:
    static uint32_t channel(uint32_t bits) { return uint32_t(std::lround(std::bit_cast<float>(bits) * 255)); }

    View& view_;
    FrameConstants constants_;
    std::vector<glm::uvec4> depth_, normals_;
};

// The same partition, whatever the aggregates are called.
bool samePartition(const Ids& a, const Ids& b, uint32_t n) {
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = 0; j < i; ++j)
            if ((a.covered >> i & 1) && (a.covered >> j & 1) && (a.id[i] == a.id[j]) != (b.id[i] == b.id[j]))
                return false;
    return true;
}

struct Agreement {
    size_t pixels = 0;       // that show geometry
    size_t several = 0;      // of these, that have more than one aggregate
    size_t ofOneSurface = 0; // of these, that have one for that reason
    size_t different = 0;    // of these, that the GPU parts otherwise
};

template <class Host>
Agreement compareWithOracle(typename Host::Context& context, const ViewSettings& settings,
                            const std::vector<Triangle>& scene) {
    typename Host::View view(context, settings);
    view.setTriangles(scene);
    const AgaaFrame frame = view.frame();
    view.render(frame);
    const Oracle<typename Host::View> oracle(view, frame);
    const auto metadata = view.readSurface("metadata");
    const uint32_t n = view.plan().view.samples, c = view.plan().view.aggregates;
    Agreement found;
    size_t outOfRange = 0, stray = 0;
    for (uint32_t y = 0; y < view.plan().view.height; ++y)
        for (uint32_t x = 0; x < view.plan().view.width; ++x) {
            const Pixel pixel = oracle.load(x, y);
            const size_t index = size_t(y) * view.plan().view.width + x;
            const Ids gpu = storedIds(metadata, index, n, c, pixel.covered);
            for (uint32_t i = 0; i < n; ++i) {
                outOfRange += gpu.id[i] >= c;
                stray += !(pixel.covered >> i & 1) && gpu.id[i] != 0;
            }
            if (!pixel.covered)
                continue;
            const AgaaConfig& config = view.plan().view.config;
            Ids cpu{pixel.covered, {}};
            pixel.clustering->hasPlanes = view.plan().view.measurement.flags & AGAA_MEASURE_DEPTH_PLANES;
            const bool one =
                pixel.clustering->agaa_areAllOneSurface(n, pixel.covered, double(config.surfaceCosine), pixel.width);
            const uint32_t count =
                one ? 1
                    : pixel.clustering->agaa_defineAggregates(n, pixel.covered, c, pixel.k,
                                                              double(view.plan().view.aggregation.aggregateThreshold),
                                                              view.plan().view.measurement.seeds);
            for (uint32_t i = 0; i < n && !one; ++i)
                cpu.id[i] = pixel.clustering->agaa_sampleAggregate[i];
            ++found.pixels;
            found.several += count > 1;
            found.ofOneSurface += one && std::popcount(pixel.covered) > 1;
            found.different += !samePartition(gpu, cpu, n);
        }
    EXPECT_EQ(outOfRange, 0u);
    EXPECT_EQ(stray, 0u) << "samples without geometry belong to aggregate 0";
    return found;
}

template <class Host>
void expectOracle(typename Host::Context& context, const ViewSettings& settings, const std::vector<Triangle>& scene) {
    SCOPED_TRACE("n=" + std::to_string(settings.config.samples) + " c=" + std::to_string(settings.config.aggregates));
    const Agreement found = compareWithOracle<Host>(context, settings, scene);
    EXPECT_EQ(found.ofOneSurface == 0, (settings.config.flags & AGAA_CONFIG_SPLIT_SURFACES) != 0) << found.ofOneSurface;
    EXPECT_GT(found.several, found.pixels / 5);
    // Distances are compared in 14 bits, so that only rounding across such a step can decide otherwise.
    EXPECT_LE(found.different, found.pixels / 200);
}

ViewSettings settingsFor(uint32_t n, uint32_t c) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.flags = AGAA_CONFIG_READBACK;
    settings.facts.shadowMapCount = 0;
    return settings;
}

// A square of two triangles; `side` is along one of its edges.
void addSquare(std::vector<Triangle>& scene, const glm::vec3& normal, const glm::vec3& side, const glm::vec3& centre,
               float size) {
    const glm::vec3 up = glm::cross(side, normal);
    const glm::vec3 corners[4] = {centre - size * (side + up), centre + size * (side - up), centre + size * (side + up),
                                  centre + size * (up - side)};
    for (const auto& index : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        Triangle t;
        for (size_t i = 0; i < 3; ++i)
            t.position[i] = corners[index[i]];
        t.material.geometricNormal = t.material.normal = glm::vec4(planeNormal(t), 0);
        t.material.normal.w = 0.5f;
        scene.push_back(t);
    }
}

struct Split {
    size_t several = 0; // pixels of more than one aggregate
    size_t layered = 0; // that show both layers, more than a pixel's width apart
    size_t wrong = 0;   // one but not the other; pixels where the gap is about a width are left out
};

// A plane through (0, 0, -6) with this normal, both in view space, and a parallel one in front of its one half, if
// the gap is not 0. The camera is turned, so that no axis of the host's is one of the view's.
template <class Host>
Split splitPixels(typename Host::Context& context, uint32_t tier, const glm::vec3& normal, float gap) {
    ViewSettings settings = settingsFor(8, 2);
    settings.config.generationTier = tier;
    settings.config.flags |= tier == AGAA_TIER_GBUFFER ? AGAA_CONFIG_BUFFERED : 0; // for the metadata
    settings.view =
        glm::mat4(glm::mat3(glm::vec3(0.36f, 0.48f, -0.8f), glm::vec3(-0.8f, 0.6f, 0), glm::vec3(0.48f, 0.64f, 0.6f)));
    const glm::mat3 toShading = glm::transpose(glm::mat3(settings.view));
    const glm::vec3 side = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 0.9f, 0.2f)));
    const glm::vec3 behind(0, 0, -6);
    constexpr float size = 30;
    std::vector<Triangle> scene;
    addSquare(scene, toShading * normal, toShading * side, toShading * behind, size);
    if (gap > 0)
        addSquare(scene, toShading * normal, toShading * side, toShading * (behind + gap * normal + size * side), size);
    typename Host::View view(context, settings);
    view.setTriangles(scene);
    const AgaaFrame frame = view.frame();
    view.render(frame);
    const FrameConstants constants = frameConstants(view.plan(), frame, view.positions());
    const auto depth = view.readSurface("depth");
    const auto metadata = view.readSurface("metadata");
    Split split;
    for (uint32_t y = 0; y < settings.height; ++y)
        for (uint32_t x = 0; x < settings.width; ++x) {
            double least = 1e9, most = -1e9, nearest = 1e9;
            for (uint32_t i = 0; i < 8; ++i) {
                const double d = double(std::bit_cast<float>(depth[view.sampleIndex(x, y, i)].x));
                if (d == 1) // no geometry
                    continue;
                const glm::dvec3 at = viewPosition(view.plan(), constants, x, y, i, d);
                const double along = glm::dot(at - glm::dvec3(behind), glm::dvec3(normal));
                nearest = std::min(nearest, -at.z);
                least = std::min(least, along);
                most = std::max(most, along);
            }
            const double width = nearest * 2 / (double(constants.projectionScale[0]) * settings.width);
            if (gap > 0 && std::abs(gap / width - 1) < 0.1)
                continue;
            const bool layered = gap > width && most - least > double(gap) / 2;
            const bool several = metadata[size_t(y) * settings.width + x].x != 0;
            split.layered += layered;
            split.several += several;
            split.wrong += layered != several;
        }
    return split;
}

const glm::vec3 slopes[] = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.8f, 0.6f}, {-0.64f, 0.48f, 0.6f}};
constexpr uint32_t tiers[] = {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER};

} // namespace
} // namespace definition

template <class Host> class DefinitionCases : public testing::Test, protected SettingCounter<Host> {
protected:
    void expectOracle(const ViewSettings& settings, const std::vector<Triangle>& scene) {
        definition::expectOracle<Host>(context, settings, scene);
    }
    typename Host::Context context;
};

TYPED_TEST_SUITE_P(DefinitionCases);

TYPED_TEST_P(DefinitionCases, AgreesWithDoubleForEverySampleAndAggregateCount) {
    const auto scene = randomTriangles({.triangles = 400}, 21);
    for (uint32_t n : {2u, 4u, 8u, 16u, 32u})
        for (uint32_t c : {2u, 3u, 4u})
            if (this->rendersNext())
                this->expectOracle(definition::settingsFor(n, c), scene);
}

// Distance alone may part the samples of one surface.
TYPED_TEST_P(DefinitionCases, AgreesWhereSurfacesMayBeSplit) {
    ViewSettings settings = definition::settingsFor(8, 2);
    settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES;
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 26));
}

TYPED_TEST_P(DefinitionCases, AgreesForSeedsAsPrinted) {
    ViewSettings settings = definition::settingsFor(8, 4);
    settings.config.measurement.seeds = AGAA_SEEDS_SUM_OF_SQUARES;
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 22));
}

// AGAA 4.1: planes in place of samples. Triangles of these sizes show few planes in most pixels.
TYPED_TEST_P(DefinitionCases, AgreesForPlanes) {
    for (const uint32_t c : {2u, 4u}) {
        ViewSettings settings = definition::settingsFor(8, c);
        settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES;
        settings.config.measurement.flags = AGAA_MEASURE_DEPTH_PLANES;
        settings.config.measurement.lanes = AGAA_LANES_PIXEL;
        this->expectOracle(settings, randomTriangles({.triangles = 60}, 29));
    }
}

TYPED_TEST_P(DefinitionCases, AgreesForAFixedLength) {
    ViewSettings settings = definition::settingsFor(8, 3);
    settings.config.aggregation.characteristicLength = 0.1f;
    settings.config.aggregation.characteristicLengthPerDistance = 0;
    settings.config.aggregation.aggregateThreshold = 0.1f;
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 23));
}

TYPED_TEST_P(DefinitionCases, AgreesForOrthographicViews) {
    ViewSettings settings = definition::settingsFor(8, 3);
    settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES;
    settings.projection = pixelOrthographic(12, 8, 25);
    settings.projection[3] = glm::vec4(0, 0, 0, 1);
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 28));
}

// The eye of an orthographic view is an arbitrary point: a step between two layers is parted everywhere or nowhere,
// wherever the eye is.
TYPED_TEST_P(DefinitionCases, StepsInOrthographicViewsArePartedAlike) {
    for (const float eye : {0.0f, 1000.0f})
        for (const float gap : {2.0f, 5.0f}) { // k is 24, of which k sqrt(t) is 3.4
            ViewSettings settings = definition::settingsFor(8, 2);
            settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES;
            settings.config.aggregation.characteristicLengthPerDistance = 1;
            settings.projection = pixelOrthographic(48, 32, 10);
            settings.projection[3].x += 2 * eye / 48;
            Material material;
            std::vector<Triangle> scene = rectangle(0, 0, 48, 32, 9, material);
            for (int x = 0; x < 48; ++x)
                for (const Triangle& t : rectangle(float(x), 0, float(x) + 0.5f, 32, 9 - gap, material))
                    scene.push_back(t);
            for (Triangle& t : scene)
                for (glm::vec3& p : t.position)
                    p.x -= eye;
            typename TypeParam::View view(this->context, settings);
            view.setTriangles(scene);
            view.render(view.frame());
            size_t parted = 0;
            for (const glm::uvec4& texel : view.readSurface("metadata"))
                parted += texel.x != 0;
            EXPECT_EQ(parted, gap < 3 ? 0u : 48u * 32u) << eye << ' ' << gap;
        }
}

TYPED_TEST_P(DefinitionCases, AgreesForOtherSurfaces) {
    ViewSettings settings = definition::settingsFor(8, 3);
    settings.config.surfaceCosine = 0.5f;
    settings.config.surfaceDistance = 4;
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 27));
}

TYPED_TEST_P(DefinitionCases, HardCase16AgreesForReversedDepthAndInfiniteFarPlane) {
    ViewSettings settings = definition::settingsFor(8, 4);
    settings.flags = AGAA_VIEW_REVERSED_Z;
    settings.projection = reversedInfinite(60, 1.5f, 0.01f);
    this->expectOracle(settings, randomTriangles({.triangles = 400}, 24));
}

TYPED_TEST_P(DefinitionCases, HardCase55AgreesAtOddSizes) {
    const auto scene = randomTriangles({.triangles = 400}, 25);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {31u, 17u}, {97u, 1u}}) {
        ViewSettings settings = definition::settingsFor(8, 3);
        settings.width = width;
        settings.height = height;
        const definition::Agreement found = definition::compareWithOracle<TypeParam>(this->context, settings, scene);
        EXPECT_GT(found.several, 0u) << width;
        EXPECT_LE(found.different, found.pixels / 200) << width;
    }
}

TYPED_TEST_P(DefinitionCases, ASurfaceIsOneAggregateAtAnySlope) {
    for (const uint32_t tier : definition::tiers)
        for (const glm::vec3& normal : definition::slopes)
            EXPECT_EQ(definition::splitPixels<TypeParam>(this->context, tier, normal, 0).several, 0u)
                << normal.x << ' ' << normal.y;
}

TYPED_TEST_P(DefinitionCases, ParallelLayersAreTwoAggregates) {
    for (const uint32_t tier : definition::tiers)
        for (const glm::vec3& normal : definition::slopes)
            for (const float gap : {0.9f, 2.0f}) {
                const definition::Split split = definition::splitPixels<TypeParam>(this->context, tier, normal, gap);
                EXPECT_GT(split.layered, 5u);
                EXPECT_EQ(split.wrong, 0u) << normal.x << ' ' << normal.y << ' ' << gap << ": " << split.layered
                                           << " with two layers, " << split.several << " split";
            }
}

// The depth buffer puts samples of a distant wall steps of many metres apart: it stays one aggregate.
TYPED_TEST_P(DefinitionCases, HardCase20AWallStaysOneAggregate) {
    for (float distance : {10.0f, 100.0f, 1000.0f, 4000.0f}) {
        ViewSettings settings = definition::settingsFor(8, 4);
        settings.config.flags |= AGAA_CONFIG_SPLIT_SURFACES; // by their distance, were it not for k
        settings.projection = perspective(5, 1.5f, 0.01f, 10000);
        const float s = distance;
        std::vector<Triangle> wall;
        const glm::vec3 corners[4] = {
            {-s, -s, -1.1f * distance}, {s, -s, -0.9f * distance}, {s, s, -0.9f * distance}, {-s, s, -1.1f * distance}};
        for (const auto& index : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            Triangle t;
            for (size_t i = 0; i < 3; ++i)
                t.position[i] = corners[index[i]];
            t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
            wall.push_back(t);
        }
        typename TypeParam::View view(this->context, settings);
        view.setTriangles(wall);
        view.render(view.frame());
        const auto depth = view.readSurface("depth");
        const auto metadata = view.readSurface("metadata");
        size_t split = 0, stepped = 0;
        for (uint32_t y = 0; y < settings.height; ++y)
            for (uint32_t x = 0; x < settings.width; ++x) {
                split += metadata[size_t(y) * settings.width + x].x != 0;
                for (uint32_t i = 1; i < 8; ++i)
                    stepped += depth[view.sampleIndex(x, y, 0)].x != depth[view.sampleIndex(x, y, i)].x;
            }
        if (isInOrder(this->context.caps())) { // an NVIDIA H200 has no step there
            EXPECT_GT(stepped, 0u) << "the wall must cross steps of the depth buffer";
        }
        EXPECT_EQ(split, 0u) << "at " << distance;
    }
}

// A backdrop at 1 km, whose step of depth is 0.6 m, is seen between thin rails at 5 m and 6 m: the rails are aggregates
// of their own.
TYPED_TEST_P(DefinitionCases, HardCase20AFarBackdropLeavesNearRailsApart) {
    for (const uint32_t tier : definition::tiers) {
        ViewSettings settings = definition::settingsFor(8, 3);
        settings.config.generationTier = tier;
        settings.config.flags |= tier == AGAA_TIER_GBUFFER ? AGAA_CONFIG_BUFFERED : 0;
        settings.width = 16;
        settings.height = 8;
        settings.projection = perspective(0.4f, 1.5f, 0.1f, 2000);                      // a pixel is 0.7 m wide at 1 km
        const float column = 2 * 1.5f * std::tan(0.5f * 0.4f * 3.14159265f / 180) / 16; // a pixel's width at 1 m
        std::vector<Triangle> scene;
        definition::addSquare(scene, {0, 0, 1}, {1, 0, 0}, {0, 0, -1000}, 2000);
        for (int x = 0; x < 16; ++x)
            for (const float distance : {5.0f, 6.0f}) {
                const float from = (float(x - 8) + (distance < 5.5f ? 0.0f : 0.4f)) * column * distance;
                const float to = from + 0.4f * column * distance;
                for (const auto& top : {glm::vec3(from, 9, -distance), glm::vec3(to, -9, -distance)}) {
                    Triangle t;
                    t.position[0] = glm::vec3(from, -9, -distance);
                    t.position[1] = top.y < 0 ? top : glm::vec3(to, 9, -distance);
                    t.position[2] = top.y < 0 ? glm::vec3(to, 9, -distance) : top;
                    t.material.geometricNormal = glm::vec4(0, 0, 1, 0);
                    scene.push_back(t);
                }
            }
        typename TypeParam::View view(this->context, settings);
        view.setTriangles(scene);
        const AgaaFrame frame = view.frame();
        view.render(frame);
        const FrameConstants constants = frameConstants(view.plan(), frame, view.positions());
        const auto depth = view.readSurface("depth");
        const auto metadata = view.readSurface("metadata");
        size_t wrong = 0;
        for (uint32_t y = 0; y < settings.height; ++y)
            for (uint32_t x = 0; x < settings.width; ++x) {
                const definition::Ids ids = definition::storedIds(metadata, size_t(y) * settings.width + x, 8, 3, 0xFF);
                std::array<double, 8> z{};
                for (uint32_t i = 0; i < 8; ++i) {
                    const double d = double(std::bit_cast<float>(depth[view.sampleIndex(x, y, i)].x));
                    z[i] = std::max(definition::viewPosition(view.plan(), constants, x, y, i, d).z, -100.0);
                }
                for (uint32_t i = 0; i < 8; ++i)
                    for (uint32_t j = 0; j < i; ++j)
                        wrong += (ids.id[i] == ids.id[j]) != (std::abs(z[i] - z[j]) < 0.5);
            }
        EXPECT_EQ(wrong, 0u) << "pairs of samples";
    }
}

REGISTER_TYPED_TEST_SUITE_P(DefinitionCases, AgreesWithDoubleForEverySampleAndAggregateCount,
                            AgreesWhereSurfacesMayBeSplit, AgreesForSeedsAsPrinted, AgreesForPlanes,
                            AgreesForAFixedLength, AgreesForOrthographicViews, StepsInOrthographicViewsArePartedAlike,
                            AgreesForOtherSurfaces, HardCase16AgreesForReversedDepthAndInfiniteFarPlane,
                            HardCase55AgreesAtOddSizes, ASurfaceIsOneAggregateAtAnySlope,
                            ParallelLayersAreTwoAggregates, HardCase20AWallStaysOneAggregate,
                            HardCase20AFarBackdropLeavesNearRailsApart);

} // namespace agaa::test
