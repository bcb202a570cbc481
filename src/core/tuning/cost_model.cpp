#include "core/tuning/cost_model.h"

#include "core/base/names.h"

#include <algorithm>
#include <cmath>

namespace agaa {

namespace {

struct CommonCosts {
    float lightTime, tapTime;                           // nanoseconds
    float singleGeometry, coverage, complexity, lights; // medians of the scenes
};

#define AGAA_CHOICE_SCENES(count, ...)                                                                                 \
    static_assert(count == tableScenes, "the table has errors of other scenes");                                       \
    constexpr std::array<float, tableScenes> singleErrors = {__VA_ARGS__};
#define AGAA_CHOICE_COMMON(...) constexpr CommonCosts common = {__VA_ARGS__};
#define AGAA_CHOICE_ROW(...)
#include "core/tuning/choice_table.inc"

template <typename... Numbers>
constexpr ChoiceRow makeRow(const char* technique, uint32_t samples, uint32_t aggregates, const char* preset,
                            AgaaTier tier, float geometryRatio, float geometryTime, float pixelTime, float eventTime,
                            float lightRatio, float events, float eventsByComplexity, float taps,
                            float tapsByComplexity, Numbers... errors) {
    static_assert(sizeof...(errors) == tableScenes, "a row has errors of other scenes");
    return {technique,    samples,          aggregates, preset,     tier,   geometryRatio,
            geometryTime, pixelTime,        eventTime,  lightRatio, events, eventsByComplexity,
            taps,         tapsByComplexity, {errors...}};
}

#define AGAA_CHOICE_SCENES(...)
#define AGAA_CHOICE_COMMON(...)
#define AGAA_CHOICE_ROW(technique, samples, aggregates, preset, tier, ...)                                             \
    makeRow(technique, samples, aggregates, preset, AGAA_TIER_##tier, __VA_ARGS__),
constexpr ChoiceRow rows[] = {
#include "core/tuning/choice_table.inc"
};
static_assert(std::size(rows) <= maxChoiceRows);

float quantile(std::array<float, tableScenes> values, float share) {
    std::sort(values.begin(), values.end());
    const auto needed = size_t(std::ceil(share * tableScenes - 1e-4f)); // 0.8 of ten are eight
    return values[std::clamp<size_t>(needed, 1, tableScenes) - 1];
}

double eventsOf(const ChoiceRow& row, double complexity) { return row.events + row.eventsByComplexity * complexity; }

} // namespace

std::span<const ChoiceRow> choiceRows() { return rows; }

const ChoiceRow* findRow(const char* technique, uint32_t samples, uint32_t aggregates, const char* preset,
                         uint32_t tier) {
    for (const ChoiceRow& row : choiceRows())
        if (technique && isSameName(row.technique, technique) && row.samples == samples &&
            row.aggregates == aggregates && isSameName(row.preset, preset ? preset : "") && uint32_t(row.tier) == tier)
            return &row;
    return nullptr;
}

float errorShareIn(const ChoiceRow& row, float share) { return quantile(row.errorShares, share); }

float errorIn(const ChoiceRow& row, float share) {
    std::array<float, tableScenes> errors;
    for (size_t scene = 0; scene < tableScenes; ++scene)
        errors[scene] = row.errorShares[scene] * singleErrors[scene];
    return quantile(errors, share);
}

SceneTerms usualTerms(const AgaaSceneFacts& facts) {
    return {common.coverage, common.complexity, std::min<double>(common.lights, facts.maxLights),
            double(facts.shadowMapCount)};
}

FrameTimes predictTimes(const ChoiceRow& row, const SceneTerms& terms, uint64_t pixels) {
    const double events = eventsOf(row, terms.complexity) * terms.coverage;
    const double taps = tapsOf(row, terms.complexity) * terms.coverage * terms.shadows;
    const double lights = terms.lights * row.lightRatio;
    const double milliseconds = double(pixels) * 1e-6; // a nanosecond per pixel
    return {(row.geometryRatio * double(common.singleGeometry) + row.geometryTime) * milliseconds,
            (row.pixelTime + events * (row.eventTime + lights * common.lightTime) + taps * common.tapTime) *
                milliseconds};
}

double tapsOf(const ChoiceRow& row, double complexity) { return row.taps + row.tapsByComplexity * complexity; }

std::optional<double> complexityOf(const ChoiceRow& row, double events) {
    constexpr float minSlope = 0.5f; // below this, the scenes of the table differ more
    if (row.eventsByComplexity < minSlope)
        return std::nullopt;
    return std::clamp((events - row.events) / row.eventsByComplexity, 0.0, 1.0);
}

} // namespace agaa
