// Views that are planned but not created: their device, facts and functions.
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

// Returns the device for a plan: the requested device, else the limits of Mesa's software rasterisers, which are the
// lowest that the SDK runs on. Empty stands for the ideal device of the papers' model.
std::optional<AgaaDeviceCaps> planningDevice(const Configuration& configuration, const DeviceArguments& device);

// Describes a view for a plan or for its memory. The description points to the arguments.
AgaaViewDesc viewOf(const Configuration& configuration, const AgaaSceneFacts& facts, const AgaaFetchFunction& fetch,
                    bool reversedZ, bool clipZFromMinusOne);

// Plans depend on the presence of functions, not on their texts.
AgaaFetchFunction anyFetch(bool forAllDraws, bool computesTriangles);

// Returns the facts of the scene if sceneGiven, else all effects, without the effects of --without.
AgaaSceneFacts plannedFacts(const RenderArguments& arguments, bool sceneGiven);

} // namespace harness
