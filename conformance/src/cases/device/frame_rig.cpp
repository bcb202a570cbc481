#include "frame_rig.h"

#include "creation.h"

#include <cmath>
#include <cstring>

namespace agaa::conformance {

namespace {

// The hook of the call in progress. A global holds it, because the replaced functions have no user pointer.
struct Intercepted {
    const Functions& sdk;
    const RecordHook& hook;
};
Intercepted* intercepted = nullptr;

AgaaResult AGAA_CALL recordVk(AgaaView view, const AgaaFrame* frame, const AgaaVkFrame* native) {
    const auto call = [sdk = intercepted->sdk](AgaaView v, const AgaaFrame* f, const void* n) {
        return sdk.agaaVkRecordFrame(v, f, static_cast<const AgaaVkFrame*>(n));
    };
    return intercepted->hook(call, view, frame, native);
}

AgaaResult AGAA_CALL recordGl(AgaaView view, const AgaaFrame* frame, const AgaaGlFrame* native) {
    const auto call = [sdk = intercepted->sdk](AgaaView v, const AgaaFrame* f, const void* n) {
        return sdk.agaaGlRecordFrame(v, f, static_cast<const AgaaGlFrame*>(n));
    };
    return intercepted->hook(call, view, frame, native);
}

} // namespace

Rig::Rig(Test& theTest, const ChangeView& changeView, const ChangeContext& changeContext)
    : test(theTest), context(theTest, changeContext), description_(&theTest.device()),
      view(theTest, context.get(), changed(changeView)),
      scene(smallScene(description_.desc.width, description_.desc.height)) {
    device().takeMessages(); // removes messages of earlier tests
}

const ViewDescription& Rig::changed(const ChangeView& changeView) {
    if (changeView)
        changeView(description_);
    const std::string obstacle = unsupportedReason(test, description_.config.technique);
    if (!obstacle.empty())
        test.skip(obstacle);
    return description_;
}

std::string Rig::function() const { return apiName(device(), "RecordFrame"); }

AgaaFrame Rig::nextFrame() const { return pixelFrame(device(), description_, recorded + 1); }

AgaaResult Rig::record(AgaaFrame& frame, const RecordHook& hook) {
    AgaaResult result = AGAA_OK;
    if (!hook)
        result = device().record(test.sdk, view.get(), frame, scene);
    else {
        Functions functions = test.sdk;
        functions.agaaVkRecordFrame = recordVk;
        functions.agaaGlRecordFrame = recordGl;
        Intercepted now{test.sdk, hook};
        intercepted = &now;
        result = device().record(functions, view.get(), frame, scene);
        intercepted = nullptr;
    }
    if (result == AGAA_OK)
        recorded = std::max(recorded, frame.frameIndex);
    return result;
}

Image Rig::render(const ChangeFrame& change) {
    AgaaFrame frame = nextFrame();
    if (change)
        change(frame);
    test.requireOk(record(frame), function());
    expectNoMessages(function());
    expectNoErrors(function());
    return device().readOutput();
}

AgaaFrameStatistics Rig::statistics() {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    test.requireOk(test.sdk.agaaGetFrameStatistics(view.get(), recorded, &statistics), "agaaGetFrameStatistics");
    return statistics;
}

void Rig::expectNoMessages(const std::string& what) { conformance::expectNoMessages(test, what); }

void Rig::expectNoErrors(const std::string& what) {
    for (const LogLine& line : context.log.lines)
        test.check(line.severity == AGAA_SEVERITY_INFO, what + " succeeds and logs: " + line.text);
    context.log.lines.clear();
}

void expectFrameRefused(Rig& rig, AgaaFrame& frame, const Refusal& refusal, const Image& expected,
                        const RecordHook& hook) {
    constexpr float untouched = 0.25f;
    rig.device().fillOutput(untouched);
    rig.context.log.lines.clear();
    const uint64_t before = rig.recorded;
    const AgaaResult result = rig.record(frame, hook);
    expectRefused(rig.test, result, refusal.code, rig.context.log, rig.function(), refusal.what, refusal.words);
    if (refusal.mayReport)
        rig.device().takeMessages();
    rig.expectNoMessages(refusal.what);
    if (result == AGAA_OK)
        return;
    rig.recorded = before;
    for (const float value : rig.device().readOutput())
        if (!rig.test.check(value == untouched, refusal.what + " fails and changes the output."))
            break;
    expectNextFrame(rig, expected, refusal.what);
}

void expectNextFrame(Rig& rig, const Image& expected, const std::string& after) {
    AgaaFrame frame = rig.nextFrame();
    const AgaaResult result = rig.record(frame);
    if (!rig.test.result(result, AGAA_OK, "the next frame after " + after))
        return;
    expectSame(rig.test, rig.device().readOutput(), expected, rig.description().desc.width,
               "the next frame after " + after);
    rig.expectNoMessages("the next frame after " + after);
    rig.context.log.lines.clear();
}

void runOn(Test& test, Device& device, const std::function<void(Test&)>& run) {
    Test inner(test.sdk, &device);
    device.takeMessages();
    try {
        run(inner);
    } catch (const Aborted&) {
    }
    for (const std::string& failure : inner.failures())
        test.check(false, failure);
}

void addRecordCase(Suite& suite, const std::string& promise, const std::function<void(Test&)>& run) {
    addApiCase(suite, "RecordFrame", promise, run);
}

const float* pixel(const Image& image, uint32_t width, uint32_t x, uint32_t y) {
    return &image[4 * (size_t(y) * width + x)];
}

static std::string colorText(const float* rgba) {
    char text[120];
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", double(rgba[0]), double(rgba[1]), double(rgba[2]));
    return text;
}

static std::string at(size_t i, uint32_t width) {
    return " at pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")";
}

