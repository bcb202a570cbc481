#include "vk/device.h"

#include "vk/features.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace harness::vk {

namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

template <class Item, class Call> std::vector<Item> enumerate(Call call, const char* what) {
    uint32_t count = 0;
    check(call(&count, nullptr), what);
    std::vector<Item> items(count);
    check(call(&count, items.data()), what);
    items.resize(count);
    return items;
}

bool hasLayer(const char* name) {
    const auto layers = enumerate<VkLayerProperties>(
        [](uint32_t* count, VkLayerProperties* items) { return vkEnumerateInstanceLayerProperties(count, items); },
        "list the layers");
    return std::any_of(layers.begin(), layers.end(),
                       [name](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool hasInstanceExtension(const char* name, const char* layer) {
    const auto extensions = enumerate<VkExtensionProperties>(
        [layer](uint32_t* count, VkExtensionProperties* items) {
            return vkEnumerateInstanceExtensionProperties(layer, count, items);
        },
        "list the instance extensions");
    return std::any_of(extensions.begin(), extensions.end(),
                       [name](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

std::optional<uint32_t> graphicsAndComputeFamily(VkPhysicalDevice device) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & wanted) == wanted)
            return i;
    }
    return std::nullopt;
}

int rank(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return 1;
    default:
        return 0;
    }
}

} // namespace

Device::Device(const RendererOptions& options) {
    try {
        createInstance(options.validation);
        choosePhysicalDevice();
        createDevice(options);
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() { destroy(); }

void Device::createInstance(bool useValidation) {
    check(vkEnumerateInstanceVersion(&instanceVersion_), "ask for its version");
    if (instanceVersion_ < VK_API_VERSION_1_2)
        throw std::runtime_error("The installed Vulkan loader is older than Vulkan 1.2.");
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "agaa-harness";
    application.apiVersion = instanceVersion_ >= VK_API_VERSION_1_3 ? VK_API_VERSION_1_3 : VK_API_VERSION_1_2;

    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;

    VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(messages_);
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT validation{};
    validation.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    validation.enabledValidationFeatureCount = 1;
    validation.pEnabledValidationFeatures = enabled;

    const bool isValidated = useValidation && hasLayer(validationLayer);
    bool synchronises = false;
    if (isValidated) {
        layers.push_back(validationLayer);
        synchronises = hasInstanceExtension(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME, validationLayer);
        if (synchronises) {
            extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
            validation.pNext = info.pNext;
            info.pNext = &validation;
        }
    }
    const bool hasMessenger =
        useValidation && (hasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, nullptr) ||
                          (isValidated && hasInstanceExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, validationLayer)));
    if (hasMessenger) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        messenger.pNext = info.pNext; // reports the creation and destruction of the instance, too
        info.pNext = &messenger;
    }
    hasValidation_ = synchronises && hasMessenger;
    info.enabledLayerCount = uint32_t(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = uint32_t(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    check(vkCreateInstance(&info, nullptr, &instance_), "create an instance");

    if (hasMessenger) {
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
        messenger.pNext = nullptr;
        check(create(instance_, &messenger, nullptr, &messenger_), "create a debug messenger");
    }
}

void Device::choosePhysicalDevice() {
    const auto devices = enumerate<VkPhysicalDevice>(
        [this](uint32_t* count, VkPhysicalDevice* items) {
            return vkEnumeratePhysicalDevices(instance_, count, items);
        },
        "list the devices");
    const char* wanted = std::getenv("AGAA_DEVICE");
    int bestRank = -1;
    for (VkPhysicalDevice candidate : devices) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(candidate, &properties);
        const auto family = graphicsAndComputeFamily(candidate);
        if (!family || properties.apiVersion < VK_API_VERSION_1_2)
            continue;
        if (wanted && std::string_view(properties.deviceName).find(wanted) == std::string::npos)
            continue;
        if (rank(properties.deviceType) > bestRank) {
            bestRank = rank(properties.deviceType);
            physicalDevice_ = candidate;
            properties_ = properties;
            queueFamily_ = *family;
        }
    }
    if (physicalDevice_ == VK_NULL_HANDLE)
        throw std::runtime_error(wanted ? "No Vulkan 1.2 device has \"" + std::string(wanted) +
                                              "\" in its name, as AGAA_DEVICE demands."
                                        : "There is no Vulkan 1.2 device with graphics and compute.");
    vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memory_);
    apiVersion_ = instanceVersion_ >= VK_API_VERSION_1_3 && properties_.apiVersion >= VK_API_VERSION_1_3
                      ? VK_API_VERSION_1_3
                      : VK_API_VERSION_1_2;
}

