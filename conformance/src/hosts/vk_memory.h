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

struct VulkanImage { // optimal tiling, one level, layout GENERAL
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

// The descriptor set for the functions of the host: a storage buffer at binding 0, in compute shaders.
class VulkanFunctionSet {
public:
    explicit VulkanFunctionSet(const VulkanApi& api);
    ~VulkanFunctionSet();
    VulkanFunctionSet(const VulkanFunctionSet&) = delete;
    VulkanFunctionSet& operator=(const VulkanFunctionSet&) = delete;

    void write(VkBuffer buffer); // pending commands must not use the set
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;

private:
    const VulkanApi& api_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

// One command buffer that is submitted and waited for.
class VulkanCommands {
public:
    explicit VulkanCommands(const VulkanApi& api);
    ~VulkanCommands();
    VulkanCommands(const VulkanCommands&) = delete;
    VulkanCommands& operator=(const VulkanCommands&) = delete;

    VkCommandBuffer begin();
    void submit();  // submits and waits
    void discard(); // called instead of submit()

private:
    const VulkanApi& api_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

// Records a barrier between all earlier and later commands, and changes the layout of the image.
void imageBarrier(VkCommandBuffer commands, const VulkanImage& image, VkImageLayout from, VkImageLayout to);
void allBarrier(VkCommandBuffer commands);

} // namespace agaa::conformance
