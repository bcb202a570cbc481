/* SPDX-License-Identifier: MIT */
#include "vulkan_device.h"

#include "agaa_vk.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace {

void require(bool isMet, const char* sentence) {
    if (!isMet)
        throw std::runtime_error(sentence);
}

/* Returns false for names that the host does not know. */
bool hasFeature(const VkPhysicalDeviceFeatures& features, const std::string& name) {
    using Features = VkPhysicalDeviceFeatures;
    constexpr std::pair<const char*, VkBool32 Features::*> known[] = {
        {"fragmentStoresAndAtomics", &Features::fragmentStoresAndAtomics},
        {"sampleRateShading", &Features::sampleRateShading},
        {"shaderStorageImageExtendedFormats", &Features::shaderStorageImageExtendedFormats},
        {"shaderStorageImageWriteWithoutFormat", &Features::shaderStorageImageWriteWithoutFormat}};
    for (const auto& [each, member] : known)
        if (name == each)
            return features.*member;
    return false;
}

} // namespace

VulkanDevice::VulkanDevice() {
    createInstance();
    createDevice();
}

VulkanDevice::~VulkanDevice() {
    vkDestroyDevice(m_device, nullptr);
    m_qtInstance.destroy();
    const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(m_instance, "vkDestroyDebugUtilsMessengerEXT"));
    if (m_messenger)
        destroyMessenger(m_instance, m_messenger, nullptr);
    vkDestroyInstance(m_instance, nullptr);
}

/* QVulkanInstance cannot enable synchronisation validation, so the host creates the instance. */
void VulkanDevice::createInstance() {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    const char* const layer = "VK_LAYER_KHRONOS_validation";
    m_hasValidation = std::any_of(layers.begin(), layers.end(),
                                  [layer](const auto& each) { return std::strcmp(each.layerName, layer) == 0; });
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT validation = {VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    validation.enabledValidationFeatureCount = 1, validation.pEnabledValidationFeatures = enabled;
    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_2;
    std::vector<const char*> extensions = {"VK_KHR_surface", "VK_KHR_xcb_surface"}; // for Qt's windows
    if (m_hasValidation)
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = uint32_t(extensions.size()), info.ppEnabledExtensionNames = extensions.data();
    if (m_hasValidation)
        info.pNext = &validation, info.enabledLayerCount = 1, info.ppEnabledLayerNames = &layer;
    require(vkCreateInstance(&info, nullptr, &m_instance) == VK_SUCCESS, "There is no Vulkan instance.");
    if (m_hasValidation) {
        VkDebugUtilsMessengerCreateInfoEXT messenger = {VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
        messenger.messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        messenger.messageType =
            VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
        messenger.pfnUserCallback = onMessage, messenger.pUserData = this;
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(m_instance, "vkCreateDebugUtilsMessengerEXT"));
        require(create(m_instance, &messenger, nullptr, &m_messenger) == VK_SUCCESS, "There are no debug messages.");
    }
    m_qtInstance.setVkInstance(m_instance);
    m_qtInstance.setApiVersion(QVersionNumber(1, 2));
    require(m_qtInstance.create(), "Qt does not accept the Vulkan instance.");
}

/* Qt's settings for the device that it creates have no features. This device has all features of Vulkan 1.0 that are
 * there, among them those of agaaVkGetRequirements, and the swapchain that Qt's windows need. */
void VulkanDevice::createDevice() {
    uint32_t count = 1;
    vkEnumeratePhysicalDevices(m_instance, &count, &m_physicalDevice);
    require(m_physicalDevice, "There is no Vulkan device.");
    m_features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    vkGetPhysicalDeviceFeatures2(m_physicalDevice, &m_features);
    m_features.features.robustBufferAccess = VK_FALSE;
    AgaaVkRequirements requirements = AGAA_VK_REQUIREMENTS_INIT;
    require(agaaVkGetRequirements(&requirements) == AGAA_OK, "The SDK's requirements are not known.");
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(m_physicalDevice, &properties);
    require(properties.apiVersion >= requirements.apiVersion, "The device is older than the SDK needs.");
    for (uint32_t i = 0; i < requirements.requiredFeatureCount; ++i)
        require(hasFeature(m_features.features, requirements.requiredFeatures[i]),
                (std::string("The device lacks the feature ") + requirements.requiredFeatures[i] + '.').c_str());
    uint32_t families = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(m_physicalDevice, &families, nullptr);
    std::vector<VkQueueFamilyProperties> each(families);
    vkGetPhysicalDeviceQueueFamilyProperties(m_physicalDevice, &families, each.data());
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    while (m_queueFamily < families && (each[m_queueFamily].queueFlags & both) != both)
        ++m_queueFamily;
    require(m_queueFamily < families, "The device has no queue for graphics and compute.");
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = m_queueFamily, queue.queueCount = 1, queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &m_features, info.queueCreateInfoCount = 1, info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1, info.ppEnabledExtensionNames = &extension;
    require(vkCreateDevice(m_physicalDevice, &info, nullptr, &m_device) == VK_SUCCESS, "There is no Vulkan device.");
    vkGetDeviceQueue(m_device, m_queueFamily, 0, &m_queue);
}

VkBool32 VulkanDevice::onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                 const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<VulkanDevice*>(user)->m_messages.push_back(data->pMessage);
    return VK_FALSE;
}

