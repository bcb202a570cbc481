// Linear RGB float image and its files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace harness {

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> rgb; // 3 floats a pixel, rows from top to bottom

    size_t pixelCount() const { return size_t(width) * height; }
};

// All throw std::runtime_error with one sentence naming the file.
Image readExr(const std::filesystem::path& path);
void writeExr(const std::filesystem::path& path, const Image& image); // 32-bit float, ZIP
// Tone-mapped for looking at: x/(1+x), then ^(1/2.2), 8 bit. The mapping of the mseTm metric.
void writePng(const std::filesystem::path& path, const Image& image);
// The same as JPEG: quality, [1;100]. For pages that must stay small.
void writeJpeg(const std::filesystem::path& path, const Image& image, int quality);
// |a-b| of the tone-mapped images, times gain, clamped.
void writeDifferencePng(const std::filesystem::path& path, const Image& a, const Image& b,
                        float gain);

} // namespace harness
