/* The scene of the minimal hosts: its shaders, settings, camera and light.
 * SPDX-License-Identifier: MIT
 */
#ifndef SCENE_H
#define SCENE_H

#include "agaa_sdk.h"

enum { width = 320, height = 180, frameCount = 3 };

/* [vertex] */
/* Before it stand the version, VERTEX (the index) and the uniform clipFromShading. All passes share this
 * shader: the material pass tests for the very depth that the prepass left. */
static const char vertexCode[] =
    "const vec3 eye = vec3(0.0, 1.2, 3.0);\n" /* an engine subtracts it on the CPU, in double */
    "const vec3 corners[15] = vec3[](\n"
    "    vec3(-2.60, 0.0, 0.0), vec3(-2.50, 0.0, 0.0), vec3(-0.90, 2.4, 0.2),\n"
    "    vec3(-1.10, 0.0, 0.3), vec3(-1.02, 0.0, 0.3), vec3(-2.00, 2.3, 0.0),\n"
    "    vec3( 0.20, 0.0, 0.0), vec3( 0.26, 0.0, 0.0), vec3( 0.90, 2.5, 0.1),\n"
    "    vec3( 1.60, 0.0, 0.2), vec3( 1.76, 0.0, 0.2), vec3( 0.10, 2.2, 0.0),\n"
    "    vec3(-2.80, 0.6, 0.1), vec3(-2.80, 0.5, 0.1), vec3( 2.80, 1.3, 0.1));\n"
    "const vec3 colors[5] = vec3[](vec3(0.3, 0.7, 0.1), vec3(0.6, 0.7, 0.1), vec3(0.2, 0.5, 0.3),\n"
    "                              vec3(0.7, 0.3, 0.1), vec3(0.6, 0.6, 0.6));\n"
    "layout(location = 0) out vec3 position; // shading space: the world's axes, origin at the eye\n"
    "layout(location = 1) out vec3 normal;\n"
    "layout(location = 2) flat out vec3 color;\n"
    "invariant gl_Position;\n"
    "void main() {\n"
    "    int first = VERTEX / 3 * 3;\n"
    "    position = corners[VERTEX] - eye;\n"
    "    normal = cross(corners[first + 1] - corners[first], corners[first + 2] - corners[first]);\n"
    "    color = colors[VERTEX / 3];\n"
    "    gl_Position = clipFromShading * vec4(position, 1.0);\n"
    "}\n";
/* [/vertex] */
enum { vertexCount = 15 };

/* [material] */
/* Before it stand the version, the pass's extensions and the pass's declarations. */
static const char materialCode[] =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) flat in vec3 color;\n"
    "void main() {\n"
    "    AgaaSurfaceInput s = agaa_surfaceInput();\n"
    "    s.position = AGAA_INSIDE(position);\n"
    "    s.geometricNormal = agaa_planeNormal(position);\n"
    "#if AGAA_NEEDS_MATERIAL\n"
    "    s.diffuse = color;\n"
    "    s.normal = normalize(AGAA_INSIDE(normal));\n"
    "#endif\n"
    "    agaa_emit(s);\n"
    "}\n";
/* [/material] */

/* [settings] */
/* Counters are for integration: they show what AgaaFrameStatistics tells, and cost time. */
static AgaaConfig sceneConfig(void) {
    AgaaConfig config = AGAA_CONFIG_INIT; /* "agaa" */
    config.samples = 8;
    config.aggregates = 2;
    config.flags = AGAA_CONFIG_COUNTERS;
    return config;
}

/* What the scene has: the plan leaves out all else. */
static AgaaSceneFacts sceneFacts(void) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = AGAA_FACT_AMBIENT;
    facts.maxLights = 1;
    facts.shadowMapCount = 0;
    return facts;
}
/* [/settings] */

/* [frame] */
/* The projection is the one that the vertex shader uses. Its y points down, so that row 0 of the output is
 * the top of the image; near and far plane are at clip z = nearZ and 1. */
static AgaaFrame sceneFrame(float nearZ) {
    static const AgaaLight sun = {.type = AGAA_LIGHT_DIRECTIONAL,
                                  .shadowMap = AGAA_NO_SHADOW,
                                  .direction = {0.0f, -0.6f, -0.8f},
                                  .color = {3.0f, 2.9f, 2.7f}};
    const float focal = 1.7320508f; /* a field of view of 60 degrees */
    const float nearest = 0.1f, farthest = 100.0f, depth = farthest - nearest;
    AgaaFrame frame = AGAA_FRAME_INIT; /* the view matrix is the identity: along -z */
    frame.projection[0] = focal * height / width;
    frame.projection[5] = -focal;
    frame.projection[10] = (nearZ * nearest - farthest) / depth;
    frame.projection[11] = -1.0f;
    frame.projection[14] = (nearZ - 1.0f) * nearest * farthest / depth;
    frame.lights = &sun;
    frame.lightCount = 1;
    frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 0.1f;
    frame.background[0] = 0.02f;
    frame.background[1] = 0.03f;
    frame.background[2] = 0.05f;
    return frame;
}
/* [/frame] */

#endif
