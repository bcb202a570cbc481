// Measures one scene on one backend: rows in alternating order, errors, temporal errors, ablation; see docs/sweep.md.
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
    uint32_t rounds = 7;        // turns of all rows without pass times, each with another sub-pixel shift; every second
                                // turn runs backwards
    uint32_t warmUpTurns = 1;   // turns of all rows before the rounds; the first one renders the images
    uint32_t untimedFrames = 0; // frames before each frame of a turn
    uint32_t timedRounds = 7;   // turns with pass times
    uint32_t heavierTimedRounds = 2; // the turns with pass times that include the rows of heavier lighting
    uint32_t effectRounds = 4;       // frames with an effect, and as many without it
    bool effectsOfRows = false;      // measure only the effects of the measured rows
    bool ablation = true;            // measure effects at all
    uint32_t pathFrames = 3;         // frames of the camera path
    uint32_t pathSamples = 8;        // rows with more samples leave the path out
    uint32_t referenceSamples = 512;
    uint32_t jpegQuality = 0;      // of images, [1, 100]; 0: PNG
    uint32_t temporalSamples = 32; // of the references of shifts and of the path; 0: no errors over time
};
// Returns the options of a sweep.
//
// effectsOnly   Measure effects, and of all else only what they need.
// rounds        0: the default number, which suits software rasterisers. A GPU has time for 101.
SweepOptions sweepOptions(bool quick, bool effectsOnly, uint32_t rounds = 0);

class SceneSweep {
public:
    // Receives the current step, the number of completed steps, and the number of all steps.
    using Progress = std::function<void(const std::string& step, uint32_t done, uint32_t total)>;

    // base         Camera, lights, facts and size.
    // references   The references of the scene, which all backends share.
    // images       A folder that exists.
    // prefix       The prefix of the file names in it.
    SceneSweep(Renderer& renderer, const Scene& scene, const RenderSettings& base, const SweepOptions& options,
               const std::vector<SweepRow>& rows, SceneReferences& references, std::filesystem::path images,
               std::string prefix, Progress progress);

    nlohmann::json run();        // without the scene's name
    uint32_t timeSource() const; // AgaaTimeSource of the passes; valid after run()

private:
    struct Measured {
        SweepRow row;
        std::vector<double> frameMs;
        std::vector<AgaaFrameStatistics> timed;
        RenderResult still; // one frame without a shift
        AgaaCounters counters{};
        double shiftNoise = 0, pathNoise = 0; // sums of the references' own errors
        nlohmann::json errorSameSamples, errorReference, temporal, path;
        nlohmann::json imageFile, differenceFile, heatFile;
    };

    RenderResult render(const SweepRow& row, uint64_t flags = 0, uint32_t debugView = AGAA_DEBUG_VIEW_NONE);
    void countEvents(); // also writes their images
    // Returns the counted row that differs from a row of heavier lighting in its cost only, or null.
    const Measured* sameButCost(const Measured& row) const;
    // Renders all rows, or all but the rows of heavier lighting. Odd rounds run backwards.
    void takeTurn(uint32_t round, uint64_t flags, bool withHeavier,
                  const std::function<void(Measured&, RenderResult&)>& keep);
    void measureErrors();
    void measureErrors(Measured& row); // requires the images of sameSamples()
    void measureFrames();              // measures frame times, and errors over sub-pixel shifts
    void measurePasses();
    void measurePath();
    // Returns the reference for the camera and jitter of base_. kind: "shift" or "path".
    const Reference& temporalReference(const char* kind, uint32_t frame);
    nlohmann::json ablation();
    nlohmann::json rowJson(const Measured& row) const;
    std::string writeImage(const std::string& name, const Image& image) const;
    // Returns the image of ssaa with the row's n, or null if there is none.
    const Image* sameSamples(const SweepRow& row);
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
