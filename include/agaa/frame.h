/* Draw passes and frames. Part of agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_FRAME_H
#define AGAA_FRAME_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- host draw passes ----------------------------------------------------------------------- */

typedef enum AgaaDrawPassId {
    AGAA_DRAW_PASS_VISIBILITY = 1, /* depth alone, or with geometric normals or, with the tier IDS, ids */
    AGAA_DRAW_PASS_AGGREGATE = 2,  /* materials, added to aggregates or kept as surfaces; no colour output, except
                                      with the tier NV_MIXED_SAMPLES, which adds to colour attachments */
    AGAA_DRAW_PASS_GBUFFER = 3,    /* materials into a multisampled G-buffer */
    AGAA_DRAW_PASS_FORWARD = 4,    /* materials, shaded in the fragment shader, into a multisampled colour target */
    AGAA_DRAW_PASS_FRAGMENTS = 5,  /* coverage and ids of all fragments, appended to lists; neither depth nor colour.
                                      Requires a geometry shader (AgaaDrawPass::glslGeometry) or, with
                                      AGAA_VIEW_VERTEX_PULLING, a vertex shader that expands triangles
                                      (AgaaDrawPass::glslVertex) */
    AGAA_DRAW_PASS_MAX_ENUM = 0x7FFFFFFF
} AgaaDrawPassId;

typedef enum AgaaStage {
    AGAA_STAGE_PREPASS = 0,
    AGAA_STAGE_DEFINITION = 1,
    AGAA_STAGE_GENERATION = 2,
    AGAA_STAGE_SHADING = 3,
    AGAA_STAGE_OTHER = 4,
    AGAA_STAGE_MAX_ENUM = 0x7FFFFFFF
} AgaaStage;

typedef enum AgaaCompare {
    AGAA_COMPARE_LESS = 0,
    AGAA_COMPARE_GREATER = 1,
    AGAA_COMPARE_EQUAL = 2,
    AGAA_COMPARE_ALWAYS = 3,
    AGAA_COMPARE_MAX_ENUM = 0x7FFFFFFF
} AgaaCompare;

/* Fixed-function state that the host's pipelines must have in a draw pass. The depth test is on, the viewport's
 * depth range is [0, 1], and the viewport and the scissor are those of the target. The host chooses the cull mode,
 * which must be the same in all draw passes of a frame. All other state that changes fragments must be off: blending
 * except keepFirst and additive, dithering, logic operations, alpha-to-coverage, sample masks, depth bias, depth
 * clamping and sRGB conversion. */
typedef struct AgaaDrawState {
    uint32_t depthCompare;      /* AgaaCompare */
    uint32_t depthWrite;        /* 1: write depth */
    uint32_t stencilTest;       /* 1: pass if the stencil equals 0 (mask 0xFF), then increment and clamp */
    uint32_t stencilTestMasked; /* stencilTest for alpha-masked materials */
    uint32_t colorAttachmentCount;
    uint32_t colorWriteMask; /* the bits 1, 2, 4, 8 for red, green, blue, alpha; the same for all attachments */
    uint32_t samples;        /* samples per texel of the target */
    uint32_t sampleShading;  /* 1: one invocation per sample (minSampleShading 1) */
    uint32_t keepFirst;      /* 1: blend colour and alpha of all attachments with the source factor ONE_MINUS_DST_ALPHA,
                                the destination factor ONE and the operation ADD; a sample keeps its first fragment */
    uint32_t conservative;   /* 1: overestimating conservative rasterisation, which gives a fragment to each pixel
                                that a triangle touches (VK_EXT_conservative_rasterization,
                                GL_NV_conservative_raster) */
    uint32_t vertexPulling;  /* 1: the pipeline has no geometry shader. Its vertex shader has
                                AgaaDrawPass::glslVertex, fetches the vertices of each triangle from buffers, and
                                draws the triangle as a strip of 8 vertices */
    uint32_t readsAttachments; /* 1: the fragment shader reads the colour attachments, in the order of the draws. On
                                  Vulkan the pipeline is for AgaaVkDrawPass::renderPass, and its colour blend state
                                  has the flag RASTERIZATION_ORDER_ATTACHMENT_ACCESS
                                  (VK_EXT_rasterization_order_attachment_access) */
    uint32_t additive;         /* 1: blend colour and alpha of all attachments with the factors ONE and ONE and the
                                  operation ADD */
    uint32_t colorSamples;     /* samples per texel of the colour attachments if they have fewer than `samples`, which
                                  depth and rasterisation have then; 0: both have `samples`. Sample shading, and on
                                  OpenGL GL_RASTER_MULTISAMPLE_EXT, must be off, and colours must not be modulated by
                                  coverage. On Vulkan the pipeline has VkPipelineCoverageReductionStateCreateInfoNV
                                  with TRUNCATE and, without a render pass, VkAttachmentSampleCountInfoNV
                                  (docs/integration/vulkan-pipelines.md) */
    uint32_t multicast;        /* 0: triangles are drawn in one viewport at a time. Otherwise the pipeline has this many
                                  viewports and scissors, and its vertex shader has AgaaDrawPass::glslVertex and calls
                                  agaa_multicast(), which sends each triangle to all of them */
    uint32_t sampleLocations;  /* 1: Vulkan pipelines have VkPipelineSampleLocationsStateCreateInfoEXT with
                                  sampleLocationsEnable and VK_DYNAMIC_STATE_SAMPLE_LOCATIONS_EXT; the SDK sets the
                                  locations before it calls the draw callback. On OpenGL the framebuffer has them */
} AgaaDrawState;

