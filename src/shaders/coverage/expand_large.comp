// Finds the fragments of large triangles; expand_triangles.comp finds those of small ones. Each workgroup covers a
// block of pixels, each lane a row of it.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "math/light.glsl"
#include "ids/fetch.glsl"
#include "coverage/triangle_words.glsl"
#include "coverage/expanded_triangle.glsl"

void agaa_expandBlock(uint entry, uint block) {
    uint id = agaa_triangles.words[agaa_largeAt(entry)];
    AgaaPrimitive p = agaa_primitive(id);
    agaa_Outline outline = agaa_outlineOf(p);
    vec2 size = vec2(agaa_frame.size);
    agaa_Span rows = agaa_outlineRows(outline, size.y), columns = agaa_outlineColumns(outline, size.x);
    uvec2 first = uvec2(columns.first, rows.first), last = uvec2(columns.last, rows.last);
    uint across = (last.x - first.x) / AGAA_BLOCK_SIDE + 1u;
    first += uvec2(block % across, block / across) * AGAA_BLOCK_SIDE;
    uint y = first.y + gl_LocalInvocationIndex;
    if (y > last.y)
        return;
    agaa_Span span = agaa_outlineSpan(outline, float(y), size.x);
    span.first = max(span.first, float(first.x));
    span.last = min(span.last, float(first.x + AGAA_BLOCK_SIDE - 1u));
    for (float x = span.first; x <= span.last; x += 1.0)
        agaa_expandPixel(id, p, uvec2(uint(x), y));
}

void main() {
    uint block = agaa_groupInRows();
    uint entries = agaa_triangles.words[AGAA_LARGE_LISTED];
    uint entry = agaa_firstSumAbove(block, agaa_largeAt(0u) + 1u, entries, AGAA_LARGE_WORDS);
    if (entry >= entries)
        return;
    agaa_countBegin();
    agaa_expandBlock(entry, block - (entry == 0u ? 0u : agaa_triangles.words[agaa_largeAt(entry - 1u) + 1u]));
    agaa_countEnd();
}
