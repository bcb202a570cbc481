#include "core/glsl/glsl_text.h"

#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/glsl/expression_depth.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace agaa {

// Appends the lines of a text. Its #include lines are relative to the folder and replaced by the files.
static void appendLines(std::string& out, std::string_view text, const std::string& folder, std::set<std::string>& seen,
                        const std::string& hostCode) {
    size_t begin = 0;
    while (begin < text.size()) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (line.starts_with("#extension GL_GOOGLE_include_directive") ||
            line.starts_with("#extension GL_KHR_shader_subgroup")) {
            // The text needs no extension for includes. Those for subgroups precede all other text.
        } else if (line == "#include \"host-code\"") {
            // Messages about the host's text count its lines. Lines of the library after it count from 100000.
            out += hostCode + "#line 100000\n";
        } else if (line.starts_with("#include \"")) {
            std::string name(line.substr(10, line.find('"', 10) - 10));
            appendGlsl(out, name.find('/') == std::string::npos ? folder + name : name, seen, hostCode);
        } else {
            out += line;
            out += '\n';
        }
        begin = end + 1;
    }
}

void appendGlsl(std::string& out, const std::string& path, std::set<std::string>& seen, const std::string& hostCode) {
    const bool isTable = path.ends_with(".inc"); // a table is included for each macro that its rows use
    if (!seen.insert(path).second && !isTable)
        return;
    const std::string_view text = embeddedGlsl(path);
    if (text.empty())
        fail(AGAA_ERROR_INTERNAL, "the shader text " + path + " is not in the library.");
    appendLines(out, text, path.substr(0, path.find('/') + 1), seen, hostCode);
}

void appendGlslText(std::string& out, const std::string& text, std::set<std::string>& seen) {
    appendLines(out, text, "", seen, {});
}

// Expands the macros of math/real.glsl, because the host may define the same names.
std::string coverageGlsl() {
    static constexpr std::pair<std::string_view, std::string_view> macros[] = {
        {"real", "float"}, {"rvec2", "vec2"},   {"rvec3", "vec3"},     {"rvec4", "vec4"},
        {"OUT", "out "},   {"INOUT", "inout "}, {"PRECISE", "precise"}};
    const auto macroAt = [](std::string_view text) {
        const auto end = std::find_if_not(text.begin(), text.end(), isWordByte);
        const std::string_view word = text.substr(0, size_t(end - text.begin()));
        return std::find_if(std::begin(macros), std::end(macros), [&](const auto& row) {
            return row.first == word && (!row.second.ends_with(' ') || (end != text.end() && *end == '('));
        });
    };
    std::string source, out;
    std::set<std::string> seen;
    appendGlsl(source, "math/alpha_coverage.glsl", seen);
    bool isArgument = false; // of OUT or INOUT
    for (std::string_view text = source; !text.empty();) {
        constexpr std::string_view define = "#define ";
        const auto macro = macroAt(text);
        if (text.starts_with(define) && macroAt(text.substr(define.size())) != std::end(macros)) {
            text.remove_prefix(text.find('\n') + 1);
        } else if (macro != std::end(macros) && (out.empty() || !isWordByte(out.back()))) {
            out += macro->second;
            isArgument |= macro->second.ends_with(' ');
            text.remove_prefix(macro->first.size() + macro->second.ends_with(' ')); // its bracket, too
        } else {
            if (!isArgument || text[0] != ')')
                out += text[0];
            isArgument &= text[0] != ')';
            text.remove_prefix(1);
        }
    }
    return out;
}

// The extensions of src/shaders/common/subgroup_extensions.glsl.
static constexpr const char* subgroupExtensions = "#extension GL_KHR_shader_subgroup_basic : require\n"
                                                  "#extension GL_KHR_shader_subgroup_vote : require\n"
                                                  "#extension GL_KHR_shader_subgroup_ballot : require\n"
                                                  "#extension GL_KHR_shader_subgroup_shuffle : require\n";

static std::string assemble(const Pass& pass, std::set<std::string> seen, const std::string& version,
                            const std::string& head) {
    if (expressionDepth(pass.compute().hostCode) > maxExpressionDepth)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s is nested more than %zu levels deep.",
                                                 pass.compute().hostCodeOrigin.c_str(), maxExpressionDepth));
    std::string text;
    if (pass.compute().text.empty())
        appendGlsl(text, pass.compute().file, seen, pass.compute().hostCode);
    else
        appendLines(text, pass.compute().text, "", seen, pass.compute().hostCode);
    // #version must be the first line.
    const std::string_view line = "#version 450\n";
    const size_t at = text.find(line);
    if (at == std::string::npos)
        fail(AGAA_ERROR_INTERNAL, "the pass " + pass.name + " has no version.");
    const std::string extensions = pass.compute().fullSubgroups ? subgroupExtensions : "";
    return text.replace(at, line.size(), version + extensions + pass.compute().hostCodeExtensions + head);
}

std::string passGlsl(const Pass& pass) { return assemble(pass, {}, "#version 450\n", pass.compute().defines); }

std::string passGlslForOpenGl(const Pass& pass, uint32_t glslVersion) {
    std::string head = "#define AGAA_GL 1\n#define AGAA_CONSTANTS_GLSL\n" + pass.compute().defines;
#define AGAA_CONSTANT(id, name, value) head += format("const uint %s = %uu;\n", #name, pass.constants[id]);
#include "shaders/tables/constants.inc"
#undef AGAA_CONSTANT
    return assemble(pass, {"common/constants.glsl"}, format("#version %u\n", glslVersion), head);
}

} // namespace agaa
