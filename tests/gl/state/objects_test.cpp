// Bindings whose objects, ranges or surroundings are out of the ordinary.
#include "gl/query_buffer.h"
#include "support.h"

namespace agaa::test {
namespace {

class ObjectsTest : public BothProfiles {
protected:
    // Captures, scrambles and restores; the state must be as it was.
    void expectRestored() {
        HostObjects others(gl());
        gl::StateGuard guard(gl(), testScope(), GetParam());
        const auto before = read();
        guard.capture();
        for (uint32_t seed = 0; seed < 4; ++seed) {
            scrambleState(guard.context(), others, seed);
            guard.restore();
            EXPECT_EQ(joined(differences(before, read())), "") << "seed " << seed;
        }
    }
};

TEST_P(ObjectsTest, deletedObjectsBecomeNone) {
    for (uint32_t seed = 0; seed < 16; ++seed) {
        HostObjects deleted(gl()), others(gl());
        gl::StateGuard guard(gl(), testScope(), GetParam());
        scrambleState(guard.context(), deleted, seed);
        const auto before = read();
        guard.capture();
        scrambleState(guard.context(), others, seed + 1);
        deleted.deleteAll();
        guard.restore();
        ASSERT_EQ(context.takeMessages(), "") << "seed " << seed;
        const auto after = read();
        for (size_t i = 0; i < before.size(); ++i) {
            const bool binding =
                before[i].name.find("_BINDING") != std::string::npos || before[i].name == "GL_CURRENT_PROGRAM";
            // The default vertex array keeps the deleted buffer if another was bound at the
            // deletion.
            if (!binding ||
                (before[i].name == "GL_ELEMENT_ARRAY_BUFFER_BINDING" && before[i].value == after[i].value)) {
                EXPECT_EQ(before[i].value, after[i].value) << before[i].name;
            } else {
                EXPECT_EQ(after[i].value.substr(0, after[i].value.find(' ')), "0") << after[i].name;
            }
        }
    }
}

TEST_P(ObjectsTest, buffersWithRangesAndWithout) {
    HostObjects objects(gl());
    for (const GLenum target : {GLenum{GL_UNIFORM_BUFFER}, GLenum{GL_SHADER_STORAGE_BUFFER}}) {
        gl().BindBufferBase(target, 0, objects.buffers[0]);
        gl().BindBufferRange(target, 2, objects.buffers[1], 0, HostObjects::kBufferBytes);
        gl().BindBufferRange(target, 5, objects.buffers[1], 512, HostObjects::kBufferBytes - 512);
        gl().BindBufferRange(target, 9 - (target == GL_SHADER_STORAGE_BUFFER ? 2 : 0), objects.buffers[2], 1024, 16);
        gl().BindBuffer(target, objects.buffers[0]); // not the last one bound to an index
    }
    expectRestored();
}

TEST_P(ObjectsTest, rangesBeyondTheBuffer) {
    HostObjects objects(gl());
    // Legal at binding: the buffer may grow before it is used.
    gl().BindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, objects.buffers[0], 256, GLsizeiptr{1} << 30);
    expectRestored();
}

// Contexts of 4.3 have the binding by an extension.
TEST_P(ObjectsTest, queryBufferOfAnExtension) {
    if (!gl().ARB_query_buffer_object)
        GTEST_SKIP() << "the context has not the extension";
    HostObjects objects(gl());
    GladGLContext older = gl();
    older.VERSION_4_4 = 0;
    gl().BindBuffer(GL_QUERY_BUFFER, objects.buffers[0]);
    const auto bound = [&] {
        GLint name = -1;
        gl().GetIntegerv(GL_QUERY_BUFFER_BINDING, &name);
        return GLuint(name);
    };
    {
        const gl::NoQueryBuffer none(older);
        EXPECT_EQ(bound(), 0u);
    }
    EXPECT_EQ(bound(), objects.buffers[0]);
    gl::StateGuard guard(older, testScope(), GetParam());
    guard.capture();
    gl().BindBuffer(GL_QUERY_BUFFER, objects.buffers[1]);
    guard.restore();
    EXPECT_EQ(bound(), objects.buffers[0]);
}

TEST_P(ObjectsTest, noVertexArray) {
    gl().BindVertexArray(0);
    expectRestored();
}

TEST_P(ObjectsTest, indexBufferOfTheDefaultVertexArray) {
    if (!GetParam())
        GTEST_SKIP() << "core contexts have no default vertex array";
    HostObjects objects(gl());
    gl().BindBuffer(GL_ELEMENT_ARRAY_BUFFER, objects.buffers[0]);
    gl().BindBuffer(GL_ARRAY_BUFFER, objects.buffers[1]);
    expectRestored();
}

TEST_P(ObjectsTest, vertexArrayKeepsADeletedIndexBuffer) {
    HostObjects objects(gl());
    gl().VertexArrayElementBuffer(objects.vertexArrays[0], objects.buffers[0]);
    gl().BindVertexArray(objects.vertexArrays[1]);
    gl().DeleteBuffers(1,
                       &objects.buffers[0]); // stays attached to a vertex array that is not bound
    gl().BindVertexArray(objects.vertexArrays[0]);
    GLint before = 0, after = 0;
    gl().GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &before);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    guard.capture();
    gl().BindVertexArray(0);
    guard.restore();
    gl().GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &after);
    EXPECT_EQ(before, after);
}

TEST_P(ObjectsTest, programPipelineWithoutAProgram) {
    HostObjects objects(gl());
    gl().UseProgram(0);
    gl().BindProgramPipeline(objects.pipelines[1]);
    expectRestored();
}

