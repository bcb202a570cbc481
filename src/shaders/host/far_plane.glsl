// Samples whose stored depth is that of the far plane are background in all techniques. The first pass rejects them,
// because it tests against the cleared depth. A second pass tests for equal depth and would accept them. Needs
// AGAA_FAR_DEPTH.
#ifndef AGAA_FAR_DEPTH
#error "far_plane.glsl needs AGAA_FAR_DEPTH."
#endif

// Returns whether a sample of this fragment may have the far plane's depth. Returns true for NaN.
bool agaa_mayReachFarPlane() {
    float reach = 2.0 * fwidth(gl_FragCoord.z); // samples lie within half a texel
#if AGAA_FAR_DEPTH
    return !(gl_FragCoord.z + reach < 1.0 - 2.4e-7);
#else
    return !(gl_FragCoord.z - reach > 1e-30);
#endif
}
