#include "core/tuning/observations.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/names.h"

#include <algorithm>

namespace agaa {

namespace {

bool isSame(const char* a, const char* b) { return a && b ? isSameName(a, b) : a == b; }

bool areSameSettings(const AgaaObservation& a, const AgaaObservation& b) {
    return isSame(a.technique, b.technique) && isSame(a.preset, b.preset) && a.samples == b.samples &&
           a.aggregates == b.aggregates && a.generationTier == b.generationTier && a.pixels == b.pixels;
}

constexpr double maxMean = 1e6;

// There are events.
void readCounts(const AgaaCounters& c, AgaaObservation& o) {
    const double pixels = double(o.pixels), events = double(c.shadingEvents);
    const auto mean = [](uint64_t count, double over) { return float(std::min(double(count) / over, maxMean)); };
    o.flags |= AGAA_OBSERVED_COUNTS;
    o.coverage = float(std::min(double(c.visible) / (pixels * o.samples), 1.0));
    o.eventsPerPixel = mean(c.shadingEvents, pixels);
    o.lightsPerEvent = mean(c.lightEvaluations, events);
    o.shadowTapsPerEvent = mean(c.shadowTaps, events);
}

bool isGeometry(uint32_t stage) {
    return stage == AGAA_STAGE_PREPASS || stage == AGAA_STAGE_DEFINITION || stage == AGAA_STAGE_GENERATION;
}

void readTimes(const AgaaFrameStatistics& statistics, AgaaObservation& o) {
    o.flags |= AGAA_OBSERVED_TIMES;
    o.geometryMilliseconds = o.shadingMilliseconds = 0;
    for (uint32_t i = 0; i < statistics.passCount; ++i) {
        const AgaaPassTime& pass = statistics.passes[i];
        (isGeometry(pass.stage) ? o.geometryMilliseconds : o.shadingMilliseconds) += float(pass.milliseconds);
    }
}

// Checks the times and returns whether all passes are timed.
bool checkTimes(const AgaaFrameStatistics& statistics) {
    checkRange(uint64_t(statistics.passCount), 0, AGAA_MAX_PASSES, "AgaaFrameStatistics::passCount");
    bool areTimed = statistics.passCount > 0;
    for (uint32_t i = 0; i < statistics.passCount; ++i) {
        const AgaaPassTime& pass = statistics.passes[i];
        areTimed = areTimed && pass.isTimed;
        if (pass.isTimed)
            checkRange(pass.milliseconds, 0.0, 1e7, "AgaaPassTime::milliseconds");
    }
    return areTimed;
}

} // namespace

AgaaObservation observe(const AgaaObservation& settings, const AgaaFrameStatistics& statistics,
                        const AgaaObservation& previous) {
    checkReserved(statistics.reserved, "AgaaFrameStatistics::reserved");
    const bool areTimed = checkTimes(statistics);
    AgaaObservation o = settings;
    if (areSameSettings(settings, previous)) {
        o = previous;
        o.technique = settings.technique; // static storage
        o.preset = settings.preset;
    }
    if (statistics.counters.shadingEvents > 0)
        readCounts(statistics.counters, o);
    if (areTimed)
        readTimes(statistics, o);
    return o;
}

void checkObservation(const AgaaObservation& o) {
    checkFlags(o.flags, AGAA_OBSERVED_COUNTS | AGAA_OBSERVED_TIMES, "AgaaObservation::flags");
    checkRange(uint64_t(o.samples), 0, 128, "AgaaObservation::samples");
    checkRange(uint64_t(o.aggregates), 0, 8, "AgaaObservation::aggregates");
    require(isTier(o.generationTier), AGAA_ERROR_OUT_OF_RANGE, "AgaaObservation::generationTier is not an AgaaTier.");
    checkReserved(o.reserved, "AgaaObservation::reserved");
    checkRange(double(o.coverage), 0.0, 1.0, "AgaaObservation::coverage");
    checkRange(double(o.eventsPerPixel), 0.0, maxMean, "AgaaObservation::eventsPerPixel");
    checkRange(double(o.lightsPerEvent), 0.0, maxMean, "AgaaObservation::lightsPerEvent");
    checkRange(double(o.shadowTapsPerEvent), 0.0, maxMean, "AgaaObservation::shadowTapsPerEvent");
    checkRange(double(o.geometryMilliseconds), 0.0, 1e9, "AgaaObservation::geometryMilliseconds");
    checkRange(double(o.shadingMilliseconds), 0.0, 1e9, "AgaaObservation::shadingMilliseconds");
}

} // namespace agaa
