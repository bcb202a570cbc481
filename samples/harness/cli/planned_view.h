// Views that are planned and not created: their device, facts and functions.
#pragma once

#include "cli/commands.h"

#include <optional>
#include <string>

namespace harness {

// Throws with the SDK's own sentence.
class Sdk {
public:
    AgaaLog* log() { return &log_; }
    void check(AgaaResult result) const;

private:
    static void AGAA_CALL keepMessage(void* user, uint32_t severity, AgaaResult code, const char* message);

    std::string message_;
    AgaaLog log_ = {AGAA_STRUCTURE_TYPE_LOG, sizeof(AgaaLog), nullptr, keepMessage, &message_};
};

// The device that a plan is made for: the one asked for, else Mesa's software rasterisers' limits,
// which are the least that the SDK runs on. Empty: the ideal device of the papers' model.
std::optional<AgaaDeviceCaps> planningDevice(const Configuration& configuration, const DeviceArguments& device);

// Of a plan or of its memory. It points to what it is given.
AgaaViewDesc viewOf(const Configuration& configuration, const AgaaSceneFacts& facts, const AgaaFetchFunction& fetch,
                    bool reversedZ, bool clipZFromMinusOne);

// Plans depend on there being functions, not on what they say.
AgaaFetchFunction anyFetch(bool ofAllDraws);

// sceneGiven: facts are those of the scene, else all. Less the effects of --without.
AgaaSceneFacts plannedFacts(const RenderArguments& arguments, bool sceneGiven);

} // namespace harness
