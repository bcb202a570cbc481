// A host's own shading of aggregates on OpenGL.
#include "compute_pass.h"
#include "host_shading_cases.h"
#include "show.h"

#include <limits>

namespace agaa::test {
namespace {

constexpr const char* declarations = R"(#version 430
layout(std430, binding = 0) readonly buffer Aggregates { uint words[]; } aggregates;
layout(rgba32f, binding = 0) writeonly uniform image2D image;
#define AGAA_AGGREGATE_WORD(i) aggregates.words[i]
void show(uvec2 pixel, vec3 color) { imageStore(image, ivec2(pixel), vec4(color, 1.0)); }
)";

class HostPass {
public:
    HostPass(StageContext& context, const ViewSettings& settings, StageView& view, const char* light)
        : gl_(context.egl().gl()), settings_(settings), image_(harness::gl::createTexture(gl_, GL_TEXTURE_2D)),
          pass_(gl_, hostShadingText(viewDesc(settings), context.caps(), declarations, light)) {
        AgaaSurface common = AGAA_SURFACE_INIT;
        common.pNext = &aggregates_;
        EXPECT_EQ(agaaGetSurface(view.get(), "aggregates", &common), AGAA_OK);
        gl_.TextureStorage2D(image_.get(), 1, GL_RGBA32F, GLsizei(settings.width), GLsizei(settings.height));
    }

    void record(const AgaaGlFrame&) const {
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, aggregates_.buffer);
        gl_.BindImageTexture(0, image_.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
        pass_.run(settings_.width, settings_.height);
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
        gl_.BindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
    }

    void clear() const {
        const std::vector<float> nothing(size_t(settings_.width) * settings_.height * 4,
                                         std::numeric_limits<float>::quiet_NaN());
        gl_.TextureSubImage2D(image_.get(), 0, 0, 0, GLsizei(settings_.width), GLsizei(settings_.height), GL_RGBA,
                              GL_FLOAT, nothing.data());
    }
    std::vector<float> rgba() const {
        std::vector<float> texels(size_t(settings_.width) * settings_.height * 4);
        gl_.GetTextureImage(image_.get(), 0, GL_RGBA, GL_FLOAT, GLsizei(texels.size() * sizeof(float)), texels.data());
        return texels;
    }

private:
    const GladGLContext& gl_;
    const ViewSettings& settings_;
    harness::gl::Texture image_;
    ComputePass pass_;
    AgaaGlSurface aggregates_ = AGAA_GL_SURFACE_INIT;
};

struct ShadingHost : OpenGLHost {
    static constexpr uint32_t drawnTier = AGAA_TIER_PER_SAMPLE;
    static constexpr uint64_t readback = AGAA_CONFIG_READBACK;
    using Pass = HostPass;
};
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HostShadingCases, ShadingHost);

} // namespace
} // namespace agaa::test
