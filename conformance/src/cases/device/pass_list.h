// The draw passes of views, for the tests of agaaGetDrawPasses.
#pragma once

#include "frame_rig.h"

namespace agaa::conformance {

// Passes, each with the struct of the device's API.
struct PassList {
    PassList(Test& test, AgaaView view);
    std::vector<AgaaDrawPass> passes;
    std::vector<AgaaVkDrawPass> vk;
    std::vector<AgaaGlDrawPass> gl;
};

using VisitPasses = std::function<void(const ViewDescription&, const PassList&, const std::string& technique)>;
void visitView(Test& test, const ScopedContext& context, const ViewDescription& description, const VisitPasses& visit);
// Runs over each technique that the device supports, with n of samplesOf() for 4 samples. Passes are listed once for
// all tests of a device.
void forTechniques(Test& test, const VisitPasses& visit);
std::string passText(const std::string& technique, const AgaaDrawPass& pass);

} // namespace agaa::conformance
