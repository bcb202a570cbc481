// Calls of agaaGetDrawPasses that must fail.
#include "cases.h"
#include "frame_rig.h"

#include <cstring>

namespace agaa::conformance {

namespace {

const AgaaDrawPass unsetPass = AGAA_DRAW_PASS_INIT;

struct Arguments {
    Arguments(Test& test, AgaaView theView) : view(theView) {
        const AgaaVkDrawPass initialVk = AGAA_VK_DRAW_PASS_INIT;
        const AgaaGlDrawPass initialGl = AGAA_GL_DRAW_PASS_INIT;
        vk = initialVk;
        gl = initialGl;
        test.requireOk(test.sdk.agaaGetDrawPasses(view, &length, nullptr), "agaaGetDrawPasses");
        array.assign(length, unsetPass);
        isVk = test.device().backend() == Backend::Vulkan;
    }
    AgaaView view;
    uint32_t length = 0;
    uint32_t* count = &length;
    std::vector<AgaaDrawPass> array;
    bool isNull = false; // passes
    AgaaVkDrawPass vk;
    AgaaGlDrawPass gl;
    AgaaStructHeader unknown = {farStructType, sizeof(AgaaStructHeader), nullptr};
    bool isVk;
    void chain(bool isSameApi) { array.back().pNext = isSameApi == isVk ? static_cast<void*>(&vk) : &gl; }
};

struct WrongCall {
    std::string what;
    AgaaResult code;
    std::function<void(Arguments&)> corrupt;
};

const std::vector<WrongCall>& wrongCalls() {
    static const std::vector<WrongCall> calls = {
        {"a null view", AGAA_ERROR_INVALID_ARGUMENT, [](Arguments& a) { a.view = nullptr; }},
        {"count = null", AGAA_ERROR_INVALID_ARGUMENT, [](Arguments& a) { a.count = nullptr; }},
        {"count and passes = null", AGAA_ERROR_INVALID_ARGUMENT,
         [](Arguments& a) {
             a.count = nullptr;
             a.isNull = true;
         }},
        {"a last element of another type", AGAA_ERROR_STRUCT,
         [](Arguments& a) { a.array.back().sType = AGAA_STRUCTURE_TYPE_SURFACE; }},
        {"a last element of structSize 8", AGAA_ERROR_STRUCT, [](Arguments& a) { a.array.back().structSize = 8; }},
        {"a chained struct of structSize 8", AGAA_ERROR_STRUCT,
         [](Arguments& a) {
             a.chain(true);
             a.vk.structSize = a.gl.structSize = 8;
         }},
        {"the struct of the other API chained", AGAA_ERROR_UNKNOWN_STRUCT, [](Arguments& a) { a.chain(false); }},
        {"an unknown struct chained", AGAA_ERROR_UNKNOWN_STRUCT,
         [](Arguments& a) { a.array.back().pNext = &a.unknown; }},
        {"count = 0", AGAA_ERROR_BUFFER_TOO_SMALL, [](Arguments& a) { a.length = 0; }},
        {"one element less than there are passes", AGAA_ERROR_BUFFER_TOO_SMALL, [](Arguments& a) { --a.length; }}};
    return calls;
}

template <class T> bool isSame(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size() * sizeof(T));
}

// Runs the calls that fail with `code`; AGAA_OK selects all calls.
void testCalls(Test& test, AgaaResult code) {
    const char* technique = "agaa"; // has more than one draw pass on most devices
    ScopedContext context(test);
    ViewDescription description(&test.device());
    setTechnique(description, technique, 4);
    const BareView view(test, context.get(), description);
    for (const WrongCall& call : wrongCalls()) {
        if (code != AGAA_OK && call.code != code)
            continue;
        Arguments a(test, view.get());
        call.corrupt(a);
        const uint32_t length = a.length;
        const std::vector<AgaaDrawPass> before = a.array;
        const AgaaVkDrawPass vk = a.vk;
        const AgaaGlDrawPass gl = a.gl;
        context.log.lines.clear();
        const AgaaResult result = test.sdk.agaaGetDrawPasses(a.view, a.count, a.isNull ? nullptr : a.array.data());
        const std::string what = "agaaGetDrawPasses with " + call.what;
        if (a.view)
            expectRefused(test, result, call.code, context.log, "agaaGetDrawPasses", what);
        else
            test.result(result, call.code, what);
        test.check(a.length == length, what + " fails and changes count.");
        test.check(isSame(a.array, before), what + " fails and changes passes.");
        test.check(!std::memcmp(&vk, &a.vk, sizeof vk) && !std::memcmp(&gl, &a.gl, sizeof gl),
                   what + " fails and changes a chained struct.");
    }
}

} // namespace

void addDrawPassErrorCases(Suite& suite) {
    const struct {
        const char* name;
        AgaaResult code;
    } rows[] = {{"AGAA_ERROR_INVALID_ARGUMENT", AGAA_ERROR_INVALID_ARGUMENT},
                {"AGAA_ERROR_STRUCT", AGAA_ERROR_STRUCT},
                {"AGAA_ERROR_UNKNOWN_STRUCT", AGAA_ERROR_UNKNOWN_STRUCT},
                {"AGAA_ERROR_BUFFER_TOO_SMALL", AGAA_ERROR_BUFFER_TOO_SMALL},
                {"count.unchanged", AGAA_OK},
                {"passes.unchanged", AGAA_OK}};
    for (const auto& row : rows)
        suite.both(std::string("agaaGetDrawPasses/") + row.name,
                   [code = row.code](Test& test) { testCalls(test, code); });
}

} // namespace agaa::conformance
