// What is asked of devices: of such that allocate little at once, or whose window for the host is full; pipelines by a
// cache.
#include "stage_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace agaa::test {
namespace {

// What the device of a test is made to be, and what was asked of it.
struct Card {
    VkDeviceSize mostAtOnce = 0; // 0: as it is
    bool hasWindow = false;      // types: 0 system memory, 1 the card's own, 2 a part of it that the host sees, full
    uint32_t refused = 0;
    VkDeviceSize largestSurface = 0;
    std::vector<VkDeviceSize> sizes[3]; // of allocations, by type
    std::vector<VkPipelineCache> caches; // of pipelines
};
Card card;

PFN_vkGetDeviceProcAddr realDeviceProcAddr = nullptr;
PFN_vkGetPhysicalDeviceProperties2 realProperties = nullptr;
PFN_vkGetPhysicalDeviceMemoryProperties realMemory = nullptr;
PFN_vkGetImageMemoryRequirements realOfImage = nullptr;
PFN_vkGetBufferMemoryRequirements realOfBuffer = nullptr;
PFN_vkAllocateMemory realAllocate = nullptr;
PFN_vkCreateComputePipelines realCreatePipelines = nullptr;

VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
    realProperties(device, out);
    for (auto* next = static_cast<VkBaseOutStructure*>(out->pNext); next; next = next->pNext)
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES && card.mostAtOnce)
            reinterpret_cast<VkPhysicalDeviceMaintenance3Properties*>(next)->maxMemoryAllocationSize = card.mostAtOnce;
}

VKAPI_ATTR void VKAPI_CALL memory(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties* out) {
    realMemory(device, out);
    if (!card.hasWindow)
        return;
    constexpr VkMemoryPropertyFlags seen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    constexpr VkMemoryPropertyFlags own = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    out->memoryTypeCount = 3;
    out->memoryTypes[0] = {seen | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, 0};
    out->memoryTypes[1] = {own, 0};
    out->memoryTypes[2] = {own | seen, 0};
}

void widen(VkMemoryRequirements* out) {
    card.largestSurface = std::max(card.largestSurface, (out->size + out->alignment - 1) / out->alignment * out->alignment);
    if (card.hasWindow)
        out->memoryTypeBits = 0b111;
}

VKAPI_ATTR void VKAPI_CALL ofImage(VkDevice device, VkImage image, VkMemoryRequirements* out) {
    realOfImage(device, image, out);
    widen(out);
}

VKAPI_ATTR void VKAPI_CALL ofBuffer(VkDevice device, VkBuffer buffer, VkMemoryRequirements* out) {
    realOfBuffer(device, buffer, out);
    widen(out);
}

VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                        const VkAllocationCallbacks* allocator, VkDeviceMemory* out) {
    if (info->memoryTypeIndex == 2) {
        ++card.refused;
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    card.sizes[info->memoryTypeIndex].push_back(info->allocationSize);
    VkMemoryAllocateInfo real = *info;
    real.memoryTypeIndex = 0;
    return realAllocate(device, &real, allocator, out);
}

VKAPI_ATTR VkResult VKAPI_CALL createPipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                               const VkComputePipelineCreateInfo* infos,
                                               const VkAllocationCallbacks* allocator, VkPipeline* out) {
    card.caches.push_back(cache);
    return realCreatePipelines(device, cache, count, infos, allocator, out);
}

template <class Function>
PFN_vkVoidFunction instead(Function*& real, PFN_vkVoidFunction found, Function* ours) {
    real = reinterpret_cast<Function*>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(ours);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
    const PFN_vkVoidFunction real = realDeviceProcAddr(device, name);
    if (std::strcmp(name, "vkGetImageMemoryRequirements") == 0)
        return instead(realOfImage, real, ofImage);
    if (std::strcmp(name, "vkGetBufferMemoryRequirements") == 0)
        return instead(realOfBuffer, real, ofBuffer);
    if (std::strcmp(name, "vkCreateComputePipelines") == 0)
        return instead(realCreatePipelines, real, createPipelines);
    return std::strcmp(name, "vkAllocateMemory") == 0 ? instead(realAllocate, real, allocate) : real;
}

AgaaVkFunction AGAA_CALL procAddr(void* instance, const char* name) {
    const auto real = reinterpret_cast<PFN_vkVoidFunction>(harness::vk::Device::getProcAddr(instance, name));
    const auto function = [&]() -> PFN_vkVoidFunction {
        if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
            return instead(realDeviceProcAddr, real, deviceProcAddr);
        if (std::strcmp(name, "vkGetPhysicalDeviceProperties2") == 0)
            return instead(realProperties, real, properties);
        if (std::strcmp(name, "vkGetPhysicalDeviceMemoryProperties") == 0)
            return instead(realMemory, real, memory);
        return real;
    };
    return reinterpret_cast<AgaaVkFunction>(function());
}

std::vector<float> picture() {
    ViewSettings settings;
    settings.config.samples = 8;
    settings.facts.shadowMapCount = 0;
    StageContext context({.getProcAddr = procAddr});
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 200}, 11));
    const AgaaLight light = sun();
    AgaaFrame frame = view.frame();
    frame.lights = &light;
    frame.lightCount = 1;
    view.render(frame);
    return view.image().rgb;
}

TEST(DeviceTest, SurfacesAreSpreadOverWhatTheDeviceAllocatesAtOnce) {
    card = {};
    const std::vector<float> expected = picture();
    const size_t usual = card.sizes[0].size();
    const VkDeviceSize most = card.largestSurface;
    ASSERT_GT(*std::max_element(card.sizes[0].begin(), card.sizes[0].end()), most) << "surfaces share allocations";
    card = {};
    card.mostAtOnce = most;
    EXPECT_EQ(picture(), expected);
    EXPECT_GT(card.sizes[0].size(), usual);
    for (const VkDeviceSize size : card.sizes[0])
        EXPECT_LE(size, most);
}

TEST(DeviceTest, UploadsGoToSystemMemoryWhereTheWindowIsFull) {
    card = {};
    const std::vector<float> expected = picture();
    card = {};
    card.hasWindow = true;
    EXPECT_EQ(picture(), expected);
    EXPECT_GT(card.refused, 0u);
    EXPECT_FALSE(card.sizes[0].empty());
    EXPECT_FALSE(card.sizes[1].empty()) << "what the host does not see stays the card's";
}

// A view of another size has the same pipelines.
TEST(DeviceTest, ViewsShareACacheOfPipelines) {
    card = {};
    StageContext context({.getProcAddr = procAddr});
    ViewSettings settings;
    const StageView one(context, settings);
    settings.width *= 2;
    const StageView other(context, settings);
    ASSERT_FALSE(card.caches.empty());
    EXPECT_NE(card.caches.front(), VkPipelineCache(VK_NULL_HANDLE));
    EXPECT_EQ(std::count(card.caches.begin(), card.caches.end(), card.caches.front()), ptrdiff_t(card.caches.size()));
}

} // namespace
} // namespace agaa::test
