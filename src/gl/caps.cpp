// Requirements and capabilities of OpenGL contexts.
#include "core/abi/api_guard.h"
#include "core/base/error.h"
#include "core/view/tiers.h"
#include "gl/context.h"
#include "gl/formats.h"
#include "gl/structs.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace agaa::gl {

namespace {

// Core in OpenGL 4.5.
constexpr const char* requiredExtensions[] = {"GL_ARB_direct_state_access"};
constexpr const char* optionalExtensions[] = {
    "GL_ARB_post_depth_coverage", // without it generation runs once per sample
    "GL_ARB_clip_control",        // core in OpenGL 4.5; without it reversed depth loses precision
    "GL_ARB_fragment_shader_interlock",
    "GL_EXT_shader_framebuffer_fetch",
    "GL_KHR_shader_subgroup",
    "GL_NV_framebuffer_mixed_samples",
    "GL_NV_sample_mask_override_coverage",
};

GLint integer(const GladGLContext& gl, GLenum parameter) {
    GLint value = 0;
    gl.GetIntegerv(parameter, &value);
    return value;
}

// NVIDIA emulates some sample counts by fewer samples in a larger image. Sample masks and positions do not match there.
bool isRasterised(const GladGLContext& gl, Format format, GLint samples) {
    if (!gl.NV_internalformat_sample_query)
        return true;
    const auto is = [&](GLenum parameter) {
        GLint value = 1;
        gl.GetInternalformatSampleivNV(GL_TEXTURE_2D_MULTISAMPLE, internalFormat(format), samples, parameter, 1,
                                       &value);
        return value == 1;
    };
    return is(GL_SUPERSAMPLE_SCALE_X_NV) && is(GL_SUPERSAMPLE_SCALE_Y_NV) && is(GL_CONFORMANT_NV);
}

// Returns a bit mask: textures of this format can have 2^i samples if bit i is set.
uint32_t sampleCounts(const GladGLContext& gl, Format format) {
    GLint count = 0;
    gl.GetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, internalFormat(format), GL_NUM_SAMPLE_COUNTS, 1, &count);
    std::vector<GLint> list(size_t(std::max(count, 0)));
    gl.GetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, internalFormat(format), GL_SAMPLES, count, list.data());
    uint32_t bits = 1;
    for (GLint samples : list)
        if (samples > 0 && std::has_single_bit(uint32_t(samples)) && isRasterised(gl, format, samples))
            bits |= 1u << std::countr_zero(uint32_t(samples));
    return bits;
}

// Returns AgaaDeviceCaps::subgroupSize. OpenGL cannot require full subgroups. Those of NVIDIA are always full, because
// workgroups have a multiple of their lanes. Other vendors may compile a shader for fewer lanes than they report.
uint32_t fullSubgroupSize(const GladGLContext& gl) {
    if (!gl.KHR_shader_subgroup || !textOf(gl, GL_VENDOR).starts_with("NVIDIA"))
        return 0;
    constexpr GLint operations = GL_SUBGROUP_FEATURE_BASIC_BIT_KHR | GL_SUBGROUP_FEATURE_VOTE_BIT_KHR |
                                 GL_SUBGROUP_FEATURE_BALLOT_BIT_KHR | GL_SUBGROUP_FEATURE_SHUFFLE_BIT_KHR;
    const bool has = integer(gl, GL_SUBGROUP_SUPPORTED_STAGES_KHR) & GL_COMPUTE_SHADER_BIT &&
                     (integer(gl, GL_SUBGROUP_SUPPORTED_FEATURES_KHR) & operations) == operations;
    return has ? uint32_t(integer(gl, GL_SUBGROUP_SIZE_KHR)) : 0;
}

} // namespace

