#include "vk_shaders.h"

#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

#include <stdexcept>

namespace agaa::conformance {

VulkanShaders::VulkanShaders(const VulkanApi& api) : api_(api) { glslang_initialize_process(); }

VulkanShaders::~VulkanShaders() {
    for (const auto& [text, module] : modules_)
        vkDestroyShaderModule(api_.device, module, nullptr);
    glslang_finalize_process();
}

static glslang_stage_t compilerStage(VkShaderStageFlagBits stage) {
    return stage == VK_SHADER_STAGE_VERTEX_BIT     ? GLSLANG_STAGE_VERTEX
           : stage == VK_SHADER_STAGE_GEOMETRY_BIT ? GLSLANG_STAGE_GEOMETRY
                                                   : GLSLANG_STAGE_FRAGMENT;
}

VkShaderModule VulkanShaders::find(VkShaderStageFlagBits vkStage, const std::string& text) {
    const auto found = modules_.find(text);
    if (found != modules_.end())
        return found->second;
    const glslang_stage_t stage = compilerStage(vkStage);
    const int messages = GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT;
    glslang_input_t input{};
    input.language = GLSLANG_SOURCE_GLSL;
    input.stage = stage;
    input.client = GLSLANG_CLIENT_VULKAN;
    input.client_version = GLSLANG_TARGET_VULKAN_1_2;
    input.target_language = GLSLANG_TARGET_SPV;
    input.target_language_version = GLSLANG_TARGET_SPV_1_5;
    input.code = text.c_str();
    input.default_version = 100;
    input.default_profile = GLSLANG_NO_PROFILE;
    input.messages = glslang_messages_t(messages);
    input.resource = glslang_default_resource();
    const std::unique_ptr<glslang_shader_t, void (*)(glslang_shader_t*)> shader(glslang_shader_create(&input),
                                                                                glslang_shader_delete);
    const std::unique_ptr<glslang_program_t, void (*)(glslang_program_t*)> program(glslang_program_create(),
                                                                                   glslang_program_delete);
    if (!glslang_shader_preprocess(shader.get(), &input) || !glslang_shader_parse(shader.get(), &input))
        throw std::runtime_error(std::string("a shader of the suite's host does not compile: ") +
                                 glslang_shader_get_info_log(shader.get()));
    glslang_program_add_shader(program.get(), shader.get());
    if (!glslang_program_link(program.get(), messages))
        throw std::runtime_error(std::string("a shader of the suite's host does not link: ") +
                                 glslang_program_get_info_log(program.get()));
    glslang_program_SPIRV_generate(program.get(), stage);
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = glslang_program_SPIRV_get_size(program.get()) * sizeof(uint32_t);
    info.pCode = glslang_program_SPIRV_get_ptr(program.get());
    VkShaderModule module;
    checkVk(vkCreateShaderModule(api_.device, &info, nullptr, &module), "vkCreateShaderModule");
    modules_.emplace(text, module);
    return module;
}

} // namespace agaa::conformance
