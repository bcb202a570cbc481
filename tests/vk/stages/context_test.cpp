// Contexts of Vulkan that are refused, and what they cannot do.
#include "context_misuse.h"
#include "stage_host.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

TEST(VkMisuse, ContextsAreRefusedInASentence) {
    static const VkPhysicalDeviceFeatures2 noFeatures{};
    static const VkPhysicalDeviceFeatures2 without{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, nullptr, {}};
    const auto rows = contextMisuses<AgaaVkContextDesc>({
        {"reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.reserved = 1; }},
        {"no instance", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.instance = nullptr; }},
        {"no physical device", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.physicalDevice = nullptr; }},
        {"no device", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device = nullptr; }},
        {"no extensions", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& d) {
             d.enabledExtensions = nullptr;
             d.enabledExtensionCount = 1;
         }},
        {"Vulkan 1.1", AGAA_ERROR_UNSUPPORTED, [](auto& d) { d.apiVersion = VK_API_VERSION_1_1; }},
        {"queue family", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.queueFamily = 99; }},
        {"features of another struct", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.enabledFeatures = &noFeatures; }},
        {"no feature enabled", AGAA_ERROR_UNSUPPORTED, [](auto& d) { d.enabledFeatures = &without; }},
        {"rendering", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.rendering = 3; }},
        {"recording", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.recording = 2; }},
        {"descriptor set", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.descriptorSet = 8; }},
        {"the other reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.reserved2 = 1; }},
    });
    expectContextsRefused(agaaVkCreateContext, contextDesc(), rows);
}

// What the host did not enable is not used, though the device has it.
TEST(VkMisuse, WhatWasNotEnabledIsNotThere) {
    AgaaDeviceCaps all = AGAA_DEVICE_CAPS_INIT, least = AGAA_DEVICE_CAPS_INIT;
    const StageContext usual;
    ASSERT_EQ(agaaVkGetContextCaps(usual.get(), &all), AGAA_OK);
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, nullptr, {}};
    features.features.shaderStorageImageExtendedFormats = VK_TRUE;
    features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    StageContext context({.change = [&](auto& desc) {
        desc.enabledFeatures = &features;
        desc.enabledExtensionCount = 0;
    }});
    ASSERT_EQ(agaaVkGetContextCaps(context.get(), &least), AGAA_OK);
    const uint64_t dropped = AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                             AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_DYNAMIC_RENDERING;
    EXPECT_NE(all.flags & AGAA_DEVICE_FRAGMENT_ATOMICS, 0u);
    EXPECT_EQ(least.flags, all.flags & ~dropped);
    ViewSettings settings;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "counters without atomics");
}

TEST(VkMisuse, OpenGLsClipSpaceIsRefused) {
    StageContext context;
    ViewSettings settings;
    settings.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "OpenGL's clip space");
}

} // namespace
} // namespace agaa::test
