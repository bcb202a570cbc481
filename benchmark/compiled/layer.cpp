// A Vulkan layer for benchmark/compiled.py. The driver compiles compute pipelines, nothing is executed, and the layer
// writes the compiler's statistics of each named pipeline. It is made for drivers without a device, as RADV's null
// winsys, which compile but have neither images nor queues.
//
// AGAA_COMPILED_OUT     File to which the layer appends one JSON object for each named pipeline.
// AGAA_COMPILED_CACHE   Folder of statistics, shared by processes. Equal shaders are compiled once. It must belong to
//                       one device of one driver.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

// ---- state ---------------------------------------------------------------------------------------

// The next functions below the layer, and what the layer knows of the driver's objects. A process has one device.
struct Layer {
    PFN_vkGetInstanceProcAddr nextInstanceProc = nullptr;
    PFN_vkGetDeviceProcAddr nextDeviceProc = nullptr;
    VkInstance instance = VK_NULL_HANDLE;
    std::mutex mutex; // of the maps
    std::map<VkShaderModule, std::vector<uint32_t>> modules;
    std::map<VkDescriptorSetLayout, uint64_t> setLayouts; // hashes
    std::map<VkPipelineLayout, uint64_t> pipelineLayouts; // hashes
    std::map<VkPipeline, std::string> statistics;         // members of a JSON object
};

Layer& layer() {
    static Layer one;
    return one;
}

template <class Function> Function next(VkDevice device, const char* name) {
    return reinterpret_cast<Function>(layer().nextDeviceProc(device, name));
}

// Returns the structure of this type in a chain, or null.
template <class Structure> const Structure* findInChain(const void* chain, VkStructureType type) {
    for (auto link = static_cast<const VkBaseInStructure*>(chain); link; link = link->pNext)
        if (link->sType == type)
            return reinterpret_cast<const Structure*>(link);
    return nullptr;
}

// ---- functions that do nothing --------------------------------------------------------------------

template <class Function> struct Nothing;
template <class Result, class... Arguments> struct Nothing<Result(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR Result VKAPI_CALL call(Arguments...) { return Result(); } // VK_SUCCESS is 0
};

// Stands in for all commands that are recorded: they return nothing, and the caller removes the arguments.
VKAPI_ATTR void VKAPI_CALL recordNothing() {}

// Creates an object that only the layer knows.
template <class Function> struct Placeholder;
template <class Info, class Handle>
struct Placeholder<VkResult(VKAPI_PTR*)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*)> {
    static VKAPI_ATTR VkResult VKAPI_CALL create(VkDevice, const Info*, const VkAllocationCallbacks*, Handle* out) {
        *out = make();
        return VK_SUCCESS;
    }
    static Handle make() {
        static std::atomic<uint64_t> count = 0;
        constexpr uint64_t first = uint64_t(1) << 63; // no address of a driver's object
        return reinterpret_cast<Handle>(first + ++count);
    }
};

using PlaceholderPipeline = Placeholder<VkResult(VKAPI_PTR*)(VkDevice, const VkComputePipelineCreateInfo*,
                                                             const VkAllocationCallbacks*, VkPipeline*)>;

// ---- memory: one type, which everything may use ----------------------------------------------------

