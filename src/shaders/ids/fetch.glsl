// Fetches materials of primitives by id, through functions of the host. Needs common/frame.glsl, AGAA_HOST_FETCH,
// AGAA_PRIMITIVE_BITS and AGAA_CLIP_Z_FROM_MINUS_ONE.
#ifndef AGAA_FETCH_GLSL
#define AGAA_FETCH_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_HOST_FETCH)
#error "fetch.glsl needs frame.glsl and AGAA_HOST_FETCH."
#endif
#if !defined(AGAA_PRIMITIVE_BITS) || !defined(AGAA_CLIP_Z_FROM_MINUS_ONE)
#error "fetch.glsl needs AGAA_PRIMITIVE_BITS and AGAA_CLIP_Z_FROM_MINUS_ONE."
#endif
#include "math/barycentrics.glsl"
#include "math/triangle_coverage.glsl"
#include "common/host_samples.glsl"

// corners   In clip coordinates.
AgaaPrimitive agaa_primitiveAt(uint id, vec4 corners[3]) {
    AgaaPrimitive p;
    p.draw = (id - 1u) >> AGAA_PRIMITIVE_BITS;
    p.primitive = id - 1u & (1u << AGAA_PRIMITIVE_BITS) - 1u;
    p.a = corners[0];
    p.b = corners[1];
    p.c = corners[2];
    return p;
}

AgaaPrimitive agaa_primitive(uint id) {
    const vec4 unknown = vec4(0.0, 0.0, 0.0, 1.0);
    AgaaPrimitive p = agaa_primitiveAt(id, vec4[3](unknown, unknown, unknown));
    agaaHostTriangle(p.draw, p.primitive, p.a, p.b, p.c);
    return p;
}

vec3 agaa_vertexViewPosition(vec4 clip) {
#if AGAA_CLIP_Z_FROM_MINUS_ONE
    clip.z = 0.5 * (clip.z + clip.w);
#endif
    if (agaa_isOrthographic() != 0u)
        return vec3((clip.xy - agaa_frame.projectionOffset) / agaa_frame.projectionScale,
                    (clip.z - agaa_frame.projection32) / agaa_frame.projection22);
    return vec3((clip.xy + agaa_frame.projectionOffset * clip.w) / agaa_frame.projectionScale, -clip.w);
}

float agaa_largestMagnitude(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Returns the normal of the primitive's plane in view space, facing the eye. Vertices may be behind the eye.
vec3 agaa_planeNormal(AgaaPrimitive p) {
    vec3 a = agaa_vertexViewPosition(p.a);
    vec3 n = cross(agaa_vertexViewPosition(p.b) - a, agaa_vertexViewPosition(p.c) - a);
    float size = agaa_largestMagnitude(n);
    if (!agaa_isFinite3(n) || size == 0.0)
        return vec3(0.0, 0.0, 1.0);
    n = normalize(agaa_quotient3(n, size));
    float away =
        agaa_isOrthographic() != 0u ? -n.z : dot(n, agaa_quotient3(a, max(agaa_largestMagnitude(a), 1e-30)));
    return away > 0.0 ? -n : n;
}

// Returns the sine of the angle by which rounding of the vertices may turn the plane normal; 1 for a primitive without
// area.
float agaa_planeNormalError(AgaaPrimitive p) {
    vec3 a = agaa_vertexViewPosition(p.a), b = agaa_vertexViewPosition(p.b), c = agaa_vertexViewPosition(p.c);
    float longest = max(length(b - a), max(length(c - b), length(a - c)));
    float height = length(cross(b - a, c - a)) / max(longest, 1e-30);
    float rounding = 1e-6 * max(agaa_largestMagnitude(a), max(agaa_largestMagnitude(b), agaa_largestMagnitude(c)));
    return height > rounding ? rounding / height : 1.0;
}

// Returns the plane normal in shading space; the direction to the eye for a primitive without area.
vec3 agaa_facingNormal(AgaaPrimitive p, float normalError) {
    return normalError < 1.0 ? agaa_toShadingSpace(agaa_planeNormal(p))
                             : agaa_toEye(agaa_toShadingSpace(agaa_vertexViewPosition(p.a)));
}

// Evaluates the primitive's weights at an offset in the pixel, [0, 1].
void agaa_evaluateAt(inout AgaaPrimitive p, uvec2 pixel, vec2 offset) {
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size);
    vec2 ndc = (vec2(pixel) + offset) / pixelsPerNdc - 1.0;
    agaa_Barycentrics b = agaa_barycentrics(p.a.xyw, p.b.xyw, p.c.xyw, ndc, pixelsPerNdc);
    p.at = b.at;
    p.dx = b.dx;
    p.dy = b.dy;
    p.facing = b.facing;
}

#ifdef AGAA_EXPANDS_TRIANGLES
AgaaDraw agaa_drawOf(uint draw) {
    AgaaDraw d;
    d.primitives = 0u;
    d.culledFacing = 0;
    d.isAlphaMasked = false;
    agaaHostDraw(draw, d);
    return d;
}

uvec2 agaa_expandedPixel = uvec2(0u);

void agaaMoveTo(inout AgaaPrimitive p, vec2 offset) {
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size);
    agaa_Barycentrics b = agaa_barycentrics(agaa_vertexInPixels(p.a.xyw, pixelsPerNdc),
                                            agaa_vertexInPixels(p.b.xyw, pixelsPerNdc),
                                            agaa_vertexInPixels(p.c.xyw, pixelsPerNdc),
                                            vec2(agaa_expandedPixel) + 0.5 + offset, vec2(1.0));
    p.at = b.at;
    p.dx = b.dx;
    p.dy = b.dy;
    p.facing = b.facing;
}
#endif

