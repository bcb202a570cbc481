// The commands of agaa-harness. Each prints its result to stdout: JSON, or text for people.
#pragma once

#include "cli/arguments.h"

#include <string>
#include <vector>

namespace harness {

struct DeviceArguments {
    std::string backend; // empty: any device
    bool renderPass = false;
    bool noConditionalRendering = false;
    bool noGeometryShaders = false;
    bool noD24 = false;
    bool inlineRecording = false;
    bool noValidation = false;
    uint32_t keptViews = 2;
    bool compatibilityProfile = false;
    bool clipZFromMinusOne = false;
    bool storageImages = false;
    std::string constants = "block";
    bool hostOutputs = false;
    uint32_t glslVersion = 450;
    std::string statePolicy = "restore";
};

struct RenderArguments {
    PlanArguments plan;
    DeviceArguments device{"vk"};
    std::string scene = "bamboo";
    std::string camera;  // empty: the camera of the scene, or a default
    uint32_t lights = 0; // lights in addition to those of the scene
    std::string jitter = "0,0";
    uint32_t frames = 1;
    uint32_t warmup = 0;
    bool switchFacts = false;
    std::vector<std::string> without; // effects to leave out
    bool plainFacts = false;
    uint32_t drawOrderSeed = 0;
    uint32_t alphaPoints = 1;
    uint32_t ditherFrame = 0;
    std::string shadingFunction; // render: a file with GLSL; empty: none
    std::string shadingLevel = "event";
    std::string environment;            // render, reference: an image file; empty: none
    std::vector<std::string> clearCoat; // render, reference: materials of the scene
    bool filteredShadows = false;       // render
    std::vector<std::string> resolved;  // render: AgaaResolvedValue
    bool layers = false;                // render
    std::string motion = "still";       // render: of the scene
    uint32_t spp = 512;                 // reference: samples per pixel
    std::string footprint = "pixel";    // reference: pixel or sample
    bool noCounters = false;
    bool noTimestamps = false;
    std::string png;
    std::string exr;
};

// Limits of choose; 0: none.
struct ChooseArguments {
    float maxError = 0, maxMse = 0, sceneShare = 0.8f, maxMs = 0;
    uint64_t maxBytes = 0;
    std::string prefer = "time";
    bool oneGeometryPass = false;
    bool predictOthers = false;
    bool noFetch = false;
    bool observe = false;
    std::string measured; // a file, or empty
};

struct MotionArguments {
    RenderArguments base; // the scene, the size, and what all rows have
    std::string motion = "still";
    std::vector<std::string> rows; // options of views
    uint32_t frames = 64;
    uint32_t spp = 64;  // samples per pixel of the references
    std::string images; // a folder, or empty
};

struct CompareArguments {
    std::string reference;
    std::string test;
    std::string difference; // PNG, or empty
    double gain = 4;
};

struct HardScenesArguments {
    DeviceArguments device;          // backend empty: both
    std::vector<std::string> scenes; // empty lists select all
    std::vector<std::string> techniques;
    std::vector<uint32_t> samples, aggregates;
    uint32_t spp = 0;         // samples per pixel of references, at most; 0: those of the scenes
    uint32_t covering = 0;    // configurations of each pair of a technique and a scene; 0: all
    std::string part = "1/1"; // K/N
    bool list = false;
};

// Changes the facts of the scene as the arguments request.
void changeFacts(const RenderArguments& arguments, AgaaSceneFacts& facts);

void runCaps(const DeviceArguments& arguments, bool json);
void runMemory(const PlanArguments& plan, const DeviceArguments& device, bool json);
// sceneGiven   true: use the facts of the scene; false: assume all effects
void runPlan(const RenderArguments& arguments, bool sceneGiven, bool json);
// Prints the cost of effects and of steps of n and c. timesPath is a file of measured times, or empty.
void runPrice(const RenderArguments& arguments, const std::string& timesPath, bool sceneGiven, bool json);
// Prints settings for a goal. sceneGiven has the same meaning as in runPlan.
void runChoose(const RenderArguments& arguments, const ChooseArguments& chosen, bool sceneGiven, bool json);
void runScenes(bool json);
void runRender(const RenderArguments& arguments, bool json);
// Prints errors over the frames of a motion, and times, of views whose frames take turns.
void runMotion(const MotionArguments& arguments, bool json);
void runReference(const RenderArguments& arguments, bool json);
void runCompare(const CompareArguments& arguments, bool json);
// Throws if a frame exceeds a bound or is not finite.
void runHardScenes(const HardScenesArguments& arguments, bool json);

// Removes an effect from the facts, so that the plan drops it. Throws BadArgument for unknown names.
void removeEffect(const std::string& effect, AgaaSceneFacts& facts);
// Returns the scene's motion, to which the scene gets an object, if need be. Throws BadArgument for unknown names.
std::shared_ptr<const Motion> sceneMotion(const std::string& name, Scene& scene, const RenderSettings& settings);
// Returns the lights that remain after --without.
std::vector<Light> remainingLights(const RenderArguments& arguments, std::vector<Light> lights);

// Returns the goal of the limits, without measured settings. Throws BadArgument.
AgaaGoal goalOf(const ChooseArguments& arguments);
// Returns options of `render`, names and values in turn, for the chosen settings.
std::vector<std::string> optionsOf(const AgaaChoice& choice);

// Shared by commands that render.
std::unique_ptr<Renderer> makeRenderer(const DeviceArguments& arguments);
// Throws BadArgument if there is no such scene. Prints the features of a file that the scene does not have to stderr.
Scene loadSceneArgument(const std::string& nameOrPath);
// Returns the scene of the arguments, with the clear coats that they ask for.
Scene sceneOf(const RenderArguments& arguments);
RenderSettings renderSettings(const RenderArguments& arguments, const Configuration& configuration, const Scene& scene);
// Returns the image that a PNG of it shows: counts of debug views are scaled.
Image shownImage(Image image, const TechniqueConfig& config);

} // namespace harness
