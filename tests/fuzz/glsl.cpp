// Target glsl: texts of the host in the compute passes of views, compiled as the Vulkan backend compiles them.
#include "api_inputs.h"

#include "core/base/error.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/glsl_text.h"
#include "core/plan/planner.h"
#include "core/view/view_settings.h"

namespace fuzz {

namespace {

constexpr const char* fetchText = R"(
void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    a = vec4(0, 0, 0, 1); b = vec4(1, 0, 0, 1); c = vec4(0, 1, 0, 1);
}
void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) { m.diffuse = vec3(0.5); }
)";
constexpr const char* gbufferText = R"(
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    depth = 0.5; m.diffuse = vec3(1.0); return true;
}
)";
constexpr const char* shadowText = R"(
float agaaHostShadow(uint shadow, vec3 position) { return position.x; }
)";
constexpr const char* shadingText = R"(
vec3 agaaShade(AgaaSurface surface) { return surface.diffuse * surface.coverage; }
)";

std::string repeated(const std::string& part, size_t count) {
    std::string text;
    text.reserve(part.size() * count);
    for (size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

// Returns a text that a compiler may not survive: long, deep, unfinished or of other characters.
std::string hardText(Choices& choices) {
    const size_t count = size_t(1) << choices.below(choices.oneIn(20) ? 20 : 11);
    switch (choices.below(24)) {
    case 0:
        return "/* a comment without an end";
    case 1:
        return "#error a host's error " + repeated("x", count) + "\n";
    case 2:
        return "// " + repeated("x", count) + std::string(choices.oneIn(2) ? "\r" : " \\\n/* within the comment\n") +
               "float f14(float x) { return x" + repeated(" + x", count) + "; }\n";
    case 3:
        return "float f0() { return " + repeated("(", count) + "1.0" + repeated(")", count) + "; }\n";
    case 4:
        return "void f1() " + repeated("{", count) + repeated("}", count) + "\n";
    case 5:
        return repeated("#if 1\n", count) + repeated("#endif\n", count - choices.below(2));
    case 6:
        return "float f2(float x) { return x" + repeated(" + x", count) + "; }\n";
    case 7:
        return "float f3(float x) { return " + repeated("-", count) + "x; }\n";
    case 8:
        return "#define A B\n#define B A\nfloat f4 = A;\n";
    case 9:
        return "#include \"math/depth.glsl\"\n#include <file>\n#line 2147483647\n#pragma x\n#version 450\n";
    case 10:
        return "\x01\x7f\xc3\x28 \"unfinished\n";
    case 11:
        return "float f5[" + std::to_string(choices.word()) + "];\n";
    case 12:
        return "struct S0 { float x; };\n" + repeated("struct S" + std::string("1 { S0 x; };\n"), choices.below(3));
    case 13:
        return "float f6(float x) { " + repeated("if (x > 0.0) ", count) + "return x; return 0.0; }\n";
    case 14:
        return "float f7(float x) { return " + repeated("x > 0.0 ? 1.0 : ", count) + "0.0; }\n";
    case 15:
        return "float f8(float x) { return " + repeated("abs(", count) + "x" + repeated(")", count) + "; }\n";
    case 16:
        return "int f9 = " + repeated("9", count) + ";\nfloat f10 = 1e" + repeated("9", count) + ";\n";
    case 17:
        return "void main() {}\nfloat agaa_x, agaaX, gl_x, a__b;\n";
    case 18:
        return "float f11(float x) { " + repeated("for (;;) ", count) + "return x; }\n";
    case 19:
        return "float f12(float x) { " + repeated("x; ", count) + "return x; }\n";
    case 20:
        return "int f13(int x) { return x / 0 + x % 0 + (1 << 77) + int(1.0 / 0.0); }\n";
    case 21:
        return "float f14(float x) { float a[2]; return a" + repeated("[int(x)]", count) + "; }\n";
    case 22:
        return "\\\n" + repeated("\\\n", count) + "\r\n\r";
    default:
        return "float f15(vec4 x) { return x" + repeated(".xyzw", count) + ".x; }\n";
    }
}

std::string hostText(Choices& choices, std::string text) {
    static const char* const tokens[] = {"{",         "}",  "(",  ")",     ";",      "vec3", "float", "= 0.0",
                                         "#define x", "/*", "*/", "inout", "return", "\n",   "m.",    "//"};
    while (choices.oneIn(3)) {
        const size_t at = choices.below(text.size() + 1);
        switch (choices.below(4)) {
        case 0:
            text.insert(at, choices.of(tokens));
            break;
        case 1:
            text.erase(at, choices.below(16));
            break;
        case 2:
            text.insert(at, 1, char(1 + choices.below(255)));
            break;
        default:
            text.insert(0, hardText(choices));
        }
    }
    if (choices.oneIn(2))
        text += hardText(choices);
    return text;
}

} // namespace

void runGlsl(Choices& choices) {
    Memory memory(choices);
    AgaaConfig config = AGAA_CONFIG_INIT;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = view.height = 64;
    view.config = &config;
    view.facts = &facts;
    config.samples = 4;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    AgaaGBufferFunction gbuffer = AGAA_GBUFFER_FUNCTION_INIT;
    AgaaShadowFunction shadow = AGAA_SHADOW_FUNCTION_INIT;
    AgaaShadingFunction shading = AGAA_SHADING_FUNCTION_INIT;
    shading.level = AGAA_SHADING_EVENT;
    fetch.maxDraws = fetch.maxPrimitives = 100;
    shadow.shadows = 1;
    const auto chain = [&](auto& function, const char* usual) {
        function.glsl = memory.text(hostText(choices, usual));
        function.pNext = view.pNext;
        view.pNext = &function;
    };
    const uint64_t kind = choices.below(3);
    if (kind == 0)
        chain(fetch, fetchText);
    else if (kind == 1)
        chain(gbuffer, gbufferText);
    if (kind == 2 || choices.oneIn(4))
        chain(shadow, shadowText);
    if (choices.oneIn(4))
        chain(shading, shadingText);

    // A compilation takes milliseconds, so one pass of the view is enough.
    static const agaa::GlslCompilerUse compilerUse;
    const char* step = "planning";
    try {
        const agaa::Plan plan = agaa::makePlan(agaa::resolveView(&view, agaa::techniques()), agaa::idealDevice(), 2);
        step = "compiling";
        for (const agaa::Pass& pass : plan.passes)
            if (pass.kind() == agaa::PassKind::Compute && !pass.compute().hostCode.empty()) {
                agaa::compileCompute(agaa::passGlsl(pass), pass.compute().hostCodeOrigin.c_str());
                break;
            }
        countAccepted();
    } catch (const agaa::Error& error) {
        if (error.code != AGAA_ERROR_INVALID_ARGUMENT)
            report(std::string("an error while ") + step + ": " + error.message);
        if (!error.message.ends_with('.'))
            report("a message without a full stop: " + error.message);
        checkLine(step, error.message);
    }
}

} // namespace fuzz
