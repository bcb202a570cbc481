// Values of the command line. They are parsed strictly; each error is one sentence.
#pragma once

#include "cli/adaptive_arguments.h"
#include "cli/temporal_arguments.h"
#include "render/renderer.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace harness {

// Reports a wrong argument. The exit status is 2.
class BadArgument : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Size {
    uint32_t width = 640;
    uint32_t height = 360;
};
Size parseSize(const std::string& text);     // WxH
Camera parseCamera(const std::string& text); // ex,ey,ez,tx,ty,tz,fovDegrees
std::vector<double> parseNumbers(const std::string& text, size_t count, const char* option);
uint32_t parseStatePolicy(const std::string& name);          // restore, callbacks, none
uint32_t parseConstants(const std::string& name);            // block, uniforms, texels
AgaaShadingLevel parseShadingLevel(const std::string& name); // event, reflectance
void requireBackend(const std::string& name);                // vk or gl

// The settings that determine a plan; memory, plan, render and reference share them.
struct PlanArguments {
    std::string technique = "agaa";
    uint32_t samples = 8;
    uint32_t aggregates = 2;
    std::string layout = "precise"; // name of a layout or of a file
    std::string brdf = "ggx";
    std::string ndf = "toksvig";
    std::string seeds = "maximin";
    std::string lanes = "auto";
    double k = 0;
    std::optional<double> kPerDistance;
    std::optional<double> threshold;
    std::string surface = "0,0,0";
    uint32_t shadowTaps = 0;
    uint32_t shadingCost = 1;
    std::vector<std::string> tiers; // native, auto or stage=tier
    bool noStencil = false;
    bool noCulling = false;
    bool checkFacts = false;
    bool firstSampleRouting = false;
    bool splitSurfaces = false;
    bool fineMaterials = false;
    bool hdrResolve = false;
    double exposure = 1;
    bool lit = false;
    bool buffered = false;
    uint32_t unfetchedEvery = 0; // tier IDS: every unfetchedEvery-th draw cannot be fetched; 0: none
    std::string view = "none";
    std::string preset; // empty: none
    double glossWeight = 0;
    std::string merge = "visible";
    std::string fragmentsPerPixel = "8"; // a number, or auto
    uint32_t maxBatches = 0;
    bool exact = false;
    bool drawOrder = false;
    bool reverseOrder = false;
    bool depthPrepass = false;
    std::string coveragePattern = "library";
    uint32_t tableSize = 0;
    AdaptiveArguments adaptive;
    TemporalArguments temporal;
    bool noDiffuseFilter = false;
    bool noShadowFilter = false;
    bool shadowAlongDepth = false;
    bool shadowCovariance = false;
    bool lightDirections = false;
    bool storedDepth = false;
    bool depthPlanes = false;
    std::string diffuseFilter = "rectified";
    bool reversedZ = true;
    std::string expand = "geometry";
    std::string size = "640x360";
};

// An SDK configuration with the memory that its pointers refer to.
struct Configuration {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    std::string technique; // config.technique points to it
    TechniqueConfig config;
    bool vertexPulling = false;
    bool computesTriangles = false;    // AgaaFetchFunction::maxTriangles
    bool fitsFragmentCapacity = false; // --fragments-per-pixel auto: a frame determines the capacity
    bool isModel = false;              // --tier native: the papers' model, on an ideal device
    Size size;

    explicit Configuration(const PlanArguments& arguments);
    Configuration(const Configuration&) = delete;
    Configuration& operator=(const Configuration&) = delete;
};

} // namespace harness
