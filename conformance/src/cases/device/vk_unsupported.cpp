// Vulkan devices that the SDK cannot use, or no longer.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

namespace agaa::conformance {

namespace {

void interpose(ContextDescription& d) { d.vk.getProcAddr = VulkanInterposer::getProcAddr; }

void testDeviceOfOtherSort(Test& test) {
    VulkanInterposer vulkan;
    vulkan.changeProperties = [](VkPhysicalDeviceProperties& p) { p.apiVersion = VK_API_VERSION_1_1; };
    expectContextRefused(test, {"a device of Vulkan 1.1", AGAA_ERROR_UNSUPPORTED, "1.2", interpose});
    vulkan.changeProperties = nullptr;
    for (const VkQueueFlags missing : {VK_QUEUE_GRAPHICS_BIT, VK_QUEUE_COMPUTE_BIT}) {
        vulkan.changeQueueFamily = [=](VkQueueFamilyProperties& p) { p.queueFlags &= ~missing; };
        expectContextRefused(test, {"a queue family without the flag " + std::to_string(missing),
                                    AGAA_ERROR_UNSUPPORTED, "queue family", interpose});
    }
}

void testFeatures(Test& test) {
    using Feature = VkBool32 VkPhysicalDeviceFeatures::*;
    for (const Feature feature : {&VkPhysicalDeviceFeatures::shaderStorageImageExtendedFormats,
                                  &VkPhysicalDeviceFeatures::shaderStorageImageWriteWithoutFormat}) {
        VkPhysicalDeviceFeatures2 features =
            *static_cast<const VkPhysicalDeviceFeatures2*>(test.device().description().vk.enabledFeatures);
        features.features.*feature = VK_FALSE;
        expectContextRefused(test,
                             {"enabledFeatures without a feature shaderStorageImage…", AGAA_ERROR_UNSUPPORTED,
                              "storage images", [&](ContextDescription& d) { d.vk.enabledFeatures = &features; }});
    }
}

// Returns whether a context needs the function. It works without functions of extensions and later versions.
bool isCore(const std::string& name) {
    const std::string end = name.substr(name.size() - 3);
    return end != "EXT" && end != "KHR" && name.find("Rendering") == std::string::npos;
}

void testMissing(Test& test) {
    VulkanInterposer vulkan;
    expectContextAccepted(test, "functions of the suite", interpose);
    const std::set<std::string> requested = vulkan.requested;
    test.require(requested.count("vkGetDeviceProcAddr") && requested.count("vkCreateImage"),
                 "agaaVkCreateContext does not ask getProcAddr for the functions of Vulkan.");
    for (const std::string& name : requested) {
        vulkan.missing = {name};
        if (isCore(name))
            expectContextRefused(test, {"no function " + name, AGAA_ERROR_UNSUPPORTED, name, interpose});
        else
            expectContextAccepted(test, "no function " + name, interpose);
    }
}

void testContextUnsupported(Test& test) {
    testContextRows(test, rowsOf(wrongVulkanContexts(test.device()), AGAA_ERROR_UNSUPPORTED));
    testFeatures(test);
    testDeviceOfOtherSort(test);
    testMissing(test);
}

// The device no longer supports images of the formats of the view.
void testFormats(Test& test) {
    VulkanInterposer vulkan;
    Rig rig(test, {}, interpose);
    const Image image = rig.render();
    const std::map<std::string, int64_t> before = vulkan.objects;
    vulkan.hasImageFormats = false;
    expectRefused(test, test.sdk.agaaResizeView(rig.view.get(), 48, 40), AGAA_ERROR_UNSUPPORTED, rig.context.log,
                  "agaaResizeView", "agaaResizeView on a device without images");
    test.check(vulkan.objects == before, "agaaResizeView fails and leaves " + objectsText(vulkan.objects) + ".");
    expectNextFrame(rig, image, "agaaResizeView on a device without images");
    vulkan.hasImageFormats = true;
    test.result(test.sdk.agaaResizeView(rig.view.get(), 48, 40), AGAA_OK, "agaaResizeView after one that failed");
}

} // namespace

void addVulkanUnsupportedCases(Suite& suite) {
    suite.add("agaaVkCreateContext/AGAA_ERROR_UNSUPPORTED", {Backend::Vulkan}, testContextUnsupported);
    suite.add("agaaResizeView/AGAA_ERROR_UNSUPPORTED", {Backend::Vulkan}, testFormats);
}

} // namespace agaa::conformance
