// What OpenGL's create calls are asked for, and that everything created is deleted.
#include "bench.h"
#include "payload_cases.h"

#include <cstdlib>
#include <cstring>
#include <new>
#include <set>

#pragma GCC diagnostic ignored "-Wmismatched-new-delete" // GCC 12 does not see that both are replaced

// Memory of this size is not to be had by this thread.
static thread_local size_t missingSize = 0;

void* operator new(size_t size) {
    void* block = size != 0 && size == missingSize ? nullptr : std::malloc(size != 0 ? size : 1);
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, size_t) noexcept { std::free(block); }

namespace agaa::test {
namespace {

Created created;
std::multiset<std::pair<std::string, GLuint>> alive; // kind and name
bool drawsNothing = false; // shaders that do nothing replace those of the passes, which tests of frames compile

// From the OpenGL specification, not from the library.
uint64_t bytesOf(GLenum format) {
    switch (format) {
    case GL_R8:
    case GL_R8UI:
        return 1;
    case GL_RG8:
    case GL_R16:
    case GL_R16UI:
        return 2;
    case GL_RGBA8:
    case GL_RGB10_A2:
    case GL_RG16:
    case GL_R32UI:
    case GL_DEPTH24_STENCIL8:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_DEPTH32F_STENCIL8:
        return 5;
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RG32UI:
        return 8;
    case GL_RGBA32UI:
        return 16;
    default:
        ADD_FAILURE() << "format " << format << " is not in the test's table";
        return 0;
    }
}

const GladGLContext& real() { return sharedEgl().gl(); }

void GLAD_API_PTR textureStorage(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    EXPECT_EQ(levels, 1);
    created.imageBytes += uint64_t(width) * uint64_t(height) * bytesOf(format);
    real().TextureStorage2D(texture, levels, format, width, height);
}

void GLAD_API_PTR textureStorageMultisample(GLuint texture, GLsizei samples, GLenum format, GLsizei width,
                                            GLsizei height, GLboolean fixed) {
    created.imageBytes += uint64_t(width) * uint64_t(height) * uint64_t(samples) * bytesOf(format);
    real().TextureStorage2DMultisample(texture, samples, format, width, height, fixed);
}

void GLAD_API_PTR bufferData(GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) {
    ++created.bufferSizes[uint64_t(size)];
    real().NamedBufferData(buffer, size, data, usage);
}

void GLAD_API_PTR shaderSource(GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
    const GLchar* nothing = "#version 430\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
    if (drawsNothing)
        real().ShaderSource(shader, 1, &nothing, nullptr);
    else
        real().ShaderSource(shader, count, texts, lengths);
}

void born(const char* kind, GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i)
        alive.emplace(kind, names[i]);
}

void gone(const char* kind, GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i) {
        const auto found = alive.find({kind, names[i]});
        EXPECT_TRUE(names[i] == 0 || found != alive.end()) << kind << " " << names[i];
        if (found != alive.end())
            alive.erase(found);
    }
}

void GLAD_API_PTR createTextures(GLenum target, GLsizei count, GLuint* names) {
    real().CreateTextures(target, count, names);
    born("texture", count, names);
}
void GLAD_API_PTR deleteTextures(GLsizei count, const GLuint* names) {
    gone("texture", count, names);
    real().DeleteTextures(count, names);
}
void GLAD_API_PTR createQueries(GLenum target, GLsizei count, GLuint* names) {
    real().CreateQueries(target, count, names);
    born("query", count, names);
}
void GLAD_API_PTR deleteQueries(GLsizei count, const GLuint* names) {
    gone("query", count, names);
    real().DeleteQueries(count, names);
}
GLuint GLAD_API_PTR createProgram() {
    const GLuint name = real().CreateProgram();
    born("program", 1, &name);
    return name;
}
void GLAD_API_PTR deleteProgram(GLuint name) {
    gone("program", 1, &name);
    real().DeleteProgram(name);
}
GLuint GLAD_API_PTR createShader(GLenum stage) {
    const GLuint name = real().CreateShader(stage);
    born("shader", 1, &name);
    return name;
}
void GLAD_API_PTR deleteShader(GLuint name) {
    gone("shader", 1, &name);
    real().DeleteShader(name);
}

// Kinds whose create and delete calls have the same form.
#define AGAA_TEST_KIND(Kind, kind)                                                                                     \
    void GLAD_API_PTR create##Kind(GLsizei count, GLuint* names) {                                                     \
        real().Create##Kind(count, names);                                                                             \
        born(kind, count, names);                                                                                      \
    }                                                                                                                  \
    void GLAD_API_PTR delete##Kind(GLsizei count, const GLuint* names) {                                               \
        gone(kind, count, names);                                                                                      \
        real().Delete##Kind(count, names);                                                                             \
    }
