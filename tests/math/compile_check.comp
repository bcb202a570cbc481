// Every file of the shared mathematics in one Vulkan compute shader, each function called once so
// that nothing is dropped before it has been compiled.
#version 450
#extension GL_GOOGLE_include_directive : require

#define AGAA_MAX_SAMPLES 32

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
#include "../../src/shaders/math/triangle_hull.glsl"
#include "../../src/shaders/math/hull_rows.glsl"
#include "../../src/shaders/math/surface_merge.glsl"
float agaa_nearestDepths[64];
float agaa_nearestDepth(uint i) { return agaa_nearestDepths[i]; }
void agaa_setNearestDepth(uint i, float depth) { agaa_nearestDepths[i] = depth; }
agaa_CoveredSurface agaa_rounded(agaa_CoveredSurface s) { return s; }
#include "../../src/shaders/math/surface_stream.glsl"
#include "../../src/shaders/math/surface_resolve.glsl"
#include "../../src/shaders/math/display.glsl"
#include "../../src/shaders/math/hdr_weight.glsl"
#include "../../src/shaders/math/pixel_sums.glsl"
#include "../../src/shaders/math/encoding.glsl"
#include "../../src/shaders/math/blended_sums.glsl"
#include "../../src/shaders/math/metadata.glsl"
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
#define AGAA_CLASSES true
#define AGAA_PLANES true
#include "../../src/shaders/math/clustering.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0) readonly buffer Input { vec4 inputs[]; };
layout(set = 0, binding = 1) writeonly buffer Output { vec4 outputs[]; };

uint agaa_fragmentWord(uint at) { return agaa_orderedBits(inputs[at].x); }
#include "../../src/shaders/tables/layouts.inc"
#include "../../src/shaders/math/list_order.glsl"

