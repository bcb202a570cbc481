// Tests, and what a test says: each is named after the promise or the duty that it is about.
#pragma once

#include "library.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace agaa::conformance {

class Device; // device.h

enum class Backend { Core, Vulkan, OpenGl, Host };
const char* backendName(Backend backend); // "core", "vk", "gl", "host"

// Thrown by Test::skip() and Test::require().
struct Skipped {
    std::string reason;
};
struct Aborted {}; // the failure is recorded

// One run of one test. Checks record what failed and go on; require() ends the test.
class Test {
public:
    Test(const Functions& functions, Device* device) : sdk(functions), device_(device) {}

    const Functions& sdk;
    Device& device() const; // of tests on Vulkan and OpenGL

    bool check(bool isTrue, const std::string& sentence);
    void require(bool isTrue, const std::string& sentence);
    // what: the call, as a reader of the failure would write it.
    bool result(AgaaResult got, AgaaResult expected, const std::string& what);
    void requireOk(AgaaResult got, const std::string& what);
    [[noreturn]] void skip(const std::string& reason) const;

    const std::vector<std::string>& failures() const { return failures_; }

private:
    std::string nameOf(AgaaResult result) const;
    Device* device_;
    std::vector<std::string> failures_;
};

struct Case {
    std::string name; // PROMISE, or PROMISE/variant
    std::vector<Backend> backends;
    std::function<void(Test&)> run;
};

class Suite {
public:
    void add(std::string name, std::vector<Backend> backends, std::function<void(Test&)> run);
    void core(std::string name, std::function<void(Test&)> run) { add(std::move(name), {Backend::Core}, std::move(run)); }
    void both(std::string name, std::function<void(Test&)> run) {
        add(std::move(name), {Backend::Vulkan, Backend::OpenGl}, std::move(run));
    }
    const std::vector<Case>& cases() const { return cases_; }

private:
    std::vector<Case> cases_;
};

// The tests of the promises: those that need no device (cases/core), and all (cases/core, cases/device). The checks of an engine
// are in integration/.
Suite makeCoreSuite();
Suite makeSuite();

// As GoogleTest's --gtest_filter.
bool matches(const std::string& name, const std::string& filter);

struct Outcome {
    std::string name;
    Backend backend;
    AgaaConformanceStatus status;
    std::string reason;
    double milliseconds;
};

// Runs one test; an exception that leaves it is a failure.
Outcome runCase(const std::string& name, const std::function<void(Test&)>& run, const Functions& functions, Device* device,
                Backend backend);
// Runs the matching tests of a backend in order.
std::vector<Outcome> runSuite(const Suite& suite, const Functions& functions, Device* device, Backend backend,
                              const std::string& filter, const std::function<void(const Outcome&)>& onOutcome);

} // namespace agaa::conformance
