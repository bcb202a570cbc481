#include "core/tuning/choice_reason.h"

#include "core/base/error.h"
#include "core/base/names.h"

#include <algorithm>
#include <cstring>

namespace agaa {

namespace {

std::string settingsText(const AgaaChoice& choice) {
    std::string text = format("\"%s\"", choice.technique);
    if (choice.samples > 1)
        text += format(" n=%u", choice.samples);
    if (choice.preset)
        text += format(" %s", choice.preset);
    else if (choice.aggregates)
        text += format(" c=%u", choice.aggregates);
    if (choice.generationTier != AGAA_TIER_AUTO)
        text += format(" (%s)", tierName(choice.generationTier));
    return text;
}

std::string limitsText(uint32_t missed) {
    std::string text;
    for (const auto& [bit, name] : {std::pair{AGAA_LIMIT_ERROR_SHARE, "maxErrorShare"},
                                    {AGAA_LIMIT_ERROR, "maxError"},
                                    {AGAA_LIMIT_MILLISECONDS, "maxMilliseconds"},
                                    {AGAA_LIMIT_BYTES, "maxBytes"}})
        if (missed & bit)
            text += (text.empty() ? "" : " and ") + std::string(name);
    return text;
}

std::string whyText(const AgaaChoice& choice, const AgaaGoal& goal, size_t satisfying, size_t count, bool waits) {
    const char* criterion = goal.prefer == AGAA_PREFER_TIME ? "time" : "error";
    if (satisfying == 0)
        return format("comes nearest: none of %zu settings holds all limits, and it misses %s", count,
                      limitsText(choice.missedLimits).c_str());
    const char* until = waits ? " until more of its frames were observed" : "";
    if (choice.missedLimits)
        return format("is kept%s, though it misses %s%s", until, limitsText(choice.missedLimits).c_str(),
                      waits ? "" : ": others would gain too little");
    if (!choice.hasChanged)
        return waits ? format("is kept%s", until)
                     : format("is kept: no other of the %zu settings that hold all limits gains enough %s", satisfying,
                              criterion);
    return format("is chosen for its %s: %zu of %zu settings hold all limits", criterion, satisfying, count);
}

std::string errorsText(const AgaaChoice& choice, const Predictions& predictions) {
    if (predictions.isMeasured(rowOf(choice)))
        return format("Measured: error %.3g of single's. Predicted: ", choice.errorShare);
    const size_t count = predictions.measuredCount();
    const std::string from = count > 0 ? format(" from %zu measured setting%s", count, count == 1 ? "" : "s") : "";
    return format("Predicted%s: error %.3g of single's (median %.3g, worst %.3g), ", from.c_str(), choice.errorShare,
                  choice.errorShareMedian, choice.errorShareWorst);
}

} // namespace

void explain(AgaaChoice& choice, const AgaaGoal& goal, const Predictions& predictions, size_t satisfying, size_t count,
             bool waits, const std::string& firstExclusion) {
    std::string text = settingsText(choice) + " " + whyText(choice, goal, satisfying, count, waits) + ". ";
    const bool isOfDevice = choice.hasTimes || predictions.hasMeasuredTimes();
    text += errorsText(choice, predictions) + format("%.3g ms%s, %.3g MB.", choice.milliseconds,
                                                     isOfDevice ? "" : " on the table's device",
                                                     double(choice.bytes) * 1e-6);
    if (choice.leftOut)
        text += format(" %u settings are left out, the first because %s", choice.leftOut, firstExclusion.c_str());
    const size_t length = std::min(text.size(), sizeof choice.reason - 1);
    std::memcpy(choice.reason, text.data(), length);
    choice.reason[length] = 0;
}

} // namespace agaa
