/* Settings for a goal: a limit of the error, the time or the memory, instead of a technique. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_GOAL_H
#define AGAA_GOAL_H

#include "agaa/query.h"
#include "agaa/statistics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- goals ---------------------------------------------------------------------------------- */

/* Selects what the choice minimises among the settings that satisfy all limits. */
typedef enum AgaaPreference {
    AGAA_PREFER_TIME = 0,
    AGAA_PREFER_ERROR = 1,
    AGAA_PREFER_MAX_ENUM = 0x7FFFFFFF
} AgaaPreference;

/* Bits of AgaaGoal::flags. */
#define AGAA_GOAL_ONE_GEOMETRY_PASS                                                                                    \
    UINT64_C(0x01) /* leave out settings that draw the scene more than once in a                                       \
                      frame */
#define AGAA_GOAL_PREDICT_OTHERS                                                                                       \
    UINT64_C(0x02) /* choose also among settings that are not in AgaaGoal::measured, by errors predicted from those    \
                      that are; no effect without measured settings */

/* Measurements of settings in the host's own scene. The errors come from three frames with one camera: one with
 * these settings, one with "single" and one with full sampling. */
typedef struct AgaaMeasuredSettings {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    const char* technique;   /* technique; the table of choices must contain it with the members below */
    const char* preset;      /* null: none */
    uint32_t samples;        /* n */
    uint32_t aggregates;     /* c or S; 0: the technique has none */
    uint32_t generationTier; /* an AgaaTier; AUTO: the technique has none */
    uint32_t reserved;       /* 0 */
    uint64_t pixels;         /* pixels of the timed frame; 0 without times */
    float errorShare;        /* error divided by the error of "single", (0, 1e9] */
    float error;             /* error, [0, 1e9]; it must be above 0 if AgaaGoal::maxError is a limit */
    /* Times as in AgaaObservation; both are 0 if they were not measured. */
    float geometryMilliseconds; /* [0, 1e9] */
    float shadingMilliseconds;  /* [0, 1e9] */
} AgaaMeasuredSettings;
#define AGAA_MEASURED_SETTINGS_INIT                                                                                    \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_MEASURED_SETTINGS, (uint32_t)sizeof(AgaaMeasuredSettings), NULL, NULL, NULL, 0, 0, 0, 0,   \
            0, 0.0f, 0.0f, 0.0f, 0.0f                                                                                  \
    }
AGAA_API void AGAA_CALL agaaInitMeasuredSettings(AgaaMeasuredSettings* outMeasured, size_t structSize);

/* Limits, and the quantity to minimise within them. Errors are mean square errors after tone mapping, against full
 * sampling. If `measured` is null, errors are predicted from the ten scenes of docs/choosing.md: they do not depend
 * on the contents of a frame.
 *
 * If `measured` is set, the choice is made among its settings, with the measured errors; sceneShare is used with the
 * flag below alone. If the settings have times, the predicted times are the measured ones, scaled by the times that
 * were observed later and to other numbers of pixels: shading in proportion, geometry by the observed sizes or, if
 * there is one size, by the root of the ratio. Either all measured settings have times, or none has.
 *
 * With AGAA_GOAL_PREDICT_OTHERS, the choice is made among all settings of the table. The errors that are not measured
 * are predicted from the measured ones and from the covariance of the logarithms of errors over the ten scenes. A
 * predicted error is not exceeded with the probability sceneShare, clamped to [0.001, 0.999]. A host that measures each
 * choice, adds it to `measured` and chooses anew settles after few frames. */
typedef struct AgaaGoal {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;     /* null */
    float maxErrorShare;   /* error divided by the error of "single" in the same scene, [0, 1]; 0: no limit */
    float maxError;        /* error, [0, inf); 0: no limit */
    float sceneShare;      /* the error limits hold in this share of the ten scenes, [0, 1]. 0.5: the median, 1: the
                              worst. With AGAA_GOAL_PREDICT_OTHERS, the probability that a predicted limit holds */
    float maxMilliseconds; /* time of geometry passes and passes of the library, [0, inf); 0: no limit */
    uint64_t maxBytes;     /* AgaaMemoryReport::totalBytes; 0: no limit */
    uint32_t prefer;       /* AgaaPreference */
    uint32_t reserved;     /* 0 */
    uint64_t flags;        /* AGAA_GOAL_… */
    const AgaaMeasuredSettings* measured; /* read during the call only */
    uint32_t measuredCount;               /* 0: the table of ten scenes predicts */
    uint32_t reservedMeasured;            /* 0 */
} AgaaGoal;
#define AGAA_GOAL_INIT                                                                                                 \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_GOAL, (uint32_t)sizeof(AgaaGoal), NULL, 0.0f, 0.0f, 0.8f, 0.0f, 0, AGAA_PREFER_TIME, 0, 0, \
            NULL, 0, 0                                                                                                 \
    }
AGAA_API void AGAA_CALL agaaInitGoal(AgaaGoal* outGoal, size_t structSize);

