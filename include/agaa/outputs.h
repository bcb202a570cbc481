/* Values per pixel beside the image: depth, normal, coverage and custom attributes. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_OUTPUTS_H
#define AGAA_OUTPUTS_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A value of a pixel, resolved over the samples that show geometry: those of the visibility pass, or the coverage
 * samples of "dcaa" and of the tier FRAGMENTS. Samples that show geometry at the far plane may count as background.
 * Channels that a value lacks are 0, and alpha is 1. */
typedef enum AgaaResolvedValue {
    /* Red: the depth of the nearest sample, or that of the far plane where no sample shows geometry. Depths are those
     * of the depth buffer, [0, 1]. Techniques and tiers without one have the depth of the mean position of the nearest
     * shading event. */
    AGAA_RESOLVED_NEAREST_DEPTH = 1,
    /* Red: the mean depth of the samples, or that of the far plane. On a plane it is the depth at the centroid of the
     * samples. */
    AGAA_RESOLVED_MEAN_DEPTH = 2,
    /* Red, green, blue: the mean of the samples' unit normals in shading space, or 0. It is shorter than 1 if they
     * differ. Surfaces of "dcaa", and aggregates in memory with folded roughness, count as one direction. */
    AGAA_RESOLVED_NORMAL = 3,
    /* Red: the share of the pixel's samples that show geometry, [0, 1]. */
    AGAA_RESOLVED_COVERAGE = 4,
    /* The channels of a custom attribute of the layout, combined by its AgaaFilter, or 0. AGAA_FILTER_CLASS is combined
     * as AGAA_FILTER_NONE: the largest number of a class in the pixel. */
    AGAA_RESOLVED_CUSTOM = 5,
    AGAA_RESOLVED_VALUE_MAX_ENUM = 0x7FFFFFFF
} AgaaResolvedValue;

typedef struct AgaaResolvedOutput {
    uint32_t value;        /* AgaaResolvedValue */
    uint32_t reserved;     /* 0 */
    const char* attribute; /* CUSTOM: the name of the attribute (AGAA_ERROR_LAYOUT if the layout has none of this name).
                              Read during the call only. Null for all others */
} AgaaResolvedOutput;

#define AGAA_MAX_RESOLVED_OUTPUTS 6
/* Outputs of a view beside its image. Chain it to AgaaViewDesc. The last pass of each frame writes them into images of
 * the host: AgaaVkResolvedImages or AgaaGlResolvedTextures, chained to AgaaVkFrame or AgaaGlFrame. A depth or coverage
 * of a view with a depth buffer costs this pass. Other values take memory where samples are not in a G-buffer: the
 * surface "resolved-sums" and, for CUSTOM in "dcaa" and "sbaa", the attributes of each surface. For NORMAL and CUSTOM,
 * the prepass of "msaa" evaluates materials and writes these attributes of each sample. With AGAA_CONFIG_ACCUMULATE,
 * the values are those of the frame, not of the accumulated image. On Vulkan, more outputs than
 * maxPerStageDescriptorStorageImages of the device fail with AGAA_ERROR_UNSUPPORTED. */
typedef struct AgaaResolvedOutputs {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t count;    /* [1, AGAA_MAX_RESOLVED_OUTPUTS] */
    uint32_t reserved; /* 0 */
    AgaaResolvedOutput outputs[AGAA_MAX_RESOLVED_OUTPUTS];
} AgaaResolvedOutputs;
#define AGAA_RESOLVED_OUTPUTS_INIT                                                                                     \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_RESOLVED_OUTPUTS, (uint32_t)sizeof(AgaaResolvedOutputs), NULL, 1, 0, {                     \
            {AGAA_RESOLVED_NEAREST_DEPTH, 0, NULL}, {0, 0, NULL}, {0, 0, NULL}, {0, 0, NULL}, {0, 0, NULL}, {          \
                0, 0, NULL                                                                                             \
            }                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitResolvedOutputs(AgaaResolvedOutputs* outOutputs, size_t structSize);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_OUTPUTS_H */
