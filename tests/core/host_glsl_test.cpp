// The GLSL handed to hosts compiles for every technique, n, c, layout, tier and switch.
#include "plan_support.h"

#include "core/host_glsl.h"

#include <glslang/Public/ShaderLang.h>
#include <glslang/Public/ResourceLimits.h>
#include <gtest/gtest.h>

using namespace agaa;
using namespace agaa::test;

namespace {

class HostGlsl : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

std::string compileErrors(const std::string& text) {
    glslang::TShader shader(EShLangFragment);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    return shader.parse(GetDefaultResources(), 450, false, messages) ? "" : shader.getInfoLog();
}

std::string hostShader(const Plan& plan, const Pass& pass, bool masked) {
    return "#version 450\n" + hostExtensions(plan, pass) + "#define AGAA_ALPHA_MASKED " +
           (masked ? "1\n" : "0\n") + hostDeclarations(plan, pass, 1) + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
layout(location = 2) flat in uint seed;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = AGAA_INSIDE(position);
    s.geometricNormal = agaa_planeNormal(position);
    s.primitiveSeed = seed;
    s.alpha = agaa_sharpenAlpha(uv.x, 0.5);
#if AGAA_NEEDS_MATERIAL
    s.diffuse = vec3(AGAA_INSIDE(uv), agaa_dFdx(uv).x);
#endif
    agaa_emit(s);
}
)";
}

TEST_F(HostGlsl, CompilesForEveryPlan) {
    int compiled = 0;
    for (const char* technique : {"single", "ssaa", "agaa"})
        for (const char* layout : {"precise", "paper16"})
            for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
                for (uint32_t aggregates : {1u, 2u, 3u, 4u})
                    for (uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_PER_SAMPLE})
                        for (uint64_t flags : {UINT64_C(0), AGAA_CONFIG_COUNTERS,
                                               AGAA_CONFIG_FIRST_SAMPLE_ROUTING}) {
                            const bool aggregating = std::string_view(technique) == "agaa";
                            if (!aggregating && (aggregates > 1 || tier))
                                continue;
                            ViewSpec spec;
                            spec.technique = technique;
                            spec.layout = layout;
                            spec.samples = samples;
                            spec.aggregates = aggregates;
                            spec.generationTier = tier;
                            spec.configFlags = flags;
                            const Plan plan = planFor(spec, fourSampleDevice());
                            for (const Pass& pass : plan.passes)
                                if (pass.kind == PassKind::HostDraw) {
                                    const bool masked = ++compiled & 1;
                                    const std::string log =
                                        compileErrors(hostShader(plan, pass, masked));
                                    ASSERT_EQ(log, "") << technique << " n=" << samples
                                                       << " c=" << aggregates << " " << pass.name;
                                }
                        }
    EXPECT_GT(compiled, 300);
}

} // namespace
