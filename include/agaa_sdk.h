/* AGAA SDK: anti-aliasing for deferred shading without history.
 * SPDX-License-Identifier: MIT
 *
 * Pure C99. Sources named below: "AGAA" is Crassin et al., Aggregate G-Buffer Anti-Aliasing, TVCG 2016.
 *
 * Conventions
 *   Errors     Every function that can fail returns an AgaaResult: 0 ok, > 0 not an error, < 0 an error.
 *              An error is also told through the log callback in one sentence. A call that fails
 *              validation has recorded and changed nothing.
 *   Lifetime   Pointers in parameters need to live until the call returns, unless stated otherwise.
 *   Threading  Functions without a handle may be called from any thread. Calls that share a context
 *              must not overlap in time.
 *   Spaces     Shading space: the host's axes with the origin at the eye ("camera-relative world").
 *              View space: right-handed, x right, y up, looking down -z. Matrices are column-major.
 *              Colours are linear. Lengths are in the host's unit.
 */
#ifndef AGAA_SDK_H
#define AGAA_SDK_H

#include <stddef.h>
#include <stdint.h>

#define AGAA_VERSION_MAJOR 0
#define AGAA_VERSION_MINOR 1
#define AGAA_VERSION_PATCH 0
#define AGAA_HEADER_VERSION                                                                         \
    (((uint32_t)AGAA_VERSION_MAJOR << 22) | ((uint32_t)AGAA_VERSION_MINOR << 12) |                  \
     (uint32_t)AGAA_VERSION_PATCH)

#if defined(_WIN32)
#if defined(AGAA_BUILDING)
#define AGAA_API __declspec(dllexport)
#else
#define AGAA_API __declspec(dllimport)
#endif
#define AGAA_CALL __cdecl
#else
#define AGAA_API __attribute__((visibility("default")))
#define AGAA_CALL
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- handles ------------------------------------------------------------------------------- */

typedef struct AgaaContext_T* AgaaContext; /* one per device */
typedef struct AgaaView_T* AgaaView;       /* one per camera and size: the frame's surfaces */

/* ---- results: one list, so that names and values cannot part ------------------------------- */

#define AGAA_RESULT_LIST(X)                                                                         \
    X(AGAA_OK, 0, "success")                                                                        \
    X(AGAA_NOT_READY, 1, "the result is not there yet")                                             \
    X(AGAA_ERROR_INVALID_ARGUMENT, -1, "an argument is null or has no valid value")                 \
    X(AGAA_ERROR_VERSION, -2, "header and library versions do not match")                           \
    X(AGAA_ERROR_STRUCT, -3, "a struct has the wrong sType or structSize")                          \
    X(AGAA_ERROR_UNKNOWN_STRUCT, -4, "a struct of unknown type is in a pNext chain")                \
    X(AGAA_ERROR_OUT_OF_RANGE, -5, "a value is out of its range")                                   \
    X(AGAA_ERROR_UNSUPPORTED, -6, "the device or this build cannot do what was asked")              \
    X(AGAA_ERROR_LAYOUT, -7, "a G-buffer layout cannot be packed")                                  \
    X(AGAA_ERROR_TOO_LARGE, -8, "a size exceeds a limit of the device or of 64-bit arithmetic")     \
    X(AGAA_ERROR_OUT_OF_MEMORY, -9, "memory could not be allocated")                                \
    X(AGAA_ERROR_DEVICE, -10, "the graphics API reported an error")                                 \
    X(AGAA_ERROR_CALLBACK, -11, "a host callback reported failure; nothing was recorded")           \
    X(AGAA_ERROR_PARTIAL, -12, "a frame was recorded in part; discard the command buffer")          \
    X(AGAA_ERROR_WRONG_ORDER, -13, "calls came in the wrong order")                                 \
    X(AGAA_ERROR_BUFFER_TOO_SMALL, -14, "the caller's array is too small")                          \
    X(AGAA_ERROR_INTERNAL, -15, "an internal error")

typedef enum AgaaResultCode {
#define AGAA_RESULT_ENUM(name, value, text) name = (value),
    AGAA_RESULT_LIST(AGAA_RESULT_ENUM)
#undef AGAA_RESULT_ENUM
        AGAA_RESULT_MAX_ENUM = 0x7FFFFFFF
} AgaaResultCode;
typedef int32_t AgaaResult;

/* Never null; "unknown result" for values of a newer library. Static storage. */
AGAA_API const char* AGAA_CALL agaaResultString(AgaaResult result);
AGAA_API const char* AGAA_CALL agaaResultName(AgaaResult result);
/* Version of the library, encoded as AGAA_HEADER_VERSION. */
AGAA_API uint32_t AGAA_CALL agaaGetVersion(void);

/* ---- struct types -------------------------------------------------------------------------- */

