#include "engine_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace agaa::conformance {

namespace {

// Copies the chained structs of the engine's view that provide geometry and materials. The suite renders without
// shadows, so it skips an AgaaShadowFunction.
struct ChainedFunctions {
    AgaaGBufferFunction gbuffer;
    AgaaFetchFunction fetch;
    const void* first = nullptr;

    explicit ChainedFunctions(const void* chain) {
        for (const auto* link = static_cast<const AgaaStructHeader*>(chain); link;
             link = static_cast<const AgaaStructHeader*>(link->pNext)) {
            if (link->sType == AGAA_STRUCTURE_TYPE_GBUFFER_FUNCTION)
                take(gbuffer, link);
            else if (link->sType == AGAA_STRUCTURE_TYPE_FETCH_FUNCTION)
                take(fetch, link);
        }
    }

private:
    template <class T> void take(T& copy, const AgaaStructHeader* link) {
        copy = *reinterpret_cast<const T*>(link);
        copy.pNext = first;
        first = &copy;
    }
};

} // namespace

EngineView::EngineView(Test& test, HostTest& hostTest, const ViewChoice& choice)
    : test_(test), hostTest_(hostTest), choice_(choice), width_(hostTest.host.view->width),
      height_(hostTest.host.view->height) {
    const Functions& sdk = hostTest.sdk;
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    test.requireOk(sdk.agaaGetBuiltinLayout(choice.layout, &layout), "agaaGetBuiltinLayout");
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
    if (choice.isWithoutStencil)
        measurement.flags |= AGAA_MEASURE_NO_STENCIL;
    AgaaConfig config = AGAA_CONFIG_INIT;
    config.pNext = &measurement;
    config.technique = choice.technique;
    config.samples = choice.samples;
    config.layout = &layout;
    config.flags = AGAA_CONFIG_COUNTERS;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT; // diffuse light only, so that images add up
    const uint64_t hostFlags = hostTest.host.view->facts ? hostTest.host.view->facts->flags : 0;
    facts.flags = AGAA_FACT_AMBIENT | (hostFlags & (AGAA_FACT_ALPHA_MASKED | AGAA_FACT_CUSTOM_DEPTH));
    facts.maxLights = 1;
    facts.shadowMapCount = 0;
    AgaaViewDesc desc = *hostTest.host.view;
    const ChainedFunctions functions(desc.pNext);
    desc.pNext = functions.first;
    desc.config = &config;
    desc.facts = &facts;
    const bool isVulkan = hostTest.host.api == AGAA_CONFORMANCE_VULKAN;
    const AgaaResult created = isVulkan ? sdk.agaaVkCreateView(hostTest.host.context, &desc, &view_)
                                        : sdk.agaaGlCreateView(hostTest.host.context, &desc, &view_);
    const std::string what = std::string("creating a view of \"") + choice.technique + "\"";
    if (created == AGAA_ERROR_UNSUPPORTED)
        test.skip(what + " is not supported here.");
    test.requireOk(created, what);
    const AgaaResult prepared =
        hostTest.host.prepareView ? hostTest.host.prepareView(hostTest.host.user, view_) : AGAA_OK;
    if (prepared != AGAA_OK) {
        sdk.agaaDestroyView(view_);
        test.requireOk(prepared, what + ": prepareView");
    }
}

EngineView::~EngineView() {
    if (hostTest_.host.releaseView)
        hostTest_.host.releaseView(hostTest_.host.user, view_);
    hostTest_.sdk.agaaDestroyView(view_);
}

AgaaFrame EngineView::nextFrame() {
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.completedFrame = frameIndex_;
    frame.frameIndex = ++frameIndex_;
    return frame;
}

Image EngineView::render(AgaaFrame& frame) {
    // The initial values do not occur in correct images, so they show unwritten pixels.
    Image image{width_, height_, std::vector<float>(size_t(width_) * height_ * 4, -1.0f)};
    const AgaaResult result = hostTest_.host.renderFrame(hostTest_.host.user, view_, &frame, image.pixels.data());
    test_.requireOk(result, std::string("renderFrame with \"") + choice_.technique + "\"");
    std::copy(frame.view, frame.view + 16, viewMatrix_.begin());
    std::copy(frame.projection, frame.projection + 16, projection_.begin());
    return image;
}

Image EngineView::renderAlbedo() {
    AgaaFrame frame = nextFrame();
    std::fill(frame.ambient, frame.ambient + 3, 1.0f);
    return render(frame);
}

Image EngineView::renderHeadlight() {
    if (frameIndex_ == 0)
        renderAlbedo(); // the host sets the view matrix
    AgaaLight light = AGAA_LIGHT_INIT;
    for (int i = 0; i < 3; ++i) {
        light.direction[i] = -viewMatrix_[size_t(4 * i + 2)]; // the camera's direction, row 2 of the rotation
        light.color[i] = 3.14159265f;
    }
    AgaaFrame frame = nextFrame();
    frame.lights = &light;
    frame.lightCount = 1;
    return render(frame);
}

uint32_t EngineView::drawPasses() const {
    uint32_t count = 0;
    test_.requireOk(hostTest_.sdk.agaaGetDrawPasses(view_, &count, nullptr), "agaaGetDrawPasses");
    return count;
}

AgaaFrameValidation EngineView::validate() {
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    test_.requireOk(hostTest_.sdk.agaaValidateFrame(view_, frameIndex_, &validation), "agaaValidateFrame");
    return validation;
}

AgaaCounters EngineView::counters() {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    test_.requireOk(hostTest_.sdk.agaaGetFrameStatistics(view_, frameIndex_, &statistics), "agaaGetFrameStatistics");
    return statistics.counters;
}

double differingShare(const Image& a, const Image& b, float tolerance) {
    size_t shown = 0, different = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4) {
        bool isShown = false, isDifferent = false;
        for (size_t c = i; c < i + 3; ++c) {
            isShown |= a.pixels[c] != 0 || b.pixels[c] != 0;
            isDifferent |= !(std::abs(a.pixels[c] - b.pixels[c]) <= tolerance); // true for NaN, too
        }
        shown += isShown;
        different += isDifferent;
    }
    return shown ? double(different) / double(shown) : 0.0;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
    return text;
}

} // namespace agaa::conformance