/* A viewport of a draw pass, in texels from the target's corner at (0, 0), with its scissor. Its depth range is
 * [0, 1]. */
typedef struct AgaaViewport {
    float x, y, width, height; /* x and y may be below 0 and have fractions. Hosts that flip y on Vulkan set
                                  y + height and -height */
    uint32_t scissorX, scissorY, scissorWidth, scissorHeight; /* texels. If there are several viewports, the scissor
                                                                 test must be on; a single one has its whole target */
} AgaaViewport;

/* Describes a draw pass of a view before anything is recorded. Chain an AgaaVkDrawPass or an AgaaGlDrawPass to
 * receive the formats and objects of the graphics API.
 *
 * A host fragment shader consists of a #version line (450 on Vulkan), glslExtensions, glslDeclarations and the
 * host's own code, which fills an AgaaSurfaceInput and calls agaa_emit() once. The host compiles the same code for
 * each pass. For alpha-masked materials, `#define AGAA_ALPHA_MASKED 1` stands before glslDeclarations.
 * docs/shader-interface.md describes the functions. */
typedef struct AgaaDrawPass {
    uint32_t sType;
    uint32_t structSize;
    void* pNext;
    uint32_t pass;           /* AgaaDrawPassId */
    uint32_t stage;          /* AgaaStage */
    const char* name;        /* owned by the view */
    uint64_t pipelineKey;    /* differs between passes that need different shaders or pipelines */
    uint32_t width, height;  /* texels of the target: pixels of the view times the scale, and the height times the
                                layers of the tiers LAYERS and NV_MULTICAST. Frames may draw fewer */
    uint32_t scaleX, scaleY; /* texels per pixel */
    AgaaDrawState state;
    const char* glslExtensions;   /* owned by the view */
    const char* glslDeclarations; /* owned by the view */
    /* Null if the pass needs no geometry shader. Otherwise the host's geometry shader has this text between
     * glslExtensions and its own code, which calls the functions that the text names. Owned by the view. */
    const char* glslGeometry;
    /* Null unless state.vertexPulling is 1 or state.multicast is not 0. Otherwise the host's vertex shader has this
     * text between glslExtensions and its own code, which calls agaa_pullVertex() or agaa_multicast() once. Owned by
     * the view. */
    const char* glslVertex;
} AgaaDrawPass;
#define AGAA_DRAW_PASS_INIT                                                                                            \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_DRAW_PASS, (uint32_t)sizeof(AgaaDrawPass), NULL, 0, 0, NULL, 0, 0, 0, 0, 0,                \
            {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, NULL, NULL, NULL, NULL                                   \
    }
