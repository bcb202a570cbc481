#include "core/base/structs.h"

namespace agaa {

namespace {

constexpr uint32_t largest = 1 << 16; // bytes of a struct; a larger size is taken for uninitialised memory

// A later version's struct may be longer. The bytes that this version does not know must be 0, the defaults.
void checkTail(const void* structure, size_t from, size_t to, const char* name) {
    const auto* bytes = static_cast<const unsigned char*>(structure);
    for (size_t i = from; i < to; ++i)
        if (bytes[i] != 0)
            fail(AGAA_ERROR_VERSION, format("%s has data at offset %zu, which this library (%u.%u.%u) does not know.",
                                            name, i, AGAA_VERSION_MAJOR, AGAA_VERSION_MINOR, AGAA_VERSION_PATCH));
}

const AgaaStructHeader* next(const AgaaStructHeader* header) {
    return static_cast<const AgaaStructHeader*>(header->pNext);
}

} // namespace

void checkStruct(const void* structure, const StructRow& row) {
    if (!structure)
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s is null.", row.name));
    const auto* header = static_cast<const AgaaStructHeader*>(structure);
    if (header->sType != row.sType)
        fail(AGAA_ERROR_STRUCT,
             format("%s has sType %u where %u is expected; start from its _INIT.", row.name, header->sType, row.sType));
    checkStructSize(structure, row);
}

void checkStructSize(const void* structure, const StructRow& row) {
    const uint32_t size = static_cast<const AgaaStructHeader*>(structure)->structSize;
    if (size < row.firstSize || size > largest)
        fail(AGAA_ERROR_STRUCT, format("%s has structSize %u; this library's is %zu, that of version 0.2 %zu.",
                                       row.name, size, row.size, row.firstSize));
    if (size % alignof(AgaaStructHeader) != 0)
        fail(AGAA_ERROR_STRUCT, format("%s has structSize %u, which is not a multiple of 8.", row.name, size));
    checkTail(structure, row.size, size, row.name);
}

void checkChain(const void* structure, const char* name, const std::vector<uint32_t>& known) {
    std::vector<uint32_t> seen;
    const auto* mark = static_cast<const AgaaStructHeader*>(structure);
    uint32_t length = 0, markAt = 0;
    for (const auto* link = next(mark); link; link = next(link)) {
        // A cyclic chain reaches the mark again. The mark moves each time the length has doubled (Brent 1980).
        if (link == mark)
            fail(AGAA_ERROR_UNKNOWN_STRUCT, format("the chain of %s does not end.", name));
        if (++length >= 2 * markAt + 1) {
            mark = link;
            markAt = length;
        }
        if (std::find(known.begin(), known.end(), link->sType) != known.end()) {
            if (std::find(seen.begin(), seen.end(), link->sType) != seen.end())
                fail(AGAA_ERROR_UNKNOWN_STRUCT,
                     format("the chain of %s holds two structs of type %u.", name, link->sType));
            seen.push_back(link->sType);
        } else if (!(link->sType & AGAA_STRUCTURE_TYPE_OPTIONAL_BIT))
            fail(AGAA_ERROR_UNKNOWN_STRUCT,
                 format("the chain of %s holds a struct of type %u, which is not known here.", name, link->sType));
    }
}

const void* findChained(const void* structure, uint32_t sType) {
    for (const auto* link = next(static_cast<const AgaaStructHeader*>(structure)); link; link = next(link))
        if (link->sType == sType)
            return link;
    return nullptr;
}

void copyKnown(const void* structure, void* value, size_t size) {
    const uint32_t hosts = static_cast<const AgaaStructHeader*>(structure)->structSize;
    std::memcpy(value, structure, std::min<size_t>(hosts, size));
}

void writeKnown(void* structure, const void* value, size_t size) {
    constexpr size_t header = sizeof(AgaaStructHeader);
    const uint32_t hosts = static_cast<const AgaaStructHeader*>(structure)->structSize;
    std::memcpy(static_cast<char*>(structure) + header, static_cast<const char*>(value) + header,
                std::min<size_t>(hosts, size) - header);
}

void* nativePart(void* structure, const StructRow& row) {
    void* native = const_cast<void*>(findChained(structure, row.sType));
    if (native)
        checkStructSize(native, row);
    return native;
}

void checkElements(const void* first, uint32_t bytes, uint32_t count, size_t size, size_t firstSize, const char* name) {
    if (count == 0)
        return;
    if (bytes < firstSize || bytes > largest || bytes % 4 != 0)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is %u; this library's struct has %zu bytes, that of version 0.2 %zu.",
                                             name, bytes, size, firstSize));
    for (uint32_t i = 0; i < count; ++i)
        checkTail(static_cast<const char*>(first) + size_t(i) * bytes, size, bytes, name);
}

void initialise(void* structure, size_t structSize, const void* initial, size_t size) {
    if (!structure)
        return;
    std::memset(structure, 0, structSize);
    std::memcpy(structure, initial, std::min(structSize, size));
}

} // namespace agaa
