// Alpha-masked materials in views whose facts exclude cut-outs or translucency. Each graphics API instantiates these.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"

namespace agaa::test {

template <class Host> class MaskCases : public HardCaseTest<Host> {
protected:
    // Mean share of a pixel that a white rectangle covers with alpha 0.5.
    double shareOf(const TechniqueTier& tier, uint64_t facts, const char* surface) {
        ViewSettings settings = pixelView({tier.technique, tier.n});
        apply(tier, settings);
        settings.facts.flags = AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT | facts;
        settings.surface = surface;
        Material white = facing({1, 1, 1});
        white.diffuse.w = 0.5f;
        std::vector<Triangle> panel = rectangle(0, 0, 32, 16, 5, white);
        for (Triangle& triangle : panel)
            triangle.isMasked = true;
        settings.facts.shadowMapCount = 0;
        const auto light = [](AgaaFrame& frame) { frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 1; };
        return sumOf(show(this->context, settings, {.triangles = panel, .lights = {}, .change = light}).rgb) /
               (32 * 16 * 3);
    }
};
TYPED_TEST_SUITE_P(MaskCases);

// The facts of the view decide whether a masked material is a cut-out, in every technique and tier alike.
TYPED_TEST_P(MaskCases, HardCase60FactsDecideBeforeMaterials) {
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || tier.isMixed ||
            !runs(tier, this->context.get()->caps))
            continue;
        if (std::strcmp(tier.technique, "fxaa") == 0 || std::strcmp(tier.technique, "smaa") == 0)
            continue; // they mix tone-mapped values, of which shares are not linear
        EXPECT_NEAR(this->shareOf(tier, AGAA_FACT_NO_TRANSLUCENCY, "s.alphaCutoff = 0.0;"), 1, 1e-4)
            << "alpha is above the cutoff";
        EXPECT_NEAR(this->shareOf(tier, AGAA_FACT_NO_CUTOUTS, "s.alphaCutoff = 0.6;"), 0.5, tier.n == 1 ? 0.1 : 0.04)
            << "alpha is a share";
    }
}

REGISTER_TYPED_TEST_SUITE_P(MaskCases, HardCase60FactsDecideBeforeMaterials);

} // namespace agaa::test
