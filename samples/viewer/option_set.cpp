#include "option_set.h"

#include "cli/plan_options.h"
#include "cli/program.h"
#include "cli/render_options.h"
#include "scene/shortened.h"

#include <algorithm>
#include <set>

namespace viewer {

using harness::BadArgument;

namespace {

// The viewer writes files and measures by itself.
const std::set<std::string> notTaken = {"--png", "--exr", "--resolve", "--no-counters", "--no-timestamps", "--help"};
// The size of a frame is equal in both views.
const std::set<std::string> ofFrame = {"--size", "--reversed-z", "--exposure", "--hdr-resolve"};

std::string nameOf(const CLI::Option& option) { return option.get_name(); }

std::set<std::string> viewOptionNames() {
    harness::PlanArguments plan;
    CLI::App app;
    harness::addPlanOptions(app, plan);
    harness::addShadingOptions(app, plan);
    std::set<std::string> names = {"--without", "--plain-facts", "--filtered-shadows", "--backend"};
    for (const CLI::Option* option : app.get_options())
        if (!ofFrame.contains(nameOf(*option)))
            names.insert(nameOf(*option));
    return names;
}

std::vector<OptionRow> makeRows() {
    harness::RenderArguments arguments;
    CLI::App app;
    harness::addRenderCommandOptions(app, arguments);
    const std::set<std::string> ofView = viewOptionNames();
    std::vector<OptionRow> rows;
    for (CLI::Option* option : app.get_options()) {
        const std::string name = nameOf(*option);
        if (notTaken.contains(name))
            continue;
        OptionRow row{name, option->get_description(), {}, false, false, false};
        row.isFlag = option->get_items_expected_max() == 0;
        row.isRepeatable = option->get_items_expected_max() > 1;
        row.isOfView = ofView.contains(name);
        if (!row.isFlag && !row.isRepeatable) {
            option->capture_default_str();
            row.fallback = option->get_default_str();
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

// Returns the text of a value, or throws.
std::string textOf(const nlohmann::json& value, const std::string& name) {
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number())
        return value.dump();
    throw BadArgument("The value of " + name + " in the state is " + harness::shortened(value.dump()) +
                      "; it can be a text or a number.");
}

} // namespace

const std::vector<OptionRow>& optionRows() {
    static const std::vector<OptionRow> rows = makeRows();
    return rows;
}

const OptionRow* findOption(const std::string& name) {
    const std::vector<OptionRow>& rows = optionRows();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const OptionRow& row) { return row.name == name; });
    return found == rows.end() ? nullptr : &*found;
}

static const OptionRow& requireOption(const std::string& name) {
    if (notTaken.contains(name))
        throw BadArgument("The viewer does not take the option " + name + ".");
    const OptionRow* row = findOption(name);
    if (!row)
        throw BadArgument("The option \"" + harness::shortened(name) +
                          "\" is not known; see agaa-harness render --help.");
    return *row;
}

std::string OptionSet::get(const std::string& name) const {
    const auto found = values_.find(name);
    if (found != values_.end() && !found->second.empty())
        return found->second.front();
    const OptionRow* row = findOption(name);
    return row ? row->fallback : std::string();
}

std::vector<std::string> OptionSet::all(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? std::vector<std::string>() : found->second;
}

void OptionSet::setAll(const std::string& name, std::vector<std::string> values) {
    const OptionRow& row = requireOption(name);
    if (row.isFlag)
        throw BadArgument("The option " + name + " is a flag and takes no value.");
    if (values.empty())
        values_.erase(name);
    else
        values_[name] = std::move(values);
}

void OptionSet::setFlag(const std::string& name, bool on) {
    if (!requireOption(name).isFlag)
        throw BadArgument("The option " + name + " takes a value.");
    if (on)
        values_[name] = {};
    else
        values_.erase(name);
}

std::vector<std::string> OptionSet::arguments() const {
    std::vector<std::string> words;
    for (const auto& [name, values] : values_) {
        if (values.empty())
            words.push_back(name);
        for (const std::string& value : values)
            words.push_back(name + "=" + value);
    }
    return words;
}

harness::RenderArguments OptionSet::parse() const {
    harness::RenderArguments arguments;
    CLI::App app;
    app.set_help_flag();
    harness::addRenderCommandOptions(app, arguments);
    std::vector<std::string> words = {"agaa-viewer"};
    for (std::string& word : this->arguments())
        words.push_back(std::move(word));
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    harness::parseArguments(app, int(pointers.size()), pointers.data());
    return arguments;
}

nlohmann::json OptionSet::toJson() const {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [name, values] : values_) {
        if (values.empty())
            json[name] = true;
        else if (findOption(name)->isRepeatable)
            json[name] = values;
        else
            json[name] = values.front();
    }
    return json;
}

OptionSet OptionSet::fromJson(const nlohmann::json& json) {
    if (!json.is_object())
        throw BadArgument("The options of the state must be an object.");
    OptionSet options;
    for (const auto& [name, value] : json.items()) {
        requireOption(name);
        if (value.is_boolean() && findOption(name)->isFlag) {
            options.setFlag(name, value.get<bool>());
            continue;
        }
        std::vector<std::string> values;
        if (value.is_array())
            for (const nlohmann::json& each : value)
                values.push_back(textOf(each, name));
        else
            values.push_back(textOf(value, name));
        options.setAll(name, std::move(values));
    }
    return options;
}

OptionSet withView(const OptionSet& frame, const OptionSet& view) {
    OptionSet result;
    for (const OptionRow& row : optionRows()) {
        const OptionSet& source = row.isOfView && !(row.name == "--backend" && !view.has(row.name)) ? view : frame;
        if (!source.has(row.name))
            continue;
        if (row.isFlag)
            result.setFlag(row.name, true);
        else
            result.setAll(row.name, source.all(row.name));
    }
    return result;
}

OptionSet withChoice(OptionSet options, const std::vector<std::string>& chosen) {
    // A preset excludes these options.
    for (const char* decided : {"--preset", "--technique", "--samples", "--aggregates", "--tier", "--ndf", "--seeds",
                                "--threshold", "--surface", "--gloss-weight", "--lit", "--shadow-taps",
                                "--split-surfaces", "--fine-materials", "--first-sample-routing", "--no-diffuse-filter",
                                "--no-shadow-filter", "--shadow-along-depth", "--shadow-covariance"})
        options.erase(decided);
    for (size_t i = 0; i + 1 < chosen.size(); i += 2)
        options.set(chosen[i], chosen[i + 1]);
    return options;
}

} // namespace viewer
