// What a frame of the sample engine is, whatever API draws it: facts, camera, lights, draws, and the order in which
// a renderer is asked for them.
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
    // The SDK's warnings and errors so far.
    const std::vector<std::string>& sdkTexts() { return log().texts(); }

protected:
    struct FrameInput {
        const RenderSettings& settings;
        CameraMatrices camera;
        std::vector<AgaaLight> lights;
        std::vector<AgaaLight> unshadowed; // the same without shadows
        const AgaaSceneFacts* facts = nullptr; // of the frame; null: those of the view
        std::vector<Draw> draws;
        bool useMasked = true;
    };

    virtual SdkLog& log() = 0;
    virtual ClipY clipY() const = 0;
    virtual uint64_t viewFlags() const { return 0; }
    // The projection for z in [0;w] as this API's rasteriser wants it.
    virtual glm::dmat4 rasterised(const glm::dmat4& projection) const { return projection; }
    // Of the scene that scene() now is.
    virtual void upload() = 0;
    // For views that fetch: the function that fetches scene()'s materials. coversByEdges: the tier is not IDS.
    virtual const AgaaFetchFunction* fetchFunction(bool coversByEdges) = 0;
    // First of all, so that the SDK refuses what it cannot do, in its own words.
    virtual AgaaView useView(const AgaaViewDesc& desc) = 0;
    // Output, shadow maps and pipelines that the frames need.
    virtual void prepare(const FrameInput& input) = 0;
    // One frame, waited for, through record(). Returns milliseconds.
    virtual double renderFrame(const FrameInput& input) = 0;
    virtual Image readOutput() = 0;
    virtual const std::vector<AgaaShadow>& shadows() const = 0;
    virtual void draw(const AgaaDrawTarget& target, const FrameInput& input) = 0;

    const Scene& scene() const { return scene_; }
    // Calls the backend's recording function for each of the frame's segments.
    template <class Record>
    void record(const FrameInput& input, const char* call, const Record& record);

private:
    AgaaFrame describeFrame(const FrameInput& input) const;
    // The SDK's callback: no exception may leave it, so errors wait in drawError_.
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);

    Scene scene_;
    bool isLoaded_ = false;
    uint64_t frameIndex_ = 0; // of the newest frame; all are waited for
    const FrameInput* input_ = nullptr; // of the frame being recorded
    using Clock = std::chrono::steady_clock;
    Clock::duration recordTime_{}; // of the SDK in the newest frame, with drawTime_
    Clock::duration drawTime_{};   // of the callback
    std::string drawError_;
};

template <class Record>
void HostRenderer::record(const FrameInput& input, const char* call, const Record& record) {
    AgaaFrame frame = describeFrame(input);
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
