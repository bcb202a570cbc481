// Lighting of one surface or aggregate by all lights, with shadows. Needs AGAA_SHADOWS, common/frame.glsl, and a
// function agaa_count(counter, amount). Passes that find the lights of a tile themselves (common/tile_lights.glsl)
// define AGAA_FINDS_LIGHTS; others read the masks of lights that a pass before them has written.
#ifndef AGAA_LIGHTING_GLSL
#define AGAA_LIGHTING_GLSL
#if !defined(AGAA_SHADOWS) || !defined(AGAA_FRAME_GLSL)
#error "lighting.glsl needs AGAA_SHADOWS and frame.glsl."
#endif
#include "common/camera.glsl"
#include "common/footprint.glsl"
#include "math/brdf.glsl"
#include "math/light.glsl"
#include "math/ndf.glsl"
#include "math/sggx.glsl"
#include "math/ordered_bits.glsl" // of tile_lights.glsl and resolve_event.glsl

#include "common/lights.glsl"
#include "common/scene_facts.glsl"
#include "common/shadow_maps.glsl"
#include "common/stored.glsl"
#include "tables/lighting.inc"

#ifndef AGAA_LIT
#define AGAA_LIT 0
#endif
#ifndef AGAA_HOST_SHADES_EVENTS // 1 if a function of the host shades whole events
#define AGAA_HOST_SHADES_EVENTS 0
#endif

// Counts taps of shadow `map`. A shadow that the frame lacks costs none.
void agaa_countTaps(uint map, uint taps) {
    agaa_count(AGAA_COUNT_SHADOW_TAPS, agaa_lightBuffer.shadows[map].layerCount != 0u ? taps : 0u);
}

// Returns whether a function of the host looks this shadow up once for all samples of an event.
bool agaa_hasFootprintFunction(uint map) { return (uint(AGAA_HOST_FOOTPRINTS) >> map & 1u) != 0u; }

#if AGAA_HOST_FOOTPRINTS
float agaa_footprintTap(uint map, AgaaFootprint footprint) {
    uint bad = 0u;
    return agaa_sanitise(agaaHostShadowFootprint(map, footprint), 0.0, 1.0, bad);
}
#endif

// Returns agaa_shadowTap() and does not count the tap.
float agaa_uncountedTap(uint map, vec3 p) {
    if (agaa_lightBuffer.shadows[map].layerCount == 0u)
        return 1.0;
#if AGAA_HOST_FOOTPRINTS
    if (agaa_hasFootprintFunction(map))
        return agaa_footprintTap(map, AgaaFootprint(p, vec3(0.0), vec3(0.0), 0.0));
#endif
#ifdef AGAA_HOST_SHADOWS
#if (AGAA_HOST_SHADOWS & ~AGAA_HOST_FOOTPRINTS) != 0
    uint bad = 0u;
    if ((uint(AGAA_HOST_SHADOWS) >> map & 1u) != 0u)
        return agaa_sanitise(agaaHostShadow(map, p), 0.0, 1.0, bad);
#endif
#endif
    return agaa_mapTap(map, p);
}

// Returns the share of light that shadow `map` lets reach p. A shadow that the frame lacks returns 1.
float agaa_shadowTap(uint map, vec3 p) {
    agaa_countTaps(map, 1u);
    return agaa_uncountedTap(map, p);
}

float agaa_visibility[AGAA_MAX_SHADOW_MAPS]; // by shadow map, of the current surface
#if AGAA_LIT
agaa_Surface agaa_litSurface[AGAA_MAX_SHADOW_MAPS]; // the part of it that the lights of these shadows reach
#endif

// Returns whether the visibility is that of the lit surface, not of taps.
bool agaa_isLitShadow(uint map) {
#if AGAA_LIT
    return (AGAA_LIT_SHADOWS >> map & 1u) != 0u;
#else
    return false;
#endif
}

