#include "core/plan/sample_order.h"

#include <algorithm>
#include <cmath>

namespace agaa {

std::vector<SamplePosition> positionsOf(const Plan& plan) {
    const SamplePositions all = samplePositions(plan.view);
    return {all.begin(), all.begin() + plan.view.samples};
}

// Returns the squared distances to the chosen samples in ascending order, on a pixel whose opposite edges are joined.
// They are rounded, so that equal distances compare equal.
static std::vector<uint32_t> distances(const std::vector<SamplePosition>& positions,
                                       const std::vector<uint32_t>& chosen, uint32_t i) {
    std::vector<uint32_t> out;
    for (const uint32_t other : chosen) {
        const auto across = [](float d) { return std::min(std::fabs(d), 1 - std::fabs(d)); };
        const float x = across(positions[i].x - positions[other].x), y = across(positions[i].y - positions[other].y);
        out.push_back(uint32_t(std::lround(65536 * (x * x + y * y))));
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<uint32_t> sampleOrder(const std::vector<SamplePosition>& positions) {
    const auto fromCentre = [&](uint32_t i) { return std::hypot(positions[i].x - 0.5f, positions[i].y - 0.5f); };
    const uint32_t count = uint32_t(positions.size());
    uint32_t first = 0;
    for (uint32_t i = 1; i < count; ++i)
        if (fromCentre(i) < fromCentre(first) - 1e-6f)
            first = i;
    std::vector<uint32_t> order = {first};
    while (order.size() < count) {
        uint32_t best = 0;
        std::vector<uint32_t> farthest;
        for (uint32_t i = 0; i < count; ++i) {
            if (std::find(order.begin(), order.end(), i) != order.end())
                continue;
            std::vector<uint32_t> toChosen = distances(positions, order, i);
            if (farthest.empty() || toChosen > farthest) {
                farthest = std::move(toChosen);
                best = i;
            }
        }
        order.push_back(best);
    }
    return order;
}

} // namespace agaa
