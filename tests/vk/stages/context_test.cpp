// Features that a host did not enable.
#include "stage_host.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

// What the host did not enable is not used, though the device has it.
TEST(VkMisuse, WhatWasNotEnabledIsNotThere) {
    AgaaDeviceCaps all = AGAA_DEVICE_CAPS_INIT, least = AGAA_DEVICE_CAPS_INIT;
    const StageContext usual;
    ASSERT_EQ(agaaVkGetContextCaps(usual.get(), &all), AGAA_OK);
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, nullptr, {}};
    features.features.shaderStorageImageExtendedFormats = VK_TRUE;
    features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    StageContext context({.change = [&](auto& desc) {
        desc.device.enabledFeatures = &features;
        desc.device.enabledExtensionCount = 0;
    }});
    ASSERT_EQ(agaaVkGetContextCaps(context.get(), &least), AGAA_OK);
    const uint64_t dropped = AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                             AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_DYNAMIC_RENDERING |
                             AGAA_DEVICE_GEOMETRY_SHADERS | AGAA_DEVICE_CONDITIONAL_RENDERING |
                             AGAA_DEVICE_FRAGMENT_INTERLOCK | AGAA_DEVICE_FRAMEBUFFER_FETCH;
    EXPECT_NE(all.flags & AGAA_DEVICE_FRAGMENT_ATOMICS, 0u);
    EXPECT_EQ(least.flags, all.flags & ~dropped);
    ViewSettings settings;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "counters without atomics");
}

} // namespace
} // namespace agaa::test
