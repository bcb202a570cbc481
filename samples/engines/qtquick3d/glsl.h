/* Compiles the GLSL of the host at run time.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <vulkan/vulkan.h>

#include <string>

/* It throws a std::runtime_error with the compiler's message. */
VkShaderModule compile(VkDevice device, VkShaderStageFlagBits stage, const std::string& text);
