// Targets gltf, layout, measured, exr and cache: files that the sample engine and the library read.
#include "target.h"

#include "cli/arguments.h"
#include "cli/layout_file.h"
#include "cli/measured_file.h"
#include "gl/program_cache.h"
#include "image/image.h"
#include "scene/gltf.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace fuzz {

namespace {

// Loads a text from a file. Errors must be std::runtime_error with one line.
template <typename Load> void readFile(const char* extension, const std::string& text, const Load& load) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("agaa_fuzz_" + std::to_string(getpid()) + extension);
    std::ofstream(path, std::ios::binary) << text;
    try {
        load(path);
        countAccepted();
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        if (message.empty())
            report("an error without a message");
        checkLine("loading", message);
    } catch (const std::exception& error) {
        report(std::string("another kind of exception: ") + error.what());
    }
    std::filesystem::remove(path);
}

void checkScene(const harness::Scene& scene) {
    for (const harness::Mesh& mesh : scene.meshes) {
        if (mesh.firstVertex > scene.vertices.size() || mesh.vertexCount > scene.vertices.size() - mesh.firstVertex ||
            mesh.firstIndex > scene.indices.size() || mesh.indexCount > scene.indices.size() - mesh.firstIndex ||
            mesh.material >= scene.materials.size())
            return report("a mesh reaches beyond the scene");
        for (uint32_t i = 0; i < mesh.indexCount; ++i)
            if (scene.indices[mesh.firstIndex + i] >= mesh.vertexCount)
                return report("an index reaches beyond its mesh");
    }
    for (const harness::Instance& instance : scene.instances)
        if (instance.mesh >= scene.meshes.size())
            report("an instance has no mesh");
    for (const harness::Material& material : scene.materials)
        for (const int texture :
             {material.baseColorTexture, material.normalTexture, material.metalRoughTexture, material.emissiveTexture})
            if (texture < -1 || texture >= int(scene.textures.size()))
                report("a material has no such texture");
    for (const harness::Vertex& vertex : scene.vertices)
        if (!std::isfinite(vertex.position.x + vertex.position.y + vertex.position.z) ||
            !std::isfinite(vertex.normal.x + vertex.normal.y + vertex.normal.z) ||
            !std::isfinite(vertex.uv.x + vertex.uv.y))
            return report("a vertex is not finite");
    for (const std::string& dropped : scene.dropped)
        checkLine("a dropped feature", dropped);
}

} // namespace

void readGltf(const std::string& text) {
    readFile(".gltf", text, [](const std::filesystem::path& path) { checkScene(harness::loadGltf(path)); });
}

void readLayoutFile(const std::string& text) {
    readFile(".json", text, [](const std::filesystem::path& path) {
        try {
            harness::readLayout(path);
        } catch (const harness::BadArgument& error) {
            throw std::runtime_error(error.what());
        }
    });
}

void readMeasuredFile(const std::string& text) {
    readFile(".json", text, [](const std::filesystem::path& path) { harness::MeasuredFile file(path.string()); });
}

void readExrFile(const std::string& text) {
    readFile(".exr", text, [](const std::filesystem::path& path) {
        const harness::Image image = harness::readExr(path);
        if (image.rgb.size() != 3 * image.pixelCount())
            report("an image has other pixels than its size says");
    });
}

// The checksum of a changed cache is made right, so that the reader gets further.
void readProgramCache(const std::string& text) {
    std::string bytes = text;
    if (bytes.size() >= 8) {
        uint64_t hash = 0xCBF29CE484222325u;
        for (size_t i = 0; i + 8 < bytes.size(); ++i)
            hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 0x100000001B3u;
        std::memcpy(bytes.data() + bytes.size() - 8, &hash, 8);
    }
    agaa::gl::ProgramCache cache("driver");
    cache.set({1, 2}, {});
    const std::string why = cache.read(std::as_bytes(std::span(bytes)));
    if (!why.empty() && cache.size() != 1)
        report("a cache that was refused was read");
    if (why.empty())
        countAccepted();
}

} // namespace fuzz