/* ---- observations --------------------------------------------------------------------------- */

/* Bits of AgaaObservation::flags: members that are known. */
#define AGAA_OBSERVED_COUNTS UINT64_C(0x01)
#define AGAA_OBSERVED_TIMES UINT64_C(0x02)

/* Counts and times of a finished frame, and the settings that rendered it. agaaObserve fills the struct; a host may
 * also fill it from its own timers. */
typedef struct AgaaObservation {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    uint64_t flags;          /* AGAA_OBSERVED_… */
    const char* technique;   /* technique of the frame; null: unknown */
    const char* preset;      /* null: none */
    uint32_t samples;        /* n, [0, 128]; 0: unknown */
    uint32_t aggregates;     /* c or S, [0, 8]; 0: none */
    uint32_t generationTier; /* AgaaTier that ran; AUTO: none */
    uint32_t reserved;       /* 0 */
    uint64_t pixels;         /* pixels of the frame; 0: unknown */
    /* The next four members are known with AGAA_OBSERVED_COUNTS. */
    float coverage;           /* share of the samples with geometry, [0, 1] */
    float eventsPerPixel;     /* shading events, mean over all pixels, [0, 1e6] */
    float lightsPerEvent;     /* lights that a shading event evaluates, mean, [0, 1e6] */
    float shadowTapsPerEvent; /* look-ups in all shadows, mean, [0, 1e6] */
    /* The next two members are known with AGAA_OBSERVED_TIMES. */
    float geometryMilliseconds; /* stages prepass, definition and generation, [0, 1e9] */
    float shadingMilliseconds;  /* all other stages, [0, 1e9] */
} AgaaObservation;
#define AGAA_OBSERVATION_INIT                                                                                          \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_OBSERVATION, (uint32_t)sizeof(AgaaObservation), NULL, 0, NULL, NULL, 0, 0, 0, 0, 0, 0.0f,  \
            0.0f, 0.0f, 0.0f, 0.0f, 0.0f                                                                               \
    }
AGAA_API void AGAA_CALL agaaInitObservation(AgaaObservation* outObservation, size_t structSize);

/* Reads an observation from the statistics of a frame.
 *
 * view             The description of the view that rendered the frame; its width and height are those of the frame
 *                  (AgaaFrame::width).
 * caps             Capabilities of the context. Null: an ideal device.
 * log              May be null.
 * statistics       Statistics of the frame (agaaGetFrameStatistics). Counts are known if the view has
 *                  AGAA_CONFIG_COUNTERS, times if all passes are timed.
 * outObservation   Initialised; unchanged on failure. Counts or times that the statistics lack keep their values if
 *                  they belong to the same settings and number of pixels; otherwise they become unknown. Counting
 *                  makes frames slower: a host may count in some frames, time others, and pass the same struct for
 *                  both. Its technique and preset have static storage.
 *
 * Errors           Those of agaaQueryMemory that concern the description, and
 *                  AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             statistics or outObservation is not initialised
 *                  AGAA_ERROR_OUT_OF_RANGE       statistics has more than AGAA_MAX_PASSES passes, or a time that is
 *                                                negative or not finite
 * Threads          Any. */
AGAA_API AgaaResult AGAA_CALL agaaObserve(const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                          const AgaaFrameStatistics* statistics, AgaaObservation* outObservation);

/* ---- choices -------------------------------------------------------------------------------- */

/* Bits of AgaaChoice::missedLimits. */
#define AGAA_LIMIT_ERROR_SHARE UINT32_C(0x01)
#define AGAA_LIMIT_ERROR UINT32_C(0x02)
#define AGAA_LIMIT_MILLISECONDS UINT32_C(0x04)
#define AGAA_LIMIT_BYTES UINT32_C(0x08)

