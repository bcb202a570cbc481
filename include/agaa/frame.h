/* What a host draws and hands over each frame. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_FRAME_H
#define AGAA_FRAME_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- host draw passes ----------------------------------------------------------------------- */

typedef enum AgaaDrawPassId {
    AGAA_DRAW_PASS_VISIBILITY = 1, /* depth, and geometric normals or, with the tier IDS, ids */
    AGAA_DRAW_PASS_AGGREGATE = 2,  /* materials, accumulated into aggregates or kept as surfaces; no
                                      colour output */
    AGAA_DRAW_PASS_GBUFFER = 3,    /* materials into a multisampled G-buffer */
    AGAA_DRAW_PASS_FORWARD = 4,    /* materials, shaded in the fragment shader, into a multisampled colour */
    AGAA_DRAW_PASS_MAX_ENUM = 0x7FFFFFFF
} AgaaDrawPassId;

typedef enum AgaaCompare {
    AGAA_COMPARE_LESS = 0,
    AGAA_COMPARE_GREATER = 1,
    AGAA_COMPARE_EQUAL = 2,
    AGAA_COMPARE_ALWAYS = 3,
    AGAA_COMPARE_MAX_ENUM = 0x7FFFFFFF
} AgaaCompare;

/* Fixed-function state that the host's pipelines must have in this pass. Cull mode is the host's
 * choice and must be the same in all passes of a frame. Disable everything else that changes fragments: blending
 * except keepFirst, dithering, logic operations, alpha-to-coverage, sample masks, depth bias, scissor and sRGB
 * conversion. */
typedef struct AgaaDrawState {
    uint32_t depthCompare; /* AgaaCompare */
    uint32_t depthWrite;
    uint32_t stencilTest;  /* 1: pass where stencil EQUAL 0 (mask 0xFF), then INCREMENT_AND_CLAMP */
    uint32_t stencilTestMasked; /* the same for alpha-masked materials */
    uint32_t colorAttachmentCount;
    uint32_t colorWriteMask; /* RGBA bits 1, 2, 4, 8, the same for all attachments */
    uint32_t samples;        /* of the target */
    uint32_t sampleShading;  /* 1: one invocation per sample (minSampleShading 1) */
    uint32_t keepFirst;      /* 1: blend all attachments, colour and alpha alike: source factor ONE_MINUS_DST_ALPHA,
                              * destination factor ONE, operation ADD. A sample keeps what was drawn into it first */
    uint32_t conservative;   /* 1: conservative rasterisation, overestimating: a pixel that a triangle touches has a
                              * fragment (VK_EXT_conservative_rasterization, GL_NV_conservative_raster) */
} AgaaDrawState;

typedef struct AgaaDrawTarget {
    uint32_t pass;          /* AgaaDrawPassId */
    uint32_t width, height; /* viewport and scissor, from (0,0): the scaled target */
    uint32_t scaleX, scaleY; /* sub-pixels per pixel; multiply derivatives by these */
    AgaaDrawState state;
    uint64_t pipelineKey; /* changes when pipelines and shaders of this pass must be rebuilt */
    void* commandBuffer;  /* backend's: VkCommandBuffer, inside rendering; null on OpenGL */
    uint64_t descriptorSet; /* backend's: VkDescriptorSet, bind at the index given at context creation */
    uint32_t framebuffer;   /* backend's: OpenGL's name, to be bound by the host */
    uint32_t batch;         /* of a pass that is drawn in several, which one, from 0 */
} AgaaDrawTarget;

/* Draw the scene's opaque and alpha-masked geometry (AGAA_FETCH_NOT_ALL_DRAWS: see there). The target is cleared, or
 * has the depth of an earlier pass to be equal to. Vulkan: called with rendering
 * begun by the SDK, which also ends it; nothing is bound, viewport and scissor are unset. Commands are
 * recorded inline: the callback executes no command buffers of its own. OpenGL: as at agaaGlRecordFrame.
 * Return AGAA_OK, or any other value to give up the frame. Must not call the SDK. Must not throw: an exception that the
 * SDK can catch counts as AGAA_ERROR_CALLBACK returned. */
typedef AgaaResult(AGAA_CALL* AgaaDrawCallback)(void* user, const AgaaDrawTarget* target);

/* ---- frame ---------------------------------------------------------------------------------- */

typedef enum AgaaLightType {
    AGAA_LIGHT_DIRECTIONAL = 0,
    AGAA_LIGHT_POINT = 1,
    AGAA_LIGHT_SPOT = 2,
    AGAA_LIGHT_MAX_ENUM = 0x7FFFFFFF
} AgaaLightType;

#define AGAA_NO_SHADOW 0xFFFFFFFFu

