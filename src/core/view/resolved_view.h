// A view as a device runs it: the value that planning reads.
#pragma once

#include "core/view/technique.h"
#include "core/view/view_settings.h"

#include <string>
#include <vector>

namespace agaa {

// Settings without features that the scene or the technique does not use, with all defaults set.
struct ResolvedView : ViewSettings {
    ResolvedView() = default;
    explicit ResolvedView(const ViewSettings& settings) : ViewSettings(settings) {}

    AgaaTier visibilityTier = AGAA_TIER_NATIVE;
    uint32_t hwSamples = 1;                     // samples per texel of the target
    uint32_t scaleX = 1, scaleY = 1;            // texels of the target per pixel
    uint32_t layers = 1;                        // of the target, one below the other
    bool placesSamples = false;                 // the executor sets the locations of the samples in a texel
    AgaaTier generationTier = AGAA_TIER_AUTO;   // AUTO: the technique has no generation stage
    const GenerationTier* generation = nullptr; // the row of generationTier, or null
    AgaaLanes lanes = AGAA_LANES_AUTO;          // of passes with several variants; AUTO: the view has none
    std::vector<std::string> notes;             // why tiers were chosen and settings ignored, one sentence each

    bool knowsMaterials() const { return generation && generation->knowsMaterials; }
    bool countsPrimitives() const { return generation && generation->countsPrimitives; }
    bool readsGBuffer() const { return generation && generation->readsGBuffer; }
    bool sumsFragments() const { return generation && generation->sumsFragments; }
    bool isModel() const { return generation && generation->isModel; }         // it is priced and never run
    bool accumulates() const { return config.flags & AGAA_CONFIG_ACCUMULATE; } // frames
    bool hasCounters() const { return config.flags & AGAA_CONFIG_COUNTERS; }
    // Returns whether two geometry passes need the normals of samples: to group them, to count samples with geometry,
    // and to know fragments at the far plane, which a reversed depth has not.
    bool needsSampleNormals() const { return aggregates > 1 || hasCounters() || !reversedZ; }
    // Returns whether aggregates have the second moments of their normals.
    bool keepsNormalMoments() const {
        return config.ndf > AGAA_NDF_TOKSVIG || measurement.diffuseFilter == AGAA_DIFFUSE_SGGX;
    }
    // Returns whether aggregates have the moments of their samples' depths.
    bool storesDepth() const { return measurement.flags & AGAA_MEASURE_STORED_DEPTH; }
    // Bytes per pixel, besides the aggregates in memory, that record which samples have an aggregate. Two geometry
    // passes need them if a sample may go to any aggregate.
    uint64_t claimBytes() const { return measurement.flags & AGAA_MEASURE_FIRST_SAMPLE_ROUTING ? 4 : 0; }
};

// Throws Error if the device cannot run the view; the message says why, and names other techniques of the table.
ResolvedView resolveForDevice(const ViewSettings& settings, const AgaaDeviceCaps& caps, TechniqueTable table);

// Sets the limits within which fragments count as one surface, except those that the host set: the lowest cosine
// between normals, the distance in pixels and the difference of materials in [0;1].
void setSurfaceDefaults(ViewSettings& view, float cosine, float distance, float material);

} // namespace agaa
