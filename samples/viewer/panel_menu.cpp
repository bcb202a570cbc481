#include "panels.h"

#include "scene/builtin.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace viewer {

namespace {

void drawScenes(App& app, const char* title, const std::vector<harness::BuiltinScene>& scenes) {
    if (!ImGui::BeginMenu(title))
        return;
    for (const harness::BuiltinScene& scene : scenes) {
        const std::string name(scene.name);
        if (ImGui::MenuItem(name.c_str(), nullptr, app.state.options.get("--scene") == name))
            app.selectScene(name);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", std::string(scene.stresses).c_str());
    }
    ImGui::EndMenu();
}

void drawCameras(App& app) {
    if (!ImGui::BeginMenu("Camera of the scene", !app.shown().cameras.empty()))
        return;
    for (size_t i = 0; i < app.shown().cameras.size(); ++i) {
        const harness::Camera& camera = app.shown().cameras[i];
        const std::string name = std::to_string(i + 1) + " " + camera.name;
        if (!ImGui::MenuItem(name.c_str()))
            continue;
        if (i == 0)
            app.resetCamera();
        else
            app.setCamera(camera);
    }
    ImGui::EndMenu();
}

// Asks for the path of a file, because Dear ImGui has no dialogue for files.
void askForFile(App& app, Ui& ui) {
    if (ui.asksForFile) {
        ui.file.clear();
        ImGui::OpenPopup("Open a file");
    }
    ui.asksForFile = false;
    if (!ImGui::BeginPopupModal("Open a file", nullptr, ImGuiWindowFlags_AlwaysAutoResize))
        return;
    ImGui::TextUnformatted("Path of a scene (.gltf, .glb), a state (.json) or an environment (.hdr, .exr).\n"
                           "A file can also be dropped on the window.");
    if (ImGui::IsWindowAppearing())
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(500);
    ImGui::InputText("##path", &ui.file);
    if (ImGui::IsItemActive())
        ui.mark("path");
    if ((ImGui::Button("Open") || ui.isEntered) && !ui.file.empty()) {
        app.open(ui.file);
        ImGui::CloseCurrentPopup();
    }
    ui.mark("open file");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void drawFileMenu(App& app, Ui& ui, Window& window) {
    if (!ImGui::BeginMenu("File"))
        return;
    if (ImGui::MenuItem("Open...", "Ctrl+O"))
        ui.asksForFile = true;
    drawScenes(app, "Built-in scene", harness::builtinScenes());
    drawScenes(app, "Numerically hard scene", harness::hardScenes());
    drawCameras(app);
    ImGui::Separator();
    if (ImGui::MenuItem("Save the state", "Ctrl+S"))
        app.saveState(ui.savedState);
    if (ImGui::MenuItem("Save the view as agaa-viewer.png", "F12"))
        app.saveScreenshot("agaa-viewer.png");
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q"))
        window.close();
    ImGui::EndMenu();
}

} // namespace

void drawMenu(App& app, Ui& ui, Window& window) {
    if (ImGui::BeginMainMenuBar()) {
        drawFileMenu(app, ui, window);
        if (ImGui::BeginMenu("View")) {
            ImGui::MenuItem("Panels", "H", &ui.showsPanels);
            ImGui::MenuItem("Magnifier", "M", &app.state.showsMagnifier);
            ImGui::MenuItem("Freeze the image", "F", &app.state.isFrozen);
            ImGui::MenuItem("Size follows the window", nullptr, &app.state.followsWindow);
            int size = int(app.state.texelSize);
            if (ImGui::SliderInt("window pixels per pixel", &size, 1, 8))
                app.state.texelSize = uint32_t(size);
            ImGui::EndMenu();
        }
        if (ImGui::MenuItem("Keys"))
            ui.showsHelp = !ui.showsHelp;
        const Snapshot& shown = app.shown();
        ImGui::TextDisabled("  %s  %s  %s%s", app.state.options.get("--scene").c_str(), shown.device.c_str(),
                            app.state.isFrozen ? "frozen  " : "", app.isSettled() ? "" : "rendering...");
        ImGui::EndMainMenuBar();
    }
    askForFile(app, ui);
}

void drawHelp(Ui& ui) {
    if (!ui.showsHelp)
        return;
    ImGui::SetNextWindowSize({520, 0});
    if (ImGui::Begin("Keys", &ui.showsHelp, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings))
        for (const auto& [key, meaning] :
             {std::pair{"left mouse button", "turn around the target, or look around while flying; move the line"},
              {"right or middle button", "move sideways"},
              {"wheel", "nearer and farther"},
              {"W A S D Q E", "move; Shift: four times as fast"},
              {"G", "fly, or turn around the target"},
              {"Home", "first camera of the scene"},
              {"1 2 3 4", "show A, B, both with a line, their difference"},
              {"Tab", "flip between A and B"},
              {"T, Shift+T", "next and previous technique"},
              {"F", "freeze the image"},
              {"M", "magnifier"},
              {"Space", "play frames: motion and accumulation continue"},
              {"R P L N", "camera path: record, play, loop, next"},
              {"H", "panels"},
              {"Ctrl+O Ctrl+S F12", "open a file, save the state, save the view"},
              {"Ctrl+Q", "quit"}}) {
            ImGui::TextUnformatted(key);
            ImGui::SameLine(170);
            ImGui::TextWrapped("%s", meaning);
        }
    ImGui::End();
}

} // namespace viewer
