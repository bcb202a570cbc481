// One scene on one backend: rows in turns, errors, temporal errors, ablation. docs/sweep.md has the result.
#pragma once

#include "render/reference.h"
#include "sweep/rows.h"
#include "sweep/temporal.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace harness {

struct SweepOptions {
    uint32_t rounds = 7;      // of frames without times of passes, each shifted by another part of a pixel; the
                              // rows take turns, forth and back
    uint32_t warmUpTurns = 1; // of all rows, before those; the one makes images
    uint32_t untimedFrames = 0; // before each frame of a turn
    uint32_t timedRounds = 7; // of frames with them
    uint32_t heavierTimedRounds = 2; // as many of these are with the rows of heavier lighting too
    uint32_t effectRounds = 4; // of frames with an effect, and of frames without it
    bool effectsOfRows = false; // only of those that are measured
    bool ablation = true;       // whether effects are measured at all
    uint32_t pathFrames = 3;  // of a camera path
    uint32_t pathSamples = 8; // rows of more samples do not walk it
    uint32_t referenceSamples = 512;
    uint32_t jpegQuality = 0; // of images, [1;100]; 0: PNG
    uint32_t temporalSamples = 32; // of the references of shifts and of the path; 0: no errors over time
};
// rounds: 0: the usual number, which is for software rasterisers; a GPU has time for 101.
// ofEffects: they are what is asked for, with as little else as can be.
SweepOptions sweepOptions(bool quick, bool ofEffects, uint32_t rounds = 0);

class SceneSweep {
public:
    // step: told what is being done, and with how many of how many steps behind it.
    using Progress = std::function<void(const std::string& step, uint32_t done, uint32_t of)>;

    // images: a folder that exists; prefix: of its files. base: camera, lights, facts, size. references: the
    // scene's, of other backends too.
    SceneSweep(Renderer& renderer, const Scene& scene, const RenderSettings& base, const SweepOptions& options,
               const std::vector<SweepRow>& rows, SceneReferences& references, std::filesystem::path images,
               std::string prefix, Progress progress);

    nlohmann::json run(); // but for the scene's name
    uint32_t timeSource() const; // AgaaTimeSource of the passes, after run()

private:
    struct Measured {
        SweepRow row;
        std::vector<double> frameMs;
        std::vector<AgaaFrameStatistics> timed;
        RenderResult still; // one frame as it is
        AgaaCounters counters{};
        double shiftNoise = 0, pathNoise = 0; // sums of the references' own errors
        nlohmann::json errorSameSamples, errorReference, temporal, path;
        nlohmann::json imageFile, differenceFile, heatFile;
    };

    RenderResult render(const SweepRow& row, uint64_t flags = 0, uint32_t debugView = AGAA_DEBUG_VIEW_NONE);
    void countEvents(); // and shows them
    const Measured* sameButCost(const Measured& row) const; // of those that are counted; or null
    // Renders all rows, or all but those of heavier lighting; forth, or back in odd rounds.
    void takeTurn(uint32_t round, uint64_t flags, bool withHeavier,
                  const std::function<void(Measured&, RenderResult&)>& keep);
    void measureErrors();
    void measureErrors(Measured& row); // against images that are there
    void measureFrames(); // their times, and errors over sub-pixel shifts
    void measurePasses();
    void measurePath();
    // Of base_ as it is.
    const Reference& temporalReference(const char* of, uint32_t frame);
    nlohmann::json ablation();
    nlohmann::json rowJson(const Measured& row) const;
    std::string writeImage(const std::string& name, const Image& image) const;
    const Image* sameSamples(const SweepRow& row); // null where the row has no n
    void step(const std::string& what);

    Renderer& renderer_;
    const Scene& scene_;
    RenderSettings base_;
    SweepOptions options_;
    std::filesystem::path images_;
    std::string prefix_;
    Progress progress_;
    uint32_t done_ = 0;
    uint32_t steps_ = 0;
    std::vector<Measured> rows_;
    SceneReferences& references_;
    const Reference* reference_ = nullptr;
    std::map<uint32_t, Image> sameSamples_; // ssaa by n
};

} // namespace harness
