// Functions that write text: agaaPlanToJson, agaaGetAggregateGlsl, agaaGetCoverageGlsl.
#include "cases.h"
#include "view_parts.h"
#include "wrong_views.h"

namespace agaa::conformance {

namespace {

// A function with its view. All functions get the same parameters.
struct TextCall {
    std::string name;
    std::function<AgaaResult(Test&, const AgaaDeviceCaps*, const AgaaLog*, size_t*, char*)> call;
};

TextCall planCall() {
    return {"agaaPlanToJson", [](Test& test, const AgaaDeviceCaps* caps, const AgaaLog* log, size_t* size, char* text) {
                ViewParts parts(test.sdk, nullptr);
                return test.sdk.agaaPlanToJson(&parts.desc, caps, log, size, text);
            }};
}

TextCall aggregateCall() {
    return {"agaaGetAggregateGlsl",
            [](Test& test, const AgaaDeviceCaps* caps, const AgaaLog* log, size_t* size, char* text) {
                ViewParts parts(test.sdk, nullptr);
                return test.sdk.agaaGetAggregateGlsl(&parts.desc, caps, log, size, text);
            }};
}

TextCall coverageCall() {
    return {"agaaGetCoverageGlsl", [](Test& test, const AgaaDeviceCaps*, const AgaaLog* log, size_t* size, char* text) {
                return test.sdk.agaaGetCoverageGlsl(log, size, text);
            }};
}

std::string textOf(Test& test, const TextCall& c, const AgaaDeviceCaps* caps) {
    size_t size = 0;
    test.requireOk(c.call(test, caps, nullptr, &size, nullptr), c.name + " with text = null");
    std::string text(size, '#');
    test.requireOk(c.call(test, caps, nullptr, &size, text.data()), c.name);
    return text; // includes the final zero
}

// The size includes the final zero, and nothing is written after it.
void testTwoCalls(Test& test, const TextCall& c) {
    size_t size = 12345; // not read by the call
    test.requireOk(c.call(test, nullptr, nullptr, &size, nullptr), c.name + " with text = null");
    std::string text(size + 32, '#');
    size_t written = size;
    test.requireOk(c.call(test, nullptr, nullptr, &written, text.data()), c.name + " with the size that it returned");
    test.check(written == size, c.name + " returns another size with a buffer than without.");
    test.check(text.find('\0') == size - 1, c.name + ": the size is not that of the text with its final zero.");
    test.check(text.find_first_not_of('#', size) == std::string::npos,
               c.name + " writes beyond the size that it returns.");
    written = size + 32;
    test.requireOk(c.call(test, nullptr, nullptr, &written, text.data()), c.name + " with a larger buffer");
    test.check(written == size, c.name + " with a larger buffer does not return the size of the text.");
}

void testTooSmall(Test& test, const TextCall& c) {
    size_t needed = 0;
    test.requireOk(c.call(test, nullptr, nullptr, &needed, nullptr), c.name + " with text = null");
    const std::string before(needed, '#');
    for (const size_t length : {size_t(0), size_t(1), needed - 1}) {
        LogRecorder log;
        std::string text = before;
        size_t size = length;
        expectRefused(test, c.call(test, nullptr, log.get(), &size, text.data()), AGAA_ERROR_BUFFER_TOO_SMALL, log,
                      c.name, c.name + " with size = " + std::to_string(length) + " of " + std::to_string(needed));
        test.check(text == before && size == length, c.name + " with a buffer that is too small writes.");
    }
}

void testSizeNull(Test& test, const TextCall& c) {
    LogRecorder log;
    expectRefused(test, c.call(test, nullptr, log.get(), nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT, log, c.name,
                  c.name + " with size = null", "size");
    char text[4] = "###";
    expectRefused(test, c.call(test, nullptr, log.get(), nullptr, text), AGAA_ERROR_INVALID_ARGUMENT, log, c.name,
                  c.name + " with size = null and a buffer", "size");
    test.check(text[0] == '#', c.name + " with size = null writes.");
}

// The result does not depend on the log.
void testLogNull(Test& test, const TextCall& c) {
    size_t size = 0;
    test.result(c.call(test, nullptr, nullptr, &size, nullptr), AGAA_OK, c.name + " with log = null");
    test.result(c.call(test, nullptr, nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                c.name + " with log = null and size = null");
    LogRecorder log;
    test.result(c.call(test, nullptr, log.get(), &size, nullptr), AGAA_OK, c.name + " with a log");
    test.check(log.errors().empty(), c.name + " succeeds and logs an error.");
}

void testCapsNull(Test& test, const TextCall& c) {
    const AgaaDeviceCaps ideal = ViewParts(test.sdk, nullptr).caps;
    test.check(textOf(test, c, nullptr) == textOf(test, c, &ideal),
               c.name + " writes different texts for caps = null and an ideal device.");
}

void testWrongViewsOf(Test& test, const std::string& name, decltype(Functions::agaaPlanToJson) call) {
    testWrongViews(test, nullptr, name, [&](const ViewParts& parts, LogRecorder& log) {
        size_t size = 777;
        const AgaaResult result = call(parts.get(), &parts.caps, log.get(), &size, nullptr);
        test.check(size == 777, name + " fails and changes size.");
        return result;
    });
}

void testTextUnchanged(Test& test) {
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        std::string text(1 << 16, '#');
        size_t size = text.size();
        const AgaaResult result = test.sdk.agaaPlanToJson(parts.get(), &parts.caps, nullptr, &size, text.data());
        test.check(result != AGAA_OK && size == text.size() && text.find_first_not_of('#') == std::string::npos,
                   callWith("agaaPlanToJson", row.what) + " changes text or size.");
    }
}

// The texts contain the names that the header promises.
void testGlslNames(Test& test) {
    const std::string text = textOf(test, aggregateCall(), nullptr);
    for (const char* word :
         {"struct AgaaAggregate", "AgaaAggregate agaaAggregate(", "AGAA_AGGREGATES", "AGAA_AGGREGATE_WORD"})
        test.check(text.find(word) != std::string::npos,
                   std::string("agaaGetAggregateGlsl: the text has no \"") + word + "\".");
    test.check(textOf(test, coverageCall(), nullptr).find("agaa") != std::string::npos,
               "agaaGetCoverageGlsl: the text declares no function of the SDK.");
}

// Tests which views keep aggregates in memory.
void testAggregatesUnsupported(Test& test) {
    struct Row {
        const char* what;
        bool isKept;
        std::function<void(ViewParts&)> change;
    };
    const auto tier = [](uint32_t tier, uint64_t flags) {
        return [=](ViewParts& p) {
            p.config.generationTier = tier;
            p.config.flags = flags;
            p.chain(p.fetch);
        };
    };
    const auto technique = [](const char* name) { return [=](ViewParts& p) { p.setTechnique(name, 4); }; };
    for (const Row& row : {Row{"post-depth atomics", true, tier(AGAA_TIER_POST_DEPTH_ATOMICS, 0)},
                           Row{"per-sample atomics", true, tier(AGAA_TIER_PER_SAMPLE, 0)},
                           Row{"GBUFFER", false, tier(AGAA_TIER_GBUFFER, 0)},
                           Row{"GBUFFER and BUFFERED", true, tier(AGAA_TIER_GBUFFER, AGAA_CONFIG_BUFFERED)},
                           Row{"IDS", false, tier(AGAA_TIER_IDS, 0)},
                           Row{"IDS and BUFFERED", true, tier(AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED)},
                           Row{"\"single\"", false, technique("single")}, Row{"\"fxaa\"", false, technique("fxaa")},
                           Row{"\"msaa\"", false, technique("msaa")}, Row{"\"ssaa\"", false, technique("ssaa")},
                           Row{"\"simple_complex\"", false, technique("simple_complex")},
                           Row{"\"sbaa\"", false, technique("sbaa")}, Row{"\"dcaa\"", false, technique("dcaa")}}) {
        ViewParts parts(test.sdk, nullptr);
        row.change(parts);
        LogRecorder log;
        const AgaaResult result = aggregateGlslQuery.call(test.sdk, &parts.desc, nullptr, log.get());
        const std::string what = callWith("agaaGetAggregateGlsl", row.what);
        if (row.isKept)
            test.result(result, AGAA_OK, what);
        else
            expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, log, "agaaGetAggregateGlsl", what);
        bool hasSurface = false;
        for (const AgaaSurface& surface : surfacesOf(test, parts))
            hasSurface |= std::string(surface.name) == "aggregates" && parts.config.technique == std::string("agaa");
        test.check(hasSurface == row.isKept, callWith("agaaQueryMemory", row.what) +
                                                 (row.isKept ? " lists no" : " lists a") + " surface \"aggregates\".");
    }
    ViewParts flat(test.sdk, nullptr);
    flat.config.technique = "agaa";
    flat.facts.flags = AGAA_FACT_PLANE_NORMALS | AGAA_FACT_NO_LOCAL_LIGHTS;
    LogRecorder log;
    const AgaaResult result = aggregateGlslQuery.call(test.sdk, &flat.desc, nullptr, log.get());
    expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, log, "agaaGetAggregateGlsl",
                  callWith("agaaGetAggregateGlsl", "AGAA_FACT_PLANE_NORMALS"));
}

using Step = void (*)(Test&, const TextCall&);

} // namespace

