// Results of frames of the engine's scene with different techniques, rendered once for all checks of the geometry
// passes.
#pragma once

#include "engine_view.h"

namespace agaa::conformance {

constexpr ViewChoice oneSample = {.technique = "single"};
constexpr ViewChoice allSamples = {.technique = "ssaa", .samples = 4};
constexpr ViewChoice twoPasses = {.technique = "agaa", .samples = 4};

// Share of an image that may differ for reasons of the engine, for example texture filters.
constexpr double maxDifferingShare = 0.05;

struct Findings {
    AgaaFrameValidation twoPasses;
    uint32_t passes = 0; // 1, or 0 if the engine's functions or facts leave no work for a second pass
    // Counters without alpha-masked objects. They exist only if twoPasses is not covered and the engine can hide the
    // objects.
    std::optional<AgaaFrameValidation> twoPassesUnmasked;
    uint64_t ties = 0; // samples that two passes without the stencil test wrote more than once
    // Shares of the image that differ between two passes and one G-buffer, and between "msaa", if it is supported, and
    // the G-buffer.
    double twoPassesAgainstGBuffer = 0;
    std::optional<double> forwardAgainstGBuffer;

    // Returns whether the material pass writes all samples that the prepass shows.
    static bool isCovered(const AgaaFrameValidation& v) { return v.uncovered == 0 && v.overlapping == 0; }
    bool isCovered() const { return isCovered(twoPasses); }
    // Returns whether the material pass writes almost no samples.
    bool missesAll() const { return twoPasses.uncovered > twoPasses.visible - twoPasses.visible / 1000; }
    // Returns whether the prepass writes the depths of the material pass, and no colours.
    bool isColorless() const { return twoPasses.visible == 0 && twoPasses.overlapping != 0; }
    bool isWrittenOnce() const { return ties <= twoPasses.visible / 50; }
};

const Findings& findingsOf(Test& test, HostTest& hostTest);

std::string figures(const AgaaFrameValidation& v); // Returns " (visible …)".

} // namespace agaa::conformance
