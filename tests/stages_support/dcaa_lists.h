// What `dcaa` leaves in memory, read back.
#pragma once

#include "shown.h"

#include "paper_merge.h"

#include <vector>

namespace agaa::test {

struct Kept {
    std::vector<std::vector<uint32_t>> lists;        // of each pixel, the ids of its fragments, last drawn first
    std::vector<std::vector<paper::Surface>> pixels; // the surfaces of each
    std::vector<std::vector<uint32_t>> words;        // theirs
    AgaaCounters counters{};
    std::vector<float> rgb; // the image
};

// Buffers, and the words of what they hold. Without lists there are no fragments.
struct KeptBuffers {
    std::vector<uint32_t> fragments, surfaces;
    uint32_t payloadWords = 0; // of a fragment, beside id, next fragment and mask
    uint32_t stride = 0;       // of a surface
};
Kept keptOf(const ViewSettings& settings, const KeptBuffers& buffers, const AgaaCounters& counters);

// Texels may have words that no surface of their pixel needs, after the others.
std::vector<uint32_t> withoutRests(const std::vector<uint32_t>& words, size_t pixels, size_t wordsOfPixel);

// What a frame leaves in memory.
template <class Host> Kept keepFrame(typename Host::Context& context, ViewSettings settings, const Shot& shot) {
    settings.config.flags |= AGAA_CONFIG_READBACK;
    settings.config.coverage.maxBatches = 1; // the lists of one draw
    return showBy<Host>(context, settings, shot, [&](typename Host::View& view) {
        const auto& plan = view.plan();
        KeptBuffers buffers{{}, view.readBuffer("surfaces"), plan.payloadWords, plan.bytesPerAggregate / 4};
        buffers.surfaces = withoutRests(buffers.surfaces, size_t(plan.view.width) * plan.view.height,
                                        plan.view.aggregates * buffers.stride);
        if (plan.fragmentCapacity)
            buffers.fragments = view.readBuffer("fragments");
        Kept kept = keptOf(settings, buffers, view.statistics().counters);
        kept.rgb = withoutAlpha(Host::rgba(view));
        return kept;
    });
}

// Rounds to what memory keeps.
void storeSurface(paper::Surface& surface, uint32_t samples);
// pixel: index among those of the view.
paper::Rules rulesOf(const ViewSettings& settings, const paper::Surface& fragment, size_t pixel);

// Masks are equal; numbers differ by steps of what memory keeps at most.
// isRounded: by programs that round differently, so that slopes may be a step apart. Both slopes of a surface have the
// step of the larger one, and half floats below their normal range step by 6e-8.
void expectSame(const std::vector<paper::Surface>& got, const std::vector<paper::Surface>& expected, size_t pixel,
                bool isRounded = false);

} // namespace agaa::test
