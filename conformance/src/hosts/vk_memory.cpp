#include "vk_memory.h"

#include <stdexcept>

namespace agaa::conformance {

namespace {

VkDeviceMemory allocate(const VulkanApi& api, const VkMemoryRequirements& needed, VkMemoryPropertyFlags flags) {
    VkPhysicalDeviceMemoryProperties types;
    vkGetPhysicalDeviceMemoryProperties(api.physicalDevice, &types);
    for (uint32_t i = 0; i < types.memoryTypeCount; ++i)
        if ((needed.memoryTypeBits >> i & 1) && (types.memoryTypes[i].propertyFlags & flags) == flags) {
            VkMemoryAllocateInfo info{};
            info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
            info.allocationSize = needed.size;
            info.memoryTypeIndex = i;
            VkDeviceMemory memory;
            checkVk(vkAllocateMemory(api.device, &info, nullptr, &memory), "vkAllocateMemory");
            return memory;
        }
    throw std::runtime_error("the device has no memory that the suite's host needs.");
}

} // namespace

VulkanBuffer::VulkanBuffer(const VulkanApi& owner, size_t size, VkBufferUsageFlags usage) : api(owner) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    checkVk(vkCreateBuffer(api.device, &info, nullptr, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needed;
    vkGetBufferMemoryRequirements(api.device, buffer, &needed);
    memory = allocate(api, needed, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    checkVk(vkBindBufferMemory(api.device, buffer, memory, 0), "vkBindBufferMemory");
    checkVk(vkMapMemory(api.device, memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
}

VulkanBuffer::~VulkanBuffer() {
    vkDestroyBuffer(api.device, buffer, nullptr);
    vkFreeMemory(api.device, memory, nullptr);
}

VulkanImage::VulkanImage(const VulkanApi& owner, uint32_t w, uint32_t h, uint32_t layerCount, VkFormat format,
                         VkImageUsageFlags usage, VkImageViewType viewType)
    : api(owner), width(w), height(h), layers(layerCount),
      aspect(format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = 1;
    info.arrayLayers = layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    checkVk(vkCreateImage(api.device, &info, nullptr, &image), "vkCreateImage");
    VkMemoryRequirements needed;
    vkGetImageMemoryRequirements(api.device, image, &needed);
    memory = allocate(api, needed, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    checkVk(vkBindImageMemory(api.device, image, memory, 0), "vkBindImageMemory");
    VkImageViewCreateInfo viewInfo{};
    viewInfo.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    viewInfo.image = image;
    viewInfo.viewType = viewType;
    viewInfo.format = format;
    viewInfo.subresourceRange = {aspect, 0, 1, 0, layers};
    checkVk(vkCreateImageView(api.device, &viewInfo, nullptr, &view), "vkCreateImageView");
}

VulkanImage::~VulkanImage() {
    vkDestroyImageView(api.device, view, nullptr);
    vkDestroyImage(api.device, image, nullptr);
    vkFreeMemory(api.device, memory, nullptr);
}

VulkanCommands::VulkanCommands(const VulkanApi& api) : api_(api) {
    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = api.queueFamily;
    checkVk(vkCreateCommandPool(api.device, &pool, nullptr, &pool_), "vkCreateCommandPool");
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool_;
    info.commandBufferCount = 1;
    checkVk(vkAllocateCommandBuffers(api.device, &info, &commands_), "vkAllocateCommandBuffers");
}

VulkanCommands::~VulkanCommands() { vkDestroyCommandPool(api_.device, pool_, nullptr); }

VkCommandBuffer VulkanCommands::begin() {
    discard();
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    checkVk(vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
    return commands_;
}

void VulkanCommands::submit() {
    checkVk(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
    VkSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    checkVk(vkQueueSubmit(api_.queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit");
    checkVk(vkQueueWaitIdle(api_.queue), "vkQueueWaitIdle");
}

void VulkanCommands::discard() { checkVk(vkResetCommandPool(api_.device, pool_, 0), "vkResetCommandPool"); }

VulkanFunctionSet::VulkanFunctionSet(const VulkanApi& api) : api_(api) {
    const VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT,
                                                  nullptr};
    VkDescriptorSetLayoutCreateInfo layoutInfo{};
    layoutInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layoutInfo.bindingCount = 1;
    layoutInfo.pBindings = &binding;
    checkVk(vkCreateDescriptorSetLayout(api.device, &layoutInfo, nullptr, &layout), "vkCreateDescriptorSetLayout");
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
    VkDescriptorPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 1;
    poolInfo.pPoolSizes = &size;
    checkVk(vkCreateDescriptorPool(api.device, &poolInfo, nullptr, &pool_), "vkCreateDescriptorPool");
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool_;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    checkVk(vkAllocateDescriptorSets(api.device, &info, &set), "vkAllocateDescriptorSets");
}

VulkanFunctionSet::~VulkanFunctionSet() {
    vkDestroyDescriptorPool(api_.device, pool_, nullptr);
    vkDestroyDescriptorSetLayout(api_.device, layout, nullptr);
}

void VulkanFunctionSet::write(VkBuffer buffer) {
    const VkDescriptorBufferInfo info = {buffer, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &info;
    vkUpdateDescriptorSets(api_.device, 1, &write, 0, nullptr);
}

void imageBarrier(VkCommandBuffer commands, const VulkanImage& image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    barrier.subresourceRange = {image.aspect, 0, 1, 0, image.layers};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
}

void allBarrier(VkCommandBuffer commands) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0,
                         nullptr);
}

} // namespace agaa::conformance
