// The device or the OpenGL context is lost: during a call, or between calls. Calls return AGAA_ERROR_DEVICE with one
// sentence, and objects can be destroyed.
#include "cases.h"
#include "frame_rig.h"
#include "gl_interposer.h"
#include "survived.h"

#include <GL/glcorearb.h>
#include <vulkan/vulkan.h>

namespace agaa::conformance {

namespace {

Rig::ChangeView timedView(const std::string& technique) {
    return [=](ViewDescription& description) {
        setTechnique(description, technique, 4);
        description.desc.width = description.desc.height = 16;
        description.config.flags |= AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_CHECK_FACTS;
    };
}

// Expects calls on a view of a lost device to be refused.
class LostView {
public:
    LostView(Rig& rig, const std::string& how) : rig_(rig), how_(how) {}

    void expectAll() {
        const Functions& sdk = rig_.test.sdk;
        const AgaaView view = rig_.view.get();
        AgaaFrame frame = rig_.nextFrame();
        expect(rig_.function(), [&] { return rig_.record(frame); });
        expectStatistics();
        expect("agaaResizeView", [&] { return sdk.agaaResizeView(view, 8, 8); });
        AgaaSceneFacts facts = rig_.description().facts;
        facts.flags = 0;
        const bool isVulkan = rig_.device().backend() == Backend::Vulkan;
        if (!isVulkan || rig_.description().technique != "msaa") // whose variants have no pipelines
            expect("agaaPrepareVariants", [&] { return sdk.agaaPrepareVariants(view, 1, &facts); });
        AgaaView other = untouchedHandle<AgaaView>();
        expect(apiName(rig_.device(), "CreateView"),
               [&] { return rig_.device().createView(sdk, rig_.context.get(), &rig_.description().desc, &other); });
        rig_.test.check(other == untouchedHandle<AgaaView>(), how_ + " a view is created.");
    }

    void expectStatistics() {
        const Functions& sdk = rig_.test.sdk;
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        expect("agaaGetFrameStatistics",
               [&] { return sdk.agaaGetFrameStatistics(rig_.view.get(), rig_.recorded, &statistics); });
        rig_.test.check(!statistics.frameIndex && !statistics.payloadBytes,
                        how_ + " agaaGetFrameStatistics changes its output.");
        // On Vulkan the counters of an executed frame are in memory of the CPU.
        if (rig_.device().backend() == Backend::Vulkan)
            return;
        AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
        expect("agaaValidateFrame", [&] { return sdk.agaaValidateFrame(rig_.view.get(), rig_.recorded, &validation); });
        AgaaFactReport report = AGAA_FACT_REPORT_INIT;
        expect("agaaGetFactReport", [&] { return sdk.agaaGetFactReport(rig_.view.get(), rig_.recorded, &report); });
    }

private:
    void expect(const std::string& function, const std::function<AgaaResult()>& call) {
        rig_.context.log.lines.clear();
        expectRefused(rig_.test, call(), AGAA_ERROR_DEVICE, rig_.context.log, function, function + how_);
    }

