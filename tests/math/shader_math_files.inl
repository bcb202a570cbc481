// All files of src/shaders/math in the namespace of one precision. The guards are dropped first,
// because the same files are wanted once for each precision.
#undef AGAA_MATH_REAL_GLSL
#undef AGAA_MATH_SANITISE_GLSL
#undef AGAA_MATH_ORDERED_BITS_GLSL
#undef AGAA_MATH_LIST_ORDER_GLSL
#undef AGAA_MATH_MATERIAL_FACTS_GLSL
#undef AGAA_MATH_PLACEMENT_GLSL
#undef AGAA_MATH_ADAPTIVE_GLSL
#undef AGAA_MATH_TILE_BATCHES_GLSL
#undef AGAA_MATH_ALPHA_COVERAGE_GLSL
#undef AGAA_MATH_COVERAGE_PATTERN_GLSL
#undef AGAA_MATH_TRIANGLE_COVERAGE_GLSL
#undef AGAA_MATH_COVERAGE_TABLE_GLSL
#undef AGAA_MATH_DEPTH_PLANE_GLSL
#undef AGAA_MATH_FACET_NORMAL_GLSL
#undef AGAA_MATH_STORED_PLANE_GLSL
#undef AGAA_MATH_TRIANGLE_HULL_GLSL
#undef AGAA_MATH_HULL_ROWS_GLSL
#undef AGAA_MATH_DISPLAY_GLSL
#undef AGAA_MATH_HDR_WEIGHT_GLSL
#undef AGAA_MATH_PIXEL_SUMS_GLSL
#undef AGAA_MATH_ENCODING_GLSL
#undef AGAA_MATH_BLENDED_SUMS_GLSL
#undef AGAA_MATH_METADATA_GLSL
#undef AGAA_MATH_SECOND_MOMENTS_GLSL
#undef AGAA_MATH_NDF_GLSL
#undef AGAA_MATH_NORMAL_SPREAD_GLSL
#undef AGAA_MATH_NORMAL_MOMENTS_GLSL
#undef AGAA_MATH_DEPTH_MOMENTS_GLSL
#undef AGAA_MATH_SGGX_GLSL
#undef AGAA_MATH_BRDF_GLSL
#undef AGAA_MATH_DEPTH_GLSL
#undef AGAA_MATH_BARYCENTRICS_GLSL
#undef AGAA_MATH_STATISTICS_GLSL
#undef AGAA_MATH_LIGHT_GLSL
#undef AGAA_MATH_LIGHT_CULLING_GLSL
#undef AGAA_MATH_CLUSTERING_GLSL
#undef AGAA_MATH_SBAA_SURFACES_GLSL
#undef AGAA_MATH_SBAA_RECORDS_GLSL
#undef AGAA_MATH_SURFACE_MERGE_GLSL
#undef AGAA_MATH_SURFACE_STREAM_GLSL
#undef AGAA_MATH_SURFACE_RESOLVE_GLSL
#undef AGAA_MATH_EDGE_SHARES_GLSL
#undef AGAA_MATH_HISTORY_GLSL

#include "../../src/shaders/math/real.glsl"
#include "../../src/shaders/math/sanitise.glsl"
#include "../../src/shaders/math/ordered_bits.glsl"
#include "../../src/shaders/math/material_facts.glsl"
#include "../../src/shaders/math/placement.glsl"
#include "../../src/shaders/math/alpha_coverage.glsl"
#include "../../src/shaders/math/coverage_pattern.glsl"
#include "../../src/shaders/math/triangle_coverage.glsl"
#include "../../src/shaders/math/coverage_table.glsl"
#include "../../src/shaders/math/depth_plane.glsl"
#include "../../src/shaders/math/facet_normal.glsl"
#include "../../src/shaders/math/stored_plane.glsl"
#include "../../src/shaders/math/surface_resolve.glsl"
#include "../../src/shaders/math/triangle_hull.glsl"
#include "../../src/shaders/math/hull_rows.glsl"
#include "../../src/shaders/math/display.glsl"
#include "../../src/shaders/math/hdr_weight.glsl"
#include "../../src/shaders/math/pixel_sums.glsl"
#include "../../src/shaders/math/encoding.glsl"
#include "../../src/shaders/math/blended_sums.glsl"
#include "../../src/shaders/math/metadata.glsl"
#include "../../src/shaders/math/sbaa_records.glsl"
#include "../../src/shaders/math/second_moments.glsl"
#include "../../src/shaders/math/ndf.glsl"
#include "../../src/shaders/math/normal_spread.glsl"
#include "../../src/shaders/math/normal_moments.glsl"
#include "../../src/shaders/math/depth_moments.glsl"
#include "../../src/shaders/math/sggx.glsl"
#include "../../src/shaders/math/brdf.glsl"
#include "../../src/shaders/math/depth.glsl"
#include "../../src/shaders/math/barycentrics.glsl"
#include "../../src/shaders/math/statistics.glsl"
#include "../../src/shaders/math/light.glsl"
#include "../../src/shaders/math/light_culling.glsl"
#include "../../src/shaders/math/adaptive.glsl"
#include "../../src/shaders/math/tile_batches.glsl"
#include "../../src/shaders/math/edge_shares.glsl"
#include "../../src/shaders/math/history.glsl"

struct FragmentLists {
    std::vector<uint> words;
    uint agaa_fragmentWord(uint at) const { return words[at]; }
#include "../../src/shaders/math/list_order.glsl"
};

struct Clustering {
    bool hasClasses = false, hasPlanes = false;
#define AGAA_CLASSES hasClasses
#define AGAA_PLANES hasPlanes
#include "../../src/shaders/math/clustering.glsl"
#include "../../src/shaders/math/sbaa_surfaces.glsl"
#undef AGAA_PLANES
#undef AGAA_CLASSES
};

struct KeptSurfaces {
    real colors[9] = {}; // of surfaces, for AGAA_RULE_COLOR
#define AGAA_COLOR_DIFFERENCE(i, k) std::abs(colors[i] - colors[k])
#include "../../src/shaders/math/surface_merge.glsl"
#undef AGAA_COLOR_DIFFERENCE
    real nearest[128];
    real agaa_nearestDepth(uint i) const { return nearest[i]; }
    void agaa_setNearestDepth(uint i, real depth) { nearest[i] = depth; }
    static agaa_CoveredSurface agaa_rounded(const agaa_CoveredSurface& s) { return s; }
#include "../../src/shaders/math/surface_stream.glsl"
};
