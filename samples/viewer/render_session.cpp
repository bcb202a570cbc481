#include "render_session.h"

#include "cli/planned_view.h"
#include "cli/render_options.h"
#include "render/fragment_capacity.h"

#include <chrono>
#include <set>

namespace viewer {

using namespace harness;

// A view with the memory that its settings refer to.
struct RenderSession::View {
    View(const OptionSet& options, const RenderArguments& arguments)
        : options(options), arguments(arguments), configuration(arguments.plan) {}

    OptionSet options;
    RenderArguments arguments;
    Configuration configuration;
    RenderSettings settings;
    Renderer* renderer = nullptr;
};

namespace {

// Views of the SDK that a device keeps: plain, timed and counted frames of A and B, and the reference.
constexpr uint32_t keptViews = 8;

std::string textOf(const OptionSet& options, const std::set<std::string>& names) {
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
    return textOf(options, names);
}

// Two views of one key have the same reference.
std::string referenceKeyOf(const OptionSet& options) {
    std::set<std::string> names = {"--layout", "--brdf", "--without", "--plain-facts", "--filtered-shadows"};
    for (const OptionRow& row : optionRows())
        if (!row.isOfView)
            names.insert(row.name);
    return deviceKey(options) + textOf(options, names);
}

// An error that another device would have, too.
class SceneError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Returns nothing for images with values that are not finite.
std::optional<Metrics> errorOf(const Image& reference, const Image& image) {
    try {
        return compareImages(reference, image);
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

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
            begin(request);
        } else if (hasFailed_) {
            return nullptr;
        }
        if (!advance())
            return nullptr;
    } catch (const BadArgument& error) {
        hasFailed_ = true;
        state_.error = error.what();
        state_.exitStatus = 2;
    } catch (const SceneError& error) {
        hasFailed_ = true;
        state_.error = error.what();
        state_.exitStatus = 1;
    } catch (const std::exception& error) {
        hasFailed_ = true;
        state_.error = error.what();
        state_.exitStatus = 1;
        state_.hasFailedDevice = true;
    }
    return std::make_shared<const Snapshot>(state_);
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

OptionSet RenderSession::chosenOptions(const ViewRequest& request) {
    if (!request.goal.isOn)
        return request.a;
    const std::unique_ptr<View> view = prepare(request.a);
    const AgaaFetchFunction fetch = anyFetch(view->arguments.plan.unfetchedEvery == 0, false);
    AgaaViewDesc desc = viewOf(view->configuration, view->settings.facts, fetch, view->settings.reversedZ,
                               view->arguments.device.clipZFromMinusOne);
    desc.pNext = &fetch;
    const AgaaGoal goal = goalOf(request.goal.limits());
    Sdk sdk;
    sdk.check(agaaChooseSettings(&desc, &view->renderer->caps(), sdk.log(), &goal, &observation_, &choice_, &choice_));
    observation_ = AGAA_OBSERVATION_INIT;
    state_.chosen = optionsOf(choice_);
    state_.reason = choice_.reason;
    return withChoice(request.a, state_.chosen);
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

void RenderSession::renderImage(View& view, ViewResult& result) {
    RenderSettings settings = view.settings;
    if (request_->motionFrame) {
        settings.firstFrame = *request_->motionFrame;
        settings.frames = 1;
        settings.warmup = 0;
    }
    result.figures = Figures();
    const RenderResult rendered = view.renderer->render(settings);
    const AgaaFrameStatistics& last = rendered.statistics.back();
    Figures& figures = result.figures;
    figures.frameMs = rendered.frameMs.back();
    figures.memory = rendered.memory;
    figures.plan = rendered.plan;
    figures.payloadBytes = last.payloadBytes;
    figures.driverBytes = last.driverBytes;
    figures.peakBytes = last.peakBytes;
    figures.geometryPasses = last.geometryPasses;
    figures.factReport = rendered.facts ? rendered.facts->explanation : "";
    result.image = std::make_shared<const Image>(shownImage(rendered.image, settings.config));
    result.error.reset();
    areErrorsPending_ = state_.reference != nullptr;
    if (&view == a_.get())
        ++state_.frames;
}

void RenderSession::measure(View& view, ViewResult& result, uint64_t flag, uint32_t warmup) {
    RenderSettings settings = view.settings;
    settings.config.flags |= flag;
    settings.frames = 1;
    settings.warmup = warmup;
    const RenderResult rendered = view.renderer->render(settings);
    const AgaaFrameStatistics& last = rendered.statistics.back();
    if (flag == AGAA_CONFIG_COUNTERS) {
        result.figures.counters = last.counters;
    } else {
        result.figures.passes.clear();
        for (uint32_t i = 0; i < last.passCount; ++i)
            if (last.passes[i].isTimed)
                result.figures.passes.push_back(
                    {last.passes[i].name, agaaStageName(last.passes[i].stage), last.passes[i].milliseconds});
        ++result.figures.timedFrames;
        result.figures.frameMs = rendered.frameMs.back(); // the frame of the image compiled pipelines
    }
    if (&view == a_.get() && request_->goal.isOn)
        observe(last);
}

bool RenderSession::measureNext(View& view, ViewResult& result) {
    Figures& figures = result.figures;
    if (!figures.counters) {
        measure(view, result, AGAA_CONFIG_COUNTERS, 0);
        return true;
    }
    if (figures.timedFrames >= request_->measuredFrames)
        return false;
    measure(view, result, AGAA_CONFIG_TIMESTAMPS, figures.timedFrames == 0 ? 1 : 0); // the first compiles pipelines
    if (&view == a_.get())
        ++state_.frames;
    // Times of frames may change the choice of a goal. The library waits for 16 of them.
    if (&view == a_.get() && request_->goal.isOn && figures.timedFrames % 16 == 0)
        begin(ViewRequest(*request_));
    return true;
}

void RenderSession::observe(const AgaaFrameStatistics& statistics) {
    const AgaaFetchFunction fetch = anyFetch(a_->arguments.plan.unfetchedEvery == 0, false);
    const AgaaViewDesc desc = viewOf(a_->configuration, a_->settings.facts, fetch, a_->settings.reversedZ,
                                     a_->arguments.device.clipZFromMinusOne);
    Sdk sdk;
    sdk.check(agaaObserve(&desc, &a_->renderer->caps(), sdk.log(), &statistics, &observation_));
}

void RenderSession::useReference(const ViewRequest& request) {
    const std::string key =
        request.wantsReference ? referenceKeyOf(a_->options) + std::to_string(request.referenceSamples) : "";
    if (key == referenceKey_)
        return;
    accumulation_.reset();
    referenceView_.reset();
    state_.reference.reset();
    state_.referenceSamples = 0;
    state_.isReferenceDone = false;
    state_.a.error.reset();
    state_.b.error.reset();
    areErrorsPending_ = false;
    referenceKey_ = key;
    if (key.empty())
        return;
    referenceView_ = std::make_unique<View>(a_->options, a_->arguments);
    referenceView_->renderer = a_->renderer;
    RenderSettings& settings = referenceView_->settings = a_->settings;
    // The technique's settings do not change the reference.
    const TechniqueConfig& own = referenceView_->configuration.config;
    settings.config = TechniqueConfig();
    settings.config.layout = own.layout;
    settings.config.brdf = own.brdf;
    settings.config.flags = own.flags & AGAA_CONFIG_HDR_RESOLVE;
    settings.vertexPulling = settings.computesTriangles = false;
    accumulation_ = std::make_unique<ReferenceAccumulation>(settings, request.referenceSamples);
}

bool RenderSession::accumulate() {
    if (!accumulation_ || state_.isReferenceDone)
        return false;
    const auto start = std::chrono::steady_clock::now();
    do
        accumulation_->addSample(*referenceView_->renderer);
    while (accumulation_->done() < 2 || (accumulation_->done() < request_->referenceSamples &&
                                         std::chrono::steady_clock::now() - start < std::chrono::milliseconds(250)));
    const Reference reference = accumulation_->result();
    state_.reference = std::make_shared<const Image>(reference.image);
    state_.referenceSamples = accumulation_->done();
    state_.referenceError = reference.splitHalfMseTm;
    state_.isReferenceDone = accumulation_->done() >= request_->referenceSamples;
    updateErrors();
    return true;
}

void RenderSession::updateErrors() {
    areErrorsPending_ = false;
    for (ViewResult* result : {&state_.a, &state_.b}) {
        const View* view = result == &state_.a ? a_.get() : b_.get();
        result->error.reset();
        if (view && result->image && state_.reference && state_.reference->width == result->image->width &&
            state_.reference->height == result->image->height &&
            view->configuration.config.measurement.debugView == AGAA_DEBUG_VIEW_NONE)
            result->error = errorOf(*state_.reference, *result->image);
    }
}

} // namespace viewer
