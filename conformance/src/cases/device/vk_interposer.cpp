#include "vk_interposer.h"

#include <algorithm>
#include <cstring>
#include <mutex>

namespace agaa::conformance {

VulkanInterposer* VulkanInterposer::current = nullptr;

namespace {

std::mutex mutex; // functions without a handle may be called from any thread

// ---- functions in place of Vulkan's, each with Vulkan's own ---------------------------------------

enum Function {
#define AGAA_CREATE(name) create##name,
#define AGAA_RESULT(name) result##name,
#include "vk_interposer.inc"
};

bool failsNow(const char* function, VkResult& error) {
    return VulkanInterposer::current && VulkanInterposer::current->fails(function, error);
}

template <class Handle> void createdNow(const char* kind, Handle handle) {
    if (VulkanInterposer::current)
        VulkanInterposer::current->addObject(kind, (uint64_t)handle);
}
template <class Handle> void destroyedNow(const char* kind, Handle handle) {
    if (VulkanInterposer::current)
        VulkanInterposer::current->removeObject(kind, (uint64_t)handle);
}

PFN_vkSetDebugUtilsObjectNameEXT realName = nullptr; // null: the instance has no VK_EXT_debug_utils
VKAPI_ATTR VkResult VKAPI_CALL setName(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info) {
    if (VulkanInterposer::current)
        VulkanInterposer::current->nameObject(info->objectHandle, info->pObjectName);
    return realName ? realName(device, info) : VK_SUCCESS;
}

template <Function id, class F> struct Result;
template <Function id, class... Arguments> struct Result<id, VkResult(VKAPI_PTR*)(Arguments...)> {
    static inline VkResult(VKAPI_PTR* real)(Arguments...) = nullptr;
    static inline const char* name = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
        VkResult error;
        const bool fails = failsNow(name, error);
        if (id == resultEndCommandBuffer && fails)
            real(arguments...); // the command buffer has left the recording state
        return fails ? error : real(arguments...);
    }
};

// ---- sample locations ------------------------------------------------------------------------------

bool fakesLocations() { return VulkanInterposer::current && VulkanInterposer::current->sampleLocations.isFaked; }

constexpr VkImageCreateFlags locationsFlag = VK_IMAGE_CREATE_SAMPLE_LOCATIONS_COMPATIBLE_DEPTH_BIT_EXT;
template <class Info> const Info* withoutLocations(const Info* info, Info&) { return info; }
const VkImageCreateInfo* withoutLocations(const VkImageCreateInfo* info, VkImageCreateInfo& plain) {
    if (!fakesLocations() || !(info->flags & locationsFlag))
        return info;
    ++VulkanInterposer::current->sampleLocations.images;
    plain = *info;
    plain.flags &= ~locationsFlag;
    return &plain;
}

void changeLocations(VkPhysicalDeviceProperties2& properties) {
    if (!fakesLocations())
        return;
    const VulkanInterposer::SampleLocations& faked = VulkanInterposer::current->sampleLocations;
    for (auto* next = static_cast<VkBaseOutStructure*>(properties.pNext); next; next = next->pNext)
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SAMPLE_LOCATIONS_PROPERTIES_EXT) {
            auto* out = reinterpret_cast<VkPhysicalDeviceSampleLocationsPropertiesEXT*>(next);
            out->sampleLocationSampleCounts = faked.counts;
            out->maxSampleLocationGridSize = {1, 1};
            out->sampleLocationCoordinateRange[0] = 0;
            out->sampleLocationCoordinateRange[1] = faked.highest;
            out->sampleLocationSubPixelBits = faked.subPixelBits;
            out->variableSampleLocations = faked.areVariable;
        }
}

VKAPI_ATTR void VKAPI_CALL setLocations(VkCommandBuffer, const VkSampleLocationsInfoEXT* info) {
    VulkanInterposer::current->sampleLocations.sets.emplace_back(info->pSampleLocations,
                                                                 info->pSampleLocations + info->sampleLocationsCount);
}

