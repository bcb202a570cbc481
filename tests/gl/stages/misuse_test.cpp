// Misuse of contexts and views on OpenGL, their memory and their order.
#include "bench.h"
#include "context_misuse.h"
#include "dcaa_cases.h"
#include "show.h"

#include "agaa_vk.h"

#include "core/abi/handles.h"

#include <cstdio>

namespace agaa::test {
namespace {

AgaaResult AGAA_CALL nothing(void*) { return AGAA_OK; }
AgaaGlFunction AGAA_CALL noFunction(void*, const char*) { return nullptr; }

TEST(GlMisuse, ContextsAreRefusedInASentence) {
    sharedEgl().makeCurrent();
    const auto rows = contextMisuses<OpenGLContextDesc>({
        {"no functions", AGAA_ERROR_UNSUPPORTED, [](auto& d) { d.device.getProcAddr = noFunction; }},
        {"GLSL 320", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.glslVersion = 320; }},
        {"GLSL 455", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.glslVersion = 455; }},
        {"storage", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.storage = 2; }},
        {"constants", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.constants = 3; }},
        {"constants where metadata are", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& d) {
             d.device.constants = AGAA_GL_CONSTANTS_TEXELS;
             d.device.bindings[AGAA_GL_BINDING_FRAME] = d.device.bindings[AGAA_GL_BINDING_METADATA];
         }},
        {"outputs", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.outputs = 2; }},
        {"policy", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.statePolicy = 3; }},
        {"equal bindings", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_COUNTERS] = 0; }},
        {"equal texture units", AGAA_ERROR_INVALID_ARGUMENT, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_SHADOW3] = 0; }},
        {"lights where the frame is", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& d) {
             d.device.storage = AGAA_GL_STORAGE_IMAGES;
             d.device.bindings[AGAA_GL_BINDING_LIGHTS] = d.device.bindings[AGAA_GL_BINDING_FRAME];
         }},
        {"a binding that is not known", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_COUNT] = 9; }},
        {"frame binding", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_FRAME] = 100000; }},
        {"metadata unit", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_METADATA] = 100000; }},
        {"shadow unit", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_SHADOW0] = 100000; }},
        {"last shadow unit", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_SHADOW3] = ~0u; }},
        {"aggregates binding", AGAA_ERROR_OUT_OF_RANGE, [](auto& d) { d.device.bindings[AGAA_GL_BINDING_AGGREGATES] = 100000; }},
        {"counters image unit", AGAA_ERROR_OUT_OF_RANGE,
         [](auto& d) {
             d.device.storage = AGAA_GL_STORAGE_IMAGES;
             d.device.bindings[AGAA_GL_BINDING_COUNTERS] = 100000;
         }},
        {"no popState", AGAA_ERROR_INVALID_ARGUMENT,
         [](auto& d) {
             d.device.statePolicy = AGAA_GL_STATE_CALLBACKS;
             d.device.pushState = nothing;
         }},
    });
    expectContextsRefused(agaaGlCreateContext, contextDesc(), rows);
    EXPECT_EQ(StageContext().lines.size(), 0u) << "a right one";
    EXPECT_EQ(sharedEgl().takeMessages(), "");
}

TEST(GlMisuse, NeedsACurrentContext) {
    std::vector<LogLine> lines;
    const AgaaLog log = logInto(lines);
    OpenGLContextDesc desc = contextDesc();
    desc.log = &log;
    {
        const EglContext gone(leastContext); // and with it none is current
    }
    AgaaContext context = nullptr;
    EXPECT_EQ(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context), AGAA_ERROR_UNSUPPORTED);
    expectOneSentence(lines, AGAA_ERROR_UNSUPPORTED, "no context");
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    EXPECT_EQ(agaaGlGetDeviceCaps(EglContext::getProcAddr, nullptr, nullptr, &caps),
              AGAA_ERROR_UNSUPPORTED);
    sharedEgl().makeCurrent();
    EXPECT_EQ(agaaGlGetDeviceCaps(EglContext::getProcAddr, nullptr, nullptr, &caps), AGAA_OK);
    EXPECT_EQ(agaaGlGetDeviceCaps(nullptr, nullptr, nullptr, &caps), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGlGetDeviceCaps(EglContext::getProcAddr, nullptr, nullptr, nullptr),
              AGAA_ERROR_INVALID_ARGUMENT);
}

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

TEST(GlMisuse, HandlesOfAnotherBackendAreRefused) {
    Bench bench;
    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    AgaaVkSurface surface = AGAA_VK_SURFACE_INIT;
    AgaaSurface common = AGAA_SURFACE_INIT;
    common.pNext = &surface;
    AgaaVkDrawPass pass = AGAA_VK_DRAW_PASS_INIT;
    AgaaDrawPass passes[2] = {AGAA_DRAW_PASS_INIT, AGAA_DRAW_PASS_INIT};
    passes[0].pNext = &pass;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    const AgaaFrame frame = bench.frame();
    const ViewSettings settings = benchSettings();
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    uint32_t count = 2;
    const auto expect = [&](AgaaResult result, const char* what) {
        EXPECT_EQ(result, AGAA_ERROR_INVALID_ARGUMENT) << what;
        expectOneSentence(bench.context.lines, AGAA_ERROR_INVALID_ARGUMENT, what);
        bench.context.lines.clear();
    };
    expect(agaaVkCreateView(bench.context.get(), &desc, &view), "create a view");
    expect(agaaVkGetContextCaps(bench.context.get(), &caps), "caps");
    expect(agaaVkRecordFrame(bench.view.get(), &frame, &vkFrame), "record");
    const auto expectUnknown = [&](AgaaResult result, const char* what) {
        EXPECT_EQ(result, AGAA_ERROR_UNKNOWN_STRUCT) << what;
        expectOneSentence(bench.context.lines, AGAA_ERROR_UNKNOWN_STRUCT, what);
        bench.context.lines.clear();
    };
    expectUnknown(agaaGetDrawPasses(bench.view.get(), &count, passes), "draw passes");
    expectUnknown(agaaGetSurface(bench.view.get(), "depth", &common), "surface");
}

// Handles of Vulkan need no device to be refused.
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
    StageContext context(OpenGLHost::changed([](OpenGLContextDesc& desc) { desc.device.outputs = AGAA_GL_OUTPUTS_HOST; }));
    const std::string reason = expectRefused(context, dcaaSettings(64, 1, AGAA_TIER_RASTER_ORDER), AGAA_ERROR_UNSUPPORTED, "outputs");
    EXPECT_NE(reason.find("AGAA_GL_OUTPUTS_SDK"), std::string::npos) << reason;
}

} // namespace
} // namespace agaa::test
