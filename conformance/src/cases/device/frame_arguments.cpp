// Pointers, handles and structs that a frame needs.
#include "cases.h"
#include "frame_rig.h"

namespace agaa::conformance {

namespace {

struct ArgumentRow {
    std::string what; // for example "a null AgaaFrame"
    std::string words;
    RecordHook hook;
    AgaaResult code = AGAA_ERROR_INVALID_ARGUMENT;
    bool mayReport = false;
};

template <class Native> RecordHook changed(const std::function<void(Native&)>& change) {
    return [change](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
        Native copy = *static_cast<const Native*>(native);
        change(copy);
        return call(view, frame, &copy);
    };
}
constexpr auto vk = changed<AgaaVkFrame>;
constexpr auto gl = changed<AgaaGlFrame>;

std::vector<ArgumentRow> pointers(const std::string& nativeName) {
    return {{"a null AgaaFrame", "AgaaFrame",
             [](const RecordCall& call, AgaaView view, const AgaaFrame*, const void* native) {
                 return call(view, nullptr, native);
             }},
            {"a null " + nativeName, nativeName,
             [](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void*) {
                 return call(view, frame, nullptr);
             }},
            {"AgaaFrame::draw = null", "AgaaFrame::draw",
             [](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
                 AgaaFrame copy = *frame;
                 copy.draw = nullptr;
                 return call(view, &copy, native);
             }}};
}

void testRows(Rig& rig, const std::vector<ArgumentRow>& rows, const Image& expected,
              const Rig::ChangeFrame& changeFrame = {}) {
    for (const ArgumentRow& row : rows) {
        AgaaFrame frame = rig.nextFrame();
        if (changeFrame)
            changeFrame(frame);
        expectFrameRefused(rig, frame, {row.code, rig.function() + " with " + row.what, row.words, row.mayReport},
                           expected, row.hook);
    }
}

// A call with a null view has no log.
void testNullView(Rig& rig) {
    AgaaFrame frame = rig.nextFrame();
    const AgaaResult result = rig.record(
        frame, [](const RecordCall& call, AgaaView, const AgaaFrame* f, const void* n) { return call(nullptr, f, n); });
    rig.test.result(result, AGAA_ERROR_INVALID_ARGUMENT, rig.function() + " with a null view");
    rig.context.log.lines.clear();
}

void allowShadows(ViewDescription& description) { description.facts.shadowMapCount = 2; }

const AgaaShadow plainShadow = AGAA_SHADOW_INIT;
const AgaaShadow twoShadows[] = {plainShadow, plainShadow};
void useShadows(AgaaFrame& frame) {
    frame.shadows = twoShadows;
    frame.shadowCount = 2;
}

void testVk(Test& test) {
    Rig rig(test, allowShadows);
    const Image expected = rig.render();
    testNullView(rig);
    std::vector<ArgumentRow> rows = pointers("AgaaVkFrame");
    rows.push_back({"commandBuffer = null", "commandBuffer", vk([](AgaaVkFrame& f) { f.commandBuffer = nullptr; })});
    rows.push_back({"outputImage = 0", "output", vk([](AgaaVkFrame& f) { f.outputImage = 0; })});
    rows.push_back({"outputView = 0", "output", vk([](AgaaVkFrame& f) { f.outputView = 0; })});
    // The view declares shadow maps, so the first one is needed even if the frame has no shadows.
    rows.push_back({"shadowViews[0] = 0", "shadowViews[0]", vk([](AgaaVkFrame& f) { f.shadowViews[0] = 0; })});
    testRows(rig, rows, expected);
    testRows(
        rig,
        {{"two shadows and shadowViews[1] = 0", "shadowViews[1]", vk([](AgaaVkFrame& f) { f.shadowViews[1] = 0; })}},
        expected, useShadows);
    rig.device().changeVkFrame = [](AgaaVkFrame& f) { f.shadowViews[1] = f.shadowViews[2] = f.shadowViews[3] = 0; };
    expectNextFrame(rig, expected, "a frame without shadows and shadowViews that are 0 but for the first");
    rig.device().changeVkFrame = nullptr;
}

void testGl(Test& test) {
    Rig rig(test, allowShadows);
    const Image expected = rig.render();
    testNullView(rig);
    std::vector<ArgumentRow> rows = pointers("AgaaGlFrame");
    rows.push_back({"outputTexture = 0", "outputTexture", gl([](AgaaGlFrame& f) { f.outputTexture = 0; })});
    rows.push_back({"an outputTexture that does not exist", "outputTexture",
                    gl([](AgaaGlFrame& f) { f.outputTexture = 0x7F000001; })});
    rows.push_back({"an outputTexture of another target", "outputTexture",
                    gl([](AgaaGlFrame& f) { f.outputTexture = f.shadowTextures[0]; }), AGAA_ERROR_INVALID_ARGUMENT,
                    true});
    testRows(rig, rows, expected);
    testRows(rig,
             {{"two shadows and shadowTextures[1] = 0", "shadowTextures[1]",
               gl([](AgaaGlFrame& f) { f.shadowTextures[1] = 0; })},
              {"a shadowTextures[0] that does not exist", "shadowTextures[0]",
               gl([](AgaaGlFrame& f) { f.shadowTextures[0] = 0x7F000001; })},
              {"a shadowTextures[1] of another target", "shadowTextures[1]",
               gl([](AgaaGlFrame& f) { f.shadowTextures[1] = f.outputTexture; }), AGAA_ERROR_INVALID_ARGUMENT, true}},
             expected, useShadows);
    rig.device().changeGlFrame = [](AgaaGlFrame& f) { std::fill(f.shadowTextures, f.shadowTextures + 4, 0u); };
    expectNextFrame(rig, expected, "a frame without shadows and shadowTextures that are 0");
    rig.device().changeGlFrame = nullptr;
}

// Segments that do not write the output need neither it nor shadow maps.
void testPrepassNeedsLess(Test& test) {
    Rig rig(test, allowShadows);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    const auto less = [](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
        return call(view, f, native);
    };
    rig.device().changeVkFrame = [](AgaaVkFrame& f) { f.outputImage = f.outputView = f.shadowViews[0] = 0; };
    rig.device().changeGlFrame = [](AgaaGlFrame& f) { f.outputTexture = f.shadowTextures[0] = 0; };
    frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
    const AgaaResult result = rig.record(frame, less);
    rig.device().changeVkFrame = nullptr;
    rig.device().changeGlFrame = nullptr;
    test.requireOk(result, rig.function() + " without the shading segment and without an output");
    frame.segments = AGAA_SEGMENT_SHADING;
    test.requireOk(rig.record(frame), rig.function() + " with the shading segment");
    expectSame(test, rig.device().readOutput(), expected, rig.description().desc.width, "a frame in two segments");
    rig.expectNoMessages(rig.function());
}

void testOtherApi(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    const bool isVk = rig.device().backend() == Backend::Vulkan;
    const AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    const AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    frame.draw = Device::drawCallback;
    rig.context.log.lines.clear();
    const AgaaResult result = isVk ? test.sdk.agaaGlRecordFrame(rig.view.get(), &frame, &glFrame)
                                   : test.sdk.agaaVkRecordFrame(rig.view.get(), &frame, &vkFrame);
    const std::string other = isVk ? "agaaGlRecordFrame" : "agaaVkRecordFrame";
    expectRefused(test, result, AGAA_ERROR_INVALID_ARGUMENT, rig.context.log, other,
                  other + " with a view of the other API", "view");
    expectNextFrame(rig, expected, other + " with a view of the other API");
}

template <class Native> void addStructRows(std::vector<ArgumentRow>& rows, const std::string& name) {
    for (const uint32_t size : {0u, 8u, uint32_t(sizeof(Native)) - 8}) {
        const auto hook = changed<Native>([size](Native& f) { f.structSize = size; });
        rows.push_back({name + "::structSize = " + std::to_string(size), name, hook, AGAA_ERROR_STRUCT});
    }
    rows.push_back({name + "::sType = 0", name, changed<Native>([](Native& f) { f.sType = 0; }), AGAA_ERROR_STRUCT});
}

void testStructs(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    std::vector<ArgumentRow> rows;
    if (rig.device().backend() == Backend::Vulkan)
        addStructRows<AgaaVkFrame>(rows, "AgaaVkFrame");
    else
        addStructRows<AgaaGlFrame>(rows, "AgaaGlFrame");
    testRows(rig, rows, expected);
    for (const bool isType : {true, false}) {
        AgaaFrame frame = rig.nextFrame();
        (isType ? frame.sType : frame.structSize) = 0;
        expectFrameRefused(
            rig, frame, {AGAA_ERROR_STRUCT, rig.function() + " with an AgaaFrame that is not initialised", "AgaaFrame"},
            expected);
    }
}

} // namespace

void addFrameArgumentCases(Suite& suite) {
    suite.add("agaaVkRecordFrame/AGAA_ERROR_INVALID_ARGUMENT", {Backend::Vulkan}, testVk);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_INVALID_ARGUMENT", {Backend::OpenGl}, testGl);
    suite.add("agaaVkRecordFrame/AGAA_ERROR_INVALID_ARGUMENT/other_api", {Backend::OpenGl}, testOtherApi);
    suite.add("agaaGlRecordFrame/AGAA_ERROR_INVALID_ARGUMENT/other_api", {Backend::Vulkan}, testOtherApi);
    addRecordCase(suite, "AGAA_ERROR_INVALID_ARGUMENT/only_what_is_needed", testPrepassNeedsLess);
    addRecordCase(suite, "AGAA_ERROR_STRUCT", testStructs);
}

} // namespace agaa::conformance
