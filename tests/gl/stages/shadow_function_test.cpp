// Shadows by a function of the host's against the shadow map that says the same, and what else a frame may ask of
// its view.
#include "bench.h"

#include "gl/output_view.h"

#include <array>
#include <cmath>
#include <numeric>

namespace agaa::test {
namespace {

constexpr uint32_t shadowUnit = 20, shadowBlock = 6; // beyond what frames touch
constexpr const char* functionText = R"(
layout(binding = 20) uniform sampler2D hostMap;
layout(std140, binding = 6) uniform Host { float threshold; } host;
float agaaHostShadow(uint shadow, vec3 position) {
    return texelFetch(hostMap, ivec2(0), 0).x < host.threshold ? 0.0 : 1.0;
}
)";

// All points lie at 0.25 of a map of this depth: lit where it is not less.
std::vector<float> byMap(const ViewSettings& settings, float depth) {
    Bench bench(settings);
    bench.map = shadowMap(sharedEgl().gl(), depth);
    return bench.picture();
}

std::vector<float> byFunction(ViewSettings settings, float depth) {
    const GladGLContext& gl = sharedEgl().gl();
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = functionText;
    function.shadows = 1;
    settings.chained = &function;
    const harness::gl::Texture map = harness::gl::createTexture(gl, GL_TEXTURE_2D);
    gl.TextureStorage2D(map.get(), 1, GL_R32F, 1, 1);
    gl.TextureSubImage2D(map.get(), 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, &depth);
    const harness::gl::Buffer block = harness::gl::createBuffer(gl);
    const float threshold[4] = {0.25f, 0, 0, 0};
    gl.NamedBufferData(block.get(), sizeof threshold, threshold, GL_STATIC_DRAW);
    gl.BindTextureUnit(shadowUnit, map.get());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, shadowBlock, block.get());
    Bench bench(settings);
    bench.shadow = AgaaShadow{};
    const std::vector<float> picture = bench.picture();
    gl.BindTextureUnit(shadowUnit, 0);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, shadowBlock, 0);
    return picture;
}

double sum(const std::vector<float>& picture) { return std::accumulate(picture.begin(), picture.end(), 0.0); }

TEST(GlShadowFunction, ShowsWhatTheSameMapShows) {
    for (const char* technique : {"single", "ssaa", "simple_complex", "sbaa", "agaa", "adaptive"}) {
        ViewSettings settings = benchSettings();
        settings.config.technique = technique;
        settings.config.samples = technique == std::string("single") ? 1 : 4;
        const std::vector<float> lit = byMap(settings, 0.5f), dark = byMap(settings, 0.125f);
        EXPECT_GT(sum(lit), 1.005 * sum(dark)) << "there is light to lose";
        EXPECT_EQ(byFunction(settings, 0.5f), lit) << technique;
        EXPECT_EQ(byFunction(settings, 0.125f), dark) << technique;
    }
}

// What the output held shows where nothing is drawn, and in part where something is.
TEST(GlFrames, CompositeOverTheOutput) {
    const GladGLContext& gl = sharedEgl().gl();
    ViewSettings settings = benchSettings();
    const auto render = [&](bool composite) {
        settings.flags = composite ? AGAA_VIEW_COMPOSITE : 0;
        Bench bench(settings);
        const float below[4] = {0.25f, 0.5f, 2.0f, 1};
        const harness::gl::Framebuffer target = harness::gl::createFramebuffer(gl);
        gl.NamedFramebufferTexture(target.get(), GL_COLOR_ATTACHMENT0, bench.view.output().get(), 0);
        gl.Disable(GL_SCISSOR_TEST);
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.ClearNamedFramebufferfv(target.get(), GL_COLOR, 0, below);
        AgaaFrame frame = bench.frame();
        for (int i = 0; i < 4; ++i)
            frame.background[i] = composite ? 0 : below[i];
        bench.view.render(frame, bench.glFrame());
        return bench.view.image();
    };
    for (const char* technique : {"ssaa", "agaa", "sbaa", "simple_complex", "msaa", "fxaa"}) {
        settings.config.technique = technique;
        EXPECT_EQ(render(true), render(false)) << technique << ": a background of the same colour";
    }
}