typedef enum AgaaStructType {
    AGAA_STRUCTURE_TYPE_LOG = 1,
    AGAA_STRUCTURE_TYPE_LAYOUT = 2,
    AGAA_STRUCTURE_TYPE_CONFIG = 3,
    AGAA_STRUCTURE_TYPE_SCENE_FACTS = 4,
    AGAA_STRUCTURE_TYPE_VIEW = 5,
    AGAA_STRUCTURE_TYPE_DEVICE_CAPS = 6,
    AGAA_STRUCTURE_TYPE_REQUIREMENTS = 7,
    AGAA_STRUCTURE_TYPE_MEMORY_REPORT = 8,
    AGAA_STRUCTURE_TYPE_FRAME = 9,
    AGAA_STRUCTURE_TYPE_FRAME_STATISTICS = 10,
    AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION = 11,
    AGAA_STRUCTURE_TYPE_FRAME_VALIDATION = 12,
    AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION = 13,
    AGAA_STRUCTURE_TYPE_FETCH_FUNCTION = 14,
    AGAA_STRUCTURE_TYPE_VK_CONTEXT = 1000,
    AGAA_STRUCTURE_TYPE_VK_FRAME = 1001,
    AGAA_STRUCTURE_TYPE_VK_DRAW_PASS = 1002,
    AGAA_STRUCTURE_TYPE_VK_SURFACE = 1003,
    AGAA_STRUCTURE_TYPE_GL_REQUIREMENTS = 2000,
    AGAA_STRUCTURE_TYPE_GL_CONTEXT = 2001,
    AGAA_STRUCTURE_TYPE_GL_FRAME = 2002,
    AGAA_STRUCTURE_TYPE_GL_DRAW_PASS = 2003,
    AGAA_STRUCTURE_TYPE_GL_SURFACE = 2004,
    /* A chained struct whose type has this bit may be ignored by a library that does not know it. */
    AGAA_STRUCTURE_TYPE_OPTIONAL_BIT = 0x40000000,
    AGAA_STRUCTURE_TYPE_MAX_ENUM = 0x7FFFFFFF
} AgaaStructType;

/* First members of every versioned struct; AGAA_…_INIT sets them and the defaults. */
typedef struct AgaaStructHeader {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
} AgaaStructHeader;

/* ---- log and host memory ------------------------------------------------------------------- */

typedef enum AgaaSeverity {
    AGAA_SEVERITY_INFO = 0,
    AGAA_SEVERITY_WARNING = 1,
    AGAA_SEVERITY_ERROR = 2,
    AGAA_SEVERITY_MAX_ENUM = 0x7FFFFFFF
} AgaaSeverity;

/* Called on the thread of the failing call; message is UTF-8, valid during the call only, and of an error
 * begins with the name of the function.
 * Callbacks must not throw and must not call the SDK. */
typedef void(AGAA_CALL* AgaaLogCallback)(void* user, uint32_t severity, AgaaResult code,
                                         const char* message);

typedef struct AgaaLog {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    AgaaLogCallback callback; /* may be null */
    void* user;
} AgaaLog;
#define AGAA_LOG_INIT {AGAA_STRUCTURE_TYPE_LOG, (uint32_t)sizeof(AgaaLog), NULL, NULL, NULL}

/* Host memory for the objects behind handles. alignment is a power of two. Both or neither. */
typedef void*(AGAA_CALL* AgaaAllocateCallback)(void* user, size_t size, size_t alignment);
typedef void(AGAA_CALL* AgaaFreeCallback)(void* user, void* memory);

/* ---- G-buffer layout (AGAA section 4.3, figure 7) ------------------------------------------- */

typedef enum AgaaSemantic {
    AGAA_SEMANTIC_DIFFUSE = 0,   /* 3 channels: diffuse albedo */
    AGAA_SEMANTIC_SPECULAR = 1,  /* 3 channels: specular reflectance at normal incidence */
    AGAA_SEMANTIC_NORMAL = 2,    /* 3 channels per aggregate, stored as 2 per sample */
    AGAA_SEMANTIC_ROUGHNESS = 3, /* 1 channel: alpha squared */
    AGAA_SEMANTIC_EMISSIVE = 4,  /* 3 channels, or 1: a factor of the diffuse albedo */
    AGAA_SEMANTIC_COUNT = 5,
    AGAA_SEMANTIC_MAX_ENUM = 0x7FFFFFFF
} AgaaSemantic;

typedef enum AgaaEncoding {
    AGAA_ENCODING_UNORM = 0, /* value / range in [0,1] */
    AGAA_ENCODING_YCBCR = 1, /* luma at `bits`, both chroma channels at `chromaBits` (aggregates) */
    AGAA_ENCODING_FOLDED = 2, /* roughness only: shortens the normal, takes no bits (aggregates) */
    AGAA_ENCODING_MAX_ENUM = 0x7FFFFFFF
} AgaaEncoding;