AgaaDeviceCaps queryCaps(const GladGLContext& gl) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    std::snprintf(caps.deviceName, sizeof caps.deviceName, "%.127s", textOf(gl, GL_RENDERER).c_str());
    std::snprintf(caps.driverName, sizeof caps.driverName, "%.60s %.60s", textOf(gl, GL_VENDOR).c_str(),
                  textOf(gl, GL_VERSION).c_str());
    GLint viewport[2] = {0, 0};
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    caps.maxImageSize =
        uint32_t(std::min({integer(gl, GL_MAX_TEXTURE_SIZE), viewport[0], viewport[1],
                           integer(gl, GL_MAX_FRAMEBUFFER_WIDTH), integer(gl, GL_MAX_FRAMEBUFFER_HEIGHT)}));
    GLint64 range = 0;
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &range);
    caps.maxStorageRange = uint64_t(std::max<GLint64>(range, 0));
    caps.maxSharedBytes = uint32_t(integer(gl, GL_MAX_COMPUTE_SHARED_MEMORY_SIZE));
    caps.subgroupSize = fullSubgroupSize(gl);
    // Software rasterisers of Mesa.
    for (const char* software : {"llvmpipe", "softpipe"})
        if (std::strstr(caps.deviceName, software))
            caps.flags |= AGAA_DEVICE_SOFTWARE;
    caps.flags |= AGAA_DEVICE_SAMPLE_RATE_SHADING | AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_D24S8 |
                  AGAA_DEVICE_D32S8 | AGAA_DEVICE_NO_ALIASING | AGAA_DEVICE_GEOMETRY_SHADERS;
    if (integer(gl, GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS) >= 2)
        caps.flags |= AGAA_DEVICE_FRAGMENT_ATOMICS;
    if (gl.ARB_post_depth_coverage)
        caps.flags |= AGAA_DEVICE_POST_DEPTH_COVERAGE;
    if (gl.ARB_fragment_shader_interlock)
        caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
    if (gl.EXT_shader_framebuffer_fetch)
        caps.flags |= AGAA_DEVICE_FRAMEBUFFER_FETCH;
    if (gl.NV_framebuffer_mixed_samples && gl.NV_sample_mask_override_coverage &&
        integer(gl, GL_MIXED_DEPTH_SAMPLES_SUPPORTED_NV) && integer(gl, GL_MIXED_STENCIL_SAMPLES_SUPPORTED_NV))
        caps.flags |= AGAA_DEVICE_NV_MIXED_SAMPLES;
    // The extension guarantees a grid of sixteenths.
    if (gl.ARB_sample_locations && integer(gl, GL_PROGRAMMABLE_SAMPLE_LOCATION_TABLE_SIZE_ARB) >= 16)
        caps.flags |= AGAA_DEVICE_SAMPLE_LOCATIONS;
    if (gl.NV_viewport_array2 && integer(gl, GL_MAX_VIEWPORTS) >= int(maxLayers))
        caps.flags |= AGAA_DEVICE_NV_MULTICAST;
    caps.sampleCounts = 0x1F; // no standard defines a pattern of 32 samples
    for (Format format : {Format::R8, Format::RG8, Format::RGBA8, Format::R16, Format::RG16, Format::RGBA16,
                          Format::RGBA16F, Format::RGB10A2, Format::D24S8, Format::D32S8, Format::D32})
        caps.sampleCounts &= sampleCounts(gl, format);
    return caps;
}

} // namespace agaa::gl

using namespace agaa;

extern "C" {

AgaaResult AGAA_CALL agaaGlGetRequirements(AgaaGlRequirements* out) {
    return guarded(Log(), "agaaGlGetRequirements", [&]() -> AgaaResult {
        checkOutput(out);
        AgaaGlRequirements requirements = AGAA_GL_REQUIREMENTS_INIT;
        requirements.majorVersion = 4;
        requirements.minorVersion = 3;
        requirements.completeMajorVersion = 4;
        requirements.completeMinorVersion = 5;
        requirements.requiredExtensionCount = uint32_t(std::size(gl::requiredExtensions));
        requirements.requiredExtensions = gl::requiredExtensions;
        requirements.optionalExtensionCount = uint32_t(std::size(gl::optionalExtensions));
        requirements.optionalExtensions = gl::optionalExtensions;
        writeStruct(out, requirements);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlGetDeviceCaps(AgaaGlGetProcAddr getProcAddr, void* getProcUser, const AgaaLog* log,
                                         AgaaDeviceCaps* outCaps) {
    return guarded(log, "agaaGlGetDeviceCaps", [&]() -> AgaaResult {
        require(getProcAddr, AGAA_ERROR_INVALID_ARGUMENT, "getProcAddr is null.");
        checkOutput(outCaps);
        writeStruct(outCaps, gl::queryCaps(gl::loadFunctions(getProcAddr, getProcUser)));
        return AGAA_OK;
    });
}

} // extern "C"
