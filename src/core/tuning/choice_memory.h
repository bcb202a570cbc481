// What choices remember of the frames that were observed.
#pragma once

#include "core/tuning/predictions.h"

namespace agaa {

// As AgaaChoice::memory holds it. 0 is what no frame has shown.
class ChoiceMemory {
public:
    // Throws Error where a number is not finite or negative. Forgets times that were learned by other predictions.
    ChoiceMemory(const AgaaChoice& choice, const Predictions& predictions);
    void store(AgaaChoice& choice) const;

    void learn(const AgaaObservation& observation, const AgaaSceneFacts& facts);
    // Of the settings that run now.
    void countObservation() { numbers_.held += 1; }
    void startHolding() { numbers_.held = 0; }
    float held() const { return numbers_.held; }

    bool hasTimes() const { return numbers_.geometry > 0; }
    // Of a frame: by the times of these settings, or else by those of the settings that ran last. The row has a prediction.
    double milliseconds(const ChoiceRow& row, const AgaaSceneFacts& facts, uint64_t pixels) const;

private:
    static constexpr size_t maxRows = 63;
    struct Row {
        float geometry, shading; // times by the predicted ones
        float count;             // of observations
    };
    struct Numbers {
        float held;  // observations of the current choice, since it was chosen
        float count; // of observed counts
        float coverage, complexity, lights, shadows; // means; complexity plus 1
        float geometry, shading; // of the row that ran last
        float timesNumber; // of the predictions that times are by
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
