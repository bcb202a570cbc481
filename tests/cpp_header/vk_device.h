// A Vulkan device with a command buffer that records, and no window.
#pragma once

#include <vulkan/vulkan.h>

#include <stdexcept>

namespace cpp_header {

class VkHost {
public:
    VkHost() {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_2;
        VkInstanceCreateInfo instanceInfo{};
        instanceInfo.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        instanceInfo.pApplicationInfo = &application;
        check(vkCreateInstance(&instanceInfo, nullptr, &instance));
        uint32_t count = 1;
        if (vkEnumeratePhysicalDevices(instance, &count, &physicalDevice) < 0 || count == 0)
            throw std::runtime_error("no Vulkan device");
        createDevice();
        VkCommandPoolCreateInfo poolInfo{};
        poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        check(vkCreateCommandPool(device, &poolInfo, nullptr, &pool));
        VkCommandBufferAllocateInfo bufferInfo{};
        bufferInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        bufferInfo.commandPool = pool;
        bufferInfo.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(device, &bufferInfo, &commandBuffer));
        VkCommandBufferBeginInfo beginInfo{};
        beginInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        check(vkBeginCommandBuffer(commandBuffer, &beginInfo));
    }
    ~VkHost() {
        vkDestroyCommandPool(device, pool, nullptr);
        vkDestroyDevice(device, nullptr);
        vkDestroyInstance(instance, nullptr);
    }
    VkHost(const VkHost&) = delete;
    VkHost& operator=(const VkHost&) = delete;

    VkInstance instance{};
    VkPhysicalDevice physicalDevice{};
    VkDevice device{};
    VkCommandPool pool{};
    VkCommandBuffer commandBuffer{};

private:
    static void check(VkResult result) {
        if (result != VK_SUCCESS)
            throw std::runtime_error("a Vulkan function failed");
    }

    // Enables all features of Vulkan 1.0. Queue family 0 has graphics and compute in the drivers that the tests know.
    void createDevice() {
        VkPhysicalDeviceFeatures features;
        vkGetPhysicalDeviceFeatures(physicalDevice, &features);
        features.robustBufferAccess = VK_FALSE;
        const float priority = 1;
        VkDeviceQueueCreateInfo queueInfo{};
        queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queueInfo.queueCount = 1;
        queueInfo.pQueuePriorities = &priority;
        VkDeviceCreateInfo deviceInfo{};
        deviceInfo.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        deviceInfo.queueCreateInfoCount = 1;
        deviceInfo.pQueueCreateInfos = &queueInfo;
        deviceInfo.pEnabledFeatures = &features;
        check(vkCreateDevice(physicalDevice, &deviceInfo, nullptr, &device));
    }
};

} // namespace cpp_header
