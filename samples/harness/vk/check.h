// Results of Vulkan calls as exceptions, and handles that destroy themselves.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <utility>

namespace harness::vk {

std::string resultName(VkResult result);

// Throws std::runtime_error "Vulkan could not <what>: <result>." on errors.
void check(VkResult result, const char* what);

// A handle that belongs to a device. Destroy is a function of the API, such as vkDestroyImage.
template <class Handle, auto Destroy> class Owned {
public:
    Owned() = default;
    Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    Owned(Owned&& other) noexcept { swap(other); }
    Owned& operator=(Owned&& other) noexcept {
        Owned moved(std::move(other));
        swap(moved);
        return *this;
    }
    ~Owned() {
        if (handle_ != VK_NULL_HANDLE)
            Destroy(device_, handle_, nullptr);
    }
    Handle get() const { return handle_; }
    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

private:
    void swap(Owned& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
    }

    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
};

using Buffer = Owned<VkBuffer, vkDestroyBuffer>;
using BufferView = Owned<VkBufferView, vkDestroyBufferView>;
using CommandPool = Owned<VkCommandPool, vkDestroyCommandPool>;
using DescriptorPool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using DescriptorSetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using DeviceMemory = Owned<VkDeviceMemory, vkFreeMemory>;
using Fence = Owned<VkFence, vkDestroyFence>;
using Framebuffer = Owned<VkFramebuffer, vkDestroyFramebuffer>;
using ImageHandle = Owned<VkImage, vkDestroyImage>;
using ImageView = Owned<VkImageView, vkDestroyImageView>;
using Pipeline = Owned<VkPipeline, vkDestroyPipeline>;
using PipelineLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using RenderPass = Owned<VkRenderPass, vkDestroyRenderPass>;
using Sampler = Owned<VkSampler, vkDestroySampler>;
using ShaderModule = Owned<VkShaderModule, vkDestroyShaderModule>;

// Calls a vkCreate… function: make<Buffer>(device, vkCreateBuffer, info, "create a buffer").
template <class Result, class Create, class Info>
Result make(VkDevice device, Create create, const Info& info, const char* what) {
    decltype(std::declval<Result>().get()) handle = VK_NULL_HANDLE;
    check(create(device, &info, nullptr, &handle), what);
    return Result(device, handle);
}

} // namespace harness::vk