    Rig& rig_;
    std::string how_;
};

// A rig whose timestamps the SDK reads.
bool isTimed(Rig& rig) { return rig.statistics().timeSource == AGAA_TIME_DEVICE; }

// The device is lost between two frames.
void testBetween(Test& test) {
    for (const std::string& technique : techniques(test)) {
        const std::unique_ptr<Interposer> api = makeInterposer(test.device());
        {
            Rig rig(test, timedView(technique), [&](ContextDescription& d) { api->chainTo(d); });
            const Image image = rig.render();
            if (test.device().backend() == Backend::Vulkan && !isTimed(rig))
                test.skip("the queue has no timestamps.");
            api->loseAt(1);
            LostView(rig, " of \"" + technique + "\" after the loss").expectAll();
            test.device().takeMessages();
        }
        test.check(api->objects.empty(),
                   "\"" + technique + "\" leaves " + objectsText(api->objects) + " after the loss of the device.");
    }
}

// glGetGraphicsResetStatus reports a reset once. Later calls must remember it.
void testReset(Test& test) {
    OpenGlInterposer api;
    api.notifiesReset = true;
    {
        Rig rig(test, timedView("agaa"), [&](ContextDescription& d) { api.chainTo(d); });
        rig.render();
        api.resetStatus = GL_UNKNOWN_CONTEXT_RESET;
        LostView(rig, " after a reset").expectAll();
    }
    test.check(api.objects.empty(), "a reset leaves " + objectsText(api.objects) + ".");
}

// The nth call of a function finds the device lost while a view is created. The call of the SDK succeeds only if it
// does not notice.
void testDuring(Test& test) {
    for (const std::string& technique : techniques(test)) {
        Survived survived;
        const std::unique_ptr<Interposer> api = makeInterposer(test.device());
        ScopedContext context(test, [&](ContextDescription& d) { api->chainTo(d); });
        ViewDescription description(&test.device());
        timedView(technique)(description);
        const std::map<std::string, int64_t> before = api->objects;
        for (uint32_t n = 1;; ++n) {
            const size_t failures = test.failures().size();
            const std::string what = "\"" + technique + "\", lost at call " + std::to_string(n);
            AgaaView view = nullptr;
            context.log.lines.clear();
            api->loseAt(n);
            const AgaaResult result = test.device().createView(test.sdk, context.get(), &description.desc, &view);
            const bool isLost = api->isLost();
            if (result != AGAA_OK)
                expectRefused(test, result, AGAA_ERROR_DEVICE, context.log, apiName(test.device(), "CreateView"), what);
            else
                test.sdk.agaaDestroyView(view);
            api->loseAt(0);
            test.device().takeMessages();
            test.check(api->objects == before, what + " leaves " + objectsText(api->objects) + ".");
            if (!isLost)
                break;
            survived.count(test, failures);
        }
        survived.print(test, "the loss while a view of \"" + technique + "\" is created");
    }
}

// The nth call of a frame on OpenGL finds the context lost.
void testDuringFrame(Test& test) {
    for (const std::string& technique : techniques(test)) {
        Survived survived;
        OpenGlInterposer api;
        {
            Rig rig(test, timedView(technique), [&](ContextDescription& d) { api.chainTo(d); });
            const Image image = rig.render();
            for (uint32_t n = 1;; ++n) {
                const size_t failures = test.failures().size();
                const std::string what = "\"" + technique + "\", lost at call " + std::to_string(n) + " of a frame";
                AgaaFrame frame = rig.nextFrame();
                api.loseAt(n);
                rig.context.log.lines.clear();
                const AgaaResult result = rig.record(frame);
                const bool isLost = api.isLost();
                test.check(result == AGAA_OK || result == AGAA_ERROR_DEVICE,
                           what + " returns " + std::to_string(result) + ".");
                if (isLost)
                    LostView(rig, ", " + what).expectStatistics();
                api.loseAt(0);
                test.device().takeMessages();
                if (!isLost)
                    break;
                survived.count(test, failures);
            }
        }
        test.check(api.objects.empty(), "\"" + technique + "\" leaves " + objectsText(api.objects) + ".");
        survived.print(test, "the loss during a frame of \"" + technique + "\"");
    }
}

// Timestamps cannot be read. The next call succeeds.
void testQueries(Test& test, const std::vector<int64_t>& errors, AgaaResult code) {
    const std::unique_ptr<Interposer> api = makeInterposer(test.device());
    Rig rig(test, timedView("single"), [&](ContextDescription& d) { api->chainTo(d); });
    rig.render();
    if (!isTimed(rig))
        test.skip("the queue has no timestamps.");
    for (const int64_t error : errors) {
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        rig.context.log.lines.clear();
        api->failAt(1, error);
        const AgaaResult result = test.sdk.agaaGetFrameStatistics(rig.view.get(), rig.recorded, &statistics);
        api->failAt(0, 0);
        expectRefused(test, result, code, rig.context.log, "agaaGetFrameStatistics",
                      "agaaGetFrameStatistics where vkGetQueryPoolResults returns " + std::to_string(error),
                      "vkGetQueryPoolResults");
        test.check(rig.statistics().frameIndex == rig.recorded, "statistics after a failure are of another frame.");
    }
}

void testOneReport(Test& test) {
    const std::unique_ptr<Interposer> api = makeInterposer(test.device());
    Rig rig(test, timedView("single"), [&](ContextDescription& d) { api->chainTo(d); });
    rig.render();
    api->loseAt(1);
    LostView(rig, " after the loss").expectStatistics();
    test.device().takeMessages();
}

// On OpenGL the test has a context of its own: a lost context does not restore the host's state.
std::function<void(Test&)> onOwnContext(void (*run)(Test&)) {
    return [run](Test& test) {
        if (test.device().backend() == Backend::Vulkan)
            return run(test);
        const std::unique_ptr<Device> device = makeOpenGlDevice(test.device().deviceName());
        runOn(test, *device, run);
    };
}

} // namespace

void addLossCases(Suite& suite) {
    suite.both("agaaDestroyView/lost", onOwnContext(testBetween));
    suite.add("agaaGlRecordFrame/AGAA_ERROR_DEVICE", {Backend::OpenGl}, onOwnContext(testReset));
    addApiCase(suite, "CreateView", "lost", onOwnContext(testDuring));
    suite.add("agaaGlRecordFrame/lost", {Backend::OpenGl}, onOwnContext(testDuringFrame));
    suite.add("agaaGetFrameStatistics/AGAA_ERROR_OUT_OF_MEMORY", {Backend::Vulkan}, [](Test& test) {
        testQueries(test, {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}, AGAA_ERROR_OUT_OF_MEMORY);
    });
    suite.both("agaaGetFrameStatistics/AGAA_ERROR_DEVICE", [](Test& test) {
        if (test.device().backend() == Backend::Vulkan)
            testQueries(test, {VK_ERROR_DEVICE_LOST, VK_ERROR_UNKNOWN}, AGAA_ERROR_DEVICE);
        else
            onOwnContext(testOneReport)(test);
    });
    suite.add("agaaValidateFrame/AGAA_ERROR_DEVICE", {Backend::OpenGl}, onOwnContext(testOneReport));
    suite.add("agaaGetFactReport/AGAA_ERROR_DEVICE", {Backend::OpenGl}, onOwnContext(testOneReport));
}

} // namespace agaa::conformance
