/* What a view is: layout, settings, facts of the scene. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_CONFIG_H
#define AGAA_CONFIG_H

#include "agaa/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- G-buffer layout (AGAA section 4.3, figure 7) ------------------------------------------- */

typedef enum AgaaSemantic {
    AGAA_SEMANTIC_DIFFUSE = 0,   /* 3 channels: diffuse albedo */
    AGAA_SEMANTIC_SPECULAR = 1,  /* 3 channels: specular reflectance at normal incidence; with ROUGHNESS only */
    AGAA_SEMANTIC_NORMAL = 2,    /* 3 channels per aggregate, stored as 2 per sample */
    AGAA_SEMANTIC_ROUGHNESS = 3, /* 1 channel: alpha squared */
    AGAA_SEMANTIC_EMISSIVE = 4,  /* 3 channels, or 1: a factor of the diffuse albedo */
    AGAA_SEMANTIC_CUSTOM = 5,    /* 1 to 4 channels of the host's own. The SDK stores and filters them, and does not
                                    shade by them; agaaAggregate() of agaaGetAggregateGlsl() reads them. */
    AGAA_SEMANTIC_COUNT = 6,
    AGAA_SEMANTIC_MAX_ENUM = 0x7FFFFFFF
} AgaaSemantic;

typedef enum AgaaEncoding {
    AGAA_ENCODING_UNORM = 0, /* value / range in [0,1] */
    AGAA_ENCODING_YCBCR = 1, /* specular only: luma at `aggregateBits`, both chroma channels at `chromaBits` */
    AGAA_ENCODING_FOLDED = 2, /* roughness only: shortens the normal, takes no bits (aggregates). An aggregate in memory
                                 then cannot tell roughness from the spread of its normals: its diffuse term is not
                                 filtered, and rounding of the sums widens narrow lobes. */
    AGAA_ENCODING_MAX_ENUM = 0x7FFFFFFF
} AgaaEncoding;

/* How the values of samples become the value of their aggregate. */
typedef enum AgaaFilter {
    AGAA_FILTER_MEAN = 0,   /* the mean; values in [0;range] */
    AGAA_FILTER_NORMAL = 1, /* 3 channels, a unit vector per sample; an aggregate has the mean, as long as they agree */
    AGAA_FILTER_NONE = 2,   /* the value of one sample: the largest code of channel 0, then of 1, and so on. Values in
                               [0;range]; all channels of an aggregate in 32 bits */
    AGAA_FILTER_MAX_ENUM = 0x7FFFFFFF
} AgaaFilter;

#define AGAA_MAX_CUSTOM_CHANNELS 8
typedef struct AgaaLayoutAttribute {
    uint32_t semantic;      /* AgaaSemantic, each at most once but for CUSTOM; DIFFUSE and NORMAL are mandatory */
    uint32_t channels;      /* as at AgaaSemantic; AGAA_MAX_CUSTOM_CHANNELS of all CUSTOM attributes together */
    uint32_t sampleBits;    /* per channel in the multisampled G-buffer: 8, 10 (of three channels, not of normals) or
                               16; all together must fit four attachments */
    uint32_t aggregateBits; /* per channel and fragment before summing: [6;16]; 0: as many as n leaves of
                               16, or a whole 16 */
    uint32_t chromaBits;    /* YCBCR: [6;16] */
    uint32_t encoding;      /* AgaaEncoding */
    float range;            /* [1e-6;65504]: the value that full scale stands for; 1 except EMISSIVE and CUSTOM */
    uint32_t filter;        /* AgaaFilter of CUSTOM; 0 of others */
    const char* name;       /* CUSTOM: the member of AgaaSurfaceInput, AgaaMaterial and AgaaAggregate, a float or a vec of
                               `channels`. 1 to 31 letters, digits and single underscores. Begins with a letter, not with
                               gl_, agaa or AGAA. Not a keyword of GLSL, nor a member that those structs have. Read
                               during the call only. Null of others */
} AgaaLayoutAttribute;

#define AGAA_MAX_LAYOUT_ATTRIBUTES 13
typedef struct AgaaLayout {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t attributeCount;
    uint32_t reserved; /* 0 */
    AgaaLayoutAttribute attributes[AGAA_MAX_LAYOUT_ATTRIBUTES];
} AgaaLayout;

/* Built-in layouts: "paper16" (AGAA figure 7) and "precise", the default: per channel 16 bits of a sample, 10 of its
 * specular reflectance, and 11 or more of an aggregate; roughness beside the normal. The range of emission is 16 in both.
 * Writes all of *outLayout, which need not be initialised. AGAA_ERROR_LAYOUT for other names. */
