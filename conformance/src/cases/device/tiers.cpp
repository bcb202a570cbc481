// Settings that a device cannot run: agaa…CreateView refuses them, and the context stays usable.
#include "cases.h"

#include "cases/core/structs.h"
#include "cases/core/view_parts.h"
#include "frame_rig.h"

#include <cmath>

namespace agaa::conformance {

namespace {

std::string createView(Test& test) {
    return test.device().backend() == Backend::Vulkan ? "agaaVkCreateView" : "agaaGlCreateView";
}

void expectCreated(Test& test, const ScopedContext& context, const ViewParts& parts, const std::string& what) {
    AgaaView view = nullptr;
    if (test.result(test.device().createView(test.sdk, context.get(), &parts.desc, &view), AGAA_OK,
                    callWith(createView(test), what)))
        test.sdk.agaaDestroyView(view);
}

// Returns the log's sentence.
std::string expectNotCreated(Test& test, ScopedContext& context, const ViewParts& parts, const std::string& what,
                             const std::string& words = "") {
    context.log.lines.clear();
    AgaaView view = nullptr;
    const AgaaResult result = test.device().createView(test.sdk, context.get(), &parts.desc, &view);
    const std::vector<LogLine> errors = context.log.errors();
    expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, context.log, createView(test), callWith(createView(test), what),
                  words);
    test.check(!view, callWith(createView(test), what) + " fails and returns a view.");
    if (view)
        test.sdk.agaaDestroyView(view);
    const std::string sentence = errors.empty() ? "" : errors.front().text;
    expectCreated(test, context, ViewParts(test.sdk, &test.device()), "a right view after " + what);
    return sentence;
}

void testMixedSamples(Test& test) {
    ScopedContext context(test);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "the capabilities of the context");
    if (caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES)
        test.skip("the device has AGAA_DEVICE_NV_MIXED_SAMPLES.");
    ViewParts parts(test.sdk, &test.device());
    parts.config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    expectNotCreated(test, context, parts, "generationTier = AGAA_TIER_NV_MIXED_SAMPLES");
}

// The tier sends a fragment to the aggregate of its first sample, as AGAA_MEASURE_FIRST_SAMPLE_ROUTING does.
void testMixedImage(Test& test) {
    {
        ScopedContext context(test);
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "the capabilities of the context");
        if (!(caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES))
            test.skip("the device lacks AGAA_DEVICE_NV_MIXED_SAMPLES.");
    }
    for (const uint32_t aggregates : {1u, 2u}) {
        const auto image = [&](uint32_t tier) {
            Rig rig(test, [&](ViewDescription& d) {
                d.setTechnique("agaa", 4);
                d.config.aggregates = aggregates;
                d.config.generationTier = tier;
                d.measurement.flags = AGAA_MEASURE_FIRST_SAMPLE_ROUTING;
            });
            return rig.render();
        };
        expectAlike(test, image(AGAA_TIER_NV_MIXED_SAMPLES), image(AGAA_TIER_POST_DEPTH_ATOMICS), 0.01f,
                    "the tier NV_MIXED_SAMPLES against POST_DEPTH_ATOMICS");
    }
}

