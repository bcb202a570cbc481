// The part of a frame of the sample engine that does not depend on the graphics API: facts, camera, lights, draws, and
// the order of the steps.
#pragma once

#include "render/camera_matrices.h"
#include "render/draw_list.h"
#include "render/environment_glsl.h"
#include "render/filtered_shadows.h"
#include "render/sdk_log.h"

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

namespace harness {

class HostRenderer : public Renderer {
public:
    void load(const Scene& scene) override;
    RenderResult render(const RenderSettings& settings) override;
    // Returns the SDK's warnings and errors so far.
    const std::vector<std::string>& sdkTexts() { return log().texts(); }

protected:
    struct FrameInput {
        const RenderSettings& settings;
        uint32_t index = 0; // of the frame in the motion
        CameraMatrices camera = {};
        std::optional<CameraMatrices> previousCamera = {}; // of the previous frame, without jitter
        glm::dvec2 jitter{0};                              // of this frame, in pixels
        uint64_t placement = 0;                            // equal numbers: equal transforms of the instances
        std::vector<AgaaLight> lights = {};
        std::vector<AgaaLight> unshadowed = {}; // lights without shadows
        const AgaaSceneFacts* facts = nullptr;  // facts of the frame; null: the facts of the view
        std::vector<AgaaShadow> shadows = {};   // if functions of the view answer for all shadows
        std::vector<Draw> draws = {};
        bool useMasked = true;
    };

    virtual SdkLog& log() = 0;
    virtual ClipY clipY() const = 0;
    virtual uint64_t viewFlags() const { return 0; }
    // Converts a projection for z in [0, w] to the clip space of the API.
    virtual glm::dmat4 rasterised(const glm::dmat4& projection) const { return projection; }
    // Uploads scene() to the device.
    virtual void upload() = 0;
    // Returns the function that fetches the materials of scene(), for views that fetch. `coversByEdges` is true if the
    // tier is not IDS.
    virtual const AgaaFetchFunction* fetchFunction(bool coversByEdges) = 0;
    // Makes an environment available to the functions of the views, or, with inDraws, to the fragment shaders of draws.
    virtual EnvironmentBindings useEnvironment(const std::shared_ptr<const Environment>& environment, bool inDraws) = 0;
    // Makes filtered shadow maps available to the functions of the views.
    virtual FilteredShadowBindings useFilteredShadows() = 0;
    // Returns the view of a description. It runs before all other steps, so that the SDK reports unsupported settings.
    virtual AgaaView useView(const AgaaViewDesc& desc) = 0;
    // Creates the output, shadow maps and pipelines that the frames need. Called again when draws have changed.
    virtual void prepare(const FrameInput& input) = 0;
    // Writes the camera for the draws. Called after prepare() and before each frame whose camera differs.
    virtual void setCamera(const FrameInput& input) = 0;
    // Renders one frame through record() and waits for it. Returns milliseconds.
    virtual double renderFrame(const FrameInput& input) = 0;
    virtual Image readOutput() = 0;
    virtual Image readResolved(size_t index) = 0; // of RenderSettings::resolved
    virtual const std::vector<AgaaShadow>& shadows() const = 0;
    virtual void draw(const AgaaDrawTarget& target, const FrameInput& input) = 0;

    // Returns the scene with its instances as the frame places them.
    const Scene& scene() const { return scene_; }
    // Calls the backend's recording function for each of the frame's segments.
    template <class Record> void record(const FrameInput& input, const char* call, const Record& record);

private:
    AgaaFrame describeFrame(const FrameInput& input) const;
    AgaaTemporalFrame describeHistory(const FrameInput& input) const;
    // Returns the camera of a frame, without a position of agaaGetJitter().
    CameraMatrices cameraAt(const RenderSettings& settings, uint32_t index, const glm::dvec2& jitter) const;
    glm::dmat4 transformAt(const RenderSettings& settings, uint32_t instance, uint32_t index) const;
    // Sets the instances, lights and draws of the input's frame.
    void placeFrame(FrameInput& input);
    void describeMotion(FrameInput& input) const;
    // Sets the cameras of the input's frame and the frame before it.
    void moveCamera(FrameInput& input) const;
    // The callback of the SDK. No exception may leave it, so drawError_ keeps errors.
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);

    Scene scene_;
    std::vector<Instance> rest_;                 // the scene's instances as they were loaded
    std::shared_ptr<const Motion> placedMotion_; // that placed the instances of scene_; null: they rest
    uint32_t placedIndex_ = 0;
    uint64_t placement_ = 0;
    bool isLoaded_ = false;
    uint64_t frameIndex_ = 0;           // index of the newest frame; the renderer waits for each frame
    const FrameInput* input_ = nullptr; // input of the frame that is being recorded
    using Clock = std::chrono::steady_clock;
    Clock::duration recordTime_{}; // time in the SDK in the newest frame, including drawTime_
    Clock::duration drawTime_{};   // time in the draw callback
    std::string drawError_;
};

template <class Record> void HostRenderer::record(const FrameInput& input, const char* call, const Record& record) {
    AgaaFrame frame = describeFrame(input);
    const AgaaTemporalFrame history = describeHistory(input);
    frame.pNext = &history;
    frame.completedFrame = frameIndex_;
    frame.frameIndex = ++frameIndex_;
    std::vector<uint64_t> calls = {AGAA_SEGMENT_ALL};
    if (input.settings.splitSegments)
        calls = {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING};
    input_ = &input;
    recordTime_ = drawTime_ = {};
    for (const uint64_t segments : calls) {
        frame.segments = segments;
        drawError_.clear();
        const Clock::time_point start = Clock::now();
        const AgaaResult recorded = record(frame);
        recordTime_ += Clock::now() - start;
        if (!drawError_.empty())
            throw std::runtime_error(drawError_);
        log().check(recorded, call);
    }
}

} // namespace harness