#define AGAA_CHOICE_MEMORY 200
typedef struct AgaaChoice {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null */
    const char* technique;   /* static storage; null: nothing is chosen yet */
    const char* preset;      /* name for agaaApplyPreset, static storage; null: none */
    uint32_t samples;        /* n */
    uint32_t aggregates;     /* c or S; 0: the technique has none */
    uint32_t generationTier; /* AgaaTier; AUTO: the technique has none */
    uint32_t hasChanged;     /* 1: the settings differ from those of `current`, or there was no current choice */
    uint32_t missedLimits;   /* AGAA_LIMIT_… that the choice is predicted to miss. `reason` says why it is made or
                                kept nevertheless */
    uint32_t leftOut;        /* number of settings of the table, or of AgaaGoal::measured, that the device, the view
                                or the goal's flags do not allow */
    float errorShare;        /* predicted error divided by the error of "single", in AgaaGoal::sceneShare of the
                                scenes. With AgaaGoal::measured, this member and the next two are the measured error.
                                Predicted with AGAA_GOAL_PREDICT_OTHERS, they are not exceeded with the probabilities
                                AgaaGoal::sceneShare, 0.5, and 0.98 or more */
    float errorShareMedian;  /* predicted error share in half of the scenes */
    float errorShareWorst;   /* predicted error share in all scenes */
    float error;             /* predicted error, in AgaaGoal::sceneShare of the scenes; or the measured one */
    float milliseconds;      /* predicted time. Until a call has measured or observed times, it is the time on the
                                device of the table */
    uint32_t hasTimes;       /* 1: a call had observed times */
    uint64_t bytes;          /* AgaaMemoryReport::totalBytes */
    char reason[512];        /* the choice and the reasons for it, one to three sentences */
    float memory[AGAA_CHOICE_MEMORY]; /* state of the library between calls, [0, inf). Pass it on unchanged */
} AgaaChoice;
#define AGAA_CHOICE_INIT                                                                                               \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_CHOICE, (uint32_t)sizeof(AgaaChoice), NULL, NULL, NULL, 0, 0, 0, 0, 0, 0, 0.0f, 0.0f,      \
            0.0f, 0.0f, 0.0f, 0, 0, {0}, {                                                                             \
            0.0f                                                                                                       \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitChoice(AgaaChoice* outChoice, size_t structSize);

/* Chooses the technique, its tier, n, c and preset for a goal. The candidates are the settings of a table that was
 * measured on ten scenes, those that the host measured in its own scene, or both (docs/integration/goals.md). The call
 * creates nothing: if hasChanged is 1, the host applies the choice (agaaApplyChoice) and creates another view.
 *
 * The byte limit has priority over the other limits. If no settings satisfy all limits, the call chooses the
 * settings whose largest ratio of a predicted number to its limit is least.
 *
 * The current choice stays until one of these cases, so that noise in the times does not make it alternate:
 * - It is no longer allowed, or misses the byte limit or an error limit that other settings satisfy.
 * - It misses the time limit by more than 10 % or cannot satisfy all limits, and other settings satisfy all limits
 *   or, if there are none, have a largest ratio that is 15 % less.
 * - Other settings need 15 % less time or, with AGAA_PREFER_ERROR, have a smaller error.
 * In the last two cases, settings that satisfy all limits must satisfy the time limit with 10 % to spare; if times
 * were observed, these cases also wait for 16 observations with times of the current choice. Predictions use means
 * of about 16 observations; settings that ran before are predicted from their own times. The call forgets observed
 * times when the measured times of the goal change.
 *
 * view          Provides the size, layout, facts, functions and flags. The settings that agaaApplyChoice sets are
 *               ignored.
 * caps          Capabilities of the context. Null: an ideal device.
 * log           May be null.
 * observation   Observation of a frame with any settings. Null: no observation since the last call. Frames with
 *               settings that are not in the table are not used. Times of settings that the goal's measured times
 *               lack are not used.
 * current       The result of the last call, or initialised. May be null, and may be outChoice.
 * outChoice     Initialised; unchanged on failure.
 *
 * Errors        AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, functions of the host exclude each other, their
 *                                             glslExtensions are not valid, or current has settings that are not in
 *                                             the table; measured settings are not in the table, occur twice, have
 *                                             times without pixels, lack an error or times that they need, or
 *                                             have times with AGAA_GOAL_PREDICT_OTHERS
 *               AGAA_ERROR_STRUCT             a struct is not initialised, or measured settings differ in structSize
 *               AGAA_ERROR_OUT_OF_RANGE       a number is not finite or out of its range, a flag is unknown, or a
 *                                             reserved member is not 0
 *               AGAA_ERROR_LAYOUT             the layout is not valid
 *               AGAA_ERROR_TOO_LARGE          AgaaFetchFunction has more draws and primitives than ids distinguish
 *               AGAA_ERROR_UNSUPPORTED        the view's technique is unknown, or no settings of the table can be
 *                                             planned
 * Threads       Any. */
AGAA_API AgaaResult AGAA_CALL agaaChooseSettings(const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                                                 const AgaaLog* log, const AgaaGoal* goal,
                                                 const AgaaObservation* observation, const AgaaChoice* current,
                                                 AgaaChoice* outChoice);

/* Applies a choice to the settings of a view.
 *
 * choice        Result of agaaChooseSettings.
 * config        Receives technique, samples, aggregates, both tiers, and the members that agaaApplyPreset sets;
 *               without a preset, these receive their defaults. aggregates is the choice's, also with
 *               AGAA_FILTER_CLASS. All other members keep their values.
 * aggregation   Receives the members that agaaApplyPreset sets; without a preset, these receive their defaults.
 *               Chain it to config.
 * measurement   Receives seeds and the flags of filters and routing. Chain it to config. May be null.
 *
 * Errors        AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or the choice has settings that are not in the table
 *               AGAA_ERROR_STRUCT             a struct is not initialised
 *               AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, a struct twice, or does not end
 *               On failure all structs keep their values.
 * Threads       Any. */
AGAA_API AgaaResult AGAA_CALL agaaApplyChoice(const AgaaChoice* choice, AgaaConfig* config,
                                              AgaaAggregation* aggregation, AgaaMeasurement* measurement);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_GOAL_H */
