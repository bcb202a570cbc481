/* The parts that the minimal Vulkan hosts with materials by id share: the buffer of the geometry and its descriptor
 * set. SPDX-License-Identifier: MIT
 */
#pragma once

#include "ids.h"
#include "vk.h"

/* The geometry that the SDK's passes read, and its descriptor set. */
typedef struct Fetch {
    VkBuffer geometry;
    VkDeviceMemory memory;
    VkDescriptorSetLayout layout;
    VkDescriptorPool pool;
} Fetch;

static void createGeometry(const Host* host, Fetch* fetch) {
    const Geometry geometry = describeGeometry(0.0f);
    const VkBufferCreateInfo buffer = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                       .size = sizeof geometry,
                                       .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    VkMemoryRequirements needed;
    CHECK(vkCreateBuffer(host->device, &buffer, NULL, &fetch->geometry));
    vkGetBufferMemoryRequirements(host->device, fetch->geometry, &needed);
    memcpy(allocate(host, &needed, mappedMemory, &fetch->memory), &geometry, sizeof geometry);
    CHECK(vkBindBufferMemory(host->device, fetch->geometry, fetch->memory, 0));
}

static void createSet(Host* host, Fetch* fetch) {
    const VkDescriptorSetLayoutBinding binding = {.binding = 0,
                                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                                  .descriptorCount = 1,
                                                  .stageFlags = VK_SHADER_STAGE_ALL};
    const VkDescriptorSetLayoutCreateInfo layout = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 1, .pBindings = &binding};
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
    const VkDescriptorPoolCreateInfo pool = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    VkDescriptorSetAllocateInfo allocation = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                              .descriptorSetCount = 1,
                                              .pSetLayouts = &fetch->layout};
    const VkDescriptorBufferInfo geometry = {fetch->geometry, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .descriptorCount = 1,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                  .pBufferInfo = &geometry};
    CHECK(vkCreateDescriptorSetLayout(host->device, &layout, NULL, &fetch->layout));
    CHECK(vkCreateDescriptorPool(host->device, &pool, NULL, &fetch->pool));
    allocation.descriptorPool = fetch->pool;
    CHECK(vkAllocateDescriptorSets(host->device, &allocation, &host->functionSet));
    write.dstSet = host->functionSet;
    vkUpdateDescriptorSets(host->device, 1, &write, 0, NULL);
}

static void destroyFetch(const Host* host, const Fetch* fetch) {
    vkDestroyDescriptorPool(host->device, fetch->pool, NULL);
    vkDestroyDescriptorSetLayout(host->device, fetch->layout, NULL);
    vkDestroyBuffer(host->device, fetch->geometry, NULL);
    vkFreeMemory(host->device, fetch->memory, NULL);
}
