// Text of hosts: names in messages, and GLSL that compilers do not survive.
#include "plan_support.h"

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/expression_depth.h"
#include "core/glsl/glsl_text.h"

#include <gtest/gtest.h>

using namespace agaa;

namespace {

std::string repeated(const std::string& part, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

TEST(Printable, EscapesWhatIsNotUtf8OfOneLine) {
    EXPECT_EQ(printable("a b\n\x7f"), "a b\\x0A\\x7F");
    EXPECT_EQ(printable("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
    EXPECT_EQ(printable("\xff\xc3\x28\x80"), "\\xFF\\xC3(\\x80");              // no character begins like these
    EXPECT_EQ(printable("\xc0\xaf\xed\xa0\x80"), "\\xC0\\xAF\\xED\\xA0\\x80"); // too long, and a surrogate
    EXPECT_EQ(printable("\xc2\x85\xe2\x80\xa8"), "\\xC2\\x85\\xE2\\x80\\xA8"); // line breaks
    EXPECT_EQ(printable("\xe2\x82"), "\\xE2\\x82"); // the end of the text is within a character
    EXPECT_EQ(printable("abc\xC3\xA9", 4), "abc");  // the limit is within a character
    EXPECT_EQ(printable(std::string(100, 'x')), std::string(64, 'x'));
}

std::string messageOf(const std::string& glsl) {
    try {
        compileCompute("#version 450\nlayout(local_size_x = 1) in;\n" + glsl + "\nvoid main() {}\n", "The text");
    } catch (const Error& error) {
        EXPECT_EQ(error.code, AGAA_ERROR_INVALID_ARGUMENT);
        return error.message;
    }
    return {};
}

TEST(HostText, CompilerMessagesAreOneLine) {
    for (const std::string& glsl :
         {std::string("\x01"), std::string("float \x7f\xff;"), "#error " + repeated("x", 1 << 20),
          "#error \xc3" + repeated("\xa9", 700), repeated("float x;", 1 << 17), std::string("/* no end")}) {
        const std::string message = messageOf(glsl);
        EXPECT_TRUE(message.starts_with("The text does not compile: ")) << message;
        EXPECT_TRUE(message.ends_with('.')) << message;
        EXPECT_LT(message.size(), 600u);
        EXPECT_EQ(message, printable(message, message.size()));
    }
}

TEST(HostText, DepthCountsOperatorsAndBrackets) {
    EXPECT_EQ(expressionDepth(""), 0u);
    EXPECT_EQ(expressionDepth("float f() { return 1.0; }"), 3u); // "float f", "f(", "{ return 1.0"
    EXPECT_GT(expressionDepth("float f(float x) { return x" + repeated(" + x", 501) + "; }"), maxExpressionDepth);
    EXPECT_GT(expressionDepth("vec4 f(vec4 x) { return x" + repeated(".xyzw", 501) + "; }"), maxExpressionDepth);
    EXPECT_GT(expressionDepth("float f(float x) { return (" + repeated("x, ", 501) + "x); }"), maxExpressionDepth);
    EXPECT_GT(expressionDepth("void f() { for (;;x" + repeated(", x", 501) + ") {} }"), maxExpressionDepth);
    for (const std::string part : {"(", "abs(", "[", "{", "-", "!", "if (x) ", "for (;;) ", "if (x) { } else ",
                                   "if (x) y; else ", "x ? y : ", "x = ", "do ", "while (x) "})
        EXPECT_GT(expressionDepth("void f() { " + repeated(part, 501)), maxExpressionDepth) << part;
    EXPECT_GT(expressionDepth("#define A x" + repeated(" + x", 501) + "\n"), maxExpressionDepth);
    const std::string deep = "float f(float x) { return x" + repeated(" + x", 501) + "; }";
    for (const std::string lineEnd : {"\n", "\r", "\r\n"}) {
        EXPECT_GT(expressionDepth("#define A x \\" + lineEnd + repeated(" + x \\" + lineEnd, 501) + lineEnd),
                  maxExpressionDepth);
        EXPECT_GT(expressionDepth("// a comment" + lineEnd + deep), maxExpressionDepth);
        EXPECT_GT(expressionDepth("#define A" + lineEnd + deep), maxExpressionDepth);
        EXPECT_GT(expressionDepth("// a comment \\" + lineEnd + "/* within it" + lineEnd + deep), maxExpressionDepth);
        EXPECT_LT(expressionDepth("/\\" + lineEnd + "/ " + deep), 30u) << "a comment";
    }
}

TEST(HostText, DepthDoesNotCountLengths) {
    const std::string sum = "x + y * z.x - abs(w)";
    for (const std::string& glsl :
         {"float t[9999] = float[](" + repeated("-1.0, ", 9999) + "1.0);",
          "float t[9999] = {" + repeated("-1.0, ", 9999) + "1.0};",
          "float t[2][9999] = {{" + repeated("-1.0, ", 9999) + "1.0}, {" + repeated("-1.0, ", 9999) + "}};",
          "void f() { g(" + repeated(sum + ", ", 9999) + "); }", "void f() { " + repeated(sum + "; ", 9999) + "}",
          "void f() { " + repeated("if (" + sum + ") { " + sum + "; } ", 9999) + "}",
          "void f() { " + repeated("if (x) y = " + sum + "; ", 9999) + "}",
          "void f() { switch (x) { " + repeated("case 1: x = " + sum + "; break; ", 9999) + "} }",
          repeated("#define A " + sum + "\n", 9999), repeated("// ((((((((\n/* {{{{{{{ */\n", 9999),
          repeated("float f(float x, float y) { return " + sum + "; }\n", 9999),
          repeated("struct S { float a, b; vec3 c; };\nuniform sampler2D t;\n", 9999)})
        EXPECT_LT(expressionDepth(glsl), 30u) << glsl.substr(0, 80);
}

// Without the limit the compiler ends the process: from 10,500 operators on with a stack of 8 MiB, from 1,330 on with
// 1 MiB.
TEST(HostText, ViewsRefuseTextThatIsTooDeepForCompilers) {
    for (const std::string& body : {"x" + repeated(" + x", 200000), "vec4(x)" + repeated(".xxxx", 200000) + ".x",
                                    "(" + repeated("x, ", 200000) + "x)", repeated("abs(", 3000) + "x"}) {
        const std::string text = "float agaaHostShadow(uint s, vec3 p) { float x = p.x; return " + body + "; }";
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = text.c_str();
        function.shadows = 1;
        test::TechniqueConfig config;
        AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
        AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
        desc.width = desc.height = 64;
        desc.config = &config;
        desc.facts = &facts;
        desc.pNext = &function;
        const Plan plan = makePlan(resolveView(&desc, techniques()), idealDevice(), 2);
        uint32_t refused = 0;
        for (const Pass& pass : plan.passes)
            if (pass.kind() == PassKind::Compute && !pass.compute().hostCode.empty()) {
                try {
                    compileCompute(passGlsl(pass), pass.compute().hostCodeOrigin.c_str());
                } catch (const Error& error) {
                    EXPECT_EQ(error.code, AGAA_ERROR_INVALID_ARGUMENT);
                    EXPECT_EQ(error.message, "AgaaShadowFunction::glsl is nested more than 500 levels deep.");
                    ++refused;
                }
                EXPECT_THROW(passGlslForOpenGl(pass, 450), Error);
            }
        EXPECT_GT(refused, 0u) << body.substr(0, 20);
    }
}

} // namespace
