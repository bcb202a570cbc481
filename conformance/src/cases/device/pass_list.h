// The draw passes of views, for the tests of what agaaGetDrawPasses describes.
#pragma once

#include "frame_rig.h"

namespace agaa::conformance {

// Passes with the struct of the device's API chained to each.
struct PassList {
    PassList(Test& test, AgaaView view);
    std::vector<AgaaDrawPass> passes;
    std::vector<AgaaVkDrawPass> vk;
    std::vector<AgaaGlDrawPass> gl;
};

using VisitPasses = std::function<void(const ViewDescription&, const PassList&, const std::string& technique)>;
void visitView(Test& test, const OwnContext& context, const ViewDescription& description, const VisitPasses& visit);
// Each technique that the device runs, with n = 4, or as many as samplesOf() says. Passes are listed once for all tests of a device.
void forTechniques(Test& test, const VisitPasses& visit);
std::string passText(const std::string& technique, const AgaaDrawPass& pass);

} // namespace agaa::conformance
