/* AGAA SDK on Vulkan. Includes no Vulkan header: dispatchable handles are void*, other handles are uint64_t (cast a
 * VkImage with (uint64_t)), enumerations are uint32_t with Vulkan's values.
 * SPDX-License-Identifier: MIT
 */
#ifndef AGAA_VK_H
#define AGAA_VK_H

#include "agaa_sdk.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*AgaaVkFunction)(void);
/* The type of vkGetInstanceProcAddr. The SDK calls it with the host's instance. */
typedef AgaaVkFunction(AGAA_CALL* AgaaVkGetInstanceProcAddr)(void* instance, const char* name);

/* ---- before a device exists ------------------------------------------------------------------ */

/* Lists the version and the features that a device must have, and features and extensions that improve the SDK.
 * Names have static storage. */
typedef struct AgaaVkRequirements {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;   /* null */
    uint32_t apiVersion; /* VK_API_VERSION_1_2 */
    uint32_t requiredFeatureCount;
    const char* const* requiredFeatures; /* members of VkPhysicalDeviceFeatures */
    uint32_t optionalFeatureCount;
    uint32_t optionalDeviceExtensionCount;
    const char* const* optionalFeatures;         /* members of the feature structs of Vulkan 1.3 or of the extensions */
    const char* const* optionalDeviceExtensions; /* enable those that the device has */
} AgaaVkRequirements;
#define AGAA_VK_REQUIREMENTS_INIT                                                                                      \
    { AGAA_STRUCTURE_TYPE_VK_REQUIREMENTS, (uint32_t)sizeof(AgaaVkRequirements), NULL, 0, 0, NULL, 0, 0, NULL, NULL }
AGAA_API void AGAA_CALL agaaInitVkRequirements(AgaaVkRequirements* outRequirements, size_t structSize);

/* Gets the requirements on a device.
 *
 * outRequirements   Initialised; unchanged on failure.
 *
 * Errors            AGAA_ERROR_INVALID_ARGUMENT   outRequirements is null
 *                   AGAA_ERROR_STRUCT             outRequirements is not initialised
 * Threads           Any. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetRequirements(AgaaVkRequirements* outRequirements);

/* Gets the capabilities of a physical device, for the queries of agaa_sdk.h.
 *
 * instance         VkInstance.
 * physicalDevice   VkPhysicalDevice.
 * log              May be null.
 * outCaps          Initialised; unchanged on failure.
 *
 * Errors           AGAA_ERROR_INVALID_ARGUMENT   a pointer is null
 *                  AGAA_ERROR_STRUCT             outCaps is not initialised
 *                  AGAA_ERROR_UNSUPPORTED        a function of Vulkan 1.2 is missing
 *                  AGAA_ERROR_OUT_OF_MEMORY, AGAA_ERROR_DEVICE   a Vulkan function failed
 * Threads          Any. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetDeviceCaps(void* instance, void* physicalDevice,
                                                  AgaaVkGetInstanceProcAddr getProcAddr, const AgaaLog* log,
                                                  AgaaDeviceCaps* outCaps);

/* ---- context --------------------------------------------------------------------------------- */

typedef enum AgaaVkRendering {
    AGAA_VK_RENDERING_AUTO = 0,        /* dynamic rendering if the device was created with it */
    AGAA_VK_RENDERING_DYNAMIC = 1,     /* VK_KHR_dynamic_rendering or Vulkan 1.3 */
    AGAA_VK_RENDERING_RENDER_PASS = 2, /* VkRenderPass */
    AGAA_VK_RENDERING_MAX_ENUM = 0x7FFFFFFF
} AgaaVkRendering;

typedef enum AgaaVkRecording {
    /* Draw callbacks receive a secondary command buffer of the SDK. If a callback fails, the host's command buffer is
     * unchanged. No query may be active in the host's command buffer. */
    AGAA_VK_RECORDING_SECONDARY = 0,
    /* Draw callbacks receive the host's command buffer. If a callback fails, the frame fails with
     * AGAA_ERROR_PARTIAL. */
    AGAA_VK_RECORDING_INLINE = 1,
    AGAA_VK_RECORDING_MAX_ENUM = 0x7FFFFFFF
} AgaaVkRecording;

