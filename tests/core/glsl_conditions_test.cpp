// Conditions of the preprocessor name macros that are defined: GLSL up to 4.20 makes anything else an error, and
// drivers differ in what they forgive.
#include "plan_support.h"

#include "core/glsl_text.h"
#include "core/host_glsl.h"

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
    const std::string bare = "#version 310 es\n" +
                             std::regex_replace(text, std::regex("(^|\n)#(version|extension)[^\n]*"), "$1");
    glslang::TShader shader(EShLangCompute);
    const char* source = bare.c_str();
    shader.setStrings(&source, 1);
    std::string out;
    glslang::TShader::ForbidIncluder includer;
    const bool good = shader.preprocess(GetDefaultResources(), 310, EEsProfile, false, false, EShMsgDefault, &out,
                                        includer);
    return good ? "" : shader.getInfoLog();
}

TEST_F(GlslConditions, AreCheckedHere) {
    EXPECT_EQ(conditionErrors("#version 430\n#define HERE 1\n#if HERE && !defined(THERE)\n#endif\n"), "");
    EXPECT_NE(conditionErrors("#version 430\n#if THERE\n#endif\n"), "");
}

struct Case {
    const char* technique;
    uint32_t generationTier;
    bool fetches;
    uint64_t configFlags;
    uint32_t litShadows;
};

TEST_F(GlslConditions, NameWhatIsDefined) {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                 "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
    fetch.maxDraws = fetch.maxPrimitives = 100;
    const Case cases[] = {{"single", AGAA_TIER_AUTO, false, 0, 0},
                          {"fxaa", AGAA_TIER_AUTO, false, 0, 0},
                          {"msaa", AGAA_TIER_AUTO, false, 0, 0},
                          {"ssaa", AGAA_TIER_AUTO, false, 0, 0},
                          {"simple_complex", AGAA_TIER_AUTO, false, 0, 0},
                          {"sbaa", AGAA_TIER_AUTO, false, 0, 0},
                          {"sbaa", AGAA_TIER_GBUFFER, false, 0, 0},
                          {"agaa", AGAA_TIER_AUTO, false, 0, 0},
                          {"agaa", AGAA_TIER_PER_SAMPLE, false, 0, 0},
                          {"agaa", AGAA_TIER_GBUFFER, false, 0, 1},
                          {"agaa", AGAA_TIER_GBUFFER, false, AGAA_CONFIG_BUFFERED, 0},
                          {"agaa", AGAA_TIER_IDS, true, 0, 1},
                          {"agaa", AGAA_TIER_IDS, true, AGAA_CONFIG_BUFFERED, 0}};
    int passes = 0;
    for (const Case& each : cases)
        for (uint32_t shadowMaps : {0u, 1u})
            for (uint64_t someUnfetched : {UINT64_C(0), AGAA_FETCH_NOT_ALL_DRAWS}) {
                fetch.flags = someUnfetched;
                ViewSpec spec;
                spec.technique = each.technique;
                spec.generationTier = each.generationTier;
                spec.chained = each.fetches ? &fetch : nullptr;
                spec.configFlags = each.configFlags;
                spec.shadowMaps = shadowMaps;
                spec.change = [&](AgaaConfig& config) { config.litShadows = each.litShadows & shadowMaps; };
                const Plan plan = planFor(spec, fourSampleDevice());
                for (const Pass& pass : plan.passes) {
                    const std::string what = std::string(each.technique) + " " + pass.name;
                    ++passes;
                    if (pass.kind == PassKind::Compute) {
                        EXPECT_EQ(conditionErrors(passGlslForOpenGl(pass, 430)), "") << what;
                        continue;
                    }
                    for (bool images : {false, true}) {
                        HostDialect dialect;
                        dialect.openGl = true;
                        dialect.glslVersion = 400;
                        dialect.storageImages = images;
                        if (pass.kind != PassKind::HostDraw)
                            continue;
                        EXPECT_EQ(conditionErrors("#define AGAA_ALPHA_MASKED 1\n" + hostDeclarations(plan, pass, dialect)),
                                  "")
                            << what;
                    }
                }
            }
    EXPECT_GT(passes, 100);
}

} // namespace
} // namespace agaa::test