#if AGAA_LIT
// visibility   Share of the light of a lit shadow that reaches the current surface.
// surface      The part of the surface that it reaches.
void agaa_setLitSurface(uint map, float visibility, agaa_Surface surface) {
    // The index is a constant, so that surfaces stay in registers: compilers do not unroll loops over maps.
    for (uint k = 0u; k < AGAA_MAX_SHADOW_MAPS; ++k)
        if (agaa_isLitShadow(k) && map == k) {
            agaa_visibility[k] = visibility;
            agaa_litSurface[k] = surface;
        }
}
#endif

uint agaa_reachingShadows = (1u << AGAA_MAX_SHADOW_MAPS) - 1u; // mask of those whose lights reach the current surface

void agaa_addTaps(vec3 position) {
#if AGAA_SHADOWS
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        if (!agaa_isLitShadow(map) && !agaa_hasFootprintFunction(map) && (agaa_reachingShadows >> map & 1u) != 0u)
            agaa_visibility[map] += agaa_shadowTap(map, position);
#endif
}

// Looks up the shadows that functions of the host find over footprints. Call it after agaa_visibility has the means of
// taps, and when the footprint around the position is known.
void agaa_lookUpFootprint(vec3 position) {
#if AGAA_SHADOWS && AGAA_HOST_FOOTPRINTS
    AgaaFootprint footprint =
        AgaaFootprint(position, agaa_footprint.squares, agaa_footprint.mixed, agaa_depthVariance());
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        if (agaa_hasFootprintFunction(map) && (agaa_reachingShadows >> map & 1u) != 0u) {
            bool isThere = agaa_lightBuffer.shadows[map].layerCount != 0u;
            agaa_visibility[map] = isThere ? agaa_footprintTap(map, footprint) : 1.0;
            agaa_countTaps(map, 1u);
        }
#endif
}

// Mean squared distance of the samples of the current shading event from its position. The inverse square law at a mean
// position has no bound, but its mean over positions has (hard case 65).
float agaa_positionSpread = 0.0;

// Sets the spread. It is at most that of a surface which crosses the pixel: parts of an aggregate at several depths are
// not one surface around a light.
// position   The position of the event, in shading space.
void agaa_setSpread(float spread, vec3 position) {
    float width = agaa_pixelWidth((mat3(agaa_frame.view) * position).z);
    agaa_positionSpread = min(spread, width * width);
}

#if defined(AGAA_HOST_SHADING) || defined(AGAA_RESOLVES_EVENTS)
#define AGAA_DESCRIBES_EVENTS
struct agaa_Event {
    uvec2 pixel;
    uvec4 samples;
    float coverage;
} agaa_event; // that is shaded
#endif

// Describes the event to shading functions of the host and to resolved outputs. samples: that it represents, bits as in
// AgaaSurface.
void agaa_setEvent(uvec2 pixel, uvec4 samples) {
#ifdef AGAA_DESCRIBES_EVENTS
    ivec4 counts = bitCount(samples);
    agaa_event = agaa_Event(pixel, samples, float(counts.x + counts.y + counts.z + counts.w) / float(AGAA_SAMPLES));
#endif
}

// The second moments of the normals of an event that is shaded with means.
agaa_SecondMoments agaa_eventMoments = agaa_SecondMoments(vec3(0.0), vec3(0.0));
#ifdef AGAA_HOST_SHADING
// The mean of its alpha squared, before it is widened.
float agaa_eventAlpha2 = -1.0; // below 0: the event has no means
#endif

// Sets the custom attributes of the event, as layouts store them.
#ifdef AGAA_SHADES_CUSTOM
float agaa_eventCustom[AGAA_SHADES_CUSTOM];
#endif
void agaa_setEventCustom(agaa_Stored v) {
#ifdef AGAA_SHADES_CUSTOM
    for (int i = 0; i < AGAA_SHADES_CUSTOM; ++i)
        agaa_eventCustom[i] = v.custom[i];
#endif
}

