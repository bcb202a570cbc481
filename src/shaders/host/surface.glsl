// The interface of draw passes to the host's fragment shader. Needs common/frame.glsl and the macros of
// core/glsl/host_glsl.cpp.
#if !defined(AGAA_HW_SAMPLES) || !defined(AGAA_HAS_CORNERS) || !defined(AGAA_FIRST_PASS) || !defined(AGAA_CHECK_FACTS)
#error "surface.glsl needs AGAA_HW_SAMPLES, AGAA_HAS_CORNERS, AGAA_FIRST_PASS and AGAA_CHECK_FACTS."
#endif
#include "common/camera.glsl"

// The surface that a host's fragment shader passes to the SDK. Positions and normals are in shading space (the host's
// axes, origin at the eye), colours are linear, alpha2 is GGX alpha squared.
struct AgaaSurfaceInput {
    vec3 position;        // of the fragment
    // normal of the primitive's plane, on either side. Read in the visibility pass, and in all passes with
    // AGAA_FACT_PLANE_NORMALS or AGAA_CONFIG_CHECK_FACTS
    vec3 geometricNormal;
    // read if AGAA_ALPHA_MASKED is 1. It must be equal in all passes: declare it precise and evaluate it at
    // AGAA_AT_CENTRE, because AGAA_INSIDE depends on the samples that survive. A non-finite alpha or cutoff counts as 0
    float alpha;
    float alphaCutoff;    // > 0: a cut-out, which covers the samples with alpha >= alphaCutoff.
                          // <= 0: a translucent surface, which covers the share alpha of the samples, [0, 1]. A cut-out
                          // at 0 covers all samples and is not alpha-masked
    bool hasAlphaNear;    // cut-outs: alphaNear is set; alpha is then read at n = 1 only
    vec4 alphaNear;       // alpha at agaa_alphaPoint(0) to (3), by the same rules as alpha
#if AGAA_HAS_CORNERS
    bool hasAlphaRows;    // cut-outs, if AGAA_HAS_CORNERS is 1: alphaRows is set in place of alphaNear
    vec4 alphaRows[4];    // alpha at agaa_alphaRowPoint(r, c) in row r, column c
#endif
    // translucent surfaces: differs between primitives that may overlap, and is equal in all passes
    uint primitiveSeed;
    uint draw;            // visibility pass, if AGAA_WRITES_IDS is 1: the draw that AgaaFetchFunction receives
    uint primitive;       // index in the draw, as gl_PrimitiveID
    vec3 diffuse;         // [0,1]
    vec3 specular;        // reflectance at normal incidence, [0,1]
    vec3 emissive;        // radiance, [0,range of the layout]; brighter values are scaled to the range, in the same hue
    vec3 normal;          // shading normal, unit
    float alpha2;         // [4.1e-6,1]
#if AGAA_HAS_CORNERS
    // if AGAA_HAS_CORNERS is 1: derivatives of `normal` by the image's x and y, as in AgaaMaterial
    vec3 normalDx, normalDy;
#endif
    AGAA_CUSTOM_MEMBERS   // custom attributes of the layout (AGAA_SEMANTIC_CUSTOM), in their range
};

const uint AGAA_UNFETCHED = 0xFFFFFFFFu; // AgaaSurfaceInput::draw of unfetched draws (AGAA_FETCH_NOT_ALL_DRAWS)

AgaaSurfaceInput agaa_surfaceInput() {
    AgaaSurfaceInput s;
    s.position = vec3(0.0, 0.0, -1.0);
    s.geometricNormal = vec3(0.0, 0.0, 1.0);
    s.alpha = 1.0;
    s.alphaCutoff = 0.0;
    s.hasAlphaNear = false;
    s.alphaNear = vec4(1.0);
#if AGAA_HAS_CORNERS
    s.hasAlphaRows = false;
    for (int r = 0; r < 4; ++r)
        s.alphaRows[r] = vec4(1.0);
#endif
    s.primitiveSeed = 0u;
    s.draw = 0u;
    s.primitive = 0u;
    s.diffuse = vec3(0.5);
    s.specular = vec3(0.04);
    s.emissive = vec3(0.0);
    s.normal = vec3(0.0, 0.0, 1.0);
    s.alpha2 = 1.0;
#if AGAA_HAS_CORNERS
    s.normalDx = s.normalDy = vec3(0.0);
#endif
    AGAA_CLEAR_CUSTOM(s)
    return s;
}