AGAA_API void AGAA_CALL agaaInitDrawPass(AgaaDrawPass* outPass, size_t structSize);

/* Lists the draw passes of a view.
 *
 * count    Receives the number of draw passes; unchanged on failure. On entry it holds the length of the array,
 *          unless passes is null.
 * passes   Null, or an array whose elements are all initialised; unchanged on failure. Strings stay valid until the
 *          view is resized or destroyed.
 *
 * Errors   AGAA_ERROR_INVALID_ARGUMENT   the view or count is null
 *          AGAA_ERROR_STRUCT             an element, or a struct chained to it, is not initialised
 *          AGAA_ERROR_UNKNOWN_STRUCT     a chained struct is not the graphics API's AgaaVkDrawPass or AgaaGlDrawPass
 *          AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads  One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaGetDrawPasses(AgaaView view, uint32_t* count, AgaaDrawPass* passes);

typedef enum AgaaGlslResourceKind {
    AGAA_GLSL_RESOURCE_UNIFORM = 1, /* plain uniform, without a binding */
    AGAA_GLSL_RESOURCE_SAMPLER = 2,
    AGAA_GLSL_RESOURCE_IMAGE = 3,
    AGAA_GLSL_RESOURCE_UNIFORM_BLOCK = 4,
    AGAA_GLSL_RESOURCE_STORAGE_BLOCK = 5,
    AGAA_GLSL_RESOURCE_INPUT_ATTACHMENT = 6,
    AGAA_GLSL_RESOURCE_KIND_MAX_ENUM = 0x7FFFFFFF
} AgaaGlslResourceKind;

typedef enum AgaaGlslStageBits {
    AGAA_GLSL_STAGE_FRAGMENT = 1, /* AgaaDrawPass::glslDeclarations */
    AGAA_GLSL_STAGE_GEOMETRY = 2, /* AgaaDrawPass::glslGeometry */
    AGAA_GLSL_STAGE_VERTEX = 4,   /* AgaaDrawPass::glslVertex */
    AGAA_GLSL_STAGE_MAX_ENUM = 0x7FFFFFFF
} AgaaGlslStageBits;

/* A resource that the GLSL of a draw pass declares. Compilers remove those that the host's code does not reach. */
typedef struct AgaaGlslResource {
    char name[64];        /* of the uniform, or of the block; begins with agaa_ */
    uint32_t kind;        /* AgaaGlslResourceKind */
    uint32_t stages;      /* AgaaGlslStageBits of the texts that declare it */
    uint32_t set;         /* descriptor set on Vulkan; 0 on OpenGL */
    uint32_t binding;     /* in the set; on OpenGL the texture unit, the image unit or the binding point of the block;
                             0 for plain uniforms, which have locations */
    uint32_t count;       /* elements of an array; 1 otherwise */
    uint32_t reserved[3]; /* 0 */
} AgaaGlslResource;

/* Lists the resources that the GLSL of a draw pass declares, for engines that set or describe every uniform of their
 * shaders. The first call for a pass preprocesses its texts, which takes milliseconds.
 *
 * pass       Index of the draw pass in agaaGetDrawPasses.
 * count      Receives the number of resources; unchanged on failure. On entry it holds the length of the array, unless
 *            resources is null.
 * resources  Null, or an array that receives the resources; unchanged on failure.
 *
 * Errors     AGAA_ERROR_INVALID_ARGUMENT   the view or count is null, or the text of the host in the pass does not
 *                                          preprocess
 *            AGAA_ERROR_OUT_OF_RANGE       the view has no such draw pass
 *            AGAA_ERROR_BUFFER_TOO_SMALL   the array is too short
 * Threads    One call at a time per context. */
AGAA_API AgaaResult AGAA_CALL agaaGetGlslResources(AgaaView view, uint32_t pass, uint32_t* count,
                                                   AgaaGlslResource* resources);

