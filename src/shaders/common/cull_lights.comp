// Light culling: writes bit masks of the lights that may reach the geometry of each tile of 8 by 8 pixels, and of the
// shadows of these lights.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_COUNTING 0
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/sample_depth.glsl"
#include "common/lights.glsl"
#include "common/tile_lights.glsl"
#include "common/tile_pixels.glsl"

layout(std430, AGAA_BINDING_LIGHT_MASKS) writeonly buffer agaa_LightMaskBlock {
    uint words[];
} agaa_lightMasks;

// Returns false where the sample has no geometry. In targets of the SDK that is the far plane (host/far_plane.glsl).
bool agaa_readDepth(uvec2 pixel, uint i, out float depth) {
#ifdef AGAA_HOST_GBUFFER
    AgaaMaterial material;
    return agaa_readHost(pixel, i, depth, material);
#else
    depth = agaa_depthOf(pixel, i);
    return depth != float(AGAA_FAR_DEPTH);
#endif
}

agaa_Box agaa_boxOfPixel(uvec2 pixel) {
    agaa_Box box = agaa_emptyBox();
    uint i = 0u;
    do {
        float depth;
        bool shows = agaa_readDepth(pixel, i, depth);
        vec3 at = agaa_sampleViewPosition(pixel, i, depth);
        if (shows)
            agaa_addToBox(box, at);
    } while (++i < agaa_sampleCount());
    return box;
}

void main() {
    agaa_beginTileLights();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (agaa_needsTileBox() && all(lessThan(pixel, agaa_frame.size)))
        agaa_addToTile(agaa_boxOfPixel(pixel));
    agaa_findTileLights();
    barrier();
    const uint first = agaa_lightMaskAt(gl_WorkGroupID.xy);
    for (uint i = gl_LocalInvocationIndex; i <= AGAA_LIGHT_WORDS; i += 64u)
        agaa_lightMasks.words[first + i] = agaa_tileLights[i];
}
