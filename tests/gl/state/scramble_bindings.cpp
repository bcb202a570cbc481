// Scramblers of bindings.
#include "scramblers.h"

namespace agaa::test {
namespace {

template <GLenum Target> void bindBuffer(Scrambling& s) {
    s.gl.BindBuffer(Target, s.values.nameOrNone(s.objects.buffers));
}

// Whole buffers, ranges with an offset and ranges up to the end.
template <GLenum Target> void bindBufferAt(Scrambling& s) {
    const GLuint buffer = s.values.nameOrNone(s.objects.buffers);
    const GLintptr start = s.values.oneOf<GLintptr>({0, 256, 4096});
    const GLsizeiptr size = s.values.oneOf<GLsizeiptr>({64, HostObjects::kBufferBytes - start});
    if (buffer == 0 || s.values.below(3) == 0)
        s.gl.BindBufferBase(Target, s.element, buffer);
    else
        s.gl.BindBufferRange(Target, s.element, buffer, start, size);
}

template <GLenum Target, HostObjects::Names HostObjects::*Textures> void bindTexture(Scrambling& s) {
    GLint active = 0;
    s.gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    s.gl.ActiveTexture(GL_TEXTURE0 + s.element);
    s.gl.BindTexture(Target, s.values.nameOrNone(s.objects.*Textures));
    s.gl.ActiveTexture(static_cast<GLenum>(active));
}

void bindImage(Scrambling& s) {
    const GLint level = s.values.oneOf<GLint>({0, 1, HostObjects::kLevels - 1});
    const GLint layer = s.values.oneOf<GLint>({0, 1, HostObjects::kLayers - 1});
    const GLenum access = s.values.oneOf<GLenum>({GL_WRITE_ONLY, GL_READ_WRITE});
    const GLenum format = s.values.oneOf<GLenum>({GL_RGBA8, GL_R32UI, GL_RGBA8UI});
    switch (s.values.below(4)) {
    case 0:
        s.gl.BindImageTexture(s.element, s.values.name(s.objects.textures), level, GL_FALSE, 0, access, format);
        break;
    case 1:
        s.gl.BindImageTexture(s.element, s.values.name(s.objects.arrays), level, GL_FALSE, layer, access, format);
        break;
    case 2:
        s.gl.BindImageTexture(s.element, s.values.name(s.objects.arrays), level, GL_TRUE, 0, access, format);
        break;
    default:
        s.gl.BindImageTexture(s.element, s.values.name(s.objects.bufferTextures), 0, GL_FALSE, 0, access, format);
        break;
    }
}

void bindElementBuffer(Scrambling& s) {
    GLint vertexArray = 0;
    s.gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray);
    if (vertexArray != 0 || s.compatibilityProfile)
        s.gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.values.nameOrNone(s.objects.buffers));
}

// Mesa binds none only while no program is in use.
void bindPipeline(Scrambling& s) {
    GLint program = 0;
    s.gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
    s.gl.UseProgram(0);
    s.gl.BindProgramPipeline(s.values.nameOrNone(s.objects.pipelines));
    s.gl.UseProgram(static_cast<GLuint>(program));
}

const Scrambler kBindings[] = {
    {"GL_PROGRAM_PIPELINE_BINDING", bindPipeline},
    {"GL_CURRENT_PROGRAM", [](Scrambling& s) { s.gl.UseProgram(s.values.nameOrNone(s.objects.programs)); }},
    {"GL_DRAW_FRAMEBUFFER_BINDING",
     [](Scrambling& s) { s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.values.nameOrNone(s.objects.framebuffers)); }},
    {"GL_READ_FRAMEBUFFER_BINDING",
     [](Scrambling& s) { s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.values.nameOrNone(s.objects.framebuffers)); }},
    {"GL_RENDERBUFFER_BINDING",
     [](Scrambling& s) { s.gl.BindRenderbuffer(GL_RENDERBUFFER, s.values.nameOrNone(s.objects.renderbuffers)); }},
    {"GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE", bindBufferAt<GL_UNIFORM_BUFFER>},
    {"GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, "
     "GL_SHADER_STORAGE_BUFFER_SIZE",
     bindBufferAt<GL_SHADER_STORAGE_BUFFER>},
    {"GL_UNIFORM_BUFFER_BINDING", bindBuffer<GL_UNIFORM_BUFFER>},
    {"GL_SHADER_STORAGE_BUFFER_BINDING", bindBuffer<GL_SHADER_STORAGE_BUFFER>},
    {"GL_ATOMIC_COUNTER_BUFFER_BINDING", bindBuffer<GL_ATOMIC_COUNTER_BUFFER>},
    {"GL_ARRAY_BUFFER_BINDING", bindBuffer<GL_ARRAY_BUFFER>},
    {"GL_COPY_READ_BUFFER_BINDING", bindBuffer<GL_COPY_READ_BUFFER>},
    {"GL_COPY_WRITE_BUFFER_BINDING", bindBuffer<GL_COPY_WRITE_BUFFER>},
    {"GL_PIXEL_PACK_BUFFER_BINDING", bindBuffer<GL_PIXEL_PACK_BUFFER>},
    {"GL_PIXEL_UNPACK_BUFFER_BINDING", bindBuffer<GL_PIXEL_UNPACK_BUFFER>},
    {"GL_DRAW_INDIRECT_BUFFER_BINDING", bindBuffer<GL_DRAW_INDIRECT_BUFFER>},
    {"GL_DISPATCH_INDIRECT_BUFFER_BINDING", bindBuffer<GL_DISPATCH_INDIRECT_BUFFER>},
    {"GL_TEXTURE_BUFFER_BINDING", bindBuffer<GL_TEXTURE_BUFFER>},
    {"GL_QUERY_BUFFER_BINDING", bindBuffer<GL_QUERY_BUFFER>},
    {"GL_VERTEX_ARRAY_BINDING",
     [](Scrambling& s) { s.gl.BindVertexArray(s.values.nameOrNone(s.objects.vertexArrays)); }},
    {"GL_ELEMENT_ARRAY_BUFFER_BINDING", bindElementBuffer},
    {"GL_TEXTURE_BINDING_2D", bindTexture<GL_TEXTURE_2D, &HostObjects::textures>},
    {"GL_TEXTURE_BINDING_2D_MULTISAMPLE", bindTexture<GL_TEXTURE_2D_MULTISAMPLE, &HostObjects::multisampled>},
    {"GL_TEXTURE_BINDING_2D_ARRAY", bindTexture<GL_TEXTURE_2D_ARRAY, &HostObjects::arrays>},
    {"GL_TEXTURE_BINDING_BUFFER", bindTexture<GL_TEXTURE_BUFFER, &HostObjects::bufferTextures>},
    {"GL_SAMPLER_BINDING", [](Scrambling& s) { s.gl.BindSampler(s.element, s.values.nameOrNone(s.objects.samplers)); }},
    {"GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED, "
     "GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT",
     bindImage},
    {"GL_ACTIVE_TEXTURE",
     [](Scrambling& s) {
         s.gl.ActiveTexture(GL_TEXTURE0 + s.values.oneOf<GLenum>({1, 5, 20}));
     }},
    {"GL_CLIENT_ACTIVE_TEXTURE",
     [](Scrambling& s) {
         s.gl.ClientActiveTexture(GL_TEXTURE0 + s.values.oneOf<GLenum>({1, 2, 3}));
     }},
};

} // namespace

std::span<const Scrambler> bindingScramblers() { return kBindings; }

} // namespace agaa::test