typedef struct AgaaLayoutAttribute {
    uint32_t semantic;      /* AgaaSemantic, each at most once; DIFFUSE and NORMAL are mandatory */
    uint32_t channels;      /* as at AgaaSemantic */
    uint32_t sampleBits;    /* per channel in the multisampled G-buffer: 8, 10 or 16 */
    uint32_t aggregateBits; /* per channel and fragment before summing: [6;16]; 0: as many as n leaves of
                               16, or a whole 16 */
    uint32_t chromaBits;    /* YCBCR: [6;16] */
    uint32_t encoding;      /* AgaaEncoding */
    float range;            /* [1e-6;65504]: the value that full scale stands for; 1 except EMISSIVE */
    uint32_t reserved;      /* 0 */
} AgaaLayoutAttribute;

#define AGAA_MAX_LAYOUT_ATTRIBUTES 5
typedef struct AgaaLayout {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t attributeCount;
    uint32_t reserved; /* 0 */
    AgaaLayoutAttribute attributes[AGAA_MAX_LAYOUT_ATTRIBUTES];
} AgaaLayout;

/* Built-in layouts: "paper16" (AGAA figure 7) and "precise" (the default: 11 bits or more per
 * fragment and channel, roughness beside the normal). */
AGAA_API AgaaResult AGAA_CALL agaaGetBuiltinLayout(const char* name, AgaaLayout* outLayout);

/* ---- configuration -------------------------------------------------------------------------- */

typedef enum AgaaBrdf {
    AGAA_BRDF_BLINN_PHONG = 0,
    AGAA_BRDF_GGX = 1,
    AGAA_BRDF_MAX_ENUM = 0x7FFFFFFF
} AgaaBrdf;

/* How the spread of normals inside an aggregate widens the specular lobe (AGAA section 3.5.2). */
typedef enum AgaaNdf {
    AGAA_NDF_NONE = 0, /* no widening: for ablation */
    AGAA_NDF_TOKSVIG = 1,
    AGAA_NDF_MAX_ENUM = 0x7FFFFFFF
} AgaaNdf;

typedef enum AgaaSeeds {
    AGAA_SEEDS_MAXIMIN = 0,
    AGAA_SEEDS_SUM_OF_SQUARES = 1, /* AGAA algorithm 1 (e) as printed, for comparison */
    AGAA_SEEDS_MAX_ENUM = 0x7FFFFFFF
} AgaaSeeds;

typedef enum AgaaTier {
    AGAA_TIER_AUTO = 0,
    /* visibility */
    AGAA_TIER_NATIVE = 1,
    AGAA_TIER_NV_MULTICAST = 2,
    AGAA_TIER_SCALED_TARGET = 3, /* a target of SX x SY sub-pixels at the device's sample count */
    AGAA_TIER_LAYERS = 4,
    /* generation */
    AGAA_TIER_NV_MIXED_SAMPLES = 16,  /* the paper's: additive blending with coverage override */
    AGAA_TIER_POST_DEPTH_ATOMICS = 17, /* fragment coverage after the depth test, integer atomics */
    AGAA_TIER_PER_SAMPLE = 18,         /* one invocation per sample, integer atomics */
    AGAA_TIER_GBUFFER = 19, /* one geometry pass into a full multisampled G-buffer, whose samples a compute pass
                               aggregates */
    AGAA_TIER_IDS = 20, /* one geometry pass into depth and ids, by which materials are fetched (AgaaFetchFunction) */
    AGAA_TIER_MAX_ENUM = 0x7FFFFFFF
} AgaaTier;

/* Bits of AgaaConfig::flags. */
#define AGAA_CONFIG_COUNTERS UINT64_C(0x01)   /* count events; see AgaaCounters */
#define AGAA_CONFIG_TIMESTAMPS UINT64_C(0x02) /* time each pass */
#define AGAA_CONFIG_READBACK UINT64_C(0x04)   /* surfaces may be copied from; no aliasing */
#define AGAA_CONFIG_NO_DIFFUSE_FILTER UINT64_C(0x08)
#define AGAA_CONFIG_NO_SHADOW_FILTER UINT64_C(0x10) /* one tap at the aggregate's mean position */
#define AGAA_CONFIG_SHADOW_ALONG_DEPTH UINT64_C(0x80) /* AGAA 3.5.3: taps along the view ray by the
                                                         aggregate's depth variance, not at samples */
#define AGAA_CONFIG_NO_STENCIL UINT64_C(0x20) /* first come, first kept; not repeatable on ties */
#define AGAA_CONFIG_FIRST_SAMPLE_ROUTING UINT64_C(0x40) /* AGAA algorithm 2 (c), for comparison */
#define AGAA_CONFIG_SPLIT_SURFACES UINT64_C(0x100) /* of "agaa": samples of one surface are clustered like all
                                                      others (AGAA 3.3), so that distance may part them */
#define AGAA_CONFIG_BUFFERED UINT64_C(0x200) /* of "agaa", tiers IDS and GBUFFER: aggregates go to memory, the surface
                                                "aggregates", and a pass of its own shades them */

