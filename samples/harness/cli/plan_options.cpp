#include "cli/plan_options.h"

namespace harness {

void addPlanOptions(CLI::App& app, PlanArguments& a) {
    app.add_option("--technique", a.technique, "see agaa-harness caps: single, ssaa, agaa, dcaa, adaptive …");
    app.add_option("--samples", a.samples,
                   "n: visibility samples per pixel; dcaa: coverage samples; 9 on an ordered grid");
    app.add_option("--aggregates", a.aggregates,
                   "c: aggregates per pixel, 1 to 4; S: surfaces of sbaa, 1 to 6, of dcaa, 1 to 8");
    app.add_option("--layout", a.layout, "paper16, precise, dcaa28, reference or a JSON file");
    app.add_option("--tier", a.tiers, "native, auto or stage=tier; repeatable")->take_all()->allow_extra_args(false);
    app.add_option("--size", a.size, "WxH");
    app.add_option("--reversed-z", a.reversedZ, "1: near is 1, far is infinite and 0");
    app.add_option("--expand", a.expand,
                   "what expands triangles: geometry or pulling shaders, or compute, also for agaa by ids");
    app.add_flag("--no-stencil", a.noStencil, "first come, first kept on equal depth");
    app.add_flag("--no-culling", a.noCulling, "every shading event evaluates all lights of the frame");
    app.add_flag("--check-facts", a.checkFacts, "inspect materials for what the scene's facts say");
}

void addShadingOptions(CLI::App& app, PlanArguments& a) {
    app.add_option("--brdf", a.brdf, "blinn-phong or ggx");
    app.add_option("--ndf", a.ndf, "none, toksvig, lean or sggx");
    app.add_option("--seeds", a.seeds, "maximin or sum-of-squares");
    app.add_option("--lanes", a.lanes, "of passes with several variants: auto, pixel, shared or subgroup");
    app.add_option("--k", a.k, "characteristic length in scene units");
    app.add_option("--k-per-distance", a.kPerDistance, "at least this times the distance");
    app.add_option("--threshold", a.threshold, "t: least distance between aggregates");
    app.add_option("--surface", a.surface, "one surface: least cosine, widths of a pixel, material; 0: default");
    app.add_option("--merge", a.merge,
                   "dcaa: what a discarded surface gives to another, visible, paper, none or color");
    app.add_option("--fragments-per-pixel", a.fragmentsPerPixel,
                   "that lists of fragments have room for; auto: as a frame needs");
    app.add_option("--max-batches", a.maxBatches, "draws of the scene where lists have too little room; 0: 16");
    app.add_flag("--exact", a.exact, "dcaa: keep and shade all fragments that show");
    app.add_flag("--draw-order", a.drawOrder, "lists of fragments keep the order of the draws");
    app.add_flag("--reverse-order", a.reverseOrder, "lists of fragments begin with the last draw");
    app.add_flag("--depth-prepass", a.depthPrepass, "a depth prepass drops hidden fragments, approximately");
    app.add_option("--coverage-pattern", a.coveragePattern,
                   "positions of coverage samples: library, or r2 by a table of half-planes");
    app.add_option("--table-size", a.tableSize, "entries a side of the table of half-planes for r2; 0: 128");
    a.adaptive.addTo(app);
    a.temporal.addTo(app);
    app.add_option("--gloss-weight", a.glossWeight, "agaa by id or from a G-buffer: of shading normals");
    app.add_flag("--lit", a.lit, "agaa by id or from a G-buffer: lit statistics for the lights with shadows");
    app.add_flag("--buffered", a.buffered,
                 "agaa by id or from a G-buffer: aggregates in memory, shaded by a pass of their own");
    app.add_option("--unfetched-every", a.unfetchedEvery, "agaa by id: so many-th draws that cannot be fetched");
    app.add_option("--view", a.view, "show events, aggregates, clusters, primitives, lit, widened or tier");
    app.add_option("--shadow-taps", a.shadowTaps, "per aggregate, at most; 0: 8");
    app.add_option("--shading-cost", a.shadingCost, "evaluate lighting this many times");
    app.add_flag("--split-surfaces", a.splitSurfaces, "agaa: one surface may make several aggregates");
    app.add_flag("--fine-materials", a.fineMaterials, "agaa by id: a material in each texel of the scaled target");
    app.add_flag("--hdr-resolve", a.hdrResolve, "weight light by 1 / (1 + exposure luminance)");
    app.add_option("--exposure", a.exposure, "of --hdr-resolve")->check(CLI::Range(0.0, 1e9));
    app.add_flag("--first-sample-routing", a.firstSampleRouting, "the paper's algorithm 2, step 2 (c)");
    app.add_flag("--no-diffuse-filter", a.noDiffuseFilter);
    app.add_flag("--no-shadow-filter", a.noShadowFilter);
    app.add_flag("--shadow-along-depth", a.shadowAlongDepth, "the paper's shadow taps");
    app.add_flag("--shadow-covariance", a.shadowCovariance, "shadow taps along the longest axis of an aggregate");
    app.add_flag("--stored-depth", a.storedDepth, "agaa by two passes: aggregates store moments of depth");
    app.add_flag("--depth-planes", a.depthPlanes, "agaa: planes are grouped in place of samples, where they are few");
    app.add_flag("--light-directions", a.lightDirections, "widen lobes by the variance of light directions");
    app.add_option("--diffuse-filter", a.diffuseFilter, "agaa: rectified, mises-fisher or sggx");
    CLI::Option* preset = app.add_option("--preset", a.preset, "paper, fast, balanced or accurate: settings of agaa");
    for (const char* decided :
         {"--technique", "--aggregates", "--ndf", "--seeds", "--threshold", "--surface", "--gloss-weight", "--lit",
          "--shadow-taps", "--split-surfaces", "--fine-materials", "--first-sample-routing", "--no-diffuse-filter",
          "--no-shadow-filter", "--shadow-along-depth", "--shadow-covariance"})
        preset->excludes(app.get_option(decided));
}

} // namespace harness
