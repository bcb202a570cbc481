#include "gl/gpu_environment.h"

#include "gl/gpu_scene.h"

namespace harness::gl {

GpuEnvironment::GpuEnvironment(const GladGLContext& gl, const Environment& environment)
    : gl_(&gl), map_(createTexture(gl, GL_TEXTURE_2D)), constants_(createBuffer(gl)) {
    const std::vector<HalfLevel>& levels = environment.levels;
    gl.TextureStorage2D(map_.get(), GLsizei(levels.size()), GL_RGBA16F, GLsizei(levels[0].width),
                        GLsizei(levels[0].height));
    for (size_t i = 0; i < levels.size(); ++i)
        gl.TextureSubImage2D(map_.get(), GLint(i), 0, 0, GLsizei(levels[i].width), GLsizei(levels[i].height), GL_RGBA,
                             GL_HALF_FLOAT, levels[i].rgba.data());
    gl.NamedBufferData(constants_.get(), sizeof environment.constants, &environment.constants, GL_STATIC_DRAW);
    // Shaders interpolate between levels themselves, because rows of levels have different places.
    sampler_ = makeSampler(gl, {Wrap::Repeat, Wrap::Clamp, {Filter::Linear, Filter::Linear, MipFilter::Nearest}});
}

void GpuEnvironment::bind() const {
    gl_->BindTextureUnit(mapUnit, map_.get());
    gl_->BindSampler(mapUnit, sampler_.get());
    gl_->BindBufferBase(GL_UNIFORM_BUFFER, constantsBinding, constants_.get());
}

} // namespace harness::gl
