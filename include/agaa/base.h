/* Version, handles, results, struct types, log, host memory, contexts. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_BASE_H
#define AGAA_BASE_H

#include <stddef.h>
#include <stdint.h>

#define AGAA_VERSION_MAJOR 0
#define AGAA_VERSION_MINOR 2
#define AGAA_VERSION_PATCH 0
#define AGAA_HEADER_VERSION                                                                                            \
    (((uint32_t)AGAA_VERSION_MAJOR << 22) | ((uint32_t)AGAA_VERSION_MINOR << 12) | (uint32_t)AGAA_VERSION_PATCH)

#if defined(AGAA_STATIC) /* the host links the static library */
#define AGAA_API
#elif !defined(_WIN32)
#define AGAA_API __attribute__((visibility("default")))
#elif defined(AGAA_BUILDING)
#define AGAA_API __declspec(dllexport)
#else
#define AGAA_API __declspec(dllimport)
#endif
#if defined(_WIN32)
#define AGAA_CALL __cdecl
#else
#define AGAA_CALL
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- results -------------------------------------------------------------------------------- */

typedef int32_t AgaaResult; /* AgaaResultCode, or a value of a later library */

typedef enum AgaaResultCode {
    AGAA_OK = 0,
    AGAA_NOT_READY = 1,                /* the result does not exist yet */
    AGAA_ERROR_INVALID_ARGUMENT = -1,  /* an argument is null or has no valid value */
    AGAA_ERROR_VERSION = -2,           /* the host uses something that this library does not know */
    AGAA_ERROR_STRUCT = -3,            /* a struct has the wrong sType or structSize */
    AGAA_ERROR_UNKNOWN_STRUCT = -4,    /* a pNext chain holds an unknown struct, a struct twice, or does not end */
    AGAA_ERROR_OUT_OF_RANGE = -5,      /* a value is out of its range */
    AGAA_ERROR_UNSUPPORTED = -6,       /* the device or this library cannot do what was asked */
    AGAA_ERROR_LAYOUT = -7,            /* a G-buffer layout is not valid or cannot be packed */
    AGAA_ERROR_TOO_LARGE = -8,         /* a size exceeds a limit of the device or of 64-bit arithmetic */
    AGAA_ERROR_OUT_OF_MEMORY = -9,     /* memory could not be allocated */
    AGAA_ERROR_DEVICE = -10,           /* the graphics API reported an error */
    AGAA_ERROR_CALLBACK = -11,         /* a host callback reported a failure or returned an invalid value */
    AGAA_ERROR_PARTIAL = -12,          /* a frame was recorded in part: discard the command buffer */
    AGAA_ERROR_WRONG_ORDER = -13,      /* the call is not allowed at this point */
    AGAA_ERROR_BUFFER_TOO_SMALL = -14, /* the caller's array is too small */
    AGAA_ERROR_INTERNAL = -15,         /* an error of the library itself */
    AGAA_RESULT_MAX_ENUM = 0x7FFFFFFF
} AgaaResultCode;

/* Describes a result in a few words of English.
 *
 * Returns   Static storage, never null; "unknown result" if the library does not know the value.
 * Errors    None. */
AGAA_API const char* AGAA_CALL agaaResultString(AgaaResult result);

/* Names a result as the enumerator is spelled, for example "AGAA_ERROR_LAYOUT".
 *
 * Returns   Static storage, never null; "unknown result" if the library does not know the value.
 * Errors    None. */
AGAA_API const char* AGAA_CALL agaaResultName(AgaaResult result);

/* Returns the version of the library, encoded as AGAA_HEADER_VERSION.
 *
 * Errors    None. */
AGAA_API uint32_t AGAA_CALL agaaGetVersion(void);

/* ---- struct types --------------------------------------------------------------------------- */

