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
    EXPECT_EQ(least.subgroupSize, 0u);
    ViewSettings settings;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "counters without atomics");
}

// Subgroups may have fewer lanes than the device reports unless the host enabled computeFullSubgroups.
TEST(VkMisuse, SubgroupsNeedAFeatureThatTheHostNames) {
    const auto subgroupSizeOf = [](const StageContext& context) {
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        EXPECT_EQ(agaaVkGetContextCaps(context.get(), &caps), AGAA_OK);
        return caps.subgroupSize;
    };
    const uint32_t size = subgroupSizeOf(StageContext());
    if (size == 0)
        GTEST_SKIP() << "the device has no full subgroups";
    const auto subgroupSizeWith = [&](void* chain) {
        VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, chain, {}};
        features.features.shaderStorageImageExtendedFormats = VK_TRUE;
        features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
        return subgroupSizeOf(StageContext({.change = [&](auto& desc) { desc.device.enabledFeatures = &features; }}));
    };
    VkPhysicalDeviceVulkan13Features core{};
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    EXPECT_EQ(subgroupSizeWith(&core), 0u);
    core.computeFullSubgroups = VK_TRUE;
    EXPECT_EQ(subgroupSizeWith(&core), size);
    VkPhysicalDeviceSubgroupSizeControlFeatures control{};
    control.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_FEATURES;
    EXPECT_EQ(subgroupSizeWith(&control), 0u);
    control.computeFullSubgroups = VK_TRUE;
    EXPECT_EQ(subgroupSizeWith(&control), size);
    StageContext unknown({.change = [](auto& desc) { desc.device.enabledFeatures = nullptr; }});
    EXPECT_EQ(subgroupSizeOf(unknown), 0u);
    ViewSettings settings;
    settings.config.measurement.lanes = AGAA_LANES_SAMPLE_SUBGROUP;
    const std::string message = expectRefused(unknown, settings, AGAA_ERROR_UNSUPPORTED, "no full subgroups");
    EXPECT_NE(message.find("AgaaMeasurement::lanes"), std::string::npos) << message;
}

} // namespace
} // namespace agaa::test
