// What is asked of devices: of such that allocate little at once, lack a format, or whose window for the host is full;
// pipelines by a cache, and barriers.
#include "ids_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace agaa::test {
namespace {

// What the device of a test is made to be, and what was asked of it.
struct Card {
    VkDeviceSize mostAtOnce = 0; // 0: as it is
    uint32_t sharedBytes = 0;    // of a graphics card; 0: as it is
    bool hasWindow = false;      // types: 0 system memory, 1 the card's own, 2 a part of it that the host sees, full
    bool isFull = false;
    bool isOwnFull = false;         // of a card with a window
    uint32_t typesOfImages = 0b111; // of its types
    uint32_t refused = 0;
    uint32_t warnings = 0; // that the host was told
    VkDeviceSize largestSurface = 0;
    std::map<uint32_t, std::vector<VkDeviceSize>> sizes; // of allocations, by type
    std::vector<VkPipelineCache> caches;                 // of pipelines
    VkFormat lacked = VK_FORMAT_UNDEFINED;
    VkResult ofFormats = VK_SUCCESS;                     // of questions for formats
    std::vector<std::pair<uint32_t, uint32_t>> barriers; // of memory, and of surfaces that had no layout, by call
    VkImage output = VK_NULL_HANDLE;                     // the host's, no surface
};
Card card;

PFN_vkGetDeviceProcAddr realDeviceProcAddr = nullptr;
PFN_vkGetPhysicalDeviceProperties2 realProperties = nullptr;
PFN_vkGetPhysicalDeviceMemoryProperties realMemory = nullptr;
PFN_vkGetImageMemoryRequirements realOfImage = nullptr;
PFN_vkGetBufferMemoryRequirements realOfBuffer = nullptr;
PFN_vkAllocateMemory realAllocate = nullptr;
PFN_vkCreateComputePipelines realCreatePipelines = nullptr;
PFN_vkCmdPipelineBarrier realBarrier = nullptr;
PFN_vkGetPhysicalDeviceImageFormatProperties realFormat = nullptr;

VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
    realProperties(device, out);
    if (card.sharedBytes) {
        out->properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
        out->properties.limits.maxComputeSharedMemorySize = card.sharedBytes;
    }
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

void widen(VkMemoryRequirements* out, uint32_t types) {
    card.largestSurface =
        std::max(card.largestSurface, (out->size + out->alignment - 1) / out->alignment * out->alignment);
    if (card.hasWindow)
        out->memoryTypeBits = types;
}

VKAPI_ATTR void VKAPI_CALL ofImage(VkDevice device, VkImage image, VkMemoryRequirements* out) {
    realOfImage(device, image, out);
    widen(out, card.typesOfImages);
}

VKAPI_ATTR void VKAPI_CALL ofBuffer(VkDevice device, VkBuffer buffer, VkMemoryRequirements* out) {
    realOfBuffer(device, buffer, out);
    widen(out, 0b111);
}

VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                        const VkAllocationCallbacks* allocator, VkDeviceMemory* out) {
    const uint32_t type = info->memoryTypeIndex;
    if (card.isFull || (card.hasWindow && (type == 2 || (type == 1 && card.isOwnFull)))) {
        ++card.refused;
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    card.sizes[type].push_back(info->allocationSize);
    VkMemoryAllocateInfo real = *info;
    if (card.hasWindow)
        real.memoryTypeIndex = 0;
    return realAllocate(device, &real, allocator, out);
}

VKAPI_ATTR VkResult VKAPI_CALL formatProperties(VkPhysicalDevice device, VkFormat format, VkImageType type,
                                                VkImageTiling tiling, VkImageUsageFlags usage, VkImageCreateFlags flags,
                                                VkImageFormatProperties* out) {
    if (card.ofFormats != VK_SUCCESS)
        return card.ofFormats;
    return format == card.lacked ? VK_ERROR_FORMAT_NOT_SUPPORTED
                                 : realFormat(device, format, type, tiling, usage, flags, out);
}

VKAPI_ATTR void VKAPI_CALL barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                                   VkDependencyFlags flags, uint32_t memoryCount, const VkMemoryBarrier* memoryBarriers,
                                   uint32_t bufferCount, const VkBufferMemoryBarrier* buffers, uint32_t imageCount,
                                   const VkImageMemoryBarrier* images) {
    card.barriers.emplace_back(memoryCount, std::count_if(images, images + imageCount, [](const auto& image) {
                                   return image.oldLayout == VK_IMAGE_LAYOUT_UNDEFINED && image.image != card.output;
                               }));
    realBarrier(commands, from, to, flags, memoryCount, memoryBarriers, bufferCount, buffers, imageCount, images);
}