void main() {
    const uint id = gl_GlobalInvocationID.x;
    const vec4 x = inputs[id];
    uint bad = 0u;
    vec3 v = agaa_sanitise3(x.xyz, 0.0, 65504.0, bad) + agaa_sanitiseEmission(x.yzw, x.x, bad);
    vec3 t;
    vec3 b;
    agaa_viewBasis(normalize(v), t, b);
    vec3 n;
    float len;
    agaa_meanDirection(v, t, n, len);
    vec3 acc = agaa_decodeHemiOct8(agaa_encodeHemiOct8(n)) + t + b;
    acc += agaa_decodeOct(agaa_encodeOct(n, 10u), 10u);
    acc += agaa_yCbCrToRgb(agaa_rgbToYCbCr(v));
    acc.x += agaa_signedMeanOfSum(agaa_signedCode(x.w, 11u), 3u, 11u) +
             agaa_meanOfSum(agaa_quantise(x.x, 11u), 3u, 11u);
    acc.x += agaa_signedMeanOfBlended(agaa_blendedCode(agaa_blendedValue(x.w, 3u, 8u, 10u, true), 10u), 3u, 8u, 10u) +
             agaa_meanOfBlended(agaa_blendedCode(agaa_blendedValue(x.x, 3u, 8u, 16u, false), 16u), 3u, 8u, 16u) +
             agaa_blendedMask(id, 1u);
    agaa_Barycentrics inside = agaa_barycentrics(v, acc, x.yzw, x.xy, x.zw);
    acc += inside.at + inside.dx + inside.dy + inside.facing;
    acc += agaa_emissiveFactor(v, acc);
    acc.x += agaa_mixDisplayed(x.x, x.y, x.z) + agaa_colorDifference(agaa_displayed(v), t) + agaa_displayLuma(v);
    acc.xyz += agaa_lightOfWeightedMean(agaa_weightByLuminance(v, x.x), x.x);
    acc.x += agaa_isCutoutByFacts(x.x, x.y > 0.0, x.z > 0.0) && agaa_isEmissive(v, x.w) ? 1.0 : 0.0;
    acc.y += agaa_isElsewhere(x.xy, x.z, x.w, x.x, x.y) ? 1.0 : 0.0;
    acc.z += agaa_fromOrderedBits(agaa_orderingWord(id, id + 5u, AGAA_FRAGMENT_MASK_AT + 2u));
    acc.z += float(agaa_translucentMask(x.w, 4u, 1u, 2u, agaa_translucencyHash(id, 1u, 2u, 3u)));
    acc.z += agaa_isInCutout(x.w, x.x, x.xy, x.zw) ? 1.0 : 0.0;
    acc.y += agaa_toksvigAlpha2(x.y,
                                agaa_varianceFloor(len, agaa_storedLengthBound(1u, 16u)));
    acc.z += agaa_alpha2FromFoldedLength(agaa_foldedLength(x.z)) + agaa_exponentFromAlpha2(x.z);
    acc.z += agaa_rangeReaches(v, x.x, t, b) && agaa_coneReaches(v, t, x.y, b, x.z) ? 1.0 : 0.0;
    agaa_Moments m = agaa_momentsInit(x.x);
    agaa_momentsAdd(m, x.y);
    uint word = agaa_packCount(9u, agaa_wholeCount(agaa_shadingCount(x.x, x.y, 0.1, 0.1, x.z), 1u, 9u), x.w);
    uint number = agaa_countIn(word) + agaa_coveredIn(word);
    acc.x += agaa_leftIn(word) + agaa_normalStep(v, t, x.x) + agaa_planeStep(v, t, b, x.y) + agaa_meanOfCounts(x.x, number, x.y) +
             agaa_differenceOfBin(agaa_bucketOfCount(agaa_differenceBin(x.z)));
    acc.x += agaa_momentsVariance(m) + agaa_normalMetric(x.y) +
             agaa_depthTap(id, x.x, x.y, x.z, x.w);
    const float z = agaa_viewZFromDepth(x.x, x.y, x.z, bad);
    acc.z += agaa_depthQuantum(z, x.x, x.y, x.z, bad, 1e-6) + agaa_depthOfViewZ(z, x.x, x.y, bad);
    acc.x += agaa_meanOfTerms(agaa_sumTerm(x.x), 3u) + agaa_meanOfDepthTerms(agaa_depthSumTerm(x.y), 3u);
    acc.z += agaa_characteristicLength(x.x, x.y, agaa_scaleDistance(z, x.z, bad));
    acc += agaa_viewPosition(x.xy, z, x.x, x.y, x.z, x.w, bad);
    agaa_Surface s;
    s.diffuse = v;
    s.specular = v;
    s.emissive = v;
    s.normal = n;
    s.meanLength = len;
    s.alpha2 = x.w;
    agaa_SecondMoments spread = agaa_SecondMoments(v, t);
    agaa_addSecondMoments(spread, x.y, n);
    spread = agaa_momentsInBasis(agaa_momentsAroundMean(spread, x.z, b), n, t, b);
    agaa_spreadAlpha2(spread, n, len, x.z, id & 1u, 1e-6, s.axis, s.alpha2Along, s.alpha2);
    agaa_addDirectionVariance(s, agaa_directionVariance(spread, b) + agaa_longestAxis(spread, b));
    acc.x += agaa_sggxCosine(spread, n, t);
    acc += agaa_shade(s, t, agaa_lightDirection(b, 1e-4), bad, id & 1u, id & 2u) *
           agaa_pointAttenuation(x.x, x.y, 1e-4) * agaa_spotCone(x.x, x.y, x.z);
    for (uint i = 0u; i < 32u; ++i) {
        agaa_samplePosition[i] = inputs[id * 32u + i].xyz;
        agaa_sampleNormal[i] = n;
        agaa_sampleKeyA[i] = i;
        agaa_sampleKeyB[i] = i;
        agaa_sampleStep[i] = x.w;
    }
    const uint count = agaa_defineAggregates(32u, 0xFFFFFFFFu, 4u, 0.1, 0.02, id & 1u);
    uvec2 planes = uvec2(0u);
    for (uint i = 0u; i < 32u; ++i) {
        agaa_putAggregateId(planes, i, agaa_sampleAggregate[i]);
    }
    planes = agaa_loadedPlanes(agaa_storedPlanes(planes, 32u, 4u), 32u, 4u);
    const vec3 p = agaa_vertexInPixels(v, x.xy);
    const uvec4 covered = agaa_triangleCoverage(p, acc, x.yzw, x.xy, 128u) ^
                          agaa_triangleCoverage(p, acc, x.yzw, x.xy, 64u);
    const agaa_CoverageLookup found = agaa_findCoverage(p, acc, 128u);
    agaa_keptCount = 0u;
    const agaa_FacetFrame facets = agaa_facetFrame(x.xy, x.yz, x.zw, x.wx, x.x, id & 1u, 1.0);
    agaa_CoveredSurface kept = agaa_CoveredSurface(covered, x.xyz, x.xyz, vec3(0.0, 0.0, 1.0));
    acc.y += agaa_insertSurface(kept, agaa_MergeRules(4u, 0.9, 0.0, AGAA_RULE_PAPER, facets, false)).share;
    acc.y += agaa_streamSurface(kept, agaa_MergeRules(4u, 0.9, 0.0, AGAA_RULE_VISIBLE, facets, true), 64u).share;
    acc.x += float(agaa_coverageCount(agaa_foundCoverage(found, covered, 64u)));
    acc.y += agaa_isInTableEntry(found.entry, 128u, agaa_coveragePosition(id & 63u, 64u)) ? 1.0 : 0.0;
    acc.z += agaa_isCovered(covered, id & 63u) ? 1.0 : 0.0;
    const agaa_DepthPlane plane = agaa_depthPlane(p, acc, x.yzw, v, x.xy);
    acc.x += agaa_depthAt(plane, x.zw) + (agaa_depthsOverlap(plane, plane, x.x) ? 1.0 : 0.0);
    acc.x += float(agaa_batchOfNextTile(agaa_TileBatch(1u, planes.x), agaa_saturatingSum(planes.y, id), 65536u).number);
    const agaa_Hull hull = agaa_triangleHull(x, x.yzwx, x.zwxy, vec2(1.0, 0.0), x.xy);
    acc += hull.vertices[hull.count & 7u].xyz;
    const agaa_Outline outline = agaa_triangleOutline(x, x.yzwx, x.zwxy, vec2(1.0, 0.0), abs(x.xy));
    if (outline.count != 0u) {
        const agaa_Span rows = agaa_outlineRows(outline, x.y), columns = agaa_outlineColumns(outline, x.x);
        const agaa_Span span = agaa_outlineSpan(outline, rows.first, x.x);
        acc += vec3(rows.last, columns.first + columns.last, span.first + span.last);
    }
    outputs[id] = vec4(acc, float(count + agaa_samplesOfAggregate(planes, 3u)));
}
