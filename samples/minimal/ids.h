/* The parts that the minimal hosts with materials by id share: the geometry in a buffer, and the GLSL.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "host.h"

#include <string.h>

/* The geometry as an engine stores it: a table of draws, and the vertices of all draws. The vertex shader and the
 * fetch functions read the same buffer. */
typedef struct Geometry {
    float camera[16]; /* shading space to clip space */
    struct {
        uint32_t firstVertex, primitiveCount, unused[2];
    } draws[drawCount];
    struct {
        float position[4], color[4];
    } vertices[vertexCount];
} Geometry;

/* Returns the scene of SCENE_CODE. */
static Geometry describeGeometry(float nearZ) {
    const AgaaFrame frame = describeFrame(1, nearZ); /* all frames have the same camera */
    Geometry geometry = {0};
    memcpy(geometry.camera, frame.projection, sizeof geometry.camera);
    for (int i = 0; i < drawCount; ++i) {
        geometry.draws[i].firstVertex = drawBegin[i];
        geometry.draws[i].primitiveCount = (drawBegin[i + 1] - drawBegin[i]) / 3;
    }
    for (int i = 0; i < vertexCount; ++i) {
        const float blade = (float)(i / 3), k = (float)(i % 3);
        float* position = geometry.vertices[i].position;
        float* color = geometry.vertices[i].color;
        position[0] = k < 2 ? blade - 2.0f + 0.1f * k : 1.6f - 0.8f * blade;
        position[1] = k < 2 ? -1.2f : 1.2f;
        position[2] = 0.1f * blade - 3.0f;
        color[0] = 0.2f + 0.1f * blade, color[1] = 0.7f - 0.1f * blade, color[2] = 0.1f;
    }
    return geometry;
}

#define GEOMETRY_CODE(AT)                                                                                              \
    "struct Vertex { vec4 position, color; };\n"                                                                       \
    "layout(std430, " AT ") readonly buffer Geometry { mat4 camera; uvec4 draws[2]; Vertex vertices[]; };\n"

/* Replaces vertexCode. VERTEX and DRAW, the number of the draw, must be defined before. */
#define ID_VERTEX_CODE(AT)                                                                                             \
    GEOMETRY_CODE(AT)                                                                                                  \
    "layout(location = 0) out vec3 position;\n"                                                                        \
    "layout(location = 1) flat out uint number;\n"                                                                     \
    "invariant gl_Position;\n"                                                                                         \
    "void main() {\n"                                                                                                  \
    "    position = vertices[VERTEX].position.xyz, number = DRAW;\n"                                                   \
    "    gl_Position = camera * vec4(position, 1.0);\n"                                                                \
    "}\n"

/* Replaces materialCode in the visibility pass. */
static const char idCode[] = "layout(location = 0) in vec3 position;\n"
                             "layout(location = 1) flat in uint number;\n"
                             "void main() {\n"
                             "    AgaaSurfaceInput s = agaa_surfaceInput();\n"
                             "    s.position = AGAA_INSIDE(position);\n"
                             "    s.draw = number;\n"
                             "    s.primitive = uint(gl_PrimitiveID); // counts from 0 in each draw\n"
                             "    agaa_emit(s);\n"
                             "}\n";

/* Provides triangles and their materials. The material of an engine would read textures. */
#define FETCH_CODE(AT)                                                                                                 \
    GEOMETRY_CODE(AT)                                                                                                  \
    "uint firstVertex(uint draw, uint primitive) { return draws[draw].x + 3u * primitive; }\n"                         \
    "vec4 clipPosition(uint vertex) {\n"                                                                               \
    "    precise vec4 clip = camera * vec4(vertices[vertex].position.xyz, 1.0);\n"                                     \
    "    return clip;\n"                                                                                               \
    "}\n"                                                                                                              \
    "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {\n"                   \
    "    uint first = firstVertex(draw, primitive);\n"                                                                 \
    "    a = clipPosition(first);\n"                                                                                   \
    "    b = clipPosition(first + 1u);\n"                                                                              \
    "    c = clipPosition(first + 2u);\n"                                                                              \
    "}\n"                                                                                                              \
    "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {\n"                                                 \
    "    uint first = firstVertex(p.draw, p.primitive);\n"                                                             \
    "    m.diffuse = p.at.x * vertices[first].color.rgb + p.at.y * vertices[first + 1u].color.rgb\n"                   \
    "              + p.at.z * vertices[first + 2u].color.rgb;\n"                                                       \
    "}\n"

/* Follows FETCH_CODE in hosts that draw nothing: provides the number of triangles of each draw. */
#define TRIANGLES_CODE                                                                                                 \
    "#ifdef AGAA_EXPANDS_TRIANGLES\n"                                                                                  \
    "void agaaHostDraw(uint draw, inout AgaaDraw d) { d.primitives = draws[draw].y; }\n"                               \
    "#endif\n"
