#include "containment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace agaa::test {

namespace {

using Kind = BadAttribute::Kind;

const float badValues[] = {std::bit_cast<float>(0x7FC00000u), // NaN, quiet
                           std::bit_cast<float>(0xFFC00001u), // NaN with a sign and a payload
                           std::bit_cast<float>(0x7F800001u), // NaN, signalling
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           -1.0f,
                           -65504.0f,
                           65504.0f,
                           1e30f,
                           std::numeric_limits<float>::max(),
                           1e-40f, // a denormal
                           0.0f};
constexpr uint32_t columns = uint32_t(std::size(badValues));

// Values of Material::emissive.w, which select the attribute that Material::specular.w replaces. Texts have them as
// spare.y and spare.x.
enum Selector { Position = 1, Corner, Wind, Tangent, Part, DerivativeX, DerivativeY, Cutoff, Near };

// A point that alpha has everywhere needs no derivative of alpha, for which some drivers do not load the storage
// buffers of helper invocations.
constexpr const char* drawnText =
    "if (spare.y == 1.0) s.position.x += spare.x; "
    "if (spare.y == 8.0) { s.alphaCutoff = spare.x; s.hasAlphaNear = true; s.alphaNear = vec4(0.7); } "
    "if (spare.y == 9.0) { s.alphaCutoff = 0.5; s.hasAlphaNear = true; s.alphaNear = vec4(spare.x, vec3(1.0)); } ";
constexpr const char* cornerText = "if (spare.y == 2.0) a.x += spare.x;";
std::string derivativeText(const char* s) {
    return std::string("if (spare.y == 6.0) ") + s + ".normalDx.x = spare.x; if (spare.y == 7.0) " + s +
           ".normalDy.x = spare.x;";
}
std::string customText(const std::string& s) {
    return s + ".wind = vec2(spare.y == 3.0 ? spare.x : 1.0, 2.0); " + s +
           ".tangent = vec3(spare.y == 4.0 ? spare.x : 0.0, 0.0, 1.0); " + s +
           ".part = spare.y == 5.0 ? spare.x : 0.5; ";
}

// "precise" with custom attributes in place of emission.
const AgaaLayout* customLayout() {
    static const AgaaLayout made = [] {
        AgaaLayout layout = AGAA_LAYOUT_INIT;
        EXPECT_EQ(agaaGetBuiltinLayout("precise", &layout), AGAA_OK);
        layout.attributeCount = 4;
        const auto add = [&](const char* name, uint32_t channels, uint32_t bits, float range, uint32_t filter) {
            AgaaLayoutAttribute& a = layout.attributes[layout.attributeCount++];
            agaaInitLayoutAttribute(&a);
            a.semantic = AGAA_SEMANTIC_CUSTOM;
            a.channels = channels;
            a.sampleBits = bits;
            a.aggregateBits = filter == AGAA_FILTER_NONE ? 8 : 0;
            a.range = range;
            a.filter = filter;
            a.name = name;
        };
        add("wind", 2, 16, 4.0f, AGAA_FILTER_MEAN);
        add("tangent", 3, 8, 1.0f, AGAA_FILTER_NORMAL);
        add("part", 1, 8, 1.0f, AGAA_FILTER_NONE);
        return layout;
    }();
    return &made;
}

std::function<float(float)> clampedTo(float low, float high) {
    return [=](float x) { return std::isfinite(x) ? std::clamp(x, low, high) : low; };
}
float zeroIfNotFinite(float x) { return std::isfinite(x) ? x : 0.0f; }

std::function<void(Triangle&, float)> select(Selector selector) {
    return [selector](Triangle& t, float value) {
        t.material.emissive.w = float(selector);
        t.material.specular.w = value;
    };
}

// The corners of a cell's triangle, in its pixel. It covers the centre and no whole pixel.
constexpr glm::vec2 cellCorners[3] = {{0.02f, 0.02f}, {0.98f, 0.1f}, {0.1f, 0.98f}};
bool isInCell(glm::vec2 at) {
    bool isIn = true;
    for (int i = 0; i < 3; ++i) {
        const glm::vec2 a = cellCorners[i], edge = cellCorners[(i + 1) % 3] - a;
        isIn &= edge.x * (at.y - a.y) - edge.y * (at.x - a.x) > 0;
    }
    return isIn;
}

// The share of a pixel that it covers, which coverage samples approximate.
constexpr float cellArea = (0.96f * 0.96f - 0.08f * 0.08f) / 2;

bool filtersImage(const TechniqueTier& tier) {
    return std::strcmp(tier.technique, "fxaa") == 0 || std::strcmp(tier.technique, "smaa") == 0;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b, size_t pixel) {
    return std::memcmp(&a[3 * pixel], &b[3 * pixel], 3 * sizeof(float)) == 0;
}

std::string cellText(const BadCell& cell) {
    char value[32];
    std::snprintf(value, sizeof value, "%g", double(cell.value));
    return std::string(cell.attribute->name) + " = " + value;
}

} // namespace

