#include "hard/frames.h"

#include "hard/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace harness::hard {

namespace {

void black(RenderSettings& settings) { settings.background = glm::vec4(0, 0, 0, 1); }

void emissive(RenderSettings& settings) {
    black(settings);
    settings.ambient = glm::vec3(0);
}

// Emission up to the largest value of the output.
void bright(RenderSettings& settings) {
    static const AgaaLayout layout = [] {
        AgaaLayout wide = AGAA_LAYOUT_INIT;
        agaaGetBuiltinLayout("precise", &wide);
        for (uint32_t i = 0; i < wide.attributeCount; ++i)
            if (wide.attributes[i].semantic == AGAA_SEMANTIC_EMISSIVE)
                wide.attributes[i].range = 65504;
        return wide;
    }();
    emissive(settings);
    settings.config.layout = &layout;
}

void diffuseOnly(RenderSettings& settings) {
    emissive(settings);
    settings.facts.flags &= ~uint64_t(AGAA_FACT_SPECULAR);
}

void standardDepth(RenderSettings& settings) { settings.reversedZ = false; }

void translated(RenderSettings& settings) { settings.worldOffset = {1e6, -2e6, 1e6}; }
void untranslated(RenderSettings& settings) { settings.worldOffset = glm::dvec3(0); }

// Shows the stripes through an orthographic camera, whose longer side is 64 units.
void stripes(RenderSettings& settings) {
    settings.camera.height = 64.0 * settings.height / std::max(settings.width, settings.height);
}

void manyFragments(RenderSettings& settings) { settings.config.coverage.fragmentsPerPixel = 128; }

// Sums of 32 samples in fixed point round a dark albedo by up to half a code.
bool sums32(const HardConfiguration& configuration) {
    const uint32_t tier = configuration.generationTier;
    return configuration.technique == "agaa" && configuration.samples == 32 &&
           (tier == AGAA_TIER_PER_SAMPLE || tier == AGAA_TIER_POST_DEPTH_ATOMICS);
}
bool sumsFewerThan32(const HardConfiguration& configuration) { return !sums32(configuration); }

bool isLargest(const HardConfiguration& configuration) {
    return configuration.technique == "agaa" && configuration.samples == 32 && configuration.aggregates == 4;
}

Finding likeWhole(const Rendered& frame) {
    // msaa shades each fragment at a place inside of it, and highlights of a mirror change within a pixel.
    return differenceFromOther(frame, frame.configuration.technique == "msaa" ? 0.026 : 1.0 / 255);
}
// dcaa merges the duplicates of a pixel with few surfaces, and the order of merging changes.
Finding likeOnce(const Rendered& frame) {
    return frame.configuration.technique == "dcaa" ? differenceFromOther(frame, 0.18) : bitsOfOther(frame);
}
Finding likeUntranslated(const Rendered& frame) { return differenceFromOther(frame, 1.0 / 255); }
// The edges of the scene have a contrast of 0.16. At most two edges cross a column of samples at once. "sbaa" shades a
// surface by one of its samples, which may change for all samples of the pixel.
Finding jump(const Rendered& frame) {
    const double share =
        frame.configuration.technique == "sbaa" ? 1 : 2 / std::sqrt(double(frame.configuration.samples));
    return largestJump(frame, 0.16 * std::min(1.0, share) + 0.02);
}

// Frames of one sample per pixel are not bounded.
constexpr Bounds bounds(double few, double samples, double surfaces, double aggregates, double mean, double event) {
    return {std::numeric_limits<double>::infinity(), few, samples, surfaces, aggregates, mean, event};
}
// One event has the errors of few samples and of one aggregate.
constexpr Bounds bounds(double few, double samples, double surfaces, double aggregates, double mean) {
    return bounds(few, samples, surfaces, aggregates, mean, std::max(few, mean));
}

} // namespace

