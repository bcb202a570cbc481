// A host that chooses settings for goals.
#pragma once

#include "plan_support.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace agaa::test {

inline void AGAA_CALL keepText(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity == AGAA_SEVERITY_ERROR)
        *static_cast<std::string*>(user) = message;
}

// A host with a view that has a fetch function.
struct Host {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    AgaaDeviceCaps caps = fourSampleDevice();
    AgaaGoal goal = AGAA_GOAL_INIT;
    AgaaChoice choice = AGAA_CHOICE_INIT; // the current one
    std::string message;

    Host() {
        fetch.glsl = "";
        fetch.maxDraws = fetch.maxPrimitives = 1;
        view.width = 1280;
        view.height = 720;
        view.config = &config;
        view.facts = &facts;
        view.pNext = &fetch;
    }

    AgaaResult choose(const AgaaObservation* observation = nullptr) {
        AgaaLog log = AGAA_LOG_INIT;
        log.callback = keepText;
        log.user = &message;
        return agaaChooseSettings(&view, &caps, &log, &goal, observation, &choice, &choice);
    }
    // Without the current choice.
    AgaaChoice fresh(const AgaaObservation* observation = nullptr) {
        choice = AGAA_CHOICE_INIT;
        EXPECT_EQ(choose(observation), AGAA_OK) << message;
        return choice;
    }
};

// A frame of "single" with so many lights for each event.
inline AgaaObservation frameOfSingle(float lights) {
    AgaaObservation o = AGAA_OBSERVATION_INIT;
    o.flags = AGAA_OBSERVED_COUNTS;
    o.technique = "single";
    o.samples = 1;
    o.pixels = 1280 * 720;
    o.coverage = o.eventsPerPixel = 0.6f;
    o.lightsPerEvent = lights;
    o.shadowTapsPerEvent = 1;
    return o;
}

inline bool isSame(const AgaaChoice& a, const AgaaChoice& b) {
    return std::strcmp(a.technique, b.technique) == 0 && a.samples == b.samples && a.aggregates == b.aggregates &&
           a.generationTier == b.generationTier && std::string(a.preset ? a.preset : "") == (b.preset ? b.preset : "");
}

} // namespace agaa::test
