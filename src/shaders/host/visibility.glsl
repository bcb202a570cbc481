// Visibility pass: writes depth and a value that distinguishes samples. That value is an id, or the primitive's normal
// in the frame of the pixel's view ray, in which visible surfaces face the viewer at any field of view. With
// AGAA_WRITES_CLASSES, the class of the material is beside the normal. Needs
// AGAA_WRITES_NORMALS, AGAA_WRITES_IDS and AGAA_WRITES_CLASSES.
#if !defined(AGAA_WRITES_NORMALS) || !defined(AGAA_WRITES_IDS) || !defined(AGAA_WRITES_CLASSES)
#error "visibility.glsl needs AGAA_WRITES_NORMALS, AGAA_WRITES_IDS and AGAA_WRITES_CLASSES."
#endif
void agaa_emit(AgaaSurfaceInput s) {
    agaa_checkPlacement(s.position);
#if AGAA_WRITES_NORMALS
    vec2 centre = (vec2(agaa_hostPixel()) + 0.5) / vec2(agaa_frame.size) * 2.0 - 1.0;
    vec3 ray = agaa_viewPosition(centre, -1.0, agaa_frame.projectionScale.x, agaa_frame.projectionScale.y,
                                 agaa_frame.projectionOffset.x, agaa_frame.projectionOffset.y,
                                 agaa_frame.isOrthographic);
    vec3 v = agaa_frame.isOrthographic != 0u ? vec3(0.0, 0.0, 1.0) : normalize(-ray);
    vec3 t, b;
    agaa_viewBasis(v, t, b);
    vec3 n = mat3(agaa_frame.view) * s.geometricNormal;
    n = vec3(dot(n, t), dot(n, b), dot(n, v));
    if (n.z < 0.0)
        n = -n;
    float class_ = 0.0;
#if AGAA_WRITES_CLASSES
    agaa_Stored stored = agaa_storedSurface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
    AGAA_STORE_CUSTOM(s, stored)
    uint code = agaa_quantise(stored.custom[AGAA_CLASS_CHANNEL - 1u], 8u); // contains values that are not finite
    class_ = agaa_unormOfCode(vec2(float(code)), 8u).x;
#endif
    agaa_out0 = vec4(agaa_unormOfCode(vec2(agaa_encodeHemiOct8(n)), 8u), class_, 0.0);
#endif
#if AGAA_WRITES_IDS
    if (!AGAA_HELPER)
        agaa_countMask(s);
    uint id = agaa_idOfInput(s);
    uvec4 bytes = uvec4(id, id >> 8u, id >> 16u, id >> 24u) & 255u;
    agaa_out0 = vec4(agaa_unormOfCode(vec2(bytes.xy), 8u), agaa_unormOfCode(vec2(bytes.zw), 8u));
#endif
#if AGAA_ALPHA_MASKED
    AGAA_KEEP_SAMPLES(agaa_alphaMask(s));
#endif
}
