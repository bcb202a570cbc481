/* The GLSL that the minimal hosts with a G-buffer of their own share.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "host.h"

enum { samples = 4, diffuseImage = 0, normalImage, depthImage, imageCount };

/* The G-buffer pass belongs to the host: it has any layout and any state, and uses no declarations of the SDK. */
static const char gbufferCode[] = "layout(location = 1) flat in vec3 color;\n"
                                  "layout(location = 0) out vec4 diffuse;\n"
                                  "layout(location = 1) out vec4 normal; // w: there is geometry\n"
                                  "void main() {\n"
                                  "    diffuse = vec4(color, 0.0);\n"
                                  "    normal = vec4(0.0, 0.0, 1.0, 1.0); // the blades face the camera\n"
                                  "}\n";

/* The SDK's passes read a sample of the G-buffer through this function. */
#define SAMPLE_CODE(DIFFUSE_AT, NORMAL_AT, DEPTH_AT)                                                                   \
    "layout(" DIFFUSE_AT ") uniform sampler2DMS diffuse;\n"                                                            \
    "layout(" NORMAL_AT ") uniform sampler2DMS normal;\n"                                                              \
    "layout(" DEPTH_AT ") uniform sampler2DMS depth;\n"                                                                \
    "bool agaaHostSample(uvec2 pixel, uint i, inout float z, inout AgaaMaterial m) {\n"                                \
    "    vec4 n = texelFetch(normal, ivec2(pixel), int(i));\n"                                                         \
    "    z = texelFetch(depth, ivec2(pixel), int(i)).x;\n"                                                             \
    "    m.diffuse = texelFetch(diffuse, ivec2(pixel), int(i)).rgb;\n"                                                 \
    "    m.normal = n.xyz;\n"                                                                                          \
    "    return n.w > 0.0;\n"                                                                                          \
    "}\n"
