// agaaGetSurface.
#include "cases.h"
#include "frame_rig.h"

#include <cstring>
#include <map>

namespace agaa::conformance {

namespace {

struct Native {
    AgaaVkSurface vk;
    AgaaGlSurface gl;
    Native() {
        const AgaaVkSurface initialVk = AGAA_VK_SURFACE_INIT;
        const AgaaGlSurface initialGl = AGAA_GL_SURFACE_INIT;
        vk = initialVk;
        gl = initialGl;
    }
    void* of(Backend backend) { return backend == Backend::Vulkan ? static_cast<void*>(&vk) : &gl; }
};

Backend other(Backend backend) { return backend == Backend::Vulkan ? Backend::OpenGl : Backend::Vulkan; }

struct SurfaceArguments {
    AgaaView view = nullptr;
    const char* name = "depth";
    AgaaSurface surface = AGAA_SURFACE_INIT;
    AgaaSurface* out = &surface;
    Native native;
    AgaaStructHeader unknown = {farStructType, sizeof(AgaaStructHeader), nullptr};
};

struct WrongSurfaceCall {
    std::string what;
    AgaaResult code;
    std::function<void(SurfaceArguments&, Backend)> corrupt;
};

const std::vector<WrongSurfaceCall>& wrongSurfaceCalls() {
    static const std::vector<WrongSurfaceCall> calls = {
        {"a null view", AGAA_ERROR_INVALID_ARGUMENT, [](SurfaceArguments& a, Backend) { a.view = nullptr; }},
        {"a null name", AGAA_ERROR_INVALID_ARGUMENT, [](SurfaceArguments& a, Backend) { a.name = nullptr; }},
        {"a null surface", AGAA_ERROR_INVALID_ARGUMENT, [](SurfaceArguments& a, Backend) { a.out = nullptr; }},
        {"an unknown name", AGAA_ERROR_INVALID_ARGUMENT,
         [](SurfaceArguments& a, Backend) { a.name = "no such surface"; }},
        {"an empty name", AGAA_ERROR_INVALID_ARGUMENT, [](SurfaceArguments& a, Backend) { a.name = ""; }},
        {"a name of other case", AGAA_ERROR_INVALID_ARGUMENT, [](SurfaceArguments& a, Backend) { a.name = "Depth"; }},
        {"a surface of another type", AGAA_ERROR_STRUCT,
         [](SurfaceArguments& a, Backend) { a.surface.sType = AGAA_STRUCTURE_TYPE_TARGET; }},
        {"a surface of structSize 8", AGAA_ERROR_STRUCT,
         [](SurfaceArguments& a, Backend) { a.surface.structSize = 8; }},
        {"a chained struct of structSize 8", AGAA_ERROR_STRUCT,
         [](SurfaceArguments& a, Backend backend) {
             a.native.vk.structSize = a.native.gl.structSize = 8;
             a.surface.pNext = a.native.of(backend);
         }},
        {"the struct of the other API chained", AGAA_ERROR_UNKNOWN_STRUCT,
         [](SurfaceArguments& a, Backend backend) { a.surface.pNext = a.native.of(other(backend)); }},
        {"an unknown struct chained", AGAA_ERROR_UNKNOWN_STRUCT,
         [](SurfaceArguments& a, Backend) { a.surface.pNext = &a.unknown; }}};
    return calls;
}

// Runs the calls that fail with `code`; AGAA_OK selects all calls.
void testSurfaceCalls(Test& test, AgaaResult code) {
    ScopedContext context(test);
    const ViewDescription description(&test.device());
    const BareView view(test, context.get(), description);
    const Backend backend = test.device().backend();
    for (const WrongSurfaceCall& call : wrongSurfaceCalls()) {
        if (code != AGAA_OK && call.code != code)
            continue;
        SurfaceArguments a;
        a.view = view.get();
        call.corrupt(a, backend);
        AgaaSurface before;
        Native nativeBefore;
        std::memcpy(&before, &a.surface, sizeof before);
        std::memcpy(&nativeBefore, &a.native, sizeof nativeBefore);
        context.log.lines.clear();
        const AgaaResult result = test.sdk.agaaGetSurface(a.view, a.name, a.out);
        const std::string what = "agaaGetSurface with " + call.what;
        if (a.view)
            expectRefused(test, result, call.code, context.log, "agaaGetSurface", what);
        else
            test.result(result, call.code, what);
        test.check(!std::memcmp(&before, &a.surface, sizeof before), what + " fails and changes outSurface.");
        test.check(!std::memcmp(&nativeBefore, &a.native, sizeof nativeBefore),
                   what + " fails and changes a chained struct.");
    }
}

struct Listed {
    AgaaSurface predicted, got;
    Native native;
    std::string what;
};

void listSurfaces(Test& test, const ScopedContext& context, const AgaaDeviceCaps& caps, const std::string& technique,
                  std::vector<Listed>& list) {
    ViewDescription description(&test.device());
    setTechnique(description, technique, 4);
    const BareView view(test, context.get(), description);
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, nullptr, &count, nullptr),
                   "agaaQueryMemory");
    std::vector<AgaaSurface> predicted(count, initial);
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, nullptr, &count, predicted.data()),
                   "agaaQueryMemory");
    bool hasDepth = false;
    for (const AgaaSurface& surface : predicted) {
        if (!surface.isPerPixel)
            continue;
        hasDepth = hasDepth || !std::strcmp(surface.name, "depth");
        Native native;
        AgaaSurface got = initial;
        got.pNext = native.of(test.device().backend());
        const std::string what = "the surface " + std::string(surface.name) + " of \"" + technique + "\"";
        if (test.result(test.sdk.agaaGetSurface(view.get(), surface.name, &got), AGAA_OK, "agaaGetSurface for " + what))
            list.push_back({surface, got, native, what});
    }
    test.check(hasDepth != hasCoverageSamples(technique),
               "\"" + technique + (hasDepth ? "\" has a surface depth." : "\" has no surface depth."));
}