typedef enum AgaaStructType {
    AGAA_STRUCTURE_TYPE_LOG = 1,
    AGAA_STRUCTURE_TYPE_LAYOUT = 2,
    AGAA_STRUCTURE_TYPE_CONFIG = 3,
    AGAA_STRUCTURE_TYPE_SCENE_FACTS = 4,
    AGAA_STRUCTURE_TYPE_VIEW_DESC = 5,
    AGAA_STRUCTURE_TYPE_DEVICE_CAPS = 6,
    AGAA_STRUCTURE_TYPE_MEMORY_REPORT = 7,
    AGAA_STRUCTURE_TYPE_FRAME = 8,
    AGAA_STRUCTURE_TYPE_FRAME_STATISTICS = 9,
    AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION = 10,
    AGAA_STRUCTURE_TYPE_FRAME_VALIDATION = 11,
    AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION = 12,
    AGAA_STRUCTURE_TYPE_FETCH_FUNCTION = 13,
    AGAA_STRUCTURE_TYPE_TARGET = 14,
    AGAA_STRUCTURE_TYPE_AGGREGATION = 15,
    AGAA_STRUCTURE_TYPE_MEASUREMENT = 16,
    AGAA_STRUCTURE_TYPE_CONTEXT_DESC = 17,
    AGAA_STRUCTURE_TYPE_DRAW_PASS = 18,
    AGAA_STRUCTURE_TYPE_DRAW_TARGET = 19,
    AGAA_STRUCTURE_TYPE_SURFACE = 20,
    AGAA_STRUCTURE_TYPE_CAPABILITY = 21,
    AGAA_STRUCTURE_TYPE_DECOUPLED_COVERAGE = 22,
    AGAA_STRUCTURE_TYPE_ADAPTIVE_SAMPLING = 23,
    AGAA_STRUCTURE_TYPE_PRICE = 24,
    AGAA_STRUCTURE_TYPE_FACT_REPORT = 25,
    AGAA_STRUCTURE_TYPE_GOAL = 26,
    AGAA_STRUCTURE_TYPE_OBSERVATION = 27,
    AGAA_STRUCTURE_TYPE_CHOICE = 28,
    AGAA_STRUCTURE_TYPE_MEASURED_SETTINGS = 29,
    AGAA_STRUCTURE_TYPE_TEMPORAL = 30,
    AGAA_STRUCTURE_TYPE_TEMPORAL_FRAME = 31,
    AGAA_STRUCTURE_TYPE_SHADING_FUNCTION = 32,
    AGAA_STRUCTURE_TYPE_RESOLVED_OUTPUTS = 33,
    AGAA_STRUCTURE_TYPE_BREADCRUMBS = 34,
    AGAA_STRUCTURE_TYPE_VK_REQUIREMENTS = 1000,
    AGAA_STRUCTURE_TYPE_VK_DEVICE_DESC = 1001,
    AGAA_STRUCTURE_TYPE_VK_FRAME = 1002,
    AGAA_STRUCTURE_TYPE_VK_DRAW_PASS = 1003,
    AGAA_STRUCTURE_TYPE_VK_SURFACE = 1004,
    AGAA_STRUCTURE_TYPE_VK_ALLOCATOR = 1005,
    AGAA_STRUCTURE_TYPE_VK_RESOLVED_IMAGES = 1006,
    AGAA_STRUCTURE_TYPE_GL_REQUIREMENTS = 2000,
    AGAA_STRUCTURE_TYPE_GL_DEVICE_DESC = 2001,
    AGAA_STRUCTURE_TYPE_GL_FRAME = 2002,
    AGAA_STRUCTURE_TYPE_GL_DRAW_PASS = 2003,
    AGAA_STRUCTURE_TYPE_GL_SURFACE = 2004,
    AGAA_STRUCTURE_TYPE_GL_PROGRAM_CACHE = 2005,
    AGAA_STRUCTURE_TYPE_GL_RESOLVED_TEXTURES = 2006,
    /* A library that does not know a struct whose type has this bit skips it. */
    AGAA_STRUCTURE_TYPE_OPTIONAL_BIT = 0x40000000,
    AGAA_STRUCTURE_TYPE_MAX_ENUM = 0x7FFFFFFF
} AgaaStructType;

/* The first members of every versioned struct. Initialise a struct with its macro AGAA_…_INIT, or with its function
 * agaaInit…, which set these members and the defaults of all others. agaaInit… does nothing if the pointer is null.
 *
 * structSize   sizeof the struct in the header that the host was compiled with; a multiple of 8. Structs grow at
 *              their end only.
 *              - A smaller size of an earlier version is accepted; the missing members have their defaults.
 *              - A larger size is accepted if the bytes that the library does not know are 0; otherwise the call
 *                fails with AGAA_ERROR_VERSION, and the log names the offset of the first such byte.
 *              - The library writes output structs up to this size.
 * pNext        Null, or the first struct of a chain. The struct's comment lists the structs that may be chained. Any
 *              other struct fails with AGAA_ERROR_UNKNOWN_STRUCT, unless its type has
 *              AGAA_STRUCTURE_TYPE_OPTIONAL_BIT.
 *
 * Elements of an array of versioned structs must all have the structSize of the first. */
