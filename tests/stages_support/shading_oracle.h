// Lighting of surfaces read back from the GPU, in double.
#pragma once

#include "surfaces.h"

#include "core/frame/frame_data.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace agaa::test {

// The light that a point gets through shadow map `map`, in [0,1]; NaN where the oracle will not say
// because rounding decides.
using Visibility = std::function<double(uint32_t map, const glm::dvec3& position)>;

class ShadingOracle {
public:
    // view: a host's, which lives as long and has rendered the frame with AGAA_CONFIG_READBACK.
    template <class View>
    ShadingOracle(const View& view, const AgaaFrame& frame, Visibility visibility)
        : plan_(view.plan()), frame_(frame), constants_(frameConstants(view.plan(), frame, view.positions())),
          visibility_(std::move(visibility)), depth_(view.readSurface("depth")) {
        if (plan_.view.aggregates)
            words_ = view.readBuffer("aggregates");
        for (size_t i = 0; i < packGBuffer(plan_.view.layout).attachments.size() && !plan_.view.aggregates; ++i)
            gbuffer_.push_back(view.readSurface("gbuffer-" + std::to_string(i)));
    }

    // The pixel's colour, or NaN where the oracle will not say.
    glm::dvec3 pixel(uint32_t x, uint32_t y) const;

    uint64_t shadowTaps() const { return shadowTaps_; }
    uint64_t events() const { return events_; }

private:
    struct Shaded {
        glm::dvec3 diffuse, specular, emissive, normal;
        double meanLength = 1, alpha2 = 1;
    };
    Shaded aggregate(const uint32_t* words, uint32_t count, const glm::dvec3& toEye) const;
    Shaded sample(size_t index) const;
    glm::dvec3 position(uint32_t x, uint32_t y, uint32_t i) const; // shading space
    // samples: positions that an aggregate stands for, or none.
    glm::dvec3 light(const Shaded& s, const glm::dvec3& position, const std::vector<glm::dvec3>& samples,
                     const std::vector<double>& visibility) const;
    double spreadOf(const std::vector<glm::dvec3>& samples, const glm::dvec3& mean) const;
    // Of an aggregate: the mean of its samples' positions, and where its shadows are looked up.
    std::pair<glm::dvec3, std::vector<glm::dvec3>> storedTapsOf(const std::vector<glm::dvec3>& samples) const;
    std::pair<glm::dvec3, std::vector<glm::dvec3>> shadowTapsOf(const std::vector<glm::dvec3>& samples) const;
    glm::dvec3 perSamplePixel(uint32_t x, uint32_t y) const;
    glm::dvec3 aggregatedPixel(uint32_t x, uint32_t y) const;

    const Plan& plan_;
    AgaaFrame frame_;
    FrameConstants constants_;
    Visibility visibility_;
    std::vector<glm::uvec4> depth_;
    std::vector<std::vector<glm::uvec4>> gbuffer_;
    std::vector<uint32_t> words_;
    mutable uint64_t shadowTaps_ = 0, events_ = 0;
};

} // namespace agaa::test
