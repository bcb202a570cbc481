#include "trace.h"

#include <imgui.h>

#include <filesystem>
#include <fstream>

namespace viewer {

void Trace::write(const App& app, const Ui& ui) {
    if (path_.empty())
        return;
    const ImGuiIO& io = ImGui::GetIO();
    const nlohmann::json content = {
        {"state", app.state.toJson()},   {"places", ui.places},
        {"frames", app.shown().frames},  {"settled", app.isSettled()},
        {"error", app.error()},          {"imageSize", {app.width(), app.height()}},
        {"version", app.version()},      {"file", ui.file},
        {"search", ui.search},           {"mouse", {int(io.MousePos.x), int(io.MousePos.y)}},
        {"isMouseDown", io.MouseDown[0]}};
    const std::string text = content.dump(1);
    if (text == newest_)
        return;
    newest_ = text;
    const std::string part = path_ + ".part";
    std::ofstream(part, std::ios::trunc) << text;
    std::error_code ignored; // a test that misses the file reports it
    std::filesystem::rename(part, path_, ignored);
}

} // namespace viewer
