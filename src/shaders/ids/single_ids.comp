// Shades pixels of one primitive, whose samples are one aggregate. Pixels that show several primitives, or whose
// surfaces may be split, are deferred to the pass that groups samples.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
#define AGAA_SAMPLE_WORDS AGAA_SAMPLES
#define AGAA_GROUPING_WORDS 0u
#define AGAA_HAS_LIT_PART
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

// The materials of the current pixel. A pixel of one material keeps it in registers. With several materials and one lit
// shadow or none, each is added to the means when it is fetched, and the light is looked up before. Only several lit
// shadows keep several materials, in an array of the lane, which GPUs have in device memory.
AgaaMaterial agaa_materials[(AGAA_MAX_SAMPLES + AGAA_MATERIAL_SAMPLES - 1u) / AGAA_MATERIAL_SAMPLES];
agaa_Means agaa_pixelMeans;

bool agaa_hasOneMaterial() { return !agaa_hasFineMaterials() || AGAA_MATERIAL_SAMPLES >= AGAA_MAX_SAMPLES; }

bool agaa_keepsMaterials() {
#if AGAA_LIT
    if ((AGAA_LIT_SHADOWS & AGAA_LIT_SHADOWS - 1u) != 0u)
        return true;
#endif
    return agaa_hasOneMaterial();
}

// Returns the index of the material of sample i.
uint agaa_materialOf(uint i) { return agaa_hasOneMaterial() ? 0u : i / AGAA_MATERIAL_SAMPLES; }

#if AGAA_LIT
agaa_LitPart agaa_pixelLit; // of the one lit shadow
uint agaa_reached = 0u;     // samples that its light reaches
#endif

// Prepares agaa_addMaterial(). Taps are not counted, because the pixel may be deferred.
void agaa_beginMeans(uvec2 pixel, uint samples) {
    agaa_pixelMeans = agaa_noMeans();
#if AGAA_LIT
    agaa_lightPixel(pixel);
    const uint map = uint(findLSB(AGAA_LIT_SHADOWS));
    agaa_reached = agaa_reachedSamples(map, samples);
    agaa_pixelLit = agaa_LitPart(agaa_lightSamples(pixel, map, agaa_reached), agaa_noMeans());
#endif
}

void agaa_addMaterialOf(AgaaMaterial m, uint group, uint samples) {
    agaa_addPrimitive(agaa_pixelMeans, m, group, 1.0 / float(bitCount(samples)), false);
#if AGAA_LIT
    if (agaa_reached != 0u)
        agaa_addPrimitive(agaa_pixelLit.means, m, group, agaa_lightScale(agaa_pixelLit.light), true);
#endif
}

// Fetches the materials of a pixel. Returns whether all samples may be in one aggregate: shading normals are those of
// one surface, and materials have one class. It precedes all readers of agaa_materials, because compilers warn about
// reads that precede writes.
bool agaa_fetchGroups(uvec2 pixel, uint id, uint samples) {
    vec3 normal = vec3(0.0);
    float least = 1.0;
    uint firstClass = 0u;
    bool isOneClass = true;
    if (!agaa_keepsMaterials())
        agaa_beginMeans(pixel, samples);
    for (uint left = samples; left != 0u;) {
        uint first = uint(findLSB(left));
        uint group = left & agaa_materialGroup(first);
        // The primitive is fetched for each material: to keep it takes more registers than GPUs have for four waves.
        AgaaMaterial m = agaa_fetchMaterial(agaa_primitive(id), pixel, group);
        if (agaa_keepsMaterials())
            agaa_materials[agaa_materialOf(first)] = m;
        else
            agaa_addMaterialOf(m, group, samples);
        bool isFirst = left == samples;
        left &= ~group;
        uint class_ = agaa_classOfMaterial(m);
        firstClass = isFirst ? class_ : firstClass;
        isOneClass = isOneClass && class_ == firstClass;
        if (AGAA_AGGREGATES == 1u || AGAA_GLOSS_WEIGHT == 0u)
            continue;
        normal = isFirst ? agaa_materialNormal(m, first) : normal;
        uint compared = agaa_isCurvedMaterial(m) ? group : 1u << first;
        for (; compared != 0u; compared &= compared - 1u)
            least = min(least, dot(normal, agaa_materialNormal(m, uint(findLSB(compared)))));
    }
    bool isOneSurface = AGAA_GLOSS_WEIGHT == 0u || least >= agaa_frame.surfaceCosine;
    return AGAA_AGGREGATES == 1u || (isOneSurface && isOneClass);
}

// Returns means over kept materials.
agaa_Means agaa_meansOf(uint samples, float scale, bool isLit) {
    agaa_Means m = agaa_noMeans();
    for (uint left = samples; left != 0u;) {
        uint first = uint(findLSB(left));
        uint group = left & agaa_materialGroup(first);
        agaa_addPrimitive(m, agaa_materials[agaa_materialOf(first)], group, scale, isLit);
        left &= ~group;
    }
    return m;
}

#if AGAA_LIT
agaa_LitPart agaa_litPart(uvec2 pixel, uint map, uint mask) {
    if (!agaa_keepsMaterials())
        return agaa_pixelLit;
    float light = agaa_lightSamples(pixel, map, mask);
    return agaa_LitPart(light, agaa_meansOf(mask, agaa_lightScale(light), true));
}
#endif

void agaa_shadeSingle(uvec2 pixel, uint id, uint samples) {
    if (!agaa_fetchGroups(pixel, id, samples)) {
        agaa_deferLate(pixel);
        return;
    }
    agaa_count(AGAA_COUNT_PRIMITIVES, 1u);
    agaa_shownPrimitives = 1u;
    agaa_PixelWork work = agaa_countedWork(pixel, 1u, samples, 0u);
    agaa_Means means = agaa_pixelMeans;
    if (agaa_keepsMaterials())
        means = agaa_meansOf(samples, 1.0 / float(bitCount(samples)), false);
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
