// Binding points of OpenGL. Plans number all bindings in one space; OpenGL has one space for each kind.
#pragma once

#include "core/plan/bindings.h"
#include "core/glsl/host_glsl.h"
#include "gl/state_context.h"

#include <optional>

namespace agaa::gl {

constexpr uint32_t bindingPointOf(uint32_t slot) { return bindingTable[slot].openGl; }

// Returns how the host's shaders access a binding, or nullopt if they do not. Storage buffers become images or uniform
// buffers with AGAA_GL_STORAGE_IMAGES; the frame constants become a texture with AGAA_GL_CONSTANTS_TEXELS.
std::optional<BindingKind> hostKind(const BindingRow& row, const HostDialect& dialect);

// Binding points of the SDK's resources during draw callbacks and in compute passes.
StateScope hostBindings(const HostDialect& dialect);
StateScope passBindings();

} // namespace agaa::gl
