// AGAA_GL_STATE_CALLBACKS: the order of the host's callbacks, and callbacks that fail one after the other.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "gl_state.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

// The host has OpenGL's initial state. The callback restores it by removing the bindings that frames use.
void restoreInitial() {
    setHarmlessState();
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
    Device& device;
    std::string order = {}; // a letter per call: + pushState, - popState, d draw callback
    uint32_t failAt = 0;    // index of the failing call of pushState and popState from now on; 0: none
    AgaaResult failure = AGAA_ERROR_CALLBACK;

    AgaaResult result() { return failAt && --failAt == 0 ? failure : AgaaResult(AGAA_OK); }
    static AgaaResult AGAA_CALL push(void* user) {
        auto& self = *static_cast<Callbacks*>(user);
        self.order += '+';
        return self.result();
    }
    static AgaaResult AGAA_CALL pop(void* user) {
        auto& self = *static_cast<Callbacks*>(user);
        self.order += '-';
        restoreInitial();
        return self.result();
    }
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<Callbacks*>(user);
        self.order += 'd';
        return self.device.draw(*target);
    }
    void use(AgaaFrame& frame) {
        order.clear();
        frame.draw = draw;
        frame.drawUser = this;
    }
    Rig::ChangeContext change() {
        return [this](ContextDescription& d) {
            d.gl.statePolicy = AGAA_GL_STATE_CALLBACKS;
            d.gl.pushState = push;
            d.gl.popState = pop;
            d.gl.stateUser = this;
        };
    }
};

// The SDK calls pushState on entry and after each draw callback, and popState before each draw callback and before the
// end.
std::string promisedOrder(Rig& rig) {
    std::string order = "+-";
    for (uint32_t i = 0; i < rig.statistics().geometryPasses; ++i)
        order += "d+-";
    return order;
}

void testOrder(Test& test) {
    for (const std::string& technique : techniques(test)) {
        const auto changeView = [&](ViewDescription& description) { setTechnique(description, technique, 4); };
        Image expected;
        {
            Rig plain(test, changeView);
            expected = plain.render();
        }
        Callbacks callbacks{test.device()};
        Rig rig(test, changeView, callbacks.change());
        test.check(callbacks.order.empty(), "the callbacks are called before the first frame.");
        const Image image = rig.render([&](AgaaFrame& frame) { callbacks.use(frame); });
        const std::string promised = promisedOrder(rig);
        test.check(callbacks.order == promised,
                   "the calls of pushState (+), popState (-) and the draw callback (d) of \"" + technique + "\" are " +
                       callbacks.order + " in place of " + promised + ".");
        expectSame(test, image, expected, 32, "a frame of \"" + technique + "\" with AGAA_GL_STATE_CALLBACKS");
    }
}

void testFailures(Test& test, const std::string& technique, AgaaResult failure) {
    constexpr float untouched = 0.25f;
    Callbacks callbacks{test.device()};
    callbacks.failure = failure;
    Rig rig(
        test, [&](ViewDescription& description) { setTechnique(description, technique, 4); }, callbacks.change());
    const Image image = rig.render();
    std::string calls; // calls without the draw callbacks
    for (const char call : promisedOrder(rig))
        if (call != 'd')
            calls += call;
    for (uint32_t n = 1; n <= calls.size(); ++n) {
        const char* callback = calls[n - 1] == '+' ? "pushState" : "popState";
        const std::string what = "agaaGlRecordFrame (\"" + technique + "\"), where " + callback + ", call " +
                                 std::to_string(n) + " of " + std::to_string(calls.size()) + ", fails";
        rig.device().fillOutput(untouched);
        rig.context.log.lines.clear();
        AgaaFrame frame = rig.nextFrame();
        callbacks.use(frame);
        callbacks.failAt = n;
        const AgaaResult result = rig.record(frame);
        callbacks.failAt = 0;
        expectRefused(test, result, AGAA_ERROR_CALLBACK, rig.context.log, "agaaGlRecordFrame", what, callback);
        rig.expectNoMessages(what);
        const Image output = rig.device().readOutput();
        if (n == calls.size()) { // the last callback fails although the output is written
            expectSame(test, output, image, rig.description().desc.width, what + ": the output");
            rig.recorded = std::max(rig.recorded, frame.frameIndex);
        } else
            test.check(output == Image(output.size(), untouched), what + ", and changes the output.");
        restoreInitial();
        expectNextFrame(rig, image, what);
    }
}

} // namespace

void addOpenGlStateCallbackCases(Suite& suite) {
    suite.add("AGAA_GL_STATE_CALLBACKS/AGAA_ERROR_CALLBACK", {Backend::OpenGl}, [](Test& test) {
        for (const AgaaResult failure : {AGAA_ERROR_CALLBACK, AGAA_ERROR_INTERNAL, AGAA_NOT_READY})
            testFailures(test, "agaa", failure);
    });
    suite.add("AGAA_GL_STATE_CALLBACKS/AGAA_ERROR_CALLBACK/frames", {Backend::OpenGl}, [](Test& test) {
        for (const std::string& technique : techniques(test))
            if (technique != "agaa")
                testFailures(test, technique, AGAA_ERROR_INTERNAL);
    });
    suite.add("general/opengl_state_callbacks_are_in_order", {Backend::OpenGl}, testOrder);
}

} // namespace agaa::conformance
