// The results of rendering that the window shows. A snapshot does not change, so that threads share it.
#pragma once

#include "frame_history.h"
#include "image/metrics.h"
#include "render/renderer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace viewer {

// Figures of one view.
struct Figures {
    double frameMs = 0; // from submission to completion, of the newest frame
    std::vector<PassTime> passes;
    uint64_t timedFrames = 0; // number of frames whose passes were timed since the settings changed
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT;
    uint64_t payloadBytes = 0, driverBytes = 0, peakBytes = 0;
    uint32_t geometryPasses = 0;
    std::optional<AgaaCounters> counters;
    harness::PlanSummary plan;
    std::string factReport; // with --check-facts
};

struct ViewResult {
    std::shared_ptr<const harness::Image> image; // as displayed: debug views are scaled. Null: not rendered yet
    Figures figures;
    std::optional<harness::Metrics> error; // against the reference
};

struct Snapshot {
    uint64_t serial = 0;     // of the request
    uint64_t frames = 0;     // rendered since the viewer started, without references
    bool isComplete = false; // the images of the request are rendered
    bool isReferenceDone = false;
    ViewResult a, b;
    std::shared_ptr<const harness::Image> reference;
    uint32_t referenceSamples = 0;
    double referenceError = 0; // mean square error of the reference itself, tone-mapped

    std::string device, driver;
    harness::Camera camera;               // of the images
    double sceneSize = 1;                 // diagonal of the scene's bounds
    std::vector<harness::Camera> cameras; // of the scene
    std::vector<std::string> notes;       // features of a file that the scene does not have, messages of the API

    std::vector<std::string> chosen; // options of a goal's settings, names and values in turn
    std::string reason;              // of the choice

    std::string error;            // one sentence; empty: none
    int exitStatus = 0;           // of a script that ends with the error: 2 for wrong settings, 1 for other errors
    bool hasFailedDevice = false; // rendering failed; starting again may help
};

} // namespace viewer
