// G-buffer pass: one evaluation per fragment, written to every sample it covers. The declarations before
// this define agaa_out0… and agaa_store(), which puts channel values in their attachments.

void agaa_emit(AgaaSurfaceInput s) {
    agaa_checkPlacement(s.position);
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE);
    if (bad != 0u && !AGAA_HELPER)
        agaa_countFragment(AGAA_COUNT_SANITISED, 1u);
    float c[13];
    c[0] = s.diffuse.x;
    c[1] = s.diffuse.y;
    c[2] = s.diffuse.z;
    c[3] = s.specular.x;
    c[4] = s.specular.y;
    c[5] = s.specular.z;
    vec2 code = agaa_encodeOct(s.normal, AGAA_SOURCE_NORMAL_X >> 16);
    c[6] = code.x;
    c[7] = code.y;
    c[8] = 0.0;
    c[9] = s.alpha2;
    vec3 e = s.emissive / AGAA_EMISSIVE_RANGE;
    c[10] = AGAA_EMISSIVE_CHANNELS == 1u ? agaa_scalarEmissive(s) : e.x;
    c[11] = e.y;
    c[12] = e.z;
    agaa_store(c);
#if AGAA_ALPHA_MASKED
    AGAA_KEEP_SAMPLES(agaa_alphaMask(s));
#endif
}
