// Contexts of Vulkan that are refused, and what they cannot do.
#include "context_misuse.h"
#include "stage_host.h"

#include <gtest/gtest.h>

#include <bit>
#include <stdexcept>

namespace agaa::test {
namespace {

TEST(VkMisuse, ContextsAreRefusedInASentence) {
    static const VkPhysicalDeviceFeatures2 noFeatures{};
    static const VkPhysicalDeviceFeatures2 without{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, nullptr, {}};
    const auto rows = contextMisuses<VulkanContextDesc>({
        {"no instance", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.instance = nullptr; }},
        {"no physical device", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.physicalDevice = nullptr; }},
        {"no device", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.device = nullptr; }},
        {"no extensions", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& d) {
             d.device.enabledExtensions = nullptr;
             d.device.enabledExtensionCount = 1;
         }},
        {"Vulkan 1.1", AGAA_ERROR_UNSUPPORTED, [](auto& d) { d.device.apiVersion = VK_API_VERSION_1_1; }},
        {"queue family", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.queueFamily = 99; }},
        {"features of another struct", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.enabledFeatures = &noFeatures; }},
        {"no feature enabled", AGAA_ERROR_UNSUPPORTED, [](auto& d) { d.device.enabledFeatures = &without; }},
        {"rendering", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.rendering = 3; }},
        {"recording", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.recording = 2; }},
        {"descriptor set", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.descriptorSet = 8; }},
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
        desc.device.enabledFeatures = &features;
        desc.device.enabledExtensionCount = 0;
    }});
    ASSERT_EQ(agaaVkGetContextCaps(context.get(), &least), AGAA_OK);
    const uint64_t dropped = AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                             AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_DYNAMIC_RENDERING | AGAA_DEVICE_GEOMETRY_SHADERS |
                             AGAA_DEVICE_CONDITIONAL_RENDERING | AGAA_DEVICE_FRAGMENT_INTERLOCK |
                             AGAA_DEVICE_FRAMEBUFFER_FETCH;
    EXPECT_NE(all.flags & AGAA_DEVICE_FRAGMENT_ATOMICS, 0u);
    EXPECT_EQ(least.flags, all.flags & ~dropped);
    ViewSettings settings;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "counters without atomics");
}

// An allocator of the host's, which gives what lies behind the first `offset` bytes of an allocation.
struct DeviceMemory {
    uint64_t offset = 256;
    uint32_t refused = ~0u; // number of the call that fails
    bool isAligned = true, isMapped = true, isReservedClear = true;
    uint32_t calls = 0, alive = 0;

    AgaaVkAllocator allocator() {
        AgaaVkAllocator out = AGAA_VK_ALLOCATOR_INIT;
        out.allocate = allocate;
        out.free = free;
        out.user = this;
        return out;
    }
    static AgaaResult AGAA_CALL allocate(void* user, const AgaaVkAllocationInfo* info, AgaaVkMemory* outMemory) {
        auto& self = *static_cast<DeviceMemory*>(user);
        if (self.calls++ == self.refused)
            return AGAA_ERROR_OUT_OF_MEMORY;
        EXPECT_NE(info->memoryTypeBits, 0u);
        EXPECT_GT(info->size, 0u);
        VkMemoryAllocateInfo wanted{};
        wanted.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        const uint64_t offset = (self.offset + info->alignment - 1) / info->alignment * info->alignment;
        wanted.allocationSize = offset + info->size;
        wanted.memoryTypeIndex = uint32_t(std::countr_zero(info->memoryTypeBits));
        VkDeviceMemory memory = VK_NULL_HANDLE;
        EXPECT_EQ(vkAllocateMemory(sharedDevice().get(), &wanted, nullptr, &memory), VK_SUCCESS);
        outMemory->memory = (uint64_t)memory;
        outMemory->offset = self.isAligned ? offset : offset + 1;
        if (info->requiredFlags && self.isMapped) {
            void* start = nullptr;
            EXPECT_EQ(vkMapMemory(sharedDevice().get(), memory, 0, VK_WHOLE_SIZE, 0, &start), VK_SUCCESS);
            outMemory->mapped = static_cast<char*>(start) + offset;
        }
        outMemory->allocation = &self;
        outMemory->reserved[1] = self.isReservedClear ? 0 : 1;
        ++self.alive;
        return AGAA_OK;
    }
    static void AGAA_CALL free(void* user, const AgaaVkMemory* memory) {
        EXPECT_EQ(memory->allocation, user);
        --static_cast<DeviceMemory*>(user)->alive;
        vkFreeMemory(sharedDevice().get(), (VkDeviceMemory)memory->memory, nullptr);
    }
};

std::vector<float> pictureWith(const AgaaVkAllocator* allocator) {
    StageContext context({.change = [&](auto& desc) { desc.device.pNext = allocator; }});
    ViewSettings settings;
    settings.config.samples = 4;
    settings.facts.shadowMapCount = 0;
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 20}, 41));
    view.render(view.frame());
    return view.image().rgb;
}

TEST(VkMemory, ComesFromTheHostsAllocator) {
    const std::vector<float> expected = pictureWith(nullptr);
    DeviceMemory memory;
    const AgaaVkAllocator allocator = memory.allocator();
    EXPECT_EQ(pictureWith(&allocator), expected);
    EXPECT_GT(memory.calls, 2u);
    EXPECT_EQ(memory.alive, 0u);
    // Where a call fails, what others gave comes back.
    for (uint32_t call = 0; call < memory.calls; ++call) {
        DeviceMemory poor;
        poor.refused = call;
        const AgaaVkAllocator failing = poor.allocator();
        StageContext context({.change = [&](auto& desc) { desc.device.pNext = &failing; }});
        ViewSettings settings;
        settings.config.samples = 4;
        settings.facts.shadowMapCount = 0;
        expectRefused(context, settings, AGAA_ERROR_OUT_OF_MEMORY, "no memory");
        EXPECT_EQ(poor.alive, 0u) << call;
    }
}

TEST(VkMemory, OfTheHostsMustBeAlignedMappedAndKnown) {
    const std::pair<bool DeviceMemory::*, const char*> faults[] = {{&DeviceMemory::isAligned, "not aligned"},
                                                                   {&DeviceMemory::isMapped, "not mapped"},
                                                                   {&DeviceMemory::isReservedClear, "reserved"}};
    for (const auto& [member, words] : faults) {
        DeviceMemory wrong;
        wrong.*member = false;
        const AgaaVkAllocator allocator = wrong.allocator();
        StageContext context({.change = [&](auto& desc) { desc.device.pNext = &allocator; }});
        expectRefused(context, {}, AGAA_ERROR_CALLBACK, words);
        EXPECT_EQ(wrong.alive, 0u);
    }
    AgaaVkAllocator half = AGAA_VK_ALLOCATOR_INIT;
    half.allocate = DeviceMemory::allocate;
    EXPECT_THROW(StageContext({.change = [&](auto& desc) { desc.device.pNext = &half; }}), std::runtime_error);
}

TEST(VkMisuse, OpenGLsClipSpaceIsRefused) {
    StageContext context;
    ViewSettings settings;
    settings.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "OpenGL's clip space");
}

} // namespace
} // namespace agaa::test
