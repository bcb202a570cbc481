// Adds the surfaces of shading events to the sums of their pixel, if the view has AgaaResolvedOutputs of surfaces whose
// samples are not in a G-buffer. Needs common/lighting.glsl.
#ifndef AGAA_RESOLVE_EVENT_GLSL
#define AGAA_RESOLVE_EVENT_GLSL
#ifndef AGAA_LIGHTING_GLSL
#error "resolve_event.glsl needs lighting.glsl."
#endif
#include "math/encoding.glsl"
#include "math/ordered_bits.glsl"
#include "math/pixel_sums.glsl"
#ifdef AGAA_RESOLVES_EVENTS
layout(std430, AGAA_BINDING_RESOLVED_SUMS) buffer agaa_ResolvedBlock { uint words[]; } agaa_resolved;
uint agaa_resolvedPixel = 0u; // index of its first word

void agaa_addToSum(uint word, uint amount) { atomicAdd(agaa_resolved.words[agaa_resolvedPixel + word], amount); }
void agaa_raiseSum(uint word, uint least) { atomicMax(agaa_resolved.words[agaa_resolvedPixel + word], least); }
#include "common/resolved_values.glsl"

// Adds the event that agaa_setEvent() and agaa_setEventCustom() describe.
// normal     Mean over its samples.
// position   In shading space.
void agaa_resolveEvent(vec3 normal, vec3 position) {
    ivec4 counts = bitCount(agaa_event.samples);
    uint samples = uint(counts.x + counts.y + counts.z + counts.w);
    agaa_resolvedPixel = (agaa_event.pixel.y * agaa_frame.size.x + agaa_event.pixel.x) * AGAA_RESOLVED_WORDS;
    agaa_addToSum(0u, samples);
    AGAA_ADD_VALUES(float(samples), normal, agaa_eventCustom)
    AGAA_ADD_DEPTHS(float(samples), agaa_depthOfViewZ((mat3(agaa_frame.view) * position).z, agaa_frame.projection22,
                                                      agaa_frame.projection32, agaa_isOrthographic()))
}
#else
void agaa_resolveEvent(vec3 normal, vec3 position) {}
#endif
#endif
