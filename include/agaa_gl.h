/* AGAA SDK on OpenGL. Includes no OpenGL header: object names, formats and enums are uint32_t with
 * OpenGL's own values.
 * SPDX-License-Identifier: MIT
 *
 * Threading  Every function but agaaGlGetRequirements needs a GL context to be current in the calling thread:
 *            for an AgaaContext or AgaaView, the one that it was made in.
 */
#ifndef AGAA_GL_H
#define AGAA_GL_H

#include "agaa_sdk.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*AgaaGlFunction)(void);
/* As eglGetProcAddress or glXGetProcAddress, with the host's pointer before the name. Must return functions of
 * OpenGL 1.x as well, which wglGetProcAddress alone does not. Called inside agaaGlGetDeviceCaps and
 * agaaGlCreateContext only. */
typedef AgaaGlFunction(AGAA_CALL* AgaaGlGetProcAddr)(void* user, const char* name);

/* ---- before a context exists ------------------------------------------------------------------ */

/* What a GL context must and should offer. Names have static storage. */
typedef struct AgaaGlRequirements {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t majorVersion; /* core or compatibility profile; 4.3 */
    uint32_t minorVersion;
    uint32_t completeMajorVersion; /* that needs none of the required extensions; 4.5 */
    uint32_t completeMinorVersion;
    uint32_t requiredExtensionCount; /* what the version lacks */
    const char* const* requiredExtensions;
    uint32_t optionalExtensionCount;
    const char* const* optionalExtensions;
} AgaaGlRequirements;
#define AGAA_GL_REQUIREMENTS_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_GL_REQUIREMENTS, (uint32_t)sizeof(AgaaGlRequirements), NULL, 0, 0, 0, 0, 0,   \
     NULL, 0, NULL}
AGAA_API AgaaResult AGAA_CALL agaaGlGetRequirements(AgaaGlRequirements* outRequirements);

/* Capabilities of the current context, to be passed to the queries of agaa_sdk.h. log may be null. For
 * AGAA_GL_STORAGE_IMAGES, whose limits are others, ask agaaGlGetContextCaps. AGAA_ERROR_UNSUPPORTED where no
 * context is current or it is too old. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetDeviceCaps(AgaaGlGetProcAddr getProcAddr, void* getProcUser,
                                                  const AgaaLog* log, AgaaDeviceCaps* outCaps);

/* ---- context ----------------------------------------------------------------------------------- */

/* What becomes of the host's state. docs/state.md lists the states that RESTORE keeps. */
typedef enum AgaaGlStatePolicy {
    /* Every state of the list is read on entry and set again before each draw callback and at return, also
     * when a callback or the frame fails. A program that the host has deleted while it is in use is lost: OpenGL
     * drops it when another is used. */
    AGAA_GL_STATE_RESTORE = 0,
    /* pushState is called on entry and after each draw callback, popState before each draw callback and at
     * return: for hosts that can save and restore more cheaply than by glGet. Where the last popState fails
     * the frame is AGAA_ERROR_CALLBACK, though its output was written. */
    AGAA_GL_STATE_CALLBACKS = 1,
    /* Nothing is saved: the host sets what it needs. */
    AGAA_GL_STATE_NONE = 2,
    AGAA_GL_STATE_MAX_ENUM = 0x7FFFFFFF
} AgaaGlStatePolicy;

/* How the host's fragment shaders reach buffers that they add to. */
typedef enum AgaaGlStorage {
    AGAA_GL_STORAGE_BUFFERS = 0, /* shader storage blocks */
    AGAA_GL_STORAGE_IMAGES = 1,  /* buffer images: for engines that choke on storage blocks */
    AGAA_GL_STORAGE_MAX_ENUM = 0x7FFFFFFF
} AgaaGlStorage;

/* Who declares the fragment shader's outputs. */
typedef enum AgaaGlOutputs {
    AGAA_GL_OUTPUTS_SDK = 0,  /* agaa_out0 … are outputs at locations 0 … */
    AGAA_GL_OUTPUTS_HOST = 1, /* agaa_out0 … are variables that the host copies to its outputs after agaa_emit() */
    AGAA_GL_OUTPUTS_MAX_ENUM = 0x7FFFFFFF
} AgaaGlOutputs;