typedef struct AgaaLight {
    uint32_t type;      /* AgaaLightType */
    uint32_t shadowMap; /* index into AgaaFrame::shadows, or AGAA_NO_SHADOW */
    float position[3];  /* shading space, [-1e18;1e18] */
    float direction[3]; /* unit, the way the light travels, shading space; of a point light finite */
    float color[3];     /* irradiance (directional) or intensity, [0;1e30] */
    float range;        /* (0;1e18], or 0: infinite */
    float cosInner;     /* spot: cosines of the half angles, [-1;1], inner >= outer */
    float cosOuter;
    float radius;       /* of the lamp, [0;1e15]: the inverse-square law stops there */
    float reserved;     /* 0 */
} AgaaLight;

/* A shadow map is a 2D array of depth layers, each with its matrix. A point uses the first layer whose
 * clip volume holds it: one layer is a plain map, several in order of detail are cascades, six are the
 * faces of a cube. Points in no layer are lit. Compared as: lit where depth - bias <= stored. Where an
 * AgaaShadowFunction answers, layerCount is 0 and the rest is not read. */
typedef struct AgaaShadow {
    uint32_t layerCount; /* [1;AGAA_MAX_SHADOW_LAYERS], or 0: by the host's function */
    float depthBias;     /* in the map's depth, [0;1] */
    float matrices[AGAA_MAX_SHADOW_LAYERS][16]; /* shading space to the layer's clip space, z in [0,w] */
} AgaaShadow;

/* Segments of a frame, so that a host can use what one leaves before it records the next. One may be empty: by a
 * technique, or a tier, that has nothing to do there. */
#define AGAA_SEGMENT_PREPASS UINT64_C(0x1)    /* the first geometry pass, into depth or into a G-buffer; with
                                                 AGAA_FETCH_NOT_ALL_DRAWS the second too */
#define AGAA_SEGMENT_GENERATION UINT64_C(0x2) /* what leaves aggregates or surfaces in memory, its material pass too */
#define AGAA_SEGMENT_SHADING UINT64_C(0x4)    /* all that writes the output, and the draw pass FORWARD of "msaa" */
#define AGAA_SEGMENT_ALL UINT64_C(0x7)
/* The camera of a frame is that of its first segment. Lights, shadows, ambient and background are read with
 * AGAA_SEGMENT_SHADING. Earlier segments may still run on the device while a later one is recorded. A frame
 * whose command buffer is discarded counts as completed; figures of it mean nothing: ask for those of a later one. */

typedef struct AgaaFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t frameIndex;     /* increases by at least one each frame, from 1 */
    uint64_t completedFrame; /* newest frame whose GPU work is known to have finished, < frameIndex; 0: none */
    uint64_t segments;       /* AGAA_SEGMENT_…, in order, each once per frame */
    float view[16];       /* shading to view space: a rotation, its translation is zero */
    float projection[16]; /* as the rasteriser uses it, sub-pixel jitter and the y flip of a negative viewport
                             height included. Samples whose depth rounds to that of the far plane, 1 or with
                             AGAA_VIEW_REVERSED_Z 0, show the background. With AGAA_VIEW_REVERSED_Z, where depth does
                             not round to 0, draw nothing at exactly 0 (a sky, say): two geometry passes count it
                             as drawn twice. "msaa" may show the background also where depth is the step of a
                             fixed-point format next to the far plane's */
    uint32_t lightCount;
    uint32_t shadowCount;
    const AgaaLight* lights;
    const AgaaShadow* shadows;
    float ambient[3];    /* radiance from all sides, [0;65504] */
    /* Colour, [0;65504], where nothing is visible. The fourth: 0: what the output holds instead, which needs
     * AGAA_VIEW_COMPOSITE and, on Vulkan, an outputLayoutIn that keeps it; (0;65504]: this colour. The output
     * gets linear colours up to 65504, and 1 as alpha. */
    float background[4];
    AgaaDrawCallback draw; /* null only where the host draws the G-buffer (AgaaGBufferFunction) */
    void* drawUser;
    /* Selects the random numbers by which translucent surfaces cover samples (AgaaSurfaceInput::alphaCutoff is 0); the
     * same in all segments of a frame. 0 in every frame: the pattern stands still. A number that differs between
     * frames: images that are accumulated over frames converge. Cut-outs do not depend on it. */
    uint32_t ditherFrame;
    uint32_t reserved; /* 0 */
} AgaaFrame;
#define AGAA_FRAME_INIT                                                                             \
    {AGAA_STRUCTURE_TYPE_FRAME, (uint32_t)sizeof(AgaaFrame), NULL, 0, 0, AGAA_SEGMENT_ALL,           \
     {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {0}, 0, 0, NULL, NULL,                        \
     {0, 0, 0}, {0, 0, 0, 1}, NULL, NULL, 0, 0}

#ifdef __cplusplus
}
#endif
#endif /* AGAA_FRAME_H */
