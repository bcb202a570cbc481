// Functions of OpenGL that fail while contexts and views are created or resized: each in turn.
#include "cases.h"
#include "frame_rig.h"
#include "gl_interposer.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

struct Fault {
    uint32_t error;
    AgaaResult expected;
};
constexpr Fault failure = {GL_INVALID_OPERATION, AGAA_ERROR_DEVICE};
constexpr Fault outOfMemory = {GL_OUT_OF_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};

// Calls while the nth allocation fails, for every n, until none fails. The objects that exist must be those of before.
void forEachFunction(Test& test, OpenGlInterposer& gl, const Fault& fault, const std::string& function, LogRecorder& log,
                     const std::function<AgaaResult()>& call, const std::function<void(const std::string&)>& after) {
    const std::map<std::string, int64_t> before = gl.objects;
    for (uint32_t n = 1;; ++n) {
        gl.failAt(n, fault.error);
        const AgaaResult result = call();
        const std::string failed = gl.failed();
        gl.failAt(0, GL_NO_ERROR);
        if (failed.empty()) {
            test.result(result, AGAA_OK, function + " after " + std::to_string(n - 1) + " calls that failed");
            test.check(n > 1, function + " allocates nothing.");
            return;
        }
        const std::string what = function + ", where allocation " + std::to_string(n) + ", " + failed + ", fails";
        expectRefused(test, result, fault.expected, log, function, what);
        test.check(gl.objects == before,
                   what + ": there are " + objectsText(gl.objects) + " where there were " + objectsText(before) + ".");
        test.device().takeMessages(); // of the objects without memory
        after(what);
    }
}

void testContext(Test& test, const Fault& fault) {
    OpenGlInterposer gl;
    LogRecorder log;
    AgaaContext context = untouchedHandle<AgaaContext>();
    const auto create = [&] {
        ContextDescription description = test.device().description();
        description.desc.log = log.get();
        gl.chainTo(description);
        return test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
    };
    forEachFunction(test, gl, fault, "agaaGlCreateContext", log, create, [&](const std::string& what) {
        test.check(context == untouchedHandle<AgaaContext>(), what + ", changes outContext.");
    });
    if (context == untouchedHandle<AgaaContext>())
        return;
    test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
    test.check(gl.objects.empty(), "a context leaves " + objectsText(gl.objects) + ".");
}

void testView(Test& test, const Fault& fault) {
    OpenGlInterposer gl;
    OwnContext context(test, [&](ContextDescription& d) { gl.chainTo(d); });
    const std::map<std::string, int64_t> before = gl.objects;
    ViewDescription description(&test.device());
    description.config.flags |= AGAA_CONFIG_TIMESTAMPS;
    AgaaView view = untouchedHandle<AgaaView>();
    forEachFunction(
        test, gl, fault, "agaaGlCreateView", context.log,
        [&] { return test.device().createView(test.sdk, context.get(), &description.desc, &view); },
        [&](const std::string& what) { test.check(view == untouchedHandle<AgaaView>(), what + ", changes outView."); });
    if (view == untouchedHandle<AgaaView>())
        return;
    test.sdk.agaaDestroyView(view);
    test.check(gl.objects == before, "agaaDestroyView leaves " + objectsText(gl.objects) + ".");
}

void testResize(Test& test, const Fault& fault) {
    OpenGlInterposer gl;
    Rig rig(test, {}, [&](ContextDescription& d) { gl.chainTo(d); });
    const Image image = rig.render();
    forEachFunction(
        test, gl, fault, "agaaResizeView", rig.context.log, [&] { return test.sdk.agaaResizeView(rig.view.get(), 48, 40); },
        [&](const std::string& what) { expectNextFrame(rig, image, what); });
}

// Framebuffers that the driver cannot draw to.
void testIncomplete(Test& test, bool isResize) {
    OpenGlInterposer gl;
    Rig rig(test, {}, [&](ContextDescription& d) { gl.chainTo(d); });
    const Image image = rig.render();
    const std::map<std::string, int64_t> before = gl.objects;
    gl.isComplete = false;
    AgaaView view = nullptr;
    ViewDescription description(&test.device());
    const std::string function = isResize ? "agaaResizeView" : "agaaGlCreateView";
    const AgaaResult result = isResize
                                  ? test.sdk.agaaResizeView(rig.view.get(), 48, 40)
                                  : test.device().createView(test.sdk, rig.context.get(), &description.desc, &view);
    gl.isComplete = true;
    const std::string what = function + " where framebuffers are not complete";
    expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, rig.context.log, function, what);
    test.check(gl.objects == before, what + ": there are " + objectsText(gl.objects) + " where there were " +
                                         objectsText(before) + ".");
    expectNextFrame(rig, image, what);
}

} // namespace

void addOpenGlFaultCases(Suite& suite) {
    const auto gl = [&](const char* name, std::function<void(Test&)> run) { suite.add(name, {Backend::OpenGl}, std::move(run)); };
    gl("agaaGlCreateContext/AGAA_ERROR_DEVICE", [](Test& test) { testContext(test, failure); });
    gl("agaaGlCreateContext/AGAA_ERROR_OUT_OF_MEMORY", [](Test& test) { testContext(test, outOfMemory); });
    gl("agaaGlCreateView/AGAA_ERROR_DEVICE", [](Test& test) { testView(test, failure); });
    gl("agaaGlCreateView/AGAA_ERROR_OUT_OF_MEMORY", [](Test& test) { testView(test, outOfMemory); });
    gl("agaaResizeView/AGAA_ERROR_DEVICE/opengl", [](Test& test) { testResize(test, failure); });
    gl("agaaResizeView/AGAA_ERROR_OUT_OF_MEMORY/opengl", [](Test& test) { testResize(test, outOfMemory); });
    gl("agaaResizeView/AGAA_ERROR_UNSUPPORTED/opengl", [](Test& test) { testIncomplete(test, true); });
    gl("agaaGlCreateView/AGAA_ERROR_UNSUPPORTED/framebuffers", [](Test& test) { testIncomplete(test, false); });
}

} // namespace agaa::conformance
