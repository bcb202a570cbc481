// Hard cases 14 to 16, 20, 22, 26 and 41 of docs/numerics.md: variances, depth buffers and positions.
#include <algorithm>
#include <cfloat>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

TEST(HardCase14_ShiftedVariance, AgainstDouble) {
    Random random(214);
    HardCaseFigures figures(14, "relative error of the variance", 1e-5);
    Worst mean("shifted mean: relative", 6e-7);
    Share negative;
    for (int i = 0; i < 100000; ++i) {
        const double mu = random.decades(1e-2, 1e4);
        const double sigma = mu / random.decades(1.0, 1e6);
        const int n = 2 + int(random.below(31));
        std::vector<float> x;
        for (int k = 0; k < n; ++k)
            x.push_back(static_cast<float>(mu + sigma * random.range(-1.7, 1.7)));
        math_f::agaa_Moments m = math_f::agaa_momentsInit(x[0]);
        double sum = 0.0, squares = 0.0;
        float rawSum = 0.0f, rawSquares = 0.0f;
        for (float v : x) {
            math_f::agaa_momentsAdd(m, v);
            sum += double(v) / n;
            rawSum += v / static_cast<float>(n);
            rawSquares += v * v / static_cast<float>(n);
        }
        for (float v : x)
            squares += (double(v) - sum) * (double(v) - sum) / n;
        mean.relative(double(m.shift + m.sum / m.count), sum);
        const double got = double(math_f::agaa_momentsVariance(m));
        ASSERT_GE(got, 0.0);
        negative.add(rawSquares - rawSum * rawSum < 0.0f);
        if (squares > 0.0)
            figures.relative(double(rawSquares - rawSum * rawSum), got, squares);
        else
            figures.ours(got);
    }
    std::printf("[ measured ] E[x^2]-E[x]^2 negative in %.1f %%\n", 100.0 * negative.value());
    EXPECT_GT(negative.value(), 0.05);
}

TEST(HardCase14_ShiftedVariance, TapsStayWithinTheSamples) {
    // Depths 1, 1, 1, 1, 20: 1.34 sigma before the mean is 5.4 behind the eye.
    Worst error("shadow taps along the depth: float against double, relative to the depth", 1e-5);
    Random random(215);
    for (int i = 0; i < 20000; ++i) {
        std::vector<float> z(1 + random.below(32));
        for (float& v : z)
            v = -float(random.decades(1, 100));
        if (i == 0)
            z = {-1, -1, -1, -1, -20};
        const auto [low, high] = std::minmax_element(z.begin(), z.end());
        math_f::agaa_Moments m = math_f::agaa_momentsInit(z[0]);
        double mean = 0, variance = 0;
        for (const float v : z) {
            math_f::agaa_momentsAdd(m, v);
            mean += double(v) / double(z.size());
        }
        for (const float v : z)
            variance += (double(v) - mean) * (double(v) - mean) / double(z.size());
        std::vector<float> taps;
        for (unsigned j = 0; j < 4; ++j)
            taps.push_back(math_f::agaa_depthTap(j, m.shift + m.sum / m.count,
                                                 std::sqrt(math_f::agaa_momentsVariance(m)), *low, *high));
        std::sort(taps.begin(), taps.end());
        const double quantiles[] = {-1.34, -0.45, 0.45, 1.34};
        for (size_t j = 0; j < 4; ++j) {
            ASSERT_GE(taps[j], *low);
            ASSERT_LE(taps[j], *high);
            const double expected =
                std::min(std::max(mean + quantiles[j] * std::sqrt(variance), double(*low)), double(*high));
            error.add(std::abs(double(taps[j]) - expected) / std::abs(double(*low)));
        }
    }
}

// A reversed projection of floats without far plane, whose near plane is at 0.1.
static glm::vec3 reconstructed(const glm::vec2& ndc, float depth) {
    const float z = math_f::agaa_viewZFromDepth(depth, 0.0f, 0.1f, 0);
    return math_f::agaa_viewPosition(ndc, z, 1.0f, 1.0f, 0.0f, 0.0f, 0);
}

