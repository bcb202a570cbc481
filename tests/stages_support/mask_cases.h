// Alpha-masked materials in views whose facts exclude cut-outs or translucency. Each graphics API instantiates these.
#pragma once

#include "hard_case_test.h"

namespace agaa::test {

template <class Host> class MaskCases : public HardCaseTest<Host> {
protected:
    // Mean share of a pixel that a white, glowing rectangle covers with alpha 0.5.
    static double shareOf(const Setting& s, uint64_t facts, const char* surface) {
        ViewSettings settings = pixelView(s);
        settings.facts.flags = AGAA_FACT_ALPHA_MASKED | AGAA_FACT_EMISSIVE | facts;
        settings.surface = surface;
        Material glowing = facing({0, 0, 0});
        glowing.diffuse.w = 0.5f;
        glowing.emissive = glm::vec4(1);
        std::vector<Triangle> panel = rectangle(0, 0, 32, 16, 5, glowing);
        for (Triangle& triangle : panel)
            triangle.isMasked = true;
        typename Host::Context context;
        settings.facts.shadowMapCount = 0;
        return sumOf(show(context, settings, {.triangles = panel}).rgb) / (32 * 16 * 3);
    }
};
TYPED_TEST_SUITE_P(MaskCases);

// Passes of different sources choose masks: those of samples, of texels, of aggregates, and of coverage samples.
constexpr Setting maskSettings[] = {{"single", 1},
                                    {"ssaa", 8},
                                    {"msaa", 4},
                                    {"sbaa", 8},
                                    {"adaptive", 4},
                                    {"agaa", 8, AGAA_TIER_PER_SAMPLE},
                                    {"agaa", 8, AGAA_TIER_IDS},
                                    {"agaa", 64, AGAA_TIER_FRAGMENTS},
                                    {"dcaa", 64, AGAA_TIER_FRAGMENT_LISTS},
                                    {"dcaa", 64, AGAA_TIER_MATERIAL_LISTS}};

// The facts of the view decide whether a masked material is a cut-out, in every technique and tier alike.
TYPED_TEST_P(MaskCases, HardCase60FactsDecideBeforeMaterials) {
    for (const Setting& s : maskSettings) {
        SCOPED_TRACE(testing::Message() << s);
        EXPECT_NEAR(this->shareOf(s, AGAA_FACT_NO_TRANSLUCENCY, "s.alphaCutoff = 0.0;"), 1, 1e-4)
            << "alpha is above the cutoff";
        EXPECT_NEAR(this->shareOf(s, AGAA_FACT_NO_CUTOUTS, "s.alphaCutoff = 0.6;"), 0.5, s.n == 1 ? 0.1 : 0.04)
            << "alpha is a share";
    }
}

REGISTER_TYPED_TEST_SUITE_P(MaskCases, HardCase60FactsDecideBeforeMaterials);

} // namespace agaa::test