/* Describes the host's device. Chain it to AgaaContextDesc. */
typedef struct AgaaVkDeviceDesc {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    void* instance;       /* VkInstance */
    void* physicalDevice; /* VkPhysicalDevice */
    void* device;         /* VkDevice, with the features and extensions of AgaaVkRequirements; outlives the context */
    AgaaVkGetInstanceProcAddr getProcAddr;
    uint32_t queueFamily; /* queue family of the command buffers; it must support graphics and compute */
    uint32_t apiVersion;  /* version for which the instance and the device were created, >= VK_API_VERSION_1_2 */
    uint32_t rendering;   /* AgaaVkRendering */
    uint32_t recording;   /* AgaaVkRecording */
    const char* const* enabledExtensions; /* device extensions that the host enabled */
    uint32_t enabledExtensionCount;
    uint32_t descriptorSet; /* index of the SDK's descriptor set in the host's pipeline layouts, [0, 7] */
    /* VkPhysicalDeviceFeatures2 with the chain that was passed to vkCreateDevice. Null: the host enabled every
     * feature of AgaaVkRequirements that the device has; conditionalRendering, computeFullSubgroups and
     * rasterizationOrderColorAttachmentAccess are then not used. */
    const void* enabledFeatures;
    /* VkPipelineCache that outlives the context. With 0, the SDK uses an empty cache of its own. The cache must not
     * have VK_PIPELINE_CACHE_CREATE_EXTERNALLY_SYNCHRONIZED_BIT if agaaPrepareVariants runs concurrently with other
     * calls. */
    uint64_t pipelineCache;
} AgaaVkDeviceDesc;
#define AGAA_VK_DEVICE_DESC_INIT                                                                                       \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_VK_DEVICE_DESC, (uint32_t)sizeof(AgaaVkDeviceDesc), NULL, NULL, NULL, NULL, NULL, 0, 0,    \
            AGAA_VK_RENDERING_AUTO, AGAA_VK_RECORDING_SECONDARY, NULL, 0, 0, NULL, 0                                   \
    }
AGAA_API void AGAA_CALL agaaInitVkDeviceDesc(AgaaVkDeviceDesc* outDesc, size_t structSize);

/* A request for device memory. */
typedef struct AgaaVkAllocationInfo {
    uint64_t size;           /* bytes */
    uint64_t alignment;      /* bytes, a power of two */
    uint32_t memoryTypeBits; /* bit i: memory type i is allowed */
    uint32_t requiredFlags;  /* VkMemoryPropertyFlags; with HOST_VISIBLE the SDK needs AgaaVkMemory::mapped */
    uint32_t preferredFlags; /* VkMemoryPropertyFlags */
    uint32_t isImage;        /* 1: the memory holds images with optimal tiling, 0: it holds buffers or both */
    const char* name;        /* name for debugging; valid during the callback only */
    uint64_t reserved[4];    /* 0 */
} AgaaVkAllocationInfo;

typedef struct AgaaVkMemory {
    uint64_t memory;      /* VkDeviceMemory */
    uint64_t offset;      /* bytes, a multiple of the alignment */
    void* mapped;         /* address of the first byte if HOST_VISIBLE was required; stays mapped. Otherwise it may
                             be null */
    void* allocation;     /* any value of the host */
    uint64_t reserved[2]; /* 0; the SDK clears the struct before it calls the host */
} AgaaVkMemory;

/* Allocates device memory. The SDK binds its images and buffers to the memory.
 *
 * Returns   AGAA_OK, or any other value: the SDK's call then fails with AGAA_ERROR_OUT_OF_MEMORY.
 * Threads   The thread that called the SDK. The callback must not call the SDK and must not throw. */