AGAA_API AgaaResult AGAA_CALL agaaGetBuiltinLayout(const char* name, AgaaLayout* outLayout);

/* ---- configuration -------------------------------------------------------------------------- */

typedef enum AgaaBrdf {
    AGAA_BRDF_BLINN_PHONG = 0,
    AGAA_BRDF_GGX = 1,
    AGAA_BRDF_MAX_ENUM = 0x7FFFFFFF
} AgaaBrdf;

/* How the spread of normals inside an aggregate widens the specular lobe (AGAA section 3.5.2). The last two widen it
 * in each direction by the spread there, so that lobes are elliptic: for thin things that shine narrowly. They need
 * each normal: tier AUTO then is IDS with an AgaaFetchFunction, else GBUFFER; other tiers and AGAA_CONFIG_BUFFERED are
 * AGAA_ERROR_UNSUPPORTED. Without a specular lobe, and for techniques other than "agaa", they are TOKSVIG. */
typedef enum AgaaNdf {
    AGAA_NDF_NONE = 0,    /* no widening: for ablation */
    AGAA_NDF_TOKSVIG = 1, /* all around alike, by the length of the mean normal (Toksvig 2005) */
    AGAA_NDF_LEAN = 2,    /* twice the variance of slopes on top of alpha squared (Olano and Baker 2010) */
    AGAA_NDF_SGGX = 3,    /* projected areas added up (Heitz et al. 2015): narrower than LEAN */
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
    AGAA_TIER_NV_MULTICAST = 2,  /* reserved: AGAA_ERROR_UNSUPPORTED */
    AGAA_TIER_SCALED_TARGET = 3, /* a target of SX x SY sub-pixels at the device's sample count */
    AGAA_TIER_LAYERS = 4,        /* reserved: AGAA_ERROR_UNSUPPORTED */
    /* generation */
    AGAA_TIER_NV_MIXED_SAMPLES = 16,  /* the paper's: additive blending with coverage override. A model: agaaQueryMemory
                                         and agaaPlanToJson price it, views of it are AGAA_ERROR_UNSUPPORTED */
    AGAA_TIER_POST_DEPTH_ATOMICS = 17, /* fragment coverage after the depth test, integer atomics */
    AGAA_TIER_PER_SAMPLE = 18,         /* one invocation per sample, integer atomics */
    AGAA_TIER_GBUFFER = 19, /* one geometry pass into a full multisampled G-buffer, whose samples a compute pass
                               aggregates */
    AGAA_TIER_IDS = 20, /* one geometry pass into depth and ids, by which materials are fetched (AgaaFetchFunction) */
    AGAA_TIER_MAX_ENUM = 0x7FFFFFFF
} AgaaTier;

/* Bits of AgaaConfig::flags. */
#define AGAA_CONFIG_COUNTERS UINT64_C(0x01)   /* count events; see AgaaCounters. AGAA_ERROR_UNSUPPORTED without
                                                 AGAA_DEVICE_FRAGMENT_ATOMICS */
#define AGAA_CONFIG_TIMESTAMPS UINT64_C(0x02) /* time each pass */
#define AGAA_CONFIG_READBACK UINT64_C(0x04)   /* surfaces may be copied from; no aliasing */
#define AGAA_CONFIG_NO_DIFFUSE_FILTER UINT64_C(0x08)
#define AGAA_CONFIG_NO_SHADOW_FILTER UINT64_C(0x10) /* one tap at the aggregate's mean position */
#define AGAA_CONFIG_SHADOW_ALONG_DEPTH UINT64_C(0x80) /* AGAA 3.5.3: taps along the view ray by the
                                                         aggregate's depth variance, not at samples, within
                                                         the depths of its samples */
#define AGAA_CONFIG_NO_STENCIL UINT64_C(0x20) /* first come, first kept; not repeatable on ties */
#define AGAA_CONFIG_FIRST_SAMPLE_ROUTING UINT64_C(0x40) /* AGAA algorithm 2, step 2 (c), for comparison: 4 bytes
                                                               a pixel more */
#define AGAA_CONFIG_SPLIT_SURFACES UINT64_C(0x200) /* of "agaa": samples of one surface are clustered like all
                                                      others (AGAA 3.3), so that distance may part them */
