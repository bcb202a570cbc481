/* Statistics of finished frames, and the validation of an integration. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_STATISTICS_H
#define AGAA_STATISTICS_H

#include "agaa/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- statistics ----------------------------------------------------------------------------- */

/* Exact counts of one frame. All are 0 without AGAA_CONFIG_COUNTERS. */
typedef struct AgaaCounters {
    uint64_t visible;       /* samples with geometry after the prepass */
    uint64_t once;          /* visible samples that were accumulated, by one aggregate or more */
    uint64_t uncovered;     /* visible samples that were never accumulated */
    uint64_t overlapping;   /* samples accumulated by a further aggregate, or although nothing is visible; "msaa"
                               counts only the latter */
    uint64_t ties;          /* sample writes refused because an equal depth came first. The stencil test refuses them
                               uncounted, so this counts alpha-masked materials, views with AGAA_MEASURE_NO_STENCIL, and
                               depth formats without stencil. 0 for "msaa" */
    uint64_t sanitised;     /* fragments with a non-finite attribute, and fetched materials with one, each time that
                               they are fetched */
    uint64_t shadingEvents; /* lighting evaluations for a sample or an aggregate; "msaa" counts per fragment,
                               including each coplanar fragment of alpha-masked materials */
    uint64_t shadowTaps;
    uint64_t widenedLobes;      /* shading events whose specular lobe the NDF widened */
    uint64_t shadedPixels;      /* pixels with at least one shading event */
    uint64_t maxEventsPerPixel; /* 0 for "msaa" */
    uint64_t aggregates;        /* aggregates of all pixels; surfaces for "sbaa" and "dcaa" */
    uint64_t primitives;        /* "agaa", tiers IDS and FRAGMENTS: primitives that the samples of a pixel show, summed
                                   over all pixels; unfetched draws are not counted */
    uint64_t materials;         /* tier IDS: material evaluations, one per primitive and pixel or, with
                                   AGAA_CONFIG_FINE_MATERIALS, per primitive and texel; two in pixels of one primitive
                                   whose shading normals belong to several surfaces. "adaptive": one per primitive and
                                   pixel each time that samples are compared, and one per shaded sample. Tier
                                   FRAGMENT_LISTS: one per fragment that has room. Tier FRAGMENTS: one per fragment that
                                   shows, for each use */
    uint64_t misplaced;         /* fragments of the first geometry pass that do not lie where the camera places them;
                                   slivers cause a few, because their positions extrapolate */
    uint64_t unannounced; /* tier IDS: fragments whose draw or primitive exceeds the limits of AgaaFetchFunction; with
                             its maxTriangles: primitives beyond the limits */
    /* Counters of "dcaa" (DCAA section 3). The tier FRAGMENTS uses fragments and lostFragments, too. */
    uint64_t fragments;     /* primitives that cover a sample of a pixel, also those for which the lists had no room */
    uint64_t mergedFirst;   /* fragments merged into a surface of similar normal whose depths overlap */
    uint64_t mergedSecond;  /* discarded surfaces, fragments included, of which another surface took samples */
    uint64_t discarded;     /* surfaces, fragments included, that were dropped because the pixel was full */
    uint64_t lostSamples;   /* samples that showed a dropped surface; "sgbc" counts each time that it drops a sample */
    uint64_t lostFragments; /* fragments for which the lists had no room */
    uint64_t batches;       /* tiers with lists: draws of the scene that the frame needed, 1 to maxBatches */
    uint64_t pixelsByEvents[6]; /* pixels with one shading event, with two, with more up to 4, 8 and 16, and with
                                   more than 16. 0 for "msaa" */
    uint64_t lightEvaluations;  /* lights that shading events evaluated, shadowed or not, times shadingCost; "msaa"
                                   counts per fragment. With a debug view, "adaptive" counts its first samples only */
    uint64_t joinedClasses;     /* "agaa" with AGAA_FILTER_CLASS and two aggregates or more: samples whose class has no
                                   aggregate of its own; tier FRAGMENTS: fragments */
    uint64_t reserved[1];       /* 0 */
} AgaaCounters;