void addTextCases(Suite& suite) {
    const auto add = [&](const std::string& promise, const TextCall& c, Step step) {
        suite.core(c.name + '/' + promise, [c, step](Test& test) { step(test, c); });
    };
    for (const TextCall& c : {planCall(), aggregateCall(), coverageCall()}) {
        add("text.null", c, testTwoCalls);
        add("log.null", c, testLogNull);
        add("AGAA_ERROR_BUFFER_TOO_SMALL", c, testTooSmall);
        add("AGAA_ERROR_INVALID_ARGUMENT", c, testSizeNull);
    }
    add("caps.null", planCall(), testCapsNull);
    add("caps.null", aggregateCall(), testCapsNull);
    suite.core("agaaPlanToJson/text.unchanged", testTextUnchanged);
    suite.core("agaaPlanToJson/those_of.agaaQueryMemory",
               [](Test& test) { testWrongViewsOf(test, "agaaPlanToJson", test.sdk.agaaPlanToJson); });
    suite.core("agaaGetAggregateGlsl/those_of.agaaPlanToJson", [](Test& test) {
        testWrongViewsOf(test, "agaaGetAggregateGlsl", test.sdk.agaaGetAggregateGlsl);
        testTooSmall(test, aggregateCall());
        testSizeNull(test, aggregateCall());
    });
    suite.core("agaaGetAggregateGlsl/AGAA_ERROR_UNSUPPORTED", testAggregatesUnsupported);
    suite.core("agaaGetAggregateGlsl/names", testGlslNames);
}

} // namespace agaa::conformance
