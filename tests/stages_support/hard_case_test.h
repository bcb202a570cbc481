// What the suites of numerically hard input share: views of flat surfaces, a pixel a unit, over a background of colours
// that tests know.
#pragma once

#include "setting_share.h"
#include "shown.h"

#include <gtest/gtest.h>

#include <cstring>
#include <ostream>
#include <span>

namespace agaa::test {

inline Material facing(const glm::vec3& diffuse) {
    Material m;
    m.diffuse = glm::vec4(diffuse, 1);
    m.specular = glm::vec4(0);
    m.normal = glm::vec4(0, 0, 1, 1);
    return m;
}

struct Setting {
    const char* technique;
    uint32_t n;
    uint32_t tier = AGAA_TIER_AUTO;
};
constexpr Setting hardSettings[] = {{"single", 1},
                                    {"ssaa", 8},
                                    {"agaa", 1},
                                    {"agaa", 4},
                                    {"agaa", 8},
                                    {"agaa", 16},
                                    {"agaa", 32},
                                    {"agaa", 8, AGAA_TIER_GBUFFER},
                                    {"agaa", 8, AGAA_TIER_IDS},
                                    {"agaa", 32, AGAA_TIER_IDS}};
// Of agaa with several samples.
constexpr std::span<const Setting> aggregateSettings = std::span(hardSettings).subspan(3);

template <class Host> class HardCaseTest : public testing::Test {
protected:
    // Over a background of colours that tests know.
    Shown render(ViewSettings settings, const std::vector<Triangle>& triangles, const std::vector<AgaaLight>& lights) {
        settings.facts.shadowMapCount = 0;
        return show(context, settings, {.triangles = triangles, .lights = lights, .change = [](AgaaFrame& frame) {
                                            const float background[4] = {0.25f, 0.5f, 0.75f, 1};
                                            std::memcpy(frame.background, background, sizeof background);
                                        }});
    }
    // Returns whether this graphics API renders a setting of hardSettings.
    static bool renders(const Setting& s, size_t further = 0) {
        return rendersSetting<Host>(size_t(&s - hardSettings) + further);
    }

    typename Host::Context context;
};

inline ViewSettings pixelView(const Setting& s, uint32_t c = 2) {
    ViewSettings settings;
    settings.width = 32;
    settings.height = 16;
    settings.projection = pixelOrthographic(32, 16, 10);
    settings.config.technique = s.technique;
    settings.config.samples = s.n;
    settings.config.aggregates = c;
    settings.config.generationTier = s.tier;
    return settings;
}
// Replaces each depth of an orthographic view by 1 - depth.
inline void reverseDepth(ViewSettings& settings) {
    settings.flags |= AGAA_VIEW_REVERSED_Z;
    for (int column = 0; column < 4; ++column)
        settings.projection[column][2] = (column == 3 ? 1.0f : 0.0f) - settings.projection[column][2];
}
inline std::ostream& operator<<(std::ostream& out, const Setting& s) {
    return out << s.technique << " n=" << s.n << ' ' << agaaTierName(s.tier);
}

} // namespace agaa::test