#define AGAA_CONFIG_BUFFERED UINT64_C(0x400) /* of "agaa": aggregates go to memory, the surface "aggregates", and a
                                                pass of its own shades them, by the tiers IDS and GBUFFER too; not
                                                with litShadows, nor with ndf from LEAN on */
#define AGAA_CONFIG_FINE_MATERIALS UINT64_C(0x800) /* of the tier IDS: a primitive's material is evaluated in each
                                                      texel of the target that shows it, where a G-buffer's is: the
                                                      centre, or the first sample that the primitive covers.
                                                      Derivatives of normals are not used.
                                                      AgaaCounters::materials counts the evaluations */

/* What the output shows of each pixel in place of its image: numbers and shares in all channels, or a colour. Not of
 * "msaa", whose shading is the host's. Beyond what is covered: 0. A view that does not apply is
 * AGAA_ERROR_UNSUPPORTED. */
typedef enum AgaaDebugView {
    AGAA_DEBUG_VIEW_NONE = 0,
    AGAA_DEBUG_VIEW_EVENTS = 1,     /* shading events */
    AGAA_DEBUG_VIEW_AGGREGATES = 2, /* aggregates of "agaa", or surfaces kept by "sbaa" */
    AGAA_DEBUG_VIEW_CLUSTERS = 3,   /* of these a colour each, in the share of its samples */
    AGAA_DEBUG_VIEW_PRIMITIVES = 4, /* tier IDS, not BUFFERED: primitives that samples show */
    AGAA_DEBUG_VIEW_LIT = 5,        /* share of the light of AgaaFrame::shadows[0] that gets to what is covered; 1
                                       without shadows */
    AGAA_DEBUG_VIEW_WIDENED = 6,    /* by how much the NDF widened lobes: alpha of GGX, of elliptic ones where they are
                                       the widest, mean over what is covered; of "agaa" and "sbaa", and of layouts that
                                       keep roughness beside the normal */
    AGAA_DEBUG_VIEW_TIER = 7,       /* grey: not aggregated; orange: by two passes; blue: from a G-buffer; green: by
                                       ids; half as bright where one shading event did. Draws that were not fetched are
                                       blue, but with AGAA_CONFIG_BUFFERED, where materials are aggregates already */
    AGAA_DEBUG_VIEW_MAX_ENUM = 0x7FFFFFFF
} AgaaDebugView;

typedef struct AgaaConfig {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* technique;    /* "single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa" */
    uint32_t samples;         /* n, visibility samples per pixel: 1, 2, 4, 8, 16, 32; "single" and "fxaa" have 1 */
    uint32_t aggregates;      /* c of "agaa", [1;4]; S, surfaces kept, of "sbaa", [1;6]; no more than n are made */
    const AgaaLayout* layout; /* null: "precise" */
    uint32_t brdf;            /* AgaaBrdf */
    uint32_t ndf;             /* AgaaNdf */
    /* What counts as one surface: shaded once by "simple_complex" and "sbaa", one aggregate of "agaa". 0: as the
     * technique has it. */
    float surfaceCosine;   /* least cosine between normals, [0;1] */
    float surfaceDistance; /* from the surface's plane, in widths of a pixel at its depth, [0;1e6] */
    float surfaceMaterial; /* largest difference of a material's channel, [0;1]; read by "simple_complex" */
    uint32_t shadowTaps;      /* most samples of an aggregate that are looked up in each shadow, [0;32]; 0: 8. Shadows
                                 alone depend on it: the aggregate's position is the mean of all its samples. */
    uint32_t visibilityTier;  /* AgaaTier; AUTO: best that runs */
    uint32_t generationTier;  /* AgaaTier; AUTO: best that runs; of "agaa", not BUFFERED, GBUFFER where no storage
                                 buffer of the device holds the aggregates */
    uint32_t shadingCost;     /* [1;64]: lighting is evaluated this many times, for measurements */
    uint32_t debugView;       /* AgaaDebugView */
    uint64_t flags;           /* AGAA_CONFIG_… */
} AgaaConfig;
#define AGAA_CONFIG_INIT                                                                            \
    {AGAA_STRUCTURE_TYPE_CONFIG, (uint32_t)sizeof(AgaaConfig), NULL, "agaa", 8, 2, NULL,             \
     AGAA_BRDF_GGX, AGAA_NDF_TOKSVIG, 0.0f, 0.0f, 0.0f, 0,                                           \
     AGAA_TIER_AUTO, AGAA_TIER_AUTO, 1, 0, 0}