AGAA_TEST_KIND(Buffers, "buffer")
AGAA_TEST_KIND(Framebuffers, "framebuffer")
AGAA_TEST_KIND(Samplers, "sampler")
AGAA_TEST_KIND(VertexArrays, "vertex array")
#undef AGAA_TEST_KIND

AgaaGlFunction AGAA_CALL interceptingProcAddr(void* user, const char* name) {
    const std::pair<const char*, AgaaGlFunction> replaced[] = {
#define AGAA_TEST_ROW(name, function) {name, reinterpret_cast<AgaaGlFunction>(function)}
        AGAA_TEST_ROW("glTextureStorage2D", textureStorage),
        AGAA_TEST_ROW("glTextureStorage2DMultisample", textureStorageMultisample),
        AGAA_TEST_ROW("glNamedBufferData", bufferData),
        AGAA_TEST_ROW("glShaderSource", shaderSource),
        AGAA_TEST_ROW("glCreateTextures", createTextures),
        AGAA_TEST_ROW("glDeleteTextures", deleteTextures),
        AGAA_TEST_ROW("glCreateQueries", createQueries),
        AGAA_TEST_ROW("glDeleteQueries", deleteQueries),
        AGAA_TEST_ROW("glCreateProgram", createProgram),
        AGAA_TEST_ROW("glDeleteProgram", deleteProgram),
        AGAA_TEST_ROW("glCreateShader", createShader),
        AGAA_TEST_ROW("glDeleteShader", deleteShader),
        AGAA_TEST_ROW("glCreateBuffers", createBuffers),
        AGAA_TEST_ROW("glDeleteBuffers", deleteBuffers),
        AGAA_TEST_ROW("glCreateFramebuffers", createFramebuffers),
        AGAA_TEST_ROW("glDeleteFramebuffers", deleteFramebuffers),
        AGAA_TEST_ROW("glCreateSamplers", createSamplers),
        AGAA_TEST_ROW("glDeleteSamplers", deleteSamplers),
        AGAA_TEST_ROW("glCreateVertexArrays", createVertexArrays),
        AGAA_TEST_ROW("glDeleteVertexArrays", deleteVertexArrays),
#undef AGAA_TEST_ROW
    };
    for (const auto& [known, function] : replaced)
        if (std::strcmp(name, known) == 0)
            return function;
    return EglContext::getProcAddr(user, name);
}

OpenGLContextDesc interceptedDesc() {
    created = {};
    alive.clear();
    OpenGLContextDesc desc = contextDesc();
    desc.device.getProcAddr = interceptingProcAddr;
    return desc;
}

// Everything created is deleted.
struct InterceptedContext : StageContext {
    InterceptedContext() : StageContext(interceptedDesc()) { drawsNothing = true; }
    ~InterceptedContext() {
        drawsNothing = false;
        destroy();
        EXPECT_TRUE(alive.empty()) << alive.begin()->first;
    }
    static Created& created() { return test::created; }
};

struct PayloadHost : OpenGLHost {
    using Context = InterceptedContext;
    static constexpr bool sharesMemory = false;
    static constexpr PayloadSize sizes[] = {{1, 1}, {17, 5}, {131, 67}};
    static constexpr uint32_t turns = 1;
};
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, PayloadCases, PayloadHost);

// The memory that uploads are written in is of the size of a buffer of theirs.
TEST(GlLeaks, ViewsWithoutMemoryLeaveNothing) {
    StageContext context(interceptedDesc());
    const ViewSettings settings = benchSettings();
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    ASSERT_EQ(agaaGlCreateView(context.get(), &desc, &view), AGAA_OK);
    agaaDestroyView(view);
    const auto before = alive;
    const auto sizes = created.bufferSizes;
    uint32_t refused = 0;
    for (const auto& [size, count] : sizes) {
        view = nullptr;
        missingSize = size;
        const AgaaResult result = agaaGlCreateView(context.get(), &desc, &view);
        missingSize = 0;
        refused += result == AGAA_ERROR_OUT_OF_MEMORY;
        agaaDestroyView(view);
        EXPECT_EQ(alive, before) << size << " bytes";
    }
    EXPECT_GE(refused, 1u);
}

// Frames create nothing that stays, failures neither.
TEST(GlLeaks, FramesAndFailuresLeaveNothing) {
    OpenGLContextDesc desc = interceptedDesc();
    desc.device.storage = AGAA_GL_STORAGE_IMAGES;
    {
        ViewSettings settings = benchSettings();
        settings.config.flags |= AGAA_CONFIG_TIMESTAMPS;
        Bench bench(settings, desc);
        bench.picture();
        const auto before = alive;
        bench.picture();
        EXPECT_EQ(alive, before);
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = "float x = ;";
        function.shadows = 1;
        settings.chained = &function;
        EXPECT_THROW(StageView(bench.context, settings), std::runtime_error);
        EXPECT_EQ(alive, before);
        sharedEgl().takeMessages(); // of the function
    }
    EXPECT_TRUE(alive.empty());
}

} // namespace
} // namespace agaa::test
