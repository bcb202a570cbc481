// The small OpenGL host that draws known triangles through the public interface.
#pragma once

#include "agaa_gl.h"
#include "context_desc.h"
#include "egl_context.h"
#include "surfaces.h"
#include "view_settings.h"

#include "gl/objects.h"
#include "gl/program.h"
// The library's own, for looking inside.
#include "../../../src/gl/view.h"

#include <array>
#include <functional>
#include <map>

namespace agaa::test {

// The least that the library takes; drivers give more, unless they are told not to.
inline constexpr EglContextDesc leastContext{.minor = 3};

// One context for the process, with debug messages; those of medium or higher severity fail the test at hand.
EglContext& sharedEgl();

// What a context is made with, complete but for what the test wants to change.
using OpenGLContextDesc = ContextDesc<AgaaGlDeviceDesc>;
OpenGLContextDesc contextDesc();

class StageContext {
public:
    explicit StageContext(const OpenGLContextDesc& desc = contextDesc(), EglContext& egl = sharedEgl());
    ~StageContext();
    StageContext(const StageContext&) = delete;
    StageContext& operator=(const StageContext&) = delete;

    AgaaContext get() const { return context_; }
    const AgaaDeviceCaps& caps() const { return caps_; }
    AgaaResult createView(const AgaaViewDesc& desc, AgaaView& view) const {
        return agaaGlCreateView(context_, &desc, &view);
    }
    EglContext& egl() const { return egl_; }
    // Destroys it before its time.
    void destroy();
    std::vector<LogLine> lines; // warnings and errors of the SDK

private:
    EglContext& egl_;
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
};

// A depth map of one layer, everywhere as deep.
harness::gl::Texture shadowMap(const GladGLContext& gl, float depth);
// The name of a map that is no more.
GLuint deletedTexture(const GladGLContext& gl);

class StageView {
public:
    StageView(StageContext& context, const ViewSettings& settings);
    ~StageView();
    StageView(const StageView&) = delete;
    StageView& operator=(const StageView&) = delete;

    void setTriangles(const std::vector<Triangle>& triangles);
    AgaaFrame frame(); // the next, complete but for lights and shadows
    AgaaGlFrame glFrame() const;
    // Records by one call, or a call a segment. Throws where the SDK refuses.
    void render(const AgaaFrame& frame, const AgaaGlFrame& glFrame, bool splitSegments = false);
    void render(const AgaaFrame& wanted, bool splitSegments = false) { render(wanted, glFrame(), splitSegments); }
    std::vector<float> image() const; // RGBA
    AgaaFrameStatistics statistics() const;
    AgaaView get() const { return view_; }
    uint64_t frameIndex() const { return frameIndex_; }
    const agaa::Plan& plan() const { return view_->current->plan; }
    const agaa::gl::View& executor() const { return static_cast<const agaa::gl::View&>(*view_->current); }
    const SamplePositions& positions() const { return executor().positions; }
    // A surface by its name in the plan, texel by texel, sample by sample; floats as their bits.
    std::vector<glm::uvec4> readSurface(const std::string& name) const;
    // The words of a buffer, or of an image of whole numbers with several layers: pixel by pixel, layer by layer.
    std::vector<uint32_t> readBuffer(const std::string& name) const;
    // Index of sample i of a pixel in what readSurface returns.
    size_t sampleIndex(uint32_t x, uint32_t y, uint32_t i) const { return test::sampleIndex(plan(), x, y, i); }
    const ViewSettings& settings() const { return settings_; }
    const harness::gl::Texture& output() const { return output_; }
    // 25 floats a vertex: its position, the vectors of its Material, its texture coordinates.
    GLuint vertices() const { return vertices_.get(); }

    std::map<uint32_t, AgaaResult> drawResults; // of the callback, by pass; each call counts
    uint32_t drawCalls = 0;
    std::vector<uint32_t> batches;     // of the calls
    std::vector<AgaaDrawState> states; // of the calls
    std::function<void()> beforeDraw;  // called by each draw callback

private:
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    AgaaResult draw(const AgaaDrawTarget& target);
    void drawAll(const AgaaDrawTarget& target, const AgaaDrawState& state);

    StageContext& context_;
    const GladGLContext& gl_;
    ViewSettings settings_;
    AgaaView view_ = nullptr;
    uint64_t frameIndex_ = 0;
    harness::gl::Texture output_;
    harness::gl::VertexArray vertexArray_;
    harness::gl::Buffer vertices_;
    // The first draw with it links a program, so that kinds that are not drawn cost nothing.
    struct PassProgram {
        std::string vertex, fragment, geometry, name;
        harness::gl::Program linked;
    };
    PassProgram passProgram(const AgaaDrawPass& pass, bool isMasked) const;

    using PassPrograms = std::array<PassProgram, 2>; // opaque, masked
    std::map<uint64_t, PassPrograms> programs_;      // by pipeline key
    std::map<uint32_t, std::vector<Run>> runs_;      // by AgaaDrawPassId
};

} // namespace agaa::test
