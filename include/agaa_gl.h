/* AGAA SDK on OpenGL. Includes no OpenGL header: object names, formats and enumerations are uint32_t with OpenGL's
 * values.
 * SPDX-License-Identifier: MIT
 *
 * OpenGL   Every function except agaaGlGetRequirements and agaaGlGetProgramCache needs a current context: for a given
 *          AgaaContext or AgaaView, the one in which it was created.
 */
#ifndef AGAA_GL_H
#define AGAA_GL_H

#include "agaa_sdk.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*AgaaGlFunction)(void);
/* Returns an OpenGL function by its name, like eglGetProcAddress and glXGetProcAddress. `user` is the host's
 * pointer. The callback must also return functions of OpenGL 1.x, which wglGetProcAddress does not. The SDK calls it
 * in agaaGlGetDeviceCaps and agaaGlCreateContext only. */
typedef AgaaGlFunction(AGAA_CALL* AgaaGlGetProcAddr)(void* user, const char* name);

/* ---- before a context exists ------------------------------------------------------------------ */

/* Lists the version and the extensions that an OpenGL context must have, and extensions that improve the SDK. Names
 * have static storage. */
typedef struct AgaaGlRequirements {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;     /* null */
    uint32_t majorVersion; /* 4.3, core or compatibility profile, with the required extensions */
    uint32_t minorVersion;
    uint32_t completeMajorVersion; /* 4.5, which needs none of the required extensions */
    uint32_t completeMinorVersion;
    uint32_t requiredExtensionCount;
    uint32_t optionalExtensionCount;
    const char* const* requiredExtensions;
    const char* const* optionalExtensions;
} AgaaGlRequirements;
#define AGAA_GL_REQUIREMENTS_INIT                                                                                      \
    { AGAA_STRUCTURE_TYPE_GL_REQUIREMENTS, (uint32_t)sizeof(AgaaGlRequirements), NULL, 0, 0, 0, 0, 0, 0, NULL, NULL }
AGAA_API void AGAA_CALL agaaInitGlRequirements(AgaaGlRequirements* outRequirements, size_t structSize);

/* Gets the requirements on an OpenGL context.
 *
 * outRequirements   Initialised; unchanged on failure.
 *
 * Errors            AGAA_ERROR_INVALID_ARGUMENT   outRequirements is null
 *                   AGAA_ERROR_STRUCT             outRequirements is not initialised
 * Threads           Any. No context needs to be current. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetRequirements(AgaaGlRequirements* outRequirements);

/* Gets the capabilities of the current context, for the queries of agaa_sdk.h. With AGAA_GL_STORAGE_IMAGES the
 * limits differ: use agaaGlGetContextCaps.
 *
 * log       May be null.
 * outCaps   Initialised; unchanged on failure.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *           AGAA_ERROR_STRUCT             outCaps is not initialised
 *           AGAA_ERROR_UNSUPPORTED        no context is current, or it is too old or lacks a required extension, or
 *                                         getProcAddr has no pointer of a core function
 * Threads   The thread in which the context is current. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetDeviceCaps(AgaaGlGetProcAddr getProcAddr, void* getProcUser, const AgaaLog* log,
                                                  AgaaDeviceCaps* outCaps);

/* ---- context ----------------------------------------------------------------------------------- */

/* Selects how the SDK treats the host's state. docs/state.md lists the states that RESTORE keeps. */
typedef enum AgaaGlStatePolicy {
    /* The SDK reads every state of the list on entry, and sets it again before each draw callback and before it
     * returns, even if a callback or the frame fails. A program that the host deleted while it is in use is lost,
     * because OpenGL deletes it when another one is used. */
    AGAA_GL_STATE_RESTORE = 0,
    /* The SDK calls pushState on entry and after each draw callback, and popState before each draw callback and
     * before it returns. The policy is for hosts that save state more cheaply than with glGet. If the last popState
     * fails, the frame fails with AGAA_ERROR_CALLBACK although its output is written. */
    AGAA_GL_STATE_CALLBACKS = 1,
    /* The SDK saves nothing. The host sets the state that it needs. */
    AGAA_GL_STATE_NONE = 2,
    AGAA_GL_STATE_MAX_ENUM = 0x7FFFFFFF
} AgaaGlStatePolicy;

