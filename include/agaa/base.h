/* Version, handles, results, struct types, log and host memory. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_BASE_H
#define AGAA_BASE_H

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

/* Destroying null is legal. On OpenGL the context must be current. Every frame recorded with the object must have
 * finished. A context that still has views is kept, and the log is told: destroy them first. */
AGAA_API void AGAA_CALL agaaDestroyView(AgaaView view);
AGAA_API void AGAA_CALL agaaDestroyContext(AgaaContext context);

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
    X(AGAA_ERROR_CALLBACK, -11, "a host callback reported failure")           \
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
    AGAA_STRUCTURE_TYPE_TARGET = 15,
    AGAA_STRUCTURE_TYPE_AGGREGATION = 16,
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

/* First members of every versioned struct; AGAA_…_INIT sets them and the defaults, of an AgaaLayout
 * agaaGetBuiltinLayout. Structs without them are elements of arrays and parts of versioned ones. */
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

#ifdef __cplusplus
}
#endif
#endif /* AGAA_BASE_H */
