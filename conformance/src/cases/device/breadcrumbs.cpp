// agaaGetBreadcrumbs: the passes that the device reached last.
#include "cases.h"
#include "frame_rig.h"
#include "gl_interposer.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr const char* call = "agaaGetBreadcrumbs";

Rig::ChangeView viewWithCrumbs(const std::string& technique) {
    return [=](ViewDescription& description) {
        setTechnique(description, technique, 4);
        description.config.flags |= AGAA_CONFIG_BREADCRUMBS;
    };
}

AgaaBreadcrumbs noCrumbs() {
    const AgaaBreadcrumbs crumbs = AGAA_BREADCRUMBS_INIT;
    return crumbs;
}

void expectCrumbsRefused(Rig& rig, AgaaView view, AgaaBreadcrumbs* out, AgaaResult code, const std::string& how) {
    const AgaaBreadcrumbs before = out ? *out : noCrumbs();
    rig.context.log.lines.clear();
    const AgaaResult result = rig.test.sdk.agaaGetBreadcrumbs(view, out);
    if (view)
        expectRefused(rig.test, result, code, rig.context.log, call, call + how);
    else
        rig.test.result(result, code, call + how);
    if (out)
        rig.test.check(isSameBytes(before, *out), call + how + " fails and changes the output.");
}

void testCrumbArguments(Test& test) {
    Rig rig(test, viewWithCrumbs("single"));
    rig.render();
    AgaaBreadcrumbs out = noCrumbs();
    expectCrumbsRefused(rig, nullptr, &out, AGAA_ERROR_INVALID_ARGUMENT, " with a null view");
    expectCrumbsRefused(rig, rig.view.get(), nullptr, AGAA_ERROR_INVALID_ARGUMENT, " with a null output");
}

void testCrumbStruct(Test& test) {
    Rig rig(test, viewWithCrumbs("single"));
    rig.render();
    AgaaBreadcrumbs wrongType = noCrumbs(), wrongSize = noCrumbs();
    wrongType.sType = AGAA_STRUCTURE_TYPE_SURFACE;
    wrongSize.structSize = 8;
    expectCrumbsRefused(rig, rig.view.get(), &wrongType, AGAA_ERROR_STRUCT, " with another sType");
    expectCrumbsRefused(rig, rig.view.get(), &wrongSize, AGAA_ERROR_STRUCT, " with structSize = 8");
}

void testViewWithoutCrumbs(Test& test) {
    Rig rig(test, [](ViewDescription& description) { setTechnique(description, "single", 1); });
    for (int i = 0; i < 2; ++i) { // repeats before and after a frame
        AgaaBreadcrumbs out = noCrumbs();
        expectCrumbsRefused(rig, rig.view.get(), &out, AGAA_ERROR_WRONG_ORDER, " without AGAA_CONFIG_BREADCRUMBS");
        rig.render();
    }
}

void expectNotReached(Rig& rig, const std::string& how) {
    AgaaBreadcrumbs out = noCrumbs();
    rig.test.result(rig.test.sdk.agaaGetBreadcrumbs(rig.view.get(), &out), AGAA_NOT_READY, call + how);
    rig.test.check(isSameBytes(out, noCrumbs()), call + how + " changes the output.");
}

// A finished frame has ended its last pass.
void expectEnd(Rig& rig, uint64_t frame, const std::string& how) {
    const AgaaFrameStatistics statistics = rig.statistics();
    AgaaBreadcrumbs out = noCrumbs();
    rig.test.requireOk(rig.test.sdk.agaaGetBreadcrumbs(rig.view.get(), &out), call);
    const uint32_t last = statistics.passCount - 1;
    for (const AgaaBreadcrumb& crumb : {out.begun, out.ended}) {
        rig.test.check(crumb.pass == last && !std::strcmp(crumb.name, statistics.passes[last].name),
                       call + how + " names pass " + std::to_string(crumb.pass) + " in place of the last one.");
        rig.test.check(crumb.frameIndex == frame, call + how + " names another frame.");
        rig.test.check(crumb.repetition == 0, call + how + " names a repetition of a pass that runs once.");
        rig.test.check(crumb.reserved[0] == 0, "AgaaBreadcrumb::reserved is not 0.");
    }
}