#define AGAA_MAX_PASSES 32
typedef struct AgaaPassTime {
    char name[48];
    uint32_t stage;       /* AgaaStage */
    uint32_t isTimed;     /* 0: the time is unknown */
    double milliseconds;  /* of all its repetitions */
    uint64_t reserved[2]; /* 0 */
} AgaaPassTime;

/* The clock of the pass times. */
typedef enum AgaaTimeSource {
    AGAA_TIME_NONE = 0,       /* times were not requested, or are not available */
    AGAA_TIME_DEVICE = 1,     /* timestamps of the device */
    AGAA_TIME_CPU_FINISH = 2, /* CPU time around glFinish, because the driver's timer queries are wrong */
    AGAA_TIME_MAX_ENUM = 0x7FFFFFFF
} AgaaTimeSource;

typedef struct AgaaFrameStatistics {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;     /* null */
    uint64_t frameIndex;   /* the frame that was measured */
    uint64_t payloadBytes; /* payload of the per-pixel surfaces, as created */
    uint64_t driverBytes;  /* memory that the driver requires for all surfaces; 0 on OpenGL, which does not report it */
    uint64_t peakBytes;    /* memory allocated for per-pixel surfaces, which may share memory */
    uint32_t geometryPasses;
    uint32_t timeSource; /* AgaaTimeSource */
    AgaaCounters counters;
    uint32_t passCount;
    uint32_t reserved;
    AgaaPassTime passes[AGAA_MAX_PASSES]; /* the first passCount elements are set */
    /* Facts of the variant that the frame ran with (agaaPrepareVariants). */
    uint64_t variantFlags; /* AGAA_FACT_… */
    uint32_t variantShadowMaps;
    /* The members from here on describe the view since it was created or resized, when the statistics are read. */
    uint32_t variantCount;      /* variants that frames may run with, >= 1: the variant of the view's facts, and the
                                   prepared ones */
    double compileMilliseconds; /* elapsed time to create the pipelines or programs of the SDK's compute passes */
    uint32_t compiledPipelines; /* pipelines or programs that were created; variants share equal pipelines */
    uint32_t cachedPipelines;   /* programs among these that came from an AgaaGlProgramCache; 0 on Vulkan, where
                                   only the driver knows */
} AgaaFrameStatistics;
#define AGAA_FRAME_STATISTICS_INIT                                                                                     \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_FRAME_STATISTICS, (uint32_t)sizeof(AgaaFrameStatistics), NULL, 0, 0, 0, 0, 0, 0,           \
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0}, 0, 0, {0}}, 0, 0,               \
            {{{0}, 0, 0, 0.0, {0, 0}}}, 0, 0, 0, 0.0, 0, 0                                                             \
    }
AGAA_API void AGAA_CALL agaaInitFrameStatistics(AgaaFrameStatistics* outStatistics, size_t structSize);

/* Reads the statistics of the newest completely recorded frame that is not after completedFrame.
 *
 * completedFrame   The newest frame that the device is known to have finished.
 * outStatistics    Initialised; unchanged on failure.
 *
 * Returns          AGAA_NOT_READY if there is no such frame, or if its command buffer was discarded; then only the
 *                  bytes, geometryPasses, and the members from variantCount on are written. Views without counters and
 *                  times do not notice that a command buffer was discarded.
 * Errors           AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             outStatistics is not initialised
 *                  AGAA_ERROR_OUT_OF_MEMORY      Vulkan: timestamps could not be read
 *                  AGAA_ERROR_DEVICE             Vulkan: timestamps could not be read, for example because the device
 *                                                is lost; OpenGL: the context is lost
 * Threads          One call at a time per context.
 * OpenGL           The context must be current. */
AGAA_API AgaaResult AGAA_CALL agaaGetFrameStatistics(AgaaView view, uint64_t completedFrame,
                                                     AgaaFrameStatistics* outStatistics);

/* ---- breadcrumbs ---------------------------------------------------------------------------- */

/* A pass of a frame on the device. */
typedef struct AgaaBreadcrumb {
    char name[48];        /* as in AgaaPassTime; empty: the device has reached no pass */
    uint64_t frameIndex;  /* AgaaFrame::frameIndex */
    uint32_t pass;        /* index into AgaaFrameStatistics::passes */
    uint32_t repetition;  /* of a pass that is repeated, from 0 */
    uint64_t reserved[1]; /* 0 */
} AgaaBreadcrumb;

