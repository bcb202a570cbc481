// Binding points of OpenGL. Plans number all bindings in one space; OpenGL has one space for each kind.
#pragma once

#include "agaa_gl.h"
#include "core/glsl/host_glsl.h"
#include "core/plan/bindings.h"
#include "gl/state_context.h"

#include <optional>

namespace agaa::gl {

// The public names of the bindings that hosts set have the numbers of the slots.
static_assert(hostBindingCount == AGAA_GL_BINDING_COUNT);
#define AGAA_HOST_BINDING(macro, name, slot, kind, openGl) static_assert(AGAA_GL_BINDING_##macro == slot);
#include "shaders/tables/bindings.inc"

constexpr uint32_t bindingPointOf(uint32_t slot) { return bindingTable[slot].openGl; }

// Returns how the host's shaders access a binding, or nullopt if they do not. Storage buffers become images or uniform
// buffers with AGAA_GL_STORAGE_IMAGES; the frame constants become a texture with AGAA_GL_CONSTANTS_TEXELS.
std::optional<BindingKind> hostKind(const BindingRow& row, const HostDialect& dialect);

// Binding points of the SDK's resources during draw callbacks and in compute passes.
StateScope hostBindings(const HostDialect& dialect);
StateScope passBindings();

} // namespace agaa::gl
