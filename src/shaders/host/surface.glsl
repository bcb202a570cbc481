// What a host's fragment shader fills and hands over. Positions and normals are in shading space (the
// host's axes, origin at the eye), colours linear, alpha2 is GGX alpha squared.
struct AgaaSurfaceInput {
    vec3 position;        // of the fragment
    vec3 geometricNormal; // of the primitive's plane; either side
    float alpha;          // coverage in [0,1]; used where AGAA_ALPHA_MASKED is 1. Must be equal in
                          // every pass: precise, and taken at AGAA_AT_CENTRE, since AGAA_INSIDE
                          // depends on which samples survive
    uint primitiveSeed;   // differs between primitives that may overlap; the same in every pass
    uint draw;            // of the visibility pass where AGAA_WRITES_IDS is 1: what AgaaFetchFunction is asked for
    uint primitive;       // of the draw, as gl_PrimitiveID counts
    vec3 diffuse;         // [0,1]
    vec3 specular;        // reflectance at normal incidence, [0,1]
    vec3 emissive;        // radiance, [0,range of the layout]
    vec3 normal;          // shading normal, unit
    float alpha2;         // [4.1e-6,1]
};

const uint AGAA_UNFETCHED = 0xFFFFFFFFu; // AgaaSurfaceInput::draw of what AGAA_FETCH_NOT_ALL_DRAWS says

AgaaSurfaceInput agaa_surfaceInput() {
    AgaaSurfaceInput s;
    s.position = vec3(0.0, 0.0, -1.0);
    s.geometricNormal = vec3(0.0, 0.0, 1.0);
    s.alpha = 1.0;
    s.primitiveSeed = 0u;
    s.draw = 0u;
    s.primitive = 0u;
    s.diffuse = vec3(0.5);
    s.specular = vec3(0.04);
    s.emissive = vec3(0.0);
    s.normal = vec3(0.0, 0.0, 1.0);
    s.alpha2 = 1.0;
    return s;
}

// The value of a fragment input inside its primitive: on a triangle thinner than a pixel the centre lies
// outside and attributes extrapolate without bound. Mesa 22.3 divides by the centre's 1/w here and
// displaces plain reads of the same input: pass a constant 1 along, divide by it, and take derivatives
// of an input of their own where such drivers matter.
#define AGAA_INSIDE(v) interpolateAtCentroid(v)

// The value of a fragment input at the centre of its texel. Where a pass runs once per sample, OpenGL evaluates
// plain inputs at the sample.
#if defined(AGAA_PER_SAMPLE) && AGAA_PER_SAMPLE
#define AGAA_AT_CENTRE(v) interpolateAtOffset(v, vec2(0.0))
#else
#define AGAA_AT_CENTRE(v) (v)
#endif

// Derivatives per pixel, whatever the target's scale; of plain inputs, so that they belong to the centre.
#define AGAA_DERIVATIVES(T) \
    T agaa_dFdx(T v) { return dFdx(v) * float(AGAA_SCALE_X); } \
    T agaa_dFdy(T v) { return dFdy(v) * float(AGAA_SCALE_Y); }
AGAA_DERIVATIVES(float)
AGAA_DERIVATIVES(vec2)
AGAA_DERIVATIVES(vec3)

// Normal of the plane that the fragment's position input moves on.
vec3 agaa_planeNormal(vec3 position) {
    vec3 n = cross(dFdx(position), dFdy(position));
    float l2 = dot(n, n);
    return l2 > 0.0 ? n * inversesqrt(l2) : vec3(0.0);
}

// Alpha tested at a cutoff as coverage: a ramp one pixel wide around the contour. Passes are programs of their own,
// which compilers may evaluate differently but for what is precise.
float agaa_sharpenAlpha(float alpha, float cutoff) {
    precise float width = max(abs(agaa_dFdx(alpha)) + abs(agaa_dFdy(alpha)), 1e-4);
    precise float coverage = (alpha - cutoff) / width + 0.5;
    return clamp(coverage, 0.0, 1.0);
}

uint agaa_hash(uint x) { // PCG output permutation
    x = x * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28u) + 4u)) ^ x) * 277803737u;
    return (x >> 22u) ^ x;
}

uvec2 agaa_hostPixel() { return uvec2(gl_FragCoord.xy) / uvec2(AGAA_SCALE_X, AGAA_SCALE_Y); }
uint agaa_hostGroup() {
    uvec2 sub = uvec2(gl_FragCoord.xy) % uvec2(AGAA_SCALE_X, AGAA_SCALE_Y);
    return sub.y * AGAA_SCALE_X + sub.x;
}

// Samples of this texel that a surface of this alpha covers. One number a pixel and primitive is spread
// over the pixel's texels and samples, so that their sum is alpha n rounded up or down, without bias;
// which samples they are differs from primitive to primitive (hard case 53).
uint agaa_alphaMask(float alpha, uint primitiveSeed) {
    const uint all = 0xFFFFFFFFu >> (32u - AGAA_HW_SAMPLES);
    alpha = clamp(alpha, 0.0, 1.0);
    if (alpha >= 1.0)
        return all;
    uvec2 pixel = agaa_hostPixel();
    uint h = agaa_hash(pixel.x + agaa_hash(pixel.y + agaa_hash(primitiveSeed)));
    const uint groups = AGAA_SCALE_X * AGAA_SCALE_Y;
    uint group = (agaa_hostGroup() + (h >> 8u)) % groups;
    float u = (float(group) + float(h & 0xFFu) / 256.0) / float(groups);
    precise float samples = alpha * float(AGAA_HW_SAMPLES) + u;
    uint count = min(uint(samples), AGAA_HW_SAMPLES);
    uint start = (h >> 16u) + agaa_hostGroup() * 3u;
    uint mask = 0u;
    for (uint i = 0u; i < count; ++i)
        mask |= 1u << ((start + i) % AGAA_HW_SAMPLES);
    return mask;
}

// Leaves a fragment these samples. OpenGL ignores the sample mask of targets with one sample.
#if AGAA_HW_SAMPLES == 1
#define AGAA_KEEP_SAMPLES(mask) if ((mask) == 0u) discard
#else
#define AGAA_KEEP_SAMPLES(mask) gl_SampleMask[0] = int(mask)
#endif

// Clamps to what a layout can hold; a non-finite value becomes 0 and is counted (hard case 37).
uint agaa_sanitiseSurface(inout AgaaSurfaceInput s, float emissiveRange) {
    uint bad = 0u;
    s.diffuse = agaa_sanitise3(s.diffuse, 0.0, 1.0, bad);
    s.specular = agaa_sanitise3(s.specular, 0.0, 1.0, bad);
    s.emissive = agaa_sanitise3(s.emissive, 0.0, emissiveRange, bad);
    s.alpha2 = agaa_sanitise(s.alpha2, agaa_minAlpha2(), 1.0, bad);
    s.normal = agaa_sanitiseNormal(s.normal, bad);
    return bad;
}

float agaa_scalarEmissive(AgaaSurfaceInput s) {
    return agaa_emissiveFactor(s.diffuse, s.emissive / AGAA_EMISSIVE_RANGE);
}
