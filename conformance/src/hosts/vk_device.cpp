#include "vk_device.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace agaa::conformance {

namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

// Members of VkPhysicalDeviceFeatures by the names of agaaVkGetRequirements.
VkBool32* featureOf(VkPhysicalDeviceFeatures& features, const std::string& name) {
#define FEATURE(member)                                                                                                \
    if (name == #member)                                                                                               \
        return &features.member;
    // clang-format takes a list of macros for one expression.
    // clang-format off
    FEATURE(robustBufferAccess) FEATURE(fullDrawIndexUint32) FEATURE(imageCubeArray) FEATURE(independentBlend)
    FEATURE(geometryShader) FEATURE(tessellationShader) FEATURE(sampleRateShading) FEATURE(dualSrcBlend)
    FEATURE(logicOp)
    FEATURE(multiDrawIndirect) FEATURE(drawIndirectFirstInstance) FEATURE(depthClamp) FEATURE(depthBiasClamp)
    FEATURE(fillModeNonSolid) FEATURE(depthBounds) FEATURE(wideLines) FEATURE(largePoints) FEATURE(alphaToOne)
    FEATURE(multiViewport) FEATURE(samplerAnisotropy) FEATURE(occlusionQueryPrecise) FEATURE(pipelineStatisticsQuery)
    FEATURE(vertexPipelineStoresAndAtomics) FEATURE(fragmentStoresAndAtomics)
    FEATURE(shaderTessellationAndGeometryPointSize) FEATURE(shaderImageGatherExtended)
    FEATURE(shaderStorageImageExtendedFormats) FEATURE(shaderStorageImageMultisample)
    FEATURE(shaderStorageImageReadWithoutFormat) FEATURE(shaderStorageImageWriteWithoutFormat)
    FEATURE(shaderUniformBufferArrayDynamicIndexing) FEATURE(shaderSampledImageArrayDynamicIndexing)
    FEATURE(shaderStorageBufferArrayDynamicIndexing) FEATURE(shaderStorageImageArrayDynamicIndexing)
    FEATURE(shaderClipDistance) FEATURE(shaderCullDistance) FEATURE(shaderFloat64) FEATURE(shaderInt64)
    FEATURE(shaderInt16) FEATURE(shaderResourceResidency) FEATURE(shaderResourceMinLod)
    // clang-format on
#undef FEATURE
                                                                                return nullptr;
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT types,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    // General messages of the loader and of drivers are skipped.
    const auto checked =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    if (types & checked)
        static_cast<Messages*>(user)->add(data->pMessage ? data->pMessage : "");
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(Messages& messages) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = &messages;
    return info;
}

bool hasValidationLayer() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [](const VkLayerProperties& layer) { return !std::strcmp(layer.layerName, validationLayer); });
}

bool hasDeviceExtension(VkPhysicalDevice device, const char* name) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const VkExtensionProperties& e) { return !std::strcmp(e.extensionName, name); });
}

} // namespace

void checkVk(VkResult result, const char* call) {
    if (result < 0)
        throw std::runtime_error(std::string(call) + " returns VkResult " + std::to_string(result) +
                                 " to the suite's host.");
}

void Messages::add(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    texts_.push_back(text);
}

std::vector<std::string> Messages::take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> texts;
    texts.swap(texts_);
    return texts;
}

VulkanApi::VulkanApi(const Functions& sdk, const std::string& name, bool withOptions) {
    try {
        createInstance();
        choosePhysicalDevice(name);
        createDevice(sdk, withOptions);
    } catch (...) {
        destroy();
        throw;
    }
}

VulkanApi::~VulkanApi() { destroy(); }

void VulkanApi::destroy() {
    if (device)
        vkDestroyDevice(device, nullptr);
    if (messenger_)
        reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"))(instance, messenger_, nullptr);
    if (instance)
        vkDestroyInstance(instance, nullptr);
}

void VulkanApi::createInstance() {
    uint32_t loader = 0;
    vkEnumerateInstanceVersion(&loader);
    if (loader < VK_API_VERSION_1_2)
        throw Skipped{"the Vulkan loader is older than 1.2."};
    VkApplicationInfo app{};
    app.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    app.pApplicationName = "agaa-conformance";
    app.apiVersion = std::min(loader, VK_API_VERSION_1_3);
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &app;
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enabled;
    const char* extensions[] = {VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME, VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    isValidated = hasValidationLayer();
    if (isValidated) {
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &validationLayer;
        info.enabledExtensionCount = 2;
        info.ppEnabledExtensionNames = extensions;
        info.pNext = &features;
    } else
        std::printf("vk: %s is not installed: messages are not tested.\n", validationLayer);
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result < 0) {
        instance = VK_NULL_HANDLE;
        throw Skipped{"vkCreateInstance returns VkResult " + std::to_string(result) + "."};
    }
    if (!isValidated)
        return;
    const VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(messages);
    checkVk(reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(
                instance, "vkCreateDebugUtilsMessengerEXT"))(instance, &messenger, nullptr, &messenger_),
            "vkCreateDebugUtilsMessengerEXT");
}

