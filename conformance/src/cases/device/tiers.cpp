// Settings that a device cannot run: agaa…CreateView refuses them, and the context stays usable.
#include "cases.h"

#include "cases/core/structs.h"
#include "cases/core/view_parts.h"
#include "frame_rig.h"

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
    suite.both("AgaaDeviceCaps.sampleCounts/AGAA_ERROR_UNSUPPORTED", testSampleCounts);
    suite.add("AgaaSceneFacts.maxLights/AGAA_ERROR_UNSUPPORTED", {Backend::OpenGl}, testLightsOfBlocks);
}

} // namespace agaa::conformance
