#include "render/reference.h"

#include "image/tonemap.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace harness {

glm::dvec2 pixelOffset(uint32_t i) {
    constexpr double g = 1.32471795724474602596;
    const double x = 0.5 + double(i) / g;
    const double y = 0.5 + double(i) / (g * g);
    return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

AgaaLayout referenceLayout(const AgaaLayout* own) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    if (own)
        layout = *own;
    else
        agaaGetBuiltinLayout("precise", &layout);
    for (uint32_t i = 0; i < std::min<uint32_t>(layout.attributeCount, AGAA_MAX_LAYOUT_ATTRIBUTES); ++i)
        layout.attributes[i].sampleBits = 16;
    return layout;
}

// The mean of images, in which each pixel has the weight of AGAA_CONFIG_HDR_RESOLVE; with exposure 0 all are equal.
class ReferenceAccumulation::Half {
public:
    explicit Half(double exposure) : exposure_(exposure) {}
    void add(const Image& image) {
        sums_.resize(image.rgb.size());
        weights_.resize(image.rgb.size() / 3);
        for (size_t pixel = 0; pixel < weights_.size(); ++pixel) {
            const float* c = &image.rgb[3 * pixel];
            const double luminance = 0.2126 * double(c[0]) + 0.7152 * double(c[1]) + 0.0722 * double(c[2]);
            const double weight = 1 / (1 + exposure_ * std::max(luminance, 0.0));
            for (size_t i = 0; i < 3; ++i)
                sums_[3 * pixel + i] += weight * double(c[i]);
            weights_[pixel] += weight;
        }
    }
    double mean(size_t i) const { return sums_[i] / weights_[i / 3]; }
    size_t size() const { return sums_.size(); }

private:
    double exposure_;
    std::vector<double> sums_, weights_;
};

// A dither pattern that all frames shared would remain in the image. A pattern that references share would remain in
// their difference.
ReferenceAccumulation::ReferenceAccumulation(const RenderSettings& settings, uint32_t spp, Footprint footprint)
    : settings_(settings), layout_(referenceLayout(settings.config.layout)), centre_(settings.jitter),
      firstDither_(settings.ditherFrame * spp + 1),
      halves_(2, Half(settings.config.flags & AGAA_CONFIG_HDR_RESOLVE ? double(settings.exposure) : 0.0)) {
    settings_.config.technique = "ssaa";
    settings_.config.samples = 1;
    settings_.frames = 1;
    settings_.warmup = 0;
    settings_.config.layout = &layout_;
    if (footprint == Footprint::Sample)
        settings_.footprint = 1 / std::sqrt(double(spp));
}

ReferenceAccumulation::~ReferenceAccumulation() = default;

void ReferenceAccumulation::addSample(Renderer& renderer) {
    settings_.jitter = centre_ + pixelOffset(done_);
    settings_.ditherFrame = firstDither_ + done_;
    newest_ = renderer.render(settings_).image;
    halves_[done_++ & 1].add(newest_);
}

Reference ReferenceAccumulation::result() const {
    Reference reference;
    reference.image = newest_;
    // The mean of two halves of equal size has a quarter of the squared difference between them.
    for (size_t i = 0; i < halves_[0].size(); ++i) {
        const double a = halves_[0].mean(i), b = halves_[1].mean(i);
        reference.image.rgb[i] = float(0.5 * (a + b));
        reference.splitHalfMse += (a - b) * (a - b);
        reference.splitHalfMseTm += std::pow(toneMap(a) - toneMap(b), 2);
    }
    const double scale = 1.0 / (4.0 * double(halves_[0].size()));
    reference.splitHalfMse *= scale;
    reference.splitHalfMseTm *= scale;
    return reference;
}

Reference renderReference(Renderer& renderer, RenderSettings settings, uint32_t spp,
                          const std::function<void(uint32_t)>& progress, Footprint footprint) {
    ReferenceAccumulation accumulation(settings, spp, footprint);
    for (uint32_t i = 0; i < spp; ++i) {
        accumulation.addSample(renderer);
        if (progress)
            progress(i + 1);
    }
    return accumulation.result();
}

const Reference& SceneReferences::get(const std::string& frame, Renderer& renderer, const RenderSettings& settings,
                                      uint32_t spp) {
    const auto known = kept_.find(frame);
    if (known != kept_.end())
        return known->second;
    return kept_[frame] = renderReference(renderer, settings, spp);
}

nlohmann::json metricsJson(const Metrics& m) {
    nlohmann::json out = {{"mse", m.mse},           {"mseTm", m.mseTm}, {"relMse", m.relMse},
                          {"psnrPeak", m.psnrPeak}, {"flip", m.flip},   {"flipP95", m.flipP95}};
    out["psnr"] = std::isfinite(m.psnr) ? nlohmann::json(m.psnr) : nlohmann::json(); // equal images
    return out;
}

} // namespace harness
