// The plan's bytes against what is really created, recomputed from the intercepted create calls.
#include "prediction.h"
#include "stage_host.h"

#include <gtest/gtest.h>

#include <cstring>

namespace agaa::test {
namespace {

struct Created {
    uint64_t imageBytes = 0;
    std::map<uint64_t, uint32_t> bufferSizes; // bytes -> how many
};
Created created;
PFN_vkGetDeviceProcAddr realGetDeviceProcAddr = nullptr;
PFN_vkCreateImage realCreateImage = nullptr;
PFN_vkCreateBuffer realCreateBuffer = nullptr;

// From the Vulkan specification, not from the library.
uint64_t bytesOf(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8_UINT:
    case VK_FORMAT_R8_UNORM:
        return 1;
    case VK_FORMAT_R8G8_UNORM:
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_R16_UNORM:
        return 2;
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32:
    case VK_FORMAT_R16G16_UNORM:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT:
        return 4;
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
        return 5;
    case VK_FORMAT_R16G16B16A16_UNORM:
    case VK_FORMAT_R16G16B16A16_SFLOAT:
    case VK_FORMAT_R32G32_UINT:
        return 8;
    default:
        ADD_FAILURE() << "format " << format << " is not in the test's table";
        return 0;
    }
}

VKAPI_ATTR VkResult VKAPI_CALL createImage(VkDevice device, const VkImageCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkImage* image) {
    created.imageBytes += uint64_t(info->extent.width) * info->extent.height * info->extent.depth *
                          info->arrayLayers * uint64_t(info->samples) * bytesOf(info->format);
    EXPECT_EQ(info->mipLevels, 1u);
    return realCreateImage(device, info, allocator, image);
}

VKAPI_ATTR VkResult VKAPI_CALL createBuffer(VkDevice device, const VkBufferCreateInfo* info,
                                            const VkAllocationCallbacks* allocator,
                                            VkBuffer* buffer) {
    ++created.bufferSizes[info->size];
    return realCreateBuffer(device, info, allocator, buffer);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    const PFN_vkVoidFunction real = realGetDeviceProcAddr(device, name);
    if (std::strcmp(name, "vkCreateImage") == 0) {
        realCreateImage = reinterpret_cast<PFN_vkCreateImage>(real);
        return reinterpret_cast<PFN_vkVoidFunction>(createImage);
    }
    if (std::strcmp(name, "vkCreateBuffer") == 0) {
        realCreateBuffer = reinterpret_cast<PFN_vkCreateBuffer>(real);
        return reinterpret_cast<PFN_vkVoidFunction>(createBuffer);
    }
    return real;
}

AgaaVkFunction AGAA_CALL interceptingProcAddr(void* instance, const char* name) {
    const AgaaVkFunction real = harness::vk::Device::getProcAddr(instance, name);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) {
        realGetDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(real);
        return reinterpret_cast<AgaaVkFunction>(getDeviceProcAddr);
    }
    return real;
}

struct Size {
    uint32_t width, height;
};
constexpr Size sizes[] = {{1, 1}, {3, 7}, {17, 5}, {131, 67}, {4097, 3}};

class PayloadTest : public testing::Test {
protected:
    PayloadTest() : context_({.getProcAddr = interceptingProcAddr}) {}

    void expectPayload(const PayloadRow& row, uint32_t c, const char* layoutName, uint64_t viewFlags, Size size) {
        AgaaLayout layout;
        agaaGetBuiltinLayout(layoutName, &layout);
        TechniqueConfig config;
        config.technique = row.technique;
        config.samples = row.samples;
        config.aggregates = c;
        config.generationTier = row.tier;
        config.flags = row.configFlags;
        config.layout = &layout;
        const AgaaFetchFunction fetch = emptyFetch(row.fetchFlags);
        AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
        AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
        desc.width = size.width;
        desc.height = size.height;
        desc.config = &config;
        desc.facts = &facts;
        desc.flags = viewFlags;
        desc.pNext = row.tier == AGAA_TIER_IDS ? &fetch : nullptr;
        const Prediction predicted = predict(desc, context_.caps());
        created = {};
        AgaaView view = nullptr;
        ASSERT_EQ(agaaVkCreateView(context_.get(), &desc, &view), 0)
            << context_.lines.back().text;
        const uint64_t bufferBytes = takePixelBuffers(predicted, created.bufferSizes);
        EXPECT_EQ(created.imageBytes + bufferBytes, predicted.report.totalBytes)
            << row.technique << " n=" << row.samples << " c=" << c << " " << agaaTierName(row.tier) << " "
            << row.configFlags << " " << layoutName << " " << size.width << "x" << size.height;
        agaaDestroyView(view);
        ++checked_;
    }

    StageContext context_;
    size_t checked_ = 0;
};

TEST_F(PayloadTest, IsWhatTheQueryPredicts) {
    size_t next = 0; // sizes take turns
    const auto sizeFor = [&](uint32_t n) {
        const size_t count = n > 8 ? std::size(sizes) - 1 : std::size(sizes); // the last is wider than images then are
        return sizes[next++ % count];
    };
    for (const char* layout : {"paper16", "precise"})
        for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u}) {
            for (int i = 0; i < 2; ++i)
                expectPayload({"ssaa", n}, 1, layout, 0, sizeFor(n));
            for (uint32_t c = 1; c <= 4; ++c)
                for (int i = 0; i < 2; ++i)
                    expectPayload({"agaa", n}, c, layout, 0, sizeFor(n));
        }
    for (uint32_t n : {1u, 8u, 32u})
        expectPayload({"agaa", n}, 2, "precise", AGAA_VIEW_REVERSED_Z, {17, 5});
    for (const Size& size : sizes)
        expectPayload({"single", 1}, 1, "precise", 0, size);
    size_t turn = 0; // layouts take turns: functions are compiled for each view
    for (const PayloadRow& row : payloadRows())
        expectPayload(row, 2, turn++ % 2 ? "paper16" : "precise", 0, {131, 67});
    EXPECT_EQ(checked_, 120u + 3 + std::size(sizes) + payloadRows().size());
}

} // namespace
} // namespace agaa::test