/* The SDK's resources that the host's fragment shaders reach, and the kind of each binding. */
typedef enum AgaaGlBinding {
    AGAA_GL_BINDING_FRAME = 0,      /* uniform buffer */
    AGAA_GL_BINDING_METADATA = 1,   /* texture unit */
    AGAA_GL_BINDING_AGGREGATES = 2, /* shader storage buffer; image unit with AGAA_GL_STORAGE_IMAGES */
    AGAA_GL_BINDING_COUNTERS = 3,   /* as AGAA_GL_BINDING_AGGREGATES */
    AGAA_GL_BINDING_LIGHTS = 4,     /* shader storage buffer; uniform buffer with AGAA_GL_STORAGE_IMAGES */
    AGAA_GL_BINDING_SHADOW0 = 5,    /* texture units of the shadow maps; SHADOW0 also holds the prepass's normals in
                                       AGAA_DRAW_PASS_AGGREGATE of views without AGAA_VIEW_REVERSED_Z */
    AGAA_GL_BINDING_SHADOW1 = 6,
    AGAA_GL_BINDING_SHADOW2 = 7,
    AGAA_GL_BINDING_SHADOW3 = 8,
    AGAA_GL_BINDING_FRAGMENTS = 9, /* as AGAA_GL_BINDING_AGGREGATES */
    AGAA_GL_BINDING_COUNT = 10,
    AGAA_GL_BINDING_MAX_ENUM = 0x7FFFFFFF
} AgaaGlBinding;
#define AGAA_GL_MAX_BINDINGS 17

/* Must not throw and must not call the SDK. Anything but AGAA_OK makes the frame AGAA_ERROR_CALLBACK. */
typedef AgaaResult(AGAA_CALL* AgaaGlStateCallback)(void* user);

typedef struct AgaaGlContextDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    AgaaGlGetProcAddr getProcAddr;
    void* getProcUser;
    uint32_t glslVersion; /* of the host's fragment shaders: 330 to 460, as in their #version line */
    uint32_t storage;     /* AgaaGlStorage */
    uint32_t outputs;     /* AgaaGlOutputs */
    uint32_t statePolicy; /* AgaaGlStatePolicy */
    AgaaGlStateCallback pushState; /* both with AGAA_GL_STATE_CALLBACKS; otherwise not called, may be null */
    AgaaGlStateCallback popState;
    void* stateUser;
    /* By AgaaGlBinding: where the SDK binds resources of the host's shaders during draw callbacks. Bindings of one kind
     * must differ; elements from AGAA_GL_BINDING_COUNT on must be 0. The host's own bindings are restored after the
     * callback, except with AGAA_GL_STATE_NONE. */
    uint32_t bindings[AGAA_GL_MAX_BINDINGS];
    uint32_t framesInFlight; /* [1;8]: as of AgaaVkContextDesc */
    const AgaaLog* log;      /* may be null; copied */
    AgaaAllocateCallback allocate; /* may be null */
    AgaaFreeCallback free;
    void* allocateUser;
} AgaaGlContextDesc;
#define AGAA_GL_CONTEXT_DESC_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_GL_CONTEXT, (uint32_t)sizeof(AgaaGlContextDesc), NULL, NULL, NULL, 450,       \
     AGAA_GL_STORAGE_BUFFERS, AGAA_GL_OUTPUTS_SDK, AGAA_GL_STATE_RESTORE, NULL, NULL, NULL,            \
     {0, 0, 0, 1, 2, 1, 2, 3, 4, 3, 0, 0, 0, 0, 0, 0, 0}, 2, NULL, NULL, NULL, NULL}

/* headerVersion: pass AGAA_HEADER_VERSION. Probes whether the driver's timer queries are right, which takes
 * some milliseconds. The host's state is left as it was; errors that were pending are told to the log. Not to be
 * called with transform feedback that is not paused, conditional rendering, a query of GL_TIME_ELAPSED or rectangles of
 * GL_EXT_window_rectangles active. */
AGAA_API AgaaResult AGAA_CALL agaaGlCreateContext(uint32_t headerVersion,
                                                  const AgaaGlContextDesc* desc,
                                                  AgaaContext* outContext);

/* Those of the context, with the limits of AgaaGlContextDesc::storage. AGAA_ERROR_INVALID_ARGUMENT for null and
 * for contexts of Vulkan, AGAA_ERROR_STRUCT where outCaps is not initialised. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps);

/* Allocates the view's surfaces and compiles its passes. desc and what it points to are needed until the call
 * returns. The view is the host's to destroy, before its context. AGAA_ERROR_UNSUPPORTED, _TOO_LARGE or _LAYOUT
 * where the device or the library cannot, _OUT_OF_MEMORY or _DEVICE where the driver refuses; what was made is
 * given back, and *outView is not written. The host's state is left as it was; errors that were pending are told
 * to the log. */
AGAA_API AgaaResult AGAA_CALL agaaGlCreateView(AgaaContext context, const AgaaViewDesc* desc,
                                               AgaaView* outView);

/* ---- host draw passes --------------------------------------------------------------------------- */

/* A host fragment shader is: its #version line, extensions, declarations, the host's own code, which fills
 * an AgaaSurfaceInput and calls agaa_emit() once. Compile the same text for each pass; for alpha-masked materials
 * `#define AGAA_ALPHA_MASKED 1` stands before the declarations. */
