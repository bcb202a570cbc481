// OpenGL errors of the host that are pending when it calls the SDK.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

// Functions that create and resize report such an error, but do not fail.
void testCreation(Test& test, const std::string& function) {
    ScopedContext context(test);
    ViewDescription description(&test.device());
    ScopedView view(test, context.get(), description);
    context.log.lines.clear();
    test.device().takeMessages();
    LogRecorder otherLog;
    AgaaContext otherContext = nullptr;
    AgaaView otherView = nullptr;
    AgaaResult result = AGAA_OK;
    glEnable(0xFFFF); // GL_INVALID_ENUM
    if (function == "agaaGlCreateContext") {
        ContextDescription d = test.device().description();
        d.desc.log = otherLog.get();
        result = test.device().createContext(test.sdk, AGAA_HEADER_VERSION, d, &otherContext);
    } else if (function == "agaaGlCreateView")
        result = test.device().createView(test.sdk, context.get(), &description.desc, &otherView);
    else
        result = test.sdk.agaaResizeView(view.get(), 48, 40);
    test.result(result, AGAA_OK, function + " after an error of the host");
    const std::vector<LogLine>& lines = otherContext ? otherLog.lines : context.log.lines;
    test.check(lines.size() == 1 && lines[0].severity == AGAA_SEVERITY_WARNING && lines[0].code == AGAA_OK &&
                   lines[0].text.find("0500") != std::string::npos,
               function + " after GL_INVALID_ENUM does not report this error alone, as a warning" +
                   (lines.empty() ? "." : ": " + lines[0].text));
    test.check(glGetError() == GL_NO_ERROR, function + " reports an error of the host, and leaves it.");
    test.device().takeMessages();
    test.sdk.agaaDestroyView(otherView);
    test.sdk.agaaDestroyContext(otherContext);
}

// Frames leave the error to the host, and add none.
void testFrame(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    GLenum first = GL_NO_ERROR, second = GL_NO_ERROR;
    const auto hook = [&](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
        glEnable(0xFFFF);
        const AgaaResult recorded = call(view, f, native);
        first = glGetError();
        second = glGetError();
        return recorded;
    };
    const AgaaResult result = rig.record(frame, hook);
    rig.device().takeMessages(); // removes the message of the error
    test.requireOk(result, rig.function() + " while an OpenGL error is pending");
    test.check(first == GL_INVALID_ENUM, "an OpenGL error that was pending before a frame is lost.");
    test.check(second == GL_NO_ERROR, "a frame leaves an OpenGL error.");
    expectSame(test, rig.device().readOutput(), expected, 32, "a frame while an OpenGL error is pending");
}

} // namespace

void addOpenGlPendingErrorCases(Suite& suite) {
    for (const std::string function : {"agaaGlCreateContext", "agaaGlCreateView", "agaaResizeView"})
        suite.add(function + "/pending_errors", {Backend::OpenGl}, [=](Test& test) { testCreation(test, function); });
    suite.add("general/opengl_errors_remain", {Backend::OpenGl}, testFrame);
}

} // namespace agaa::conformance
