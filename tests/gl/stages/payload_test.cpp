// The plan's bytes against what is really created, recomputed from the intercepted create calls; and everything
// created is deleted.
#include "bench.h"
#include "prediction.h"

#include <cstdlib>
#include <cstring>
#include <new>
#include <set>

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

struct Created {
    uint64_t textureBytes = 0;
    std::map<uint64_t, uint32_t> bufferSizes; // bytes -> how many
    std::multiset<std::pair<std::string, GLuint>> objects; // kind and name, of those alive
};
Created created;

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
    default:
        ADD_FAILURE() << "format " << format << " is not in the test's table";
        return 0;
    }
}

const GladGLContext& real() { return sharedEgl().gl(); }

void GLAD_API_PTR textureStorage(GLuint texture, GLsizei levels, GLenum format, GLsizei width,
                                 GLsizei height) {
    EXPECT_EQ(levels, 1);
    created.textureBytes += uint64_t(width) * uint64_t(height) * bytesOf(format);
    real().TextureStorage2D(texture, levels, format, width, height);
}

void GLAD_API_PTR textureStorageMultisample(GLuint texture, GLsizei samples, GLenum format,
                                            GLsizei width, GLsizei height, GLboolean fixed) {
    created.textureBytes += uint64_t(width) * uint64_t(height) * uint64_t(samples) * bytesOf(format);
    real().TextureStorage2DMultisample(texture, samples, format, width, height, fixed);
}

void GLAD_API_PTR bufferData(GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) {
    ++created.bufferSizes[uint64_t(size)];
    real().NamedBufferData(buffer, size, data, usage);
}

void born(const char* kind, GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i)
        created.objects.emplace(kind, names[i]);
}

void gone(const char* kind, GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i) {
        const auto found = created.objects.find({kind, names[i]});
        EXPECT_TRUE(names[i] == 0 || found != created.objects.end()) << kind << " " << names[i];
        if (found != created.objects.end())
            created.objects.erase(found);
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
#define AGAA_TEST_KIND(Kind, kind)                                            \
    void GLAD_API_PTR create##Kind(GLsizei count, GLuint* names) {            \
        real().Create##Kind(count, names);                                    \
        born(kind, count, names);                                             \
    }                                                                         \
    void GLAD_API_PTR delete##Kind(GLsizei count, const GLuint* names) {      \
        gone(kind, count, names);                                             \
        real().Delete##Kind(count, names);                                    \
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

AgaaGlContextDesc interceptedDesc() {
    created = {};
    AgaaGlContextDesc desc = contextDesc();
    desc.getProcAddr = interceptingProcAddr;
    return desc;
}

class GlPayload : public testing::Test {
protected:
    GlPayload() : context_(interceptedDesc()) {}
    ~GlPayload() override {
        context_.destroy();
        EXPECT_TRUE(created.objects.empty()) << created.objects.begin()->first;
    }

    void expectPayload(const ViewSettings& settings) {
        const AgaaViewDesc desc = viewDesc(settings);
        const Prediction predicted = predict(desc, context_.caps());
        created.textureBytes = 0;
        created.bufferSizes.clear();
        AgaaView view = nullptr;
        ASSERT_EQ(agaaGlCreateView(context_.get(), &desc, &view), 0) << context_.lines.back().text;
        const uint64_t bufferBytes = takePixelBuffers(predicted, created.bufferSizes);
        EXPECT_EQ(created.textureBytes + bufferBytes, predicted.report.totalBytes)
            << settings.config.technique << " n=" << settings.config.samples
            << " c=" << settings.config.aggregates << " " << agaaTierName(settings.config.generationTier) << " "
            << settings.config.flags << " " << settings.width << "x" << settings.height;
        EXPECT_EQ(predicted.report.peakBytes, predicted.report.totalBytes) << "surfaces cannot share memory";
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        EXPECT_EQ(agaaGetFrameStatistics(view, 1, &statistics), AGAA_NOT_READY);
        EXPECT_EQ(statistics.payloadBytes, predicted.report.totalBytes);
        EXPECT_EQ(statistics.peakBytes, predicted.report.totalBytes);
        agaaDestroyView(view);
        ++checked_;
    }

