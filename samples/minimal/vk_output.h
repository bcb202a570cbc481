/* The image that the SDK writes in the minimal Vulkan host, and a buffer through which the CPU reads it.
 * SPDX-License-Identifier: MIT
 */
#ifndef VK_OUTPUT_H
#define VK_OUTPUT_H

#include "host.h"

#include <vulkan/vulkan.h>

static void check(VkResult result, const char* call) {
    if (result < 0)
        fail("%s failed with VkResult %d.", call, (int)result);
}

typedef struct Output {
    VkImage image;
    VkImageView view;
    VkBuffer buffer;
    VkDeviceMemory imageMemory, bufferMemory;
    const float* pixels;
} Output;

static VkDeviceMemory allocate(VkPhysicalDevice physicalDevice, VkDevice device,
                               VkMemoryRequirements needed, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties types;
    VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                 .allocationSize = needed.size};
    VkDeviceMemory memory;
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &types);
    while (!(needed.memoryTypeBits >> info.memoryTypeIndex & 1) ||
           (types.memoryTypes[info.memoryTypeIndex].propertyFlags & wanted) != wanted)
        if (++info.memoryTypeIndex == types.memoryTypeCount)
            fail("The device has no memory of the wanted kind.");
    check(vkAllocateMemory(device, &info, NULL, &memory), "vkAllocateMemory");
    return memory;
}

/* [output] */
static Output createOutput(VkPhysicalDevice physicalDevice, VkDevice device) {
    const VkImageCreateInfo image = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                     .extent = {width, height, 1},
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT};
    /* [/output] */
    const VkBufferCreateInfo buffer = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                       .size = width * height * 4 * sizeof(float),
                                       .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    VkImageViewCreateInfo view = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                  .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                  .format = image.format,
                                  .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkMemoryRequirements needed;
    Output output;
    void* mapped;
    check(vkCreateImage(device, &image, NULL, &output.image), "vkCreateImage");
    vkGetImageMemoryRequirements(device, output.image, &needed);
    output.imageMemory = allocate(physicalDevice, device, needed, 0);
    check(vkBindImageMemory(device, output.image, output.imageMemory, 0), "vkBindImageMemory");
    view.image = output.image;
    check(vkCreateImageView(device, &view, NULL, &output.view), "vkCreateImageView");
    check(vkCreateBuffer(device, &buffer, NULL, &output.buffer), "vkCreateBuffer");
    vkGetBufferMemoryRequirements(device, output.buffer, &needed);
    output.bufferMemory = allocate(
        physicalDevice, device, needed,
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(device, output.buffer, output.bufferMemory, 0), "vkBindBufferMemory");
    check(vkMapMemory(device, output.bufferMemory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    output.pixels = mapped;
    return output;
}

static void recordReadback(const Output* output, VkCommandBuffer commands) {
    const VkBufferImageCopy copy = {.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                    .imageExtent = {width, height, 1}};
    const VkMemoryBarrier toHost = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                    .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                    .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    vkCmdCopyImageToBuffer(commands, output->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, output->buffer,
                           1, &copy);
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &toHost, 0, NULL, 0, NULL);
}

static void destroyOutput(VkDevice device, const Output* output) {
    vkDestroyImageView(device, output->view, NULL);
    vkDestroyImage(device, output->image, NULL);
    vkDestroyBuffer(device, output->buffer, NULL);
    vkFreeMemory(device, output->imageMemory, NULL);
    vkFreeMemory(device, output->bufferMemory, NULL);
}

#endif