// Returns the light that the library's model reflects, for unit radiance.
vec3 agaa_builtInReflect(agaa_Surface s, vec3 toLight, vec3 toEye) {
    uint elliptic = AGAA_NDF >= agaa_ndfLean ? 1u : 0u;
    uint filterDiffuse = agaa_hasFact(AGAA_FACT_NO_DIFFUSE) ? 0u : AGAA_FILTER_DIFFUSE;
    vec3 sggx = vec3(0.0);
    if (filterDiffuse == agaa_diffuseSggx) {
        sggx = clamp(s.diffuse, 0.0, 1.0) * (agaa_sggxCosine(agaa_eventMoments, toEye, toLight) / agaa_pi());
        s.diffuse = vec3(0.0);
    }
    vec3 reflected = agaa_shadeDiffuse(s, toLight, filterDiffuse);
    if (AGAA_HAS_SPECULAR != 0u) {
        vec3 both = agaa_shade(s, toEye, toLight, AGAA_BRDF, filterDiffuse, elliptic);
        reflected = agaa_leavesOut(AGAA_FACT_SPECULAR) ? reflected : both;
    }
    return sggx + reflected;
}

#ifdef AGAA_FINDS_LIGHTS
#include "common/tile_lights.glsl"
void agaa_seekTile(uvec2 pixel) {}
uint agaa_lightWord(uint i) { return agaa_tileLights[i]; }
#elif defined(AGAA_BINDING_LIGHT_MASKS)
layout(std430, AGAA_BINDING_LIGHT_MASKS) readonly buffer agaa_LightMaskBlock { uint words[]; }
agaa_lightMasks;

uint agaa_lightMask = 0u; // index of the first word of the event's tile
void agaa_seekTile(uvec2 pixel) { agaa_lightMask = agaa_lightMaskAt(pixel / 8u); }
uint agaa_lightWord(uint i) { return agaa_lightMasks.words[agaa_lightMask + i]; }
#endif
#if defined(AGAA_FINDS_LIGHTS) || defined(AGAA_BINDING_LIGHT_MASKS)
#define AGAA_CULLS_LIGHTS
// Chooses the lights of the events of this pixel.
void agaa_lightPixel(uvec2 pixel) {
    agaa_seekTile(pixel);
    if (AGAA_LIGHT_WORDS != 0u && AGAA_DEBUG_VIEW != AGAA_DEBUG_VIEW_LIT) // which shows visibility without light, too
        agaa_reachingShadows = agaa_lightWord(AGAA_LIGHT_WORDS);
}
#endif

#ifdef AGAA_HOST_SHADING
#include "common/shade_by_host.glsl"
#else
vec3 agaa_reflect(agaa_Surface s, vec3 position, vec3 toLight, vec3 toEye) {
    return agaa_builtInReflect(s, toLight, toEye);
}
#endif

