#include "hard/frames.h"

#include "hard/checks.h"

#include <algorithm>
#include <cmath>

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
    return differenceFromOther(frame, frame.configuration.technique == "msaa" ? 1 : 4.0 / 255);
}
// dcaa merges the duplicates of a pixel with few surfaces, and the order of merging changes.
Finding likeOnce(const Rendered& frame) {
    return frame.configuration.technique == "dcaa" ? differenceFromOther(frame, 0.1) : bitsOfOther(frame);
}
Finding likeUntranslated(const Rendered& frame) { return differenceFromOther(frame, 1.0 / 255); }
// The edges of the scene have a contrast of 0.16. At most two edges cross a column of samples at once.
Finding jump(const Rendered& frame) {
    const double share = 2 / std::sqrt(double(frame.configuration.samples));
    return largestJump(frame, 0.16 * std::min(1.0, share) + 0.02);
}

constexpr Bounds kFinite = {1, 1, 1, 1, 1};

} // namespace

const std::vector<HardFrame>& hardFrames() {
    static const std::vector<HardFrame> frames = {
        {"mirror", "hard-mirror", "2, 5, 8", 64, 36, 64, kFinite, kFinite, nullptr, OtherFrame{"hard-mirror-whole"},
         "the plane in one fragment", likeWhole},
        {"opposite-normals", "hard-opposite-normals", "4, 12", 64, 36, 64, kFinite, kFinite},
        {"needles", "hard-needles", "4, 6, 7, 12", 64, 36, 64, kFinite, kFinite},
        {"duplicates", "hard-duplicates", "25, 33", 64, 36, 64, kFinite, kFinite, nullptr,
         OtherFrame{"hard-duplicates-once"}, "the scene without duplicates", likeOnce},
        {"far-wall", "hard-far-wall", "15, 16, 20", 64, 36, 64, kFinite, kFinite},
        {"far-wall-standard", "hard-far-wall", "15, 20", 64, 36, 64, kFinite, kFinite, standardDepth},
        {"far-world", "hard-railings", "22", 64, 36, 64, kFinite, kFinite, translated,
         OtherFrame{nullptr, untranslated}, "the world at the origin", likeUntranslated},
        {"light-on-surface", "hard-light-on-surface", "39, 65", 64, 36, 256, kFinite, kFinite},
        {"light-in-surface", "hard-light-in-surface", "39, 65", 64, 36, 256, kFinite, kFinite},
        {"light-inside", "hard-light-inside", "39, 41", 64, 36, 64, kFinite, kFinite},
        {"light-radius-0", "hard-light-radius-0", "39, 65", 64, 36, 256, kFinite, kFinite},
        {"spots", "hard-spots", "40", 64, 36, 64, kFinite, kFinite},
        {"checker", "hard-checker", "42", 64, 36, 64, kFinite, kFinite},
        {"railings", "hard-railings", "49, 59", 64, 36, 64, kFinite, kFinite},
        {"hair", "hard-hair", "48, 59", 64, 36, 64, kFinite, kFinite},
        {"dark-ramp", "hard-dark-ramp", "31, 32", 64, 36, 16, kFinite, kFinite, diffuseOnly, std::nullopt,
         "no bar is black; errors in codes", rampError},
        {"emission", "hard-emission", "34, 43", 64, 36, 64, kFinite, kFinite, bright},
        {"cut-outs", "hard-cut-outs", "53", 32, 18, 64, kFinite, kFinite, manyFragments},
        {"sweep", "hard-sweep", "23, 24", 64, 36, 64, kFinite, kFinite, nullptr, std::nullopt,
         "largest change by 1/16 of a pixel", jump},
        {"hdr-edges", "hard-hdr-edges", "34, 43", 64, 36, 256, kFinite, kFinite, bright},
        {"size-1x1", "hard-stripes", "55", 1, 1, 256, kFinite, kFinite, stripes},
        {"size-1x8191", "hard-stripes", "55", 1, 8191, 16, kFinite, kFinite, stripes},
        {"size-4097x3", "hard-stripes", "55", 4097, 3, 16, kFinite, kFinite, stripes},
        {"size-widest", "hard-stripes", "38, 55", 0, 1, 16, kFinite, kFinite, stripes, std::nullopt, nullptr, {}, true},
        {"size-1080p",
         "hard-hair",
         "30, 38",
         1920,
         1080,
         8,
         kFinite,
         kFinite,
         nullptr,
         std::nullopt,
         nullptr,
         {},
         false,
         isLargest},
        {"empty", "hard-empty", "18", 64, 36, 2, kFinite, kFinite, nullptr, std::nullopt, "bits of the background",
         bitsOfBackground},
        {"one-sample", "hard-specks", "19, 31", 64, 36, 256, kFinite, kFinite, emissive, std::nullopt,
         "weights are whole samples", wholeWeights},
        {"primitive-per-sample", "hard-primitives", "23, 30, 44", 32, 18, 64, kFinite, kFinite},
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