typedef AgaaResult(AGAA_CALL* AgaaVkAllocateCallback)(void* user, const AgaaVkAllocationInfo* info,
                                                      AgaaVkMemory* outMemory);
/* Frees memory that AgaaVkAllocateCallback returned. */
typedef void(AGAA_CALL* AgaaVkFreeCallback)(void* user, const AgaaVkMemory* memory);

/* Device memory from the host's allocator. Chain it to AgaaContextDesc; without it, the SDK calls vkAllocateMemory. */
typedef struct AgaaVkAllocator {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    AgaaVkAllocateCallback allocate;
    AgaaVkFreeCallback free;
    void* user;
} AgaaVkAllocator;
#define AGAA_VK_ALLOCATOR_INIT                                                                                         \
    { AGAA_STRUCTURE_TYPE_VK_ALLOCATOR, (uint32_t)sizeof(AgaaVkAllocator), NULL, NULL, NULL, NULL }
AGAA_API void AGAA_CALL agaaInitVkAllocator(AgaaVkAllocator* outAllocator, size_t structSize);

/* Creates a context.
 *
 * headerVersion   AGAA_HEADER_VERSION.
 * desc            Must chain an AgaaVkDeviceDesc.
 * outContext      Receives the context; unchanged on failure. Destroy it with agaaDestroyContext.
 *
 * Errors          AGAA_ERROR_VERSION            header and library have different major or minor versions
 *                 AGAA_ERROR_INVALID_ARGUMENT   no device is chained, a handle, getProcAddr or a callback of
 *                                               AgaaVkAllocator is null, enabledExtensions is null although there
 *                                               are some, only one of AgaaContextDesc::allocate and free is set, or
 *                                               enabledFeatures is not a VkPhysicalDeviceFeatures2
 *                 AGAA_ERROR_OUT_OF_RANGE       a member is out of its range or exceeds a limit of the device
 *                 AGAA_ERROR_UNSUPPORTED        the device or apiVersion is below Vulkan 1.2, a function is missing,
 *                                               the queue family lacks graphics or compute, a feature
 *                                               shaderStorageImage… of AgaaVkRequirements is not enabled, or dynamic
 *                                               rendering was requested and is not enabled
 *                 AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated
 *                 AGAA_ERROR_DEVICE             a Vulkan function failed
 * Threads         Any. */
AGAA_API AgaaResult AGAA_CALL agaaVkCreateContext(uint32_t headerVersion, const AgaaContextDesc* desc,
                                                  AgaaContext* outContext);

/* Gets the capabilities of the device with the extensions and features that the host enabled.
 *
 * outCaps   Initialised; unchanged on failure.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, or the context is an OpenGL context
 *           AGAA_ERROR_STRUCT             outCaps is not initialised
 * Threads   One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaVkGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps);

/* Creates a view: the surfaces and pipelines for one camera at one size.
 *
 * desc      Read during the call only, with all that it points to.
 * outView   Receives the view; unchanged on failure. Destroy it with agaaDestroyView, before its context.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer is null, the context is an OpenGL context, functions of the host
 *                                         exclude each other, or a text of theirs is not valid or does not compile
 *           AGAA_ERROR_STRUCT             a struct is not initialised
 *           AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, a struct twice, or does not end
 *           AGAA_ERROR_OUT_OF_RANGE       a member is out of its range, or has an unknown flag or value
 *           AGAA_ERROR_LAYOUT             the layout is not valid or cannot be packed
 *           AGAA_ERROR_UNSUPPORTED        no technique has this name, or the device or the library cannot do what
 *                                         was asked
 *           AGAA_ERROR_TOO_LARGE          a surface exceeds a limit of the device or of 64-bit arithmetic
 *           AGAA_ERROR_OUT_OF_MEMORY      host or device memory could not be allocated, or AgaaVkAllocator failed
 *           AGAA_ERROR_CALLBACK           AgaaVkAllocator returned no memory, memory that is not aligned or not
 *                                         mapped, or a reserved member that is not 0
 *           AGAA_ERROR_DEVICE             a Vulkan function failed
 * Threads   One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaVkCreateView(AgaaContext context, const AgaaViewDesc* desc, AgaaView* outView);

/* ---- draw passes and surfaces ----------------------------------------------------------------- */

