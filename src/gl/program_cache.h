// Cache of program binaries, which hosts can store as bytes between runs. It calls no OpenGL function.
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
    // 128-bit hash of a program's whole text; collisions are not handled.
    struct Key {
        uint64_t low = 0, high = 0;
        auto operator<=>(const Key&) const = default;
    };
    static Key keyOf(std::string_view text);

    struct Binary {
        uint32_t format = 0; // GLenum
        std::vector<std::byte> bytes;
    };

    // driver: differs from the string of every driver whose binaries this one cannot load.
    explicit ProgramCache(std::string driver) : driver_(std::move(driver)) {}

    // Adds the programs of an earlier run. Any data is allowed. If the same driver and library did not write it with
    // bytes(), nothing is added, and the function returns the reason as the end of a sentence.
    std::string read(std::span<const std::byte> data);
    std::vector<std::byte> bytes() const;

    const Binary* find(const Key& key) const; // null if the cache lacks it
    void set(const Key& key, Binary binary) { binaries_[key] = std::move(binary); }
    size_t size() const { return binaries_.size(); }

private:
    std::string driver_;
    std::map<Key, Binary> binaries_;
};

} // namespace agaa::gl
