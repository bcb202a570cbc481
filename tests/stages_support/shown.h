// A frame of known triangles by the small host of either graphics API, and what is said of it;
// images compared.
#pragma once

#include "view_settings.h"

#include <functional>
#include <optional>
#include <span>

namespace agaa::test {

struct Shot {
    std::vector<Triangle> triangles{};
    std::vector<AgaaLight> lights = {sun()};
    std::function<void(AgaaFrame&)> change{};
    // Of the tier ids: further text of agaaHostMaterial(); primitives and draws that are announced,
    // 0 for all; AGAA_FETCH_…
    const char* material = "";
    const char* corners = ""; // further text of agaaHostTriangle()
    uint32_t announced = 0;
    uint32_t announcedDraws = 0;
    uint64_t fetchFlags = 0;
    // With ViewSettings::computesTriangles: further text of agaaHostDraw() and of agaaHostAlpha(); triangles that are
    // announced, 0 for all.
    const char* draws = "";
    const char* alpha = "";
    uint32_t announcedTriangles = 0;
};

struct Shown {
    std::vector<float> rgb; // pixel by pixel
    AgaaCounters counters{};
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    AgaaFactReport facts = AGAA_FACT_REPORT_INIT; // with AGAA_CONFIG_CHECK_FACTS; asked for twice
    uint32_t geometryPasses = 0;
};

std::vector<float> withAlpha(std::span<const float> rgb); // 1
std::vector<float> withoutAlpha(std::span<const float> rgba);

// A frame with counters, and by functions where settings ask for a tier that fetches: views of a type Ids. Returns
// what(view).
template <class Host, class What>
auto showBy(typename Host::Context& context, ViewSettings settings, const Shot& shot, const What& what) {
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    std::optional<typename Host::Ids> ids;
    std::optional<typename Host::View> own;
    if (settings.fetches())
        ids.emplace(context, settings, shot);
    else
        own.emplace(context, settings).setTriangles(shot.triangles);
    typename Host::View& view = ids ? ids->view() : *own;
    AgaaFrame frame = view.frame();
    frame.lights = shot.lights.data();
    frame.lightCount = uint32_t(shot.lights.size());
    if (shot.change)
        shot.change(frame);
    Host::run(view, [&](typename Host::Frame& native) {
        if (ids)
            ids->bind(native);
        EXPECT_EQ(Host::recordFrame(view.get(), &frame, &native), AGAA_OK);
    });
    return what(view);
}

// The host's show(context, settings, shot).
template <class Host> Shown showBy(typename Host::Context& context, const ViewSettings& settings, const Shot& shot) {
    return showBy<Host>(context, settings, shot, [&settings](typename Host::View& view) {
        const AgaaFrameStatistics statistics = view.statistics();
        Shown shown;
        shown.rgb = withoutAlpha(Host::rgba(view));
        shown.counters = statistics.counters;
        shown.geometryPasses = statistics.geometryPasses;
        EXPECT_EQ(agaaValidateFrame(view.get(), view.frameIndex(), &shown.validation), AGAA_OK);
        for (int i = 0; i < 2 && settings.config.flags & AGAA_CONFIG_CHECK_FACTS; ++i)
            EXPECT_EQ(agaaGetFactReport(view.get(), view.frameIndex(), &shown.facts), AGAA_OK);
        return shown;
    });
}

// Ambient light of a quarter.
void addAmbient(AgaaFrame& frame);
size_t nonFinite(std::span<const float> rgb);
double sumOf(std::span<const float> rgb);

struct Difference {
    double psnr = 0;      // of tone-mapped values, peak 1
    double farPixels = 0; // share of pixels with a channel more than 24/255 off
};
Difference compare(std::span<const float> a, std::span<const float> b);

} // namespace agaa::test