/* Settings of "agaa" and "sbaa": how samples are grouped. Chained to AgaaConfig; without it they have these defaults.
 * Other techniques check the struct and do not use it, so that a host may chain the settings of all techniques. */
typedef struct AgaaAggregation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    float characteristicLength;            /* k of equation 1, in host units, [0;inf) */
    float characteristicLengthPerDistance; /* k is at least this times the distance of the pixel's nearest sample,
                                              [0;1]; k > 0. In an orthographic view, half the view's width stands for
                                              the distance, as in a perspective view of 90 degrees. */
    float aggregateThreshold; /* t: a further aggregate must be farther than this, [0;1e6] */
    uint32_t seeds;           /* AgaaSeeds; of "agaa" */
    /* Of "agaa". Bit i: lights of AgaaFrame::shadows[i] are shaded by means over the samples of an aggregate that they
     * reach, times the share of those samples, so that lit and unlit samples may differ in normal and colour. One tap a
     * sample replaces shadowTaps. Shadows that AgaaSceneFacts does not declare are left out. Requires the tier IDS or
     * GBUFFER without AGAA_CONFIG_BUFFERED. AUTO selects one of them; any other tier fails with
     * AGAA_ERROR_UNSUPPORTED. */
    uint32_t litShadows;
    /* Of "agaa", [0;16]. Shading normals differ by glossWeight / alpha as much in equation 1, [1;20], alpha of GGX, up
     * to the term's largest value of 1. Equal normals of different gloss differ too. Glossy surfaces are split earlier.
     * 0: by normals alone; so it is without specular light. Requires the tier IDS or GBUFFER, which know materials when
     * they group samples. AUTO selects one of them; any other tier fails with AGAA_ERROR_UNSUPPORTED. */
    float glossWeight;
} AgaaAggregation;
#define AGAA_AGGREGATION_INIT                                                                       \
    {AGAA_STRUCTURE_TYPE_AGGREGATION, (uint32_t)sizeof(AgaaAggregation), NULL, 0.0f, 0.03f, 0.02f,   \
     AGAA_SEEDS_MAXIMIN, 0, 0.0f}

/* Applies named settings of "agaa", from measurements (docs/choosing.md). "paper" follows the paper's sections, except
 * that each sample goes to its own aggregate (AGAA_CONFIG_FIRST_SAMPLE_ROUTING) and that k keeps its value (the paper:
 * 10 cm). The others are "fast", "balanced" and "accurate".
 *
 * config       Receives technique, aggregates, surface…, shadowTaps, ndf, and the flags of clustering, filters and
 *              materials. All else keeps its value, pNext too.
 * aggregation  Receives aggregateThreshold, seeds, litShadows (the first shadow) and glossWeight. All else keeps its
 *              value. Chain it to config.
 *
 * "balanced" and "accurate" need materials where samples are grouped: without an AgaaFetchFunction, tier AUTO is GBUFFER.
 *
 * Errors       AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or the name is not known
 *              AGAA_ERROR_STRUCT             a struct was not initialised
 *              AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, or one twice, or does not end
 *              Both structs then keep all their values. */
AGAA_API AgaaResult AGAA_CALL agaaApplyPreset(const char* name, AgaaConfig* config, AgaaAggregation* aggregation);

/* What the scene calls for. The planner drops what is not named here. */
#define AGAA_FACT_SPECULAR UINT64_C(0x01)
#define AGAA_FACT_EMISSIVE UINT64_C(0x02)
#define AGAA_FACT_ALPHA_MASKED UINT64_C(0x04)
#define AGAA_FACT_AMBIENT UINT64_C(0x08)
#define AGAA_FACT_CUSTOM_DEPTH UINT64_C(0x10) /* materials write depth or discard on their own, so that no pass can draw
                                                 them again at equal depth: "agaa" and "sbaa" take the tier GBUFFER
                                                 ("agaa" with an AgaaFetchFunction IDS); "msaa" is
                                                 AGAA_ERROR_UNSUPPORTED */
#define AGAA_FACT_ALL_SHADED (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT)

#define AGAA_MAX_SHADOW_MAPS 4
#define AGAA_MAX_SHADOW_LAYERS 6
typedef struct AgaaSceneFacts {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t flags;          /* AGAA_FACT_… */
    uint32_t maxLights;      /* [0;4096]; of "msaa" with AGAA_GL_STORAGE_IMAGES at most 16 KiB of them, or
                                AGAA_ERROR_UNSUPPORTED, which says how many */
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

#ifdef __cplusplus
}
#endif
#endif /* AGAA_CONFIG_H */
