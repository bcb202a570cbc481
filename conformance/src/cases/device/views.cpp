// Creation of views on both APIs: every invalid description is refused and leaves no objects.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"

#include "cases/core/wrong_views.h"

namespace agaa::conformance {

namespace {

using Rows = std::vector<WrongView>;

// Views that the device does not support, or whose texts do not compile.
Rows deviceRows(const AgaaDeviceCaps& caps, Backend backend) {
    Rows rows;
    const auto add = [&](const std::string& what, AgaaResult expected, const char* words,
                         std::function<void(ViewParts&)> corrupt) {
        rows.push_back({what, expected, words, std::move(corrupt)});
    };
    constexpr AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT;
    add("an AgaaGBufferFunction and an AgaaFetchFunction", invalid, "AgaaGBufferFunction", [](ViewParts& p) {
        p.chain(p.gbuffer);
        p.chain(p.fetch);
    });
    const auto withShadow = [](ViewParts& p) {
        p.facts.shadowMapCount = 1;
        p.chain(p.shadow);
    };
    for (const char* text : {"float nonsense(", "", "#error no text\n"}) {
        const std::string shown = " with the text \"" + std::string(text).substr(0, 15) + "\"";
        add("an AgaaGBufferFunction" + shown, invalid, "AgaaGBufferFunction", [=](ViewParts& p) {
            p.chain(p.gbuffer);
            p.gbuffer.glsl = text;
        });
        add("an AgaaFetchFunction" + shown, invalid, "AgaaFetchFunction", [=](ViewParts& p) {
            p.chain(p.fetch);
            p.fetch.glsl = text;
        });
        add("an AgaaShadowFunction" + shown, invalid, "AgaaShadowFunction", [=](ViewParts& p) {
            withShadow(p);
            p.shadow.glsl = text;
        });
        add("an AgaaShadingFunction" + shown, invalid, "AgaaShadingFunction", [=](ViewParts& p) {
            p.chain(p.shading);
            p.shading.glsl = text;
        });
    }
    for (const char* lines : {"#define A 1", "#extension GL_AGAA_no_such_extension : require"})
        add(std::string("AgaaShadowFunction::glslExtensions = ") + lines, invalid, "glslExtensions", [=](ViewParts& p) {
            withShadow(p);
            p.shadow.glslExtensions = lines;
        });
    if (!(caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES))
        add("the tier NV_MIXED_SAMPLES", AGAA_ERROR_UNSUPPORTED, "",
            [](ViewParts& p) { p.config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES; });
    if (backend == Backend::Vulkan)
        add("AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE", AGAA_ERROR_UNSUPPORTED, "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE",
            [](ViewParts& p) { p.desc.flags |= AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; });
    const uint32_t limit = caps.maxImageSize;
    for (const char* technique : {"single", "agaa"}) {
        const std::string name = std::string("\"") + technique + "\" and ";
        add(name + "a width of one pixel more than maxImageSize", AGAA_ERROR_TOO_LARGE, "", [=](ViewParts& p) {
            p.config.technique = technique;
            p.desc.width = limit + 1;
        });
        add(name + "a height of one pixel more than maxImageSize", AGAA_ERROR_TOO_LARGE, "", [=](ViewParts& p) {
            p.config.technique = technique;
            p.desc.height = limit + 1;
        });
    }
    return rows;
}

Rows allRows(Test& test, AgaaContext context) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context, &caps), "reading the capabilities of the context");
    Rows rows = wrongViews();
    for (const WrongView& row : deviceRows(caps, test.device().backend()))
        rows.push_back(row);
    return rows;
}

void expectRowRefused(Test& test, ScopedContext& context, const WrongView& row) {
    const std::string function = apiName(test.device(), "CreateView"), what = callWith(function, row.what);
    ViewParts parts(test.sdk, &test.device());
    row.corrupt(parts);
    AgaaView view = untouchedHandle<AgaaView>();
    context.log.lines.clear();
    const AgaaResult result = test.device().createView(test.sdk, context.get(), parts.get(), &view);
    expectRefused(test, result, row.expected, context.log, function, what, row.words);
    if (result == AGAA_OK)
        test.sdk.agaaDestroyView(view);
    else
        test.check(view == untouchedHandle<AgaaView>(), what + " fails and changes outView.");
    if (row.expected == AGAA_ERROR_INVALID_ARGUMENT && test.device().backend() == Backend::OpenGl)
        test.device().takeMessages(); // compilers report messages
    else
        expectNoMessages(test, what);
}

// AGAA_OK stands for all errors. At the end, the destruction of the context shows that it has no views.
void testRows(Test& test, AgaaResult expected) {
    ScopedContext context(test);
    uint32_t count = 0;
    for (const WrongView& row : allRows(test, context.get()))
        if (expected == AGAA_OK || row.expected == expected) {
            expectRowRefused(test, context, row);
            ++count;
        }
    test.check(count > 0, "the test has no rows.");
    ViewParts right(test.sdk, &test.device());
    AgaaView view = nullptr;
    test.requireOk(test.device().createView(test.sdk, context.get(), &right.desc, &view),
                   "a right view after wrong ones");
    test.sdk.agaaDestroyView(view);
}

void testNulls(Test& test) {
    const std::string function = apiName(test.device(), "CreateView");
    ScopedContext context(test);
    ViewParts parts(test.sdk, &test.device());
    AgaaView view = untouchedHandle<AgaaView>();
    test.result(test.device().createView(test.sdk, nullptr, &parts.desc, &view), AGAA_ERROR_INVALID_ARGUMENT,
                function + " with context = null");
    test.check(view == untouchedHandle<AgaaView>(), function + " with context = null changes outView.");
    const auto create =
        test.device().backend() == Backend::Vulkan ? test.sdk.agaaVkCreateView : test.sdk.agaaGlCreateView;
    expectRefused(test, create(context.get(), &parts.desc, nullptr), AGAA_ERROR_INVALID_ARGUMENT, context.log, function,
                  function + " with outView = null", "view");
}

