// Frames whose command buffer the host discards. They have no statistics, because the device did not execute them.
#include "cases.h"
#include "frame_rig.h"

#include <cstring>

namespace agaa::conformance {

namespace {

struct Flags {
    const char* name;
    uint64_t flags;
};
constexpr Flags all[] = {{"counters", AGAA_CONFIG_COUNTERS},
                         {"times", AGAA_CONFIG_TIMESTAMPS},
                         {"counters and times", AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS},
                         {"fact checks", AGAA_CONFIG_CHECK_FACTS}};

// Records the next frame and discards it. It counts as completed.
void discardFrame(Rig& rig) {
    AgaaFrame frame = rig.nextFrame();
    rig.device().discardsCommands = true;
    const AgaaResult result = rig.record(frame);
    rig.device().discardsCommands = false;
    rig.test.requireOk(result, "recording a frame that is discarded");
}

template <class T>
void expectNotReady(Rig& rig, const T& initial, AgaaResult (*get)(const Functions&, AgaaView, uint64_t, T*),
                    const std::string& what) {
    T out = initial;
    rig.test.result(get(rig.test.sdk, rig.view.get(), rig.recorded, &out), AGAA_NOT_READY, what);
    rig.test.check(!std::memcmp(&out, &initial, sizeof out), what + " changes the output.");
}

// Expects that the newest frame has no statistics.
void expectNothing(Rig& rig, uint64_t flags, const std::string& what) {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    rig.test.result(rig.test.sdk.agaaGetFrameStatistics(rig.view.get(), rig.recorded, &statistics), AGAA_NOT_READY,
                    "agaaGetFrameStatistics of " + what);
    rig.test.check(!statistics.frameIndex && !statistics.passCount && !statistics.counters.visible,
                   "agaaGetFrameStatistics of " + what + " returns numbers of another frame.");
    if (flags & AGAA_CONFIG_COUNTERS)
        expectNotReady<AgaaFrameValidation>(
            rig, AGAA_FRAME_VALIDATION_INIT,
            [](const Functions& sdk, AgaaView view, uint64_t completed, AgaaFrameValidation* out) {
                return sdk.agaaValidateFrame(view, completed, out);
            },
            "agaaValidateFrame of " + what);
    if (flags & AGAA_CONFIG_CHECK_FACTS)
        expectNotReady<AgaaFactReport>(
            rig, AGAA_FACT_REPORT_INIT,
            [](const Functions& sdk, AgaaView view, uint64_t completed, AgaaFactReport* out) {
                return sdk.agaaGetFactReport(view, completed, out);
            },
            "agaaGetFactReport of " + what);
    rig.test.check(rig.context.log.errors().empty(), "the statistics of " + what + " are logged as an error.");
}

// The first frame of each slot, and a frame whose slot has the statistics of an earlier one.
void testDiscarded(Test& test) {
    for (const std::string& technique : techniques(test))
        for (const Flags& flags : all) {
            // One technique with each pair of flags suffices for times: they do not depend on the technique.
            if (flags.flags != AGAA_CONFIG_COUNTERS && technique != "single" && technique != "agaa")
                continue;
            Rig rig(test, [&](ViewDescription& description) {
                setTechnique(description, technique, 4);
                description.desc.width = description.desc.height = 16;
                description.config.flags = flags.flags;
            });
            const std::string what = "a discarded frame of \"" + technique + "\" with " + flags.name;
            for (int i = 0; i < 2; ++i) {
                discardFrame(rig);
                expectNothing(rig, flags.flags, what + " before the first one that is executed");
            }
            const Image image = rig.render();
            for (int i = 0; i < 3; ++i) {
                expectNextFrame(rig, image, what);
                test.check(rig.statistics().frameIndex == rig.recorded,
                           "the frame after " + what + " has statistics of another frame.");
                discardFrame(rig);
                expectNothing(rig, flags.flags, what + " after one that is executed");
            }
            rig.expectNoMessages(what);
        }
}

// A technique that keeps numbers from frame to frame clears them again if the frame that cleared them is discarded.
void testDiscardedMemory(Test& test) {
    const auto remember = [](ViewDescription& description) {
        setTechnique(description, "adaptive", 16);
        description.desc.width = description.desc.height = 16;
        description.config.flags = 0;
        description.adaptive.flags |= AGAA_ADAPTIVE_GEOMETRY;
        description.adaptive.countMemory = 0.5f;
    };
    Image images[3];
    {
        Rig rig(test, remember);
        for (Image& image : images)
            image = rig.render();
    }
    Rig rig(test, remember);
    discardFrame(rig);
    for (const Image& image : images)
        expectSame(test, rig.render(), image, 16, "a frame after one that was discarded");
}

} // namespace

void addDiscardedFrameCases(Suite& suite) {
    suite.add("agaaGetFrameStatistics/returns/discarded", {Backend::Vulkan}, testDiscarded);
    suite.add("agaaVkRecordFrame/discarded/persistent", {Backend::Vulkan}, testDiscardedMemory);
}

} // namespace agaa::conformance