/* What the output shows of each pixel in place of its image: numbers and shares in all channels, or a colour. Not of
 * "msaa", whose shading is the host's. */
typedef enum AgaaDebugView {
    AGAA_DEBUG_VIEW_NONE = 0,
    AGAA_DEBUG_VIEW_EVENTS = 1,     /* shading events */
    AGAA_DEBUG_VIEW_AGGREGATES = 2, /* aggregates, or surfaces kept by "sbaa" */
    AGAA_DEBUG_VIEW_CLUSTERS = 3,   /* of these a colour each, in the share of its samples */
    AGAA_DEBUG_VIEW_PRIMITIVES = 4, /* tier IDS: primitives that samples show */
    AGAA_DEBUG_VIEW_LIT = 5,        /* share of the light of AgaaFrame::shadows[0] that gets to what is covered */
    AGAA_DEBUG_VIEW_WIDENED = 6,    /* by how much the NDF widened lobes: alpha of GGX, mean over what is covered */
    AGAA_DEBUG_VIEW_TIER = 7,       /* grey: not aggregated; orange: by two passes; blue: from a G-buffer; green: by ids;
                                       half as bright where one shading event did */
    AGAA_DEBUG_VIEW_MAX_ENUM = 0x7FFFFFFF
} AgaaDebugView;

typedef struct AgaaConfig {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* technique;    /* "single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa" */
    uint32_t samples;         /* n, visibility samples per pixel: 1, 2, 4, 8, 16, 32 */
    uint32_t aggregates;      /* c of "agaa", [1;4]; S, surfaces kept, of "sbaa", [1;6] */
    const AgaaLayout* layout; /* null: "precise" */
    uint32_t brdf;            /* AgaaBrdf */
    uint32_t ndf;             /* AgaaNdf */
    float characteristicLength;            /* k of equation 1, in host units, [0;inf) */
    float characteristicLengthPerDistance; /* k is at least this times the distance, [0;1]; k > 0 */
    float aggregateThreshold; /* t: a further aggregate must be farther than this, [0;inf) */
    /* What counts as one surface: shaded once by "simple_complex" and "sbaa", one aggregate of "agaa". 0: as the
     * technique has it. */
    float surfaceCosine;   /* least cosine between normals, [0;1] */
    float surfaceDistance; /* from the surface's plane, in widths of a pixel at its depth, [0;inf) */
    float surfaceMaterial; /* largest difference of a material's channel, [0;1]; read by "simple_complex" */
    uint32_t seeds;           /* AgaaSeeds */
    uint32_t shadowTaps;      /* samples of an aggregate that are looked up in each shadow, and whose mean its place
                                 is; at most, [0;32]; 0: 8 */
    uint32_t visibilityTier;  /* AgaaTier; AUTO: best that runs */
    uint32_t generationTier;  /* AgaaTier; AUTO: best that runs */
    uint32_t shadingCost;     /* [1;64]: lighting is evaluated this many times, for measurements */
    /* Of the tiers IDS and GBUFFER. Bit i: lights of AgaaFrame::shadows[i] are shaded by means over what they reach of an
     * aggregate, times the share that they reach, so that lit and unlit samples may differ in normal and colour.
     * A tap a sample, in place of shadowTaps. Shadows that AgaaSceneFacts does not declare are left out. */
    uint32_t litShadows;
    uint64_t flags;           /* AGAA_CONFIG_… */
    /* Of the tiers GBUFFER and IDS, which know materials when they group samples. Shading normals differ by
     * glossWeight / alpha as much in equation 1, [1;20], alpha of GGX, up to the term's largest value of 1; equal
     * normals of different gloss differ too. What shines narrowly is parted sooner. [0;16]; 0: by normals alone. */
    float glossWeight;
    uint32_t debugView; /* AgaaDebugView */
} AgaaConfig;
#define AGAA_CONFIG_INIT                                                                            \
    {AGAA_STRUCTURE_TYPE_CONFIG, (uint32_t)sizeof(AgaaConfig), NULL, "agaa", 8, 2, NULL,             \
     AGAA_BRDF_GGX, AGAA_NDF_TOKSVIG, 0.0f, 0.03f, 0.02f, 0.0f, 0.0f, 0.0f, AGAA_SEEDS_MAXIMIN, 0,   \
     AGAA_TIER_AUTO, AGAA_TIER_AUTO, 1, 0, 0, 0.0f, 0}

/* Named settings of "agaa", from measurements (docs/presets.md): "paper", as its sections say; "fast", "balanced" and
 * "accurate". Sets technique, aggregates, aggregateThreshold, surface…, seeds, shadowTaps, ndf, litShadows (the first
 * shadow), glossWeight and what flags say of clustering and filters; leaves the rest. All but "paper" want materials
 * where samples are grouped: without an AgaaFetchFunction, tier AUTO then is GBUFFER. */
