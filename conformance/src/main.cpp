// agaa-conformance: tests a library on the devices of this machine.
#include "device.h"
#include "report.h"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <stdexcept>

namespace agaa::conformance {
namespace {

struct Arguments {
#ifdef _WIN32
    std::string library = "agaa.dll";
#else
    std::string library = // found by its soname
        "libagaa.so." + std::to_string(AGAA_VERSION_MAJOR) + "." + std::to_string(AGAA_VERSION_MINOR);
#endif
    std::string filter, device, json, junit;
    std::vector<std::string> backends = {"core", "vk", "gl"};
    bool list = false, verbose = false;
};

int listTests(const Suite& suite, const Arguments& arguments) {
    for (const Case& c : suite.cases()) {
        std::string backends;
        for (const Backend backend : c.backends) {
            const std::string name = backendName(backend);
            if (std::find(arguments.backends.begin(), arguments.backends.end(), name) == arguments.backends.end())
                continue;
            if (!backends.empty())
                backends += ',';
            backends += name;
        }
        if (!backends.empty() && matches(c.name, arguments.filter))
            std::cout << c.name << '\t' << backends << '\n';
    }
    return 0;
}

void print(const Outcome& outcome, bool isVerbose) {
    if (outcome.status == AGAA_CONFORMANCE_PASSED && !isVerbose)
        return;
    std::cout << statusName(outcome.status) << "  " << backendName(outcome.backend) << "  " << outcome.name << '\n';
    if (!outcome.reason.empty())
        std::cout << "    " << outcome.reason << '\n';
    std::cout.flush();
}

std::ofstream open(const std::string& path) {
    std::ofstream file(path);
    if (!file)
        throw std::runtime_error(path + " cannot be opened for writing.");
    return file;
}

// Skips every test of a backend without a device.
std::vector<Outcome> skipAll(const Suite& suite, Backend backend, const std::string& filter,
                             const std::string& reason) {
    return runSuite(
        [&] {
            Suite skipped;
            for (const Case& c : suite.cases())
                skipped.add(c.name, c.backends, [&reason](Test& test) { test.skip(reason); });
            return skipped;
        }(),
        Functions{}, nullptr, backend, filter, nullptr);
}

int runTests(const Suite& suite, const Arguments& arguments) {
    // Opens the report first, so that an invalid path fails before the tests.
    std::ofstream json, junit;
    if (!arguments.json.empty())
        json = open(arguments.json);
    if (!arguments.junit.empty())
        junit = open(arguments.junit);

    Library library(arguments.library);
    std::vector<std::string> missing;
    const Functions functions = findFunctions(Library::find, &library, missing);
    if (!missing.empty())
        throw std::runtime_error(arguments.library + " lacks the function " + missing.front() + " and " +
                                 std::to_string(missing.size() - 1) + " more.");
    Report report;
    report.library = library.path();
    report.version = functions.agaaGetVersion();
    std::cout << library.path() << ", version " << versionText(report.version) << '\n';

    const auto onOutcome = [&](const Outcome& outcome) { print(outcome, arguments.verbose); };
    for (const Backend backend : {Backend::Core, Backend::Vulkan, Backend::OpenGl}) {
        if (std::find(arguments.backends.begin(), arguments.backends.end(), backendName(backend)) ==
            arguments.backends.end())
            continue;
        std::unique_ptr<Device> device;
        std::vector<Outcome> outcomes;
        try {
            if (backend == Backend::Vulkan)
                device = makeVulkanDevice(functions, arguments.device);
            else if (backend == Backend::OpenGl)
                device = makeOpenGlDevice(arguments.device);
        } catch (const Skipped& skipped) {
            std::cout << backendName(backend) << ": skipped, because " << skipped.reason << '\n';
            outcomes = skipAll(suite, backend, arguments.filter, skipped.reason);
            report.outcomes.insert(report.outcomes.end(), outcomes.begin(), outcomes.end());
            continue;
        }
        if (device) {
            report.devices.push_back({backend, device->deviceName(), device->driverName()});
            std::cout << backendName(backend) << ": " << device->deviceName() << ", " << device->driverName() << '\n';
        }
        outcomes = runSuite(suite, functions, device.get(), backend, arguments.filter, onOutcome);
        report.outcomes.insert(report.outcomes.end(), outcomes.begin(), outcomes.end());
    }
    if (json.is_open())
        writeJson(json, report);
    if (junit.is_open())
        writeJunit(junit, report);
    if (!json || !junit)
        throw std::runtime_error("a report could not be written.");
    const size_t failed = report.count(AGAA_CONFORMANCE_FAILED), skipped = report.count(AGAA_CONFORMANCE_SKIPPED);
    std::cout << report.outcomes.size() << " tests: " << report.count(AGAA_CONFORMANCE_PASSED) << " passed, " << failed
              << " failed, " << skipped << " skipped.\n";
    if (report.outcomes.empty())
        throw std::runtime_error("no test matches.");
    return failed ? 1 : 0;
}

} // namespace
} // namespace agaa::conformance

int main(int argc, char** argv) {
    using namespace agaa::conformance;
    Arguments arguments;
    CLI::App app{"Tests what the headers of the AGAA SDK promise. Exit status: 0 if nothing failed, 1 if a test "
                 "failed, 2 if the "
                 "tests cannot run."};
    app.name("agaa-conformance");
    app.add_option("library", arguments.library, "The library, libagaa.so of this soname")->capture_default_str();
    app.add_flag("--list", arguments.list, "List the tests and their backends, and run none");
    app.add_option("--filter", arguments.filter,
                   "Tests by name: patterns with * and ?, separated by ':'; patterns after '-' exclude tests");
    app.add_option("--backend", arguments.backends, "core (needs no device), vk, gl, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember({"core", "vk", "gl"}))
        ->capture_default_str();
    app.add_option("--device", arguments.device, "The first device whose name contains this text");
    app.add_option("--json", arguments.json, "Write the results to this file as JSON");
    app.add_option("--junit", arguments.junit, "Write the results to this file as JUnit XML");
    app.add_flag("--verbose", arguments.verbose, "Print tests that pass, too");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        const Suite suite = makeSuite();
        return arguments.list ? listTests(suite, arguments) : runTests(suite, arguments);
    } catch (const std::exception& error) {
        std::cerr << "agaa-conformance: " << error.what() << '\n';
        return 2;
    }
}
