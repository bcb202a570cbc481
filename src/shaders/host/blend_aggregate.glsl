// Generation pass: adds a fragment's attributes, weighted by its share of the pixel's samples, to one colour sample of
// the attachments by additive blending (AGAA algorithm 2). The attachments have a colour sample for each aggregate. All
// samples of a fragment go to the aggregate of the first one, because all colour samples receive the same values. Needs
// AGAA_ROUTES and agaa_blend(), which core/glsl/host_glsl.cpp writes.
#ifndef AGAA_ROUTES
#error "blend_aggregate.glsl needs AGAA_ROUTES."
#endif
layout(override_coverage) out int gl_SampleMask[];

// Returns the aggregate of a sample.
uint agaa_aggregateOf(uint i) {
    uvec2 planes = agaa_readPlanes(agaa_hostPixel());
    return (planes.x >> i & 1u) | (planes.y >> i & 1u) << 1u;
}

void agaa_emit(AgaaSurfaceInput s) {
    uint mask = agaa_fragmentMask(s);
    gl_SampleMask[0] = 0; // without visible samples nothing is blended
    if (mask == 0u || AGAA_HELPER)
        return;
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE);
    agaa_countSurface(bad);
    gl_SampleMask[0] = int(AGAA_ROUTES[agaa_aggregateOf(uint(findLSB(mask)))]);
    agaa_blend(agaa_aggregateInput(agaa_storedInput(s)), uint(bitCount(mask)), mask);
}
