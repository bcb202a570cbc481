/* The description of a view: layout, settings, scene facts. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_CONFIG_H
#define AGAA_CONFIG_H

#include "agaa/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- G-buffer layout (AGAA section 4.3, figure 7) ------------------------------------------- */

typedef enum AgaaSemantic {
    AGAA_SEMANTIC_DIFFUSE = 0,   /* 3 channels: diffuse albedo. Required */
    AGAA_SEMANTIC_SPECULAR = 1,  /* 3 channels: specular reflectance at normal incidence. Requires ROUGHNESS */
    AGAA_SEMANTIC_NORMAL = 2,    /* 3 channels per aggregate, stored as 2 per sample. Required */
    AGAA_SEMANTIC_ROUGHNESS = 3, /* 1 channel: alpha squared */
    AGAA_SEMANTIC_EMISSIVE = 4,  /* 3 channels, or 1: a factor of the diffuse albedo */
    AGAA_SEMANTIC_CUSTOM = 5,    /* 1 to 4 channels of the host. The SDK stores and filters them, but does not shade
                                    with them; agaaAggregate() of agaaGetAggregateGlsl reads them */
    AGAA_SEMANTIC_COUNT = 6,
    AGAA_SEMANTIC_MAX_ENUM = 0x7FFFFFFF
} AgaaSemantic;

typedef enum AgaaEncoding {
    AGAA_ENCODING_UNORM = 0, /* value / range in [0, 1] */
    AGAA_ENCODING_YCBCR = 1, /* SPECULAR only: luma with aggregateBits, each chroma channel with chromaBits */
    /* ROUGHNESS only: an aggregate shortens its mean normal by the roughness and stores no roughness. Such an aggregate
     * in memory does not distinguish roughness from the spread of its normals: its diffuse term is not filtered, and
     * the rounding of the sums widens narrow specular lobes. */
    AGAA_ENCODING_FOLDED = 2,
    AGAA_ENCODING_MAX_ENUM = 0x7FFFFFFF
} AgaaEncoding;

/* Selects how an aggregate combines the values of its samples. */
typedef enum AgaaFilter {
    AGAA_FILTER_MEAN = 0,   /* the mean. Values are in [0, range] */
    AGAA_FILTER_NORMAL = 1, /* 3 channels, a unit vector per sample. The aggregate has the mean vector, whose length
                               measures how well the vectors agree */
    AGAA_FILTER_NONE = 2,   /* the value of one sample: the one with the largest code of channel 0, then of channel 1,
                               and so on. Values are in [0, range]; all channels of an aggregate fit 32 bits */
    /* 1 channel, the number of a material class: an integer in [0, 255]. aggregateBits is 0 or 8, and range 255; a
     * layout has one at most. "agaa" puts no samples of different classes into one aggregate as long as
     * AgaaConfig::aggregates allows it. Where a pixel has more classes, those with the fewest samples join the most
     * similar aggregates of others. An aggregate has the class of more than half of its samples, or one of theirs; with
     * two geometry passes, it has that of the fragment with the most samples, and of equally many the largest number.
     * AgaaCounters::joinedClasses counts the samples that joined, except with one aggregate. The tier FRAGMENTS gives
     * aggregates to the classes of a pixel's 32 largest fragments. With two geometry passes, the shaders of the
     * visibility pass set the attribute, too (AGAA_NEEDS_MATERIAL is 1). In other techniques, surfaces of several
     * classes may be shaded together: as the class of the sample that represents them or, in "dcaa", of the larger
     * part at each merge. agaaApplyPreset() selects one more aggregate, up to 4. */
    AGAA_FILTER_CLASS = 3,
    AGAA_FILTER_MAX_ENUM = 0x7FFFFFFF
} AgaaFilter;

#define AGAA_MAX_CUSTOM_CHANNELS 8
typedef struct AgaaLayoutAttribute {
    uint32_t semantic;      /* AgaaSemantic. Each occurs at most once, except CUSTOM */
    uint32_t channels;      /* the number that AgaaSemantic states. CUSTOM attributes together have at most
                               AGAA_MAX_CUSTOM_CHANNELS */
    uint32_t sampleBits;    /* bits per channel in the multisampled G-buffer: 8, 16, or 10 for 3 channels other than
                               NORMAL. All attributes together must fit four attachments */
    uint32_t aggregateBits; /* bits per channel and sample before summing, [6, 16]. 0 selects the most with which the
                               sum of n samples fits 16 bits or a whole word */
    uint32_t chromaBits;    /* YCBCR: [6, 16] */
    uint32_t encoding;      /* AgaaEncoding */
    float range;            /* value of full scale, [1e-6, 65504]. It must be 1 for all semantics except EMISSIVE and
                               CUSTOM, and for AGAA_FILTER_NORMAL */
    uint32_t filter;        /* AgaaFilter for CUSTOM, 0 for all others */
    /* CUSTOM: the name of the member of AgaaSurfaceInput, AgaaMaterial, AgaaAggregate and, in views with an
     * AgaaShadingFunction, AgaaSurface, which is a float or a vec of `channels`. It has 1 to 31 letters, digits and
     * single underscores. It begins with a letter, and not with gl_, agaa or AGAA. It is neither a GLSL keyword nor a
     * member that these structs already have. Read during the call only. Null for all others. */
    const char* name;
    uint64_t reserved[2]; /* 0 */
} AgaaLayoutAttribute;
#define AGAA_LAYOUT_ATTRIBUTE_INIT                                                                                     \
    {                                                                                                                  \
        0, 0, 0, 0, 0, 0, 1.0f, 0, NULL, { 0, 0 }                                                                      \
    }
AGAA_API void AGAA_CALL agaaInitLayoutAttribute(AgaaLayoutAttribute* outAttribute);

#define AGAA_MAX_LAYOUT_ATTRIBUTES 13
/* The layout of a sample and of an aggregate. A member of the layout or of an attribute that has no valid value
 * fails with AGAA_ERROR_LAYOUT; a reserved member that is not 0 fails with AGAA_ERROR_OUT_OF_RANGE. */