typedef struct AgaaStructHeader {
    uint32_t sType; /* AgaaStructType */
    uint32_t structSize;
    const void* pNext;
} AgaaStructHeader;

/* ---- log and host memory -------------------------------------------------------------------- */

typedef enum AgaaSeverity {
    AGAA_SEVERITY_INFO = 0,
    AGAA_SEVERITY_WARNING = 1,
    AGAA_SEVERITY_ERROR = 2,
    AGAA_SEVERITY_MAX_ENUM = 0x7FFFFFFF
} AgaaSeverity;

/* Receives one message.
 *
 * user       AgaaLog::user.
 * severity   AgaaSeverity.
 * code       The result that the call returns; AGAA_OK for information and warnings.
 * message    UTF-8, valid during the callback only. The message of an error begins with the name of the function.
 *
 * Threads    The thread that called the SDK. The callback must not throw and must not call the SDK. */
typedef void(AGAA_CALL* AgaaLogCallback)(void* user, uint32_t severity, AgaaResult code, const char* message);

typedef struct AgaaLog {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;        /* null */
    AgaaLogCallback callback; /* may be null */
    void* user;
} AgaaLog;
#define AGAA_LOG_INIT                                                                                                  \
    { AGAA_STRUCTURE_TYPE_LOG, (uint32_t)sizeof(AgaaLog), NULL, NULL, NULL }
AGAA_API void AGAA_CALL agaaInitLog(AgaaLog* outLog, size_t structSize);

/* Allocates and frees host memory for the objects behind handles. `alignment` is a power of two. If the host returns
 * null, the SDK's call fails with AGAA_ERROR_OUT_OF_MEMORY. Both callbacks must not throw and must not call the SDK. */
typedef void*(AGAA_CALL* AgaaAllocateCallback)(void* user, size_t size, size_t alignment);
typedef void(AGAA_CALL* AgaaFreeCallback)(void* user, void* memory);

/* ---- contexts and views --------------------------------------------------------------------- */

typedef struct AgaaContext_T* AgaaContext; /* the SDK inside one Vulkan device or OpenGL context */
typedef struct AgaaView_T* AgaaView;       /* surfaces and pipelines for one camera at one size */

/* Describes a context. Chain an AgaaVkDeviceDesc (agaa_vk.h) for agaaVkCreateContext, or an AgaaGlDeviceDesc
 * (agaa_gl.h) for agaaGlCreateContext. Chain an AgaaVkAllocator to allocate device memory in the host, or an
 * AgaaGlProgramCache to keep compiled programs. */
typedef struct AgaaContextDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    /* Number of frames that may be unfinished at once, and whose statistics are kept, [1, 8]. Frame i requires that
     * frame i - framesInFlight is at most AgaaFrame::completedFrame. */
    uint32_t framesInFlight;
    uint32_t reserved;             /* 0 */
    const AgaaLog* log;            /* may be null; copied */
    AgaaAllocateCallback allocate; /* host memory; set both callbacks or neither */
    AgaaFreeCallback free;
    void* allocateUser;
} AgaaContextDesc;
#define AGAA_CONTEXT_DESC_INIT                                                                                         \
    { AGAA_STRUCTURE_TYPE_CONTEXT_DESC, (uint32_t)sizeof(AgaaContextDesc), NULL, 2, 0, NULL, NULL, NULL, NULL }
AGAA_API void AGAA_CALL agaaInitContextDesc(AgaaContextDesc* outDesc, size_t structSize);

/* Destroys a context.
 *
 * context   May be null. All its views must be destroyed.
 *
 * Errors    AGAA_ERROR_WRONG_ORDER   the context still has views; it is kept
 * Threads   One call at a time per context.
 * OpenGL    The context must be current. */
AGAA_API AgaaResult AGAA_CALL agaaDestroyContext(AgaaContext context);

/* Destroys a view and its surfaces.
 *
 * view      May be null. The device must have finished every frame that was recorded with the view.
 *
 * Errors    None.
 * Threads   One call at a time per context.
 * OpenGL    The context must be current. */
AGAA_API void AGAA_CALL agaaDestroyView(AgaaView view);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_BASE_H */