std::vector<std::string> VulkanDevice::takeMessages() { return std::exchange(m_messages, {}); }

std::string VulkanDevice::name() const {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(m_physicalDevice, &properties);
    return properties.deviceName;
}

uint32_t VulkanDevice::memoryType(uint32_t typeBits, VkMemoryPropertyFlags flags) const {
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(m_physicalDevice, &properties);
    for (uint32_t i = 0; i < properties.memoryTypeCount; ++i)
        if ((typeBits & 1u << i) && (properties.memoryTypes[i].propertyFlags & flags) == flags)
            return i;
    throw std::runtime_error("The device has no memory of this type.");
}

/* ---- images --------------------------------------------------------------------------------------- */

Image::Image(VulkanDevice& device, uint32_t width, uint32_t height, VkImageUsageFlags usage)
    : m_device(device), m_width(width), m_height(height) {
    const VkDevice vk = device.device();
    VkImageCreateInfo image = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    image.imageType = VK_IMAGE_TYPE_2D, image.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    image.extent = {width, height, 1}, image.mipLevels = image.arrayLayers = 1;
    image.samples = VK_SAMPLE_COUNT_1_BIT, image.usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    require(vkCreateImage(vk, &image, nullptr, &m_image) == VK_SUCCESS, "An image could not be created.");
    VkMemoryRequirements needed;
    vkGetImageMemoryRequirements(vk, m_image, &needed);
    m_memory = allocate(needed, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    vkBindImageMemory(vk, m_image, m_memory, 0);
    VkImageViewCreateInfo view = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = m_image, view.viewType = VK_IMAGE_VIEW_TYPE_2D, view.format = image.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    require(vkCreateImageView(vk, &view, nullptr, &m_view) == VK_SUCCESS, "An image view could not be created.");
    VkBufferCreateInfo buffer = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    buffer.size = 16ull * width * height, buffer.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    require(vkCreateBuffer(vk, &buffer, nullptr, &m_buffer) == VK_SUCCESS, "A buffer could not be created.");
    vkGetBufferMemoryRequirements(vk, m_buffer, &needed);
    m_bufferMemory = allocate(needed, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    vkBindBufferMemory(vk, m_buffer, m_bufferMemory, 0);
    VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = device.queueFamily();
    require(vkCreateCommandPool(vk, &pool, nullptr, &m_pool) == VK_SUCCESS, "A command pool could not be created.");
}

Image::~Image() {
    const VkDevice vk = m_device.device();
    vkDestroyCommandPool(vk, m_pool, nullptr);
    vkDestroyBuffer(vk, m_buffer, nullptr);
    vkDestroyImageView(vk, m_view, nullptr);
    vkDestroyImage(vk, m_image, nullptr);
    vkFreeMemory(vk, m_bufferMemory, nullptr);
    vkFreeMemory(vk, m_memory, nullptr);
}

VkDeviceMemory Image::allocate(const VkMemoryRequirements& needed, VkMemoryPropertyFlags flags) const {
    VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needed.size, info.memoryTypeIndex = m_device.memoryType(needed.memoryTypeBits, flags);
    VkDeviceMemory memory;
    require(vkAllocateMemory(m_device.device(), &info, nullptr, &memory) == VK_SUCCESS, "There is too little memory.");
    return memory;
}

Pixels Image::read(VkImageLayout layout) const {
    const VkDevice vk = m_device.device();
    VkCommandBufferAllocateInfo allocation = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocation.commandPool = m_pool, allocation.commandBufferCount = 1;
    VkCommandBuffer commands;
    require(vkAllocateCommandBuffers(vk, &allocation, &commands) == VK_SUCCESS, "There is no command buffer.");
    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vkBeginCommandBuffer(commands, &begin);
    const auto transition = [&](VkImageLayout from, VkImageLayout to) {
        VkImageMemoryBarrier barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
        barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
        barrier.oldLayout = from, barrier.newLayout = to, barrier.image = m_image;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                             nullptr, 0, nullptr, 1, &barrier);
    };
    transition(layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region = {};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {m_width, m_height, 1};
    vkCmdCopyImageToBuffer(commands, m_image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, m_buffer, 1, &region);
    transition(VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
    VkMemoryBarrier toHost = {VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    toHost.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT, toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &toHost, 0,
                         nullptr, 0, nullptr);
    vkEndCommandBuffer(commands);
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1, submit.pCommandBuffers = &commands;
    require(vkQueueSubmit(m_device.queue(), 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS, "The image could not be read.");
    require(vkQueueWaitIdle(m_device.queue()) == VK_SUCCESS, "The image could not be read.");
    vkFreeCommandBuffers(vk, m_pool, 1, &commands);
    Pixels pixels(4 * size_t(m_width) * m_height);
    void* bytes = nullptr;
    require(vkMapMemory(vk, m_bufferMemory, 0, VK_WHOLE_SIZE, 0, &bytes) == VK_SUCCESS, "The image could not be read.");
    std::memcpy(pixels.data(), bytes, pixels.size() * sizeof(float));
    vkUnmapMemory(vk, m_bufferMemory);
    return pixels;
}
