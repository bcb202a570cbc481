// Facts of frames, prepared variants, and programs that hosts keep.
#include "cases.h"
#include "frame_rig.h"

#include "cases/core/header_check.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr const char* prepare = "agaaPrepareVariants";

AgaaSceneFacts noFacts() {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = 0;
    facts.maxLights = 0;
    facts.shadowMapCount = 0;
    return facts;
}

// Leaves the view few effects, so that the facts of frames can exceed them.
void useAmbientOnly(ViewDescription& description) { description.facts.flags = AGAA_FACT_AMBIENT; }
void unmask(Scene& scene) {
    for (Vertex& vertex : scene)
        vertex.isMasked = 0;
}

// Facts that exceed those of the view.
struct WrongFacts {
    std::string what;
    AgaaSceneFacts facts;
};
std::vector<WrongFacts> beyond(const AgaaSceneFacts& view) {
    std::vector<WrongFacts> list;
    const auto add = [&](const std::string& what, const auto& change) {
        list.push_back({what, view});
        change(list.back().facts);
    };
    add("one shadow more", [](AgaaSceneFacts& f) { ++f.shadowMapCount; });
    add("one light more", [](AgaaSceneFacts& f) { ++f.maxLights; });
    for (const auto& [name, flag] :
         {std::pair("AGAA_FACT_SPECULAR", AGAA_FACT_SPECULAR), std::pair("AGAA_FACT_EMISSIVE", AGAA_FACT_EMISSIVE),
          std::pair("AGAA_FACT_ALPHA_MASKED", AGAA_FACT_ALPHA_MASKED),
          std::pair("AGAA_FACT_AMBIENT", AGAA_FACT_AMBIENT),
          std::pair("AGAA_FACT_CUSTOM_DEPTH", AGAA_FACT_CUSTOM_DEPTH)})
        if (!(view.flags & flag))
            add(name, [flag = flag](AgaaSceneFacts& f) { f.flags |= flag; });
    add("an unknown flag", [](AgaaSceneFacts& f) { f.flags |= UINT64_C(1) << 62; });
    return list;
}

// Invalid elements after a valid one: nothing is prepared.
void expectNonePrepared(Test& test, AgaaResult code, const std::vector<WrongFacts>& rows,
                        const Rig::ChangeView& changeView = {}) {
    Rig rig(test, changeView);
    unmask(rig.scene);
    const Image expected = rig.render();
    for (const WrongFacts& row : rows) {
        const AgaaSceneFacts facts[] = {noFacts(), row.facts};
        expectRefused(test, test.sdk.agaaPrepareVariants(rig.view.get(), 2, facts), code, rig.context.log, prepare,
                      std::string(prepare) + " with " + row.what);
    }
    test.check(rig.statistics().variantCount == 1, "agaaPrepareVariants that fails prepares a variant.");
    expectNextFrame(rig, expected, "agaaPrepareVariants that fails");
}

