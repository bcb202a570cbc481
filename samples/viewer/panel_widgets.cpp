#include "panels.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace viewer {

void Ui::mark(const std::string& name) {
    const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
    places[name] = {int((least.x + most.x) / 2), int((least.y + most.y) / 2)};
}

void optionText(Ui& ui, OptionSet& options, const OptionRow& row) {
    const std::string label = "##" + row.name;
    if (row.isFlag) {
        bool on = options.has(row.name);
        if (ImGui::Checkbox(label.c_str(), &on))
            options.setFlag(row.name, on);
        return;
    }
    std::string joined;
    for (const std::string& value : options.all(row.name))
        joined += (joined.empty() ? "" : " ") + value;
    const auto edited = ui.edited.find(row.name);
    std::string text = edited == ui.edited.end() ? joined : edited->second;
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint(label.c_str(), row.fallback.c_str(), &text);
    if (ImGui::IsItemActive()) {
        ui.edited[row.name] = text;
        return;
    }
    if (edited == ui.edited.end())
        return;
    text = edited->second;
    ui.edited.erase(edited);
    std::vector<std::string> values;
    if (row.isRepeatable) {
        for (size_t begin = text.find_first_not_of(' '); begin != std::string::npos;) {
            const size_t end = std::min(text.find(' ', begin), text.size());
            values.push_back(text.substr(begin, end - begin));
            begin = text.find_first_not_of(' ', end);
        }
    } else if (!text.empty()) {
        values.push_back(text);
    }
    options.setAll(row.name, values);
}

bool optionCombo(Ui& ui, const char* label, const std::string& current, const std::vector<std::string>& names,
                 std::string& chosen) {
    bool isChosen = false;
    const bool isOpen = ImGui::BeginCombo(label, current.c_str());
    ui.mark(label);
    if (!isOpen)
        return false;
    for (const std::string& name : names) {
        if (ImGui::Selectable(name.empty() ? "(none)" : name.c_str(), name == current)) {
            chosen = name;
            isChosen = true;
        }
        ui.mark(std::string(label) + ":" + name);
    }
    ImGui::EndCombo();
    return isChosen;
}

} // namespace viewer
