// Extensions of a function of the host's, in words of Vulkan's compiler; test_gl_stages knows OpenGL's.
#include "stage_host.h"

namespace agaa::test {
namespace {

TEST(VkShadowFunction, MayNeedExtensions) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) {\n"
                    "    [[flatten]] if (position.x > 0.0) return 1.0;\n"
                    "    return 0.0;\n"
                    "}";
    function.shadows = 1;
    ViewSettings settings;
    settings.chained = &function;
    expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "without the extension");
    for (const char* lines : {"#extension GL_EXT_control_flow_attributes : require",
                              "\r\n#extension  GL_EXT_control_flow_attributes:enable \r\n\n"}) {
        function.glslExtensions = lines;
        EXPECT_NO_THROW(StageView(context, settings)) << lines;
    }
    function.glslExtensions = "#extension GL_EXT_no_such_extension : require";
    const std::string unknown = expectRefused(context, settings, AGAA_ERROR_INVALID_ARGUMENT, "an unknown extension");
    EXPECT_NE(unknown.find("::glslExtensions does not compile: 0:1:"), std::string::npos) << unknown;
}

} // namespace
} // namespace agaa::test
