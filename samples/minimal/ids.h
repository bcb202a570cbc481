/* What the minimal hosts that fetch materials by id share: their GLSL.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "host.h"

/* Of the visibility pass, in place of materialCode. */
static const char idCode[] =
    "layout(location = 0) in vec3 position;\n"
    "void main() {\n"
    "    AgaaSurfaceInput s = agaa_surfaceInput();\n"
    "    s.position = AGAA_INSIDE(position);\n"
    "    s.primitive = uint(gl_PrimitiveID); // of draw 0, the only one\n"
    "    agaa_emit(s);\n"
    "}\n";

/* The triangles and their materials; an engine's are in buffers and textures, beside the camera. */
#define FETCH_CODE(CAMERA_AT)                                                                                    \
    SCENE_CODE                                                                                                   \
    "layout(std140, " CAMERA_AT ") uniform Camera { mat4 clipFromShading; };\n"                                  \
    "vec4 clipCorner(uint primitive, int corner) {\n"                                                            \
    "    return clipFromShading * vec4(bladeCorner(float(primitive), corner), 1.0);\n"                           \
    "}\n"                                                                                                        \
    "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {\n"             \
    "    a = clipCorner(primitive, 0);\n"                                                                        \
    "    b = clipCorner(primitive, 1);\n"                                                                        \
    "    c = clipCorner(primitive, 2);\n"                                                                        \
    "}\n"                                                                                                        \
    "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) { m.diffuse = bladeColor(float(p.primitive)); }\n"
