// A frame of known triangles by the small host of either graphics API, and what is said of it;
// images compared.
#pragma once

#include "view_settings.h"

#include <functional>
#include <span>
#include <stdexcept>

namespace agaa::test {

struct Shot {
    std::vector<Triangle> triangles{};
    std::vector<AgaaLight> lights = {sun()};
    std::function<void(AgaaFrame&)> change{};
    // Of the tier ids: further text of agaaHostMaterial(); primitives and draws that are announced,
    // 0 for all; AGAA_FETCH_…
    const char* material = "";
    uint32_t announced = 0;
    uint32_t announcedDraws = 0;
    uint64_t fetchFlags = 0;
};

struct Shown {
    std::vector<float> rgb; // pixel by pixel
    AgaaCounters counters{};
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    uint32_t geometryPasses = 0;
};

// Each API's host has
//   Shown show(StageContext& context, ViewSettings settings, const Shot& shot);
// with counters, and by functions where settings ask for the tier ids. It renders by this, which
// wants of it render(frame) and rgb().
template <class View, class Render, class Rgb>
Shown showBy(View& view, const Shot& shot, const Render& render, const Rgb& rgb) {
    AgaaFrame frame = view.frame();
    frame.lights = shot.lights.data();
    frame.lightCount = uint32_t(shot.lights.size());
    if (shot.change)
        shot.change(frame);
    render(frame);
    const AgaaFrameStatistics statistics = view.statistics();
    Shown shown;
    shown.rgb = rgb();
    shown.counters = statistics.counters;
    shown.geometryPasses = statistics.geometryPasses;
    if (agaaValidateFrame(view.get(), frame.frameIndex, &shown.validation) != AGAA_OK)
        throw std::runtime_error("agaaValidateFrame");
    return shown;
}

// Ambient light of a quarter.
void addAmbient(AgaaFrame& frame);
std::vector<float> withAlpha(std::span<const float> rgb); // 1
size_t nonFinite(std::span<const float> rgb);
double sumOf(std::span<const float> rgb);

struct Difference {
    double psnr = 0;      // of tone-mapped values, peak 1
    double farPixels = 0; // share of pixels with a channel more than 24/255 off
};
Difference compare(std::span<const float> a, std::span<const float> b);

} // namespace agaa::test
