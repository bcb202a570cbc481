// Input of the clustering for one pixel, wherever its samples come from. Needs AGAA_MAX_SAMPLES and common/frame.glsl.
#ifndef AGAA_PIXEL_SAMPLES_GLSL
#define AGAA_PIXEL_SAMPLES_GLSL
#ifndef AGAA_MAX_SAMPLES
#error "pixel_samples.glsl needs AGAA_MAX_SAMPLES."
#endif
#define AGAA_CLASSES (AGAA_CLASS_CHANNEL != 0u)
#define AGAA_PLANES (AGAA_DEPTH_PLANES != 0u)
#include "math/clustering.glsl"
#include "math/ndf.glsl"
#include "common/camera.glsl"

// Returns whether samples of one plane may be in several aggregates (AGAA_CONFIG_SPLIT_SURFACES). The planner then sets
// a cosine above 1, which no two normals have.
bool agaa_splitsSurfaces() { return AGAA_AGGREGATES > 1u && agaa_frame.surfaceCosine > 1.0; }

struct agaa_PixelSamples {
    uint covered;
    float nearest;  // distance of the nearest sample
    float nearestZ; // its distance along the view
};

// Scales a normal for the clustering, so that differences of glossy surfaces weigh more: w = weight / alpha, [1, 20].
vec3 agaa_weighedNormal(vec3 shadingNormal, float alpha2) {
    float w = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) * inversesqrt(max(alpha2, agaa_minAlpha2())), 1.0, 20.0);
    return sqrt(w) * shadingNormal;
}

void agaa_weighNormal(uint i, vec3 shadingNormal, float alpha2) {
    agaa_sampleNormal[i] = agaa_weighedNormal(shadingNormal, alpha2);
}

agaa_PixelSamples agaa_noSamples() { return agaa_PixelSamples(0u, 3.0e38, 3.0e38); }

// Call it after all samples are added, while `nearest` is the square of the distance.
agaa_PixelSamples agaa_withDistance(agaa_PixelSamples samples) {
    samples.nearest = sqrt(samples.nearest);
    return samples;
}

// Returns the length of one step of the depth buffer at a sample.
// quantum   Step of the stored depth.
float agaa_depthStepAt(vec3 position, float depth, float quantum) {
    return agaa_depthQuantum(position.z, depth, agaa_frame.projection22, agaa_frame.projection32,
                             agaa_isOrthographic(), quantum);
}

// Returns the code of a sample's content: by its normal or, with AGAA_CLASSES, its class and weight. The position alone
// distinguishes samples.
// code     16 bits, equal for equal normals.
// weight   Number of samples that it stands for, [1, 255].
uint agaa_codeWithClass(uint code, uint class_, uint weight) { return AGAA_CLASSES ? class_ << 8u | weight : code; }

// Returns the second key of a sample's content.
// offset   Position in the pixel, [0, 1].
// code     Of agaa_codeWithClass().
uint agaa_contentKey(vec2 offset, uint code) {
    uvec2 key = uvec2(offset * 128.0);
    return code << 16 | key.x << 8 | key.y;
}

// Adds sample i, which has geometry.
// quantum   Step of its stored depth.
// offset    Position in the pixel, [0, 1].
// code      Of agaa_codeWithClass().
void agaa_addSampleAt(inout agaa_PixelSamples samples, uint i, vec3 position, float depth, float quantum, vec2 offset,
                      vec3 normal, uint code) {
    samples.covered |= 1u << (i & 31u);
    agaa_setSample(i, position, normal, agaa_depthStepAt(position, depth, quantum), floatBitsToUint(depth),
                   agaa_contentKey(offset, code));
    samples.nearest = min(samples.nearest, dot(position, position));
    samples.nearestZ = min(samples.nearestZ, abs(position.z));
}

// Returns the code of a normal that is not stored as one.
uint agaa_codeOfNormal(vec3 normal) {
    uvec3 c = uvec3((normal * 0.5 + 0.5) * 2047.0 + 0.5);
    return ((c.x * 2048u + c.y) * 2048u + c.z) * 2654435761u >> 16;
}

float agaa_pixelCharacteristicLength(agaa_PixelSamples samples) {
    float distance = agaa_scaleDistance(samples.nearest, agaa_frame.projectionScale.x, agaa_isOrthographic());
    return agaa_characteristicLength(agaa_frame.characteristicLength, agaa_frame.characteristicLengthPerDistance,
                                     distance);
}

// Returns the tolerance of a surface to its plane, without the steps of depth.
float agaa_surfaceWidth(agaa_PixelSamples samples) {
    return agaa_frame.surfaceDistance * agaa_pixelWidth(samples.nearestZ);
}
#endif
