// reference, compare: images as files.
#include "cli/commands.h"

#include "image/metrics.h"
#include "image/tonemap.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace harness {

using nlohmann::json;

namespace {

// Frame i of a sequence that fills the pixel evenly at every length (Roberts 2018, R2): the box filter
// of one pixel.
glm::dvec2 pixelOffset(uint32_t i) {
    constexpr double g = 1.32471795724474602596;
    const double x = 0.5 + double(i) / g;
    const double y = 0.5 + double(i) / (g * g);
    return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

class Accumulator {
public:
    void add(const Image& image) {
        if (sums_.empty())
            sums_.assign(image.rgb.size(), 0.0);
        for (size_t i = 0; i < sums_.size(); ++i)
            sums_[i] += double(image.rgb[i]);
        ++count_;
    }
    double mean(size_t i) const { return sums_[i] / double(count_); }
    size_t size() const { return sums_.size(); }

private:
    std::vector<double> sums_;
    size_t count_ = 0;
};

} // namespace

void runReference(const RenderArguments& arguments, bool asJson) {
    PlanArguments plan = arguments.plan;
    plan.technique = "ssaa";
    plan.samples = 1;
    const Configuration configuration(plan);
    requireBackend(arguments.device.backend);
    const Scene scene = loadSceneArgument(arguments.scene);
    RenderSettings settings = renderSettings(arguments, configuration, scene);
    settings.frames = 1;
    settings.warmup = 0;
    const auto renderer = makeRenderer(arguments.device);
    renderer->load(scene);
    Accumulator halves[2];
    Image image;
    const auto begin = std::chrono::steady_clock::now();
    auto told = begin;
    for (uint32_t i = 0; i < arguments.spp; ++i) {
        settings.jitter = pixelOffset(i);
        image = renderer->render(settings).image;
        halves[i & 1].add(image);
        const auto now = std::chrono::steady_clock::now();
        if (now - told > std::chrono::seconds(5)) {
            told = now;
            const double elapsed = std::chrono::duration<double>(now - begin).count();
            std::fprintf(stderr, "%u of %u samples, %.0f s left\n", i + 1, arguments.spp,
                         elapsed * (arguments.spp - i - 1) / (i + 1));
        }
    }
    // The mean of two halves of equal size has a quarter of the squared difference between them.
    double linear = 0, toneMapped = 0;
    for (size_t i = 0; i < halves[0].size(); ++i) {
        const double a = halves[0].mean(i), b = halves[1].mean(i);
        image.rgb[i] = float(0.5 * (a + b));
        linear += (a - b) * (a - b);
        toneMapped += std::pow(toneMap(a) - toneMap(b), 2);
    }
    const double scale = 1.0 / (4.0 * double(halves[0].size()));
    if (!arguments.exr.empty())
        writeExr(arguments.exr, image);
    if (!arguments.png.empty())
        writePng(arguments.png, image);
    json messages = json::array();
    for (const ApiMessage& message : renderer->takeMessages())
        messages.push_back(message.text);
    const json out = {{"scene", arguments.scene},
                      {"spp", arguments.spp},
                      {"splitHalfMse", linear * scale},
                      {"splitHalfMseTm", toneMapped * scale},
                      {"apiMessages", messages}};
    if (asJson)
        std::cout << out.dump(2) << '\n';
    else
        std::printf("%u samples per pixel, split-half error %.3g linear, %.3g tone-mapped\n",
                    arguments.spp, linear * scale, toneMapped * scale);
}

void runCompare(const CompareArguments& arguments, bool asJson) {
    const Image reference = readExr(arguments.reference);
    const Image test = readExr(arguments.test);
    const Metrics m = compareImages(reference, test);
    if (!arguments.difference.empty())
        writeDifferencePng(arguments.difference, reference, test, float(arguments.gain));
    if (asJson) {
        json out = {{"mse", m.mse},   {"mseTm", m.mseTm}, {"relMse", m.relMse},
                    {"psnrPeak", m.psnrPeak}, {"flip", m.flip},   {"flipP95", m.flipP95},
                    {"maxAbs", m.maxAbs},     {"meanAbsTm", m.meanAbsTm},
                    {"above4of255", m.above4}, {"pixelsPerDegree", m.pixelsPerDegree}};
        out["psnr"] = std::isfinite(m.psnr) ? json(m.psnr) : json(); // equal images
        std::cout << out.dump(2) << '\n';
        return;
    }
    std::printf("mse %.4g, tone-mapped %.4g, relMse %.4g, PSNR %.2f dB (peak %g), FLIP %.4f (95 %%: "
                "%.4f), largest difference %.4g\n",
                m.mse, m.mseTm, m.relMse, m.psnr, m.psnrPeak, m.flip, m.flipP95, m.maxAbs);
}

} // namespace harness
