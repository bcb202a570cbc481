// Grids of bad attributes, and expectations of the frames that show them.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"

#include "core/plan/sample_patterns.h"

#include <functional>

namespace agaa::test {

enum class GridFill {
    Good,     // a value in range
    Bad,      // the bad values
    Replaced, // the values that replace them
    Bright,   // good values, and emission of brightEmission
};
constexpr float goodEmission = 0.5f, brightEmission = 8;

// A row of the grid: one attribute with each of the bad values.
struct BadAttribute {
    enum class Kind {
        Linear,    // the colour is linear in the value once it is in range
        Nonlinear, // it is not
        Mask,      // the value decides which samples the fragment covers
        Duty,      // the host must give finite values; no value replaces others
    };
    const char* name;
    Kind kind;
    float good;
    std::function<float(float)> replaced; // returns the value that replaces a bad one
    std::function<void(Triangle&, float)> set;
    bool isCounted = true; // non-finite values count as sanitised
};

// A pixel in which one triangle of one bad value covers part of a ground.
struct BadCell {
    uint32_t x, y;
    const BadAttribute* attribute;
    float value;
};

class BadGrid {
public:
    static BadGrid materials(const TechniqueTier& tier); // all attributes that the tier reads
    static BadGrid planeNormals();                       // with AGAA_FACT_PLANE_NORMALS
    static BadGrid customAttributes();                   // of the layout, which has no emission

    ViewSettings settings(const TechniqueTier& tier) const;
    Shot shot(const TechniqueTier& tier) const;
    std::vector<Triangle> triangles(GridFill fill) const;
    std::vector<BadCell> cells() const;
    uint64_t badPositions() const; // number of cells whose position is not finite

    static constexpr uint32_t pitch = 3; // pixels from one cell to the next

private:
    std::vector<BadAttribute> attributes_; // rows
    std::string surface_, material_;       // as ViewSettings::surface and Shot::material
    uint64_t facts_ = 0;                   // of the view, besides the default ones
    bool hasCustomLayout_ = false;
};

struct GridFrames {
    glm::uvec2 extent{};
    uint32_t coveredSamples = 0, coveredTexels = 0; // of a cell, by its triangle
    Shown good, bad, replaced, bright;
    std::vector<uint32_t> badWords, replacedWords; // of aggregates in memory

    // Finds what a triangle of a cell covers. samples, hwSamples: of a pixel and of a texel.
    void setCoverage(const SamplePositions& positions, uint32_t samples, uint32_t hwSamples);
};

// The image of bad values is bitwise that of the values that replace them, and the frame counts them.
void expectReplaced(const GridFrames& frames, const TechniqueTier& tier, const BadGrid& grid);
// All pixels but the cells are bitwise those of good values.
void expectNoNeighbourChanges(const GridFrames& frames, const TechniqueTier& tier, const BadGrid& grid);
// A cell changes by at most the share of its samples that the bad fragment covers. FXAA: no pixel leaves the range of
// its unfiltered neighbours.
// single   The same grid with the technique "single", whose cells show one fragment each.
void expectWithinWeight(const GridFrames& frames, const GridFrames& single, const TechniqueTier& tier,
                        const BadGrid& grid);

} // namespace agaa::test
