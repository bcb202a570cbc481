// Rows and columns of pixels that triangles touch (src/shaders/math/hull_rows.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

using math_f::agaa_Outline;
using math_f::agaa_Span;

// An image, and the near plane as agaa_triangleHull() has it.
struct Image {
    int width, height;
    glm::vec2 nearPlane;

    glm::dvec2 halfSize() const { return {0.5 * width, 0.5 * height}; }
    glm::vec4 vertex(const glm::dvec2& fromMiddle, double w) const {
        return clipVertex(fromMiddle / halfSize(), w, glm::dvec2(nearPlane));
    }
};

const Image images[] = {{15, 11, {1, 0}}, {33, 7, {-1, 1}}, {1, 1, {1, 0}},  {8, 21, {1, 1}},
                        {11, 9, {-1, 1}}, {16, 12, {1, 0}}, {5, 37, {1, 1}}, {1, 63, {-1, 1}}};

agaa_Outline outlineOf(const Clip& t, const Image& image) {
    return math_f::agaa_triangleOutline(t[0], t[1], t[2], image.nearPlane, glm::vec2(image.halfSize()));
}

bool isEmpty(const agaa_Span& s) { return s.first > s.last; }
bool isIn(double x, const agaa_Span& s) { return x >= double(s.first) && x <= double(s.last); }

// Returns true if a span is finite and either empty or whole numbers in [0, size).
bool isValid(const agaa_Span& s, int size) {
    if (!std::isfinite(s.first) || !std::isfinite(s.last))
        return false;
    return isEmpty(s) || (s.first >= 0 && s.last <= float(size - 1) && s.first == std::floor(s.first) &&
                          s.last == std::floor(s.last));
}

// The columns of a row that a polygon touches, by the polygon's edges at the row's centre only.
agaa_Span naiveSpan(const agaa_Outline& o, double row, int width) {
    double low = 1e30, high = -1e30;
    for (unsigned i = 0; i < o.count; ++i) {
        const glm::dvec2 a(o.at[i]), b(o.at[(i + 1) % o.count]);
        const double y = row + 0.5;
        if ((a.y <= y) == (b.y <= y))
            continue;
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        low = std::min(low, x);
        high = std::max(high, x);
    }
    agaa_Span span;
    span.first = float(std::max(std::ceil(low - 1), 0.0));
    span.last = float(std::min(std::floor(high), width - 1.0));
    return span;
}

enum class Kind { Small, Thin, Large, Huge, NearPlane, FarBehind, Eye, Count };

Clip randomTriangle(Random& random, Kind kind, const Image& image, unsigned i) {
    const glm::dvec2 half = image.halfSize();
    const glm::dvec2 at(random.range(-half.x - 1, half.x + 1), random.range(-half.y - 1, half.y + 1));
    const double turn = i % 5 == 0 ? random.below(8) * 0.7853981633974483 : random.range(0, 6.3);
    const glm::dvec2 along(std::cos(turn), std::sin(turn)), aside(-along.y, along.x);
    double size = random.decades(0.01, 4), thin = 1, nearest = 0.2, furthest = 50;
    switch (kind) {
    case Kind::Thin:
        size = random.decades(0.5, 100);
        thin = random.decades(1e-9, 0.1);
        break;
    case Kind::Large:
        size = random.decades(4, 300);
        break;
    case Kind::Huge:
        size = random.decades(300, 1.5e7);
        thin = i % 2 ? random.decades(1e-9, 1) : 1;
        break;
    default:
        break;
    }
    Clip t;
    for (unsigned k = 0; k < 3; ++k) {
        glm::dvec2 offset = size * (along * random.range(-1, 1) + aside * (thin * random.range(-1, 1)));
        double w = random.decades(nearest, furthest);
        if (kind == Kind::NearPlane) {
            offset = random.decades(0.5, 1e4) * random.range(-1, 1) * along + random.range(-9, 9) * aside;
            w = k == i % 3 ? 0.1 - random.decades(1e-9, 0.09) : random.decades(0.1, 2);
        }
        if (kind == Kind::FarBehind && k == i % 3) {
            offset = random.decades(0.5, 1e4) * random.range(-1, 1) * along + random.range(-9, 9) * aside;
            w = -random.decades(1, 1e3);
        } else if (kind == Kind::FarBehind) { // where the edges to the other vertex cross the near plane
            offset = {random.range(-5, 5), random.range(-5, 5)};
            w = 0.1 + random.decades(1e-9, 1e-2);
        }
        if (kind == Kind::Eye)
            w = random.range(-4, 6);
        t[k] = image.vertex(at + offset, w);
        if (kind == Kind::Eye) { // positions in clip space, because vertices may be at the eye
            const double spread = random.decades(5, i % 4 ? 300 : 1e5);
            t[k].x = float(random.range(-1, 1) * spread / half.x);
            t[k].y = float(random.range(-1, 1) * spread / half.y);
        }
    }
    if (i % 50 == 0)
        t[1] = t[0];
    if (i % 150 == 0)
        t[2] = t[0];
    return t;
}

