// One scene on one backend: rows in turns, errors, temporal errors, ablation. docs/sweep.md has the result.
#pragma once

#include "sweep/reference.h"
#include "sweep/rows.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace harness {

struct SweepOptions {
    uint32_t rounds = 7;       // of frames without times of passes; the rows take turns, forth and back
    uint32_t timedRounds = 3;  // of frames with them
    uint32_t referenceSamples = 512;
    uint32_t temporalFrames = 6; // shifts by parts of a pixel, and frames of a camera path; 0: none
    uint32_t temporalSamples = 32; // of the reference at each
};
SweepOptions sweepOptions(bool quick);

class SceneSweep {
public:
    // step: told what is being done, and with how many of how many steps behind it.
    using Progress = std::function<void(const std::string& step, uint32_t done, uint32_t of)>;

    // images: a folder that exists; stem: of its files. base: camera, lights, facts, size.
    SceneSweep(Renderer& renderer, const Scene& scene, const RenderSettings& base, const SweepOptions& options,
               const std::vector<SweepRow>& rows, std::filesystem::path images, std::string stem, Progress progress);

    nlohmann::json run();
    uint32_t timeSource() const; // AgaaTimeSource of the passes, after run()

private:
    struct Measured {
        SweepRow row;
        std::vector<double> frameMs;
        std::vector<AgaaFrameStatistics> timed;
        RenderResult counted; // one frame with counters
        Image image;
        nlohmann::json errorSameSamples, errorReference, temporal, path;
        nlohmann::json imageFile, differenceFile, heatFile;
    };

    RenderResult render(const SweepRow& row, uint64_t flags = 0);
    void countEvents();
    void takeTurns(uint32_t rounds, uint64_t flags,
                   const std::function<void(Measured&, const RenderResult&)>& keep);
    void measureErrors();
    // place: moves base_ to a frame. Results go to a member of the rows.
    void measureTemporal(const char* what, nlohmann::json Measured::*result,
                         const std::function<void(uint32_t frame)>& place);
    nlohmann::json ablation();
    nlohmann::json rowJson(const Measured& row) const;
    std::string writeImage(const std::string& name, const Image& image) const;
    const Image& sameSamples(uint32_t samples);
    void step(const std::string& what);

    Renderer& renderer_;
    const Scene& scene_;
    RenderSettings base_;
    SweepOptions options_;
    std::filesystem::path images_;
    std::string stem_;
    Progress progress_;
    uint32_t done_ = 0;
    uint32_t steps_ = 0;
    std::vector<Measured> rows_;
    Reference reference_;
    std::vector<std::pair<uint32_t, Image>> sameSamples_; // ssaa by n
};

} // namespace harness
