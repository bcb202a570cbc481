// Aggregates of what a pixel's ids name, shaded at once. A tile's lanes list the primitives of their pixels and share
// out the fetching of materials, each in the middle of the samples that its primitive has in a pixel, the grouping of
// samples in pixels of several primitives, and the shading. Nothing but the image goes to memory.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES 32
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/aggregate.glsl"
#include "passes/samples.glsl"
#include "math/surfaces.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#define AGAA_OWN_TILE
#include "passes/tile.glsl"

// Primitives of pixels that are in hand; a tile with more takes them in turns, a pixel at a time at least.
const uint agaa_listLength = 256u;
shared uint agaa_listed; // places asked for, of which some may not have been had
shared uint agaa_listId[agaa_listLength];
shared uint agaa_listSamples[agaa_listLength]; // 0: nobody's
shared uint agaa_listLane[agaa_listLength];
shared vec3 agaa_listPlane[agaa_listLength]; // normal in view space
shared AgaaMaterial agaa_listMaterial[agaa_listLength];
shared uint agaa_pixelList[64];                    // first place | number of them << 16
shared uint agaa_manyCount;                        // pixels of several primitives
shared uint agaa_many[64];
shared uint agaa_aggregateCount[64];
shared uint agaa_masks[64u * AGAA_AGGREGATES];     // samples of each aggregate
shared uint agaa_waiting;                          // pixels that did not find room

// Of the pixel at hand.
uint agaa_sampleIds[AGAA_MAX_SAMPLES];
uint agaa_samplePrimitive[AGAA_MAX_SAMPLES]; // its place in the list
uint agaa_primitiveSamples[AGAA_MAX_SAMPLES];

// Returns the samples that show geometry.
uint agaa_loadIds(uvec2 pixel) {
    uint covered = 0u;
    for (uint i = 0u; i < agaa_sampleCount(); ++i) {
        agaa_sampleIds[i] = agaa_idOf(pixel, i);
        covered |= agaa_sampleIds[i] != 0u ? 1u << i : 0u;
    }
    return covered;
}

// Returns how many primitives these samples show.
uint agaa_findPrimitives(uint covered) {
    uint count = 0u;
    for (uint left = covered; left != 0u; ++count) {
        uint id = agaa_sampleIds[findLSB(left)];
        uint alike = 0u;
        for (uint rest = left; rest != 0u; rest &= rest - 1u) {
            uint i = uint(findLSB(rest));
            alike |= agaa_sampleIds[i] == id ? 1u << i : 0u;
        }
        agaa_primitiveSamples[count] = alike;
        left &= ~alike;
    }
    return count;
}

void agaa_listPrimitives(uint first, uint count) {
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = 0u; i < count; ++i) {
        agaa_listId[first + i] = agaa_sampleIds[findLSB(agaa_primitiveSamples[i])];
        agaa_listSamples[first + i] = agaa_primitiveSamples[i];
        agaa_listLane[first + i] = lane;
    }
    agaa_pixelList[lane] = first | count << 16u;
}

void agaa_fetchListed(uint at, uvec2 corner) {
    uint samples = agaa_listSamples[at];
    vec2 middle = vec2(0.0);
    for (uint rest = samples; rest != 0u; rest &= rest - 1u)
        middle += agaa_frame.samplePosition[findLSB(rest)].xy;
    middle /= float(bitCount(samples));
    uint lane = agaa_listLane[at];
    AgaaPrimitive p = agaa_primitive(agaa_listId[at]);
    agaa_listPlane[at] = agaa_planeNormal(p);
    agaa_listMaterial[at] = agaa_fetchMaterial(p, corner + uvec2(lane & 7u, lane >> 3u), middle);
}