// The left edge of a rectangle is 3/32 of a pixel inside. If 4 standard samples move by 1/16 of a pixel to both sides,
// one of the 8 is left of it. Samples of a scaled target, and those of layers without an offset, are all right of it.
void testLayeredImage(Test& test) {
    bool isPlaced = false;
    const auto image = [&](uint32_t tier) {
        Rig rig(test, [&](ViewDescription& d) {
            setTechnique(d, "agaa", 8);
            d.config.visibilityTier = tier;
        });
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.requireOk(test.device().getContextCaps(test.sdk, rig.context.get(), &caps), "the context's capabilities");
        isPlaced = caps.flags & AGAA_DEVICE_SAMPLE_LOCATIONS;
        if (!(caps.sampleCounts & 4))
            test.skip("the device lacks 4 samples.");
        const AgaaViewDesc& desc = rig.description().desc;
        Surface surface;
        surface.emissive[0] = 1;
        rig.scene.clear();
        addRectangle(rig.scene, desc.width, desc.height, 3 + 3.0f / 32, 2, float(desc.width) - 4,
                     float(desc.height) - 3, 5, surface);
        return rig.render();
    };
    const Image layers = image(AGAA_TIER_LAYERS), scaled = image(AGAA_TIER_SCALED_TARGET);
    test.require(layers.size() == scaled.size(), "the tiers LAYERS and SCALED_TARGET have images of one size");
    const size_t width = 32, row = 8 * width;
    const float inside = scaled[4 * (row + 10)], edge = layers[4 * (row + 3)] / inside;
    const float expected = isPlaced ? 1 : 7.0f / 8;
    test.check(std::fabs(scaled[4 * (row + 3)] / inside - 1) < 1e-3f, "SCALED_TARGET misses samples at the edge.");
    test.check(std::fabs(edge - expected) < 1e-3f,
               "LAYERS covers " + std::to_string(edge) + " of a pixel in place of " + std::to_string(expected) + ".");
    for (size_t x = 4; x < 28; ++x)
        test.check(std::fabs(layers[4 * (row + x)] - scaled[4 * (row + x)]) < 1e-3f * inside,
                   "LAYERS differs from SCALED_TARGET inside of a surface.");
}

void testSampleCounts(Test& test) {
    ScopedContext context(test);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps),
                   "asking for the capabilities of the context");
    for (uint32_t i = 1; i <= 5; ++i) {
        ViewParts parts(test.sdk, &test.device());
        parts.config.samples = 1u << i;
        parts.config.visibilityTier = AGAA_TIER_NATIVE;
        const std::string what = "AGAA_TIER_NATIVE, samples = " + std::to_string(1u << i) +
                                 " and sampleCounts = " + std::to_string(caps.sampleCounts);
        if (caps.sampleCounts >> i & 1)
            expectCreated(test, context, parts, what);
        else
            expectNotCreated(test, context, parts, what);
    }
}

// The sentence names the largest number, which is accepted.
void testLightsOfBlocks(Test& test) {
    ScopedContext context(test,
                          [](ContextDescription& description) { description.gl.storage = AGAA_GL_STORAGE_IMAGES; });
    ViewParts parts(test.sdk, &test.device());
    parts.config.technique = "msaa";
    parts.facts.maxLights = 4096;
    const std::string sentence = expectNotCreated(test, context, parts, "4096 lights in a uniform block", "4096");
    uint32_t most = 0;
    for (uint32_t n = 1; n < 4096; ++n)
        if (sentence.find(' ' + std::to_string(n) + ' ') != std::string::npos)
            most = n;
    test.require(most > 0, "the log does not name the largest number of lights: " + sentence);
    parts.facts.maxLights = most;
    expectCreated(test, context, parts, std::to_string(most) + " lights in a uniform block");
    parts.facts.maxLights = most + 1;
    expectNotCreated(test, context, parts, std::to_string(most + 1) + " lights in a uniform block",
                     std::to_string(most));
    parts.config.technique = "agaa";
    parts.facts.maxLights = 4096;
    expectCreated(test, context, parts, "\"agaa\" and 4096 lights");
}

} // namespace

void addTierCases(Suite& suite) {
    suite.both("AGAA_TIER_NV_MIXED_SAMPLES/AGAA_ERROR_UNSUPPORTED", testMixedSamples);
    suite.both("AGAA_TIER_NV_MIXED_SAMPLES/same_image", testMixedImage);
    suite.both("AGAA_TIER_LAYERS/image", testLayeredImage);
    suite.both("AgaaDeviceCaps.sampleCounts/AGAA_ERROR_UNSUPPORTED", testSampleCounts);
    suite.add("AgaaSceneFacts.maxLights/AGAA_ERROR_UNSUPPORTED", {Backend::OpenGl}, testLightsOfBlocks);
}

} // namespace agaa::conformance
