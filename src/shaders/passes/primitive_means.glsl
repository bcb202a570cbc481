// Means over samples of primitives, each of one material for all its samples of a pixel.
#ifndef AGAA_PRIMITIVE_MEANS_GLSL
#define AGAA_PRIMITIVE_MEANS_GLSL
#include "passes/aggregate.glsl"
#include "passes/fetch.glsl"
#include "passes/sample_ids.glsl"
#include "passes/pixel_work.glsl"

float agaa_weightOf(uint i, bool isLit) {
#if AGAA_LIT
    if (isLit)
        return agaa_sampleLight[i];
#endif
    return 1.0;
}

// Sums of places in the pixel and of their products, over samples of the weight scale * agaa_weightOf().
struct agaa_Places {
    float weight;
    vec2 sum;
    vec3 products; // xx, yy, xy
};

agaa_Places agaa_placesOf(uint samples, float scale, bool isLit) {
    agaa_Places p = agaa_Places(0.0, vec2(0.0), vec3(0.0));
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float weight = scale * agaa_weightOf(i, isLit);
        vec2 place = agaa_sampleLocation(i);
        p.weight += weight;
        p.sum += weight * place;
        p.products += weight * vec3(place * place, place.x * place.y);
    }
    return p;
}

// Normals of a primitive that grow evenly across the pixel: as one in their middle, with the spread around it.
void agaa_addCurved(inout agaa_Means m, AgaaMaterial material, agaa_Places places) {
    vec2 middle = places.sum / places.weight;
    vec3 n = material.normal + middle.x * material.normalDx + middle.y * material.normalDy;
    float scale = inversesqrt(max(dot(n, n), 1e-6));
    n *= scale;
    vec3 u = scale * material.normalDx;
    vec3 v = scale * material.normalDy;
    vec3 spread = places.products / places.weight - vec3(middle * middle, middle.x * middle.y);
    spread.xy = max(spread.xy, vec2(0.0));
    vec3 squares = spread.x * u * u + spread.y * v * v + 2.0 * spread.z * u * v;
    float total = 1.0 + max(squares.x + squares.y + squares.z, 0.0);
    m.normal += places.weight * inversesqrt(total) * n;
    if (AGAA_HAS_SPECULAR != 0u && AGAA_NDF >= agaa_ndfLean) {
        float share = places.weight / total;
        agaa_addNormalMoments(m.moments, share, n);
        m.moments.squares += share * squares;
        m.moments.mixed += share * (spread.x * u.yzx * u.zxy + spread.y * v.yzx * v.zxy +
                                    spread.z * (u.yzx * v.zxy + u.zxy * v.yzx));
    }
}

// Adds these samples of a primitive.
void agaa_addPrimitive(inout agaa_Means m, AgaaMaterial material, uint samples, float scale, bool isLit) {
    bool isCurved = agaa_isCurvedMaterial(material);
    agaa_Places places = agaa_placesOf(isCurved || isLit ? samples : 0u, scale, isLit);
    float weight = isCurved || isLit ? places.weight : scale * float(bitCount(samples));
    agaa_Surface s = agaa_surfaceOfMaterial(material);
    agaa_addMaterial(m, weight, s);
    if (!isCurved)
        agaa_addNormal(m, weight, s.normal);
    else if (weight > 0.0)
        agaa_addCurved(m, material, places);
}

// count: of the pixel's aggregates; uncovered: samples beside the covered ones that no pass gave a material.
agaa_PixelWork agaa_countedWork(uvec2 pixel, uint count, uint covered, uint uncovered) {
    uint samples = uint(bitCount(covered));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(covered | uncovered)));
    agaa_count(AGAA_COUNT_ONCE, samples);
#if AGAA_COUNTING
    agaa_count(AGAA_COUNT_UNCOVERED, uint(bitCount(uncovered)));
    if (uncovered != 0u)
        agaa_reportPixel(pixel, covered | uncovered, uncovered, 0u);
#endif
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, samples);
}
#endif
