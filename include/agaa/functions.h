/* GLSL functions of the host, with which the SDK's passes are compiled. Part of agaa_sdk.h.
 *
 * All texts are GLSL 450, or GLSL 430 in OpenGL contexts below 4.5. The functions run in compute shaders, without
 * implicit derivatives. Their resources must be readable by compute shaders when the commands of the frame run. On
 * Vulkan they are in descriptor set 1 (AgaaVkFrame::functionSet); on OpenGL they are where agaaGlRecordFrame
 * describes. Names that begin with agaa, Agaa or AGAA_ belong to the library, except for the functions that the host
 * defines. If a text does not compile, creating the view fails with AGAA_ERROR_INVALID_ARGUMENT and the compiler's
 * first message. It fails in the same way if the text is nested more than 500 levels deep, because compilers recurse;
 * macros are not expanded to find this. docs/shader-interface.md describes the structs.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_FUNCTIONS_H
#define AGAA_FUNCTIONS_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A multisampled G-buffer that the host draws before it records the frame. Chain it to AgaaViewDesc. The library draws
 * nothing: it does not call AgaaFrame::draw, and "agaa", "sbaa" and "adaptive" use the tier GBUFFER. The text defines
 *     bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m)
 * which returns whether sample i, [0, n), shows geometry, and provides its depth as the host's depth buffer holds it
 * and its material. Colours are in [0, 1], emission is in [0, range] of the layout. Non-finite values are replaced
 * by the lowest value of their range. "msaa" and "dcaa" do not support the struct (AGAA_ERROR_UNSUPPORTED). An
 * AgaaFetchFunction excludes it (AGAA_ERROR_INVALID_ARGUMENT). */
typedef struct AgaaGBufferFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    /* Positions of the n samples in the pixel, as pairs x, y in [0, 1) of gl_FragCoord. Null: the samples are those
     * of a target of the visibility tier, which agaaTexel(pixel, i) and agaaTexelSample(i) address. */
    const float* samplePositions;
    /* Vulkan: VkDescriptorSetLayout of set 1, for the compute stage, or 0 without resources. Functions of a view
     * that have a layout must have the same one (AGAA_ERROR_INVALID_ARGUMENT). It must exist until the view is
     * destroyed: agaaResizeView uses it again. OpenGL: 0 (AGAA_ERROR_INVALID_ARGUMENT). */
    uint64_t descriptorSetLayout;
    uint32_t depthBits; /* bits of a fixed-point depth buffer, 16 or 24; 0: a float depth buffer */
    uint32_t reserved;  /* 0 */
    /* Null, or lines "#extension NAME : BEHAVIOUR" and nothing else (AGAA_ERROR_INVALID_ARGUMENT). They hold for the
     * whole pass. The host enables their features. Bindless textures on Vulkan need GL_EXT_nonuniform_qualifier,
     * shaderSampledImageArrayNonUniformIndexing and runtimeDescriptorArray. */
    const char* glslExtensions;
} AgaaGBufferFunction;
#define AGAA_GBUFFER_FUNCTION_INIT                                                                                     \
    { AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION, (uint32_t)sizeof(AgaaGBufferFunction), NULL, NULL, NULL, 0, 0, 0, NULL }
AGAA_API void AGAA_CALL agaaInitGBufferFunction(AgaaGBufferFunction* outFunction, size_t structSize);

/* Bits of AgaaFetchFunction::flags.
 *
 * NOT_ALL_DRAWS: some draws cannot be fetched, because they are displaced or their shaders cannot run in compute. In
 * the visibility pass these draws set AgaaSurfaceInput::draw to AGAA_UNFETCHED. A second geometry pass
 * (AGAA_DRAW_PASS_GBUFFER with depthCompare EQUAL) draws only them into a multisampled G-buffer. The number
 * AGAA_UNFETCHED takes one id. At equal depth the first draw is shown; without a stencil format or with
 * AGAA_MEASURE_NO_STENCIL, the last unfetched draw. Excludes AGAA_FACT_CUSTOM_DEPTH and the tiers FRAGMENT_LISTS and
 * FRAGMENTS (AGAA_ERROR_UNSUPPORTED); "dcaa" then uses the tier MATERIAL_LISTS, which fetches nothing. In it,
 * fragments of draws with AGAA_UNFETCHED merge last, ordered by content. */
#define AGAA_FETCH_NOT_ALL_DRAWS UINT64_C(0x01)

