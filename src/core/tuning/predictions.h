// What settings are predicted to have: by the table of ten scenes, or by what the host measured in its own.
#pragma once

#include "core/tuning/cost_model.h"

#include <vector>

namespace agaa {

// Errors of settings to choose among.
struct Prediction {
    const ChoiceRow* row;
    float errorShare, errorShareMedian, errorShareWorst; // by that of "single": by AgaaGoal::sceneShare, of half, of all scenes
    float error;                                         // by AgaaGoal::sceneShare
};

class Predictions {
public:
    // Throws Error where AgaaGoal::measured is not valid.
    explicit Predictions(const AgaaGoal& goal);

    const std::vector<Prediction>& list() const { return list_; }
    bool areMeasured() const { return areMeasured_; }
    bool hasMeasuredTimes() const { return !measuredTimes_.empty(); }
    // Of a frame. Empty: there are measured times, and the row has none.
    std::optional<FrameTimes> times(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels) const;
    // Distinguishes measured times from others, and from those of the table, whose number is 0.
    float timesNumber() const { return timesNumber_; }

private:
    void addMeasured(const AgaaMeasuredSettings& measured, const AgaaGoal& goal);
    void numberTimes();

    std::vector<Prediction> list_;
    bool areMeasured_;
    std::vector<FrameTimes> measuredTimes_; // of a pixel, in the order of the list
    float timesNumber_ = 0;
};

} // namespace agaa
