#include "gl/context.h"

#include "core/base/error.h"
#include "gl/bindings.h"
#include "gl/color_samples.h"
#include "gl/errors.h"
#include "gl/timer_probe.h"

#include <algorithm>

namespace agaa::gl {

GladGLContext loadFunctions(AgaaGlGetProcAddr getProcAddr, void* user) {
    struct Loader {
        AgaaGlGetProcAddr get;
        void* user;
        std::string missing; // first function that the driver does not have
    } loader{getProcAddr, user, {}};
    GladGLContext gl{};
    const int version = gladLoadGLContextUserPtr(
        &gl,
        [](void* pointer, const char* name) {
            auto& from = *static_cast<Loader*>(pointer);
            const auto function = GLADapiproc(from.get(from.user, name));
            if (!function && from.missing.empty())
                from.missing = name;
            return function;
        },
        &loader);
    require(version != 0, AGAA_ERROR_UNSUPPORTED, "no OpenGL context is current, or it is lost.");
    if (!gl.VERSION_4_3)
        fail(AGAA_ERROR_UNSUPPORTED, format("the context is OpenGL %d.%d; 4.3 is needed.", GLAD_VERSION_MAJOR(version),
                                            GLAD_VERSION_MINOR(version)));
    require(gl.VERSION_4_5 || gl.ARB_direct_state_access, AGAA_ERROR_UNSUPPORTED,
            "the context is below OpenGL 4.5 and lacks GL_ARB_direct_state_access.");
    if (!loader.missing.empty())
        fail(AGAA_ERROR_UNSUPPORTED, "getProcAddr has no " + loader.missing + ".");
    return gl;
}

std::string textOf(const GladGLContext& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

static StateScope scopeOf(const HostDialect& dialect) {
    StateScope scope = hostBindings(dialect);
    const StateScope passes = passBindings();
    const auto append = [](std::vector<uint32_t>& to, const std::vector<uint32_t>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(scope.textureUnits, passes.textureUnits);
    append(scope.uniformBindings, passes.uniformBindings);
    append(scope.storageBindings, passes.storageBindings);
    append(scope.imageUnits, passes.imageUnits);
    return scope;
}

static bool isCompatibilityProfile(const GladGLContext& gl) {
    GLint mask = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    return !(mask & GL_CONTEXT_CORE_PROFILE_BIT);
}

static GLenum limitOf(BindingKind kind) {
    switch (kind) {
    case BindingKind::Uniform:
        return GL_MAX_UNIFORM_BUFFER_BINDINGS;
    case BindingKind::Texture:
        return GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS;
    case BindingKind::Image:
        return GL_MAX_IMAGE_UNITS;
    case BindingKind::Storage:
    case BindingKind::WrittenStorage:
        break;
    }
    return GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS;
}

static void checkBindings(const GladGLContext& gl, const HostDialect& dialect) {
    for (const BindingRow& row : hostBindingTable) {
        const auto kind = hostKind(row, dialect);
        if (!kind)
            continue;
        GLint count = 0;
        gl.GetIntegerv(limitOf(*kind), &count);
        if (dialect.bindings[row.slot] >= uint32_t(count))
            fail(AGAA_ERROR_OUT_OF_RANGE,
                 format("AgaaGlDeviceDesc::bindings[AGAA_GL_BINDING_%s] is %u; the context has %d.", row.macro,
                        dialect.bindings[row.slot], count));
    }
}

// Applies the limits of image units and buffer textures: host draws access buffers as images.
static void limitToImages(const GladGLContext& gl, AgaaDeviceCaps& caps) {
    GLint texels = 0, images = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    gl.GetIntegerv(GL_MAX_FRAGMENT_IMAGE_UNIFORMS, &images);
    caps.maxStorageRange = std::min<uint64_t>(caps.maxStorageRange, 4 * uint64_t(texels));
    caps.flags &= ~AGAA_DEVICE_FRAGMENT_ATOMICS;
    caps.flags |= images >= 2 ? AGAA_DEVICE_FRAGMENT_ATOMICS : 0;
}

static bool notifiesReset(const GladGLContext& gl) {
    GLint strategy = GL_NO_RESET_NOTIFICATION;
    if (gl.VERSION_4_5 || gl.KHR_robustness)
        gl.GetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    return strategy == GL_LOSE_CONTEXT_ON_RESET;
}

// Identifies the driver: program binaries are loaded only by the driver that wrote them.
static std::string driverOf(const GladGLContext& gl) {
    std::string driver;
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION})
        driver += textOf(gl, name) + '\n';
    return driver;
}

static std::vector<uint32_t> binaryFormatsOf(const GladGLContext& gl) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    std::vector<GLint> formats(size_t(std::max(count, 0)));
    if (!formats.empty())
        gl.GetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    return {formats.begin(), formats.end()};
}

