// agaaVkGetDeviceCaps: failing and missing functions, and threads.
#include "cases.h"
#include "creation.h"
#include "vk_interposer.h"

#include <atomic>
#include <cstring>
#include <thread>

namespace agaa::conformance {

namespace {

const AgaaDeviceCaps initialCaps = AGAA_DEVICE_CAPS_INIT;

bool isSame(const AgaaDeviceCaps& a, const AgaaDeviceCaps& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

AgaaDeviceCaps pattern() {
    AgaaDeviceCaps caps = initialCaps;
    constexpr size_t header = sizeof(AgaaStructHeader);
    std::memset(reinterpret_cast<char*>(&caps) + header, 0x5A, sizeof caps - header);
    return caps;
}

AgaaResult interposedCaps(Test& test, const AgaaLog* log, AgaaDeviceCaps* caps) {
    ContextDescription description = test.device().description();
    description.vk.getProcAddr = VulkanInterposer::getProcAddr;
    return test.sdk.agaaVkGetDeviceCaps(description.vk.instance, description.vk.physicalDevice,
                                        description.vk.getProcAddr, log, caps);
}

void testMissingFunctions(Test& test) {
    VulkanInterposer vulkan;
    AgaaDeviceCaps caps = initialCaps;
    test.requireOk(interposedCaps(test, nullptr, &caps), "agaaVkGetDeviceCaps with functions of the suite");
    const std::set<std::string> requested = vulkan.requested;
    test.require(!requested.empty(), "agaaVkGetDeviceCaps does not ask getProcAddr for functions.");
    for (const std::string& name : requested) {
        vulkan.missing = {name};
        LogRecorder log;
        caps = pattern();
        const std::string what = "agaaVkGetDeviceCaps without " + name;
        expectRefused(test, interposedCaps(test, log.get(), &caps), AGAA_ERROR_UNSUPPORTED, log, "agaaVkGetDeviceCaps",
                      what, name);
        test.check(isSame(caps, pattern()), what + " changes outCaps.");
    }
}

void testFailures(Test& test, const std::vector<VkResult>& errors, AgaaResult expected) {
    VulkanInterposer vulkan;
    for (const VkResult error : errors)
        for (uint32_t nth = 1;; ++nth) {
            vulkan.failAt(nth, error);
            LogRecorder log;
            AgaaDeviceCaps caps = pattern();
            const AgaaResult result = interposedCaps(test, log.get(), &caps);
            if (vulkan.failed().empty()) {
                test.result(result, AGAA_OK, "agaaVkGetDeviceCaps after calls that failed");
                test.check(nth > 1, "agaaVkGetDeviceCaps calls no function that can fail.");
                break;
            }
            const std::string what =
                "agaaVkGetDeviceCaps, where " + vulkan.failed() + " returns " + std::to_string(error);
            expectRefused(test, result, expected, log, "agaaVkGetDeviceCaps", what, vulkan.failed());
            test.check(isSame(caps, pattern()), what + ", changes outCaps.");
        }
}

void testThreads(Test& test) {
    AgaaDeviceCaps expected = initialCaps;
    test.requireOk(test.device().getDeviceCaps(test.sdk, nullptr, &expected), "agaaVkGetDeviceCaps");
    std::atomic<uint32_t> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 20; ++i) {
                AgaaDeviceCaps caps = pattern();
                wrong += test.device().getDeviceCaps(test.sdk, nullptr, &caps) != AGAA_OK || !isSame(caps, expected);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    test.check(wrong == 0,
               "agaaVkGetDeviceCaps: " + std::to_string(wrong) + " of 160 calls of 8 threads at once differ.");
}

} // namespace

void addVulkanCapsCases(Suite& suite) {
    const auto vk = [&](const char* name, std::function<void(Test&)> run) {
        suite.add(name, {Backend::Vulkan}, std::move(run));
    };
    vk("agaaVkGetDeviceCaps/AGAA_ERROR_UNSUPPORTED", testMissingFunctions);
    vk("agaaVkGetDeviceCaps/AGAA_ERROR_DEVICE", [](Test& test) {
        testFailures(test, {VK_ERROR_DEVICE_LOST, VK_ERROR_INITIALIZATION_FAILED, VK_ERROR_UNKNOWN}, AGAA_ERROR_DEVICE);
    });
    vk("agaaVkGetDeviceCaps/AGAA_ERROR_OUT_OF_MEMORY", [](Test& test) {
        testFailures(test, {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}, AGAA_ERROR_OUT_OF_MEMORY);
    });
    vk("agaaVkGetDeviceCaps/threads", testThreads);
}

} // namespace agaa::conformance
