// Shading by a function of the host, and what it may call. Needs common/host_shading.glsl, the host's text and what
// common/lighting.glsl declares before it includes this file.
#ifndef AGAA_SHADE_BY_HOST_GLSL
#define AGAA_SHADE_BY_HOST_GLSL
#ifndef AGAA_HOST_SHADING_GLSL
#error "shade_by_host.glsl needs host_shading.glsl."
#endif

// Returns the moments of normals that spread equally in all directions, and whose mean has this length.
agaa_SecondMoments agaa_roundMoments(vec3 normal, float meanLength) {
    float along = meanLength * meanLength;
    float across = 0.5 * (1.0 - along);
    return agaa_SecondMoments(across + (along - across) * normal * normal,
                              (along - across) * normal.yzx * normal.zxy);
}

// isPart   The surface is the part of an event that a light reaches. Its own moments are not kept.
AgaaSurface agaa_surfaceForHost(agaa_Surface s, vec3 position, bool isPart) {
    AgaaSurface surface;
    surface.diffuse = agaa_hasFact(AGAA_FACT_NO_DIFFUSE) ? vec3(0.0) : s.diffuse;
    surface.specular = AGAA_HAS_SPECULAR == 0u || agaa_leavesOut(AGAA_FACT_SPECULAR) ? vec3(0.0) : s.specular;
    surface.emissive = agaa_leavesOut(AGAA_FACT_EMISSIVE) ? vec3(0.0) : s.emissive;
    surface.normal = s.normal;
    surface.normalLength = s.meanLength;
    surface.alpha2 = s.alpha2;
    surface.alpha2Along = max(s.alpha2Along, s.alpha2);
    surface.axis = s.alpha2Along > s.alpha2 ? s.axis : vec3(0.0);
    bool hasMeans = agaa_eventAlpha2 >= 0.0 && AGAA_HAS_SPECULAR != 0u && !isPart;
    agaa_SecondMoments moments = agaa_roundMoments(s.normal, s.meanLength);
    if (hasMeans && AGAA_NDF >= agaa_ndfLean)
        moments = agaa_eventMoments;
    surface.materialAlpha2 = hasMeans ? agaa_eventAlpha2 : s.alpha2;
    surface.normalSquares = moments.squares;
    surface.normalProducts = moments.mixed;
    surface.position = position;
    surface.positionSpread = agaa_positionSpread;
    surface.positionSquares = agaa_footprint.squares;
    surface.positionProducts = agaa_footprint.mixed;
    surface.depthVariance = agaa_depthVariance();
    surface.pixel = agaa_event.pixel;
    surface.samples = agaa_event.samples;
    surface.coverage = agaa_event.coverage;
    surface.shadows = AGAA_SHADOWS != 0 ? agaa_reachingShadows & ((1u << AGAA_SHADOW_MAPS) - 1u) : 0u;
#ifdef AGAA_SHADES_CUSTOM
    agaa_Stored stored;
    for (int i = 0; i < AGAA_SHADES_CUSTOM; ++i)
        stored.custom[i] = agaa_eventCustom[i];
    AGAA_LOAD_CUSTOM(stored, surface)
#endif
    return surface;
}

// Round lobes have no axis, and any is right for them.
agaa_Surface agaa_surfaceFromHost(AgaaSurface s) {
    vec3 axis, across;
    agaa_viewBasis(s.normal, axis, across);
    axis = dot(s.axis, s.axis) > 0.0 ? s.axis : axis;
    return agaa_Surface(s.diffuse, s.specular, s.emissive, s.normal, s.normalLength, s.alpha2, s.alpha2Along, axis);
}

// Contains values that are not finite, and counts their event.
vec3 agaa_contained(vec3 color) {
    uint bad = 0u;
    color = agaa_sanitise3(color, 0.0, AGAA_MAX_FLOAT, bad);
    agaa_count(AGAA_COUNT_SANITISED, bad);
    return color;
}

vec3 agaaToEye(vec3 position) { return agaa_toEye(position); }

vec3 agaaAmbient() {
    return AGAA_HAS_AMBIENT == 0u || agaa_leavesOut(AGAA_FACT_AMBIENT) ? vec3(0.0) : agaa_frame.ambient;
}

vec3 agaaBuiltInReflect(AgaaSurface surface, vec3 toLight, vec3 toEye) {
    return agaa_builtInReflect(agaa_surfaceFromHost(surface), toLight, toEye);
}

float agaaShadow(uint shadow) {
    float share = 1.0;
#if AGAA_SHADOWS
    // The index is a constant, so that shares stay in registers.
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        share = map == shadow ? agaa_visibility[map] : share;
#endif
    return share;
}