PFN_vkCmdPipelineBarrier realBarrier = nullptr;
VKAPI_ATTR void VKAPI_CALL barrier(VkCommandBuffer commands, VkPipelineStageFlags source,
                                   VkPipelineStageFlags destination, VkDependencyFlags flags, uint32_t memoryCount,
                                   const VkMemoryBarrier* memory, uint32_t bufferCount,
                                   const VkBufferMemoryBarrier* buffers, uint32_t imageCount,
                                   const VkImageMemoryBarrier* images) {
    std::vector<VkImageMemoryBarrier> plain(images, images + imageCount);
    for (VkImageMemoryBarrier& image : plain) {
        if (!fakesLocations())
            break;
        const auto* info = static_cast<const VkSampleLocationsInfoEXT*>(image.pNext);
        if (image.oldLayout == VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL) {
            auto& locations = VulkanInterposer::current->sampleLocations.transitions.emplace_back();
            if (info)
                locations.assign(info->pSampleLocations, info->pSampleLocations + info->sampleLocationsCount);
        }
        image.pNext = nullptr;
    }
    realBarrier(commands, source, destination, flags, memoryCount, memory, bufferCount, buffers, imageCount,
                plain.data());
}

template <Function id, class Info, class Handle> struct Create {
    static inline VkResult(VKAPI_PTR* real)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*) = nullptr;
    static inline void(VKAPI_PTR* realDestroy)(VkDevice, Handle, const VkAllocationCallbacks*) = nullptr;
    static inline const char* name = nullptr;
    static inline const char* kind = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(VkDevice device, const Info* info,
                                               const VkAllocationCallbacks* callbacks, Handle* out) {
        VkResult error;
        if (failsNow(name, error))
            return error;
        Info plain{};
        const VkResult result = real(device, withoutLocations(info, plain), callbacks, out);
        if (result == VK_SUCCESS)
            createdNow(kind, *out);
        return result;
    }
    static VKAPI_ATTR void VKAPI_CALL destroy(VkDevice device, Handle handle, const VkAllocationCallbacks* callbacks) {
        destroyedNow(kind, handle);
        realDestroy(device, handle, callbacks);
    }
};

using Memory = Create<createMemory, VkMemoryAllocateInfo, VkDeviceMemory>;

template <class Info> struct CreatePipelines {
    static inline VkResult(VKAPI_PTR* real)(VkDevice, VkPipelineCache, uint32_t, const Info*,
                                            const VkAllocationCallbacks*, VkPipeline*) = nullptr;
    static inline const char* name = nullptr;
    static VKAPI_ATTR VkResult VKAPI_CALL call(VkDevice device, VkPipelineCache cache, uint32_t count,
                                               const Info* infos, const VkAllocationCallbacks* callbacks,
                                               VkPipeline* out) {
        VkResult error;
        if (failsNow(name, error)) {
            for (uint32_t i = 0; i < count; ++i)
                out[i] = VK_NULL_HANDLE;
            return error;
        }
        if (VulkanInterposer::current)
            VulkanInterposer::current->addPipelineCache(cache);
        const VkResult result = real(device, cache, count, infos, callbacks, out);
        for (uint32_t i = 0; i < count; ++i)
            createdNow("Pipeline", out[i]);
        return result;
    }
};

using CreateCompute = CreatePipelines<VkComputePipelineCreateInfo>;
using CreateGraphics = CreatePipelines<VkGraphicsPipelineCreateInfo>;

PFN_vkDestroyPipeline realDestroyPipeline = nullptr;
VKAPI_ATTR void VKAPI_CALL destroyPipeline(VkDevice device, VkPipeline pipeline,
                                           const VkAllocationCallbacks* callbacks) {
    destroyedNow("Pipeline", pipeline);
    realDestroyPipeline(device, pipeline, callbacks);
}

