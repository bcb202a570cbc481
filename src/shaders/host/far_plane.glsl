// Samples whose stored depth is that of the far plane are background in all techniques: the first pass, which tests
// against the depth that was cleared, refuses them. A second pass tests for equal depth and would let them through.

// Whether a sample of this fragment may have the far plane's depth. True where depth is no number.
bool agaa_mayReachFarPlane() {
    float reach = 2.0 * fwidth(gl_FragCoord.z); // samples lie within half a texel
#if AGAA_FAR_DEPTH
    return !(gl_FragCoord.z + reach < 1.0 - 2.4e-7);
#else
    return !(gl_FragCoord.z - reach > 1e-30);
#endif
}