typedef struct AgaaLayout {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    uint32_t attributeCount; /* [2, AGAA_MAX_LAYOUT_ATTRIBUTES] */
    uint32_t reserved;       /* 0 */
    AgaaLayoutAttribute attributes[AGAA_MAX_LAYOUT_ATTRIBUTES];
} AgaaLayout;
#define AGAA_LAYOUT_INIT                                                                                               \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_LAYOUT, (uint32_t)sizeof(AgaaLayout), NULL, 0, 0, {                                        \
            {                                                                                                          \
                0, 0, 0, 0, 0, 0, 0.0f, 0, NULL, { 0, 0 }                                                              \
            }                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitLayout(AgaaLayout* outLayout, size_t structSize);

/* Gets a built-in layout.
 *
 * name        "paper16" (AGAA figure 7) or "precise", the default of AgaaConfig::layout: 16 bits per channel of a
 *             sample, 10 for its specular reflectance, 11 or more per channel of an aggregate, roughness beside the
 *             normal. The range of emission is 16 in both. agaaGetNames lists the names.
 * outLayout   Initialised. Receives the layout; unchanged on failure.
 *
 * Errors      AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *             AGAA_ERROR_STRUCT             outLayout is not initialised
 *             AGAA_ERROR_LAYOUT             no layout has this name
 * Threads     Any. */
AGAA_API AgaaResult AGAA_CALL agaaGetBuiltinLayout(const char* name, AgaaLayout* outLayout);

/* ---- configuration -------------------------------------------------------------------------- */

typedef enum AgaaBrdf { AGAA_BRDF_BLINN_PHONG = 0, AGAA_BRDF_GGX = 1, AGAA_BRDF_MAX_ENUM = 0x7FFFFFFF } AgaaBrdf;

/* Selects how the spread of normals in an aggregate widens the specular lobe (AGAA section 3.5.2). LEAN and SGGX
 * widen it by the spread in each direction, so that lobes become elliptic: use them for thin geometry with sharp
 * highlights. Up to 32 samples, AUTO selects IDS with an AgaaFetchFunction and GBUFFER without, which read the normal
 * of each sample when they shade. Aggregates in memory, those of two geometry passes or of AGAA_CONFIG_BUFFERED, keep
 * second moments of the normals in 20 bytes more each (AGAA section 3.4.1). A layout with folded roughness cannot have
 * them there, and NV_MIXED_SAMPLES keeps none: these fail with AGAA_ERROR_UNSUPPORTED. "dcaa" keeps the spread of a
 * surface's normals in 8 bytes more. Other techniques, and views without specular light, use TOKSVIG instead. */
typedef enum AgaaNdf {
    AGAA_NDF_NONE = 0,    /* no widening, for ablation */
    AGAA_NDF_TOKSVIG = 1, /* isotropic, by the length of the mean normal (Toksvig 2005) */
    AGAA_NDF_LEAN = 2,    /* adds twice the variance of slopes to alpha squared (Olano and Baker 2010) */
    AGAA_NDF_SGGX = 3,    /* adds projected areas (Heitz et al. 2015); narrower than LEAN */
    AGAA_NDF_MAX_ENUM = 0x7FFFFFFF
} AgaaNdf;

/* An implementation of a stage. agaaQueryCapabilities lists the tiers that run on a device. */
typedef enum AgaaTier {
    AGAA_TIER_AUTO = 0,
    /* visibility */
    AGAA_TIER_NATIVE = 1,        /* a target of the device's own n samples */
    AGAA_TIER_NV_MULTICAST = 2,  /* LAYERS, where one draw reaches all layers by viewport multicast (AGAA 4.4). Requires
                                    AGAA_DEVICE_NV_MULTICAST. Not yet run on a device, so AUTO does not select it */
    AGAA_TIER_SCALED_TARGET = 3, /* a target of scaleX x scaleY texels per pixel, with fewer samples per texel */
    AGAA_TIER_LAYERS = 4,        /* 2, 4 or 8 layers with fewer samples each, at other places in the pixel (AGAA 4.4).
                                    n is 2, 4, 8, 16 or 32; coverage samples have no layers. Derivatives are those of
                                    the pixel. Layers lie one below the other in one target. The host draws everything
                                    once for each layer (AgaaDrawTarget::viewports), and its viewports keep fractions of
                                    a pixel. With AGAA_DEVICE_SAMPLE_LOCATIONS the samples are spread over the pixel
                                    like those of SCALED_TARGET. Otherwise they lie around the standard locations of
                                    n/2, n/4 or n/8 samples, at most 8, and edges are coarser (docs/techniques.md). AUTO
                                    does not select it. It excludes AgaaGBufferFunction (AGAA_ERROR_UNSUPPORTED) */
    AGAA_TIER_ORDERED_GRID = 5,  /* 4, 9 or 16 samples: 2x2, 3x3 or 4x4 texels of one sample each */
    /* generation */
    AGAA_TIER_NV_MIXED_SAMPLES = 16,   /* the paper's method: additive blending into colour attachments with a sample
                                          for each aggregate. Requires AGAA_DEVICE_NV_MIXED_SAMPLES, the device's own
                                          n samples, AGAA_DEVICE_POST_DEPTH_COVERAGE for n > 1, a format of depth and
                                          stencil (AGAA_DEVICE_D32S8, or D24S8 if depth is not reversed) without
                                          AGAA_MEASURE_NO_STENCIL, attributes that are filtered, round lobes, and at
                                          most 8 attachments that the device blends (AGAA_ERROR_UNSUPPORTED). Not yet
                                          run on a device, so AUTO does not select it. For "sbaa"
                                          it is the papers' memory: agaaQueryMemory and agaaPlanToJson accept it,
                                          agaa…CreateView fails with AGAA_ERROR_UNSUPPORTED */
    AGAA_TIER_POST_DEPTH_ATOMICS = 17, /* coverage after the depth test, integer atomics */
    AGAA_TIER_PER_SAMPLE = 18,         /* one invocation per sample, integer atomics */
    AGAA_TIER_GBUFFER = 19, /* one geometry pass into a multisampled G-buffer; a compute pass aggregates its samples */
    AGAA_TIER_IDS = 20,     /* one geometry pass into depth and ids; compute passes fetch the materials by id
                               (AgaaFetchFunction) */
    AGAA_TIER_FRAGMENT_LISTS = 21, /* one geometry pass appends each fragment to a list of its pixel; a compute pass
                                      merges the lists from front to back (AgaaFetchFunction) */
    AGAA_TIER_FRAGMENTS = 22,      /* "agaa" at 32, 64 or 128 coverage samples: the same lists; a compute pass clusters
                                      the fragments that show, and shades the aggregates (AgaaFetchFunction). AUTO
                                      selects it at 64 and 128 */
    AGAA_TIER_MATERIAL_LISTS = 23, /* "dcaa": FRAGMENT_LISTS with fragments that carry their materials. The host's
                                      fragment shader evaluates them */
    AGAA_TIER_FRAGMENT_INTERLOCK = 24, /* "dcaa": no lists. The host's fragment shader evaluates the materials and
                                          merges each fragment, in the order of the draws. AUTO does not select it */
    AGAA_TIER_RASTER_ORDER = 25, /* "dcaa": like FRAGMENT_INTERLOCK, but fragment shaders read the attachments. Up to
                                    eight attachments hold the surfaces: 128 bytes per pixel. AUTO does not select it */
    AGAA_TIER_MAX_ENUM = 0x7FFFFFFF
} AgaaTier;