Context::Context(const AgaaContextDesc& common, const AgaaGlDeviceDesc& desc,
                 const std::optional<AgaaGlProgramCache>& cache)
    : AgaaContext_T(Backend::OpenGL, common), gl(loadFunctions(desc.getProcAddr, desc.getProcUser)),
      statePolicy(AgaaGlStatePolicy(desc.statePolicy)), pushState(desc.pushState), popState(desc.popState),
      stateUser(desc.stateUser), programs(driverOf(gl)) {
    dialect.openGl = true;
    dialect.glslVersion = desc.glslVersion;
    dialect.storageImages = desc.storage == AGAA_GL_STORAGE_IMAGES;
    dialect.constants = AgaaGlConstants(desc.constants);
    dialect.hostOutputs = desc.outputs == AGAA_GL_OUTPUTS_HOST;
    std::copy_n(desc.bindings, hostBindingCount, dialect.bindings.begin());
    notifiesReset_ = notifiesReset(gl);
    requireAlive();
    clearHostErrors("agaaGlCreateContext");
    caps = queryCaps(gl);
    if (dialect.hostOutputs) // outputs that the host declares cannot be read
        caps.flags &= ~AGAA_DEVICE_FRAMEBUFFER_FETCH;
    checkBindings(gl, dialect);
    binaryFormats = binaryFormatsOf(gl);
    keepsPrograms = cache && !binaryFormats.empty();
    if (cache && cache->size > 0) {
        const std::string reason = programs.read({static_cast<const std::byte*>(cache->data), size_t(cache->size)});
        if (!reason.empty())
            log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                      format("agaaGlCreateContext: AgaaGlProgramCache::data %s; it is not used.", reason.c_str()));
    }
    if (dialect.storageImages)
        limitToImages(gl, caps);
    guard.emplace(gl, scopeOf(dialect), isCompatibilityProfile(gl));
    checkErrors("creating the context"); // the probe below may remove errors
    if (statePolicy == AGAA_GL_STATE_CALLBACKS)
        hostBindings.emplace(gl, dialect, isCompatibilityProfile(gl));
    guard->capture();
    try {
        GLint bits = 0;
        gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
        timestampBits = uint32_t(std::clamp(bits, 0, 64));
        timeSource = probeTimer(gl, timestampBits) ? AGAA_TIME_DEVICE : AGAA_TIME_CPU_FINISH;
    } catch (...) {
        guard->restore();
        discardErrors(gl);
        throw;
    }
    guard->restore();
    try {
        createObjects();
        checkErrors("creating the context");
    } catch (...) {
        destroyObjects();
        discardErrors(gl);
        throw;
    }
}

Context::~Context() { destroyObjects(); }