/* Functions that fetch materials by id, for "agaa" with the tier IDS or FRAGMENTS, for "adaptive" with the tier IDS
 * and for "dcaa" with the tier FRAGMENT_LISTS, which AUTO then selects. With AGAA_FETCH_NOT_ALL_DRAWS, AUTO selects
 * GBUFFER for "adaptive". Chain it to AgaaViewDesc. With the tier IDS, the visibility pass stores, beside depth, the
 * draw and the primitive of each sample (AgaaSurfaceInput::draw, ::primitive). Compute passes find the primitives of
 * a pixel, evaluate the material of each once, at the mean position of its samples, group the samples and shade;
 * "adaptive" evaluates it again for each shaded sample. The tier FRAGMENT_LISTS evaluates the material of each
 * fragment, the tier FRAGMENTS that of each fragment that shows. The text defines
 *     void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c)
 *     void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m)
 * The first provides the clip coordinates of a triangle as the vertex shader computes them, with the y direction of
 * AgaaFrame::projection if a negative viewport height flips it. The second provides the material at a point of the
 * triangle. All samples of the primitive in the pixel share this material. They share its normal too, unless the
 * function provides derivatives of the normal. With AGAA_CONFIG_FINE_MATERIALS the samples of one texel share a
 * material, and derivatives of normals are not used. Colours are in [0, 1], emission is in [0, range] of the layout.
 * Non-finite values are replaced by the lowest value of their range. Only the visibility pass and the fragments pass
 * test alpha. With maxTriangles compute passes replace both. */
typedef struct AgaaFetchFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    /* Upper bound of draw numbers, >= 1: draws are numbered below maxDraws. Out-of-range draws show primitive 0 of
     * the last draw, out-of-range primitives the last primitive of their draw; AgaaCounters::unannounced counts
     * both. */
    uint32_t maxDraws;
    /* Largest number of primitives of a draw, >= 1. maxPrimitives, rounded up to a power of two, times maxDraws is
     * at most 2^32 - 1, or 2^32 - 2 with AGAA_FETCH_NOT_ALL_DRAWS (AGAA_ERROR_TOO_LARGE). */
    uint32_t maxPrimitives;
    uint64_t descriptorSetLayout; /* see AgaaGBufferFunction::descriptorSetLayout */
    uint64_t flags;               /* AGAA_FETCH_… */
    const char* glslExtensions;   /* see AgaaGBufferFunction::glslExtensions */
    /* 0: the host draws all passes. Otherwise "dcaa" with the tier FRAGMENT_LISTS and "agaa" with the tiers FRAGMENTS
     * and IDS call no draw callback: compute passes fetch all primitives by id and find the samples that they cover.
     * Lists have the fragments of a draw, and the device needs neither geometry shaders nor atomics in fragment
     * shaders. IDS shows the nearest primitive of each sample of the target, and of equal depths the first in the order
     * of draws and primitives. Edges are exact; rasterisers round vertices, usually to 1/256 of a pixel. The view has
     * no surface "depth". The host draws the ids with AGAA_FETCH_NOT_ALL_DRAWS, AGAA_FACT_CUSTOM_DEPTH and
     * AGAA_CONFIG_ACCUMULATE. The value is the upper bound of the primitives of all draws of a frame together, below
     * 2^31 (AGAA_ERROR_OUT_OF_RANGE). Further primitives are not drawn; AgaaCounters::unannounced counts them, and
     * those beyond maxPrimitives. Each takes 8 bytes of the view's memory. Primitives with a corner that is not finite
     * are not drawn. The text also defines
     *     void agaaHostDraw(uint draw, inout AgaaDraw d)
     *     void agaaHostAlpha(AgaaPrimitive p, inout AgaaAlpha a)
     * The first is called for all draws below maxDraws and provides the number of primitives, 0 for draws that the
     * frame does not show. The second is needed in views with AGAA_FACT_ALPHA_MASKED or AGAA_CONFIG_CHECK_FACTS and
     * provides what decides coverage by alpha at the centre of a pixel, to which p is moved; agaaMoveTo(p, offset)
     * moves it to agaa_alphaPoint(k) or agaa_alphaRowPoint(r, c). */
    uint32_t maxTriangles;
    uint32_t reserved; /* 0 */
} AgaaFetchFunction;
#define AGAA_FETCH_FUNCTION_INIT                                                                                       \
    { AGAA_STRUCTURE_TYPE_FETCH_FUNCTION, (uint32_t)sizeof(AgaaFetchFunction), NULL, NULL, 0, 0, 0, 0, NULL, 0, 0 }
