// Images of many samples per pixel, accumulated from frames of one sample, each shifted by a part of a pixel.
#pragma once

#include "image/metrics.h"
#include "render/renderer.h"

#include <functional>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace harness {

// Returns offset i, in [-1/2, 1/2) pixels, of a sequence that fills the pixel evenly at every length (Roberts 2018,
// R2). The filter is a box of one pixel.
glm::dvec2 pixelOffset(uint32_t i);

// Returns the layout with 16 bits per channel of a sample; null stands for "precise". Reference images use it for two
// reasons: 10 bits of specular reflectance change dark images by more than a technique's error, and techniques without
// a G-buffer do not round.
AgaaLayout referenceLayout(const AgaaLayout* layout);

// The area over which a reference filters textures. It selects the question that the reference answers.
enum class Footprint {
    Pixel,  // a pixel, as in every technique: the error against all samples of the same textures
    Sample, // one of the spp samples: the error of technique and texture filtering together
};

struct Reference {
    Image image;
    double splitHalfMse = 0; // error of the image, from the difference of its halves
    double splitHalfMseTm = 0;
};

// A reference that grows frame by frame, with the frames of renderReference().
class ReferenceAccumulation {
public:
    // The settings' technique string, samples and footprint are not used. Pointers of the settings must stay valid.
    ReferenceAccumulation(const RenderSettings& settings, uint32_t spp, Footprint footprint = Footprint::Pixel);
    ~ReferenceAccumulation();
    ReferenceAccumulation(const ReferenceAccumulation&) = delete;
    ReferenceAccumulation& operator=(const ReferenceAccumulation&) = delete;

    void addSample(Renderer& renderer);
    uint32_t done() const { return done_; }
    // Returns the reference of the samples so far, of which there must be at least 2.
    Reference result() const;

private:
    class Half;

    RenderSettings settings_;
    AgaaLayout layout_;
    glm::dvec2 centre_;
    uint32_t firstDither_;
    std::vector<Half> halves_; // that share no random numbers
    Image newest_;
    uint32_t done_ = 0;
};

// Renders the settings' frame with spp samples per pixel (at least 2) around the settings' jitter. The settings'
// technique, samples and footprint are not used; their layout is widened. Every frame has one sample, hard cut-outs and
// its own random numbers for translucent surfaces. With AGAA_CONFIG_HDR_RESOLVE samples have the weights of events. The
// frames form two halves that share no random numbers. References with the same spp and different ditherFrame share
// none either.
Reference renderReference(Renderer& renderer, RenderSettings settings, uint32_t spp,
                          const std::function<void(uint32_t done)>& progress = {},
                          Footprint footprint = Footprint::Pixel);

// Keeps the references of one scene, which it renders on demand. Backends share them, because the difference of their
// images (see the tests) is far below the error of a reference.
class SceneReferences {
public:
    // `frame` names the settings' camera and jitter.
    const Reference& get(const std::string& frame, Renderer& renderer, const RenderSettings& settings, uint32_t spp);

private:
    std::map<std::string, Reference> kept_;
};

// Returns the error that docs/sweep.md defines.
nlohmann::json metricsJson(const Metrics& metrics);

} // namespace harness
