// Shades one sample of each pixel: the covered one that is nearest to the mean of all in normal and distance. The image
// has its radiance without emission, and in alpha its index + 1, or 0 where no sample is covered.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#define AGAA_MAX_EVENTS 1u
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "gbuffer/gbuffer.glsl"
#include "gbuffer/sample_visibility.glsl"
#include "gbuffer/same_surface.glsl"
#include "common/tile_pixels.glsl"
#include "common/events.glsl"

// The samples that one event represents.
struct agaa_Represented {
    uint covered; // samples with geometry
    uint alike;   // those that show the event's surface
    uint first;   // the event's sample
};

shared uint agaa_representedSamples[64]; // agaa_Represented::alike of each lane's pixel

agaa_Represented agaa_representedOf(uvec2 pixel) {
    agaa_Represented r = agaa_Represented(0u, 0u, 0u);
    vec3 normals = vec3(0.0);
    float depths = 0.0;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isCovered(pixel, i)) {
            agaa_SurfacePoint p = agaa_surfacePoint(pixel, i);
            r.covered |= 1u << i;
            normals += p.normal;
            depths += p.position.z;
        }
    if (r.covered == 0u)
        return r;
    const float count = float(bitCount(r.covered));
    const float meanDepth = depths / count;
    const float unit = max(abs(meanDepth), 1e-20);
    r.first = uint(findLSB(r.covered));
    float nearest = 1e30;
    for (uint rest = r.covered; rest != 0u; rest &= rest - 1u) {
        const uint i = uint(findLSB(rest));
        const agaa_SurfacePoint p = agaa_surfacePoint(pixel, i);
        const vec2 aside = agaa_sampleLocation(i) - 0.5;
        // The last term prefers the middle of the pixel among samples of one surface.
        const float distance = 1.0 - dot(p.normal, normals) / count + abs(p.position.z - meanDepth) / unit +
                               0.01 * dot(aside, aside);
        r.first = distance < nearest ? i : r.first;
        nearest = min(nearest, distance);
    }
    const agaa_SurfacePoint first = agaa_surfacePoint(pixel, r.first);
    for (uint rest = r.covered; rest != 0u; rest &= rest - 1u) {
        const uint i = uint(findLSB(rest));
        r.alike |= agaa_surfaceDifference(first, agaa_surfacePoint(pixel, i)) <= 1.0 ? 1u << i : 0u;
    }
    r.alike |= 1u << r.first;
    return r;
}

// Returns the event's light without its emission, which is the sample's own.
vec3 agaa_shadeEvent(uint lane, uint i) {
    const uvec2 pixel = agaa_pixelOf(lane);
    agaa_findVisibility(pixel, agaa_representedSamples[lane]);
    agaa_findSpread(pixel, i, agaa_representedSamples[lane]);
    agaa_fetchSample(pixel, i);
    agaa_setEventCustom(agaa_fetchedCustom());
    agaa_Surface s = agaa_sampleSurface();
    s.emissive = vec3(0.0);
    return agaa_showsEvents() ? agaa_shownOfEvent(0u, 0.0, s.diffuse)
                              : agaa_lightSurface(s, agaa_samplePosition(pixel, i));
}

void main() {
    agaa_countBegin();
    const uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    agaa_Represented r = agaa_Represented(0u, 0u, 0u);
    const bool isInside = all(lessThan(pixel, agaa_frame.size));
    if (isInside)
        r = agaa_representedOf(pixel);
    agaa_representedSamples[gl_LocalInvocationIndex] = r.alike;
    const uint covered = uint(bitCount(r.covered));
    const agaa_PixelWork work = agaa_pixelWork(covered != 0u ? 1u << r.first : 0u, 0u, covered);
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_countEvents(agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_PIXELS, covered != 0u ? 1u : 0u);
    const vec3 color = agaa_shadeWork(work);
    if (isInside && agaa_showsEvents())
        agaa_writePixel(pixel, work, color * float(covered));
    else if (isInside)
        imageStore(agaa_output, ivec2(pixel),
                   vec4(agaa_representableColor(color), covered != 0u ? float(r.first + 1u) : 0.0));
    agaa_countEnd();
}
