// Compresses text files into a C++ include file for core/base/embedded.cpp.
//
// usage: agaa-embed-text OUTPUT FOLDER,FOLDER… FILE…
// The name of a file is its path below the folder that has it.
#include "array_text.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

// Returns the path below one of the folders, which are separated by commas.
std::string nameOf(const fs::path& file, const std::string& folders) {
    for (size_t begin = 0; begin < folders.size();) {
        const size_t end = std::min(folders.find(',', begin), folders.size());
        const std::string path = file.lexically_relative(folders.substr(begin, end - begin)).generic_string();
        if (!path.empty() && !path.starts_with(".."))
            return path;
        begin = end + 1;
    }
    throw std::runtime_error("The file " + file.string() + " is in no folder of " + folders);
}

void embed(const fs::path& output, const std::string& folders, std::span<char*> files) {
    std::string rows, texts;
    for (const char* file : files) {
        std::ifstream stream(file, std::ios::binary);
        if (!stream)
            throw std::runtime_error("The file " + std::string(file) + " cannot be read");
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        rows += "{\"" + nameOf(file, folders) + "\", " + std::to_string(texts.size()) + ", " +
                std::to_string(text.size()) + "},\n";
        texts += text;
    }
    const std::vector<uint8_t> bytes =
        compressed(std::span(reinterpret_cast<const uint8_t*>(texts.data()), texts.size()));
    std::ofstream out(output, std::ios::binary);
    out << "constexpr TextRow textRows[] = {\n"
        << rows << "};\n"
        << arrayText("textData", bytes) << "constexpr size_t textDataBytes = " << bytes.size()
        << ", textBytes = " << texts.size() << ";\n";
    if (!out.flush())
        throw std::runtime_error("The file " + output.string() + " cannot be written");
}

} // namespace

int main(int count, char** arguments) {
    try {
        if (count < 4)
            throw std::runtime_error("OUTPUT FOLDERS FILE… are expected");
        embed(arguments[1], arguments[2], std::span(arguments + 3, size_t(count - 3)));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "agaa-embed-text: %s.\n", error.what());
        return EXIT_FAILURE;
    }
}
