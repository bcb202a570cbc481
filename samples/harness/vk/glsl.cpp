#include "vk/glsl.h"

#include "embedded.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace harness::vk {

namespace {

// The library must be initialised and finalised once per process.
struct Glslang {
    Glslang() { glslang::InitializeProcess(); }
    ~Glslang() { glslang::FinalizeProcess(); }
};

// glslang writes "ERROR: 0:123: …". The text was assembled at run time, so the message also quotes the line.
std::string withSourceLines(const std::string& log, const std::string& source) {
    std::vector<std::string> lines;
    std::istringstream text(source);
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    std::string result;
    std::istringstream messages(log);
    for (std::string message; std::getline(messages, message);) {
        result += message + "\n";
        const size_t colon = message.find(": 0:");
        const size_t number =
            colon == std::string::npos ? 0 : size_t(std::strtoul(message.c_str() + colon + 4, nullptr, 10));
        if (number >= 1 && number <= lines.size())
            result += "    " + lines[number - 1] + "\n";
    }
    return result;
}

} // namespace

std::vector<uint32_t> compileGlsl(ShaderStage stage, const std::string& source, const std::string& name) {
    static const Glslang library;
    const EShLanguage language = stage == ShaderStage::Vertex     ? EShLangVertex
                                 : stage == ShaderStage::Geometry ? EShLangGeometry
                                 : stage == ShaderStage::Fragment ? EShLangFragment
                                                                  : EShLangCompute;
    const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    const auto fail = [&](const std::string& log) {
        throw std::runtime_error("The shader \"" + name + "\" does not compile:\n" + withSourceLines(log, source));
    };

    glslang::TShader shader(language);
    const char* text = source.c_str();
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    if (!shader.parse(GetDefaultResources(), 450, false, messages))
        fail(shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages))
        fail(program.getInfoLog());
    std::vector<uint32_t> spirv;
    glslang::SpvOptions options;
    options.disableOptimizer = true; // the driver optimises
    glslang::GlslangToSpv(*program.getIntermediate(language), spirv, &options);
    if (spirv.empty())
        fail("no code was generated");
    return spirv;
}

std::string vulkanText(const char* body) { return std::string("#version 450\n") + embedded::interface_glsl + body; }

} // namespace harness::vk
