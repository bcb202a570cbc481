// Tests and their results. Each test has the name of a promise or of a duty.
#pragma once

#include "library.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace agaa::conformance {

class Device; // declared in device.h

enum class Backend { Core, Vulkan, OpenGl, Host };
const char* backendName(Backend backend); // "core", "vk", "gl", "host"

// Thrown by Test::skip() and Test::require().
struct Skipped {
    std::string reason;
};
struct Aborted {}; // thrown after the failure was recorded

// One run of a test. Checks record failures and continue; require() ends the test.
class Test {
public:
    Test(const Functions& functions, Device* device) : sdk(functions), device_(device) {}

    const Functions& sdk;
    Device& device() const; // only for tests on Vulkan and OpenGL

    bool check(bool isTrue, const std::string& sentence);
    void require(bool isTrue, const std::string& sentence);
    // Checks a result. `what` names the call in the failure.
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
    void core(std::string name, std::function<void(Test&)> run) {
        add(std::move(name), {Backend::Core}, std::move(run));
    }
    void both(std::string name, std::function<void(Test&)> run) {
        add(std::move(name), {Backend::Vulkan, Backend::OpenGl}, std::move(run));
    }
    const std::vector<Case>& cases() const { return cases_; }

private:
    std::vector<Case> cases_;
};

// Return the tests of the promises: those without a device (cases/core), and all tests (cases/core, cases/device). The
// checks of an engine are in integration/.
Suite makeCoreSuite();
Suite makeSuite();

// Matches like --gtest_filter of GoogleTest.
bool matches(const std::string& name, const std::string& filter);

struct Outcome {
    std::string name;
    Backend backend;
    AgaaConformanceStatus status;
    std::string reason;
    double milliseconds;
};

// Runs one test. An exception that leaves it is a failure.
Outcome runCase(const std::string& name, const std::function<void(Test&)>& run, const Functions& functions,
                Device* device, Backend backend);
// Runs the matching tests of a backend in order.
std::vector<Outcome> runSuite(const Suite& suite, const Functions& functions, Device* device, Backend backend,
                              const std::string& filter, const std::function<void(const Outcome&)>& onOutcome);

} // namespace agaa::conformance
