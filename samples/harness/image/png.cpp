// Tone-mapped PNG and JPEG files.
#include "image/check.h"
#include "image/image.h"
#include "image/tonemap.h"

#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

namespace harness {

namespace {

// Values that are not a number get a colour that shading does not produce, so that they are visible.
constexpr Pixel magenta = {255, 0, 255};

uint8_t toByte(double value) { return uint8_t(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

bool isFinite(const float* rgb) { return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]); }

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw std::runtime_error("Could not write the image file \"" + path.string() + "\": " + reason + ".");
}

void requireForFile(const std::filesystem::path& path, const Image& image) {
    try {
        requireConsistent(image, "the image");
    } catch (const std::exception& error) {
        std::string reason = error.what();
        reason.pop_back(); // fail() ends the sentence itself
        fail(path, reason);
    }
}

void appendBytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<char>*>(context);
    const char* begin = static_cast<const char*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

constexpr int lossless = 0;

// Encodes into memory first, because the library's file functions do not report a full disk. The quality is in [1, 100]
// for JPEG, or `lossless` for PNG.
void writeBytes(const std::filesystem::path& path, uint32_t columns, uint32_t rows, const std::vector<Pixel>& pixels,
                int quality = lossless) {
    std::vector<char> encoded;
    const int width = int(columns), height = int(rows);
    const bool isEncoded =
        quality == lossless ? stbi_write_png_to_func(appendBytes, &encoded, width, height, 3, pixels.data(), width * 3)
                            : stbi_write_jpg_to_func(appendBytes, &encoded, width, height, 3, pixels.data(), quality);
    if (!isEncoded)
        fail(path, "it could not be encoded");
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file)
        fail(path, "it could not be opened for writing");
    file.write(encoded.data(), std::streamsize(encoded.size()));
    file.close();
    if (!file)
        fail(path, "not all of it could be written");
}

} // namespace

std::vector<Pixel> displayPixels(const Image& image) {
    requireConsistent(image, "The image");
    std::vector<Pixel> pixels(image.pixelCount());
    for (size_t i = 0; i < pixels.size(); ++i) {
        const float* rgb = &image.rgb[3 * i];
        if (!isFinite(rgb)) {
            pixels[i] = magenta;
            continue;
        }
        for (size_t c = 0; c < 3; ++c)
            pixels[i][c] = toByte(toneMap(rgb[c]));
    }
    return pixels;
}

std::vector<Pixel> differencePixels(const Image& a, const Image& b, float gain) {
    requireConsistent(a, "The first image");
    requireConsistent(b, "The second image");
    if (a.width != b.width || a.height != b.height)
        throw std::runtime_error("The two images differ in size.");
    if (!std::isfinite(gain) || gain < 0)
        throw std::runtime_error("The gain must be a number of at least 0.");
    std::vector<Pixel> pixels(a.pixelCount());
    for (size_t i = 0; i < pixels.size(); ++i) {
        const float* left = &a.rgb[3 * i];
        const float* right = &b.rgb[3 * i];
        if (!isFinite(left) || !isFinite(right)) {
            pixels[i] = magenta;
            continue;
        }
        for (size_t c = 0; c < 3; ++c)
            pixels[i][c] = toByte(std::abs(toneMap(left[c]) - toneMap(right[c])) * gain);
    }
    return pixels;
}

void writePng(const std::filesystem::path& path, const Image& image) {
    requireForFile(path, image);
    writeBytes(path, image.width, image.height, displayPixels(image));
}

void writePng(const std::filesystem::path& path, uint32_t width, uint32_t height, const std::vector<Pixel>& pixels) {
    if (pixels.empty() || pixels.size() != size_t(width) * height)
        fail(path, "the image has no pixels, or another number than its size says");
    writeBytes(path, width, height, pixels);
}

void writeJpeg(const std::filesystem::path& path, const Image& image, int quality) {
    if (quality < 1 || quality > 100)
        fail(path, "the quality must be from 1 to 100");
    requireForFile(path, image);
    writeBytes(path, image.width, image.height, displayPixels(image), quality);
}

void writeDifferencePng(const std::filesystem::path& path, const Image& a, const Image& b, float gain) {
    requireForFile(path, a);
    requireForFile(path, b);
    if (a.width != b.width || a.height != b.height)
        fail(path, "the two images differ in size");
    if (!std::isfinite(gain) || gain < 0)
        fail(path, "the gain must be a number of at least 0");
    writeBytes(path, a.width, a.height, differencePixels(a, b, gain));
}

} // namespace harness