#if !AGAA_HOST_SHADES_EVENTS
vec3 agaa_oneLight(agaa_Surface s, vec3 position, vec3 toEye, uint index) {
    agaa_GpuLight light = agaa_lightBuffer.lights[index];
    vec3 toLight = -light.direction;
    float intensity = 1.0;
    float directions = 0.0; // variance
    if (light.type != AGAA_LIGHT_DIRECTIONAL && !agaa_hasFact(AGAA_FACT_NO_LOCAL_LIGHTS)) {
        vec3 d = light.position - position;
        if (AGAA_LIGHT_DIRECTIONS != 0u)
            directions = agaa_directionVariance(agaa_footprint, d);
        float d2 = agaa_spreadDistance2(dot(d, d), agaa_positionSpread);
        intensity = agaa_pointAttenuation(d2, light.range, light.radius * light.radius);
        if (intensity <= 0.0)
            return vec3(0.0);
        toLight = agaa_lightDirection(d, light.radius * light.radius);
        if (light.type == AGAA_LIGHT_SPOT)
            intensity *= agaa_spotCone(dot(-toLight, light.direction), light.cosInner, light.cosOuter);
        if (agaa_positionSpread > 0.0)
            toLight =
                agaa_lightDirection(agaa_nearestToLight(d, s.normal, agaa_positionSpread), light.radius * light.radius);
    }
    uint map = light.shadowMap;
    if (map < AGAA_MAX_SHADOW_MAPS)
        intensity *= agaa_visibility[map];
    if (intensity <= 0.0)
        return vec3(0.0);
#if AGAA_LIT
    // The index is a constant, so that surfaces stay in registers.
    for (uint k = 0u; k < AGAA_MAX_SHADOW_MAPS; ++k)
        if (agaa_isLitShadow(k) && map == k)
            s = agaa_litSurface[k];
#endif
    if (AGAA_LIGHT_DIRECTIONS != 0u)
        agaa_addDirectionVariance(s, directions);
    return agaa_reflect(s, position, toLight, toEye) * light.color * intensity;
}

// Sums the lights in the order of the frame, so that culling does not change the result.
vec3 agaa_sumOfLights(agaa_Surface s, vec3 position, vec3 toEye, vec3 sum) {
    const uint count = agaa_lightBuffer.shadows[0].lightCount;
    agaa_count(AGAA_COUNT_LIGHTS, count);
    uint i = 0u;
    do {
        if (i < count)
            sum += agaa_oneLight(s, position, toEye, i);
    } while (++i < count);
    return sum;
}


#ifdef AGAA_CULLS_LIGHTS
vec3 agaa_sumOfReachingLights(agaa_Surface s, vec3 position, vec3 toEye, vec3 sum) {
    uint word = 0u;
    do {
        uint left = agaa_lightWord(word);
        agaa_count(AGAA_COUNT_LIGHTS, uint(bitCount(left)));
        for (; left != 0u; left &= left - 1u)
            sum += agaa_oneLight(s, position, toEye, 32u * word + uint(findLSB(left)));
    } while (++word < agaa_opaque(AGAA_LIGHT_WORDS));
    return sum;
}
#endif

vec3 agaa_allLights(agaa_Surface s, vec3 position, vec3 toEye) {
    vec3 sum = agaa_leavesOut(AGAA_FACT_EMISSIVE) ? vec3(0.0) : s.emissive;
    if (AGAA_HAS_AMBIENT != 0u) {
        vec3 all = s.diffuse + (agaa_leavesOut(AGAA_FACT_SPECULAR) ? vec3(0.0) : s.specular);
        sum += agaa_leavesOut(AGAA_FACT_AMBIENT) ? vec3(0.0) : agaa_frame.ambient * all;
    }
#ifdef AGAA_CULLS_LIGHTS
    if (AGAA_LIGHT_WORDS != 0u)
        return agaa_sumOfReachingLights(s, position, toEye, sum);
#endif
    return agaa_sumOfLights(s, position, toEye, sum);
}
#else
vec3 agaa_allLights(agaa_Surface s, vec3 position, vec3 toEye) { return agaa_shadeByHost(s, position); }
#endif

// Measurements of shading cost repeat the lighting AGAA_SHADING_COST times. agaa_frame.zero keeps compilers from
// merging the repetitions.
vec3 agaa_lightSurface(agaa_Surface s, vec3 position) {
    vec3 toEye = agaa_toEye(position);
    vec3 sum = agaa_allLights(s, position, toEye);
    if (AGAA_SHADING_COST == 1u) // compilers do not remove a loop without iterations, nor the lighting in it
        return sum;
    for (uint i = 1u; i < AGAA_SHADING_COST; ++i)
        sum += agaa_allLights(s, position + float(i) * agaa_frame.zero, toEye);
    return sum / float(AGAA_SHADING_COST);
}
#endif
