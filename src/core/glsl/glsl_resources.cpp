#include "core/glsl/glsl_resources.h"

#include "core/base/error.h"
#include "core/glsl/compile_glsl.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

namespace agaa {

namespace {

using Tokens = std::vector<std::string_view>;

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Splits into words and single other characters. Lines of directives are left out.
Tokens tokensOf(std::string_view text) {
    Tokens tokens;
    bool beginsLine = true;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c))) {
            beginsLine |= c == '\n';
            ++i;
        } else if (c == '#' && beginsLine) {
            i = std::min(text.find('\n', i), text.size());
        } else {
            size_t end = i + 1;
            while (isWordCharacter(c) && end < text.size() && isWordCharacter(text[end]))
                ++end;
            tokens.push_back(text.substr(i, end - i));
            i = end;
            beginsLine = false;
        }
    }
    return tokens;
}

bool contains(const Tokens& tokens, std::string_view word) {
    return std::find(tokens.begin(), tokens.end(), word) != tokens.end();
}

uint32_t numberAfter(const Tokens& tokens, std::string_view word, uint32_t otherwise) {
    const auto at = std::find(tokens.begin(), tokens.end(), word);
    for (auto next = at; next != tokens.end() && next - at <= 2; ++next)
        if (std::isdigit(static_cast<unsigned char>(next->front())))
            return uint32_t(std::strtoul(std::string(*next).c_str(), nullptr, 0));
    return otherwise;
}

// Opaque types have the letter of their components before their names, as in usampler2D.
bool isType(std::string_view type, std::string_view kind) {
    return type.starts_with(kind) || (!type.empty() && type.substr(1).starts_with(kind));
}

AgaaGlslResourceKind kindOfType(std::string_view type) {
    if (isType(type, "sampler") || isType(type, "texture"))
        return AGAA_GLSL_RESOURCE_SAMPLER;
    if (isType(type, "image"))
        return AGAA_GLSL_RESOURCE_IMAGE;
    return isType(type, "subpassInput") ? AGAA_GLSL_RESOURCE_INPUT_ATTACHMENT : AGAA_GLSL_RESOURCE_UNIFORM;
}

// Says whether the brace after the statement begins a block, not a function or a struct.
bool beginsBlock(const Tokens& statement) {
    if (statement.size() < 2)
        return false;
    const std::string_view storage = statement[statement.size() - 2];
    return storage == "uniform" || storage == "buffer";
}

void setName(AgaaGlslResource& resource, std::string_view name) {
    std::memcpy(resource.name, name.data(), std::min(name.size(), sizeof resource.name - 1));
}

// Appends the resource of a global statement, if it declares one. A block's statement ends before its members.
void appendResource(const Tokens& statement, bool isBlock, std::vector<AgaaGlslResource>& out) {
    const bool isStorage = contains(statement, "buffer");
    if (!isStorage && !contains(statement, "uniform"))
        return;
    if (statement.back() == "uniform" || statement.back() == "buffer") // sets defaults of layouts
        return;
    AgaaGlslResource resource{};
    resource.count = 1;
    resource.set = numberAfter(statement, "set", 0);
    resource.binding = numberAfter(statement, "binding", 0);
    if (isBlock) {
        resource.kind = isStorage ? AGAA_GLSL_RESOURCE_STORAGE_BLOCK : AGAA_GLSL_RESOURCE_UNIFORM_BLOCK;
        setName(resource, statement.back());
    } else {
        auto end = statement.end();
        if (statement.back() == "]") {
            end = std::find(statement.begin(), statement.end(), "[");
            resource.count = numberAfter(Tokens(end, statement.end()), "[", 1);
        }
        if (end - statement.begin() < 3)
            return;
        setName(resource, *(end - 1));
        resource.kind = kindOfType(*(end - 2));
    }
    out.push_back(resource);
}

} // namespace

std::vector<AgaaGlslResource> declaredResources(std::string_view preprocessed) {
    std::vector<AgaaGlslResource> out;
    Tokens statement;
    int depth = 0;
    const Tokens tokens = tokensOf(preprocessed);
    for (const std::string_view token : tokens) {
        if (token == "}") {
            --depth;
        } else if (token == "{") {
            if (depth++ == 0 && beginsBlock(statement))
                appendResource(statement, true, out);
        } else if (depth == 0 && token != ";") {
            statement.push_back(token);
            continue;
        } else if (depth == 0 && !statement.empty()) {
            appendResource(statement, false, out);
        }
        statement.clear();
    }
    return out;
}

std::vector<AgaaGlslResource> glslResources(const HostPass& pass) {
    const GlslCompilerUse use;
    std::vector<AgaaGlslResource> list;
    for (const auto& [text, stage] :
         {std::pair(&pass.declarations, AGAA_GLSL_STAGE_FRAGMENT), std::pair(&pass.geometry, AGAA_GLSL_STAGE_GEOMETRY),
          std::pair(&pass.vertex, AGAA_GLSL_STAGE_VERTEX)})
        for (const AgaaGlslResource& resource : declaredResources(text->empty() ? *text : preprocess(*text))) {
            const std::string_view name = resource.name;
            if (!name.starts_with("agaa_"))
                continue;
            auto at = std::find_if(list.begin(), list.end(),
                                   [&](const AgaaGlslResource& other) { return name == other.name; });
            if (at == list.end())
                at = list.insert(at, resource);
            at->stages |= uint32_t(stage);
        }
    return list;
}

} // namespace agaa