typedef struct AgaaGlDrawPass {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t pass;  /* AgaaDrawPassId */
    uint32_t stage; /* AgaaStage */
    const char* name;     /* owned by the view */
    uint64_t pipelineKey; /* as AgaaDrawTarget::pipelineKey */
    uint32_t framebuffer; /* the view's; complete, of the format and size below */
    uint32_t width, height;  /* texels of the target: pixels times the scale */
    uint32_t scaleX, scaleY; /* sub-pixels a pixel */
    AgaaDrawState state;
    uint32_t colorFormats[4];    /* internal formats; state.colorAttachmentCount are used */
    uint32_t depthStencilFormat; /* internal format */
    const char* glslExtensions;   /* owned by the view */
    const char* glslDeclarations; /* owned by the view */
    /* Null: the pass needs no geometry shader. Otherwise the host's has this text between glslExtensions and its own
     * code, which calls the functions that the text names. Owned by the view */
    const char* glslGeometry;
} AgaaGlDrawPass;
#define AGAA_GL_DRAW_PASS_INIT                                                                      \
    {AGAA_STRUCTURE_TYPE_GL_DRAW_PASS, (uint32_t)sizeof(AgaaGlDrawPass), NULL, 0, 0, NULL, 0, 0, 0, 0, \
     0, 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, 0, NULL, NULL, NULL}

/* Two-call: with passes null, writes the count; otherwise every element must be initialised, or the call is
 * AGAA_ERROR_STRUCT. AGAA_ERROR_BUFFER_TOO_SMALL where *count is less than there are; AGAA_ERROR_INVALID_ARGUMENT
 * for null and for views of Vulkan. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetDrawPasses(AgaaView view, uint32_t* count,
                                                  AgaaGlDrawPass* passes);

/* A surface of a view, for hosts that use it between segments or copy it. Owned by the view. */
typedef struct AgaaGlSurface {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t texture; /* TEXTURE_2D, or TEXTURE_2D_MULTISAMPLE with samples > 1; or 0 */
    uint32_t buffer;  /* or 0 */
    uint64_t bytes;
    uint32_t format; /* internal format */
    uint32_t width, height, samples; /* texels: scaleX x scaleY a pixel */
    uint32_t scaleX, scaleY;
    uint32_t reserved;
} AgaaGlSurface;
#define AGAA_GL_SURFACE_INIT                                                                        \
    {AGAA_STRUCTURE_TYPE_GL_SURFACE, (uint32_t)sizeof(AgaaGlSurface), NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}

/* name: as in agaaQueryMemory; "depth" is of every view that draws, "aggregates" of those that
 * agaaGetAggregateGlsl is for. Others may change with the version. AGAA_ERROR_INVALID_ARGUMENT for names that the view
 * does not have. */
AGAA_API AgaaResult AGAA_CALL agaaGlGetSurface(AgaaView view, const char* name,
                                               AgaaGlSurface* outSurface);

/* ---- frames ------------------------------------------------------------------------------------- */

typedef struct AgaaGlFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    /* TEXTURE_2D of the view's size, level 0, of a format that image stores take, RGBA16F or RGBA32F by
     * choice. Needed by the shading segment. Row 0 is where the projection puts y = -1. */
    uint32_t outputTexture;
    /* TEXTURE_2D_ARRAY with depth, one per AgaaFrame::shadows that no AgaaShadowFunction answers for. Others
     * are not looked at: a frame without shadows needs none. */
    uint32_t shadowTextures[AGAA_MAX_SHADOW_MAPS];
    uint32_t reserved; /* 0 */
} AgaaGlFrame;
#define AGAA_GL_FRAME_INIT                                                                          \
    {AGAA_STRUCTURE_TYPE_GL_FRAME, (uint32_t)sizeof(AgaaGlFrame), NULL, 0, {0, 0, 0, 0}, 0}

/* Runs the frame's segments in the current context. Draw callbacks find the host's state as it was on
 * entry, but for the bindings named in AgaaGlContextDesc; they bind AgaaDrawTarget::framebuffer and set
 * viewport and AgaaDrawState themselves. A callback that fails is AGAA_ERROR_CALLBACK: the output is
 * untouched, but passes before it have run. A frame is AGAA_ERROR_WRONG_ORDER too early (framesInFlight), with a
 * frameIndex that does not increase, or with segments missing or repeated; with another camera than its earlier
 * segments AGAA_ERROR_OUT_OF_RANGE. Active transform feedback that is not paused is AGAA_ERROR_WRONG_ORDER. Not to be
 * called with conditional rendering, a query of GL_TIME_ELAPSED or rectangles of GL_EXT_window_rectangles active.
 * Other errors of OpenGL's are not looked for: they are left to the host's glGetError. Functions of the host's
 * (AgaaGBufferFunction, AgaaFetchFunction, AgaaShadowFunction) find their resources as bound on entry, or where the
 * host draws, when the last draw callback returns: texture units from 17 and other binding points from 4 are left
 * alone, but for the places named in AgaaGlContextDesc. */
AGAA_API AgaaResult AGAA_CALL agaaGlRecordFrame(AgaaView view, const AgaaFrame* frame,
                                                const AgaaGlFrame* glFrame);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_GL_H */
