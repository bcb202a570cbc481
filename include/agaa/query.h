/* Queries that need no context: devices, memory, plans, shader text. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_QUERY_H
#define AGAA_QUERY_H

#include "agaa/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- devices -------------------------------------------------------------------------------- */

/* Bits of AgaaDeviceCaps::flags. */
#define AGAA_DEVICE_POST_DEPTH_COVERAGE UINT64_C(0x01)
#define AGAA_DEVICE_FRAGMENT_ATOMICS UINT64_C(0x02)
#define AGAA_DEVICE_SAMPLE_RATE_SHADING UINT64_C(0x04)
#define AGAA_DEVICE_DYNAMIC_RENDERING UINT64_C(0x08)
#define AGAA_DEVICE_STORAGE_FORMATS UINT64_C(0x10) /* extended storage formats, writes without a format */
#define AGAA_DEVICE_NV_MIXED_SAMPLES                                                                                   \
    UINT64_C(0x20) /* colour attachments with fewer samples than depth, and fragment shaders that choose their         \
                      samples: GL_NV_framebuffer_mixed_samples and GL_NV_sample_mask_override_coverage, or the         \
                      extensions of these names on Vulkan with VK_NV_coverage_reduction_mode, which must have          \
                      TRUNCATE */
#define AGAA_DEVICE_D24S8 UINT64_C(0x40)
#define AGAA_DEVICE_D32S8 UINT64_C(0x80)
#define AGAA_DEVICE_NO_ALIASING UINT64_C(0x100) /* surfaces cannot share memory (OpenGL) */
#define AGAA_DEVICE_SOFTWARE UINT64_C(0x200)    /* renders on the CPU, where workgroups do not share memory */
#define AGAA_DEVICE_GEOMETRY_SHADERS                                                                                   \
    UINT64_C(0x400) /* devices without them need AGAA_VIEW_VERTEX_PULLING or                                           \
                       AgaaFetchFunction::maxTriangles */
#define AGAA_DEVICE_CONDITIONAL_RENDERING                                                                              \
    UINT64_C(0x800) /* VK_EXT_conditional_rendering: the device skips batches                                          \
                       that are not needed (AgaaDecoupledCoverage::maxBatches) */
#define AGAA_DEVICE_FRAGMENT_INTERLOCK                                                                                 \
    UINT64_C(0x1000) /* ordered critical sections for each pixel in fragment                                           \
                        shaders */
#define AGAA_DEVICE_FRAMEBUFFER_FETCH                                                                                  \
    UINT64_C(0x2000) /* fragment shaders read the attachments, in the order of the                                     \
                        draws (GL_EXT_shader_framebuffer_fetch,                                                        \
                        VK_EXT_rasterization_order_attachment_access) */
#define AGAA_DEVICE_SAMPLE_LOCATIONS                                                                                   \
    UINT64_C(0x4000) /* samples lie where a program says, on a grid of sixteenths of a pixel or finer                  \
                        (GL_ARB_sample_locations; VK_EXT_sample_locations with variableSampleLocations) */
#define AGAA_DEVICE_NV_MULTICAST                                                                                       \
    UINT64_C(0x8000) /* vertex shaders send a triangle to several viewports, of which there are 8 or more              \
                        (NV_viewport_array2, and on Vulkan the features multiViewport and geometryShader) */

/* Capabilities of a device. agaaVkGetDeviceCaps, agaaVkGetContextCaps, agaaGlGetDeviceCaps and agaaGlGetContextCaps
 * fill it. */
typedef struct AgaaDeviceCaps {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext; /* null */
    char deviceName[128];
    char driverName[128];
    uint32_t sampleCounts;    /* bit i: multisampled colour and depth textures with 2^i samples, in the formats that the
                                 device has; bits above 6 are not set. A view with a surface of another
                                 format fails with AGAA_ERROR_UNSUPPORTED */
    uint32_t maxImageSize;    /* texels */
    uint64_t maxStorageRange; /* bytes of one storage buffer */
    uint32_t maxSharedBytes;  /* bytes of shared memory of a compute workgroup */
    uint32_t subgroupSize;    /* lanes of a full subgroup of compute shaders, a power of two in [1, 128]; 0: the device
                                 lacks subgroup operations (basic, vote, ballot, shuffle) or full subgroups */
    uint64_t flags;           /* AGAA_DEVICE_… */
} AgaaDeviceCaps;
#define AGAA_DEVICE_CAPS_INIT                                                                                          \
    { AGAA_STRUCTURE_TYPE_DEVICE_CAPS, (uint32_t)sizeof(AgaaDeviceCaps), NULL, {0}, {0}, 0, 0, 0, 16384, 0, 0 }
