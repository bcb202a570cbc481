#include "gl/gpu_motion.h"

#include "render/host_material.h"

#include <stdexcept>

namespace harness::gl {

constexpr GLuint unit = 30; // MOTION_AT of shaders/interface.glsl
constexpr size_t rowsPerDraw = std::tuple_size_v<MotionRows>;

GpuMotion::GpuMotion(const GladGLContext& gl)
    : gl_(&gl), rows_(createBuffer(gl)), texels_(createTexture(gl, GL_TEXTURE_BUFFER)) {
    gl.TextureBuffer(texels_.get(), GL_RGBA32F, rows_.get());
}

void GpuMotion::update(const std::vector<Draw>& draws) {
    hasRows_ = !draws.empty() && draws.front().motionOutput != MotionOutput::None;
    if (!hasRows_)
        return;
    const std::vector<MotionRows> rows = motionRows(draws);
    GLint most = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (rows.size() * rowsPerDraw > size_t(most))
        throw std::runtime_error("The scene has more draws than the device's texture buffers hold.");
    gl_->NamedBufferData(rows_.get(), GLsizeiptr(rows.size() * sizeof(MotionRows)), rows.data(), GL_STREAM_DRAW);
}

void GpuMotion::bind() const {
    if (!hasRows_)
        return;
    gl_->BindTextureUnit(unit, texels_.get());
    gl_->BindSampler(unit, 0);
}

} // namespace harness::gl
