// The C functions for engines.
#include "integration/checks.h"

namespace agaa::conformance {
namespace {

struct Ready {
    Functions functions;
    bool isValid = false;
};

Ready prepare(const AgaaConformanceRun* run) {
    Ready ready;
    if (!run || run->structSize != sizeof *run)
        return ready;
    std::vector<std::string> missing;
    ready.functions = findFunctions(run->getFunction, run->getUser, missing);
    ready.isValid = missing.empty();
    return ready;
}

int32_t runAll(const Suite& suite, Backend backend, const AgaaConformanceRun& run, const Functions& functions) {
    const auto onOutcome = [&](const Outcome& outcome) {
        const AgaaConformanceResult result = {
            outcome.name.c_str(), backendName(backend), outcome.reason.c_str(), uint32_t(outcome.status), 0,
            outcome.milliseconds};
        if (run.onResult)
            run.onResult(run.resultUser, &result);
    };
    int32_t failed = 0;
    for (const Outcome& outcome : runSuite(suite, functions, nullptr, backend, run.filter ? run.filter : "", onOutcome))
        failed += outcome.status == AGAA_CONFORMANCE_FAILED;
    return failed;
}

} // namespace
} // namespace agaa::conformance

using namespace agaa::conformance;

extern "C" {

int32_t agaaConformanceTestLibrary(const AgaaConformanceRun* run) {
    try {
        const Ready ready = prepare(run);
        return ready.isValid ? runAll(makeCoreSuite(), Backend::Core, *run, ready.functions) : -1;
    } catch (...) {
        return -1;
    }
}

int32_t agaaConformanceCheckHost(const AgaaConformanceRun* run, const AgaaConformanceHost* host) {
    try {
        const Ready ready = prepare(run);
        if (!ready.isValid || !isComplete(host))
            return -1;
        return runAll(makeHostChecks(*host, ready.functions), Backend::Host, *run, ready.functions);
    } catch (...) {
        return -1;
    }
}

} // extern "C"
