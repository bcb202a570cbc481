// A host that shades the aggregates itself, by the text that reads them, against the SDK's own shading.
#include "host_shading.h"
#include "stage_host.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

constexpr const char* declarations = R"(#version 430
layout(std430, binding = 0) readonly buffer Aggregates { uint words[]; } aggregates;
layout(rgba32f, binding = 0) writeonly uniform image2D image;
#define AGAA_AGGREGATE_WORD(i) aggregates.words[i]
void show(uvec2 pixel, vec3 color) { imageStore(image, ivec2(pixel), vec4(color, 1.0)); }
)";

GLuint computeProgram(const GladGLContext& gl, const std::string& text) {
    const char* source = text.c_str();
    const GLuint program = gl.CreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    char log[2048] = "";
    gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    EXPECT_TRUE(linked) << log;
    return program;
}

std::vector<float> shadedByHost(StageContext& context, const ViewSettings& settings, StageView& view,
                                const char* light = ambientLight) {
    const GladGLContext& gl = context.egl().gl();
    AgaaGlSurface surface = AGAA_GL_SURFACE_INIT;
    EXPECT_EQ(agaaGlGetSurface(view.get(), "aggregates", &surface), AGAA_OK);
    const GLuint program = computeProgram(gl, hostShadingText(viewDesc(settings), context.caps(), declarations, light));
    const harness::gl::Texture image = harness::gl::createTexture(gl, GL_TEXTURE_2D);
    gl.TextureStorage2D(image.get(), 1, GL_RGBA32F, GLsizei(settings.width), GLsizei(settings.height));
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gl.UseProgram(program);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, surface.buffer);
    gl.BindImageTexture(0, image.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl.DispatchCompute((settings.width + 7) / 8, (settings.height + 7) / 8, 1);
    gl.MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    std::vector<float> rgba(size_t(settings.width) * settings.height * 4);
    gl.GetTextureImage(image.get(), 0, GL_RGBA, GL_FLOAT, GLsizei(rgba.size() * sizeof(float)), rgba.data());
    gl.UseProgram(0);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
    gl.BindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
    gl.DeleteProgram(program);
    return rgba;
}

TEST(GlHostShading, ReadsWhatTheSdkShades) {
    StageContext context;
    forHostShading(AGAA_TIER_PER_SAMPLE, [&](ViewSettings settings) {
        settings.config.flags |= AGAA_CONFIG_READBACK;
        StageView view(context, settings);
        view.setTriangles(hostShadingScene());
        AgaaFrame frame = view.frame();
        lightForHost(frame);
        view.render(frame);
        expectShadedAlike(view.image(), 4, shadedByHost(context, settings, view));
    });
}

TEST(GlHostShading, ReadsAttributesOfItsOwn) {
    StageContext context;
    CustomImages images;
    forCustomAttributes({AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER}, [&](const ViewSettings& settings) {
        StageView view(context, settings);
        view.setTriangles(hostShadingScene());
        view.render(view.frame());
        images.add(settings, shadedByHost(context, settings, view, customLight));
    });
}

TEST(GlHostShading, IsRefusedWhereNothingIsKept) {
    StageContext context;
    for (const char* technique : {"ssaa", "sbaa", "agaa"}) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.generationTier = technique == std::string("agaa") ? AGAA_TIER_GBUFFER : AGAA_TIER_AUTO;
        const AgaaViewDesc desc = viewDesc(settings);
        std::vector<LogLine> lines;
        AgaaLog log = AGAA_LOG_INIT;
        log.callback = collectLines;
        log.user = &lines;
        size_t size = 0;
        EXPECT_EQ(agaaGetAggregateGlsl(&desc, &context.caps(), &log, &size, nullptr), AGAA_ERROR_UNSUPPORTED);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_NE(lines[0].text.find("no aggregates in memory"), std::string::npos);
    }
}

} // namespace
} // namespace agaa::test
