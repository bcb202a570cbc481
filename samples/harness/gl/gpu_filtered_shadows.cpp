#include "gl/gpu_filtered_shadows.h"

#include "gl/gpu_scene.h"

namespace harness::gl {

GpuFilteredShadows::GpuFilteredShadows(const GladGLContext& gl) : gl_(&gl), constants_(createBuffer(gl)) {
    gl.NamedBufferData(constants_.get(), sizeof(FilteredShadowConstants), nullptr, GL_STATIC_DRAW);
    sampler_ = makeSampler(gl, {Wrap::Clamp, Wrap::Clamp, {Filter::Linear, Filter::Linear, MipFilter::Linear}});
}

void GpuFilteredShadows::update(const ShadowMaps& maps) {
    if (maps.shadows().empty() || version_ == maps.version())
        return;
    const std::vector<std::vector<MipLevel>> layers = momentLayers(depthsOf(maps), maps.size());
    moments_ = createTexture(*gl_, GL_TEXTURE_2D_ARRAY);
    gl_->TextureStorage3D(moments_.get(), GLsizei(layers[0].size()), GL_RG32F, GLsizei(maps.size()),
                          GLsizei(maps.size()), GLsizei(layers.size()));
    for (size_t layer = 0; layer < layers.size(); ++layer)
        for (size_t i = 0; i < layers[layer].size(); ++i) {
            const MipLevel& level = layers[layer][i];
            gl_->TextureSubImage3D(moments_.get(), GLint(i), 0, 0, GLint(layer), GLsizei(level.width),
                                   GLsizei(level.height), 1, GL_RG, GL_FLOAT, level.rgba.data());
        }
    const FilteredShadowConstants constants = filteredShadowConstants(maps.shadows());
    gl_->NamedBufferSubData(constants_.get(), 0, sizeof constants, &constants);
    version_ = maps.version();
}

void GpuFilteredShadows::bind() const {
    gl_->BindTextureUnit(mapUnit, moments_.get());
    gl_->BindSampler(mapUnit, sampler_.get());
    gl_->BindBufferBase(GL_UNIFORM_BUFFER, constantsBinding, constants_.get());
}

} // namespace harness::gl
