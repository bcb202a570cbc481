/* The host's Vulkan device, which Qt and the SDK use, its validation messages, and images that the CPU can read.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <vulkan/vulkan.h>

#include <QtGui/QVulkanInstance>

#include <string>
#include <vector>

class VulkanDevice {
public:
    VulkanDevice();
    ~VulkanDevice();
    VulkanDevice(const VulkanDevice&) = delete;

    QVulkanInstance& instance() { return m_qtInstance; }
    VkPhysicalDevice physicalDevice() const { return m_physicalDevice; }
    VkDevice device() const { return m_device; }
    VkQueue queue() const { return m_queue; }
    uint32_t queueFamily() const { return m_queueFamily; }
    const VkPhysicalDeviceFeatures2& enabledFeatures() const { return m_features; }
    bool hasValidation() const { return m_hasValidation; }
    std::string name() const;
    /* Returns the warnings and errors since the last call. */
    std::vector<std::string> takeMessages();
    uint32_t memoryType(uint32_t typeBits, VkMemoryPropertyFlags flags) const;

private:
    void createInstance();
    void createDevice();
    static VkBool32 VKAPI_PTR onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                        const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

    VkInstance m_instance = VK_NULL_HANDLE;
    QVulkanInstance m_qtInstance;
    VkDebugUtilsMessengerEXT m_messenger = VK_NULL_HANDLE;
    VkPhysicalDevice m_physicalDevice = VK_NULL_HANDLE;
    VkPhysicalDeviceFeatures2 m_features = {};
    VkDevice m_device = VK_NULL_HANDLE;
    VkQueue m_queue = VK_NULL_HANDLE;
    uint32_t m_queueFamily = 0;
    bool m_hasValidation = false;
    std::vector<std::string> m_messages;
};

using Pixels = std::vector<float>; // linear RGBA, row 0 on top

/* A colour image of 32-bit floats. */
class Image {
public:
    Image(VulkanDevice& device, uint32_t width, uint32_t height, VkImageUsageFlags usage);
    ~Image();
    Image(const Image&) = delete;

    VkImage image() const { return m_image; }
    VkImageView view() const { return m_view; }
    /* Copies the pixels of an image that no command uses. It stays in its layout. */
    Pixels read(VkImageLayout layout) const;

private:
    VkDeviceMemory allocate(const VkMemoryRequirements& needed, VkMemoryPropertyFlags flags) const;

    VulkanDevice& m_device;
    uint32_t m_width, m_height;
    VkImage m_image = VK_NULL_HANDLE;
    VkImageView m_view = VK_NULL_HANDLE;
    VkBuffer m_buffer = VK_NULL_HANDLE;
    VkDeviceMemory m_memory = VK_NULL_HANDLE, m_bufferMemory = VK_NULL_HANDLE;
    VkCommandPool m_pool = VK_NULL_HANDLE;
};
