// Shader modules from GLSL.
#pragma once

#include "vk_device.h"

#include <unordered_map>

namespace agaa::conformance {

class VulkanShaders {
public:
    explicit VulkanShaders(const VulkanApi& api);
    ~VulkanShaders();
    VulkanShaders(const VulkanShaders&) = delete;
    VulkanShaders& operator=(const VulkanShaders&) = delete;

    // Caches modules by their text. Throws std::runtime_error with the compiler's message.
    VkShaderModule find(VkShaderStageFlagBits stage, const std::string& text);

private:
    const VulkanApi& api_;
    std::unordered_map<std::string, VkShaderModule> modules_;
};

} // namespace agaa::conformance
