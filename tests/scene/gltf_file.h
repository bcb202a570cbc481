// Writes small glTF files for the loader's tests, and reads the errors that the loader reports.
#pragma once

#include "scene/gltf.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace scene_test {

// A folder of this process, removed when it ends: tests run side by side and write files of the same names.
inline const std::filesystem::path& scratchFolder() {
    struct Folder {
        Folder() {
            std::string name = (std::filesystem::temp_directory_path() / "agaa_scenes_XXXXXX").string();
            if (!mkdtemp(name.data()))
                throw std::runtime_error("cannot create a folder like " + name + ".");
            path = name;
        }
        ~Folder() {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
        std::filesystem::path path;
    };
    static const Folder folder;
    return folder.path;
}

// Collects buffer data with its bufferViews and accessors; everything else is given as JSON text.
class GltfFile {
public:
    // Returns the accessor's index. Accessors begin at multiples of 4 bytes, as the format asks.
    template <typename T>
    int add(const std::vector<T>& values, const std::string& type, int componentType, bool normalized = false) {
        static const std::vector<std::pair<std::string, size_t>> types{
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        size_t components = 0;
        for (const auto& [name, count] : types)
            if (name == type)
                components = count;
        const size_t offset = (bytes.size() + 3) / 4 * 4;
        bytes.resize(offset + values.size() * sizeof(T));
        std::memcpy(bytes.data() + offset, values.data(), values.size() * sizeof(T));
        join(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                         std::to_string(values.size() * sizeof(T)) + "}");
        join(accessors_, R"({"bufferView":)" + std::to_string(count_) + R"(,"componentType":)" +
                             std::to_string(componentType) + R"(,"count":)" +
                             std::to_string(values.size() / components) + R"(,"type":")" + type + R"(","normalized":)" +
                             (normalized ? "true" : "false") + "}");
        return count_++;
    }

    // An embedded image; returns its bufferView. Accessors have to be added before it.
    int addView(const std::vector<uint8_t>& data) {
        const size_t offset = bytes.size();
        bytes.insert(bytes.end(), data.begin(), data.end());
        join(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                         std::to_string(data.size()) + "}");
        return count_++;
    }

    // `rest` is the file's other members, such as "nodes", without the outer braces.
    std::string json(const std::string& rest, const std::string& bufferUri) const {
        const std::string uri = bufferUri.empty() ? "" : R"("uri":")" + bufferUri + R"(",)";
        return R"({"asset":{"version":"2.0"},"buffers":[{)" + uri + R"("byteLength":)" + std::to_string(bytes.size()) +
               R"(}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ + "]," + rest + "}";
    }

    std::filesystem::path writeGltf(const std::string& stem, const std::string& rest) const {
        const std::filesystem::path path = scratchFolder() / (stem + ".gltf");
        write(scratchFolder() / (stem + ".bin"), {bytes.begin(), bytes.end()});
        write(path, json(rest, stem + ".bin"));
        return path;
    }

    std::filesystem::path writeGlb(const std::string& stem, const std::string& rest) const {
        std::string text = json(rest, "");
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string data(bytes.begin(), bytes.end());
        data.resize((data.size() + 3) / 4 * 4, '\0');
        std::string file = "glTF";
        append(file, 2);
        append(file, uint32_t(12 + 8 + text.size() + 8 + data.size()));
        append(file, uint32_t(text.size()));
        file += "JSON" + text;
        append(file, uint32_t(data.size()));
        file += std::string("BIN\0", 4) + data;
        const std::filesystem::path path = scratchFolder() / (stem + ".glb");
        write(path, file);
        return path;
    }

    static void write(const std::filesystem::path& path, const std::string& content) {
        std::ofstream(path, std::ios::binary).write(content.data(), std::streamsize(content.size()));
    }

    std::vector<uint8_t> bytes;

private:
    static void join(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }
    static void append(std::string& file, uint32_t value) {
        file.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    std::string views_;
    std::string accessors_;
    int count_ = 0;
};

constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;

// A unit square in the plane z = 0 facing +z, as a strip.
inline const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

inline const std::vector<float> kSquareNormals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

// A 1 x 2 PNG: red above transparent black.
inline const std::vector<uint8_t> kPng{
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x99, 0x81, 0xb6, 0x27, 0x00, 0x00, 0x00,
    0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0x00, 0x44, 0x40, 0x00, 0x00, 0x0e, 0xfb,
    0x01, 0xff, 0x07, 0xd2, 0x15, 0xed, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

inline std::string str(int n) { return std::to_string(n); }

// The members of a file with one node, whose mesh is one primitive.
inline std::string oneNode(const std::string& primitive) {
    return R"("meshes":[{"primitives":[{)" + primitive + R"(}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])";
}

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], tolerance);
}

// The sentence of the exception; fails where none is thrown.
inline std::string errorOf(const std::filesystem::path& path) {
    try {
        harness::loadGltf(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    ADD_FAILURE() << path << " was loaded";
    return {};
}

inline void expectError(const std::filesystem::path& path, const std::string& part) {
    const std::string sentence = errorOf(path);
    EXPECT_NE(sentence.find(path.string()), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_LT(sentence.size(), path.string().size() + 400) << sentence;
}

} // namespace scene_test