struct Totals {
    std::size_t triangles = 0, cut = 0, phantoms = 0, naiveMisses = 0, measured = 0;
    double touched = 0, listed = 0, worst = 0; // pixels of triangles that touch many
};

// Pixels with samples in a triangle are listed, unless no part of it in front of the near plane touches them.
struct Check {
    const Clip& t;
    const Image& image;
    unsigned samples;
    Totals& totals;
    agaa_Outline outline = outlineOf(t, image);
    Polygon inFront = projected(t, glm::dvec2(image.nearPlane), image.halfSize());
    Vertices inPixels = {};
    bool isCut = false;

    void prepare() {
        const glm::vec2 n = image.nearPlane;
        for (std::size_t k = 0; k < 3; ++k) {
            inPixels[k] = math_f::agaa_vertexInPixels({t[k].x, t[k].y, t[k].w}, glm::vec2(image.halfSize()));
            isCut = isCut || n.x * t[k].z + n.y * t[k].w < 0;
        }
    }
    bool isTouched(int x, int y, double halfWidth = 0.5) const {
        return touches(inFront, glm::dvec2(x + 0.5, y + 0.5) - image.halfSize(), halfWidth);
    }
    bool isMasked(int x, int y) const {
        return math_f::agaa_coverageCount(mask(inPixels, {float(x) + 0.5f, float(y) + 0.5f}, samples)) != 0;
    }

    void pixel(int x, int y, bool isListed, bool isNaive) {
        if ((isListed && isNaive) || !isMasked(x, y))
            return;
        if (isListed)
            ++totals.naiveMisses;
        else if (isCut && !isTouched(x, y))
            ++totals.cut;
        else if (!isCut && !isTouched(x, y, 1.5))
            ++totals.phantoms; // rounding gives samples to a sliver that lies in another place of its line
        else
            ADD_FAILURE() << "pixel " << x << " " << y << " of " << image.width << " x " << image.height;
    }

    // The pixels that can have samples, or all pixels.
    std::array<int, 4> window(bool isWhole) const {
        if (isWhole || isCut)
            return {0, image.width, 0, image.height};
        glm::dvec2 low(1e30), high(-1e30);
        for (const glm::dvec2& p : inFront) {
            low = glm::min(low, p + image.halfSize());
            high = glm::max(high, p + image.halfSize());
        }
        return {int(std::clamp(low.x - 3, 0.0, double(image.width))),
                int(std::clamp(high.x + 4, 0.0, double(image.width))),
                int(std::clamp(low.y - 3, 0.0, double(image.height))),
                int(std::clamp(high.y + 4, 0.0, double(image.height)))};
    }

    void run(bool isWhole) {
        prepare();
        const agaa_Span rows = math_f::agaa_outlineRows(outline, float(image.height));
        const agaa_Span columns = math_f::agaa_outlineColumns(outline, float(image.width));
        EXPECT_TRUE(isValid(rows, image.height)) << rows.first << " " << rows.last;
        EXPECT_TRUE(isValid(columns, image.width)) << columns.first << " " << columns.last;
        const auto [left, right, bottom, top] = window(isWhole);
        for (int y = 0; y < image.height; ++y) {
            const agaa_Span span = math_f::agaa_outlineSpan(outline, float(y), float(image.width));
            EXPECT_TRUE(isValid(span, image.width)) << span.first << " " << span.last;
            const bool hasRow = isIn(y, rows);
            if (hasRow && !isEmpty(span)) {
                EXPECT_TRUE(isIn(double(span.first), columns) && isIn(double(span.last), columns));
            }
            const agaa_Span naive = naiveSpan(outline, y, image.width);
            for (int x = left; x < right && y >= bottom && y < top; ++x)
                pixel(x, y, hasRow && isIn(x, span), isIn(x, naive));
        }
        ++totals.triangles;
    }

    void measure() {
        double touched = 0, listed = 0;
        const agaa_Span rows = math_f::agaa_outlineRows(outline, float(image.height));
        for (int y = 0; y < image.height; ++y) {
            const agaa_Span span = math_f::agaa_outlineSpan(outline, float(y), float(image.width));
            if (isIn(y, rows) && !isEmpty(span))
                listed += double(span.last - span.first + 1);
            for (int x = 0; x < image.width; ++x)
                touched += isTouched(x, y);
        }
        if (touched < 30)
            return;
        ++totals.measured;
        totals.touched += touched;
        totals.listed += listed;
        totals.worst = std::max(totals.worst, listed / touched);
    }
};

