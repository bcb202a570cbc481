#include "cli/measured_file.h"

#include "cli/json_numbers.h"
#include "scene/shortened.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace harness {

using nlohmann::json;

namespace {

std::string textOf(const json& row, const char* key) {
    const auto found = row.find(key);
    return found == row.end() || found->is_null() ? "" : found->get<std::string>();
}

uint32_t tierOf(const json& row) {
    const std::string name = textOf(row, "tier");
    uint32_t tier = AGAA_TIER_AUTO;
    if (!name.empty() && agaaTierFromName(name.c_str(), &tier) != AGAA_OK)
        throw std::runtime_error("\"" + name + "\" is no tier.");
    return tier;
}

AgaaMeasuredSettings settingsOf(const json& row, std::list<std::string>& names) {
    AgaaMeasuredSettings m = AGAA_MEASURED_SETTINGS_INIT;
    m.technique = names.emplace_back(row.at("technique").get<std::string>()).c_str();
    if (const std::string preset = textOf(row, "preset"); !preset.empty())
        m.preset = names.emplace_back(preset).c_str();
    m.samples = countOf<uint32_t>(row.at("samples"));
    m.aggregates = countOf<uint32_t>(row.at("aggregates"));
    m.generationTier = tierOf(row);
    m.errorShare = row.at("errorShare").get<float>();
    m.error = row.at("error").get<float>();
    if (row.contains("pixels"))
        m.pixels = countOf<uint64_t>(row["pixels"]);
    m.geometryMilliseconds = row.value("geometryMs", 0.0f);
    m.shadingMilliseconds = row.value("shadingMs", 0.0f);
    return m;
}

} // namespace

MeasuredFile::MeasuredFile(const std::string& path) {
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error("\"" + path + "\" cannot be read.");
    try {
        const json data = json::parse(file);
        for (const json& row : data.at("measured"))
            settings_.push_back(settingsOf(row, names_));
    } catch (const std::exception& error) {
        throw std::runtime_error("\"" + path + "\" is no file of measured settings (" + shortened(error.what()) + ").");
    }
    if (settings_.empty())
        throw std::runtime_error("\"" + path + "\" has no measured settings.");
}

} // namespace harness