BadGrid BadGrid::materials(const TechniqueTier& tier) {
    BadGrid grid;
    grid.surface_ = drawnText + (carriesMaterials(tier) ? derivativeText("s") : std::string());
    grid.material_ = derivativeText("m");
    const auto unit = clampedTo(0, 1);
    const bool hasDerivatives = fetches(tier) || carriesMaterials(tier);
    grid.attributes_ = {
        {"diffuse", Kind::Linear, 0.4f, unit, [](Triangle& t, float x) { t.material.diffuse.y = x; }},
        {"all of diffuse", Kind::Linear, 0.4f, unit,
         [](Triangle& t, float x) {
             t.material.diffuse = {x, x, x, 1};
         }},
        {"specular", Kind::Linear, 0.1f, unit, [](Triangle& t, float x) { t.material.specular.y = x; }},
        {"emissive", Kind::Linear, goodEmission, clampedTo(0, 16),
         [](Triangle& t, float x) { t.material.emissive.y = x; }},
        {"alpha2", Kind::Nonlinear, 0.3f, clampedTo(4.100625e-6f, 1),
         [](Triangle& t, float x) { t.material.normal.w = x; }},
        {"x of the normal", Kind::Nonlinear, 0, zeroIfNotFinite, [](Triangle& t, float x) { t.material.normal.x = x; }},
        {"z of the normal", Kind::Nonlinear, 1,
         [](float x) { return std::isfinite(x) && std::fabs(x) > 1e-30f ? x : 1.0f; },
         [](Triangle& t, float x) { t.material.normal.z = x; }},
        {"x of the plane normal", Kind::Nonlinear, 0, zeroIfNotFinite,
         [](Triangle& t, float x) { t.material.geometricNormal.x = x; }, false},
        {"normalDx", Kind::Nonlinear, 0.1f, zeroIfNotFinite, select(DerivativeX), hasDerivatives},
        {"normalDy", Kind::Nonlinear, 0.1f, zeroIfNotFinite, select(DerivativeY), hasDerivatives},
        {"alpha", Kind::Mask, 1, unit, [](Triangle& t, float x) { t.material.diffuse.w = x; }, false},
        {"alpha cutoff", Kind::Mask, 0.5f, zeroIfNotFinite,
         [](Triangle& t, float x) {
             t.material.diffuse.w = 0.7f;
             select(Cutoff)(t, x);
         },
         false},
        {"alpha at a point", Kind::Mask, 1, zeroIfNotFinite, select(Near), false},
        {"position", Kind::Duty, 0, zeroIfNotFinite, select(Position), false},
        {"fetched corner", Kind::Duty, 0, zeroIfNotFinite, select(Corner), false},
    };
    return grid;
}

BadGrid BadGrid::planeNormals() {
    BadGrid grid;
    grid.facts_ = AGAA_FACT_PLANE_NORMALS;
    grid.surface_ = drawnText;
    const auto setPlane = [](Triangle& t, const glm::vec3& n) { t.material.geometricNormal = glm::vec4(n, 0); };
    // The direction to the eye is +z in this view.
    const auto zOr = [](float x) { return std::isfinite(x) && std::fabs(x) > 1e-30f ? x : 1.0f; };
    grid.attributes_ = {
        {"x of the plane normal", Kind::Nonlinear, 0, zeroIfNotFinite,
         [=](Triangle& t, float x) {
             setPlane(t, {x, 0, 1});
         },
         false},
        {"z of the plane normal", Kind::Nonlinear, 1, zOr,
         [=](Triangle& t, float x) {
             setPlane(t, {0, 0, x});
         },
         false},
        {"plane normal and position", Kind::Duty, 1, zOr,
         [=](Triangle& t, float x) {
             setPlane(t, glm::vec3(x));
             select(Position)(t, x);
         },
         false},
    };
    return grid;
}

BadGrid BadGrid::customAttributes() {
    BadGrid grid;
    grid.hasCustomLayout_ = true;
    grid.surface_ = customText("s");
    grid.material_ = customText("m");
    grid.attributes_ = {{"wind", Kind::Linear, 1, clampedTo(0, 4), select(Wind)},
                        {"tangent", Kind::Nonlinear, 0, zeroIfNotFinite, select(Tangent)},
                        {"part", Kind::Linear, 0.5f, clampedTo(0, 1), select(Part)}};
    return grid;
}

