#include "session_view.h"

#include "cli/render_options.h"
#include "render/fragment_capacity.h"

namespace viewer {

using namespace harness;

std::string keyOf(const OptionSet& options, const std::set<std::string>& names) {
    std::string text;
    for (const std::string& word : options.arguments())
        if (names.contains(word.substr(0, word.find('='))))
            text += word + '\n';
    return text;
}

std::string deviceKey(const OptionSet& options) {
    static const std::set<std::string> names = [] {
        DeviceArguments arguments;
        CLI::App app;
        addDeviceOptions(app, arguments);
        std::set<std::string> result;
        for (const CLI::Option* option : app.get_options())
            result.insert(option->get_name());
        return result;
    }();
    return keyOf(options, names);
}

namespace {

// Views of the SDK that a device keeps: plain, timed and counted frames of A and B, and the reference.
constexpr uint32_t keptViews = 8;

// An error that another device would have, too.
class SceneError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

Scene loaded(const RenderArguments& arguments) {
    try {
        return sceneOf(arguments);
    } catch (const BadArgument&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(error.what());
    }
}

} // namespace

RenderSession::RenderSession(RendererFactory factory) : factory_(std::move(factory)) {}
RenderSession::~RenderSession() = default;

std::shared_ptr<const Snapshot> RenderSession::step(const ViewRequest& request) {
    try {
        if (!request_ || !(*request_ == request)) {
            hasBegun_ = false;
            begin(request);
            hasBegun_ = true;
        } else if (hasFailed_) {
            return nullptr;
        }
        if (!advance())
            return nullptr;
    } catch (const BadArgument& error) {
        fail(error.what(), 2);
    } catch (const SceneError& error) {
        fail(error.what(), 1);
    } catch (const std::exception& error) {
        fail(error.what(), 1);
        state_.hasFailedDevice = true;
    }
    return std::make_shared<const Snapshot>(state_);
}

void RenderSession::fail(const char* error, int exitStatus) {
    hasFailed_ = true;
    state_.error = error;
    state_.exitStatus = exitStatus;
    if (hasBegun_)
        return;
    // The devices may have loaded another scene than that of these views.
    a_.reset();
    b_.reset();
}

void RenderSession::begin(const ViewRequest& request) {
    const std::optional<ViewRequest> before = std::exchange(request_, request);
    hasFailed_ = false;
    state_.error.clear();
    state_.exitStatus = 0;
    state_.hasFailedDevice = false;
    state_.isComplete = false;
    if (before && before->restarts != request.restarts)
        dropDevices();
    if (!before || !(before->goal == request.goal)) {
        choice_ = AGAA_CHOICE_INIT;
        observation_ = AGAA_OBSERVATION_INIT;
        state_.chosen.clear();
        state_.reason.clear();
    }
    const bool isOtherFrame = before && before->motionFrame != request.motionFrame;
    const OptionSet options = chosenOptions(request);
    if (!a_ || !(a_->options == options)) {
        std::unique_ptr<View> view = prepare(options);
        a_ = std::move(view);
        isAPending_ = true;
    }
    if (request.b && (!b_ || !(b_->options == *request.b))) {
        std::unique_ptr<View> view = prepare(*request.b);
        b_ = std::move(view);
        isBPending_ = true;
    }
    if (!request.b) {
        b_.reset();
        state_.b = ViewResult();
        isBPending_ = false;
    }
    isAPending_ |= isOtherFrame;
    isBPending_ |= isOtherFrame && b_;
    useReference(request);
    dropUnusedDevices();
    state_.isComplete = !isAPending_ && !isBPending_;
}

void RenderSession::dropDevices() {
    accumulation_.reset();
    referenceView_.reset();
    referenceKey_.clear();
    a_.reset();
    b_.reset();
    devices_.clear();
}

void RenderSession::dropUnusedDevices() {
    std::erase_if(devices_, [&](const auto& device) {
        const Renderer* renderer = device.second.renderer.get();
        return !(a_ && a_->renderer == renderer) && !(b_ && b_->renderer == renderer) &&
               !(referenceView_ && referenceView_->renderer == renderer);
    });
}

Renderer& RenderSession::rendererFor(const OptionSet& options, const DeviceArguments& arguments) {
    Device& device = devices_[deviceKey(options)];
    if (!device.renderer) {
        DeviceArguments kept = arguments;
        kept.keptViews = keptViews;
        device.renderer = factory_(kept);
    }
    if (device.sceneKey != sceneKey_) {
        device.sceneKey.clear();
        device.renderer->load(motion_ ? movingScene_ : stillScene_);
        device.sceneKey = sceneKey_;
    }
    return *device.renderer;
}

void RenderSession::useScene(const RenderArguments& arguments, RenderSettings& settings,
                             const Configuration& configuration) {
    std::string stillKey = arguments.scene + (arguments.environment.empty() ? "" : "\nlit by an environment");
    for (const std::string& coat : arguments.clearCoat)
        stillKey += "\n" + coat;
    if (stillKey_ != stillKey) {
        stillKey_.clear();
        sceneKey_.clear();
        stillScene_ = loaded(arguments);
        stillKey_ = stillKey;
    }
    std::string key = stillKey;
    if (arguments.motion != "still")
        key += "\n" + arguments.motion + "\n" + arguments.camera + "\n" + arguments.plan.size;
    const std::string environmentKey = arguments.environment + "\n" + arguments.shadingFunction;
    RenderArguments rest = arguments;
    const bool isKnown = environmentKey == environmentKey_;
    if (isKnown)
        rest.environment.clear(); // it takes seconds to filter
    settings = renderSettings(rest, configuration, stillScene_);
    if (isKnown)
        settings.environment = environment_;
    environment_ = settings.environment;
    environmentKey_ = environmentKey;
    if (sceneKey_ == key) {
        settings.motion = motion_;
        return;
    }
    sceneKey_.clear();
    motion_.reset();
    if (arguments.motion != "still") {
        movingScene_ = stillScene_;
        motion_ = settings.motion = sceneMotion(arguments.motion, movingScene_, settings);
    }
    sceneKey_ = key;
}

std::unique_ptr<RenderSession::View> RenderSession::prepare(const OptionSet& options) {
    const RenderArguments arguments = options.parse();
    auto view = std::make_unique<View>(options, arguments);
    requireBackend(arguments.device.backend);
    if (!arguments.camera.empty())
        parseCamera(arguments.camera); // fails before the scene is loaded
    useScene(arguments, view->settings, view->configuration);
    view->renderer = &rendererFor(options, arguments.device);
    if (view->configuration.fitsFragmentCapacity)
        fitFragmentCapacity(*view->renderer, view->settings);
    return view;
}

bool RenderSession::advance() {
    if (isAPending_) {
        renderImage(*a_, state_.a);
        isAPending_ = false;
        describe();
        if (request_->isPlaying && !request_->motionFrame)
            measure(*a_, state_.a, AGAA_CONFIG_TIMESTAMPS, 0);
        state_.isComplete = !isBPending_;
        if (state_.isComplete || !request_->isPlaying)
            return true;
    }
    if (isBPending_) {
        renderImage(*b_, state_.b);
        isBPending_ = false;
        state_.isComplete = true;
        return true;
    }
    if (areErrorsPending_) {
        updateErrors();
        return true;
    }
    if (request_->isPlaying)
        return false;
    bool hasMeasured = measureNext(*a_, state_.a);
    if (b_)
        hasMeasured |= measureNext(*b_, state_.b);
    return accumulate() || hasMeasured;
}

void RenderSession::describe() {
    state_.camera = a_->settings.camera;
    state_.cameras = stillScene_.cameras;
    state_.sceneSize = std::max(1e-6, glm::length(stillScene_.boundsMax - stillScene_.boundsMin));
    state_.notes = stillScene_.dropped;
    state_.device = a_->renderer->caps().deviceName;
    state_.driver = a_->renderer->caps().driverName;
    for (const ApiMessage& message : a_->renderer->takeMessages())
        state_.notes.push_back(message.id + ": " + message.text);
}

} // namespace viewer
