#include "error_of.h"
#include "image/image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <gtest/gtest.h>
#include <stb_image.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <unistd.h>

using namespace harness;
namespace fs = std::filesystem;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

// One sentence: a full stop at the end and no line break or second sentence before it.
void expectSentenceNaming(const std::string& error, const fs::path& path) {
    EXPECT_NE(error.find(path.string()), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_EQ(error.find(". "), std::string::npos) << error;
    EXPECT_TRUE(error.ends_with('.') && !error.ends_with("..")) << error;
}

class ImageFiles : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "image_files_XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    fs::path folder;
};

struct Decoded {
    int width = 0, height = 0, channels = 0;
    std::vector<int> bytes;
};

Decoded decodePng(const fs::path& path) {
    Decoded out;
    unsigned char* data = stbi_load(path.string().c_str(), &out.width, &out.height, &out.channels, 0);
    if (data)
        out.bytes.assign(data, data + out.width * out.height * out.channels);
    stbi_image_free(data);
    return out;
}

void expectSameBits(const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(std::bit_cast<uint32_t>(a[i]), std::bit_cast<uint32_t>(b[i])) << i;
}

// Writes channels of one type by the library itself, value = 100 * x + 10 * y + channel.
void writeForeign(const fs::path& path, const std::string& channels, Imf::PixelType type, const Imath::Box2i& window) {
    Imf::Header header(Imath::Box2i({0, 0}, {31, 31}), window);
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::vector<std::vector<float>> floats(channels.size());
    std::vector<std::vector<Imath::half>> halves(channels.size());
    std::vector<std::vector<unsigned>> integers(channels.size());
    Imf::FrameBuffer frame;
    for (size_t c = 0; c < channels.size(); ++c) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                floats[c].push_back(float(100 * x + 10 * y) + float(c));
                halves[c].push_back(Imath::half(floats[c].back()));
                integers[c].push_back(unsigned(floats[c].back()));
            }
        }
        void* data = type == Imf::FLOAT  ? static_cast<void*>(floats[c].data())
                     : type == Imf::HALF ? static_cast<void*>(halves[c].data())
                                         : static_cast<void*>(integers[c].data());
        const size_t size = type == Imf::HALF ? 2 : 4;
        const std::string name(1, channels[c]);
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice::Make(type, data, window, size, size * size_t(width)));
    }
    Imf::OutputFile file(path.string().c_str(), header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(height);
}

} // namespace

TEST_F(ImageFiles, ExrRoundTripIsBitwise) {
    Image image{37, 19, {}};
    std::mt19937 random(7);
    for (size_t i = 0; i < image.pixelCount() * 3; ++i)
        image.rgb.push_back(std::bit_cast<float>(uint32_t(random())));
    image.rgb[0] = notANumber;
    image.rgb[1] = infinity;
    image.rgb[2] = -0.f;
    image.rgb[3] = std::numeric_limits<float>::denorm_min();
    image.rgb[4] = std::numeric_limits<float>::max();
    const fs::path path = folder / "round trip.exr";
    writeExr(path, image);
    const Image back = readExr(path);
    EXPECT_EQ(back.width, 37u);
    EXPECT_EQ(back.height, 19u);
    expectSameBits(back.rgb, image.rgb);
}

TEST_F(ImageFiles, ExrIsFloatZipRgb) {
    const fs::path path = folder / "a.exr";
    writeExr(path, {2, 1, {1, 2, 3, 4, 5, 6}});
    Imf::InputFile file(path.string().c_str(), 0);
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    std::string names;
    for (auto it = file.header().channels().begin(); it != file.header().channels().end(); ++it) {
        names += it.name();
        EXPECT_EQ(it.channel().type, Imf::FLOAT);
    }
    EXPECT_EQ(names, "BGR");
}

TEST_F(ImageFiles, ExrOfOnePixel) {
    const fs::path path = folder / "one.exr";
    writeExr(path, {1, 1, {0.25f, -1, 1e6f}});
    EXPECT_EQ(readExr(path).rgb, (std::vector<float>{0.25f, -1, 1e6f}));
}

TEST_F(ImageFiles, ExrWithHalfOrFloatOffsetWindowAndOtherChannels) {
    const fs::path path = folder / "foreign.exr";
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
        writeForeign(path, "RGBAZ", type, Imath::Box2i({-3, 5}, {1, 8}));
        const Image image = readExr(path);
        ASSERT_EQ(image.width, 5u);
        ASSERT_EQ(image.height, 4u);
        for (uint32_t y = 0; y < 4; ++y)
            for (uint32_t x = 0; x < 5; ++x)
                for (uint32_t c = 0; c < 3; ++c)
                    EXPECT_EQ(image.rgb[3 * (y * 5 + x) + c], float(100 * x + 10 * y + c));
    }
}

TEST_F(ImageFiles, ExrInTiles) {
    const fs::path path = folder / "tiled.exr";
    const int width = 21, height = 13;
    std::vector<float> values(size_t(width) * height * 3);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = float(i);
    {
        Imf::Header header(width, height);
        Imf::FrameBuffer frame;
        for (size_t c = 0; c < 3; ++c) {
            const std::string name(1, "RGB"[c]);
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            frame.insert(name,
                         Imf::Slice::Make(Imf::FLOAT, values.data() + c, header.dataWindow(), 12, 12 * size_t(width)));
        }
        header.setTileDescription(Imf::TileDescription(8, 8));
        Imf::TiledOutputFile file(path.string().c_str(), header, 0);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }
    expectSameBits(readExr(path).rgb, values);
}

