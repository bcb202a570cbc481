// Views that OpenGL refuses for what the host declares, handles of Vulkan, and contexts beside each other.
#include "bench.h"
#include "dcaa_cases.h"
#include "show.h"

#include "core/frame/context.h"

#include <cstdio>

namespace agaa::test {
namespace {

bool hasExtension(const GladGLContext& gl, const std::string& name) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i))) == name)
            return true;
    return false;
}

TEST(GlMisuse, FunctionsOfViewsAreRefusedInASentence) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }";
    function.shadows = 1;
    ViewSettings settings = benchSettings();
    settings.chained = &function;
    EXPECT_NO_THROW(StageView(context, settings)) << "a function";
    function.descriptorSetLayout = 5;
    expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "a set layout of Vulkan's");
    function.descriptorSetLayout = 0;
    function.glsl = "float x = ;";
    expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, function.glsl);
    sharedEgl().takeMessages(); // of drivers that tell of it too
    if (hasExtension(sharedEgl().gl(), "GL_ARB_shader_group_vote")) {
        function.glsl = "float agaaHostShadow(uint shadow, vec3 p) { return anyInvocationARB(true) ? 1.0 : 0.0; }";
        expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "without the extension");
        function.glslExtensions = "#extension GL_ARB_shader_group_vote : require";
        EXPECT_NO_THROW(StageView(context, settings)) << "with the extension";
        sharedEgl().takeMessages();
    } else {
        std::printf("Extensions of the host's code are not tried: no GL_ARB_shader_group_vote.\n");
    }
}

// The conformance suite tests the same with a Vulkan device. Here the handle needs none.
TEST(GlMisuse, HandlesOfVulkanAreRefused) {
    std::vector<LogLine> lines;
    const AgaaLog log = logInto(lines);
    AgaaContextDesc commonDesc = AGAA_CONTEXT_DESC_INIT;
    commonDesc.log = &log;
    AgaaContext_T vulkan(Backend::Vulkan, commonDesc);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    EXPECT_EQ(agaaGlGetContextCaps(&vulkan, &caps), AGAA_ERROR_INVALID_ARGUMENT);
    expectOneSentence(lines, AGAA_ERROR_INVALID_ARGUMENT, "caps");
    lines.clear();
    const ViewSettings settings = benchSettings();
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    EXPECT_EQ(agaaGlCreateView(&vulkan, &desc, &view), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(view, nullptr);
    expectOneSentence(lines, AGAA_ERROR_INVALID_ARGUMENT, "view");
}

// Two views of one context, and another OpenGL context beside it.
TEST(GlLifetime, ViewsAndContextsDoNotDisturbEachOther) {
    Bench bench;
    const std::vector<float> expected = bench.picture();
    ViewSettings settings = benchSettings();
    settings.width = 31;
    settings.height = 17;
    settings.config.technique = "ssaa";
    StageView second(bench.context, settings);
    second.setTriangles(randomTriangles({.triangles = 20}, 42));
    AgaaFrame frame = second.frame();
    setLight(frame, bench.light);
    bench.light.shadowMap = AGAA_NO_SHADOW;
    AgaaGlFrame glFrame = second.glFrame();
    glFrame.shadowTextures[0] = bench.map.get();
    second.render(frame, glFrame);
    const std::vector<float> other = second.image();
    bench.light.shadowMap = 0;
    {
        EglContext egl(leastContext);
        Bench beside(benchSettings(), contextDesc(), egl);
        EXPECT_EQ(beside.picture(), expected);
        sharedEgl().makeCurrent();
        EXPECT_EQ(bench.picture(), expected);
        egl.makeCurrent();
        EXPECT_EQ(beside.picture(), expected);
    }
    sharedEgl().makeCurrent();
    EXPECT_EQ(bench.picture(), expected);
    EXPECT_EQ(second.image(), other);
}

// Outputs that the host declares are not read.
TEST(GlMisuse, AttachmentsOfHostOutputsAreNotRead) {
    StageContext context(
        OpenGLHost::changed([](OpenGLContextDesc& desc) { desc.device.outputs = AGAA_GL_OUTPUTS_HOST; }));
    const std::string reason =
        expectRefused(context, dcaaSettings(64, 1, AGAA_TIER_RASTER_ORDER), AGAA_ERROR_UNSUPPORTED, "outputs");
    EXPECT_NE(reason.find("AGAA_GL_OUTPUTS_SDK"), std::string::npos) << reason;
}

} // namespace
} // namespace agaa::test