// Returns the value of a fragment input inside its primitive. The centre of a pixel may be outside a triangle thinner
// than a pixel, where attributes extrapolate without bound. Mesa 22.3 divides by the centre's 1/w here and changes
// plain reads of the same input: if such drivers matter, interpolate a constant 1 too and divide by it, and take
// derivatives of a separate input.
#if AGAA_FIRST_PASS && AGAA_HW_SAMPLES > 1
// The first pass tests depth against earlier draws. Mesa 22.3 takes the centroid of the samples that pass, so values
// would depend on the order of draws. gl_SampleMaskIn has the samples that the primitive covers.
bool agaa_isCentreInside() {
    uint mask = uint(gl_SampleMaskIn[0]);
    return mask == 0u || mask == 0xFFFFFFFFu >> (32u - AGAA_HW_SAMPLES); // 0: a helper invocation
}
int agaa_firstSampleInside() { return max(findLSB(uint(gl_SampleMaskIn[0])), 0); }
#define AGAA_INSIDE(v) \
    (agaa_isCentreInside() ? interpolateAtOffset(v, vec2(0.0)) : interpolateAtSample(v, agaa_firstSampleInside()))
#else
#define AGAA_INSIDE(v) interpolateAtCentroid(v)
#endif

// Returns the value of a fragment input at the centre of its texel. If a pass runs once per sample, OpenGL evaluates
// plain inputs at the sample.
#if defined(AGAA_PER_SAMPLE) && AGAA_PER_SAMPLE
#define AGAA_AT_CENTRE(v) interpolateAtOffset(v, vec2(0.0))
#else
#define AGAA_AT_CENTRE(v) (v)
#endif

// Derivatives per pixel, independent of the target's scale. Take them of plain inputs, so that they are those at the
// centre.
#define AGAA_DERIVATIVES(T) \
    T agaa_dFdx(T v) { return dFdx(v) * float(AGAA_SCALE_X); } \
    T agaa_dFdy(T v) { return dFdy(v) * float(AGAA_SCALE_Y); }
AGAA_DERIVATIVES(float)
AGAA_DERIVATIVES(vec2)
AGAA_DERIVATIVES(vec3)

// Returns the normal of the plane of the fragment's position input.
vec3 agaa_planeNormal(vec3 position) {
    vec3 n = cross(dFdx(position), dFdy(position));
    float l2 = dot(n, n);
    return l2 > 0.0 ? n * inversesqrt(l2) : vec3(0.0);
}

// Returns the layer of the target that the fragment lies in.
uint agaa_hostLayer() { return AGAA_LAYERS > 1u ? uint(gl_FragCoord.y) / agaa_frame.size.y : 0u; }
uvec2 agaa_hostPixel() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    if (AGAA_LAYERS > 1u)
        texel.y -= agaa_hostLayer() * agaa_frame.size.y;
    return texel / uvec2(AGAA_SCALE_X, AGAA_SCALE_Y);
}
uint agaa_hostGroup() {
    uvec2 sub = uvec2(gl_FragCoord.xy) % uvec2(AGAA_SCALE_X, AGAA_SCALE_Y);
    return AGAA_LAYERS > 1u ? agaa_hostLayer() : sub.y * AGAA_SCALE_X + sub.x;
}

vec2 agaa_hostLayerCentre() {
    return agaa_layerCentre(vec2(uintBitsToFloat(AGAA_LAYER_X), uintBitsToFloat(AGAA_LAYER_Y)),
                            agaa_hostLayer() * AGAA_HW_SAMPLES);
}