VKAPI_ATTR void VKAPI_CALL getMemoryProperties(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* out) {
    *out = {};
    out->memoryTypeCount = 1;
    out->memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                        VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    out->memoryHeapCount = 1;
    out->memoryHeaps[0] = {VkDeviceSize(8) << 30, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
}

VKAPI_ATTR void VKAPI_CALL getMemoryProperties2(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties2* out) {
    getMemoryProperties(device, &out->memoryProperties);
}

VKAPI_ATTR void VKAPI_CALL getBufferRequirements(VkDevice device, VkBuffer buffer, VkMemoryRequirements* out) {
    next<PFN_vkGetBufferMemoryRequirements>(device, "vkGetBufferMemoryRequirements")(device, buffer, out);
    out->memoryTypeBits = 1;
}

VKAPI_ATTR void VKAPI_CALL getBufferRequirements2(VkDevice device, const VkBufferMemoryRequirementsInfo2* info,
                                                  VkMemoryRequirements2* out) {
    getBufferRequirements(device, info->buffer, &out->memoryRequirements);
}

VKAPI_ATTR void VKAPI_CALL getImageRequirements(VkDevice, VkImage, VkMemoryRequirements* out) {
    *out = {1 << 16, 256, 1};
}

VKAPI_ATTR void VKAPI_CALL getImageRequirements2(VkDevice, const VkImageMemoryRequirementsInfo2*,
                                                 VkMemoryRequirements2* out) {
    out->memoryRequirements = {1 << 16, 256, 1};
}

// ---- keys of equal pipelines ------------------------------------------------------------------------

class Hash { // FNV-1a
public:
    void addBytes(const void* data, size_t size) {
        for (size_t i = 0; i < size; ++i)
            value_ = (value_ ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3;
    }
    template <class Value> void add(const Value& value) { addBytes(&value, sizeof value); }
    uint64_t value() const { return value_; }

private:
    uint64_t value_ = 0xcbf29ce484222325;
};

// Adds the values of the constants that the module declares. Pipelines may specify further ones.
void addConstants(Hash& hash, const std::vector<uint32_t>& words, const VkSpecializationInfo* info) {
    constexpr uint32_t opDecorate = 71, specId = 1, headerWords = 5;
    for (size_t at = headerWords; info && at + 3 < words.size(); at += words[at] >> 16) {
        if (words[at] >> 16 == 0)
            return;
        if ((words[at] & 0xFFFF) != opDecorate || words[at + 2] != specId)
            continue;
        for (uint32_t i = 0; i < info->mapEntryCount; ++i) {
            const VkSpecializationMapEntry& entry = info->pMapEntries[i];
            if (entry.constantID == words[at + 3]) {
                hash.add(entry.constantID);
                hash.addBytes(static_cast<const char*>(info->pData) + entry.offset, entry.size);
            }
        }
    }
}

std::string keyOf(const VkComputePipelineCreateInfo& info) {
    const std::scoped_lock lock(layer().mutex);
    const std::vector<uint32_t>& words = layer().modules[info.stage.module];
    Hash hash;
    hash.addBytes(words.data(), words.size() * sizeof words[0]);
    addConstants(hash, words, info.stage.pSpecializationInfo);
    hash.add(layer().pipelineLayouts[info.layout]);
    hash.add(info.flags);
    hash.add(info.stage.flags);
    if (const auto size = findInChain<VkPipelineShaderStageRequiredSubgroupSizeCreateInfo>(
            info.stage.pNext, VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO))
        hash.add(size->requiredSubgroupSize);
    char name[17];
    std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash.value()));
    return name;
}

VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkShaderModule* out) {
    const VkResult result =
        next<PFN_vkCreateShaderModule>(device, "vkCreateShaderModule")(device, info, allocator, out);
    const std::scoped_lock lock(layer().mutex);
    layer().modules[*out].assign(info->pCode, info->pCode + info->codeSize / sizeof(uint32_t));
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createSetLayout(VkDevice device, const VkDescriptorSetLayoutCreateInfo* info,
                                               const VkAllocationCallbacks* allocator, VkDescriptorSetLayout* out) {
    const VkResult result =
        next<PFN_vkCreateDescriptorSetLayout>(device, "vkCreateDescriptorSetLayout")(device, info, allocator, out);
    Hash hash;
    for (uint32_t i = 0; i < info->bindingCount; ++i) {
        hash.add(info->pBindings[i].binding);
        hash.add(info->pBindings[i].descriptorType);
        hash.add(info->pBindings[i].descriptorCount);
    }
    const std::scoped_lock lock(layer().mutex);
    layer().setLayouts[*out] = hash.value();
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createPipelineLayout(VkDevice device, const VkPipelineLayoutCreateInfo* info,
                                                    const VkAllocationCallbacks* allocator, VkPipelineLayout* out) {
    const VkResult result =
        next<PFN_vkCreatePipelineLayout>(device, "vkCreatePipelineLayout")(device, info, allocator, out);
    const std::scoped_lock lock(layer().mutex);
    Hash hash;
    for (uint32_t i = 0; i < info->setLayoutCount; ++i)
        hash.add(layer().setLayouts[info->pSetLayouts[i]]);
    for (uint32_t i = 0; i < info->pushConstantRangeCount; ++i)
        hash.add(info->pPushConstantRanges[i]);
    layer().pipelineLayouts[*out] = hash.value();
    return result;
}

// ---- statistics ---------------------------------------------------------------------------------------

// Returns the statistics of a compute pipeline as members of a JSON object.
std::string readStatistics(VkDevice device, VkPipeline pipeline) {
    const auto getExecutables =
        next<PFN_vkGetPipelineExecutablePropertiesKHR>(device, "vkGetPipelineExecutablePropertiesKHR");
    const auto getStatistics =
        next<PFN_vkGetPipelineExecutableStatisticsKHR>(device, "vkGetPipelineExecutableStatisticsKHR");
    VkPipelineInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
    info.pipeline = pipeline;
    uint32_t count = 1;
    VkPipelineExecutablePropertiesKHR executable{};
    executable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
    getExecutables(device, &info, &count, &executable);
    VkPipelineExecutableInfoKHR which{};
    which.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
    which.pipeline = pipeline;
    count = 0;
    getStatistics(device, &which, &count, nullptr);
    VkPipelineExecutableStatisticKHR empty{};
    empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
    std::vector<VkPipelineExecutableStatisticKHR> statistics(count, empty);
    getStatistics(device, &which, &count, statistics.data());
    std::string out = "\"Subgroup size\": " + std::to_string(executable.subgroupSize);
    for (const VkPipelineExecutableStatisticKHR& one : statistics)
        if (one.format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
            out += ", \"" + std::string(one.name) + "\": " + std::to_string(one.value.u64);
    return out;
}

VkResult compile(VkDevice device, VkPipelineCache cache, const VkComputePipelineCreateInfo& info,
                 const VkAllocationCallbacks* allocator, VkPipeline* out, std::string& statistics) {
    VkComputePipelineCreateInfo captured = info;
    captured.flags |= VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    const VkResult result = next<PFN_vkCreateComputePipelines>(device, "vkCreateComputePipelines")(
        device, cache, 1, &captured, allocator, out);
    if (result == VK_SUCCESS)
        statistics = readStatistics(device, *out);
    return result;
}

// Compiles a pipeline, or takes the statistics of an equal one.
VkResult createComputePipeline(VkDevice device, VkPipelineCache cache, const VkComputePipelineCreateInfo& info,
                               const VkAllocationCallbacks* allocator, VkPipeline* out) {
    std::string statistics;
    const char* folder = std::getenv("AGAA_COMPILED_CACHE");
    const std::string kept = folder ? std::string(folder) + "/" + keyOf(info) : "";
    if (std::ifstream file(kept); std::getline(file, statistics)) {
        *out = PlaceholderPipeline::make();
    } else {
        if (const VkResult result = compile(device, cache, info, allocator, out, statistics); result != VK_SUCCESS)
            return result;
        if (folder)
            std::ofstream(kept) << statistics << "\n";
    }
    const std::scoped_lock lock(layer().mutex);
    layer().statistics[*out] = statistics;
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL createComputePipelines(VkDevice device, VkPipelineCache cache, uint32_t count,
                                                      const VkComputePipelineCreateInfo* infos,
                                                      const VkAllocationCallbacks* allocator, VkPipeline* out) {
    for (uint32_t i = 0; i < count; ++i)
        if (const VkResult result = createComputePipeline(device, cache, infos[i], allocator, &out[i]);
            result != VK_SUCCESS)
            return result;
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL createGraphicsPipelines(VkDevice, VkPipelineCache, uint32_t count,
                                                       const VkGraphicsPipelineCreateInfo*,
                                                       const VkAllocationCallbacks*, VkPipeline* out) {
    for (uint32_t i = 0; i < count; ++i)
        out[i] = PlaceholderPipeline::make();
    return VK_SUCCESS;
}

// Writes the statistics of a compute pipeline when it gets its name.
VKAPI_ATTR VkResult VKAPI_CALL setObjectName(VkDevice, const VkDebugUtilsObjectNameInfoEXT* info) {
    if (info->objectType != VK_OBJECT_TYPE_PIPELINE)
        return VK_SUCCESS;
    const std::scoped_lock lock(layer().mutex);
    const auto found = layer().statistics.find(reinterpret_cast<VkPipeline>(info->objectHandle));
    const char* out = std::getenv("AGAA_COMPILED_OUT");
    if (found != layer().statistics.end() && out)
        std::ofstream(out, std::ios::app) << "{\"name\": \"" << info->pObjectName << "\", " << found->second << "}\n";
    return VK_SUCCESS;
}

// ---- instance and device ----------------------------------------------------------------------------------

template <class Link> Link* findLink(const void* chain, VkStructureType type) {
    for (auto link = static_cast<const VkBaseInStructure*>(chain); link; link = link->pNext) {
        auto found = reinterpret_cast<const Link*>(link);
        if (link->sType == type && found->function == VK_LAYER_LINK_INFO)
            return const_cast<Link*>(found); // the loader lets layers advance it
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* out) {
    auto link = findLink<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    layer().nextInstanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(layer().nextInstanceProc(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, out);
    layer().instance = *out;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* out) {
    auto link = findLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    layer().nextDeviceProc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const PFN_vkGetInstanceProcAddr instanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    std::vector<const char*> extensions(info->ppEnabledExtensionNames,
                                        info->ppEnabledExtensionNames + info->enabledExtensionCount);
    extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR feature{};
    feature.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    feature.pNext = const_cast<void*>(info->pNext);
    feature.pipelineExecutableInfo = VK_TRUE;
    VkDeviceCreateInfo extended = *info;
    extended.pNext = &feature;
    extended.enabledExtensionCount = uint32_t(extensions.size());
    extended.ppEnabledExtensionNames = extensions.data();
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(instanceProc(layer().instance, "vkCreateDevice"));
    return create(physical, &extended, allocator, out);
}

// ---- the layer's functions ----------------------------------------------------------------------------------

template <class Function> PFN_vkVoidFunction erased(Function function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

const std::map<std::string_view, PFN_vkVoidFunction>& deviceFunctions() {
#define AGAA_NOTHING(name)                                                                                             \
    { #name, erased(Nothing <PFN_##name>::call) }
#define AGAA_PLACEHOLDER(name)                                                                                         \
    { #name, erased(Placeholder <PFN_##name>::create) }
    static const std::map<std::string_view, PFN_vkVoidFunction> functions = {
        {"vkCreateComputePipelines", erased(createComputePipelines)},
        {"vkCreateDescriptorSetLayout", erased(createSetLayout)},
        {"vkCreateGraphicsPipelines", erased(createGraphicsPipelines)},
        {"vkCreatePipelineLayout", erased(createPipelineLayout)},
        {"vkCreateShaderModule", erased(createShaderModule)},
        {"vkGetBufferMemoryRequirements", erased(getBufferRequirements)},
        {"vkGetBufferMemoryRequirements2", erased(getBufferRequirements2)},
        {"vkGetImageMemoryRequirements", erased(getImageRequirements)},
        {"vkGetImageMemoryRequirements2", erased(getImageRequirements2)},
        {"vkSetDebugUtilsObjectNameEXT", erased(setObjectName)},
        AGAA_PLACEHOLDER(vkCreateFence),
        AGAA_PLACEHOLDER(vkCreateFramebuffer),
        AGAA_PLACEHOLDER(vkCreateImage),
        AGAA_PLACEHOLDER(vkCreateImageView),
        AGAA_PLACEHOLDER(vkCreateSemaphore),
        AGAA_NOTHING(vkBeginCommandBuffer),
        AGAA_NOTHING(vkBindImageMemory),
        AGAA_NOTHING(vkBindImageMemory2),
        AGAA_NOTHING(vkDestroyDevice),
        AGAA_NOTHING(vkDestroyFence),
        AGAA_NOTHING(vkDestroyFramebuffer),
        AGAA_NOTHING(vkDestroyImage),
        AGAA_NOTHING(vkDestroyImageView),
        AGAA_NOTHING(vkDestroyPipeline),
        AGAA_NOTHING(vkDestroySemaphore),
        AGAA_NOTHING(vkDeviceWaitIdle),
        AGAA_NOTHING(vkEndCommandBuffer),
        AGAA_NOTHING(vkFreeCommandBuffers),
        AGAA_NOTHING(vkGetFenceStatus),
        AGAA_NOTHING(vkGetQueryPoolResults),
        AGAA_NOTHING(vkQueueSubmit),
        AGAA_NOTHING(vkQueueSubmit2),
        AGAA_NOTHING(vkQueueSubmit2KHR),
        AGAA_NOTHING(vkQueueWaitIdle),
        AGAA_NOTHING(vkResetCommandBuffer),
        AGAA_NOTHING(vkResetCommandPool),
        AGAA_NOTHING(vkResetFences),
        AGAA_NOTHING(vkUpdateDescriptorSets),
        AGAA_NOTHING(vkWaitForFences),
    };
#undef AGAA_NOTHING
#undef AGAA_PLACEHOLDER
    return functions;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProc(VkDevice device, const char* name);
VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProc(VkInstance instance, const char* name);

// Returns the layer's function, or null.
PFN_vkVoidFunction ownFunction(std::string_view name) {
    static const std::map<std::string_view, PFN_vkVoidFunction> instanceFunctions = {
        {"vkCreateDevice", erased(createDevice)},
        {"vkCreateInstance", erased(createInstance)},
        {"vkDestroyInstance", erased(Nothing<PFN_vkDestroyInstance>::call)},
        {"vkGetDeviceProcAddr", erased(getDeviceProc)},
        {"vkGetInstanceProcAddr", erased(getInstanceProc)},
        {"vkGetPhysicalDeviceMemoryProperties", erased(getMemoryProperties)},
        {"vkGetPhysicalDeviceMemoryProperties2", erased(getMemoryProperties2)},
    };
    if (name.starts_with("vkCmd"))
        return recordNothing;
    for (const auto* functions : {&deviceFunctions(), &instanceFunctions})
        if (const auto found = functions->find(name); found != functions->end())
            return found->second;
    return nullptr;
}

PFN_vkVoidFunction VKAPI_CALL getDeviceProc(VkDevice device, const char* name) {
    const PFN_vkVoidFunction own = ownFunction(name);
    return own ? own : layer().nextDeviceProc(device, name);
}

PFN_vkVoidFunction VKAPI_CALL getInstanceProc(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction own = ownFunction(name);
    return own || !layer().nextInstanceProc ? own : layer().nextInstanceProc(instance, name);
}

} // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
    interface->loaderLayerInterfaceVersion = CURRENT_LOADER_LAYER_INTERFACE_VERSION;
    interface->pfnGetInstanceProcAddr = getInstanceProc;
    interface->pfnGetDeviceProcAddr = getDeviceProc;
    interface->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
