/* AGAA SDK on Vulkan. Includes no Vulkan header: dispatchable handles are void*, others uint64_t
 * (cast a VkImage with (uint64_t)), enums uint32_t with Vulkan's own values.
 * SPDX-License-Identifier: MIT
 */
#ifndef AGAA_VK_H
#define AGAA_VK_H

#include "agaa_sdk.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*AgaaVkFunction)(void);
/* As vkGetInstanceProcAddr, called with the host's instance. */
typedef AgaaVkFunction(AGAA_CALL* AgaaVkGetInstanceProcAddr)(void* instance, const char* name);

/* ---- before a device exists ------------------------------------------------------------------ */

/* What a device must and should offer. Names have static storage. */
typedef struct AgaaVkRequirements {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t apiVersion; /* VK_API_VERSION_1_2 */
    uint32_t reserved;
    uint32_t requiredFeatureCount;
    const char* const* requiredFeatures; /* members of VkPhysicalDeviceFeatures */
    uint32_t optionalFeatureCount;
    const char* const* optionalFeatures; /* of Vulkan 1.3's or the extension's struct */
    uint32_t optionalDeviceExtensionCount; /* enable those the device has */
    const char* const* optionalDeviceExtensions;
} AgaaVkRequirements;
#define AGAA_VK_REQUIREMENTS_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_REQUIREMENTS, (uint32_t)sizeof(AgaaVkRequirements), NULL, 0, 0, 0, NULL, 0, \
     NULL, 0, NULL}
AGAA_API AgaaResult AGAA_CALL agaaVkGetRequirements(AgaaVkRequirements* outRequirements);

/* Capabilities of a physical device, to be passed to the queries of agaa_sdk.h. log may be null.
 * agaaVkGetContextCaps gives those that are left of it in a context. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetDeviceCaps(void* instance, void* physicalDevice,
                                                  AgaaVkGetInstanceProcAddr getProcAddr,
                                                  const AgaaLog* log, AgaaDeviceCaps* outCaps);

/* ---- context --------------------------------------------------------------------------------- */

typedef enum AgaaVkRendering {
    AGAA_VK_RENDERING_AUTO = 0, /* dynamic where the device was created with it */
    AGAA_VK_RENDERING_DYNAMIC = 1,
    AGAA_VK_RENDERING_RENDER_PASS = 2,
    AGAA_VK_RENDERING_MAX_ENUM = 0x7FFFFFFF
} AgaaVkRendering;

typedef enum AgaaVkRecording {
    /* Draw callbacks get a secondary command buffer of the SDK's: a callback that fails leaves the
     * host's command buffer untouched. No query may be active in that. */
    AGAA_VK_RECORDING_SECONDARY = 0,
    /* Draw callbacks get the host's command buffer: a callback that fails is AGAA_ERROR_PARTIAL. */
    AGAA_VK_RECORDING_INLINE = 1,
    AGAA_VK_RECORDING_MAX_ENUM = 0x7FFFFFFF
} AgaaVkRecording;

typedef struct AgaaVkContextDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    void* instance;       /* VkInstance */
    void* physicalDevice; /* VkPhysicalDevice */
    void* device;         /* VkDevice; features and extensions as in AgaaVkRequirements */
    uint32_t queueFamily; /* of the command buffers; graphics and compute */
    uint32_t apiVersion;  /* that the instance and device were created for, VK_API_VERSION_1_2 or later */
    AgaaVkGetInstanceProcAddr getProcAddr;
    const char* const* enabledExtensions; /* device extensions enabled by the host */
    uint32_t enabledExtensionCount;
    uint32_t reserved2; /* 0 */
    /* VkPhysicalDeviceFeatures2 with the chain given to vkCreateDevice; null: every feature of
     * AgaaVkRequirements that the device has was enabled. */
    const void* enabledFeatures;
    uint32_t rendering;      /* AgaaVkRendering */
    uint32_t recording;      /* AgaaVkRecording */
    uint32_t descriptorSet;  /* index of the SDK's set in the host's pipeline layouts, [0;7] */
    uint64_t pipelineCache;  /* VkPipelineCache that outlives the context, or 0: one of its own, empty at first */
    /* [1;8]: frames that may be unfinished at once, and whose statistics are kept. A frame needs the one this many
     * before it to be no later than AgaaFrame::completedFrame, or it is AGAA_ERROR_WRONG_ORDER. */
    uint32_t framesInFlight;
    uint32_t reserved;       /* 0 */
    const AgaaLog* log;      /* may be null; copied */
    AgaaAllocateCallback allocate; /* may be null */
    AgaaFreeCallback free;
    void* allocateUser;
} AgaaVkContextDesc;
#define AGAA_VK_CONTEXT_DESC_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_VK_CONTEXT, (uint32_t)sizeof(AgaaVkContextDesc), NULL, NULL, NULL, NULL, 0, \
     0, NULL, NULL, 0, 0, NULL, AGAA_VK_RENDERING_AUTO, AGAA_VK_RECORDING_SECONDARY, 0, 0, 2, 0,     \
     NULL, NULL, NULL, NULL}