/* Formats and objects for the pipelines of a draw pass on Vulkan. Chain it to AgaaDrawPass. */
typedef struct AgaaVkDrawPass {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    uint32_t colorFormats[8];    /* VkFormat of the first AgaaDrawState::colorAttachmentCount attachments */
    uint32_t depthStencilFormat; /* VkFormat; UNDEFINED without a depth attachment */
    uint32_t reserved;
    uint64_t renderPass;          /* VkRenderPass of the view, subpass 0. It is 0 with dynamic rendering, except for
                                     a pass with AgaaDrawState::readsAttachments */
    uint64_t descriptorSetLayout; /* VkDescriptorSetLayout of the SDK's set, owned by the view */
} AgaaVkDrawPass;
#define AGAA_VK_DRAW_PASS_INIT                                                                                         \
    { AGAA_STRUCTURE_TYPE_VK_DRAW_PASS, (uint32_t)sizeof(AgaaVkDrawPass), NULL, {0, 0, 0, 0, 0, 0, 0, 0}, 0, 0, 0, 0 }
AGAA_API void AGAA_CALL agaaInitVkDrawPass(AgaaVkDrawPass* outPass, size_t structSize);

/* The handles of a surface on Vulkan. Chain it to AgaaSurface in agaaGetSurface. */
typedef struct AgaaVkSurface {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    uint64_t image;  /* VkImage; 0 for buffers */
    uint64_t view;   /* VkImageView: 2D, or a 2D array of all layers; the depth aspect of depth formats */
    uint64_t buffer; /* VkBuffer; 0 for images */
    uint32_t format; /* VkFormat */
    /* VkImageLayout after the commands of segment 1 << i; UNDEFINED if the contents are lost. A host that uses the
     * image leaves it in this layout, with a barrier whose second scope is ALL_COMMANDS and MEMORY_READ |
     * MEMORY_WRITE, before the commands of the next segment. Where draws have AgaaDrawState::sampleLocations, a host
     * reads the depth in this layout and does not change it. */
    uint32_t layouts[3];
} AgaaVkSurface;
#define AGAA_VK_SURFACE_INIT                                                                                           \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_VK_SURFACE, (uint32_t)sizeof(AgaaVkSurface), NULL, 0, 0, 0, 0, { 0, 0, 0 }                 \
    }
AGAA_API void AGAA_CALL agaaInitVkSurface(AgaaVkSurface* outSurface, size_t structSize);

/* ---- recording --------------------------------------------------------------------------------- */

typedef struct AgaaVkFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;   /* null, or an AgaaVkResolvedImages */
    void* commandBuffer; /* primary, recording, outside rendering and conditional rendering */
    /* The output: a 2D image with one layer and the size of the view, or one that holds the frame at
     * AgaaFrame::outputX and outputY if the frame names its width, with usage STORAGE (and SAMPLED with
     * AGAA_VIEW_COMPOSITE), in a float format whose storage view can be written without a format. The shading
     * segment needs it. */
    uint64_t outputImage;
    uint64_t outputView;
    uint32_t outputLayoutIn;  /* VkImageLayout; UNDEFINED discards the contents */
    uint32_t outputLayoutOut; /* VkImageLayout that the SDK leaves, visible to all later commands; not UNDEFINED and not
                                 PREINITIALIZED */
    /* One view of a depth array per AgaaFrame::shadows that no AgaaShadowFunction answers for, in
     * SHADER_READ_ONLY_OPTIMAL, readable by compute shaders and with "msaa" by fragment shaders. If the view
     * declares shadow maps and the frame has none, the first element is needed all the same, because descriptors
     * cannot be empty. Other elements are not read. */
    uint64_t shadowViews[AGAA_MAX_SHADOW_MAPS];
    uint64_t functionSet; /* VkDescriptorSet for the functions of the host (agaa/functions.h), or 0 */
} AgaaVkFrame;
#define AGAA_VK_FRAME_INIT                                                                                             \
    { AGAA_STRUCTURE_TYPE_VK_FRAME, (uint32_t)sizeof(AgaaVkFrame), NULL, NULL, 0, 0, 0, 1, {0, 0, 0, 0}, 0 }
