// The part of a frame of the sample engine that does not depend on the graphics API: facts, camera, lights, draws, and
// the order of the steps.
#pragma once

#include "render/camera_matrices.h"
#include "render/draw_list.h"
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
        CameraMatrices camera;
        std::optional<CameraMatrices> previousCamera = {}; // of the previous frame, without jitter
        glm::dvec2 jitter{0};                              // of this frame, in pixels
        std::vector<AgaaLight> lights = {};
        std::vector<AgaaLight> unshadowed = {}; // lights without shadows
        const AgaaSceneFacts* facts = nullptr;  // facts of the frame; null: the facts of the view
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
    // Returns the view of a description. It runs before all other steps, so that the SDK reports unsupported settings.
    virtual AgaaView useView(const AgaaViewDesc& desc) = 0;
    // Creates the output, shadow maps and pipelines that the frames need.
    virtual void prepare(const FrameInput& input) = 0;
    // Writes the camera for the draws. Called after prepare() and before each frame whose camera differs.
    virtual void setCamera(const FrameInput& input) = 0;
    // Renders one frame through record() and waits for it. Returns milliseconds.
    virtual double renderFrame(const FrameInput& input) = 0;
    virtual Image readOutput() = 0;
    virtual const std::vector<AgaaShadow>& shadows() const = 0;
    virtual void draw(const AgaaDrawTarget& target, const FrameInput& input) = 0;

    const Scene& scene() const { return scene_; }
    // Calls the backend's recording function for each of the frame's segments.
    template <class Record> void record(const FrameInput& input, const char* call, const Record& record);

private:
    AgaaFrame describeFrame(const FrameInput& input) const;
    AgaaTemporalFrame describeHistory(const FrameInput& input) const;
    void moveCamera(FrameInput& input, uint32_t frame) const;
    // The callback of the SDK. No exception may leave it, so drawError_ keeps errors.
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);

    Scene scene_;
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
