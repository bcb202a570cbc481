// A Vulkan device of the suite, with the validation layer where it is installed.
#pragma once

#include "device.h"

#include <vulkan/vulkan.h>

#include <mutex>

namespace agaa::conformance {

void checkVk(VkResult result, const char* call); // throws std::runtime_error

// Collects the reports of the validation layer.
class Messages {
public:
    void add(const std::string& text);
    std::vector<std::string> take();

private:
    std::mutex mutex_;
    std::vector<std::string> texts_;
};

class VulkanApi {
public:
    // A device with the requirements of agaaVkGetRequirements, and with geometry shaders if available. With options, it
    // also has the other optional features and extensions.
    VulkanApi(const Functions& sdk, const std::string& name, bool withOptions);
    ~VulkanApi();
    VulkanApi(const VulkanApi&) = delete;
    VulkanApi& operator=(const VulkanApi&) = delete;

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    uint32_t apiVersion = VK_API_VERSION_1_2;
    VkPhysicalDeviceFeatures2 enabledFeatures{};
    VkPhysicalDeviceVulkan13Features features13{};                                   // chained if it is used
    VkPhysicalDeviceDynamicRenderingFeatures dynamicRendering{};                     // chained if it is used
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditionalRendering{};          // chained if it is used
    VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock{};                  // chained if it is used
    VkPhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT attachmentOrder{}; // chained if it is used
    VkPhysicalDeviceCoverageReductionModeFeaturesNV coverageReduction{};             // the same
    std::vector<const char*> enabledExtensions;
    std::string deviceName, driverName;
    Messages messages;
    bool isValidated = false;

private:
    void createInstance();
    void choosePhysicalDevice(const std::string& name);
    void createDevice(const Functions& sdk, bool withOptions);
    void enableOptions(const AgaaVkRequirements& requirements);
    void destroy();
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

} // namespace agaa::conformance
