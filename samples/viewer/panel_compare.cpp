// Two images beside each other, and the camera.
#include "panels.h"

#include <imgui.h>

#include <algorithm>

namespace viewer {

void drawCompare(App& app, Ui& ui) {
    ViewerState& state = app.state;
    int mode = int(state.mode);
    const char* labels[] = {"A", "B", "line", "difference"};
    for (int i = 0; i < 4; ++i) {
        if (i > 0)
            ImGui::SameLine();
        ImGui::RadioButton(labels[i], &mode, i);
        ui.mark(std::string("mode ") + nameOf(Mode(i)));
    }
    state.mode = Mode(mode);
    int other = int(state.compareWith);
    ImGui::RadioButton("B is a second configuration", &other, 0);
    ImGui::RadioButton("B is the reference", &other, 1);
    ui.mark("B is the reference");
    state.compareWith = Other(other);
    ImGui::Checkbox("accumulate the reference", &state.accumulatesReference);
    ui.mark("accumulate");
    ImGui::PushItemWidth(200);
    int samples = int(state.referenceSamples);
    if (ImGui::InputInt("samples per pixel", &samples, 64, 512))
        state.referenceSamples = uint32_t(std::clamp(samples, 2, 65536));
    float split = float(state.split), gain = float(state.gain);
    if (ImGui::SliderFloat("line", &split, 0, 1))
        state.split = double(split);
    if (ImGui::SliderFloat("gain", &gain, 1, 64, "%.1f", ImGuiSliderFlags_Logarithmic))
        state.gain = double(gain);
    ImGui::PopItemWidth();
    ImGui::Checkbox("magnifier", &state.showsMagnifier);
    ui.mark("magnifier");
    ImGui::Checkbox("freeze the image", &state.isFrozen);
    ui.mark("freeze");
}

void drawCamera(App& app, Ui& ui) {
    ViewerState& state = app.state;
    int flies = state.flies;
    ImGui::RadioButton("turn around the target", &flies, 0);
    ImGui::SameLine();
    ImGui::RadioButton("fly", &flies, 1);
    state.flies = flies == 1;
    const harness::Camera camera = app.camera();
    ImGui::Text("eye    %.3f %.3f %.3f", camera.eye.x, camera.eye.y, camera.eye.z);
    ImGui::Text("target %.3f %.3f %.3f", camera.target.x, camera.target.y, camera.target.z);
    float degrees = float(camera.fovDegrees);
    ImGui::SetNextItemWidth(200);
    if (ImGui::SliderFloat("field of view", &degrees, 5, 120, "%.0f degrees")) {
        harness::Camera wider = camera;
        wider.fovDegrees = double(degrees);
        app.setCamera(wider);
    }
    if (ImGui::Button("First camera of the scene"))
        app.resetCamera();
    ImGui::Separator();
    CameraPath& path = state.path;
    ImGui::Text("path: camera %zu of %zu", path.cameras.empty() ? 0 : std::min(path.position + 1, path.cameras.size()),
                path.cameras.size());
    if (ImGui::Button(path.isRecording ? "Stop recording" : "Record"))
        path.toggleRecording();
    ui.mark("record");
    ImGui::SameLine();
    if (ImGui::Button(path.isPlaying ? "Stop" : "Play"))
        path.togglePlaying();
    ui.mark("play");
    ImGui::SameLine();
    if (ImGui::Button("Next"))
        app.stepPath();
    ImGui::SameLine();
    ImGui::Checkbox("loop", &path.loops);
    ImGui::Separator();
    ImGui::Checkbox("play frames: motion and accumulation continue", &state.playsFrames);
    ui.mark("play frames");
}

} // namespace viewer
