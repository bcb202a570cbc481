// Compiles permutations of a pass to SPIR-V, optimises, encodes (core/base/spirv_code.h) and compresses them, and
// writes each into a C++ include file for core/base/embedded.cpp. Permutations are compressed by their differences to
// the first one of the process.
//
// usage: agaa-compile-passes SHADER OUTPUT_FOLDER DEPFILE INCLUDE_FOLDERS OPTIMISATIONS PERMUTATION…
// Lists have commas. A permutation is NAME:MACRO=VALUE:MACRO=VALUE…; its file is OUTPUT_FOLDER/NAME.inc.
#include "array_text.h"
#include "encode.h"

#include "core/base/spirv_code.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Words = std::vector<uint32_t>;
using Bytes = std::vector<uint8_t>;

[[noreturn]] void fail(const std::string& sentence) {
    std::fprintf(stderr, "agaa-compile-passes: %s\n", sentence.c_str());
    std::exit(1);
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::string readText(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        fail("The file " + path.string() + " cannot be read.");
    return {std::istreambuf_iterator<char>(file), {}};
}

// Finds included files beside the one that includes them, then in the folders.
class Includer : public glslang::TShader::Includer {
public:
    explicit Includer(std::vector<std::string> folders) : folders_(std::move(folders)) {}

    IncludeResult* includeLocal(const char* name, const char* includer, size_t) override {
        if (IncludeResult* beside = find(fs::path(includer).parent_path() / name))
            return beside;
        return includeSystem(name, includer, 0);
    }
    IncludeResult* includeSystem(const char* name, const char*, size_t) override {
        for (const std::string& folder : folders_)
            if (IncludeResult* found = find(fs::path(folder) / name))
                return found;
        return nullptr;
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

    const std::map<std::string, std::string>& files() const { return texts_; } // that were included, with their texts

private:
    IncludeResult* find(const fs::path& path) {
        const std::string name = path.lexically_normal().string();
        auto found = texts_.find(name);
        if (found == texts_.end()) {
            if (!fs::is_regular_file(name))
                return nullptr;
            found = texts_.emplace(name, readText(name)).first;
        }
        return new IncludeResult(name, found->second.data(), found->second.size(), nullptr);
    }

    std::vector<std::string> folders_;
    std::map<std::string, std::string> texts_;
};

Words compile(const std::string& path, const std::string& text, const std::string& preamble, Includer& includer) {
    constexpr auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(EShLangCompute);
    const char* const texts[] = {text.c_str()};
    const int lengths[] = {int(text.size())};
    const char* const names[] = {path.c_str()};
    shader.setStringsWithLengthsAndNames(texts, lengths, names, 1);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    if (!shader.parse(GetDefaultResources(), 100, false, messages, includer))
        fail(path + " does not compile:\n" + shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages) || !program.mapIO())
        fail(path + " does not link:\n" + program.getInfoLog());
    Words words;
    glslang::SpvOptions options;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words, &options);
    return words;
}

// Sets or clears the bit DontInline of functions with several returns. SPIRV-Tools inlines none of them, but without
// the bit it prints the whole module for a warning at each of their calls, which takes two thirds of its time.
void markAsNotInlined(Words& words, bool mark) {
    enum Op : uint32_t { Function = 54, FunctionEnd = 56, Return = 253, ReturnValue = 254 };
    constexpr uint32_t dontInline = 2;
    constexpr size_t header = 5;
    uint32_t* control = nullptr;
    int returns = 0;
    for (size_t at = header; at < words.size(); at += std::max(words[at] >> 16, 1u)) {
        const uint32_t op = words[at] & 0xFFFF;
        if (op == Function) {
            control = &words.at(at + 3);
            returns = 0;
        } else if (op == Return || op == ReturnValue) {
            ++returns;
        } else if (op == FunctionEnd && returns > 1) {
            *control = mark ? *control | dontInline : *control & ~dontInline;
        }
    }
}

Words optimised(Words words, const std::vector<std::string>& passes, const std::string& name) {
    markAsNotInlined(words, true);
    spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_6);
    std::string errors;
    optimizer.SetMessageConsumer([&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
        if (level <= SPV_MSG_ERROR)
            errors += std::string(text) + "\n";
    });
    Words result;
    if (!optimizer.RegisterPassesFromFlags(passes) || !optimizer.Run(words.data(), words.size(), &result))
        fail(name + " cannot be optimised:\n" + errors);
    markAsNotInlined(result, false);
    return result;
}

struct Base {
    std::string name; // empty if the module is the base
    Bytes code;
};

// Writes the module, and makes it the base if there is none.
void writeModule(const fs::path& path, const std::string& name, const Words& spirv, Base& base) {
    const EncodedModule module = encoded(spirv);
    if (agaa::decodedSpirv(module.code) != module.words)
        fail(name + " is not the same when it is decoded.");
    const Bytes bytes = compressed(module.code, base.code);
    if (decompressed(bytes, base.code, module.code.size()) != module.code)
        fail(name + " is not the same when it is decompressed.");
    std::array<uint64_t, 2> constants{};
    for (const uint32_t id : module.constants)
        constants.at(id / 64) |= uint64_t(1) << id % 64;
    std::string text = arrayText("spirv_" + name, bytes) + "constexpr SpirvModule module_" + name + " = {\"" + name +
                       "\", spirv_" + name + ", " + std::to_string(bytes.size()) + ", " +
                       std::to_string(module.code.size()) + ", " +
                       (base.name.empty() ? "nullptr" : "&module_" + base.name) + ", {";
    for (const uint64_t each : constants)
        append(text, each);
    std::ofstream file(path, std::ios::binary);
    file << text << "}};\n";
    if (!file.flush())
        fail("The file " + path.string() + " cannot be written.");
    if (base.name.empty())
        base = {name, module.code};
}

} // namespace

int main(int count, char** arguments) {
    if (count < 7)
        fail("SHADER OUTPUT_FOLDER DEPFILE INCLUDE_FOLDERS OPTIMISATIONS PERMUTATION… are expected.");
    const std::string shader = arguments[1];
    const fs::path folder = arguments[2];
    const std::vector<std::string> passes = split(arguments[5], ',');
    const std::string text = readText(shader);
    Includer includer(split(arguments[4], ','));
    glslang::InitializeProcess();
    std::string outputs;
    Base base;
    for (int i = 6; i < count; ++i) {
        const std::vector<std::string> parts = split(arguments[i], ':');
        const std::string& name = parts[0];
        std::string preamble;
        for (size_t k = 1; k < parts.size(); ++k)
            preamble += "#define " + parts[k].substr(0, parts[k].find('=')) + " " +
                        parts[k].substr(parts[k].find('=') + 1) + "\n";
        const fs::path output = folder / (name + ".inc");
        try {
            writeModule(output, name, optimised(compile(shader, text, preamble, includer), passes, name), base);
        } catch (const std::exception& error) {
            fail(name + ": " + error.what() + ".");
        }
        outputs += output.string() + " ";
    }
    glslang::FinalizeProcess();
    std::ofstream dependencies(arguments[3]);
    dependencies << outputs << ": " << shader;
    for (const auto& [path, contents] : includer.files())
        dependencies << " " << path;
    dependencies << "\n";
    if (!dependencies.flush())
        fail(std::string("The file ") + arguments[3] + " cannot be written.");
}
