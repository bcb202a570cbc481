// SMAA, second pass: follows the edges of each pixel to their ends, and stores the shares of the pixels on both sides
// that lie beyond the line for which the edge stands. Jimenez et al. 2012, sections 4.2 to 4.4. Under jitter the line
// moves against it, as in SMAA T2x (section 4.5): the shares are those of the samples.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "math/edge_shares.glsl"
#define AGAA_EDGES_ACCESS readonly
#define AGAA_READS_EDGES 1
#include "filter/edge_words.glsl"

// A word per pixel with edges: shares of the pixel and of the one above, then of the pixel and of the one to the left.
layout(std430, AGAA_BINDING_SHARES) writeonly buffer agaa_ShareBlock { uint words[]; } agaa_shares;

const int agaa_longestRun = 64;
const uint agaa_mostSteps = 32u;

// The edges along a row or a column, between it and the one across.
struct agaa_Run {
    uint direction;
    int line;
};

uint agaa_crossingWord(agaa_Run run, int word) {
    return agaa_edgeWord(run.direction, 1u, run.line, word) | agaa_edgeWord(run.direction, 1u, run.line - 1, word);
}

// Returns the number of pixels before this one to which the edge extends: no edge crosses on the way.
int agaa_pixelsBefore(agaa_Run run, int at) {
    int count = 0;
    int word = at >> 5, bit = at & 31;
    uint along = agaa_edgeWord(run.direction, 0u, run.line, word);
    for (; count < agaa_longestRun; --word) {
        uint before = agaa_edgeWord(run.direction, 0u, run.line, word - 1);
        uint ends = ~(along << 1u | before >> 31u) | agaa_crossingWord(run, word);
        ends &= 0xFFFFFFFFu >> uint(31 - bit);
        if (ends != 0u)
            return min(count + bit - findMSB(ends), agaa_longestRun);
        count += bit + 1;
        bit = 31;
        along = before;
    }
    return agaa_longestRun;
}

int agaa_pixelsAfter(agaa_Run run, int at) {
    int count = 0;
    int word = (at + 1) >> 5, bit = (at + 1) & 31;
    for (; count < agaa_longestRun; ++word) {
        uint ends = ~agaa_edgeWord(run.direction, 0u, run.line, word) | agaa_crossingWord(run, word);
        ends &= 0xFFFFFFFFu << uint(bit);
        if (ends != 0u)
            return min(count + findLSB(ends) - bit, agaa_longestRun);
        count += 32 - bit;
        bit = 0;
    }
    return agaa_longestRun;
}

// Returns the edges that cross before the pixel `at`, `away` pixels from the edge.
uint agaa_crossingsAt(agaa_Run run, int at, int away) {
    uint here = agaa_hasEdge(run.direction, 1u, run.line + away, at) ? agaa_crossesHere : 0u;
    return here | (agaa_hasEdge(run.direction, 1u, run.line - 1 - away, at) ? agaa_crossesAcross : 0u);
}

vec2 agaa_sharesOfRun(agaa_Run run, int at) {
    int before = agaa_pixelsBefore(run, at);
    int after = agaa_pixelsAfter(run, at);
    int first = at - before, last = at + after + 1;
    float moved = run.direction == agaa_rows ? agaa_frame.jitter.y : agaa_frame.jitter.x;
    return agaa_edgeShares(float(before), float(after), agaa_crossingsAt(run, first, 0),
                           agaa_crossingsAt(run, last, 0), moved) *
           agaa_cornerShares(float(before), float(after), agaa_crossingsAt(run, first, 1),
                             agaa_crossingsAt(run, last, 1));
}

// Returns whether a staircase has step i, counted from the upper edge of the pixel. Staircases rise to the right, or
// to the left if they are mirrored. direction   -1: downward, 1: upward.
bool agaa_hasStep(ivec2 pixel, uint i, int direction, int mirror) {
    int down = int(direction < 0 ? i / 2u : (i + 1u) / 2u);
    ivec2 at = pixel + ivec2(mirror * direction, -direction) * down;
    return (i & 1u) == 0u ? agaa_hasUpperEdge(at) : agaa_hasLeftEdge(mirror < 0 ? at + ivec2(1, 0) : at);
}

uint agaa_stepsOf(ivec2 pixel, int direction, int mirror) {
    uint i = 0u;
    while (i < agaa_mostSteps && agaa_hasStep(pixel, i + 1u, direction, mirror))
        ++i;
    return i;
}

// Returns whether the last step continues as an edge of the same direction.
bool agaa_isDoubled(ivec2 pixel, uint steps, int direction, int mirror) {
    int down = int(direction < 0 ? steps / 2u : (steps + 1u) / 2u);
    ivec2 at = pixel + ivec2(mirror * direction, -direction) * down;
    if ((steps & 1u) == 0u)
        return agaa_hasUpperEdge(at + ivec2(mirror * direction, 0));
    return agaa_hasLeftEdge(at + ivec2(mirror < 0 ? 1 : 0, -direction));
}

vec2 agaa_sharesOfStaircase(ivec2 pixel, int mirror) {
    uint down = agaa_stepsOf(pixel, -1, mirror);
    uint up = agaa_stepsOf(pixel, 1, mirror);
    if (down + up + 1u < agaa_fewestSteps)
        return vec2(0.0);
    vec2 moved = vec2(float(mirror) * agaa_frame.jitter.x, agaa_frame.jitter.y);
    return agaa_diagonalShares(agaa_lowerEnd(down, agaa_isDoubled(pixel, down, -1, mirror)) - moved,
                               agaa_upperEnd(up, agaa_isDoubled(pixel, up, 1, mirror)) - moved);
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return;
    ivec2 at = ivec2(pixel);
    bool hasUpper = agaa_hasUpperEdge(at), hasLeft = agaa_hasLeftEdge(at);
    vec2 above = vec2(0.0), left = vec2(0.0);
    // The left edge of a step that falls to the right belongs to the pixel after the one with the upper edge.
    if (hasLeft && !hasUpper && agaa_hasUpperEdge(at - ivec2(1, 0)) &&
        agaa_sharesOfStaircase(at - ivec2(1, 0), -1) != vec2(0.0))
        hasLeft = false;
    if (hasUpper) {
        above = agaa_sharesOfStaircase(at, 1) + agaa_sharesOfStaircase(at, -1);
        if (above.x + above.y > 0.0) // the pixels of a staircase blend along columns
            hasLeft = false;
        else
            above = agaa_sharesOfRun(agaa_Run(agaa_rows, at.y), at.x);
    }
    if (hasLeft)
        left = agaa_sharesOfRun(agaa_Run(agaa_columns, at.x), at.y);
    agaa_shares.words[pixel.y * agaa_frame.size.x + pixel.x] = packUnorm4x8(vec4(above, left));
}