/* The target of one call of the draw callback. The SDK fills it; structSize is the size in the library. */
typedef struct AgaaDrawTarget {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    uint32_t pass;           /* AgaaDrawPassId */
    uint32_t batch;          /* index of the batch, from 0, if the frame calls for the pass more than once */
    uint32_t width, height;  /* texels that the frame draws, from (0, 0). With one viewport they are viewport and
                                scissor */
    uint32_t scaleX, scaleY; /* texels per pixel. Multiply screen-space derivatives by these */
    AgaaDrawState state;
    uint64_t pipelineKey;   /* AgaaDrawPass::pipelineKey of the pass */
    void* commandBuffer;    /* Vulkan: VkCommandBuffer, inside rendering. OpenGL: null */
    uint64_t descriptorSet; /* Vulkan: VkDescriptorSet, to be bound at AgaaVkDeviceDesc::descriptorSet. OpenGL: 0 */
    uint32_t framebuffer;   /* OpenGL: the framebuffer that the callback binds. Vulkan: 0 */
    uint32_t constantCount; /* vectors of four floats in constants */
    /* OpenGL with AGAA_GL_CONSTANTS_UNIFORMS: the values of `uniform vec4 agaa_constants[]`. Otherwise null. Valid
     * during the callback only. */
    const float* constants;
    /* One viewport, or one for each layer of the tiers LAYERS and NV_MULTICAST. With state.multicast the callback sets
     * them all and draws once. Otherwise it draws everything in each of them, in any order. Valid during the callback
     * only. */
    const AgaaViewport* viewports;
    uint32_t viewportCount; /* 1, 2, 4 or 8 */
    uint32_t reserved;      /* 0 */
} AgaaDrawTarget;

/* Draws the opaque and alpha-masked geometry of the scene, or with AGAA_FETCH_NOT_ALL_DRAWS the part that the pass
 * names. The target is cleared, or holds the depth of an earlier pass.
 *
 * user      AgaaFrame::drawUser.
 * target    Valid during the callback only.
 *
 * Returns   AGAA_OK, or any other value to abandon the frame.
 * Vulkan    The SDK begins and ends rendering. Nothing is bound; viewport and scissor are not set. The callback
 *           records its commands inline and executes no command buffers of its own. With
 *           AGAA_DEVICE_CONDITIONAL_RENDERING, draws in batches are within conditional rendering, and the callback
 *           begins none in them. With AGAA_VK_RECORDING_SECONDARY, all batches execute the commands of one call.
 * OpenGL    The host's state is as it was on entry to agaaGlRecordFrame, except for the bindings named in
 *           AgaaGlDeviceDesc. The callback binds the framebuffer and sets viewports, scissors and
 *           AgaaDrawState.
 * Threads   The thread that records. The callback must not call the SDK and must not throw; an exception that the
 *           SDK can catch counts as AGAA_ERROR_CALLBACK. */
typedef AgaaResult(AGAA_CALL* AgaaDrawCallback)(void* user, const AgaaDrawTarget* target);

/* ---- lights and shadows --------------------------------------------------------------------- */

typedef enum AgaaLightType {
    AGAA_LIGHT_DIRECTIONAL = 0,
    AGAA_LIGHT_POINT = 1,
    AGAA_LIGHT_SPOT = 2,
    AGAA_LIGHT_MAX_ENUM = 0x7FFFFFFF
} AgaaLightType;

#define AGAA_NO_SHADOW 0xFFFFFFFFu

typedef struct AgaaLight {
    uint32_t type;      /* AgaaLightType */
    uint32_t shadowMap; /* index into AgaaFrame::shadows, or AGAA_NO_SHADOW */
    float position[3];  /* position in shading space, [-1e18, 1e18] */
    float direction[3]; /* unit vector in shading space along which the light travels; finite for a point light */
    float color[3];     /* irradiance (directional) or intensity (point, spot), [0, 1e30] */
    float range;        /* (0, 1e18], or 0: infinite */
    float cosInner;     /* spot: cosines of the half angles, [-1, 1]; cosInner >= cosOuter. Not read for other types */
    float cosOuter;
    float radius;   /* radius of the lamp, [0, 1e15]; the inverse-square law stops there */
    float reserved; /* 0 */
} AgaaLight;
#define AGAA_LIGHT_INIT                                                                                                \
    {                                                                                                                  \
        AGAA_LIGHT_DIRECTIONAL, AGAA_NO_SHADOW, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {1.0f, 1.0f, 1.0f}, 0.0f,     \
            1.0f, 0.0f, 0.0f, 0.0f                                                                                     \
    }
