// A small host of the SDK that draws one triangle, and leaves the context in any state if it is
// told to.
#pragma once

#include "agaa_gl.h"
#include "scramble.h"
#include "support.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace agaa::test {

struct FrameSettings {
    std::string technique = "agaa";
    uint32_t samples = 4;
    uint32_t generationTier = AGAA_TIER_AUTO;
    bool composite = false;
    bool storageImages = false;
    uint32_t constants = AGAA_GL_CONSTANTS_BLOCK;
    uint64_t flags = 0;
    bool fetches = false; // of the tier ids, from a buffer and a texture that are bound on entry
    uint64_t fetchFlags = 0;
};

// Where the SDK binds what host shaders read: apart from its own passes' places.
inline constexpr uint32_t kFrameBinding = 4, kMetadataUnit = 18, kAggregatesBinding = 5, kCountersBinding = 6,
                          kLightsBinding = 7, kShadowUnit = 20,
                          kFrameUnit = 24; // with AGAA_GL_CONSTANTS_TEXELS

// What frames may touch, and more to see that they do not.
gl::StateScope touchedScope(const FrameSettings& settings);
gl::StateScope watchedScope();

class FrameHost {
public:
    static constexpr uint32_t kWidth = 48, kHeight = 32;

    FrameHost(const EglContext& egl, const FrameSettings& settings, AgaaGlStatePolicy policy);
    ~FrameHost();
    FrameHost(const FrameHost&) = delete;
    FrameHost& operator=(const FrameHost&) = delete;

    // Result of agaaGlCreateView; nothing else may be called unless it is 0.
    AgaaResult createView();
    AgaaFrame frame(uint64_t segments = AGAA_SEGMENT_ALL);
    AgaaResult record(const AgaaFrame& frame, uint32_t outputTexture);
    AgaaResult record() { return record(frame(), output); }
    void readStatistics();
    // Fills buffers by the shader, as on GPUs. gl: its functions fill; it must outlive the context.
    void fillByShader(const GladGLContext& gl);

    std::vector<StateText> read() const;
    // Leaves the context as it was when the host was made, but for the bindings by number.
    void useDefaults() { defaults_.restore(); }
    // Binds what fetching reads, if it does; recording does so, too.
    void bindFetched();
    void clearOutput();
    std::vector<float> picture();

    std::function<void()> beforeDraw;              // at the start of each draw callback
    std::function<AgaaResult(uint32_t)> afterDraw; // at its end, with its number in the frame
    std::function<void()> onPush, onPop;
    size_t failingCall = ~size_t{0}; // push or pop, by its place in calls
    std::string calls;               // of the frame: a letter for each push (p), pop (o) and draw (d)
    std::vector<std::string> log;
    uint32_t output = 0;
    uint64_t frameIndex = 0;

private:
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target);
    void drawTriangle(const AgaaDrawTarget& target);
    uint32_t program(const AgaaDrawPass& pass);

    const GladGLContext& gl_;
    bool compatibility_;
    FrameSettings settings_;
    gl::StateGuard defaults_;
    AgaaContext context_ = nullptr;
    AgaaView view_ = nullptr;
    std::vector<AgaaDrawPass> passes_;
    std::vector<uint32_t> programs_;
    uint32_t vertexArray_ = 0, shadowMap_ = 0, fetchCorners_ = 0, fetchColour_ = 0;
    AgaaLight light_{};
    AgaaShadow shadow_{};
};

} // namespace agaa::test