// Hard case 50, for passes without a rasteriser.
TEST(HullRows, ContainEveryPixelWithSamples) {
    Random random(1);
    Totals totals;
    for (unsigned i = 0; i < 120000; ++i) {
        const Kind kind = Kind(i % unsigned(Kind::Count));
        const Image& image = images[random.below(std::size(images))];
        const Clip t = randomTriangle(random, kind, image, i / unsigned(Kind::Count));
        Check check{t, image, 32u << random.below(3), totals};
        if (check.outline.count == 0) {
            EXPECT_TRUE(check.inFront.empty()) << i;
            continue;
        }
        check.run(i % 10 == 0);
        if (kind != Kind::Huge && kind != Kind::Eye && i % 5 == 0)
            check.measure();
        ASSERT_FALSE(HasFailure()) << "triangle " << i << " of kind " << int(kind);
    }
    std::printf("[ measured ] %zu triangles, %zu masks behind the near plane, %zu of no place; listed / touched %.3f, "
                "at most %.3f of %zu; rows' centres miss %zu pixels\n",
                totals.triangles, totals.cut, totals.phantoms, totals.listed / totals.touched, totals.worst,
                totals.measured, totals.naiveMisses);
    EXPECT_GT(totals.triangles, 100000u);
    EXPECT_GT(totals.cut, 1000u);
    EXPECT_LT(totals.phantoms, 200u);
    // Spans are hardly longer than necessary.
    EXPECT_GT(totals.measured, 1000u);
    EXPECT_LT(totals.listed, 1.02 * totals.touched);
    EXPECT_LT(totals.worst, 1.2);
    // The borders of a row are needed.
    EXPECT_GT(totals.naiveMisses, 10000u);
}

TEST(HullRows, OutlinesOfSpecialTriangles) {
    const Image& image = images[0];
    const auto at = [&](double x, double y) { return image.vertex({x, y}, 1); };
    EXPECT_EQ(outlineOf({at(0, 0), at(3, 1), at(1, 2)}, image).count, 3u);
    EXPECT_EQ(outlineOf({image.vertex({0, 0}, -1), image.vertex({1, 0}, -1), image.vertex({0, 1}, 0.05)}, image).count,
              0u);
    // A vertex at the eye, which no near plane cut off: the whole image.
    const agaa_Outline whole = outlineOf({glm::vec4(0, 0, 1, 0), at(1, 2), at(3, 4)}, image);
    EXPECT_EQ(math_f::agaa_outlineRows(whole, 11.0f).first, 0.0f);
    EXPECT_EQ(math_f::agaa_outlineRows(whole, 11.0f).last, 10.0f);
    for (int y = 0; y < 11; ++y) {
        const agaa_Span span = math_f::agaa_outlineSpan(whole, float(y), 15.0f);
        EXPECT_EQ(span.first, 0.0f);
        EXPECT_EQ(span.last, 14.0f);
    }
    for (int vertex = 0; vertex < 3; ++vertex)
        for (int k = 0; k < 4; ++k)
            for (const float bad : {nanF(), infinityF(), -infinityF()}) {
                Clip t = {at(0, 0), at(3, 1), at(1, 2)};
                t[std::size_t(vertex)][k] = bad;
                EXPECT_EQ(outlineOf(t, image).count, 0u);
            }
}

// A triangle that touches no pixel of the image has no rows or no columns.
TEST(HullRows, NothingIsListedBesideTheImage) {
    const Image& image = images[0];
    for (const glm::dvec2 from : {glm::dvec2(20, 0), glm::dvec2(-20, 0), glm::dvec2(0, 20), glm::dvec2(0, -20)}) {
        const agaa_Outline o = outlineOf(
            {image.vertex(from, 1), image.vertex(from + glm::dvec2(2, 1), 1), image.vertex(from + glm::dvec2(1, 2), 1)},
            image);
        ASSERT_EQ(o.count, 3u);
        EXPECT_TRUE(isEmpty(math_f::agaa_outlineRows(o, 11.0f)) || isEmpty(math_f::agaa_outlineColumns(o, 15.0f)));
        for (int y = 0; y < 11; ++y)
            EXPECT_TRUE(isEmpty(math_f::agaa_outlineSpan(o, float(y), 15.0f)) ||
                        !isIn(y, math_f::agaa_outlineRows(o, 11.0f)));
    }
}

} // namespace