/* Selects how the host's fragment shaders access the buffers that they write. */
typedef enum AgaaGlStorage {
    AGAA_GL_STORAGE_BUFFERS = 0, /* shader storage blocks */
    AGAA_GL_STORAGE_IMAGES = 1,  /* buffer images, for engines that do not support storage blocks */
    AGAA_GL_STORAGE_MAX_ENUM = 0x7FFFFFFF
} AgaaGlStorage;

/* Selects how the host's fragment shaders receive the constants of the frame. With UNIFORMS or TEXELS, and
 * AGAA_GL_STORAGE_IMAGES, the shaders declare no block. "msaa" needs BLOCK (AGAA_ERROR_UNSUPPORTED). */
typedef enum AgaaGlConstants {
    AGAA_GL_CONSTANTS_BLOCK = 0,    /* a uniform block at AGAA_GL_BINDING_FRAME */
    AGAA_GL_CONSTANTS_UNIFORMS = 1, /* `uniform vec4 agaa_constants[]`. Each draw callback sets the uniform of its
                                       programs to AgaaDrawTarget::constants, for example with glUniform4fv */
    AGAA_GL_CONSTANTS_TEXELS = 2,   /* a buffer texture at AGAA_GL_BINDING_FRAME, which then is a texture unit: set
                                       it to one that no other binding has */
    AGAA_GL_CONSTANTS_MAX_ENUM = 0x7FFFFFFF
} AgaaGlConstants;

/* Selects who declares the outputs of the fragment shader. */
typedef enum AgaaGlOutputs {
    AGAA_GL_OUTPUTS_SDK = 0,  /* agaa_out0 … are outputs at locations 0 … */
    AGAA_GL_OUTPUTS_HOST = 1, /* agaa_out0 … are variables that the host copies to its outputs after agaa_emit() */
    AGAA_GL_OUTPUTS_MAX_ENUM = 0x7FFFFFFF
} AgaaGlOutputs;

/* The SDK's resources in the host's fragment shaders, and the kind of binding point of each. */
typedef enum AgaaGlBinding {
    AGAA_GL_BINDING_FRAME = 0,      /* uniform buffer, or the kind that AgaaGlConstants selects */
    AGAA_GL_BINDING_METADATA = 1,   /* texture unit. In AGAA_DRAW_PASS_FRAGMENTS, it holds the table for the host's
                                       own coverage samples (AgaaDecoupledCoverage::samplePositions) */
    AGAA_GL_BINDING_AGGREGATES = 2, /* shader storage buffer; image unit with AGAA_GL_STORAGE_IMAGES */
    AGAA_GL_BINDING_COUNTERS = 3,   /* same kinds as AGAA_GL_BINDING_AGGREGATES */
    AGAA_GL_BINDING_LIGHTS = 4,     /* shader storage buffer; uniform buffer with AGAA_GL_STORAGE_IMAGES */
    AGAA_GL_BINDING_SHADOW0 = 5,    /* texture units of the shadow maps. In AGAA_DRAW_PASS_AGGREGATE of views without
                                       AGAA_VIEW_REVERSED_Z, SHADOW0 holds the normals of the prepass */
    AGAA_GL_BINDING_SHADOW1 = 6,
    AGAA_GL_BINDING_SHADOW2 = 7,
    AGAA_GL_BINDING_SHADOW3 = 8,
    AGAA_GL_BINDING_FRAGMENTS = 9, /* same kinds as AGAA_GL_BINDING_AGGREGATES */
    AGAA_GL_BINDING_COUNT = 10,
    AGAA_GL_BINDING_MAX_ENUM = 0x7FFFFFFF
} AgaaGlBinding;
#define AGAA_GL_MAX_BINDINGS 17

/* Saves or restores the host's state. It must not throw and must not call the SDK. If it returns anything but
 * AGAA_OK, the frame fails with AGAA_ERROR_CALLBACK. */
typedef AgaaResult(AGAA_CALL* AgaaGlStateCallback)(void* user);

