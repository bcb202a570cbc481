#include "scene/gltf_document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace harness {

namespace {

using nlohmann::json;

constexpr uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
constexpr int mostNesting = 100; // glTF itself nests about ten deep

struct Document {
    std::string text;
    std::string binary; // chunk of a .glb file
    bool isBinary = false;
};

[[noreturn]] void refuse(const std::string& why) {
    throw std::runtime_error("not a readable glTF file (" + shortened(why) + ")");
}

std::string readFile(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    if (!in)
        refuse("it cannot be read");
    if (bytes.size() > std::numeric_limits<int32_t>::max()) // the length that tinygltf takes has 32 bits
        refuse("it is larger than 2 GiB");
    return bytes;
}

uint32_t wordAt(const std::string& bytes, size_t offset) {
    uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word); // little-endian, as the format is
    return word;
}

Document splitChunks(const std::string& bytes) {
    Document document;
    document.isBinary = true;
    if (bytes.size() < 20 || wordAt(bytes, 4) != 2)
        refuse("it has no header of a version 2 binary");
    for (size_t at = 12; at + 8 <= bytes.size();) {
        const uint32_t length = wordAt(bytes, at), type = wordAt(bytes, at + 4);
        at += 8;
        if (length > bytes.size() - at)
            refuse("a chunk is longer than the file");
        if (type == jsonChunk && document.text.empty())
            document.text = bytes.substr(at, length);
        else if (type == binaryChunk && document.binary.empty())
            document.binary = bytes.substr(at, length);
        at += (size_t(length) + 3) / 4 * 4;
    }
    return document;
}

Document readDocument(const std::filesystem::path& path) {
    std::string bytes = readFile(path);
    return bytes.starts_with("glTF") ? splitChunks(bytes) : Document{std::move(bytes), {}, false};
}

// Brackets in strings do not nest.
void checkNesting(const std::string& text) {
    int depth = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString && c == '\\')
            ++i;
        else if (c == '"')
            inString = !inString;
        else if (!inString && (c == '{' || c == '['))
            ++depth;
        else if (!inString && (c == '}' || c == ']'))
            --depth;
        if (depth > mostNesting)
            refuse("its values are nested more than " + std::to_string(mostNesting) + " deep");
    }
}

json parse(const std::string& text) {
    checkNesting(text);
    try {
        return json::parse(text);
    } catch (const json::exception& error) {
        refuse(error.what());
    }
}

void requireKnownExtensions(const json& root) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || !required->is_array())
        return;
    for (const json& name : *required)
        if (name.is_string() &&
            std::find(knownExtensions.begin(), knownExtensions.end(), name.get<std::string>()) == knownExtensions.end())
            throw std::runtime_error("it requires the extension " + shortened(name.get<std::string>()) +
                                     ", which is not supported");
}

std::string replaced(const std::string& text, std::string_view from, std::string_view to) {
    std::string out;
    size_t begin = 0;
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, begin)) {
        out.append(text, begin, at - begin).append(to);
        begin = at + from.size();
    }
    return out.append(text, begin);
}

// tinygltf decodes URIs as forms do, where a plus sign is a space. Returns whether there was one to escape.
bool escapePlusSigns(json& root, const char* list) {
    bool isChanged = false;
    const auto found = root.find(list);
    if (found == root.end() || !found->is_array())
        return false;
    for (json& item : *found) {
        if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string())
            continue;
        auto& uri = item["uri"].get_ref<std::string&>();
        if (uri.starts_with("data:") || uri.find('+') == std::string::npos)
            continue;
        uri = replaced(uri, "+", "%2B");
        isChanged = true;
    }
    return isChanged;
}

void append(std::string& bytes, uint32_t word) { bytes.append(reinterpret_cast<const char*>(&word), sizeof word); }

void appendChunk(std::string& bytes, uint32_t type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    append(bytes, uint32_t(content.size()));
    append(bytes, type);
    bytes += content;
}

// Returns a .glb file whose sizes are right.
std::string joinChunks(const Document& document) {
    std::string chunks;
    appendChunk(chunks, jsonChunk, document.text, ' ');
    if (!document.binary.empty())
        appendChunk(chunks, binaryChunk, document.binary, '\0');
    std::string bytes = "glTF";
    append(bytes, 2);
    append(bytes, uint32_t(12 + chunks.size()));
    return bytes + chunks;
}

bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
    // tinygltf does not compare the view of an image with its buffer, so its bytes must not be read here.
    if (image->bufferView < 0 && size > 0)
        image->image.assign(bytes, bytes + size);
    return true;
}

// tinygltf's own functions open directories, whose size it takes for 2^63 - 1 bytes, and wait for pipes. A zero ends
// the name for the file system, but not for the file.
bool isFile(const std::string& path, void*) {
    std::error_code error;
    return path.find('\0') == std::string::npos && std::filesystem::is_regular_file(path, error);
}

bool readBytes(std::vector<unsigned char>* bytes, std::string* why, const std::string& path, void*) {
    std::error_code error;
    const uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream in(path, std::ios::binary);
    bytes->resize(error ? 0 : size);
    in.read(reinterpret_cast<char*>(bytes->data()), std::streamsize(bytes->size()));
    if (!in)
        *why = "it cannot be read";
    return bool(in);
}

} // namespace

tinygltf::Model readGltfModel(const std::filesystem::path& path) {
    Document document = readDocument(path);
    json root = parse(document.text);
    requireKnownExtensions(root);
    if (escapePlusSigns(root, "buffers") | escapePlusSigns(root, "images"))
        document.text = root.dump();
    root.clear();
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepEncoded, nullptr);
    loader.SetFsCallbacks({isFile, tinygltf::ExpandFilePath, readBytes, tinygltf::WriteWholeFile, nullptr});
    tinygltf::Model model;
    std::string errors, warnings;
    const std::string folder = path.parent_path().string();
    const bool isBinary = document.isBinary;
    bool isLoaded = false;
    try {
        if (isBinary) {
            const std::string joined = joinChunks(document);
            document = {};
            isLoaded = loader.LoadBinaryFromMemory(&model, &errors, &warnings,
                                                   reinterpret_cast<const unsigned char*>(joined.data()),
                                                   unsigned(joined.size()), folder);
        } else {
            isLoaded = loader.LoadASCIIFromString(&model, &errors, &warnings, document.text.data(),
                                                  unsigned(document.text.size()), folder);
        }
    } catch (const std::exception& error) {
        refuse(error.what());
    }
    if (!isLoaded)
        refuse(errors.empty() ? "unknown reason" : errors.substr(0, errors.find('\n')));
    for (tinygltf::Image& image : model.images)
        image.uri = replaced(image.uri, "%2B", "+"); // names in messages are those of the file
    return model;
}

} // namespace harness
