// Objects bound to the context. Those deleted since they were read are restored as 0: a name that
// no longer exists would raise an error, or make an object that the host never asked for.
#include "gl/query_buffer.h"
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

using Gl = GladGLContext;

template <auto Bind, auto IsObject, GLenum... Target>
void bindObject(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    (context.gl().*Bind)(Target..., living<IsObject>(context, value.name()));
}
template <GLenum Target>
constexpr StateWrite bindBuffer = bindObject<&Gl::BindBuffer, &Gl::IsBuffer, Target>;
template <GLenum Target>
constexpr StateWrite bindFramebuffer = bindObject<&Gl::BindFramebuffer, &Gl::IsFramebuffer, Target>;

// A buffer bound without a range is read as start 0, size 0.
template <GLenum Target>
void bindBufferRange(const StateContext& context, const StateRow&, uint32_t element,
                     const StateValue& value) {
    const GLuint buffer = living<&Gl::IsBuffer>(context, value.name());
    const auto start = component<GLintptr>(value, 1);
    const auto size = component<GLsizeiptr>(value, 2);
    if (buffer == 0 || size == 0)
        context.gl().BindBufferBase(Target, element, buffer);
    else
        context.gl().BindBufferRange(Target, element, buffer, start, size);
}

// The binding is the vertex array's, which may hold a buffer whose name is gone. Core contexts
// without a vertex array have none.
void bindElementBuffer(const StateContext& context, const StateRow&, uint32_t,
                       const StateValue& value) {
    GLint bound = 0;
    context.gl().GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
    if (static_cast<GLuint>(bound) != value.name())
        context.gl().BindBuffer(GL_ELEMENT_ARRAY_BUFFER,
                                living<&Gl::IsBuffer>(context, value.name()));
}

void readUnit(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    reading.gl().ActiveTexture(GL_TEXTURE0 + element);
    GLint name = 0;
    reading.gl().GetIntegerv(row.parameters[0], &name);
    out.setInteger(0, name);
}

template <GLenum Target>
void bindTexture(const StateContext& context, const StateRow& row, uint32_t element,
                 const StateValue& value) {
    const GladGLContext& gl = context.gl();
    gl.ActiveTexture(GL_TEXTURE0 + element);
    const GLuint texture = living<&Gl::IsTexture>(context, value.name());
    GLint bound = 0;
    if (texture != 0) {
        // Cannot fail, as glBindTexture does where the host has given the name to a texture of
        // another target: then that is what it binds, and the query shows it.
        gl.BindTextureUnit(element, texture);
        gl.GetIntegerv(row.parameters[0], &bound);
    }
    if (static_cast<GLuint>(bound) != texture || texture == 0)
        gl.BindTexture(Target, 0);
}

void bindSampler(const StateContext& context, const StateRow&, uint32_t element,
                 const StateValue& value) {
    context.gl().BindSampler(element, living<&Gl::IsSampler>(context, value.name()));
}

void bindImage(const StateContext& context, const StateRow&, uint32_t element,
               const StateValue& value) {
    context.gl().BindImageTexture(element, living<&Gl::IsTexture>(context, value.name()),
                                  component<GLint>(value, 1), component<GLboolean>(value, 2),
                                  component<GLint>(value, 3), component<GLenum>(value, 4),
                                  component<GLenum>(value, 5));
}

// Mesa ignores glBindProgramPipeline(0) while a program is in use, and glUseProgram(0) fails there
// if the pipeline behind the program has been deleted: so another pipeline comes between. The
// program in use is the next row's.
void bindPipeline(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    const GLuint pipeline = living<&Gl::IsProgramPipeline>(context, value.name());
    GLint bound = 0;
    gl.GetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &bound);
    if (static_cast<GLuint>(bound) == pipeline)
        return;
    gl.BindProgramPipeline(context.emptyPipeline());
    gl.UseProgram(0);
    gl.BindProgramPipeline(pipeline);
}

// A program that the host has linked anew without success can be in use, but not be used again.
void useProgram(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    const GLuint program = living<&Gl::IsProgram>(context, value.name());
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
constexpr StateRow buffer(GLenum parameter, const char* name, const char* description,
                          StateNeed need = {}) {
    return {name,       description,        {parameter},      "o",
            readValues, bindBuffer<Target>, StateArray::Once, StateProfile::Any,
            need};
}

template <GLenum Target>
constexpr StateRow texture(GLenum parameter, const char* name, const char* description) {
    return {name,
            description,
            {parameter},
            "o",
            readUnit,
            bindTexture<Target>,
            StateArray::TextureUnits};
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

    // Binding to an index also binds to the target.
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
                                 "buffer that pixels are read to"),
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
    // Setting textures and reading them changes the active unit.
    {"GL_ACTIVE_TEXTURE", "active texture unit", {GL_ACTIVE_TEXTURE}, "e", readActiveTexture,
     set<&Gl::ActiveTexture>},

    {"GL_CLIENT_ACTIVE_TEXTURE", "texture unit of vertex arrays", {GL_CLIENT_ACTIVE_TEXTURE}, "e",
     readValues, set<&Gl::ClientActiveTexture>, StateArray::Once, StateProfile::Compatibility},
    {"GL_MATRIX_MODE", "which matrix is changed", {GL_MATRIX_MODE}, "e", readValues,
     set<&Gl::MatrixMode>, StateArray::Once, StateProfile::Compatibility},
};
// clang-format on

} // namespace

std::span<const StateRow> bindingRows() {
    return kRows;
}

} // namespace agaa::gl
