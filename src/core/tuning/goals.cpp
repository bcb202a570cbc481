#include "core/tuning/goals.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/tuning/choice_memory.h"
#include "core/tuning/choice_reason.h"
#include "core/tuning/observations.h"
#include "core/view/presets.h"

#include <algorithm>
#include <limits>

namespace agaa {

namespace {

constexpr double timeMargin = 0.1;    // share of the time limit, on either side
constexpr double timeGain = 0.15;     // share of the time that another choice must save
constexpr float minObservations = 16; // of a choice before its times may replace it

void checkGoal(const AgaaGoal& goal) {
    constexpr double largest = std::numeric_limits<float>::max();
    checkRange(double(goal.maxErrorShare), 0.0, 1.0, "AgaaGoal::maxErrorShare");
    checkRange(double(goal.maxError), 0.0, largest, "AgaaGoal::maxError");
    checkRange(double(goal.sceneShare), 0.0, 1.0, "AgaaGoal::sceneShare");
    checkRange(double(goal.maxMilliseconds), 0.0, largest, "AgaaGoal::maxMilliseconds");
    checkRange(uint64_t(goal.prefer), 0, AGAA_PREFER_ERROR, "AgaaGoal::prefer");
    checkReserved(goal.reserved, "AgaaGoal::reserved");
    checkReserved(goal.reservedMeasured, "AgaaGoal::reservedMeasured");
    checkFlags(goal.flags, AGAA_GOAL_ONE_GEOMETRY_PASS | AGAA_GOAL_PREDICT_OTHERS, "AgaaGoal::flags");
}

uint64_t plannedBytes(const TunedView& view, const ChoiceRow& row, const AgaaGoal& goal) {
    const PlannedCost cost = view.plan(row);
    require(!(goal.flags & AGAA_GOAL_ONE_GEOMETRY_PASS) || cost.geometryPasses <= 1, AGAA_ERROR_UNSUPPORTED,
            "the settings draw the scene more than once.");
    return cost.bytes;
}

// The settings that have a prediction and can be planned.
struct Candidates {
    std::vector<Candidate> list;
    uint32_t excluded = 0;
    Error firstReason{AGAA_ERROR_UNSUPPORTED, {}}; // for the first excluded settings
};

Candidates listCandidates(const TunedView& view, const AgaaGoal& goal, const Predictions& predictions,
                          const ChoiceMemory& memory) {
    Candidates found;
    for (const Prediction& prediction : predictions.list()) {
        try {
            const uint64_t bytes = plannedBytes(view, *prediction.row, goal);
            found.list.push_back({prediction, memory.milliseconds(*prediction.row, view.facts, view.pixels), bytes});
        } catch (const Error& error) {
            if (error.code == AGAA_ERROR_INTERNAL)
                throw;
            if (found.excluded++ == 0)
                found.firstReason.message = error.message;
        }
    }
    if (found.list.empty())
        throw found.firstReason;
    return found;
}

double ratioOf(double number, double limit) { return limit > 0 ? number / limit : 0; }

// Compares candidates by a goal. timeScale: a factor of the time limit.
class Order {
public:
    explicit Order(const AgaaGoal& goal, double timeScale = 1) : goal_(goal), timeScale_(timeScale) {}

    double bytes(const Candidate& c) const { return ratioOf(double(c.bytes), double(goal_.maxBytes)); }
    double error(const Candidate& c) const {
        return std::max(ratioOf(c.errorShare, goal_.maxErrorShare), ratioOf(c.error, goal_.maxError));
    }
    double time(const Candidate& c) const { return ratioOf(c.milliseconds, goal_.maxMilliseconds * timeScale_); }
    double excess(const Candidate& c) const { return std::max({bytes(c), error(c), time(c)}); }
    bool satisfies(const Candidate& c) const { return excess(c) <= 1; }

    bool isBetter(const Candidate& a, const Candidate& b) const { return key(a) < key(b); }
    const Candidate& best(const std::vector<Candidate>& list) const {
        return *std::min_element(list.begin(), list.end(),
                                 [&](const Candidate& a, const Candidate& b) { return isBetter(a, b); });
    }

private:
    std::array<double, 4> key(const Candidate& c) const {
        const bool byTime = goal_.prefer == AGAA_PREFER_TIME;
        const double time = c.milliseconds, error = c.errorShare;
        return {std::max(bytes(c), 1.0), std::max(excess(c), 1.0), byTime ? time : error, byTime ? error : time};
    }

