#include "core/tuning/choice_memory.h"

#include "core/base/arguments.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace agaa {

namespace {

constexpr float meanLength = 16; // observations
constexpr double maxPixels = 1e12;
// Sizes that differ by a tenth decide as much as the assumption of a scene whose sizes are not known.
constexpr double assumedSpread = 0.01;

void addTo(float& mean, double value, float count) { mean += (float(value) - mean) / std::min(count, meanLength); }

// Hosts may measure the whole frame as one part.
bool isWhole(const FrameTimes& t) { return t.geometry <= 0 || t.shading <= 0; }

// Both parts of whole frames have the same ratio.
FrameTimes ratioOf(const FrameTimes& observed, const FrameTimes& predicted) {
    const auto ratio = [](double a, double b) { return std::clamp(a / std::max(b, 1e-12), 1e-6, 1e12); };
    if (!isWhole(predicted) && !isWhole(observed))
        return {ratio(observed.geometry, predicted.geometry), ratio(observed.shading, predicted.shading)};
    const double both = ratio(observed.geometry + observed.shading, predicted.geometry + predicted.shading);
    return {both, both};
}

} // namespace

ChoiceMemory::ChoiceMemory(const AgaaChoice& choice, const Predictions& predictions) : predictions_(predictions) {
    for (const float number : choice.memory)
        checkRange(double(number), 0.0, 1e12, "AgaaChoice::memory");
    std::memcpy(&numbers_, choice.memory, sizeof numbers_);
    for (Row& row : numbers_.rows)
        if (!(row.geometry > 0 && row.pixels > 0)) // no observation leaves such a row
            row = {};
    if (numbers_.timesNumber == predictions.timesNumber())
        return;
    numbers_.timesNumber = predictions.timesNumber();
    // They are relative to other times.
    numbers_.geometry = numbers_.shading = numbers_.pixels = numbers_.sinceChange = 0;
    numbers_.growth = numbers_.growthPixels = 0;
    std::fill(std::begin(numbers_.rows), std::end(numbers_.rows), Row{});
}

void ChoiceMemory::store(AgaaChoice& choice) const { std::memcpy(choice.memory, &numbers_, sizeof numbers_); }

size_t ChoiceMemory::indexOf(const ChoiceRow& row) { return size_t(&row - choiceRows().data()); }

SceneTerms ChoiceMemory::terms(const AgaaSceneFacts& facts) const {
    SceneTerms terms = usualTerms(facts);
    if (numbers_.complexity > 0)
        terms.complexity = std::max(double(numbers_.complexity) - 1, 0.0); // hosts may have changed the memory
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
    const double usual = terms(AGAA_SCENE_FACTS_INIT).complexity;
    addTo(numbers_.coverage, o.coverage, count);
    addTo(numbers_.lights, o.lightsPerEvent / row.lightRatio, count);
    if (const double taps = tapsOf(row, usual); taps > 0)
        addTo(numbers_.shadows, std::min(o.shadowTapsPerEvent * events / taps, double(AGAA_MAX_SHADOW_MAPS)), count);
}

// A row that did not run yet starts with the prediction, so that its first frame alone does not decide.
void ChoiceMemory::learnTimes(const AgaaObservation& o, const ChoiceRow& row, const AgaaSceneFacts& facts) {
    const std::optional<FrameTimes> predicted = predictions_.times(row, terms(facts), o.pixels);
    const FrameTimes observed = {o.geometryMilliseconds, o.shadingMilliseconds};
    if (!predicted || observed.geometry + observed.shading <= 0) // the timers are too coarse for the frame
        return;
    const FrameTimes ratio = ratioOf(observed, *predicted);
    const double pixels = std::min(double(o.pixels), maxPixels);
    Row& memory = numbers_.rows[indexOf(row)];
    if (memory.count == 0 && hasTimes())
        memory = {.geometry = float(geometryAt(pixels, numbers_.geometry, numbers_.pixels)),
                  .shading = numbers_.shading,
                  .count = 1,
                  .pixels = float(pixels),
                  .spread = 0,
                  .growth = 0};
    memory.count += 1;
    learnGeometry(memory, ratio.geometry, pixels, isWhole(*predicted) || isWhole(observed));
    addTo(memory.shading, ratio.shading, memory.count);
    numbers_.geometry = memory.geometry;
    numbers_.shading = memory.shading;
    numbers_.pixels = memory.pixels;
}

// Moves the means of pixels and times, and the least-squares line through them, towards an observation. Whole frames
// do not tell what grows.
void ChoiceMemory::learnGeometry(Row& memory, double ratio, double pixels, bool isWhole) {
    if (memory.count == 1) {
        memory.geometry = float(ratio);
        memory.pixels = float(pixels);
        return;
    }
    const double weight = 1 / double(std::min(memory.count, meanLength));
    const double x = pixels / double(memory.pixels) - 1; // relative differences from the means
    const double y = ratio * pixels / (double(memory.geometry) * double(memory.pixels)) - 1;
    const double longer = 1 + weight * y, larger = 1 + weight * x;
    const double spread = (1 - weight) * (memory.spread + weight * x * x) / (larger * larger);
    const double product = (1 - weight) * (double(memory.growth) * memory.spread + weight * x * y) / (larger * longer);
    memory.spread = float(spread);
    if (spread > 0 && !isWhole)
        memory.growth = float(std::clamp(product / spread, 0.0, 1.0));
    memory.geometry = float(std::clamp(memory.geometry * longer / larger, 1e-6, 1e12));
    memory.pixels = float(memory.pixels * larger);
    if (spread > assumedSpread && !isWhole) {
        numbers_.growth = memory.growth;
        numbers_.growthPixels = memory.pixels;
    }
}

// The time at other sizes lies between one that stays and one in proportion to pixels. If the sizes that ran are alike,
// the geometric mean of both is assumed, which is wrong by at most the root of the ratio of sizes.
double ChoiceMemory::growth(const Row* memory, double seen, double pixels) const {
    double assumed = 1 / (1 + std::sqrt(pixels / seen));
    if (numbers_.growthPixels > 0) {
        const double growing = double(numbers_.growth) * seen / double(numbers_.growthPixels);
        // A host may have changed the memory, and with it the growth.
        assumed = std::clamp(growing / std::max(1 - double(numbers_.growth) + growing, 1e-12), 0.0, 1.0);
    }
    if (!memory)
        return assumed;
    const double spread = memory->spread;
    const double share = (spread * memory->growth + assumedSpread * assumed) / (spread + assumedSpread);
    return std::clamp(share, 0.0, 1.0);
}

double ChoiceMemory::geometryAt(double pixels, double ratio, double seen, const Row* memory) const {
    const double share = growth(memory, seen, pixels);
    return ratio * ((1 - share) * seen / pixels + share);
}

double ChoiceMemory::milliseconds(const ChoiceRow& row, const AgaaSceneFacts& facts, uint64_t pixels) const {
    const FrameTimes predicted = predictions_.times(row, terms(facts), pixels).value();
    const Row& observed = numbers_.rows[indexOf(row)];
    const double size = std::min(double(pixels), maxPixels);
    if (observed.count > 0)
        return predicted.geometry * geometryAt(size, observed.geometry, observed.pixels, &observed) +
               predicted.shading * observed.shading;
    if (hasTimes())
        return predicted.geometry * geometryAt(size, numbers_.geometry, numbers_.pixels) +
               predicted.shading * numbers_.shading;
    if (const double measured = predictions_.measuredPixels(row); measured > 0)
        return predicted.geometry * geometryAt(size, 1, measured) + predicted.shading;
    return predicted.geometry + predicted.shading;
}

} // namespace agaa
