/* Functions of the host's that passes are compiled with: its own G-buffer, materials by id, shadows. Part of
 * agaa_sdk.h.
 * SPDX-License-Identifier: MIT */
#ifndef AGAA_FUNCTIONS_H
#define AGAA_FUNCTIONS_H

#include "agaa/config.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Chained to AgaaViewDesc: a multisampled G-buffer that the host draws itself, before it records the frame. The
 * library draws nothing: AgaaFrame::draw is not called and may be null, and techniques that aggregate take the tier
 * GBUFFER. Its passes are compiled with a function of the host's that reads a sample; the text is GLSL 450, in OpenGL
 * contexts below 4.5 GLSL 430, and defines
 *     bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m)
 * which gives depth as the host's depth buffer holds it, and the material (docs/shader-interface.md), and says whether
 * sample i, [0;n), shows geometry. It runs in compute: no implicit derivatives. Its resources, readable by compute when
 * the frame's commands run, are in set 1 (Vulkan), or where agaaGlRecordFrame says. Colours are in [0;1], emission in
 * [0;range] of the layout; what is not finite becomes the least of its range, as in docs/shader-interface.md.
 * Names beginning with agaa, Agaa and AGAA_ are the library's, but for the functions that the host defines. Code that
 * does not compile is AGAA_ERROR_INVALID_ARGUMENT, with the compiler's first message. Not for "msaa", and not together
 * with an AgaaFetchFunction. */
typedef struct AgaaGBufferFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    /* Where the n samples lie in the pixel, [0;1), as pairs x, y of gl_FragCoord; null: in a target of the
     * visibility tier, whose texels agaaTexel(pixel, i) and agaaTexelSample(i) name. */
    const float* samplePositions;
    uint64_t descriptorSetLayout; /* Vulkan: VkDescriptorSetLayout of set 1, for compute, or 0 without resources; that
                                     of an AgaaShadowFunction too, where both have one; not used after
                                     agaaVkCreateView. OpenGL: 0 */
    uint32_t depthBits;           /* of a fixed-point depth, 16 or 24; 0: a float */
    uint32_t reserved;            /* 0 */
    /* Null, or what the text needs of extensions: lines "#extension NAME : BEHAVIOUR" and nothing else. They hold for
     * the whole pass. Enabling their features, or making a context that has them, is the host's; for bindless
     * textures on Vulkan GL_EXT_nonuniform_qualifier, shaderSampledImageArrayNonUniformIndexing and
     * runtimeDescriptorArray. Other lines are AGAA_ERROR_INVALID_ARGUMENT. */
    const char* glslExtensions;
} AgaaGBufferFunction;
#define AGAA_GBUFFER_FUNCTION_INIT                                                                  \
    {AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION, (uint32_t)sizeof(AgaaGBufferFunction), NULL, NULL, NULL, 0, 0, 0, NULL}

/* Chained to AgaaViewDesc: materials by id, for the tier IDS, which AUTO then is. The visibility pass leaves, beside
 * depth, which draw and primitive each sample shows (AgaaSurfaceInput::draw, ::primitive); compute passes find the
 * primitives of a pixel, evaluate the material of each once, in the middle of its samples, group these and shade.
 * They are compiled with functions of the host's; the text, GLSL as at AgaaGBufferFunction, defines
 *     void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c)
 *     void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m)
 * which give the clip coordinates of a triangle, as the vertex shader computed them, but with y as
 * AgaaFrame::projection has it, where a negative viewport height turns it, and the material at a point of
 * it (docs/shader-interface.md). That point's material is taken for all samples of the primitive in the pixel. Its
 * normal is, too, unless the function gives the normal's derivatives. With AGAA_CONFIG_FINE_MATERIALS a material is
 * taken for the samples of a texel, and derivatives of normals are not used. The functions run in compute: no implicit
 * derivatives. Their resources are in set 1 (Vulkan), or where agaaGlRecordFrame says. Colours are in [0;1], emission in
 * [0;range] of the layout; what is not finite as there. The alpha test is the visibility pass's alone. Names and errors
 * as at AgaaGBufferFunction. Of "agaa". */
/* Some draws cannot be fetched: displaced, or by shaders that compute cannot call. The visibility pass gives them
 * AgaaSurfaceInput::draw = AGAA_UNFETCHED, and a second geometry pass, AGAA_DRAW_PASS_GBUFFER whose depthCompare is
 * EQUAL, draws these draws alone into a multisampled G-buffer, from which their samples are taken; it takes one id. Of
 * equal depths the first drawn is shown; without a stencil (AGAA_CONFIG_NO_STENCIL, or no such depth format) the last of
 * these draws. Not with AGAA_FACT_CUSTOM_DEPTH. */
#define AGAA_FETCH_NOT_ALL_DRAWS UINT64_C(0x01)
typedef struct AgaaFetchFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t maxDraws;      /* >= 1; the numbers of draws are below it. What is not, is shown as the last draw's first
                               primitive, or as the draw's last announced one, and counted as
                               AgaaCounters::unannounced */
    uint32_t maxPrimitives; /* >= 1, of a draw; rounded up to a power of two and times maxDraws it is at most 2^32 - 1,
                               with AGAA_FETCH_NOT_ALL_DRAWS one less: else AGAA_ERROR_TOO_LARGE */
    uint64_t descriptorSetLayout; /* as at AgaaGBufferFunction */
    uint64_t flags;               /* AGAA_FETCH_… */
    const char* glslExtensions;   /* as at AgaaGBufferFunction */
} AgaaFetchFunction;
#define AGAA_FETCH_FUNCTION_INIT                                                                    \
    {AGAA_STRUCTURE_TYPE_FETCH_FUNCTION, (uint32_t)sizeof(AgaaFetchFunction), NULL, NULL, 0, 0, 0, 0, NULL}

/* Chained to AgaaViewDesc: shadows by a function of the host's in place of some shadow maps. It is
 * compiled into the passes that shade; the text, GLSL as at AgaaGBufferFunction, defines
 *     float agaaHostShadow(uint shadow, vec3 position)
 * the share of light, [0;1], that a point in shading space gets past AgaaFrame::shadows[shadow]. It runs
 * in compute: no implicit derivatives. Its resources are in set 1 (Vulkan), or where agaaGlRecordFrame says;
 * names as at AgaaGBufferFunction. Code that does not compile is
 * AGAA_ERROR_INVALID_ARGUMENT, with the compiler's first message. Not for "msaa": AGAA_ERROR_UNSUPPORTED. */
typedef struct AgaaShadowFunction {
    uint32_t sType;
    uint32_t structSize;
    const void* pNext;
    const char* glsl;
    uint32_t shadows;  /* bit i: the function answers for AgaaFrame::shadows[i], whose layerCount is 0 */
    uint32_t reserved; /* 0 */
    uint64_t descriptorSetLayout; /* as at AgaaGBufferFunction */
    const char* glslExtensions;   /* as at AgaaGBufferFunction */
} AgaaShadowFunction;
#define AGAA_SHADOW_FUNCTION_INIT                                                                   \
    {AGAA_STRUCTURE_TYPE_SHADOW_FUNCTION, (uint32_t)sizeof(AgaaShadowFunction), NULL, NULL, 0, 0, 0, NULL}

#ifdef __cplusplus
}
#endif
#endif /* AGAA_FUNCTIONS_H */