void VulkanApi::choosePhysicalDevice(const std::string& name) {
    uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    vkEnumeratePhysicalDevices(instance, &count, devices.data());
    for (const VkPhysicalDevice candidate : devices) {
        VkPhysicalDeviceDriverProperties driver{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        VkPhysicalDeviceProperties2 properties{};
        properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        properties.pNext = &driver;
        vkGetPhysicalDeviceProperties2(candidate, &properties);
        if (std::string(properties.properties.deviceName).find(name) == std::string::npos ||
            properties.properties.apiVersion < VK_API_VERSION_1_2)
            continue;
        uint32_t families = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &families, nullptr);
        std::vector<VkQueueFamilyProperties> family(families);
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &families, family.data());
        for (uint32_t i = 0; i < families; ++i)
            if ((family[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) && (family[i].queueFlags & VK_QUEUE_COMPUTE_BIT)) {
                physicalDevice = candidate;
                queueFamily = i;
                deviceName = properties.properties.deviceName;
                driverName = std::string(driver.driverName) + " " + driver.driverInfo;
                return;
            }
    }
    throw Skipped{"there is no device of Vulkan 1.2 with graphics and compute" +
                  (name.empty() ? std::string(".") : ", whose name contains " + name + ".")};
}

void VulkanApi::createDevice(const Functions& sdk, bool withOptions) {
    AgaaVkRequirements requirements = AGAA_VK_REQUIREMENTS_INIT;
    if (sdk.agaaVkGetRequirements(&requirements) != AGAA_OK)
        throw std::runtime_error("agaaVkGetRequirements fails.");
    apiVersion = requirements.apiVersion;
    enabledFeatures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    VkPhysicalDeviceFeatures available;
    vkGetPhysicalDeviceFeatures(physicalDevice, &available);
    for (uint32_t i = 0; i < requirements.requiredFeatureCount; ++i) {
        const char* name = requirements.requiredFeatures[i];
        VkBool32* wanted = featureOf(enabledFeatures.features, name);
        if (!wanted || !*featureOf(available, name))
            throw Skipped{"the device lacks the required feature " + std::string(name) + "."};
        *wanted = VK_TRUE;
    }
    enabledFeatures.features.geometryShader = available.geometryShader; // "dcaa" needs it
    if (withOptions)
        enableOptions(requirements);
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &enabledFeatures;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = uint32_t(enabledExtensions.size());
    info.ppEnabledExtensionNames = enabledExtensions.data();
    checkVk(vkCreateDevice(physicalDevice, &info, nullptr, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, queueFamily, 0, &queue);
}

// Enables the extensions and their features. Dynamic rendering comes from Vulkan 1.3 or from the extension.
void VulkanApi::enableOptions(const AgaaVkRequirements& requirements) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physicalDevice, &properties);
    const bool is13 = properties.apiVersion >= VK_API_VERSION_1_3;
    for (uint32_t i = 0; i < requirements.optionalDeviceExtensionCount; ++i) {
        const char* name = requirements.optionalDeviceExtensions[i];
        if (hasDeviceExtension(physicalDevice, name) &&
            !(is13 && !std::strcmp(name, VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME)))
            enabledExtensions.push_back(name);
        if (!is13 && !std::strcmp(name, VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME) &&
            hasDeviceExtension(physicalDevice, name)) {
            dynamicRendering.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES;
            dynamicRendering.dynamicRendering = VK_TRUE;
            enabledFeatures.pNext = &dynamicRendering;
        }
    }
    if (is13) {
        apiVersion = VK_API_VERSION_1_3;
        features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        VkPhysicalDeviceFeatures2 has{};
        has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        has.pNext = &features13;
        vkGetPhysicalDeviceFeatures2(physicalDevice, &has);
        const VkBool32 fullSubgroups = features13.computeFullSubgroups;
        features13 = {};
        features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        features13.dynamicRendering = VK_TRUE;
        features13.computeFullSubgroups = fullSubgroups;
        enabledFeatures.pNext = &features13;
    }
    const auto enableAvailable = [this](const char* extension, auto& features) {
        if (!hasDeviceExtension(physicalDevice, extension))
            return;
        VkPhysicalDeviceFeatures2 has{};
        has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        has.pNext = &features;
        vkGetPhysicalDeviceFeatures2(physicalDevice, &has);
        features.pNext = enabledFeatures.pNext;
        enabledFeatures.pNext = &features;
    };
    conditionalRendering.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT;
    enableAvailable(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME, conditionalRendering);
    conditionalRendering.inheritedConditionalRendering = VK_FALSE;
    interlock.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADER_INTERLOCK_FEATURES_EXT;
    enableAvailable(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME, interlock);
    attachmentOrder.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_FEATURES_EXT;
    enableAvailable(VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME, attachmentOrder);
    coverageReduction.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV;
    enableAvailable(VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME, coverageReduction);
}

} // namespace agaa::conformance