/* headerVersion: pass AGAA_HEADER_VERSION. The host's device must outlive the context. */
AGAA_API AgaaResult AGAA_CALL agaaVkCreateContext(uint32_t headerVersion,
                                                  const AgaaVkContextDesc* desc,
                                                  AgaaContext* outContext);

/* What the device can do with the extensions and features that the host enabled. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps);

/* Allocates the view's surfaces and compiles its passes. desc and what it points to are needed until the call
 * returns. The view is the host's to destroy, before its context. AGAA_ERROR_UNSUPPORTED, _TOO_LARGE or _LAYOUT where
 * the device or the library cannot (AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE is for OpenGL), _OUT_OF_MEMORY or _DEVICE where the
 * driver refuses; what was made is given back, and *outView is not written. */
AGAA_API AgaaResult AGAA_CALL agaaVkCreateView(AgaaContext context, const AgaaViewDesc* desc,
                                               AgaaView* outView);

/* ---- host draw passes, known before anything is recorded -------------------------------------- */

/* A host fragment shader is: #version 450, extensions, declarations, the host's own code, which fills an
 * AgaaSurfaceInput and calls agaa_emit() once. Compile the same text for each pass; for alpha-masked materials
 * `#define AGAA_ALPHA_MASKED 1` stands before the declarations. */
typedef struct AgaaVkDrawPass {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t pass; /* AgaaDrawPassId */
    uint32_t stage; /* AgaaStage */
    const char* name;     /* owned by the view */
    uint64_t pipelineKey; /* as AgaaDrawTarget::pipelineKey */
    uint32_t width, height;  /* texels of the target: pixels times the scale */
    uint32_t scaleX, scaleY; /* sub-pixels a pixel */
    AgaaDrawState state;
    uint32_t colorFormats[4];    /* VkFormat; state.colorAttachmentCount are used */
    uint32_t depthStencilFormat; /* VkFormat */
    uint32_t reserved;
    uint64_t renderPass;          /* VkRenderPass, subpass 0, the view's; 0 with dynamic rendering */
    uint64_t descriptorSetLayout; /* VkDescriptorSetLayout of the SDK's set, the view's */
    const char* glslExtensions;   /* owned by the view */
    const char* glslDeclarations; /* owned by the view */
    /* Null: the pass needs no geometry shader. Otherwise the host's has this text between glslExtensions and its own
     * code, which calls the functions that the text names. Owned by the view */
    const char* glslGeometry;
} AgaaVkDrawPass;
#define AGAA_VK_DRAW_PASS_INIT                                                                      \
    {AGAA_STRUCTURE_TYPE_VK_DRAW_PASS, (uint32_t)sizeof(AgaaVkDrawPass), NULL, 0, 0, NULL, 0, 0, 0,  \
     0, 0, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, 0, 0, 0, 0, NULL, NULL, NULL}

/* Two-call: with passes null, writes the count; otherwise every element must be initialised, or the call is
 * AGAA_ERROR_STRUCT. AGAA_ERROR_BUFFER_TOO_SMALL where *count is less than there are; AGAA_ERROR_INVALID_ARGUMENT
 * for null and for views of OpenGL. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetDrawPasses(AgaaView view, uint32_t* count,
                                                  AgaaVkDrawPass* passes);

/* A surface of a view, for hosts that use it between segments (depth for their own occlusion, say) or copy
 * it (AGAA_CONFIG_READBACK). Owned by the view. */
