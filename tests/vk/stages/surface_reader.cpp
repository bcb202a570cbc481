#include "surface_reader.h"

#include "compute_pass.h"
#include "surfaces.h"

#include "vk/arena.h"
#include "vk/barrier.h"

#include <cstring>

using namespace harness::vk;

namespace agaa::test {

namespace {

void everythingBefore(VkCommandBuffer commands) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
}

void toHost(VkCommandBuffer commands) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
}

} // namespace

std::vector<glm::uvec4> readTexels(const Device& device, const Resource& resource, VkImageView view) {
    const size_t count = size_t(resource.width) * resource.height * resource.samples;
    Arena arena(device);
    const BufferResource out = arena.hostBuffer(count * sizeof(glm::uvec4), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
    VkSamplerCreateInfo samplerInfo{};
    samplerInfo.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    const Sampler sampler = make<Sampler>(device.get(), vkCreateSampler, samplerInfo, "create a sampler");
    const VkDescriptorSetLayoutBinding bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
        {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr}};
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.bindingCount = 2;
    setInfo.pBindings = bindings;
    const auto setLayout =
        make<DescriptorSetLayout>(device.get(), vkCreateDescriptorSetLayout, setInfo, "create a set layout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}};
    VkDescriptorPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 2;
    poolInfo.pPoolSizes = sizes;
    const auto pool = make<DescriptorPool>(device.get(), vkCreateDescriptorPool, poolInfo, "create a pool");
    const VkDescriptorSetLayout layouts[] = {setLayout.get()};
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool.get();
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = layouts;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device.get(), &allocate, &set), "allocate a set");
    const VkDescriptorImageInfo image{sampler.get(), view,
                                      isDepth(resource.format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                                               : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const VkDescriptorBufferInfo buffer{out.buffer.get(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet writes[2]{};
    for (uint32_t i = 0; i < 2; ++i) {
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set;
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = bindings[i].descriptorType;
        writes[i].pImageInfo = &image;
        writes[i].pBufferInfo = &buffer;
    }
    vkUpdateDescriptorSets(device.get(), 2, writes, 0, nullptr);

    const ComputePass pass(device, setLayout.get(), "#version 450\n" + surfaceText(resource), resource.name);
    device.runCommands([&](VkCommandBuffer commands) {
        everythingBefore(commands);
        pass.record(commands, set, resource.width, resource.height);
        toHost(commands);
    });
    std::vector<glm::uvec4> texels(count);
    std::memcpy(texels.data(), out.mapped, count * sizeof(glm::uvec4));
    return texels;
}

std::vector<uint32_t> readImage(const Device& device, const Resource& resource, VkImage image) {
    Arena arena(device);
    const BufferResource out = arena.hostBuffer(resource.bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true);
    constexpr ImageUse shown{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_WRITE_BIT,
                             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    constexpr ImageUse copied{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
    constexpr ImageUse shownAgain{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_READ_BIT, shown.layout};
    device.runCommands([&](VkCommandBuffer commands) {
        imageBarrier(commands, image, VK_IMAGE_ASPECT_COLOR_BIT, shown, copied);
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, resource.layers};
        region.imageExtent = {resource.width, resource.height, 1};
        vkCmdCopyImageToBuffer(commands, image, copied.layout, out.buffer.get(), 1, &region);
        imageBarrier(commands, image, VK_IMAGE_ASPECT_COLOR_BIT, copied, shownAgain);
        toHost(commands);
    });
    std::vector<uint32_t> words(resource.bytes / 4);
    std::memcpy(words.data(), out.mapped, words.size() * 4);
    return words;
}

std::vector<uint32_t> readWords(const Device& device, VkBuffer buffer, uint64_t bytes) {
    Arena arena(device);
    const BufferResource out = arena.hostBuffer(bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true);
    device.runCommands([&](VkCommandBuffer commands) {
        everythingBefore(commands);
        const VkBufferCopy region{0, 0, bytes};
        vkCmdCopyBuffer(commands, buffer, out.buffer.get(), 1, &region);
        toHost(commands);
    });
    std::vector<uint32_t> words(bytes / 4);
    std::memcpy(words.data(), out.mapped, words.size() * 4);
    return words;
}

} // namespace agaa::test
