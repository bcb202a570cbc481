// Tiers on devices whose properties are changed: agaaResizeView if AUTO selects another tier at the new size, with
// small storage buffers, and frames of the tier NV_MIXED_SAMPLES, which are recorded and never run.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

#include <cstring>

namespace agaa::conformance {

namespace {

// The aggregates of a view of 32 x 24 pixels fit a storage buffer, but those of larger views do not.
uint32_t shortRange(Test& test, const ViewDescription& description) {
    ScopedContext context(test);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    uint32_t count = 64;
    std::vector<AgaaSurface> surfaces(count, initial);
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, nullptr, &count, surfaces.data()),
                   "agaaQueryMemory");
    for (const AgaaSurface& surface : surfaces)
        if (!std::strcmp(surface.name, "aggregates"))
            return uint32_t(surface.bytes);
    test.skip("AUTO keeps no aggregates in memory on this device.");
}

struct ShortDevice {
    VulkanInterposer vulkan;
    ShortDevice(Test& test, const ViewDescription& description) {
        const uint32_t range = shortRange(test, description);
        vulkan.changeProperties = [=](VkPhysicalDeviceProperties& p) { p.limits.maxStorageBufferRange = range; };
    }
    static void use(ContextDescription& d) { d.vk.getProcAddr = VulkanInterposer::getProcAddr; }
};

std::vector<uint64_t> keysOf(Test& test, AgaaView view) {
    uint32_t count = 8;
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(count, initial);
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    std::vector<uint64_t> keys;
    for (uint32_t i = 0; i < count; ++i)
        keys.push_back(passes[i].pipelineKey);
    return keys;
}

// The view works with the other tier, and again with the first one.
void testOtherTier(Test& test) {
    const ViewDescription description(&test.device());
    ShortDevice device(test, description);
    Rig rig(test, {}, ShortDevice::use);
    const Image image = rig.render();
    const std::vector<uint64_t> keys = keysOf(test, rig.view.get());
    test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 64, 48), "agaaResizeView to a size that needs another tier");
    test.check(keysOf(test, rig.view.get()) != keys, "AUTO selects the same tier although the aggregates do not fit.");
    rig.device().prepare(test.sdk, rig.view.get());
    rig.device().setOutput(64, 48);
    ViewDescription larger(&rig.device());
    larger.desc.width = 64;
    larger.desc.height = 48;
    const Scene small = rig.scene;
    rig.scene = smallScene(64, 48);
    AgaaFrame frame = pixelFrame(rig.device(), larger, rig.recorded + 1);
    test.requireOk(rig.record(frame), "a frame with another tier");
    const float masked[] = {0.25f, 0.75f, 0.5f};
    expectColor(test, rig.device().readOutput(), 64, {32, 0, 48, 24}, masked, 0.01f,
                "the masked rectangle with another tier");
    test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 32, 24), "agaaResizeView back");
    test.check(keysOf(test, rig.view.get()) == keys, "the first size has other keys than at first.");
    rig.device().setOutput(32, 24);
    rig.scene = small;
    expectNextFrame(rig, image, "agaaResizeView back");
}

// ---- a text that the passes of one tier compile, and those of another do not ------------------------

struct ShadowView : ViewParts {
    std::string text;
    ShadowView(Test& test, const std::string& word) : ViewParts(test.sdk, &test.device()) {
        text =
            std::string("float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }\n#define ") + word + " )\n";
        facts.shadowMapCount = 1;
        shadow.glsl = text.c_str();
        chain(shadow);
    }
};

// Words that passes may use after the function of the host.
constexpr const char* words[] = {"samples", "left",  "group", "base",     "best",    "masks",
                                 "mask",    "sum",   "next",  "farthest", "members", "reach",
                                 "depth",   "first", "other", "taken",    "covered", "weight"};