using Visit =
    std::function<void(const AgaaSurface& predicted, const AgaaSurface& got, const Native&, const std::string& what)>;

// All surfaces of agaaQueryMemory with isPerPixel 1, for each technique. They are listed once for all tests of a
// device.
void forSurfaces(Test& test, const Visit& visit) {
    static std::map<Backend, std::vector<Listed>> listed;
    std::vector<Listed>& list = listed[test.device().backend()];
    if (list.empty()) {
        const ScopedContext context(test);
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "the capabilities of the context");
        for (const std::string& technique : techniques(test))
            listSurfaces(test, context, caps, technique, list);
    }
    for (const Listed& surface : list)
        visit(surface.predicted, surface.got, surface.native, surface.what);
}

void testPredicted(Test& test) {
    forSurfaces(test, [&](const AgaaSurface& predicted, AgaaSurface got, const Native&, const std::string& what) {
        got.pNext = nullptr;
        test.check(!std::memcmp(&predicted, &got, sizeof got), what + " differs from that of agaaQueryMemory.");
    });
}

void testHandles(Test& test) {
    const bool isVk = test.device().backend() == Backend::Vulkan;
    forSurfaces(test,
                [&](const AgaaSurface& surface, const AgaaSurface&, const Native& native, const std::string& what) {
                    const bool isBuffer = !surface.format[0];
                    const bool hasImage = isVk ? native.vk.image && native.vk.view && native.vk.format
                                               : native.gl.texture && native.gl.format;
                    const bool hasBuffer = isVk ? native.vk.buffer != 0 : native.gl.buffer != 0;
                    test.check(isBuffer ? hasBuffer && !hasImage : hasImage && !hasBuffer,
                               what + " has no handle, or one that does not fit its format.");
                });
}

void testReservedOfSurfaces(Test& test) {
    forSurfaces(test, [&](const AgaaSurface&, const AgaaSurface& got, const Native& native, const std::string& what) {
        test.check(native.gl.reserved == 0, what + ": AgaaGlSurface::reserved is not 0.");
        test.check(got.reserved == 0, what + ": AgaaSurface::reserved is not 0.");
    });
}

} // namespace

void addSurfaceCases(Suite& suite) {
    suite.both("agaaGetSurface/AGAA_ERROR_INVALID_ARGUMENT",
               [](Test& test) { testSurfaceCalls(test, AGAA_ERROR_INVALID_ARGUMENT); });
    suite.both("agaaGetSurface/AGAA_ERROR_STRUCT", [](Test& test) { testSurfaceCalls(test, AGAA_ERROR_STRUCT); });
    suite.both("agaaGetSurface/AGAA_ERROR_UNKNOWN_STRUCT",
               [](Test& test) { testSurfaceCalls(test, AGAA_ERROR_UNKNOWN_STRUCT); });
    suite.both("agaaGetSurface/outSurface.unchanged", [](Test& test) { testSurfaceCalls(test, AGAA_OK); });
    suite.add("AgaaGlSurface.reserved/zero", {Backend::OpenGl}, testReservedOfSurfaces);
    suite.both("general/surfaces_are_as_predicted", testPredicted);
    suite.both("general/surfaces_have_handles", testHandles);
}

} // namespace agaa::conformance
