// Accumulates the image over frames whose cameras are jittered (temporal anti-aliasing). The image of earlier frames is
// looked up where each pixel was in the previous frame, rejected where the surface was hidden, and clipped to the
// colours around the pixel (Karis 2014; Salvi 2016).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/output_place.glsl"
#include "common/target.glsl"
#include "common/sample_depth.glsl"
#include "math/history.glsl"

layout(AGAA_BINDING_COLOR) uniform sampler2D agaa_shaded;
#if AGAA_MOTION && !defined(AGAA_HOST_GBUFFER)
layout(AGAA_BINDING_MOTION_X) uniform AGAA_TARGET_TEXTURE agaa_motionX;
layout(AGAA_BINDING_MOTION_Y) uniform AGAA_TARGET_TEXTURE agaa_motionY;
#endif
layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D agaa_output;

// Two images take turns. Two words hold the frames that wrote them; then each pixel has three words: red and green,
// blue and the number of frames, distance.
layout(std430, AGAA_BINDING_HISTORY) buffer agaa_HistoryBlock { uint words[]; } agaa_history;

const float agaa_infinity = 1e30; // distance of pixels without geometry

const int agaa_side = 10;
shared vec4 agaa_pixels[agaa_side * agaa_side]; // compressed colour and distance, with a pixel around the tile

uint agaa_historyAt(ivec2 pixel, uint slot) {
    return 2u + 3u * ((slot * agaa_frame.size.y + uint(pixel.y)) * agaa_frame.size.x + uint(pixel.x));
}

ivec2 agaa_inside(ivec2 pixel) { return clamp(pixel, ivec2(0), ivec2(agaa_frame.size) - 1); }

// Returns the depth of sample 0.
float agaa_pixelDepth(uvec2 pixel) {
#ifdef AGAA_HOST_GBUFFER
    float depth;
    AgaaMaterial material;
    return agaa_readHost(pixel, 0u, depth, material) ? depth : float(AGAA_FAR_DEPTH);
#else
    return agaa_depthOf(pixel, 0u);
#endif
}

bool agaa_isBackground(float depth) { return depth == float(AGAA_FAR_DEPTH); }

#if AGAA_MOTION
vec2 agaa_storedMotion(uvec2 pixel) {
#ifdef AGAA_HOST_GBUFFER
    float depth;
    AgaaMaterial material;
    return agaa_readHost(pixel, 0u, depth, material) ? material.AGAA_MOTION_MEMBER : vec2(0.0);
#else
    return vec2(AGAA_FETCH(agaa_motionX, pixel, 0u)[AGAA_MOTION_X], AGAA_FETCH(agaa_motionY, pixel, 0u)[AGAA_MOTION_Y]);
#endif
}
#endif

void agaa_loadPixels(ivec2 corner) {
    for (uint i = gl_LocalInvocationIndex; i < uint(agaa_side * agaa_side); i += 64u) {
        ivec2 at = agaa_inside(corner + ivec2(i % uint(agaa_side), i / uint(agaa_side)));
        float depth = agaa_pixelDepth(uvec2(at));
        vec3 color = clamp(texelFetch(agaa_shaded, at, 0).rgb, vec3(0.0), vec3(AGAA_MAX_HALF));
        agaa_pixels[i] = vec4(agaa_compressedYCoCg(color),
                              agaa_isBackground(depth) ? agaa_infinity : -agaa_sampleViewZ(depth));
    }
}

vec4 agaa_nearPixel(ivec2 lane) { return agaa_pixels[(lane.y + 1) * agaa_side + lane.x + 1]; }

struct agaa_Previous {
    vec2 motion;    // to where the point was in the previous frame, in pixels
    float distance; // from the previous frame's camera
    bool isKnown;
};

// Returns the direction, in view space, in which sample 0 of the pixel lies.
vec3 agaa_viewDirection(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + agaa_sampleLocation(0u)) / vec2(agaa_frame.size) * 2.0 - 1.0;
    return agaa_viewPosition(ndc, -1.0, agaa_frame.projectionScale.x, agaa_frame.projectionScale.y,
                             agaa_frame.projectionOffset.x, agaa_frame.projectionOffset.y, 0u);
}