AgaaMaterial agaa_evaluateMaterial(AgaaPrimitive p) {
    AgaaMaterial m = agaa_defaultMaterial();
    agaaHostMaterial(p, m);
    agaa_count(AGAA_COUNT_MATERIALS, 1u);
    agaa_count(AGAA_COUNT_SANITISED, agaa_sanitiseValues(m));
    if (agaa_hasFact(AGAA_FACT_PLANE_NORMALS) || AGAA_CHECK_FACTS != 0u) {
        float normalError = agaa_planeNormalError(p);
        agaa_applyFacts(m, agaa_facingNormal(p, normalError), normalError < 0.005);
    } else {
        agaa_applyFacts(m, m.normal, false);
    }
    agaa_countFacts();
    return m;
}

// Returns whether each texel of the target has separate materials (AGAA_CONFIG_FINE_MATERIALS).
bool agaa_hasFineMaterials() { return AGAA_FINE_MATERIALS != 0u; }

// Returns the samples of a pixel that share a primitive's material with this one.
uint agaa_materialGroup(uint i) {
    if (!agaa_hasFineMaterials() || AGAA_MATERIAL_SAMPLES >= 32u)
        return 0xFFFFFFFFu;
    return (1u << AGAA_MATERIAL_SAMPLES) - 1u << i / AGAA_MATERIAL_SAMPLES * AGAA_MATERIAL_SAMPLES;
}

// Returns the samples of a texel that the primitive covers, without regard to nearer surfaces and masks.
// known   A sample at which the weights of p were evaluated.
uint agaa_coveredOfTexel(AgaaPrimitive p, uint group, uint known) {
    uint covered = 1u << known;
    for (uint i = group * AGAA_MATERIAL_SAMPLES; i < (group + 1u) * AGAA_MATERIAL_SAMPLES; ++i) {
        vec2 away = agaa_sampleLocation(i) - agaa_sampleLocation(known);
        vec3 at = p.at + p.dx * away.x + p.dy * away.y;
        covered |= min(at.x, min(at.y, at.z)) > 0.0 ? 1u << i : 0u;
    }
    return covered;
}

// Returns a texel's material at the position of a G-buffer's fragment (AGAA_INSIDE): the centre or, if the primitive
// does not cover all samples, the first sample that it covers. It has one normal.
AgaaMaterial agaa_fetchFineMaterial(AgaaPrimitive p, uvec2 pixel, uint samples) {
    uint first = uint(findLSB(samples));
    uint group = first / AGAA_MATERIAL_SAMPLES;
    uint covered = samples;
    if (uint(bitCount(samples)) < AGAA_MATERIAL_SAMPLES) {
        agaa_evaluateAt(p, pixel, agaa_sampleLocation(first));
        covered = agaa_coveredOfTexel(p, group, first);
    }
    vec2 centre = (vec2(group % AGAA_SCALE_X, group / AGAA_SCALE_X) + 0.5) / vec2(AGAA_SCALE_X, AGAA_SCALE_Y);
    if (AGAA_LAYERS > 1u)
        centre = agaa_layerCentre(vec2(uintBitsToFloat(AGAA_LAYER_X), uintBitsToFloat(AGAA_LAYER_Y)), first);
    bool isWhole = uint(bitCount(covered)) == AGAA_MATERIAL_SAMPLES;
    agaa_evaluateAt(p, pixel, isWhole ? centre : agaa_sampleLocation(findLSB(covered)));
    AgaaMaterial m = agaa_evaluateMaterial(p);
    m.normalDx = m.normalDy = vec3(0.0);
    return m;
}

// Returns the material of these samples, one or more, at their centroid. Its normal is that at the pixel's corner, not
// unit.
AgaaMaterial agaa_fetchMaterial(AgaaPrimitive p, uvec2 pixel, uint samples) {
    if (agaa_hasFineMaterials())
        return agaa_fetchFineMaterial(p, pixel, samples);
    vec2 middle = vec2(0.0);
    uint i = 0u;
    do {
        if ((samples >> i & 1u) != 0u)
            middle += agaa_sampleLocation(i);
    } while (++i < agaa_sampleCount());
    middle /= float(bitCount(samples));
    agaa_evaluateAt(p, pixel, middle);
    AgaaMaterial m = agaa_evaluateMaterial(p);
    m.normal -= middle.x * m.normalDx + middle.y * m.normalDy;
    return m;
}

bool agaa_isCurvedMaterial(AgaaMaterial m) { return m.normalDx != vec3(0.0) || m.normalDy != vec3(0.0); }

// Returns the normal at sample i.
vec3 agaa_materialNormal(AgaaMaterial m, uint i) {
    vec2 at = agaa_sampleLocation(i);
    vec3 n = m.normal + at.x * m.normalDx + at.y * m.normalDy;
    return n * inversesqrt(max(dot(n, n), 1e-6));
}

// Returns the surface without what the view leaves out, which ambient light would reach otherwise. The normal of a
// curved material is not that of the surface.
agaa_Surface agaa_surfaceOfMaterial(AgaaMaterial m) {
    const bool hasSpecular = AGAA_HAS_SPECULAR != 0u;
    const bool isEmissive = AGAA_EMISSIVE_CHANNELS != 0u;
    return agaa_Surface(m.diffuse, hasSpecular ? m.specular : vec3(0.0), isEmissive ? m.emissive : vec3(0.0), m.normal,
                        1.0, hasSpecular ? m.alpha2 : 1.0, 0.0, vec3(0.0));
}
#endif