// lane: of the pixel, which may be another's.
agaa_PixelSamples agaa_listedSamples(uvec2 pixel, uint lane) {
    agaa_PixelSamples samples = agaa_noSamples();
    uint first = agaa_pixelList[lane] & 0xFFFFu;
    uint count = agaa_pixelList[lane] >> 16u;
    uint covered = 0u;
    for (uint k = 0u; k < count; ++k) {
        covered |= agaa_listSamples[first + k];
        for (uint rest = agaa_listSamples[first + k]; rest != 0u; rest &= rest - 1u)
            agaa_samplePrimitive[findLSB(rest)] = first + k;
    }
    for (uint i = 0u; i < agaa_sampleCount(); ++i) {
        if ((covered >> i & 1u) == 0u)
            continue;
        vec3 normal = agaa_listPlane[agaa_samplePrimitive[i]];
        uvec3 c = uvec3((normal * 0.5 + 0.5) * 2047.0 + 0.5);
        agaa_addSample(samples, pixel, i, normal, ((c.x * 2048u + c.y) * 2048u + c.z) * 2654435761u >> 16);
    }
    return agaa_withDistance(samples);
}

void agaa_weighNormals(uint covered) {
    for (uint i = 0u; i < agaa_sampleCount(); ++i)
        if ((covered >> i & 1u) != 0u) {
            AgaaMaterial m = agaa_listMaterial[agaa_samplePrimitive[i]];
            agaa_weighNormal(i, mat3(agaa_frame.view) * m.normal, m.alpha2);
        }
}

