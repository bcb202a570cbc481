// The image, the mouse over it, the line of a split view, the magnifier and errors.
#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace viewer {

namespace {

// The rectangle of the image in the window, in the units of Dear ImGui.
struct Placement {
    ImVec2 origin;
    float perPixel = 1; // units of one pixel of the image
};

Placement placed(const App& app, ImVec2 origin, ImVec2 room) {
    Placement p;
    p.perPixel = float(app.state.texelSize) / ImGui::GetIO().DisplayFramebufferScale.x;
    const float width = float(app.width()) * p.perPixel, height = float(app.height()) * p.perPixel;
    // Whole units, so that each pixel of the image covers whole pixels of the window.
    p.origin = {origin.x + std::floor(std::max(0.0f, room.x - width) / 2),
                origin.y + std::floor(std::max(0.0f, room.y - height) / 2)};
    return p;
}

void drawSplit(App& app, Ui& ui, const Placement& p, bool isHovered) {
    const float x = p.origin.x + float(splitColumn(app.width(), app.state.split)) * p.perPixel;
    const float bottom = p.origin.y + float(app.height()) * p.perPixel;
    ImGui::GetWindowDrawList()->AddLine({x, p.origin.y}, {x, bottom}, IM_COL32(255, 220, 0, 160));
    ui.places["split line"] = {int(x), int((p.origin.y + bottom) / 2)};
    const float mouse = ImGui::GetIO().MousePos.x;
    const bool isNear = isHovered && std::fabs(mouse - x) < 6;
    if (isNear)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (isNear && ImGui::IsMouseClicked(0))
        ui.draggedSplit = true;
    if (!ImGui::IsMouseDown(0))
        ui.draggedSplit = false;
    if (ui.draggedSplit && app.width() > 0)
        app.state.split = std::clamp(double((mouse - p.origin.x) / (p.perPixel * float(app.width()))), 0.0, 1.0);
}

void moveCamera(App& app, const Ui& ui, bool isHovered, bool isHeld) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    const double x = double(io.MouseDelta.x), y = double(io.MouseDelta.y);
    if (isHeld && moves && ImGui::IsMouseDown(0) && !ui.draggedSplit) {
        constexpr double radians = 0.006; // per pixel of the mouse
        app.setCamera(app.state.flies ? turned(app.camera(), -radians * x, -radians * y)
                                      : orbited(app.camera(), -radians * x, radians * y));
    } else if (isHeld && moves) {
        const harness::Camera camera = app.camera();
        const double scale = 0.0015 * glm::length(camera.target - camera.eye);
        app.setCamera(moved(camera, {-scale * x, scale * y, 0}));
    }
    if (isHovered && io.MouseWheel != 0) {
        const double factor = std::pow(0.88, double(io.MouseWheel));
        const harness::Camera camera = app.camera();
        app.setCamera(app.state.flies ? moved(camera, {0, 0, (1 - factor) * glm::length(camera.target - camera.eye)})
                                      : zoomed(camera, factor));
    }
}

void drawError(App& app, Ui& ui, float left, float top, float width) {
    if (app.error().empty() && app.notice().empty())
        return;
    ImGui::SetNextWindowPos({left + 10, top + 10});
    ImGui::SetNextWindowSize({std::max(width - 20, 200.0f), 0});
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    if (!app.error().empty())
        ImGui::TextWrapped("%s", app.error().c_str());
    if (!app.notice().empty())
        ImGui::TextWrapped("%s", app.notice().c_str());
    if (app.shown().hasFailedDevice) {
        if (ImGui::Button("Start again"))
            app.restart();
        ui.mark("start again");
    }
    if (app.error() != app.shown().error || !app.notice().empty()) {
        if (ImGui::Button("Close"))
            app.dismiss();
        ui.mark("close message");
    }
    ImGui::End();
}

} // namespace