/* Bits of AgaaConfig::flags. */
/* Count events (AgaaCounters). A device without AGAA_DEVICE_FRAGMENT_ATOMICS fails with AGAA_ERROR_UNSUPPORTED. */
#define AGAA_CONFIG_COUNTERS UINT64_C(0x01)
/* Measure the time of each pass. */
#define AGAA_CONFIG_TIMESTAMPS UINT64_C(0x02)
/* The host may copy from surfaces; surfaces do not share memory. */
#define AGAA_CONFIG_READBACK UINT64_C(0x04)
/* "agaa": cluster samples of one surface like all others (AGAA 3.3), so that their distance may separate them. */
#define AGAA_CONFIG_SPLIT_SURFACES UINT64_C(0x08)
/* "agaa": with the tiers IDS and GBUFFER too, aggregates go to the surface "aggregates", and a pass of its own
 * shades them. Excludes litShadows, elliptic NDFs with layouts of folded roughness, and the tier FRAGMENTS. */
#define AGAA_CONFIG_BUFFERED UINT64_C(0x10)
/* Tier IDS of "agaa": evaluate a primitive's material for each texel of the target that shows it, at the point
 * where a G-buffer pass evaluates it: the centre, or the first covered sample. Derivatives of normals are not
 * used. AgaaCounters::materials counts the evaluations. */
#define AGAA_CONFIG_FINE_MATERIALS UINT64_C(0x20)

/* Accumulate the image over frames (agaa/temporal.h), as "taa" always does. A technique or tier without a depth buffer
 * ("dcaa", FRAGMENTS) fails with AGAA_ERROR_UNSUPPORTED. Debug views are not accumulated. */
#define AGAA_CONFIG_ACCUMULATE UINT64_C(0x80)

/* Weight the light of each shading event of a pixel by 1 / (1 + exposure * luminance) (Karis 2013), so that edges
 * between surfaces of very different brightness stay smooth after tone mapping. The output stays linear: it is the
 * weighted mean. The background counts as an event. AgaaFrame::exposure is the exposure. A luminance above
 * 65536 / exposure is scaled down to it, also where a pixel shows nothing else. Debug views and techniques with one
 * sample do not change. Hosts that shade aggregates themselves weigh them themselves. */
#define AGAA_CONFIG_HDR_RESOLVE UINT64_C(0x100)

/* Record which pass the device began last and which it ended last (agaaGetBreadcrumbs), to find the pass that hangs or
 * loses the device. Passes then do not overlap on the device. OpenGL needs version 4.4 or GL_ARB_buffer_storage;
 * without both a view fails with AGAA_ERROR_UNSUPPORTED. */
#define AGAA_CONFIG_BREADCRUMBS UINT64_C(0x200)

/* Compare each material with AgaaSceneFacts (agaaGetFactReport). Implies AGAA_CONFIG_COUNTERS. */
#define AGAA_CONFIG_CHECK_FACTS UINT64_C(0x40)

/* Settings of a view. AgaaAggregation, AgaaDecoupledCoverage, AgaaAdaptiveSampling, AgaaTemporal and AgaaMeasurement
 * may be chained. A struct that is not chained has its defaults. */
typedef struct AgaaConfig {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* technique;    /* "single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                 "sbaa", "agaa", "dcaa", "sgbc" or "adaptive". "sgbc" is "dcaa" whose samples keep
                                 their depths: what is said of "dcaa" holds for it, except that it fails with
                                 AGAA_ERROR_UNSUPPORTED with AGAA_COVERAGE_EXACT, AGAA_COVERAGE_DEPTH_PREPASS and
                                 the tiers FRAGMENT_INTERLOCK and RASTER_ORDER */
    uint32_t samples;         /* n, visibility samples per pixel: 1, 2, 4, 8, 16 or 32; the first four use 1.
                                 "msaa", "ssaa", "simple_complex" and "adaptive" also accept 9, on the tier
                                 ORDERED_GRID. "dcaa", and "agaa" with the tier FRAGMENTS, have 32, 64 or 128
                                 coverage samples per pixel */
    uint32_t aggregates;      /* c, aggregates of "agaa", [1, 4]; S, surfaces of "sbaa", [1, 6], and of "dcaa",
                                 [1, 8]. A pixel has at most n of them. Other techniques accept [1, 8] and do not use
                                 it */
    const AgaaLayout* layout; /* null: "precise" */
    uint32_t brdf;            /* AgaaBrdf */
    uint32_t ndf;             /* AgaaNdf */
    /* Samples within these three thresholds count as one surface: "simple_complex" and "sbaa" shade it once,
     * "visibility" gives it the light of one event, "agaa" makes one aggregate of it, "adaptive" shades one of its
     * samples or more. 0 selects the default of the technique. */
    float surfaceCosine;     /* smallest cosine between normals, [0, 1] */
    float surfaceDistance;   /* largest distance from the surface's plane, in pixel widths at its depth, [0, 1e6] */
    float surfaceMaterial;   /* largest difference of a material channel, [0, 1]; only "simple_complex" and "adaptive"
                                read it */
    uint32_t shadowTaps;     /* largest number of samples of an aggregate that are looked up in each shadow map, [0,
                                32]; 0 selects 8. It affects shadows only: the position of an aggregate is the mean of
                                all its samples */
    uint32_t visibilityTier; /* AgaaTier. AUTO selects the best tier that runs. A tier that cannot run fails with
                                AGAA_ERROR_UNSUPPORTED */
    uint32_t generationTier; /* AgaaTier. AUTO selects the best tier that runs; GBUFFER if the aggregates fit no
                                storage buffer of the device. A tier that cannot run fails with
                                AGAA_ERROR_UNSUPPORTED. Only "agaa", "sbaa", "dcaa" and "adaptive" use it */
    uint64_t flags;          /* AGAA_CONFIG_… */
} AgaaConfig;
#define AGAA_CONFIG_INIT                                                                                               \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_CONFIG, (uint32_t)sizeof(AgaaConfig), NULL, "agaa", 8, 2, NULL, AGAA_BRDF_GGX,             \
            AGAA_NDF_TOKSVIG, 0.0f, 0.0f, 0.0f, 0, AGAA_TIER_AUTO, AGAA_TIER_AUTO, 0                                   \
    }
