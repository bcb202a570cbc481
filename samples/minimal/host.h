/* The parts that the minimal hosts share: errors, the scene, the SDK's statistics and the image file. Headers that
 * minimal_cpp.cpp includes are C99 and C++17.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "agaa_sdk.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { width = 320, height = 180, frameCount = 3, maxPasses = 4, vertexCount = 15, drawCount = 2 };

/* The first three blades are draw 0, the other two are draw 1. */
static const uint32_t drawBegin[drawCount + 1] = {0, 9, vertexCount};

/* Ends the program with a sentence if the condition is not met. An engine would return the error. */
static void require(int isMet, const char* sentence) {
    if (isMet)
        return;
    fprintf(stderr, "%s\n", sentence);
    exit(EXIT_FAILURE);
}

/* Results below 0 are errors, in the SDK and in Vulkan. */
#define CHECK(call) require((call) >= 0, #call " failed.")

/* The SDK's sentences begin with the name of the function that failed. */
static void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message) {
    (void)user, (void)code;
    if (severity >= AGAA_SEVERITY_ERROR)
        fprintf(stderr, "%s\n", message);
}

/* Five crossing blades in shading space, which has the world's axes and its origin at the eye. An engine subtracts
 * the eye on the CPU, in double precision. */
#define SCENE_CODE                                                                                                     \
    "vec2 corner(float i, int k) { return k < 2 ? vec2(i - 2.0 + 0.1 * float(k), 0.0) : vec2(1.6 - 0.8 * i, 2.4); }\n" \
    "vec3 bladeCorner(float i, int k) { return vec3(corner(i, k), 0.1 * i) - vec3(0.0, 1.2, 3.0); }\n"                 \
    "vec3 bladeColor(float i) { return vec3(0.2 + 0.1 * i, 0.7 - 0.1 * i, 0.1); }\n"

/* The vertex shader, after the macro VERTEX (the vertex index) and the uniform clipFromShading. All passes share it,
 * because their depths must be equal. */
static const char vertexCode[] =
    SCENE_CODE "layout(location = 0) out vec3 position;\n"
               "layout(location = 1) flat out vec3 color;\n"
               "invariant gl_Position;\n"
               "void main() {\n"
               "    position = bladeCorner(float(VERTEX / 3), VERTEX % 3), color = bladeColor(float(VERTEX / 3));\n"
               "    gl_Position = clipFromShading * vec4(position, 1.0);\n"
               "}\n";

/* The fragment shader, after the version, the pass's extensions and the pass's declarations. */
static const char materialCode[] = "layout(location = 0) in vec3 position;\n"
                                   "layout(location = 1) flat in vec3 color;\n"
                                   "void main() {\n"
                                   "    AgaaSurfaceInput s = agaa_surfaceInput();\n"
                                   "    s.position = AGAA_INSIDE(position);\n"
                                   "    s.geometricNormal = agaa_planeNormal(position);\n"
                                   "#if AGAA_NEEDS_MATERIAL\n"
                                   "    s.diffuse = color; // the normal stays (0, 0, 1): the blades face the camera\n"
                                   "#endif\n"
                                   "    agaa_emit(s);\n"
                                   "}\n";

/* Describes the view: the settings, and the facts of the scene. The plan drops all effects that the facts do not
 * name. */
static AgaaViewDesc describeView(void) {
    static AgaaConfig config = AGAA_CONFIG_INIT; /* "agaa", 8 samples, 2 aggregates */
    static AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    config.flags = AGAA_CONFIG_COUNTERS; /* counters help with an integration (AgaaFrameStatistics), but cost time */
    facts.flags = 0;                     /* AGAA_FACT_...: no specular light, no ambient light, no emission */
    facts.maxLights = 1;
    facts.shadowMapCount = 0;
    desc.width = width, desc.height = height;
    desc.config = &config, desc.facts = &facts;
    return desc;
}

/* Describes a frame. y points down, so that row 0 of the output is the top of the image. The near plane is at clip z
 * = nearZ, the far plane at 1. */
static AgaaFrame describeFrame(uint64_t frameIndex, float nearZ) {
    static AgaaLight sun = AGAA_LIGHT_INIT; /* directional, without a shadow map */
    const float focal = 1.7320508f;         /* vertical field of view of 60 degrees */
    const float nearest = 0.1f, farthest = 100.0f, depth = farthest - nearest;
    AgaaFrame frame = AGAA_FRAME_INIT; /* the view matrix is the identity: the camera looks along -z */
    sun.direction[1] = -0.6f, sun.direction[2] = -0.8f;
    sun.color[0] = 3.0f, sun.color[1] = 2.9f, sun.color[2] = 2.7f;
    frame.frameIndex = frameIndex;
    frame.completedFrame = frameIndex - 1; /* the host waited for the previous frame */
    frame.projection[0] = focal * (float)height / (float)width;
    frame.projection[5] = -focal;
    frame.projection[10] = (nearZ * nearest - farthest) / depth;
    frame.projection[11] = -1.0f;
    frame.projection[14] = (nearZ - 1.0f) * nearest * farthest / depth;
    frame.lights = &sun;
    frame.lightCount = 1;
    return frame;
}

static void reportFrame(AgaaView view, uint64_t frameIndex) {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    require(agaaGetFrameStatistics(view, frameIndex, &statistics) == AGAA_OK, "A frame has no statistics.");
    printf("frame %" PRIu64 ": visible %" PRIu64 " once %" PRIu64 " shadingEvents %" PRIu64 "\n", frameIndex,
           statistics.counters.visible, statistics.counters.once, statistics.counters.shadingEvents);
    CHECK(agaaValidateFrame(view, frameIndex, &validation));
    require(validation.isValid, validation.explanation);
}

/* Writes linear RGBA pixels, row 0 on top, as a binary PPM file in sRGB. */
static void writeImage(const char* path, const float* pixels) {
    FILE* file = fopen(path, "wb");
    require(file != NULL, "The image cannot be opened for writing.");
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int i = 0; i < width * height * 3; ++i) {
        const float linear = fminf(fmaxf(pixels[i / 3 * 4 + i % 3], 0.0f), 1.0f);
        const float coded = linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
        fputc((int)(coded * 255.0f + 0.5f), file);
    }
    require(!ferror(file) && fclose(file) == 0, "The image could not be written.");
}