void testText(Test& test) {
    const ViewDescription description(&test.device());
    ShortDevice device(test, ShadowView(test, "unused_word"));
    ScopedContext context(test, ShortDevice::use);
    for (const char* word : words) {
        ShadowView parts(test, word);
        AgaaView view = nullptr, larger = nullptr;
        const AgaaResult small = test.device().createView(test.sdk, context.get(), &parts.desc, &view);
        parts.desc.width = 64;
        parts.desc.height = 48;
        const AgaaResult large =
            small ? small : test.device().createView(test.sdk, context.get(), &parts.desc, &larger);
        if (!large && larger)
            test.sdk.agaaDestroyView(larger);
        context.log.lines.clear();
        const bool isFound = small == AGAA_OK && large == AGAA_ERROR_INVALID_ARGUMENT;
        if (isFound) {
            const std::map<std::string, int64_t> before = device.vulkan.objects;
            const std::vector<uint64_t> keys = keysOf(test, view);
            expectRefused(
                test, test.sdk.agaaResizeView(view, 64, 48), AGAA_ERROR_INVALID_ARGUMENT, context.log, "agaaResizeView",
                "agaaResizeView where a text does not compile in the passes of another tier", "AgaaShadowFunction");
            test.check(device.vulkan.objects == before && keysOf(test, view) == keys,
                       "agaaResizeView fails because of a text, and changes the view.");
        }
        if (view)
            test.sdk.agaaDestroyView(view);
        if (isFound)
            return;
    }
    test.skip("the suite has no text that the passes of one tier compile, and those of another do not.");
}

// ---- mixed samples ----------------------------------------------------------------------------------

// A device that seems to have the extensions of the tier NV_MIXED_SAMPLES. Frames are recorded and never run.
struct MixedDevice {
    VulkanInterposer vulkan;
    std::vector<const char*> extensions;
    VkPhysicalDeviceFeatures2 features;
    VkPhysicalDeviceCoverageReductionModeFeaturesNV reduction{};

    MixedDevice(Device& device, VkCoverageReductionModeNV mode) {
        const AgaaVkDeviceDesc vk = device.description().vk;
        extensions.assign(vk.enabledExtensions, vk.enabledExtensions + vk.enabledExtensionCount);
        for (const char* name :
             {VK_NV_FRAMEBUFFER_MIXED_SAMPLES_EXTENSION_NAME, VK_NV_SAMPLE_MASK_OVERRIDE_COVERAGE_EXTENSION_NAME,
              VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME}) {
            extensions.push_back(name);
            vulkan.moreExtensions.push_back(name);
        }
        features = *static_cast<const VkPhysicalDeviceFeatures2*>(vk.enabledFeatures);
        reduction.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV;
        reduction.pNext = features.pNext;
        reduction.coverageReductionMode = VK_TRUE;
        features.pNext = &reduction;
        vulkan.changeFeatures = [](VkPhysicalDeviceFeatures2& has) {
            for (auto* next = static_cast<VkBaseOutStructure*>(has.pNext); next; next = next->pNext)
                if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV)
                    reinterpret_cast<VkPhysicalDeviceCoverageReductionModeFeaturesNV*>(next)->coverageReductionMode =
                        VK_TRUE;
        };
        VkFramebufferMixedSamplesCombinationNV four{};
        four.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_MIXED_SAMPLES_COMBINATION_NV;
        four.coverageReductionMode = mode;
        four.rasterizationSamples = VK_SAMPLE_COUNT_4_BIT;
        four.depthStencilSamples = VK_SAMPLE_COUNT_4_BIT;
        four.colorSamples = VK_SAMPLE_COUNT_1_BIT;
        vulkan.mixedSamples = {four};
    }
    void use(ContextDescription& d) {
        vulkan.chainTo(d);
        d.vk.enabledExtensions = extensions.data();
        d.vk.enabledExtensionCount = uint32_t(extensions.size());
        d.vk.enabledFeatures = &features;
    }
};

struct MixedView : ViewDescription {
    MixedView(Device& device, uint32_t aggregates) : ViewDescription(&device) {
        conformance::setTechnique(*this, "agaa", 4);
        config.aggregates = aggregates;
        config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    }
};

// Messages about numbers of samples are those of a device without the extensions.
void expectSampleMessagesOnly(Test& test, const std::string& what) {
    for (const std::string& message : test.device().takeMessages())
        test.check(message.find("ample") != std::string::npos, what + ": " + message);
}

