// Hosts that do one thing wrong, checked as engines are: the check that is named after the mistake fails, and says why.
#include "hosts/own_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace agaa::conformance {
namespace {

struct Broken {
    std::string name;
    std::set<std::string> failing; // the checks that fail; all others pass or are skipped
    std::string words;             // in the reason of the first of them
    std::function<void(Mistakes&)> make;
    bool isVulkanAlone = false;
};

std::vector<Broken> brokenHosts() {
    const auto material = [](uint32_t pass) {
        return pass == AGAA_DRAW_PASS_AGGREGATE || pass == AGAA_DRAW_PASS_FORWARD;
    };
    return {
        {"none", {}, "", [](Mistakes&) {}},
        {"inverted normals", {"normals"}, "points away from the eye",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget&, const Scene& scene) {
                 Scene inverted = scene;
                 for (Vertex& vertex : inverted)
                     for (float& component : vertex.normal)
                         component = -component;
                 return inverted;
             };
         }},
        {"other projection", {"camera"}, "AgaaFrame's camera",
         [](Mistakes& m) { m.changeProjection = [](float* p) { p[0] *= 0.8f, p[5] *= 0.8f; }; }},
        {"wrong y", {"camera"}, "direction of y",
         [](Mistakes& m) { m.changeProjection = [](float* p) { p[5] = -p[5]; }; }},
        {"forgotten discard", {"alpha_masks"}, "one pass discards and the other does not",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget& target, const Scene& scene) {
                 Scene solid = scene;
                 if (target.pass == AGAA_DRAW_PASS_VISIBILITY)
                     for (Vertex& vertex : solid)
                         vertex.isMasked = 0;
                 return solid;
             };
         }},
        {"wrong depth function: hidden surfaces", {"depth_test"}, "hidden surfaces show",
         [material](Mistakes& m) {
             m.changeState = [material](uint32_t pass, AgaaDrawState& state) {
                 if (material(pass))
                     state.depthCompare = AGAA_COMPARE_ALWAYS;
             };
         }},
        {"wrong depth function: nothing", {"depth_test"}, "depthCompare, which is EQUAL",
         [material](Mistakes& m) {
             m.changeState = [material](uint32_t pass, AgaaDrawState& state) {
                 if (material(pass))
                     state.depthCompare = AGAA_COMPARE_LESS;
             };
         }},
        {"blending left on", {"blending"}, "disable blending", [](Mistakes& m) { m.blends = true; }},
        {"stale key", {"pipeline_keys"}, "AgaaDrawPass::pipelineKey", [](Mistakes& m) { m.keysByPass = true; }},
        {"wrong set", {"descriptor_sets"}, "AgaaDrawTarget::descriptorSet",
         [](Mistakes& m) { m.keepsFirstSet = true; }, true},
        {"missing barrier", {"messages"}, "A barrier of the host is missing",
         [](Mistakes& m) { m.forgetsBarrier = true; }, true},
        {"two draws", {"drawn_once"}, "more than once",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget&, const Scene& scene) {
                 Scene twice = scene;
                 twice.insert(twice.end(), scene.begin(), scene.end());
                 return twice;
             };
         }},
    };
}

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

// Reasons of the checks that fail, by name.
std::map<std::string, std::string> failuresOf(const OwnHost& host, int32_t& count) {
    std::map<std::string, std::string> failed;
    AgaaConformanceRun run{};
    run.structSize = sizeof run;
    run.resultUser = &failed;
    run.onResult = [](void* user, const AgaaConformanceResult* result) {
        if (result->status == AGAA_CONFORMANCE_FAILED)
            (*static_cast<std::map<std::string, std::string>*>(user))[result->name] = result->reason;
    };
    count = agaaConformanceCheckHost(&run, host.get());
    return failed;
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
        const OwnHost host(test, *device);
        int32_t count = 0;
        std::map<std::string, std::string> failed = failuresOf(host, count);
        EXPECT_EQ(count, int32_t(broken.failing.size()));
        for (const auto& [name, reason] : failed)
            EXPECT_TRUE(broken.failing.count(name.substr(name.find('/') + 1))) << name << ": " << reason;
        for (const std::string& name : broken.failing)
            EXPECT_NE(failed["integration/" + name].find(broken.words), std::string::npos)
                << name << ": " << failed["integration/" + name];
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
