// What a technique is: a row of a table. src/core/techniques/ has them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace agaa {

class PlanBuilder;

struct Technique {
    const char* name;
    uint32_t maxAggregates; // c or S, of techniques with a generation stage; 0: none
    bool multisampled;      // runs at more than one sample per pixel
    bool groupsSamples;     // by where they lie and what they show: tier IDS, lit shadows, gloss, elliptic lobes
    void (*build)(PlanBuilder& builder);
};
const std::vector<const Technique*>& techniques();
const Technique* findTechnique(std::string_view name); // null where there is none

} // namespace agaa
