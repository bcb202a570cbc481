#include "panels.h"

#include <imgui.h>

namespace viewer {

void drawSidePanel(App& app, Ui& ui, float top) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, top});
    ImGui::SetNextWindowSize({panelWidth, std::max(size.y - top, 1.0f)});
    const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("settings", nullptr, fixed)) {
        ImGui::BeginChild("tabs", {0, 390});
        if (ImGui::BeginTabBar("tab bar")) {
            const auto tab = [&](const char* name, auto draw) {
                const bool isOpen = ImGui::BeginTabItem(name);
                ui.mark(name);
                if (!isOpen)
                    return;
                draw(app, ui);
                ImGui::EndTabItem();
            };
            tab("Settings", drawSettings);
            tab("Compare", drawCompare);
            tab("Camera", drawCamera);
            tab("Goal", drawGoal);
            tab("All options", drawOptions);
            ImGui::EndTabBar();
        }
        ImGui::EndChild();
        ImGui::Separator();
        ImGui::BeginChild("figures");
        drawFigures(app);
        ImGui::EndChild();
    }
    ImGui::End();
}

} // namespace viewer
