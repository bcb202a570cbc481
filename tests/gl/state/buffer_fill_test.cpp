// Buffers filled by the driver and by a shader.
#include "gl/buffer_fill.h"
#include "support.h"

namespace agaa::test {
namespace {

class BufferFillTest : public BothProfiles {
protected:
    // Returns the words of a buffer of which `words` are filled, with one word more.
    std::vector<uint32_t> filled(bool byShader, size_t words, uint32_t value) {
        const gl::BufferFill fill(gl(), byShader);
        std::vector<uint32_t> found(words + 1, guardWord);
        const auto bytes = GLsizeiptr(found.size() * sizeof(uint32_t));
        GLuint buffer = 0;
        gl().CreateBuffers(1, &buffer);
        gl().NamedBufferStorage(buffer, bytes, found.data(), GL_DYNAMIC_STORAGE_BIT);
        fill.fill(buffer, words * sizeof(uint32_t), value);
        gl().GetNamedBufferSubData(buffer, 0, bytes, found.data());
        gl().DeleteBuffers(1, &buffer);
        return found;
    }

    static constexpr uint32_t guardWord = 0xA5A5A5A5u;
};

TEST_P(BufferFillTest, writesEachWordAndNoMore) {
    for (const size_t words : {1, 256, 257, 4099})
        for (const uint32_t value : {0u, 7u})
            for (const bool byShader : {false, true}) {
                std::vector<uint32_t> expected(words, value);
                expected.push_back(guardWord);
                EXPECT_EQ(filled(byShader, words, value), expected) << (byShader ? "by a shader" : "by the driver");
            }
    EXPECT_EQ(context.takeMessages(), "");
}

TEST_P(BufferFillTest, lanesOfAShaderFillSeveralWords) {
    const size_t lanes = size_t(65535) * 256;
    std::vector<uint32_t> expected(lanes + 3, 7);
    expected.push_back(guardWord);
    EXPECT_TRUE(filled(true, lanes + 3, 7) == expected);
}

INSTANTIATE_TEST_SUITE_P(gl, BufferFillTest, testing::Bool(), profileName);

} // namespace
} // namespace agaa::test