void testMixedSamples(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        for (const uint32_t recording : {AGAA_VK_RECORDING_INLINE, AGAA_VK_RECORDING_SECONDARY})
            for (const uint32_t rendering : {AGAA_VK_RENDERING_DYNAMIC, AGAA_VK_RENDERING_RENDER_PASS}) {
                const std::string what = "a frame of the tier NV_MIXED_SAMPLES, recording " +
                                         std::to_string(recording) + " and rendering " + std::to_string(rendering);
                MixedDevice mixed(*device, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
                ScopedContext context(inner, [&](ContextDescription& d) {
                    mixed.use(d);
                    d.vk.recording = recording;
                    d.vk.rendering = rendering;
                });
                AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
                inner.requireOk(device->getContextCaps(inner.sdk, context.get(), &caps), "agaaVkGetContextCaps");
                if (!(caps.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE) || !(caps.sampleCounts & 4))
                    inner.skip("the device lacks 4 samples or post-depth coverage.");
                inner.check(caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES, "the caps lack AGAA_DEVICE_NV_MIXED_SAMPLES.");
                const MixedView d(*device, 1);
                AgaaView view = nullptr;
                inner.requireOk(device->createView(inner.sdk, context.get(), &d.desc, &view), "agaaVkCreateView");
                device->setOutput(32, 24);
                device->discardsCommands = true;
                std::vector<AgaaDrawState> states;
                AgaaFrame frame = pixelFrame(*device, d, 1);
                frame.drawUser = &states;
                frame.draw = [](void* user, const AgaaDrawTarget* target) -> AgaaResult {
                    static_cast<std::vector<AgaaDrawState>*>(user)->push_back(target->state);
                    return AGAA_OK;
                };
                inner.result(device->record(inner.sdk, view, frame, {}), AGAA_OK, what);
                inner.require(states.size() == 2, what + " draws " + std::to_string(states.size()) + " times.");
                inner.check(states[1].additive && states[1].samples == 4 && states[1].colorSamples == 1,
                            what + " has another state than additive blending of 4 samples into one.");
                device->discardsCommands = false;
                inner.sdk.agaaDestroyView(view);
                expectSampleMessagesOnly(inner, what);
            }
    });
}

// Adds a triangle with a vertical edge at x and a corner at `end`, in an image of 32 x 24 pixels. Its other edges are
// outside of the area that testBlendedImage() compares. It is inside of the image, because clipping would divide it.
void addColumns(Scene& scene, float x, float end, float distance, const Surface& surface) {
    const size_t first = scene.size();
    addRectangle(scene, 32, 24, 0, 0, 1, 1, distance, surface);
    scene.resize(first + 3);
    const float corners[3][2] = {{x, 0}, {x, 24}, {end, 12}};
    for (size_t i = 0; i < 3; ++i) {
        scene[first + i].position[0] = corners[i][0] - 16;
        scene[first + i].position[1] = 12 - corners[i][1];
    }
}

// Removes the override of coverage, which most drivers do not compile.
void removeOverride(std::string& text) {
    for (const std::string line : {"#extension GL_NV_sample_mask_override_coverage : require\n",
                                   "layout(override_coverage) out int gl_SampleMask[];\n"})
        if (const size_t at = text.find(line); at != std::string::npos)
            text.erase(at, line.size());
}

// With a colour sample for each sample of the depth no samples are mixed. Without the override of coverage a fragment
// still writes a sample that it covers: the left half of a pixel has the samples 0 and 2, the right half 1 and 3. So
// drivers without the extensions run the passes of the tier.
void testBlendedImage(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        MixedDevice mixed(*device, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
        ScopedContext context(inner, [&](ContextDescription& d) { mixed.use(d); });
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        inner.requireOk(device->getContextCaps(inner.sdk, context.get(), &caps), "agaaVkGetContextCaps");
        if (!(caps.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE) || !(caps.sampleCounts & 4))
            inner.skip("the device lacks 4 samples or post-depth coverage.");
        Scene scene;
        Surface surface;
        surface.emissive[0] = 3;
        addColumns(scene, 0, 32, 8, surface);
        surface = {{0.1f, 0.7f, 0.3f, 1}, {0.6f, 0, 0.8f}, {0.2f, 0.4f, 0.9f}, 0.3f};
        addColumns(scene, 14, 32, 6, surface);
        surface.emissive[1] = 0.25f;
        addColumns(scene, 8.5f, 0, 4, surface); // the first aggregate of pixels is the nearer one
        std::vector<Image> images;
        for (const uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_NV_MIXED_SAMPLES}) {
            MixedView d(*device, 4);
            d.config.generationTier = tier;
            AgaaView view = nullptr;
            inner.requireOk(device->createView(inner.sdk, context.get(), &d.desc, &view), "agaaVkCreateView");
            device->setOutput(32, 24);
            device->mistakes.changeFragmentShader = removeOverride;
            device->prepare(inner.sdk, view);
            AgaaFrame frame = pixelFrame(*device, d, 1);
            AgaaLight light = AGAA_LIGHT_INIT; // shows normals and roughness
            light.direction[1] = 0.6f;
            light.direction[2] = -0.8f;
            frame.lights = &light;
            frame.lightCount = 1;
            inner.result(device->record(inner.sdk, view, frame, scene), AGAA_OK, "a frame");
            const Image image = device->readOutput();
            Image& area = images.emplace_back(); // columns 4 to 19 of rows 9 to 14
            for (size_t row = 9; row < 15; ++row)
                area.insert(area.end(), &image[(row * 32 + 4) * 4], &image[(row * 32 + 20) * 4]);
            device->forget(view);
            inner.sdk.agaaDestroyView(view);
        }
        expectAlike(inner, images[1], images[0], 5e-4f, "the tier NV_MIXED_SAMPLES against POST_DEPTH_ATOMICS");
        expectNoMessages(inner, "a frame with additive blending");
    });
}

