#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace harness {

namespace {

constexpr double pi = std::numbers::pi;

// The paper's constants (sections 4.1.3, 4.2 and 4.3).
constexpr double colorExponent = 0.7;    // q_c
constexpr double colorKnee = 0.4;        // p_c
constexpr double colorKneeTarget = 0.95; // p_t
constexpr double featureWidth = 0.082;   // w, in degrees
constexpr double featureExponent = 0.5;  // q_f

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>;
using Plane = std::vector<double>;
using Kernel = std::vector<double>; // odd length, centred

// Linear sRGB to CIE XYZ under D65.
constexpr Mat3 rgbToXyz = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                            {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                            {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

constexpr Vec3 multiply(const Mat3& m, const Vec3& v) {
    Vec3 out{};
    for (size_t row = 0; row < 3; ++row)
        out[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return out;
}

constexpr Mat3 inverse(const Mat3& m) {
    Mat3 out{};
    for (size_t row = 0; row < 3; ++row) {
        for (size_t column = 0; column < 3; ++column) {
            // Cofactor of the transposed element. Cyclic indices give it its sign.
            const size_t r1 = (column + 1) % 3, r2 = (column + 2) % 3;
            const size_t c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            out[row][column] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    }
    const double determinant = m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0];
    for (Vec3& row : out) {
        for (double& value : row)
            value /= determinant;
    }
    return out;
}

constexpr Mat3 xyzToRgb = inverse(rgbToXyz);
constexpr Vec3 whiteXyz = multiply(rgbToXyz, {1, 1, 1});

double srgbToLinear(double value) {
    const double v = std::clamp(value, 0.0, 1.0);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// Converts to YCxCz: L*a*b* without its cube root, so that it is linear in light and can be filtered.
Vec3 linearToYcxcz(const Vec3& rgb) {
    const Vec3 xyz = multiply(rgbToXyz, rgb);
    const double x = xyz[0] / whiteXyz[0], y = xyz[1] / whiteXyz[1], z = xyz[2] / whiteXyz[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Vec3 ycxczToLinear(const Vec3& color) {
    const double y = (color[0] + 16) / 116;
    const double x = y + color[1] / 500;
    const double z = y - color[2] / 200;
    return multiply(xyzToRgb, {x * whiteXyz[0], y * whiteXyz[1], z * whiteXyz[2]});
}

double labCurve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

// Converts to L*a*b* with the Hunt effect: chroma is less visible in dark colours.
Vec3 linearToHuntLab(const Vec3& rgb) {
    const Vec3 xyz = multiply(rgbToXyz, rgb);
    const double x = labCurve(xyz[0] / whiteXyz[0]);
    const double y = labCurve(xyz[1] / whiteXyz[1]);
    const double z = labCurve(xyz[2] / whiteXyz[2]);
    const double lightness = 116 * y - 16;
    const double hunt = 0.01 * lightness;
    return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

double hyab(const Vec3& a, const Vec3& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

// Filters the image with `horizontal` along x and `vertical` along y. Pixels beyond the border repeat the border.
class SeparableFilter {
public:
    SeparableFilter(size_t width, size_t height) : width_(width), height_(height) {}

    Plane alongX(const Plane& image, const Kernel& kernel) const {
        const size_t radius = kernel.size() / 2;
        std::vector<double> padded(width_ + 2 * radius);
        Plane out(image.size(), 0.0);
        for (size_t y = 0; y < height_; ++y) {
            const double* row = &image[y * width_];
            std::fill_n(padded.begin(), radius, row[0]);
            std::copy_n(row, width_, padded.begin() + std::ptrdiff_t(radius));
            std::fill_n(padded.end() - std::ptrdiff_t(radius), radius, row[width_ - 1]);
            for (size_t k = 0; k < kernel.size(); ++k)
                addScaled(&out[y * width_], &padded[k], kernel[k]);
        }
        return out;
    }

    Plane alongY(const Plane& image, const Kernel& kernel) const {
        const auto radius = std::ptrdiff_t(kernel.size() / 2);
        const auto last = std::ptrdiff_t(height_) - 1;
        Plane out(image.size(), 0.0);
        for (std::ptrdiff_t y = 0; y <= last; ++y) {
            for (size_t k = 0; k < kernel.size(); ++k) {
                const auto source = size_t(std::clamp<std::ptrdiff_t>(y + std::ptrdiff_t(k) - radius, 0, last));
                addScaled(&out[size_t(y) * width_], &image[source * width_], kernel[k]);
            }
        }
        return out;
    }

    Plane both(const Plane& image, const Kernel& horizontal, const Kernel& vertical) const {
        return alongY(alongX(image, horizontal), vertical);
    }

private:
    // Each tap is applied to a whole row, which compilers vectorise.
    void addScaled(double* out, const double* in, double weight) const {
        for (size_t x = 0; x < width_; ++x)
            out[x] += weight * in[x];
    }

    size_t width_;
    size_t height_;
};

// One term a*sqrt(pi/b)*exp(-pi^2 d^2/b) of a contrast sensitivity function's image-space form,
// d in degrees; over the plane it is the product of two such exponentials.
struct Gaussian {
    double a;
    double b;
};

constexpr double largestB = 0.04; // largest b of all channels, which share one radius
constexpr std::array<Gaussian, 1> achromatic = {{{1, 0.0047}}};
constexpr std::array<Gaussian, 1> redGreen = {{{1, 0.0053}}};
constexpr std::array<Gaussian, 2> blueYellow = {{{34.1, 0.04}, {13.5, 0.025}}};

template <size_t N>
Plane filterContrast(const SeparableFilter& filter, const Plane& image, const std::array<Gaussian, N>& terms,
                     double pixelsPerDegree) {
    const int radius = int(std::ceil(3 * std::sqrt(largestB / (2 * pi * pi)) * pixelsPerDegree));
    Plane sum(image.size(), 0.0);
    double total = 0;
    std::array<double, N> share{};
    std::array<Kernel, N> kernels;
    for (size_t n = 0; n < N; ++n) {
        double weight = 0;
        for (int i = -radius; i <= radius; ++i) {
            const double degrees = i / pixelsPerDegree;
            kernels[n].push_back(std::exp(-pi * pi * degrees * degrees / terms[n].b));
            weight += kernels[n].back();
        }
        share[n] = terms[n].a * std::sqrt(pi / terms[n].b) * weight * weight;
        total += share[n];
        for (double& value : kernels[n])
            value /= weight;
    }
    for (size_t n = 0; n < N; ++n) {
        const Plane part = filter.both(image, kernels[n], kernels[n]);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += share[n] / total * part[i];
    }
    return sum;
}

// The smoothing kernel and its first and second derivatives. In each, positive weights sum to 1 and negative weights to
// -1. The signs depend on one axis only, so normalised factors give a normalised product.
struct FeatureKernels {
    Kernel smooth, edge, point;

    explicit FeatureKernels(double pixelsPerDegree) {
        const double sd = 0.5 * featureWidth * pixelsPerDegree;
        const int radius = int(std::ceil(3 * sd));
        for (int i = -radius; i <= radius; ++i) {
            const double g = std::exp(-double(i) * i / (2 * sd * sd));
            smooth.push_back(g);
            edge.push_back(-i * g);
            point.push_back((double(i) * i / (sd * sd) - 1) * g);
        }
        for (Kernel* kernel : {&smooth, &edge, &point}) {
            double positive = 0, negative = 0;
            for (double value : *kernel)
                (value > 0 ? positive : negative) += std::abs(value);
            for (double& value : *kernel)
                value /= value > 0 ? positive : (negative > 0 ? negative : 1);
        }
    }
};

// The data that the metric derives from one image.
struct Analysis {
    std::vector<Vec3> lab; // filtered, Hunt-adjusted
    Plane edges;           // magnitudes
    Plane points;
};

Analysis analyse(const Image& image, double pixelsPerDegree) {
    const size_t count = image.pixelCount();
    std::array<Plane, 3> opponent;
    for (Plane& plane : opponent)
        plane.resize(count);
    Plane luminance(count);
    for (size_t i = 0; i < count; ++i) {
        const Vec3 color = linearToYcxcz(
            {srgbToLinear(image.rgb[3 * i]), srgbToLinear(image.rgb[3 * i + 1]), srgbToLinear(image.rgb[3 * i + 2])});
        for (size_t c = 0; c < 3; ++c)
            opponent[c][i] = color[c];
        luminance[i] = (color[0] + 16) / 116;
    }

    const SeparableFilter filter(image.width, image.height);
    opponent[0] = filterContrast(filter, opponent[0], achromatic, pixelsPerDegree);
    opponent[1] = filterContrast(filter, opponent[1], redGreen, pixelsPerDegree);
    opponent[2] = filterContrast(filter, opponent[2], blueYellow, pixelsPerDegree);

    Analysis out;
    out.lab.resize(count);
    for (size_t i = 0; i < count; ++i) {
        // Channels that are filtered separately can leave the gamut of the display.
        Vec3 rgb = ycxczToLinear({opponent[0][i], opponent[1][i], opponent[2][i]});
        for (double& value : rgb)
            value = std::clamp(value, 0.0, 1.0);
        out.lab[i] = linearToHuntLab(rgb);
    }

    const FeatureKernels kernels(pixelsPerDegree);
    const auto magnitude = [&](const Kernel& kernel) {
        Plane alongX = filter.both(luminance, kernel, kernels.smooth);
        const Plane alongY = filter.both(luminance, kernels.smooth, kernel);
        for (size_t i = 0; i < count; ++i)
            alongX[i] = std::hypot(alongX[i], alongY[i]);
        return alongX;
    };
    out.edges = magnitude(kernels.edge);
    out.points = magnitude(kernels.point);
    return out;
}

} // namespace

std::vector<float> flipErrorMap(const Image& reference, const Image& test, double pixelsPerDegree) {
    const Analysis a = analyse(reference, pixelsPerDegree);
    const Analysis b = analyse(test, pixelsPerDegree);

    // Green and blue have the largest distance of all displayable colours.
    const double largest = std::pow(hyab(linearToHuntLab({0, 1, 0}), linearToHuntLab({0, 0, 1})), colorExponent);
    const double knee = colorKnee * largest;
    std::vector<float> errors(a.lab.size());
    for (size_t i = 0; i < errors.size(); ++i) {
        const double distance = std::pow(hyab(a.lab[i], b.lab[i]), colorExponent);
        const double color = distance < knee
                                 ? distance * colorKneeTarget / knee
                                 : colorKneeTarget + (distance - knee) / (largest - knee) * (1 - colorKneeTarget);
        const double feature = std::pow(
            std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) / std::numbers::sqrt2,
            featureExponent);
        errors[i] = float(std::clamp(std::pow(color, 1 - feature), 0.0, 1.0));
    }
    return errors;
}

double percentile(std::vector<float> values, double fraction) {
    const double position = std::clamp(fraction, 0.0, 1.0) * double(values.size() - 1);
    const auto below = size_t(position);
    const auto nth = values.begin() + std::ptrdiff_t(below);
    std::nth_element(values.begin(), nth, values.end());
    const double low = *nth;
    if (below + 1 >= values.size())
        return low;
    const double high = *std::min_element(nth + 1, values.end());
    return low + (position - double(below)) * (high - low);
}

} // namespace harness
