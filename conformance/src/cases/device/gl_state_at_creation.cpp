// Functions that create and resize do not change the state of the host's context.
#include "cases.h"
#include "creation.h"
#include "gl_state.h"

namespace agaa::conformance {

namespace {

class UnusualContext : public SeparateOpenGl {
public:
    explicit UnusualContext(Test& outer) : SeparateOpenGl(outer) {
        const State initial = readState();
        makeStateUnusual();
        expectNoMessages(test, "the test itself");
        state_ = readState();
        uint32_t equal = 0;
        for (size_t i = 0; i < state_.size(); ++i)
            equal += initial[i].values == state_[i].values;
        test.check(equal * 4 < state_.size(), "the test leaves most of the state as it is at first.");
    }
    void expectUnchanged(const std::string& after) {
        expectNoMessages(test, after);
        const State now = readState();
        expectSameState(test, now, state_, false, "after " + after);
        state_ = now;
    }

private:
    State state_;
};

AgaaResult AGAA_CALL keepState(void*) { return AGAA_OK; }

// Creates a context with a policy. The policy concerns frames only, so each policy must pass the tests.
AgaaContext createContext(Test& test, UnusualContext& host, uint32_t policy, LogRecorder& log) {
    ContextDescription description = host.device->description();
    description.desc.log = log.get();
    description.gl.statePolicy = policy;
    description.gl.pushState = description.gl.popState = keepState;
    AgaaContext context = nullptr;
    test.requireOk(host.device->createContext(test.sdk, AGAA_HEADER_VERSION, description, &context),
                   "agaaGlCreateContext");
    return context;
}

void testContexts(Test& test) {
    UnusualContext host(test);
    for (const uint32_t policy : {AGAA_GL_STATE_RESTORE, AGAA_GL_STATE_CALLBACKS, AGAA_GL_STATE_NONE}) {
        LogRecorder log;
        const AgaaContext context = createContext(test, host, policy, log);
        host.expectUnchanged("agaaGlCreateContext with statePolicy = " + std::to_string(policy));
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.result(host.device->getContextCaps(test.sdk, context, &caps), AGAA_OK, "agaaGlGetContextCaps");
        host.expectUnchanged("agaaGlGetContextCaps");
        test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
        host.expectUnchanged("agaaDestroyContext");
        test.check(log.lines.empty(), "a context in unusual state logs a line.");
    }
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.result(host.device->getDeviceCaps(test.sdk, nullptr, &caps), AGAA_OK, "agaaGlGetDeviceCaps");
    host.expectUnchanged("agaaGlGetDeviceCaps");
    ContextDescription wrong = host.device->description();
    wrong.gl.bindings[AGAA_GL_BINDING_LIGHTS] = 0xFFFFFFF0; // the binding exceeds the limit of the context
    AgaaContext none = nullptr;
    test.result(host.device->createContext(test.sdk, AGAA_HEADER_VERSION, wrong, &none), AGAA_ERROR_OUT_OF_RANGE,
                "agaaGlCreateContext with a binding that the context lacks");
    host.expectUnchanged("agaaGlCreateContext that fails");
}

// Runs on views of all techniques, with their host functions.
using RunOnView = std::function<void(UnusualContext&, AgaaContext, const ViewParts&, const std::string& name)>;
void forEachView(Test& test, const RunOnView& run) {
    UnusualContext host(test);
    LogRecorder log;
    const AgaaContext context = createContext(test, host, AGAA_GL_STATE_RESTORE, log);
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"}) {
        ViewParts parts(test.sdk, host.device.get());
        parts.setTechnique(technique, 4);
        parts.config.flags |= AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_READBACK;
        run(host, context, parts, std::string("\"") + technique + "\"");
    }
    ViewParts fetched(test.sdk, host.device.get()), sampled(test.sdk, host.device.get());
    fetched.chain(fetched.fetch);
    run(host, context, fetched, "\"agaa\" with an AgaaFetchFunction");
    sampled.chain(sampled.gbuffer); // draws nothing
    run(host, context, sampled, "\"agaa\" with an AgaaGBufferFunction");
    test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
}

void testViews(Test& test) {
    forEachView(test, [&](UnusualContext& host, AgaaContext context, const ViewParts& parts, const std::string& name) {
        AgaaView view = nullptr;
        test.requireOk(host.device->createView(test.sdk, context, &parts.desc, &view), "agaaGlCreateView of " + name);
        host.expectUnchanged("agaaGlCreateView of " + name);
        test.sdk.agaaDestroyView(view);
        host.expectUnchanged("agaaDestroyView of " + name);
        ViewParts wrong(test.sdk, host.device.get());
        wrong.chain(wrong.gbuffer);
        wrong.gbuffer.glsl = "";
        test.result(host.device->createView(test.sdk, context, &wrong.desc, &view), AGAA_ERROR_INVALID_ARGUMENT,
                    "agaaGlCreateView with a text that does not compile");
        host.device->takeMessages(); // removes messages of the compiler
        host.expectUnchanged("agaaGlCreateView that fails");
    });
}

void testVariants(Test& test) {
    forEachView(test, [&](UnusualContext& host, AgaaContext context, const ViewParts& parts, const std::string& name) {
        AgaaView view = nullptr;
        test.requireOk(host.device->createView(test.sdk, context, &parts.desc, &view), "agaaGlCreateView of " + name);
        host.expectUnchanged("agaaGlCreateView of " + name);
        AgaaSceneFacts fewer = *parts.desc.facts;
        fewer.flags = 0;
        fewer.shadowMapCount = 0;
        test.result(test.sdk.agaaPrepareVariants(view, 1, &fewer), AGAA_OK, "agaaPrepareVariants of " + name);
        host.expectUnchanged("agaaPrepareVariants of " + name);
        fewer.flags = UINT64_C(1) << 62;
        test.result(test.sdk.agaaPrepareVariants(view, 1, &fewer), AGAA_ERROR_OUT_OF_RANGE,
                    "agaaPrepareVariants of " + name);
        host.expectUnchanged("agaaPrepareVariants that fails");
        test.sdk.agaaDestroyView(view);
    });
}

void testResizes(Test& test) {
    forEachView(test, [&](UnusualContext& host, AgaaContext context, const ViewParts& parts, const std::string& name) {
        AgaaView view = nullptr;
        test.requireOk(host.device->createView(test.sdk, context, &parts.desc, &view), "agaaGlCreateView of " + name);
        host.expectUnchanged("agaaGlCreateView of " + name);
        test.result(test.sdk.agaaResizeView(view, 48, 16), AGAA_OK, "agaaResizeView of " + name);
        host.expectUnchanged("agaaResizeView of " + name);
        test.result(test.sdk.agaaResizeView(view, 0xFFFFFFFF, 16), AGAA_ERROR_TOO_LARGE, "agaaResizeView of " + name);
        host.expectUnchanged("agaaResizeView that fails");
        test.sdk.agaaDestroyView(view);
    });
}

} // namespace

void addOpenGlStateCases(Suite& suite) {
    suite.add("agaaGlCreateContext/opengl_state", {Backend::OpenGl}, testContexts);
    suite.add("agaaGlCreateView/opengl_state", {Backend::OpenGl}, testViews);
    suite.add("agaaPrepareVariants/opengl_state", {Backend::OpenGl}, testVariants);
    suite.add("agaaResizeView/opengl_state", {Backend::OpenGl}, testResizes);
}

} // namespace agaa::conformance