void testUnmixedSamples(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        AgaaDeviceCaps real = AGAA_DEVICE_CAPS_INIT;
        ScopedContext own(inner);
        inner.requireOk(device->getContextCaps(inner.sdk, own.get(), &real), "agaaVkGetContextCaps");
        if (!(real.flags & AGAA_DEVICE_POST_DEPTH_COVERAGE) || !(real.sampleCounts & 4))
            inner.skip("the device lacks 4 samples or post-depth coverage.");
        const auto expectNone = [&](const std::string& what, const auto& change) {
            MixedDevice mixed(*device, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
            change(mixed);
            ScopedContext context(inner, [&](ContextDescription& d) { mixed.use(d); });
            AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
            inner.requireOk(device->getContextCaps(inner.sdk, context.get(), &caps), "agaaVkGetContextCaps");
            inner.check(!(caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES),
                        what + ", and the caps have AGAA_DEVICE_NV_MIXED_SAMPLES.");
        };
        expectNone("the device has merged coverage only", [](MixedDevice& m) {
            m.vulkan.mixedSamples[0].coverageReductionMode = VK_COVERAGE_REDUCTION_MODE_MERGE_NV;
        });
        expectNone("the host enabled no coverageReductionMode",
                   [](MixedDevice& m) { m.reduction.coverageReductionMode = VK_FALSE; });
        for (size_t i = 0; i < 3; ++i) {
            const auto name = [&](MixedDevice& m) { return m.extensions.end() - 1 - std::ptrdiff_t(i); };
            expectNone("the host lacks one of the extensions", [&](MixedDevice& m) { m.extensions.erase(name(m)); });
            expectNone("the device lacks one of the extensions", [&](MixedDevice& m) {
                const auto at = m.vulkan.moreExtensions.begin() + std::ptrdiff_t(i);
                m.vulkan.lessExtensions = {*at};
                m.vulkan.moreExtensions.erase(at);
            });
        }
        const auto expectNoView = [&](MixedDevice& mixed, const std::string& what, const std::string& words) {
            ScopedContext context(inner, [&](ContextDescription& d) { mixed.use(d); });
            const MixedView d(*device, 1);
            AgaaView view = nullptr;
            const AgaaResult result = device->createView(inner.sdk, context.get(), &d.desc, &view);
            expectRefused(inner, result, AGAA_ERROR_UNSUPPORTED, context.log, "agaaVkCreateView",
                          "agaaVkCreateView with " + what, words);
        };
        MixedDevice other(*device, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
        other.vulkan.mixedSamples[0].colorSamples = VK_SAMPLE_COUNT_2_BIT;
        expectNoView(other, "samples that the device cannot combine", "truncated coverage");
        MixedDevice unblended(*device, VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV);
        unblended.vulkan.changeFormat = [](VkFormat, VkFormatProperties& p) {
            p.optimalTilingFeatures &= ~VkFormatFeatureFlags(VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT);
        };
        expectNoView(unblended, "formats that the device does not blend", "does not blend");
    });
}

} // namespace

void addVulkanTierCases(Suite& suite) {
    suite.add("AGAA_TIER_NV_MIXED_SAMPLES/recorded", {Backend::Vulkan}, testMixedSamples);
    suite.add("AGAA_TIER_NV_MIXED_SAMPLES/image", {Backend::Vulkan}, testBlendedImage);
    suite.add("AGAA_DEVICE_NV_MIXED_SAMPLES/absent", {Backend::Vulkan}, testUnmixedSamples);
    suite.add("agaaResizeView/other_tier", {Backend::Vulkan}, testOtherTier);
    suite.add("agaaResizeView/AGAA_ERROR_INVALID_ARGUMENT/text", {Backend::Vulkan}, testText);
}

} // namespace agaa::conformance
