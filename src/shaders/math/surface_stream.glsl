// Streams the fragments of a pixel into a few surfaces that show disjoint samples. Each sample keeps the least depth of
// all fragments so far, so that a fragment takes the samples where it is nearest from the surfaces that have them.
// Source: Kerzner and Salvi 2014, "Streaming G-Buffer Compression for Multi-Sample Anti-Aliasing", as DCAA (Wang et
// al., I3D 2016) describes it in sections 2, 3.2 and 3.3.
//
// The includer defines agaa_nearestDepth(i) and agaa_setNearestDepth(i, depth), the depths of samples, and
// agaa_rounded(surface), which returns the surface with the values that memory has.
#ifndef AGAA_MATH_SURFACE_STREAM_GLSL
#define AGAA_MATH_SURFACE_STREAM_GLSL
#include "surface_merge.glsl"

// Larger than all depths.
real agaa_noDepth() { return real(3e38); }

// Returns 1 if the fragment covers sample i and is in front of all fragments so far there, and keeps its depth.
uint agaa_takeSample(agaa_CoveredSurface s, uint i, uint samples) {
    if ((s.mask[i / 32u] >> i % 32u & 1u) == 0u)
        return 0u;
    const rvec2 range = agaa_rangeOf(s);
    const rvec2 at = agaa_coveragePosition(i, samples);
    const real depth = clamp(s.plane.x + (s.plane.y * at.x + s.plane.z * at.y), range.x, range.y);
    if (!(depth < agaa_nearestDepth(i)))
        return 0u;
    agaa_setNearestDepth(i, depth);
    return 1u;
}

// Returns the samples where the fragment is in front of all fragments so far, and keeps its depths there. Four samples
// are taken at a time, because Mesa bounds the iterations of all loops.
uvec4 agaa_takeSamples(agaa_CoveredSurface s, uint samples) {
    uvec4 taken = uvec4(0u);
    for (uint i = 0u; i < samples; i += 4u) {
        if ((s.mask[i / 32u] >> i % 32u & 15u) != 0u) {
            uint four = agaa_takeSample(s, i, samples);
            four = four | agaa_takeSample(s, i + 1u, samples) << 1u;
            four = four | agaa_takeSample(s, i + 2u, samples) << 2u;
            four = four | agaa_takeSample(s, i + 3u, samples) << 3u;
            taken[i / 32u] = taken[i / 32u] | four << i % 32u;
        }
    }
    return taken;
}

// Removes samples from all surfaces. A surface without samples leaves its place free. Memory has planes relative to the
// middle of a surface's samples, so that each removal rounds the plane anew.
void agaa_removeSamples(uvec4 samples) {
    for (uint i = 0u; i < agaa_keptCount; ++i) {
        agaa_CoveredSurface s = agaa_keptAt(i);
        if (agaa_coverageCount(s.mask & samples) != 0u) {
            s.mask = s.mask & ~samples;
            agaa_keep(i, agaa_rounded(s));
        }
    }
}

// Returns the first free place of a surface, or AGAA_NO_SURFACE.
uint agaa_freePlace(uint limit) {
    uint place = agaa_keptCount < limit ? agaa_keptCount : AGAA_NO_SURFACE;
    for (uint i = agaa_keptCount; i > 0u; --i)
        place = agaa_coverageCount(agaa_keptAt(i - 1u).mask) == 0u ? i - 1u : place;
    return place;
}

// Inserts a fragment, which must cover a sample. It merges with a surface that rules.cosine and overlapping depths
// allow and that shares no sample with it, or takes a free place. In a full pixel, rules that count what shows merge
// the cheapest pair; the others drop the fragment with the samples that it has taken, as printed.
agaa_Insertion agaa_streamSurface(agaa_CoveredSurface s, agaa_MergeRules rules, uint samples) {
    agaa_Insertion done = agaa_noInsertion();
    const uint aligned = agaa_findAligned(s, rules);
    s.mask = agaa_takeSamples(s, samples);
    const uint taken = agaa_coverageCount(s.mask);
    if (taken == 0u)
        return done;
    agaa_removeSamples(s.mask);
    const uint place = agaa_freePlace(rules.limit);
    if (aligned != AGAA_NO_SURFACE) {
        done.hasMerged = true;
        done.to = aligned;
        const rvec2 merged = agaa_mergeInto(aligned, s, s.mask, agaa_coverageCount(agaa_keptAt(aligned).mask), taken,
                                            rules.slack);
        done.share = merged.x;
        done.shareLength = merged.y;
    } else if (place != AGAA_NO_SURFACE) {
        done.to = place;
        agaa_keep(place, s);
        agaa_keptCount = max(agaa_keptCount, place + 1u);
    } else if (agaa_countsShown(rules.rule)) {
        agaa_keep(rules.limit, s);
        done = agaa_insertInFull(rules);
    } else {
        done.isSecond = true;
        done.lost = taken;
    }
    return done;
}
#endif