AGAA_API AgaaResult AGAA_CALL agaaApplyPreset(const char* name, AgaaConfig* config);

/* What the scene calls for. The planner drops what is not named here. */
#define AGAA_FACT_SPECULAR UINT64_C(0x01)
#define AGAA_FACT_EMISSIVE UINT64_C(0x02)
#define AGAA_FACT_ALPHA_MASKED UINT64_C(0x04)
#define AGAA_FACT_AMBIENT UINT64_C(0x08)
#define AGAA_FACT_CUSTOM_DEPTH UINT64_C(0x10) /* materials write depth or discard on their own:
                                                 generation takes the tier gbuffer */
#define AGAA_FACT_ALL_SHADED (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT)

#define AGAA_MAX_SHADOW_MAPS 4
#define AGAA_MAX_SHADOW_LAYERS 6
typedef struct AgaaSceneFacts {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t flags;          /* AGAA_FACT_… */
    uint32_t maxLights;      /* [0;4096] */
    uint32_t shadowMapCount; /* [0;AGAA_MAX_SHADOW_MAPS] */
} AgaaSceneFacts;
#define AGAA_SCENE_FACTS_INIT                                                                       \
    {AGAA_STRUCTURE_TYPE_SCENE_FACTS, (uint32_t)sizeof(AgaaSceneFacts), NULL,                       \
     AGAA_FACT_ALL_SHADED, 64, 1}

#define AGAA_VIEW_REVERSED_Z UINT64_C(0x01) /* near is 1, far is 0; wants a float depth format */
#define AGAA_VIEW_COMPOSITE UINT64_C(0x02)  /* frames may composite over what the output holds */
/* The rasteriser maps z/w in [-1;1] to depth, which is OpenGL's default; without the flag, z/w in [0;1].
 * AgaaFrame::projection puts the near and the far plane at the ends of that range. */
#define AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE UINT64_C(0x04)

typedef struct AgaaViewDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t width;  /* pixels, >= 1 */
    uint32_t height; /* pixels, >= 1 */
    const AgaaConfig* config;
    const AgaaSceneFacts* facts;
    uint64_t flags; /* AGAA_VIEW_… */
} AgaaViewDesc;
#define AGAA_VIEW_DESC_INIT                                                                         \
    {AGAA_STRUCTURE_TYPE_VIEW, (uint32_t)sizeof(AgaaViewDesc), NULL, 0, 0, NULL, NULL, 0}

/* Chained to AgaaViewDesc: a multisampled G-buffer that the host draws itself, before it records the frame. The
 * library draws nothing: AgaaFrame::draw is not called and may be null, and techniques that aggregate take the tier
 * GBUFFER. Its passes are compiled with a function of the host's that reads a sample; the text is GLSL 450 and
 * defines
 *     bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m)
 * which gives depth as the host's depth buffer holds it, and the material (src/shaders/passes/host_code.glsl,
 * docs/integration.md), and says whether sample i, [0;n), shows geometry. It runs in compute: no implicit
 * derivatives. Its resources, readable by compute when the frame's commands run, are in set 1 (Vulkan), or where agaaGlRecordFrame says. Colours are in [0;1], emission in [0;range]
 * of the layout; what is not finite becomes 0. Names beginning with agaa_ and AGAA_ are the library's. Code that
 * does not compile is AGAA_ERROR_INVALID_ARGUMENT, with the compiler's first message. Not for "msaa". */
typedef struct AgaaGBufferFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    /* Where the n samples lie in the pixel, [0;1), as pairs x, y of gl_FragCoord; null: in a target of the
     * visibility tier, whose texels agaaTexel(pixel, i) and agaaTexelSample(i) name. */
    const float* samplePositions;
    uint64_t descriptorSetLayout; /* Vulkan: VkDescriptorSetLayout of set 1, or 0 without resources; that of an
                                     AgaaShadowFunction too, where both have one. OpenGL: 0 */
    uint32_t depthBits;           /* of a fixed-point depth, 16 or 24; 0: a float */
    uint32_t reserved;            /* 0 */
} AgaaGBufferFunction;
#define AGAA_GBUFFER_FUNCTION_INIT                                                                  \
    {AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION, (uint32_t)sizeof(AgaaGBufferFunction), NULL, NULL, NULL, 0, 0, 0}

/* Chained to AgaaViewDesc: materials by id, for the tier IDS, which AUTO then is. The visibility pass leaves, beside
 * depth, which draw and primitive each sample shows (AgaaSurfaceInput::draw, ::primitive); the only other pass finds
 * the primitives of a pixel, evaluates the material of each once, in the middle of its samples, groups these and
 * shades. It is compiled with functions of the host's; the text is GLSL 450 and defines
 *     void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c)
 *     void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m)
 * which give the clip coordinates of a triangle, as the vertex shader computed them, and the material at a point of
 * it (src/shaders/passes/host_code.glsl, docs/integration.md). They run in compute: no implicit derivatives. Their
 * resources are in set 1 (Vulkan), or where agaaGlRecordFrame says. Colours are in [0;1], emission in [0;range] of
 * the layout; what is not finite becomes 0. The alpha test is the visibility pass's alone. Names and errors as at
 * AgaaGBufferFunction. Of "agaa". */