void testInvalidArguments(Test& test) {
    Rig rig(test);
    const AgaaSceneFacts facts = noFacts();
    test.result(test.sdk.agaaPrepareVariants(nullptr, 1, &facts), AGAA_ERROR_INVALID_ARGUMENT,
                "agaaPrepareVariants with view = null");
    expectRefused(test, test.sdk.agaaPrepareVariants(rig.view.get(), 1, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  rig.context.log, prepare, "agaaPrepareVariants with facts = null and count = 1");
}

void testNoElements(Test& test) {
    Rig rig(test);
    const AgaaSceneFacts facts = noFacts();
    test.result(test.sdk.agaaPrepareVariants(rig.view.get(), 0, nullptr), AGAA_OK, "agaaPrepareVariants of no facts");
    test.result(test.sdk.agaaPrepareVariants(rig.view.get(), 0, &facts), AGAA_OK, "agaaPrepareVariants with count = 0");
    rig.render();
    test.check(rig.statistics().variantCount == 1, "agaaPrepareVariants with count = 0 prepares a variant.");
}

void testStructs(Test& test) {
    AgaaSceneFacts noType = noFacts(), noSize = noFacts(), larger = noFacts();
    noType.sType = 0;
    noSize.structSize = 8;
    larger.structSize += 4; // not a multiple of 8
    expectNonePrepared(test, AGAA_ERROR_STRUCT,
                       {{"sType = 0", noType}, {"structSize = 8", noSize}, {"an odd structSize", larger}});
}

void testUnknownStruct(Test& test) {
    const AgaaStructHeader unknown = {farStructType, sizeof(AgaaStructHeader), nullptr};
    AgaaSceneFacts chained = noFacts();
    chained.pNext = &unknown;
    expectNonePrepared(test, AGAA_ERROR_UNKNOWN_STRUCT, {{"an unknown struct in a chain", chained}});
}

// ---- frames -----------------------------------------------------------------------------------------

void testFactsBeyondView(Test& test) {
    for (const Rig::ChangeView& changeView : {Rig::ChangeView(), Rig::ChangeView(useAmbientOnly)}) {
        Rig rig(test, changeView);
        unmask(rig.scene);
        const Image expected = rig.render();
        for (const WrongFacts& row : beyond(rig.description().facts)) {
            AgaaFrame frame = rig.nextFrame();
            frame.facts = &row.facts;
            expectFrameRefused(rig, frame, {AGAA_ERROR_OUT_OF_RANGE, "a frame whose facts have " + row.what}, expected);
        }
    }
}

// The frame has a light and a shadow, as its view allows, and its facts allow only one of them.
void testFrameBeyondFacts(Test& test) {
    Rig rig(test, [](ViewDescription& description) { description.facts.shadowMapCount = 1; });
    const Image expected = rig.render();
    const AgaaLight light = AGAA_LIGHT_INIT;
    const AgaaShadow shadow = AGAA_SHADOW_INIT;
    AgaaSceneFacts noLights = rig.description().facts, noShadows = rig.description().facts;
    noLights.maxLights = 0;
    noShadows.shadowMapCount = 0;
    for (const auto& [facts, member] : {std::pair(&noLights, "lightCount"), std::pair(&noShadows, "shadowCount")}) {
        AgaaFrame frame = rig.nextFrame();
        frame.facts = facts;
        frame.lights = &light;
        frame.shadows = &shadow;
        frame.lightCount = frame.shadowCount = 1;
        expectFrameRefused(
            rig, frame, {AGAA_ERROR_OUT_OF_RANGE, std::string("a frame whose facts are below its ") + member, member},
            expected);
    }
}

void testFrameFacts(Test& test) {
    testFactsBeyondView(test);
    testFrameBeyondFacts(test);
}

// Null stands for the facts of the view.
void testNullFacts(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    const AgaaSceneFacts viewFacts = rig.description().facts;
    expectSame(test, rig.render([&](AgaaFrame& frame) { frame.facts = &viewFacts; }), expected, 32,
               "a frame with the facts of its view");
    test.check(rig.statistics().variantFlags == viewFacts.flags,
               "AgaaFrameStatistics::variantFlags are not those of the view.");
}

void testVariantCount(Test& test) {
    Rig rig(test);
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    test.result(test.sdk.agaaGetFrameStatistics(rig.view.get(), 0, &statistics), AGAA_NOT_READY,
                "agaaGetFrameStatistics");
    test.check(statistics.variantCount == 1,
               "a new view has " + std::to_string(statistics.variantCount) + " variants.");
    test.check(statistics.compiledPipelines > 0 && statistics.compileMilliseconds > 0,
               "a new view has compiled nothing.");
    const AgaaSceneFacts facts = noFacts();
    for (int i = 0; i < 2; ++i) {
        test.requireOk(test.sdk.agaaPrepareVariants(rig.view.get(), 1, &facts), prepare);
        rig.render();
        test.check(rig.statistics().variantCount == 2, "a view with a prepared variant does not have two.");
    }
}

// ---- programs ---------------------------------------------------------------------------------------

void testCacheArguments(Test& test) {
    ScopedContext context(test);
    size_t size = 0;
    test.result(test.sdk.agaaGlGetProgramCache(nullptr, &size, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                "agaaGlGetProgramCache with context = null");
    expectRefused(test, test.sdk.agaaGlGetProgramCache(context.get(), nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                  context.log, "agaaGlGetProgramCache", "agaaGlGetProgramCache with size = null");
}

// A call with null data returns the size. A size that is too small changes nothing.
void testCacheSize(Test& test) {
    ScopedContext context(test);
    size_t size = 0;
    test.requireOk(test.sdk.agaaGlGetProgramCache(context.get(), &size, nullptr),
                   "agaaGlGetProgramCache with data = null");
    test.require(size > 0, "agaaGlGetProgramCache tells no size.");
    Bytes bytes(size + 64);
    const Bytes untouched = bytes;
    size_t less = size - 1;
    expectRefused(test, test.sdk.agaaGlGetProgramCache(context.get(), &less, bytes.data()), AGAA_ERROR_BUFFER_TOO_SMALL,
                  context.log, "agaaGlGetProgramCache", "agaaGlGetProgramCache with a size that is too small");
    test.check(less == size - 1, "agaaGlGetProgramCache that fails changes the size.");
    test.check(bytes == untouched, "agaaGlGetProgramCache that fails writes data.");
    size_t more = size + 32;
    test.requireOk(test.sdk.agaaGlGetProgramCache(context.get(), &more, bytes.data()), "agaaGlGetProgramCache");
    test.check(more == size, "agaaGlGetProgramCache returns another size than before.");
    test.check(bytes.findDifference(size, size + 64, Bytes::pattern) == size + 64,
               "agaaGlGetProgramCache writes beyond its size.");
}

AgaaResult createWithCache(Test& test, const void* cache, const AgaaLog* log) {
    AgaaGlDeviceDesc device = test.device().description().gl;
    device.pNext = cache;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    desc.log = log;
    desc.pNext = &device;
    AgaaContext context = nullptr;
    const AgaaResult result = test.sdk.agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context);
    if (result == AGAA_OK)
        test.sdk.agaaDestroyContext(context);
    return result;
}

void testCacheData(Test& test) {
    AgaaGlProgramCache cache = AGAA_GL_PROGRAM_CACHE_INIT;
    LogRecorder log;
    test.result(createWithCache(test, &cache, log.get()), AGAA_OK,
                "agaaGlCreateContext with an empty AgaaGlProgramCache");
    test.check(log.lines.empty(), "an empty AgaaGlProgramCache logs a line.");
    cache.size = 8;
    expectRefused(test, createWithCache(test, &cache, log.get()), AGAA_ERROR_INVALID_ARGUMENT, log,
                  "agaaGlCreateContext", "agaaGlCreateContext with AgaaGlProgramCache::data = null",
                  "AgaaGlProgramCache::data");
    const char text[] = "these are no programs that a driver made";
    cache.data = text;
    cache.size = sizeof text;
    test.result(createWithCache(test, &cache, log.get()), AGAA_OK, "agaaGlCreateContext with other data");
    test.check(log.lines.size() == 1 && log.lines[0].severity == AGAA_SEVERITY_WARNING,
               "AgaaGlProgramCache::data that is of no use does not log one warning.");
}

void testCacheHeader(Test& test) {
    HeaderCase c = {
        "AgaaGlProgramCache", "agaaGlCreateContext", nullptr,
        [](Test& inner, void* structure, const AgaaLog* log) { return createWithCache(inner, structure, log); }};
    c.isChained = true;
    testHeader(test, c);
}

} // namespace

void addVariantCases(Suite& suite) {
    suite.both("agaaPrepareVariants/AGAA_ERROR_INVALID_ARGUMENT", testInvalidArguments);
    suite.both("agaaPrepareVariants/facts.null", testNoElements);
    suite.both("agaaPrepareVariants/AGAA_ERROR_STRUCT", testStructs);
    suite.both("agaaPrepareVariants/AGAA_ERROR_UNKNOWN_STRUCT", testUnknownStruct);
    suite.both("agaaPrepareVariants/AGAA_ERROR_OUT_OF_RANGE", [](Test& test) {
        ViewDescription description(&test.device());
        expectNonePrepared(test, AGAA_ERROR_OUT_OF_RANGE, beyond(description.facts));
        useAmbientOnly(description);
        expectNonePrepared(test, AGAA_ERROR_OUT_OF_RANGE, beyond(description.facts), useAmbientOnly);
    });
    suite.both("AgaaFrame.facts/AGAA_ERROR_OUT_OF_RANGE", testFrameFacts);
    suite.both("AgaaFrame.facts/null", testNullFacts);
    suite.both("AgaaFrameStatistics.variantFlags/flags", testNullFacts);
    suite.both("AgaaFrameStatistics.variantCount/range", testVariantCount);
    const auto gl = [&](const char* name, std::function<void(Test&)> run) {
        suite.add(name, {Backend::OpenGl}, std::move(run));
    };
    gl("agaaGlGetProgramCache/AGAA_ERROR_INVALID_ARGUMENT", testCacheArguments);
    for (const char* promise : {"size.unchanged", "data.unchanged", "data.null", "AGAA_ERROR_BUFFER_TOO_SMALL"})
        gl((std::string("agaaGlGetProgramCache/") + promise).c_str(), testCacheSize);
    gl("AgaaGlProgramCache.data/null", testCacheData);
    gl("AgaaGlProgramCache/header", testCacheHeader);
}

} // namespace agaa::conformance