    const AgaaGoal& goal_;
    double timeScale_;
};

bool isWorthSwitching(const Candidate& other, const Candidate& current, const AgaaGoal& goal) {
    return goal.prefer == AGAA_PREFER_TIME ? other.milliseconds < (1 - timeGain) * current.milliseconds
                                           : other.errorShare < current.errorShare;
}

// Returns the candidate that replaces the current choice, or the current choice.
const Candidate& choose(const std::vector<Candidate>& list, const Candidate& current, const AgaaGoal& goal,
                        const ChoiceMemory& memory) {
    const Order exact(goal), tolerant(goal, 1 + timeMargin), reserved(goal, 1 - timeMargin);
    const Candidate& nearest = exact.best(list);
    // These misses do not depend on times, so that noise cannot make choices alternate.
    if (exact.bytes(current) > 1 && exact.bytes(nearest) <= 1)
        return nearest;
    if (exact.error(current) > 1 && exact.satisfies(nearest))
        return nearest;
    if (memory.hasTimes() && memory.observationsSinceChange() < minObservations)
        return current;
    const Candidate& best = reserved.best(list);
    if (tolerant.satisfies(current))
        return reserved.satisfies(best) && isWorthSwitching(best, current, goal) ? best : current;
    if (reserved.satisfies(best))
        return best;
    return exact.excess(nearest) < (1 - timeGain) * exact.excess(current) ? nearest : current;
}

uint32_t missedLimits(const Candidate& c, const AgaaGoal& goal) {
    const auto missed = [](double number, double limit, uint32_t bit) { return ratioOf(number, limit) > 1 ? bit : 0u; };
    return missed(c.errorShare, goal.maxErrorShare, AGAA_LIMIT_ERROR_SHARE) |
           missed(c.error, goal.maxError, AGAA_LIMIT_ERROR) |
           missed(c.milliseconds, goal.maxMilliseconds, AGAA_LIMIT_MILLISECONDS) |
           missed(double(c.bytes), double(goal.maxBytes), AGAA_LIMIT_BYTES);
}

// Returns the row of a choice, or null if nothing is chosen yet.
const ChoiceRow* chosenRow(const AgaaChoice& choice) {
    if (!choice.technique)
        return nullptr;
    const ChoiceRow* row = rowOf(choice);
    require(row, AGAA_ERROR_INVALID_ARGUMENT, "the AgaaChoice has settings that are not in the table of choices.");
    return row;
}

AgaaChoice describe(const Candidate& chosen, const AgaaGoal& goal, const ChoiceMemory& memory) {
    AgaaChoice choice = AGAA_CHOICE_INIT;
    const ChoiceRow& row = *chosen.row;
    choice.technique = row.technique;
    choice.preset = *row.preset ? row.preset : nullptr;
    choice.samples = row.samples;
    choice.aggregates = row.aggregates;
    choice.generationTier = row.tier;
    choice.missedLimits = missedLimits(chosen, goal);
    choice.errorShare = chosen.errorShare;
    choice.errorShareMedian = chosen.errorShareMedian;
    choice.errorShareWorst = chosen.errorShareWorst;
    choice.error = chosen.error;
    choice.milliseconds = float(chosen.milliseconds);
    choice.hasTimes = memory.hasTimes();
    choice.bytes = chosen.bytes;
    return choice;
}

} // namespace

void applySettings(const ChoiceRow& row, AgaaConfig& config, AgaaAggregation& aggregation,
                   AgaaMeasurement* measurement) {
    config.generationTier = row.tier; // which presets read
    if (*row.preset)
        applyPreset(row.preset, config, aggregation, measurement);
    else
        applyDefaults(config, aggregation, measurement);
    config.technique = row.technique;
    config.samples = row.samples;
    config.aggregates = std::max(row.aggregates, 1u);
    config.visibilityTier = AGAA_TIER_AUTO;
}

AgaaChoice chooseSettings(const TunedView& view, const AgaaGoal& goal, const AgaaObservation& observation,
                          const AgaaChoice& current) {
    checkGoal(goal);
    checkObservation(observation);
    const Predictions predictions(goal);
    const ChoiceRow* currentRow = chosenRow(current);
    ChoiceMemory memory(current, predictions);
    memory.learn(observation, view.facts);
    if (currentRow && (observation.flags & AGAA_OBSERVED_TIMES) && rowOf(observation) == currentRow)
        memory.countObservation();

    const Candidates candidates = listCandidates(view, goal, predictions, memory);
    const auto& list = candidates.list;
    const auto kept = std::find_if(list.begin(), list.end(), [&](const Candidate& c) { return c.row == currentRow; });
    const Candidate& chosen = kept == list.end() ? Order(goal).best(list) : choose(list, *kept, goal, memory);
    const bool hasChanged = chosen.row != currentRow;
    if (hasChanged)
        memory.restartCount();

    AgaaChoice choice = describe(chosen, goal, memory);
    choice.hasChanged = hasChanged;
    choice.leftOut = candidates.excluded;
    memory.store(choice);
    const auto satisfying =
        size_t(std::count_if(list.begin(), list.end(), [&](const Candidate& c) { return Order(goal).satisfies(c); }));
    const bool waits = !hasChanged && memory.hasTimes() && memory.observationsSinceChange() < minObservations;
    explain(choice, goal, predictions, satisfying, list.size(), waits, candidates.firstReason.message);
    return choice;
}

void applyChoice(const AgaaChoice& choice, AgaaConfig& config, AgaaAggregation& aggregation,
                 AgaaMeasurement* measurement) {
    const ChoiceRow* row = chosenRow(choice);
    require(row, AGAA_ERROR_INVALID_ARGUMENT, "nothing is chosen yet: AgaaChoice::technique is null.");
    applySettings(*row, config, aggregation, measurement);
}

} // namespace agaa
