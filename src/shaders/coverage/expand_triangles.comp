// Finds the fragments of triangles without a rasteriser, for the lists of pixels (Wang et al., I3D 2016, section 3.1)
// or for the samples of the target. Each lane fetches a triangle. The lanes of a workgroup then share the rows of
// pixels of its 64 triangles, a number of rows at a time, and the pixels of these rows, so that no lane waits for a
// longer row. Large triangles are listed for expand_large.comp.
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

// Pixels of a triangle's bounds, at most. Software rasterisers of Mesa end all loops of an invocation after 65535
// iterations in total; a pixel of the target has loops over its samples.
const uint agaa_maxPixels = AGAA_COVERS_TARGET == 1 ? 256u : 1024u;

shared vec4 agaa_sharedCorners[64][3];
shared vec2 agaa_sharedOutlines[64][4];
shared uint agaa_sharedCounts[64]; // of the outlines
shared float agaa_sharedHalfWidths[64];
shared uint agaa_sharedIds[64];
shared uint agaa_firstRows[64];
shared uint agaa_rowCounts[64];
shared uint agaa_rowSums[64]; // of a triangle and those before it
const uint agaa_rowsPerLane = 4u;
const uint agaa_rowsAtATime = 64u * agaa_rowsPerLane;
shared uint agaa_rowTriangles[agaa_rowsAtATime];
shared uvec2 agaa_rowPixels[agaa_rowsAtATime]; // the first one
shared uint agaa_pixelSums[agaa_rowsAtATime];  // of a row and those before it
shared uint agaa_laneSums[64];

void agaa_listLarge(uint id, uvec2 first, uvec2 last) {
    uvec2 blocks = (last - first) / AGAA_BLOCK_SIDE + 1u;
    uint at = agaa_largeAt(atomicAdd(agaa_triangles.words[AGAA_LARGE_COUNT], 1u));
    agaa_triangles.words[at] = id;
    agaa_triangles.words[at + 1u] = blocks.x * blocks.y;
}

// Returns the rows of pixels of triangle t that the workgroup expands, and keeps the triangle.
uint agaa_prepareTriangle(uint lane, uint t) {
    if (t >= agaa_triangles.words[AGAA_TRIANGLES_TOTAL])
        return 0u;
    uint draw = agaa_firstSumAbove(t, AGAA_TRIANGLE_SUMS, AGAA_MAX_DRAWS, 1u);
    uint before = draw == 0u ? 0u : agaa_triangles.words[AGAA_TRIANGLE_SUMS + draw - 1u];
    uint id = (draw << AGAA_PRIMITIVE_BITS | t - before) + 1u;
    AgaaPrimitive p = agaa_primitive(id);
    if (agaa_isCulled(p, agaa_drawOf(draw)))
        return 0u;
    agaa_Outline outline = agaa_outlineOf(p);
    if (outline.count == 0u)
        return 0u;
    vec2 size = vec2(agaa_frame.size);
    agaa_Span rows = agaa_outlineRows(outline, size.y), columns = agaa_outlineColumns(outline, size.x);
    if (rows.first > rows.last || columns.first > columns.last)
        return 0u;
    uvec2 first = uvec2(columns.first, rows.first), last = uvec2(columns.last, rows.last);
    if ((last.x - first.x + 1u) * (last.y - first.y + 1u) > agaa_maxPixels) {
        agaa_listLarge(id, first, last);
        return 0u;
    }
    agaa_sharedCorners[lane] = vec4[3](p.a, p.b, p.c);
    agaa_sharedOutlines[lane] = outline.at;
    agaa_sharedCounts[lane] = outline.count;
    agaa_sharedHalfWidths[lane] = outline.halfWidth;
    agaa_sharedIds[lane] = id;
    agaa_firstRows[lane] = first.y;
    return last.y - first.y + 1u;
}

// Returns the triangle of a row: the first one whose sum is greater.
uint agaa_triangleOfRow(uint row) {
    uint k = 0u;
    for (uint size = 32u; size > 0u; size /= 2u)
        k += agaa_rowSums[k + size - 1u] <= row ? size : 0u;
    return k;
}

// Finds the pixels of a row, number i of those at hand. Returns their number.
uint agaa_prepareRow(uint i, uint row) {
    if (row >= agaa_rowSums[63])
        return 0u;
    uint k = agaa_triangleOfRow(row);
    uint y = agaa_firstRows[k] + row - (agaa_rowSums[k] - agaa_rowCounts[k]);
    agaa_Outline outline = agaa_Outline(agaa_sharedOutlines[k], agaa_sharedCounts[k], agaa_sharedHalfWidths[k]);
    agaa_Span span = agaa_outlineSpan(outline, float(y), float(agaa_frame.size.x));
    if (span.first > span.last)
        return 0u;
    agaa_rowTriangles[i] = k;
    agaa_rowPixels[i] = uvec2(uint(span.first), y);
    return uint(span.last) - uint(span.first) + 1u;
}

// Sets agaa_pixelSums for the rows from `first` on.
void agaa_prepareRows(uint lane, uint first) {
    uint sum = 0u;
    for (uint i = lane * agaa_rowsPerLane; i < (lane + 1u) * agaa_rowsPerLane; ++i) {
        sum += agaa_prepareRow(i, first + i);
        agaa_pixelSums[i] = sum;
    }
    agaa_laneSums[lane] = sum;
    barrier();
    uint before = 0u;
    for (uint k = 0u; k < lane; ++k)
        before += agaa_laneSums[k];
    for (uint i = lane * agaa_rowsPerLane; i < (lane + 1u) * agaa_rowsPerLane; ++i)
        agaa_pixelSums[i] += before;
    barrier();
}

void agaa_expandItem(uint item) {
    uint i = 0u; // the first row whose sum is greater
    for (uint size = agaa_rowsAtATime / 2u; size > 0u; size /= 2u)
        i += agaa_pixelSums[i + size - 1u] <= item ? size : 0u;
    uint before = i == 0u ? 0u : agaa_pixelSums[i - 1u];
    uint k = agaa_rowTriangles[i];
    uint id = agaa_sharedIds[k];
    agaa_expandPixel(id, agaa_primitiveAt(id, agaa_sharedCorners[k]), agaa_rowPixels[i] + uvec2(item - before, 0u));
}

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    agaa_rowCounts[lane] = agaa_prepareTriangle(lane, agaa_groupInRows() * 64u + lane);
    barrier();
    uint sum = 0u;
    for (uint k = 0u; k <= lane; ++k)
        sum += agaa_rowCounts[k];
    agaa_rowSums[lane] = sum;
    barrier();
    for (uint first = 0u; first < agaa_rowSums[63]; first += agaa_rowsAtATime) {
        agaa_prepareRows(lane, first);
        for (uint item = lane; item < agaa_pixelSums[agaa_rowsAtATime - 1u]; item += 64u)
            agaa_expandItem(item);
        barrier();
    }
    agaa_countEnd();
}