AGAA_API void AGAA_CALL agaaInitConfig(AgaaConfig* outConfig, size_t structSize);

/* Controls how "agaa" and "sbaa" group samples. Chain it to AgaaConfig. Other techniques check the struct and do not
 * use it, so that a host may chain it for all techniques. */
typedef struct AgaaAggregation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    float characteristicLength;            /* k of equation 1, in host units, [0, inf) */
    float characteristicLengthPerDistance; /* k is at least this factor times the distance of the pixel's nearest
                                              sample, [0, 1]. k must be > 0. In an orthographic view, half the width
                                              of the view replaces the distance, as in a perspective view of 90
                                              degrees */
    float aggregateThreshold; /* t: samples start a further aggregate only if they are farther than this from all
                                 others, [0, 1e6] */
    /* "agaa": bit i in [0, AGAA_MAX_SHADOW_MAPS) selects AgaaFrame::shadows[i]. Its lights shade an aggregate with
     * the means over the lit samples, times the share of lit samples, so that lit and unlit samples may differ in
     * normal and colour. One tap per sample replaces shadowTaps. Bits from AgaaSceneFacts::shadowMapCount on have no
     * effect. Requires the tier FRAGMENTS, or IDS or GBUFFER without AGAA_CONFIG_BUFFERED. AUTO selects one of them;
     * any other tier fails with AGAA_ERROR_UNSUPPORTED. */
    uint32_t litShadows;
    /* "agaa": scale of the difference of shading normals in equation 1, [0, 16]. The difference is multiplied by
     * glossWeight / alpha, clamped to [1, 20], where alpha is GGX alpha. The term stays at most 1. Equal normals
     * with different roughness differ too. Glossy surfaces are split earlier. Normals alone count if glossWeight is
     * 0 or the view has no specular light. Requires the tier IDS, FRAGMENTS or GBUFFER, which know materials before
     * they group samples. AUTO selects one of them; any other tier fails with AGAA_ERROR_UNSUPPORTED. */
    float glossWeight;
    uint32_t reserved; /* 0 */
} AgaaAggregation;
#define AGAA_AGGREGATION_INIT                                                                                          \
    { AGAA_STRUCTURE_TYPE_AGGREGATION, (uint32_t)sizeof(AgaaAggregation), NULL, 0.0f, 0.03f, 0.02f, 0, 0.0f, 0 }
AGAA_API void AGAA_CALL agaaInitAggregation(AgaaAggregation* outAggregation, size_t structSize);

/* Selects how "dcaa" merges fragments into the surfaces of a pixel. In "sgbc", fragments merge only into surfaces with
 * which they share no sample; PAPER and NONE drop the fragment in a full pixel with the samples that it shows, which
 * then show the background (Kerzner and Salvi 2014). */
typedef enum AgaaMerge {
    AGAA_MERGE_VISIBLE = 0, /* surfaces count by the samples that they show. A fragment merges into a surface of
                               similar normal whose depths overlap if they share no sample. In a full pixel, the pair
                               with the least cost merges, so that no sample is lost */
    AGAA_MERGE_PAPER = 1,   /* DCAA algorithm 1: merging does not depend on shared samples. In a full pixel, the
                               surface that shows least merges into one whose depths overlap, or is dropped */
    AGAA_MERGE_NONE = 2,    /* PAPER without the merge in a full pixel, for comparison */
    AGAA_MERGE_COLOR = 3,   /* VISIBLE; in a full pixel, differences of the sum of diffuse colour and reflectance count
                               as differences of normals do (DCAA section 5.3 proposes it) */
    AGAA_MERGE_MAX_ENUM = 0x7FFFFFFF
} AgaaMerge;

/* Bits of AgaaDecoupledCoverage::flags. */
/* Keep all fragments and shade those that show at a sample: the reference for AgaaMerge. AgaaConfig::aggregates is
 * not used. Requires a tier with lists; otherwise the view fails with AGAA_ERROR_UNSUPPORTED. The tier MATERIAL_LISTS
 * rounds depth planes and materials as the layout stores them. */
#define AGAA_COVERAGE_EXACT UINT64_C(0x01)
/* Lists keep the order of the host's draws, as in DCAA (section 3.2). By default they are sorted by depth, so that the
 * order of the draws changes no pixel except at equal depths. The tiers FRAGMENT_INTERLOCK and RASTER_ORDER merge in
 * the order of the draws with and without the flag. */
#define AGAA_COVERAGE_DRAW_ORDER UINT64_C(0x02)
/* Fragments merge from the last draw to the first, for measurements of what the order changes. It implies DRAW_ORDER.
 * The tiers FRAGMENT_INTERLOCK and RASTER_ORDER fail with AGAA_ERROR_UNSUPPORTED. */
#define AGAA_COVERAGE_REVERSE_ORDER UINT64_C(0x08)
/* The host draws the pass VISIBILITY first, with the largest number of samples of the device up to 8, depth only. Where
 * its samples in a pixel and in the eight pixels around it show no background, fragments behind the farthest of them
 * are dropped, and the fragments that stay count as if they covered the pixel (DCAA section 4.2). It is an
 * approximation: what shows through a gap that these samples miss is lost. A view has 4 bytes more per sample of the
 * prepass and pixel, and without EXACT 4 bytes per pixel. The tiers FRAGMENT_INTERLOCK and RASTER_ORDER, and views
 * whose triangles compute passes expand (AgaaFetchFunction::maxTriangles), fail with AGAA_ERROR_UNSUPPORTED. "agaa"
 * does not use the flag. */
