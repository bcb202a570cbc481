// Adds fetched materials, one for all samples that a primitive has in a pixel, to the means of an aggregate.
#ifndef AGAA_FETCHED_MEANS_GLSL
#define AGAA_FETCHED_MEANS_GLSL
#include "ids/fetch.glsl"
#include "aggregate/mean_surface.glsl"

// Sums of places in the pixel and of their products, over samples of a primitive by their weights.
struct agaa_PositionSums {
    float weight;
    vec2 sum;
    vec3 products; // xx, yy, xy
};

// Normals of a primitive that grow evenly across the pixel: as one in their middle, with the spread around it.
void agaa_addCurved(inout agaa_Means m, AgaaMaterial material, agaa_PositionSums places) {
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

// places: of materials that are curved; weight: of their samples, in all.
void agaa_addFetched(inout agaa_Means m, AgaaMaterial material, float weight, agaa_PositionSums places) {
    agaa_Surface s = agaa_surfaceOfMaterial(material);
    agaa_addMaterial(m, weight, s);
    if (!agaa_isCurvedMaterial(material))
        agaa_addNormal(m, weight, s.normal);
    else if (weight > 0.0)
        agaa_addCurved(m, material, places);
}
#endif
