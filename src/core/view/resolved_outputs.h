// Values per pixel that a view writes beside its image (agaa/outputs.h), after validation.
#pragma once

#include "agaa_sdk.h"
#include "core/view/layout.h"

#include <vector>

namespace agaa {

struct ResolvedOutput {
    AgaaResolvedValue value = AGAA_RESOLVED_NEAREST_DEPTH;
    // CUSTOM: the attribute, and its first channel among those of all custom attributes.
    AgaaLayoutAttribute attribute{}; // its name is null
    uint32_t firstChannel = 0;

    bool isDepth() const { return value == AGAA_RESOLVED_NEAREST_DEPTH || value == AGAA_RESOLVED_MEAN_DEPTH; }
    // Returns whether the value is of surfaces, not of the depths of samples.
    bool isOfSurfaces() const { return value == AGAA_RESOLVED_NORMAL || value == AGAA_RESOLVED_CUSTOM; }
};

inline bool resolvesCustom(const ResolvedOutput& output) { return output.value == AGAA_RESOLVED_CUSTOM; }

// Returns the outputs that are chained to the description, in the order of the host. Throws Error if they are not
// valid.
std::vector<ResolvedOutput> readResolvedOutputs(const AgaaViewDesc& desc, const Layout& layout);

} // namespace agaa
