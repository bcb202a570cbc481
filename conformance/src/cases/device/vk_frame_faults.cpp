// Vulkan functions fail one after the other while a frame is recorded.
#include "cases.h"
#include "frame_rig.h"
#include "vk_interposer.h"

namespace agaa::conformance {

namespace {

void testFault(Test& test, const std::vector<VkResult>& errors, AgaaResult code) {
    VulkanInterposer vulkan;
    Rig rig(test, {}, [&](ContextDescription& d) { vulkan.chainTo(d); });
    vulkan.called.clear();
    const Image expected = rig.render();
    const std::vector<std::string> called = vulkan.called;
    if (called.empty())
        test.skip("the library calls no Vulkan function that can fail before the first command.");
    for (uint32_t n = 1; n <= called.size(); ++n)
        for (const VkResult error : errors) {
            const std::string& function = called[n - 1];
            const std::string what = "agaaVkRecordFrame, where the function " + std::to_string(n) + ", " + function +
                                     ", returns " + std::to_string(error);
            const RecordHook hook = [&](const RecordCall& call, AgaaView view, const AgaaFrame* frame,
                                        const void* native) {
                vulkan.failAt(n, error);
                const AgaaResult result = call(view, frame, native);
                test.check(vulkan.failed() == function, what + ": the function is not called.");
                vulkan.failAt(0, VK_SUCCESS);
                return result;
            };
            AgaaFrame frame = rig.nextFrame();
            expectFrameRefused(rig, frame, {code, what, function}, expected, hook);
        }
}

} // namespace

void addVulkanFrameFaultCases(Suite& suite) {
    suite.add("agaaVkRecordFrame/AGAA_ERROR_OUT_OF_MEMORY", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}, AGAA_ERROR_OUT_OF_MEMORY);
    });
    suite.add("agaaVkRecordFrame/AGAA_ERROR_DEVICE", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_DEVICE_LOST, VK_ERROR_UNKNOWN}, AGAA_ERROR_DEVICE);
    });
}

} // namespace agaa::conformance
