// Compiles, validates and shows SPIR-V of shader text. The test calls glslang::InitializeProcess().
#pragma once

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace agaa::test {

// Returns the SPIR-V and the compiler's messages.
inline std::pair<std::vector<uint32_t>, std::string> spirvOf(EShLanguage stage, const std::string& text) {
    glslang::TShader shader(stage);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 450, false, messages))
        return {{}, shader.getInfoLog()};
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages))
        return {{}, program.getInfoLog()};
    std::vector<uint32_t> words;
    glslang::GlslangToSpv(*program.getIntermediate(stage), words);
    return {words, ""};
}

inline std::string validate(const std::vector<uint32_t>& words) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
    std::string errors;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* text) {
        errors += std::string(text) + "\n";
    });
    return tools.Validate(words) ? "" : "invalid: " + errors;
}

inline std::string disassemble(const std::vector<uint32_t>& words) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
    std::string text;
    tools.Disassemble(words, &text);
    return text;
}

} // namespace agaa::test
