// Bindings of resources, from src/shaders/tables/bindings.inc.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace agaa {

// Bindings of the SDK's compute passes.
namespace slot {
enum : uint32_t {
#define AGAA_BINDING(macro, name, slot, kind, openGl) name = slot,
#define AGAA_ALIAS(macro, name, ofMacro, of) name = of,
#include "shaders/tables/bindings.inc"
};
} // namespace slot
// Bindings of the set that hosts bind.
namespace host_slot {
enum : uint32_t {
#define AGAA_HOST_BINDING(macro, name, slot, kind, openGl) name = slot,
#define AGAA_HOST_ALIAS(macro, name, ofMacro, of) name = of,
#include "shaders/tables/bindings.inc"
};
} // namespace host_slot

enum class BindingKind { Uniform, Texture, Image, Storage, WrittenStorage };

struct BindingRow {
    const char* macro; // after AGAA_BINDING_
    uint32_t slot;     // in plans and on Vulkan
    BindingKind kind;
    uint32_t openGl; // binding point among those of the kind
};

inline constexpr BindingRow bindingTable[] = {
// The index is the slot.
#define AGAA_BINDING(macro, name, slot, kind, openGl) {#macro, slot, BindingKind::kind, openGl},
#include "shaders/tables/bindings.inc"
};
inline constexpr BindingRow hostBindingTable[] = {
// The index is the slot.
#define AGAA_HOST_BINDING(macro, name, slot, kind, openGl) {#macro, slot, BindingKind::kind, openGl},
#include "shaders/tables/bindings.inc"
};
inline constexpr uint32_t hostBindingCount = uint32_t(std::size(hostBindingTable));

template <size_t count> constexpr bool isInOrder(const BindingRow (&table)[count]) {
    return std::ranges::all_of(table, [&](const BindingRow& row) { return &row == &table[row.slot]; });
}
static_assert(isInOrder(bindingTable) && isInOrder(hostBindingTable), "slots count from 0, each once");
// The slot of Vulkan's array of input attachments, after all others.
inline constexpr uint32_t fetchedTargetsSlot = hostBindingCount;

} // namespace agaa