// As glTexImage2D leaves a texture: with a filter that wants mip levels, and without any.
TEST(GlFrames, CompositeOverATextureWithoutMipLevels) {
    const GladGLContext& gl = sharedEgl().gl();
    ViewSettings settings = benchSettings();
    settings.flags = AGAA_VIEW_COMPOSITE;
    Bench bench(settings);
    const auto count = GLsizei(4 * settings.width * settings.height);
    const std::vector<float> below(size_t(count), 0.5f);
    const auto render = [&](GLuint output) {
        gl.TextureSubImage2D(output, 0, 0, 0, GLsizei(settings.width), GLsizei(settings.height), GL_RGBA, GL_FLOAT,
                             below.data());
        AgaaFrame frame = bench.frame();
        frame.background[3] = 0;
        AgaaGlFrame glFrame = bench.glFrame();
        glFrame.outputTexture = output;
        bench.view.render(frame, glFrame);
        std::vector<float> texels(below.size());
        gl.GetTextureImage(output, 0, GL_RGBA, GL_FLOAT, count * GLsizei(sizeof(float)), texels.data());
        return texels;
    };
    GLuint name = 0;
    gl.GenTextures(1, &name);
    const harness::gl::Texture output(gl, name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, GLsizei(settings.width), GLsizei(settings.height), 0, GL_RGBA, GL_FLOAT,
                  nullptr);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    gl.TextureParameteri(name, GL_TEXTURE_MAX_LEVEL, 3);
    EXPECT_EQ(render(name), render(bench.view.output().get()));
    GLint maxLevel = 0, filter = 0;
    gl.GetTextureParameteriv(name, GL_TEXTURE_MAX_LEVEL, &maxLevel);
    gl.GetTextureParameteriv(name, GL_TEXTURE_MIN_FILTER, &filter);
    EXPECT_EQ(maxLevel, 3) << "the host's";
    EXPECT_EQ(filter, GL_NEAREST_MIPMAP_LINEAR);
}

