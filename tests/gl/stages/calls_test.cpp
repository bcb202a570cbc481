// What frames ask of OpenGL, where a picture would not show a mistake or another driver's would.
#include "bench.h"
#include "replaced.h"

#include "gl/pass_clock.h"

#include <cstring>
#include <utility>

namespace agaa::test {
namespace {

const GladGLContext& driver() { return sharedEgl().gl(); }

GLbitfield barriers; // since the last call that is looked at
bool clearedBehindBarrier;

void GLAD_API_PTR memoryBarrier(GLbitfield bits) {
    barriers |= bits;
    driver().MemoryBarrier(bits);
}
void GLAD_API_PTR clearBuffer(GLuint buffer, GLenum internalFormat, GLenum format, GLenum type, const void* data) {
    clearedBehindBarrier &= (barriers & GL_BUFFER_UPDATE_BARRIER_BIT) != 0;
    driver().ClearNamedBufferData(buffer, internalFormat, format, type, data);
}

// What a draw stored before its callback failed is cleared by the next frame.
TEST(GlCalls, AFailureIsFollowedByBarriers) {
    Replaced replaced;
    replace(replaced, "glMemoryBarrier", memoryBarrier);
    replace(replaced, "glClearNamedBufferData", clearBuffer);
    Bench bench(benchSettings(), contextDesc(replaced));
    bench.picture();
    for (const uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE}) {
        bench.view.drawResults[pass] = AGAA_ERROR_DEVICE;
        EXPECT_EQ(bench.record(bench.frame(), bench.glFrame()), AGAA_ERROR_CALLBACK);
        bench.view.drawResults.clear();
        barriers = 0;
        clearedBehindBarrier = true;
        EXPECT_EQ(bench.record(bench.frame(), bench.glFrame()), AGAA_OK);
        EXPECT_TRUE(clearedBehindBarrier) << "pass " << pass;
    }
}

uint32_t dispatches, fedBack; // the latter: with images bound to draw to
void GLAD_API_PTR dispatch(GLuint x, GLuint y, GLuint z) {
    GLint framebuffer = 0;
    driver().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    bool draws = framebuffer == 0;
    for (const GLenum attachment : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT}) {
        GLint kind = GL_NONE;
        driver().GetNamedFramebufferAttachmentParameteriv(GLuint(framebuffer), framebuffer ? attachment : GL_BACK,
                                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        draws |= kind != GL_NONE;
    }
    ++dispatches;
    fedBack += draws;
    driver().DispatchCompute(x, y, z);
}

// OpenGL 4.5, 9.3.1: fetching from what the bound framebuffer could write is undefined, for another kind of shader too.
TEST(GlCalls, NothingIsFetchedFromTheBoundFramebuffer) {
    Replaced replaced;
    replace(replaced, "glDispatchCompute", dispatch);
    for (const AgaaGlStatePolicy policy : {AGAA_GL_STATE_RESTORE, AGAA_GL_STATE_NONE}) {
        OpenGLContextDesc desc = contextDesc(replaced);
        desc.device.statePolicy = policy;
        Bench bench(benchSettings(), desc);
        dispatches = fedBack = 0;
        bench.picture();
        EXPECT_GT(dispatches, 1u);
        EXPECT_EQ(fedBack, 0u) << policy;
    }
}

// The driver is said to be a GPU's, so that a shader fills buffers, whose text is refused.
const GLubyte* GLAD_API_PTR stringOfAGpu(GLenum name) {
    return name == GL_RENDERER ? reinterpret_cast<const GLubyte*>("a GPU") : driver().GetString(name);
}
void GLAD_API_PTR sourceWithoutFill(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
    const GLchar* const wrong = "#version 430\nwrong";
    const bool fills = std::strstr(texts[0], "block.words[i] = value") != nullptr;
    driver().ShaderSource(shader, count, fills ? &wrong : texts, fills ? nullptr : lengths);
}

TEST(GlCalls, AShaderThatDoesNotFillIsReplacedWithAWarning) {
    Replaced replaced;
    replace(replaced, "glGetString", stringOfAGpu);
    {
        const StageContext fills(contextDesc(replaced));
        EXPECT_FALSE(fills.caps().flags & AGAA_DEVICE_SOFTWARE);
        EXPECT_TRUE(fills.lines.empty());
    }
    replace(replaced, "glShaderSource", sourceWithoutFill);
    Bench bench(benchSettings(), contextDesc(replaced));
    ASSERT_EQ(bench.context.lines.size(), 1u);
    EXPECT_EQ(bench.context.lines[0].code, AGAA_OK);
    EXPECT_NE(bench.context.lines[0].text.find("the shader that fills buffers does not compile"), std::string::npos)
        << bench.context.lines[0].text;
    const std::vector<float> cleared = bench.picture();
    EXPECT_TRUE(bench.context.lines.empty()) << "the warning is not repeated";
    sharedEgl().takeMessages(); // the driver may tell of the wrong text
    Bench usual(benchSettings(), contextDesc());
    EXPECT_EQ(cleared, usual.picture());
}

const char queryOfSamples[] = "GL_NV_internalformat_sample_query";
void GLAD_API_PTR integersAndOneExtension(GLenum parameter, GLint* out) {
    driver().GetIntegerv(parameter, out);
    *out += parameter == GL_NUM_EXTENSIONS;
}
const GLubyte* GLAD_API_PTR stringOrExtension(GLenum name, GLuint index) {
    GLint count = 0;
    driver().GetIntegerv(GL_NUM_EXTENSIONS, &count);
    return name == GL_EXTENSIONS && index == GLuint(count) ? reinterpret_cast<const GLubyte*>(queryOfSamples)
                                                           : driver().GetStringi(name, index);
}
GLenum whatFourLack;
void GLAD_API_PTR sampleQuery(GLenum, GLenum, GLsizei samples, GLenum parameter, GLsizei, GLint* out) {
    const bool lacks = samples == 4 && parameter == whatFourLack;
    *out = !lacks ? 1 : parameter == GL_CONFORMANT_NV ? GL_FALSE : 2;
}

// As NVIDIA's 16 samples, which are 4 in each of four texels.
TEST(GlCalls, SupersamplingIsNotTakenForSamples) {
    sharedEgl().makeCurrent();
    Replaced replaced;
    replace(replaced, "glGetIntegerv", integersAndOneExtension);
    replace(replaced, "glGetStringi", stringOrExtension);
    replace(replaced, "glGetInternalformatSampleivNV", sampleQuery);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    for (const GLenum lack : {GL_NONE, GL_SUPERSAMPLE_SCALE_X_NV, GL_SUPERSAMPLE_SCALE_Y_NV, GL_CONFORMANT_NV}) {
        whatFourLack = lack;
        ASSERT_EQ(agaaGlGetDeviceCaps(replacedProcAddr, &replaced, nullptr, &caps), AGAA_OK);
        EXPECT_EQ(caps.sampleCounts >> 2 & 1u, lack == GL_NONE ? 1u : 0u) << lack;
        EXPECT_EQ(caps.sampleCounts & 1u, 1u);
    }
}

TEST(GlCalls, ASlotThatAFunctionAnswersForIsNotUsed) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    function.shadows = 1;
    ViewSettings settings = benchSettings();
    settings.facts.shadowMapCount = 2;
    settings.chained = &function;
    Bench bench(settings);
    bench.shadow = AgaaShadow{};
    AgaaGlFrame glFrame = bench.glFrame();
    glFrame.shadowTextures[0] = deletedTexture(sharedEgl().gl());
    bench.view.render(bench.frame(), glFrame);
    EXPECT_EQ(sharedEgl().takeMessages(), "");
}