float agaaShadowAt(uint shadow, vec3 position) {
    return AGAA_SHADOWS != 0 && shadow < AGAA_SHADOW_MAPS ? agaa_shadowTap(shadow, position) : 1.0;
}

AgaaSurface agaaLitPart(AgaaSurface surface, AgaaIncidentLight light) {
#if AGAA_LIT
    for (uint k = 0u; k < AGAA_MAX_SHADOW_MAPS; ++k)
        if (agaa_isLitShadow(k) && light.shadow == k)
            surface = agaa_surfaceForHost(agaa_litSurface[k], surface.position, true);
#endif
    return surface;
}

AgaaLights agaaLights() { return AgaaLights(0u, 0u); }

// Finds the number of the next light. `word` is the number of the next word of masks, or of the next light without
// masks. A search for a light that reaches the event would be a loop in the host's loop, which lanes leave at different
// lights.
bool agaa_nextIndex(inout AgaaLights lights, out uint index) {
#ifdef AGAA_CULLS_LIGHTS
    if (AGAA_LIGHT_WORDS != 0u) {
        while (lights.left == 0u && lights.word < agaa_opaque(AGAA_LIGHT_WORDS)) {
            lights.left = agaa_lightWord(lights.word);
            agaa_count(AGAA_COUNT_LIGHTS, uint(bitCount(lights.left)));
            ++lights.word;
        }
        bool isThere = lights.left != 0u;
        index = 32u * (lights.word - 1u) + uint(findLSB(lights.left));
        lights.left &= lights.left - 1u;
        return isThere;
    }
#endif
    index = lights.word;
    bool isThere = index < agaa_lightBuffer.shadows[0].lightCount;
    agaa_count(AGAA_COUNT_LIGHTS, isThere ? 1u : 0u);
    lights.word += isThere ? 1u : 0u;
    return isThere;
}

// How a light reaches an event, as in agaa_oneLight(). They are two, because agaa_oneLight() with this function takes 8
// registers more on AMD GPUs.
struct agaa_Incidence {
    vec3 toLight;
    float intensity; // 0 if it does not
};

// normal   Of the event.
agaa_Incidence agaa_incidenceOf(agaa_GpuLight light, vec3 position, vec3 normal) {
    vec3 toLight = -light.direction;
    float intensity = 1.0;
    if (light.type != AGAA_LIGHT_DIRECTIONAL && !agaa_hasFact(AGAA_FACT_NO_LOCAL_LIGHTS)) {
        vec3 d = light.position - position;
        float d2 = agaa_spreadDistance2(dot(d, d), agaa_positionSpread);
        intensity = agaa_pointAttenuation(d2, light.range, light.radius * light.radius);
        if (intensity <= 0.0)
            return agaa_Incidence(toLight, 0.0);
        toLight = agaa_lightDirection(d, light.radius * light.radius);
        if (light.type == AGAA_LIGHT_SPOT)
            intensity *= agaa_spotCone(dot(-toLight, light.direction), light.cosInner, light.cosOuter);
        if (agaa_positionSpread > 0.0)
            toLight =
                agaa_lightDirection(agaa_nearestToLight(d, normal, agaa_positionSpread), light.radius * light.radius);
    }
    uint map = light.shadowMap;
    if (map < AGAA_MAX_SHADOW_MAPS)
        intensity *= agaa_visibility[map];
    return agaa_Incidence(toLight, intensity);
}

bool agaaNextLight(inout AgaaLights lights, AgaaSurface surface, out AgaaIncidentLight light) {
    light = AgaaIncidentLight(vec3(0.0), vec3(0.0), 0u, 0u);
    bool isThere = agaa_nextIndex(lights, light.index);
    if (isThere) {
        agaa_GpuLight found = agaa_lightBuffer.lights[light.index];
        agaa_Incidence incidence = agaa_incidenceOf(found, surface.position, surface.normal);
        light.toLight = incidence.toLight;
        light.radiance = found.color * max(incidence.intensity, 0.0);
        light.shadow = found.shadowMap;
    }
    return isThere;
}

#if !AGAA_HOST_SHADES_EVENTS
vec3 agaa_reflect(agaa_Surface s, vec3 position, vec3 toLight, vec3 toEye) {
    return agaa_contained(agaaReflect(agaa_surfaceForHost(s, position, AGAA_LIT != 0), toLight, toEye));
}
#else
vec3 agaa_shadeByHost(agaa_Surface s, vec3 position) {
    return agaa_contained(agaaShade(agaa_surfaceForHost(s, position, false)));
}
#endif
#endif
