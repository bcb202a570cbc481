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

    bool hasTimes() const { return numbers_.geometry > 0 && numbers_.pixels > 0; }
    // Returns the time of a frame, scaled by the observed times of these settings, or else of the settings that ran
    // last. The row must have a prediction.
    double milliseconds(const ChoiceRow& row, const AgaaSceneFacts& facts, uint64_t pixels) const;

private:
    // Times relative to the predicted ones, which are in proportion to the number of pixels. Shading is, too. Geometry
    // is the sum of vertex work, which does not depend on it, and of work in proportion to it: a line over pixels.
    struct Row {
        float geometry, shading; // means; geometry is that of `pixels`
        float count;             // of observations
        float pixels;            // mean number
        float spread;            // variance of the number of pixels, relative to the square of the mean
        float growth;            // share of geometry at `pixels` that is in proportion to pixels, by observed sizes
    };
    struct Numbers {
        float sinceChange;                           // observations of the current choice since it was chosen
        float count;                                 // of observations with counts
        float coverage, complexity, lights, shadows; // means; complexity is stored plus 1
        float geometry, shading, pixels;             // of the row that ran last
        float timesNumber;                           // of the predictions that the times are relative to
        float growth, growthPixels; // as Row::growth, of the last row that ran at different sizes, and its `pixels`
        float unused[2];
        Row rows[maxChoiceRows];
    };
    static_assert(sizeof(Numbers) == sizeof AgaaChoice::memory);

    SceneTerms terms(const AgaaSceneFacts& facts) const;
    void learnCounts(const AgaaObservation& observation, const ChoiceRow& row);
    void learnTimes(const AgaaObservation& observation, const ChoiceRow& row, const AgaaSceneFacts& facts);
    void learnGeometry(Row& memory, double ratio, double pixels, bool isWhole);
    // Returns the share of geometry at `seen` pixels that is in proportion to pixels, for a prediction at other pixels.
    double growth(const Row* memory, double seen, double pixels) const;
    // Returns the relative time of geometry at `pixels`, from that at `seen` pixels.
    double geometryAt(double pixels, double ratio, double seen, const Row* memory = nullptr) const;
    static size_t indexOf(const ChoiceRow& row);

    const Predictions& predictions_;
    Numbers numbers_;
};

} // namespace agaa