TEST_P(ObjectsTest, programPipelineBehindAProgram) {
    HostObjects objects(gl());
    gl().UseProgram(objects.programs[0]);
    gl().BindProgramPipeline(objects.pipelines[1]);
    expectRestored();
}

TEST_P(ObjectsTest, noProgramPipelineBehindAProgram) {
    HostObjects objects(gl()), others(gl());
    gl().UseProgram(objects.programs[0]);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    const auto before = read();
    guard.capture();
    gl().BindProgramPipeline(others.pipelines[0]);
    guard.restore();
    EXPECT_EQ(joined(differences(before, read())), "");
    gl().BindProgramPipeline(others.pipelines[0]);
    others.deleteAll();
    guard.restore();
    EXPECT_EQ(joined(differences(before, read())), "");
    gl().UseProgram(0);
}

TEST_P(ObjectsTest, programThatNoLongerLinks) {
    HostObjects objects(gl());
    const GLuint program = objects.programs[0];
    gl().UseProgram(program);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    guard.capture();
    const char* source = "#version 430\nvoid missing();\nvoid main() { missing(); }\n";
    const GLuint shader = gl().CreateShader(GL_FRAGMENT_SHADER);
    gl().ShaderSource(shader, 1, &source, nullptr);
    gl().CompileShader(shader);
    gl().AttachShader(program, shader);
    gl().LinkProgram(program);
    gl().DeleteShader(shader);
    GLint linked = GL_TRUE, used = -1;
    gl().GetProgramiv(program, GL_LINK_STATUS, &linked);
    ASSERT_EQ(linked, GL_FALSE);
    context.takeMessages(); // drivers may tell of the failure
    gl().UseProgram(objects.programs[1]);
    guard.restore();
    gl().GetIntegerv(GL_CURRENT_PROGRAM, &used);
    EXPECT_EQ(used, 0);
}

TEST_P(ObjectsTest, nameGivenToATextureOfAnotherTarget) {
    if (!GetParam())
        GTEST_SKIP() << "core contexts choose names themselves";
    HostObjects objects(gl());
    const GLuint name = objects.textures[0];
    gl().BindTextureUnit(1, name);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    guard.capture();
    gl().DeleteTextures(1, &name);
    gl().ActiveTexture(GL_TEXTURE7);
    gl().BindTexture(GL_TEXTURE_3D, name);
    gl().BindTextureUnit(1, objects.textures[1]);
    guard.restore();
    GLint bound = -1;
    gl().ActiveTexture(GL_TEXTURE1);
    gl().GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 0);
}

TEST_P(ObjectsTest, severalTargetsOfOneTextureUnit) {
    HostObjects objects(gl());
    gl().ActiveTexture(GL_TEXTURE3);
    gl().BindTexture(GL_TEXTURE_2D, objects.textures[0]);
    gl().BindTexture(GL_TEXTURE_2D_MULTISAMPLE, objects.multisampled[0]);
    gl().BindTexture(GL_TEXTURE_2D_ARRAY, objects.arrays[0]);
    gl().BindTexture(GL_TEXTURE_BUFFER, objects.bufferTextures[0]);
    gl().BindSampler(3, objects.samplers[0]);
    gl().ActiveTexture(GL_TEXTURE12);
    expectRestored();
}

TEST_P(ObjectsTest, imagesLayeredAndNot) {
    HostObjects objects(gl());
    gl().BindImageTexture(0, objects.arrays[0], 1, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA8);
    gl().BindImageTexture(1, objects.arrays[0], 2, GL_FALSE, 3, GL_READ_ONLY, GL_R32UI);
    gl().BindImageTexture(2, objects.textures[0], 3, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8UI);
    expectRestored();
}

// Queries clamp the reference to the bits of the framebuffer's stencil: none here.
TEST_P(ObjectsTest, stencilReferenceWithoutAStencil) {
    HostObjects objects(gl());
    gl().StencilFuncSeparate(GL_FRONT, GL_LESS, 200, 0xF0u);
    gl().StencilFuncSeparate(GL_BACK, GL_GREATER, 100, 0x0Fu);
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, objects.framebuffers[0]);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    guard.capture();
    gl().StencilFunc(GL_ALWAYS, 1, 1);
    guard.restore();
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, objects.framebuffers.back());
    GLint front = 0, back = 0;
    gl().GetIntegerv(GL_STENCIL_REF, &front);
    gl().GetIntegerv(GL_STENCIL_BACK_REF, &back);
    EXPECT_EQ(front, 200);
    EXPECT_EQ(back, 100);
}

// Queries clamp colours while those of fragments are clamped.
TEST_P(ObjectsTest, clearColorWhileFragmentsAreClamped) {
    if (!GetParam())
        GTEST_SKIP() << "core contexts do not clamp fragments";
    gl().ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
    gl().ClearColor(5.0f, -2.0f, 0.5f, 7.0f);
    gl::StateGuard guard(gl(), testScope(), GetParam());
    guard.capture();
    gl().ClearColor(0, 0, 0, 0);
    guard.restore();
    gl().ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    GLfloat color[4]{};
    gl().GetFloatv(GL_COLOR_CLEAR_VALUE, color);
    EXPECT_EQ(color[0], 5.0f);
    EXPECT_EQ(color[1], -2.0f);
    EXPECT_EQ(color[3], 7.0f);
}

INSTANTIATE_TEST_SUITE_P(gl, ObjectsTest, testing::Bool(), profileName);

} // namespace
} // namespace agaa::test
