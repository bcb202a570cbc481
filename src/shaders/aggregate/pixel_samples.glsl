// What the clustering knows of a pixel, wherever its samples come from.
#ifndef AGAA_PIXEL_SAMPLES_GLSL
#define AGAA_PIXEL_SAMPLES_GLSL
#include "math/clustering.glsl"
#include "math/ndf.glsl"
#include "common/camera.glsl"

// Whether samples of one plane may be in several aggregates (AGAA_CONFIG_SPLIT_SURFACES): the planner then asks for a
// cosine that no two normals have.
bool agaa_splitsSurfaces() { return AGAA_AGGREGATES > 1u && agaa_frame.surfaceCosine > 1.0; }

struct agaa_PixelSamples {
    uint covered;
    float nearest;  // distance
    float nearestZ; // along the view
};

// Normals, for the clustering alone, as long as their gloss makes differences count: w = weight / alpha, [1;20].
void agaa_weighNormal(uint i, vec3 shadingNormal, float alpha2) {
    float w = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) * inversesqrt(max(alpha2, agaa_minAlpha2())), 1.0, 20.0);
    agaa_sampleNormal[i] = sqrt(w) * shadingNormal;
}

agaa_PixelSamples agaa_noSamples() { return agaa_PixelSamples(0u, 3.0e38, 3.0e38); }

// While samples are added, the distance is its square.
agaa_PixelSamples agaa_withDistance(agaa_PixelSamples samples) {
    samples.nearest = sqrt(samples.nearest);
    return samples;
}

// One more sample, i, that shows geometry. quantum: a step of its depth; place: in the pixel; code: equal for equal normals.
void agaa_addSampleAt(inout agaa_PixelSamples samples, uint i, vec3 position, float depth, float quantum, vec2 place, vec3 normal,
                    uint code) {
    samples.covered |= 1u << (i & 31u);
    float depthStep = agaa_depthQuantum(position.z, depth, agaa_frame.projection22, agaa_frame.projection32,
                                        agaa_isOrthographic(), quantum);
    uvec2 key = uvec2(place * 128.0);
    agaa_setSample(i, position, normal, depthStep, floatBitsToUint(depth), code << 16 | key.x << 8 | key.y);
    samples.nearest = min(samples.nearest, dot(position, position));
    samples.nearestZ = min(samples.nearestZ, abs(position.z));
}

// Of a normal that is not stored as a code.
uint agaa_codeOfNormal(vec3 normal) {
    uvec3 c = uvec3((normal * 0.5 + 0.5) * 2047.0 + 0.5);
    return ((c.x * 2048u + c.y) * 2048u + c.z) * 2654435761u >> 16;
}

float agaa_pixelCharacteristicLength(agaa_PixelSamples samples) {
    float distance = agaa_scaleDistance(samples.nearest, agaa_frame.projectionScale.x, agaa_isOrthographic());
    return agaa_characteristicLength(agaa_frame.characteristicLength, agaa_frame.characteristicLengthPerDistance, distance);
}

// How far from its plane a surface may be, beside the steps of depth.
float agaa_surfaceWidth(agaa_PixelSamples samples) {
    return agaa_frame.surfaceDistance * agaa_pixelWidth(samples.nearestZ);
}
#endif