// ---- what devices say of themselves ----------------------------------------------------------------

PFN_vkGetPhysicalDeviceProperties realProperties = nullptr;
PFN_vkGetPhysicalDeviceProperties2 realProperties2 = nullptr;
PFN_vkGetPhysicalDeviceQueueFamilyProperties realFamilies = nullptr;
PFN_vkGetPhysicalDeviceQueueFamilyProperties2 realFamilies2 = nullptr;
PFN_vkGetPhysicalDeviceImageFormatProperties realFormats = nullptr;
PFN_vkGetPhysicalDeviceImageFormatProperties2 realFormats2 = nullptr;

void change(VkPhysicalDeviceProperties& properties) {
    if (VulkanInterposer::current && VulkanInterposer::current->changeProperties)
        VulkanInterposer::current->changeProperties(properties);
}
void change(VkQueueFamilyProperties& family) {
    if (VulkanInterposer::current && VulkanInterposer::current->changeQueueFamily)
        VulkanInterposer::current->changeQueueFamily(family);
}

PFN_vkGetPhysicalDeviceFormatProperties realFormat = nullptr;
VKAPI_ATTR void VKAPI_CALL formatProperties(VkPhysicalDevice device, VkFormat format, VkFormatProperties* out) {
    realFormat(device, format, out);
    if (VulkanInterposer::current && VulkanInterposer::current->changeFormat)
        VulkanInterposer::current->changeFormat(format, *out);
}
VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties* out) {
    realProperties(device, out);
    change(*out);
}
VKAPI_ATTR void VKAPI_CALL properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
    realProperties2(device, out);
    change(out->properties);
    changeLocations(*out);
}
VKAPI_ATTR void VKAPI_CALL families(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties* out) {
    realFamilies(device, count, out);
    for (uint32_t i = 0; out && i < *count; ++i)
        change(out[i]);
}
VKAPI_ATTR void VKAPI_CALL families2(VkPhysicalDevice device, uint32_t* count, VkQueueFamilyProperties2* out) {
    realFamilies2(device, count, out);
    for (uint32_t i = 0; out && i < *count; ++i)
        change(out[i].queueFamilyProperties);
}

bool lacksFormats() { return VulkanInterposer::current && !VulkanInterposer::current->hasImageFormats; }
VKAPI_ATTR VkResult VKAPI_CALL formats(VkPhysicalDevice device, VkFormat format, VkImageType type, VkImageTiling tiling,
                                       VkImageUsageFlags usage, VkImageCreateFlags flags,
                                       VkImageFormatProperties* out) {
    VkResult error;
    if (failsNow("vkGetPhysicalDeviceImageFormatProperties", error))
        return error;
    if (fakesLocations())
        flags &= ~locationsFlag;
    return lacksFormats() ? VK_ERROR_FORMAT_NOT_SUPPORTED
                          : realFormats(device, format, type, tiling, usage, flags, out);
}
VKAPI_ATTR VkResult VKAPI_CALL formats2(VkPhysicalDevice device, const VkPhysicalDeviceImageFormatInfo2* info,
                                        VkImageFormatProperties2* out) {
    VkResult error;
    if (failsNow("vkGetPhysicalDeviceImageFormatProperties2", error))
        return error;
    return lacksFormats() ? VK_ERROR_FORMAT_NOT_SUPPORTED : realFormats2(device, info, out);
}

