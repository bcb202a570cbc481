// The GLSL handed to hosts compiles for every technique, n, c, layout, tier and switch.
#include "plan_support.h"

#include "core/base/error.h"
#include "core/glsl/host_glsl.h"

#include <glslang/Public/ShaderLang.h>
#include <glslang/Public/ResourceLimits.h>
#include <gtest/gtest.h>

#include <regex>

using namespace agaa;
using namespace agaa::test;

namespace {

class HostGlsl : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

// What the host's compiler says; empty where it is content.
std::string compileErrors(const std::string& text, const HostDialect& dialect) {
    glslang::TShader shader(EShLangFragment);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    if (dialect.openGl)
        return shader.parse(GetDefaultResources(), 110, false, EShMsgDefault) ? "" : shader.getInfoLog();
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    return shader.parse(GetDefaultResources(), 450, false, messages) ? "" : shader.getInfoLog();
}

std::string hostShader(const Plan& plan, const Pass& pass, const HostDialect& dialect, bool masked) {
    std::string text = "#version " + std::to_string(dialect.glslVersion) + "\n" + hostExtensions(plan, pass, dialect) +
                       "#define AGAA_ALPHA_MASKED " + (masked ? "1\n" : "0\n") + hostDeclarations(plan, pass, dialect);
    // Before 4.10 fragment inputs are matched by name.
    text += dialect.glslVersion < 410 ? "#define AT(n)\n" : "#define AT(n) layout(location = n)\n";
    return text + R"(
AT(0) in vec3 position;
AT(1) in vec2 uv;
AT(2) flat in uint seed;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = AGAA_INSIDE(position);
    s.geometricNormal = agaa_planeNormal(position);
    s.primitiveSeed = seed;
    s.alpha = uv.x;
    s.alphaCutoff = 0.5;
#if AGAA_NEEDS_MATERIAL
    s.diffuse = vec3(AGAA_INSIDE(uv), agaa_dFdx(uv).x);
#endif
    agaa_emit(s);
}
)";
}

constexpr uint64_t routed = UINT64_C(1) << 63; // by the first sample

template <typename Visit> void forEveryHostPass(const Visit& visit) {
    for (const char* technique : {"single", "msaa", "ssaa", "sbaa", "agaa"})
        for (const char* layout : {"precise", "paper16"})
            for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
                for (uint32_t aggregates : {1u, 2u, 3u, 4u})
                    for (uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_PER_SAMPLE})
                        for (uint64_t flags : {UINT64_C(0), AGAA_CONFIG_COUNTERS, routed}) {
                            const bool aggregating = findTechnique(techniques(), technique)->maxAggregates != 0;
                            if (!aggregating && (aggregates > 1 || tier))
                                continue;
                            ViewSpec spec;
                            spec.technique = technique;
                            spec.layout = layout;
                            spec.samples = samples;
                            spec.aggregates = aggregates;
                            spec.generationTier = tier;
                            spec.configFlags = flags & ~routed;
                            spec.change = [&](TechniqueConfig& config) {
                                config.measurement.flags = flags & routed ? AGAA_MEASURE_FIRST_SAMPLE_ROUTING : 0;
                            };
                            const Plan plan = planFor(spec, fourSampleDevice());
                            for (const Pass& pass : plan.passes)
                                if (pass.kind() == PassKind::HostDraw)
                                    visit(plan, pass);
                        }
}

// 3.30 is left to the driver's compiler (tests/gl): glslang knows only parts of ARB_gpu_shader5.
class HostDialects : public HostGlsl, public testing::WithParamInterface<HostDialect> {};

TEST_P(HostDialects, CompilesForEveryPlan) {
    int passes = 0, compiled = 0;
    forEveryHostPass([&](const Plan& plan, const Pass& pass) {
        // The dialects differ in few lines: a stride that no loop above divides samples them.
        if (GetParam().openGl && ++passes % 7)
            return;
        const bool masked = ++compiled & 1;
        const std::string text = hostShader(plan, pass, GetParam(), masked);
        ASSERT_EQ(compileErrors(text, GetParam()), "") << plan.view.technique->name << " n=" << plan.view.samples
                                                       << " c=" << plan.view.aggregates << " " << pass.name;
        if (GetParam().hostOutputs) {
            ASSERT_EQ(text.find(") out vec4"), std::string::npos);
        }
    });
    EXPECT_GT(compiled, 50);
}