/* Some draws cannot be fetched: displaced, or by shaders that compute cannot call. The visibility pass gives them
 * AgaaSurfaceInput::draw = AGAA_UNFETCHED, and a second geometry pass, AGAA_DRAW_PASS_GBUFFER at equal depth, draws
 * these draws alone into a multisampled G-buffer, from which their samples are taken. */
#define AGAA_FETCH_NOT_ALL_DRAWS UINT64_C(0x01)
typedef struct AgaaFetchFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t maxDraws;      /* >= 1; the numbers of draws are below it. What is not, is shown as the last draw or
                               primitive, and counted as AgaaCounters::sanitised */
    uint32_t maxPrimitives; /* >= 1, of a draw; together at most 2^32 - 1 ids: maxDraws times maxPrimitives, rounded
                               up to a power of two */
    uint64_t descriptorSetLayout; /* as at AgaaGBufferFunction */
    uint64_t flags;               /* AGAA_FETCH_… */
} AgaaFetchFunction;
#define AGAA_FETCH_FUNCTION_INIT                                                                    \
    {AGAA_STRUCTURE_TYPE_FETCH_FUNCTION, (uint32_t)sizeof(AgaaFetchFunction), NULL, NULL, 0, 0, 0, 0}

/* Chained to AgaaViewDesc: shadows by a function of the host's in place of some shadow maps. It is
 * compiled into the passes that shade; the text is GLSL 450 and defines
 *     float agaaHostShadow(uint shadow, vec3 position)
 * the share of light, [0;1], that a point in shading space gets past AgaaFrame::shadows[shadow]. It runs
 * in compute: no implicit derivatives. Its resources are in set 1 (Vulkan), or where agaaGlRecordFrame says;
 * names beginning with agaa_ and AGAA_ are the library's. Code that does not compile is
 * AGAA_ERROR_INVALID_ARGUMENT, with the compiler's first message. */
typedef struct AgaaShadowFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t shadows;  /* bit i: the function answers for AgaaFrame::shadows[i], whose layerCount is 0 */
    uint32_t reserved; /* 0 */
    uint64_t descriptorSetLayout; /* Vulkan: VkDescriptorSetLayout of set 1, or 0 without resources; OpenGL: 0 */
} AgaaShadowFunction;
#define AGAA_SHADOW_FUNCTION_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION, (uint32_t)sizeof(AgaaShadowFunction), NULL, NULL, 0, 0, 0}

/* ---- questions answered without a context --------------------------------------------------- */

#define AGAA_DEVICE_POST_DEPTH_COVERAGE UINT64_C(0x01)
#define AGAA_DEVICE_FRAGMENT_ATOMICS UINT64_C(0x02)
#define AGAA_DEVICE_SAMPLE_RATE_SHADING UINT64_C(0x04)
#define AGAA_DEVICE_DYNAMIC_RENDERING UINT64_C(0x08)
#define AGAA_DEVICE_STORAGE_FORMATS UINT64_C(0x10) /* extended storage formats, write w/o format */
#define AGAA_DEVICE_NV_MIXED_SAMPLES UINT64_C(0x20)
#define AGAA_DEVICE_D24S8 UINT64_C(0x40)
#define AGAA_DEVICE_D32S8 UINT64_C(0x80)
#define AGAA_DEVICE_NO_ALIASING UINT64_C(0x100) /* surfaces cannot share memory (OpenGL) */

typedef struct AgaaDeviceCaps {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    char deviceName[128];
    char driverName[128];
    uint32_t sampleCounts; /* bit i: 2^i samples for colour and depth that can also be sampled */
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
    float relativePrice; /* measured time, relative to native visibility or post-depth atomics */
    char reason[244];    /* one sentence */
} AgaaCapability;

/* Names as written on command lines ("scaled-target"); "unknown" for others. Static storage. */
AGAA_API const char* AGAA_CALL agaaTierName(uint32_t tier);
AGAA_API const char* AGAA_CALL agaaStageName(uint32_t stage);
AGAA_API AgaaResult AGAA_CALL agaaTierFromName(const char* name, uint32_t* outTier);

/* Techniques of this library; names have static storage. Two-call: with names null, writes the
 * count; otherwise fills up to *count. */
AGAA_API AgaaResult AGAA_CALL agaaEnumerateTechniques(uint32_t* count, const char** names);

