// Every technique with every tier that runs on the devices of the tests, for cases that must hold in all of them.
#pragma once

#include "view_settings.h"

#include <ostream>

namespace agaa::test {

struct TechniqueTier {
    const char* technique;
    uint32_t n;
    uint32_t tier = AGAA_TIER_AUTO; // of generation
    uint32_t visibility = AGAA_TIER_AUTO;
    uint64_t flags = 0; // AGAA_CONFIG_…
    uint64_t coverageFlags = 0;
    const char* layout = nullptr; // a built-in one
    bool isBatched = false;       // the lists take more than one draw of the scene: the view has batchedExtent
    bool isMixed = false;         // each third draw is not fetched
    // How often the material of a primitive is evaluated in a pixel.
    enum class Evaluations { Once, EachTexel, EachSample, OfOtherPasses } evaluations = Evaluations::Once;
};
std::ostream& operator<<(std::ostream& out, const TechniqueTier& tier);

// A view of this size with two fragments in each pixel takes more than one batch.
constexpr glm::uvec2 batchedExtent{322, 242};

const std::vector<TechniqueTier>& techniqueTiers();
bool fetches(const TechniqueTier& tier);
// Returns whether fragments carry their materials in lists or surfaces.
bool carriesMaterials(const TechniqueTier& tier);
// Returns whether the tier runs on a device of these capabilities.
bool runs(const TechniqueTier& tier, const AgaaDeviceCaps& caps);
// Sets technique and tier. Size, camera and facts are the caller's.
void apply(const TechniqueTier& tier, ViewSettings& settings);

} // namespace agaa::test
