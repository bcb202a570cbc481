// Aggregate definition: which aggregate each sample of a pixel belongs to (AGAA section 3.3).
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_COUNTING 0
#define AGAA_MAX_SAMPLES 32
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "math/encoding.glsl"
#include "math/clustering.glsl"
#include "math/metadata.glsl"

layout(AGAA_AT_DEPTH) uniform AGAA_TARGET_TEXTURE agaa_depth;
#if AGAA_FROM_GBUFFER
#include "passes/gbuffer.glsl"
#else
layout(AGAA_AT_SURFACE0) uniform AGAA_TARGET_TEXTURE agaa_normals;
#endif
layout(AGAA_AT_METADATA_OUT) writeonly uniform uimage2D agaa_metadata;

// The normal of a sample in a frame that all samples of the pixel share, and a number that is equal for
// equal normals. False where there is no geometry.
bool agaa_loadNormal(uvec2 pixel, uint i, out vec3 normal, out uint code) {
#if AGAA_FROM_GBUFFER
    if (!agaa_fetchSample(pixel, i))
        return false;
    normal = agaa_decodeOct(agaa_normalCode(), AGAA_SOURCE_NORMAL_X >> 16);
    uvec2 c = uvec2(agaa_normalCode() * 65535.0 + 0.5);
    code = (c.x << 16 | c.y) * 2654435761u >> 16;
#else
    uvec2 c = uvec2(AGAA_FETCH(agaa_normals, pixel, i).xy * 255.0 + 0.5);
    if (c.x + c.y == 0u)
        return false;
    normal = agaa_decodeHemiOct8(c);
    code = c.x << 8 | c.y;
#endif
    return true;
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size.xy)))
        return;
    uint covered = 0u;
    float nearest2 = 3.0e38;
    float quantum = 0.0;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        vec3 normal;
        uint code;
        if (!agaa_loadNormal(pixel, i, normal, code))
            continue;
        covered |= 1u << i;
        float depth = AGAA_FETCH(agaa_depth, pixel, i).x;
        vec3 position = agaa_sampleViewPosition(pixel, i, depth);
        uvec2 place = uvec2(agaa_frame.samplePosition[i].xy * 128.0);
        agaa_setSample(i, position, normal, floatBitsToUint(depth),
                       code << 16 | place.x << 8 | place.y);
        nearest2 = min(nearest2, dot(position, position));
        float step = agaa_frame.projection1.w;
        step = step < 0.0 ? -step * depth : step; // float formats: relative
        quantum = max(quantum, agaa_depthQuantum(position.z, depth, agaa_frame.projection1.x,
                                                 agaa_frame.projection1.y, agaa_isOrthographic(),
                                                 step));
    }
    float k = agaa_characteristicLength(agaa_frame.cluster.x, agaa_frame.cluster.y, sqrt(nearest2),
                                        quantum, agaa_frame.cluster.z);
    uvec2 planes = uvec2(0u);
    if (covered != 0u &&
        agaa_defineAggregates(AGAA_SAMPLES, covered, AGAA_AGGREGATES, k, agaa_frame.cluster.z,
                              AGAA_SEEDS) > 1u) {
        for (uint i = 0u; i < AGAA_SAMPLES; ++i)
            if ((covered >> i & 1u) != 0u)
                agaa_putAggregateId(planes, i, agaa_sampleAggregate[i]);
    }
    planes = agaa_storedPlanes(planes, AGAA_SAMPLES, AGAA_AGGREGATES);
    imageStore(agaa_metadata, ivec2(pixel), uvec4(planes, 0u, 0u));
}