// Textures with bindless handles refuse any change: those that lack no level keep their last one during a frame.
TEST(GlFrames, OutputsThatLackNoLevelAreNotChanged) {
    const GladGLContext& gl = sharedEgl().gl();
    for (const bool isImmutable : {false, true}) {
        ViewSettings settings = benchSettings();
        const harness::gl::Texture output = harness::gl::createTexture(gl, GL_TEXTURE_2D);
        const auto width = GLsizei(settings.width), height = GLsizei(settings.height);
        if (isImmutable) {
            gl.TextureStorage2D(output.get(), 1, GL_RGBA32F, width, height);
        } else {
            gl.BindTexture(GL_TEXTURE_2D, output.get());
            gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
            gl.BindTexture(GL_TEXTURE_2D, 0);
            gl.TextureParameteri(output.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        }
        const agaa::gl::OutputView view(gl, output.get());
        GLint maxLevel = 0;
        gl.GetTextureParameteriv(output.get(), GL_TEXTURE_MAX_LEVEL, &maxLevel);
        EXPECT_EQ(maxLevel, 1000) << "OpenGL's default";
    }
}

// Level 0 and its channels are written and read, whatever the host's own sampling of the texture is set to.
TEST(GlFrames, OutputsMayHaveABaseLevelAndSwizzle) {
    const GladGLContext& gl = sharedEgl().gl();
    ViewSettings settings = benchSettings();
    settings.flags = AGAA_VIEW_COMPOSITE;
    const auto width = GLsizei(settings.width), height = GLsizei(settings.height);
    const auto count = 4 * width * height;
    const std::vector<float> below(size_t(count), 0.5f), other(size_t(count), 8.0f);
    constexpr std::array<GLint, 4> plain = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    constexpr std::array<GLint, 4> mixed = {GL_ZERO, GL_ALPHA, GL_RED, GL_ONE};
    for (const char* technique : {"ssaa", "agaa", "fxaa"}) {
        settings.config.technique = technique;
        Bench bench(settings);
        const auto render = [&](GLint baseLevel, const std::array<GLint, 4>& swizzle, float background) {
            const harness::gl::Texture output = harness::gl::createTexture(gl, GL_TEXTURE_2D);
            gl.TextureStorage2D(output.get(), 2, GL_RGBA32F, width, height);
            gl.TextureSubImage2D(output.get(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, below.data());
            gl.TextureSubImage2D(output.get(), 1, 0, 0, width / 2, height / 2, GL_RGBA, GL_FLOAT, other.data());
            gl.TextureParameteri(output.get(), GL_TEXTURE_BASE_LEVEL, baseLevel);
            gl.TextureParameteriv(output.get(), GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
            AgaaFrame frame = bench.frame();
            frame.background[3] = background;
            AgaaGlFrame glFrame = bench.glFrame();
            glFrame.outputTexture = output.get();
            bench.view.render(frame, glFrame);
            GLint levelNow = -1;
            std::array<GLint, 4> swizzleNow{};
            gl.GetTextureParameteriv(output.get(), GL_TEXTURE_BASE_LEVEL, &levelNow);
            gl.GetTextureParameteriv(output.get(), GL_TEXTURE_SWIZZLE_RGBA, swizzleNow.data());
            EXPECT_EQ(levelNow, baseLevel);
            EXPECT_EQ(swizzleNow, swizzle);
            std::vector<float> texels(below.size());
            gl.GetTextureImage(output.get(), 0, GL_RGBA, GL_FLOAT, count * GLsizei(sizeof(float)), texels.data());
            return texels;
        };
        for (float background : {0.0f, 1.0f}) { // 0: composites
            const std::vector<float> expected = render(0, plain, background);
            EXPECT_EQ(render(1, plain, background), expected) << technique << ", background " << background;
            EXPECT_EQ(render(0, mixed, background), expected) << technique << ", background " << background;
            EXPECT_EQ(render(1, mixed, background), expected) << technique << ", background " << background;
        }
    }
}

double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double total = 0;
    for (size_t i = 0; i < a.size(); ++i)
        total += std::fabs(double(a[i]) / (1 + double(a[i])) - double(b[i]) / (1 + double(b[i])));
    return total / double(a.size());
}

// z in [-w;w] for z in [0;w].
glm::mat4 fromMinusOne(glm::mat4 projection) {
    for (int column = 0; column < 4; ++column)
        projection[column][2] = 2 * projection[column][2] - projection[column][3];
    return projection;
}

TEST(GlFrames, EitherDepthAndClipConventionAgrees) {
    ViewSettings settings = benchSettings();
    const auto render = [&](uint64_t flags, const glm::mat4& projection) {
        settings.flags = flags;
        settings.projection = projection;
        Bench bench(settings);
        // Near the triangles, so that places which depth tells wrongly are lit wrongly.
        bench.light.type = AGAA_LIGHT_POINT;
        bench.light.position[2] = -2;
        return bench.picture();
    };
    const glm::mat4 standard = perspective(60, 1.5f, 0.1f, 100);
    const glm::mat4 reversed = reversedInfinite(60, 1.5f, 0.1f);
    constexpr uint64_t below = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    const std::vector<float> expected = render(0, standard);
    const struct {
        const char* name;
        uint64_t flags;
        glm::mat4 projection;
    } rows[] = {
        {"reversed", AGAA_VIEW_REVERSED_Z, reversed},
        {"[-1;1]", below, fromMinusOne(standard)},
        {"[-1;1], reversed", below | AGAA_VIEW_REVERSED_Z, fromMinusOne(reversed)},
    };
    for (const auto& row : rows) {
        const double mean = 255 * meanDifference(render(row.flags, row.projection), expected);
        std::printf("%-18s mean difference %.6f/255\n", row.name, mean);
        EXPECT_LT(mean, 1e-3) << row.name;
    }
}

} // namespace
} // namespace agaa::test