// A view of the largest size is accepted.
void testLargest(Test& test) {
    ScopedContext context(test);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps),
                   "reading the capabilities of the context");
    for (const bool isTall : {false, true}) {
        ViewParts parts(test.sdk, &test.device());
        parts.config.technique = "single";
        parts.desc.width = isTall ? 1 : caps.maxImageSize;
        parts.desc.height = isTall ? caps.maxImageSize : 1;
        AgaaView view = nullptr;
        const AgaaResult result = test.device().createView(test.sdk, context.get(), &parts.desc, &view);
        if (test.result(result, AGAA_OK,
                        std::string("a view of maxImageSize x 1 pixels") + (isTall ? ", upright" : "")))
            test.sdk.agaaDestroyView(view);
    }
}

// The description is read during the call only.
void testDescriptionGone(Test& test) {
    ScopedContext context(test);
    AgaaView view = nullptr;
    {
        auto parts = std::make_unique<ViewParts>(test.sdk, &test.device());
        std::string name = "agaa", text = parts->shadow.glsl;
        parts->config.technique = name.c_str();
        parts->useLayout();
        parts->facts.shadowMapCount = 1;
        parts->chain(parts->shadow);
        parts->shadow.glsl = text.c_str();
        test.requireOk(test.device().createView(test.sdk, context.get(), &parts->desc, &view), "creating a view");
        std::fill(name.begin(), name.end(), '#');
        std::fill(text.begin(), text.end(), '#');
    }
    test.result(test.sdk.agaaResizeView(view, 20, 20), AGAA_OK,
                "agaaResizeView after the strings of the view's description were overwritten");
    test.sdk.agaaDestroyView(view);
}

void testLayoutsOfSets(Test& test) {
    ScopedContext context(test);
    const auto refuse = [&](const char* what, std::function<void(ViewParts&)> corrupt) {
        expectRowRefused(test, context, {what, AGAA_ERROR_INVALID_ARGUMENT, "layout", std::move(corrupt)});
    };
    if (test.device().backend() == Backend::OpenGl) {
        refuse("AgaaGBufferFunction::descriptorSetLayout = 1", [](ViewParts& p) {
            p.chain(p.gbuffer);
            p.gbuffer.descriptorSetLayout = 1;
        });
        refuse("AgaaFetchFunction::descriptorSetLayout = 1", [](ViewParts& p) {
            p.chain(p.fetch);
            p.fetch.descriptorSetLayout = 1;
        });
        refuse("AgaaShadowFunction::descriptorSetLayout = 1", [](ViewParts& p) {
            p.facts.shadowMapCount = 1;
            p.chain(p.shadow);
            p.shadow.descriptorSetLayout = 1;
        });
        return;
    }
    for (const bool isFetch : {false, true})
        refuse("different layouts of set 1", [=](ViewParts& p) { // the call fails before it uses the layouts
            p.facts.shadowMapCount = 1;
            p.shadow.descriptorSetLayout = 1;
            p.gbuffer.descriptorSetLayout = p.fetch.descriptorSetLayout = 2;
            p.chain(p.shadow);
            if (isFetch)
                p.chain(p.fetch);
            else
                p.chain(p.gbuffer);
        });
}

} // namespace

void addViewCases(Suite& suite) {
    for (const auto& [name, code] : {std::pair("AGAA_ERROR_STRUCT", AGAA_ERROR_STRUCT),
                                     std::pair("AGAA_ERROR_UNKNOWN_STRUCT", AGAA_ERROR_UNKNOWN_STRUCT),
                                     std::pair("AGAA_ERROR_OUT_OF_RANGE", AGAA_ERROR_OUT_OF_RANGE),
                                     std::pair("AGAA_ERROR_LAYOUT", AGAA_ERROR_LAYOUT),
                                     std::pair("AGAA_ERROR_UNSUPPORTED", AGAA_ERROR_UNSUPPORTED)})
        addApiCase(suite, "CreateView", name, [code = code](Test& test) { testRows(test, code); });
    addApiCase(suite, "CreateView", "AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        testNulls(test);
        testRows(test, AGAA_ERROR_INVALID_ARGUMENT);
    });
    addApiCase(suite, "CreateView", "AGAA_ERROR_TOO_LARGE", [](Test& test) {
        testLargest(test);
        testRows(test, AGAA_ERROR_TOO_LARGE);
    });
    addApiCase(suite, "CreateView", "outView.unchanged", [](Test& test) {
        testNulls(test);
        testRows(test, AGAA_OK);
    });
    addApiCase(suite, "CreateView", "description_is_copied", testDescriptionGone);
    suite.both("AgaaGBufferFunction.descriptorSetLayout/AGAA_ERROR_INVALID_ARGUMENT", testLayoutsOfSets);
    suite.add("AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE/AGAA_ERROR_UNSUPPORTED", {Backend::Vulkan}, [](Test& test) {
        ScopedContext context(test);
        for (const char* technique : {"single", "msaa", "agaa"})
            for (const uint64_t others : {UINT64_C(0), AGAA_VIEW_REVERSED_Z})
                expectRowRefused(test, context,
                                 {"AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE", AGAA_ERROR_UNSUPPORTED,
                                  "AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE", [=](ViewParts& p) {
                                      p.config.technique = technique;
                                      p.desc.flags |= AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE | others;
                                  }});
    });
}

} // namespace agaa::conformance
