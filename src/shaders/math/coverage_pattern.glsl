// The coverage samples of a pixel and masks of them: 32, 64 or 128 samples, independent of the samples of the target.
// Source: DCAA (Wang et al., I3D 2016) section 3.1.
//
// Samples lie in rows. Along a row they are equally spaced, so that a half-plane covers a span of each row. Every row
// is shifted by its own phase. The phases and row lengths are chosen by the error of the covered area over edges of any
// direction, level and upright edges, strips and triangles together: tests/math/coverage_patterns.cpp. The patterns of
// 32 and 64 samples continue as lattices across pixel borders.
//
//   samples   rows   columns   phase of row r
//        32     16         2   (5 r mod 16) / 16
//        64     16         4   (7 r mod 16) / 16
//       128     32         4   (41 r mod 64) / 64
//
// Sample row * columns + column is bit i & 31 of word i >> 5 of a mask; words without samples are 0. All coordinates
// are multiples of 1/512, so that float holds them exactly.
//
// Shaders with the constants of a frame may have a pattern of the host instead, whose masks come from a table of
// half-planes (coverage_table.glsl). They need AGAA_TABLE_SIZE, which common/constants.glsl has.
#ifndef AGAA_MATH_COVERAGE_PATTERN_GLSL
#define AGAA_MATH_COVERAGE_PATTERN_GLSL
#include "real.glsl"

#ifdef AGAA_FRAME_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_TABLE_SIZE)
#error "coverage_pattern.glsl needs AGAA_TABLE_SIZE."
#endif
#ifndef AGAA_COVERS_TARGET
#define AGAA_COVERS_TARGET 0 // 1: the samples are those of the target
#endif
bool agaa_hasHostPattern() {
    return AGAA_TABLE_SIZE != 0u || AGAA_COVERS_TARGET == 1;
}
rvec2 agaa_hostPosition(uint i) {
    return agaa_sampleLocation(i) - rvec2(real(0.5));
}
#else
bool agaa_hasHostPattern() {
    return false;
}
rvec2 agaa_hostPosition(uint i) {
    return rvec2(real(i));
}
#endif

uint agaa_coverageColumns(uint samples) {
    return samples == 32u ? 2u : 4u;
}

uint agaa_coverageRows(uint samples) {
    return samples == 128u ? 32u : 16u;
}

// Returns the position of the first sample of a row, from the left border of the pixel, in units of the spacing of
// samples.
real agaa_coveragePhase(uint row, uint samples) {
    if (samples == 128u) {
        return (real((row * 41u) & 63u) + real(0.5)) * real(0.015625);
    }
    return (real((row * (samples == 64u ? 7u : 5u)) & 15u) + real(0.5)) * real(0.0625);
}

// Returns y of a row, from the pixel's centre, in pixels.
real agaa_coverageRowY(uint row, uint samples) {
    return (real(row) + real(0.5)) * (samples == 128u ? real(0.03125) : real(0.0625)) - real(0.5);
}

// Returns a sample's position from the pixel's centre in pixels, (-1/2, 1/2).
rvec2 agaa_coveragePosition(uint i, uint samples) {
    if (agaa_hasHostPattern())
        return agaa_hostPosition(i);
    const uint columns = agaa_coverageColumns(samples);
    const uint row = i / columns;
    const real spacing = columns == 2u ? real(0.5) : real(0.25);
    return rvec2((real(i - row * columns) + agaa_coveragePhase(row, samples)) * spacing - real(0.5),
                 agaa_coverageRowY(row, samples));
}

rvec2 agaa_hostMiddle(uvec4 mask) {
    rvec2 sum = rvec2(real(0.0));
    real count = real(0.0);
    for (uint word = 0u; word < 4u; ++word) {
        uint left = mask[word];
        while (left != 0u) {
            sum += agaa_hostPosition(word * 32u + uint(findLSB(left)));
            count += real(1.0);
            left = left & (left - 1u);
        }
    }
    return sum / max(count, real(1.0));
}

// Adds the samples of a row to sums: their positions from the left border and from the centre of the pixel, and their
// number.
// bits   The row's part of a mask.
void agaa_addRow(INOUT(rvec3) sums, uint bits, uint row, real spacing, uint samples) {
    const real count = real(bitCount(bits));
    const real columnSum = real(bitCount(bits & 0xAu) + 2 * bitCount(bits & 0xCu));
    sums.x += (columnSum + count * agaa_coveragePhase(row, samples)) * spacing;
    sums.y += count * agaa_coverageRowY(row, samples);
    sums.z += count;
}

// Returns the centroid of a mask's samples, one or more, from the pixel's centre in pixels. An iteration adds four
// rows, because software rasterisers of Mesa end all loops of an invocation after 65535 iterations in total.
rvec2 agaa_coverageMiddle(uvec4 mask, uint samples) {
    if (agaa_hasHostPattern())
        return agaa_hostMiddle(mask);
    const uint columns = agaa_coverageColumns(samples);
    const uint rows = agaa_coverageRows(samples);
    const uint rowsOfWord = 32u / columns;
    const uint ofRow = (1u << columns) - 1u;
    const real spacing = columns == 2u ? real(0.5) : real(0.25);
    rvec3 sums = rvec3(real(0.0));
    for (uint row = 0u; row < rows; row += 4u) {
        const uint bits = mask[row / rowsOfWord] >> (row % rowsOfWord * columns);
        agaa_addRow(sums, bits & ofRow, row, spacing, samples);
        agaa_addRow(sums, bits >> columns & ofRow, row + 1u, spacing, samples);
        agaa_addRow(sums, bits >> 2u * columns & ofRow, row + 2u, spacing, samples);
        agaa_addRow(sums, bits >> 3u * columns & ofRow, row + 3u, spacing, samples);
    }
    const real scale = real(1.0) / max(sums.z, real(1.0));
    return rvec2(sums.x * scale - real(0.5), sums.y * scale);
}

// samples   Also 1 to 31, of targets.
uvec4 agaa_allCoverage(uint samples) {
    const uint first = samples < 32u ? (1u << samples) - 1u : 0xFFFFFFFFu;
    return uvec4(first, samples > 32u ? 0xFFFFFFFFu : 0u, samples > 64u ? 0xFFFFFFFFu : 0u,
                 samples > 64u ? 0xFFFFFFFFu : 0u);
}

uvec4 agaa_coverageComplement(uvec4 mask, uint samples) {
    return mask ^ agaa_allCoverage(samples);
}

uint agaa_coverageCount(uvec4 mask) {
    return uint(bitCount(mask.x) + bitCount(mask.y) + bitCount(mask.z) + bitCount(mask.w));
}

bool agaa_isCovered(uvec4 mask, uint i) {
    return ((mask[i >> 5u] >> (i & 31u)) & 1u) != 0u;
}

#endif