// Returns where the previous frame's camera saw the point that sample 0 of the pixel shows.
agaa_Previous agaa_previousOf(ivec2 pixel) {
    float depth = agaa_pixelDepth(uvec2(pixel));
    vec4 point = vec4(agaa_viewPositionAt(uvec2(pixel), agaa_sampleLocation(0u), depth), 1.0);
    if (agaa_isBackground(depth) && agaa_isOrthographic() == 0u) // a direction
        point = vec4(agaa_viewDirection(pixel), 0.0);
    vec4 clip = agaa_frame.previousClip * point;
    agaa_Previous previous;
    previous.isKnown = clip.w > 0.0;
    vec2 now = vec2(pixel) + agaa_sampleLocation(0u) - agaa_frame.jitter;
    vec2 before = (clip.xy / max(clip.w, 1e-20) * 0.5 + 0.5) * vec2(agaa_frame.size);
    previous.motion = before - now;
    previous.distance = agaa_isBackground(depth) ? agaa_infinity : dot(agaa_frame.previousDistance, point);
#if AGAA_MOTION
    vec2 stored = agaa_storedMotion(uvec2(pixel));
    if (stored.x > 0.0 || stored.y > 0.0) {
        previous.motion = vec2(agaa_decodedMotion(stored.x), agaa_decodedMotion(stored.y)) * vec2(agaa_frame.size);
        previous.isKnown = true;
    }
#endif
    return previous;
}

// Returns the pixel of the 3 x 3 around a lane that is nearest to the camera, so that edges move with their surface.
ivec2 agaa_nearestAround(ivec2 lane) {
    ivec2 nearest = ivec2(0);
    float distance = agaa_nearPixel(lane).w;
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        if (agaa_nearPixel(lane + offset).w < distance) {
            distance = agaa_nearPixel(lane + offset).w;
            nearest = offset;
        }
    }
    return nearest;
}

uint agaa_readSlot() { return 1u - agaa_frame.historySlot; }

bool agaa_hasHistory() {
    return agaa_frame.historyStamp != 0u && agaa_history.words[agaa_readSlot()] == agaa_frame.historyStamp;
}

// Returns by how much the distance of a surface may change.
float agaa_slack(float distance) {
    return uintBitsToFloat(AGAA_DEPTH_TOLERANCE) *
           agaa_scaleDistance(distance, agaa_frame.projectionScale.x, agaa_isOrthographic());
}

// Returns whether the distances of the four pixels around a position in the previous frame and those of the 3 x 3
// pixels of this frame have a common range. Surfaces thinner than a pixel show in some frames only. An object that
// moved away from all of them was nearer.
// change   Of the distance since the previous frame.
bool agaa_wasVisible(vec2 at, ivec2 lane, float change) {
    vec2 now = vec2(agaa_infinity, 0.0), before = now; // smallest and largest
    for (int i = 0; i < 9; ++i) {
        float distance = agaa_nearPixel(lane + ivec2(i % 3, i / 3) - 1).w - change;
        now = vec2(min(now.x, distance), max(now.y, distance));
    }
    ivec2 first = ivec2(floor(at - 0.5));
    for (int i = 0; i < 4; ++i) {
        uint word = agaa_historyAt(agaa_inside(first + ivec2(i & 1, i >> 1)), agaa_readSlot());
        float distance = uintBitsToFloat(agaa_history.words[word + 2u]);
        before = vec2(min(before.x, distance), max(before.y, distance));
    }
    return before.y + agaa_slack(before.y) >= now.x && before.x <= now.y + agaa_slack(now.y);
}