void testCrumbsOfFrames(Test& test) {
    for (const std::string& technique : techniques(test)) {
        Rig plain(test, [&](ViewDescription& description) { setTechnique(description, technique, 4); });
        const Image expected = plain.render();
        Rig rig(test, viewWithCrumbs(technique));
        const std::string of = " of \"" + technique + "\"";
        expectNotReached(rig, of + " before a frame");
        expectSame(test, rig.render(), expected, rig.description().desc.width, "the image with breadcrumbs" + of);
        expectEnd(rig, rig.recorded, of);
        AgaaFrame refused = rig.nextFrame();
        refused.width = ~0u;
        test.check(rig.record(refused) < 0, "a frame that is too large is accepted.");
        rig.context.log.lines.clear();
        expectEnd(rig, rig.recorded, of + " after a refused frame");
        rig.render();
        expectEnd(rig, rig.recorded, of + " after another frame");
        test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 24, 24), "agaaResizeView");
        expectNotReached(rig, of + " after agaaResizeView");
    }
}

// A lost device does not matter: the call reads memory of the CPU.
void testCrumbsAfterLoss(Test& test) {
    const std::unique_ptr<Interposer> api = makeInterposer(test.device());
    Rig rig(test, viewWithCrumbs("agaa"), [&](ContextDescription& d) { api->chainTo(d); });
    rig.render();
    AgaaBreadcrumbs before = noCrumbs(), after = noCrumbs();
    test.requireOk(test.sdk.agaaGetBreadcrumbs(rig.view.get(), &before), call);
    api->loseAt(1);
    AgaaFrame frame = rig.nextFrame();
    test.result(rig.record(frame), AGAA_ERROR_DEVICE, rig.function() + " after the loss of the device");
    test.requireOk(test.sdk.agaaGetBreadcrumbs(rig.view.get(), &after), "agaaGetBreadcrumbs of a lost device");
    test.check(isSameBytes(before, after), "agaaGetBreadcrumbs of a lost device names other passes.");
    test.device().takeMessages();
}

void testCrumbsUnsupported(Test& test) {
    OpenGlInterposer gl;
    gl.version = "4.3 of the suite";
    gl.hiddenExtension = "GL_ARB_buffer_storage";
    ScopedContext context(test, [&](ContextDescription& d) { gl.chainTo(d); });
    ViewDescription description(&test.device());
    viewWithCrumbs("single")(description);
    AgaaView view = untouchedHandle<AgaaView>();
    const AgaaResult result = test.device().createView(test.sdk, context.get(), &description.desc, &view);
    expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, context.log, "agaaGlCreateView",
                  "agaaGlCreateView with AGAA_CONFIG_BREADCRUMBS without GL_ARB_buffer_storage",
                  "GL_ARB_buffer_storage");
    test.check(view == untouchedHandle<AgaaView>(), "agaaGlCreateView fails and changes outView.");
}

// On OpenGL the test has a context of its own: a lost context does not restore the host's state.
void runOnLosable(Test& test) {
    if (test.device().backend() == Backend::Vulkan)
        return testCrumbsAfterLoss(test);
    const std::unique_ptr<Device> device = makeOpenGlDevice(test.device().deviceName());
    runOn(test, *device, testCrumbsAfterLoss);
}

} // namespace

void addBreadcrumbCases(Suite& suite) {
    suite.both("agaaGetBreadcrumbs/AGAA_ERROR_INVALID_ARGUMENT", testCrumbArguments);
    suite.both("agaaGetBreadcrumbs/AGAA_ERROR_STRUCT", testCrumbStruct);
    suite.both("agaaGetBreadcrumbs/outBreadcrumbs.unchanged", [](Test& test) {
        testCrumbArguments(test);
        testCrumbStruct(test);
    });
    suite.both("agaaGetBreadcrumbs/AGAA_ERROR_WRONG_ORDER", testViewWithoutCrumbs);
    suite.both("agaaGetBreadcrumbs/returns", testCrumbsOfFrames);
    suite.both("AgaaBreadcrumb.reserved/zero", [](Test& test) {
        Rig rig(test, viewWithCrumbs("single"));
        rig.render();
        expectEnd(rig, rig.recorded, "");
    });
    suite.both("agaaGetBreadcrumbs/lost", runOnLosable);
    suite.add("AGAA_CONFIG_BREADCRUMBS/AGAA_ERROR_UNSUPPORTED", {Backend::OpenGl}, testCrumbsUnsupported);
}

} // namespace agaa::conformance
