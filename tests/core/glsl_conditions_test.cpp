// Conditions of the preprocessor name macros that are defined: GLSL up to 4.20 makes anything else an error, and
// drivers differ in what they forgive.
#include "plan_support.h"

#include "core/glsl/glsl_text.h"
#include "core/glsl/host_glsl.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gtest/gtest.h>

#include <regex>

namespace agaa::test {
namespace {

class GlslConditions : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

// As the preprocessor of OpenGL ES, which insists.
std::string conditionErrors(const std::string& text) {
    const std::string bare =
        "#version 310 es\n" + std::regex_replace(text, std::regex("(^|\n)#(version|extension)[^\n]*"), "$1");
    glslang::TShader shader(EShLangCompute);
    const char* source = bare.c_str();
    shader.setStrings(&source, 1);
    std::string out;
    glslang::TShader::ForbidIncluder includer;
    const bool good =
        shader.preprocess(GetDefaultResources(), 310, EEsProfile, false, false, EShMsgDefault, &out, includer);
    return good ? "" : shader.getInfoLog();
}

TEST_F(GlslConditions, AreCheckedHere) {
    EXPECT_EQ(conditionErrors("#version 430\n#define HERE 1\n#if HERE && !defined(THERE)\n#endif\n"), "");
    EXPECT_NE(conditionErrors("#version 430\n#if THERE\n#endif\n"), "");
}

enum class Functions { None, Fetch, FetchOfSome, GBuffer, Shadow };

struct Case {
    const char* technique;
    uint32_t generationTier = AGAA_TIER_AUTO;
    Functions functions = Functions::None;
    uint64_t configFlags = 0;
    uint32_t litShadows = 0;
};

// Of the host's, chained to a view; calls of it return pointers into it.
class Chain {
public:
    const void* of(Functions functions) {
        fetch_.glsl = "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                      "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
        fetch_.maxDraws = fetch_.maxPrimitives = 100;
        fetch_.flags = functions == Functions::FetchOfSome ? AGAA_FETCH_NOT_ALL_DRAWS : 0;
        gbuffer_.glsl =
            "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return true; }";
        shadow_.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
        shadow_.shadows = 1;
        switch (functions) {
        case Functions::None:
            return nullptr;
        case Functions::GBuffer:
            return &gbuffer_;
        case Functions::Shadow:
            return &shadow_;
        default:
            return &fetch_;
        }
    }

private:
    AgaaFetchFunction fetch_ = AGAA_FETCH_FUNCTION_INIT;
    AgaaGBufferFunction gbuffer_ = AGAA_GBUFFER_FUNCTION_INIT;
    AgaaShadowFunction shadow_ = AGAA_SHADOW_FUNCTION_INIT;
};

void expectDefined(const Plan& plan, const Pass& pass, const std::string& what) {
    if (pass.kind() == PassKind::Compute) {
        EXPECT_EQ(conditionErrors(passGlslForOpenGl(pass, 430)), "") << what;
        return;
    }
    if (pass.kind() != PassKind::HostDraw)
        return;
    for (const char* masked : {"0", "1"})
        for (bool images : {false, true}) {
            HostDialect dialect;
            dialect.openGl = true;
            dialect.glslVersion = 400;
            dialect.storageImages = images;
            EXPECT_EQ(conditionErrors(std::string("#define AGAA_ALPHA_MASKED ") + masked + "\n" +
                                      hostDeclarations(plan, pass, dialect)),
                      "")
                << what;
        }
}

TEST_F(GlslConditions, NameWhatIsDefined) {
    const Case cases[] = {{"dcaa"},
                          {"dcaa", AGAA_TIER_MATERIAL_LISTS},
                          {"dcaa", AGAA_TIER_FRAGMENT_INTERLOCK},
                          {"dcaa", AGAA_TIER_RASTER_ORDER},
                          {"single"},
                          {"fxaa"},
                          {"msaa"},
                          {"ssaa"},
                          {"ssaa", AGAA_TIER_AUTO, Functions::Shadow},
                          {"simple_complex"},
                          {"sbaa"},
                          {"sbaa", AGAA_TIER_GBUFFER},
                          {"agaa"},
                          {"agaa", AGAA_TIER_PER_SAMPLE},
                          {"agaa", AGAA_TIER_GBUFFER, Functions::None, 0, 1},
                          {"agaa", AGAA_TIER_GBUFFER, Functions::GBuffer, 0, 1},
                          {"agaa", AGAA_TIER_GBUFFER, Functions::None, AGAA_CONFIG_BUFFERED},
                          {"agaa", AGAA_TIER_IDS, Functions::Fetch, 0, 1},
                          {"agaa", AGAA_TIER_IDS, Functions::Fetch, AGAA_CONFIG_BUFFERED},
                          {"agaa", AGAA_TIER_IDS, Functions::FetchOfSome, 0, 1},
                          {"agaa", AGAA_TIER_IDS, Functions::FetchOfSome, AGAA_CONFIG_BUFFERED}};
    Chain chain;
    for (const Case& each : cases)
        for (uint32_t shadowMaps : {0u, 1u})
            for (uint64_t viewFlags : {UINT64_C(0), AGAA_VIEW_COMPOSITE}) {
                if (each.functions == Functions::Shadow && !shadowMaps)
                    continue;
                ViewSpec spec;
                spec.technique = each.technique;
                spec.generationTier = each.generationTier;
                spec.chained = chain.of(each.functions);
                spec.configFlags = each.configFlags | (viewFlags ? AGAA_CONFIG_COUNTERS : 0);
                spec.viewFlags = viewFlags;
                spec.shadowMaps = shadowMaps;
                spec.change = [&](TechniqueConfig& config) {
                    config.aggregation.litShadows = each.litShadows & shadowMaps;
                };
                AgaaDeviceCaps caps = fourSampleDevice();
                caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK | AGAA_DEVICE_FRAMEBUFFER_FETCH;
                const Plan plan = planFor(spec, caps);
                for (const Pass& pass : plan.passes)
                    expectDefined(plan, pass, std::string(each.technique) + " " + pass.name);
            }
}

} // namespace
} // namespace agaa::test
