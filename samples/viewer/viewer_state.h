// Everything that a person sets in the viewer. It is saved as JSON; docs/viewer.md describes the file.
#pragma once

#include "camera_path.h"
#include "option_set.h"

#include <filesystem>
#include <string>

namespace viewer {

enum class Mode { A, B, Split, Difference };
enum class Other { Configuration, Reference }; // the image B

// A goal in place of settings: limits for agaaChooseSettings. 0: no limit.
struct Goal {
    bool isOn = false;
    double maxError = 0; // share of the error of "single"
    double maxMilliseconds = 0;
    double maxBytes = 0;
    bool prefersError = false; // the least error within the limits, in place of the least time

    bool operator==(const Goal&) const = default;
    harness::ChooseArguments limits() const;
};

struct ViewerState {
    OptionSet options; // of the view A, and of the scene
    OptionSet other;   // of the view B; only those of the technique are used
    Mode mode = Mode::A;
    Other compareWith = Other::Configuration;
    double split = 0.5; // share of the width that shows A
    double gain = 4;    // of differences
    bool accumulatesReference = false;
    uint32_t referenceSamples = 64; // per pixel
    bool isFrozen = false;
    bool showsMagnifier = false;
    bool flies = false;
    bool playsFrames = false;  // frames follow each other: motions and accumulation go on
    bool followsWindow = true; // --size is that of the view in the window
    uint32_t texelSize = 1;    // pixels of the window that show a pixel of the image, in each direction
    Goal goal;
    CameraPath path;

    bool operator==(const ViewerState&) const = default;

    bool showsOther() const { return mode != Mode::A; }
    bool needsOtherView() const { return showsOther() && compareWith == Other::Configuration; }
    bool needsReference() const { return accumulatesReference || (showsOther() && compareWith == Other::Reference); }
    // Returns the options of the view B with those of the scene.
    OptionSet otherOptions() const { return withView(options, other); }

    nlohmann::json toJson() const;
    // Members that the JSON lacks keep their defaults. Throws BadArgument with a sentence that names the member.
    static ViewerState fromJson(const nlohmann::json& json);
};

// Returns the state of a viewer that starts without a file.
ViewerState defaultState();

// Throw BadArgument with one sentence that names the file.
ViewerState readState(const std::filesystem::path& path);
void writeState(const std::filesystem::path& path, const ViewerState& state);

const char* nameOf(Mode mode);

} // namespace viewer
