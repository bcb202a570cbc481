// Files of environments: both formats, and errors of one sentence.
#include "environment/environment.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

using namespace harness;
namespace fs = std::filesystem;

namespace {

class EnvironmentFiles : public testing::Test {
protected:
    EnvironmentFiles() { fs::create_directories(folder_); }
    ~EnvironmentFiles() override { fs::remove_all(folder_); }
    fs::path path(const char* name) const { return folder_ / name; }

    static Image gradient(uint32_t width, uint32_t height) {
        Image image{width, height, {}};
        for (size_t i = 0; i < 3 * image.pixelCount(); ++i)
            image.rgb.push_back(0.25f + float(i % 97));
        return image;
    }
    void writeRadiance(const fs::path& file, const Image& image) const {
        ASSERT_TRUE(stbi_write_hdr(file.string().c_str(), int(image.width), int(image.height), 3, image.rgb.data()));
    }
    static std::string bytesOf(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    static void write(const fs::path& file, const std::string& bytes) {
        std::ofstream(file, std::ios::binary) << bytes;
    }
    // Expects one sentence that names the file, and returns it.
    static std::string errorOf(const fs::path& file) {
        try {
            loadEnvironment(file);
        } catch (const std::runtime_error& error) {
            const std::string text = error.what();
            EXPECT_NE(text.find(file.string()), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            EXPECT_EQ(text.back(), '.') << text;
            return text;
        }
        ADD_FAILURE() << file << " was read";
        return "";
    }

private:
    fs::path folder_ = fs::temp_directory_path() / ("agaa-environment-" + std::to_string(getpid()));
};

TEST_F(EnvironmentFiles, BothFormatsHoldTheSameLight) {
    const Image image = gradient(64, 32);
    writeExr(path("a.exr"), image);
    writeRadiance(path("a.HDR"), image);
    const Environment exr = loadEnvironment(path("a.exr")), hdr = loadEnvironment(path("a.HDR"));
    EXPECT_EQ(exr.fileWidth, 64u);
    EXPECT_EQ(hdr.fileHeight, 32u);
    EXPECT_GT(exr.bytes(), 4000000u);
    for (int c = 0; c < 3; ++c) // Radiance files have 8 bits of mantissa
        EXPECT_NEAR(hdr.constants.irradiance[0][c] / exr.constants.irradiance[0][c], 1, 0.01);
}

TEST_F(EnvironmentFiles, OtherSizesAreRefused) {
    for (const auto& [width, height] : {std::pair{64u, 64u}, {65u, 32u}, {1u, 1u}, {32u, 64u}}) {
        writeExr(path("odd.exr"), gradient(width, height));
        EXPECT_NE(errorOf(path("odd.exr")).find(std::to_string(width) + "x" + std::to_string(height)),
                  std::string::npos);
    }
    writeExr(path("least.exr"), gradient(2, 1));
    EXPECT_EQ(loadEnvironment(path("least.exr")).fileWidth, 2u);
}

TEST_F(EnvironmentFiles, MissingAndOtherFilesAreRefused) {
    errorOf(path("missing.hdr"));
    errorOf(path("missing.exr"));
    errorOf(path("picture.png"));
    fs::create_directories(path("folder.hdr"));
    errorOf(path("folder.hdr"));
    write(path("empty.hdr"), "");
    errorOf(path("empty.hdr"));
    write(path("text.hdr"), "not an image\n");
    errorOf(path("text.hdr"));
    write(path("huge.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 200000\n");
    errorOf(path("huge.hdr"));
}

TEST_F(EnvironmentFiles, DamagedFilesAreRefused) {
    writeRadiance(path("whole.hdr"), gradient(64, 32));
    writeExr(path("whole.exr"), gradient(64, 32));
    const std::string hdr = bytesOf(path("whole.hdr")), exr = bytesOf(path("whole.exr"));
    for (const double share : {0.01, 0.3, 0.6, 0.95}) {
        write(path("cut.hdr"), hdr.substr(0, size_t(share * double(hdr.size()))));
        errorOf(path("cut.hdr"));
        write(path("cut.exr"), exr.substr(0, size_t(share * double(exr.size()))));
        errorOf(path("cut.exr"));
    }
}

} // namespace
