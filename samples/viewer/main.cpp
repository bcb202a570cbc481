// agaa-viewer: scenes, techniques and their errors in a window.
#include "cli/program.h"
#include "panels.h"
#include "trace.h"
#include "view_texture.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

using namespace viewer;

namespace {

class Program {
public:
    explicit Program(const ViewerArguments& arguments)
        : arguments_(arguments), window_(arguments.window.width, arguments.window.height),
          app_(initialState(arguments), Window::wake), texture_(window_.gl()), trace_(arguments.trace) {
        ui_.savedState = arguments.savedState;
        app_.setMeasuredFrames(std::max<uint64_t>(30, arguments.frames));
    }

    void run() {
        while (!window_.isClosed()) {
            drawFrame();
            if (arguments_.frames > 0 && hasEnded())
                return;
        }
        if (arguments_.frames > 0)
            throw std::runtime_error("The window was closed before the frames were rendered.");
        finish();
    }

private:
    void drawFrame() {
        window_.beginFrame(moves());
        for (const std::string& file : window_.takeDroppedFiles())
            app_.open(file);
        handleKeys(app_, ui_, window_, ImGui::GetIO().DeltaTime);
        ui_.places.clear();
        if (window_.hasPixels())
            drawPanels();
        else
            app_.setViewSize(0, 0);
        app_.update();
        texture_.update(app_.width(), app_.height(), app_.pixels(), app_.version());
        window_.endFrame();
        trace_.write(app_, ui_);
        window_.present();
    }

    void drawPanels() {
        drawMenu(app_, ui_, window_);
        const float top = ImGui::GetFrameHeight();
        if (ui_.showsPanels)
            drawSidePanel(app_, ui_, top);
        drawView(app_, ui_, texture_.id(), ui_.showsPanels ? panelWidth : 0, top);
        drawHelp(ui_);
    }

    bool moves() const { return movesByKeys(app_, window_) || ImGui::IsAnyMouseDown(); }

    // Returns whether a script's frames are rendered and its files written.
    bool hasEnded() {
        if (!app_.error().empty()) {
            if (app_.shown().exitStatus == 2)
                throw harness::BadArgument(app_.error());
            throw std::runtime_error(app_.error());
        }
        const bool hasFrames = app_.shown().frames >= arguments_.frames || app_.state.isFrozen;
        // Frames that play are followed by others, so that the view never settles.
        const bool isPlaying = (app_.state.playsFrames || app_.state.path.isPlaying) && !app_.state.isFrozen;
        const bool isShown = isPlaying ? app_.imageA() && app_.shown().isComplete : app_.isSettled();
        if (!hasFrames || !isShown)
            return false;
        finish();
        return true;
    }

    void finish() {
        if (!arguments_.screenshot.empty())
            harness::writePng(arguments_.screenshot, app_.width(), app_.height(), app_.pixels());
        if (!arguments_.windowScreenshot.empty())
            writeWindow();
        if (arguments_.savesState)
            writeState(arguments_.savedState, app_.state);
    }

    void writeWindow() {
        for (int i = 0; i < 3; ++i) // panels take some frames to settle
            drawFrame();
        window_.endFrame();
        uint32_t width = 0, height = 0;
        const std::vector<harness::Pixel> pixels = window_.read(width, height);
        harness::writePng(arguments_.windowScreenshot, width, height, pixels);
    }

    const ViewerArguments& arguments_;
    Window window_;
    App app_; // its thread ends before the window is destroyed
    ViewTexture texture_;
    Trace trace_;
    Ui ui_;
};

} // namespace

int main(int argc, char** argv) {
    return harness::runProgram("agaa-viewer", [=] {
        if (const std::optional<ViewerArguments> arguments = parseViewerArguments(argc, argv))
            Program(*arguments).run();
    });
}
