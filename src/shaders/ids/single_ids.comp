// Shades pixels of one primitive, whose samples are one aggregate. Pixels that show several primitives, or whose
// surfaces may be split, are deferred to the pass that groups samples.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
#define AGAA_SAMPLE_WORDS AGAA_SAMPLES
#define AGAA_GROUPING_WORDS 0u
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "aggregate/samples.glsl"
#include "ids/deferred_pixels.glsl"
#include "ids/primitive_means.glsl"

// A workgroup has a region of AGAA_REGION_SIDE tiles in each direction and compacts its pixels of one primitive, so
// that all lanes are busy.
shared uint agaa_singleCount;
shared uint agaa_singlePixel[64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE]; // x | y << 16
shared uint agaa_singleId[64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE];
shared uint agaa_singleSamples[64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE];

// The materials of the current pixel, by groups of samples that share one.
AgaaMaterial agaa_materials[(AGAA_MAX_SAMPLES + AGAA_MATERIAL_SAMPLES - 1u) / AGAA_MATERIAL_SAMPLES];

// Fetches the materials of a pixel. Returns whether shading normals are those of one surface. It precedes all readers
// of agaa_materials, because compilers warn about reads that precede writes.
bool agaa_fetchGroups(uvec2 pixel, uint id, uint samples) {
    AgaaPrimitive primitive = agaa_primitive(id);
    vec3 normal = vec3(0.0);
    float least = 1.0;
    for (uint left = samples; left != 0u;) {
        uint first = uint(findLSB(left));
        uint group = left & agaa_materialGroup(first);
        AgaaMaterial m = agaa_fetchMaterial(primitive, pixel, group);
        agaa_materials[first / AGAA_MATERIAL_SAMPLES] = m;
        bool isFirst = left == samples;
        left &= ~group;
        if (AGAA_AGGREGATES == 1u || AGAA_GLOSS_WEIGHT == 0u)
            continue;
        normal = isFirst ? agaa_materialNormal(m, first) : normal;
        uint compared = agaa_isCurvedMaterial(m) ? group : 1u << first;
        for (; compared != 0u; compared &= compared - 1u)
            least = min(least, dot(normal, agaa_materialNormal(m, uint(findLSB(compared)))));
    }
    return least >= agaa_frame.surfaceCosine || AGAA_AGGREGATES == 1u || AGAA_GLOSS_WEIGHT == 0u;
}

agaa_Means agaa_meansOf(uint samples, float scale, bool isLit) {
    agaa_Means m = agaa_noMeans();
    for (uint left = samples; left != 0u;) {
        uint first = uint(findLSB(left));
        uint group = left & agaa_materialGroup(first);
        agaa_addPrimitive(m, agaa_materials[first / AGAA_MATERIAL_SAMPLES], group, scale, isLit);
        left &= ~group;
    }
    return m;
}

#if AGAA_LIT
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) { return agaa_meansOf(mask, scale, true); }
#endif

void agaa_shadeSingle(uvec2 pixel, uint id, uint samples) {
    if (!agaa_fetchGroups(pixel, id, samples)) {
        agaa_deferLate(pixel);
        return;
    }
    agaa_count(AGAA_COUNT_PRIMITIVES, 1u);
    agaa_shownPrimitives = 1u;
    agaa_PixelWork work = agaa_countedWork(pixel, 1u, samples, 0u);
    agaa_Means means = agaa_meansOf(samples, 1.0 / float(bitCount(samples)), false);
    vec3 color = agaa_shadeMeans(pixel, agaa_locateAggregate(pixel, samples), 0u, samples, means, false);
    agaa_writePixel(pixel, work, color);
}

// Writes the empty pixels of a tile, lists those of one primitive, and defers the others. Each lane has a pixel.
void agaa_sortTile(uvec2 tile) {
    const uint lane = gl_LocalInvocationIndex;
    uvec2 pixel = tile * 8u + uvec2(lane & 7u, lane >> 3u);
    uint id = 0u;
    uint samples = 0u;
    bool isOne = true;
    bool isInside = all(lessThan(pixel, agaa_frame.size));
    uint i = 0u;
    do {
        uint sampleId = isInside ? agaa_idOf(pixel, i) : 0u;
        isOne = isOne && (sampleId == 0u || ((id == 0u || sampleId == id) && agaa_isFetched(sampleId)));
        id = sampleId != 0u ? sampleId : id;
        samples |= sampleId != 0u ? 1u << i : 0u;
    } while (++i < agaa_sampleCount());
    isOne = isOne && !(agaa_splitsSurfaces() && bitCount(samples) > 1);
    if (samples == 0u && isInside)
        agaa_writePixel(pixel, agaa_pixelWork(0u, 0u, 0u), vec3(0.0));
    if (samples != 0u && isOne) {
        uint at = atomicAdd(agaa_singleCount, 1u);
        agaa_singlePixel[at] = pixel.x | pixel.y << 16u;
        agaa_singleId[at] = id;
        agaa_singleSamples[at] = samples;
    }
    agaa_deferPixel(tile, !isOne);
}

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_singleCount = 0u;
    barrier();
    for (uint t = 0u; t < AGAA_REGION_SIDE * AGAA_REGION_SIDE; ++t)
        agaa_sortTile(gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(t % AGAA_REGION_SIDE, t / AGAA_REGION_SIDE));
    memoryBarrierBuffer(); // for agaa_deferLate()
    barrier();
    uint at = lane;
    do {
        if (at < agaa_singleCount) {
            uint pixel = agaa_singlePixel[at];
            agaa_shadeSingle(uvec2(pixel & 0xFFFFu, pixel >> 16u), agaa_singleId[at], agaa_singleSamples[at]);
        }
        at += 64u;
    } while (at < agaa_singleCount);
    agaa_countEnd();
}
