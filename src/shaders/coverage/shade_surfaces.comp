// Shades each surface of `dcaa` once, weighted by the samples that it shows (DCAA section 3.4).
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_REPRESENTED 1
#define AGAA_FINDS_LIGHTS
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "coverage/covered_surface.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/event_light.glsl"
#include "common/tile.glsl"

#if AGAA_IN_TARGETS
layout(AGAA_BINDING_SURFACE_TARGETS) uniform usampler2DArray agaa_surfaces; // four words a layer
uvec2 agaa_surfacesOf = uvec2(0u);
void agaa_seekSurfaces(uvec2 pixel) { agaa_surfacesOf = pixel; }
uint agaa_readSurfaces(uint word) {
    return texelFetch(agaa_surfaces, ivec3(agaa_surfacesOf, word >> 2u), 0)[word & 3u];
}
#else
layout(std430, AGAA_BINDING_SURFACES) readonly buffer agaa_SurfaceBlock { uint words[]; }
agaa_surfaces;
void agaa_seekSurfaces(uvec2 pixel) {}
uint agaa_readSurfaces(uint word) { return agaa_surfaces.words[word]; }
#endif

#define AGAA_AGGREGATE_WORD(i) agaa_readSurfaces(i)
#define AGAA_IMAGE_WIDTH agaa_frame.size.x
#define AGAA_EMISSIVE_RANGE agaa_frame.emissiveRange
#include "aggregate/stored_aggregate.glsl"
#include "coverage/surface_position.glsl"

shared uvec4 agaa_shown[64u * AGAA_AGGREGATES]; // of each surface, the samples that show it
shared float agaa_sampleWeights[64];            // of each pixel, where AGAA_NORMALISES is set

// Returns whether the surfaces count as if they covered the pixel.
bool agaa_isWhole(uvec2 pixel) {
#if !AGAA_IN_TARGETS
    if (AGAA_NORMALISES != 0u)
        return agaa_readSurfaces(agaa_boundOfSurfaces(pixel)) != 0u;
#endif
    return false;
}

uvec4 agaa_loadMask(uint base) {
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
        mask[word] = agaa_readSurfaces(base + word);
    return mask;
}

agaa_DepthPlane agaa_loadPlane(uint base, uvec4 mask) {
    agaa_StoredPlane stored = agaa_StoredPlane(uintBitsToFloat(agaa_readSurfaces(base + AGAA_DEPTH_WORD)),
                                               agaa_readSurfaces(base + AGAA_SLOPE_WORD));
    return agaa_loadedPlane(stored, agaa_coverageMiddle(mask, AGAA_SAMPLES), false);
}

// Returns the samples that surface a loses to the others.
uvec4 agaa_hiddenSamples(uvec2 pixel, uint a, uvec4 mask, agaa_DepthPlane plane) {
    uvec4 hidden = uvec4(0u);
    for (uint other = 0u; other < agaa_aggregateLimit(); ++other) {
        uint base = agaa_surfaceBase(pixel, other);
        uvec4 second = agaa_loadMask(base);
        uvec4 both = second & mask;
        if (other != a && agaa_coverageCount(both) != 0u)
            hidden |= agaa_samplesBehind(plane, agaa_loadPlane(base, second), both, other < a, AGAA_SAMPLES);
    }
    return hidden;
}

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_seekSurfaces(pixel);
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    uint first = gl_LocalInvocationIndex * AGAA_AGGREGATES;
    agaa_Box box = agaa_emptyBox();
    for (uint a = 0u; a < agaa_aggregateLimit(); ++a) {
        uint base = agaa_surfaceBase(pixel, a);
        uvec4 mask = agaa_loadMask(base);
        uint count = 0u;
        if (agaa_coverageCount(mask) != 0u) {
            agaa_DepthPlane plane = agaa_loadPlane(base, mask);
            mask &= ~agaa_hiddenSamples(pixel, a, mask, plane);
            count = agaa_coverageCount(mask);
            if (count != 0u && agaa_needsTileBox())
                agaa_addToBox(box, agaa_viewPositionOf(pixel, plane, agaa_coverageMiddle(mask, AGAA_SAMPLES)));
        }
        agaa_shown[first + a] = mask;
        work.events[0] |= count != 0u ? 1u << a : 0u;
        work.covered += count;
    }
    agaa_addToTile(box);
    agaa_countEvents(agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_VISIBLE, work.covered);
    agaa_count(AGAA_COUNT_ONCE, work.covered);
    agaa_count(AGAA_COUNT_AGGREGATES, agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_PIXELS, work.events[0] != 0u ? 1u : 0u);
    bool isWhole = work.covered != 0u && agaa_isWhole(pixel);
    agaa_sampleWeights[gl_LocalInvocationIndex] = isWhole ? float(AGAA_SAMPLES) / float(work.covered) : 1.0;
    work.covered = isWhole ? AGAA_SAMPLES : work.covered;
    return work;
}

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_lightPixel(pixel);
    agaa_seekSurfaces(pixel);
    uint base = agaa_surfaceBase(pixel, a);
    uvec4 mask = agaa_shown[lane * AGAA_AGGREGATES + a];
    agaa_DepthPlane plane = agaa_loadPlane(base, agaa_loadMask(base));
    vec3 position = agaa_surfacePosition(pixel, plane, agaa_coverageMiddle(mask, AGAA_SAMPLES));
    agaa_tapSurface(pixel, plane, mask, position);
    float weight = float(agaa_coverageCount(mask)) * (AGAA_NORMALISES != 0u ? agaa_sampleWeights[lane] : 1.0);
    agaa_base = base + AGAA_MATERIAL_WORD;
    agaa_Means m = agaa_meansOfStored(agaa_storedMeans());
    agaa_setEventCustom(m);
    agaa_Surface s =
        agaa_Surface(m.diffuse, m.specular, m.emissive, agaa_unpackNormal(agaa_readSurfaces(base + AGAA_NORMAL_WORD)),
                     1.0, m.alpha2, 0.0, vec3(0.0));
    float widening = 0.0;
    if (AGAA_SPREAD_WORDS != 0u && AGAA_HAS_SPECULAR != 0u) {
        uint at = base + AGAA_SPREAD_WORD;
        agaa_widenSurface(s, agaa_unpackSpread(s.normal, uvec2(agaa_readSurfaces(at), agaa_readSurfaces(at + 1u))));
        widening = max(sqrt(s.alpha2Along) - sqrt(m.alpha2), 0.0);
        agaa_count(AGAA_COUNT_WIDENED, widening > 0.0 ? 1u : 0u);
    }
    return agaa_eventLight(a, widening, s, position) * weight;
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
