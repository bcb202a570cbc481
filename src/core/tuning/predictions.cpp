#include "core/tuning/predictions.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/structs.h"

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

Predictions::Predictions(const AgaaGoal& goal) : areMeasured_(goal.measuredCount > 0) {
    require(!areMeasured_ || goal.measured, AGAA_ERROR_INVALID_ARGUMENT, "AgaaGoal::measured is null.");
    for (uint32_t i = 0; i < goal.measuredCount; ++i) {
        requireEqualSizes(elementOf(goal.measured, i), goal.measured);
        addMeasured(readStruct(elementOf(goal.measured, i)), goal);
    }
    if (hasMeasuredTimes())
        numberTimes();
    if (areMeasured_)
        return;
    for (const ChoiceRow& row : choiceRows())
        list_.push_back({&row, errorShareIn(row, goal.sceneShare), errorShareIn(row, 0.5f), errorShareIn(row, 1.0f),
                         errorIn(row, goal.sceneShare)});
}

void Predictions::addMeasured(const AgaaMeasuredSettings& m, const AgaaGoal& goal) {
    const std::string name = format("AgaaGoal::measured[%zu]", list_.size());
    checkNumbers(m, name);
    checkErrors(m, goal, name);
    const ChoiceRow* row = rowOf(m);
    if (!row)
        refuse(name + " has settings that are not in the table of choices.");
    if (std::any_of(list_.begin(), list_.end(), [&](const Prediction& other) { return other.row == row; }))
        refuse(name + " has the settings of an element before it.");
    if (!list_.empty() && isTimed(m) != hasMeasuredTimes())
        refuse("AgaaGoal::measured has times of some settings and not of others.");
    list_.push_back({row, m.errorShare, m.errorShare, m.errorShare, m.error});
    if (!isTimed(m))
        return;
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
