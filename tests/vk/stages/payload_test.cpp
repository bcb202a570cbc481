// What Vulkan's create calls are asked for.
#include "payload_cases.h"
#include "show.h"

#include <cstring>

namespace agaa::test {
namespace {

Created created;
PFN_vkGetDeviceProcAddr realGetDeviceProcAddr = nullptr;
PFN_vkCreateImage realCreateImage = nullptr;
PFN_vkCreateBuffer realCreateBuffer = nullptr;
PFN_vkCreateShaderModule realCreateShaderModule = nullptr;

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
    case VK_FORMAT_R32G32B32A32_UINT:
        return 16;
    default:
        ADD_FAILURE() << "format " << format << " is not in the test's table";
        return 0;
    }
}

VKAPI_ATTR VkResult VKAPI_CALL createImage(VkDevice device, const VkImageCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkImage* image) {
    created.imageBytes += uint64_t(info->extent.width) * info->extent.height * info->extent.depth * info->arrayLayers *
                          uint64_t(info->samples) * bytesOf(info->format);
    EXPECT_EQ(info->mipLevels, 1u);
    return realCreateImage(device, info, allocator, image);
}

VKAPI_ATTR VkResult VKAPI_CALL createBuffer(VkDevice device, const VkBufferCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkBuffer* buffer) {
    ++created.bufferSizes[info->size];
    return realCreateBuffer(device, info, allocator, buffer);
}

// Views are not drawn: shaders that do nothing replace those of the passes, which tests of frames compile.
VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkShaderModule* shader) {
    static constexpr uint32_t words[] = {0x07230203,
                                         0x00010000,
                                         0,
                                         5,
                                         0,
                                         2 << 16 | 17,
                                         1, // OpCapability Shader
                                         3 << 16 | 14,
                                         0,
                                         1, // OpMemoryModel Logical GLSL450
                                         5 << 16 | 15,
                                         5,
                                         1,
                                         0x6E69616D,
                                         0, // OpEntryPoint GLCompute %1 "main"
                                         6 << 16 | 16,
                                         1,
                                         17,
                                         64, // as of passes with full subgroups
                                         1,
                                         1, // OpExecutionMode %1 LocalSize 64 1 1
                                         2 << 16 | 19,
                                         2, // %2 = OpTypeVoid
                                         3 << 16 | 33,
                                         3,
                                         2, // %3 = OpTypeFunction %2
                                         5 << 16 | 54,
                                         2,
                                         1,
                                         0,
                                         3, // %1 = OpFunction %2 None %3
                                         2 << 16 | 248,
                                         4,
                                         1 << 16 | 253,
                                         1 << 16 | 56}; // OpLabel, OpReturn, OpFunctionEnd
    VkShaderModuleCreateInfo nothing = *info;
    nothing.codeSize = sizeof words;
    nothing.pCode = words;
    return realCreateShaderModule(device, &nothing, allocator, shader);
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
    if (std::strcmp(name, "vkCreateShaderModule") == 0) {
        realCreateShaderModule = reinterpret_cast<PFN_vkCreateShaderModule>(real);
        return reinterpret_cast<PFN_vkVoidFunction>(createShaderModule);
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

struct InterceptedContext : StageContext {
    InterceptedContext() : StageContext({.getProcAddr = interceptingProcAddr}) {}
    static Created& created() { return test::created; }
};

struct PayloadHost : VulkanHost {
    using Context = InterceptedContext;
    static constexpr bool sharesMemory = true;
    static constexpr PayloadSize sizes[] = {{1, 1}, {3, 7}, {17, 5}, {131, 67}, {4097, 3}};
    static constexpr uint32_t turns = 2; // of each configuration
};
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, PayloadCases, PayloadHost);

} // namespace
} // namespace agaa::test
