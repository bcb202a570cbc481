// The resources listed for a draw pass are those that a compiler finds in its GLSL.
#include "plan_support.h"

#include "core/base/error.h"
#include "core/glsl/glsl_resources.h"
#include "core/glsl/host_glsl.h"

#include <glslang/Include/Types.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace agaa;
using namespace agaa::test;

namespace {

TEST(GlslResources, ReadsEveryKindOfDeclaration) {
    const auto list = declaredResources(R"(
#version 450
layout(std140, set = 2, binding = 3) uniform agaa_Block { vec4 v[2]; uniformName x; } agaa_block;
layout ( binding = 0x11 , std430 ) coherent readonly buffer agaa_Words { uint words [ ] ; } ;
layout(r32ui, binding = 4) coherent uniform uimageBuffer agaa_image;
layout(set = 1, binding = 5) uniform usampler2DMS agaa_samples[3];
#line 12
layout(input_attachment_index = 0, set = 0, binding = 6) uniform usubpassInput agaa_held[7];
uniform highp vec4 agaa_constants[12];
uniform float x;
layout(std430) buffer;
layout(std140) uniform;
layout(location = 0) out vec4 color;
const uint bindings[2] = uint[](1u, 2u);
struct Stored { uint buffers; };
float f(float y) { if (y > 0.0) { y = x; } return y; }
void uniformly();
)");
    std::string text;
    for (const AgaaGlslResource& r : list)
        text += std::string(r.name) + ' ' + std::to_string(r.kind) + ' ' + std::to_string(r.set) + ' ' +
                std::to_string(r.binding) + ' ' + std::to_string(r.count) + '\n';
    EXPECT_EQ(text, "agaa_Block 4 2 3 1\n"
                    "agaa_Words 5 0 17 1\n"
                    "agaa_image 3 0 4 1\n"
                    "agaa_samples 2 1 5 3\n"
                    "agaa_held 6 0 6 7\n"
                    "agaa_constants 1 0 0 12\n"
                    "x 1 0 0 1\n");
}

TEST(GlslResources, TextsWithoutEndAreRead) {
    for (const char* text : {"", ";", "{", "}", "}}", "uniform", "uniform;", "layout(binding = ) uniform sampler2D",
                             "buffer {", "uniform x [", "layout(binding", "]", "uniform ]", "uniform a b["})
        EXPECT_LE(declaredResources(text).size(), 1u) << text;
}

TEST(GlslResources, NamesThatAreTooLongAreCutOff) {
    const auto list = declaredResources("uniform float " + std::string(100, 'x') + ";");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].name, std::string(63, 'x'));
}

TEST(GlslResources, TextsThatDoNotPreprocessAreRefused) {
    HostPass pass;
    pass.declarations = "#error no\n";
    EXPECT_THROW(glslResources(pass), Error);
}

AgaaGlslResourceKind kindOf(const glslang::TType& type) {
    if (type.getBasicType() != glslang::EbtSampler)
        return AGAA_GLSL_RESOURCE_UNIFORM;
    const glslang::TSampler& sampler = type.getSampler();
    return sampler.isSubpass() ? AGAA_GLSL_RESOURCE_INPUT_ATTACHMENT
           : sampler.isImage() ? AGAA_GLSL_RESOURCE_IMAGE
                               : AGAA_GLSL_RESOURCE_SAMPLER;
}

