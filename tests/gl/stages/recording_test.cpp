// Misuse of frames: an error code, one clear sentence, nothing drawn, nothing lost.
#include "bench.h"
#include "frame_misuse.h"
// The library's own, for its buffer of counters.
#include "gl/view.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace agaa::test {
namespace {

using harness::gl::Texture;

struct Row {
    const char* what;
    AgaaResult expected;
    std::function<void(AgaaFrame&, AgaaGlFrame&)> spoil;
};

Texture texture(GLenum target, GLenum format, GLsizei width, GLsizei height) {
    const GladGLContext& gl = sharedEgl().gl();
    Texture made = harness::gl::createTexture(gl, target);
    if (target == GL_TEXTURE_2D)
        gl.TextureStorage2D(made.get(), 1, format, width, height);
    else
        gl.TextureStorage3D(made.get(), 1, format, width, height, 1);
    return made;
}

// A refused frame draws nothing; the next one is as good as ever.
TEST(GlRecording, MisuseIsRefusedAndChangesNothing) {
    Bench bench;
    const std::vector<float> expected = bench.picture();
    const Texture small = texture(GL_TEXTURE_2D, GL_RGBA16F, 47, 32);
    const Texture integer = texture(GL_TEXTURE_2D, GL_RGBA32UI, 48, 32);
    const Texture srgb = texture(GL_TEXTURE_2D, GL_SRGB8_ALPHA8, 48, 32);
    const Texture layered = texture(GL_TEXTURE_2D_ARRAY, GL_RGBA16F, 48, 32);
    const Texture flat = texture(GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, 4, 4);
    std::vector<Row> rows = {
        {"backend: wrong sType", AGAA_ERROR_STRUCT, [](auto&, auto& gl) { gl.sType = 9; }},
        {"backend: wrong structSize", AGAA_ERROR_STRUCT, [](auto&, auto& gl) { gl.structSize = 0; }},
        {"backend: unknown struct", AGAA_ERROR_UNKNOWN_STRUCT,
         [](auto&, auto& gl) { gl.pNext = &unknownStruct; }},
        {"backend: reserved", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& gl) { gl.reserved = 1; }},
        {"no output", AGAA_ERROR_INVALID_ARGUMENT, [](auto&, auto& gl) { gl.outputTexture = 0; }},
        {"output of no name", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto&, auto& gl) { gl.outputTexture = 54321; }},
        {"output of another size", AGAA_ERROR_OUT_OF_RANGE,
         [&](auto&, auto& gl) { gl.outputTexture = small.get(); }},
        {"output of integers", AGAA_ERROR_UNSUPPORTED,
         [&](auto&, auto& gl) { gl.outputTexture = integer.get(); }},
        {"output of sRGB", AGAA_ERROR_UNSUPPORTED,
         [&](auto&, auto& gl) { gl.outputTexture = srgb.get(); }},
        {"output of layers", AGAA_ERROR_INVALID_ARGUMENT,
         [&](auto&, auto& gl) { gl.outputTexture = layered.get(); }},
        {"no shadow map", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto&, auto& gl) { gl.shadowTextures[0] = 0; }},
        {"shadow map without layers", AGAA_ERROR_INVALID_ARGUMENT,
         [&](auto&, auto& gl) { gl.shadowTextures[0] = flat.get(); }},
        {"shadow map of colours", AGAA_ERROR_INVALID_ARGUMENT,
         [&](auto&, auto& gl) { gl.shadowTextures[0] = layered.get(); }},
        {"composites without the view's flag", AGAA_ERROR_OUT_OF_RANGE,
         [](auto& f, auto&) { f.background[3] = 0; }},
    };
    for (const FrameMisuse& misuse : frameMisuses)
        rows.push_back({misuse.what, misuse.expected, [&](auto& frame, auto&) {
                            misuse.spoil(frame, bench.light, bench.shadow);
                        }});
    const AgaaShadow shadow = bench.shadow;
    const AgaaLight light = bench.light;
    bench.view.drawCalls = 0;
    for (const Row& row : rows) {
        AgaaFrame frame = bench.frame();
        AgaaGlFrame glFrame = bench.glFrame();
        row.spoil(frame, glFrame);
        EXPECT_EQ(bench.record(frame, glFrame), row.expected) << row.what;
        expectOneSentence(bench.context.lines, row.expected, row.what);
        bench.shadow = shadow;
        bench.light = light;
    }
    EXPECT_EQ(bench.view.drawCalls, 0u);
    EXPECT_EQ(bench.view.image(), expected);
    sharedEgl().takeMessages(); // drivers may tell of textures of a wrong target
    EXPECT_EQ(bench.picture(), expected);
}

