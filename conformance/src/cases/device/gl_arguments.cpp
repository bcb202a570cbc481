// OpenGL state that a frame needs: textures, and a context in which programs may change.
#include "cases.h"
#include "frame_rig.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

class ScopedTexture {
public:
    ScopedTexture(GLenum target, GLenum format, GLsizei width, GLsizei height) {
        glCreateTextures(target, 1, &name);
        if (target == GL_TEXTURE_2D_ARRAY)
            glTextureStorage3D(name, 1, format, width, height, AGAA_MAX_SHADOW_LAYERS);
        else
            glTextureStorage2D(name, 1, format, width, height);
    }
    ~ScopedTexture() { glDeleteTextures(1, &name); }
    ScopedTexture(const ScopedTexture&) = delete;
    ScopedTexture& operator=(const ScopedTexture&) = delete;
    GLuint name = 0;
};

RecordHook changed(const std::function<void(AgaaGlFrame&)>& change) {
    return [change](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
        AgaaGlFrame copy = *static_cast<const AgaaGlFrame*>(native);
        change(copy);
        return call(view, frame, &copy);
    };
}

void testFormats(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    for (const GLenum format :
         {GL_SRGB8_ALPHA8, GL_RGB8, GL_RGBA4, GL_RGB9_E5, GL_DEPTH_COMPONENT32F, GL_RGBA32UI, GL_RGBA16I}) {
        const ScopedTexture output(GL_TEXTURE_2D, format, 32, 24);
        AgaaFrame frame = rig.nextFrame();
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_UNSUPPORTED,
                            rig.function() + " with an output of format " + std::to_string(format), "outputTexture"},
                           expected, changed([&](AgaaGlFrame& f) { f.outputTexture = output.name; }));
    }
    for (const GLenum format : {GL_RGBA32F, GL_RGBA16F}) {
        const ScopedTexture output(GL_TEXTURE_2D, format, 32, 24);
        AgaaFrame frame = rig.nextFrame();
        test.requireOk(rig.record(frame, changed([&](AgaaGlFrame& f) { f.outputTexture = output.name; })),
                       rig.function() + " with an output of format " + std::to_string(format));
        Image image(size_t(32) * 24 * 4);
        glGetTextureImage(output.name, 0, GL_RGBA, GL_FLOAT, GLsizei(image.size() * sizeof(float)), image.data());
        const float color[] = {expected[0], expected[1], expected[2]};
        expectColor(test, image, 32, {0, 0, 1, 1}, color, 0.001f, "an output of format " + std::to_string(format));
    }
}

void testSizes(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    const GLsizei sizes[][2] = {{31, 24}, {32, 25}, {24, 32}, {64, 48}, {1, 1}};
    for (const auto& size : sizes) {
        const ScopedTexture output(GL_TEXTURE_2D, GL_RGBA32F, size[0], size[1]);
        AgaaFrame frame = rig.nextFrame();
        const std::string what = rig.function() + " with an output of " + std::to_string(size[0]) + "x" +
                                 std::to_string(size[1]) + " for a view of 32x24";
        expectFrameRefused(rig, frame, {AGAA_ERROR_OUT_OF_RANGE, what, "outputTexture"}, expected,
                           changed([&](AgaaGlFrame& f) { f.outputTexture = output.name; }));
    }
}

void testResolvedTextures(Test& test) {
    AgaaResolvedOutputs outputs = AGAA_RESOLVED_OUTPUTS_INIT;
    Rig rig(test, [&](ViewDescription& d) { d.desc.pNext = &outputs; });
    rig.device().setResolvedOutputs(1);
    const Image expected = rig.render();
    struct Row {
        GLenum target, format;
        GLsizei width, height;
        AgaaResult code;
        const char* what;
    };
    for (const Row& row : {Row{GL_TEXTURE_2D, GL_R32F, 31, 24, AGAA_ERROR_OUT_OF_RANGE, "a texture of 31x24"},
                           {GL_TEXTURE_2D, GL_R32F, 32, 23, AGAA_ERROR_OUT_OF_RANGE, "a texture of 32x23"},
                           {GL_TEXTURE_2D, GL_RGBA32UI, 32, 24, AGAA_ERROR_UNSUPPORTED, "a texture of integers"},
                           {GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, 32, 24, AGAA_ERROR_UNSUPPORTED, "a depth texture"},
                           {GL_TEXTURE_2D_ARRAY, GL_R32F, 32, 24, AGAA_ERROR_INVALID_ARGUMENT, "an array"}}) {
        const ScopedTexture texture(row.target, row.format, row.width, row.height);
        AgaaGlResolvedTextures textures = AGAA_GL_RESOLVED_TEXTURES_INIT;
        textures.textures[0] = texture.name;
        AgaaFrame frame = rig.nextFrame();
        expectFrameRefused(rig, frame,
                           {row.code, rig.function() + " with " + row.what + " for an output", "textures[0]",
                            row.target != GL_TEXTURE_2D},
                           expected, changed([&](AgaaGlFrame& f) { f.pNext = &textures; }));
    }
    for (const GLenum format : {GL_R32F, GL_R16, GL_RGBA16F}) {
        const ScopedTexture texture(GL_TEXTURE_2D, format, 40, 30);
        AgaaGlResolvedTextures textures = AGAA_GL_RESOLVED_TEXTURES_INIT;
        textures.textures[0] = texture.name;
        AgaaFrame frame = rig.nextFrame();
        test.requireOk(rig.record(frame, changed([&](AgaaGlFrame& f) { f.pNext = &textures; })),
                       rig.function() + " with an output of format " + std::to_string(format));
    }
    rig.device().setResolvedOutputs(0);
}

