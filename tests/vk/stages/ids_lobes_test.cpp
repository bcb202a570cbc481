// Lobes of aggregates whose normals spread in one direction, and of primitives whose normals turn inside a pixel.
#include "ids_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace agaa::test {
namespace {

// Strips of a wall, several to a pixel, whose normals tilt in one direction at random.
std::vector<Triangle> strips(float angle, const std::function<void(Triangle&)>& change) {
    std::vector<Triangle> triangles;
    for (uint32_t strip = 0; strip < 600; ++strip) {
        const float y0 = -6 + 0.02f * float(strip), y1 = y0 + 0.02f;
        const float tilt = angle * (float(strip * 2654435761u >> 8 & 0xFFFFu) / 65535.0f - 0.5f);
        Triangle triangle;
        triangle.material.normal = glm::vec4(0, std::sin(tilt), std::cos(tilt), 1);
        change(triangle);
        const glm::vec3 corners[] = {{-8, y0, -5}, {8, y0, -5}, {8, y1, -5}, {-8, y1, -5}};
        for (const auto& three : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            for (int i = 0; i < 3; ++i)
                triangle.position[i] = corners[three[size_t(i)]];
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

harness::Image shown(StageContext& context, const ViewSettings& settings, const std::vector<Triangle>& triangles) {
    if (settings.config.generationTier == AGAA_TIER_IDS)
        return IdsView(context, settings, {.triangles = triangles}).render();
    StageView view(context, settings);
    return drawn(view, triangles);
}

// Normals that spread in one direction, several to a pixel, shine in a streak; a lobe as wide in all directions blurs
// it. In the mean along the streak, where samples do not tell, the elliptic one has the profile of shading every
// sample.
TEST(IdsLobes, EllipticOnesKeepAStreakNarrow) {
    StageContext context;
    const std::vector<Triangle> triangles = strips(0.9f, [](Triangle& triangle) {
        triangle.material.normal.w = 0.01f;
        triangle.material.specular = glm::vec4(0.9f, 0.8f, 0.5f, 0);
    });
    const auto profile = [&](const char* technique, uint32_t tier, uint32_t ndf, uint64_t flags = 0) {
        ViewSettings settings = settingsFor(8, 1, tier);
        settings.config.technique = technique;
        settings.config.ndf = ndf;
        settings.config.flags |= flags;
        const harness::Image image = shown(context, settings, triangles);
        std::vector<double> columns(image.width, 0.0);
        for (size_t p = 0; p < image.pixelCount(); ++p)
            columns[p % image.width] += double(image.rgb[3 * p]) / double(image.height);
        return columns;
    };
    const std::vector<double> truth = profile("ssaa", AGAA_TIER_AUTO, AGAA_NDF_TOKSVIG);
    const uint64_t inMemory = AGAA_CONFIG_BUFFERED;
    for (const auto& [tier, flags] : {std::pair{AGAA_TIER_GBUFFER, uint64_t(0)},
                                      {AGAA_TIER_IDS, uint64_t(0)},
                                      {AGAA_TIER_GBUFFER, inMemory},
                                      {AGAA_TIER_IDS, inMemory},
                                      {AGAA_TIER_PER_SAMPLE, uint64_t(0)}}) {
        const auto error = [&](uint32_t ndf) {
            const std::vector<double> shown = profile("agaa", tier, ndf, flags);
            double sum = 0, all = 0;
            for (size_t x = 0; x < truth.size(); ++x) {
                sum += (shown[x] - truth[x]) * (shown[x] - truth[x]);
                all += truth[x] * truth[x];
            }
            return std::sqrt(sum / all);
        };
        const double round = error(AGAA_NDF_TOKSVIG), lean = error(AGAA_NDF_LEAN), sggx = error(AGAA_NDF_SGGX);
        std::printf("%s%s: relative error of the profile, round %.3f, LEAN %.3f, SGGX %.3f\n", agaaTierName(tier),
                    flags ? ", buffered" : "", round, lean, sggx);
        EXPECT_GT(round, 0.1) << "there is something to gain";
        EXPECT_LT(lean, 0.42 * round);
        EXPECT_LT(sggx, 0.72 * round);
    }
}

// Each filter of the diffuse term comes nearer to shading every sample than none, by the same amount in all tiers:
// aggregates in memory have the moments of those that are shaded at once.
TEST(IdsLobes, FiltersOfTheDiffuseTermAgreeInAllTiers) {
    StageContext context;
    const std::vector<Triangle> triangles =
        strips(2.8f, [](Triangle& triangle) { triangle.material.diffuse = glm::vec4(0.8f, 0.6f, 0.4f, 1); });
    const auto mean = [&](const char* technique, uint32_t tier, uint64_t flags, uint32_t filter,
                          uint64_t measured = 0) {
        ViewSettings settings = settingsFor(8, 1, tier);
        settings.config.technique = technique;
        settings.config.flags |= flags;
        settings.config.measurement.diffuseFilter = filter;
        settings.config.measurement.flags = measured;
        settings.facts.flags &= ~AGAA_FACT_SPECULAR;
        const harness::Image image = shown(context, settings, triangles);
        double sum = 0;
        for (size_t p = 0; p < image.pixelCount(); ++p)
            sum += double(image.rgb[3 * p]) / double(image.pixelCount());
        return sum;
    };
    const double truth = mean("ssaa", AGAA_TIER_AUTO, 0, AGAA_DIFFUSE_RECTIFIED);
    const double plain =
        mean("agaa", AGAA_TIER_GBUFFER, 0, AGAA_DIFFUSE_RECTIFIED, AGAA_MEASURE_NO_DIFFUSE_FILTER) / truth;
    for (const uint32_t filter : {AGAA_DIFFUSE_RECTIFIED, AGAA_DIFFUSE_MISES_FISHER, AGAA_DIFFUSE_SGGX}) {
        const double atOnce = mean("agaa", AGAA_TIER_GBUFFER, 0, filter) / truth;
        std::printf("filter %u: %.4f of the light, without filter %.4f\n", filter, atOnce, plain);
        EXPECT_LT(std::fabs(atOnce - 1), 0.2 * std::fabs(plain - 1)) << filter;
        for (const auto& [tier, flags] : {std::pair{AGAA_TIER_IDS, uint64_t(0)},
                                          {AGAA_TIER_GBUFFER, AGAA_CONFIG_BUFFERED},
                                          {AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED},
                                          {AGAA_TIER_PER_SAMPLE, uint64_t(0)}})
            EXPECT_NEAR(mean("agaa", tier, flags, filter) / truth, atOnce, 5e-4) << agaaTierName(tier) << ' ' << filter;
    }
}

// A curved thing as flat triangles, by four times as many a step: their normals are those of one surface, at their
// places.
std::vector<Triangle> cut(std::vector<Triangle> triangles, int steps) {
    for (; steps > 0; --steps) {
        std::vector<Triangle> quarters;
        for (const Triangle& t : triangles) {
            const auto& p = t.position;
            const glm::vec3 ab = 0.5f * (p[0] + p[1]), bc = 0.5f * (p[1] + p[2]), ca = 0.5f * (p[2] + p[0]);
            for (const auto& corners : {std::array{p[0], ab, ca}, {ab, p[1], bc}, {ca, bc, p[2]}, {ab, bc, ca}}) {
                Triangle quarter = t;
                std::copy(corners.begin(), corners.end(), quarter.position);
                quarters.push_back(quarter);
            }
        }
        triangles = std::move(quarters);
    }
    return triangles;
}

// Normals of a wave over the place.
const std::string waves = R"(
    vec3 place = vec3(0.0), dx = vec3(0.0), dy = vec3(0.0);
    for (uint i = 0u; i < 3u; ++i) {
        vec3 corner = hostVertices.data[6u * p.primitive + 2u * i].xyz;
        place += p.at[i] * corner;
        dx += p.dx[i] * corner;
        dy += p.dy[i] * corner;
    }
    m.diffuse = vec3(0.2, 0.3, 0.1);
    m.specular = vec3(0.8);
    m.alpha2 = 0.002;
    vec3 n = vec3(sin(9.0 * place.x + 2.0 * place.y), 0.4 * sin(5.0 * place.y - place.x), 1.5);
    float scale = inversesqrt(dot(n, n));
    m.normal = scale * n;
)";
// What the change of the normal is.
const std::string told = waves + R"(
    float cx = 9.0 * cos(9.0 * place.x + 2.0 * place.y), cy = 0.4 * cos(5.0 * place.y - place.x);
    mat3 grows = mat3(vec3(cx, -cy, 0.0), vec3(cx / 4.5, 5.0 * cy, 0.0), vec3(0.0));
    vec3 nx = scale * (grows * dx), ny = scale * (grows * dy);
    m.normalDx = nx - m.normal * dot(m.normal, nx);
    m.normalDy = ny - m.normal * dot(m.normal, ny);
)";

// A curved primitive's normals differ inside a pixel: told by their change from pixel to pixel, it shows what small
// flat triangles of the same surface show.
TEST(IdsLobes, CurvedPrimitivesShowWhatSmallFlatOnesShow) {
    StageContext context;
    std::vector<Triangle> whole(1);
    whole[0].position[0] = {-6, -4, -4};
    whole[0].position[1] = {6, -4, -5};
    whole[0].position[2] = {0, 6, -6};
    const auto shown = [&](const std::string& text, int steps, uint32_t c, uint32_t ndf, uint64_t flags = 0) {
        ViewSettings settings = settingsFor(8, c, AGAA_TIER_IDS);
        settings.config.ndf = ndf;
        settings.config.flags |= flags;
        settings.config.aggregation.glossWeight = c > 1 ? 0.5f : 0;
        return IdsView(context, settings, {.triangles = cut(whole, steps), .material = text.c_str()}).render();
    };
    const auto error = [](const harness::Image& a, const harness::Image& b) {
        return std::pow(10, -compare(a, b).psnr / 10);
    };
    for (const uint32_t ndf : {AGAA_NDF_TOKSVIG, AGAA_NDF_LEAN})
        for (const uint32_t c : {1u, 2u}) {
            // One aggregate of one primitive; several of primitives about as large as pixels.
            const int coarse = c > 1 ? 5 : 0;
            const harness::Image fine = shown(waves, 7, c, ndf);
            const double without = error(fine, shown(waves, coarse, c, ndf)),
                         with = error(fine, shown(told, coarse, c, ndf));
            std::printf("ndf %u, c = %u: mseTm against small triangles %.2e, with derivatives %.2e\n", ndf, c, without,
                        with);
            EXPECT_LT(with, 0.12 * without);
        }
    const Difference d =
        compare(shown(told, 0, 1, AGAA_NDF_TOKSVIG), shown(told, 0, 1, AGAA_NDF_TOKSVIG, AGAA_CONFIG_BUFFERED));
    std::printf("fused against buffered: %.1f dB, %.4f %% of pixels far\n", d.psnr, 100 * d.farPixels);
    EXPECT_GE(d.psnr, 50);
    // What is no number tells nothing.
    const std::string spoilt = waves + "m.normalDx = vec3(uintBitsToFloat(0x7FC00000u)); m.normalDy = vec3(1.0);\n";
    EXPECT_EQ(shown(spoilt, 0, 1, AGAA_NDF_LEAN).rgb, shown(waves, 0, 1, AGAA_NDF_LEAN).rgb);
}

} // namespace
} // namespace agaa::test