TEST(HardCase15_DepthMetricDependsOnUnits, DistancesFromAPlane) {
    Random random(115);
    HardCaseFigures figures(15, "error of the difference, in units of the one that needs a sample", 5e-5);
    // The printed metric c Var(depth), of which c makes steps of a twentieth of the distance need a sample at 2 m.
    const double stepAt2 = 0.1 * 0.1 / (2 * 2) / 2;
    const double c = 1 / (stepAt2 * stepAt2);
    for (int i = 0; i < 100000; ++i) {
        const double distance = random.decades(0.2, 1e4);
        glm::dvec3 n = random.hemisphere(0.1);
        const bool isStep = i % 2;
        if (isStep)
            n = {0, 0, 1};
        const glm::dvec2 pixel(random.range(-0.5, 0.5), random.range(-0.5, 0.5));
        glm::vec3 at[8];
        float depths[8];
        float mean = 0, variance = 0;
        for (int s = 0; s < 8; ++s) {
            const glm::dvec2 ndc = pixel + glm::dvec2(random.range(-1, 1), random.range(-1, 1)) * 1e-3;
            // The sample lies on the plane through the pixel's middle, or on one of the two sides of a step.
            const glm::dvec3 ray(ndc, -1), through(pixel * distance, -distance);
            const double along = glm::dot(n, through) / glm::dot(n, ray);
            if (!(along > 0.5 * distance && along < 2 * distance)) {
                depths[s] = float(0.1 / distance);
                at[s] = reconstructed(glm::vec2(pixel), depths[s]);
                continue;
            }
            depths[s] = float(0.1 / (isStep && s % 2 ? distance * 1.05 : along));
            at[s] = reconstructed(glm::vec2(ndc), depths[s]);
        }
        for (float d : depths)
            mean += d / 8;
        for (float d : depths)
            variance += (d - mean) * (d - mean) / 8;
        // The tolerance is proportional to the distance, as in src/shaders/adaptive/sample_features.glsl.
        float ours = 0;
        const float width = float(distance) * 0.03f;
        for (int s = 1; s < 8; ++s)
            ours = std::max(ours, math_f::agaa_planeStep(at[s] - at[0], glm::vec3(n), glm::vec3(n), width));
        const double naive = c * double(variance);
        figures.add(isStep ? std::max(0.0, 1 - naive) : naive, isStep ? std::max(0.0, 1 - double(ours)) : double(ours));
    }
}

TEST(HardCase16_ReversedInfiniteDepth, FiniteAtDepthZero) {
    Random random(116);
    HardCaseFigures figures(16, "relative error of the mean distance of a pixel's samples", 1e-6);
    const float listed[] = {0.0f, FLT_TRUE_MIN, FLT_MIN, 1.0f};
    for (int i = 0; i < 100000; ++i) {
        float naiveMean = 0, mean = 0;
        double reference = 0;
        for (int s = 0; s < 4; ++s) {
            const float d = random.below(4) == 0 ? listed[random.below(4)] : float(random.decades(1e-9, 1));
            const float z = math_f::agaa_viewZFromDepth(d, 0.0f, 0.1f, 0);
            ASSERT_TRUE(std::isfinite(z) && z < 0) << d;
            naiveMean += -0.1f / d / 4;
            mean += z / 4;
            reference += math_d::agaa_viewZFromDepth(double(d), 0.0, double(0.1f), 0) / 4;
        }
        figures.relative(double(naiveMean), double(mean), reference);
    }
    // The differences of positions are not numbers.
    EXPECT_TRUE(std::isnan(-0.1f / listed[0] - -0.1f / listed[0]));
    for (float d : listed)
        for (float nearPlane : {1e-3f, 0.1f, 10.0f}) {
            const float z = math_f::agaa_viewZFromDepth(d, 0.0f, nearPlane, 0);
            if (d == 1.0f) {
                EXPECT_EQ(z, -nearPlane);
            }
            const glm::vec3 p = math_f::agaa_viewPosition({1, -1}, z, 0.5f, 0.5f, 0, 0, 0);
            ASSERT_TRUE(allFinite(p));
            ASSERT_TRUE(std::isfinite(glm::dot(p, p)));
            ASSERT_TRUE(std::isfinite(math_f::agaa_depthQuantum(z, d, 0.0f, nearPlane, 0, 6e-8f)));
        }
    // The far value of the forward infinite projection.
    EXPECT_TRUE(std::isfinite(math_f::agaa_viewZFromDepth(1.0f, -1.0f, -0.1f, 0)));
}

TEST(HardCase20_DepthQuantum, StepsOfTheFormats) {
    const float nearPlane = 0.1f, farPlane = 10000.0f;
    const float p22 = farPlane / (nearPlane - farPlane), p32 = nearPlane * p22;
    auto step = [&](float z, float bits) {
        const float d = (p22 * z + p32) / -z;
        return math_f::agaa_depthQuantum(z, d, p22, p32, 0, std::exp2(-bits));
    };
    // z^2 / (near 2^bits): 10 cm at 410 m with 24 bits and at 25.6 m with 16.
    EXPECT_NEAR(step(-410.0f, 24), 0.1f, 0.01f);
    EXPECT_NEAR(step(-25.6f, 16), 0.1f, 0.002f);
    // A float depth, reversed: 6e-5 m at 1 km.
    const float d = nearPlane / 1000.0f;
    const float ulp = std::nextafter(d, 1.0f) - d;
    EXPECT_LT(math_f::agaa_depthQuantum(-1000.0f, d, 0.0f, nearPlane, 0, ulp), 1.3e-4f);
}

