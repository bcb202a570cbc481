// G-buffer pass: evaluates each fragment once and writes it to all samples that it covers. Needs agaa_store(), which
// writes the channels to their attachments.

void agaa_emit(AgaaSurfaceInput s) {
    agaa_checkPlacement(s.position);
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE);
    if (!AGAA_HELPER)
        agaa_countSurface(bad);
    agaa_Stored v = agaa_storedInput(s);
    v.normal.xy = agaa_encodeOct(s.normal, agaa_fieldBits(AGAA_SOURCE_NORMAL_X));
    agaa_store(v);
#if AGAA_ALPHA_MASKED
    AGAA_KEEP_SAMPLES(agaa_alphaMask(s));
#endif
}
