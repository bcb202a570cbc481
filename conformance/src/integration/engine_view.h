// A view in the context of the engine under test, and its images.
#pragma once

#include "../suite.h"

#include <array>
#include <optional>

namespace agaa::conformance {

struct Findings; // declared in findings.h

struct HostTest {
    const AgaaConformanceHost& host;
    const Functions& sdk;
    std::shared_ptr<const Findings> findings = {};
    // Name of the check whose failure makes all further checks meaningless, for example pipelines of another view.
    std::string blockedBy = {};
};

struct ViewChoice {
    const char* technique = "single";
    uint32_t samples = 1;
    const char* layout = "precise";
    bool isWithoutStencil = false;
};

struct Image {
    uint32_t width = 0, height = 0;
    std::vector<float> pixels; // RGBA
};

class EngineView {
public:
    // Throws Skipped if the device or the library does not support the choice.
    EngineView(Test& test, HostTest& hostTest, const ViewChoice& choice);
    ~EngineView();
    EngineView(const EngineView&) = delete;
    EngineView& operator=(const EngineView&) = delete;

    // Renders with ambient light 1 only: the image is the diffuse albedo.
    Image renderAlbedo();
    // Renders with a light of irradiance pi along the camera's direction: the image is albedo times the cosine of the
    // normal.
    Image renderHeadlight();
    AgaaFrameValidation validate();
    uint32_t drawPasses() const; // number of draw passes of the view
    AgaaCounters counters();
    // Returns the projection of the newest frame.
    const std::array<float, 16>& projection() const { return projection_; }

private:
    Image render(AgaaFrame& frame); // the frame must succeed
    AgaaFrame nextFrame();
    Test& test_;
    HostTest& hostTest_;
    ViewChoice choice_;
    AgaaView view_ = nullptr;
    uint32_t width_, height_;
    uint64_t frameIndex_ = 0;
    std::array<float, 16> viewMatrix_{}, projection_{};
};

// Returns the share of the pixels that differ by more than `tolerance` in a channel, among those that are not black in
// both images.
double differingShare(const Image& a, const Image& b, float tolerance = 1.0f / 16);
std::string percent(double share);

} // namespace agaa::conformance