/* Describes the host's OpenGL context. Chain it to AgaaContextDesc. */
typedef struct AgaaGlDeviceDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    AgaaGlGetProcAddr getProcAddr;
    void* getProcUser;
    uint32_t glslVersion; /* version of the host's fragment shaders, as in their #version line: 330, 400, 410, … 460 */
    uint32_t storage;     /* AgaaGlStorage */
    uint32_t outputs;     /* AgaaGlOutputs */
    uint32_t statePolicy;          /* AgaaGlStatePolicy */
    AgaaGlStateCallback pushState; /* required, like popState, with AGAA_GL_STATE_CALLBACKS; otherwise the SDK calls
                                      neither */
    AgaaGlStateCallback popState;
    void* stateUser;
    /* Binding points during draw callbacks, by AgaaGlBinding. Binding points of one kind must differ. Elements from
     * AGAA_GL_BINDING_COUNT on must be 0. After the callback the SDK restores the host's bindings, except with
     * AGAA_GL_STATE_NONE. */
    uint32_t bindings[AGAA_GL_MAX_BINDINGS];
    uint32_t constants; /* AgaaGlConstants */
} AgaaGlDeviceDesc;
#define AGAA_GL_DEVICE_DESC_INIT                                                                                       \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_GL_DEVICE_DESC, (uint32_t)sizeof(AgaaGlDeviceDesc), NULL, NULL, NULL, 450,                 \
            AGAA_GL_STORAGE_BUFFERS, AGAA_GL_OUTPUTS_SDK, AGAA_GL_STATE_RESTORE, NULL, NULL, NULL,                     \
            {0, 0, 0, 1, 2, 1, 2, 3, 4, 3, 0, 0, 0, 0, 0, 0, 0}, AGAA_GL_CONSTANTS_BLOCK                               \
    }
AGAA_API void AGAA_CALL agaaInitGlDeviceDesc(AgaaGlDeviceDesc* outDesc, size_t structSize);

/* Compiled programs of an earlier run. Chain it to AgaaContextDesc to keep the SDK's programs in memory: views that
 * are created or resized take equal programs from the cache, and agaaGlGetProgramCache gets them for the next run.
 * Without the struct, the SDK compiles every program from its text. */
typedef struct AgaaGlProgramCache {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t size; /* bytes of data; 0: start empty */
    /* Result of agaaGlGetProgramCache in an earlier run; may be null if size is 0. The SDK copies it during the
     * call. Data of another driver, another version of the library or another format, and damaged data, are ignored
     * with one warning to the log. Checks find accidental damage only: the driver loads the programs, so data must
     * come from a place that the host trusts. */
    const void* data;
} AgaaGlProgramCache;
#define AGAA_GL_PROGRAM_CACHE_INIT                                                                                     \
    { AGAA_STRUCTURE_TYPE_GL_PROGRAM_CACHE, (uint32_t)sizeof(AgaaGlProgramCache), NULL, 0, NULL }
AGAA_API void AGAA_CALL agaaInitGlProgramCache(AgaaGlProgramCache* outCache, size_t structSize);

/* Creates a context in the current OpenGL context. The SDK tests the driver's timer queries, which takes some
 * milliseconds.
 *
 * headerVersion   AGAA_HEADER_VERSION.
 * desc            Must chain an AgaaGlDeviceDesc. It may chain an AgaaGlProgramCache to keep programs.
 * outContext      Receives the context; unchanged on failure. Destroy it with agaaDestroyContext.
 *
 * Errors          AGAA_ERROR_VERSION            header and library have different major or minor versions
 *                 AGAA_ERROR_INVALID_ARGUMENT   no device is chained, getProcAddr or a needed callback is null, only
 *                                               one of two callbacks is set, two bindings of one kind are equal, or
 *                                               AgaaGlProgramCache::data is null although size is not 0
 *                 AGAA_ERROR_OUT_OF_RANGE       a member is out of its range or exceeds a limit of the context
 *                 AGAA_ERROR_UNSUPPORTED        no OpenGL context is current, or it is lost, too old or lacks a
 *                                               required extension, or getProcAddr has no pointer of a core function
 *                 AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated
 *                 AGAA_ERROR_DEVICE             an OpenGL function failed
 * Threads         The thread in which the OpenGL context is current.
 * OpenGL          All state is restored before the call returns. The log reports errors of earlier calls that were
 *                 pending. None of these may be active: transform feedback that is not paused, conditional
 *                 rendering, a query of GL_TIME_ELAPSED, rectangles of GL_EXT_window_rectangles. */
AGAA_API AgaaResult AGAA_CALL agaaGlCreateContext(uint32_t headerVersion, const AgaaContextDesc* desc,
                                                  AgaaContext* outContext);

