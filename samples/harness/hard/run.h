// Renders frames of hard cases and compares them with their references.
#pragma once

#include "hard/frames.h"

#include <memory>
#include <string>
#include <vector>

namespace harness::hard {

// A frame in a configuration on a backend.
struct HardJob {
    size_t frame;         // index of hardFrames()
    size_t configuration; // index of hardConfigurations()
    std::string backend;  // vk or gl
};

// Returns all combinations that `frames`, `configurations` and `backends` select.
std::vector<HardJob> allJobs(const std::vector<size_t>& frames, const std::vector<size_t>& configurations,
                             const std::vector<std::string>& backends);
// Returns some of the jobs: perPair of each pair of a technique and a frame, so that each n, c, tier and backend of a
// technique occurs, as far as the number of frames allows. The order of the jobs determines the result.
std::vector<HardJob> coveringJobs(const std::vector<HardJob>& jobs, uint32_t perPair);

struct HardResult {
    HardJob job;
    std::string refusal; // the SDK's sentence, if it does not plan the configuration
    std::string failure; // the sentence of any other error
    uint32_t width = 0, height = 0;
    double mseTm = 0, maxTm = 0, meanError = 0;
    double maxMseTm = 0, maxMeanError = 0; // bounds
    double referenceMseTm = 0;             // error of the reference
    std::optional<Finding> finding;
    uint64_t frames = 0;    // frames of the job, with those of its check
    uint64_t nonFinite = 0; // channels
    uint64_t sanitised = 0;
    uint64_t lostFragments = 0;

    bool isRefused() const { return !refusal.empty(); }
    bool isWithin() const;
    // Returns what exceeds its bound, as a phrase; empty if isWithin().
    std::string excess() const;
};

struct HardOptions {
    uint32_t perPair = 0;         // run coveringJobs() of the jobs that the SDK plans; 0: all
    uint32_t part = 0, parts = 1; // of these, run every parts-th job of each frame
    uint32_t spp = 0;             // samples per pixel of references, at most; 0: those of the frames
    std::function<void(const HardResult&)> report;
};

// Creates the renderer of an API. isWithoutD24: as on a device that lacks D24_UNORM_S8_UINT.
using MakeBackend = std::function<std::unique_ptr<Renderer>(const std::string& backend, bool isWithoutD24)>;

struct HardDevice {
    std::string backend, device, driver;
};
struct HardReport {
    std::vector<HardResult> results; // in the order of frames, backends and configurations
    std::vector<HardDevice> devices;
    std::vector<std::string> messages; // of the graphics APIs
};

HardReport runJobs(const std::vector<HardJob>& jobs, const MakeBackend& makeBackend, const HardOptions& options);

} // namespace harness::hard
