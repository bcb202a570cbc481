// The memory of choices: statistics of observed frames.
#pragma once

#include "core/tuning/predictions.h"

namespace agaa {

// The layout of AgaaChoice::memory. Numbers that no frame has shown are 0.
class ChoiceMemory {
public:
    // Throws Error if a number is negative or not finite. Forgets times that were learned with other predictions.
    ChoiceMemory(const AgaaChoice& choice, const Predictions& predictions);
    void store(AgaaChoice& choice) const;

    void learn(const AgaaObservation& observation, const AgaaSceneFacts& facts);
    // Count the observations of the current settings since they were chosen.
    void countObservation() { numbers_.sinceChange += 1; }
    void restartCount() { numbers_.sinceChange = 0; }
    float observationsSinceChange() const { return numbers_.sinceChange; }

    bool hasTimes() const { return numbers_.geometry > 0; }
    // Returns the time of a frame, scaled by the observed times of these settings, or else of the settings that ran
    // last. The row must have a prediction.
    double milliseconds(const ChoiceRow& row, const AgaaSceneFacts& facts, uint64_t pixels) const;

private:
    static constexpr size_t maxRows = 63;
    struct Row {
        float geometry, shading; // observed times relative to the predicted ones
        float count;             // of observations
    };
    struct Numbers {
        float sinceChange;                           // observations of the current choice since it was chosen
        float count;                                 // of observations with counts
        float coverage, complexity, lights, shadows; // means; complexity is stored plus 1
        float geometry, shading;                     // of the row that ran last
        float timesNumber;                           // of the predictions that the times are relative to
        float unused[2];
        Row rows[maxRows];
    };
    static_assert(sizeof(Numbers) == sizeof AgaaChoice::memory);

    SceneTerms terms(const AgaaSceneFacts& facts) const;
    void learnCounts(const AgaaObservation& observation, const ChoiceRow& row);
    void learnTimes(const AgaaObservation& observation, const ChoiceRow& row, const AgaaSceneFacts& facts);
    static size_t indexOf(const ChoiceRow& row);

    const Predictions& predictions_;
    Numbers numbers_;
};

} // namespace agaa
