// Options of `agaa-harness render` by name. They are the viewer's settings, so that both programs have the same ones.
#pragma once

#include "cli/commands.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace viewer {

// One option of `agaa-harness render` that the viewer takes.
struct OptionRow {
    std::string name;        // with its dashes
    std::string description; // one line, may be empty
    std::string fallback;    // value without the option; empty: none
    bool isFlag = false;
    bool isRepeatable = false;
    bool isOfView = false; // a setting of the technique, which two views of one scene may have differently
};

// Returns all rows, in the order of `agaa-harness render --help`.
const std::vector<OptionRow>& optionRows();
// Returns null for names that the viewer does not take.
const OptionRow* findOption(const std::string& name);

// Options with their values. Flags have no value.
class OptionSet {
public:
    bool has(const std::string& name) const { return values_.contains(name); }
    // Returns the first value, or the value that the option has by default.
    std::string get(const std::string& name) const;
    // Returns no values for flags and for options that are not set.
    std::vector<std::string> all(const std::string& name) const;
    // Throws BadArgument for names that the viewer does not take.
    void setAll(const std::string& name, std::vector<std::string> values);
    void set(const std::string& name, const std::string& value) { setAll(name, std::vector{value}); }
    void setFlag(const std::string& name, bool on);
    void erase(const std::string& name) { values_.erase(name); }
    bool operator==(const OptionSet&) const = default;

    // Returns the command line of `agaa-harness render` after the command's name.
    std::vector<std::string> arguments() const;
    // Parses the options as `agaa-harness render` does. Throws BadArgument with its sentence.
    harness::RenderArguments parse() const;

    // Flags are true, repeatable options arrays, other options strings.
    nlohmann::json toJson() const;
    // Throws BadArgument with a sentence that names the option.
    static OptionSet fromJson(const nlohmann::json& json);

private:
    std::map<std::string, std::vector<std::string>> values_;
};

// Returns the options of a view of another technique in the same frame: those of the scene from `frame`, those of the
// technique from `view`.
OptionSet withView(const OptionSet& frame, const OptionSet& view);
// Replaces the options that agaaChooseSettings decides. chosen: names and values in turn, as optionsOf() returns them.
OptionSet withChoice(OptionSet options, const std::vector<std::string>& chosen);

} // namespace viewer
