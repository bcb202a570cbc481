// Contexts on both APIs: AgaaContextDesc, and the order of destruction.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"

#include "cases/core/header_check.h"

namespace agaa::conformance {

namespace {

// The technique whose views are created fastest.
void useSingle(ViewDescription& description) {
    description.config.technique = "single";
    description.config.samples = 1;
}

std::vector<ContextRow> allRows(const Device& device) {
    std::vector<ContextRow> rows = wrongContexts();
    const bool isVulkan = device.backend() == Backend::Vulkan;
    for (const ContextRow& row : isVulkan ? wrongVulkanContexts(device) : wrongOpenGlContexts())
        rows.push_back(row);
    return rows;
}

void testRowsOf(Test& test, AgaaResult expected) { testContextRows(test, rowsOf(allRows(test.device()), expected)); }

void testVersions(Test& test) {
    const uint32_t version = test.sdk.agaaGetVersion();
    const std::string function = apiName(test.device(), "CreateContext");
    const auto create = [&](uint32_t headerVersion, LogRecorder& log, AgaaContext* context) {
        ContextDescription description = test.device().description();
        description.desc.log = log.get();
        return test.device().createContext(test.sdk, headerVersion, description, context);
    };
    for (const uint32_t wrong : {0u, version + (1u << 12), version - (1u << 12), version + (1u << 22), 0xFFFFFFFFu}) {
        LogRecorder log;
        AgaaContext context = untouchedHandle<AgaaContext>();
        expectRefused(test, create(wrong, log, &context), AGAA_ERROR_VERSION, log, function,
                      function + " with headerVersion = " + std::to_string(wrong), "version");
        test.check(context == untouchedHandle<AgaaContext>(), function + " fails and changes outContext.");
    }
    // Headers with another patch of the same minor version are accepted.
    for (const uint32_t right : {version & ~0xFFFu, version | 0xFFFu}) {
        LogRecorder log;
        AgaaContext context = nullptr;
        if (test.result(create(right, log, &context), AGAA_OK,
                        function + " with headerVersion = " + std::to_string(right)))
            test.sdk.agaaDestroyContext(context);
    }
}

// Tests calls without a description or without outContext.
void testNulls(Test& test) {
    const bool isVulkan = test.device().backend() == Backend::Vulkan;
    const std::string function = apiName(test.device(), "CreateContext");
    const auto create = isVulkan ? test.sdk.agaaVkCreateContext : test.sdk.agaaGlCreateContext;
    AgaaContext context = untouchedHandle<AgaaContext>();
    test.result(create(AGAA_HEADER_VERSION, nullptr, &context), AGAA_ERROR_INVALID_ARGUMENT,
                function + " with desc = null");
    test.check(context == untouchedHandle<AgaaContext>(), function + " with desc = null changes outContext.");
    ContextDescription description = test.device().description();
    LogRecorder log;
    description.desc.log = log.get();
    expectRefused(test, create(AGAA_HEADER_VERSION, &description.desc, &context), AGAA_ERROR_INVALID_ARGUMENT, log,
                  function, function + " without a chain", "DeviceDesc");
    description.desc.pNext = isVulkan ? static_cast<const void*>(&description.vk) : &description.gl;
    expectRefused(test, create(AGAA_HEADER_VERSION, &description.desc, nullptr), AGAA_ERROR_INVALID_ARGUMENT, log,
                  function, function + " with outContext = null", "context");
}

void testLogNull(Test& test) {
    expectContextAccepted(test, "AgaaContextDesc::log = null", [](ContextDescription& d) { d.desc.log = nullptr; });
    expectContextRefused(test, {"AgaaContextDesc::log = null and framesInFlight = 0", AGAA_ERROR_OUT_OF_RANGE, "",
                                [](ContextDescription& d) {
                                    d.desc.log = nullptr;
                                    d.desc.framesInFlight = 0;
                                },
                                true});
    const AgaaLog noCallback = AGAA_LOG_INIT;
    expectContextAccepted(test, "AgaaLog::callback = null", [&](ContextDescription& d) { d.desc.log = &noCallback; });
    // The SDK copies the log: the host's struct changes before the context reports.
    LogRecorder log;
    AgaaLog hostLog = *log.get();
    ScopedContext context(test, [&](ContextDescription& d) { d.desc.log = &hostLog; });
    hostLog.callback = nullptr;
    hostLog.user = nullptr;
    ViewDescription description(&test.device());
    description.desc.width = 0;
    AgaaView view = nullptr;
    expectRefused(test, test.device().createView(test.sdk, context.get(), &description.desc, &view),
                  AGAA_ERROR_OUT_OF_RANGE, log, apiName(test.device(), "CreateView"),
                  "a context whose AgaaLog was overwritten", "width");
}

// If framesInFlight is f, at most f frames may be unfinished.
void testFramesInFlight(Test& test) {
    for (uint32_t frames = 1; frames <= 8; ++frames) {
        const std::string what = "AgaaContextDesc::framesInFlight = " + std::to_string(frames);
        Rig rig(test, useSingle, [=](ContextDescription& d) { d.desc.framesInFlight = frames; });
        for (uint64_t i = 1; i <= frames + 1; ++i) {
            AgaaFrame frame = rig.nextFrame();
            frame.frameIndex = i;
            frame.completedFrame = 0;
            test.result(rig.record(frame), i <= frames ? AGAA_OK : AGAA_ERROR_WRONG_ORDER,
                        what + ", frame " + std::to_string(i) + " while no frame is completed");
        }
        rig.context.log.lines.clear();
    }
    testContextRows(test, [] {
        std::vector<ContextRow> rows;
        for (const ContextRow& row : wrongContexts())
            if (row.words == "framesInFlight")
                rows.push_back(row);
        return rows;
    }());
}

void testReserved(Test& test) {
    for (const ContextRow& row : wrongContexts())
        if (row.words == "reserved")
            expectContextRefused(test, row);
}

void testWrongOrder(Test& test) {
    ScopedContext context(test);
    ViewDescription description(&test.device());
    useSingle(description);
    AgaaView views[2] = {};
    for (AgaaView& view : views)
        test.requireOk(test.device().createView(test.sdk, context.get(), &description.desc, &view), "creating a view");
    for (AgaaView view : views) {
        expectRefused(test, test.sdk.agaaDestroyContext(context.get()), AGAA_ERROR_WRONG_ORDER, context.log,
                      "agaaDestroyContext", "agaaDestroyContext of a context with views", "view");
        // The context and its views remain usable.
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.result(test.device().getContextCaps(test.sdk, context.get(), &caps), AGAA_OK,
                    "a call with a context that is kept");
        test.result(test.sdk.agaaResizeView(view, 16, 16), AGAA_OK, "agaaResizeView after agaaDestroyContext failed");
        test.sdk.agaaDestroyView(view);
    }
    test.check(context.log.errors().empty(), "agaaDestroyView logs an error.");
}

// Destroys a new view, a resized view, and a view after a failed creation.
void testDestroyView(Test& test) {
    ScopedContext context(test);
    for (int i = 0; i < 3; ++i) {
        ViewDescription description(&test.device());
        AgaaView view = nullptr, none = nullptr;
        test.requireOk(test.device().createView(test.sdk, context.get(), &description.desc, &view), "creating a view");
        if (i == 1)
            test.result(test.sdk.agaaResizeView(view, 5, 7), AGAA_OK, "agaaResizeView");
        if (i == 2) {
            description.desc.width = 0;
            test.result(test.device().createView(test.sdk, context.get(), &description.desc, &none),
                        AGAA_ERROR_OUT_OF_RANGE, "creating a view without pixels");
            context.log.lines.clear();
        }
        test.sdk.agaaDestroyView(view);
        test.check(context.log.lines.empty(), "agaaDestroyView logs a line.");
    }
    expectNoMessages(test, "agaaDestroyView"); // the test can destroy the context at its end
}

HeaderCase contextHeader(const Device& device) {
    const auto call = [](Test& test, void* structure, const AgaaLog* log) {
        auto& desc = *static_cast<AgaaContextDesc*>(structure);
        ContextDescription right = test.device().description();
        const bool isVulkan = test.device().backend() == Backend::Vulkan;
        const void* const chain = desc.pNext;
        desc.log = log;
        right.vk.pNext = right.gl.pNext = chain;
        desc.pNext = isVulkan ? static_cast<const void*>(&right.vk) : &right.gl;
        const auto create = isVulkan ? test.sdk.agaaVkCreateContext : test.sdk.agaaGlCreateContext;
        AgaaContext context = nullptr;
        const AgaaResult result = create(AGAA_HEADER_VERSION, &desc, &context);
        if (result == AGAA_OK)
            test.sdk.agaaDestroyContext(context);
        desc.pNext = chain;
        return result;
    };
    HeaderCase c = {"AgaaContextDesc", apiName(device, "CreateContext"), nullptr, call};
    c.holdsLog = true;
    if (device.backend() == Backend::Vulkan)
        c.chained = "AgaaVkAllocator";
    return c;
}

} // namespace

void addContextCases(Suite& suite) {
    for (const auto& [name, code] : {std::pair("AGAA_ERROR_OUT_OF_RANGE", AGAA_ERROR_OUT_OF_RANGE),
                                     std::pair("AGAA_ERROR_STRUCT", AGAA_ERROR_STRUCT),
                                     std::pair("AGAA_ERROR_UNKNOWN_STRUCT", AGAA_ERROR_UNKNOWN_STRUCT)})
        addApiCase(suite, "CreateContext", name, [code = code](Test& test) { testRowsOf(test, code); });
    addApiCase(suite, "CreateContext", "AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        testNulls(test);
        testRowsOf(test, AGAA_ERROR_INVALID_ARGUMENT);
    });
    addApiCase(suite, "CreateContext", "AGAA_ERROR_VERSION", testVersions);
    // Each row tests the promise; this test runs all rows.
    addApiCase(suite, "CreateContext", "outContext.unchanged",
               [](Test& test) { testContextRows(test, allRows(test.device())); });
    suite.both("AgaaContextDesc/header", [](Test& test) { testHeader(test, contextHeader(test.device())); });
    suite.both("AgaaContextDesc.framesInFlight/range", testFramesInFlight);
    suite.both("AgaaContextDesc.reserved/zero", testReserved);
    suite.both("AgaaContextDesc.log/null", testLogNull);
    suite.both("agaaDestroyContext/AGAA_ERROR_WRONG_ORDER", testWrongOrder);
    suite.both("agaaDestroyContext/context.null", [](Test& test) {
        test.result(test.sdk.agaaDestroyContext(nullptr), AGAA_OK, "agaaDestroyContext(null)");
    });
    suite.both("agaaDestroyView/view.null", [](Test& test) {
        ScopedContext context(test);
        test.sdk.agaaDestroyView(nullptr);
        test.check(context.log.lines.empty(), "agaaDestroyView(null) logs a line.");
    });
    suite.both("agaaDestroyView/no_errors", testDestroyView);
}

} // namespace agaa::conformance