VKAPI_ATTR VkResult VKAPI_CALL createPipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                               const VkComputePipelineCreateInfo* infos,
                                               const VkAllocationCallbacks* allocator, VkPipeline* out) {
    card.caches.push_back(cache);
    return realCreatePipelines(device, cache, count, infos, allocator, out);
}

template <class Function> PFN_vkVoidFunction instead(Function*& real, PFN_vkVoidFunction found, Function* ours) {
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
    if (std::strcmp(name, "vkCmdPipelineBarrier") == 0)
        return instead(realBarrier, real, barrier);
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
        if (std::strcmp(name, "vkGetPhysicalDeviceImageFormatProperties") == 0)
            return instead(realFormat, real, formatProperties);
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
    card.output = view.output().image();
    card.warnings = context.warnings;
    return drawn(view, randomTriangles({.triangles = 200}, 11)).rgb;
}

AgaaVkFunction AGAA_CALL procAddrOfVulkan10(void* instance, const char* name) {
    return std::strcmp(name, "vkGetPhysicalDeviceProperties2") == 0 ? nullptr : procAddr(instance, name);
}

TEST(DeviceTest, CapabilitiesThatCannotBeReadAreAnError) {
    const AgaaDeviceCaps untouched = AGAA_DEVICE_CAPS_INIT;
    const auto expect = [&](AgaaVkGetInstanceProcAddr getProcAddr, AgaaResult result, const char* what) {
        std::vector<LogLine> lines;
        const AgaaLog log = logInto(lines);
        AgaaDeviceCaps caps = untouched;
        EXPECT_EQ(
            agaaVkGetDeviceCaps(sharedDevice().instance(), sharedDevice().physicalDevice(), getProcAddr, &log, &caps),
            result)
            << what;
        EXPECT_EQ(std::memcmp(&caps, &untouched, sizeof caps), 0) << what;
        expectOneSentence(lines, result, what);
    };
    card = {};
    expect(procAddrOfVulkan10, AGAA_ERROR_UNSUPPORTED, "a function is missing");
    card.ofFormats = VK_ERROR_OUT_OF_HOST_MEMORY;
    expect(procAddr, AGAA_ERROR_OUT_OF_MEMORY, "no memory");
    card.ofFormats = VK_ERROR_UNKNOWN;
    expect(procAddr, AGAA_ERROR_DEVICE, "another error");
    card = {};
}

TEST(DeviceTest, SurfacesAreSpreadOverWhatTheDeviceAllocatesAtOnce) {
    card = {};
    const std::vector<float> expected = picture();
    const auto allocations = [] {
        std::vector<VkDeviceSize> all;
        for (const auto& [type, sizes] : card.sizes)
            all.insert(all.end(), sizes.begin(), sizes.end());
        return all;
    };
    const std::vector<VkDeviceSize> usual = allocations();
    const VkDeviceSize most = card.largestSurface;
    ASSERT_GT(*std::max_element(usual.begin(), usual.end()), most) << "surfaces share allocations";
    card = {};
    card.mostAtOnce = most;
    EXPECT_EQ(picture(), expected);
    const std::vector<VkDeviceSize> spread = allocations();
    EXPECT_GT(spread.size(), usual.size());
    EXPECT_LE(*std::max_element(spread.begin(), spread.end()), most);
}

