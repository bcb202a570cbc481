// A view that renders a known picture, with a light and a shadow map, to see that it still does.
#pragma once

#include "view_settings.h"

#include <gtest/gtest.h>

#include <utility>

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

template <class Host> struct BenchOf {
    using Native = typename Host::Frame;

    typename Host::Context context;
    typename Host::View view;
    typename Host::ShadowMap map;
    AgaaShadow shadow = shadowAt(0.25f);
    AgaaLight light = sun();

    // options: what the context is made with.
    template <class... Options>
    explicit BenchOf(const ViewSettings& settings = benchSettings(), Options&&... options)
        : context(std::forward<Options>(options)...), view(context, settings), map(Host::shadowMap(context, 0.5f)) {
        view.setTriangles(randomTriangles({.triangles = 20}, 41));
        light.shadowMap = 0;
    }
    AgaaFrame frame() {
        AgaaFrame f = view.frame();
        setLight(f, light, &shadow);
        return f;
    }
    // Runs what work(native) records.
    template <class Work> void run(const Work& work) {
        Host::run(view, [&](Native& native) {
            Host::setShadowMap(native, map);
            work(native);
        });
    }
    AgaaResult record(const AgaaFrame& frame, const Native& native) {
        context.lines.clear();
        return Host::recordFrame(view.get(), &frame, &native);
    }
    // For frames that must be right.
    void render(const AgaaFrame& frame) {
        run([&](Native& native) { EXPECT_EQ(record(frame, native), AGAA_OK); });
    }
    std::vector<float> image() { return Host::rgba(view); }
    std::vector<float> picture() {
        render(frame());
        EXPECT_GT(view.statistics().counters.visible, 0u);
        return image();
    }
};

} // namespace agaa::test