ViewSettings BadGrid::settings(const TechniqueTier& tier) const {
    ViewSettings settings;
    apply(tier, settings);
    const glm::uvec2 extent =
        tier.isBatched ? batchedExtent : glm::uvec2(pitch * columns, pitch * uint32_t(attributes_.size()));
    settings.width = extent.x;
    settings.height = extent.y;
    settings.projection = pixelOrthographic(float(extent.x), float(extent.y), 10);
    settings.facts.shadowMapCount = 0;
    settings.facts.flags |= facts_;
    settings.surface = surface_.c_str();
    if (hasCustomLayout_)
        settings.config.layout = customLayout();
    return settings;
}

Shot BadGrid::shot(const TechniqueTier& tier) const {
    Shot shot{.triangles = triangles(GridFill::Good),
              .change = addAmbient,
              .material = material_.c_str(),
              .corners = cornerText,
              .fetchFlags = tier.isMixed ? AGAA_FETCH_NOT_ALL_DRAWS : 0};
    shot.lights[0].direction[0] = -0.6f; // away from the peaks of lobes
    shot.lights[0].direction[2] = -0.8f;
    return shot;
}

uint64_t BadGrid::badPositions() const {
    const auto found = cells();
    return uint64_t(std::ranges::count_if(found, [](const BadCell& cell) {
        Triangle t;
        cell.attribute->set(t, cell.value);
        return t.material.emissive.w == float(Position) && !std::isfinite(cell.value);
    }));
}

std::vector<BadCell> BadGrid::cells() const {
    std::vector<BadCell> cells;
    for (uint32_t row = 0; row < attributes_.size(); ++row)
        for (uint32_t column = 0; column < columns; ++column)
            cells.push_back({pitch * column + 1, pitch * row + 1, &attributes_[row], badValues[column]});
    return cells;
}

std::vector<Triangle> BadGrid::triangles(GridFill fill) const {
    Triangle ground;
    ground.position[0] = {0, 0, -5};
    ground.position[1] = {1000, 0, -5};
    ground.position[2] = {0, 1000, -5};
    ground.material = facing(glm::vec3(0.5f));
    ground.material.specular = {0.04f, 0.04f, 0.04f, 0};
    std::vector<Triangle> list = {ground};
    for (const BadCell& cell : cells()) {
        const BadAttribute& attribute = *cell.attribute;
        Triangle t = ground;
        for (int i = 0; i < 3; ++i)
            t.position[i] = {float(cell.x) + cellCorners[i].x, float(cell.y) + cellCorners[i].y, -2};
        t.material.diffuse = {0.2f, 0.4f, 0.3f, 1};
        t.material.specular = {0.1f, 0.1f, 0.1f, 0};
        t.material.emissive = {0, goodEmission, 0, 0};
        t.material.normal.w = 0.3f;
        t.isMasked = attribute.kind == Kind::Mask;
        const bool isBad = fill == GridFill::Bad || fill == GridFill::Replaced;
        attribute.set(t, fill == GridFill::Bad ? cell.value : isBad ? attribute.replaced(cell.value) : attribute.good);
        if (fill == GridFill::Bright)
            t.material.emissive.y = brightEmission;
        list.push_back(t);
    }
    return list;
}

void GridFrames::setCoverage(const SamplePositions& positions, uint32_t samples, uint32_t hwSamples) {
    std::vector<bool> texels(samples / hwSamples);
    for (uint32_t i = 0; i < samples; ++i)
        if (isInCell({positions[i].x, positions[i].y})) {
            ++coveredSamples;
            texels[i / hwSamples] = true;
        }
    coveredTexels = uint32_t(std::ranges::count(texels, true));
}