// Returns the point of the image that a point of the target shows, in texels.
vec2 agaa_shownPoint(vec2 at) {
    if (AGAA_LAYERS > 1u)
        at += agaa_hostLayerCentre() - 0.5 - vec2(0.0, float(agaa_hostLayer() * agaa_frame.size.y));
    return at;
}

#include "common/alpha_points.glsl"
#define AGAA_ALPHA_POINTS (AGAA_HW_SAMPLES > 1 || AGAA_HAS_CORNERS == 1 ? 4u : 0u)

// Returns the offset from the texel's centre to its sample i, in texels.
vec2 agaa_sampleOffset(uint i) {
    uvec2 texel = uvec2(gl_FragCoord.xy) % uvec2(AGAA_SCALE_X, AGAA_SCALE_Y);
#ifdef AGAA_OWN_SAMPLE_POSITIONS // the samples of this pass are not those of the view
    const vec2 positions[AGAA_HW_SAMPLES] = vec2[](AGAA_OWN_SAMPLE_POSITIONS);
    vec2 position = positions[i];
#else
    vec2 position = agaa_sampleLocation(agaa_hostGroup() * AGAA_HW_SAMPLES + i);
#endif
    if (AGAA_LAYERS > 1u)
        return position - agaa_hostLayerCentre();
    return position * vec2(AGAA_SCALE_X, AGAA_SCALE_Y) - vec2(texel) - 0.5;
}

// Returns the depth of the fragment's plane at a sample of its texel.
// slope   Change of depth per texel.
float agaa_depthAtSample(uint i, vec2 slope) {
    return clamp(gl_FragCoord.z + dot(slope, agaa_sampleOffset(i)), 0.0, 1.0);
}

// Gradient of each pixel, where a driver would otherwise use one per quad.
#if __VERSION__ >= 450
#define AGAA_FINE_GRADIENT(v) vec2(dFdxFine(v), dFdyFine(v))
#else
#define AGAA_FINE_GRADIENT(v) vec2(dFdx(v), dFdy(v))
#endif

// Returns the samples of this texel that a cut-out covers. gradient: change of alpha per texel.
uint agaa_cutoutMask(AgaaSurfaceInput s, float alpha, vec2 gradient) {
    bool isBilinear = s.hasAlphaNear && AGAA_HW_SAMPLES > 1;
    vec4 near = vec4(agaa_sanitiseAlpha(s.alphaNear.x), agaa_sanitiseAlpha(s.alphaNear.y),
                     agaa_sanitiseAlpha(s.alphaNear.z), agaa_sanitiseAlpha(s.alphaNear.w));
    uint mask = 0u;
    for (uint i = 0u; i < AGAA_HW_SAMPLES; ++i) {
        vec2 offset = agaa_sampleOffset(i);
        bool isIn = isBilinear ? agaa_isInCutout4(near, s.alphaCutoff, offset)
                               : agaa_isInCutout(alpha, s.alphaCutoff, gradient, offset);
        mask |= isIn ? 1u << i : 0u;
    }
    return mask;
}

// The cutoff is usually a uniform. Mesa's lavapipe (22.3) copies a shader, and never frees the copy, at every draw
// whose uniforms decide a branch. A term that is 0 but depends on the fragment prevents that.
float agaa_fragmentCutoff(AgaaSurfaceInput s) {
    return agaa_sanitiseAlpha(s.alphaCutoff + min(gl_FragCoord.x, 0.0));
}

// Returns the samples of this texel that an alpha-masked surface covers. It takes derivatives, so it needs uniform
// control flow.
uint agaa_alphaMask(AgaaSurfaceInput s) {
    float alpha = agaa_sanitiseAlpha(s.alpha);
    vec2 gradient = AGAA_FINE_GRADIENT(alpha);
    s.alphaCutoff = agaa_fragmentCutoff(s);
    if (agaa_isCutout(s.alphaCutoff))
        return agaa_cutoutMask(s, alpha, gradient);
    uvec2 pixel = agaa_hostPixel();
    return agaa_translucentMask(alpha, AGAA_HW_SAMPLES, agaa_hostGroup(), AGAA_SCALE_X * AGAA_SCALE_Y * AGAA_LAYERS,
                                agaa_translucencyHash(pixel.x, pixel.y, s.primitiveSeed, agaa_frame.ditherFrame));
}