AGAA_API void AGAA_CALL agaaInitVkFrame(AgaaVkFrame* outFrame, size_t structSize);

/* Images for AgaaResolvedOutputs. Chain it to AgaaVkFrame. The shading segment of such a view needs it. Each image is
 * as AgaaVkFrame::outputImage, with its size or larger, in a float or normalised format whose storage view can be
 * written without a format. R32_SFLOAT keeps depths. Elements beyond the number of outputs are not read. The SDK checks
 * what the host says of the images: a frame that ends outside them fails with AGAA_ERROR_OUT_OF_RANGE, and a format of
 * integers, of depth or of compressed blocks with AGAA_ERROR_UNSUPPORTED. */
typedef struct AgaaVkResolvedImages {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint64_t images[AGAA_MAX_RESOLVED_OUTPUTS];     /* VkImage; all are different */
    uint64_t views[AGAA_MAX_RESOLVED_OUTPUTS];      /* VkImageView */
    uint32_t layoutsIn[AGAA_MAX_RESOLVED_OUTPUTS];  /* VkImageLayout; the contents are lost except around the frame */
    uint32_t layoutsOut[AGAA_MAX_RESOLVED_OUTPUTS]; /* VkImageLayout that the SDK leaves, visible to all later commands;
                                                       not UNDEFINED and not PREINITIALIZED */
    uint32_t width, height;                         /* of all images in texels; 0: not said */
    uint32_t formats[AGAA_MAX_RESOLVED_OUTPUTS];    /* VkFormat; 0: not said */
} AgaaVkResolvedImages;
#define AGAA_VK_RESOLVED_IMAGES_INIT                                                                                   \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_VK_RESOLVED_IMAGES, (uint32_t)sizeof(AgaaVkResolvedImages), NULL, {0, 0, 0, 0, 0, 0},      \
            {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {1, 1, 1, 1, 1, 1}, 0, 0, {                                        \
            0, 0, 0, 0, 0, 0                                                                                           \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitVkResolvedImages(AgaaVkResolvedImages* outImages, size_t structSize);

/* Records the segments of a frame into the host's command buffer. Afterwards the bound pipelines, descriptor sets
 * and dynamic state of the command buffer are undefined.
 *
 * Errors    AGAA_ERROR_INVALID_ARGUMENT   a pointer or a handle that the frame needs is null, or the view is an
 *                                         OpenGL view
 *           AGAA_ERROR_STRUCT             a struct is not initialised
 *           AGAA_ERROR_OUT_OF_RANGE       a member is out of its range, or the camera, ditherFrame, the size or the
 *                                         facts differ from those of the first segment
 *           AGAA_ERROR_WRONG_ORDER        framesInFlight frames are unfinished, the frame index does not increase,
 *                                         or a segment is missing or repeated
 *           AGAA_ERROR_CALLBACK           AGAA_VK_RECORDING_SECONDARY: a draw callback failed; nothing is recorded
 *           AGAA_ERROR_PARTIAL            AGAA_VK_RECORDING_INLINE: a draw callback failed; or another failure after
 *                                         the first command. Discard the command buffer
 *           AGAA_ERROR_OUT_OF_MEMORY, AGAA_ERROR_DEVICE   a Vulkan function failed before the first command
 * Threads   One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaVkRecordFrame(AgaaView view, const AgaaFrame* frame, const AgaaVkFrame* vkFrame);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_VK_H */
