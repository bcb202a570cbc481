// Images of many samples a pixel, accumulated from frames of one sample, each shifted by a part of a pixel.
#pragma once

#include "image/metrics.h"
#include "render/renderer.h"

#include <functional>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace harness {

// Offset i, in [-1/2;1/2) pixels, of a sequence that fills the pixel evenly at every length (Roberts 2018, R2):
// the box filter of one pixel.
glm::dvec2 pixelOffset(uint32_t i);

// The layout with 16 bits per channel of a sample; null: "precise". Reference images use it: 10 bits for the specular
// reflectance change dark images by more than a technique's own error, and techniques without a G-buffer do not round.
AgaaLayout referenceLayout(const AgaaLayout* layout);

// Over what the textures of a reference are filtered, so which question it answers.
enum class Footprint {
    Pixel,  // a pixel, as by every technique: how far is a technique from all samples of the same textures?
    Sample, // one of the spp samples: how far are techniques and texture filtering together from the scene?
};

struct Reference {
    Image image;
    double splitHalfMse = 0; // of the image, from the difference of its halves
    double splitHalfMseTm = 0;
};
// The settings' frame by spp samples per pixel (at least 2), around the settings' own jitter. The settings' technique,
// samples and footprint are not used; their layout is widened. Every frame has one sample, hard cut-outs and random
// numbers of its own for translucent surfaces. The two halves, which split the frames, share no random numbers;
// references of the same spp and another ditherFrame do not either.
Reference renderReference(Renderer& renderer, RenderSettings settings, uint32_t spp,
                          const std::function<void(uint32_t done)>& progress = {},
                          Footprint footprint = Footprint::Pixel);

// Those of one scene, rendered when first asked for and kept: backends share them, whose images agree (see the
// tests) far below a reference's own error.
class SceneReferences {
public:
    // frame: a name of the settings' camera and jitter.
    const Reference& get(const std::string& frame, Renderer& renderer, const RenderSettings& settings, uint32_t spp);

private:
    std::map<std::string, Reference> kept_;
};

// As docs/sweep.md has an error.
nlohmann::json metricsJson(const Metrics& metrics);

} // namespace harness
