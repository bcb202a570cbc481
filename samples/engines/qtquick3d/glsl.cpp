/* SPDX-License-Identifier: MIT */
#include "glsl.h"

#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

#include <stdexcept>

VkShaderModule compile(VkDevice device, VkShaderStageFlagBits vkStage, const std::string& text) {
    const glslang_stage_t stage = vkStage == VK_SHADER_STAGE_VERTEX_BIT ? GLSLANG_STAGE_VERTEX : GLSLANG_STAGE_FRAGMENT;
    const auto messages = glslang_messages_t(GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT);
    glslang_input_t input = {};
    input.language = GLSLANG_SOURCE_GLSL, input.stage = stage;
    input.client = GLSLANG_CLIENT_VULKAN, input.client_version = GLSLANG_TARGET_VULKAN_1_2;
    input.target_language = GLSLANG_TARGET_SPV, input.target_language_version = GLSLANG_TARGET_SPV_1_5;
    input.code = text.c_str(), input.messages = messages, input.resource = glslang_default_resource();
    glslang_initialize_process();
    glslang_shader_t* shader = glslang_shader_create(&input);
    glslang_program_t* program = glslang_program_create();
    VkShaderModule module = VK_NULL_HANDLE;
    std::string error;
    if (glslang_shader_preprocess(shader, &input) && glslang_shader_parse(shader, &input)) {
        glslang_program_add_shader(program, shader);
        glslang_program_link(program, messages);
        glslang_program_SPIRV_generate(program, stage);
        VkShaderModuleCreateInfo info = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.pCode = glslang_program_SPIRV_get_ptr(program);
        info.codeSize = glslang_program_SPIRV_get_size(program) * sizeof(uint32_t);
        vkCreateShaderModule(device, &info, nullptr, &module);
    } else {
        error = glslang_shader_get_info_log(shader);
    }
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    glslang_finalize_process();
    if (!module)
        throw std::runtime_error("A shader does not compile. " + error);
    return module;
}