/* Gets the capabilities of the context, with the limits of AgaaGlDeviceDesc::storage.
 *
 * outCaps   Initialised; unchanged on failure.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or the context is a Vulkan context
 *           AGAA_ERROR_STRUCT             outCaps is not initialised
 * Threads   The thread in which the OpenGL context is current. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps);

/* Gets the programs that the context has compiled, and those of the AgaaGlProgramCache that it was created with, as
 * bytes for a later run. Without an AgaaGlProgramCache, or if the driver has no program binaries
 * (GL_NUM_PROGRAM_BINARY_FORMATS is 0), the bytes hold a header and no programs.
 *
 * size     Receives the number of bytes; unchanged on failure. On entry it holds the size of data in bytes, unless
 *          data is null.
 * data     Null, or receives the bytes; unchanged on failure.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT    the context or size is null, or the context is a Vulkan context
 *          AGAA_ERROR_BUFFER_TOO_SMALL    data is too short
 * Threads  One call at a time per context. The OpenGL context need not be current. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetProgramCache(AgaaContext context, size_t* size, void* data);

/* Creates a view: the surfaces and programs for one camera at one size.
 *
 * desc      Read during the call only, with all that it points to.
 * outView   Receives the view; unchanged on failure. Destroy it with agaaDestroyView, before its context.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, the context is a Vulkan context, functions of the host
 *                                         exclude each other, one has a descriptorSetLayout, or a text of theirs is
 *                                         not valid or does not compile
 *           AGAA_ERROR_STRUCT             a struct is not initialised
 *           AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, a struct twice, or does not end
 *           AGAA_ERROR_OUT_OF_RANGE       a member is out of its range, or has an unknown flag or value
 *           AGAA_ERROR_LAYOUT             the layout is not valid or cannot be packed
 *           AGAA_ERROR_UNSUPPORTED        no technique has this name, or the context or the library cannot do what
 *                                         was asked
 *           AGAA_ERROR_TOO_LARGE          a surface exceeds a limit of the context or of 64-bit arithmetic
 *           AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated
 *           AGAA_ERROR_DEVICE             an OpenGL function failed
 * Threads   The thread in which the OpenGL context is current.
 * OpenGL    All state is restored before the call returns. The log reports errors of earlier calls that were
 *           pending. */
AGAA_API AgaaResult AGAA_CALL agaaGlCreateView(AgaaContext context, const AgaaViewDesc* desc, AgaaView* outView);

/* ---- draw passes and surfaces ----------------------------------------------------------------- */

/* The target of a draw pass on OpenGL. Chain it to AgaaDrawPass. */
typedef struct AgaaGlDrawPass {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    uint32_t colorFormats[8];    /* internal formats of the first AgaaDrawState::colorAttachmentCount attachments */
    uint32_t depthStencilFormat; /* internal format; 0 without a depth attachment */
    uint32_t framebuffer;        /* framebuffer of the view; complete */
} AgaaGlDrawPass;
#define AGAA_GL_DRAW_PASS_INIT                                                                                         \
    { AGAA_STRUCTURE_TYPE_GL_DRAW_PASS, (uint32_t)sizeof(AgaaGlDrawPass), NULL, {0, 0, 0, 0, 0, 0, 0, 0}, 0, 0 }
AGAA_API void AGAA_CALL agaaInitGlDrawPass(AgaaGlDrawPass* outPass, size_t structSize);

/* The objects of a surface on OpenGL. Chain it to AgaaSurface in agaaGetSurface. */
typedef struct AgaaGlSurface {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    uint32_t texture; /* TEXTURE_2D, or TEXTURE_2D_MULTISAMPLE with more than one sample; 0 for buffers */
    uint32_t buffer;  /* 0 for textures */
    uint32_t format;  /* internal format; 0 for buffers */
    uint32_t reserved;
} AgaaGlSurface;
#define AGAA_GL_SURFACE_INIT                                                                                           \
    { AGAA_STRUCTURE_TYPE_GL_SURFACE, (uint32_t)sizeof(AgaaGlSurface), NULL, 0, 0, 0, 0 }
AGAA_API void AGAA_CALL agaaInitGlSurface(AgaaGlSurface* outSurface, size_t structSize);

/* ---- frames ------------------------------------------------------------------------------------- */

