#include "gl/program_cache.h"

#include "agaa_sdk.h"

#include <cstring>
#include <optional>

namespace agaa::gl {

namespace {

// Layout of the bytes: a header, the driver's name, the binaries, and a checksum of everything before it. Numbers have
// the byte order of the processor; the mark does not match on a processor with the other byte order.
constexpr uint32_t mark = 0x41475043, formatVersion = 1;
struct Header {
    uint32_t mark, formatVersion, libraryVersion, driverBytes;
    uint64_t count; // binaries
};
struct Entry {
    uint64_t low, high; // Key
    uint32_t format, bytes;
};

// FNV-1a: a change of any one byte changes the hash.
uint64_t hash(std::string_view text, uint64_t state = 0xCBF29CE484222325u) {
    for (const char c : text)
        state = (state ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return state;
}
uint64_t checksum(std::span<const std::byte> data) {
    return hash({reinterpret_cast<const char*>(data.data()), data.size()});
}

// Reads values in sequence and fails at the end of the data.
class Reader {
public:
    explicit Reader(std::span<const std::byte> data) : rest_(data) {}
    std::optional<std::span<const std::byte>> take(size_t count) {
        if (count > rest_.size())
            return std::nullopt;
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    template <class T> bool read(T& value) {
        const auto taken = take(sizeof value);
        if (taken)
            std::memcpy(&value, taken->data(), sizeof value);
        return taken.has_value();
    }
    bool atEnd() const { return rest_.empty(); }

private:
    std::span<const std::byte> rest_;
};

void append(std::vector<std::byte>& out, const void* data, size_t size) {
    const size_t at = out.size();
    out.resize(at + size);
    if (size > 0)
        std::memcpy(out.data() + at, data, size);
}

} // namespace

ProgramCache::Key ProgramCache::keyOf(std::string_view text) {
    const uint64_t low = hash(text);
    return {low, hash(text, ~low ^ text.size())};
}

const ProgramCache::Binary* ProgramCache::find(const Key& key) const {
    const auto found = binaries_.find(key);
    return found == binaries_.end() ? nullptr : &found->second;
}

std::string ProgramCache::read(std::span<const std::byte> data) {
    constexpr const char* damaged = "is damaged";
    uint64_t sum = 0;
    if (data.size() < sizeof(Header) + sizeof sum)
        return damaged;
    const auto content = data.first(data.size() - sizeof sum);
    std::memcpy(&sum, data.data() + content.size(), sizeof sum);
    if (sum != checksum(content))
        return damaged;
    Reader reader(content);
    Header header{};
    reader.read(header);
    if (header.mark != mark)
        return damaged;
    if (header.formatVersion != formatVersion || header.libraryVersion != AGAA_HEADER_VERSION)
        return "is of another version of the library";
    const auto driver = reader.take(header.driverBytes);
    if (!driver)
        return damaged;
    if (std::string_view(reinterpret_cast<const char*>(driver->data()), driver->size()) != driver_)
        return "is of another driver";
    std::map<Key, Binary> binaries;
    for (uint64_t i = 0; i < header.count; ++i) {
        Entry entry{};
        if (!reader.read(entry))
            return damaged;
        const auto bytes = reader.take(entry.bytes);
        if (!bytes)
            return damaged;
        binaries[{entry.low, entry.high}] = {entry.format, {bytes->begin(), bytes->end()}};
    }
    if (!reader.atEnd())
        return damaged;
    binaries_.merge(binaries);
    return {};
}

std::vector<std::byte> ProgramCache::bytes() const {
    std::vector<std::byte> out;
    const Header header{mark, formatVersion, AGAA_HEADER_VERSION, uint32_t(driver_.size()), binaries_.size()};
    append(out, &header, sizeof header);
    append(out, driver_.data(), driver_.size());
    for (const auto& [key, binary] : binaries_) {
        const Entry entry{key.low, key.high, binary.format, uint32_t(binary.bytes.size())};
        append(out, &entry, sizeof entry);
        append(out, binary.bytes.data(), binary.bytes.size());
    }
    const uint64_t sum = checksum(out);
    append(out, &sum, sizeof sum);
    return out;
}

} // namespace agaa::gl
