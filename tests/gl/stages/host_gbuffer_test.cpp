// A G-buffer of the host's own in textures of its own, against the one that the library lays out.
#include "bench.h"

#include "core/error.h"
#include "core/glsl_text.h"
#include "core/layout.h"

#include <cmath>
#include <set>

namespace agaa::test {
namespace {

constexpr uint32_t firstUnit = 20; // beyond what frames touch

// Reads what a view of the same settings drew: attachments from firstUnit on, then depth.
std::string functionText(const AgaaLayout& hostLayout, uint64_t facts) {
    const Layout layout = reduceLayout(checkLayout(&hostLayout), facts);
    const GBufferPacking packing = packGBuffer(layout);
    std::string text;
    std::set<std::string> seen;
    appendGlsl(text, "math/encoding.glsl", seen);
    const size_t count = packing.attachments.size();
    for (size_t i = 0; i <= count; ++i)
        text += format("layout(binding = %zu) uniform sampler2DMS host%zu;\n", firstUnit + i, i);
    const auto channel = [&](int which) {
        const Field& f = packing.fields[size_t(which)];
        return f.bits ? format("texelFetch(host%u, texel, sub)[%u]", f.word, f.shift) : std::string("0.0");
    };
    const auto channels = [&](int first) {
        return "vec3(" + channel(first) + ", " + channel(first + 1) + ", " + channel(first + 2) + ")";
    };
    text += "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {\n"
            "    ivec2 texel = agaaTexel(pixel, i);\n    int sub = agaaTexelSample(i);\n"
            "    vec2 code = vec2(" +
            channel(ChannelNormalX) + ", " + channel(ChannelNormalY) + ");\n    if (code.x == 0.0)\n        return false;\n";
    text += format("    depth = texelFetch(host%zu, texel, sub).x;\n", count);
    text += format("    m.normal = agaa_decodeOct(code, %uu);\n", packing.fields[ChannelNormalX].bits);
    text += "    m.diffuse = " + channels(ChannelDiffuseR) + ";\n";
    text += "    m.specular = " + channels(ChannelSpecularR) + ";\n";
    text += "    m.alpha2 = " + channel(ChannelRoughness) + ";\n";
    text += format("    m.emissive = %f * ", double(layout.emissiveRange())) +
            (layout[AGAA_SEMANTIC_EMISSIVE].channels == 1 ? channel(ChannelEmissiveR) + " * m.diffuse"
                                                          : channels(ChannelEmissiveR)) +
            ";\n    return true;\n}\n";
    return text;
}

TEST(GlHostGBuffer, ShowsWhatTheLibrarysOwnShows) {
    const GladGLContext& gl = sharedEgl().gl();
    AgaaLayout layout;
    ASSERT_EQ(agaaGetBuiltinLayout("precise", &layout), AGAA_OK);
    for (const char* technique : {"ssaa", "simple_complex", "sbaa", "agaa"})
        for (uint32_t n : {4u, 8u}) {
            SCOPED_TRACE(std::string(technique) + " n=" + std::to_string(n));
            ViewSettings settings = benchSettings();
            settings.config.technique = technique;
            settings.config.samples = n;
            if (technique == std::string("agaa") || technique == std::string("sbaa"))
                settings.config.generationTier = AGAA_TIER_GBUFFER;
            Bench drawn(settings);
            const std::vector<float> expected = drawn.picture();
            uint32_t unit = firstUnit;
            for (const char* name : {"gbuffer-0", "gbuffer-1", "gbuffer-2", "gbuffer-3", "depth"}) {
                AgaaGlSurface surface = AGAA_GL_SURFACE_INIT;
                if (agaaGlGetSurface(drawn.view.get(), name, &surface) == AGAA_OK)
                    gl.BindTextureUnit(unit++, surface.texture);
            }
            drawn.context.lines.clear(); // of attachments that the layout has not
            const std::string text = functionText(layout, settings.facts.flags);
            AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
            function.glsl = text.c_str();
            function.depthBits = 24;
            ViewSettings own = settings;
            own.chained = &function;
            Bench bench(own);
            AgaaFrame frame = bench.frame();
            frame.draw = nullptr;
            bench.view.render(frame, bench.glFrame());
            const std::vector<float> image = bench.view.image();
            EXPECT_EQ(bench.view.drawCalls, 0u);
            size_t different = 0;
            for (size_t i = 0; i < image.size(); ++i)
                different += !(std::fabs(image[i] - expected[i]) <= 1e-3f * (1 + std::fabs(expected[i])));
            EXPECT_LE(different, image.size() / 500);
            const AgaaCounters a = drawn.view.statistics().counters, b = bench.view.statistics().counters;
            EXPECT_GT(a.visible, 0u);
            EXPECT_EQ(a.visible, b.visible);
            EXPECT_EQ(b.uncovered + b.overlapping, 0u);
            for (; unit > firstUnit; --unit)
                gl.BindTextureUnit(unit - 1, 0);
        }
}

TEST(GlHostGBuffer, BadOnesAreRefusedInASentence) {
    StageContext context;
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    ViewSettings settings = benchSettings();
    settings.chained = &function;
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    function.glsl = "float x = ;";
    EXPECT_EQ(agaaGlCreateView(context.get(), &desc, &view), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(context.lines, AGAA_ERROR_INVALID_ARGUMENT, "no GLSL", "AgaaGBufferFunction::glsl");
    sharedEgl().takeMessages(); // of the compiler
    context.lines.clear();
    function.glsl = "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    function.descriptorSetLayout = 1;
    EXPECT_EQ(agaaGlCreateView(context.get(), &desc, &view), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(context.lines, AGAA_ERROR_INVALID_ARGUMENT, "a set layout", "Vulkan");
}

} // namespace
} // namespace agaa::test
