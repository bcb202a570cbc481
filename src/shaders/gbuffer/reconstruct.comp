// Gives each sample of a G-buffer the light of a shading event of its surface, and resolves the samples (subpixel
// reconstruction, Chajdas et al. 2011). shade_one.comp has shaded one sample of each pixel. A sample takes its own
// pixel's event if this shows its surface with a similar reflectance, otherwise the mean of the events around that show
// its surface, otherwise the most similar event. Light moves to the sample's own reflectance, so that textures are not
// blurred.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/output.glsl"
#include "gbuffer/gbuffer.glsl"
#include "gbuffer/same_surface.glsl"

layout(AGAA_BINDING_FIRST_SAMPLES) uniform sampler2D agaa_shaded;

const int agaa_side = 10; // a tile with a pixel around it
const int agaa_eventCount = agaa_side * agaa_side;
shared vec4 agaa_eventPositions[agaa_eventCount]; // in view space; w: 1, or 0 without an event
shared vec4 agaa_eventNormals[agaa_eventCount];   // in view space; w: x of the sample in pixels from the tile's corner
shared vec4 agaa_eventLights[agaa_eventCount];    // radiance without emission; w: y of the sample
shared vec3 agaa_eventColors[agaa_eventCount];    // agaa_reflectance()

vec3 agaa_reflectance(agaa_Surface s) { return s.diffuse + s.specular; }

void agaa_loadEvent(uint at, ivec2 offset) {
    const ivec2 pixel = ivec2(gl_WorkGroupID.xy) * 8 + offset;
    agaa_eventPositions[at] = vec4(0.0);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(agaa_frame.size))))
        return;
    const vec4 texel = texelFetch(agaa_shaded, pixel, 0);
    if (texel.a == 0.0)
        return;
    const uint i = uint(texel.a) - 1u;
    const agaa_SurfacePoint p = agaa_surfacePoint(uvec2(pixel), i);
    const agaa_Surface s = agaa_sampleSurface();
    const vec2 place = vec2(offset) + agaa_sampleLocation(i);
    agaa_eventPositions[at] = vec4(p.position, 1.0);
    agaa_eventNormals[at] = vec4(p.normal, place.x);
    agaa_eventLights[at] = vec4(texel.rgb, place.y);
    agaa_eventColors[at] = agaa_reflectance(s);
}

int agaa_eventAt(ivec2 lane, int neighbour) {
    return (lane.y + neighbour / 3) * agaa_side + lane.x + neighbour % 3;
}

float agaa_differenceOfEvent(agaa_SurfacePoint p, int at) {
    return agaa_surfaceDifference(p, agaa_SurfacePoint(agaa_eventPositions[at].xyz, agaa_eventNormals[at].xyz));
}

// Returns the reflectance by that of the event. The light of dark events is mostly highlights, which do not scale.
vec3 agaa_ratioTo(int at, vec3 color) {
    const float dark = 0.002; // below it, ratios of reflectances are mostly rounding
    return (color + dark) / (agaa_eventColors[at] + dark);
}

// Returns the light of the event on a surface of this reflectance.
vec3 agaa_lightOf(int at, vec3 color) { return agaa_eventLights[at].rgb * min(agaa_ratioTo(at, color), vec3(16.0)); }

// Returns 1 for equal reflectances, and less the more a channel differs.
float agaa_likenessOf(int at, vec3 color) {
    const vec3 ratio = agaa_ratioTo(at, color);
    const vec3 likeness = min(ratio, 1.0 / ratio);
    return min(likeness.x, min(likeness.y, likeness.z));
}

const int agaa_ownEvent = 4;
const float agaa_similar = 0.25; // likeness of reflectances at which light is not looked for elsewhere

// Returns the radiance of a covered sample.
vec3 agaa_reconstructed(uvec2 pixel, uint i, ivec2 lane) {
    const agaa_SurfacePoint p = agaa_surfacePoint(pixel, i);
    const agaa_Surface s = agaa_sampleSurface();
    const vec3 color = agaa_reflectance(s);
    const vec2 place = vec2(lane) + agaa_sampleLocation(i);
    int nearest = agaa_eventAt(lane, agaa_ownEvent);
    float least = agaa_differenceOfEvent(p, nearest);
    vec4 sum = vec4(agaa_lightOf(nearest, color), 1.0);
    if (least > 1.0 || agaa_likenessOf(nearest, color) < agaa_similar) {
        sum = vec4(0.0);
        for (int k = 0; k < 9; ++k) {
            const int at = agaa_eventAt(lane, k);
            if (agaa_eventPositions[at].w == 0.0)
                continue;
            const float difference = agaa_differenceOfEvent(p, at);
            nearest = difference < least ? at : nearest;
            least = min(least, difference);
            const vec2 away = vec2(agaa_eventNormals[at].w, agaa_eventLights[at].w) - place;
            const float weight = difference <= 1.0 ? agaa_likenessOf(at, color) / (0.1 + dot(away, away)) : 0.0;
            sum += weight * vec4(agaa_lightOf(at, color), 1.0);
        }
        if (sum.a == 0.0)
            sum = vec4(agaa_lightOf(nearest, color), 1.0);
    }
    return sum.rgb / sum.a + s.emissive;
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    for (uint at = gl_LocalInvocationIndex; at < uint(agaa_eventCount); at += 64u)
        agaa_loadEvent(at, ivec2(at % uint(agaa_side), at / uint(agaa_side)) - 1);
    barrier();
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return;
    vec3 sum = vec3(0.0);
    uint covered = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isCovered(pixel, i)) {
            sum += agaa_weightedLight(agaa_reconstructed(pixel, i, ivec2(gl_LocalInvocationID.xy)));
            ++covered;
        }
    agaa_writeOutput(pixel, sum / float(AGAA_SAMPLES), covered);
}
