// Binding points of the SDK's compute passes: plans number them in one space, OpenGL has one a kind. The
// numbers are those of src/shaders/passes/bindings.glsl.
#pragma once

#include "core/plan_builder.h"

namespace agaa::gl {

constexpr uint32_t uniformBinding = 0; // frame constants
constexpr uint32_t storageBindingCount = 4;
constexpr uint32_t imageUnitCount = 2;
constexpr uint32_t firstTextureUnit = slot::Depth; // textures keep the plan's numbers
constexpr uint32_t lastTextureUnit = slot::Below;

constexpr uint32_t storageBinding(uint32_t planSlot) {
    switch (planSlot) {
    case slot::Lights:
        return 0;
    case slot::Counters:
        return 1;
    case slot::Deferred:
        return 3;
    default:
        return 2;
    }
}
constexpr uint32_t imageUnit(uint32_t planSlot) { return planSlot == slot::MetadataOut ? 0u : 1u; }

} // namespace agaa::gl
