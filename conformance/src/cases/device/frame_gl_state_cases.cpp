// What becomes of the host's OpenGL state.
#include "cases.h"
#include "frame_rig.h"
#include "frame_gl_state.h"

#include <algorithm>

namespace agaa::conformance {

namespace {

// A host that sets what it needs in its callback, and first looks at what is set.
struct Watcher {
    Rig& rig;
    State entry;
    uint32_t failingCall = 0; // from 1
    uint32_t calls = 0;

    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<Watcher*>(user);
        ++self.calls;
        const std::string when = "in draw callback " + std::to_string(self.calls);
        expectSameState(self.rig.test, readState(), self.entry, true, when);
        setHarmlessState();
        const AgaaResult result = self.rig.device().draw(*target);
        return self.calls == self.failingCall ? AGAA_ERROR_CALLBACK : result;
    }
    void use(AgaaFrame& frame) {
        frame.draw = draw;
        frame.drawUser = this;
    }
};

// The frame is recorded in unusual state, which must be there again in the callbacks and
// afterwards.
AgaaResult recordUnusual(Rig& rig, AgaaFrame& frame, uint32_t failingCall, const std::string& when) {
    const UnusualState unusual;
    Watcher watcher{rig, {}, failingCall};
    watcher.use(frame);
    const RecordHook hook = [&](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
        watcher.entry = readState();
        const AgaaResult result = call(view, f, native);
        expectSameState(rig.test, readState(), watcher.entry, false, "after " + when);
        return result;
    };
    const AgaaResult result = rig.record(frame, hook);
    frame.draw = nullptr;
    return result;
}

void testRestored(Test& test) {
    for (const std::string& technique : techniques(test.sdk)) {
        Rig rig(test, [&](ViewDescription& description) { setTechnique(description, technique, 4); });
        const Image expected = rig.render();
        AgaaFrame frame = rig.nextFrame();
        const std::string what = "a frame of \"" + technique + "\" in unusual state";
        test.requireOk(recordUnusual(rig, frame, 0, what), rig.function() + ", " + what);
        expectSame(test, rig.device().readOutput(), expected, 32, what);
        rig.expectNoMessages(what);
    }
}

void testRestoredAfterFailure(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    for (const uint32_t call : {1u, 2u}) {
        AgaaFrame frame = rig.nextFrame();
        const std::string what = "a frame whose callback fails at call " + std::to_string(call);
        const AgaaResult result = recordUnusual(rig, frame, call, what);
        test.check(result == AGAA_ERROR_CALLBACK || call > rig.statistics().geometryPasses, what + " succeeds.");
    }
    // A frame that is refused.
    AgaaFrame frame = rig.nextFrame();
    frame.ambient[0] = -1;
    test.result(recordUnusual(rig, frame, 0, "a frame that is refused"), AGAA_ERROR_OUT_OF_RANGE, rig.function());
    rig.context.log.lines.clear();
    expectNextFrame(rig, expected, "frames that failed in unusual state");
}

// Errors that are pending remain for the host, and the SDK adds none.
void testErrors(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    GLenum first = GL_NO_ERROR, second = GL_NO_ERROR;
    const AgaaResult result =
        rig.record(frame, [&](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
            glEnable(0xFFFF);
            const AgaaResult recorded = call(view, f, native);
            first = glGetError();
            second = glGetError();
            return recorded;
        });
    rig.device().takeMessages(); // of the error
    test.requireOk(result, rig.function() + " while an OpenGL error is pending");
    test.check(first == GL_INVALID_ENUM, "an OpenGL error that was pending before a frame is lost.");
    test.check(second == GL_NO_ERROR, "a frame leaves an OpenGL error.");
    expectSame(test, rig.device().readOutput(), expected, 32, "a frame while an OpenGL error is pending");
}

// ---- AGAA_GL_STATE_CALLBACKS
// -------------------------------------------------------------------------

struct StateCalls {
    std::string sequence; // p: push, o: pop, d: draw
    char failing = 0;
    uint32_t failingCall = 0; // of its kind, from 1
    Device* device = nullptr;