#define AGAA_COVERAGE_DEPTH_PREPASS UINT64_C(0x04)

/* Controls how "dcaa" keeps and merges fragments. Chain it to AgaaConfig. The tiers FRAGMENT_INTERLOCK and
 * RASTER_ORDER have no lists and use neither fragmentsPerPixel nor maxBatches. "agaa" with the tier FRAGMENTS uses
 * fragmentsPerPixel, maxBatches, samplePositions and tableSize. Other techniques and tiers check the struct and do not
 * use it. AgaaConfig::surfaceCosine is the smallest cosine between normals that merge; 0 selects the cosine of pi/16,
 * as in the paper. */
typedef struct AgaaDecoupledCoverage {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t merge;          /* AgaaMerge */
    float fragmentsPerPixel; /* capacity of the lists in fragments per pixel, mean over the view, [1, 256]. A frame
                                needs AgaaCounters::fragments divided by the number of pixels. The capacity is at
                                least 65536 fragments, and at most what one storage buffer of the device holds */
    uint32_t maxBatches;     /* largest number of times that a frame draws the scene, [0, 64]; 0 selects 16, and 2 and 3
                                select 4. If the lists overflow, the tiles of the view are divided among the draws
                                after the first. If too few draws are left, or a tile alone overflows, three draws keep
                                the nearest fragments of each pixel in the tiles concerned: as many as have room if all
                                of these pixels keep the same number, without those as far as the first that has none.
                                With 1 the scene is drawn once, and fragments that arrive after the lists are full are
                                lost, so that frames differ if the order of arrival does. AgaaCounters::lostFragments
                                counts what is lost, and the view logs one warning. Vulkan records all draws in each
                                frame; the device skips those that are not needed if it has
                                AGAA_DEVICE_CONDITIONAL_RENDERING, and otherwise runs all */
    uint32_t reserved;       /* 0 */
    uint64_t flags;          /* AGAA_COVERAGE_… */
    /* Positions of the coverage samples: AgaaConfig::samples pairs x, y in [0, 1) of gl_FragCoord; copied. Null: the
     * library's pattern, whose masks are exact. Masks of other patterns come from a table of half-planes (DCAA 3.1),
     * which a pass fills in every frame. The table rounds the direction of each edge and its distance from the
     * pixel's centre. The two sides of an edge share no sample and miss none. Near a vertex, triangles may miss a
     * sample or cover it twice. */
    const float* samplePositions;
    uint32_t tableSize;     /* number of directions, and of distances, of the table, [16, 1024]; 0 selects 128. An
                               entry takes 16 bytes. The table exists with samplePositions only */
    uint32_t reservedTable; /* 0 */
} AgaaDecoupledCoverage;
#define AGAA_DECOUPLED_COVERAGE_INIT                                                                                   \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE, (uint32_t)sizeof(AgaaDecoupledCoverage), NULL, AGAA_MERGE_VISIBLE,     \
            8.0f, 0, 0, 0, NULL, 0, 0                                                                                  \
    }
AGAA_API void AGAA_CALL agaaInitDecoupledCoverage(AgaaDecoupledCoverage* outCoverage, size_t structSize);

typedef enum AgaaSeeds {
    AGAA_SEEDS_MAXIMIN = 0,
    AGAA_SEEDS_SUM_OF_SQUARES = 1, /* AGAA algorithm 1 (e) as printed */
    AGAA_SEEDS_MAX_ENUM = 0x7FFFFFFF
} AgaaSeeds;

/* Replaces the image by a number or a share in all channels, or by a colour, per pixel. Pixels without geometry show
 * 0. "msaa" has no debug views, because the host shades. A debug view that does not apply to the technique fails
 * with AGAA_ERROR_UNSUPPORTED. */
typedef enum AgaaDebugView {
    AGAA_DEBUG_VIEW_NONE = 0,
    AGAA_DEBUG_VIEW_EVENTS = 1,     /* number of shading events */
    AGAA_DEBUG_VIEW_AGGREGATES = 2, /* number of aggregates of "agaa", or of surfaces of "sbaa" and "dcaa" */
    AGAA_DEBUG_VIEW_CLUSTERS = 3,   /* a colour per aggregate or surface, mixed by their shares of samples */
    AGAA_DEBUG_VIEW_PRIMITIVES = 4, /* "agaa", tiers FRAGMENTS, and IDS without BUFFERED: number of primitives that
                                       samples show */
    AGAA_DEBUG_VIEW_LIT = 5,        /* share of the light of AgaaFrame::shadows[0] that reaches the covered samples; 1
                                       without shadows */
    AGAA_DEBUG_VIEW_WIDENED = 6,    /* "agaa" and "sbaa", with layouts that store roughness: how far the NDF widens
                                       lobes, as GGX alpha in the widest direction, mean over the covered samples.
                                       "dcaa" shows 0 with round lobes, because it keeps the widened roughness alone,
                                       and with AGAA_COVERAGE_EXACT */
    AGAA_DEBUG_VIEW_TIER = 7,  /* grey: no aggregation; orange: two geometry passes; blue: from a G-buffer, unfetched
                                  draws included; green: by ids; yellow: by lists of fragments. The colour is half as
                                  bright if the pixel has one shading event. With AGAA_CONFIG_BUFFERED, unfetched
                                  draws are green */
    AGAA_DEBUG_VIEW_FACTS = 8, /* share of the covered samples whose material contradicts AgaaSceneFacts::flags. Implies
                                  AGAA_CONFIG_CHECK_FACTS */
    AGAA_DEBUG_VIEW_MAX_ENUM = 0x7FFFFFFF
} AgaaDebugView;