TEST(DeviceTest, WhatFindsNoRoomOnTheCardGoesToSystemMemory) {
    if (sharedDevice().name().find("llvmpipe") == std::string::npos)
        GTEST_SKIP() << "the types are made up: they need a device whose memory is all of one type";
    card = {};
    const std::vector<float> expected = picture();
    card = {};
    card.hasWindow = true;
    EXPECT_EQ(picture(), expected);
    EXPECT_GT(card.refused, 0u);
    EXPECT_FALSE(card.sizes[0].empty());
    EXPECT_FALSE(card.sizes[1].empty()) << "what the host does not see stays the card's";
    card = {};
    card.hasWindow = card.isOwnFull = true;
    EXPECT_EQ(picture(), expected);
    EXPECT_FALSE(card.sizes[0].empty());
    EXPECT_GT(card.warnings, 0u) << "the host is told";
    EXPECT_TRUE(card.sizes[1].empty()) << "surfaces go to system memory where the card is full";
}

// Images share memory with buffers though they may not lie in all types that these may lie in.
TEST(DeviceTest, ImagesAndBuffersShareMemory) {
    if (sharedDevice().name().find("llvmpipe") == std::string::npos)
        GTEST_SKIP() << "the types are made up: they need a device whose memory is all of one type";
    card = {};
    card.hasWindow = true;
    const std::vector<float> expected = picture();
    const std::vector<VkDeviceSize> sizes = card.sizes[1];
    EXPECT_EQ(card.warnings, 0u);
    card = {};
    card.hasWindow = true;
    card.typesOfImages = 0b011;
    EXPECT_EQ(picture(), expected);
    EXPECT_EQ(card.sizes[1], sizes);
}

TEST(DeviceTest, AFormatThatIsNotThereRefusesWhatNeedsIt) {
    card = {};
    card.lacked = VK_FORMAT_R16G16B16A16_UNORM;
    StageContext context({.getProcAddr = procAddr});
    ViewSettings settings;
    settings.config.samples = 4;
    const StageView aggregates(context, settings);
    settings.config.technique = "ssaa";
    const std::string sentence = expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "a G-buffer of 16 bits");
    EXPECT_NE(sentence.find("no images for gbuffer"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("RGBA16"), std::string::npos) << sentence;
}

// Pixels whose primitives find no room take another turn.
TEST(DeviceTest, ListsOfAnyLengthGiveTheSameImage) {
    const Shot shot{.triangles = randomTriangles({.triangles = 4000}, 91)};
    std::vector<float> images[3];
    const uint32_t sharedBytes[] = {0, 49152, 16384};
    const char* const lengths[] = {"", "64u", "32u"};
    for (int i = 0; i < 3; ++i) {
        card = {};
        card.sharedBytes = sharedBytes[i];
        StageContext context({.getProcAddr = procAddr});
        IdsView ids(context, settingsFor(8, 4, AGAA_TIER_IDS), shot);
        const std::vector<Pass>& passes = ids.view().plan().passes;
        EXPECT_TRUE(std::any_of(passes.begin(), passes.end(), [&](const Pass& pass) {
            return pass.kind() == PassKind::Compute &&
                   pass.compute().defines.find(std::string("AGAA_LIST_LENGTH ") + lengths[i]) != std::string::npos;
        })) << lengths[i];
        images[i] = ids.render().rgb;
        EXPECT_GT(ids.view().statistics().counters.primitives, 2u * 48 * 32) << "several a pixel";
    }
    EXPECT_EQ(images[0], images[1]);
    EXPECT_EQ(images[0], images[2]);
}

// An image's own barrier does not wait for what had its memory.
TEST(DeviceTest, FirstUsesWaitForAliases) {
    card = {};
    picture();
    uint32_t newImages = 0;
    for (const auto& [ofMemory, ofNewImages] : card.barriers) {
        newImages += ofNewImages;
        EXPECT_GE(ofMemory, ofNewImages);
    }
    EXPECT_GT(newImages, 2u);
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

// A driver that has no memory left: an error, no view, and the next view is made.
TEST(DeviceTest, AViewThatFindsNoMemoryIsNone) {
    card = {};
    StageContext context({.getProcAddr = procAddr});
    card.isFull = true;
    expectRefused(context, ViewSettings{}, AGAA_ERROR_OUT_OF_MEMORY, "no memory on the device");
    EXPECT_GT(card.refused, 0u);
    card.isFull = false;
    EXPECT_NO_THROW(StageView(context, ViewSettings{}));
}

} // namespace
} // namespace agaa::test