typedef struct AgaaGlFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext; /* null, or an AgaaGlResolvedTextures */
    /* The output: level 0 of a TEXTURE_2D with the size of the view, or one that holds the frame at AgaaFrame::outputX
     * and outputY if the frame names its width, in a format that supports image stores; RGBA16F is recommended. The
     * shading segment needs it. Row 0 is where the projection places y = -1. */
    uint32_t outputTexture;
    /* One TEXTURE_2D_ARRAY with depth per AgaaFrame::shadows that no AgaaShadowFunction answers for. Other elements
     * are not read; a frame without shadows needs none. */
    uint32_t shadowTextures[AGAA_MAX_SHADOW_MAPS];
    uint32_t reserved; /* 0 */
} AgaaGlFrame;
#define AGAA_GL_FRAME_INIT                                                                                             \
    { AGAA_STRUCTURE_TYPE_GL_FRAME, (uint32_t)sizeof(AgaaGlFrame), NULL, 0, {0, 0, 0, 0}, 0 }
AGAA_API void AGAA_CALL agaaInitGlFrame(AgaaGlFrame* outFrame, size_t structSize);

/* Textures for AgaaResolvedOutputs. Chain it to AgaaGlFrame. The shading segment of such a view needs it. Each texture
 * is as AgaaGlFrame::outputTexture, with its size or larger, in a float or normalised format that supports image
 * stores. R32F keeps depths. Elements beyond the number of outputs are not read. */
typedef struct AgaaGlResolvedTextures {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t textures[AGAA_MAX_RESOLVED_OUTPUTS]; /* all are different */
    uint32_t reserved[2];                         /* 0 */
} AgaaGlResolvedTextures;
#define AGAA_GL_RESOLVED_TEXTURES_INIT                                                                                 \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_GL_RESOLVED_TEXTURES, (uint32_t)sizeof(AgaaGlResolvedTextures), NULL, {0, 0, 0, 0, 0, 0},  \
        {                                                                                                              \
            0, 0                                                                                                       \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitGlResolvedTextures(AgaaGlResolvedTextures* outTextures, size_t structSize);

/* Runs the segments of a frame in the current context.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer that the frame needs is null, a texture that it needs does not
 *                                         exist or is of another target, a shadow map has no depth, or the view is a
 *                                         Vulkan view
 *           AGAA_ERROR_STRUCT             a struct is not initialised
 *           AGAA_ERROR_OUT_OF_RANGE       a member is out of its range, the output has another size than the view,
 *                                         it or a texture of AgaaGlResolvedTextures does not hold the frame, or the
 *                                         camera, ditherFrame, the size or the facts differ from those of the first
 *                                         segment
 *           AGAA_ERROR_WRONG_ORDER        framesInFlight frames are unfinished, the frame index does not increase, a
 *                                         segment is missing or repeated, or transform feedback is active and not
 *                                         paused
 *           AGAA_ERROR_UNSUPPORTED        the format of the output, or of a texture of AgaaGlResolvedTextures, does not
 *                                         support image stores
 *           AGAA_ERROR_CALLBACK           a callback failed. The output is unchanged; earlier passes have run, so that
 *                                         an unfinished frame cannot continue: the next call begins a frame
 *           AGAA_ERROR_DEVICE             the context is lost. If it has GL_LOSE_CONTEXT_ON_RESET, the SDK calls
 *                                         glGetGraphicsResetStatus, which may report a reset only once: take this
 *                                         error for a reset
 * Threads   The thread in which the OpenGL context is current.
 * OpenGL    AgaaGlDeviceDesc::statePolicy governs the state. None of these may be active: conditional rendering, a
 *           query of GL_TIME_ELAPSED, rectangles of GL_EXT_window_rectangles. The SDK does not read OpenGL errors:
 *           they remain for the host's glGetError. Exception: if a texture is of another target, the log reports the
 *           errors that were pending, and they are lost. Functions of the host (agaa/functions.h) use the resources
 *           that are bound on entry or, if the host draws, when the last draw callback returns. The SDK does not use
 *           texture units from 17 and other binding points from 4, except for those named in AgaaGlDeviceDesc.
 *           Techniques with lists of fragments, "dcaa" and the tier FRAGMENTS of "agaa", use binding point 4 too. Views
 *           with AgaaResolvedOutputs use storage binding points 4 and 5 and image units up to 7. */
AGAA_API AgaaResult AGAA_CALL agaaGlRecordFrame(AgaaView view, const AgaaFrame* frame, const AgaaGlFrame* glFrame);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_GL_H */
