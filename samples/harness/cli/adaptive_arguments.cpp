#include "cli/adaptive_arguments.h"

#include "cli/arguments.h"

namespace harness {

void AdaptiveArguments::addTo(CLI::App& app) {
    app.add_option("--metrics", metrics,
                   "adaptive: what calls for further samples: none, geometry, shading or geometry,shading");
    app.add_option("--pattern", pattern,
                   "adaptive: samples on an ordered grid or at the device's places: grid or device");
    app.add_flag("--printed-metric", printedMetric, "adaptive: numbers of samples as in the paper");
    app.add_flag("--in-order", inOrder, "adaptive: samples in the pattern's order, as in the paper");
    app.add_flag("--equal-weights", equalWeights, "adaptive: the mean of the shaded samples, as in the paper");
    app.add_flag("--loop", loop, "adaptive: an invocation shades all samples of its pixel, as in the paper");
    app.add_flag("--buckets", buckets, "adaptive: numbers of samples are powers of two");
    app.add_flag("--sorted", sorted, "adaptive: pixels of like numbers of samples side by side");
    app.add_flag("--tile-maximum", tileMaximum, "adaptive: the largest number of samples in each tile");
    app.add_flag("--sample-footprints", sampleFootprints,
                 "adaptive by id: textures are filtered over the area of one sample");
    app.add_flag("--count-background", countBackground,
                 "adaptive: the printed metric counts samples of the background");
    app.add_flag("--compare-light", compareLight, "adaptive: samples whose light differs are shaded, too");
    app.add_option("--target-events", values.targetEvents,
                   "adaptive: mean number of samples per pixel that frames keep; 0: none");
    app.add_option("--count-memory", values.countMemory, "adaptive: share of mean numbers kept from frame to frame");
    app.add_option("--depth-scale", values.depthScale,
                   "adaptive: samples per variance of depth, with --printed-metric");
    app.add_option("--normal-scale", values.normalScale,
                   "adaptive: samples per spread of normals, with --printed-metric");
    app.add_option("--shading-scale", values.shadingScale, "adaptive: samples per range of a colour channel");
    app.add_option("--shading-threshold", values.shadingThreshold,
                   "adaptive: least range, as a share of the largest value");
    app.add_option("--shading-minimum", values.shadingMinimum, "adaptive: least range");
    app.add_option("--adaptive-gloss-weight", values.glossWeight, "adaptive: of shading normals");
}

void AdaptiveArguments::apply(TechniqueConfig& config) const {
    const void* next = config.adaptive.pNext; // the rest of the chain
    config.adaptive = values;
    config.adaptive.pNext = next;
    uint64_t& flags = config.adaptive.flags;
    flags = 0;
    if (metrics != "none" && metrics != "geometry" && metrics != "shading" && metrics != "geometry,shading")
        throw BadArgument("--metrics is \"" + metrics + "\"; it can be none, geometry, shading or geometry,shading.");
    if (pattern != "grid" && pattern != "device")
        throw BadArgument("--pattern is \"" + pattern + "\"; it can be grid or device.");
    const auto set = [&](bool on, uint64_t flag) { flags |= on ? flag : 0; };
    set(metrics.find("geometry") != std::string::npos, AGAA_ADAPTIVE_GEOMETRY);
    set(metrics.find("shading") != std::string::npos, AGAA_ADAPTIVE_SHADING);
    set(pattern == "device", AGAA_ADAPTIVE_DEVICE_PATTERN);
    set(printedMetric, AGAA_ADAPTIVE_PRINTED_METRIC);
    set(inOrder, AGAA_ADAPTIVE_IN_ORDER);
    set(equalWeights, AGAA_ADAPTIVE_EQUAL_WEIGHTS);
    set(loop, AGAA_ADAPTIVE_LOOP);
    set(buckets, AGAA_ADAPTIVE_BUCKETS);
    set(sorted, AGAA_ADAPTIVE_SORTED);
    set(tileMaximum, AGAA_ADAPTIVE_TILE_MAXIMUM);
    set(sampleFootprints, AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS);
    set(countBackground, AGAA_ADAPTIVE_BACKGROUND);
    set(compareLight, AGAA_ADAPTIVE_LIGHTS);
}

} // namespace harness
