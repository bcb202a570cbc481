// OpenEXR files.
#include "image/check.h"
#include "image/image.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include <array>
#include <stdexcept>
#include <string>

namespace harness {

namespace {

constexpr std::array<const char*, 3> channelNames = {"R", "G", "B"};
// The limit keeps a damaged header from causing a huge allocation.
constexpr int64_t maxSide = 1 << 16;
constexpr int64_t maxPixels = int64_t(1) << 26; // 768 MiB

// The library's messages may have several sentences, line breaks, and names that a damaged file has. The result is one
// sentence.
std::string oneSentence(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7F)
            c = ' ';
    }
    while (!text.empty() && (text.back() == '.' || text.back() == ' '))
        text.pop_back();
    for (size_t at = text.find(". "); at != std::string::npos; at = text.find(". ", at))
        text.replace(at, 1, ";");
    return text;
}

[[noreturn]] void fail(const char* verb, const std::filesystem::path& path, std::string reason) {
    throw std::runtime_error("Could not " + std::string(verb) + " the OpenEXR file \"" + path.string() +
                             "\": " + oneSentence(std::move(reason)) + ".");
}

Image readChecked(const std::filesystem::path& path) {
    Imf::InputFile file(path.string().c_str(), 0);
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1;
    const int64_t height = int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > maxSide || height > maxSide || width * height > maxPixels)
        throw std::runtime_error("its size of " + std::to_string(width) + "x" + std::to_string(height) +
                                 " pixels is not usable");
    for (const char* name : channelNames) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (!channel)
            throw std::runtime_error("it has no channel " + std::string(name));
        if (channel->type != Imf::HALF && channel->type != Imf::FLOAT)
            throw std::runtime_error("its channel " + std::string(name) + " is neither half nor float");
        if (channel->xSampling != 1 || channel->ySampling != 1)
            throw std::runtime_error("its channel " + std::string(name) + " is subsampled");
    }

    Image image;
    image.width = uint32_t(width);
    image.height = uint32_t(height);
    image.rgb.resize(image.pixelCount() * 3);
    Imf::FrameBuffer frame;
    for (size_t c = 0; c < channelNames.size(); ++c)
        frame.insert(channelNames[c], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + c, window, 3 * sizeof(float),
                                                       3 * sizeof(float) * size_t(width)));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

} // namespace

Image readExr(const std::filesystem::path& path) {
    try {
        return readChecked(path);
    } catch (const std::exception& error) {
        fail("read", path, error.what());
    }
}

void writeExr(const std::filesystem::path& path, const Image& image) {
    try {
        requireConsistent(image, "the image");
        Imf::Header header(int(image.width), int(image.height));
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer frame;
        // The library takes writable memory, but only reads it.
        float* pixels = const_cast<float*>(image.rgb.data());
        for (size_t c = 0; c < channelNames.size(); ++c) {
            header.channels().insert(channelNames[c], Imf::Channel(Imf::FLOAT));
            frame.insert(channelNames[c], Imf::Slice::Make(Imf::FLOAT, pixels + c, header.dataWindow(),
                                                           3 * sizeof(float), 3 * sizeof(float) * size_t(image.width)));
        }
        Imf::OutputFile file(path.string().c_str(), header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(int(image.height));
    } catch (const std::exception& error) {
        fail("write", path, error.what());
    }
}

} // namespace harness