const std::vector<HardFrame>& hardFrames() {
    static const std::vector<HardFrame> frames = {
        {.name = "mirror",
         .scene = "hard-mirror",
         .cases = "2, 5, 8",
         .maxMseTm = bounds(7.3e-05, 1e-06, 0.0002, 4e-06, 2.9e-05),
         .maxMeanError = bounds(0.042, 0.0023, 0.023, 0.008, 0.023),
         .other = OtherFrame{"hard-mirror-whole"},
         .checked = "the plane in one fragment",
         .check = likeWhole},
        {.name = "opposite-normals",
         .scene = "hard-opposite-normals",
         .cases = "4, 12",
         .spp = 256,
         .maxMseTm = bounds(0.04, 1.6e-06, 0.042, 0.0058, 0.042),
         .maxMeanError = bounds(0.14, 0.0012, 0.037, 0.54, 0.54)},
        {.name = "needles",
         .scene = "hard-needles",
         .cases = "4, 6, 7, 12",
         .maxMseTm = bounds(0.0007, 0.00023, 0.00023, 0.00035, 0.00061),
         .maxMeanError = bounds(0.027, 0.0071, 0.011, 0.017, 0.039)},
        {.name = "duplicates",
         .scene = "hard-duplicates",
         .cases = "25, 33",
         .maxMseTm = bounds(0.0011, 4.9e-05, 0.00024, 4.9e-05, 0.0004),
         .maxMeanError = bounds(0.0011, 0.001, 0.0026, 0.001, 0.004),
         .other = OtherFrame{"hard-duplicates-once"},
         .checked = "the scene without duplicates",
         .check = likeOnce},
        {.name = "far-wall",
         .scene = "hard-far-wall",
         .cases = "15, 16, 20",
         .maxMseTm = bounds(0.0058, 0.00067, 0.0044, 0.00049, 0.014),
         .maxMeanError = bounds(0.062, 0.031, 0.18, 0.031, 0.3)},
        {.name = "far-wall-standard",
         .scene = "hard-far-wall",
         .cases = "15, 20",
         .maxMseTm = bounds(0.0058, 0.00067, 0.0011, 0.00049, 0.009),
         .maxMeanError = bounds(0.062, 0.031, 0.03, 0.031, 0.074),
         .adjust = standardDepth},
        {.name = "far-wall-d32",
         .scene = "hard-far-wall",
         .cases = "15, 20",
         .maxMseTm = bounds(0.0058, 0.00049, 0.00092, 0.00049, 0.0092),
         .maxMeanError = bounds(0.062, 0.031, 0.0067, 0.031, 0.069),
         .adjust = standardDepth,
         .isWithoutD24 = true},
        {.name = "far-world",
         .scene = "hard-railings",
         .cases = "22",
         .maxMseTm = bounds(0.009, 0.00039, 0.0019, 0.0023, 0.0037),
         .maxMeanError = bounds(0.14, 0.0013, 0.096, 0.16, 0.18),
         .adjust = translated,
         .other = OtherFrame{nullptr, untranslated},
         .checked = "the world at the origin",
         .check = likeUntranslated},
        {.name = "light-on-surface",
         .scene = "hard-light-on-surface",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(0.00017, 3.2e-06, 7.6e-05, 6.3e-05, 8.4e-05),
         .maxMeanError = bounds(0.03, 0.0022, 0.015, 0.013, 0.015)},
        {.name = "light-in-surface",
         .scene = "hard-light-in-surface",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(0.00011, 4.9e-06, 8e-05, 9.1e-06, 0.00012),
         .maxMeanError = bounds(0.007, 0.0012, 0.0034, 0.0054, 0.0059)},
        {.name = "light-inside",
         .scene = "hard-light-inside",
         .cases = "39, 41",
         .maxMseTm = bounds(2.2e-05, 3.8e-06, 1.2e-05, 4.1e-06, 0.00011),
         .maxMeanError = bounds(0.0035, 0.001, 0.0032, 0.001, 0.017)},
        {.name = "light-radius-0",
         .scene = "hard-light-radius-0",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(4.3e-05, 1e-06, 7.4e-05, 5.4e-06, 1.4e-05),
         .maxMeanError = bounds(0.0017, 0.001, 0.0031, 0.003, 0.0031)},
        {.name = "spots",
         .scene = "hard-spots",
         .cases = "40",
         .maxMseTm = bounds(0.00016, 5.4e-06, 0.00028, 9.6e-05, 0.00011),
         .maxMeanError = bounds(0.0048, 0.001, 0.0029, 0.0021, 0.0022)},
        {.name = "checker",
         .scene = "hard-checker",
         .cases = "42",
         .maxMseTm = bounds(0.05, 0.00018, 0.051, 0.0079, 0.051),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001, 0.067)}, // light and shadow share an event
        {.name = "railings",
         .scene = "hard-railings",
         .cases = "49, 59",
         .maxMseTm = bounds(0.0066, 0.0012, 0.002, 0.0023, 0.0037),
         .maxMeanError = bounds(0.12, 0.011, 0.13, 0.16, 0.17)},
        {.name = "hair",
         .scene = "hard-hair",
         .cases = "48, 59",
         .maxMseTm = bounds(0.005, 0.00089, 0.0013, 0.00094, 0.0091),
         .maxMeanError = bounds(0.017, 0.0048, 0.027, 0.025, 0.29)},
        {.name = "dark-ramp",
         .scene = "hard-dark-ramp",
         .cases = "31, 32",
         .spp = 16,
         .maxMseTm = bounds(1e-06, 1e-06, 1e-06, 1e-06, 1e-06),
         .maxMeanError = bounds(0.0083, 0.001, 0.001, 0.0081, 0.0081),
         .adjust = diffuseOnly,
         .checked = "no black bar; errors in codes",
         .check = rampError,
         .isFor = sumsFewerThan32},
        {.name = "dark-ramp-sums",
         .scene = "hard-dark-ramp",
         .cases = "31, 32",
         .spp = 16,
         .maxMseTm = bounds(1e-06, 1e-06, 1e-06, 2e-05, 2e-05),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.11, 0.11),
         .adjust = diffuseOnly,
         .checked = "no black bar; errors in codes",
         .check = rampError,
         .isFor = sums32},
        {.name = "emission",
         .scene = "hard-emission",
         .cases = "34, 43",
         .spp = 256,
         .maxMseTm = bounds(0.16, 0.046, 0.057, 0.033, 0.033),
         .maxMeanError = bounds(0.001, 0.0013, 0.0013, 0.0013, 0.0013),
         .adjust = bright},
        {.name = "cut-outs",
         .scene = "hard-cut-outs",
         .cases = "53",
         .width = 32,
         .height = 18,
         .maxMseTm = bounds(0.0018, 0.00022, 0.0013, 0.00022, 0.0021),
         .maxMeanError = bounds(0.0046, 0.0015, 0.012, 0.0015, 0.017),
         .adjust = manyFragments},
        {.name = "sweep",
         .scene = "hard-sweep",
         .cases = "23, 24",
         .maxMseTm = bounds(0.00015, 1.2e-05, 3.5e-05, 1.5e-05, 0.00014),
         .maxMeanError = bounds(0.0034, 0.0019, 0.0072, 0.0024, 0.0092),
         .checked = "change by 1/16 of a pixel",
         .check = jump},
        {.name = "hdr-edges",
         .scene = "hard-hdr-edges",
         .cases = "34, 43",
         .spp = 256,
         .maxMseTm = bounds(0.14, 0.022, 0.02, 0.022, 0.022),
         .maxMeanError = bounds(0.018, 0.0029, 0.0026, 0.0029, 0.0029),
         .adjust = bright},
        {.name = "size-1x1",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 1,
         .height = 1,
         .spp = 256,
         .maxMseTm = bounds(0.031, 0.00047, 0.031, 0.00037, 0.04),
         .maxMeanError = bounds(0.38, 0.077, 0.99, 0.079, 1.1),
         .adjust = stripes},
        {.name = "size-1x8191",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 1,
         .height = 8191,
         .spp = 16,
         .maxMseTm = bounds(2.2e-05, 3.7e-06, 1.8e-05, 3.6e-06, 3.3e-05),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001),
         .adjust = stripes},
        {.name = "size-4097x3",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 4097,
         .height = 3,
         .spp = 16,
         .maxMseTm = bounds(3.6e-05, 5.9e-06, 2.2e-05, 5.5e-06, 4.3e-05),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001),
         .adjust = stripes},
        {.name = "size-widest",
         .scene = "hard-stripes",
         .cases = "38, 55",
         .width = 0,
         .height = 1,
         .spp = 16,
         .maxMseTm = bounds(2.3e-06, 1e-06, 3.3e-06, 1e-06, 3.3e-06),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001),
         .adjust = stripes,
         .isWidest = true},
        {.name = "size-1080p",
         .scene = "hard-hair",
         .cases = "30, 38",
         .width = 1920,
         .height = 1080,
         .spp = 8,
         .maxMseTm = bounds(1e-06, 1e-06, 1e-06, 0.00011, 1e-06),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001),
         .isFor = isLargest},
        {.name = "empty",
         .scene = "hard-empty",
         .cases = "18",
         .spp = 2,
         .maxMseTm = bounds(1e-06, 1e-06, 1e-06, 1e-06, 1e-06),
         .maxMeanError = bounds(0.001, 0.001, 0.001, 0.001, 0.001),
         .checked = "bits of the background",
         .check = bitsOfBackground},
        {.name = "one-sample",
         .scene = "hard-specks",
         .cases = "19, 31",
         .spp = 256,
         .maxMseTm = bounds(0.085, 0.075, 0.07, 0.075, 0.075),
         .maxMeanError = bounds(2.1, 0.35, 0.19, 0.35, 0.35, 2.1),
         .adjust = emissive,
         .checked = "weights are whole samples",
         .check = wholeWeights},
        {.name = "primitive-per-sample",
         .scene = "hard-primitives",
         .cases = "23, 30, 44",
         .width = 32,
         .height = 18,
         .maxMseTm = bounds(0.0074, 0.00055, 0.0072, 0.00053, 0.0072),
         .maxMeanError = bounds(0.0068, 0.0025, 0.014, 0.011, 0.061)},
    };
    return frames;
}

RenderSettings settingsOf(const HardFrame& frame, const Scene& scene) {
    RenderSettings settings;
    settings.width = frame.width;
    settings.height = frame.height;
    settings.camera = scene.cameras.at(0);
    settings.lights = scene.lights;
    settings.facts = sceneFacts(scene, settings.lights);
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    settings.config.coverage.fragmentsPerPixel = 80;
    if (frame.adjust)
        frame.adjust(settings);
    return settings;
}

} // namespace harness::hard