TEST(HardCase22_LargeCoordinates, PositionsRelativeToTheCamera) {
    Random random(122);
    HardCaseFigures figures(22, "error of the distance between two samples, metres", 2e-4);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 camera = 1e6 * random.direction();
        const float z[] = {-random.rangeF(0.5, 100), 0};
        glm::vec3 ours[2], world[2];
        glm::dvec3 truth[2];
        for (int s = 0; s < 2; ++s) {
            const glm::vec2 ndc(random.rangeF(-1, 1), random.rangeF(-1, 1));
            const float depth = s == 0 ? z[0] : z[0] * random.rangeF(0.9, 1.1);
            ours[s] = math_f::agaa_viewPosition(ndc, depth, 1.0f, 1.7f, 0, 0, 0);
            truth[s] = math_d::agaa_viewPosition(glm::dvec2(ndc), double(depth), 1.0, double(1.7f), 0, 0, 0);
            world[s] = glm::vec3(camera) + ours[s];
        }
        const double distance = glm::length(truth[0] - truth[1]);
        figures.add(std::abs(double(glm::length(world[0] - world[1])) - distance),
                    std::abs(double(glm::length(ours[0] - ours[1])) - distance));
    }
}

TEST(HardCase26_TwoPassesOfUnequalDepth, OneExpressionInBoth) {
    // The SDK cannot force the host's vertex shaders. It requires one expression in both passes, whose depths are equal
    // by definition, and counts the samples that differ (tests/stages_support/validation_cases.h).
    Random random(126);
    HardCaseFigures figures(26, "share of vertices whose depth differs between two passes", 0.0);
    Share separate, equal;
    glm::mat4 projection(0), camera(1), object(1);
    projection[0][0] = 1;
    projection[1][1] = 1.7f;
    projection[2][2] = -1.0001f;
    projection[2][3] = -1;
    projection[3][2] = -0.10001f;
    for (int i = 0; i < 100000; ++i) {
        if (i % 100 == 0) {
            camera[0] = {0.8f, 0, 0.6f, 0};
            camera[2] = {-0.6f, 0, 0.8f, 0};
            camera[3] = glm::vec4(glm::vec3(random.direction() * 10.0), 1);
            object[3] = glm::vec4(glm::vec3(random.direction() * 100.0), 1);
        }
        const glm::vec4 vertex(glm::vec3(random.direction() * random.decades(0.1, 10)), 1);
        const auto depthOf = [](const glm::vec4& clip) { return clip.z / clip.w; };
        const glm::mat4 all = projection * camera * object;
        const float prepass = depthOf(all * vertex), again = depthOf(all * vertex);
        separate.add(depthOf(projection * (camera * (object * vertex))) != prepass);
        equal.add(again != prepass);
    }
    figures.naive(separate.value());
    figures.ours(equal.value(), equal.inputs());
}

TEST(HardCase41_ShadowTapsBehindTheEye, TapsStayWithinTheSamples) {
    Random random(141);
    HardCaseFigures figures(41, "share of pixels with a tap behind the eye", 0.0);
    Share behind, oursBehind, outside;
    for (int i = 0; i < 100000; ++i) {
        // A surface seen at a grazing angle, up to 1 km long.
        const unsigned n = 2 + random.below(31);
        const double nearest = random.decades(0.1, 10), longest = random.decades(1, 1000);
        std::vector<float> z;
        float sum = 0, squares = 0;
        math_f::agaa_Moments m{};
        for (unsigned s = 0; s < n; ++s) {
            z.push_back(-float(nearest + longest * std::pow(random.unit(), 8)));
            if (s == 0)
                m = math_f::agaa_momentsInit(z[0]);
            math_f::agaa_momentsAdd(m, z[s]);
            sum += z[s] / float(n);
            squares += z[s] * z[s] / float(n);
        }
        const auto [low, high] = std::minmax_element(z.begin(), z.end());
        const float mean = m.shift + m.sum / m.count, sigma = std::sqrt(math_f::agaa_momentsVariance(m));
        bool isBehind = false, oursIsBehind = false;
        for (unsigned j = 0; j < 4; ++j) {
            isBehind |= mean + (j & 1u ? 1.0f : -1.0f) * sigma * (j < 2 ? 0.45f : 1.34f) >= 0;
            oursIsBehind |= !(math_f::agaa_depthTap(j, mean, sigma, *low, *high) < 0);
        }
        behind.add(isBehind);
        oursBehind.add(oursIsBehind);
        // Chebyshev's bound of moments that cancel: the SDK compares depths in its place.
        const float variance = squares - sum * sum, t = z[0] - sum;
        const float shadow = variance / (variance + t * t);
        outside.add(!(shadow >= 0 && shadow <= 1));
    }
    figures.naive(behind.value());
    figures.ours(oursBehind.value(), oursBehind.inputs());
    std::printf("[ measured ] Chebyshev's bound outside [0, 1] or not a number: %.2g %%\n", 100 * outside.value());
    EXPECT_GT(outside.value(), 0.0);
}