/* The lanes of compute passes that compare the samples of pixels: those of "agaa", "sbaa" and "adaptive", and those of
 * "dcaa" with AGAA_COVERAGE_EXACT. The image and the counters do not depend on the value. A value that the device
 * cannot run fails with AGAA_ERROR_UNSUPPORTED, and so does SAMPLE_SUBGROUP with the tier FRAGMENTS and with
 * AGAA_COVERAGE_EXACT. Notes of the plan name the choice of AUTO and its reason.
 *
 * "dcaa", tiers FRAGMENT_LISTS and MATERIAL_LISTS: the pass that merges fragments has one lane per pixel. PIXEL keeps
 * the surfaces of a pixel in an array of the lane, the other lanes keep them in shared memory. Both need no subgroups.
 * AUTO is PIXEL on AGAA_DEVICE_SOFTWARE, and on devices with too little shared memory. */
typedef enum AgaaLanes {
    AGAA_LANES_AUTO = 0,            /* PIXEL on AGAA_DEVICE_SOFTWARE and with one sample, otherwise the last of the
                                       others that runs */
    AGAA_LANES_PIXEL = 1,           /* one lane per pixel; it keeps the samples in arrays */
    AGAA_LANES_SAMPLE_SHARED = 2,   /* one lane per sample; lanes exchange values through shared memory. Requires
                                       AgaaDeviceCaps::maxSharedBytes, more for larger n */
    AGAA_LANES_SAMPLE_SUBGROUP = 3, /* one lane per sample; lanes exchange values by subgroup operations. Requires
                                       AgaaDeviceCaps::subgroupSize in [n, 64] and ::maxSharedBytes */
    AGAA_LANES_MAX_ENUM = 0x7FFFFFFF
} AgaaLanes;

/* Bits of AgaaMeasurement::flags. */
/* Do not filter the diffuse term by the spread of normals. */
#define AGAA_MEASURE_NO_DIFFUSE_FILTER UINT64_C(0x01)
/* One shadow tap at the aggregate's mean position. */
#define AGAA_MEASURE_NO_SHADOW_FILTER UINT64_C(0x02)
/* AGAA 3.5.3: shadow taps along the view ray by the variance of depth, within the depths of the samples. The tier
 * FRAGMENTS takes taps at samples instead. */
#define AGAA_MEASURE_SHADOW_ALONG_DEPTH UINT64_C(0x04)
/* AGAA 3.5.3: four shadow taps along the longest axis of the covariance of positions. Excludes SHADOW_ALONG_DEPTH,
 * STORED_DEPTH and NO_SHADOW_FILTER (AGAA_ERROR_INVALID_ARGUMENT). The tier FRAGMENTS takes taps at samples instead. */
#define AGAA_MEASURE_SHADOW_COVARIANCE UINT64_C(0x80)
/* AGAA 3.5.3: fragments sum moments of depth in the aggregates, 16 bytes each. Shading reads these in place of the
 * samples' depths: an aggregate is at their mean, and shadow taps lie along the view ray as with SHADOW_ALONG_DEPTH,
 * unless NO_SHADOW_FILTER is set. Steps are 1e-5 of the distance, or 2.4e-7 of the range of an orthographic view.
 * Requires "agaa" by the tier POST_DEPTH_ATOMICS or PER_SAMPLE (AGAA_ERROR_UNSUPPORTED). Excludes SHADOW_COVARIANCE
 * (AGAA_ERROR_INVALID_ARGUMENT). */
#define AGAA_MEASURE_STORED_DEPTH UINT64_C(0x100)
/* AGAA 4.1: where a pixel shows no more planes than it may have aggregates, planes are grouped in place of samples. The
 * samples of a plane have one normal, as they are grouped by, are within the steps of their depths, and nearer to one
 * of them than other aggregates may be. Lanes of single samples group samples. */
#define AGAA_MEASURE_DEPTH_PLANES UINT64_C(0x200)
/* AGAA 3.5.2: point and spot lights widen the lobes of aggregates by the variance of their directions over the
 * positions of the samples. Other techniques widen those of events that stand for several samples. */
#define AGAA_MEASURE_LIGHT_DIRECTIONS UINT64_C(0x40)
/* Disable the stencil test. At equal depth, the result depends on the order of fragments and is not repeatable. */
#define AGAA_MEASURE_NO_STENCIL UINT64_C(0x08)
/* AGAA algorithm 2, step 2 (c): a fragment goes to the aggregate of its first sample. 4 bytes per pixel more. */
#define AGAA_MEASURE_FIRST_SAMPLE_ROUTING UINT64_C(0x10)
/* Every shading event evaluates all lights of the frame. Otherwise, in views with maxLights of 8 or more whose
 * technique shades in passes of the SDK, lights that cannot reach anything in a tile of 8 by 8 pixels are not
 * evaluated there. */
#define AGAA_MEASURE_NO_LIGHT_CULLING UINT64_C(0x20)

/* How "agaa" filters the diffuse term by the spread of normals (AGAA 3.5.2). Other techniques do not use it. */
typedef enum AgaaDiffuseFilter {
    AGAA_DIFFUSE_RECTIFIED = 0,    /* closed form that approximates the mean of max(n.l, 0) over Toksvig's round
                                      distribution */
    AGAA_DIFFUSE_MISES_FISHER = 1, /* that mean over a von Mises-Fisher distribution with the same mean length, where
                                      the paper has an approximation of Baker and Hill 2012 */
    AGAA_DIFFUSE_SGGX = 2,         /* mean of 8 normals of the SGGX distribution that face the eye (Heitz et al. 2015).
                                      Aggregates in memory have 20 bytes more. Excludes litShadows and the tier
                                      NV_MIXED_SAMPLES, and with layouts of folded roughness requires the tier
                                      FRAGMENTS, or IDS or GBUFFER without AGAA_CONFIG_BUFFERED
                                      (AGAA_ERROR_UNSUPPORTED) */
    AGAA_DIFFUSE_FILTER_MAX_ENUM = 0x7FFFFFFF
} AgaaDiffuseFilter;

/* Settings for measurements and for comparison with the papers. Chain it to AgaaConfig; hosts do not need it to
 * render. */
typedef struct AgaaMeasurement {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t shadingCost;   /* lighting is evaluated this many times, [1, 64] */
    uint32_t debugView;     /* AgaaDebugView */
    uint32_t seeds;         /* AgaaSeeds of "agaa" */
    uint32_t lanes;         /* AgaaLanes */
    uint64_t flags;         /* AGAA_MEASURE_… */
    uint32_t diffuseFilter; /* AgaaDiffuseFilter, without AGAA_MEASURE_NO_DIFFUSE_FILTER */
    uint32_t reserved;      /* 0 */
} AgaaMeasurement;
#define AGAA_MEASUREMENT_INIT                                                                                          \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_MEASUREMENT, (uint32_t)sizeof(AgaaMeasurement), NULL, 1, AGAA_DEBUG_VIEW_NONE,             \
            AGAA_SEEDS_MAXIMIN, AGAA_LANES_AUTO, 0, AGAA_DIFFUSE_RECTIFIED, 0                                          \
    }
