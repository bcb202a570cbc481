/* The conformance suite of the AGAA SDK: tests of the promises that the headers make, and checks of an integration.
 * SPDX-License-Identifier: MIT
 *
 * The static library agaa_conformance does not link the SDK. It finds the SDK's functions by name, so that it can test
 * any library of the same soname. The program agaa-conformance runs the tests on devices of its own; an engine runs
 * agaaConformanceCheckHost on its own device.
 */
#ifndef AGAA_CONFORMANCE_H
#define AGAA_CONFORMANCE_H

#include "agaa_sdk.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the library under test -------------------------------------------------------------------- */

typedef void (*AgaaConformanceFunction)(void);
/* Returns a function of the SDK by its name, or null. */
typedef AgaaConformanceFunction (*AgaaConformanceGetFunction)(void* user, const char* name);

/* ---- results ------------------------------------------------------------------------------------ */

typedef enum AgaaConformanceStatus {
    AGAA_CONFORMANCE_PASSED = 0,
    AGAA_CONFORMANCE_FAILED = 1,
    AGAA_CONFORMANCE_SKIPPED = 2, /* the reason says why the test cannot run */
    AGAA_CONFORMANCE_STATUS_MAX_ENUM = 0x7FFFFFFF
} AgaaConformanceStatus;

/* The result of one test. Strings are valid during the callback only. */
typedef struct AgaaConformanceResult {
    const char* name;    /* name of the test, for example "agaaQueryMemory/AGAA_ERROR_STRUCT" or
                            "integration/normals" */
    const char* backend; /* "core", "vk", "gl" or "host" */
    const char* reason;  /* reason of a failure or of a skipped test; otherwise empty */
    uint32_t status;     /* AgaaConformanceStatus */
    uint32_t reserved;
    double milliseconds;
} AgaaConformanceResult;

/* Receives each result when its test ends. */
typedef void (*AgaaConformanceCallback)(void* user, const AgaaConformanceResult* result);

/* ---- the engine under test ---------------------------------------------------------------------- */

typedef enum AgaaConformanceApi {
    AGAA_CONFORMANCE_VULKAN = 0,
    AGAA_CONFORMANCE_OPENGL = 1,
    AGAA_CONFORMANCE_API_MAX_ENUM = 0x7FFFFFFF
} AgaaConformanceApi;

/* An engine that integrates the SDK. The suite creates views in the engine's context, asks the engine to render its
 * own scene with them, and compares the images and the counters with those of a correct integration.
 *
 * The scene should have several surfaces behind each other, drawn from back to front, which fill at least a tenth of
 * the image, and an alpha-masked surface if the engine has such materials. It must not change between frames.
 * Callbacks return AGAA_OK or an error and must not throw. */
typedef struct AgaaConformanceHost {
    uint32_t structSize; /* sizeof(AgaaConformanceHost) */
    uint32_t api;        /* AgaaConformanceApi */
    void* user;
    AgaaContext context;
    /* Size, facts, flags and functions of the views. An AgaaGBufferFunction without samplePositions, or an
     * AgaaFetchFunction, may be chained; an AgaaShadowFunction is ignored. The suite replaces the configuration. It
     * keeps only the facts AGAA_FACT_ALPHA_MASKED and AGAA_FACT_CUSTOM_DEPTH, because it renders with ambient light
     * or one light, without shadows. */
    const AgaaViewDesc* view;
    /* Creates the engine's objects for a view that the suite has created, for example pipelines. May be null. */
    AgaaResult (*prepareView)(void* user, AgaaView view);
    /* Releases the engine's objects for a view that the suite destroys next. The suite does not call it if
     * prepareView failed. The device must be idle. May be null. */
    void (*releaseView)(void* user, AgaaView view);
    /* Renders one frame and waits until the device has finished it. The engine sets view, projection, draw and
     * drawUser of the frame, calls agaaVkRecordFrame or agaaGlRecordFrame, and returns its result. The suite has set
     * all other members. outPixels receives the output: linear RGBA, row 0 first, 4 * width * height floats. */
    AgaaResult (*renderFrame)(void* user, AgaaView view, AgaaFrame* frame, float* outPixels);
    /* Returns the messages of validation layers or of OpenGL's debug output since the last call, one per line, valid
     * until the next call. Returns null if there are none. May be null: the suite then does not test messages. */
    const char* (*takeMessages)(void* user);
    /* Leaves alpha-masked objects out of all passes of the frames from now on, or draws them again. May be null: the
     * suite then cannot distinguish a wrong alpha mask from other geometry, and integration/same_geometry fails. */
    void (*hideMasked)(void* user, uint32_t isHidden);
} AgaaConformanceHost;

/* ---- runs ----------------------------------------------------------------------------------------- */

typedef struct AgaaConformanceRun {
    uint32_t structSize; /* sizeof(AgaaConformanceRun) */
    uint32_t reserved;
    AgaaConformanceGetFunction getFunction; /* null: dlsym finds the functions in the program */
    void* getUser;
    const char* filter; /* null: all tests. Otherwise patterns of names, separated by ':', with '*' and '?'; patterns
                           after '-' exclude tests */
    AgaaConformanceCallback onResult; /* may be null */
    void* resultUser;
} AgaaConformanceRun;

/* Runs the tests that need no device.
 *
 * Returns   The number of tests that failed, or -1 if the run is not valid or the library lacks a function. */
int32_t agaaConformanceTestLibrary(const AgaaConformanceRun* run);

/* Checks the integration of an engine. The name of each result is the duty of the host that the check tests. The
 * reason of a failure states the measurement and the usual cause.
 *
 * Returns   The number of checks that failed, or -1 if an argument is not valid or the library lacks a function. */
int32_t agaaConformanceCheckHost(const AgaaConformanceRun* run, const AgaaConformanceHost* host);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_CONFORMANCE_H */
