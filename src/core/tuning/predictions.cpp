#include "core/tuning/predictions.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/tuning/error_model.h"

#include <algorithm>
#include <bit>

namespace agaa {

namespace {

[[noreturn]] void refuse(const std::string& message) { fail(AGAA_ERROR_INVALID_ARGUMENT, message); }

void checkNumbers(const AgaaMeasuredSettings& m, const std::string& name) {
    constexpr double largest = 1e9;
    checkReserved(m.reserved, (name + ".reserved").c_str());
    checkRange(double(m.errorShare), 0.0, largest, (name + ".errorShare").c_str());
    checkRange(double(m.error), 0.0, largest, (name + ".error").c_str());
    checkRange(double(m.geometryMilliseconds), 0.0, largest, (name + ".geometryMilliseconds").c_str());
    checkRange(double(m.shadingMilliseconds), 0.0, largest, (name + ".shadingMilliseconds").c_str());
}

bool isTimed(const AgaaMeasuredSettings& m) { return m.geometryMilliseconds > 0 || m.shadingMilliseconds > 0; }

// An error of 0 would satisfy every limit, so that it must not represent an unknown one.
void checkErrors(const AgaaMeasuredSettings& m, const AgaaGoal& goal, const std::string& name) {
    if (m.errorShare <= 0)
        refuse(name + ".errorShare is 0, as if it was not measured.");
    if (goal.maxError > 0 && m.error <= 0)
        refuse("AgaaGoal::maxError is a limit, and " + name + ".error is 0, as if it was not measured.");
}

} // namespace

Predictions::Predictions(const AgaaGoal& goal) {
    require(!goal.measuredCount || goal.measured, AGAA_ERROR_INVALID_ARGUMENT, "AgaaGoal::measured is null.");
    for (uint32_t i = 0; i < goal.measuredCount; ++i) {
        requireEqualSizes(elementOf(goal.measured, i), goal.measured);
        addMeasured(readStruct(elementOf(goal.measured, i)), goal);
    }
    measuredCount_ = list_.size();
    if (hasMeasuredTimes())
        numberTimes();
    if (measuredCount_ == 0)
        addTable(goal);
    else if (goal.flags & AGAA_GOAL_PREDICT_OTHERS)
        addOthers(goal);
}

void Predictions::addTable(const AgaaGoal& goal) {
    for (const ChoiceRow& row : choiceRows())
        list_.push_back({&row, errorShareIn(row, goal.sceneShare), errorShareIn(row, 0.5f), errorShareIn(row, 1.0f),
                         errorIn(row, goal.sceneShare), false});
}

void Predictions::addOthers(const AgaaGoal& goal) {
    constexpr double nearlyCertain = 0.98;
    std::vector<MeasuredShare> measured;
    for (const Prediction& p : list_)
        measured.push_back({p.row, p.errorShare});
    const ErrorModel model(measured);
    const float singleError = meanSingleError();
    for (const ChoiceRow& row : choiceRows()) {
        if (contains(row))
            continue;
        const float share = model.errorShare(row, double(goal.sceneShare));
        const float worst = std::max(share, model.errorShare(row, nearlyCertain));
        list_.push_back({&row, share, model.errorShare(row, 0.5), worst, share * singleError, false});
    }
}

bool Predictions::isMeasured(const ChoiceRow* row) const {
    return std::any_of(list_.begin(), list_.end(), [&](const Prediction& p) { return p.row == row && p.isMeasured; });
}

// The measured errors of "single", which all settings of a scene share, or 0 if there is none.
float Predictions::meanSingleError() const {
    double sum = 0, count = 0;
    for (const Prediction& p : list_)
        if (p.error > 0) {
            sum += double(p.error) / double(p.errorShare);
            ++count;
        }
    return count > 0 ? float(std::min(sum / count, 1e9)) : 0;
}

bool Predictions::contains(const ChoiceRow& row) const {
    return std::any_of(list_.begin(), list_.end(), [&](const Prediction& other) { return other.row == &row; });
}

void Predictions::addMeasured(const AgaaMeasuredSettings& m, const AgaaGoal& goal) {
    const std::string name = format("AgaaGoal::measured[%zu]", list_.size());
    checkNumbers(m, name);
    checkErrors(m, goal, name);
    const ChoiceRow* row = rowOf(m);
    if (!row)
        refuse(name + " has settings that are not in the table of choices.");
    if (contains(*row))
        refuse(name + " has the settings of an element before it.");
    if (!list_.empty() && isTimed(m) != hasMeasuredTimes())
        refuse("AgaaGoal::measured has times of some settings and not of others.");
    list_.push_back({row, m.errorShare, m.errorShare, m.errorShare, m.error, true});
    if (!isTimed(m))
        return;
    if (goal.flags & AGAA_GOAL_PREDICT_OTHERS)
        refuse(name + " has times, and with AGAA_GOAL_PREDICT_OTHERS times come from observations.");
    if (m.pixels == 0)
        refuse(name + " has times, and its pixels are 0.");
    measuredTimes_.push_back({m.geometryMilliseconds / double(m.pixels), m.shadingMilliseconds / double(m.pixels)});
    measuredPixels_.push_back(double(m.pixels));
}

// The number is the sum of FNV-1a over each row, independent of their order. It has 24 bits, because AgaaChoice::memory
// has floats.
void Predictions::numberTimes() {
    uint32_t sum = 0;
    for (size_t i = 0; i < list_.size(); ++i) {
        uint32_t hash = 2166136261u;
        for (const uint64_t word :
             {uint64_t(list_[i].row - choiceRows().data()), std::bit_cast<uint64_t>(measuredTimes_[i].geometry),
              std::bit_cast<uint64_t>(measuredTimes_[i].shading)})
            for (int shift = 0; shift < 64; shift += 8)
                hash = (hash ^ uint32_t(word >> shift & 0xFF)) * 16777619u;
        sum += hash;
    }
    timesNumber_ = float(1 + sum % 0xFFFFFFu);
}

std::optional<FrameTimes> Predictions::times(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels) const {
    if (!hasMeasuredTimes())
        return predictTimes(row, terms, pixels);
    for (size_t i = 0; i < list_.size(); ++i)
        if (list_[i].row == &row)
            return FrameTimes{measuredTimes_[i].geometry * double(pixels), measuredTimes_[i].shading * double(pixels)};
    return std::nullopt;
}

double Predictions::measuredPixels(const ChoiceRow& row) const {
    for (size_t i = 0; i < measuredPixels_.size(); ++i)
        if (list_[i].row == &row)
            return measuredPixels_[i];
    return 0;
}

} // namespace agaa
