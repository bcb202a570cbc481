// agaaGetFrameStatistics, agaaValidateFrame and agaaGetFactReport.
#include "cases.h"
#include "frame_rig.h"

#include <cstring>

namespace agaa::conformance {

namespace {

// "single" has the fewest pipelines.
void oneSample(ViewDescription& description) { setTechnique(description, "single", 1); }

void checked(ViewDescription& description) {
    oneSample(description);
    description.config.flags |= AGAA_CONFIG_CHECK_FACTS;
}

AgaaFrameStatistics emptyStatistics() {
    const AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    return statistics;
}
AgaaFrameValidation emptyValidation() {
    const AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    return validation;
}

AgaaFactReport emptyReport() {
    const AgaaFactReport report = AGAA_FACT_REPORT_INIT;
    return report;
}

AgaaResult get(const Functions& sdk, AgaaView view, uint64_t completed, AgaaFrameStatistics* out) {
    return sdk.agaaGetFrameStatistics(view, completed, out);
}
AgaaResult get(const Functions& sdk, AgaaView view, uint64_t completed, AgaaFrameValidation* out) {
    return sdk.agaaValidateFrame(view, completed, out);
}
AgaaResult get(const Functions& sdk, AgaaView view, uint64_t completed, AgaaFactReport* out) {
    return sdk.agaaGetFactReport(view, completed, out);
}
template <class T> T empty();
template <> AgaaFrameStatistics empty() { return emptyStatistics(); }
template <> AgaaFrameValidation empty() { return emptyValidation(); }
template <> AgaaFactReport empty() { return emptyReport(); }
template <class T> const char* nameOf();
template <> const char* nameOf<AgaaFrameStatistics>() { return "agaaGetFrameStatistics"; }
template <> const char* nameOf<AgaaFrameValidation>() { return "agaaValidateFrame"; }
template <> const char* nameOf<AgaaFactReport>() { return "agaaGetFactReport"; }

template <class T> void expectCallRefused(Rig& rig, AgaaView view, T* out, AgaaResult code, const std::string& how) {
    T before{};
    if (out)
        std::memcpy(&before, out, sizeof before);
    rig.context.log.lines.clear();
    const AgaaResult result = get(rig.test.sdk, view, rig.recorded, out);
    const std::string what = nameOf<T>() + how;
    if (view)
        expectRefused(rig.test, result, code, rig.context.log, nameOf<T>(), what);
    else
        rig.test.result(result, code, what);
    if (out)
        rig.test.check(!std::memcmp(&before, out, sizeof before), what + " fails and changes the output.");
}

template <class T> void testNull(Rig& rig) {
    T out = empty<T>();
    expectCallRefused<T>(rig, nullptr, &out, AGAA_ERROR_INVALID_ARGUMENT, " with a null view");
    expectCallRefused<T>(rig, rig.view.get(), nullptr, AGAA_ERROR_INVALID_ARGUMENT, " with a null output");
}

template <class T> void testStruct(Rig& rig) {
    T wrongType = empty<T>(), wrongSize = empty<T>();
    wrongType.sType = AGAA_STRUCTURE_TYPE_SURFACE;
    wrongSize.structSize = 8;
    expectCallRefused<T>(rig, rig.view.get(), &wrongType, AGAA_ERROR_STRUCT, " with another sType");
    expectCallRefused<T>(rig, rig.view.get(), &wrongSize, AGAA_ERROR_STRUCT, " with structSize = 8");
}

void withoutCounters(ViewDescription& description) { description.config.flags &= ~AGAA_CONFIG_COUNTERS; }

void testNoCounters(Test& test) {
    Rig rig(test, withoutCounters);
    for (int i = 0; i < 2; ++i) { // repeats before and after a frame
        AgaaFrameValidation out = emptyValidation();
        expectCallRefused(rig, rig.view.get(), &out, AGAA_ERROR_WRONG_ORDER, " without AGAA_CONFIG_COUNTERS");
        rig.render();
    }
}

void testNoChecks(Test& test) {
    Rig rig(test, oneSample);
    for (int i = 0; i < 2; ++i) { // repeats before and after a frame
        AgaaFactReport out = emptyReport();
        expectCallRefused(rig, rig.view.get(), &out, AGAA_ERROR_WRONG_ORDER, " without AGAA_CONFIG_CHECK_FACTS");
        rig.render();
    }
}

// The scene has emission and specular reflectance, or neither. A view without both reports the contradiction once in
// the log.
void testContradictions(Test& test) {
    for (const uint64_t flags : {AGAA_FACT_ALL_SHADED, UINT64_C(0)}) {
        Rig rig(test, [flags](ViewDescription& description) {
            checked(description);
            description.facts.flags = flags;
        });
        AgaaFactReport report = emptyReport();
        test.result(test.sdk.agaaGetFactReport(rig.view.get(), 0, &report), AGAA_NOT_READY,
                    "agaaGetFactReport without a finished frame");
        const AgaaFactReport initial = emptyReport();
        test.check(!std::memcmp(&initial, &report, sizeof initial), "AGAA_NOT_READY changes outReport.");
        rig.render();
        rig.context.log.lines.clear();
        for (int i = 0; i < 2; ++i)
            test.requireOk(test.sdk.agaaGetFactReport(rig.view.get(), rig.recorded, &report), "agaaGetFactReport");
        test.check(report.frameIndex == rig.recorded, "the report is not that of the newest finished frame.");
        test.check(report.inspected > 0, "no material was inspected.");
        const uint64_t shaded = report.sufficient & (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED);
        test.check((report.contradicted & (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED)) ==
                       (shaded & ~flags),
                   "the contradicted facts are not those that the frame calls for and the view left out.");
        test.check(rig.context.log.lines.size() == (report.contradicted ? 1u : 0u),
                   "a contradiction is not told once through the log.");
    }
}

template <class T> void addErrors(Suite& suite, const std::string& output) {
    const std::string name = std::string(nameOf<T>()) + "/";
    const auto run = [](const std::function<void(Rig&)>& body) {
        return [body](Test& test) {
            Rig rig(test, checked);
            rig.render();
            body(rig);
        };
    };
    suite.both(name + "AGAA_ERROR_INVALID_ARGUMENT", run(testNull<T>));
    suite.both(name + "AGAA_ERROR_STRUCT", run(testStruct<T>));
    suite.both(name + output + ".unchanged", run([](Rig& rig) {
                   testNull<T>(rig);
                   testStruct<T>(rig);
               }));
}

// Returns whether the bytes from `first` to the end equal an initialised struct.
bool isInitialFrom(const AgaaFrameStatistics& statistics, size_t first, size_t end) {
    const AgaaFrameStatistics initial = emptyStatistics();
    return !std::memcmp(reinterpret_cast<const char*>(&statistics) + first,
                        reinterpret_cast<const char*>(&initial) + first, end - first);
}

void testNotReady(Test& test) {
    Rig rig(test, oneSample);
    AgaaFrameStatistics statistics = emptyStatistics();
    test.result(test.sdk.agaaGetFrameStatistics(rig.view.get(), 0, &statistics), AGAA_NOT_READY,
                "agaaGetFrameStatistics before the first frame");
    test.check(statistics.payloadBytes && statistics.peakBytes && statistics.geometryPasses,
               "AGAA_NOT_READY comes without bytes or geometryPasses.");
    test.check(statistics.frameIndex == 0 && statistics.timeSource == 0 &&
                   isInitialFrom(statistics, offsetof(AgaaFrameStatistics, counters),
                                 offsetof(AgaaFrameStatistics, variantCount)),
               "AGAA_NOT_READY comes with more than the bytes, geometryPasses and what the view has compiled.");
    test.check(statistics.variantCount >= 1, "AGAA_NOT_READY comes without variantCount.");
    test.check(rig.context.log.errors().empty(), "AGAA_NOT_READY is logged as an error.");
    rig.render();
    test.result(test.sdk.agaaGetFrameStatistics(rig.view.get(), 0, &statistics), AGAA_NOT_READY,
                "agaaGetFrameStatistics with no finished frame");
    for (const uint64_t completed : {UINT64_C(1), UINT64_C(100)}) {
        test.requireOk(test.sdk.agaaGetFrameStatistics(rig.view.get(), completed, &statistics),
                       "agaaGetFrameStatistics");
        test.check(statistics.frameIndex == 1, "the statistics are not those of the newest finished frame.");
    }
    rig.render();
    test.requireOk(test.sdk.agaaGetFrameStatistics(rig.view.get(), 1, &statistics), "agaaGetFrameStatistics");
    test.check(statistics.frameIndex == 1, "the statistics are those of a frame after completedFrame.");
}

// A frame counts when all of its segments are recorded.
void testUnfinishedFrame(Test& test) {
    Rig rig(test, oneSample);
    rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.segments = AGAA_SEGMENT_PREPASS;
    test.requireOk(rig.record(frame), rig.function());
    AgaaFrameStatistics statistics = emptyStatistics();
    test.requireOk(test.sdk.agaaGetFrameStatistics(rig.view.get(), 2, &statistics), "agaaGetFrameStatistics");
    test.check(statistics.frameIndex == 1, "the statistics are those of a frame that is not completely recorded.");
    frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
    test.requireOk(rig.record(frame), rig.function());
    test.requireOk(test.sdk.agaaGetFrameStatistics(rig.view.get(), 2, &statistics), "agaaGetFrameStatistics");
    test.check(statistics.frameIndex == 2, "the statistics are not those of the frame that is complete now.");
}

void testValidationNotReady(Test& test) {
    Rig rig(test, oneSample);
    for (int i = 0; i < 2; ++i) {
        AgaaFrameValidation validation = emptyValidation();
        test.result(test.sdk.agaaValidateFrame(rig.view.get(), 0, &validation), AGAA_NOT_READY,
                    "agaaValidateFrame without a finished frame");
        const AgaaFrameValidation initial = emptyValidation();
        test.check(!std::memcmp(&initial, &validation, sizeof initial), "AGAA_NOT_READY changes outValidation.");
        rig.render();
    }
    AgaaFrameValidation validation = emptyValidation();
    test.requireOk(test.sdk.agaaValidateFrame(rig.view.get(), rig.recorded, &validation), "agaaValidateFrame");
    test.check(validation.frameIndex == rig.recorded, "the validation is not that of the newest finished frame.");
}

void testPasses(Test& test, const std::function<void(const AgaaPassTime&, const AgaaFrameStatistics&)>& check) {
    for (const uint64_t flags : {AGAA_CONFIG_COUNTERS, AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS}) {
        Rig rig(test, [flags](ViewDescription& description) {
            oneSample(description);
            description.config.flags = flags;
        });
        rig.render();
        const AgaaFrameStatistics statistics = rig.statistics();
        test.check(statistics.passCount >= statistics.geometryPasses && statistics.passCount <= AGAA_MAX_PASSES,
                   "AgaaFrameStatistics::passCount is " + std::to_string(statistics.passCount) + ".");
        for (uint32_t i = 0; i < statistics.passCount && i < AGAA_MAX_PASSES; ++i)
            check(statistics.passes[i], statistics);
    }
}

void testTimes(Test& test) {
    Rig plain(test, oneSample);
    plain.render();
    test.check(plain.statistics().timeSource == AGAA_TIME_NONE, "there are times without AGAA_CONFIG_TIMESTAMPS.");
    testPasses(test, [&](const AgaaPassTime& pass, const AgaaFrameStatistics& statistics) {
        test.check(statistics.timeSource <= AGAA_TIME_CPU_FINISH, "AgaaFrameStatistics::timeSource is unknown.");
        test.check(pass.isTimed <= 1 && (statistics.timeSource != AGAA_TIME_NONE || !pass.isTimed),
                   "a pass is timed without a clock.");
        test.check(pass.milliseconds >= 0 && pass.milliseconds < 60000,
                   "a pass takes " + std::to_string(pass.milliseconds) + " ms.");
        test.check(pass.isTimed || pass.milliseconds == 0, "a pass that is not timed has a time.");
    });
}

} // namespace

void addStatisticsCases(Suite& suite) {
    addErrors<AgaaFrameStatistics>(suite, "outStatistics");
    addErrors<AgaaFrameValidation>(suite, "outValidation");
    addErrors<AgaaFactReport>(suite, "outReport");
    suite.both("agaaValidateFrame/AGAA_ERROR_WRONG_ORDER", testNoCounters);
    suite.both("agaaGetFactReport/AGAA_ERROR_WRONG_ORDER", testNoChecks);
    suite.both("agaaGetFactReport/returns", testContradictions);
    suite.both("agaaGetFrameStatistics/returns", testNotReady);
    suite.both("agaaGetFrameStatistics/returns/segments", testUnfinishedFrame);
    suite.both("agaaValidateFrame/returns", testValidationNotReady);
    suite.both("AgaaPassTime.stage/enum", [](Test& test) {
        testPasses(test, [&](const AgaaPassTime& pass, const AgaaFrameStatistics&) {
            test.check(pass.stage <= AGAA_STAGE_OTHER, "the pass " + std::string(pass.name) + " has an unknown stage.");
            test.check(pass.name[0] && std::memchr(pass.name, 0, sizeof pass.name),
                       "a pass has no name, or one without an end.");
        });
    });
    suite.both("AgaaPassTime.reserved/zero", [](Test& test) {
        testPasses(test, [&](const AgaaPassTime& pass, const AgaaFrameStatistics&) {
            test.check(!pass.reserved[0] && !pass.reserved[1], "AgaaPassTime::reserved is not 0.");
        });
    });
    suite.both("AgaaFrameStatistics.timeSource/enum", testTimes);
    suite.both("AgaaFrameStatistics.reserved/zero", [](Test& test) {
        Rig rig(test, oneSample);
        rig.render();
        test.check(rig.statistics().reserved == 0, "AgaaFrameStatistics::reserved is not 0.");
    });
    suite.both("AgaaCounters.reserved/zero", [](Test& test) {
        Rig rig(test, oneSample);
        rig.render();
        for (const uint64_t word : rig.counters().reserved)
            test.check(word == 0, "AgaaCounters::reserved is not 0.");
    });
}

} // namespace agaa::conformance
