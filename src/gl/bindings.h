// Binding points of OpenGL: plans number bindings in one space, OpenGL has a space of places for each kind.
#pragma once

#include "core/plan/bindings.h"
#include "core/glsl/host_glsl.h"
#include "gl/state_context.h"

#include <optional>

namespace agaa::gl {

constexpr uint32_t placeOf(uint32_t slot) { return bindingTable[slot].openGl; }

// How the host's shaders reach a binding: storage buffers become images or uniform buffers with AGAA_GL_STORAGE_IMAGES, the
// frame's constants a texture with AGAA_GL_CONSTANTS_TEXELS. None: not at all.
std::optional<BindingKind> hostKind(const BindingRow& row, const HostDialect& dialect);

// Where draw callbacks find the SDK's resources, and where the SDK's compute passes do.
StateScope hostBindings(const HostDialect& dialect);
StateScope passBindings();

} // namespace agaa::gl
