// Adds fetched materials, one per primitive in a pixel, to the means of an aggregate. Needs what ids/fetch.glsl needs.
#ifndef AGAA_FETCHED_MEANS_GLSL
#define AGAA_FETCHED_MEANS_GLSL
#include "ids/fetched_custom.glsl"
#include "aggregate/mean_surface.glsl"

// Weighted sums of positions in the pixel and of their products over samples of a primitive.
struct agaa_PositionSums {
    float weight;
    vec2 sum;
    vec3 products; // xx, yy, xy
};

// Adds normals that change linearly across the pixel, as the normal at their centroid and the spread around it.
void agaa_addCurved(inout agaa_Means m, AgaaMaterial material, agaa_PositionSums sums) {
    vec2 middle = sums.sum / sums.weight;
    vec3 n = material.normal + middle.x * material.normalDx + middle.y * material.normalDy;
    float scale = inversesqrt(max(dot(n, n), 1e-6));
    n *= scale;
    vec3 u = scale * material.normalDx;
    vec3 v = scale * material.normalDy;
    vec3 spread = sums.products / sums.weight - vec3(middle * middle, middle.x * middle.y);
    spread.xy = max(spread.xy, vec2(0.0));
    vec3 squares = spread.x * u * u + spread.y * v * v + 2.0 * spread.z * u * v;
    float total = 1.0 + max(squares.x + squares.y + squares.z, 0.0);
    m.normal += sums.weight * inversesqrt(total) * n;
    if (AGAA_KEEPS_MOMENTS) {
        float share = sums.weight / total;
        agaa_addSecondMoments(m.moments, share, n);
        m.moments.squares += share * squares;
        m.moments.mixed += share * (spread.x * u.yzx * u.zxy + spread.y * v.yzx * v.zxy +
                                    spread.z * (u.yzx * v.zxy + u.zxy * v.yzx));
    }
}

// weight    Sum of the weights of the samples.
// sums      Used for curved materials only.
void agaa_addFetched(inout agaa_Means m, AgaaMaterial material, float weight, agaa_PositionSums sums) {
    agaa_Surface s = agaa_surfaceOfMaterial(material);
    agaa_addMaterial(m, weight, s);
    agaa_addCustom(m, weight, agaa_customOfMaterial(material));
    if (!agaa_isCurvedMaterial(material))
        agaa_addNormal(m, weight, s.normal);
    else if (weight > 0.0)
        agaa_addCurved(m, material, sums);
}
#endif