    StageContext context_;
    size_t checked_ = 0;
};

ViewSettings settingsOf(const char* technique, uint32_t n, uint32_t c, uint32_t width, uint32_t height) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.width = width;
    settings.height = height;
    return settings;
}

TEST_F(GlPayload, IsWhatTheQueryPredicts) {
    constexpr std::pair<uint32_t, uint32_t> sizes[] = {{1, 1}, {17, 5}, {131, 67}};
    for (const char* layoutName : {"paper16", "precise"}) {
        AgaaLayout layout;
        agaaGetBuiltinLayout(layoutName, &layout);
        const auto expect = [&](ViewSettings settings) {
            settings.config.layout = &layout;
            expectPayload(settings);
        };
        size_t turn = 0; // sizes take turns: each view compiles its passes
        for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u}) {
            for (uint32_t c = 1; c <= 4; ++c) {
                const auto [width, height] = sizes[turn++ % std::size(sizes)];
                expect(settingsOf("agaa", n, c, width, height));
            }
            const auto [width, height] = sizes[turn++ % std::size(sizes)];
            expect(settingsOf("ssaa", n, 1, width, height));
        }
        for (const auto& [width, height] : sizes)
            expect(settingsOf("single", 1, 1, width, height));
    }
    for (uint32_t tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER})
        for (uint32_t n : {4u, 8u}) {
            ViewSettings settings = settingsOf("agaa", n, 2, 17, 5);
            settings.config.generationTier = tier;
            expectPayload(settings);
            settings.flags = AGAA_VIEW_REVERSED_Z;
            settings.config.flags = AGAA_CONFIG_NO_STENCIL;
            expectPayload(settings);
        }
    for (const PayloadRow& row : payloadRows()) {
        ViewSettings settings = settingsOf(row.technique, row.samples, 2, 131, 67);
        settings.config.generationTier = row.tier;
        settings.config.flags = row.configFlags;
        const AgaaFetchFunction fetch = emptyFetch(row.fetchFlags);
        settings.chained = row.tier == AGAA_TIER_IDS ? &fetch : nullptr;
        expectPayload(settings);
    }
    EXPECT_EQ(checked_, 74u + payloadRows().size());
}

// The memory that uploads are written in is of the size of a buffer of theirs.
TEST(GlLeaks, ViewsWithoutMemoryLeaveNothing) {
    StageContext context(interceptedDesc());
    const ViewSettings settings = benchSettings();
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    ASSERT_EQ(agaaGlCreateView(context.get(), &desc, &view), AGAA_OK);
    agaaDestroyView(view);
    const auto alive = created.objects;
    const auto sizes = created.bufferSizes;
    uint32_t refused = 0;
    for (const auto& [size, count] : sizes) {
        view = nullptr;
        missingSize = size;
        const AgaaResult result = agaaGlCreateView(context.get(), &desc, &view);
        missingSize = 0;
        refused += result == AGAA_ERROR_OUT_OF_MEMORY;
        agaaDestroyView(view);
        EXPECT_EQ(created.objects, alive) << size << " bytes";
    }
    EXPECT_GE(refused, 1u);
}

// Frames create nothing that stays, failures neither.
TEST(GlLeaks, FramesAndFailuresLeaveNothing) {
    AgaaGlContextDesc desc = interceptedDesc();
    desc.storage = AGAA_GL_STORAGE_IMAGES;
    {
        ViewSettings settings = benchSettings();
        settings.config.flags |= AGAA_CONFIG_TIMESTAMPS;
        Bench bench(settings, desc);
        bench.picture();
        const auto alive = created.objects;
        bench.picture();
        EXPECT_EQ(created.objects, alive);
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = "float x = ;";
        function.shadows = 1;
        settings.chained = &function;
        EXPECT_THROW(StageView(bench.context, settings), std::runtime_error);
        EXPECT_EQ(created.objects, alive);
        sharedEgl().takeMessages(); // of the function
    }
    EXPECT_TRUE(created.objects.empty());
}

} // namespace
} // namespace agaa::test