AGAA_API void AGAA_CALL agaaInitDeviceCaps(AgaaDeviceCaps* outCaps, size_t structSize);

/* Describes how a technique runs a stage with n samples on a device. */
typedef struct AgaaCapability {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;     /* null */
    const char* technique; /* static storage */
    uint32_t samples;
    uint32_t stage;     /* AgaaStage */
    uint32_t tier;      /* AgaaTier; AUTO if the stage cannot run */
    uint32_t isNative;  /* 1: as the papers describe it */
    float relativeCost; /* approximate cost, measured on lavapipe, of the stage relative to native visibility or
                           post-depth atomics. GBUFFER and IDS compare whole frames of "agaa" with n = 8. Tiers of
                           "dcaa" compare whole frames with FRAGMENT_LISTS; FRAGMENT_INTERLOCK compares passes on an
                           NVIDIA H200. 0: not measured */
    uint32_t reserved;
    char reason[256]; /* one sentence */
} AgaaCapability;
#define AGAA_CAPABILITY_INIT                                                                                           \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_CAPABILITY, (uint32_t)sizeof(AgaaCapability), NULL, NULL, 0, 0, 0, 0, 0.0f, 0, { 0 }       \
    }
AGAA_API void AGAA_CALL agaaInitCapability(AgaaCapability* outCapability, size_t structSize);

/* Lists how each technique runs each stage. The first entry of a technique, n and stage is the tier that AUTO
 * selects, unless a view is too large for it or the host provides functions. Further entries run if AgaaConfig asks
 * for their tier, or if the host provides the functions that they need. If an entry needs a function,
 * AgaaFetchFunction::maxTriangles or AGAA_VIEW_VERTEX_PULLING, its reason names them. maxTriangles is named only if
 * nothing else suffices. If a stage cannot run (the tier AUTO), no view of its technique and n can be created. The
 * tier FRAGMENTS of "agaa" is listed at n = 64 and 128, and runs at 32, too.
 *
 * caps           Null: an ideal device.
 * count          Receives the number of entries. On entry it holds the length of the array, unless capabilities is
 *                null.
 * capabilities   Null, or an array whose elements are all initialised.
 *
 * Errors         AGAA_ERROR_INVALID_ARGUMENT   count is null
 *                AGAA_ERROR_STRUCT             caps or an element is not initialised
 *                AGAA_ERROR_OUT_OF_RANGE       a flag of caps is unknown, or AgaaDeviceCaps::sampleCounts or
 *                                              ::subgroupSize is of no device
 *                AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads        Any. */
AGAA_API AgaaResult AGAA_CALL agaaQueryCapabilities(const AgaaDeviceCaps* caps, uint32_t* count,
                                                    AgaaCapability* capabilities);

/* ---- names ---------------------------------------------------------------------------------- */

/* Selects a list of names. Names are lower case. In names that a host passes, '-' and '_' are equivalent. */
typedef enum AgaaNameKind {
    AGAA_NAMES_TECHNIQUES = 0, /* AgaaConfig::technique */
    AGAA_NAMES_TIERS = 1,      /* values of AgaaTier */
    AGAA_NAMES_STAGES = 2,     /* values of AgaaStage */
    AGAA_NAMES_LAYOUTS = 3,    /* agaaGetBuiltinLayout */
    AGAA_NAMES_PRESETS = 4,    /* agaaApplyPreset */
    AGAA_NAMES_MAX_ENUM = 0x7FFFFFFF
} AgaaNameKind;

/* Lists the names of a kind.
 *
 * kind     AgaaNameKind.
 * count    Receives the number of names. On entry it holds the length of the array, unless names is null.
 * names    Null, or an array. The names have static storage.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT   the kind is unknown, or count is null
 *          AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaGetNames(uint32_t kind, uint32_t* count, const char** names);

/* Return the name of a tier or a stage.
 *
 * Returns  Static storage, never null; "unknown" for other values.
 * Errors   None.
 * Threads  Any. */
AGAA_API const char* AGAA_CALL agaaTierName(uint32_t tier);
AGAA_API const char* AGAA_CALL agaaStageName(uint32_t stage);