void drawMagnifier(const App& app, uint32_t x, uint32_t y) {
    constexpr int radius = 5; // pixels around the middle one
    constexpr float cell = 14;
    ImGui::BeginTooltip();
    const auto draw = [&](const char* name, const harness::Image& image) {
        if (image.width != app.width() || image.height != app.height())
            return;
        const float* linear = &image.rgb[3 * (size_t(y) * image.width + x)];
        harness::Image around{2 * radius + 1, 2 * radius + 1, {}};
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                const size_t column = size_t(std::clamp(int(x) + dx, 0, int(image.width) - 1));
                const size_t row = size_t(std::clamp(int(y) + dy, 0, int(image.height) - 1));
                const float* rgb = &image.rgb[3 * (row * image.width + column)];
                around.rgb.insert(around.rgb.end(), rgb, rgb + 3);
            }
        const std::vector<harness::Pixel> pixels = displayPixels(around);
        const harness::Pixel& middle = pixels[pixels.size() / 2];
        ImGui::BeginGroup();
        ImGui::TextUnformatted(name);
        const ImVec2 origin = ImGui::GetCursorScreenPos();
        ImDrawList* list = ImGui::GetWindowDrawList();
        for (size_t i = 0; i < pixels.size(); ++i) {
            const ImVec2 corner = {origin.x + cell * float(i % around.width),
                                   origin.y + cell * float(i / around.width)};
            list->AddRectFilled(corner, {corner.x + cell, corner.y + cell},
                                IM_COL32(pixels[i][0], pixels[i][1], pixels[i][2], 255));
        }
        const ImVec2 corner = {origin.x + cell * radius, origin.y + cell * radius};
        list->AddRect(corner, {corner.x + cell, corner.y + cell}, IM_COL32(255, 220, 0, 255));
        ImGui::Dummy({cell * float(around.width), cell * float(around.height)});
        ImGui::Text("linear %.4f %.4f %.4f", double(linear[0]), double(linear[1]), double(linear[2]));
        ImGui::Text("8 bits %d %d %d", middle[0], middle[1], middle[2]);
        ImGui::EndGroup();
    };
    ImGui::Text("pixel %u, %u", x, y);
    if (app.imageA())
        draw("A", *app.imageA());
    if (const harness::Image* b = app.imageB()) {
        ImGui::SameLine();
        draw(app.state.compareWith == Other::Reference ? "reference" : "B", *b);
    }
    ImGui::EndTooltip();
}

void drawView(App& app, Ui& ui, void* texture, float left, float top) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 room = {std::max(0.0f, io.DisplaySize.x - left), std::max(0.0f, io.DisplaySize.y - top)};
    app.setViewSize(uint32_t(room.x * io.DisplayFramebufferScale.x), uint32_t(room.y * io.DisplayFramebufferScale.y));
    if (room.x < 1 || room.y < 1)
        return;
    ImGui::SetNextWindowPos({left, top});
    ImGui::SetNextWindowSize(room);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("view", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("image", room,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    const bool isHovered = ImGui::IsItemHovered(), isHeld = ImGui::IsItemActive();
    ui.mark("view");
    if (app.width() > 0) {
        const Placement p = placed(app, {left, top}, room);
        const ImVec2 end = {p.origin.x + float(app.width()) * p.perPixel,
                            p.origin.y + float(app.height()) * p.perPixel};
        ImGui::GetWindowDrawList()->AddImage(texture, p.origin, end);
        if (app.state.mode == Mode::Split)
            drawSplit(app, ui, p, isHovered);
        moveCamera(app, ui, isHovered, isHeld);
        const ImVec2 pixel = {(io.MousePos.x - p.origin.x) / p.perPixel, (io.MousePos.y - p.origin.y) / p.perPixel};
        const bool isInside =
            pixel.x >= 0 && pixel.y >= 0 && pixel.x < float(app.width()) && pixel.y < float(app.height());
        if (app.state.showsMagnifier && isHovered && isInside)
            drawMagnifier(app, uint32_t(pixel.x), uint32_t(pixel.y));
    }
    ImGui::End();
    drawError(app, ui, left, top, room.x);
}

} // namespace viewer
