// The OpenGL part of the C ABI.
#include "core/abi/backend_api.h"
#include "core/abi/init.h"
#include "core/base/error.h"
#include "core/plan/planner.h"
#include "gl/bindings.h"
#include "gl/structs.h"
#include "gl/view.h"

#include <cstring>

using namespace agaa;

namespace {

void checkBindings(const AgaaGlDeviceDesc& desc) {
    for (uint32_t i = AGAA_GL_BINDING_COUNT; i < AGAA_GL_MAX_BINDINGS; ++i)
        checkReserved(desc.bindings[i], format("AgaaGlDeviceDesc::bindings[%u]", i).c_str());
    HostDialect dialect;
    dialect.storageImages = desc.storage == AGAA_GL_STORAGE_IMAGES;
    dialect.constants = AgaaGlConstants(desc.constants);
    // Both kinds of storage buffers share the binding points.
    const auto pointsOf = [&](const BindingRow& row) {
        const auto kind = gl::hostKind(row, dialect);
        return kind == BindingKind::WrittenStorage ? BindingKind::Storage : kind;
    };
    for (const BindingRow& a : hostBindingTable)
        for (const BindingRow& b : hostBindingTable)
            if (a.slot < b.slot && pointsOf(a) && pointsOf(a) == pointsOf(b) &&
                desc.bindings[a.slot] == desc.bindings[b.slot])
                fail(AGAA_ERROR_INVALID_ARGUMENT,
                     format("AgaaGlDeviceDesc::bindings has the same place for AGAA_GL_BINDING_%s and "
                            "AGAA_GL_BINDING_%s.",
                            a.macro, b.macro));
}

void checkDevice(const AgaaGlDeviceDesc& desc) {
    require(desc.getProcAddr, AGAA_ERROR_INVALID_ARGUMENT, "AgaaGlDeviceDesc::getProcAddr is null.");
    constexpr uint32_t versions[] = {330, 400, 410, 420, 430, 440, 450, 460};
    bool known = false;
    for (uint32_t version : versions)
        known |= desc.glslVersion == version;
    require(known, AGAA_ERROR_OUT_OF_RANGE, "AgaaGlDeviceDesc::glslVersion is not a version of GLSL from 330 to 460.");
    checkRange(uint64_t(desc.storage), 0, AGAA_GL_STORAGE_IMAGES, "AgaaGlDeviceDesc::storage");
    checkRange(uint64_t(desc.constants), 0, AGAA_GL_CONSTANTS_TEXELS, "AgaaGlDeviceDesc::constants");
    checkRange(uint64_t(desc.outputs), 0, AGAA_GL_OUTPUTS_HOST, "AgaaGlDeviceDesc::outputs");
    checkRange(uint64_t(desc.statePolicy), 0, AGAA_GL_STATE_NONE, "AgaaGlDeviceDesc::statePolicy");
    checkBindings(desc);
    const bool callbacks = desc.statePolicy == AGAA_GL_STATE_CALLBACKS;
    require(!callbacks || (desc.pushState && desc.popState), AGAA_ERROR_INVALID_ARGUMENT,
            "AGAA_GL_STATE_CALLBACKS needs AgaaGlDeviceDesc::pushState and popState.");
}

} // namespace

extern "C" {

#define AGAA_GL_STRUCT AGAA_INIT_FUNCTION
#include "core/base/structs.inc"

AgaaResult AGAA_CALL agaaGlCreateContext(uint32_t headerVersion, const AgaaContextDesc* desc, AgaaContext* outContext) {
    return guarded(logOfDesc(desc), "agaaGlCreateContext", [&]() -> AgaaResult {
        checkHeaderVersion(headerVersion);
        require(outContext, AGAA_ERROR_INVALID_ARGUMENT, "the context pointer is null.");
        const AgaaContextDesc common =
            readContextDesc(desc, {AGAA_STRUCTURE_TYPE_GL_DEVICE_DESC, AGAA_STRUCTURE_TYPE_GL_PROGRAM_CACHE});
        const AgaaGlDeviceDesc device = readDeviceDesc<AgaaGlDeviceDesc>(common);
        checkDevice(device);
        const std::optional<AgaaGlProgramCache> cache = readChained<AgaaGlProgramCache>(&common);
        require(!cache || cache->size == 0 || cache->data, AGAA_ERROR_INVALID_ARGUMENT,
                "AgaaGlProgramCache::data is null.");
        *outContext =
            construct<gl::Context>({common.allocate, common.free, common.allocateUser}, common, device, cache);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlGetContextCaps(AgaaContext context, AgaaDeviceCaps* outCaps) {
    return writeContextCaps("agaaGlGetContextCaps", context, Backend::OpenGL, outCaps);
}

AgaaResult AGAA_CALL agaaGlGetProgramCache(AgaaContext context, size_t* size, void* data) {
    return guarded(logOf(context), "agaaGlGetProgramCache", [&]() -> AgaaResult {
        requireBackend(context, Backend::OpenGL);
        require(size, AGAA_ERROR_INVALID_ARGUMENT, "the size pointer is null.");
        const std::vector<std::byte> bytes = static_cast<gl::Context&>(*context).programs.bytes();
        if (data) {
            require(*size >= bytes.size(), AGAA_ERROR_BUFFER_TOO_SMALL, "the buffer is too small.");
            std::memcpy(data, bytes.data(), bytes.size());
        }
        *size = bytes.size();
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlCreateView(AgaaContext context, const AgaaViewDesc* desc, AgaaView* outView) {
    return guarded(logOf(context), "agaaGlCreateView", [&]() -> AgaaResult {
        requireBackend(context, Backend::OpenGL);
        require(outView, AGAA_ERROR_INVALID_ARGUMENT, "the view pointer is null.");
        const ViewSettings settings = resolveView(desc, techniques());
        *outView = createView<gl::View>(static_cast<gl::Context&>(*context), settings, settings);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaGlRecordFrame(AgaaView view, const AgaaFrame* frame, const AgaaGlFrame* glFrame) {
    return guarded(logOf(view), "agaaGlRecordFrame", [&]() -> AgaaResult {
        requireBackend(view, Backend::OpenGL);
        return static_cast<gl::View*>(view->current)
            ->record(readStruct(frame, {AGAA_STRUCTURE_TYPE_TEMPORAL_FRAME}),
                     readStruct(glFrame, {AGAA_STRUCTURE_TYPE_GL_RESOLVED_TEXTURES}));
    });
}

} // extern "C"