AGAA_API void AGAA_CALL agaaInitMeasurement(AgaaMeasurement* outMeasurement, size_t structSize);

/* Applies named settings of "agaa", which were chosen by measurement (docs/choosing.md).
 *
 * name          "paper", "fast", "balanced" or "accurate"; agaaGetNames lists them. "paper" follows the paper, with
 *               two exceptions: each sample goes to its own aggregate (AGAA_MEASURE_FIRST_SAMPLE_ROUTING), and k
 *               keeps its value (10 cm in the paper).
 * config        Receives technique, aggregates, surface…, shadowTaps, ndf, and the flags SPLIT_SURFACES and
 *               FINE_MATERIALS. All other members keep their values. If its layout, which is
 *               read, has AGAA_FILTER_CLASS, aggregates is one more than the preset has, up to 4.
 * aggregation   Receives aggregateThreshold, litShadows (the first shadow) and glossWeight. All other members keep
 *               their values. Chain it to config. If config's generationTier, which is read, is a tier of two geometry
 *               passes, litShadows and glossWeight are 0: it groups samples before it knows materials. litShadows is
 *               0, too, if config's flags have BUFFERED.
 * measurement   Receives seeds and the flags of filters and routing. All other members keep their values. Chain it
 *               to config. It may be null for all presets except "paper".
 *
 * "balanced" and "accurate" group samples by their materials, if the tier can: without an AgaaFetchFunction, the tier
 * AUTO selects GBUFFER.
 *
 * Errors        AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or no preset has this name
 *               AGAA_ERROR_STRUCT             a struct is not initialised
 *               AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, a struct twice, or does not end
 *               On failure all structs keep their values.
 * Threads       Any. */
AGAA_API AgaaResult AGAA_CALL agaaApplyPreset(const char* name, AgaaConfig* config, AgaaAggregation* aggregation,
                                              AgaaMeasurement* measurement);

/* ---- scene facts and views ------------------------------------------------------------------ */

/* Bits of AgaaSceneFacts::flags: effects that the scene uses. The plan drops all other effects. AgaaFrame::facts may
 * name fewer effects than the view.
 *
 * SPECULAR       without it, no specular reflectance and no roughness are stored or shaded
 * EMISSIVE       without it, no emission is stored or shaded
 * ALPHA_MASKED   without it, no material is alpha-masked
 * AMBIENT        without it, AgaaFrame::ambient is not used */
#define AGAA_FACT_SPECULAR UINT64_C(0x01)
#define AGAA_FACT_EMISSIVE UINT64_C(0x02)
/* Changes draw passes only; it has no effect in AgaaFrame::facts. */
#define AGAA_FACT_ALPHA_MASKED UINT64_C(0x04)
#define AGAA_FACT_AMBIENT UINT64_C(0x08)
/* Materials write depth or discard on their own, so that no second pass can draw them again at equal depth. "agaa"
 * and "sbaa" use the tier GBUFFER ("agaa" IDS with an AgaaFetchFunction); "msaa", "dcaa" and the tier FRAGMENTS fail
 * with AGAA_ERROR_UNSUPPORTED. It selects the tier of the view and has no effect in AgaaFrame::facts. */
#define AGAA_FACT_CUSTOM_DEPTH UINT64_C(0x10)
/* Bits of AgaaSceneFacts::flags: properties that all materials and lights of the scene share. The plan drops the
 * data and the work that they make redundant. If a material differs, its value is replaced; AGAA_CONFIG_CHECK_FACTS
 * counts such materials.
 *
 * ONE_ROUGHNESS     the roughness is AgaaSceneFacts::alpha2. No roughness is stored, except by "dcaa"
 * GREY_SPECULAR     the specular reflectance has equal channels. One channel is stored: the mean of the three
 * ONE_SPECULAR      the specular reflectance is AgaaSceneFacts::specular, as for dielectrics. It is not stored
 * NO_DIFFUSE        the diffuse albedo is 0, as for metals. It is not stored
 * NO_LOCAL_LIGHTS   all lights are directional. The view culls no lights
 * PLANE_NORMALS     AgaaSurfaceInput::normal is geometricNormal, or with an AgaaFetchFunction the normal of the
 *                   triangle, on the side of the eye: the scene has no normal maps and no interpolated normals. The
 *                   fact has no effect with an AgaaGBufferFunction. With NO_LOCAL_LIGHTS and without
 *                   AGAA_FACT_SPECULAR, aggregates of two geometry passes keep no normals and take the normals of
 *                   the first pass, which have 16 bits
 * NO_TRANSLUCENCY   alpha-masked materials are cut-outs (AgaaSurfaceInput::alphaCutoff > 0)
 * NO_CUTOUTS        alpha-masked materials are translucent, if NO_TRANSLUCENCY is not set */
#define AGAA_FACT_ONE_ROUGHNESS UINT64_C(0x100)
#define AGAA_FACT_GREY_SPECULAR UINT64_C(0x200)
#define AGAA_FACT_ONE_SPECULAR UINT64_C(0x400)
#define AGAA_FACT_NO_TRANSLUCENCY UINT64_C(0x2000)
#define AGAA_FACT_NO_CUTOUTS UINT64_C(0x4000)
#define AGAA_FACT_PLANE_NORMALS UINT64_C(0x8000)
/* If a layout has emission of one channel, a factor of the albedo, the view fails with AGAA_ERROR_LAYOUT. */
#define AGAA_FACT_NO_DIFFUSE UINT64_C(0x800)
/* Point and spot lights fail with AGAA_ERROR_OUT_OF_RANGE. */
#define AGAA_FACT_NO_LOCAL_LIGHTS UINT64_C(0x1000)
#define AGAA_FACT_ALL_SHADED (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT)

