// Radiance files.
#include "image/image.h"

#include <stb_image.h>

#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace harness {

namespace {

// The limit keeps a damaged header from causing a huge allocation.
constexpr int64_t maxPixels = int64_t(1) << 26; // 768 MiB

std::vector<unsigned char> readBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? std::streamoff(file.tellg()) : -1;
    // A folder opens too, and has the largest offset as its size.
    if (size < 0 || size > std::streamoff(16 * maxPixels))
        throw std::runtime_error("it cannot be read");
    std::vector<unsigned char> bytes(static_cast<size_t>(size));
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), size))
        throw std::runtime_error("it cannot be read");
    return bytes;
}

// Returns whether the pixels after the header are complete. stb_image (2.27) reads zeros beyond the end of a file, and
// never ends if they are the length of a run.
bool isComplete(const std::vector<unsigned char>& bytes, int width, int height) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const size_t blank = text.find("\n\n"); // the header ends here; a line with the size follows
    size_t at = blank == text.npos ? text.npos : text.find('\n', blank + 2);
    if (at == text.npos)
        return false;
    ++at;
    const auto isRunLength = [&] {
        return width >= 8 && width < 32768 && bytes.size() - at >= 4 && bytes[at] == 2 && bytes[at + 1] == 2 &&
               bytes[at + 2] < 128;
    };
    if (!isRunLength())
        return (bytes.size() - at) / 4 >= size_t(width) * size_t(height);
    for (int y = 0; y < height; ++y) {
        if (!isRunLength())
            return false;
        at += 4;
        for (int channel = 0; channel < 4; ++channel)
            for (int x = 0; x < width;) {
                if (at >= bytes.size() || bytes[at] == 0)
                    return false;
                const bool isRun = bytes[at] > 128;
                x += isRun ? bytes[at] - 128 : bytes[at];
                at += isRun ? 2 : size_t(bytes[at]) + 1;
            }
        if (at > bytes.size())
            return false;
    }
    return true;
}

Image readChecked(const std::filesystem::path& path) {
    const std::vector<unsigned char> bytes = readBytes(path);
    const int size = int(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_is_hdr_from_memory(bytes.data(), size) ||
        !stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw std::runtime_error("it is not a Radiance file");
    if (width < 1 || height < 1 || int64_t(width) * height > maxPixels)
        throw std::runtime_error("its size of " + std::to_string(width) + "x" + std::to_string(height) +
                                 " pixels is not usable");
    if (!isComplete(bytes, width, height))
        throw std::runtime_error("it is damaged or not complete");
    const std::unique_ptr<float, void (*)(void*)> pixels(
        stbi_loadf_from_memory(bytes.data(), size, &width, &height, &channels, 3), stbi_image_free);
    if (!pixels)
        throw std::runtime_error(std::string("it is damaged (") + stbi_failure_reason() + ")");
    Image image{uint32_t(width), uint32_t(height), {}};
    image.rgb.assign(pixels.get(), pixels.get() + 3 * image.pixelCount());
    return image;
}

} // namespace

Image readHdr(const std::filesystem::path& path) {
    try {
        return readChecked(path);
    } catch (const std::exception& error) {
        throw std::runtime_error("Could not read the Radiance file \"" + path.string() + "\": " + error.what() + ".");
    }
}

} // namespace harness
