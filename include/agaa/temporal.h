/* Accumulation over frames. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_TEMPORAL_H
#define AGAA_TEMPORAL_H

#include "agaa/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bits of AgaaTemporal::flags. */
/* Each frame is mixed with the previous frame alone, in equal parts, not with the accumulated image. "smaa" with this
 * flag and a jitter of two positions is SMAA T2x (Jimenez et al. 2012, section 4.5). */
#define AGAA_TEMPORAL_LAST_FRAME_ONLY UINT64_C(0x01)

/* Controls the accumulation of frames by "taa" and by AGAA_CONFIG_ACCUMULATE. Chain it to AgaaConfig; views that do not
 * accumulate check the struct and do not use it. The host jitters the camera (agaaGetJitter) and chains an
 * AgaaTemporalFrame to each frame. A pixel's history is looked up where its surface was in the previous frame, by a
 * cubic filter (Catmull-Rom). It is rejected where no pixel showed a surface at its distance, and clipped to the mean
 * and deviation of the 3 x 3 pixels (Salvi 2016). The view takes 32 bytes per pixel more. */
typedef struct AgaaTemporal {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t flags; /* AGAA_TEMPORAL_… */
    /* The name of an attribute AGAA_SEMANTIC_CUSTOM of the layout, with 2 channels of 16 bits and range 1: the motion
     * vector of moving surfaces. Null, or both channels 0: the surface stands still in the world. Otherwise each
     * channel is (32768 + 32767 m) / 65535, where m is the displacement from this frame to the previous one, along x
     * and y of clip space, without jitter, in widths and heights of the frame; it is clamped to one width or height.
     * Requires a technique or tier that shades a G-buffer: others fail with AGAA_ERROR_UNSUPPORTED. The name of no
     * attribute, or of another one, fails with AGAA_ERROR_LAYOUT. Read during the call only. */
    const char* motion;
    float currentShare;   /* smallest share of a frame in the image, [0.001, 1]; LAST_FRAME_ONLY does not use it */
    float clipDeviations; /* size of the clipping box in standard deviations, [0, 1e6]; 0: history is not clipped */
    float depthTolerance; /* largest change of a surface's distance between frames, besides the camera's motion, as a
                             share of it, or of half the width of an orthographic view, [0, 1e6] */
    uint32_t reserved;    /* 0 */
} AgaaTemporal;
#define AGAA_TEMPORAL_INIT                                                                                             \
    { AGAA_STRUCTURE_TYPE_TEMPORAL, (uint32_t)sizeof(AgaaTemporal), NULL, 0, NULL, 0.0625f, 1.0f, 0.05f, 0 }
AGAA_API void AGAA_CALL agaaInitTemporal(AgaaTemporal* outTemporal, size_t structSize);

/* The camera of the previous frame of the view, the last one whose recording calls returned AGAA_OK. After a frame that
 * was recorded in part or discarded, the next one has no history. Chain it to AgaaFrame in each frame of a view that
 * accumulates; other views do not use it. A frame without it fails with AGAA_ERROR_INVALID_ARGUMENT. It is read with
 * AGAA_SEGMENT_SHADING. */
typedef struct AgaaTemporalFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t resets;   /* 1: forget earlier frames, for the first frame after a cut of the camera; 0: do not */
    uint32_t reserved; /* 0 */
    float
        jitter[2]; /* by which AgaaFrame::projection moves the image along x and y of clip space, in pixels, [-1, 1] */
    /* Transform from the shading space of this frame to the view space of the previous frame: a rotation and a
     * translation, with last row 0, 0, 0, 1. Elements are in [-1e18, 1e18]. */
    float toPreviousView[16];
    float previousProjection[16]; /* as AgaaFrame::projection, without jitter */
} AgaaTemporalFrame;
#define AGAA_TEMPORAL_FRAME_INIT                                                                                       \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_TEMPORAL_FRAME, (uint32_t)sizeof(AgaaTemporalFrame), NULL, 1, 0, {0, 0},                   \
            {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {                                                        \
            0                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitTemporalFrame(AgaaTemporalFrame* outFrame, size_t structSize);

/* Gets a position of a jitter sequence that fills the pixel evenly: Halton's sequence of bases 2 and 3, without its
 * first element, or for two positions the diagonal (1/4, 1/4), (-1/4, -1/4) of SMAA T2x.
 *
 * index      Of the frame; positions repeat after `count`.
 * count      [1, 1024]. One position is the centre of the pixel.
 * outJitter  Receives x and y, (-1/2, 1/2) pixels; unchanged on failure.
 *
 * Errors     AGAA_ERROR_INVALID_ARGUMENT   outJitter is null
 *            AGAA_ERROR_OUT_OF_RANGE       count is out of range
 * Threads    Any. */
AGAA_API AgaaResult AGAA_CALL agaaGetJitter(uint64_t index, uint32_t count, float outJitter[2]);

#ifdef __cplusplus
}
#endif

#endif
