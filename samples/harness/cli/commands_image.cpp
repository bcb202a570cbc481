// reference and compare: commands that write and read image files.
#include "cli/commands.h"

#include "image/metrics.h"
#include "render/fragment_capacity.h"
#include "render/reference.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace harness {

using nlohmann::json;

void runReference(const RenderArguments& arguments, bool asJson) {
    const Configuration configuration(arguments.plan);
    requireBackend(arguments.device.backend);
    const Scene scene = sceneOf(arguments);
    RenderSettings settings = renderSettings(arguments, configuration, scene);
    const auto renderer = makeRenderer(arguments.device);
    renderer->load(scene);
    if (configuration.fitsFragmentCapacity)
        fitFragmentCapacity(*renderer, settings);
    const auto begin = std::chrono::steady_clock::now();
    auto lastReport = begin;
    const auto report = [&](uint32_t done) {
        const auto now = std::chrono::steady_clock::now();
        if (now - lastReport <= std::chrono::seconds(5))
            return;
        lastReport = now;
        const double elapsed = std::chrono::duration<double>(now - begin).count();
        std::fprintf(stderr, "%u of %u samples, %.0f s left\n", done, arguments.spp,
                     elapsed * (arguments.spp - done) / done);
    };
    const Reference reference = renderReference(*renderer, settings, arguments.spp, report,
                                                arguments.footprint == "sample" ? Footprint::Sample : Footprint::Pixel);
    const Image& image = reference.image;
    if (!arguments.exr.empty())
        writeExr(arguments.exr, image);
    if (!arguments.png.empty())
        writePng(arguments.png, image);
    json messages = json::array();
    for (const ApiMessage& message : renderer->takeMessages())
        messages.push_back(message.text);
    const json out = {{"scene", arguments.scene},
                      {"spp", arguments.spp},
                      {"footprint", arguments.footprint},
                      {"splitHalfMse", reference.splitHalfMse},
                      {"splitHalfMseTm", reference.splitHalfMseTm},
                      {"apiMessages", messages}};
    if (asJson)
        std::cout << out.dump(2) << '\n';
    else
        std::printf("%u samples per pixel, split-half error %.3g linear, %.3g tone-mapped\n", arguments.spp,
                    reference.splitHalfMse, reference.splitHalfMseTm);
}

void runCompare(const CompareArguments& arguments, bool asJson) {
    const Image reference = readExr(arguments.reference);
    const Image test = readExr(arguments.test);
    const Metrics m = compareImages(reference, test);
    if (!arguments.difference.empty())
        writeDifferencePng(arguments.difference, reference, test, float(arguments.gain));
    if (asJson) {
        json out = metricsJson(m);
        out["maxAbs"] = m.maxAbs;
        out["meanAbsTm"] = m.meanAbsTm;
        out["above4of255"] = m.above4;
        out["pixelsPerDegree"] = m.pixelsPerDegree;
        std::cout << out.dump(2) << '\n';
        return;
    }
    std::printf("mse %.4g, tone-mapped %.4g, relMse %.4g, PSNR %.2f dB (peak %g), FLIP %.4f (95 %%: "
                "%.4f), largest difference %.4g\n",
                m.mse, m.mseTm, m.relMse, m.psnr, m.psnrPeak, m.flip, m.flipP95, m.maxAbs);
}

} // namespace harness