/* The passes that the device reached since the view was created or resized. */
typedef struct AgaaBreadcrumbs {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;    /* null */
    AgaaBreadcrumb begun; /* the pass that began last */
    AgaaBreadcrumb ended; /* the pass that ended last */
} AgaaBreadcrumbs;
#define AGAA_BREADCRUMBS_INIT                                                                                          \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_BREADCRUMBS, (uint32_t)sizeof(AgaaBreadcrumbs), NULL, {{0}, 0, 0, 0, {0}}, {               \
            {0}, 0, 0, 0, { 0 }                                                                                        \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitBreadcrumbs(AgaaBreadcrumbs* outBreadcrumbs, size_t structSize);

/* Reads which pass of the view the device began last, and which it ended last. Call it when the device is lost or does
 * not finish a frame: if both differ, the device is or was in the pass that began. It reads memory of the CPU and calls
 * nothing of the graphics API. After a loss the memory may lack the newest writes of the device.
 *
 * outBreadcrumbs   Initialised; unchanged on failure.
 *
 * Returns          AGAA_NOT_READY if the device has begun no pass; outBreadcrumbs is unchanged.
 * Errors           AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             outBreadcrumbs is not initialised
 *                  AGAA_ERROR_WRONG_ORDER        the view has no AGAA_CONFIG_BREADCRUMBS
 * Threads          One call at a time per context.
 * OpenGL           The context need not be current. */
AGAA_API AgaaResult AGAA_CALL agaaGetBreadcrumbs(AgaaView view, AgaaBreadcrumbs* outBreadcrumbs);

/* ---- validation ----------------------------------------------------------------------------- */

typedef struct AgaaInvalidPixel {
    uint32_t x, y; /* pixel */
    /* Masks: sample i is bit i % 32 of word i / 32. */
    uint32_t visible[4];     /* samples that show geometry after the prepass */
    uint32_t uncovered[4];   /* visible samples that were never accumulated */
    uint32_t overlapping[4]; /* samples accumulated by two aggregates, or although nothing is visible */
    uint32_t reserved[2];    /* 0 */
} AgaaInvalidPixel;

#define AGAA_MAX_INVALID_PIXELS 8
/* Reports whether the geometry passes of a frame agree with each other and with the camera. The material pass must
 * accumulate each sample that the prepass shows exactly once. Fragments must lie where AgaaFrame places
 * AgaaSurfaceInput::position. Their draws and primitives must be within the limits of AgaaFetchFunction. */
