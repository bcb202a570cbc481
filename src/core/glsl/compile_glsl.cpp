#include "core/glsl/compile_glsl.h"

#include "core/base/error.h"
#include "core/base/names.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace agaa {

namespace {

// Names and text of the host are in the log.
std::string firstLine(const char* log) {
    const std::string text(log);
    const size_t begin = text.starts_with("ERROR: ") ? 7 : 0;
    std::string line = text.substr(begin, text.find('\n') - begin);
    while (!line.empty() && (line.back() == '.' || line.back() == ' '))
        line.pop_back();
    return printable(line, 500);
}

} // namespace

// glslang counts its users in the process.
GlslCompilerUse::GlslCompilerUse() { glslang::InitializeProcess(); }
GlslCompilerUse::~GlslCompilerUse() { glslang::FinalizeProcess(); }

// Compilations at run time need the tables of the same rules, so that these are made once.
static constexpr auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);

static void setVulkan(glslang::TShader& shader, EShLanguage stage) {
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
}

std::string preprocess(const std::string& text) {
    const GlslCompilerUse use;
    glslang::TShader shader(EShLangCompute);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    setVulkan(shader, EShLangCompute);
    std::string out;
    glslang::TShader::ForbidIncluder includer;
    if (!shader.preprocess(GetDefaultResources(), 450, ENoProfile, false, false, messages, &out, includer))
        fail(AGAA_ERROR_INVALID_ARGUMENT, "GLSL does not preprocess: " + firstLine(shader.getInfoLog()) + ".");
    return out;
}

namespace {

// A stage that compiled and linked.
class LinkedStage {
public:
    LinkedStage(const std::string& text, EShLanguage stage, const char* what) : shader_(stage) {
        const auto refuse = [&](const char* log) {
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s does not compile: %s.", what, firstLine(log).c_str()));
        };
        const char* source = text.c_str();
        shader_.setStrings(&source, 1);
        setVulkan(shader_, stage);
        if (!shader_.parse(GetDefaultResources(), 450, false, messages))
            refuse(shader_.getInfoLog());
        program_.addShader(&shader_);
        if (!program_.link(messages))
            refuse(program_.getInfoLog());
    }
    const glslang::TIntermediate& intermediate() const { return *program_.getIntermediate(shader_.getStage()); }

private:
    GlslCompilerUse use_;
    glslang::TShader shader_; // outlives the program
    glslang::TProgram program_;
};

} // namespace

std::vector<uint32_t> compileCompute(const std::string& text, const char* what) {
    const LinkedStage stage(text, EShLangCompute, what);
    std::vector<uint32_t> words;
    glslang::SpvOptions options;
    options.disableOptimizer = true; // the host waits for the compilation
    glslang::GlslangToSpv(stage.intermediate(), words, &options);
    return words;
}

void checkFragment(const std::string& text, const char* what) { LinkedStage(text, EShLangFragment, what); }

} // namespace agaa