TEST_F(ImageFiles, ExrReadErrorsNameTheFile) {
    const fs::path missing = folder / "no such file.exr";
    expectSentenceNaming(errorOf([&] { readExr(missing); }), missing);

    const fs::path damaged = folder / "damaged.exr";
    std::ofstream(damaged) << "not an image at all";
    expectSentenceNaming(errorOf([&] { readExr(damaged); }), damaged);

    const fs::path grey = folder / "grey.exr";
    writeForeign(grey, "Y", Imf::HALF, Imath::Box2i({0, 0}, {3, 3}));
    expectSentenceNaming(errorOf([&] { readExr(grey); }), grey);

    const fs::path integers = folder / "integers.exr";
    writeForeign(integers, "RGB", Imf::UINT, Imath::Box2i({0, 0}, {3, 3}));
    expectSentenceNaming(errorOf([&] { readExr(integers); }), integers);

    const fs::path cut = folder / "cut.exr";
    writeExr(cut, {64, 64, std::vector<float>(64 * 64 * 3, 0.5f)});
    fs::resize_file(cut, fs::file_size(cut) - 40);
    expectSentenceNaming(errorOf([&] { readExr(cut); }), cut);
}

TEST_F(ImageFiles, WriteErrorsNameTheFile) {
    const Image image{1, 1, {0, 0, 0}};
    const Image broken{2, 1, {0, 0, 0}};
    const fs::path exr = folder / "absent" / "a.exr", png = folder / "absent" / "a.png";
    expectSentenceNaming(errorOf([&] { writeExr(exr, image); }), exr);
    expectSentenceNaming(errorOf([&] { writePng(png, image); }), png);
    expectSentenceNaming(errorOf([&] { writeDifferencePng(png, image, image, 1); }), png);
    const fs::path other = folder / "a";
    expectSentenceNaming(errorOf([&] { writeExr(other, broken); }), other);
    expectSentenceNaming(errorOf([&] { writePng(other, broken); }), other);
    expectSentenceNaming(errorOf([&] { writePng(other, Image{}); }), other);
    EXPECT_FALSE(fs::exists(other));
}

TEST_F(ImageFiles, PngIsToneMapped) {
    const fs::path path = folder / "a.png";
    // 1 -> 0.5^(1/2.2) = 0.7297, 3 -> 0.8774, 1e30 -> 1
    writePng(path, {3, 2, {0, 1, 3, 1e30f, -1, 0, 1, 1, 1, notANumber, 0, 0, 0, infinity, 0, 0, 0, 0}});
    const Decoded png = decodePng(path);
    EXPECT_EQ(png.width, 3);
    EXPECT_EQ(png.height, 2);
    EXPECT_EQ(png.channels, 3);
    EXPECT_EQ(png.bytes, (std::vector<int>{0, 186, 224, 255, 0, 0, 186, 186, 186, 255, 0, 255, 255, 0, 255, 0, 0, 0}));
}

TEST_F(ImageFiles, PngOfOnePixel) {
    const fs::path path = folder / "one.png";
    writePng(path, {1, 1, {1, 1, 1}});
    EXPECT_EQ(decodePng(path).bytes, (std::vector<int>{186, 186, 186}));
}

TEST_F(ImageFiles, JpegIsNearlyThePng) {
    const fs::path path = folder / "a.jpg";
    Image ramp{64, 16, {}};
    for (int i = 0; i < 64 * 16; ++i)
        ramp.rgb.insert(ramp.rgb.end(), 3, float(i % 64) / 32);
    writeJpeg(path, ramp, 90);
    writePng(folder / "a.png", ramp);
    const Decoded jpeg = decodePng(path), png = decodePng(folder / "a.png"); // by the same library
    ASSERT_EQ(jpeg.bytes.size(), png.bytes.size());
    for (size_t i = 0; i < png.bytes.size(); ++i)
        ASSERT_NEAR(jpeg.bytes[i], png.bytes[i], 6) << i;
    EXPECT_LT(fs::file_size(path), 2000u);
    expectSentenceNaming(errorOf([&] { writeJpeg(path, ramp, 0); }), path);
    expectSentenceNaming(errorOf([&] { writeJpeg(path, ramp, 101); }), path);
}
TEST_F(ImageFiles, DifferencePng) {
    const fs::path path = folder / "difference.png";
    const Image a{3, 1, {1, 0, 3, 0, 0, 0, 1, 1, 1}};
    const Image b{3, 1, {0, 1, 1, 0, 0, 0, 1, notANumber, 1}};
    writeDifferencePng(path, a, b, 1);
    // 0.7297 and 0.8774 - 0.7297 = 0.1477 of 255
    EXPECT_EQ(decodePng(path).bytes, (std::vector<int>{186, 186, 38, 0, 0, 0, 255, 0, 255}));
    writeDifferencePng(path, a, b, 4);
    EXPECT_EQ(decodePng(path).bytes, (std::vector<int>{255, 255, 151, 0, 0, 0, 255, 0, 255}));
    expectSentenceNaming(errorOf([&] { writeDifferencePng(path, a, {1, 3, b.rgb}, 1); }), path);
    expectSentenceNaming(errorOf([&] { writeDifferencePng(path, a, b, notANumber); }), path);
}