/* How each technique, n and stage would run on a device by itself; other tiers can be forced by AgaaConfig.
 * caps null: an ideal device. Two-call. */
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
    double bytesPerAggregate; /* 0 where nothing is aggregated */
} AgaaMemoryReport;
#define AGAA_MEMORY_REPORT_INIT                                                                     \
    {AGAA_STRUCTURE_TYPE_MEMORY_REPORT, (uint32_t)sizeof(AgaaMemoryReport), NULL, 0, 0, 0, 0.0, 0.0}

/* Memory of a view by the plan that would allocate it, for two frames in flight. caps null: an ideal device with every
 * feature. surfaces: two-call as above. log may be null. */
AGAA_API AgaaResult AGAA_CALL agaaQueryMemory(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                              const AgaaLog* log, AgaaMemoryReport* outReport,
                                              uint32_t* surfaceCount, AgaaSurface* surfaces);

/* The plan as JSON. Two-call: with text null, writes the size including the final zero. */
AGAA_API AgaaResult AGAA_CALL agaaPlanToJson(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                             const AgaaLog* log, size_t* size, char* text);

/* ---- host draw passes ----------------------------------------------------------------------- */

typedef enum AgaaDrawPassId {
    AGAA_DRAW_PASS_VISIBILITY = 1, /* depth and geometric normals */
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
 * choice and must be the same in all passes of a frame. Nothing that mixes, moves or takes away fragments:
 * no blending, logic operation, alpha-to-coverage, sample mask, depth bias, scissor or sRGB conversion. */
typedef struct AgaaDrawState {
    uint32_t depthCompare; /* AgaaCompare */
    uint32_t depthWrite;
    uint32_t stencilTest;  /* 1: pass where stencil EQUAL 0 (mask 0xFF), then INCREMENT_AND_CLAMP */
    uint32_t stencilTestMasked; /* the same for alpha-masked materials */
    uint32_t colorAttachmentCount;
    uint32_t colorWriteMask; /* RGBA bits 1, 2, 4, 8, the same for all attachments */
    uint32_t samples;        /* of the target */
    uint32_t sampleShading;  /* 1: one invocation per sample (minSampleShading 1) */
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
    uint32_t reserved;
} AgaaDrawTarget;

/* Draw the scene's opaque and alpha-masked geometry. The target is cleared. Vulkan: called with rendering
 * begun by the SDK, which also ends it; nothing is bound, viewport and scissor are unset. Commands are
 * recorded inline: the callback executes no command buffers of its own. OpenGL: as at agaaGlRecordFrame.
 * Return AGAA_OK, or any other value to give up the frame. Must not throw, must not call the SDK. */
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
    float position[3];  /* shading space */
    float direction[3]; /* unit, the way the light travels, shading space */
    float color[3];     /* irradiance (directional) or intensity, >= 0 */
    float range;        /* > 0, or 0: infinite */
    float cosInner;     /* spot: cosines of the half angles, inner >= outer */
    float cosOuter;
    float radius;       /* of the lamp, >= 0: the inverse-square law stops there */
    float reserved;     /* 0 */
} AgaaLight;

/* A shadow map is a 2D array of depth layers, each with its matrix. A point uses the first layer whose
 * clip volume holds it: one layer is a plain map, several in order of detail are cascades, six are the
 * faces of a cube. Points in no layer are lit. Compared as: lit where depth - bias <= stored. Where an
 * AgaaShadowFunction answers, layerCount is 0 and the rest is not read. */
typedef struct AgaaShadow {
    uint32_t layerCount; /* [1;AGAA_MAX_SHADOW_LAYERS], or 0: by the host's function */
    float depthBias;     /* in the map's depth, >= 0 */
    float matrices[AGAA_MAX_SHADOW_LAYERS][16]; /* shading space to the layer's clip space, z in [0,w] */
} AgaaShadow;

/* Segments of a frame, so that a host can use what one leaves before it records the next. */
#define AGAA_SEGMENT_PREPASS UINT64_C(0x1)    /* visibility */
#define AGAA_SEGMENT_GENERATION UINT64_C(0x2) /* definition and material passes */
#define AGAA_SEGMENT_SHADING UINT64_C(0x4)    /* with the draw pass FORWARD of "msaa" */
#define AGAA_SEGMENT_ALL UINT64_C(0x7)
/* The camera of a frame is that of its first segment; lights are read with AGAA_SEGMENT_SHADING. A frame
 * whose command buffer is discarded counts as completed. */