// A texture of a wrong target raises an error; one that was pending is not lost with it.
TEST(GlRecording, ErrorsOfTheHostAreTold) {
    Bench bench;
    const Texture layered = texture(GL_TEXTURE_2D_ARRAY, GL_RGBA16F, 48, 32);
    AgaaGlFrame glFrame = bench.glFrame();
    glFrame.outputTexture = layered.get();
    sharedEgl().gl().Enable(GL_TEXTURE0);
    EXPECT_EQ(bench.record(bench.frame(), glFrame), AGAA_ERROR_INVALID_ARGUMENT);
    ASSERT_EQ(bench.context.lines.size(), 2u);
    EXPECT_NE(bench.context.lines[0].text.find("0x0500"), std::string::npos)
        << bench.context.lines[0].text;
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

GLuint programWithFeedback(const GladGLContext& gl) {
    const char* text = "#version 430\nvoid main() { gl_Position = vec4(0.0); }\n";
    const char* varying = "gl_Position";
    const GLuint program = gl.CreateProgram(), shader = gl.CreateShader(GL_VERTEX_SHADER);
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.TransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(program);
    gl.DeleteShader(shader);
    return program;
}

TEST(GlRecording, TransformFeedbackMustPause) {
    const GladGLContext& gl = sharedEgl().gl();
    Bench bench;
    const std::vector<float> expected = bench.picture();
    const GLuint program = programWithFeedback(gl);
    const harness::gl::Buffer buffer = harness::gl::createBuffer(gl);
    gl.NamedBufferData(buffer.get(), 256, nullptr, GL_STATIC_DRAW);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.get());
    gl.UseProgram(program);
    gl.BeginTransformFeedback(GL_POINTS);
    bench.view.drawCalls = 0;
    const AgaaFrame frame = bench.frame();
    EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_ERROR_WRONG_ORDER);
    expectOneSentence(bench.context.lines, AGAA_ERROR_WRONG_ORDER, "active", "transform feedback");
    EXPECT_EQ(bench.view.drawCalls, 0u);
    gl.PauseTransformFeedback();
    EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_OK);
    EXPECT_EQ(bench.view.image(), expected);
    gl.ResumeTransformFeedback();
    gl.EndTransformFeedback();
    gl.UseProgram(0);
    gl.DeleteProgram(program);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    EXPECT_EQ(sharedEgl().takeMessages(), "");
}