typedef struct AgaaVkSurface {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t image;  /* VkImage, or 0 */
    uint64_t view;   /* VkImageView: 2D; the depth aspect only of depth formats */
    uint64_t buffer; /* VkBuffer, or 0 */
    uint64_t bytes;
    uint32_t format; /* VkFormat */
    uint32_t width, height, samples; /* texels: scaleX x scaleY a pixel */
    uint32_t scaleX, scaleY;
    /* VkImageLayout after the commands of segment 1 << i; UNDEFINED where the contents are not kept. A host
     * that uses it then leaves it in that layout, by a barrier whose second scope is ALL_COMMANDS and
     * MEMORY_READ | MEMORY_WRITE, before the commands of the next segment. */
    uint32_t layouts[3];
    uint32_t reserved;
} AgaaVkSurface;
#define AGAA_VK_SURFACE_INIT                                                                        \
    {AGAA_STRUCTURE_TYPE_VK_SURFACE, (uint32_t)sizeof(AgaaVkSurface), NULL, 0, 0, 0, 0, 0, 0, 0, 0,  \
     0, 0, {0, 0, 0}, 0}

/* name: as in agaaQueryMemory; "depth" is of every view that draws, "aggregates" of those that
 * agaaGetAggregateGlsl is for. Others may change with the version. AGAA_ERROR_INVALID_ARGUMENT for names that the view
 * does not have. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetSurface(AgaaView view, const char* name,
                                               AgaaVkSurface* outSurface);

/* ---- recording --------------------------------------------------------------------------------- */

typedef struct AgaaVkFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    void* commandBuffer; /* primary, recording, outside rendering */
    /* Output: 2D, one layer, of the view's size, usage STORAGE (and SAMPLED with AGAA_VIEW_COMPOSITE), a
     * float format whose storage view can be written without a format. Needed by the shading segment. */
    uint64_t outputImage;
    uint64_t outputView;
    uint32_t outputLayoutIn;  /* VkImageLayout; UNDEFINED: contents are not kept */
    uint32_t outputLayoutOut; /* VkImageLayout the SDK leaves it in, visible to all later commands */
    /* Depth array views in SHADER_READ_ONLY_OPTIMAL, readable by compute and with "msaa" by fragment shaders, one per
     * AgaaFrame::shadows that no AgaaShadowFunction answers for. Where the view declares such maps and the frame has
     * none, the first of them all the same: descriptors cannot be empty. Others are not looked at. */
    uint64_t shadowViews[AGAA_MAX_SHADOW_MAPS];
    uint64_t functionSet; /* VkDescriptorSet of the set layout of an AgaaGBufferFunction, AgaaFetchFunction or
                             AgaaShadowFunction, or 0 */
} AgaaVkFrame;
#define AGAA_VK_FRAME_INIT                                                                          \
    {AGAA_STRUCTURE_TYPE_VK_FRAME, (uint32_t)sizeof(AgaaVkFrame), NULL, NULL, 0, 0, 0, 1, {0, 0, 0, 0}, 0}

/* Records the frame's segments. Pipeline, descriptor, viewport and dynamic state of the command buffer
 * is undefined afterwards. A draw callback that fails: with SECONDARY recording AGAA_ERROR_CALLBACK, nothing is
 * recorded; with INLINE recording AGAA_ERROR_PARTIAL, the command buffer is to be discarded. Any other failure after
 * the first command, such as the end of host memory, is AGAA_ERROR_PARTIAL too. A frame is AGAA_ERROR_WRONG_ORDER
 * too early (framesInFlight), with a frameIndex that does not increase, or with segments missing or repeated; with
 * another camera than its earlier segments AGAA_ERROR_OUT_OF_RANGE. */
AGAA_API AgaaResult AGAA_CALL agaaVkRecordFrame(AgaaView view, const AgaaFrame* frame,
                                                const AgaaVkFrame* vkFrame);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_VK_H */
