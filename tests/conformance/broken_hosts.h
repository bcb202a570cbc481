// Hosts that do one thing wrong.
#pragma once

#include "device.h"

#include <set>

namespace agaa::conformance {

struct Broken {
    std::string name;
    std::set<std::string> failing; // the checks that fail; all others pass or are skipped
    std::string words;             // in the reason of the first of them
    std::function<void(Mistakes&)> make;
    bool isVulkanAlone = false;
};
std::vector<Broken> brokenHosts();

} // namespace agaa::conformance
