// The tiers LAYERS and NV_MULTICAST on stand-ins for devices with sample locations and viewport multicast.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace agaa::conformance {

namespace {

// A device that seems to have the extensions of the tiers. A host that enables them has their names and features.
struct LayeredDevice {
    VulkanInterposer vulkan;
    std::vector<const char*> extensions;
    VkPhysicalDeviceFeatures2 features;

    explicit LayeredDevice(Device& device) {
        const AgaaVkDeviceDesc vk = device.description().vk;
        extensions.assign(vk.enabledExtensions, vk.enabledExtensions + vk.enabledExtensionCount);
        for (const char* name : {VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME, VK_NV_VIEWPORT_ARRAY_2_EXTENSION_NAME}) {
            extensions.push_back(name);
            vulkan.moreExtensions.push_back(name);
        }
        vulkan.sampleLocations.isFaked = true;
        features = *static_cast<const VkPhysicalDeviceFeatures2*>(vk.enabledFeatures);
        features.features.multiViewport = VK_TRUE;
        vulkan.changeFeatures = [](VkPhysicalDeviceFeatures2& has) { has.features.multiViewport = VK_TRUE; };
        vulkan.changeProperties = [](VkPhysicalDeviceProperties& p) {
            p.limits.maxViewports = std::max(p.limits.maxViewports, 16u);
        };
    }
    void use(ContextDescription& d) {
        vulkan.chainTo(d);
        d.vk.enabledExtensions = extensions.data();
        d.vk.enabledExtensionCount = uint32_t(extensions.size());
        d.vk.enabledFeatures = &features;
    }
};

uint64_t flagsOf(Test& test, Device& device, const ScopedContext& context) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(device.getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
    if (!(caps.sampleCounts & 4))
        test.skip("the device lacks 4 samples.");
    return caps.flags;
}

void without(std::vector<const char*>& names, const char* name) {
    std::erase_if(names, [=](const char* other) { return !std::strcmp(other, name); });
}

struct LayeredView : ViewDescription {
    LayeredView(Device& device, uint32_t tier) : ViewDescription(&device) {
        conformance::setTechnique(*this, "agaa", 16);
        config.visibilityTier = tier;
    }
};

struct Calls {
    const VulkanInterposer* vulkan;
    std::vector<size_t> sets = {}; // of locations before each call
    std::vector<AgaaDrawState> states = {};
    std::vector<std::vector<AgaaViewport>> viewports = {};
    static AgaaResult AGAA_CALL add(void* user, const AgaaDrawTarget* target) {
        auto& calls = *static_cast<Calls*>(user);
        calls.sets.push_back(calls.vulkan->sampleLocations.sets.size());
        calls.states.push_back(target->state);
        calls.viewports.emplace_back(target->viewports, target->viewports + target->viewportCount);
        return AGAA_OK;
    }
};

// The frame is recorded and never run.
void record(Test& test, Device& device, AgaaView view, const ViewDescription& d, Calls& calls,
            const std::string& what) {
    device.setOutput(32, 24);
    device.discardsCommands = true;
    AgaaFrame frame = pixelFrame(device, d, 1);
    frame.drawUser = &calls;
    frame.draw = Calls::add;
    test.result(device.record(test.sdk, view, frame, {}), AGAA_OK, what);
    device.discardsCommands = false;
}

// Each draw callback finds the locations set, and depth images and their transitions have them.
void testLocations(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        for (const uint32_t tier : {AGAA_TIER_LAYERS, AGAA_TIER_NV_MULTICAST})
            for (const uint32_t recording : {AGAA_VK_RECORDING_INLINE, AGAA_VK_RECORDING_SECONDARY})
                for (const uint32_t rendering : {AGAA_VK_RENDERING_DYNAMIC, AGAA_VK_RENDERING_RENDER_PASS}) {
                    const std::string what = std::string("a frame of the tier ") + inner.sdk.agaaTierName(tier) +
                                             ", recording " + std::to_string(recording) + " and rendering " +
                                             std::to_string(rendering);
                    LayeredDevice layered(*device);
                    ScopedContext context(inner, [&](ContextDescription& d) {
                        layered.use(d);
                        d.vk.recording = recording;
                        d.vk.rendering = rendering;
                    });
                    const uint64_t both = AGAA_DEVICE_SAMPLE_LOCATIONS | AGAA_DEVICE_NV_MULTICAST;
                    inner.check((flagsOf(inner, *device, context) & both) == both,
                                "the caps lack AGAA_DEVICE_SAMPLE_LOCATIONS or AGAA_DEVICE_NV_MULTICAST.");
                    const LayeredView d(*device, tier);
                    AgaaView view = nullptr;
                    inner.requireOk(device->createView(inner.sdk, context.get(), &d.desc, &view), "agaaVkCreateView");
                    const auto& found = layered.vulkan.sampleLocations;
                    inner.check(found.images == 1,
                                what + " has " + std::to_string(found.images) + " depth images with locations.");
                    Calls calls{&layered.vulkan};
                    record(inner, *device, view, d, calls, what);
                    const auto isEqual = [](const VkSampleLocationEXT& a, const VkSampleLocationEXT& b) {
                        return a.x == b.x && a.y == b.y;
                    };
                    inner.check(!found.transitions.empty(), what + " reads the depth in the layout of an attachment.");
                    for (const auto& locations : found.transitions)
                        inner.check(!found.sets.empty() && std::ranges::equal(locations, found.sets[0], isEqual),
                                    what + " moves the depth with other locations than those of the draws.");
                    for (size_t i = 0; i < calls.sets.size(); ++i)
                        inner.check(calls.sets[i] == i + 1, what + " calls back before it sets locations.");
                    inner.check(!calls.states.empty() && found.sets.size() == calls.states.size(),
                                what + " sets locations " + std::to_string(found.sets.size()) + " times for " +
                                    std::to_string(calls.states.size()) + " draws.");
                    for (const std::vector<VkSampleLocationEXT>& set : found.sets) {
                        inner.check(set.size() == 4, what + " sets other locations than those of 4 samples.");
                        for (const VkSampleLocationEXT& at : set)
                            inner.check(std::floor(16 * at.x) == 16 * at.x && std::floor(16 * at.y) == 16 * at.y &&
                                            at.x >= 0.25f && at.x < 0.75f && at.y >= 0.25f && at.y < 0.75f,
                                        what + " sets a location off the grid, or outside the middle of the texel.");
                    }
                    for (size_t i = 0; i < calls.states.size(); ++i) {
                        const uint32_t multicast = tier == AGAA_TIER_NV_MULTICAST ? 4 : 0;
                        inner.check(calls.states[i].multicast == multicast && calls.states[i].sampleLocations == 1 &&
                                        calls.viewports[i].size() == 4,
                                    what + " has another state than that of four layers.");
                    }
                    inner.sdk.agaaDestroyView(view);
                    expectNoMessages(inner, what);
                }
    });
}

