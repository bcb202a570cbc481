#include "core/tuning/choice_memory.h"

#include "core/base/arguments.h"
#include "core/base/error.h"

#include <algorithm>
#include <cstring>

namespace agaa {

namespace {

constexpr float meanLength = 16; // observations

void addTo(float& mean, double value, float count) { mean += (float(value) - mean) / std::min(count, meanLength); }

// Hosts may measure the whole frame as one part. Both parts then have the same ratio.
FrameTimes ratioOf(const FrameTimes& observed, const FrameTimes& predicted) {
    const auto ratio = [](double a, double b) { return std::clamp(a / std::max(b, 1e-12), 1e-6, 1e12); };
    const auto isWhole = [](const FrameTimes& t) { return t.geometry <= 0 || t.shading <= 0; };
    if (!isWhole(predicted) && !isWhole(observed))
        return {ratio(observed.geometry, predicted.geometry), ratio(observed.shading, predicted.shading)};
    const double both = ratio(observed.geometry + observed.shading, predicted.geometry + predicted.shading);
    return {both, both};
}

} // namespace

ChoiceMemory::ChoiceMemory(const AgaaChoice& choice, const Predictions& predictions) : predictions_(predictions) {
    require(choiceRows().size() <= maxRows, AGAA_ERROR_INTERNAL, "the table of choices has too many rows.");
    for (const float number : choice.memory)
        checkRange(double(number), 0.0, 1e12, "AgaaChoice::memory");
    std::memcpy(&numbers_, choice.memory, sizeof numbers_);
    if (numbers_.timesNumber == predictions.timesNumber())
        return;
    numbers_.timesNumber = predictions.timesNumber();
    numbers_.geometry = numbers_.shading = numbers_.sinceChange = 0; // they are relative to other times
    std::fill(std::begin(numbers_.rows), std::end(numbers_.rows), Row{});
}

void ChoiceMemory::store(AgaaChoice& choice) const { std::memcpy(choice.memory, &numbers_, sizeof numbers_); }

size_t ChoiceMemory::indexOf(const ChoiceRow& row) { return size_t(&row - choiceRows().data()); }

SceneTerms ChoiceMemory::terms(const AgaaSceneFacts& facts) const {
    SceneTerms terms = usualTerms(facts);
    if (numbers_.complexity > 0)
        terms.complexity = numbers_.complexity - 1;
    if (numbers_.count > 0) {
        terms.coverage = numbers_.coverage;
        terms.lights = numbers_.lights;
        terms.shadows = numbers_.shadows;
    }
    return terms;
}

void ChoiceMemory::learn(const AgaaObservation& observation, const AgaaSceneFacts& facts) {
    const ChoiceRow* row = rowOf(observation);
    if (!row)
        return;
    if ((observation.flags & AGAA_OBSERVED_COUNTS) && observation.coverage > 0)
        learnCounts(observation, *row);
    if ((observation.flags & AGAA_OBSERVED_TIMES) && observation.pixels > 0)
        learnTimes(observation, *row, facts);
}

void ChoiceMemory::learnCounts(const AgaaObservation& o, const ChoiceRow& row) {
    const float count = numbers_.count += 1;
    const double events = double(o.eventsPerPixel) / o.coverage;
    if (const std::optional<double> complexity = complexityOf(row, events))
        addTo(numbers_.complexity, *complexity + 1, numbers_.complexity > 0 ? count : 1);
    const double usual =
        numbers_.complexity > 0 ? numbers_.complexity - 1 : usualTerms(AGAA_SCENE_FACTS_INIT).complexity;
    addTo(numbers_.coverage, o.coverage, count);
    addTo(numbers_.lights, o.lightsPerEvent / row.lightRatio, count);
    if (const double taps = tapsOf(row, usual); taps > 0)
        addTo(numbers_.shadows, std::min(o.shadowTapsPerEvent * events / taps, double(AGAA_MAX_SHADOW_MAPS)), count);
}

// A row that did not run yet starts with the prediction, so that its first frame alone does not decide.
void ChoiceMemory::learnTimes(const AgaaObservation& o, const ChoiceRow& row, const AgaaSceneFacts& facts) {
    const std::optional<FrameTimes> predicted = predictions_.times(row, terms(facts), o.pixels);
    if (!predicted)
        return;
    const FrameTimes ratio = ratioOf({o.geometryMilliseconds, o.shadingMilliseconds}, *predicted);
    Row& memory = numbers_.rows[indexOf(row)];
    if (memory.count == 0 && hasTimes())
        memory = {numbers_.geometry, numbers_.shading, 1};
    memory.count += 1;
    addTo(memory.geometry, ratio.geometry, memory.count);
    addTo(memory.shading, ratio.shading, memory.count);
    numbers_.geometry = memory.geometry;
    numbers_.shading = memory.shading;
}

double ChoiceMemory::milliseconds(const ChoiceRow& row, const AgaaSceneFacts& facts, uint64_t pixels) const {
    const FrameTimes predicted = predictions_.times(row, terms(facts), pixels).value();
    const Row& observed = numbers_.rows[indexOf(row)];
    if (observed.count > 0)
        return predicted.geometry * observed.geometry + predicted.shading * observed.shading;
    if (hasTimes())
        return predicted.geometry * numbers_.geometry + predicted.shading * numbers_.shading;
    return predicted.geometry + predicted.shading;
}

} // namespace agaa
