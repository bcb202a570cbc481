#include "app.h"

#include "scene/gltf.h"

#include <algorithm>
#include <filesystem>

namespace viewer {

using harness::Camera;

std::vector<std::string> libraryNames(AgaaNameKind kind) {
    uint32_t count = 0;
    agaaGetNames(kind, &count, nullptr);
    std::vector<const char*> names(count);
    agaaGetNames(kind, &count, names.data());
    return {names.begin(), names.end()};
}

void setTechnique(OptionSet& options, const std::string& name) {
    options.erase("--preset");
    options.set("--technique", name);
}

void setPreset(OptionSet& options, const std::string& name) {
    const std::string samples = options.get("--samples");
    const std::vector<std::string> tiers = options.all("--tier");
    if (name.empty()) {
        options.erase("--preset");
        return;
    }
    options = withChoice(std::move(options), {"--preset", name, "--samples", samples});
    options.setAll("--tier", tiers);
}

App::App(ViewerState initial, std::function<void()> wake, RendererFactory factory)
    : state(std::move(initial)), thread_(std::move(wake), std::move(factory)) {}

void App::setViewSize(uint32_t width, uint32_t height) {
    viewWidth_ = width;
    viewHeight_ = height;
}

void App::update() {
    takeSnapshot();
    advancePlaying();
    const uint32_t width = viewWidth_ / state.texelSize, height = viewHeight_ / state.texelSize;
    const bool isVisible = viewWidth_ > 0 && viewHeight_ > 0;
    if (state.followsWindow && width > 0 && height > 0)
        state.options.set("--size", std::to_string(width) + "x" + std::to_string(height));
    const bool hasSize = !state.followsWindow || (width > 0 && height > 0);
    if (state.path.isRecording && shown_->a.image)
        state.path.record(cameraText(camera()));
    const bool isFrozen = state.isFrozen && shown_->a.image;
    if (isVisible && hasSize && !isFrozen) {
        ViewRequest wanted = request();
        if (!requested_ || !(*requested_ == wanted)) {
            requested_ = wanted;
            serial_ = thread_.request(std::move(wanted));
        }
    }
    compose();
}

ViewRequest App::request() const {
    ViewRequest wanted;
    wanted.a = state.options;
    if (state.needsOtherView())
        wanted.b = state.otherOptions();
    wanted.wantsReference = state.needsReference();
    wanted.referenceSamples = state.referenceSamples;
    wanted.isPlaying = state.playsFrames || state.path.isPlaying;
    wanted.motionFrame = state.playsFrames ? std::optional(motionFrame_.value_or(0)) : std::nullopt;
    wanted.measuredFrames = measuredFrames_;
    wanted.goal = state.goal;
    wanted.restarts = restarts_;
    return wanted;
}

void App::takeSnapshot() {
    std::shared_ptr<const Snapshot> newest = thread_.newest();
    if (!newest || newest == shown_)
        return;
    const auto keep = [](FrameHistory& history, const ViewResult& before, const ViewResult& after) {
        if (after.figures.timedFrames > 0 &&
            (after.figures.timedFrames != before.figures.timedFrames || after.image != before.image))
            history.add(after.figures.passes);
    };
    keep(historyA_, shown_->a, newest->a);
    keep(historyB_, shown_->b, newest->b);
    if (state.goal.isOn && !newest->chosen.empty() && newest->serial == serial_)
        state.options = withChoice(state.options, newest->chosen);
    shown_ = std::move(newest);
}

// Each frame of a path or of a motion is shown once.
void App::advancePlaying() {
    if (!state.playsFrames)
        motionFrame_.reset();
    if (state.isFrozen || advancedSerial_ == serial_ || shown_->serial != serial_ || !shown_->isComplete)
        return;
    if (!state.playsFrames && !state.path.isPlaying)
        return;
    advancedSerial_ = serial_;
    if (state.playsFrames)
        motionFrame_ = requested_->motionFrame ? *requested_->motionFrame + 1 : 0;
    if (state.path.isPlaying)
        stepPath();
}

bool App::isSettled() const {
    if (!shown_->a.image || shown_->serial != serial_ || !shown_->isComplete)
        return false;
    if (!state.isFrozen && (!requested_ || !(*requested_ == request())))
        return false;
    return !state.needsReference() || shown_->isReferenceDone;
}

const harness::Image* App::imageB() const {
    return state.compareWith == Other::Reference ? shown_->reference.get() : shown_->b.image.get();
}

void App::compose() {
    if (!shown_->a.image)
        return;
    const bool isSame = composedSnapshot_ == shown_ && composedState_.mode == state.mode &&
                        composedState_.compareWith == state.compareWith && composedState_.split == state.split &&
                        composedState_.gain == state.gain;
    if (isSame)
        return;
    pixels_ = composed(*shown_->a.image, imageB(), state);
    width_ = shown_->a.image->width;
    height_ = shown_->a.image->height;
    composedSnapshot_ = shown_;
    composedState_ = state;
    ++version_;
}

void App::dismiss() {
    actionError_.clear();
    notice_.clear();
}

void App::run(const std::function<void()>& action) {
    dismiss();
    try {
        action();
    } catch (const std::exception& error) {
        actionError_ = error.what();
    }
}

void App::open(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (extension == ".json")
        run([&] { state = readState(path); });
    else if (extension == ".hdr" || extension == ".exr")
        run([&] { state.options.set("--environment", path); });
    else
        selectScene(path);
}

void App::selectScene(const std::string& nameOrPath) {
    dismiss();
    state.options.set("--scene", nameOrPath);
    for (const char* ofScene : {"--camera", "--clear-coat"})
        state.options.erase(ofScene);
    state.path = CameraPath();
}

void App::selectTechnique(const std::string& name) {
    state.goal.isOn = false;
    setTechnique(state.options, name);
}

void App::cycleTechnique(int step) {
    const std::vector<std::string> names = libraryNames(AGAA_NAMES_TECHNIQUES);
    const auto found = std::find(names.begin(), names.end(), state.options.get("--technique"));
    const ptrdiff_t count = ptrdiff_t(names.size());
    const ptrdiff_t index = found == names.end() ? 0 : found - names.begin() + step;
    selectTechnique(names[size_t((index + count) % count)]);
}

void App::flip() { state.mode = state.mode == Mode::B ? Mode::A : Mode::B; }

void App::stepPath() {
    if (const std::optional<std::string> next = state.path.next())
        state.options.set("--camera", *next);
}

void App::restart() {
    dismiss();
    ++restarts_;
}

Camera App::camera() const {
    const std::string text = state.options.get("--camera");
    try {
        return text.empty() ? shown_->camera : harness::parseCamera(text);
    } catch (const harness::BadArgument&) {
        return shown_->camera;
    }
}

void App::setCamera(const Camera& camera) { state.options.set("--camera", cameraText(camera)); }

void App::saveState(const std::string& path) {
    run([&] {
        writeState(path, state);
        notice_ = "The state is saved as " + path + ".";
    });
}

void App::saveScreenshot(const std::string& path) {
    run([&] {
        harness::writePng(path, width_, height_, pixels_);
        notice_ = "The view is saved as " + path + ".";
    });
}

} // namespace viewer
