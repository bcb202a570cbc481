// The GLSL that hosts get for G-buffers that they draw themselves (agaaGetCoverageGlsl), in a program that knows
// nothing else of the library, against what the library's own passes cover.
#include "show.h"

#include "gl/objects.h"
#include "gl/program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace agaa::test {
namespace {

constexpr uint32_t width = 96, height = 64;
constexpr int samples = 4;

std::string coverageGlsl() {
    size_t size = 0;
    EXPECT_EQ(agaaGetCoverageGlsl(nullptr, &size, nullptr), AGAA_OK);
    std::string text(size, '\0');
    EXPECT_EQ(agaaGetCoverageGlsl(nullptr, &size, text.data()), AGAA_OK);
    text.resize(size - 1);
    return text;
}

// Coverage of each pixel by a multisampled target of the host's own. body: sets `int mask`.
std::vector<double> drawn(const std::string& body) {
    const GladGLContext& gl = sharedEgl().gl();
    const harness::gl::Program program(
        gl,
        "#version 450\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, "
        "0.0, 1.0); }",
        "#version 450\n" + coverageGlsl() +
            "layout(location = 0) uniform vec2 samplePosition[4];\nlayout(location = 0) out vec4 color;\n"
            "void main() {\n    color = vec4(1.0);\n" +
            body + "    gl_SampleMask[0] = mask;\n}\n",
        "coverage");
    GLuint textures[2], framebuffers[2], vertexArray = 0;
    gl.GenVertexArrays(1, &vertexArray);
    gl.GenFramebuffers(2, framebuffers);
    gl.GenTextures(2, textures);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, textures[0]);
    gl.TexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, width, height, GL_TRUE);
    gl.BindTexture(GL_TEXTURE_2D, textures[1]);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textures[1], 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textures[0], 0);
    gl.Viewport(0, 0, width, height);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.UseProgram(program.get());
    for (int i = 0; i < samples; ++i) {
        GLfloat position[2];
        gl.GetMultisamplefv(GL_SAMPLE_POSITION, GLuint(i), position);
        gl.Uniform2fv(i, 1, position);
    }
    gl.BindVertexArray(vertexArray);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    std::vector<uint8_t> rgba(size_t(4) * width * height);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
    gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    gl.DeleteTextures(2, textures);
    gl.DeleteFramebuffers(2, framebuffers);
    gl.DeleteVertexArrays(1, &vertexArray);
    std::vector<double> coverage;
    for (size_t i = 0; i < rgba.size(); i += 4)
        coverage.push_back(rgba[i] / 255.0);
    return coverage;
}

// The same card by "ssaa" of as many samples.
std::vector<double> shaded(const char* surface) {
    StageContext context;
    ViewSettings settings;
    settings.width = width;
    settings.height = height;
    settings.projection = pixelOrthographic(width, height, 10);
    settings.config.technique = "ssaa";
    settings.config.samples = samples;
    settings.facts.shadowMapCount = 0;
    settings.surface = surface;
    Material material;
    material.diffuse = glm::vec4(1);
    material.specular = glm::vec4(0);
    material.normal = glm::vec4(0, 0, 1, 1);
    std::vector<Triangle> triangles;
    for (Triangle t : rectangle(0, 0, float(width), float(height), 4, material)) {
        t.isMasked = true;
        triangles.push_back(t);
    }
    const Shown shown = show(context, settings, {.triangles = triangles, .change = [](AgaaFrame& frame) {
                                                     frame.background[0] = frame.background[1] = frame.background[2] =
                                                         0;
                                                 }});
    std::vector<double> coverage;
    for (size_t i = 0; i < shown.rgb.size(); i += 3)
        coverage.push_back(double(shown.rgb[i]) * 3.14159265 / 3); // by the sun, of irradiance 3
    return coverage;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

constexpr const char* loop = "    int mask = 0;\n    for (int i = 0; i < 4; ++i)\n        mask |= ";

TEST(GlCoverageGlsl, CutoutsCoverTheSamplesOfTheLibrarysPasses) {
    const std::vector<double> expected =
        shaded("precise vec3 at = AGAA_AT_CENTRE(position); precise float a = 25.9 - length(at.xy - vec2(48.3, 31.9)); "
               "s.alpha = a; s.alphaCutoff = 0.5;");
    const std::vector<double> own =
        drawn(std::string("    precise float alpha = 25.9 - length(gl_FragCoord.xy - vec2(48.3, 31.9));\n"
                          "    vec2 gradient = vec2(dFdxFine(alpha), dFdyFine(alpha));\n") +
              loop + "agaa_isInCutout(alpha, 0.5, gradient, samplePosition[i] - 0.5) ? 1 << i : 0;\n");
    double whole = 0;
    for (const double c : expected)
        whole += c;
    EXPECT_GT(whole, 0.2 * double(expected.size()));
    EXPECT_LT(whole, 0.8 * double(expected.size()));
    EXPECT_LT(largestDifference(own, expected), 5e-3);
}

TEST(GlCoverageGlsl, FourPointsCoverTheSamplesOfTheLibrarysPasses) {
    const std::string alphaAt = "0.85 - 5.0 * abs(fract((p.x + 0.2 * p.y) / 5.0) - 0.5)";
    const std::string surface =
        "precise vec3 at = AGAA_AT_CENTRE(position); s.alpha = 1.0; s.alphaCutoff = 0.5; s.hasAlphaNear = true; "
        "for (uint k = 0u; k < AGAA_ALPHA_POINTS; ++k) { precise vec2 p = at.xy + agaa_alphaPoint(k); "
        "precise float b = " +
        alphaAt + "; s.alphaNear[k] = b; }";
    const std::vector<double> own = drawn(
        "    vec4 near;\n    for (int k = 0; k < 4; ++k) {\n"
        "        precise vec2 p = gl_FragCoord.xy + vec2(k & 1, k >> 1) * 0.5 - 0.25;\n        precise float b = " +
        alphaAt + ";\n        near[k] = b;\n    }\n" + loop +
        "agaa_isInCutout4(near, 0.5, samplePosition[i] - 0.5) ? 1 << i : 0;\n");
    EXPECT_LT(largestDifference(own, shaded(surface.c_str())), 5e-3);
}

TEST(GlCoverageGlsl, TranslucentSurfacesCoverTheirShare) {
    for (const double alpha : {0.05, 0.3}) {
        const std::vector<double> own =
            drawn("    uvec2 pixel = uvec2(gl_FragCoord.xy);\n    int mask = int(agaa_translucentMask(" +
                  std::to_string(alpha) + ", 4u, 0u, 1u, agaa_translucencyHash(pixel.x, pixel.y, 7u, 0u)));\n");
        double mean = 0;
        for (const double c : own)
            mean += c / double(own.size());
        EXPECT_NEAR(mean, alpha, 4 * std::sqrt(alpha * (1 - alpha) / (4.0 * width * height)));
    }
}

} // namespace
} // namespace agaa::test
