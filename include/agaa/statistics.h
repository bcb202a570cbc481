/* Figures of finished frames, and validation for integrators. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_STATISTICS_H
#define AGAA_STATISTICS_H

#include "agaa/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- statistics ------------------------------------------------------------------------------ */

/* Exact counts of one frame; all 0 without AGAA_CONFIG_COUNTERS. */
typedef struct AgaaCounters {
    uint64_t visible;       /* samples with geometry after the prepass */
    uint64_t once;          /* of these, accumulated, by one aggregate or more */
    uint64_t uncovered;     /* of these, never accumulated */
    uint64_t overlapping;   /* accumulated by a further aggregate, or where nothing is visible; of "msaa" only there */
    uint64_t ties;          /* sample writes refused because an equal depth came first; the stencil test refuses them
                               uncounted, so these are where it does not run: of masked materials, with
                               AGAA_CONFIG_NO_STENCIL and in depth formats without stencil. Not of "msaa" */
    uint64_t sanitised;     /* fragments, and materials as often as they are fetched, with a non-finite attribute */
    uint64_t shadingEvents; /* full lighting evaluations of a sample or an aggregate; of "msaa" of fragments, each of
                               coplanar fragments of masked materials */
    uint64_t shadowTaps;
    uint64_t widenedLobes;  /* events whose specular lobe the NDF widened */
    uint64_t shadedPixels;  /* pixels with at least one event */
    uint64_t maxEventsPerPixel;
    uint64_t aggregates; /* or surfaces of "sbaa", of all pixels */
    uint64_t primitives; /* tier IDS: that samples show, of all pixels; of draws that can be fetched */
    uint64_t materials;  /* tier IDS: fetched, each for the samples of a primitive in a pixel or, with
                            AGAA_CONFIG_FINE_MATERIALS, a texel; twice in pixels of one primitive whose shading normals
                            turn out to be of several surfaces */
    uint64_t misplaced; /* fragments of the first geometry pass that do not lie where the camera puts them;
                           few of slivers, whose positions extrapolate */
    uint64_t unannounced; /* tier IDS: fragments of a draw or primitive beyond what AgaaFetchFunction announced; they
                             show the last announced */
} AgaaCounters;

#define AGAA_MAX_PASSES 16 /* a view with more is AGAA_ERROR_INTERNAL */
typedef struct AgaaPassTime {
    char name[48];
    uint32_t stage;  /* AgaaStage */
    uint32_t isTimed;
    double milliseconds;
} AgaaPassTime;

/* What pass times are measured with. */
typedef enum AgaaTimeSource {
    AGAA_TIME_NONE = 0,       /* not asked for, or not to be had */
    AGAA_TIME_DEVICE = 1,     /* the device's timestamps */
    AGAA_TIME_CPU_FINISH = 2, /* the CPU's clock around glFinish: the driver's queries were found wrong */
    AGAA_TIME_MAX_ENUM = 0x7FFFFFFF
} AgaaTimeSource;

typedef struct AgaaFrameStatistics {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t frameIndex; /* the frame that the figures belong to */
    AgaaCounters counters;
    uint32_t passCount;
    uint32_t geometryPasses;
    AgaaPassTime passes[AGAA_MAX_PASSES];
    uint64_t payloadBytes; /* as created: per-pixel surfaces */
    uint64_t driverBytes;  /* what the driver asked for, all surfaces added up; 0 on OpenGL, which does
                              not tell */
    uint64_t peakBytes;    /* what was allocated, with aliasing */
    uint32_t timeSource;   /* AgaaTimeSource */
    uint32_t reserved;
} AgaaFrameStatistics;
#define AGAA_FRAME_STATISTICS_INIT                                                                  \
    {AGAA_STRUCTURE_TYPE_FRAME_STATISTICS, (uint32_t)sizeof(AgaaFrameStatistics), NULL, 0,           \
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 0, 0, {{{0}, 0, 0, 0.0}}, 0, 0, 0, 0, 0}

/* Figures of the newest frame, recorded whole, that is not after completedFrame: the newest whose GPU work
 * is known to have finished. AGAA_NOT_READY where there is none: only bytes and geometryPasses are written then. On
 * OpenGL the view's context must be current. */
AGAA_API AgaaResult AGAA_CALL agaaGetFrameStatistics(AgaaView view, uint64_t completedFrame,
                                                     AgaaFrameStatistics* outStatistics);

/* ---- validation for integrators ----------------------------------------------------------------- */

typedef struct AgaaInvalidPixel {
    uint32_t x, y; /* pixel */
    /* Sample i is bit i % 32 of word i / 32. */
    uint32_t visible[4];     /* samples that show geometry after the prepass */
    uint32_t uncovered[4];   /* of these, never accumulated */
    uint32_t overlapping[4]; /* accumulated by two aggregates, or where nothing is visible */
} AgaaInvalidPixel;

#define AGAA_MAX_INVALID_PIXELS 8
/* Whether the geometry passes of a frame agree with each other and with the camera: each sample that the
 * prepass shows must be accumulated exactly once by the material pass, fragments must lie where AgaaFrame puts
 * AgaaSurfaceInput::position, and their draws and primitives must be announced. */
typedef struct AgaaFrameValidation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t frameIndex;
    uint64_t visible, once, uncovered, overlapping, ties; /* samples; as in AgaaCounters */
    uint64_t misplaced;                                   /* fragments; as in AgaaCounters */
    uint64_t invalidPixels;                               /* with uncovered or overlapping samples */
    uint32_t isValid; /* 1: something visible, nothing uncovered, overlapping or unannounced, misplaced at most a
                         hundredth of visible */
    uint32_t pixelCount;
    AgaaInvalidPixel pixels[AGAA_MAX_INVALID_PIXELS]; /* the first that were found */
    char explanation[512]; /* what was found and what usually causes it */
    uint64_t unannounced;  /* fragments; as in AgaaCounters */
} AgaaFrameValidation;
#define AGAA_FRAME_VALIDATION_INIT                                                                  \
    {AGAA_STRUCTURE_TYPE_FRAME_VALIDATION, (uint32_t)sizeof(AgaaFrameValidation), NULL, 0, 0, 0, 0, 0, \
     0, 0, 0, 0, 0, {{0, 0, {0}, {0}, {0}}}, {0}, 0}

/* Of the frame that agaaGetFrameStatistics would tell of; the same holds for its context. AGAA_NOT_READY where there is
 * none, AGAA_ERROR_WRONG_ORDER for views without AGAA_CONFIG_COUNTERS. */
AGAA_API AgaaResult AGAA_CALL agaaValidateFrame(AgaaView view, uint64_t completedFrame,
                                                AgaaFrameValidation* outValidation);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_STATISTICS_H */
