// What frames of the engine's scene show by different techniques, rendered once for all checks of the geometry passes.
#pragma once

#include "engine_view.h"

namespace agaa::conformance {

constexpr ViewChoice oneSample = {.technique = "single"};
constexpr ViewChoice allSamples = {.technique = "ssaa", .samples = 4};
constexpr ViewChoice twoPasses = {.technique = "agaa", .samples = 4};

// Of several surfaces of the image, some may differ for reasons of the engine's own, for example texture filters.
constexpr double largestShare = 0.05;

struct Findings {
    AgaaFrameValidation twoPasses;
    uint32_t passes = 0; // 1 or 0 where the engine's functions or facts leave nothing for a second pass
    // Without alpha-masked objects. Only if twoPasses is not covered, and the engine can hide them.
    std::optional<AgaaFrameValidation> twoPassesUnmasked;
    uint64_t ties = 0; // of two passes without the stencil test: samples that were written more than once
    // Shares of the image that differ: two passes and one G-buffer, and "msaa", if it is supported, and the G-buffer.
    double twoPassesAgainstGBuffer = 0;
    std::optional<double> forwardAgainstGBuffer;

    // The material pass writes what the prepass shows.
    static bool isCovered(const AgaaFrameValidation& v) { return v.uncovered == 0 && v.overlapping == 0; }
    bool isCovered() const { return isCovered(twoPasses); }
    // It writes next to nothing.
    bool missesAll() const { return twoPasses.uncovered > twoPasses.visible - twoPasses.visible / 1000; }
    // The prepass writes depths, which the material pass finds, and no colours.
    bool isColorless() const { return twoPasses.visible == 0 && twoPasses.overlapping != 0; }
    bool isWrittenOnce() const { return ties <= twoPasses.visible / 50; }
};

const Findings& findingsOf(Test& test, HostTest& hostTest);

std::string figures(const AgaaFrameValidation& v); // " (visible …)"

} // namespace agaa::conformance
