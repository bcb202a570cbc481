// A view that renders a known picture, with a light and a shadow map, to see that it still does.
#pragma once

#include "stage_host.h"

#include <gtest/gtest.h>

namespace agaa::test {

inline ViewSettings benchSettings() {
    ViewSettings settings;
    settings.config.samples = 4;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    return settings;
}

// Every point at this depth of the map's middle.
inline AgaaShadow shadowAt(float depth) {
    AgaaShadow shadow{};
    shadow.layerCount = 1;
    shadow.matrices[0][14] = depth;
    shadow.matrices[0][15] = 1;
    return shadow;
}

struct Bench {
    StageContext context;
    StageView view;
    harness::gl::Texture map;
    AgaaShadow shadow = shadowAt(0.25f);
    AgaaLight light = sun();

    explicit Bench(const AgaaGlContextDesc& desc = contextDesc(), EglContext& egl = sharedEgl(),
                   const ViewSettings& settings = benchSettings())
        : context(desc, egl), view(context, settings), map(shadowMap(egl.gl(), 0.5f)) {
        view.setTriangles(randomTriangles({.triangles = 20}, 41));
        light.shadowMap = 0;
    }
    AgaaFrame frame() {
        AgaaFrame f = view.frame();
        f.lights = &light;
        f.lightCount = 1;
        f.shadows = &shadow;
        f.shadowCount = 1;
        return f;
    }
    AgaaGlFrame glFrame() const {
        AgaaGlFrame f = view.glFrame();
        f.shadowTextures[0] = map.get();
        return f;
    }
    AgaaResult record(const AgaaFrame& frame, const AgaaGlFrame& glFrame) {
        context.lines.clear();
        return agaaGlRecordFrame(view.get(), &frame, &glFrame);
    }
    std::vector<float> picture() {
        view.render(frame(), glFrame());
        EXPECT_GT(view.statistics().counters.visible, 0u);
        return view.image();
    }
};

} // namespace agaa::test