void Device::createDevice(const RendererOptions& options) {
    const auto isUnwanted = [&](std::string_view feature) {
        return (feature == "dynamicRendering" && options.renderPass) ||
               (feature == "conditionalRendering" && options.noConditionalRendering) ||
               (feature == "geometryShader" && options.noGeometryShaders);
    };
    AgaaVkRequirements requirements = AGAA_VK_REQUIREMENTS_INIT;
    if (agaaVkGetRequirements(&requirements) != AGAA_OK)
        throw std::runtime_error("The SDK did not say what it requires of a Vulkan device.");
    if (requirements.apiVersion > apiVersion_)
        throw std::runtime_error("The device \"" + name() + "\" is older than the SDK requires.");

    const auto available = enumerate<VkExtensionProperties>(
        [this](uint32_t* count, VkExtensionProperties* items) {
            return vkEnumerateDeviceExtensionProperties(physicalDevice_, nullptr, count, items);
        },
        "list the device extensions");
    const auto enable = [&](const char* wanted) {
        const bool isThere = std::any_of(available.begin(), available.end(), [wanted](const auto& extension) {
            return std::strcmp(extension.extensionName, wanted) == 0;
        });
        if (isThere)
            extensions_.push_back(wanted);
        return isThere;
    };
    FeatureChain::Extensions has;
    for (uint32_t i = 0; i < requirements.optionalDeviceExtensionCount; ++i) {
        const char* extension = requirements.optionalDeviceExtensions[i];
        const auto is = [extension](const char* name) { return std::strcmp(extension, name) == 0; };
        if ((is(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME) && isUnwanted("dynamicRendering")) ||
            (is(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME) && isUnwanted("conditionalRendering")) ||
            (is(VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME) && apiVersion_ >= VK_API_VERSION_1_3) || // a part of 1.3
            !enable(extension))
            continue;
        has.dynamicRendering |= is(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME);
        has.synchronization2 |= is(VK_KHR_SYNCHRONIZATION_2_EXTENSION_NAME);
        has.conditionalRendering |= is(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME);
        has.interlock |= is(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME);
        has.attachmentOrder |= is(VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME);
        has.coverageReduction |= is(VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME);
    }

    FeatureChain supported(apiVersion_, has);
    supported.query(physicalDevice_);
    FeatureChain& enabled = enabled_.emplace(apiVersion_, has);
    for (uint32_t i = 0; i < requirements.requiredFeatureCount; ++i) {
        const std::string feature = requirements.requiredFeatures[i];
        if (!supported.isSet(feature))
            throw std::runtime_error("The device \"" + name() + "\" lacks the feature \"" + feature +
                                     "\", which the SDK requires.");
        enabled.set(feature);
    }
    for (uint32_t i = 0; i < requirements.optionalFeatureCount; ++i) {
        const std::string_view feature = requirements.optionalFeatures[i];
        if (!isUnwanted(feature) && supported.isSet(feature))
            enabled.set(feature);
    }
    // Only the sample engine uses the feature. Mesa's software rasteriser (22.3) reads wrong texels with it at the
    // edges of triangles.
    hasAnisotropy_ = properties_.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU && supported.isSet("samplerAnisotropy") &&
                     enabled.set("samplerAnisotropy");
    hasPrimitiveIds_ =
        !isUnwanted("geometryShader") && supported.isSet("geometryShader") && enabled.set("geometryShader");
    hasDynamicRendering_ = enabled.isSet("dynamicRendering");

    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = queueFamily_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = enabled.chain();
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = uint32_t(extensions_.size());
    info.ppEnabledExtensionNames = extensions_.data();
    check(vkCreateDevice(physicalDevice_, &info, nullptr, &device_), "create a device");
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = queueFamily_;
    commandPool_ = make<CommandPool>(device_, vkCreateCommandPool, pool, "create a command pool");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    fence_ = make<Fence>(device_, vkCreateFence, fence, "create a fence");
}

void Device::destroy() {
    if (device_ != VK_NULL_HANDLE)
        vkDeviceWaitIdle(device_);
    fence_ = {};
    commandPool_ = {};
    if (device_ != VK_NULL_HANDLE)
        vkDestroyDevice(device_, nullptr);
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroyMessenger(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE)
        vkDestroyInstance(instance_, nullptr);
    messages_.handOver();
}

VkCommandBuffer Device::beginCommands() const {
    VkCommandBufferAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocation.commandPool = commandPool_.get();
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device_, &allocation, &commands), "allocate a command buffer");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
    return commands;
}

double Device::submitAndWait(VkCommandBuffer commands) const {
    check(vkEndCommandBuffer(commands), "end a command buffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    const VkFence fence = fence_.get();
    const auto start = std::chrono::steady_clock::now();
    check(vkQueueSubmit(queue_, 1, &submit, fence), "submit commands");
    check(vkWaitForFences(device_, 1, &fence, VK_TRUE, UINT64_MAX), "wait for the device");
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    check(vkResetFences(device_, 1, &fence), "reset a fence");
    vkFreeCommandBuffers(device_, commandPool_.get(), 1, &commands);
    return elapsed.count();
}

void Device::discardCommands(VkCommandBuffer commands) const {
    vkFreeCommandBuffers(device_, commandPool_.get(), 1, &commands);
}

void Device::runCommands(const std::function<void(VkCommandBuffer)>& record) const {
    const VkCommandBuffer commands = beginCommands();
    try {
        record(commands);
    } catch (...) {
        discardCommands(commands);
        throw;
    }
    submitAndWait(commands);
}

AgaaVkFunction AGAA_CALL Device::getProcAddr(void* instance, const char* name) {
    return reinterpret_cast<AgaaVkFunction>(vkGetInstanceProcAddr(static_cast<VkInstance>(instance), name));
}

} // namespace harness::vk
