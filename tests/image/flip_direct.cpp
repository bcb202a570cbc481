#include "flip_direct.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

const double pi = std::acos(-1.0);

struct Color {
    double x, y, z;
};

// XYZ of the sRGB primaries, scaled so that (1, 1, 1) is the white with the tristimulus values
// 0.950428545, 1, 1.088900371 that FLIP takes for D65.
struct Primaries {
    static constexpr double white[3] = {0.950428545, 1.0, 1.088900371};
    double column[3][3]; // [primary][xyz]

    Primaries() {
        const double chromaticity[3][2] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
        double m[3][4];
        for (int p = 0; p < 3; ++p) {
            const double x = chromaticity[p][0], y = chromaticity[p][1];
            const double xyz[3] = {x / y, 1, (1 - x - y) / y};
            for (int k = 0; k < 3; ++k) {
                column[p][k] = xyz[k];
                m[k][p] = xyz[k];
                m[k][3] = white[k];
            }
        }
        double scale[3];
        solve(m, scale);
        for (int p = 0; p < 3; ++p)
            for (double& value : column[p])
                value *= scale[p];
    }

    // Gauss-Jordan elimination with row pivoting of m * out = last column.
    static void solve(double (&m)[3][4], double (&out)[3]) {
        for (int c = 0; c < 3; ++c) {
            int pivot = c;
            for (int r = c; r < 3; ++r)
                if (std::abs(m[r][c]) > std::abs(m[pivot][c]))
                    pivot = r;
            std::swap(m[c], m[pivot]);
            for (int r = 0; r < 3; ++r) {
                if (r == c)
                    continue;
                const double factor = m[r][c] / m[c][c];
                for (int k = 0; k < 4; ++k)
                    m[r][k] -= factor * m[c][k];
            }
        }
        for (int c = 0; c < 3; ++c)
            out[c] = m[c][3] / m[c][c];
    }

    Color toXyz(const Color& rgb) const {
        double out[3];
        for (int k = 0; k < 3; ++k)
            out[k] = rgb.x * column[0][k] + rgb.y * column[1][k] + rgb.z * column[2][k];
        return {out[0], out[1], out[2]};
    }

    Color toRgb(const Color& xyz) const {
        double m[3][4];
        const double right[3] = {xyz.x, xyz.y, xyz.z};
        for (int k = 0; k < 3; ++k) {
            for (int p = 0; p < 3; ++p)
                m[k][p] = column[p][k];
            m[k][3] = right[k];
        }
        double out[3];
        solve(m, out);
        return {out[0], out[1], out[2]};
    }
};

const Primaries primaries;