TEST(GlCalls, AFrameWithoutShadowsNeedsNoMap) {
    Bench bench;
    bench.light.shadowMap = AGAA_NO_SHADOW;
    AgaaFrame frame = bench.frame();
    frame.shadowCount = 0;
    bench.view.render(frame, bench.glFrame());
    const std::vector<float> expected = bench.view.image();
    frame = bench.frame();
    frame.shadowCount = 0;
    bench.view.render(frame, bench.view.glFrame());
    EXPECT_EQ(sharedEgl().takeMessages(), "");
    EXPECT_EQ(bench.view.image(), expected);
}

bool compiles;
void GLAD_API_PTR getShader(GLuint shader, GLenum parameter, GLint* value) {
    driver().GetShaderiv(shader, parameter, value);
    if (parameter == GL_COMPILE_STATUS && !compiles)
        *value = GL_FALSE;
}

TEST(GlCalls, AProbeThatDoesNotCompileLeavesTheClock) {
    Replaced replaced;
    replace(replaced, "glGetShaderiv", getShader);
    compiles = false;
    StageContext context(contextDesc(replaced));
    compiles = true;
    const bool fillsByShader = !(context.caps().flags & AGAA_DEVICE_SOFTWARE); // which does not compile either
    EXPECT_EQ(context.lines.size(), size_t(fillsByShader)) << (context.lines.empty() ? "" : context.lines.back().text);
    ViewSettings settings = benchSettings();
    settings.config.flags |= AGAA_CONFIG_TIMESTAMPS;
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 20}, 41));
    AgaaFrame frame = view.frame();
    frame.shadowCount = 0;
    view.render(frame);
    EXPECT_EQ(view.statistics().timeSource, uint32_t{AGAA_TIME_CPU_FINISH});
}

