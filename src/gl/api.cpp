// The OpenGL part of the C ABI.
#include "core/backend_api.h"
#include "gl/bindings.h"
#include "gl/formats.h"
#include "gl/view.h"

using namespace agaa;

namespace {

void checkBindings(const AgaaGlContextDesc& desc) {
    for (uint32_t i = AGAA_GL_BINDING_COUNT; i < AGAA_GL_MAX_BINDINGS; ++i)
        if (desc.bindings[i] != 0)
            fail(AGAA_ERROR_OUT_OF_RANGE, format("AgaaGlContextDesc::bindings[%u] is not 0.", i));
    const auto kind = [&](const BindingRow& row) {
        const BindingKind own = gl::hostKind(row, desc.storage == AGAA_GL_STORAGE_IMAGES);
        return own == BindingKind::WrittenStorage ? BindingKind::Storage : own;
    };
    for (const BindingRow& a : hostBindingTable)
        for (const BindingRow& b : hostBindingTable)
            if (a.slot < b.slot && kind(a) == kind(b) && desc.bindings[a.slot] == desc.bindings[b.slot])
                fail(AGAA_ERROR_INVALID_ARGUMENT,
                     format("AgaaGlContextDesc::bindings has the same place for AGAA_GL_BINDING_%s and "
                            "AGAA_GL_BINDING_%s.",
                            a.macro, b.macro));
}

void checkContextDesc(const AgaaGlContextDesc* pointer) {
    const AgaaGlContextDesc& desc =
        checkStruct(pointer, AGAA_STRUCTURE_TYPE_GL_CONTEXT, "AgaaGlContextDesc");
    require(desc.getProcAddr, AGAA_ERROR_INVALID_ARGUMENT, "AgaaGlContextDesc::getProcAddr is null.");
    constexpr uint32_t versions[] = {330, 400, 410, 420, 430, 440, 450, 460};
    bool known = false;
    for (uint32_t version : versions)
        known |= desc.glslVersion == version;
    require(known, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaGlContextDesc::glslVersion is not a version of GLSL from 330 to 460.");
    checkRange(uint64_t(desc.storage), 0, AGAA_GL_STORAGE_IMAGES, "AgaaGlContextDesc::storage");
    checkRange(uint64_t(desc.outputs), 0, AGAA_GL_OUTPUTS_HOST, "AgaaGlContextDesc::outputs");
    checkRange(uint64_t(desc.statePolicy), 0, AGAA_GL_STATE_NONE, "AgaaGlContextDesc::statePolicy");
    checkBindings(desc);
    const bool callbacks = desc.statePolicy == AGAA_GL_STATE_CALLBACKS;
    require(!callbacks || (desc.pushState && desc.popState), AGAA_ERROR_INVALID_ARGUMENT,
            "AGAA_GL_STATE_CALLBACKS needs AgaaGlContextDesc::pushState and popState.");
    checkContextCommons(desc, "AgaaGlContextDesc");
}

void describe(const gl::View& view, size_t index, AgaaGlDrawPass& out) {
    const Plan& plan = view.plan;
    const Pass& pass = plan.passes[index];
    const gl::PassObjects& objects = view.passes[index];
    out.pipelineKey = objects.key;
    out.framebuffer = objects.framebuffer;
    for (size_t i = 0; i < 4; ++i)
        out.colorFormats[i] = i < pass.colorTargets.size()
                                  ? gl::internalFormat(plan.resources[pass.colorTargets[i]].format)
                                  : 0;
    out.depthStencilFormat =
        pass.depthTarget != noResource ? gl::internalFormat(plan.resources[pass.depthTarget].format) : GL_NONE;
    out.glslExtensions = objects.extensions.c_str();
    out.glslDeclarations = objects.declarations.c_str();
    out.glslGeometry = objects.geometry.empty() ? nullptr : objects.geometry.c_str();
}

void describe(const gl::View& view, ResourceId id, AgaaGlSurface& out) {
    const gl::GpuResource& objects = (*view.resources)[id];
    describeSurface(view.plan, id, out);
    out.texture = objects.texture;
    out.buffer = objects.buffers.empty() ? 0 : objects.buffers[0];
    out.format = gl::internalFormat(view.plan.resources[id].format);
}

} // namespace

extern "C" {

AgaaResult AGAA_CALL agaaGlCreateContext(uint32_t headerVersion, const AgaaGlContextDesc* desc,
                                         AgaaContext* outContext) {
    return createContext<gl::Context>("agaaGlCreateContext", headerVersion, desc, outContext,
                                      checkContextDesc);
}

AgaaResult AGAA_CALL agaaGlGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps) {
    return writeContextCaps("agaaGlGetContextCaps", context, Backend::OpenGL, outCaps);
}

AgaaResult AGAA_CALL agaaGlCreateView(AgaaContext context, const AgaaViewDesc* desc,
                                      AgaaView* outView) {
    return guarded(logOf(context), "agaaGlCreateView", [&]() -> AgaaResult {
        requireBackend(context, Backend::OpenGL);
        require(outView, AGAA_ERROR_INVALID_ARGUMENT, "the view pointer is null.");
        const ViewSettings settings = resolveView(desc);
        *outView = construct<gl::View>(context->allocator, static_cast<gl::Context&>(*context), settings);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlGetDrawPasses(AgaaView view, uint32_t* count, AgaaGlDrawPass* passes) {
    return guarded(logOf(view), "agaaGlGetDrawPasses", [&]() -> AgaaResult {
        requireBackend(view, Backend::OpenGL);
        return writeDrawPasses(view->plan, count, passes, AGAA_STRUCTURE_TYPE_GL_DRAW_PASS,
                               "AgaaGlDrawPass", [&](size_t index, AgaaGlDrawPass& out) {
                                   describe(static_cast<const gl::View&>(*view), index, out);
                               });
    });
}

AgaaResult AGAA_CALL agaaGlGetSurface(AgaaView view, const char* name, AgaaGlSurface* outSurface) {
    return guarded(logOf(view), "agaaGlGetSurface", [&]() -> AgaaResult {
        requireBackend(view, Backend::OpenGL);
        require(name, AGAA_ERROR_INVALID_ARGUMENT, "the name is null.");
        checkStruct(outSurface, AGAA_STRUCTURE_TYPE_GL_SURFACE, "AgaaGlSurface");
        describe(static_cast<const gl::View&>(*view), view->plan.surface(name), *outSurface);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlRecordFrame(AgaaView view, const AgaaFrame* frame,
                                       const AgaaGlFrame* glFrame) {
    return guarded(logOf(view), "agaaGlRecordFrame", [&]() -> AgaaResult {
        requireBackend(view, Backend::OpenGL);
        require(frame && glFrame, AGAA_ERROR_INVALID_ARGUMENT, "a pointer is null.");
        return static_cast<gl::View*>(view)->record(*frame, *glFrame);
    });
}

} // extern "C"