#define AGAA_MAX_SHADOW_MAPS 4
#define AGAA_MAX_SHADOW_LAYERS 6
typedef struct AgaaSceneFacts {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    uint64_t flags;          /* AGAA_FACT_… */
    uint32_t maxLights;      /* [0, 4096]. "msaa" with AGAA_GL_STORAGE_IMAGES accepts 16 KiB of lights; more lights
                                fail with AGAA_ERROR_UNSUPPORTED, and the log names the largest number */
    uint32_t shadowMapCount; /* [0, AGAA_MAX_SHADOW_MAPS] */
    float alpha2;            /* GGX alpha squared for AGAA_FACT_ONE_ROUGHNESS, [4.1e-6, 1] */
    float specular;          /* reflectance at normal incidence for AGAA_FACT_ONE_SPECULAR, [0, 1] */
} AgaaSceneFacts;
#define AGAA_SCENE_FACTS_INIT                                                                                          \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_SCENE_FACTS, (uint32_t)sizeof(AgaaSceneFacts), NULL, AGAA_FACT_ALL_SHADED, 64, 1, 1.0f,    \
            0.04f                                                                                                      \
    }
AGAA_API void AGAA_CALL agaaInitSceneFacts(AgaaSceneFacts* outFacts, size_t structSize);

/* Bits of AgaaViewDesc::flags. */
/* The near plane has depth 1, the far plane 0; needs a float depth format. */
#define AGAA_VIEW_REVERSED_Z UINT64_C(0x01)
/* Frames may composite over the contents of the output. */
#define AGAA_VIEW_COMPOSITE UINT64_C(0x02)
/* OpenGL: the rasteriser maps z/w in [-1, 1] to depth, which is its default. Without the flag it maps z/w in [0, 1].
 * The near and far planes of AgaaFrame::projection lie at the ends of that range. Vulkan: AGAA_ERROR_UNSUPPORTED. */
#define AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE UINT64_C(0x04)
/* The host's vertex shaders expand triangles in the pass FRAGMENTS (AgaaDrawState::vertexPulling), so that "dcaa"
 * and the tier FRAGMENTS of "agaa" need no geometry shaders. Without the flag geometry shaders expand them, and a
 * device without AGAA_DEVICE_GEOMETRY_SHADERS fails with AGAA_ERROR_UNSUPPORTED. Other techniques and tiers do not
 * use the flag. */
#define AGAA_VIEW_VERTEX_PULLING UINT64_C(0x08)

/* Describes a view. An AgaaGBufferFunction or AgaaFetchFunction, an AgaaShadowFunction, an AgaaShadingFunction
 * (agaa/functions.h) and an AgaaResolvedOutputs (agaa/outputs.h) may be chained. */
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
#define AGAA_VIEW_DESC_INIT                                                                                            \
    { AGAA_STRUCTURE_TYPE_VIEW_DESC, (uint32_t)sizeof(AgaaViewDesc), NULL, 0, 0, NULL, NULL, 0 }
AGAA_API void AGAA_CALL agaaInitViewDesc(AgaaViewDesc* outDesc, size_t structSize);

/* Changes the size of a view. The view keeps its handle; draw passes and surfaces must be read again
 * (agaaGetDrawPasses, agaaGetSurface). Pipelines whose key is still listed may be kept: keys stay the same unless
 * the tier AUTO selects another tier at the new size. Statistics of earlier frames are lost. During the call the
 * surfaces of both sizes exist.
 *
 * view            The device must have finished every frame that was recorded with the view.
 * width, height   pixels, >= 1.
 *
 * Errors          AGAA_ERROR_INVALID_ARGUMENT   the view is null, or a text of the host does not compile in the
 *                                               passes of another tier that AUTO selects at the new size
 *                 AGAA_ERROR_OUT_OF_RANGE       a size is 0
 *                 AGAA_ERROR_UNSUPPORTED        the device cannot do what the new size needs
 *                 AGAA_ERROR_TOO_LARGE          a surface exceeds a limit of the device
 *                 AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated
 *                 AGAA_ERROR_CALLBACK           Vulkan: AgaaVkAllocator returned memory that is not valid
 *                 AGAA_ERROR_DEVICE             a function of the graphics API failed
 *                 On failure the view keeps its size, its surfaces and their contents.
 * Threads         One call at a time per context.
 * OpenGL          The context must be current. All state is restored before the call returns. The log reports errors
 *                 of earlier calls that were pending. */
AGAA_API AgaaResult AGAA_CALL agaaResizeView(AgaaView view, uint32_t width, uint32_t height);

/* Compiles the compute passes of a view for frames with fewer effects (AgaaFrame::facts). Each element adds a
 * variant: the pipelines or programs without the effects that the element leaves out. The variant of the view's own
 * facts exists from the start. A frame runs with the smallest variant that contains its facts; recording a frame
 * never compiles. Pipelines that are equal in two variants are compiled once. Variants stay until the view is
 * destroyed; agaaResizeView compiles them again for the new size.
 *
 * view     Any view. Variants of "msaa", which shades in draw passes, compile nothing.
 * count    Elements of facts; 0 does nothing.
 * facts    Read during the call only; may be null if count is 0. Each element must be within the facts of the view,
 *          as AgaaFrame::facts.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT   the view is null, or facts is null although count is not 0
 *          AGAA_ERROR_STRUCT             an element is not initialised
 *          AGAA_ERROR_UNKNOWN_STRUCT     a struct is chained to an element
 *          AGAA_ERROR_OUT_OF_RANGE       an element is not within the facts of the view, or has an unknown flag
 *          AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated
 *          AGAA_ERROR_DEVICE             a function of the graphics API failed
 *          If an element is not valid, nothing is compiled. After other errors, elements before the one that failed
 *          are prepared.
 * Threads  Vulkan: any thread, also while other threads record frames of the view, read its statistics, or use its
 *          context. Frames that begin after a variant is complete may run with it. Calls for one view wait for each
 *          other. agaaResizeView and agaaDestroyView must not run for the view at the same time. The log is called
 *          on the thread of the call.
 * OpenGL   The context must be current: one call at a time per context. All state is restored before the call
 *          returns. The log reports errors of earlier calls that were pending. */
AGAA_API AgaaResult AGAA_CALL agaaPrepareVariants(AgaaView view, uint32_t count, const AgaaSceneFacts* facts);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_CONFIG_H */