// Reduces a fragment to these samples. OpenGL ignores the sample mask of targets with one sample.
#if AGAA_HW_SAMPLES == 1
#define AGAA_KEEP_SAMPLES(mask) if ((mask) == 0u) discard
#else
#define AGAA_KEEP_SAMPLES(mask) gl_SampleMask[0] = int(mask)
#endif

uint agaa_demands = 0u; // of the current surface, by agaa_applyFacts()

uint agaa_demandsOfMask(AgaaSurfaceInput s) {
#if AGAA_ALPHA_MASKED
    bool isCutout = agaa_sanitiseAlpha(s.alphaCutoff) > 0.0;
    return AGAA_FACT_ALPHA_MASKED | (isCutout ? AGAA_FACT_NO_CUTOUTS : AGAA_FACT_NO_TRANSLUCENCY);
#else
    return 0u;
#endif
}

// Returns the plane normal of the primitive, facing the eye; the direction to the eye for a primitive without a plane.
vec3 agaa_facingNormal(AgaaSurfaceInput s) {
    vec3 toEye = agaa_toEye(s.position);
    if (!agaa_hasDirection(s.geometricNormal))
        return toEye;
    vec3 n = normalize(agaa_directionOrZ(s.geometricNormal));
    return dot(n, toEye) < 0.0 ? -n : n;
}

// Replaces the values that the facts of the scene fix.
void agaa_applyFacts(inout AgaaSurfaceInput s, float emissiveRange) {
#if AGAA_CHECK_FACTS
    agaa_demands = agaa_demandsOf(s.diffuse, s.specular, s.emissive, s.alpha2, emissiveRange) | agaa_demandsOfMask(s) |
                   agaa_demandOfNormal(s.normal, agaa_facingNormal(s));
#endif
    s.normal = agaa_factNormal(s.normal, agaa_facingNormal(s));
#if AGAA_HAS_CORNERS
    if (agaa_hasFact(AGAA_FACT_PLANE_NORMALS))
        s.normalDx = s.normalDy = vec3(0.0);
#endif
#if AGAA_SHOWS_FACTS
    s.diffuse = vec3(agaa_unmetDemands(agaa_demands) != 0u ? 1.0 : 0.0);
#else
    s.diffuse = agaa_factDiffuse(s.diffuse);
#endif
    s.specular = agaa_factSpecular3(s.specular);
    s.alpha2 = agaa_factAlpha2(s.alpha2);
}

// Clamps values to the ranges of the layout and replaces non-finite ones (hard case 37). Returns 1 if there was one.
uint agaa_sanitiseSurface(inout AgaaSurfaceInput s, float emissiveRange) {
    uint bad = 0u;
    s.diffuse = agaa_sanitise3(s.diffuse, 0.0, 1.0, bad);
    s.specular = agaa_sanitise3(s.specular, 0.0, 1.0, bad);
    s.emissive = agaa_sanitiseEmission(s.emissive, emissiveRange, bad);
    s.alpha2 = agaa_sanitise(s.alpha2, agaa_minAlpha2(), 1.0, bad);
    s.normal = agaa_sanitiseNormal(s.normal, bad);
    AGAA_SANITISE_CUSTOM(s, bad)
    agaa_applyFacts(s, emissiveRange);
    return bad;
}

agaa_Stored agaa_storedInput(AgaaSurfaceInput s) {
    vec3 emissive = s.emissive / AGAA_EMISSIVE_RANGE;
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        emissive.x = agaa_emissiveFactor(s.diffuse, emissive);
    agaa_Stored v = agaa_storedSurface(s.diffuse, s.specular, s.normal, s.alpha2, emissive);
    AGAA_STORE_CUSTOM(s, v)
    return v;
}
