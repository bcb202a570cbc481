// The viewer without its window: the state, the results that are shown, and the actions of keys, menus and panels.
#pragma once

#include "camera_control.h"
#include "compose.h"
#include "render_thread.h"

namespace viewer {

class App {
public:
    // wake: called by another thread when there is something to show.
    App(ViewerState initial, std::function<void()> wake, RendererFactory factory = harness::makeRenderer);

    ViewerState state; // panels change it; the next update() renders it

    // Must be called before update() whenever the window's view has another size in pixels; 0: nothing is rendered.
    void setViewSize(uint32_t width, uint32_t height);
    // Takes new results, advances what plays, and requests what the state asks for.
    void update();

    const Snapshot& shown() const { return *shown_; }
    const harness::Image* imageA() const { return shown_->a.image.get(); }
    // Returns the image B or the reference; null: none yet.
    const harness::Image* imageB() const;
    // Pixels of the view. The version changes with them.
    const std::vector<harness::Pixel>& pixels() const { return pixels_; }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    uint64_t version() const { return version_; }
    const FrameHistory& historyA() const { return historyA_; }
    const FrameHistory& historyB() const { return historyB_; }
    // Returns whether the images of the present state are shown, and its reference is done if it wants one.
    bool isSettled() const;
    // Returns the error of the newest action or of rendering; empty: none.
    const std::string& error() const { return actionError_.empty() ? shown_->error : actionError_; }
    const std::string& notice() const { return notice_; }
    void dismiss();
    void setMeasuredFrames(uint64_t count) { measuredFrames_ = count; }

    // Actions. Errors are sentences of error().
    void run(const std::function<void()>& action);
    void open(const std::string& path); // a scene, an environment or a state, by its name
    void selectScene(const std::string& nameOrPath);
    void selectTechnique(const std::string& name);
    void cycleTechnique(int step);
    void flip();
    void stepPath();
    void restart(); // drops all devices
    harness::Camera camera() const;
    void setCamera(const harness::Camera& camera);
    void resetCamera() { state.options.erase("--camera"); }
    void saveState(const std::string& path);
    void saveScreenshot(const std::string& path);

private:
    void takeSnapshot();
    void advancePlaying();
    ViewRequest request() const;
    void compose();

    RenderThread thread_;
    std::shared_ptr<const Snapshot> shown_ = std::make_shared<const Snapshot>();
    std::optional<ViewRequest> requested_;
    uint64_t serial_ = 0;         // of requested_
    uint64_t advancedSerial_ = 0; // of the request after which a playing path was advanced
    uint32_t viewWidth_ = 0, viewHeight_ = 0;
    std::optional<uint32_t> motionFrame_;
    uint32_t restarts_ = 0;
    uint64_t measuredFrames_ = 30;
    FrameHistory historyA_, historyB_;

    std::vector<harness::Pixel> pixels_;
    uint32_t width_ = 0, height_ = 0;
    uint64_t version_ = 0;
    std::shared_ptr<const Snapshot> composedSnapshot_;
    ViewerState composedState_;
    std::string actionError_, notice_;
};

// Returns names of the library, for example its techniques. kind: AGAA_NAMES_….
std::vector<std::string> libraryNames(AgaaNameKind kind);

// Set options that exclude others, which are erased.
void setTechnique(OptionSet& options, const std::string& name);
void setPreset(OptionSet& options, const std::string& name); // empty: none

} // namespace viewer
