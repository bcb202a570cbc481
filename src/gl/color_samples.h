// Framebuffers whose colour attachments have fewer samples than the depth (GL_NV_framebuffer_mixed_samples). OpenGL
// leaves to the driver which samples of a fragment's coverage belong to which colour sample.
#pragma once

#include <glad/gl.h>

#include <array>
#include <cstdint>

namespace agaa::gl {

// Returns, for each of colorSamples colour samples, the mask of the coverage samples that belong to it; masks beyond
// them are 0. It draws one triangle, so that the caller saves and restores the host's state. Throws Error.
// samples        Of depth and coverage, [2, 32].
// colorSamples   1, 2 or 4; at most `samples`.
std::array<uint32_t, 4> probeColorSamples(const GladGLContext& gl, uint32_t samples, uint32_t colorSamples);

} // namespace agaa::gl
