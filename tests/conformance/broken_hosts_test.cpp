// Hosts that do one thing wrong, checked as engines are: the check that is named after the mistake fails, and says why.
#include "broken_hosts.h"
#include "hosts/suite_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace agaa::conformance {
namespace {

struct Row {
    Backend backend;
    Broken broken;
};
std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.broken.name; }

std::vector<Row> rows() {
    std::vector<Row> all;
    for (const Backend backend : {Backend::Vulkan, Backend::OpenGl})
        for (const Broken& broken : brokenHosts())
            if (backend == Backend::Vulkan || !broken.isVulkanAlone)
                all.push_back({backend, broken});
    return all;
}

// Reasons by name.
struct Results {
    int32_t count = 0; // that the suite says failed
    std::map<std::string, std::string> failed, skipped;
};

Results check(const SuiteHost& host) {
    Results results;
    AgaaConformanceRun run{};
    run.structSize = sizeof run;
    run.resultUser = &results;
    run.onResult = [](void* user, const AgaaConformanceResult* result) {
        auto& all = *static_cast<Results*>(user);
        if (result->status == AGAA_CONFORMANCE_FAILED)
            all.failed[result->name] = result->reason;
        else if (result->status == AGAA_CONFORMANCE_SKIPPED)
            all.skipped[result->name] = result->reason;
    };
    results.count = agaaConformanceCheckHost(&run, host.get());
    return results;
}

class BrokenHosts : public testing::TestWithParam<Row> {};

TEST_P(BrokenHosts, AreNamed) {
    const Broken& broken = GetParam().broken;
    std::vector<std::string> missing;
    const Functions functions = findFunctions(nullptr, nullptr, missing); // the library that this program links
    ASSERT_TRUE(missing.empty()) << missing.front();
    ASSERT_EQ(functions.agaaGetVersion(), agaaGetVersion()); // a call, or linkers drop the library
    std::unique_ptr<Device> device;
    try {
        device = GetParam().backend == Backend::Vulkan ? makeVulkanDevice(functions, "") : makeOpenGlDevice("");
    } catch (const Skipped& skipped) {
        GTEST_SKIP() << skipped.reason;
    }
    if (broken.failing.count("messages") && !device->testsMessages())
        GTEST_SKIP() << "The validation layer is not installed.";
    conformance::Test test(functions, device.get());
    broken.make(device->mistakes);
    {
        SuiteHost host(test, *device);
        Results results = check(host);
        EXPECT_EQ(results.count, int32_t(broken.failing.size()));
        if (broken.failing.empty() && device->testsMessages())
            for (const auto& [name, reason] : results.skipped)
                ADD_FAILURE() << name << " is skipped: " << reason;
        for (const auto& [name, reason] : results.failed)
            EXPECT_TRUE(broken.failing.count(name.substr(name.find('/') + 1))) << name << ": " << reason;
        for (const std::string& name : broken.failing)
            EXPECT_NE(results.failed["integration/" + name].find(broken.words), std::string::npos)
                << name << ": " << results.failed["integration/" + name];
    }
    EXPECT_TRUE(test.failures().empty()) << test.failures().front();
}

std::string nameOf(const testing::TestParamInfo<Row>& info) {
    std::string name = std::string(backendName(info.param.backend)) + "_" + info.param.broken.name;
    std::erase(name, ':');
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Conformance, BrokenHosts, testing::ValuesIn(rows()), nameOf);

TEST(CheckHost, RefusesWhatIsNotComplete) {
    AgaaConformanceRun run{};
    run.structSize = sizeof run;
    AgaaConformanceHost host{};
    EXPECT_EQ(agaaConformanceCheckHost(&run, nullptr), -1);
    EXPECT_EQ(agaaConformanceCheckHost(nullptr, &host), -1);
    EXPECT_EQ(agaaConformanceCheckHost(&run, &host), -1);
    run.structSize = 0;
    EXPECT_EQ(agaaConformanceTestLibrary(&run), -1);
    run.structSize = sizeof run;
    run.getFunction = [](void*, const char*) -> AgaaConformanceFunction { return nullptr; };
    EXPECT_EQ(agaaConformanceTestLibrary(&run), -1);
}

TEST(Filter, IsThatOfGoogleTest) {
    EXPECT_TRUE(matches("agaaA/B", ""));
    EXPECT_TRUE(matches("agaaA/B", "agaaA*"));
    EXPECT_TRUE(matches("agaaA/B", "x:*/?"));
    EXPECT_FALSE(matches("agaaA/B", "*/"));
    EXPECT_FALSE(matches("agaaA/B", "agaaA*-*B"));
    EXPECT_FALSE(matches("agaaA/B", "-*B"));
    EXPECT_TRUE(matches("agaaA/C", "-*B:*D"));
}

} // namespace
} // namespace agaa::conformance