void testShadowWithoutDepth(Test& test) {
    Rig rig(test, [](ViewDescription& description) { description.facts.shadowMapCount = 1; });
    const Image expected = rig.render();
    const ScopedTexture map(GL_TEXTURE_2D_ARRAY, GL_RGBA8, 4, 4);
    const AgaaShadow shadow = AGAA_SHADOW_INIT;
    AgaaFrame frame = rig.nextFrame();
    frame.shadows = &shadow;
    frame.shadowCount = 1;
    expectFrameRefused(
        rig, frame,
        {AGAA_ERROR_INVALID_ARGUMENT, rig.function() + " with a shadow map without depth", "shadowTextures[0]"},
        expected, changed([&](AgaaGlFrame& f) { f.shadowTextures[0] = map.name; }));
}

void testReserved(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    if (!isSameVersion(test))
        test.skip("a later library may give the member a meaning.");
    // The first segments need no output, but the struct is checked.
    for (const uint64_t segments :
         {AGAA_SEGMENT_ALL, AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION})
        for (const uint32_t value : {1u, 0xFFFFFFFFu}) {
            AgaaFrame frame = rig.nextFrame();
            frame.segments = segments;
            expectFrameRefused(rig, frame,
                               {AGAA_ERROR_OUT_OF_RANGE,
                                rig.function() + " with AgaaGlFrame::reserved = " + std::to_string(value) +
                                    " and AgaaFrame::segments = " + std::to_string(segments),
                                "reserved"},
                               expected, changed([value](AgaaGlFrame& f) { f.reserved = value; }));
        }
}

// Creates a program whose vertex shader captures a value.
class Feedback {
public:
    Feedback() {
        const char* text = "#version 430\nout float captured;\nvoid main() { captured = 1.0; "
                           "gl_Position = vec4(0.0); }\n";
        const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        program_ = glCreateProgram();
        glAttachShader(program_, shader);
        const char* varying = "captured";
        glTransformFeedbackVaryings(program_, 1, &varying, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program_);
        glDeleteShader(shader);
        glCreateBuffers(1, &buffer_);
        glNamedBufferStorage(buffer_, 1024, nullptr, 0);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_);
        glUseProgram(program_);
        glBeginTransformFeedback(GL_POINTS);
    }
    ~Feedback() {
        glEndTransformFeedback();
        glUseProgram(0);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
        glDeleteBuffers(1, &buffer_);
        glDeleteProgram(program_);
    }
    Feedback(const Feedback&) = delete;
    Feedback& operator=(const Feedback&) = delete;

private:
    GLuint program_ = 0, buffer_ = 0;
};

void testFeedback(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    expectFrameRefused(
        rig, frame,
        {AGAA_ERROR_WRONG_ORDER, rig.function() + " while transform feedback is active", "transform feedback"},
        expected, [](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
            const Feedback active;
            return call(view, f, native);
        });
    frame = rig.nextFrame();
    test.requireOk(rig.record(frame,
                              [](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
                                  const Feedback active;
                                  glPauseTransformFeedback();
                                  const AgaaResult result = call(view, f, native);
                                  glResumeTransformFeedback();
                                  return result;
                              }),
                   rig.function() + " while transform feedback is paused");
    rig.expectNoMessages("a frame while transform feedback is paused");
    expectSame(test, rig.device().readOutput(), expected, 32, "a frame while transform feedback is paused");
}

} // namespace

void addGlArgumentCases(Suite& suite) {
    const std::vector<Backend> gl = {Backend::OpenGl};
    suite.add("agaaGlRecordFrame/AGAA_ERROR_UNSUPPORTED", gl, testFormats);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_UNSUPPORTED/resolved_textures", gl, testResolvedTextures);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_OUT_OF_RANGE/output_size", gl, testSizes);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_INVALID_ARGUMENT/shadow_without_depth", gl, testShadowWithoutDepth);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_WRONG_ORDER/transform_feedback", gl, testFeedback);
    suite.add("AgaaGlFrame.reserved/zero", gl, testReserved);
}

} // namespace agaa::conformance
