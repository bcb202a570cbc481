// OpenGL contexts that the SDK cannot use: none, old ones, those without an extension, and those with incomplete
// framebuffers.
#include "cases.h"
#include "frame_rig.h"
#include "gl_interposer.h"

#include <EGL/egl.h>

namespace agaa::conformance {

namespace {

// No context is current during the lifetime of this object.
class NoContext {
public:
    NoContext() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    ~NoContext() { eglMakeCurrent(display_, draw_, read_, context_); }

private:
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLSurface draw_ = eglGetCurrentSurface(EGL_DRAW), read_ = eglGetCurrentSurface(EGL_READ);
    EGLContext context_ = eglGetCurrentContext();
};

struct OtherContext {
    std::string what, version, hidden, missing, words;
    bool isAccepted;
};

const std::vector<OtherContext>& otherContexts() {
    static const std::string access = "GL_ARB_direct_state_access";
    static const std::vector<OtherContext> all = {
        {"a context of OpenGL 4.2", "4.2 of the suite", "", "", "4.2", false},
        {"a context of OpenGL 3.3", "3.3 of the suite", "", "", "3.3", false},
        {"a context of OpenGL 4.3 without " + access, "4.3 of the suite", access, "", access, false},
        {"a context of OpenGL 4.4 without " + access, "4.4 of the suite", access, "", access, false},
        {"a context of OpenGL 4.3 with " + access, "4.3 of the suite", "", "", "", true},
        {"a getProcAddr that finds no function", "", "", "*", "", false},
        {"a getProcAddr that does not find glGetString", "", "", "glGetString", "", false},
        {"a getProcAddr that does not find glCreateSamplers", "", "", "glCreateSamplers", "glCreateSamplers", false},
        {"a getProcAddr that does not find glDispatchCompute", "", "", "glDispatchCompute", "glDispatchCompute",
         false}};
    return all;
}

// `call` creates an object and destroys it again.
void testUnsupported(Test& test, const std::string& function,
                     const std::function<AgaaResult(ContextDescription&, const AgaaLog*)>& call) {
    for (const OtherContext& other : otherContexts()) {
        OpenGlInterposer gl;
        gl.version = other.version;
        gl.hiddenExtension = other.hidden;
        gl.missing = other.missing;
        ContextDescription description = test.device().description();
        gl.chainTo(description);
        LogRecorder log;
        const AgaaResult result = call(description, log.get());
        const std::string what = function + " with " + other.what;
        if (other.isAccepted)
            test.result(result, AGAA_OK, what);
        else
            expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, log, function, what, other.words);
        test.check(gl.objects.empty(), what + " leaves " + objectsText(gl.objects) + ".");
    }
    LogRecorder log;
    ContextDescription description = test.device().description();
    const NoContext none;
    expectRefused(test, call(description, log.get()), AGAA_ERROR_UNSUPPORTED, log, function,
                  function + " while no context is current");
}

void testContextUnsupported(Test& test) {
    testUnsupported(test, "agaaGlCreateContext", [&](ContextDescription& d, const AgaaLog* log) {
        d.desc.log = log;
        AgaaContext context = untouchedHandle<AgaaContext>();
        const AgaaResult result = test.device().createContext(test.sdk, AGAA_HEADER_VERSION, d, &context);
        if (result == AGAA_OK)
            test.sdk.agaaDestroyContext(context);
        else
            test.check(context == untouchedHandle<AgaaContext>(), "agaaGlCreateContext fails and changes outContext.");
        return result;
    });
}

void testCapsUnsupported(Test& test) {
    testUnsupported(test, "agaaGlGetDeviceCaps", [&](ContextDescription& d, const AgaaLog* log) {
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        caps.maxImageSize = 77;
        const AgaaResult result = test.sdk.agaaGlGetDeviceCaps(d.gl.getProcAddr, d.gl.getProcUser, log, &caps);
        test.check(result == AGAA_OK || caps.maxImageSize == 77, "agaaGlGetDeviceCaps fails and changes outCaps.");
        return result;
    });
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
    test.check(gl.objects == before,
               what + ": there are " + objectsText(gl.objects) + " where there were " + objectsText(before) + ".");
    expectNextFrame(rig, image, what);
}

} // namespace

void addOpenGlUnsupportedCases(Suite& suite) {
    suite.add("agaaGlCreateContext/AGAA_ERROR_UNSUPPORTED", {Backend::OpenGl}, testContextUnsupported);
    suite.add("agaaGlGetDeviceCaps/AGAA_ERROR_UNSUPPORTED", {Backend::OpenGl}, testCapsUnsupported);
    suite.add("agaaGlCreateView/AGAA_ERROR_UNSUPPORTED/framebuffers", {Backend::OpenGl},
              [](Test& test) { testIncomplete(test, false); });
    suite.add("agaaResizeView/AGAA_ERROR_UNSUPPORTED/opengl", {Backend::OpenGl},
              [](Test& test) { testIncomplete(test, true); });
}

} // namespace agaa::conformance
