#include "vk/context.h"

#include "core/validate.h"

#include <cstdlib>
#include <cstring>
#include <vector>

namespace agaa::vk {

void* HostAllocator::allocate(size_t size, size_t alignment) const {
    void* memory = allocateCallback ? allocateCallback(user, size, alignment)
                                    : std::aligned_alloc(alignment, (size + alignment - 1) /
                                                                        alignment * alignment);
    require(memory, AGAA_ERROR_OUT_OF_MEMORY, "host memory could not be allocated.");
    return memory;
}

void HostAllocator::free(void* memory) const {
    if (freeCallback)
        freeCallback(user, memory);
    else
        std::free(memory);
}

} // namespace agaa::vk

using namespace agaa;

static void dropWhatIsNotEnabled(AgaaDeviceCaps& caps, const AgaaVkContextDesc& desc) {
    const auto enabled = [&](const char* name) {
        for (uint32_t i = 0; i < desc.enabledExtensionCount; ++i)
            if (std::strcmp(desc.enabledExtensions[i], name) == 0)
                return true;
        return false;
    };
    if (!enabled(VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_POST_DEPTH_COVERAGE;
    if (desc.apiVersion < VK_API_VERSION_1_3 && !enabled(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_DYNAMIC_RENDERING;
}

static VkSampler createSampler(const AgaaContext_T& context, bool compare) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = compare ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = info.addressModeV = info.addressModeW =
        VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = compare;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkSampler sampler = VK_NULL_HANDLE;
    vk::check(context.vk.CreateSampler(context.device, &info, nullptr, &sampler), "vkCreateSampler");
    return sampler;
}

AgaaContext_T::AgaaContext_T(const AgaaVkContextDesc& desc)
    : log(desc.log), allocator{desc.allocate, desc.free, desc.allocateUser},
      instanceFunctions(
          vk::loadInstanceTable(desc.getProcAddr, static_cast<VkInstance>(desc.instance))),
      instance(static_cast<VkInstance>(desc.instance)),
      physicalDevice(static_cast<VkPhysicalDevice>(desc.physicalDevice)),
      device(static_cast<VkDevice>(desc.device)), queueFamily(desc.queueFamily),
      secondary(desc.recording == AGAA_VK_RECORDING_SECONDARY), descriptorSet(desc.descriptorSet),
      pipelineCache((VkPipelineCache)desc.pipelineCache), framesInFlight(desc.framesInFlight) {
    caps = vk::queryCaps(instanceFunctions, physicalDevice);
    dropWhatIsNotEnabled(caps, desc);
    const bool canBeDynamic = caps.flags & AGAA_DEVICE_DYNAMIC_RENDERING;
    require(canBeDynamic || desc.rendering != AGAA_VK_RENDERING_DYNAMIC, AGAA_ERROR_UNSUPPORTED,
            "dynamic rendering was asked for, but neither Vulkan 1.3 nor VK_KHR_dynamic_rendering "
            "is enabled.");
    dynamicRendering = canBeDynamic && desc.rendering != AGAA_VK_RENDERING_RENDER_PASS;
    require(caps.flags & AGAA_DEVICE_STORAGE_FORMATS, AGAA_ERROR_UNSUPPORTED,
            "the device cannot write storage images without a format.");
    instanceFunctions.GetPhysicalDeviceMemoryProperties(physicalDevice, &memory);
    uint32_t families = 0;
    instanceFunctions.GetPhysicalDeviceQueueFamilyProperties(physicalDevice, &families, nullptr);
    require(queueFamily < families, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaVkContextDesc::queueFamily is not a family of the device.");
    std::vector<VkQueueFamilyProperties> properties(families);
    instanceFunctions.GetPhysicalDeviceQueueFamilyProperties(physicalDevice, &families,
                                                             properties.data());
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    require((properties[queueFamily].queueFlags & needed) == needed, AGAA_ERROR_UNSUPPORTED,
            "the queue family does not do both graphics and compute.");
    const uint32_t bits = properties[queueFamily].timestampValidBits;
    timestampMask = bits >= 64 ? ~UINT64_C(0) : (UINT64_C(1) << bits) - 1;
    VkPhysicalDeviceProperties2 device2{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, nullptr, {}};
    instanceFunctions.GetPhysicalDeviceProperties2(physicalDevice, &device2);
    timestampPeriod = device2.properties.limits.timestampPeriod;
    granularity = device2.properties.limits.bufferImageGranularity;
    if (!device2.properties.limits.standardSampleLocations)
        log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                  "the device does not rasterise at the standard sample locations; positions of "
                  "samples are approximate.");
    vk = vk::loadDeviceTable(instanceFunctions, desc.getProcAddr, instance, device,
                             dynamicRendering);
    texelSampler = createSampler(*this, false);
    name(VK_OBJECT_TYPE_SAMPLER, (uint64_t)texelSampler, "agaa texel sampler");
    try {
        shadowSampler = createSampler(*this, true);
    } catch (...) {
        vk.DestroySampler(device, texelSampler, nullptr);
        throw;
    }
    name(VK_OBJECT_TYPE_SAMPLER, (uint64_t)shadowSampler, "agaa shadow sampler");
}

AgaaContext_T::~AgaaContext_T() {
    vk.DestroySampler(device, texelSampler, nullptr);
    vk.DestroySampler(device, shadowSampler, nullptr);
}

void AgaaContext_T::name(VkObjectType type, uint64_t handle, const std::string& text) const {
    if (!vk.SetDebugUtilsObjectNameEXT)
        return;
    const VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                             nullptr, type, handle, text.c_str()};
    vk.SetDebugUtilsObjectNameEXT(device, &info);
}