typedef struct AgaaFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t frameIndex;     /* increases by at least one each frame, from 1 */
    uint64_t completedFrame; /* newest frame whose GPU work is known to have finished; 0: none */
    uint64_t segments;       /* AGAA_SEGMENT_…, in order, each once per frame */
    float view[16];       /* shading to view space: a rotation, its translation is zero */
    float projection[16]; /* as the rasteriser uses it, sub-pixel jitter and the y flip of a negative viewport
                             height included */
    uint32_t lightCount;
    uint32_t shadowCount;
    const AgaaLight* lights;
    const AgaaShadow* shadows;
    float ambient[3];    /* radiance from all sides */
    float background[4]; /* colour; and 0 (with AGAA_VIEW_COMPOSITE): what the output holds instead */
    AgaaDrawCallback draw; /* null only where the host draws the G-buffer (AgaaGBufferFunction) */
    void* drawUser;
} AgaaFrame;
#define AGAA_FRAME_INIT                                                                             \
    {AGAA_STRUCTURE_TYPE_FRAME, (uint32_t)sizeof(AgaaFrame), NULL, 0, 0, AGAA_SEGMENT_ALL,           \
     {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {0}, 0, 0, NULL, NULL,                        \
     {0, 0, 0}, {0, 0, 0, 1}, NULL, NULL}

/* ---- statistics ------------------------------------------------------------------------------ */

/* Exact counts of one frame; all 0 without AGAA_CONFIG_COUNTERS. */
typedef struct AgaaCounters {
    uint64_t visible;       /* samples with geometry after the prepass */
    uint64_t once;          /* of these, accumulated, by one aggregate or more */
    uint64_t missed;        /* of these, never accumulated */
    uint64_t multi;         /* accumulated by a further aggregate, or where nothing is visible */
    uint64_t ties;          /* sample writes refused because an equal depth came first; counted by
                               NO_STENCIL and by masked materials, hidden by the stencil test */
    uint64_t sanitised;     /* fragments with a non-finite attribute */
    uint64_t shadingEvents; /* full lighting evaluations of a sample or an aggregate */
    uint64_t shadowTaps;
    uint64_t widenedLobes;  /* events whose specular lobe the NDF widened */
    uint64_t shadedPixels;  /* pixels with at least one event */
    uint64_t maxEventsPerPixel;
    uint64_t aggregates; /* or surfaces of "sbaa", of all pixels */
    uint64_t primitives; /* tier IDS: that samples show, of all pixels */
    uint64_t materials;  /* tier IDS: fetched, each for the samples of a primitive in a pixel */
    uint64_t misplaced; /* fragments of the first geometry pass that do not lie where the camera puts them;
                           few of slivers, whose positions extrapolate */
} AgaaCounters;

#define AGAA_MAX_PASSES 16
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
     {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 0, 0, {{{0}, 0, 0, 0.0}}, 0, 0, 0, 0, 0}

/* Figures of the newest frame, recorded whole, that is not after completedFrame: the newest whose GPU work
 * is known to have finished. AGAA_NOT_READY where there is none. */
AGAA_API AgaaResult AGAA_CALL agaaGetFrameStatistics(AgaaView view, uint64_t completedFrame,
                                                     AgaaFrameStatistics* outStatistics);

/* ---- validation for integrators ----------------------------------------------------------------- */

typedef struct AgaaInvalidPixel {
    uint32_t x, y;    /* pixel */
    uint32_t visible; /* bit i: sample i shows geometry after the prepass */
    uint32_t missed;  /* of these, never accumulated */
    uint32_t multi;   /* accumulated by two aggregates, or where nothing is visible */
} AgaaInvalidPixel;

#define AGAA_MAX_INVALID_PIXELS 8
/* Whether the geometry passes of a frame agree with each other and with the camera: each sample that the
 * prepass shows must be accumulated exactly once by the material pass, and fragments must lie where
 * AgaaFrame puts AgaaSurfaceInput::position. */
typedef struct AgaaFrameValidation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t frameIndex;
    uint64_t visible, once, missed, multi, ties; /* samples; as in AgaaCounters */
    uint64_t misplaced;                          /* fragments; as in AgaaCounters */
    uint64_t invalidPixels;                      /* with missed or multi samples */
    uint32_t isValid; /* 1: something visible, nothing missed or multi, misplaced at most a hundredth of visible */
    uint32_t pixelCount;
    AgaaInvalidPixel pixels[AGAA_MAX_INVALID_PIXELS]; /* the first that were found */
    char explanation[512]; /* what was found and what usually causes it */
} AgaaFrameValidation;
#define AGAA_FRAME_VALIDATION_INIT                                                                  \
    {AGAA_STRUCTURE_TYPE_FRAME_VALIDATION, (uint32_t)sizeof(AgaaFrameValidation), NULL, 0, 0, 0, 0, 0, \
     0, 0, 0, 0, 0, {{0, 0, 0, 0, 0}}, {0}}

/* Of the frame that agaaGetFrameStatistics would tell of. The view needs AGAA_CONFIG_COUNTERS. */
AGAA_API AgaaResult AGAA_CALL agaaValidateFrame(AgaaView view, uint64_t completedFrame,
                                                AgaaFrameValidation* outValidation);

/* Destroying null is legal. On OpenGL the context must be current. Every frame recorded with the object must have
 * finished. */
AGAA_API void AGAA_CALL agaaDestroyView(AgaaView view);
AGAA_API void AGAA_CALL agaaDestroyContext(AgaaContext context);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_SDK_H */
