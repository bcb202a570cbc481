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

bool isLargest(const HardConfiguration& configuration) {
    return configuration.technique == "agaa" && configuration.samples == 32 && configuration.aggregates == 4;
}

Finding likeWhole(const Rendered& frame) {
    // msaa shades each fragment at a place inside of it, and highlights of a mirror change within a pixel.
    return differenceFromOther(frame, frame.configuration.technique == "msaa" ? 0.05 : 1.0 / 255);
}
// dcaa merges the duplicates of a pixel with few surfaces, and the order of merging changes.
Finding likeOnce(const Rendered& frame) {
    return frame.configuration.technique == "dcaa" ? differenceFromOther(frame, 0.2) : bitsOfOther(frame);
}
Finding likeUntranslated(const Rendered& frame) { return differenceFromOther(frame, 1.0 / 255); }
// The edges of the scene have a contrast of 0.16. At most two edges cross a column of samples at once.
Finding jump(const Rendered& frame) {
    const double share = 2 / std::sqrt(double(frame.configuration.samples));
    return largestJump(frame, 0.16 * std::min(1.0, share) + 0.02);
}

// Frames of one sample per pixel are not bounded.
constexpr Bounds bounds(double samples, double surfaces, double aggregates, double mean) {
    return {std::numeric_limits<double>::infinity(), samples, surfaces, aggregates, mean};
}

} // namespace

