// Errors and times of frames that were not rendered: what the table of choices says of settings, and of a scene in view.
#pragma once

#include "agaa_sdk.h"

#include <array>
#include <optional>
#include <span>

namespace agaa {

inline constexpr size_t tableScenes = 10;

// Settings that agaaChooseSettings chooses among. choice_table.inc says what the numbers are.
struct ChoiceRow {
    const char* technique;
    uint32_t samples;
    uint32_t aggregates; // 0: the technique has none
    const char* preset;  // empty: none
    AgaaTier tier;       // of generation; AUTO: none
    float geometryRatio, geometryTime;
    float pixelTime, eventTime, lightRatio;
    float events, eventsByComplexity, taps, tapsByComplexity;
    std::array<float, tableScenes> errorShares;
};
std::span<const ChoiceRow> choiceRows();

// The row of these settings, or null. preset: null or empty: none.
const ChoiceRow* findRow(const char* technique, uint32_t samples, uint32_t aggregates, const char* preset, uint32_t tier);
// Of an AgaaObservation, AgaaChoice or AgaaMeasuredSettings.
template <class Settings> const ChoiceRow* rowOf(const Settings& s) {
    return findRow(s.technique, s.samples, s.aggregates, s.preset, s.generationTier);
}

// Of the scenes at least `share` have at most this error: by that of "single", or as it is.
float errorShareIn(const ChoiceRow& row, float share);
float errorIn(const ChoiceRow& row, float share);

// What the times of a frame depend on.
struct SceneTerms {
    double coverage;   // share of the samples with geometry
    double complexity; // share of the samples beyond a pixel's first that simple_complex shades at n = 8
    double lights;     // of a shading event of "single"
    double shadows;    // maps that shading events look up
};
// Of a scene that no frame has shown yet.
SceneTerms usualTerms(const AgaaSceneFacts& facts);

struct FrameTimes {
    double geometry = 0, shading = 0; // milliseconds
};
// On the device of the table.
FrameTimes predictTimes(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels);

// Look-ups for a covered pixel, with one shadow map.
double tapsOf(const ChoiceRow& row, double complexity);
// That so many shading events of a covered pixel mean; empty where they hardly depend on it.
std::optional<double> complexityOf(const ChoiceRow& row, double events);

} // namespace agaa
