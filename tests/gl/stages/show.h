// Shots by the OpenGL host.
#pragma once

#include "shown.h"
#include "stage_host.h"

#include <memory>

namespace agaa::test {

// A view of the tier ids, whose function fetches from the view's own vertices.
class IdsView {
public:
    IdsView(StageContext& context, ViewSettings settings, const Shot& shot);
    ~IdsView();
    StageView& view() { return *view_; }
    void setTriangles(const std::vector<Triangle>& triangles); // no more than the shot has
    void bind(AgaaGlFrame&) const;

private:
    std::string text_;
    AgaaFetchFunction function_;
    std::unique_ptr<StageView> view_;
};

// A storage buffer that a function of the host's reads.
class FunctionBuffer {
public:
    static constexpr const char* place = "binding = 6"; // beyond what frames touch
    explicit FunctionBuffer(const std::vector<glm::vec4>& data);
    ~FunctionBuffer();
    uint64_t layout() const { return 0; }
    void bind(AgaaGlFrame&) const;

private:
    harness::gl::Buffer buffer_;
};

// Textures for AgaaResolvedOutputs.
class ResolvedTextures {
public:
    ResolvedTextures(uint32_t width, uint32_t height, size_t count) : pixels_(size_t(width) * height) {
        const GladGLContext& gl = sharedEgl().gl();
        for (size_t i = 0; i < count; ++i) {
            textures_.push_back(harness::gl::createTexture(gl, GL_TEXTURE_2D));
            gl.TextureStorage2D(textures_.back().get(), 1, GL_RGBA32F, GLsizei(width), GLsizei(height));
            chained_.textures[i] = textures_.back().get();
        }
    }
    void chain(AgaaGlFrame& frame) const { frame.pNext = &chained_; }
    std::vector<glm::vec3> read(size_t i) const {
        std::vector<glm::vec3> texels(pixels_);
        sharedEgl().gl().GetTextureImage(textures_.at(i).get(), 0, GL_RGB, GL_FLOAT,
                                         GLsizei(pixels_ * sizeof(glm::vec3)), texels.data());
        return texels;
    }
    AgaaGlResolvedTextures& chained() { return chained_; }

private:
    size_t pixels_;
    std::vector<harness::gl::Texture> textures_;
    AgaaGlResolvedTextures chained_ = AGAA_GL_RESOLVED_TEXTURES_INIT;
};

struct OpenGLHost {
    using ResolvedImages = ResolvedTextures;
    using Context = StageContext;
    using View = StageView;
    using Options = OpenGLContextDesc;
    using Frame = AgaaGlFrame;
    using ShadowMap = harness::gl::Texture;
    using FunctionData = FunctionBuffer;
    using Ids = IdsView;
    static constexpr auto recordFrame = agaaGlRecordFrame;

    // Of configurations that differ little some are left to Vulkan: drivers are slow to compile each view's passes.
    static constexpr bool runsAll = false;
    static constexpr size_t settingShare = 1;

    // Of a context that change(desc) changes.
    template <class Change> static OpenGLContextDesc changed(const Change& change) {
        OpenGLContextDesc desc = contextDesc();
        change(desc);
        return desc;
    }
    // Whether turns of a group that have nothing to do are skipped.
    static bool skips(const Context&) { return true; }
    static constexpr bool runsAtOnce = true;      // a call that fails has run its first passes
    static constexpr bool endsRepetitions = true; // the CPU reads the word
    static constexpr bool isCalledOnce = false;
    // Returns the number of fractional bits of a vertex's position in the rasteriser.
    static uint32_t subPixelBits() {
        GLint bits = 0;
        sharedEgl().gl().GetIntegerv(GL_SUBPIXEL_BITS, &bits);
        return uint32_t(bits);
    }
    static std::vector<float> rgba(const View& view) { return view.image(); }
    static ShadowMap shadowMap(const Context& context, float depth) {
        return test::shadowMap(context.egl().gl(), depth);
    }
    static void setShadowMap(Frame& frame, const ShadowMap& map) { frame.shadowTextures[0] = map.get(); }
    template <class Work> static void run(const View& view, const Work& work) {
        Frame frame = view.glFrame();
        work(frame);
        sharedEgl().gl().Finish();
    }
    // Of the driver, which may tell of what the library refuses, too.
    static void forgetMessages() { sharedEgl().takeMessages(); }
};

inline Shown show(StageContext& context, const ViewSettings& settings, const Shot& shot) {
    return showBy<OpenGLHost>(context, settings, shot);
}

} // namespace agaa::test
