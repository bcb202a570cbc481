// A G-buffer of the host's own on OpenGL: textures, at units of its own.
#include "host_gbuffer_cases.h"
#include "show.h"

#include "core/base/error.h"
#include "core/glsl/glsl_text.h"

#include <set>

namespace agaa::test {
namespace {

constexpr uint32_t firstUnit = 20; // beyond what frames touch

// Attachments from firstUnit on, then depth.
class TextureSamples {
public:
    explicit TextureSamples(const StageView& drawn)
        : plan_(drawn.plan()), attachments_(packGBuffer(plan_.view.layout).attachments.size()) {
        for (size_t i = 0; i <= attachments_; ++i) {
            AgaaGlSurface surface = AGAA_GL_SURFACE_INIT;
            const std::string name = i < attachments_ ? "gbuffer-" + std::to_string(i) : "depth";
            AgaaSurface common = AGAA_SURFACE_INIT;
            common.pNext = &surface;
            EXPECT_EQ(agaaGetSurface(drawn.get(), name.c_str(), &common), AGAA_OK) << name;
            textures_.push_back(surface.texture);
        }
    }
    ~TextureSamples() {
        for (size_t i = 0; i < textures_.size(); ++i)
            sharedEgl().gl().BindTextureUnit(GLuint(firstUnit + i), 0);
    }
    uint64_t layout() const { return 0; }
    void bind(AgaaGlFrame&) const {
        for (size_t i = 0; i < textures_.size(); ++i)
            sharedEgl().gl().BindTextureUnit(GLuint(firstUnit + i), textures_[i]);
    }

    std::string text() const {
        const GBufferPacking packing = packGBuffer(plan_.view.layout);
        std::string text;
        std::set<std::string> seen;
        appendGlsl(text, "math/encoding.glsl", seen);
        for (size_t i = 0; i <= attachments_; ++i)
            text += format("layout(binding = %zu) uniform sampler2D%s host%zu;\n", firstUnit + i,
                           plan_.view.hwSamples > 1 ? "MS" : "", i);
        const auto channel = [&](int which) {
            const Field& f = packing.fields[size_t(which)];
            return f.bits ? format("texelFetch(host%u, texel, sub)[%u]", f.word, f.shift) : std::string("0.0");
        };
        const auto channels = [&](int first) {
            return "vec3(" + channel(first) + ", " + channel(first + 1) + ", " + channel(first + 2) + ")";
        };
        text += "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {\n"
                "    ivec2 texel = agaaTexel(pixel, i);\n    int sub = agaaTexelSample(i);\n    vec2 code = vec2(" +
                channel(ChannelNormalX) + ", " + channel(ChannelNormalY) +
                ");\n    if (code.x == 0.0)\n        return false;\n";
        text += format("    depth = texelFetch(host%zu, texel, sub).x;\n", attachments_);
        text += format("    m.normal = agaa_decodeOct(code, %uu);\n", packing.fields[ChannelNormalX].bits);
        text += "    m.diffuse = " + channels(ChannelDiffuseR) + ";\n";
        text += "    m.specular = " + channels(ChannelSpecularR) + ";\n";
        text += "    m.alpha2 = " + channel(ChannelRoughness) + ";\n";
        text += format("    m.emissive = %f * ", double(plan_.view.layout.emissiveRange())) +
                (plan_.view.layout[AGAA_SEMANTIC_EMISSIVE].channels == 1 ? channel(ChannelEmissiveR) + " * m.diffuse"
                                                                         : channels(ChannelEmissiveR)) +
                ";\n    return true;\n}\n";
        return text;
    }

private:
    const Plan& plan_;
    size_t attachments_;
    std::vector<GLuint> textures_;
};

struct GBufferHost : OpenGLHost {
    using Samples = TextureSamples;
    static constexpr uint32_t shadowMaps = 1;
    static constexpr GBufferRow rows[] = {
        {"single", 1}, {"ssaa", 4}, {"ssaa", 8}, {"visibility", 8}, {"simple_complex", 4}, {"simple_complex", 8},
        {"sbaa", 4},   {"sbaa", 8}, {"agaa", 4}, {"agaa", 8},       {"adaptive", 4},       {"adaptive", 8}};
};
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HostGBufferCases, GBufferHost);

TEST(GlHostGBuffer, HasNoSetLayout) {
    StageContext context;
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    function.glsl =
        "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    function.descriptorSetLayout = 1;
    ViewSettings settings;
    settings.chained = &function;
    const std::string text = expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "a set layout");
    EXPECT_NE(text.find("Vulkan"), std::string::npos) << text;
}

} // namespace
} // namespace agaa::test