/* Finds a tier by its name.
 *
 * outTier  Receives the AgaaTier; unchanged on failure.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or no tier has this name
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaTierFromName(const char* name, uint32_t* outTier);

/* ---- memory and plans ----------------------------------------------------------------------- */

/* Describes a surface of a plan or a view. Chain an AgaaVkSurface or an AgaaGlSurface in agaaGetSurface to receive
 * the handles. */
typedef struct AgaaSurface {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    char name[48];
    char format[32];          /* empty for buffers */
    uint32_t width, height;   /* texels; 0 for buffers */
    uint32_t samples, layers; /* layers: of the image, an array if there are several */
    /* Texels per pixel; 0 for buffers, and for images whose size is not that of the target. With the tiers LAYERS and
     * NV_MULTICAST, scaleY is AgaaTarget::layers: the rows of layer i begin at i times the height of the frame. */
    uint32_t scaleX, scaleY;
    uint64_t bytes;               /* payload of all copies */
    uint32_t isPerPixel;          /* 0: constants, tables, uploads and read-back, which do not grow with the target */
    uint32_t firstPass, lastPass; /* the surface is in use from pass firstPass to pass lastPass of the plan */
    uint32_t reserved;
} AgaaSurface;
#define AGAA_SURFACE_INIT                                                                                              \
    { AGAA_STRUCTURE_TYPE_SURFACE, (uint32_t)sizeof(AgaaSurface), NULL, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
AGAA_API void AGAA_CALL agaaInitSurface(AgaaSurface* outSurface, size_t structSize);

typedef struct AgaaMemoryReport {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;        /* null */
    uint64_t totalBytes;      /* per-pixel payload */
    uint64_t constantBytes;   /* payload that does not grow with the target */
    uint64_t peakBytes;       /* per-pixel payload if surfaces with disjoint lifetimes share memory */
    double bytesPerPixel;     /* totalBytes / (width * height) */
    double bytesPerAggregate; /* 0 if aggregates are not kept in memory */
} AgaaMemoryReport;
#define AGAA_MEMORY_REPORT_INIT                                                                                        \
    { AGAA_STRUCTURE_TYPE_MEMORY_REPORT, (uint32_t)sizeof(AgaaMemoryReport), NULL, 0, 0, 0, 0.0, 0.0 }
AGAA_API void AGAA_CALL agaaInitMemoryReport(AgaaMemoryReport* outReport, size_t structSize);

/* Predicts the memory of a view from its plan, for two frames in flight.
 *
 * caps           Null: an ideal device with every feature.
 * log            May be null.
 * outReport      May be null. Initialised; unchanged on failure.
 * surfaceCount   May be null if surfaces is null. Receives the number of surfaces. Unchanged on failure. On entry it
 *                holds the length of the array, unless surfaces is null.
 * surfaces       Null, or an array whose elements are all initialised; unchanged on failure.
 *
 * Errors         AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, functions of the host exclude each other, or their
 *                                              glslExtensions are not valid
 *                AGAA_ERROR_LAYOUT             the layout is not valid or cannot be packed
 *                AGAA_ERROR_UNSUPPORTED        no technique has this name, or the device or the library cannot do
 *                                              what was asked
 *                AGAA_ERROR_TOO_LARGE          a surface exceeds a limit of caps or of 64-bit arithmetic
 *                AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads        Any. */
AGAA_API AgaaResult AGAA_CALL agaaQueryMemory(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                              AgaaMemoryReport* outReport, uint32_t* surfaceCount,
                                              AgaaSurface* surfaces);

/* The target of the geometry passes: a pixel with n samples consists of scaleX x scaleY texels in each layer. */
typedef struct AgaaTarget {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    uint32_t width, height;  /* texels */
    uint32_t samples;        /* samples per texel. 1 for "dcaa", whose n samples are not samples of the target */
    uint32_t scaleX, scaleY; /* texels per pixel */
    uint32_t geometryPasses; /* 0: the host draws the G-buffer (AgaaGBufferFunction), with this size and these samples
                                unless the function gives sample positions */
    uint32_t layers;         /* of the tiers LAYERS and NV_MULTICAST, one below the other; otherwise 1. The height is
                                that of all layers */
    uint32_t reserved;       /* 0 */
} AgaaTarget;
#define AGAA_TARGET_INIT                                                                                               \
    { AGAA_STRUCTURE_TYPE_TARGET, (uint32_t)sizeof(AgaaTarget), NULL, 0, 0, 0, 0, 0, 0, 0, 0 }
AGAA_API void AGAA_CALL agaaInitTarget(AgaaTarget* outTarget, size_t structSize);

/* Predicts the target of a view.
 *
 * caps        Null: an ideal device with every feature.
 * log         May be null.
 * outTarget   Initialised; unchanged on failure.
 *
 * Errors      Those of agaaQueryMemory that concern the description, and
 *             AGAA_ERROR_INVALID_ARGUMENT   outTarget is null
 * Threads     Any. */
AGAA_API AgaaResult AGAA_CALL agaaQueryTarget(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                              AgaaTarget* outTarget);

/* Writes the plan of a view as JSON: tiers, resources, passes, notes.
 *
 * caps     Null: an ideal device with every feature.
 * log      May be null.
 * size     Receives the size of the text in bytes with the final zero. Unchanged on failure. On entry it holds the
 *          size of the buffer, unless text is null.
 * text     Null, or a buffer; unchanged on failure.
 *
 * Errors   Those of agaaQueryMemory that concern the description, and
 *          AGAA_ERROR_INVALID_ARGUMENT   size is null
 *          AGAA_ERROR_BUFFER_TOO_SMALL   the buffer is too small
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaPlanToJson(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                             size_t* size, char* text);

/* Describes a surface of a view, for hosts that use it between segments (depth for their own occlusion, for example)
 * or copy it (AGAA_CONFIG_READBACK). The view owns the surface.
 *
 * name         Name of a surface that agaaQueryMemory lists with isPerPixel 1. "depth" exists in every view whose
 *              host draws, except views of "dcaa". "aggregates" exists in the views that agaaGetAggregateGlsl accepts.
 *              Other names may change with the version.
 * outSurface   Initialised; unchanged on failure. Chain an AgaaVkSurface or an AgaaGlSurface to receive the handles,
 *              which stay valid until the view is resized or destroyed.
 *
 * Errors       AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or the view has no surface of this name
 *              AGAA_ERROR_STRUCT             a struct is not initialised
 *              AGAA_ERROR_UNKNOWN_STRUCT     the chained struct is not of the view's graphics API
 * Threads      One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaGetSurface(AgaaView view, const char* name, AgaaSurface* outSurface);

/* ---- shader text ---------------------------------------------------------------------------- */

/* Writes the GLSL (430) with which a compute shader of the host reads the aggregates in the surface "aggregates",
 * after AGAA_SEGMENT_GENERATION: struct AgaaAggregate and `AgaaAggregate agaaAggregate(uvec2 pixel, uint a)`, where
 * a is below AGAA_AGGREGATES (docs/shader-interface.md). Before the text, the host defines AGAA_AGGREGATE_WORD(i):
 * word i of the surface as a uint. For frames that name their width, it also defines AGAA_IMAGE_WIDTH: that width, an
 * expression of type uint such as a uniform.
 *
 * caps     Capabilities of the context. Null: an ideal device.
 * log      May be null.
 * size     As in agaaPlanToJson.
 * text     As in agaaPlanToJson.
 *
 * Errors   Those of agaaPlanToJson, and
 *          AGAA_ERROR_UNSUPPORTED   the view keeps no aggregates in memory, or they keep no normals
 *                                   (AGAA_FACT_PLANE_NORMALS and NO_LOCAL_LIGHTS without SPECULAR). "agaa" keeps
 *                                   aggregates with two geometry passes, and with the tiers IDS and GBUFFER if
 *                                   AGAA_CONFIG_BUFFERED is set
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaGetAggregateGlsl(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                                   const AgaaLog* log, size_t* size, char* text);

/* Writes the GLSL (420 or later) with which a fragment shader outside the SDK's draw passes covers the same samples
 * as in these passes. It is for a G-buffer that the host draws (AgaaGBufferFunction). The shader writes the mask to
 * gl_SampleMask. docs/shader-interface.md lists the functions, and the gradients for versions before 450.
 *
 * log      May be null.
 * size     As in agaaPlanToJson.
 * text     As in agaaPlanToJson.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT   size is null
 *          AGAA_ERROR_BUFFER_TOO_SMALL   the buffer is too small
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaGetCoverageGlsl(const AgaaLog* log, size_t* size, char* text);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_QUERY_H */
