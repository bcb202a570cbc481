#include "host_objects.h"

namespace agaa::test {
namespace {

constexpr const char* kVertexShader = "#version 430\n"
                                      "out gl_PerVertex { vec4 gl_Position; };\n"
                                      "void main() { gl_Position = vec4(0.0); }\n";

GLuint linkedProgram(const GladGLContext& gl) {
    const GLuint program = gl.CreateProgram();
    const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
    gl.ShaderSource(shader, 1, &kVertexShader, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    gl.DeleteShader(shader);
    return program;
}

} // namespace

HostObjects::HostObjects(const GladGLContext& gl) : gl_(gl) {
    constexpr GLsizei count = kCount;
    gl.CreateBuffers(count, buffers.data());
    gl.CreateTextures(GL_TEXTURE_2D, count, textures.data());
    gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, count, multisampled.data());
    gl.CreateTextures(GL_TEXTURE_2D_ARRAY, count, arrays.data());
    gl.CreateTextures(GL_TEXTURE_BUFFER, count, bufferTextures.data());
    gl.CreateSamplers(count, samplers.data());
    gl.CreateRenderbuffers(count, renderbuffers.data());
    gl.CreateFramebuffers(count, framebuffers.data());
    gl.CreateVertexArrays(count, vertexArrays.data());
    gl.CreateProgramPipelines(count, pipelines.data());
    for (size_t i = 0; i < kCount; ++i) {
        gl.NamedBufferData(buffers[i], kBufferBytes, nullptr, GL_STATIC_DRAW);
        gl.TextureStorage2D(textures[i], kLevels, GL_RGBA8, 16, 16);
        gl.TextureStorage2DMultisample(multisampled[i], 4, GL_RGBA8, 16, 16, GL_TRUE);
        gl.TextureStorage3D(arrays[i], kLevels, GL_RGBA8, 16, 16, kLayers);
        gl.TextureBuffer(bufferTextures[i], GL_RGBA8, buffers[i]);
        gl.NamedRenderbufferStorage(renderbuffers[i], GL_DEPTH24_STENCIL8, 16, 16);
        gl.NamedFramebufferTexture(framebuffers[i], GL_COLOR_ATTACHMENT0, textures[i], 0);
        programs[i] = linkedProgram(gl);
        stages_[i] = gl.CreateShaderProgramv(GL_VERTEX_SHADER, 1, &kVertexShader);
        gl.UseProgramStages(pipelines[i], GL_VERTEX_SHADER_BIT, stages_[i]);
    }
    gl.NamedFramebufferRenderbuffer(framebuffers.back(), GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                    renderbuffers.back());
}

HostObjects::~HostObjects() { deleteAll(); }

void HostObjects::deleteAll() {
    constexpr GLsizei count = kCount;
    gl_.DeleteProgramPipelines(count, pipelines.data());
    for (size_t i = 0; i < kCount; ++i) {
        gl_.DeleteProgram(programs[i]);
        gl_.DeleteProgram(stages_[i]);
    }
    gl_.DeleteVertexArrays(count, vertexArrays.data());
    gl_.DeleteFramebuffers(count, framebuffers.data());
    gl_.DeleteRenderbuffers(count, renderbuffers.data());
    gl_.DeleteSamplers(count, samplers.data());
    for (const Names* names : {&textures, &multisampled, &arrays, &bufferTextures})
        gl_.DeleteTextures(count, names->data());
    gl_.DeleteBuffers(count, buffers.data());
    for (Names* names : {&buffers, &textures, &multisampled, &arrays, &bufferTextures, &samplers, &renderbuffers,
                         &framebuffers, &vertexArrays, &programs, &pipelines, &stages_})
        names->fill(0); // a second deletion does nothing
}

} // namespace agaa::test