PFN_vkEnumerateDeviceExtensionProperties realExtensions = nullptr;
VKAPI_ATTR VkResult VKAPI_CALL extensions(VkPhysicalDevice device, const char* layer, uint32_t* count,
                                          VkExtensionProperties* out) {
    VkResult error;
    if (failsNow("vkEnumerateDeviceExtensionProperties", error))
        return error;
    if (!VulkanInterposer::current || layer)
        return realExtensions(device, layer, count, out);
    uint32_t real = 0;
    VkResult result = realExtensions(device, layer, &real, nullptr);
    std::vector<VkExtensionProperties> list(real);
    result = result == VK_SUCCESS ? realExtensions(device, layer, &real, list.data()) : result;
    if (result != VK_SUCCESS)
        return result;
    const VulkanInterposer& current = *VulkanInterposer::current;
    for (const std::vector<const char*>* changed : {&current.moreExtensions, &current.lessExtensions})
        for (const char* name : *changed)
            std::erase_if(list, [=](const VkExtensionProperties& p) { return !std::strcmp(p.extensionName, name); });
    for (const char* name : current.moreExtensions)
        std::strncpy(list.emplace_back().extensionName, name, VK_MAX_EXTENSION_NAME_SIZE - 1);
    const uint32_t room = out ? *count : 0;
    *count = out ? std::min(room, uint32_t(list.size())) : uint32_t(list.size());
    if (out)
        std::copy_n(list.begin(), *count, out);
    return out && room < list.size() ? VK_INCOMPLETE : VK_SUCCESS;
}

PFN_vkGetPhysicalDeviceFeatures2 realFeatures2 = nullptr;
VKAPI_ATTR void VKAPI_CALL features2(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* out) {
    realFeatures2(device, out);
    if (VulkanInterposer::current && VulkanInterposer::current->changeFeatures)
        VulkanInterposer::current->changeFeatures(*out);
}

constexpr const char* mixedSamplesCall = "vkGetPhysicalDeviceSupportedFramebufferMixedSamplesCombinationsNV";
VKAPI_ATTR VkResult VKAPI_CALL mixedSamples(VkPhysicalDevice, uint32_t* count,
                                            VkFramebufferMixedSamplesCombinationNV* out) {
    const auto& list = VulkanInterposer::current->mixedSamples;
    if (out)
        std::copy_n(list.begin(), std::min<size_t>(*count, list.size()), out);
    *count = uint32_t(list.size());
    return VK_SUCCESS;
}

// ---- by name ---------------------------------------------------------------------------------------

template <class F> PFN_vkVoidFunction replace(F& real, PFN_vkVoidFunction found, F replacement) {
    real = reinterpret_cast<F>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(replacement);
}

PFN_vkGetDeviceProcAddr realGetDevice = nullptr;
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDevice(VkDevice device, const char* name);

