// Algorithm 1 of the DCAA paper (Wang et al., I3D 2016, sections 3.2 and 3.3), written from its text, and the SDK's own
// rule (AGAA_MERGE_VISIBLE).
#pragma once

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace paper {

using Bits = std::bitset<128>;

struct Surface {
    Bits coverage;
    float depth, slopeX, slopeY;
    float middle, below, above; // a depth in the range, and the distances of its ends
    float normal[3];
};

// ---- the paper's words ---------------------------------------------------------------------------

// "To test this, we approximate a fragment bounding box using depth derivatives over the pixel extent."
struct Box {
    float front, back;
};
inline Box boxOf(const Surface& s) {
    const float half = 0.5f * (std::fabs(s.slopeX) + std::fabs(s.slopeY));
    const auto within = [&](float z) { return std::min(std::max(z, s.middle - s.below), s.middle + s.above); };
    return {within(s.depth - half), within(s.depth + half)};
}
inline float overlapOf(const Surface& a, const Surface& b) {
    const Box x = boxOf(a), y = boxOf(b);
    return std::min(x.back, y.back) - std::max(x.front, y.front);
}
inline float dotOf(const float (&a)[3], const float (&b)[3]) {
    const float x = a[0] * b[0], y = a[1] * b[1], z = a[2] * b[2];
    return x + y + z;
}
inline float dotOf(const Surface& a, const Surface& b) { return dotOf(a.normal, b.normal); }

// "averaging normals, depths, and material parameters based on a weighted average of the fragment's and surface's
// coverage"
inline void average(Surface& into, const Surface& from, const Bits& bits, size_t ofInto, size_t ofFrom, float slack) {
    const float share = float(ofFrom) / float(ofInto + ofFrom);
    const auto mix = [share](float& a, float b) { a += (b - a) * share; };
    if (overlapOf(into, from) + slack >= 0.0f) {
        mix(into.depth, from.depth);
        mix(into.slopeX, from.slopeX);
        mix(into.slopeY, from.slopeY);
        const float nearest = std::min(into.middle - into.below, from.middle - from.below);
        const float farthest = std::max(into.middle + into.above, from.middle + from.above);
        into.middle = (nearest + farthest) * 0.5f;
        into.below = into.above = (farthest - nearest) * 0.5f;
    }
    float n[3];
    for (int i = 0; i < 3; ++i)
        n[i] = into.normal[i] + (from.normal[i] - into.normal[i]) * share;
    const float xx = n[0] * n[0], yy = n[1] * n[1], zz = n[2] * n[2];
    const float squared = xx + yy + zz;
    if (squared > 1e-12f)
        for (int i = 0; i < 3; ++i)
            into.normal[i] = n[i] * (1.0f / std::sqrt(squared));
    into.coverage |= bits;
}

struct Rules {
    size_t limit;
    float cosine, slack;
    enum { Visible, Paper, None } rule; // AgaaMerge
    // "we need a facet normal and depth to merge surfaces" (section 4.3). Returns the angle's cosine.
    std::function<float(const Surface&, const Surface&)> facetCosine;

    float alignment(const Surface& a, const Surface& b) const {
        return rule == Visible ? dotOf(a, b) : facetCosine(a, b);
    }
};

struct Pixel {
    std::vector<Surface> surfaces;
    uint32_t mergedFirst = 0, mergedSecond = 0, discarded = 0, lostSamples = 0;
    std::function<void(Surface&)> store = [](Surface&) {}; // what memory keeps of a surface

    void insert(Surface in, const Rules& rules) {
        std::optional<size_t> best;
        for (size_t i = 0; i < surfaces.size(); ++i) {
            if (!(rules.alignment(surfaces[i], in) > rules.cosine) ||
                !(overlapOf(surfaces[i], in) + rules.slack >= 0.0f))
                continue;
            if (rules.rule == Rules::Visible && (surfaces[i].coverage & in.coverage).any())
                continue;
            const auto rank = [&](size_t k) {
                return std::pair(rules.alignment(surfaces[k], in), overlapOf(surfaces[k], in));
            };
            if (!best || rank(i) > rank(*best))
                best = i;
        }
        if (best) {
            ++mergedFirst;
            Surface& s = surfaces[*best];
            average(s, in, in.coverage, s.coverage.count(), in.coverage.count(), rules.slack);
            return store(s);
        }
        if (surfaces.size() < rules.limit)
            return surfaces.push_back(in);
        insertInFull(in, rules);
    }

private:
    void insertInFull(const Surface& in, const Rules& rules) {
        std::vector<Surface> all = surfaces;
        all.push_back(in);
        const std::vector<size_t> order = frontToBack(all);
        const std::vector<Bits> visible = visibleOf(all, order);
        const bool byCost = rules.rule == Rules::Visible;
        const size_t least = byCost ? cheapest(all, visible) : showingLeast(visible, order[0]);
        const Bits moving = byCost ? visible[least] : all[least].coverage;
        std::optional<size_t> taker;
        if (rules.rule != Rules::None && moving.any())
            taker = byCost ? std::optional(likest(all, least)) : overlapping(all, least, rules.slack);
        if (taker) {
            ++mergedSecond;
            const Bits own = byCost ? visible[*taker] : all[*taker].coverage;
            average(all[*taker], all[least], moving, own.count(), moving.count(), rules.slack);
            store(all[*taker]);
        } else {
            ++discarded;
            lostSamples += uint32_t(visible[least].count());
        }
        all[least] = all.back(); // without effect on the fragment itself
        all.pop_back();
        surfaces = all;
    }

    static std::vector<size_t> frontToBack(const std::vector<Surface>& all) {
        std::vector<size_t> order(all.size());
        for (size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        const auto centre = [&](size_t i) {
            return std::min(std::max(all[i].depth, all[i].middle - all[i].below), all[i].middle + all[i].above);
        };
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return centre(a) < centre(b); });
        return order;
    }

    // "ordering surfaces front to back and use bitwise operations to mask off samples covered by closer surfaces"
    static std::vector<Bits> visibleOf(const std::vector<Surface>& all, const std::vector<size_t>& order) {
        std::vector<Bits> visible(all.size());
        Bits covered;
        for (const size_t i : order) {
            visible[i] = all[i].coverage & ~covered;
            covered |= all[i].coverage;
        }
        return visible;
    }

    // "we exclude the closest surface when identifying the one with the least coverage"
    static size_t showingLeast(const std::vector<Bits>& visible, size_t closest) {
        size_t least = closest == 0 ? 1 : 0;
        for (size_t i = 0; i < visible.size(); ++i)
            if (i != closest && visible[i].count() <= visible[least].count())
                least = i;
        return least;
    }

    static std::optional<size_t> overlapping(const std::vector<Surface>& all, size_t least, float slack) {
        std::optional<size_t> taker;
        for (size_t i = 0; i < all.size(); ++i)
            if (i != least && overlapOf(all[i], all[least]) + slack >= 0.0f &&
                (!taker || overlapOf(all[i], all[least]) > overlapOf(all[*taker], all[least])))
                taker = i;
        return taker;
    }

    // Of those whose depths overlap the one of the closest normal, otherwise the nearest in depth.
    static size_t likest(const std::vector<Surface>& all, size_t i) {
        const auto rank = [&](size_t k) {
            const float overlap = overlapOf(all[k], all[i]);
            return overlap >= 0.0f ? std::pair(1, dotOf(all[k], all[i])) : std::pair(0, overlap);
        };
        size_t best = i == 0 ? 1 : 0;
        for (size_t k = 0; k < all.size(); ++k)
            if (k != i && rank(k) > rank(best))
                best = k;
        return best;
    }

    // Samples that it shows, times how little it is like what takes it.
    static size_t cheapest(const std::vector<Surface>& all, const std::vector<Bits>& visible) {
        std::vector<float> costs;
        for (size_t i = 0; i < all.size(); ++i) {
            const size_t taker = likest(all, i);
            const float apart = overlapOf(all[i], all[taker]) >= 0.0f ? 0.0f : 0.5f;
            costs.push_back(float(visible[i].count()) * (1.1f - dotOf(all[i], all[taker]) + apart));
        }
        return all.size() - 1 - size_t(std::min_element(costs.rbegin(), costs.rend()) - costs.rbegin());
    }
};

} // namespace paper
