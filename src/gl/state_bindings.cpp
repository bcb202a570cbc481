// Bindings of objects. An object that was deleted since it was read is restored as 0: binding its name would raise an
// error or create a new object.
#include "gl/query_buffer.h"
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

using Gl = GladGLContext;

template <auto Bind, auto IsObject, GLenum... Target>
void bindObject(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    (context.gl().*Bind)(Target..., existingName<IsObject>(context, value.name()));
}
template <GLenum Target> constexpr StateWrite bindBuffer = bindObject<&Gl::BindBuffer, &Gl::IsBuffer, Target>;
template <GLenum Target>
constexpr StateWrite bindFramebuffer = bindObject<&Gl::BindFramebuffer, &Gl::IsFramebuffer, Target>;

// For a buffer that is bound without a range, OpenGL returns start 0 and size 0.
template <GLenum Target>
void bindBufferRange(const StateContext& context, const StateRow&, uint32_t element, const StateValue& value) {
    const GLuint buffer = existingName<&Gl::IsBuffer>(context, value.name());
    const auto start = component<GLintptr>(value, 1);
    const auto size = component<GLsizeiptr>(value, 2);
    if (buffer == 0 || size == 0)
        context.gl().BindBufferBase(Target, element, buffer);
    else
        context.gl().BindBufferRange(Target, element, buffer, start, size);
}

// The binding belongs to the vertex array, which can keep a buffer whose name was deleted. Core contexts without a
// vertex array have no such binding.
void bindElementBuffer(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    GLint bound = 0;
    context.gl().GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
    if (static_cast<GLuint>(bound) != value.name())
        context.gl().BindBuffer(GL_ELEMENT_ARRAY_BUFFER, existingName<&Gl::IsBuffer>(context, value.name()));
}

void readUnit(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    reading.gl().ActiveTexture(GL_TEXTURE0 + element);
    GLint name = 0;
    reading.gl().GetIntegerv(row.parameters[0], &name);
    out.setInteger(0, name);
}

template <GLenum Target>
void bindTexture(const StateContext& context, const StateRow& row, uint32_t element, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    gl.ActiveTexture(GL_TEXTURE0 + element);
    const GLuint texture = existingName<&Gl::IsTexture>(context, value.name());
    GLint bound = 0;
    if (texture != 0) {
        // The host may have reused the name for a texture of another target, for which glBindTexture would fail.
        // glBindTextureUnit binds that texture to its own target instead, and the query shows it.
        gl.BindTextureUnit(element, texture);
        gl.GetIntegerv(row.parameters[0], &bound);
    }
    if (static_cast<GLuint>(bound) != texture || texture == 0)
        gl.BindTexture(Target, 0);
}

void bindSampler(const StateContext& context, const StateRow&, uint32_t element, const StateValue& value) {
    context.gl().BindSampler(element, existingName<&Gl::IsSampler>(context, value.name()));
}

void bindImage(const StateContext& context, const StateRow&, uint32_t element, const StateValue& value) {
    context.gl().BindImageTexture(element, existingName<&Gl::IsTexture>(context, value.name()),
                                  component<GLint>(value, 1), component<GLboolean>(value, 2),
                                  component<GLint>(value, 3), component<GLenum>(value, 4), component<GLenum>(value, 5));
}

// Mesa ignores glBindProgramPipeline(0) while a program is in use. Its glUseProgram(0) fails if the pipeline behind the
// program was deleted. Binding an empty pipeline first avoids both. The next row restores the program in use.
void bindPipeline(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    const GLuint pipeline = existingName<&Gl::IsProgramPipeline>(context, value.name());
    GLint bound = 0;
    gl.GetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &bound);
    if (static_cast<GLuint>(bound) == pipeline)
        return;
    gl.BindProgramPipeline(context.emptyPipeline());
    gl.UseProgram(0);
    gl.BindProgramPipeline(pipeline);
}

