// Binaries of programs, and the bytes in which hosts keep them from run to run. Calls no OpenGL.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace agaa::gl {

class ProgramCache {
public:
    // Of a program's whole text. Two texts of the same key are not expected in the life of the universe.
    struct Key {
        uint64_t low = 0, high = 0;
        auto operator<=>(const Key&) const = default;
    };
    static Key keyOf(std::string_view text);

    struct Binary {
        uint32_t format = 0; // GLenum
        std::vector<std::byte> bytes;
    };

    // driver: tells it from all whose binaries it cannot load.
    explicit ProgramCache(std::string driver) : driver_(std::move(driver)) {}

    // Adds the programs of an earlier run. Whatever the bytes are: where they are not those of bytes() by the same driver and
    // library, nothing is added, and the reason is returned as the end of a sentence.
    std::string read(std::span<const std::byte> data);
    std::vector<std::byte> bytes() const;

    const Binary* find(const Key& key) const; // null: there is none
    void set(const Key& key, Binary binary) { binaries_[key] = std::move(binary); }
    size_t size() const { return binaries_.size(); }

private:
    std::string driver_;
    std::map<Key, Binary> binaries_;
};

} // namespace agaa::gl
