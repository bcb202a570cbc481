// The recording of frames by OpenGL: what all graphics APIs share, and what errors and state of OpenGL's add.
#include "bench.h"
#include "recording_cases.h"

#include <stdexcept>

namespace agaa::test {
namespace {

using harness::gl::Texture;

Texture texture(GLenum target, GLenum format, GLsizei width, GLsizei height) {
    const GladGLContext& gl = sharedEgl().gl();
    Texture made = harness::gl::createTexture(gl, target);
    if (target == GL_TEXTURE_2D)
        gl.TextureStorage2D(made.get(), 1, format, width, height);
    else
        gl.TextureStorage3D(made.get(), 1, format, width, height, 1);
    return made;
}

struct RecordingHost : OpenGLHost {
    static constexpr bool driverTellsBytes = false;
    static std::vector<OpenGLContextDesc> storages() {
        return {changed([](auto& desc) { desc.device.storage = AGAA_GL_STORAGE_BUFFERS; }),
                changed([](auto& desc) { desc.device.storage = AGAA_GL_STORAGE_IMAGES; })};
    }
    static void spoilSecondMap(AgaaGlFrame& frame) { frame.shadowTextures[1] = deletedTexture(sharedEgl().gl()); }

    static void setCounter(const StageView& view, const AgaaGlFrame&, size_t offset, GLuint value) {
        const GLuint buffer = view.executor().resources->buffer(findResource(view.plan(), "counters"), 0);
        sharedEgl().gl().ClearNamedBufferSubData(buffer, GL_R32UI, GLintptr(offset), sizeof value, GL_RED_INTEGER,
                                                 GL_UNSIGNED_INT, &value);
    }
};
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, RecordingCases, RecordingHost);

// A texture of a wrong target raises an error; one that was pending is not lost with it.
TEST(GlRecording, ErrorsOfTheHostAreTold) {
    Bench bench;
    const Texture layered = texture(GL_TEXTURE_2D_ARRAY, GL_RGBA16F, 48, 32);
    AgaaGlFrame glFrame = bench.glFrame();
    glFrame.outputTexture = layered.get();
    sharedEgl().gl().Enable(GL_TEXTURE0);
    EXPECT_EQ(bench.record(bench.frame(), glFrame), AGAA_ERROR_INVALID_ARGUMENT);
    ASSERT_EQ(bench.context.lines.size(), 2u);
    EXPECT_NE(bench.context.lines[0].text.find("0x0500"), std::string::npos) << bench.context.lines[0].text;
    EXPECT_EQ(sharedEgl().gl().GetError(), GLenum{GL_NO_ERROR});
    sharedEgl().takeMessages();
    EXPECT_EQ(bench.record(bench.frame(), glFrame), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(bench.context.lines, AGAA_ERROR_INVALID_ARGUMENT, "nothing pending");
    sharedEgl().takeMessages();
    // Errors that no check comes across stay the host's.
    sharedEgl().gl().Enable(GL_TEXTURE0);
    EXPECT_EQ(bench.record(bench.frame(), bench.glFrame()), AGAA_OK);
    EXPECT_EQ(sharedEgl().gl().GetError(), GLenum{GL_INVALID_ENUM});
    sharedEgl().takeMessages();
}

// The SDK can still give the host its state back.
TEST(GlRecording, CallbacksThatThrowHaveFailed) {
    struct HostState {
        int depth = 0;
        bool throws = false;
    } state;
    OpenGLContextDesc desc = contextDesc();
    desc.device.statePolicy = AGAA_GL_STATE_CALLBACKS;
    desc.device.stateUser = &state;
    desc.device.pushState = [](void* user) -> AgaaResult {
        ++static_cast<HostState*>(user)->depth;
        return AGAA_OK;
    };
    desc.device.popState = [](void* user) -> AgaaResult {
        auto& host = *static_cast<HostState*>(user);
        --host.depth;
        if (host.throws)
            throw std::runtime_error("from popState");
        return AGAA_OK;
    };
    Bench bench(benchSettings(), desc);
    const std::vector<float> expected = bench.picture();
    for (bool isDraw : {true, false}) {
        SCOPED_TRACE(isDraw);
        AgaaFrame frame = bench.frame();
        if (isDraw)
            frame.draw = throwingDraw;
        state.throws = !isDraw;
        EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_ERROR_CALLBACK);
        expectOneSentence(bench.context.lines, AGAA_ERROR_CALLBACK, "throwing");
        EXPECT_EQ(state.depth, 0);
        state.throws = false;
        EXPECT_EQ(bench.view.image(), expected);
        EXPECT_EQ(bench.picture(), expected);
    }
}

// What ran of it has overwritten the counters and times of the frame that had its slot.
TEST(GlRecording, AFailedFrameTakesItsSlot) {
    OpenGLContextDesc desc = contextDesc();
    desc.framesInFlight = 2;
    Bench bench(benchSettings(), desc);
    bench.picture();
    bench.picture();
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_OK);
    const AgaaFrame frame = bench.frame();
    bench.view.drawResults[AGAA_DRAW_PASS_AGGREGATE] = AGAA_ERROR_DEVICE;
    EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_ERROR_CALLBACK);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_NOT_READY);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 2, &statistics), AGAA_OK);
    bench.view.drawResults.clear();
    EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_OK);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 3, &statistics), AGAA_OK);
    EXPECT_EQ(statistics.frameIndex, 3u);
}

TEST(GlRecording, SegmentsInCallsOfTheirOwnAgree) {
    for (const char* technique : {"single", "ssaa", "agaa"}) {
        ViewSettings settings = benchSettings();
        settings.config.technique = technique;
        settings.config.samples = technique == std::string("single") ? 1 : 8;
        Bench bench(settings);
        const std::vector<float> expected = bench.picture();
        bench.view.render(bench.frame(), bench.glFrame(), true);
        EXPECT_EQ(bench.view.image(), expected) << technique;
    }
}

} // namespace
} // namespace agaa::test
