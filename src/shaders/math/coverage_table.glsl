// Coverage by a table of half-planes, for patterns of samples that have no rows.
// Source: DCAA (Wang et al., I3D 2016) section 3.1, figure 3; Waller et al. 2000, "Efficient coverage mask generation
// for antialiasing".
//
// A table has size * size masks: entry direction * size + distance. Entry size * size is empty. Only half of all
// directions are stored; the others are complements, so that the two sides of an edge stay complementary. Edges are
// rounded to the nearest entry: about 1.5 % of the samples that small triangles cover are wrong at size 128, and half
// as many at size 256.
#ifndef AGAA_MATH_COVERAGE_TABLE_GLSL
#define AGAA_MATH_COVERAGE_TABLE_GLSL
#include "coverage_pattern.glsl"
#include "real.glsl"
#include "triangle_coverage.glsl"

// Returns the line of an entry, a x + b y + c with |a| + |b| = 1. The diamond angle a gives b without trigonometry.
rvec3 agaa_coverageTableLine(uint entry, uint size) {
    const real a = (real(entry / size) + real(0.5)) * real(2.0) / real(size) - real(1.0);
    const real c = (real(entry % size) + real(0.5)) / real(size) - real(0.5);
    return rvec3(a, real(1.0) - abs(a), c);
}

// Returns whether the entry's mask has the sample at this position, from the pixel's centre.
bool agaa_isInTableEntry(uint entry, uint size, rvec2 position) {
    const rvec3 line = agaa_coverageTableLine(entry, size);
    return entry < size * size && line.x * position.x + line.y * position.y + line.z >= real(0.0);
}

// Returns the texel of an entry: distance and direction.
uvec2 agaa_tableTexel(uint entry, uint size) {
    return uvec2(entry % size, entry / size);
}

struct agaa_CoverageLookup {
    uint entry;
    bool complement; // the covered samples are those outside the entry's mask
};

// Finds the entry of the edge from a to b, which are those of agaa_vertexFromCentre(). Covered samples are on its left.
agaa_CoverageLookup agaa_findCoverage(rvec3 a, rvec3 b, uint size) {
    const rvec3 line = agaa_edgeLine(a, b);
    agaa_CoverageLookup result;
    result.entry = size * size;
    PRECISE real length = abs(line.x) + abs(line.y); // meshes that share an edge may have different shaders
    if (!(abs(line.z) < length * real(0.5))) {
        result.complement = line.z > real(0.0) || (line.z == real(0.0) && agaa_isOrdered(a, b));
        return result;
    }
    result.complement = line.y < real(0.0) || (line.y == real(0.0) && line.x < real(0.0));
    const real side = result.complement ? real(-1.0) : real(1.0);
    PRECISE real direction = (side * line.x / length + real(1.0)) * (real(0.5) * real(size));
    PRECISE real distance = (side * line.z / length + real(0.5)) * real(size);
    const real last = real(size - 1u);
    result.entry = uint(clamp(direction, real(0.0), last)) * size + uint(clamp(distance, real(0.0), last));
    return result;
}

uvec4 agaa_foundCoverage(agaa_CoverageLookup lookup, uvec4 mask, uint samples) {
    return lookup.complement ? agaa_coverageComplement(mask, samples) : mask;
}

#endif