// For shaders that are not of the SDK's passes: it has no macros that the host's could be.
// NVIDIA's linker places outputs without a location over those of the host.
TEST(HostGlslCorners, HaveALocationInEveryVersion) {
    for (const bool isPulled : {false, true}) {
        ViewSpec spec{.technique = "dcaa", .samples = 64, .aggregates = 4, .generationTier = AGAA_TIER_MATERIAL_LISTS};
        spec.viewFlags = isPulled ? AGAA_VIEW_VERTEX_PULLING : 0;
        const Plan plan = planFor(spec, idealDevice());
        const Pass& pass =
            *std::ranges::find_if(plan.passes, [](const Pass& p) { return p.kind() == PassKind::HostDraw; });
        for (const uint32_t version : {330u, 400u, 410u, 430u, 460u}) {
            HostDialect dialect;
            dialect.openGl = true;
            dialect.glslVersion = version;
            const std::string expansion =
                isPulled ? hostVertex(plan, pass, dialect) : hostGeometry(plan, pass, dialect);
            for (const std::string& text : {expansion, hostDeclarations(plan, pass, dialect)}) {
                EXPECT_NE(text.find("#define AGAA_AT_CORNERS layout(location = AGAA_CORNER_LOCATION)"),
                          std::string::npos);
                EXPECT_NE(text.find("AGAA_AT_CORNERS flat"), std::string::npos);
            }
            EXPECT_EQ(hostExtensions(plan, pass, dialect).find("ARB_separate_shader_objects") != std::string::npos,
                      version < 410);
        }
    }
}