void testAbsent(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        const auto expectNone = [&](uint64_t flag, const std::string& what, const auto& change) {
            LayeredDevice layered(*device);
            change(layered);
            ScopedContext context(inner, [&](ContextDescription& d) { layered.use(d); });
            inner.check(!(flagsOf(inner, *device, context) & flag), what + ", and the caps have the feature.");
            const LayeredView d(*device, AGAA_TIER_NV_MULTICAST);
            AgaaView view = nullptr;
            const AgaaResult result = device->createView(inner.sdk, context.get(), &d.desc, &view);
            if (flag == AGAA_DEVICE_NV_MULTICAST)
                expectRefused(inner, result, AGAA_ERROR_UNSUPPORTED, context.log, "agaaVkCreateView",
                              "agaaVkCreateView with nv-multicast", "multicast");
            else
                inner.check(result == AGAA_OK && layered.vulkan.sampleLocations.images == 0,
                            what + ", and views have images with locations.");
            if (view)
                inner.sdk.agaaDestroyView(view);
        };
        const auto lacks = [](const char* extension) {
            return [=](LayeredDevice& d) {
                without(d.vulkan.moreExtensions, extension);
                d.vulkan.lessExtensions = {extension};
            };
        };
        const auto leavesOut = [](const char* extension) {
            return [=](LayeredDevice& d) { without(d.extensions, extension); };
        };
        for (const auto& [flag, name] :
             {std::pair{AGAA_DEVICE_SAMPLE_LOCATIONS, VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME},
              {AGAA_DEVICE_NV_MULTICAST, VK_NV_VIEWPORT_ARRAY_2_EXTENSION_NAME}}) {
            expectNone(flag, std::string("the device lacks ") + name, lacks(name));
            expectNone(flag, std::string("the host did not enable ") + name, leavesOut(name));
        }
        expectNone(AGAA_DEVICE_NV_MULTICAST, "the host did not enable multiViewport",
                   [](LayeredDevice& d) { d.features.features.multiViewport = VK_FALSE; });
        expectNone(AGAA_DEVICE_NV_MULTICAST, "the host did not enable geometryShader",
                   [](LayeredDevice& d) { d.features.features.geometryShader = VK_FALSE; });
        expectNone(AGAA_DEVICE_SAMPLE_LOCATIONS, "a render pass has one set of locations",
                   [](LayeredDevice& d) { d.vulkan.sampleLocations.areVariable = false; });
        expectNone(AGAA_DEVICE_NV_MULTICAST, "the device has 4 viewports", [](LayeredDevice& d) {
            d.vulkan.changeProperties = [](VkPhysicalDeviceProperties& p) { p.limits.maxViewports = 4; };
        });
        expectNone(AGAA_DEVICE_SAMPLE_LOCATIONS, "the grid is coarse",
                   [](LayeredDevice& d) { d.vulkan.sampleLocations.subPixelBits = 3; });
        expectNone(AGAA_DEVICE_SAMPLE_LOCATIONS, "the range ends early",
                   [](LayeredDevice& d) { d.vulkan.sampleLocations.highest = 0.5f; });
        expectNone(AGAA_DEVICE_SAMPLE_LOCATIONS, "four samples cannot be placed",
                   [](LayeredDevice& d) { d.vulkan.sampleLocations.counts = 2; });
    });
}

} // namespace

void addVulkanLayerCases(Suite& suite) {
    suite.add("AGAA_DEVICE_SAMPLE_LOCATIONS/recorded", {Backend::Vulkan}, testLocations);
    suite.add("AGAA_DEVICE_SAMPLE_LOCATIONS/absent", {Backend::Vulkan}, testAbsent);
}

} // namespace agaa::conformance