TEST(GlRecording, NullPointersAreRefused) {
    Bench bench;
    const AgaaFrame frame = bench.frame();
    const AgaaGlFrame glFrame = bench.glFrame();
    const AgaaView view = bench.view.get();
    EXPECT_EQ(agaaGlRecordFrame(nullptr, &frame, &glFrame), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlRecordFrame(view, nullptr, &glFrame), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlRecordFrame(view, &frame, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    uint32_t count = 0;
    EXPECT_EQ(agaaGlGetDrawPasses(view, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetDrawPasses(nullptr, &count, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaGlDrawPass passes[2] = {AGAA_GL_DRAW_PASS_INIT, AGAA_GL_DRAW_PASS_INIT};
    count = 1;
    EXPECT_EQ(agaaGlGetDrawPasses(view, &count, passes), AGAA_ERROR_BUFFER_TOO_SMALL);
    passes[1].structSize = 1;
    count = 2;
    EXPECT_EQ(agaaGlGetDrawPasses(view, &count, passes), AGAA_ERROR_STRUCT);
    AgaaGlSurface surface = AGAA_GL_SURFACE_INIT;
    EXPECT_EQ(agaaGlGetSurface(nullptr, "depth", &surface), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetSurface(view, nullptr, &surface), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetSurface(view, "depth", nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetSurface(view, "nothing", &surface), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetSurface(view, "depth", &surface), AGAA_OK);
    EXPECT_EQ(surface.width, 48 * surface.scaleX);
}

// The same frame can be recorded after all.
TEST(GlRecording, AFailingCallbackLeavesTheOutput) {
    Bench bench;
    const std::vector<float> expected = bench.picture();
    for (const uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE}) {
        const AgaaFrame frame = bench.frame();
        bench.view.drawResults[pass] = -77;
        EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_ERROR_CALLBACK);
        expectOneSentence(bench.context.lines, AGAA_ERROR_CALLBACK, "callback", "-77");
        EXPECT_EQ(bench.view.image(), expected);
        bench.view.drawResults.clear();
        EXPECT_EQ(bench.record(frame, bench.glFrame()), AGAA_OK);
        EXPECT_EQ(bench.view.image(), expected);
    }
}

// The contract forbids it, but the SDK can still give the host its state back.
TEST(GlRecording, CallbacksThatThrowHaveFailed) {
    struct HostState {
        int depth = 0;
        bool throws = false;
    } state;
    AgaaGlContextDesc desc = contextDesc();
    desc.statePolicy = AGAA_GL_STATE_CALLBACKS;
    desc.stateUser = &state;
    desc.pushState = [](void* user) -> AgaaResult {
        ++static_cast<HostState*>(user)->depth;
        return AGAA_OK;
    };
    desc.popState = [](void* user) -> AgaaResult {
        auto& host = *static_cast<HostState*>(user);
        --host.depth;
        if (host.throws)
            throw std::runtime_error("from popState");
        return AGAA_OK;
    };
    Bench bench(desc);
    const std::vector<float> expected = bench.picture();
    const auto throwing = [](void*, const AgaaDrawTarget*) -> AgaaResult { throw std::runtime_error("from a draw"); };
    for (bool isDraw : {true, false}) {
        SCOPED_TRACE(isDraw);
        AgaaFrame frame = bench.frame();
        if (isDraw)
            frame.draw = throwing;
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
    AgaaGlContextDesc desc = contextDesc();
    desc.framesInFlight = 2;
    Bench bench(desc);
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

// Fragments add to the low word of a count, which has a high word too. The test puts the low word near its end after
// the first segment, which clears it.
TEST(GlRecording, CountsOfFragmentsCarryIntoTheirHighWord) {
    for (uint32_t storage : {AGAA_GL_STORAGE_BUFFERS, AGAA_GL_STORAGE_IMAGES}) {
        SCOPED_TRACE(storage);
        AgaaGlContextDesc desc = contextDesc();
        desc.storage = storage;
        Bench bench(desc);
        std::vector<Triangle> triangles = randomTriangles({.triangles = 20}, 41);
        for (Triangle& triangle : triangles)
            triangle.material.diffuse.y = nan;
        bench.view.setTriangles(triangles);
        bench.picture();
        const uint64_t once = bench.view.statistics().counters.sanitised;
        ASSERT_GT(once, 2u);
        const auto& view = static_cast<const agaa::gl::View&>(*bench.view.get());
        const auto& resources = view.plan.resources;
        const auto counters = std::find_if(resources.begin(), resources.end(),
                                           [](const agaa::Resource& r) { return r.name == "counters"; });
        const GLuint buffer = view.resources->buffer(agaa::ResourceId(counters - resources.begin()), 0);
        AgaaFrame frame = bench.frame();
        frame.segments = AGAA_SEGMENT_PREPASS;
        ASSERT_EQ(bench.record(frame, bench.glFrame()), AGAA_OK);
        const GLuint start = 0xFFFFFFFEu;
        sharedEgl().gl().ClearNamedBufferSubData(buffer, GL_R32UI, offsetof(agaa::CounterBuffer, counts[agaa::AGAA_COUNT_SANITISED]), sizeof start,
                                                 GL_RED_INTEGER, GL_UNSIGNED_INT, &start);
        frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
        ASSERT_EQ(bench.record(frame, bench.glFrame()), AGAA_OK);
        EXPECT_EQ(bench.view.statistics().counters.sanitised, start + once);
    }
}

TEST(GlRecording, FramesAndSegmentsHaveAnOrder) {
    Bench bench;
    const std::vector<float> expected = bench.picture();
    AgaaFrame frame = bench.frame();
    const auto expect = [&](AgaaFrame& wanted, uint64_t segments, AgaaResult result, const char* what) {
        wanted.segments = segments;
        EXPECT_EQ(bench.record(wanted, bench.glFrame()), result) << what;
        if (result != AGAA_OK)
            expectOneSentence(bench.context.lines, result, what);
    };
    expect(frame, AGAA_SEGMENT_GENERATION, AGAA_ERROR_WRONG_ORDER, "begins in the middle");
    expect(frame, AGAA_SEGMENT_PREPASS, AGAA_OK, "begins");
    expect(frame, AGAA_SEGMENT_PREPASS, AGAA_ERROR_WRONG_ORDER, "twice");
    expect(frame, AGAA_SEGMENT_SHADING, AGAA_ERROR_WRONG_ORDER, "one left out");
    AgaaFrame elsewhere = frame;
    elsewhere.projection[0] *= 2;
    expect(elsewhere, AGAA_SEGMENT_GENERATION, AGAA_ERROR_OUT_OF_RANGE, "another camera");
    AgaaFrame otherDither = frame;
    ++otherDither.ditherFrame;
    expect(otherDither, AGAA_SEGMENT_GENERATION, AGAA_ERROR_OUT_OF_RANGE, "another ditherFrame");
    expect(frame, AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING, AGAA_OK, "the rest");
    expect(frame, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "the same frame");
    AgaaFrame earlier = frame;
    --earlier.frameIndex;
    --earlier.completedFrame;
    expect(earlier, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "an earlier frame");
    EXPECT_EQ(bench.view.image(), expected);
    AgaaFrame left = bench.frame();
    expect(left, AGAA_SEGMENT_PREPASS, AGAA_OK, "begun and given up");
    EXPECT_EQ(bench.picture(), expected);
}

// The slots of frames in flight, and the statistics that they keep.
TEST(GlRecording, FramesInFlightAreARing) {
    for (const uint32_t slots : {1u, 3u, 8u}) {
        AgaaGlContextDesc desc = contextDesc();
        desc.framesInFlight = slots;
        Bench bench(desc);
        const auto record = [&](uint64_t completed) {
            AgaaFrame frame = bench.frame();
            frame.completedFrame = completed;
            return bench.record(frame, bench.glFrame());
        };
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 9, &statistics), AGAA_NOT_READY);
        EXPECT_TRUE(bench.context.lines.empty());
        std::vector<uint64_t> visible(slots + 1); // each frame shows more
        for (uint32_t i = 1; i <= slots; ++i) {
            const float width = 4 * float(i);
            bench.view.setTriangles(rectangle(-width / 48, -0.5f, width / 48, 0.5f, 2, Material{}));
            EXPECT_EQ(record(0), AGAA_OK) << i;
        }
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
        for (uint32_t i = 1; i <= slots; ++i) {
            EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), i, &statistics), AGAA_OK);
            EXPECT_EQ(statistics.frameIndex, i);
            visible[i] = statistics.counters.visible;
            EXPECT_GT(visible[i], visible[i - 1]);
        }
        EXPECT_EQ(record(0), AGAA_ERROR_WRONG_ORDER) << "one too many in flight";
        expectOneSentence(bench.context.lines, AGAA_ERROR_WRONG_ORDER, "in flight");
        EXPECT_EQ(record(1), AGAA_OK);
        EXPECT_EQ(statistics.driverBytes, 0u);
        statistics.structSize = 4;
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_ERROR_STRUCT);
    }
}

TEST(GlRecording, SegmentsInCallsOfTheirOwnAgree) {
    for (const char* technique : {"single", "ssaa", "agaa"}) {
        ViewSettings settings = benchSettings();
        settings.config.technique = technique;
        settings.config.samples = technique == std::string("single") ? 1 : 8;
        Bench bench(contextDesc(), sharedEgl(), settings);
        const std::vector<float> expected = bench.picture();
        bench.view.render(bench.frame(), bench.glFrame(), true);
        EXPECT_EQ(bench.view.image(), expected) << technique;
    }
}

} // namespace
} // namespace agaa::test