// A program whose latest link failed can remain in use, but glUseProgram refuses it.
void useProgram(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    const GLuint program = existingName<&Gl::IsProgram>(context, value.name());
    GLint linked = GL_FALSE;
    if (program != 0)
        context.gl().GetProgramiv(program, GL_LINK_STATUS, &linked);
    context.gl().UseProgram(linked == GL_TRUE ? program : 0);
}

void readDrawFramebuffer(const StateReading& reading, const StateRow&, uint32_t, StateValue& out) {
    out.setInteger(0, reading.drawFramebuffer());
}

void readActiveTexture(const StateReading& reading, const StateRow&, uint32_t, StateValue& out) {
    out.setInteger(0, reading.activeTexture());
}

template <GLenum Target>
constexpr StateRow buffer(GLenum parameter, const char* name, const char* description, StateNeed need = {}) {
    return {name, description, {parameter}, "o", readValues, bindBuffer<Target>, StateArray::Once, StateProfile::Any,
            need};
}

template <GLenum Target> constexpr StateRow texture(GLenum parameter, const char* name, const char* description) {
    return {name, description, {parameter}, "o", readUnit, bindTexture<Target>, StateArray::TextureUnits};
}

constexpr StateNeed kQueryBuffers{"4.4 or GL_ARB_query_buffer_object", hasQueryBuffer};