const std::vector<HardFrame>& hardFrames() {
    static const std::vector<HardFrame> frames = {
        {.name = "mirror",
         .scene = "hard-mirror",
         .cases = "2, 5, 8",
         .maxMseTm = bounds(1e-6, 3e-4, 3e-5, 3e-4),
         .maxMeanError = bounds(0.005, 0.02, 0.03, 0.03),
         .other = OtherFrame{"hard-mirror-whole"},
         .checked = "the plane in one fragment",
         .check = likeWhole},
        {.name = "opposite-normals",
         .scene = "hard-opposite-normals",
         .cases = "4, 12",
         .spp = 256,
         .maxMseTm = bounds(0.003, 0.07, 0.01, 0.07),
         .maxMeanError = bounds(0.01, 0.3, 0.7, 0.7)},
        {.name = "needles",
         .scene = "hard-needles",
         .cases = "4, 6, 7, 12",
         .maxMseTm = bounds(1.5e-4, 4e-4, 1.5e-4, 0.003),
         .maxMeanError = bounds(0.007, 0.02, 0.02, 0.1)},
        {.name = "duplicates",
         .scene = "hard-duplicates",
         .cases = "25, 33",
         .maxMseTm = bounds(7e-5, 3e-4, 3e-4, 0.001),
         .maxMeanError = bounds(0.005, 0.01, 0.01, 0.01),
         .other = OtherFrame{"hard-duplicates-once"},
         .checked = "the scene without duplicates",
         .check = likeOnce},
        {.name = "far-wall",
         .scene = "hard-far-wall",
         .cases = "15, 16, 20",
         .maxMseTm = bounds(7e-4, 0.004, 7e-4, 0.02),
         .maxMeanError = bounds(0.04, 0.2, 0.04, 0.4)},
        {.name = "far-wall-standard",
         .scene = "hard-far-wall",
         .cases = "15, 20",
         .maxMseTm = bounds(7e-4, 0.004, 7e-4, 0.02),
         .maxMeanError = bounds(0.04, 0.2, 0.04, 0.4),
         .adjust = standardDepth},
        {.name = "far-wall-d32",
         .scene = "hard-far-wall",
         .cases = "15, 20",
         .maxMseTm = bounds(7e-4, 0.004, 7e-4, 0.02),
         .maxMeanError = bounds(0.04, 0.2, 0.04, 0.4),
         .adjust = standardDepth,
         .isWithoutD24 = true},
        {.name = "far-world",
         .scene = "hard-railings",
         .cases = "22",
         .maxMseTm = bounds(0.0015, 0.004, 0.003, 0.01),
         .maxMeanError = bounds(0.015, 0.3, 0.2, 0.3),
         .adjust = translated,
         .other = OtherFrame{nullptr, untranslated},
         .checked = "the world at the origin",
         .check = likeUntranslated},
        {.name = "light-on-surface",
         .scene = "hard-light-on-surface",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(2e-5, 4e-4, 1e-4, 4e-4),
         .maxMeanError = bounds(0.005, 0.02, 0.015, 0.05)},
        {.name = "light-in-surface",
         .scene = "hard-light-in-surface",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(1.5e-5, 1e-4, 3e-5, 3e-4),
         .maxMeanError = bounds(0.005, 0.01, 0.005, 0.03)},
        {.name = "light-inside",
         .scene = "hard-light-inside",
         .cases = "39, 41",
         .maxMseTm = bounds(3e-6, 1e-5, 1.5e-5, 1.5e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.02)},
        {.name = "light-radius-0",
         .scene = "hard-light-radius-0",
         .cases = "39, 65",
         .spp = 256,
         .maxMseTm = bounds(1e-6, 7e-5, 7e-6, 2e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.02)},
        {.name = "spots",
         .scene = "hard-spots",
         .cases = "40",
         .maxMseTm = bounds(7e-6, 3e-4, 1.5e-4, 3e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005)},
        {.name = "checker",
         .scene = "hard-checker",
         .cases = "42",
         .maxMseTm = bounds(0.004, 0.07, 0.01, 0.07),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005)},
        {.name = "railings",
         .scene = "hard-railings",
         .cases = "49, 59",
         .maxMseTm = bounds(0.0015, 0.004, 0.003, 0.01),
         .maxMeanError = bounds(0.015, 0.3, 0.2, 0.3)},
        {.name = "hair",
         .scene = "hard-hair",
         .cases = "48, 59",
         .maxMseTm = bounds(0.0015, 0.0015, 0.0015, 0.005),
         .maxMeanError = bounds(0.005, 0.05, 0.05, 0.05)},
        {.name = "dark-ramp",
         .scene = "hard-dark-ramp",
         .cases = "31, 32",
         .spp = 16,
         .maxMseTm = bounds(1e-6, 1e-6, 3e-5, 3e-5),
         .maxMeanError = bounds(0.005, 0.005, 0.15, 0.15),
         .adjust = diffuseOnly,
         .checked = "no black bar; errors in codes",
         .check = rampError},
        {.name = "emission",
         .scene = "hard-emission",
         .cases = "34, 43",
         .spp = 256,
         .maxMseTm = bounds(0.05, 0.06, 0.05, 0.1),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .adjust = bright},
        {.name = "cut-outs",
         .scene = "hard-cut-outs",
         .cases = "53",
         .width = 32,
         .height = 18,
         .maxMseTm = bounds(3e-4, 0.002, 0.001, 0.005),
         .maxMeanError = bounds(0.005, 0.01, 0.01, 0.02),
         .adjust = manyFragments},
        {.name = "sweep",
         .scene = "hard-sweep",
         .cases = "23, 24",
         .maxMseTm = bounds(1.5e-5, 5e-5, 5e-5, 3e-4),
         .maxMeanError = bounds(0.005, 0.01, 0.005, 0.015),
         .checked = "change by 1/16 of a pixel",
         .check = jump},
        {.name = "hdr-edges",
         .scene = "hard-hdr-edges",
         .cases = "34, 43",
         .spp = 256,
         .maxMseTm = bounds(0.04, 0.04, 0.04, 0.1),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .adjust = bright},
        {.name = "size-1x1",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 1,
         .height = 1,
         .spp = 256,
         .maxMseTm = bounds(0.001, 0.05, 0.001, 0.1),
         .maxMeanError = bounds(0.1, 1, 0.1, 1),
         .adjust = stripes},
        {.name = "size-1x8191",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 1,
         .height = 8191,
         .spp = 16,
         .maxMseTm = bounds(3e-6, 2e-5, 2e-5, 1e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .adjust = stripes},
        {.name = "size-4097x3",
         .scene = "hard-stripes",
         .cases = "55",
         .width = 4097,
         .height = 3,
         .spp = 16,
         .maxMseTm = bounds(7e-6, 3e-5, 3e-5, 1e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .adjust = stripes},
        {.name = "size-widest",
         .scene = "hard-stripes",
         .cases = "38, 55",
         .width = 0,
         .height = 1,
         .spp = 16,
         .maxMseTm = bounds(1e-6, 1e-5, 5e-6, 5e-5),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .adjust = stripes,
         .isWidest = true},
        {.name = "size-1080p",
         .scene = "hard-hair",
         .cases = "30, 38",
         .width = 1920,
         .height = 1080,
         .spp = 8,
         .maxMseTm = bounds(1.5e-4, 1.5e-4, 4e-4, 4e-4),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .isFor = isLargest},
        {.name = "empty",
         .scene = "hard-empty",
         .cases = "18",
         .spp = 2,
         .maxMseTm = bounds(1e-6, 1e-6, 1e-6, 1e-6),
         .maxMeanError = bounds(0.005, 0.005, 0.005, 0.005),
         .checked = "bits of the background",
         .check = bitsOfBackground},
        {.name = "one-sample",
         .scene = "hard-specks",
         .cases = "19, 31",
         .spp = 256,
         .maxMseTm = bounds(0.1, 0.1, 0.1, 0.1),
         .maxMeanError = bounds(0.4, 0.7, 0.4, 0.7),
         .adjust = emissive,
         .checked = "weights are whole samples",
         .check = wholeWeights},
        {.name = "primitive-per-sample",
         .scene = "hard-primitives",
         .cases = "23, 30, 44",
         .width = 32,
         .height = 18,
         .maxMseTm = bounds(7e-4, 0.01, 0.003, 0.02),
         .maxMeanError = bounds(0.01, 0.1, 0.05, 0.1)},
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
