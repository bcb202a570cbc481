// Versioned structs. Hosts may have been compiled against another version of the headers.
#pragma once

#include "agaa_sdk.h"
#include "core/base/error.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

namespace agaa {

struct StructRow {
    uint32_t sType;
    const char* name;
    size_t size;      // in this version
    size_t firstSize; // in version 0.2; no host has a smaller struct
};

// The row, and the value of AGAA_…_INIT. gl/structs.h and vk/structs.h have the rows of the graphics APIs.
template <class T> struct StructOf;
#define AGAA_STRUCT_ROW(Name, TYPE, bytes)                                                                             \
    template <> struct StructOf<Agaa##Name> {                                                                          \
        static constexpr StructRow row = {AGAA_STRUCTURE_TYPE_##TYPE, "Agaa" #Name, sizeof(Agaa##Name), bytes};        \
        static Agaa##Name initial() {                                                                                  \
            const Agaa##Name value = AGAA_##TYPE##_INIT;                                                               \
            return value;                                                                                              \
        }                                                                                                              \
        static_assert(sizeof(Agaa##Name) >= bytes, "structs grow at their end");                                       \
    };
#define AGAA_STRUCT AGAA_STRUCT_ROW
#include "core/base/structs.inc"

// They throw Error if a host's struct is null, of another type, too small, or has data after the members of the row.
void checkStruct(const void* structure, const StructRow& row);
void checkStructSize(const void* structure, const StructRow& row);
// Throws Error if the chain holds a type that is not in `known`, or a type twice, or does not end.
void checkChain(const void* structure, const char* name, const std::vector<uint32_t>& known = {});
// Returns the struct of this type in a chain, or null.
const void* findChained(const void* structure, uint32_t sType);

// Returns the chained output struct of a row, or null. Throws Error if its size is not valid.
void* nativePart(void* structure, const StructRow& row);

// Copy the members that both the host's checked struct and the library's struct of `size` bytes have. Reading
// overwrites defaults; writing skips the header.
void copyKnown(const void* structure, void* value, size_t size);
void writeKnown(void* structure, const void* value, size_t size);

// Members that the host's struct lacks have their defaults. known: see checkChain().
template <class T> T readStruct(const T* structure, const std::vector<uint32_t>& known = {}) {
    checkStruct(structure, StructOf<T>::row);
    checkChain(structure, StructOf<T>::row.name, known);
    T value = StructOf<T>::initial();
    copyKnown(structure, &value, sizeof value);
    return value;
}

// Returns the struct of type T in a chain that checkChain() has accepted.
template <class T> std::optional<T> readChained(const void* structure) {
    const auto* chained = static_cast<const T*>(findChained(structure, StructOf<T>::row.sType));
    if (!chained)
        return std::nullopt;
    checkStructSize(chained, StructOf<T>::row);
    T value = StructOf<T>::initial();
    copyKnown(chained, &value, sizeof value);
    return value;
}

// Checks an output struct before the call does its work, so that a failed call writes nothing.
template <class T> void checkOutput(const T* structure, const std::vector<uint32_t>& known = {}) {
    checkStruct(structure, StructOf<T>::row);
    checkChain(structure, StructOf<T>::row.name, known);
}
// Writes all members after the header that the host's struct has room for.
template <class T> void writeStruct(T* structure, const T& value) { writeKnown(structure, &value, sizeof value); }

// Returns element i of a host's array. All elements have the size of the first.
template <class T> T* elementOf(T* first, uint32_t i) {
    using Byte = std::conditional_t<std::is_const_v<T>, const char, char>;
    return reinterpret_cast<T*>(reinterpret_cast<Byte*>(first) + size_t(i) * first->structSize);
}
template <class T> void requireEqualSizes(const T* element, const T* first) {
    if (element->structSize != first->structSize)
        fail(AGAA_ERROR_STRUCT,
             format("elements of an array of %s have different structSizes.", StructOf<T>::row.name));
}
// Checks an array of `count` elements for output.
template <class T> void checkOutputs(T* first, uint32_t count, const std::vector<uint32_t>& known = {}) {
    for (uint32_t i = 0; i < count; ++i) {
        const T* element = elementOf(first, i);
        checkOutput(element, known);
        requireEqualSizes(element, first);
    }
}

// Writes structs by the two-call convention.
template <class T> AgaaResult writeStructs(const std::vector<T>& source, uint32_t* count, T* first) {
    require(count, AGAA_ERROR_INVALID_ARGUMENT, "the count pointer is null.");
    const auto available = uint32_t(source.size());
    if (first) {
        if (*count < available)
            fail(AGAA_ERROR_BUFFER_TOO_SMALL,
                 format("the array holds %u elements where %u are needed.", *count, available));
        checkOutputs(first, available);
        for (uint32_t i = 0; i < available; ++i)
            writeStruct(elementOf(first, i), source[i]);
    }
    *count = available;
    return AGAA_OK;
}

// Returns element i of an array without headers. Elements are `bytes` apart. Members that they lack are those of
// `value`.
template <class T> T readElement(const T* first, uint32_t bytes, uint32_t i, T value) {
    const char* element = reinterpret_cast<const char*>(first) + size_t(i) * bytes;
    if (bytes >= sizeof value) // the usual case; a constant size compiles to few instructions
        std::memcpy(&value, element, sizeof value);
    else
        std::memcpy(&value, element, bytes);
    return value;
}
// Checks an array without headers. The host's member `name` holds `bytes`, the stride of its elements. firstSize: see
// StructRow.
void checkElements(const void* first, uint32_t bytes, uint32_t count, size_t size, size_t firstSize, const char* name);

// Writes the value of AGAA_…_INIT into the first structSize bytes.
void initialise(void* structure, size_t structSize, const void* initial, size_t size);

} // namespace agaa
