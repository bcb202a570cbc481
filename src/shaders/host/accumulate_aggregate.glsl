// Generation pass: adds a fragment's attributes to the aggregates of its visible samples, split exactly (AGAA algorithm
// 2). Sums are integers, so the order of fragments does not matter. Needs the macros of core/glsl/host_glsl.cpp.
#if !defined(AGAA_WORDS) || !defined(AGAA_STRIDE) || !defined(AGAA_REPRESENTED) || !defined(AGAA_SPREAD_WORDS) || \
    !defined(AGAA_DEPTH_WORDS)
#error "accumulate_aggregate.glsl needs AGAA_WORDS, AGAA_STRIDE, AGAA_REPRESENTED, AGAA_SPREAD_WORDS, AGAA_DEPTH_WORDS."
#endif
#include "math/depth_moments.glsl"
#include "math/normal_moments.glsl"
#include "host/visible_samples.glsl"
#if AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_BINDING_AGGREGATES) uniform uimageBuffer agaa_aggregates;
uint agaa_readWord(uint word) { return imageLoad(agaa_aggregates, int(word)).x; }
uint agaa_orWord(uint word, uint bits) { return imageAtomicOr(agaa_aggregates, int(word), bits); }
void agaa_addToWord(uint word, uint amount) { imageAtomicAdd(agaa_aggregates, int(word), amount); }
void agaa_raiseWord(uint word, uint least) { imageAtomicMax(agaa_aggregates, int(word), least); }
#else
layout(std430, AGAA_BINDING_AGGREGATES) buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;
uint agaa_readWord(uint word) { return agaa_aggregates.words[word]; }
uint agaa_orWord(uint word, uint bits) { return atomicOr(agaa_aggregates.words[word], bits); }
void agaa_addToWord(uint word, uint amount) { atomicAdd(agaa_aggregates.words[word], amount); }
void agaa_raiseWord(uint word, uint least) { atomicMax(agaa_aggregates.words[word], least); }
#endif

#if AGAA_REPRESENTED
// Returns 1 if the fragment covers the sample that represents the surface.
uint agaa_representedPart(uint mask, uint base) {
    uvec2 record = uvec2(agaa_readWord(base + AGAA_WORDS), 0u);
    if (AGAA_SAMPLES > 16)
        record.y = agaa_readWord(base + AGAA_WORDS + 1u);
    return agaa_recordSamples(record, AGAA_SAMPLES) == 0u
               ? 0u
               : mask >> agaa_recordShaded(record, AGAA_SAMPLES) & 1u;
}
#endif

#if AGAA_DEPTH_WORDS
// Adds the depths of these samples, which lie on the fragment's plane.
// at        Index of the first word of the sums.
// samples   Of the pixel.
// slope     Change of depth per texel.
void agaa_addDepths(uint at, uint samples, vec2 slope) {
    uint sums[AGAA_DEPTH_WORDS];
    for (uint m = 0u; m < AGAA_DEPTH_WORDS; ++m)
        sums[m] = 0u;
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        float depth = gl_FragCoord.z;
#if AGAA_HW_SAMPLES > 1 && !AGAA_PER_SAMPLE // otherwise it is the sample's
        depth = agaa_depthAtSample(uint(findLSB(rest)) - agaa_hostGroup() * AGAA_HW_SAMPLES, slope);
#endif
        uint code = agaa_depthCode(depth, agaa_frame.projection22, agaa_frame.projection32,
                                   agaa_frame.isOrthographic);
        for (uint m = 0u; m < AGAA_DEPTH_WORDS; ++m)
            sums[m] += agaa_depthTerm(m, code);
    }
    for (uint m = 0u; m < AGAA_DEPTH_WORDS; ++m)
        agaa_addToWord(at + m, sums[m]);
}
#endif

void agaa_emit(AgaaSurfaceInput s) {
#if AGAA_DEPTH_WORDS
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)); // derivatives need uniform control flow
#endif
    uint mask = agaa_fragmentMask(s);
    if (mask == 0u || AGAA_HELPER)
        return;
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE);
    agaa_countSurface(bad);
    agaa_Stored stored = agaa_storedInput(s);
    agaa_packSurface(stored);
    uvec2 pixel = agaa_hostPixel();
    uvec2 planes = agaa_readPlanes(pixel);
    uint base = (pixel.y * agaa_frame.size.x + pixel.x) * (AGAA_AGGREGATES * AGAA_STRIDE);
    const uint coverageShift = AGAA_FIELD_COVERAGE >> 8 & 0xFFu;
#if AGAA_FIRST_SAMPLE_ROUTING
    // Coplanar duplicates may go to different aggregates, so the coverage of one does not show that another has the
    // sample. A word for each pixel, after all aggregates, shows it.
    uint pixels = agaa_frame.size.x * agaa_frame.size.y;
    uint claim = pixels * (AGAA_AGGREGATES * AGAA_STRIDE) + pixel.y * agaa_frame.size.x + pixel.x;
    uint claimed = agaa_orWord(claim, mask) & mask;
    if (claimed != 0u)
        agaa_countFragment(AGAA_COUNT_TIES, uint(bitCount(claimed)));
    mask = agaa_freshSamples(mask, claimed);
    if (mask == 0u)
        return;
    uint first = uint(findLSB(mask));
    uint only = (planes.x >> first & 1u) | (planes.y >> first & 1u) << 1u;
#endif
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a, base += AGAA_STRIDE) {
#if AGAA_REPRESENTED
        uint part = agaa_representedPart(mask, base);
#elif AGAA_FIRST_SAMPLE_ROUTING
        uint part = a == only ? mask : 0u;
#else
        uint part = mask & agaa_samplesOfAggregate(planes, a);
#endif
        if (part == 0u)
            continue;
        // The first fragment keeps the sample: coplanar duplicates must not count twice (hard case 25).
        uint before = agaa_orWord(base + (AGAA_FIELD_COVERAGE & 0xFFu), part << coverageShift) >>
                      coverageShift;
        uint fresh = agaa_freshSamples(part, before);
        if (fresh != part)
            agaa_countFragment(AGAA_COUNT_TIES, uint(bitCount(part & before)));
        if (fresh == 0u)
            continue;
        uint count = uint(bitCount(fresh));
        // The condition contains the product, because words of a material without textures are uniform. Mesa's lavapipe
        // (22.3) copies a shader, and never frees the copy, at every draw whose uniforms decide a branch.
        for (uint w = 0u; w < AGAA_WORDS; ++w)
            if (agaa_isUnfilteredWord(w))
                agaa_raiseWord(base + w, agaa_unfilteredWord(w, count));
            else if (agaa_packed[w] * count != 0u)
                agaa_addToWord(base + w, agaa_packed[w] * count);
        for (uint m = 0u; m < AGAA_SPREAD_WORDS; ++m)
            agaa_addToWord(base + AGAA_WORDS + m, agaa_momentCode(m, stored.normal) * count);
#if AGAA_DEPTH_WORDS
        agaa_addDepths(base + AGAA_WORDS + AGAA_SPREAD_WORDS, fresh, slope);
#endif
    }
}