    AgaaResult add(char kind) {
        sequence += kind;
        const auto count = uint32_t(std::count(sequence.begin(), sequence.end(), kind));
        return kind == failing && count == failingCall ? AGAA_ERROR_INTERNAL : AGAA_OK;
    }
    static AgaaResult AGAA_CALL push(void* user) { return static_cast<StateCalls*>(user)->add('p'); }
    static AgaaResult AGAA_CALL pop(void* user) {
        setHarmlessState();
        return static_cast<StateCalls*>(user)->add('o');
    }
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<StateCalls*>(user);
        self.add('d');
        return self.device->draw(*target);
    }
    void use(AgaaFrame& frame) {
        frame.draw = draw;
        frame.drawUser = this;
    }
    Rig::ChangeContext change() {
        return [this](ContextDescription& c) {
            c.gl.statePolicy = AGAA_GL_STATE_CALLBACKS;
            c.gl.pushState = push;
            c.gl.popState = pop;
            c.gl.stateUser = this;
        };
    }
};

// pushState on entry and after each draw callback, popState before each draw callback and before
// the end.
void testOrder(Test& test) {
    for (const std::string& technique : techniques(test.sdk)) {
        const auto changeView = [&](ViewDescription& description) { setTechnique(description, technique, 4); };
        Image expected;
        {
            Rig plain(test, changeView);
            expected = plain.render();
        }
        StateCalls calls;
        calls.device = &test.device();
        Rig rig(test, changeView, calls.change());
        calls.sequence.clear();
        const Image image = rig.render([&](AgaaFrame& frame) { calls.use(frame); });
        std::string promised = "po";
        for (uint32_t i = 0; i < rig.statistics().geometryPasses; ++i)
            promised += "dpo";
        test.check(calls.sequence == promised, "the calls of pushState (p), popState (o) and the draw callback (d) are " +
                                                   calls.sequence + " in place of " + promised + " (\"" + technique + "\").");
        expectSame(test, image, expected, 32, "a frame of \"" + technique + "\" with AGAA_GL_STATE_CALLBACKS");
    }
}

void testFailingCallbacks(Test& test) {
    StateCalls calls;
    calls.device = &test.device();
    Rig rig(test, {}, calls.change());
    const Image expected = rig.render();
    const uint32_t count = rig.statistics().geometryPasses + 1; // of each kind
    for (const char kind : {'p', 'o'})
        for (uint32_t i = 1; i <= count; ++i) {
            const bool isLast = kind == 'o' && i == count;
            AgaaFrame frame = rig.nextFrame();
            calls.use(frame);
            calls.sequence.clear();
            calls.failing = kind;
            calls.failingCall = i;
            const std::string what =
                rig.function() + ", " + (kind == 'p' ? "pushState" : "popState") + " fails at call " + std::to_string(i);
            rig.device().fillOutput(0.25f);
            rig.context.log.lines.clear();
            const AgaaResult result = rig.record(frame);
            calls.failing = 0;
            expectRefused(test, result, AGAA_ERROR_CALLBACK, rig.context.log, rig.function(), what,
                          kind == 'p' ? "pushState" : "popState");
            const Image untouched(expected.size(), 0.25f);
            expectSame(test, rig.device().readOutput(), isLast ? expected : untouched, 32, "the output after " + what);
            setHarmlessState();
            rig.device().takeMessages();
            expectNextFrame(rig, expected, what);
        }
}

} // namespace

void addGlStateCases(Suite& suite) {
    const std::vector<Backend> gl = {Backend::OpenGl};
    suite.add("general/opengl_state_is_restored", gl, testRestored);
    suite.add("general/opengl_state_is_restored/after_failures", gl, testRestoredAfterFailure);
    suite.add("general/opengl_errors_remain", gl, testErrors);
    suite.add("AGAA_GL_STATE_CALLBACKS/AGAA_ERROR_CALLBACK/frames", gl, testFailingCallbacks);
    suite.add("general/opengl_state_callbacks_are_in_order", gl, testOrder);
}

} // namespace agaa::conformance
