#include "test_scenes.h"

#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace harness::test {

namespace {

struct Rival {
    double error = 0; // mseTm against ssaa, as a share of single's
    double flip95 = 0;
    AgaaCounters counters{};
};

class Rivals {
public:
    Rivals(Renderer& renderer, const RenderSettings& settings, const char* name)
        : renderer_(renderer), settings_(settings), name_(name), reference_(render("ssaa", 1)) {
        single_ = compareImages(reference_.image, render("single", 1).image).mseTm;
    }

    uint64_t referenceEvents() const { return reference_.statistics.back().counters.shadingEvents; }

    Rival measure(const char* technique, uint32_t aggregates) {
        SCOPED_TRACE(testing::Message() << technique << " " << aggregates);
        const RenderResult result = render(technique, aggregates);
        expectWholeFrame(result, settings_.config.samples);
        const Metrics m = compareImages(reference_.image, result.image);
        const Rival rival{m.mseTm / single_, m.flipP95, result.statistics.back().counters};
        std::printf("%-10s %-14s %u: error %.4f of single's, FLIP p95 %.4f, %.2f events a pixel\n", name_, technique,
                    aggregates, rival.error, rival.flip95,
                    double(rival.counters.shadingEvents) / double(rival.counters.shadedPixels));
        return rival;
    }

private:
    RenderResult render(const char* technique, uint32_t aggregates) {
        settings_.config.technique = technique;
        settings_.config.aggregates = aggregates;
        return renderer_.render(settings_);
    }

    Renderer& renderer_;
    RenderSettings settings_;
    const char* name_;
    RenderResult reference_;
    double single_ = 0;
};

} // namespace

void expectRivals(Renderer& renderer, RenderSettings settings, const char* name) {
    Rivals rivals(renderer, settings, name);
    // Set for no visible loss.
    const Rival classified = rivals.measure("simple_complex", 1);
    EXPECT_LT(classified.error, 0.006);
    EXPECT_LT(classified.flip95, 0.05);
    EXPECT_LT(classified.counters.shadingEvents, rivals.referenceEvents());
    EXPECT_EQ(classified.counters.maxEventsPerPixel, settings.config.samples);
    // Shaded once a fragment: textures and highlights within one are all that is lost.
    const Rival forward = rivals.measure("msaa", 1);
    const bool hasWholePixels = renderer.caps().sampleCounts & 8u; // 0.056 on an NVIDIA H200
    EXPECT_LT(forward.error, hasWholePixels ? 0.06 : 0.04);
    // No sample more than single has; the errors of its edges are softened, not gone.
    const Rival filtered = rivals.measure("fxaa", 1);
    EXPECT_LT(filtered.error, isSoftware(renderer) ? 0.7 : 0.72); // 0.705 on an NVIDIA H200
    EXPECT_EQ(filtered.counters.maxEventsPerPixel, 1u);
    const Rival followed = rivals.measure("smaa", 1); // it blends less where edges are no lines
    EXPECT_LT(followed.error, 0.85);
    EXPECT_EQ(followed.counters.maxEventsPerPixel, 1u);
    // The visibility of all samples, and the light of one: the highlights of metal change within a pixel.
    const Rival reconstructed = rivals.measure("visibility", 1);
    EXPECT_LT(reconstructed.error, std::string(name) == "metal" ? 0.5 : 0.1);
    EXPECT_EQ(reconstructed.counters.maxEventsPerPixel, 1u);
    double before = 1;
    for (uint32_t surfaces : {1u, 2u, 4u, 6u}) {
        const Rival kept = rivals.measure("sbaa", surfaces);
        EXPECT_LE(kept.counters.maxEventsPerPixel, surfaces);
        EXPECT_LT(kept.error, before) << surfaces << " surfaces";
        before = kept.error;
    }
}

} // namespace harness::test