void expectSame(Test& test, const Image& got, const Image& expected, uint32_t width, const std::string& what) {
    if (!test.check(got.size() == expected.size(), what + " has another size."))
        return;
    size_t first = 0, count = 0;
    for (size_t i = 0; i < got.size() / 4; ++i)
        if (std::memcmp(&got[4 * i], &expected[4 * i], 16) != 0 && count++ == 0)
            first = i;
    if (count)
        test.check(false, what + " differs in " + std::to_string(count) + " pixels; first " +
                              colorText(&got[4 * first]) + " in place of " + colorText(&expected[4 * first]) +
                              at(first, width) + ".");
}

void expectAlike(Test& test, const Image& got, const Image& expected, float rounding, const std::string& what) {
    if (!test.check(got.size() == expected.size(), what + " has another size."))
        return;
    for (size_t i = 0; i < got.size(); ++i) {
        const float difference = std::fabs(got[i] - expected[i]);
        if (!(difference <= rounding * (1 + std::fabs(expected[i])))) { // true for NaN, too
            test.check(false, what + " has " + std::to_string(got[i]) + " in place of " + std::to_string(expected[i]) +
                                  " in pixel " + std::to_string(i / 4) + ".");
            return;
        }
    }
}

void expectColor(Test& test, const Image& got, uint32_t width, const Area& area, const float* rgb, float tolerance,
                 const std::string& what) {
    for (uint32_t y = area.y0; y < area.y1; ++y)
        for (uint32_t x = area.x0; x < area.x1; ++x) {
            const float* p = pixel(got, width, x, y);
            bool isEqual = true;
            for (int c = 0; c < 3; ++c)
                isEqual = isEqual && std::fabs(p[c] - rgb[c]) <= tolerance * std::max(1.0f, std::fabs(rgb[c]));
            if (!test.check(isEqual, what + ": " + colorText(p) + " in place of " + colorText(rgb) +
                                         at(size_t(y) * width + x, width) + "."))
                return;
        }
}

std::string unsupportedReason(Test& test, const std::string& technique) {
    if (!hasCoverageSamples(technique))
        return {};
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getDeviceCaps(test.sdk, nullptr, &caps), "asking for the capabilities of the device");
    const bool hasAtomics = caps.flags & AGAA_DEVICE_FRAGMENT_ATOMICS;
    return hasAtomics ? "" : "\"" + technique + "\" needs atomics in fragment shaders, which the device lacks.";
}

std::vector<std::string> techniques(Test& test) {
    uint32_t count = 0;
    test.sdk.agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, nullptr);
    std::vector<const char*> names(count);
    test.sdk.agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, names.data());
    std::vector<std::string> able;
    for (const char* name : names)
        if (unsupportedReason(test, name).empty())
            able.push_back(name);
    return able;
}

void setTechnique(ViewDescription& description, const std::string& technique, uint32_t samples) {
    description.setTechnique(technique, samples);
}

} // namespace agaa::conformance
