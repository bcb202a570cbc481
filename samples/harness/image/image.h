// Linear RGB float image and its files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace harness {

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> rgb; // 3 floats per pixel, rows from top to bottom

    size_t pixelCount() const { return size_t(width) * height; }
};

using Pixel = std::array<uint8_t, 3>;

// Return the pixels of writePng() and writeDifferencePng(). Throw std::runtime_error.
std::vector<Pixel> displayPixels(const Image& image);
std::vector<Pixel> differencePixels(const Image& a, const Image& b, float gain);

// All functions throw std::runtime_error with one sentence that names the file.
Image readExr(const std::filesystem::path& path);
Image readHdr(const std::filesystem::path& path);                     // Radiance
void writeExr(const std::filesystem::path& path, const Image& image); // 32-bit float, ZIP
// Writes the tone-mapped image: x/(1+x), then ^(1/2.2), 8 bits. The metric mseTm uses the same mapping.
void writePng(const std::filesystem::path& path, const Image& image);
void writePng(const std::filesystem::path& path, uint32_t width, uint32_t height, const std::vector<Pixel>& pixels);
// Writes the tone-mapped image as JPEG for small pages. The quality is in [1, 100].
void writeJpeg(const std::filesystem::path& path, const Image& image, int quality);
// Writes |a-b| of the tone-mapped images, times gain, clamped.
void writeDifferencePng(const std::filesystem::path& path, const Image& a, const Image& b, float gain);

} // namespace harness
