/* Questions answered without a context: devices, memory, plans. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_QUERY_H
#define AGAA_QUERY_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

#define AGAA_DEVICE_POST_DEPTH_COVERAGE UINT64_C(0x01)
#define AGAA_DEVICE_FRAGMENT_ATOMICS UINT64_C(0x02)
#define AGAA_DEVICE_SAMPLE_RATE_SHADING UINT64_C(0x04)
#define AGAA_DEVICE_DYNAMIC_RENDERING UINT64_C(0x08)
#define AGAA_DEVICE_STORAGE_FORMATS UINT64_C(0x10) /* extended storage formats, write w/o format */
#define AGAA_DEVICE_NV_MIXED_SAMPLES UINT64_C(0x20)
#define AGAA_DEVICE_D24S8 UINT64_C(0x40)
#define AGAA_DEVICE_D32S8 UINT64_C(0x80)
#define AGAA_DEVICE_NO_ALIASING UINT64_C(0x100) /* surfaces cannot share memory (OpenGL) */
#define AGAA_DEVICE_SOFTWARE UINT64_C(0x200)    /* draws on the CPU: groups do not share a processor's memory */

typedef struct AgaaDeviceCaps {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    char deviceName[128];
    char driverName[128];
    uint32_t sampleCounts; /* bit i: 2^i samples for colour and depth that can also be sampled, of the formats that the
                              device has; a view with a surface of another is AGAA_ERROR_UNSUPPORTED */
    uint32_t maxImageSize; /* texels */
    uint64_t maxStorageRange; /* bytes */
    uint32_t maxSharedBytes;  /* of a workgroup, in compute */
    uint32_t reserved;        /* 0 */
    uint64_t flags;        /* AGAA_DEVICE_… */
} AgaaDeviceCaps;
#define AGAA_DEVICE_CAPS_INIT                                                                       \
    {AGAA_STRUCTURE_TYPE_DEVICE_CAPS, (uint32_t)sizeof(AgaaDeviceCaps), NULL, {0}, {0}, 0, 0, 0, 16384, 0, 0}

typedef enum AgaaStage {
    AGAA_STAGE_PREPASS = 0,
    AGAA_STAGE_DEFINITION = 1,
    AGAA_STAGE_GENERATION = 2,
    AGAA_STAGE_SHADING = 3,
    AGAA_STAGE_OTHER = 4,
    AGAA_STAGE_MAX_ENUM = 0x7FFFFFFF
} AgaaStage;

typedef struct AgaaCapability {
    const char* technique; /* static storage */
    uint32_t samples;
    uint32_t stage; /* AgaaStage */
    uint32_t tier;  /* AgaaTier; AUTO where the stage cannot run */
    uint32_t isNative;
    float relativeCost; /* roughly, as measured on lavapipe: the stage by native visibility or post-depth atomics; of
                            GBUFFER and IDS whole frames of "agaa", n = 8 */
    char reason[244];    /* one sentence */
} AgaaCapability;

/* Names as written on command lines ("scaled-target"); "unknown" for others. Static storage. */
AGAA_API const char* AGAA_CALL agaaTierName(uint32_t tier);
AGAA_API const char* AGAA_CALL agaaStageName(uint32_t stage);
AGAA_API AgaaResult AGAA_CALL agaaTierFromName(const char* name, uint32_t* outTier);

/* Techniques of this library; names have static storage. Two-call: with names null, writes the count; otherwise *count
 * is the array's length, AGAA_ERROR_BUFFER_TOO_SMALL where that is less than there are, and becomes their number. */
AGAA_API AgaaResult AGAA_CALL agaaEnumerateTechniques(uint32_t* count, const char** names);

/* How each technique, n and stage runs on a device: in a stage's first row by itself, unless a view is too large for it,
 * in further rows where AgaaConfig asks for that tier or the host gives the functions that it needs. caps null: an ideal
 * device. Two-call. */