void Context::createObjects() {
    createFill();
    gl.CreateSamplers(1, &shadowSampler);
    requireObject(gl, shadowSampler, "glCreateSamplers");
    label(GL_SAMPLER, shadowSampler, "agaa shadow sampler");
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.SamplerParameteri(shadowSampler, filter, GL_LINEAR);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.SamplerParameteri(shadowSampler, wrap, GL_CLAMP_TO_EDGE);
    gl.SamplerParameteri(shadowSampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.SamplerParameteri(shadowSampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl.CreateSamplers(1, &linearSampler);
    requireObject(gl, linearSampler, "glCreateSamplers");
    label(GL_SAMPLER, linearSampler, "agaa linear sampler");
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.SamplerParameteri(linearSampler, filter, GL_LINEAR);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl.SamplerParameteri(linearSampler, wrap, GL_CLAMP_TO_EDGE);
    gl.CreateSamplers(1, &texelSampler);
    requireObject(gl, texelSampler, "glCreateSamplers");
    label(GL_SAMPLER, texelSampler, "agaa texel sampler");
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.SamplerParameteri(texelSampler, filter, GL_NEAREST);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.SamplerParameteri(texelSampler, wrap, GL_CLAMP_TO_EDGE);
    gl.CreateFramebuffers(1, &emptyFramebuffer);
    requireObject(gl, emptyFramebuffer, "glCreateFramebuffers");
    label(GL_FRAMEBUFFER, emptyFramebuffer, "agaa no target");
    for (GLenum side : {GL_FRAMEBUFFER_DEFAULT_WIDTH, GL_FRAMEBUFFER_DEFAULT_HEIGHT})
        gl.NamedFramebufferParameteri(emptyFramebuffer, side, 1);
    gl.GetIntegerv(GL_MAX_DEBUG_GROUP_STACK_DEPTH, &maxDebugGroups);
    gl.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &emptyShadowMap);
    requireObject(gl, emptyShadowMap, "glCreateTextures");
    label(GL_TEXTURE, emptyShadowMap, "agaa no shadow");
    gl.TextureStorage3D(emptyShadowMap, 1, GL_DEPTH_COMPONENT16, 1, 1, 1);
}

void Context::createFill() {
    try {
        bufferFill.emplace(gl, !(caps.flags & AGAA_DEVICE_SOFTWARE));
    } catch (const Error& error) {
        if (error.code != AGAA_ERROR_DEVICE)
            throw;
        log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                  format("agaaGlCreateContext: buffers are cleared by the API: %s", error.message.c_str()));
        bufferFill.emplace(gl, false);
    }
}

void Context::destroyObjects() {
    bufferFill.reset();
    gl.DeleteSamplers(1, &shadowSampler);
    gl.DeleteSamplers(1, &texelSampler);
    gl.DeleteSamplers(1, &linearSampler);
    gl.DeleteFramebuffers(1, &emptyFramebuffer);
    gl.DeleteTextures(1, &emptyShadowMap);
}

void Context::label(GLenum kind, GLuint name, const std::string& text) const {
    gl.ObjectLabel(kind, name, GLsizei(text.size()), text.c_str());
}

void Context::clearHostErrors(const char* call, GLenum ours) const {
    // The loop is bounded because a lost context repeats its error forever.
    for (int i = 0; i < 16; ++i) {
        const GLenum error = gl.GetError();
        if (error == GL_NO_ERROR)
            return;
        if (error != ours)
            log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                      format("%s: error 0x%04X of an earlier call of the host's was pending.", call, error));
        else
            ours = GL_NO_ERROR;
    }
}

std::array<uint32_t, 4> Context::colorSampleMasks(uint32_t samples, uint32_t colorSamples) {
    guard->capture();
    std::array<uint32_t, 4> masks{};
    try {
        masks = probeColorSamples(gl, samples, colorSamples);
    } catch (...) {
        guard->restore();
        discardErrors(gl);
        throw;
    }
    guard->restore();
    uint32_t seen = 0;
    for (uint32_t i = 0; i < colorSamples; ++i) {
        if (masks[i] == 0 || masks[i] & seen)
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("the driver gives colour sample %u of %u no sample of %u that is its own.", i, colorSamples,
                        samples));
        seen |= masks[i];
    }
    return masks;
}

void Context::requireAlive() {
    // The value stays if the context is lost or not current, because its functions then have no effect (OpenGL 4.5,
    // 2.3.2).
    GLint size = -1;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    isLost_ = isLost_ || (notifiesReset_ && gl.GetGraphicsResetStatus() != GL_NO_ERROR);
    require(!isLost_ && size != -1, AGAA_ERROR_DEVICE, "the OpenGL context is lost, or not current.");
}

void Context::checkErrors(const char* what) const { gl::checkErrors(gl, what); }

} // namespace agaa::gl
