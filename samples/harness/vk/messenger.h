// The Vulkan messenger that fills a message collector.
#pragma once

#include "render/messages.h"

#include <vulkan/vulkan.h>

namespace harness::vk {

// Returns the description for VkInstanceCreateInfo::pNext and vkCreateDebugUtilsMessengerEXT.
VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageCollector& collector);

} // namespace harness::vk