AGAA_API AgaaResult AGAA_CALL agaaQueryCapabilities(const AgaaDeviceCaps* caps, uint32_t* count,
                                                    AgaaCapability* capabilities);

typedef struct AgaaSurface {
    char name[48];
    char format[32];
    uint32_t width, height, samples, layers;
    uint64_t bytes;      /* payload */
    uint32_t isPerPixel; /* 0: constants, uploads and read-back, which do not grow with the target */
    uint32_t firstPass, lastPass; /* of the plan; a surface lives from the one to the other */
    uint32_t reserved;
} AgaaSurface;

typedef struct AgaaMemoryReport {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t totalBytes;    /* per-pixel payload */
    uint64_t constantBytes; /* payload of what does not grow with the target */
    uint64_t peakBytes;     /* per-pixel payload with surfaces of disjoint lifetimes aliased */
    double bytesPerPixel;   /* totalBytes / (width * height) */
    double bytesPerAggregate; /* 0 where none are kept in memory */
} AgaaMemoryReport;
#define AGAA_MEMORY_REPORT_INIT                                                                     \
    {AGAA_STRUCTURE_TYPE_MEMORY_REPORT, (uint32_t)sizeof(AgaaMemoryReport), NULL, 0, 0, 0, 0.0, 0.0}

/* Memory of a view by the plan that would allocate it, for two frames in flight. caps null: an ideal device with every
 * feature. surfaces: two-call as above. log may be null. */
AGAA_API AgaaResult AGAA_CALL agaaQueryMemory(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                              const AgaaLog* log, AgaaMemoryReport* outReport,
                                              uint32_t* surfaceCount, AgaaSurface* surfaces);

/* What geometry is rasterised into: n samples a pixel are scaleX x scaleY texels of `samples` each. */
typedef struct AgaaTarget {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t width, height; /* texels */
    uint32_t samples;       /* of a texel */
    uint32_t scaleX, scaleY;
    uint32_t geometryPasses; /* 0: the host draws its own G-buffer (AgaaGBufferFunction), of this size and samples
                                unless it says where samples lie */
} AgaaTarget;
#define AGAA_TARGET_INIT {AGAA_STRUCTURE_TYPE_TARGET, (uint32_t)sizeof(AgaaTarget), NULL, 0, 0, 0, 0, 0, 0}

/* The target of a view. caps null: an ideal device with every feature. log may be null. */
AGAA_API AgaaResult AGAA_CALL agaaQueryTarget(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                              AgaaTarget* outTarget);

/* The plan as JSON. Two-call: with text null, writes the size including the final zero. */
AGAA_API AgaaResult AGAA_CALL agaaPlanToJson(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                             const AgaaLog* log, size_t* size, char* text);

/* GLSL 430 by which a pass of the host's own reads the aggregates that a view leaves in memory, in the surface
 * "aggregates", when AGAA_SEGMENT_GENERATION has been recorded: struct AgaaAggregate and
 * `AgaaAggregate agaaAggregate(uvec2 pixel, uint a)`, a below AGAA_AGGREGATES (docs/shader-interface.md).
 * The host defines AGAA_AGGREGATE_WORD(i) before it, word i of the surface as a uint. Of "agaa" by two passes, and by
 * the tiers IDS and GBUFFER with AGAA_CONFIG_BUFFERED. caps: the device's. Two-call as agaaPlanToJson. */
AGAA_API AgaaResult AGAA_CALL agaaGetAggregateGlsl(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                                   const AgaaLog* log, size_t* size, char* text);

/* GLSL by which a fragment shader that is not of the SDK's draw passes covers the same samples: for a G-buffer that the
 * host draws itself (AgaaGBufferFunction). GLSL 420 or later; docs/shader-interface.md lists the functions, and the
 * gradients for versions before 450. The shader writes the mask to gl_SampleMask. Two-call as agaaPlanToJson; log may
 * be null. */
AGAA_API AgaaResult AGAA_CALL agaaGetCoverageGlsl(const AgaaLog* log, size_t* size, char* text);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_QUERY_H */
