// Selects the surfaces that a pixel keeps, with one lane per sample. math/sbaa_surfaces.glsl has one lane per pixel,
// and its results are equal bit for bit. Needs what aggregate/lane_clustering.glsl needs.
#ifndef AGAA_LANE_SURFACES_GLSL
#define AGAA_LANE_SURFACES_GLSL
#include "aggregate/lane_clustering.glsl"

// Words of lanes behind those of planes.
#define AGAA_SURFACE_SAMPLES_AT 7u
#define AGAA_SURFACE_SHADED_AT 8u

// A surface of the pixel. Lane s has surface s, in descending order of samples before others joined.
struct agaa_LaneSurface {
    uint samples; // 0: no surface
    uint shaded;  // the sample whose attributes represent it
};

// Inserts a surface into those that the pixel keeps, as agaa_keepSurface() does.
// kept   Number of kept surfaces.
// mask   Samples of the new one.
// own    Samples of the surface of this lane.
uint agaa_keepSurfaceLane(uint kept, uint mask, uint own) {
    const uint lane = agaa_laneSample();
    uint smaller = agaa_samplesWhere(lane < kept && bitCount(own) < bitCount(mask));
    uint index = smaller != 0u ? uint(findLSB(smaller)) : kept;
    agaa_syncLanes();
    AGAA_LANE_WORD(agaa_laneIndex(), AGAA_SURFACE_SAMPLES_AT) = own;
    agaa_syncLanes();
    uint previous = AGAA_LANE_WORD(agaa_firstLane() + max(lane, 1u) - 1u, AGAA_SURFACE_SAMPLES_AT);
    if (lane < AGAA_AGGREGATES && mask != 0u) {
        if (lane == index)
            own = mask;
        else if (lane > index && lane <= kept)
            own = previous;
    }
    return own;
}

// Returns the sample of the mask that is nearest to the mean of their positions, as agaa_centralSample() does. Sums run
// in the order of the samples.
uint agaa_centralSampleLane(uint mask) {
    const uint firstLane = agaa_firstLane();
    vec3 sum = vec3(0.0);
    vec3 origin = sum;
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        vec3 position = agaa_publishedPosition(firstLane + uint(findLSB(rest)));
        origin = rest == mask ? position : origin;
        sum += position - origin; // small numbers: hard case 14
    }
    const vec3 mean = origin + sum / float(max(bitCount(mask), 1));
    uint best = 0u;
    float bestDistance = 3.0e38;
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        vec3 away = agaa_publishedPosition(firstLane + i) - mean;
        float d = dot(away, away);
        if (d < bestDistance) {
            best = i;
            bestDistance = d;
        }
    }
    return best;
}

// Returns the kept surface that is nearest to this lane's sample. The surfaces are published.
uint agaa_nearestSurfaceLane(agaa_LaneSample s, uint kept, agaa_Lengths lengths) {
    uint best = 0u;
    float bestDistance = 3.0e38;
    for (uint k = 0u; k < kept; ++k) {
        uint shaded = AGAA_LANE_WORD(agaa_firstLane() + k, AGAA_SURFACE_SHADED_AT);
        float d = agaa_distanceToSample(s, shaded, lengths);
        if (d < bestDistance) {
            best = k;
            bestDistance = d;
        }
    }
    return best;
}

// Selects the surfaces of the pixel, as agaa_selectSurfaces() does, and returns that of this lane.
agaa_LaneSurface agaa_selectSurfaceLane(agaa_LaneSample s) {
    const uint lane = agaa_laneSample();
    const uint covered = agaa_samplesWhere(s.isCovered);
    agaa_syncLanes(); // the lanes have read the samples of the previous pixel
    agaa_publishPlane(s);
    agaa_syncLanes();
    agaa_PixelSamples samples = agaa_pixelOfLanes(s, covered);
    const float width = agaa_surfaceWidth(samples);
    agaa_LaneSurface surface = agaa_LaneSurface(0u, 0u);
    uint kept = 0u;
    uint left = covered;
    while (agaa_anyLane(left != 0u)) {
        const uint seed = uint(max(findLSB(left), 0));
        agaa_Plane plane = agaa_publishedPlane(agaa_firstLane() + seed);
        bool isOn = (left >> lane & 1u) != 0u &&
                    (lane == seed ||
                     agaa_areOnOnePlane(plane, agaa_planeOf(s), agaa_frame.surfaceCosine, width));
        uint mask = agaa_samplesWhere(isOn);
        left &= ~mask;
        surface.samples = agaa_keepSurfaceLane(kept, mask, surface.samples);
        kept = min(kept + (mask != 0u ? 1u : 0u), AGAA_AGGREGATES);
    }
    if (lane < kept)
        surface.shaded = agaa_centralSampleLane(surface.samples);
    agaa_syncLanes();
    AGAA_LANE_WORD(agaa_laneIndex(), AGAA_SURFACE_SAMPLES_AT) = surface.samples;
    AGAA_LANE_WORD(agaa_laneIndex(), AGAA_SURFACE_SHADED_AT) = surface.shaded;
    agaa_syncLanes();
    uint taken = 0u;
    for (uint k = 0u; k < kept; ++k)
        taken |= AGAA_LANE_WORD(agaa_firstLane() + k, AGAA_SURFACE_SAMPLES_AT);
    const bool joins = s.isCovered && (taken >> lane & 1u) == 0u;
    const agaa_Lengths lengths =
        agaa_lengthsFor(agaa_pixelCharacteristicLength(samples), agaa_frame.aggregateThreshold);
    uint nearest = agaa_nearestSurfaceLane(s, joins ? kept : 0u, lengths);
    for (uint k = 0u; k < AGAA_AGGREGATES; ++k) {
        uint more = agaa_samplesWhere(joins && nearest == k);
        surface.samples |= lane == k ? more : 0u;
    }
    return surface;
}
#endif
