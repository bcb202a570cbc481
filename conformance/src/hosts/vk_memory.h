// Buffers, images and command buffers of the suite's host on Vulkan.
#pragma once

#include "vk_device.h"

namespace agaa::conformance {

struct VulkanBuffer { // host-visible and coherent
    VulkanBuffer(const VulkanApi& api, size_t size, VkBufferUsageFlags usage);
    ~VulkanBuffer();
    VulkanBuffer(const VulkanBuffer&) = delete;
    VulkanBuffer& operator=(const VulkanBuffer&) = delete;

    const VulkanApi& api;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr;
};

struct VulkanImage { // optimal tiling, one level, in GENERAL
    VulkanImage(const VulkanApi& api, uint32_t width, uint32_t height, uint32_t layers, VkFormat format,
                VkImageUsageFlags usage, VkImageViewType viewType);
    ~VulkanImage();
    VulkanImage(const VulkanImage&) = delete;
    VulkanImage& operator=(const VulkanImage&) = delete;

    const VulkanApi& api;
    const uint32_t width, height, layers;
    const VkImageAspectFlags aspect;
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

// What the functions of the host read: a storage buffer at binding 0, in compute shaders.
class VulkanFunctionSet {
public:
    explicit VulkanFunctionSet(const VulkanApi& api);
    ~VulkanFunctionSet();
    VulkanFunctionSet(const VulkanFunctionSet&) = delete;
    VulkanFunctionSet& operator=(const VulkanFunctionSet&) = delete;

    void write(VkBuffer buffer); // while no commands that use the set are pending
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;

private:
    const VulkanApi& api_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

// One command buffer, which is waited for.
class VulkanCommands {
public:
    explicit VulkanCommands(const VulkanApi& api);
    ~VulkanCommands();
    VulkanCommands(const VulkanCommands&) = delete;
    VulkanCommands& operator=(const VulkanCommands&) = delete;

    VkCommandBuffer begin();
    void submit();  // waits
    void discard(); // instead of submit()

private:
    const VulkanApi& api_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

// Between all commands before and after, which also moves the image from one layout to the other.
void imageBarrier(VkCommandBuffer commands, const VulkanImage& image, VkImageLayout from, VkImageLayout to);
void allBarrier(VkCommandBuffer commands);

} // namespace agaa::conformance