// `found` is the function of Vulkan.
PFN_vkVoidFunction interpose(const std::string& name, PFN_vkVoidFunction found) {
    if (VulkanInterposer::current && found)
        VulkanInterposer::current->requested.insert(name);
    if (name == mixedSamplesCall && VulkanInterposer::current && !VulkanInterposer::current->mixedSamples.empty())
        return reinterpret_cast<PFN_vkVoidFunction>(mixedSamples);
    if (name == "vkCmdSetSampleLocationsEXT" && fakesLocations())
        return reinterpret_cast<PFN_vkVoidFunction>(setLocations);
    if (name == "vkSetDebugUtilsObjectNameEXT")
        return replace(realName, found, setName);
    if (!found || (VulkanInterposer::current && VulkanInterposer::current->missing.count(name)))
        return nullptr;
    if (name == "vkCmdPipelineBarrier")
        return replace(realBarrier, found, barrier);
    if (name == "vkEnumerateDeviceExtensionProperties")
        return replace(realExtensions, found, extensions);
    if (name == "vkGetPhysicalDeviceFeatures2")
        return replace(realFeatures2, found, features2);
#define AGAA_CREATE(type)                                                                                              \
    using Create##type = Create<create##type, Vk##type##CreateInfo, Vk##type>;                                         \
    if (name == "vkCreate" #type) {                                                                                    \
        Create##type::name = "vkCreate" #type;                                                                         \
        Create##type::kind = #type;                                                                                    \
        return replace(Create##type::real, found, Create##type::call);                                                 \
    }                                                                                                                  \
    if (name == "vkDestroy" #type)                                                                                     \
        return replace(Create##type::realDestroy, found, Create##type::destroy);
#define AGAA_RESULT(type)                                                                                              \
    using Result##type = Result<result##type, PFN_vk##type>;                                                           \
    if (name == "vk" #type) {                                                                                          \
        Result##type::name = "vk" #type;                                                                               \
        return replace(Result##type::real, found, Result##type::call);                                                 \
    }
#define AGAA_NO_MEMORY
#include "vk_interposer.inc"
    if (name == "vkAllocateMemory") {
        Memory::name = "vkAllocateMemory";
        Memory::kind = "DeviceMemory";
        return replace(Memory::real, found, Memory::call);
    }
    if (name == "vkFreeMemory")
        return replace(Memory::realDestroy, found, Memory::destroy);
    if (name == "vkCreateComputePipelines") {
        CreateCompute::name = "vkCreateComputePipelines";
        return replace(CreateCompute::real, found, CreateCompute::call);
    }
    if (name == "vkCreateGraphicsPipelines") {
        CreateGraphics::name = "vkCreateGraphicsPipelines";
        return replace(CreateGraphics::real, found, CreateGraphics::call);
    }
    if (name == "vkDestroyPipeline")
        return replace(realDestroyPipeline, found, destroyPipeline);
    if (name == "vkGetPhysicalDeviceProperties")
        return replace(realProperties, found, properties);
    if (name == "vkGetPhysicalDeviceFormatProperties")
        return replace(realFormat, found, formatProperties);
    if (name == "vkGetPhysicalDeviceProperties2")
        return replace(realProperties2, found, properties2);
    if (name == "vkGetPhysicalDeviceQueueFamilyProperties")
        return replace(realFamilies, found, families);
    if (name == "vkGetPhysicalDeviceQueueFamilyProperties2")
        return replace(realFamilies2, found, families2);
    if (name == "vkGetPhysicalDeviceImageFormatProperties")
        return replace(realFormats, found, formats);
    if (name == "vkGetPhysicalDeviceImageFormatProperties2")
        return replace(realFormats2, found, formats2);
    if (name == "vkGetDeviceProcAddr")
        return replace(realGetDevice, found, getDevice);
    return found;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDevice(VkDevice device, const char* name) {
    const std::lock_guard<std::mutex> lock(mutex);
    return interpose(name, realGetDevice(device, name));
}

} // namespace

VulkanInterposer::VulkanInterposer() { current = this; }
VulkanInterposer::~VulkanInterposer() { current = nullptr; }

AgaaVkFunction AGAA_CALL VulkanInterposer::getProcAddr(void* instance, const char* name) {
    const std::lock_guard<std::mutex> lock(mutex);
    return interpose(name, vkGetInstanceProcAddr(static_cast<VkInstance>(instance), name));
}

bool VulkanInterposer::fails(const char* function, VkResult& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (findsLost()) {
        error = VK_ERROR_DEVICE_LOST;
        return true;
    }
    mustFail(function);
    error = VkResult(error_);
    return failed_ == function;
}

void VulkanInterposer::addObject(const char* kind, uint64_t handle) {
    if (!handle)
        return;
    count(kind, 1);
    const std::lock_guard<std::mutex> lock(mutex_);
    kinds[handle] = kind;
}

void VulkanInterposer::removeObject(const char* kind, uint64_t handle) {
    if (!handle)
        return;
    count(kind, -1);
    const std::lock_guard<std::mutex> lock(mutex_);
    kinds.erase(handle);
    names.erase(handle);
}

void VulkanInterposer::nameObject(uint64_t handle, const char* name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    names[handle] = name;
}

void VulkanInterposer::addPipelineCache(VkPipelineCache cache) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pipelineCaches.push_back(cache);
}

} // namespace agaa::conformance