// Checks the resources that the shader uses. Returns their kinds.
std::set<uint32_t> compare(const HostPass& pass, const std::vector<AgaaGlslResource>& list, const HostDialect& dialect,
                           const std::string& what) {
    const std::string text =
        "#version " + std::to_string(dialect.glslVersion) + "\n" + pass.extensions + pass.declarations + R"(
layout(location = 0) in vec3 position;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = AGAA_INSIDE(position);
    s.geometricNormal = agaa_planeNormal(position);
    agaa_emit(s);
}
)";
    glslang::TShader shader(EShLangFragment);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    EShMessages messages = EShMsgDefault;
    if (!dialect.openGl) {
        shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
        messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
    }
    EXPECT_TRUE(shader.parse(GetDefaultResources(), 450, false, messages)) << what << shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    EXPECT_TRUE(program.link(messages)) << what << program.getInfoLog();
    EXPECT_TRUE(program.buildReflection(EShReflectionSeparateBuffers)) << what;
    std::map<std::string, AgaaGlslResource> listed;
    for (const AgaaGlslResource& resource : list)
        EXPECT_TRUE(listed.emplace(resource.name, resource).second) << what << resource.name << " is listed twice.";
    std::set<uint32_t> kinds;
    const auto check = [&](const glslang::TObjectReflection& used, AgaaGlslResourceKind kind, bool hasBinding) {
        const std::string name = used.name.substr(0, used.name.find('['));
        const auto at = listed.find(name);
        if (at == listed.end()) {
            ADD_FAILURE() << what << name << " is not listed.";
            return;
        }
        EXPECT_EQ(at->second.kind, uint32_t(kind)) << what << name;
        EXPECT_EQ(at->second.binding, hasBinding ? uint32_t(used.getBinding()) : 0u) << what << name;
        const bool hasSet = !dialect.openGl && used.getType()->getQualifier().hasSet();
        EXPECT_EQ(at->second.set, hasSet ? uint32_t(used.getType()->getQualifier().layoutSet) : 0u) << what << name;
        EXPECT_TRUE(at->second.stages & AGAA_GLSL_STAGE_FRAGMENT) << what << name;
        kinds.insert(uint32_t(kind));
    };
    for (int i = 0; i < program.getNumUniformVariables(); ++i)
        if (program.getUniform(i).offset < 0 || program.getUniform(i).index < 0) { // others are members of blocks
            const AgaaGlslResourceKind kind = kindOf(*program.getUniform(i).getType());
            check(program.getUniform(i), kind, kind != AGAA_GLSL_RESOURCE_UNIFORM);
        }
    for (int i = 0; i < program.getNumUniformBlocks(); ++i)
        check(program.getUniformBlock(i), AGAA_GLSL_RESOURCE_UNIFORM_BLOCK, true);
    for (int i = 0; i < program.getNumBufferBlocks(); ++i)
        check(program.getBufferBlock(i), AGAA_GLSL_RESOURCE_STORAGE_BLOCK, true);
    return kinds;
}

class GlslResourceLists : public testing::Test {
protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

TEST_F(GlslResourceLists, HaveWhatShadersUse) {
    std::vector<HostDialect> dialects(1);
    dialects[0].descriptorSet = 2;
    for (const AgaaGlConstants constants :
         {AGAA_GL_CONSTANTS_BLOCK, AGAA_GL_CONSTANTS_UNIFORMS, AGAA_GL_CONSTANTS_TEXELS}) {
        HostDialect openGl;
        openGl.openGl = true;
        openGl.storageImages = constants != AGAA_GL_CONSTANTS_BLOCK;
        openGl.constants = constants;
        for (uint32_t i = 0; i < hostBindingCount; ++i)
            openGl.bindings[i] = i + 1;
        dialects.push_back(openGl);
    }
    std::set<uint32_t> kinds;
    std::set<std::string> stages;
    for (const char* technique : {"single", "msaa", "ssaa", "sbaa", "agaa", "dcaa"})
        for (const HostDialect& dialect : dialects)
            for (const bool pulls : {false, true}) {
                const bool shadesInPass = std::string(technique) == "msaa";
                if (shadesInPass && dialect.constants != AGAA_GL_CONSTANTS_BLOCK)
                    continue;
                ViewSpec spec{.technique = technique, .configFlags = AGAA_CONFIG_COUNTERS};
                if (std::string(technique) == "dcaa") {
                    spec.samples = 64;
                    spec.generationTier = AGAA_TIER_MATERIAL_LISTS;
                }
                spec.viewFlags = pulls ? AGAA_VIEW_VERTEX_PULLING : 0;
                const Plan plan = planFor(spec, idealDevice());
                for (const HostPass& pass : makeHostPasses(plan, dialect)) {
                    if (pass.declarations.empty())
                        continue;
                    const auto list = glslResources(pass);
                    kinds.merge(compare(pass, list, dialect, std::string(technique) + ": "));
                    for (const AgaaGlslResource& resource : list)
                        stages.insert(resource.name + std::string(" ") + std::to_string(resource.stages));
                }
            }
    EXPECT_EQ(kinds, (std::set<uint32_t>{1, 2, 3, 4, 5}));
    EXPECT_TRUE(stages.count("agaa_FrameBlock 1"));
    EXPECT_TRUE(stages.count("agaa_FrameBlock 3")); // expanded in a geometry shader
    EXPECT_TRUE(stages.count("agaa_FrameBlock 5")); // expanded in a vertex shader
}

} // namespace
