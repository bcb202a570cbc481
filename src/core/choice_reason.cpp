#include "core/choice_reason.h"

#include "core/error.h"
#include "core/names.h"

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

std::string whyText(const AgaaChoice& choice, const AgaaGoal& goal, size_t holding, size_t count) {
    const char* least = goal.prefer == AGAA_PREFER_TIME ? "time" : "error";
    if (holding == 0)
        return format("comes nearest: none of %zu settings holds all limits, and it misses %s", count,
                      limitsText(choice.missedLimits).c_str());
    if (choice.missedLimits)
        return format("is kept within the margin, though it misses %s", limitsText(choice.missedLimits).c_str());
    if (!choice.hasChanged)
        return format("is kept: no other of the %zu settings that hold all limits gains enough %s", holding, least);
    return format("has the least %s of the %zu settings of %zu that hold all limits", least, holding, count);
}

} // namespace

void explain(AgaaChoice& choice, const AgaaGoal& goal, size_t holding, size_t count, const std::string& leftOutBecause) {
    std::string text = settingsText(choice) + " " + whyText(choice, goal, holding, count) + ". ";
    text += format("Predicted: error %.3g of single's (median %.3g, worst %.3g), %.3g ms%s, %.3g MB.", choice.errorShare,
                   choice.errorShareMedian, choice.errorShareWorst, choice.milliseconds,
                   choice.hasTimes ? "" : " on the table's device", double(choice.bytes) * 1e-6);
    if (choice.leftOut)
        text += format(" %u settings are left out, the first because %s", choice.leftOut, leftOutBecause.c_str());
    const size_t length = std::min(text.size(), sizeof choice.reason - 1);
    std::memcpy(choice.reason, text.data(), length);
    choice.reason[length] = 0;
}

} // namespace agaa
