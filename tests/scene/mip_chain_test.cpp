// Mip chains of textures whose alpha is tested.
#include "render/mip_chain.h"
#include "scene/builtin/leaf_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace harness {
namespace {

// The share of a level that passes the test, by bilinear filtering at 8 x 8 places a texel.
double coverageOf(const MipLevel& level, double cutoff) {
    const auto alpha = [&](int x, int y) {
        const auto wrap = [](int v, uint32_t size) { return size_t((v + int(size)) % int(size)); };
        return level.rgba[4 * (wrap(y, level.height) * level.width + wrap(x, level.width)) + 3] / 255.0;
    };
    constexpr int side = 8;
    size_t passing = 0;
    for (int y = 0; y < int(level.height) * side; ++y)
        for (int x = 0; x < int(level.width) * side; ++x) {
            const double u = (x + 0.5) / side - 0.5, v = (y + 0.5) / side - 0.5;
            const int i = int(std::floor(u)), j = int(std::floor(v));
            const double fx = u - i, fy = v - j;
            const double value = (alpha(i, j) * (1 - fx) + alpha(i + 1, j) * fx) * (1 - fy) +
                                 (alpha(i, j + 1) * (1 - fx) + alpha(i + 1, j + 1) * fx) * fy;
            passing += value >= cutoff;
        }
    return double(passing) / (double(side * level.width) * double(side * level.height));
}

// The figures that docs/integration/alpha-masks.md quotes: the largest change of coverage down to 8 x 8 texels.
TEST(MipChain, LevelsKeepTheCoverageOfTheFirst) {
    builtin::LeafPicture picture;
    picture.slenderness = 0.2f;
    const Texture texture = builtin::leafTexture(picture);
    MipOptions tested;
    tested.alphaCutoff = 0.5f;
    const std::vector<MipLevel> kept = makeMipChain(texture, tested), plain = makeMipChain(texture, {});
    const double first = coverageOf(kept[0], 0.5);
    ASSERT_GT(first, 0.05);
    ASSERT_LT(first, 0.95);
    double keptError = 0, plainError = 0;
    for (size_t i = 0; i < kept.size() && kept[i].width >= 8; ++i) {
        const double a = coverageOf(kept[i], 0.5) / first, b = coverageOf(plain[i], 0.5) / first;
        std::printf("[ measured ] %3u x %-3u coverage of level 0's: preserved %.3f, plain %.3f\n", kept[i].width,
                    kept[i].height, a, b);
        keptError = std::max(keptError, std::abs(a - 1));
        plainError = std::max(plainError, std::abs(b - 1));
    }
    EXPECT_LT(keptError, 0.01);
    EXPECT_GT(plainError, 0.3);
}

// Dense leaves with hard edges, whose levels must be scaled up: what is stored above 1 is 1.
TEST(MipChain, ClampedTexelsDoNotThinHardEdges) {
    Texture texture{"", 256, 256, false, Wrap::Repeat, Wrap::Repeat, {}};
    for (uint32_t y = 0; y < 256; ++y)
        for (uint32_t x = 0; x < 256; ++x) {
            const double u = x % 32 - 15.5, v = y % 32 - 15.5;
            texture.rgba.insert(texture.rgba.end(), {255, 255, 255, uint8_t(std::hypot(u, 3 * v) < 15 ? 255 : 0)});
        }
    MipOptions tested;
    tested.alphaCutoff = 0.75f;
    const std::vector<MipLevel> levels = makeMipChain(texture, tested);
    const double first = coverageOf(levels[0], 0.75);
    double worst = 0;
    for (size_t i = 1; i < levels.size() && levels[i].width >= 64; ++i) { // later a leaf is four texels, of few values
        worst = std::max(worst, std::abs(coverageOf(levels[i], 0.75) / first - 1));
        std::printf("[ measured ] %3u x %-3u coverage of level 0's: %.3f\n", levels[i].width, levels[i].height,
                    coverageOf(levels[i], 0.75) / first);
    }
    EXPECT_LT(worst, 0.02);
}

TEST(MipChain, UntestedAndUniformAlphaIsLeftAlone) {
    Texture texture{"", 4, 4, false, Wrap::Repeat, Wrap::Repeat, std::vector<uint8_t>(64, 100)};
    for (float cutoff : {0.0f, 0.2f, 0.9f}) { // not tested; everything passes; nothing passes
        MipOptions options;
        options.alphaCutoff = cutoff;
        for (const MipLevel& level : makeMipChain(texture, options))
            EXPECT_EQ(level.rgba[3], 100) << cutoff;
    }
}

} // namespace
} // namespace harness
