// Predicted errors and times of frames, from the table of choices and properties of the scene in view.
#pragma once

#include "agaa_sdk.h"

#include <array>
#include <optional>
#include <span>

namespace agaa {

inline constexpr size_t tableScenes = 10;
inline constexpr size_t maxChoiceRows = 31; // that AgaaChoice::memory has room for

// Settings that agaaChooseSettings chooses among. choice_table.inc describes the numbers.
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

// Returns the row of these settings, or null. A preset of null or "" means none.
const ChoiceRow* findRow(const char* technique, uint32_t samples, uint32_t aggregates, const char* preset,
                         uint32_t tier);
// Returns the row of an AgaaObservation, AgaaChoice or AgaaMeasuredSettings, or null.
template <class Settings> const ChoiceRow* rowOf(const Settings& s) {
    return findRow(s.technique, s.samples, s.aggregates, s.preset, s.generationTier);
}

// Return the error that at least `share` of the scenes do not exceed: relative to that of "single", or absolute.
float errorShareIn(const ChoiceRow& row, float share);
float errorIn(const ChoiceRow& row, float share);

// Properties of a scene that determine the times of a frame.
struct SceneTerms {
    double coverage;   // share of the samples with geometry
    double complexity; // share of the samples beyond a pixel's first that simple_complex shades at n = 8
    double lights;     // per shading event of "single"
    double shadows;    // maps that shading events look up
};
// Returns the terms of a scene of which no frame was observed yet.
SceneTerms usualTerms(const AgaaSceneFacts& facts);

struct FrameTimes {
    double geometry = 0, shading = 0; // milliseconds
};
// Returns the times on the device of the table.
FrameTimes predictTimes(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels);

// Returns the shadow taps per covered pixel with one shadow map.
double tapsOf(const ChoiceRow& row, double complexity);
// Returns the complexity that causes so many shading events per covered pixel, or nothing if the events hardly depend
// on it.
std::optional<double> complexityOf(const ChoiceRow& row, double events);

} // namespace agaa