double decode(double v) {
    v = std::min(1.0, std::max(0.0, v));
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Color toYcxcz(const Color& rgb) {
    const Color xyz = primaries.toXyz(rgb);
    const double x = xyz.x / Primaries::white[0], y = xyz.y, z = xyz.z / Primaries::white[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color fromYcxcz(const Color& c) {
    const double y = (c.x + 16) / 116;
    return primaries.toRgb({(y + c.y / 500) * Primaries::white[0], y, (y - c.z / 200) * Primaries::white[2]});
}

Color toHuntLab(const Color& rgb) {
    const auto f = [](double t) {
        const double d = 6.0 / 29.0;
        return t > d * d * d ? std::pow(t, 1.0 / 3.0) : t / (3 * d * d) + 4.0 / 29.0;
    };
    const Color xyz = primaries.toXyz(rgb);
    const double x = f(xyz.x / Primaries::white[0]), y = f(xyz.y);
    const double z = f(xyz.z / Primaries::white[2]);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Color& a, const Color& b) {
    return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

struct Kernel2d {
    int radius;
    std::vector<double> weights;

    Kernel2d(int r, const std::function<double(int, int)>& f) : radius(r) {
        for (int y = -r; y <= r; ++y)
            for (int x = -r; x <= r; ++x)
                weights.push_back(f(x, y));
    }

    void normalizeSum() {
        double sum = 0;
        for (double w : weights)
            sum += w;
        for (double& w : weights)
            w /= sum;
    }

    void normalizeSigns() {
        double positive = 0, negative = 0;
        for (double w : weights)
            (w > 0 ? positive : negative) += w;
        for (double& w : weights)
            w = w > 0 ? w / positive : w / -negative;
    }

    template <typename Sample> // double(int x, int y)
    double at(int px, int py, int width, int height, const Sample& sample) const {
        double sum = 0;
        size_t i = 0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x)
                sum += weights[i++] *
                       sample(std::min(width - 1, std::max(0, px + x)), std::min(height - 1, std::max(0, py + y)));
        return sum;
    }
};

} // namespace

std::vector<double> directFlip(const harness::Image& reference, const harness::Image& test, double ppd) {
    const int width = int(reference.width), height = int(reference.height);
    const int csfRadius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    const auto csf = [&](double a1, double b1, double a2, double b2) {
        Kernel2d kernel(csfRadius, [&](int x, int y) {
            const double d2 = (x * x + y * y) / (ppd * ppd);
            return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
                   a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2);
        });
        kernel.normalizeSum();
        return kernel;
    };
    const Kernel2d kernelY = csf(1, 0.0047, 0, 1e-5);
    const Kernel2d kernelCx = csf(1, 0.0053, 0, 1e-5);
    const Kernel2d kernelCz = csf(34.1, 0.04, 13.5, 0.025);

    const double sd = 0.082 * ppd / 2;
    const int featureRadius = int(std::ceil(3 * sd));
    const auto gauss = [&](int x, int y) { return std::exp(-(x * x + y * y) / (2 * sd * sd)); };
    Kernel2d edgeX(featureRadius, [&](int x, int y) { return -x * gauss(x, y); });
    Kernel2d edgeY(featureRadius, [&](int x, int y) { return -y * gauss(x, y); });
    Kernel2d pointX(featureRadius, [&](int x, int y) { return (x * x / (sd * sd) - 1) * gauss(x, y); });
    Kernel2d pointY(featureRadius, [&](int x, int y) { return (y * y / (sd * sd) - 1) * gauss(x, y); });
    for (Kernel2d* kernel : {&edgeX, &edgeY, &pointX, &pointY})
        kernel->normalizeSigns();

    struct Seen {
        Color lab;
        double edge, point;
    };
    const auto look = [&](const harness::Image& image) {
        std::vector<Color> opponent;
        for (size_t i = 0; i < image.rgb.size(); i += 3)
            opponent.push_back(toYcxcz({decode(image.rgb[i]), decode(image.rgb[i + 1]), decode(image.rgb[i + 2])}));
        const auto at = [&](int x, int y) { return opponent[size_t(y * width + x)]; };
        const auto sampleY = [&](int x, int y) { return at(x, y).x; };
        const auto sampleCx = [&](int x, int y) { return at(x, y).y; };
        const auto sampleCz = [&](int x, int y) { return at(x, y).z; };
        const auto sampleFeature = [&](int x, int y) { return (at(x, y).x + 16) / 116; };
        std::vector<Seen> out;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                Color rgb =
                    fromYcxcz({kernelY.at(x, y, width, height, sampleY), kernelCx.at(x, y, width, height, sampleCx),
                               kernelCz.at(x, y, width, height, sampleCz)});
                for (double* v : {&rgb.x, &rgb.y, &rgb.z})
                    *v = std::min(1.0, std::max(0.0, *v));
                const auto norm = [&](const Kernel2d& h, const Kernel2d& v) {
                    const double dx = h.at(x, y, width, height, sampleFeature);
                    const double dy = v.at(x, y, width, height, sampleFeature);
                    return std::sqrt(dx * dx + dy * dy);
                };
                out.push_back({toHuntLab(rgb), norm(edgeX, edgeY), norm(pointX, pointY)});
            }
        }
        return out;
    };

    const std::vector<Seen> a = look(reference), b = look(test);
    const double cmax = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), 0.7);
    std::vector<double> out;
    for (size_t i = 0; i < a.size(); ++i) {
        const double e = std::pow(hyab(a[i].lab, b[i].lab), 0.7);
        const double colorError =
            e < 0.4 * cmax ? 0.95 / (0.4 * cmax) * e : 0.95 + (e - 0.4 * cmax) / (cmax - 0.4 * cmax) * 0.05;
        const double feature = std::max(std::abs(a[i].edge - b[i].edge), std::abs(a[i].point - b[i].point));
        out.push_back(std::pow(colorError, 1 - std::sqrt(feature / std::sqrt(2.0))));
    }
    return out;
}