// clang-format off
constexpr StateRow kRows[] = {
    {"GL_PROGRAM_PIPELINE_BINDING", "program pipeline", {GL_PROGRAM_PIPELINE_BINDING}, "o",
     readValues, bindPipeline},
    {"GL_CURRENT_PROGRAM", "program in use", {GL_CURRENT_PROGRAM}, "o", readValues, useProgram},
    {"GL_DRAW_FRAMEBUFFER_BINDING", "framebuffer drawn to", {GL_DRAW_FRAMEBUFFER_BINDING}, "o",
     readDrawFramebuffer, bindFramebuffer<GL_DRAW_FRAMEBUFFER>},
    {"GL_READ_FRAMEBUFFER_BINDING", "framebuffer read from", {GL_READ_FRAMEBUFFER_BINDING}, "o",
     readValues, bindFramebuffer<GL_READ_FRAMEBUFFER>},
    {"GL_RENDERBUFFER_BINDING", "renderbuffer", {GL_RENDERBUFFER_BINDING}, "o", readValues,
     bindObject<&Gl::BindRenderbuffer, &Gl::IsRenderbuffer, GL_RENDERBUFFER>},

    // Binding to an index also binds to the target, so that the rows of targets follow.
    {"GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE",
     "uniform buffers by index",
     {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE}, "oll",
     readValues, bindBufferRange<GL_UNIFORM_BUFFER>, StateArray::UniformBindings},
    {"GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, "
     "GL_SHADER_STORAGE_BUFFER_SIZE",
     "shader storage buffers by index",
     {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
      GL_SHADER_STORAGE_BUFFER_SIZE},
     "oll", readValues, bindBufferRange<GL_SHADER_STORAGE_BUFFER>, StateArray::StorageBindings},
    buffer<GL_UNIFORM_BUFFER>(GL_UNIFORM_BUFFER_BINDING, "GL_UNIFORM_BUFFER_BINDING",
                              "uniform buffer"),
    buffer<GL_SHADER_STORAGE_BUFFER>(GL_SHADER_STORAGE_BUFFER_BINDING,
                                     "GL_SHADER_STORAGE_BUFFER_BINDING", "shader storage buffer"),
    buffer<GL_ATOMIC_COUNTER_BUFFER>(GL_ATOMIC_COUNTER_BUFFER_BINDING,
                                     "GL_ATOMIC_COUNTER_BUFFER_BINDING", "atomic counter buffer"),
    buffer<GL_ARRAY_BUFFER>(GL_ARRAY_BUFFER_BINDING, "GL_ARRAY_BUFFER_BINDING",
                            "buffer of vertex attributes"),
    buffer<GL_COPY_READ_BUFFER>(GL_COPY_READ_BUFFER_BINDING, "GL_COPY_READ_BUFFER_BINDING",
                                "source of buffer copies"),
    buffer<GL_COPY_WRITE_BUFFER>(GL_COPY_WRITE_BUFFER_BINDING, "GL_COPY_WRITE_BUFFER_BINDING",
                                 "target of buffer copies"),
    buffer<GL_PIXEL_PACK_BUFFER>(GL_PIXEL_PACK_BUFFER_BINDING, "GL_PIXEL_PACK_BUFFER_BINDING",
                                 "buffer that receives pixels"),
    buffer<GL_PIXEL_UNPACK_BUFFER>(GL_PIXEL_UNPACK_BUFFER_BINDING, "GL_PIXEL_UNPACK_BUFFER_BINDING",
                                   "buffer that pixels come from"),
    buffer<GL_DRAW_INDIRECT_BUFFER>(GL_DRAW_INDIRECT_BUFFER_BINDING,
                                    "GL_DRAW_INDIRECT_BUFFER_BINDING", "arguments of draws"),
    buffer<GL_DISPATCH_INDIRECT_BUFFER>(GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                                        "GL_DISPATCH_INDIRECT_BUFFER_BINDING",
                                        "arguments of dispatches"),
    buffer<GL_TEXTURE_BUFFER>(GL_TEXTURE_BUFFER_BINDING, "GL_TEXTURE_BUFFER_BINDING",
                              "buffer of buffer textures"),
    buffer<GL_QUERY_BUFFER>(GL_QUERY_BUFFER_BINDING, "GL_QUERY_BUFFER_BINDING",
                            "buffer of query results", kQueryBuffers),
    {"GL_VERTEX_ARRAY_BINDING", "vertex array", {GL_VERTEX_ARRAY_BINDING}, "o", readValues,
     bindObject<&Gl::BindVertexArray, &Gl::IsVertexArray>},
    {"GL_ELEMENT_ARRAY_BUFFER_BINDING", "index buffer of the vertex array bound",
     {GL_ELEMENT_ARRAY_BUFFER_BINDING}, "o", readValues, bindElementBuffer},

    texture<GL_TEXTURE_2D>(GL_TEXTURE_BINDING_2D, "GL_TEXTURE_BINDING_2D", "2D texture"),
    texture<GL_TEXTURE_2D_MULTISAMPLE>(GL_TEXTURE_BINDING_2D_MULTISAMPLE,
                                       "GL_TEXTURE_BINDING_2D_MULTISAMPLE",
                                       "multisampled 2D texture"),
    texture<GL_TEXTURE_2D_ARRAY>(GL_TEXTURE_BINDING_2D_ARRAY, "GL_TEXTURE_BINDING_2D_ARRAY",
                                 "2D array texture"),
    texture<GL_TEXTURE_BUFFER>(GL_TEXTURE_BINDING_BUFFER, "GL_TEXTURE_BINDING_BUFFER",
                               "buffer texture"),
    {"GL_SAMPLER_BINDING", "sampler object", {GL_SAMPLER_BINDING}, "o", readUnit, bindSampler,
     StateArray::TextureUnits},
    {"GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED, "
     "GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT",
     "image",
     {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED,
      GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT},
     "oibiee", readValues, bindImage, StateArray::ImageUnits},
    // Reading and writing texture bindings changes the active unit, so that this row follows them.
    {"GL_ACTIVE_TEXTURE", "active texture unit", {GL_ACTIVE_TEXTURE}, "e", readActiveTexture,
     set<&Gl::ActiveTexture>},

    {"GL_CLIENT_ACTIVE_TEXTURE", "texture unit of vertex arrays", {GL_CLIENT_ACTIVE_TEXTURE}, "e",
     readValues, set<&Gl::ClientActiveTexture>, StateArray::Once, StateProfile::Compatibility},
    {"GL_MATRIX_MODE", "matrix mode", {GL_MATRIX_MODE}, "e", readValues,
     set<&Gl::MatrixMode>, StateArray::Once, StateProfile::Compatibility},
};
// clang-format on

} // namespace

std::span<const StateRow> bindingRows() { return kRows; }

} // namespace agaa::gl