// Returns linear light and the number of frames in it.
vec4 agaa_historyColor(vec2 at) {
    ivec2 second = ivec2(floor(at - 0.5));
    vec2 rest = at - 0.5 - vec2(second);
    vec4 across = agaa_catmullRom(rest.x), down = agaa_catmullRom(rest.y);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 16; ++i) {
        uint word = agaa_historyAt(agaa_inside(second + ivec2(i & 3, i >> 2) - 1), agaa_readSlot());
        vec4 texel = vec4(unpackHalf2x16(agaa_history.words[word]), unpackHalf2x16(agaa_history.words[word + 1u]));
        sum += texel * across[i & 3] * down[i >> 2];
    }
    return max(sum, vec4(0.0));
}

// Clips a colour to the mean and the deviation of the colours around the pixel. The box also contains the colour of the
// pixel, so that still images of single pixels stay.
vec3 agaa_clipped(vec3 color, ivec2 lane) {
    vec3 sum = vec3(0.0), squares = vec3(0.0);
    for (int i = 0; i < 9; ++i) {
        vec3 c = agaa_nearPixel(lane + ivec2(i % 3, i / 3) - 1).rgb;
        sum += c;
        squares += c * c;
    }
    vec3 mean = sum / 9.0;
    vec3 deviation = sqrt(max(squares / 9.0 - mean * mean, vec3(0.0)));
    vec3 fromMean = agaa_compressedYCoCg(color) - mean;
    vec3 halfSize = max(uintBitsToFloat(AGAA_CLIP_DEVIATIONS) * deviation, abs(agaa_nearPixel(lane).rgb - mean));
    float share = agaa_shareWithin(fromMean, halfSize * 1.0001);
    return share < 1.0 ? agaa_linearFromCompressed(mean + share * fromMean) : color;
}

// Returns the colour and the number of frames of the pixel in the previous image; the number is 0 if it was not
// visible.
vec4 agaa_before(ivec2 pixel, ivec2 lane) {
    ivec2 nearest = agaa_nearestAround(lane);
    agaa_Previous edge = agaa_previousOf(agaa_inside(pixel + nearest));
    float change = agaa_nearPixel(lane + nearest).w - edge.distance;
    vec2 at = vec2(pixel) + 0.5 + edge.motion;
    bool isInside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, vec2(agaa_frame.size)));
    if (!agaa_hasHistory() || !edge.isKnown || !isInside || !agaa_wasVisible(at, lane, change))
        return vec4(0.0);
    vec4 history = agaa_historyColor(at);
    history.a = max(history.a, 1.0);
    if (uintBitsToFloat(AGAA_CLIP_DEVIATIONS) > 0.0)
        history.rgb = agaa_clipped(history.rgb, lane);
    return history;
}

void agaa_accumulate(ivec2 pixel, ivec2 lane) {
    vec3 color = min(max(texelFetch(agaa_shaded, pixel, 0).rgb, vec3(0.0)), vec3(AGAA_MAX_HALF));
    vec4 before = agaa_before(pixel, lane);
    float share = before.a > 0.0 ? max(uintBitsToFloat(AGAA_CURRENT_SHARE), 1.0 / (before.a + 1.0)) : 1.0;
    vec3 mixed = min(before.rgb + (color - before.rgb) * share, vec3(AGAA_MAX_HALF));
    imageStore(agaa_output, agaa_placeInWritten(pixel), vec4(mixed, 1.0));
    vec4 kept = AGAA_LAST_FRAME_ONLY != 0u ? vec4(color, 1.0) : vec4(mixed, min(1.0 / share, 2048.0));
    uint word = agaa_historyAt(pixel, agaa_frame.historySlot);
    agaa_history.words[word] = packHalf2x16(kept.rg);
    agaa_history.words[word + 1u] = packHalf2x16(kept.ba);
    agaa_history.words[word + 2u] = floatBitsToUint(agaa_nearPixel(lane).w);
}

void main() {
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * 8;
    ivec2 lane = ivec2(gl_LocalInvocationID.xy);
    agaa_loadPixels(corner - 1);
    barrier();
    ivec2 pixel = corner + lane;
    if (all(lessThan(pixel, ivec2(agaa_frame.size))))
        agaa_accumulate(pixel, lane);
    if (gl_GlobalInvocationID.xy == uvec2(0u))
        agaa_history.words[agaa_frame.historySlot] = agaa_frame.frameStamp;
}