void expectReplaced(const GridFrames& frames, const TechniqueTier& tier, const BadGrid& grid) {
    using enum TechniqueTier::Evaluations;
    uint64_t counted = 0;
    for (const BadCell& cell : grid.cells()) {
        counted += cell.attribute->isCounted && !std::isfinite(cell.value);
        const size_t pixel = cell.y * frames.extent.x + cell.x;
        if (cell.attribute->kind != Kind::Duty && !sameBits(frames.bad.rgb, frames.replaced.rgb, pixel))
            ADD_FAILURE() << cellText(cell) << ": " << frames.bad.rgb[3 * pixel + 1] << " in place of "
                          << frames.replaced.rgb[3 * pixel + 1];
    }
    EXPECT_EQ(nonFinite(frames.bad.rgb), 0u);
    EXPECT_EQ(frames.good.counters.sanitised, 0u);
    EXPECT_EQ(frames.good.counters.misplaced, 0u);
    EXPECT_EQ(frames.replaced.counters.sanitised, 0u);
    const uint32_t evaluations = tier.evaluations == EachTexel    ? frames.coveredTexels
                                 : tier.evaluations == EachSample ? frames.coveredSamples
                                                                  : 1;
    if (tier.evaluations == OfOtherPasses) {
        EXPECT_GE(frames.bad.counters.sanitised, counted);
    } else {
        const uint64_t badPositions =
            tier.technique == std::string("msaa") ? grid.badPositions() * frames.coveredTexels : 0;
        EXPECT_EQ(frames.bad.counters.sanitised, counted * evaluations + badPositions);
    }
}

void expectNoNeighbourChanges(const GridFrames& frames, const TechniqueTier& tier, const BadGrid& grid) {
    if (filtersImage(tier))
        return; // expectWithinWeight has its bound
    std::vector<bool> isCell(frames.good.rgb.size() / 3);
    for (const BadCell& cell : grid.cells())
        isCell[cell.y * frames.extent.x + cell.x] = true;
    size_t changed = 0;
    for (size_t p = 0; p < isCell.size(); ++p)
        if (!isCell[p] && !sameBits(frames.bad.rgb, frames.good.rgb, p) && changed++ < 5)
            ADD_FAILURE() << "pixel " << p % frames.extent.x << ", " << p / frames.extent.x << ": "
                          << frames.bad.rgb[3 * p + 1] << " in place of " << frames.good.rgb[3 * p + 1];
    EXPECT_EQ(changed, 0u) << "neighbours of bad fragments changed";
}

// Filters of edges mix each pixel with its four neighbours.
static void expectWithinFilter(const std::vector<float>& filtered, const std::vector<float>& single, glm::uvec2 size) {
    for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x)
            for (uint32_t c = 0; c < 3; ++c) {
                const auto at = [&](uint32_t px, uint32_t py) {
                    return single[3 * (std::min(py, size.y - 1) * size.x + std::min(px, size.x - 1)) + c];
                };
                const float own[] = {at(x, y), at(x + 1, y), at(x, y + 1), at(x ? x - 1 : 0, y), at(x, y ? y - 1 : 0)};
                const auto [low, high] = std::ranges::minmax(own);
                const float value = filtered[3 * (y * size.x + x) + c];
                ASSERT_GE(value, low * 0.998f - 1e-4f) << x << ", " << y;
                ASSERT_LE(value, high * 1.002f + 1e-4f) << x << ", " << y;
            }
}

void expectWithinWeight(const GridFrames& frames, const GridFrames& single, const TechniqueTier& tier,
                        const BadGrid& grid) {
    if (filtersImage(tier)) {
        expectWithinFilter(frames.bad.rgb, single.bad.rgb, frames.extent);
        return;
    }
    if (tier.layout)
        return; // emission is a factor of the diffuse albedo there, so that colours are not linear
    const bool hasCoverageSamples = tier.n > 32;
    const float expected = hasCoverageSamples ? cellArea : float(frames.coveredSamples) / float(tier.n);
    for (const BadCell& cell : grid.cells()) {
        // A normal or a roughness shades the aggregate as another one in range; expectReplaced() compares the bits.
        if (cell.attribute->kind == Kind::Duty || cell.attribute->kind == Kind::Nonlinear)
            continue;
        const size_t pixel = cell.y * frames.extent.x + cell.x, full = cell.y * single.extent.x + cell.x;
        const auto change = [](const Shown& a, const Shown& b, size_t at, size_t c) {
            return std::fabs(a.rgb[3 * at + c] - b.rgb[3 * at + c]);
        };
        const float weight = change(frames.bright, frames.good, pixel, 1) / (brightEmission - goodEmission);
        EXPECT_NEAR(weight, expected, hasCoverageSamples ? 0.03f : 1e-3f)
            << cellText(cell) << ": the share of its samples that the fragment shows";
        for (size_t c = 0; c < 3; ++c) {
            const float good = single.good.rgb[3 * full + c];
            const float range = cell.attribute->kind == Kind::Mask ? std::fabs(good - single.good.rgb[c])
                                                                   : change(single.replaced, single.good, full, c);
            EXPECT_LE(change(frames.bad, frames.good, pixel, c), weight * range * 1.005f + 2e-3f)
                << cellText(cell) << ", channel " << c << ", range " << range;
        }
    }
}

} // namespace agaa::test
