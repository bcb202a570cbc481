// AGAA_GL_STATE_CALLBACKS: callbacks that fail, each in turn.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

constexpr float untouched = 0.25f;

// The host's state is OpenGL's initial one: to restore it, the bindings that frames use are taken away.
void restoreInitial() {
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
    for (GLuint i = 0; i < 32; ++i) {
        glBindTextureUnit(i, 0);
        glBindSampler(i, 0);
    }
    for (GLuint i = 0; i < 8; ++i) {
        glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
        glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
    }
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

struct Callbacks {
    std::string order; // "+" for pushState, "-" for popState
    uint32_t failAt = 0; // the nth call from now on; 0: none
    AgaaResult failure = AGAA_ERROR_CALLBACK;

    AgaaResult result() { return failAt && --failAt == 0 ? failure : AgaaResult(AGAA_OK); }
    static AgaaResult AGAA_CALL push(void* user) {
        static_cast<Callbacks*>(user)->order += '+';
        return static_cast<Callbacks*>(user)->result();
    }
    static AgaaResult AGAA_CALL pop(void* user) {
        static_cast<Callbacks*>(user)->order += '-';
        restoreInitial();
        return static_cast<Callbacks*>(user)->result();
    }
};

// Whether each push has its pop.
bool isBalanced(const std::string& order) {
    for (size_t i = 0; i < order.size(); ++i)
        if (order[i] != (i % 2 ? '-' : '+'))
            return false;
    return order.size() % 2 == 0;
}

void testFailures(Test& test, AgaaResult failure) {
    Callbacks callbacks;
    callbacks.failure = failure;
    Rig rig(test, {}, [&](ContextDescription& d) {
        d.gl.statePolicy = AGAA_GL_STATE_CALLBACKS;
        d.gl.pushState = Callbacks::push;
        d.gl.popState = Callbacks::pop;
        d.gl.stateUser = &callbacks;
    });
    test.check(callbacks.order.empty(), "the callbacks are called before the first frame.");
    const Image image = rig.render();
    const std::string order = callbacks.order;
    test.require(order.size() >= 4 && isBalanced(order), "the order of pushState (+) and popState (-) is " + order + ".");
    for (uint32_t n = 1; n <= order.size(); ++n) {
        const bool isLast = n == order.size();
        const std::string what = "agaaGlRecordFrame, where " + std::string(order[n - 1] == '+' ? "pushState" : "popState") +
                                 ", call " + std::to_string(n) + " of " + std::to_string(order.size()) + ", fails";
        rig.device().fillOutput(untouched);
        rig.context.log.lines.clear();
        callbacks.order.clear();
        callbacks.failAt = n;
        AgaaFrame frame = rig.nextFrame();
        const AgaaResult result = rig.record(frame);
        expectRefused(test, result, AGAA_ERROR_CALLBACK, rig.context.log, "agaaGlRecordFrame", what);
        rig.expectNoMessages(what);
        const Image output = rig.device().readOutput();
        if (isLast) { // the last callback fails although the output is written
            expectSame(test, output, image, rig.description().desc.width, what + ": the output");
            rig.recorded = std::max(rig.recorded, frame.frameIndex);
        } else
            test.check(output == Image(output.size(), untouched), what + ", and changes the output.");
        callbacks.failAt = 0;
        restoreInitial();
        expectNextFrame(rig, image, what);
    }
}

} // namespace

void addOpenGlCallbackCases(Suite& suite) {
    suite.add("AGAA_GL_STATE_CALLBACKS/AGAA_ERROR_CALLBACK", {Backend::OpenGl}, [](Test& test) {
        testFailures(test, AGAA_ERROR_CALLBACK);
        testFailures(test, AGAA_NOT_READY);
    });
}

} // namespace agaa::conformance