AGAA_API void AGAA_CALL agaaInitLight(AgaaLight* outLight, size_t structSize);

/* A shadow map: a 2D array of depth layers with a matrix each. A point uses the first layer whose clip volume contains
 * it: one layer is a plain map, several layers in order of detail are cascades, six layers are the faces of a cube.
 * Points outside all layers are lit. A point is lit if its depth - depthBias <= the stored depth. */
typedef struct AgaaShadow {
    uint32_t layerCount; /* [1, AGAA_MAX_SHADOW_LAYERS], or 0 if an AgaaShadowFunction answers; then the rest is
                            ignored */
    float depthBias;     /* bias in units of the map's depth, [0, 1] */
    float matrices[AGAA_MAX_SHADOW_LAYERS][16]; /* transforms from shading space to the layer's clip space, z in
                                                   [0, w] */
} AgaaShadow;
#define AGAA_SHADOW_INIT                                                                                               \
    {                                                                                                                  \
        1, 0.0f, {                                                                                                     \
            {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {0}, {0}, {0}, {0}, { 0 }                                \
        }                                                                                                              \
    }
AGAA_API void AGAA_CALL agaaInitShadow(AgaaShadow* outShadow, size_t structSize);

/* ---- frame ---------------------------------------------------------------------------------- */

/* Segments of a frame. A host may record them in separate calls and use the surfaces between the calls. A technique
 * or a tier may leave a segment empty.
 *
 * The camera of a frame is that of its first segment. Lights, shadows, ambient light and background are read with
 * AGAA_SEGMENT_SHADING. The device may still run earlier segments while a later one is recorded. If the command
 * buffer of a frame is discarded, the frame counts as completed and has no statistics: their functions return
 * AGAA_NOT_READY until a later frame is completed. Discard all segments of the frame. */
/* The first geometry pass, into depth or a G-buffer; with AGAA_FETCH_NOT_ALL_DRAWS also the second. */
#define AGAA_SEGMENT_PREPASS UINT64_C(0x1)
/* The passes that leave aggregates or surfaces in memory. */
#define AGAA_SEGMENT_GENERATION UINT64_C(0x2)
/* All passes that write the output, and the draw pass FORWARD. */
#define AGAA_SEGMENT_SHADING UINT64_C(0x4)
#define AGAA_SEGMENT_ALL UINT64_C(0x7)

typedef struct AgaaFrame {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;       /* null, or an AgaaTemporalFrame (agaa/temporal.h) */
    uint64_t frameIndex;     /* increases by at least 1 per frame, from 1 */
    uint64_t completedFrame; /* the newest frame that the device is known to have finished, < frameIndex; 0: none */
    uint64_t segments;       /* AGAA_SEGMENT_…, in order, each once per frame */
    float view[16];          /* transform from shading to view space: a rotation without reflection or translation;
                                elements 3, 7 and 11 are 0, element 15 is 1. Left-handed hosts:
                                docs/integration/coordinate-systems.md */
    /* Transform from view space to clip space as the rasteriser uses it, with sub-pixel jitter and the y flip of a
     * negative viewport height. It is perspective (element 11 is -1, element 15 is 0) or orthographic (0 and 1),
     * without shear, roll or an oblique near plane. Samples whose depth rounds to that of the far plane (1, or 0
     * with AGAA_VIEW_REVERSED_Z) show the background. With AGAA_VIEW_REVERSED_Z and a float depth, draw nothing at
     * depth 0 exactly, such as a sky: techniques with two geometry passes would count it as drawn twice. "msaa" may
     * also show the background at the fixed-point depth next to that of the far plane. */
    float projection[16];
    uint32_t lightCount;  /* [0, AgaaSceneFacts::maxLights] */
    uint32_t shadowCount; /* [0, AgaaSceneFacts::shadowMapCount] */
    uint32_t lightSize;   /* sizeof(AgaaLight): the distance between elements of lights; not read without lights */
    uint32_t shadowSize;  /* sizeof(AgaaShadow): the distance between elements of shadows; not read without shadows */
    const AgaaLight* lights;   /* may be null without lights */
    const AgaaShadow* shadows; /* may be null without shadows */
    float ambient[3];          /* radiance from all directions, [0, 65504] */
    /* The colour of pixels without geometry, [0, 65504]. The fourth element is in (0, 65504], or 0 to keep the
     * contents of the output; this needs AGAA_VIEW_COMPOSITE and, on Vulkan, an outputLayoutIn that preserves them.
     * The output receives linear colours up to 65504 and alpha 1. */
    float background[4];
    /* Selects the random numbers by which translucent surfaces cover samples (AgaaSurfaceInput::alphaCutoff is 0).
     * It must be the same in all segments of a frame. With 0 in every frame the pattern stands still; with a
     * different number per frame, images that are accumulated over frames converge. Cut-outs do not depend on it. */
    uint32_t ditherFrame;
    AgaaDrawCallback draw; /* null only if the view has no draw passes */
    void* drawUser;
    /* The facts of this frame; null: the facts of the view. They must be the same in all segments of a frame, and
     * within the facts of the view: effects, maxLights and shadowMapCount may only be fewer. Otherwise the frame
     * fails with AGAA_ERROR_OUT_OF_RANGE. lightCount and shadowCount are checked against them. The frame is shown
     * without the effects that they leave out: SPECULAR, EMISSIVE, AMBIENT and shadows. A frame without ALPHA_MASKED
     * or CUSTOM_DEPTH is shown as one with them. Common values (ONE_ROUGHNESS and the like) always come from the
     * view. Layouts, surfaces and draw passes follow the facts of the view, so that "msaa", which shades in a draw
     * pass, shows all effects of the view. The SDK's passes save time if agaaPrepareVariants compiled them for these
     * facts. Draws of a frame without SPECULAR must write specular 0 and alpha2 1, without EMISSIVE emissive 0;
     * otherwise the grouping of samples depends on the variants that are prepared. */
    const AgaaSceneFacts* facts;
    /* The factor by which the host's tone mapping multiplies the output, [0, 1e9]: 1 / exposure is the luminance that
     * it shows at half brightness, as x / (1 + x) does. Views with AGAA_CONFIG_HDR_RESOLVE read it with
     * AGAA_SEGMENT_SHADING; 0 gives all events the same weight. */
    float exposure;
    /* Pixels of the frame, up to those of the view, for hosts that change the resolution from frame to frame: nothing
     * is allocated or compiled. 0 and 0: those of the view, and of the output. The frame uses the corner at (0, 0) of
     * draw targets and of the view's images; buffers hold its pixels row by row without gaps. A frame of another size
     * than the one before has no history and no memory of sample counts. The same in all segments of a frame. */
    uint32_t width, height;
    /* The pixel of the output that receives the frame's pixel (0, 0), so that several views may share an output. The
     * output holds the frame; pixels outside it keep their contents, with a Vulkan outputLayoutIn that preserves them.
     * Not 0 only with width and height. Checked in all segments, used with AGAA_SEGMENT_SHADING. Functions of the host
     * and reports count pixels from the frame's corner. */
    uint32_t outputX, outputY;
    uint32_t reserved; /* 0 */
} AgaaFrame;
#define AGAA_FRAME_INIT                                                                                                \
    {                                                                                                                  \
        AGAA_STRUCTURE_TYPE_FRAME, (uint32_t)sizeof(AgaaFrame), NULL, 0, 0, AGAA_SEGMENT_ALL,                          \
            {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {0}, 0, 0, (uint32_t)sizeof(AgaaLight),                  \
            (uint32_t)sizeof(AgaaShadow), NULL, NULL, {0, 0, 0}, {0, 0, 0, 1}, 0, NULL, NULL, NULL, 1.0f, 0, 0, 0, 0,  \
            0                                                                                                          \
    }
/* Initialises a frame. It sets lightSize and shadowSize to 0: the host must set them. */
AGAA_API void AGAA_CALL agaaInitFrame(AgaaFrame* outFrame, size_t structSize);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_FRAME_H */
