// Predicted errors and times of settings: from the table of ten scenes, from measurements of the host in its own
// scenes, or from both.
#pragma once

#include "core/tuning/cost_model.h"

#include <vector>

namespace agaa {

// The predicted errors of settings.
struct Prediction {
    const ChoiceRow* row;
    float errorShare, errorShareMedian,
        errorShareWorst; // relative to "single": for AgaaGoal::sceneShare, half and all of the scenes
    float error;         // for AgaaGoal::sceneShare of the scenes
    bool isMeasured;
};

class Predictions {
public:
    // Throws Error if AgaaGoal::measured is not valid.
    explicit Predictions(const AgaaGoal& goal);

    const std::vector<Prediction>& list() const { return list_; }
    size_t measuredCount() const { return measuredCount_; } // they come first in the list
    bool isMeasured(const ChoiceRow* row) const;
    bool hasMeasuredTimes() const { return !measuredTimes_.empty(); }
    // Returns the times of a frame in proportion to its pixels, or nothing if other rows have measured times and this
    // one has none.
    std::optional<FrameTimes> times(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels) const;
    // Returns the number of pixels of a row's measured times, or 0 if it has none.
    double measuredPixels(const ChoiceRow& row) const;
    // Returns a number that identifies the measured times. It is 0 for the times of the table.
    float timesNumber() const { return timesNumber_; }

private:
    void addMeasured(const AgaaMeasuredSettings& measured, const AgaaGoal& goal);
    void addTable(const AgaaGoal& goal);
    void addOthers(const AgaaGoal& goal);
    bool contains(const ChoiceRow& row) const;
    float meanSingleError() const;
    void numberTimes();

    std::vector<Prediction> list_;
    size_t measuredCount_ = 0;
    std::vector<FrameTimes> measuredTimes_; // per pixel, in the order of the list
    std::vector<double> measuredPixels_;    // likewise
    float timesNumber_ = 0;
};

} // namespace agaa
