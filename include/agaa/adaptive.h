/* Settings of "adaptive". Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_ADAPTIVE_H
#define AGAA_ADAPTIVE_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bits of AgaaAdaptiveSampling::flags. Without GEOMETRY and SHADING, all samples are shaded. */
#define AGAA_ADAPTIVE_GEOMETRY UINT64_C(0x01) /* samples that differ in normal, plane or material from all that are shaded
                                                 are shaded, too */
#define AGAA_ADAPTIVE_SHADING UINT64_C(0x02)  /* further samples are shaded if the first samples of the pixel and of its four
                                                 neighbours differ in luminance */
#define AGAA_ADAPTIVE_DEVICE_PATTERN UINT64_C(0x40) /* visibility tier AUTO: as for other techniques. Otherwise AUTO selects
                                                       ORDERED_GRID at 4, 9 and 16 samples, as in the paper */
/* For comparison with the paper. The first four together are its method, the others the ways of its section 4.2. */
#define AGAA_ADAPTIVE_PRINTED_METRIC UINT64_C(0x04) /* section 3.1 as printed: numbers of samples by the variance of depth, the
                                                       cone of normals and the range of luminances; the largest counts */
#define AGAA_ADAPTIVE_IN_ORDER UINT64_C(0x08)       /* samples are shaded in the order of the pattern, and not the one that
                                                       differs most next */
#define AGAA_ADAPTIVE_EQUAL_WEIGHTS UINT64_C(0x10)  /* the pixel is the mean of the shaded samples, and not each by the number of
                                                       samples that it stands for */
#define AGAA_ADAPTIVE_LOOP UINT64_C(0x20)           /* an invocation shades all further samples of its pixel. Otherwise these are
                                                       distributed among all invocations of a group */

#define AGAA_ADAPTIVE_BUCKETS UINT64_C(0x80)        /* numbers of samples are powers of two */
#define AGAA_ADAPTIVE_SORTED UINT64_C(0x100)        /* groups shade pixels of like numbers of samples. 8 bytes per pixel more */
#define AGAA_ADAPTIVE_TILE_MAXIMUM UINT64_C(0x200)  /* all pixels of a tile of 8 by 8 have the largest number of samples of the
                                                       tile */
#define AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS UINT64_C(0x400) /* tier IDS: textures are filtered over the area of one sample. Otherwise
                                                           over that of all samples that a shaded one represents */

/* How "adaptive" decides which samples are shaded (Hollaender et al. 2013). Chain it to AgaaConfig. Other techniques check the
 * struct and do not use it. AgaaConfig::surfaceCosine, surfaceDistance and surfaceMaterial are the differences from which on
 * a sample is shaded. */
typedef struct AgaaAdaptiveSampling {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t flags;         /* AGAA_ADAPTIVE_… */
    float depthScale;       /* c_d of the printed metric: samples per variance of device depth, [0, 1e12] */
    float normalScale;      /* c_n of the printed metric: samples per root of 1 - cosine, [0, 1e6] */
    float shadingScale;     /* c_s: samples per range of tone-mapped luminance, [0, 1e6] */
    float shadingThreshold; /* the range counts if it is at least this share of the largest luminance, [0, 1] */
    float shadingMinimum;   /* and at least this, [0, 1] */
    float glossWeight;      /* normals differ by glossWeight / alpha as much, clamped to [1, 20], where alpha is GGX alpha,
                               [0, 16]. Not of the printed metric */
    float targetEvents;     /* mean number of shaded samples, per pixel with geometry, that a frame does not exceed, [0, 32]; 0:
                               none. Differences that call for a sample, in each frame, are the least with which it is kept, but
                               1/16 of those of AgaaConfig at least. The first sample of a pixel is always shaded. Requires
                               GEOMETRY, excludes PRINTED_METRIC: AGAA_ERROR_UNSUPPORTED */
    float countMemory;      /* share of a pixel's mean number of samples that is kept from frame to frame, [0, 0.99]. If the mean
                               is larger than the number of this frame, it is used. 0: none. 4 bytes per pixel */
    uint64_t reserved;      /* 0 */
} AgaaAdaptiveSampling;
#define AGAA_ADAPTIVE_SAMPLING_INIT                                                                 \
    {AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING, (uint32_t)sizeof(AgaaAdaptiveSampling), NULL,           \
     AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING, 1e6f, 16.0f, 4.0f, 0.125f, 0.0625f, 0.2f, 0.0f, 0.0f, 0}
AGAA_API void AGAA_CALL agaaInitAdaptiveSampling(AgaaAdaptiveSampling* outAdaptive, size_t structSize);

#ifdef __cplusplus
}
#endif

#endif