AGAA_API void AGAA_CALL agaaInitFetchFunction(AgaaFetchFunction* outFunction, size_t structSize);

/* A function that replaces some shadow maps. Chain it to AgaaViewDesc. It is compiled into the passes that shade.
 * The text defines
 *     float agaaHostShadow(uint shadow, vec3 position)
 * which returns the share of light, [0, 1], that reaches a point in shading space past AgaaFrame::shadows[shadow]. For
 * the shadows of `footprints`, it defines instead
 *     float agaaHostShadowFootprint(uint shadow, AgaaFootprint footprint)
 * which is called once for each shading event and returns the mean share over the positions of its samples, for example
 * by maps that are filtered in advance (AGAA 3.5.3). AgaaFootprint has position, positionSquares, positionProducts and
 * depthVariance, as AgaaSurface has (docs/shader-interface.md). "msaa" does not support the struct
 * (AGAA_ERROR_UNSUPPORTED). */
typedef struct AgaaShadowFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t shadows;             /* bit i in [0, AgaaSceneFacts::shadowMapCount): the function answers for
                                     AgaaFrame::shadows[i], whose layerCount is 0; one bit at least */
    uint32_t footprints;          /* bits of `shadows`. With AgaaAggregation::litShadows, which looks shadows up at
                                     samples, they are unsupported (AGAA_ERROR_UNSUPPORTED) */
    uint64_t descriptorSetLayout; /* see AgaaGBufferFunction::descriptorSetLayout */
    const char* glslExtensions;   /* see AgaaGBufferFunction::glslExtensions */
} AgaaShadowFunction;
#define AGAA_SHADOW_FUNCTION_INIT                                                                                      \
    { AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION, (uint32_t)sizeof(AgaaShadowFunction), NULL, NULL, 0, 0, 0, NULL }
AGAA_API void AGAA_CALL agaaInitShadowFunction(AgaaShadowFunction* outFunction, size_t structSize);

/* The part of the lighting that a shading function replaces.
 *
 * REFLECTANCE: the library's reflectance in its loop over lights, which keeps culling, shadows, spot cones and
 * attenuation; emission and ambient light are added as without the function. The text defines
 *     vec3 agaaReflect(AgaaSurface surface, vec3 toLight, vec3 toEye)
 * which returns the radiance that is reflected to the eye for unit radiance from toLight: the reflectance times the
 * cosine. It is called once for each light that reaches an event.
 * EVENT: all lighting. The text defines
 *     vec3 agaaShade(AgaaSurface surface)
 * which returns the radiance to the eye, emission and ambient light included. It may loop over the lights that reach
 * the tile (agaaNextLight), look shadows up (agaaShadow, agaaShadowAt) and call the library's reflectance
 * (agaaBuiltInReflect). Views whose function reads none of the frame's lights or shadows need not declare any in
 * AgaaSceneFacts and do not pay for them. "visibility" adds the emission of samples itself; surface.emissive is 0. */
typedef enum AgaaShadingLevel { AGAA_SHADING_REFLECTANCE = 0, AGAA_SHADING_EVENT = 1 } AgaaShadingLevel;

/* A function that shades in place of the library. Chain it to AgaaViewDesc. It is compiled into the passes that shade,
 * and called once for each shading event: a sample, a fragment or an aggregate, whose means it receives in an
 * AgaaSurface. Positions and directions are in shading space. Negative results count as 0. Results that are not finite
 * count as 0 too; AgaaCounters::sanitised counts them. "msaa", which shades in the host's fragment shaders, has the
 * text in AgaaDrawPass::glslDeclarations: the host binds its resources as those of its own shader. The library compiles
 * it only to find errors when the view is created. */
typedef struct AgaaShadingFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t level;               /* AgaaShadingLevel */
    uint32_t reserved;            /* 0 */
    uint64_t descriptorSetLayout; /* see AgaaGBufferFunction::descriptorSetLayout */
    const char* glslExtensions;   /* see AgaaGBufferFunction::glslExtensions */
} AgaaShadingFunction;
#define AGAA_SHADING_FUNCTION_INIT                                                                                     \
    { AGAA_STRUCTURE_TYPE_SHADING_FUNCTION, (uint32_t)sizeof(AgaaShadingFunction), NULL, NULL, 0, 0, 0, NULL }
AGAA_API void AGAA_CALL agaaInitShadingFunction(AgaaShadingFunction* outFunction, size_t structSize);

#ifdef __cplusplus
}
#endif
#endif /* AGAA_FUNCTIONS_H */
