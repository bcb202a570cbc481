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

struct Reference {
    Image image;
    double splitHalfMse = 0; // of the image, from the difference of its halves
    double splitHalfMseTm = 0;
};
// As the settings are, but for technique and samples; around the settings' own jitter. spp: at least 2.
Reference renderReference(Renderer& renderer, RenderSettings settings, uint32_t spp,
                          const std::function<void(uint32_t done)>& progress = {});

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