typedef struct AgaaFrameValidation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext; /* null */
    uint64_t frameIndex;
    uint64_t visible, once, uncovered, overlapping, ties; /* samples, as in AgaaCounters */
    uint64_t misplaced;                                   /* fragments, as in AgaaCounters */
    uint64_t unannounced;                                 /* fragments, as in AgaaCounters */
    uint64_t invalidPixels;                               /* pixels with uncovered or overlapping samples */
    uint32_t isValid; /* 1: something is visible, nothing is uncovered, overlapping or unannounced, and
                         misplaced is at most a hundredth of visible */
    uint32_t pixelCount;
    AgaaInvalidPixel pixels[AGAA_MAX_INVALID_PIXELS]; /* the first pixelCount invalid pixels */
    char explanation[512];                            /* the findings and their usual cause */
} AgaaFrameValidation;
#define AGAA_FRAME_VALIDATION_INIT                                                                                     \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_FRAME_VALIDATION, (uint32_t)sizeof(AgaaFrameValidation), NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0,  \
            0, 0, {{0, 0, {0}, {0}, {0}, {0}}}, {                                                                      \
            0                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitFrameValidation(AgaaFrameValidation* outValidation, size_t structSize);

/* Validates the frame that agaaGetFrameStatistics would report.
 *
 * completedFrame   The newest frame that the device is known to have finished.
 * outValidation    Initialised; unchanged on failure.
 *
 * Returns          AGAA_NOT_READY if there is no such frame, or if its command buffer was discarded; outValidation is
 *                  unchanged.
 * Errors           AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             outValidation is not initialised
 *                  AGAA_ERROR_WRONG_ORDER        the view has no AGAA_CONFIG_COUNTERS
 *                  AGAA_ERROR_DEVICE             OpenGL: the context is lost
 * Threads          One call at a time per context.
 * OpenGL           The context must be current. */
AGAA_API AgaaResult AGAA_CALL agaaValidateFrame(AgaaView view, uint64_t completedFrame,
                                                AgaaFrameValidation* outValidation);

/* ---- scene facts ---------------------------------------------------------------------------- */

/* Compares the scene facts with the materials and lights of a frame. A material is inspected each time that a
 * fragment evaluates it in a pass that stores or shades it, visible or not. It is also inspected each time that a
 * function of the host provides it to a pass that groups or shades samples. Differences and values of 0.002 or less
 * do not count; the difference of roughness is that of GGX alpha. The visibility pass counts the masks of materials
 * that are fetched by id. The masks behind an AgaaGBufferFunction are unknown: `sufficient` then repeats the facts
 * of the view. */
typedef struct AgaaFactReport {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;   /* null */
    uint64_t frameIndex; /* the frame that was inspected */
    uint64_t inspected;  /* materials */
    /* Numbers of inspected materials: */
    uint64_t withSpecular; /* materials with specular reflectance */
    uint64_t withEmission;
    uint64_t alphaMasked;
    uint64_t otherRoughness;  /* materials whose roughness is not AgaaSceneFacts::alpha2 */
    uint64_t coloredSpecular; /* materials whose specular reflectance has unequal channels */
    uint64_t otherSpecular;   /* materials whose specular reflectance is not AgaaSceneFacts::specular */
    uint64_t withDiffuse;     /* materials with diffuse albedo */
    uint64_t translucent;     /* a part of alphaMasked */
    uint64_t cutouts;         /* a part of alphaMasked */
    uint64_t otherNormals;    /* materials whose normal is more than a degree from the normal of their primitive:
                                 AgaaSurfaceInput::geometricNormal, or the triangle of an AgaaFetchFunction.
                                 Triangles that are too small for this test, and materials of an AgaaGBufferFunction,
                                 do not count */
    /* Lights, shadows and ambient light of the frame: */
    uint32_t lightCount;
    uint32_t localLights; /* point and spot lights */
    uint32_t shadowCount;
    uint32_t hasAmbient; /* 1: AgaaFrame::ambient is not 0 */
    /* Bits of AgaaSceneFacts::flags: */
    uint64_t contradicted; /* facts of the view that the frame contradicts: effects that the frame needs and the
                              view left out, and common values that a material does not have */
    uint64_t sufficient;   /* the facts that describe this frame, with the fewest effects and all common values that
                              hold. CUSTOM_DEPTH is the same as in the view. Facts of many frames have the effects of
                              any frame and the common values of all frames */
    char explanation[512]; /* the findings */
} AgaaFactReport;
#define AGAA_FACT_REPORT_INIT                                                                                          \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_FACT_REPORT, (uint32_t)sizeof(AgaaFactReport), NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   \
            0, 0, 0, 0, 0, 0, {                                                                                        \
            0                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitFactReport(AgaaFactReport* outReport, size_t structSize);

/* Compares the facts of a view with the frame that agaaGetFrameStatistics would report. The first contradiction of a
 * view also goes to the log, as a warning.
 *
 * completedFrame   The newest frame that the device is known to have finished.
 * outReport        Initialised; unchanged on failure.
 *
 * Returns          AGAA_NOT_READY if there is no such frame, or if its command buffer was discarded; outReport is
 *                  unchanged.
 * Errors           AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             outReport is not initialised
 *                  AGAA_ERROR_WRONG_ORDER        the view has no AGAA_CONFIG_CHECK_FACTS
 *                  AGAA_ERROR_DEVICE             OpenGL: the context is lost
 * Threads          One call at a time per context.
 * OpenGL           The context must be current. */
AGAA_API AgaaResult AGAA_CALL agaaGetFactReport(AgaaView view, uint64_t completedFrame, AgaaFactReport* outReport);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_STATISTICS_H */