GLenum errorOfObjects = GL_NO_ERROR; // of the first call after samplers are made
bool hasMadeSamplers;
int32_t samplersAlive;
void GLAD_API_PTR countCreatedSamplers(GLsizei count, GLuint* samplers) {
    driver().CreateSamplers(count, samplers);
    hasMadeSamplers = true;
    samplersAlive += count;
}
void GLAD_API_PTR countDeletedSamplers(GLsizei count, const GLuint* samplers) {
    driver().DeleteSamplers(count, samplers);
    samplersAlive -= count;
}
GLenum GLAD_API_PTR errorOnceSamplersAreMade() {
    return hasMadeSamplers ? std::exchange(errorOfObjects, GLenum{GL_NO_ERROR}) : driver().GetError();
}

TEST(GlCalls, AContextWhoseObjectsFailIsNotCreated) {
    Replaced replaced;
    replace(replaced, "glCreateSamplers", countCreatedSamplers);
    replace(replaced, "glDeleteSamplers", countDeletedSamplers);
    replace(replaced, "glGetError", errorOnceSamplersAreMade);
    for (const auto& [error, result] :
         {std::pair{GL_OUT_OF_MEMORY, AGAA_ERROR_OUT_OF_MEMORY}, std::pair{GL_INVALID_OPERATION, AGAA_ERROR_DEVICE}}) {
        hasMadeSamplers = false;
        samplersAlive = 0;
        errorOfObjects = GLenum(error);
        std::vector<LogLine> lines;
        const AgaaLog log = logInto(lines);
        OpenGLContextDesc desc = contextDesc(replaced);
        desc.log = &log;
        AgaaContext context = nullptr;
        EXPECT_EQ(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context), result);
        EXPECT_EQ(context, nullptr);
        EXPECT_EQ(samplersAlive, 0);
        expectOneSentence(lines, result, "objects of the context");
    }
    hasMadeSamplers = false;
}

uint32_t clipped; // draws
void GLAD_API_PTR drawArrays(GLenum mode, GLint first, GLsizei count) {
    clipped += driver().IsEnabled(GL_CLIP_DISTANCE0 + 2);
    driver().DrawArrays(mode, first, count);
}

TEST(GlCalls, TheProbeIsNotClipped) {
    Replaced replaced;
    replace(replaced, "glDrawArrays", drawArrays);
    clipped = 0;
    driver().Enable(GL_CLIP_DISTANCE0 + 2);
    const StageContext context(contextDesc(replaced));
    EXPECT_EQ(clipped, 0u);
    EXPECT_TRUE(driver().IsEnabled(GL_CLIP_DISTANCE0 + 2));
    driver().Disable(GL_CLIP_DISTANCE0 + 2);
}

TEST(GlCalls, TimesOfAnEarlierEndAreNotHuge) {
    for (const uint32_t bits : {36u, 64u}) {
        EXPECT_EQ(gl::millisecondsBetween(1'000'000, 3'500'000, bits), 2.5);
        EXPECT_EQ(gl::millisecondsBetween(3'500'000, 1'000'000, bits), -2.5);
    }
}

TEST(GlCalls, CountersOfFewBitsMayWrap) {
    constexpr GLuint64 end = GLuint64(1) << 36;
    EXPECT_EQ(gl::millisecondsBetween(end - 500'000, 2'000'000, 36), 2.5);
    EXPECT_EQ(gl::millisecondsBetween(~GLuint64(0) - 499'999, 2'000'000, 64), 2.5);
}

} // namespace
} // namespace agaa::test
