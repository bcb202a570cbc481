#include "panels.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace viewer {

namespace {

void handleControlKey(App& app, Ui& ui, Window& window, int key) {
    if (key == GLFW_KEY_S)
        app.saveState(ui.savedState);
    else if (key == GLFW_KEY_O)
        ui.asksForFile = true;
    else if (key == GLFW_KEY_Q)
        window.close();
}

void handleKey(App& app, Ui& ui, const KeyPress& press) {
    ViewerState& state = app.state;
    switch (press.key) {
    case GLFW_KEY_1:
    case GLFW_KEY_2:
    case GLFW_KEY_3:
    case GLFW_KEY_4:
        state.mode = Mode(press.key - GLFW_KEY_1);
        break;
    case GLFW_KEY_TAB:
        app.flip();
        break;
    case GLFW_KEY_T:
        app.cycleTechnique(press.modifiers & GLFW_MOD_SHIFT ? -1 : 1);
        break;
    case GLFW_KEY_F:
        state.isFrozen = !state.isFrozen;
        break;
    case GLFW_KEY_M:
        state.showsMagnifier = !state.showsMagnifier;
        break;
    case GLFW_KEY_G:
        state.flies = !state.flies;
        break;
    case GLFW_KEY_HOME:
        app.resetCamera();
        break;
    case GLFW_KEY_SPACE:
        state.playsFrames = !state.playsFrames;
        break;
    case GLFW_KEY_R:
        state.path.toggleRecording();
        break;
    case GLFW_KEY_P:
        state.path.togglePlaying();
        break;
    case GLFW_KEY_L:
        state.path.loops = !state.path.loops;
        break;
    case GLFW_KEY_N:
        app.stepPath();
        break;
    case GLFW_KEY_H:
        ui.showsPanels = !ui.showsPanels;
        break;
    case GLFW_KEY_F12:
        app.saveScreenshot("agaa-viewer.png");
        break;
    default:
        break;
    }
}

glm::dvec3 heldDirection(const Window& window) {
    const auto held = [&](int key) { return window.isHeld(key) ? 1.0 : 0.0; };
    return {held(GLFW_KEY_D) - held(GLFW_KEY_A), held(GLFW_KEY_E) - held(GLFW_KEY_Q),
            held(GLFW_KEY_W) - held(GLFW_KEY_S)};
}

bool hasControl(const Window& window) {
    return window.isHeld(GLFW_KEY_LEFT_CONTROL) || window.isHeld(GLFW_KEY_RIGHT_CONTROL);
}

} // namespace

bool movesByKeys(const App& app, const Window& window) {
    return !ImGui::GetIO().WantTextInput && !hasControl(window) && app.imageA() &&
           heldDirection(window) != glm::dvec3(0);
}

void handleKeys(App& app, Ui& ui, Window& window, float seconds) {
    const std::vector<KeyPress> presses = window.takeKeys();
    // A dialogue's text field takes keys a frame after it appears, and misses keys that are shorter than a frame.
    ui.isEntered = false;
    for (const KeyPress& press : presses)
        ui.isEntered |= press.key == GLFW_KEY_ENTER || press.key == GLFW_KEY_KP_ENTER;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        return;
    for (const KeyPress& press : presses)
        if (press.modifiers & GLFW_MOD_CONTROL)
            handleControlKey(app, ui, window, press.key);
        else if (!ImGui::GetIO().WantTextInput)
            handleKey(app, ui, press);
    if (!movesByKeys(app, window))
        return;
    const bool isFast = window.isHeld(GLFW_KEY_LEFT_SHIFT) || window.isHeld(GLFW_KEY_RIGHT_SHIFT);
    const double speed = 0.1 * app.shown().sceneSize * (isFast ? 4 : 1); // units of the scene per second
    app.setCamera(moved(app.camera(), speed * double(std::min(seconds, 0.1f)) * heldDirection(window)));
}

} // namespace viewer
