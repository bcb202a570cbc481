#include "cli/layout_file.h"

#include "cli/arguments.h"
#include "cli/json_numbers.h"
#include "render/reference.h"
#include "scene/shortened.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <utility>

namespace harness {

static uint32_t indexOf(const std::string& name, std::initializer_list<const char*> names, const std::string& file) {
    uint32_t index = 0;
    for (const char* candidate : names) {
        if (name == candidate)
            return index;
        ++index;
    }
    throw BadArgument(file + ": \"" + shortened(name) + "\" is not known in a layout.");
}

// Returns a string that lives as long as the process, because AgaaLayoutAttribute points to it.
static const char* kept(std::string name) {
    static std::set<std::string> names;
    return names.insert(std::move(name)).first->c_str();
}

static AgaaLayout parseLayout(const nlohmann::json& json, const std::string& file) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    const auto& attributes = json.at("attributes");
    if (!attributes.is_array() || attributes.size() > AGAA_MAX_LAYOUT_ATTRIBUTES)
        throw BadArgument(file + ": a layout has an array of at most 13 attributes.");
    for (const auto& source : attributes) {
        AgaaLayoutAttribute& a = layout.attributes[layout.attributeCount++];
        a.semantic = indexOf(source.at("semantic").get<std::string>(),
                             {"diffuse", "specular", "normal", "roughness", "emissive", "custom"}, file);
        a.channels = countOf<uint32_t>(source.at("channels"));
        a.sampleBits = countOf<uint32_t>(source.at("sampleBits"));
        a.aggregateBits = countOf<uint32_t>(source.value("aggregateBits", nlohmann::json(0u)));
        a.chromaBits = countOf<uint32_t>(source.value("chromaBits", nlohmann::json(0u)));
        a.encoding = indexOf(source.value("encoding", std::string("unorm")), {"unorm", "ycbcr", "folded"}, file);
        a.range = source.value("range", 1.0f);
        a.filter = indexOf(source.value("filter", std::string("mean")), {"mean", "normal", "none"}, file);
        if (source.contains("name"))
            a.name = kept(source.at("name").get<std::string>());
    }
    return layout;
}

AgaaLayout readLayout(const std::string& nameOrFile) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    if (nameOrFile == "reference")
        return referenceLayout(nullptr);
    if (agaaGetBuiltinLayout(nameOrFile.c_str(), &layout) == AGAA_OK)
        return layout;
    std::ifstream stream(nameOrFile);
    if (!stream)
        throw BadArgument("--layout is \"" + nameOrFile +
                          "\"; it can be paper16, precise, dcaa28, reference or a readable JSON file.");
    try {
        return parseLayout(nlohmann::json::parse(stream), nameOrFile);
    } catch (const BadArgument&) {
        throw;
    } catch (const std::exception& error) {
        throw BadArgument(nameOrFile + ": not a layout (" + shortened(error.what()) + ").");
    }
}

} // namespace harness
