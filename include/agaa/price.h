/* Prices: what effects, samples and aggregates cost, before a view is created. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_PRICE_H
#define AGAA_PRICE_H

#include "agaa/query.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum AgaaPriceKind {
    AGAA_PRICE_VIEW = 0,       /* the numbers of the described view itself */
    AGAA_PRICE_EFFECT = 1,     /* the view with the effect minus the view without it */
    AGAA_PRICE_SAMPLES = 2,    /* the view with toCount samples minus the view with fromCount samples */
    AGAA_PRICE_AGGREGATES = 3, /* the view with toCount aggregates or surfaces minus the view with fromCount */
    AGAA_PRICE_MAX_ENUM = 0x7FFFFFFF
} AgaaPriceKind;

/* One price. Numbers are differences of two plans and may be negative; AGAA_PRICE_VIEW has the numbers of one plan.
 * Each plan selects its own tiers: a difference includes the change of a tier (changesTier). Numbers are 0 if the
 * effect changes nothing in the plan. A price of 0 does not mean that the effect takes no time: shaders may do other
 * work. */
typedef struct AgaaPrice {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;    /* null */
    uint32_t kind;        /* AgaaPriceKind */
    uint32_t isOn;        /* EFFECT: 1 if the description has it. SAMPLES, AGGREGATES: 1 if it has toCount or more */
    uint32_t isPossible;  /* 0: one of the two plans cannot be made; all numbers are 0, and `reason` says why */
    uint32_t changesTier; /* 1: the two plans have different tiers of visibility or generation */
    uint32_t fromCount, toCount; /* SAMPLES: n. AGGREGATES: c or S. 0 for other kinds */
    const char* name;            /* "view", an effect, "samples" or "aggregates"; static storage */
    const char* description;     /* scenes that need the effect, or the improvement by the step; one sentence, static
                                    storage */
    int64_t passes;              /* all passes of a frame; repeated passes count once */
    int64_t geometryPasses;      /* passes that call the host's draw function */
    int64_t pipelines;           /* compute pipelines of the SDK, and draw passes whose pipelines differ */
    int64_t totalBytes;          /* bytes; see AgaaMemoryReport */
    int64_t peakBytes;           /* bytes; see AgaaMemoryReport */
    int64_t constantBytes;       /* bytes; see AgaaMemoryReport */
    int64_t sampleBits;          /* bits of a sample of the targets of geometry passes: depth, stencil and colours, as
                                    stored */
    int64_t aggregateBits;       /* bits of an aggregate or surface in memory, as stored; 0 if the view keeps none in
                                    memory */
    /* Bytes per frame, if each pass reads or writes each per-pixel surface that it uses exactly once and as a whole.
     * A buffer that a pass reads and writes counts once. The number is a lower bound if all passes process all
     * pixels: overdraw, repeated reads and atomic operations add to it. Pixels that a pass skips, caches and
     * compression are not subtracted. */
    int64_t trafficBytes;
    /* Upper bounds that follow from the plan. Frames usually need less; AgaaCounters counts what a frame needs. */
    int64_t maxEventsPerPixel;     /* shading events. 0 for "msaa", which shades each visible fragment, without a
                                      bound */
    int64_t maxShadowTapsPerEvent; /* look-ups in all shadow maps, and calls of the shadow function */
    int64_t maxLightsPerEvent;     /* AgaaSceneFacts::maxLights: light culling does not lower it. Each light is
                                      evaluated AgaaMeasurement::shadingCost times */
    char reason[256];              /* one sentence; empty if isPossible is 1 */
} AgaaPrice;
#define AGAA_PRICE_INIT                                                                                                \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_PRICE, (uint32_t)sizeof(AgaaPrice), NULL, 0, 0, 0, 0, 0, 0, NULL, NULL, 0, 0, 0, 0, 0, 0,  \
            0, 0, 0, 0, 0, 0, {                                                                                        \
            0                                                                                                          \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitPrice(AgaaPrice* outPrice, size_t structSize);

/* Lists the prices of a view, from plans alone, for two frames in flight. The first entry is the view itself. One
 * entry follows for each effect, for each step between neighbouring numbers of samples that the technique supports,
 * and for each step of aggregates or surfaces up to n and up to the largest number of the technique. Steps add up:
 * the prices of 4 to 8 and of 8 to 16 samples together are the price of 4 to 16. 9 samples are a step if the view
 * has 9.
 *
 * All effects are listed for all techniques. If the technique or the layout does not use an effect, its numbers are
 * 0. If the technique, the tier or the device refuses it, isPossible is 0. The effect "shadow-map-I" adds map I to
 * the maps before it, however many maps the description has. "lights" compares AgaaSceneFacts::maxLights, or 64 if
 * it is 0, with no lights. An effect with a strength ("lit-aggregates", "gloss-weight", "ndf-widening",
 * "elliptic-lobes") has the strength of the description or, if the description lacks the effect, a usual strength.
 *
 * caps     Null: an ideal device with every feature.
 * log      May be null. Plans that cannot be made for a price are not reported.
 * count    Receives the number of entries. Unchanged on failure. On entry it holds the length of the array, unless
 *          prices is null.
 * prices   Null, or an array whose elements are all initialised; unchanged on failure.
 *
 * Errors   Those of agaaQueryMemory that concern the description, and
 *          AGAA_ERROR_INVALID_ARGUMENT   count is null
 *          AGAA_ERROR_STRUCT             an element is not initialised
 *          AGAA_ERROR_TOO_LARGE          a number of the view exceeds 63 bits
 *          AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads  Any. */
AGAA_API AgaaResult AGAA_CALL agaaQueryPrices(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                              uint32_t* count, AgaaPrice* prices);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_PRICE_H */
