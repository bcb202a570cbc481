// The settings that matter most, and the table of all options.
#include "panels.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

namespace viewer {

namespace {

// Returns the tier of a stage, or "auto".
std::string tierOf(const OptionSet& options, const std::string& stage) {
    for (const std::string& tier : options.all("--tier"))
        if (tier.starts_with(stage + "="))
            return tier.substr(stage.size() + 1);
    return "auto";
}

void setTier(OptionSet& options, const std::string& stage, const std::string& tier) {
    std::vector<std::string> tiers = options.all("--tier");
    std::erase_if(tiers, [&](const std::string& each) { return each.starts_with(stage + "="); });
    if (tier != "auto")
        tiers.push_back(stage + "=" + tier);
    options.setAll("--tier", tiers);
}

void combo(Ui& ui, OptionSet& options, const char* label, const char* name, const std::vector<std::string>& names) {
    std::string chosen;
    if (optionCombo(ui, label, options.get(name), names, chosen))
        options.set(name, chosen);
}

void drawTechnique(App& app, Ui& ui, OptionSet& options) {
    std::string chosen;
    if (optionCombo(ui, "technique", options.get("--technique"), libraryNames(AGAA_NAMES_TECHNIQUES), chosen)) {
        app.state.goal.isOn = false;
        setTechnique(options, chosen);
    }
    std::vector<std::string> presets = libraryNames(AGAA_NAMES_PRESETS);
    presets.insert(presets.begin(), "");
    if (optionCombo(ui, "preset", options.get("--preset"), presets, chosen))
        setPreset(options, chosen);
    combo(ui, options, "n", "--samples", {"1", "2", "4", "8", "9", "16", "32", "64", "128"});
    combo(ui, options, "c", "--aggregates", {"1", "2", "3", "4", "5", "6", "7", "8"});
    std::vector<std::string> tiers = libraryNames(AGAA_NAMES_TIERS);
    if (std::find(tiers.begin(), tiers.end(), "auto") == tiers.end())
        tiers.insert(tiers.begin(), "auto");
    for (const char* stage : {"visibility", "generation"})
        if (optionCombo(ui, (std::string(stage) + " tier").c_str(), tierOf(options, stage), tiers, chosen))
            setTier(options, stage, chosen);
    std::vector<std::string> layouts = libraryNames(AGAA_NAMES_LAYOUTS);
    layouts.push_back("reference");
    combo(ui, options, "layout", "--layout", layouts);
    combo(ui, options, "debug view", "--view",
          {"none", "events", "aggregates", "clusters", "primitives", "lit", "widened", "tier", "facts"});
}

void drawEffects(OptionSet& options) {
    ImGui::TextUnformatted("effects left out");
    std::vector<std::string> without = options.all("--without");
    int column = 0;
    for (const char* effect : {"specular", "emissive", "ambient", "shadows", "shading-normals", "local-lights"}) {
        const auto found = std::find(without.begin(), without.end(), effect);
        bool isOut = found != without.end();
        if (column++ % 3)
            ImGui::SameLine(130.0f * float((column - 1) % 3));
        if (!ImGui::Checkbox(effect, &isOut))
            continue;
        if (isOut)
            without.push_back(effect);
        else
            without.erase(found);
        options.setAll("--without", without);
        return;
    }
}

void drawFlag(OptionSet& options, const char* label, const char* name) {
    bool on = options.has(name);
    if (ImGui::Checkbox(label, &on))
        options.setFlag(name, on);
}

bool contains(const std::string& text, const std::string& part) {
    const auto isEqual = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), isEqual) != text.end();
}

void chooseView(Ui& ui) {
    int view = ui.editsOther;
    ImGui::RadioButton("view A", &view, 0);
    ImGui::SameLine();
    ImGui::RadioButton("view B", &view, 1);
    ui.mark("view B");
    if (view == int(ui.editsOther))
        return;
    ui.editsOther = view == 1;
    ui.edited.clear();
}

} // namespace

void drawSettings(App& app, Ui& ui) {
    chooseView(ui);
    OptionSet& options = ui.editsOther ? app.state.other : app.state.options;
    ImGui::PushItemWidth(230);
    combo(ui, options, "backend", "--backend", {"vk", "gl"});
    drawTechnique(app, ui, options);
    if (!ui.editsOther) {
        int lights = std::atoi(options.get("--lights").c_str());
        if (ImGui::InputInt("added lights", &lights, 16, 256))
            options.set("--lights", std::to_string(std::clamp(lights, 0, 4000)));
    }
    ImGui::PopItemWidth();
    drawEffects(options);
    drawFlag(options, "check facts", "--check-facts");
    ImGui::SameLine(130);
    drawFlag(options, "plain facts", "--plain-facts");
    const std::string& report = (ui.editsOther ? app.shown().b : app.shown().a).figures.factReport;
    if (!report.empty())
        ImGui::TextWrapped("%s", report.c_str());
}

void drawOptions(App& app, Ui& ui) {
    chooseView(ui);
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search the options of agaa-harness render", &ui.search);
    ui.mark("search");
    OptionSet& options = ui.editsOther ? app.state.other : app.state.options;
    if (!ImGui::BeginTable("options", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg))
        return;
    ImGui::TableSetupColumn("option", ImGuiTableColumnFlags_WidthFixed, 190);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const OptionRow& row : optionRows()) {
        if (ui.editsOther && !row.isOfView)
            continue;
        if (!contains(row.name, ui.search) && !contains(row.description, ui.search))
            continue;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (options.has(row.name))
            ImGui::TextUnformatted(row.name.c_str());
        else
            ImGui::TextDisabled("%s", row.name.c_str());
        if (ImGui::IsItemHovered() && !row.description.empty())
            ImGui::SetTooltip("%s", row.description.c_str());
        ImGui::TableNextColumn();
        const bool fails = [&] {
            try {
                optionText(ui, options, row);
                return false;
            } catch (const std::exception&) {
                return true;
            }
        }();
        if (!fails)
            ui.mark(row.name);
    }
    ImGui::EndTable();
}

void drawGoal(App& app, Ui& ui) {
    Goal& goal = app.state.goal;
    ImGui::Checkbox("settings for a goal", &goal.isOn);
    ui.mark("goal");
    ImGui::TextWrapped(
        "The library chooses technique, tier, n, c and preset of view A within the limits. 0: no limit.");
    ImGui::PushItemWidth(150);
    const auto limit = [](const char* label, double& value, const char* format, double most) {
        double edited = value;
        if (ImGui::InputDouble(label, &edited, 0, 0, format, ImGuiInputTextFlags_EnterReturnsTrue))
            value = std::clamp(edited, 0.0, most);
    };
    limit("error, as a share of single's", goal.maxError, "%.3f", 1);
    ui.mark("goal error");
    limit("milliseconds", goal.maxMilliseconds, "%.1f", 1e9);
    limit("bytes", goal.maxBytes, "%.0f", 1e15);
    ImGui::PopItemWidth();
    ImGui::Checkbox("least error, not least time", &goal.prefersError);
    if (goal.isOn && !app.shown().reason.empty())
        ImGui::TextWrapped("%s", app.shown().reason.c_str());
}

} // namespace viewer
