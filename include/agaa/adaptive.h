/* Settings of "adaptive". Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_ADAPTIVE_H
#define AGAA_ADAPTIVE_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bits of AgaaAdaptiveSampling::flags. Without GEOMETRY and SHADING, all samples are shaded. */
/* Shade samples whose normal, plane or material differs from those of all shaded samples of the pixel. */
#define AGAA_ADAPTIVE_GEOMETRY UINT64_C(0x01)
/* Shade further samples of pixels whose samples differ, if the first samples of the pixel and of its four
 * neighbours differ in a colour channel; with the printed metric, in luminance. */
#define AGAA_ADAPTIVE_SHADING UINT64_C(0x02)
/* PRINTED_METRIC, IN_ORDER, EQUAL_WEIGHTS and LOOP together are the method of the paper, for comparison. */
/* Section 3.1 as printed: the variance of depth, the cone of normals and the range of luminances each give a
 * number of samples; the largest counts. */
#define AGAA_ADAPTIVE_PRINTED_METRIC UINT64_C(0x04)
/* Shade samples in the order of the pattern. Without the flag, the sample that differs most is next. */
#define AGAA_ADAPTIVE_IN_ORDER UINT64_C(0x08)
/* The pixel is the mean of the shaded samples. Without the flag, each shaded sample has the weight of the samples
 * that it represents, and a shadow tap at each of them. */
#define AGAA_ADAPTIVE_EQUAL_WEIGHTS UINT64_C(0x10)
/* An invocation shades all further samples of its pixel. Without the flag, they are distributed among all
 * invocations of a workgroup. */
#define AGAA_ADAPTIVE_LOOP UINT64_C(0x20)
/* The visibility tier AUTO selects as for other techniques. Without the flag, AUTO selects ORDERED_GRID at 4, 9
 * and 16 samples, as in the paper, if the target fits the device and the SDK draws the G-buffer. */
#define AGAA_ADAPTIVE_DEVICE_PATTERN UINT64_C(0x40)
/* The next four flags select methods of section 4.2 of the paper, for comparison. */
/* Round numbers of samples up to powers of two. */
#define AGAA_ADAPTIVE_BUCKETS UINT64_C(0x80)
/* Workgroups shade pixels of similar numbers of samples. The view takes 8 bytes per pixel more. A view of more
 * than 2^26 pixels fails with AGAA_ERROR_TOO_LARGE. */
#define AGAA_ADAPTIVE_SORTED UINT64_C(0x100)
/* All pixels of a tile of 8x8 pixels have the largest number of samples of the tile. */
#define AGAA_ADAPTIVE_TILE_MAXIMUM UINT64_C(0x200)
/* Tier IDS: filter textures over the area of one sample. Without the flag, they are filtered over the area of all
 * samples that a shaded one represents. */
#define AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS UINT64_C(0x400)
/* The printed metric counts samples without geometry, too, as we read section 3.1: their depth is that of the far
 * plane, and their normal counts as perpendicular to all others. Without the flag, edges against the background
 * count by their geometry alone. */
#define AGAA_ADAPTIVE_BACKGROUND UINT64_C(0x800)
/* Samples differ by light, too: if the luma of their light without shadows, as displayed, differs by more than
 * surfaceMaterial. Colours of equal luma do not differ, nor lights whose changes cancel. For highlights and near
 * lights (future work in section 6). A pass before the others estimates the light of all samples by the library's
 * model, where materials are specular or point or spot lights reach; shading events do not count the estimates.
 * ceil(n / 4) * 4 bytes per pixel more. The printed metric does not use it. */
#define AGAA_ADAPTIVE_LIGHTS UINT64_C(0x1000)

/* Controls which samples "adaptive" shades (Hollaender et al. 2013). Chain it to AgaaConfig. Other techniques check
 * the struct and do not use it. A sample differs if it exceeds a threshold of AgaaConfig: surfaceCosine,
 * surfaceDistance or surfaceMaterial. */
typedef struct AgaaAdaptiveSampling {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t flags;         /* AGAA_ADAPTIVE_… */
    float depthScale;       /* c_d of the printed metric: samples per variance of device depth, [0, 1e12] */
    float normalScale;      /* c_n of the printed metric: samples per root of 1 - cosine, [0, 1e6] */
    float shadingScale;     /* c_s: further samples per range of a tone-mapped channel, [0, 1e6]. It is multiplied by
                               the difference of the samples, as a share of the thresholds. The printed metric takes
                               the range of luminance and does not multiply */
    float shadingThreshold; /* smallest range that counts, as a share of the largest value in it, [0, 1] */
    float shadingMinimum;   /* smallest range that counts, [0, 1] */
    float glossWeight;      /* scale of differences of normals, [0, 16]. They are multiplied by glossWeight / alpha,
                               clamped to [1, 20], where alpha is GGX alpha. The printed metric does not use it */
    float targetEvents;     /* mean number of shaded samples per pixel with geometry that no frame exceeds, [0, 32];
                               0: no limit. Each frame uses the smallest thresholds that keep it, at least 1/16 of
                               those of AgaaConfig. The first sample of a pixel is always shaded. Requires GEOMETRY.
                               Excludes countMemory and the flags PRINTED_METRIC, IN_ORDER, BUCKETS and TILE_MAXIMUM:
                               AGAA_ERROR_UNSUPPORTED */
    float countMemory;      /* share of a pixel's mean number of samples that is kept from frame to frame, [0, 0.99].
                               A pixel has at least this mean number of samples. 0 keeps nothing; other values take 4
                               bytes per pixel */
    uint64_t reserved;      /* 0 */
} AgaaAdaptiveSampling;
#define AGAA_ADAPTIVE_SAMPLING_INIT                                                                                    \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING, (uint32_t)sizeof(AgaaAdaptiveSampling), NULL,                           \
            AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING, 1e6f, 16.0f, 4.0f, 0.125f, 0.0625f, 0.2f, 0.0f, 0.0f, 0    \
    }
AGAA_API void AGAA_CALL agaaInitAdaptiveSampling(AgaaAdaptiveSampling* outAdaptive, size_t structSize);

#ifdef __cplusplus
}
#endif

#endif
