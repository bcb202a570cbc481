// The frames of hard cases: a scene, its settings, the largest error by what a configuration shades, and a check that
// is stronger than the error.
#pragma once

#include "hard/configurations.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness::hard {

// The result of a check: a value that must not exceed its bound.
struct Finding {
    double value = 0;
    double bound = 0;
    bool isWithin() const { return value <= bound; } // false for NaN
};

// A rendered frame, as a check sees it.
struct Rendered {
    Renderer& renderer;
    RenderSettings settings;
    const HardConfiguration& configuration;
    RenderResult result;
    const Image* other = nullptr; // the other frame, if there is one
    uint64_t* frames = nullptr;   // counts the frames that the check renders
    uint64_t* nonFinite = nullptr;
};

// The same configuration in another scene or with other settings.
struct OtherFrame {
    const char* scene = nullptr; // null: the frame's own
    void (*adjust)(RenderSettings&) = nullptr;
};

using Bounds = std::array<double, kShadings>;

struct HardFrame {
    const char* name;
    const char* scene;
    const char* cases; // numbers of docs/numerics.md, as text
    uint32_t width = 64, height = 36;
    uint32_t spp = 64; // of the reference
    // The largest mean square error after tone mapping, and the largest relative error of the image's mean.
    Bounds maxMseTm = {};
    Bounds maxMeanError = {};
    void (*adjust)(RenderSettings&) = nullptr;
    std::optional<OtherFrame> other = {};
    const char* checked = nullptr; // a phrase for the check
    std::function<Finding(const Rendered&)> check = {};
    bool isWithoutD24 = false; // a device that lacks D24_UNORM_S8_UINT: on Vulkan only
    bool isWidest = false;     // the largest width that a configuration allows, and one pixel more
    bool (*isFor)(const HardConfiguration&) = nullptr; // null: all configurations
};

const std::vector<HardFrame>& hardFrames();

// Returns the settings of a frame without a configuration. The scene must outlive the call only.
RenderSettings settingsOf(const HardFrame& frame, const Scene& scene);

} // namespace harness::hard
