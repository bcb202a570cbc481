#include "gl/color_samples.h"

#include "core/base/error.h"
#include "gl/errors.h"
#include "gl/program.h"

#include <string>

namespace agaa::gl {

namespace {

// The triangle covers all samples. The texel in column i keeps sample i alone.
constexpr const char* maskText = R"(#version 430
layout(location = 0) out vec4 color;
void main() {
    gl_SampleMask[0] = 1 << int(gl_FragCoord.x);
    color = vec4(1.0);
}
)";
// Writes the colour samples of a texel as components.
constexpr const char* readText = R"(
layout(binding = 0) uniform AGAA_TEXTURE image;
layout(location = 0) out vec4 color;
void main() {
    color = vec4(0.0);
    for (int i = 0; i < AGAA_COLOR_SAMPLES; ++i)
        color[i] = texelFetch(image, ivec2(gl_FragCoord.xy), i).x;
}
)";

class Probe {
public:
    Probe(const GladGLContext& context, uint32_t samples, uint32_t colorSamples)
        : gl(context), width(GLsizei(samples)) {
        try {
            create(colorSamples);
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~Probe() { destroy(); }
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;

    // Returns four bytes for each coverage sample, one for each colour sample.
    std::array<std::array<uint8_t, 4>, 32> run() {
        for (GLenum capability : {GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD,
                                  GL_BLEND, GL_DITHER, GL_SAMPLE_SHADING, GL_SAMPLE_MASK, GL_SAMPLE_COVERAGE,
                                  GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_COLOR_LOGIC_OP})
            gl.Disable(capability);
        if (gl.NV_framebuffer_mixed_samples) {
            gl.Disable(GL_RASTER_MULTISAMPLE_EXT);
            gl.CoverageModulationNV(GL_NONE);
        }
        GLint distances = 0; // enabled distances that the shader does not write are undefined
        gl.GetIntegerv(GL_MAX_CLIP_DISTANCES, &distances);
        for (GLint i = 0; i < distances; ++i)
            gl.Disable(GLenum(GL_CLIP_DISTANCE0 + i));
        gl.Enable(GL_MULTISAMPLE);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.Viewport(0, 0, width, 1);
        gl.BindVertexArray(vertexArray);
        constexpr GLfloat zero[4] = {};
        gl.ClearNamedFramebufferfv(framebuffers[0], GL_COLOR, 0, zero);
        draw(framebuffers[0], programs[0]);
        gl.BindTextureUnit(0, textures[1]);
        gl.BindSampler(0, 0);
        draw(framebuffers[1], programs[1]);
        std::array<std::array<uint8_t, 4>, 32> texels{};
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        for (GLenum parameter : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES})
            gl.PixelStorei(parameter, 0);
        gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        gl.GetTextureImage(textures[2], 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(sizeof texels), texels.data());
        return texels;
    }

private:
    void draw(GLuint framebuffer, GLuint program) {
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        gl.UseProgram(program);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    void attach(GLuint framebuffer, GLenum attachment, GLuint texture) {
        gl.NamedFramebufferTexture(framebuffer, attachment, requireObject(gl, texture, "glCreateTextures"), 0);
    }
    void create(uint32_t colorSamples) {
        const std::string defines = "#version 430\n#define AGAA_TEXTURE " +
                                    std::string(colorSamples > 1 ? "sampler2DMS" : "sampler2D") +
                                    "\n#define AGAA_COLOR_SAMPLES " + std::to_string(colorSamples) + "\n";
        const std::string reader = defines + readText;
        const char* what = "the probe of colour samples";
        programs[0] = linkProgram(gl, {{GL_VERTEX_SHADER, wholeTargetText}, {GL_FRAGMENT_SHADER, maskText}}, what,
                                  AGAA_ERROR_UNSUPPORTED);
        programs[1] = linkProgram(gl, {{GL_VERTEX_SHADER, wholeTargetText}, {GL_FRAGMENT_SHADER, reader.c_str()}}, what,
                                  AGAA_ERROR_UNSUPPORTED);
        gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &textures[0]);
        gl.TextureStorage2DMultisample(textures[0], width, GL_DEPTH_COMPONENT32F, width, 1, GL_TRUE);
        gl.CreateTextures(colorSamples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &textures[1]);
        if (colorSamples > 1)
            gl.TextureStorage2DMultisample(textures[1], GLsizei(colorSamples), GL_RGBA8, width, 1, GL_TRUE);
        else
            gl.TextureStorage2D(textures[1], 1, GL_RGBA8, width, 1);
        gl.CreateTextures(GL_TEXTURE_2D, 1, &textures[2]);
        gl.TextureStorage2D(textures[2], 1, GL_RGBA8, width, 1);
        if (colorSamples == 1)
            gl.TextureParameteri(textures[1], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.CreateFramebuffers(2, framebuffers);
        requireObject(gl, framebuffers[0] != 0 ? framebuffers[1] : 0, "glCreateFramebuffers");
        attach(framebuffers[0], GL_DEPTH_ATTACHMENT, textures[0]);
        attach(framebuffers[0], GL_COLOR_ATTACHMENT0, textures[1]);
        attach(framebuffers[1], GL_COLOR_ATTACHMENT0, textures[2]);
        const GLenum status = gl.CheckNamedFramebufferStatus(framebuffers[0], GL_DRAW_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE)
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("the driver cannot draw with %d samples of depth and %u of colour: status 0x%04X.", int(width),
                        colorSamples, status));
        gl.CreateVertexArrays(1, &vertexArray);
        requireObject(gl, vertexArray, "glCreateVertexArrays");
        checkErrors(gl, "probing colour samples"); // nothing is drawn into a target without memory
    }
    void destroy() {
        for (const GLuint program : programs)
            gl.DeleteProgram(program);
        gl.DeleteFramebuffers(2, framebuffers);
        gl.DeleteTextures(3, textures);
        gl.DeleteVertexArrays(1, &vertexArray);
    }

    const GladGLContext& gl;
    const GLsizei width;
    GLuint programs[2] = {0, 0};
    GLuint textures[3] = {0, 0, 0}; // depth, colours, texels that are read
    GLuint framebuffers[2] = {0, 0};
    GLuint vertexArray = 0;
};

} // namespace

std::array<uint32_t, 4> probeColorSamples(const GladGLContext& gl, uint32_t samples, uint32_t colorSamples) {
    const std::array<std::array<uint8_t, 4>, 32> texels = Probe(gl, samples, colorSamples).run();
    checkErrors(gl, "probing colour samples");
    std::array<uint32_t, 4> masks{};
    for (uint32_t i = 0; i < samples; ++i)
        for (uint32_t color = 0; color < colorSamples; ++color)
            masks[color] |= uint32_t(texels[i][color] > 127) << i;
    return masks;
}

} // namespace agaa::gl
