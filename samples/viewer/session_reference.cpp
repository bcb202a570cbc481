// The reference of a session, and errors against it.
#include "session_view.h"

#include <chrono>

namespace viewer {

using namespace harness;

namespace {

// Two views of one key have the same reference.
std::string referenceKeyOf(const OptionSet& options) {
    std::set<std::string> names = {"--layout", "--brdf", "--without", "--plain-facts", "--filtered-shadows"};
    for (const OptionRow& row : optionRows())
        if (!row.isOfView)
            names.insert(row.name);
    return deviceKey(options) + keyOf(options, names);
}

// Returns nothing for images with values that are not finite.
std::optional<Metrics> errorOf(const Image& reference, const Image& image) {
    try {
        return compareImages(reference, image);
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

} // namespace

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
