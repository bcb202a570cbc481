// The display curve and its inverse (src/shaders/math/display.glsl).
#include "test_support.h"

using namespace test_math;

namespace {

double displayed(double linear) { return std::pow(linear / (1 + linear), 1 / 2.2); }
double undisplayed(double y) {
    const double x = std::pow(y, 2.2);
    return x / (1 - x);
}

TEST(DisplayCurve, ComplementIsExactForAnyLight) {
    Random random(9);
    Worst worst("1 - y in float, relative", 4e-6);
    for (int i = 0; i < 200000; ++i) {
        const float x = float(random.decades(1e-6, 65504));
        const double u = 1 / (1 + double(x));
        worst.relative(double(math_f::agaa_displayComplement(x)), -std::expm1(std::log1p(-u) / 2.2));
    }
}

// 0.17 % off at 1e4 and 45 % at 6e4 where y itself was kept.
TEST(DisplayCurve, BrightLightComesBack) {
    Random random(10);
    Worst worst("light after the curve and back, relative", 5e-6);
    for (float x : {1.0f, 100.0f, 1e4f, 6e4f, 65504.0f})
        worst.relative(double(math_f::agaa_mixDisplayed(x, x, 0)), double(x));
    for (int i = 0; i < 200000; ++i) {
        const float x = float(random.decades(0.01, 65504));
        worst.relative(double(math_f::agaa_linearFromDisplayComplement(math_f::agaa_displayComplement(x))), double(x));
    }
}

TEST(DisplayCurve, MixesAreThoseOfTheCurve) {
    Random random(11);
    Worst worst("mix in float, relative", 5e-6);
    for (int i = 0; i < 200000; ++i) {
        const double a = random.decades(0.01, 5e4), b = random.decades(0.01, 5e4), share = random.range(0, 0.5);
        worst.relative(double(math_f::agaa_mixDisplayed(float(a), float(b), float(share))),
                       undisplayed((1 - share) * displayed(a) + share * displayed(b)));
    }
}

TEST(DisplayCurve, ExtremeInputStaysFinite) {
    for (float a : extremeFloats())
        for (float b : extremeFloats())
            for (float share : {0.0f, 0.5f, 1.0f}) {
                const float mixed = math_f::agaa_mixDisplayed(a, b, share);
                EXPECT_TRUE(std::isfinite(mixed) && mixed >= 0) << a << ' ' << b << ' ' << mixed;
            }
}

} // namespace
