// Renders requests of the viewer step by step. All calls must come from one thread, because an OpenGL context belongs
// to it.
#pragma once

#include "render/reference.h"
#include "snapshot.h"
#include "viewer_state.h"

#include <functional>
#include <map>

namespace viewer {

// The images and figures that the window wants.
struct ViewRequest {
    OptionSet a;
    std::optional<OptionSet> b;
    bool wantsReference = false;
    uint32_t referenceSamples = 64;
    std::optional<uint32_t> motionFrame; // of a motion that plays; empty: --frames of the options decide
    bool isPlaying = false;              // one step renders everything, and no further frames are measured
    uint64_t measuredFrames = 30;        // after which a still view rests
    Goal goal;
    uint32_t restarts = 0; // another number drops all devices

    bool operator==(const ViewRequest&) const = default;
};

using RendererFactory = std::function<std::unique_ptr<harness::Renderer>(const harness::DeviceArguments&)>;

class RenderSession {
public:
    explicit RenderSession(RendererFactory factory = harness::makeRenderer);
    ~RenderSession();

    // Renders the next image, measured frame or part of the reference. Returns null if nothing is left to do. Errors
    // are in the snapshot; the request is then not tried again.
    std::shared_ptr<const Snapshot> step(const ViewRequest& request);

private:
    struct View;
    struct Device {
        std::unique_ptr<harness::Renderer> renderer;
        std::string sceneKey; // of the loaded scene
    };

    void begin(const ViewRequest& request);
    void fail(const char* error, int exitStatus);
    void dropDevices();
    void dropUnusedDevices();
    bool advance(); // returns false if nothing is left to do
    void describe();
    std::unique_ptr<View> prepare(const OptionSet& options);
    void useScene(const harness::RenderArguments& arguments, harness::RenderSettings& settings,
                  const harness::Configuration& configuration);
    harness::Renderer& rendererFor(const OptionSet& options, const harness::DeviceArguments& arguments);
    void renderImage(View& view, ViewResult& result);
    // Renders a frame with pass times, or with counters.
    void measure(View& view, ViewResult& result, uint64_t flag, uint32_t warmup);
    // Measures the next frame of a view. Returns false if it needs none.
    bool measureNext(View& view, ViewResult& result);
    void useReference(const ViewRequest& request);
    // Accumulates for a part of a second. Returns false if the reference is done or not wanted.
    bool accumulate();
    void updateErrors();
    // Returns the options of the view A, in which a goal replaces the technique's.
    OptionSet chosenOptions(const ViewRequest& request);
    void observe(const AgaaFrameStatistics& statistics);

    RendererFactory factory_;
    std::map<std::string, Device> devices_;
    std::string stillKey_, sceneKey_; // of the scenes as they are; empty: none
    harness::Scene stillScene_, movingScene_;
    std::shared_ptr<const harness::Motion> motion_;
    std::string environmentKey_;
    std::shared_ptr<const harness::Environment> environment_;

    std::optional<ViewRequest> request_;
    bool hasFailed_ = false;
    bool hasBegun_ = false; // begin() has succeeded
    std::unique_ptr<View> a_, b_;
    bool isAPending_ = false, isBPending_ = false; // their images are not rendered yet
    bool areErrorsPending_ = false;
    std::unique_ptr<View> referenceView_;
    std::unique_ptr<harness::ReferenceAccumulation> accumulation_;
    std::string referenceKey_;
    AgaaChoice choice_ = AGAA_CHOICE_INIT;
    AgaaObservation observation_ = AGAA_OBSERVATION_INIT;
    Snapshot state_; // copied into each snapshot
};

} // namespace viewer
