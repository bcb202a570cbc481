// Programs that hosts keep from run to run: what is loaded, and that no bytes do harm.
#include "bench.h"

#include "core/glsl/glsl_text.h"
#include "gl/program_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace agaa::test {
namespace {

using gl::ProgramCache;

std::vector<std::byte> bytesOf(const char* text) {
    std::vector<std::byte> bytes(std::strlen(text));
    std::memcpy(bytes.data(), text, bytes.size());
    return bytes;
}

// Two programs of a driver.
ProgramCache twoPrograms() {
    ProgramCache cache("driver 1");
    cache.set(ProgramCache::keyOf("one"), {7, bytesOf("first binary")});
    cache.set(ProgramCache::keyOf("two"), {8, {}});
    return cache;
}

TEST(GlProgramCache, BytesBringProgramsBack) {
    ProgramCache cache("driver 1");
    EXPECT_EQ(cache.read(twoPrograms().bytes()), "");
    ASSERT_EQ(cache.size(), 2u);
    const ProgramCache::Binary* one = cache.find(ProgramCache::keyOf("one"));
    ASSERT_NE(one, nullptr);
    EXPECT_EQ(one->format, 7u);
    EXPECT_EQ(one->bytes, bytesOf("first binary"));
    EXPECT_EQ(cache.find(ProgramCache::keyOf("three")), nullptr);
    EXPECT_EQ(cache.bytes(), twoPrograms().bytes());
    ProgramCache empty("driver 1");
    EXPECT_EQ(cache.read(empty.bytes()), "") << "a header alone";
    EXPECT_EQ(cache.size(), 2u);
}

TEST(GlProgramCache, AnotherDriversAreOfNoUse) {
    ProgramCache cache("driver 2");
    EXPECT_EQ(cache.read(twoPrograms().bytes()), "is of another driver");
    EXPECT_EQ(cache.size(), 0u);
}

// Sums that fit what was changed, as of a version with the same marks.
void sumAnew(std::vector<std::byte>& bytes) {
    uint64_t sum = 0xCBF29CE484222325u;
    for (size_t i = 0; i + 8 < bytes.size(); ++i)
        sum = (sum ^ uint64_t(bytes[i])) * 0x100000001B3u;
    std::memcpy(bytes.data() + bytes.size() - 8, &sum, sizeof sum);
}

TEST(GlProgramCache, EachChangeOfABitIsFound) {
    const std::vector<std::byte> good = twoPrograms().bytes();
    for (size_t at = 0; at < good.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            std::vector<std::byte> bad = good;
            bad[at] ^= std::byte(1 << bit);
            ProgramCache cache("driver 1");
            EXPECT_EQ(cache.read(bad), "is damaged") << at;
            EXPECT_EQ(cache.size(), 0u);
            // Whatever the numbers in it say, it is not read beyond its end.
            sumAnew(bad);
            ProgramCache careless("driver 1");
            careless.read(bad);
        }
}

TEST(GlProgramCache, AnyLengthIsRefused) {
    const std::vector<std::byte> good = twoPrograms().bytes();
    for (size_t size = 0; size < good.size(); ++size) {
        std::vector<std::byte> bad(good.begin(), good.begin() + long(size));
        ProgramCache cache("driver 1");
        EXPECT_EQ(cache.read(bad), "is damaged") << size;
        if (size >= 8) {
            sumAnew(bad);
            EXPECT_NE(cache.read(bad), "") << size;
        }
        EXPECT_EQ(cache.size(), 0u);
    }
    std::vector<std::byte> longer = good;
    longer.insert(longer.end() - 8, std::byte(0));
    sumAnew(longer);
    ProgramCache cache("driver 1");
    EXPECT_EQ(cache.read(longer), "is damaged");
}

TEST(GlProgramCache, AnotherVersionIsNotRead) {
    for (const size_t at : {4u, 8u}) { // of the format, of the library
        std::vector<std::byte> other = twoPrograms().bytes();
        other[at] ^= std::byte(1);
        sumAnew(other);
        ProgramCache cache("driver 1");
        EXPECT_EQ(cache.read(other), "is of another version of the library");
        EXPECT_EQ(cache.size(), 0u);
    }
}

// Of a context, and programs that the host keeps.
class GlPrograms : public testing::Test {
protected:
    void SetUp() override {
        GLint formats = 0;
        sharedEgl().gl().GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
        if (formats == 0)
            GTEST_SKIP() << "the driver has no program binaries (GL_NUM_PROGRAM_BINARY_FORMATS is 0)";
    }
    OpenGLContextDesc descWith(const std::vector<std::byte>& data) {
        cache_.size = data.size();
        cache_.data = data.data();
        OpenGLContextDesc desc = contextDesc();
        desc.device.pNext = &cache_;
        return desc;
    }
    static std::vector<std::byte> bytesFrom(AgaaContext context) {
        size_t size = 0;
        EXPECT_EQ(agaaGlGetProgramCache(context, &size, nullptr), AGAA_OK);
        std::vector<std::byte> bytes(size);
        EXPECT_EQ(agaaGlGetProgramCache(context, &size, bytes.data()), AGAA_OK);
        EXPECT_EQ(size, bytes.size());
        return bytes;
    }
    static ViewSettings settings() {
        ViewSettings settings = benchSettings();
        settings.config.technique = "ssaa";
        return settings;
    }
    static AgaaSceneFacts none() {
        AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
        facts.flags = 0;
        return facts;
    }

private:
    AgaaGlProgramCache cache_ = AGAA_GL_PROGRAM_CACHE_INIT;
};

TEST_F(GlPrograms, ComeFromTheCacheInTheNextRun) {
    const AgaaSceneFacts fewer = none();
    std::vector<std::byte> bytes;
    std::vector<float> expected;
    {
        Bench bench(settings(), descWith({}));
        ASSERT_EQ(agaaPrepareVariants(bench.view.get(), 1, &fewer), AGAA_OK);
        expected = bench.picture();
        const AgaaFrameStatistics statistics = bench.view.statistics();
        EXPECT_EQ(statistics.compiledPipelines, 3u);
        EXPECT_EQ(statistics.cachedPipelines, 0u);
        bytes = bytesFrom(bench.context.get());
        EXPECT_EQ(bytesFrom(bench.context.get()), bytes);
        ASSERT_EQ(agaaResizeView(bench.view.get(), settings().width, settings().height), AGAA_OK);
        EXPECT_EQ(bench.picture(), expected);
        EXPECT_EQ(bench.view.statistics().cachedPipelines, 3u) << "views of one context share programs, too";
        EXPECT_EQ(bytesFrom(bench.context.get()), bytes);
    }
    Bench next(settings(), descWith(bytes));
    EXPECT_TRUE(next.context.lines.empty());
    ASSERT_EQ(agaaPrepareVariants(next.view.get(), 1, &fewer), AGAA_OK);
    EXPECT_EQ(next.picture(), expected);
    EXPECT_EQ(next.view.statistics().compiledPipelines, 3u);
    EXPECT_EQ(next.view.statistics().cachedPipelines, 3u);
    EXPECT_EQ(bytesFrom(next.context.get()), bytes);
    // A view with other texts.
    ViewSettings other = settings();
    other.config.samples = 2;
    StageView view(next.context, other);
    EXPECT_EQ(view.statistics().cachedPipelines, 0u);
    EXPECT_GT(bytesFrom(next.context.get()).size(), bytes.size());
}

TEST_F(GlPrograms, DamagedDataIsLeftAloneWithAWarning) {
    std::vector<std::byte> bytes;
    std::vector<float> expected;
    {
        Bench bench(settings(), descWith({}));
        expected = bench.picture();
        bytes = bytesFrom(bench.context.get());
    }
    std::vector<std::vector<std::byte>> bad;
    for (const size_t at : {size_t(0), size_t(30), bytes.size() / 2, bytes.size() - 1}) {
        bad.push_back(bytes);
        bad.back()[at] ^= std::byte(4);
        bad.push_back({bytes.begin(), bytes.begin() + long(at) + 1});
    }
    bad.pop_back(); // the whole of it
    for (const std::vector<std::byte>& data : bad) {
        Bench bench(settings(), descWith(data));
        ASSERT_EQ(bench.context.lines.size(), 1u);
        EXPECT_EQ(bench.context.lines[0].code, AGAA_OK);
        EXPECT_NE(bench.context.lines[0].text.find("AgaaGlProgramCache::data is damaged"), std::string::npos);
        EXPECT_EQ(bench.picture(), expected);
        EXPECT_EQ(bench.view.statistics().cachedPipelines, 0u);
    }
}

// The bytes are whole, and the driver takes none of them.
TEST_F(GlPrograms, WhatTheDriverDoesNotLoadIsCompiled) {
    std::vector<std::byte> bytes;
    std::vector<float> expected;
    {
        Bench bench(settings(), descWith({}));
        expected = bench.picture();
        auto& context = static_cast<gl::Context&>(*bench.context.get());
        ASSERT_EQ(context.programs.size(), 2u);
        uint32_t format = context.binaryFormats[0];
        for (const Pass& pass : bench.view.plan().passes)
            if (pass.kind() == PassKind::Compute) {
                const ProgramCache::Key key = ProgramCache::keyOf(passGlslForOpenGl(pass, 450));
                const bool isThere = context.programs.find(key) != nullptr;
                context.programs.set(isThere ? key : ProgramCache::keyOf(passGlslForOpenGl(pass, 430)),
                                     {format, bytesOf("no program")});
                format = 1; // no format at all
            }
        ASSERT_EQ(context.programs.size(), 2u);
        bytes = bytesFrom(bench.context.get());
    }
    Bench next(settings(), descWith(bytes));
    OpenGLHost::forgetMessages();
    EXPECT_TRUE(next.context.lines.empty());
    EXPECT_EQ(next.picture(), expected);
    EXPECT_EQ(next.view.statistics().cachedPipelines, 0u);
    EXPECT_GT(bytesFrom(next.context.get()).size(), bytes.size()) << "programs that load take their places";
}

TEST_F(GlPrograms, AreNotKeptUnlessAsked) {
    Bench bench(settings());
    bench.picture();
    ASSERT_EQ(agaaResizeView(bench.view.get(), settings().width, settings().height), AGAA_OK);
    bench.picture();
    EXPECT_EQ(bench.view.statistics().cachedPipelines, 0u);
    const std::vector<std::byte> bytes = bytesFrom(bench.context.get());
    EXPECT_LT(bytes.size(), 1000u) << "a header";
    Bench next(settings(), descWith(bytes));
    EXPECT_TRUE(next.context.lines.empty());
    EXPECT_EQ(next.view.statistics().cachedPipelines, 0u);
}

TEST(GlProgramCacheCalls, AreCheckedLikeOthers) {
    StageContext context;
    size_t size = 0;
    EXPECT_EQ(agaaGlGetProgramCache(nullptr, &size, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetProgramCache(context.get(), nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(context.lines, AGAA_ERROR_INVALID_ARGUMENT, "no size");
    ASSERT_EQ(agaaGlGetProgramCache(context.get(), &size, nullptr), AGAA_OK);
    std::vector<std::byte> bytes(size, std::byte(9));
    size_t less = size - 1;
    context.lines.clear();
    EXPECT_EQ(agaaGlGetProgramCache(context.get(), &less, bytes.data()), AGAA_ERROR_BUFFER_TOO_SMALL);
    expectOneSentence(context.lines, AGAA_ERROR_BUFFER_TOO_SMALL, "too small");
    EXPECT_EQ(less, size - 1);
    EXPECT_EQ(bytes, std::vector<std::byte>(size, std::byte(9)));
    bytes.resize(size + 10);
    size_t more = bytes.size();
    EXPECT_EQ(agaaGlGetProgramCache(context.get(), &more, bytes.data()), AGAA_OK);
    EXPECT_EQ(more, size);

    AgaaGlProgramCache cache = AGAA_GL_PROGRAM_CACHE_INIT;
    cache.size = 4;
    OpenGLContextDesc desc = contextDesc();
    desc.device.pNext = &cache;
    std::vector<LogLine> lines;
    const AgaaLog log = logInto(lines);
    desc.log = &log;
    AgaaContext none = nullptr;
    EXPECT_EQ(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &none), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(lines, AGAA_ERROR_INVALID_ARGUMENT, "no data");
    lines.clear();
    cache.structSize = 8;
    EXPECT_EQ(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &none), AGAA_ERROR_STRUCT);
    EXPECT_EQ(none, nullptr);
}

} // namespace
} // namespace agaa::test
