#include "suite.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <stdexcept>

namespace agaa::conformance {

const char* backendName(Backend backend) {
    switch (backend) {
    case Backend::Core:
        return "core";
    case Backend::Vulkan:
        return "vk";
    case Backend::OpenGl:
        return "gl";
    case Backend::Host:
        return "host";
    }
    return "";
}

Device& Test::device() const {
    if (!device_)
        throw std::logic_error("the test needs a device");
    return *device_;
}

bool Test::check(bool isTrue, const std::string& sentence) {
    if (!isTrue)
        failures_.push_back(sentence);
    return isTrue;
}

void Test::require(bool isTrue, const std::string& sentence) {
    if (!check(isTrue, sentence))
        throw Aborted{};
}

std::string Test::nameOf(AgaaResult result) const {
    return std::string(sdk.agaaResultName(result)) + " (" + std::to_string(result) + ")";
}

bool Test::result(AgaaResult got, AgaaResult expected, const std::string& what) {
    return check(got == expected, what + " returns " + nameOf(got) + " where " + nameOf(expected) + " is promised.");
}

void Test::requireOk(AgaaResult got, const std::string& what) {
    if (!result(got, AGAA_OK, what))
        throw Aborted{};
}

void Test::skip(const std::string& reason) const { throw Skipped{reason}; }

void Suite::add(std::string name, std::vector<Backend> backends, std::function<void(Test&)> run) {
    const bool isNew = std::none_of(cases_.begin(), cases_.end(), [&](const Case& c) { return c.name == name; });
    if (!isNew)
        throw std::logic_error("two tests have the name " + name);
    cases_.push_back({std::move(name), std::move(backends), std::move(run)});
}

namespace {

bool matchesPattern(const char* name, const char* pattern, const char* end) {
    if (pattern == end)
        return *name == 0;
    if (*pattern == '*')
        return matchesPattern(name, pattern + 1, end) || (*name && matchesPattern(name + 1, pattern, end));
    return *name && (*pattern == '?' || *pattern == *name) && matchesPattern(name + 1, pattern + 1, end);
}

bool matchesAny(const std::string& name, const std::string& patterns) {
    for (size_t begin = 0; begin <= patterns.size();) {
        const size_t end = std::min(patterns.find(':', begin), patterns.size());
        if (matchesPattern(name.c_str(), patterns.data() + begin, patterns.data() + end))
            return true;
        begin = end + 1;
    }
    return false;
}

} // namespace

bool matches(const std::string& name, const std::string& filter) {
    const size_t minus = filter.find('-');
    const std::string wanted = filter.substr(0, minus);
    if (!wanted.empty() && !matchesAny(name, wanted))
        return false;
    return minus == std::string::npos || !matchesAny(name, filter.substr(minus + 1));
}

Outcome runCase(const std::string& name, const std::function<void(Test&)>& run, const Functions& functions,
                Device* device, Backend backend) {
    Outcome outcome{name, backend, AGAA_CONFORMANCE_PASSED, "", 0};
    Test test(functions, device);
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> failures;
    try {
        run(test);
    } catch (const Skipped& skipped) {
        outcome.status = AGAA_CONFORMANCE_SKIPPED;
        outcome.reason = skipped.reason;
    } catch (const Aborted&) {
    } catch (const std::exception& error) {
        failures.push_back(std::string("the test threw: ") + error.what());
    }
    outcome.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    failures.insert(failures.begin(), test.failures().begin(), test.failures().end());
    if (!failures.empty()) { // also for a test that ended with skip()
        outcome.status = AGAA_CONFORMANCE_FAILED;
        outcome.reason.clear();
        const size_t shown = std::min<size_t>(failures.size(), 12);
        for (size_t i = 0; i < shown; ++i)
            outcome.reason += (i ? "\n" : "") + failures[i];
        if (shown < failures.size())
            outcome.reason += "\n... and " + std::to_string(failures.size() - shown) + " more.";
    }
    return outcome;
}

std::vector<Outcome> runSuite(const Suite& suite, const Functions& functions, Device* device, Backend backend,
                              const std::string& filter, const std::function<void(const Outcome&)>& onOutcome) {
    std::vector<Outcome> outcomes;
    for (const Case& c : suite.cases()) {
        if (std::find(c.backends.begin(), c.backends.end(), backend) == c.backends.end() || !matches(c.name, filter))
            continue;
        outcomes.push_back(runCase(c.name, c.run, functions, device, backend));
        if (onOutcome)
            onOutcome(outcomes.back());
    }
    return outcomes;
}

} // namespace agaa::conformance
