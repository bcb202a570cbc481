// The host's OpenGL state while frames are recorded.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "gl_state.h"

namespace agaa::conformance {

namespace {

// A host whose callback checks the state, and then sets the state that it needs.
struct Watcher {
    Rig& rig;
    State entry;
    uint32_t failingCall = 0; // index of the failing call, from 1
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
};

// Records the frame in unusual state, which the SDK must restore in the callbacks and afterwards.
AgaaResult recordUnusual(Rig& rig, AgaaFrame& frame, uint32_t failingCall, const std::string& what) {
    Watcher watcher{rig, {}, failingCall};
    frame.draw = Watcher::draw;
    frame.drawUser = &watcher;
    const RecordHook hook = [&](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
        makeStateUnusual();
        rig.device().bindScene(); // a binding of the host
        watcher.entry = readState();
        const AgaaResult result = call(view, f, native);
        expectSameState(rig.test, readState(), watcher.entry, false, "after " + what);
        setHarmlessState();
        return result;
    };
    return rig.record(frame, hook);
}

void testRestored(Test& outer) {
    for (const std::string& technique : techniques(outer)) {
        SeparateOpenGl separate(outer);
        Rig rig(separate.test, [&](ViewDescription& description) { setTechnique(description, technique, 4); });
        const Image expected = rig.render();
        AgaaFrame frame = rig.nextFrame();
        const std::string what = "a frame of \"" + technique + "\" in unusual state";
        separate.test.requireOk(recordUnusual(rig, frame, 0, what), rig.function() + ", " + what);
        expectSame(separate.test, separate.device->readOutput(), expected, 32, what);
        rig.expectNoMessages(what);
    }
}

void testRestoredAfterFailure(Test& outer) {
    SeparateOpenGl separate(outer);
    Rig rig(separate.test);
    const Image expected = rig.render();
    for (const uint32_t call : {1u, 2u}) {
        AgaaFrame frame = rig.nextFrame();
        const std::string what = "a frame whose callback fails at call " + std::to_string(call);
        const AgaaResult result = recordUnusual(rig, frame, call, what);
        separate.test.check(result == AGAA_ERROR_CALLBACK || call > rig.statistics().geometryPasses,
                            what + " succeeds.");
    }
    AgaaFrame refused = rig.nextFrame();
    refused.ambient[0] = -1;
    separate.test.result(recordUnusual(rig, refused, 0, "a frame that is refused"), AGAA_ERROR_OUT_OF_RANGE,
                         rig.function());
    rig.expectNoMessages("frames that failed in unusual state");
    rig.context.log.lines.clear();
    expectNextFrame(rig, expected, "frames that failed in unusual state");
}

} // namespace

void addOpenGlFrameStateCases(Suite& suite) {
    suite.add("general/opengl_state_is_restored", {Backend::OpenGl}, testRestored);
    suite.add("general/opengl_state_is_restored/after_failures", {Backend::OpenGl}, testRestoredAfterFailure);
}

} // namespace agaa::conformance