TEST_F(HostGlsl, CoverageCompilesAlone) {
    size_t size = 0;
    ASSERT_EQ(agaaGetCoverageGlsl(nullptr, &size, nullptr), AGAA_OK);
    std::string text(size, '\0');
    ASSERT_EQ(agaaGetCoverageGlsl(nullptr, &size, text.data()), AGAA_OK);
    text.resize(size - 1);
    EXPECT_EQ(agaaGetCoverageGlsl(nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    size = 1;
    char small = '#';
    EXPECT_EQ(agaaGetCoverageGlsl(nullptr, &size, &small), AGAA_ERROR_BUFFER_TOO_SMALL);
    EXPECT_EQ(small, '#');
    HostDialect openGl;
    openGl.openGl = true;
    for (const HostDialect& dialect : {HostDialect{}, openGl})
        for (const char* version : {"420", "450", "460"}) {
            if (!dialect.openGl && version != std::string("450"))
                continue;
            const std::string shader = std::string("#version ") + version +
                                       "\n#define real 3\n#define rvec2 4\n#define OUT 5\n#define INOUT 6\n"
                                       "#define PRECISE 7\n" +
                                       text + R"(
#if real + rvec2 + OUT + INOUT + PRECISE != 25
#error a macro of the host's is lost
#endif
layout(location = 0) out vec4 color;
void main() {
    float alpha = gl_FragCoord.x * 0.01;
    int mask = int(agaa_translucentMask(alpha, 4u, 0u, 1u, agaa_translucencyHash(1u, 2u, 3u, 4u)));
    mask |= agaa_isInCutout(alpha, 0.5, vec2(dFdx(alpha), dFdy(alpha)), vec2(0.25)) ? 1 : 0;
    mask |= agaa_isInCutout4(vec4(alpha), 0.5, vec2(0.25)) ? 2 : 0;
    gl_SampleMask[0] = mask;
    color = vec4(1.0);
}
)";
            EXPECT_EQ(compileErrors(shader, dialect), "") << version;
        }
}

// A uniform block promises 16 KiB: shadow maps, and what is left of it for lights.
TEST(HostGlslForward, WithoutStorageBlocksLightsAreBounded) {
    for (uint32_t lights : {231u, 232u}) {
        ViewSpec spec;
        spec.technique = "msaa";
        spec.maxLights = lights;
        const Plan plan = planFor(spec, fourSampleDevice());
        HostDialect dialect;
        dialect.openGl = dialect.storageImages = true;
        for (const Pass& pass : plan.passes) {
            if (pass.kind() != PassKind::HostDraw || pass.draw().id != AGAA_DRAW_PASS_FORWARD)
                continue;
            if (lights > 231) {
                EXPECT_THROW(hostDeclarations(plan, pass, dialect), Error);
                continue;
            }
            EXPECT_NE(hostDeclarations(plan, pass, dialect).find("std140, AGAA_BINDING_LIGHTS"), std::string::npos);
        }
    }
}

HostDialect openGl(uint32_t version, bool images, bool outputs) {
    HostDialect dialect;
    dialect.openGl = true;
    dialect.glslVersion = version;
    dialect.storageImages = images;
    dialect.hostOutputs = outputs;
    dialect.bindings = {3, 7, 2, 5};
    return dialect;
}

// For engines that know no blocks, neither uniform nor storage ones.
TEST_F(HostGlsl, WithoutBlocksNoneIsDeclared) {
    const std::regex block(R"((uniform|buffer)\s+\w+\s*\{)");
    for (const char* technique : {"ssaa", "sbaa", "agaa"})
        for (const AgaaTier tier : {AGAA_TIER_AUTO, AGAA_TIER_PER_SAMPLE})
            for (const uint32_t samples : {1u, 8u, 32u})
                for (const AgaaGlConstants constants :
                     {AGAA_GL_CONSTANTS_BLOCK, AGAA_GL_CONSTANTS_UNIFORMS, AGAA_GL_CONSTANTS_TEXELS})
                    for (const uint32_t version : {400u, 450u}) {
                        ViewSpec spec;
                        spec.technique = technique;
                        spec.samples = samples;
                        spec.generationTier = technique == std::string("ssaa") ? AGAA_TIER_AUTO : tier;
                        spec.configFlags = AGAA_CONFIG_COUNTERS;
                        if (technique == std::string("sbaa") && tier != AGAA_TIER_AUTO)
                            continue;
                        HostDialect dialect = openGl(version, true, false);
                        dialect.constants = constants;
                        const Plan plan = planFor(spec, fourSampleDevice());
                        for (const Pass& pass : plan.passes) {
                            if (pass.kind() != PassKind::HostDraw)
                                continue;
                            const std::string text = hostShader(plan, pass, dialect, false);
                            EXPECT_EQ(compileErrors(text, dialect), "") << technique << ' ' << samples;
                            glslang::TShader shader(EShLangFragment);
                            const char* source = text.c_str();
                            shader.setStrings(&source, 1);
                            std::string plain;
                            glslang::TShader::ForbidIncluder includer;
                            ASSERT_TRUE(shader.preprocess(GetDefaultResources(), 110, ENoProfile, false, false,
                                                          EShMsgDefault, &plain, includer))
                                << shader.getInfoLog();
                            EXPECT_EQ(std::regex_search(plain, block), constants == AGAA_GL_CONSTANTS_BLOCK) << plain;
                        }
                    }
    ViewSpec msaa;
    msaa.technique = "msaa";
    HostDialect dialect = openGl(450, true, false);
    dialect.constants = AGAA_GL_CONSTANTS_TEXELS;
    const Plan plan = planFor(msaa, fourSampleDevice());
    EXPECT_THROW(
        {
            for (const Pass& pass : plan.passes)
                if (pass.kind() == PassKind::HostDraw)
                    hostDeclarations(plan, pass, dialect);
        },
        Error);
}

INSTANTIATE_TEST_SUITE_P(All, HostDialects,
                         testing::Values(HostDialect{}, openGl(450, false, false), openGl(450, true, true),
                                         openGl(430, false, true), openGl(400, true, false)),
                         [](const auto& info) {
                             const HostDialect& d = info.param;
                             return std::string(d.openGl ? "OpenGL" : "Vulkan") + std::to_string(d.glslVersion) +
                                    (d.storageImages ? "Images" : "") + (d.hostOutputs ? "HostOutputs" : "");
                         });

} // namespace