void agaa_groupSamples(uvec2 pixel, uint lane) {
    agaa_PixelSamples samples = agaa_listedSamples(pixel, lane);
    uint count = 1u;
    bool parted = !agaa_areAllOneSurface(agaa_sampleCount(), samples.covered, agaa_frame.surface.x,
                                         agaa_surfaceWidth(samples));
    if (parted && AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighNormals(samples.covered);
    if (parted)
        count = agaa_defineAggregates(agaa_sampleCount(), samples.covered, AGAA_AGGREGATES,
                                      agaa_pixelCharacteristicLength(samples), agaa_frame.cluster.z,
                                      AGAA_SEEDS);
    agaa_aggregateCount[lane] = count;
    uint base = lane * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
}

agaa_PixelWork agaa_countedWork(uint count, uint samples) {
    agaa_count(AGAA_COUNT_VISIBLE, samples);
    agaa_count(AGAA_COUNT_ONCE, samples);
    agaa_count(AGAA_COUNT_EVENTS, count);
    agaa_count(AGAA_COUNT_PIXELS, 1u);
    return agaa_PixelWork((1u << count) - 1u, 0u, samples);
}

void agaa_addMaterial(inout agaa_Means m, float weight, AgaaMaterial one) {
    m.diffuse += weight * one.diffuse;
    m.normal += weight * one.normal;
    if (AGAA_HAS_SPECULAR != 0u) {
        m.specular += weight * one.specular;
        m.alpha2 += weight * one.alpha2;
    }
    if (AGAA_EMISSIVE_CHANNELS != 0u)
        m.emissive += weight * one.emissive;
}

agaa_Means agaa_noMeans() { return agaa_Means(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 1e-6); }

// The means over samples: of each primitive as often as it has samples. lane: of the pixel.
agaa_Means agaa_meansOf(uint lane, uint mask) {
    agaa_Means m = agaa_noMeans();
    float share = 1.0 / float(bitCount(mask));
    uint list = agaa_pixelList[lane];
    uint end = (list & 0xFFFFu) + (list >> 16u);
    for (uint at = list & 0xFFFFu; at < end; ++at) {
        float weight = share * float(bitCount(agaa_listSamples[at] & mask));
        if (weight > 0.0)
            agaa_addMaterial(m, weight, agaa_listMaterial[at]);
    }
    return m;
}

#ifdef AGAA_LIT_SHADOWS
// The means over what the lights of a shadow reach of the samples, and the share of them that they do.
agaa_Means agaa_litMeansOf(uvec2 pixel, uint lane, uint mask, uint map, out float share) {
    agaa_Means m = agaa_noMeans();
    float sum = 0.0;
    uint list = agaa_pixelList[lane];
    uint end = (list & 0xFFFFu) + (list >> 16u);
    for (uint at = list & 0xFFFFu; at < end; ++at) {
        float weight = 0.0;
        for (uint rest = agaa_listSamples[at] & mask; rest != 0u; rest &= rest - 1u)
            weight += agaa_shadowTap(map, agaa_toShadingSpace(agaa_viewPositionOf(pixel, uint(findLSB(rest)))));
        if (weight > 0.0)
            agaa_addMaterial(m, weight, agaa_listMaterial[at]);
        sum += weight;
    }
    share = sum / float(bitCount(mask));
    float scale = sum > 0.0 ? 1.0 / sum : 0.0;
    m.diffuse *= scale;
    m.specular *= scale;
    m.normal *= scale;
    m.alpha2 *= scale;
    return m;
}

void agaa_findLitSurfaces(uvec2 pixel, uint lane, uint mask, vec3 toEye) {
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        if (agaa_isLitShadow(map))
            agaa_litSurface[map] = agaa_surfaceOfMeans(
                agaa_litMeansOf(pixel, lane, mask, map, agaa_visibility[map]), false, toEye);
}
#endif

vec3 agaa_shadeEvent(uvec2 pixel, uint a) {
    uint lane = (pixel.y & 7u) * 8u + (pixel.x & 7u);
    uint mask = agaa_masks[lane * AGAA_AGGREGATES + a];
    vec3 position = agaa_placeAggregate(pixel, mask);
    agaa_Means means = agaa_meansOf(lane, mask);
    agaa_Surface s = agaa_surfaceOfMeans(means, false, agaa_toEye(position));
    agaa_countWidening(means, s);
#ifdef AGAA_LIT_SHADOWS
    agaa_findLitSurfaces(pixel, lane, mask, agaa_toEye(position));
#endif
    return agaa_lightSurface(s, position) * float(bitCount(mask));
}

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    uvec2 corner = gl_WorkGroupID.xy * 8u;
    uvec2 pixel = corner + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(pixel, agaa_frame.size.xy));
    uint covered = inside ? agaa_loadIds(pixel) : 0u;
    uint primitives = agaa_findPrimitives(covered);
    if (inside && covered == 0u)
        agaa_writePixel(pixel, agaa_PixelWork(0u, 0u, 0u), vec3(0.0));
    bool waits = covered != 0u;
    for (;;) {
        if (lane == 0u)
            agaa_listed = agaa_waiting = agaa_manyCount = 0u;
        for (uint at = lane; at < agaa_listLength; at += 64u)
            agaa_listSamples[at] = 0u;
        barrier();
        uint first = waits ? atomicAdd(agaa_listed, primitives) : 0u;
        bool turn = waits && first + primitives <= agaa_listLength;
        if (turn) {
            agaa_listPrimitives(first, primitives);
            agaa_aggregateCount[lane] = 1u;
            agaa_masks[lane * AGAA_AGGREGATES] = covered;
        }
        // A primitive is plane: with one there is nothing to group.
        if (turn && primitives > 1u && AGAA_AGGREGATES > 1u)
            agaa_many[atomicAdd(agaa_manyCount, 1u)] = lane;
        waits = waits && !turn;
        if (waits)
            atomicAdd(agaa_waiting, 1u);
        barrier();
        uint listed = min(agaa_listed, agaa_listLength);
        uint waiting = agaa_waiting;
        for (uint at = lane; at < listed; at += 64u)
            if (agaa_listSamples[at] != 0u)
                agaa_fetchListed(at, corner);
        barrier();
        if (lane < agaa_manyCount) {
            uint other = agaa_many[lane];
            agaa_groupSamples(corner + uvec2(other & 7u, other >> 3u), other);
        }
        barrier();
        agaa_PixelWork work = agaa_PixelWork(0u, 0u, 0u);
        if (turn)
            work = agaa_countedWork(agaa_aggregateCount[lane], uint(bitCount(covered)));
        vec3 color = agaa_shadeWork(work, corner);
        if (turn)
            agaa_writePixel(pixel, work, color);
        if (waiting == 0u)
            break;
        barrier();
    }
    agaa_countEnd();
}
