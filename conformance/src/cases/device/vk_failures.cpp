// Vulkan functions that fail while a frame is recorded.
#include "cases.h"
#include "frame_rig.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

namespace {

// Which function fails next, and how. Functions have no user pointer.
struct Fault {
    std::string function; // empty: none
    VkResult result = VK_SUCCESS;
    bool happened = false;
    std::vector<std::string> called; // of those below
} fault;

bool failsNow(const char* function) {
    fault.called.push_back(function);
    if (fault.function != function || fault.happened)
        return false;
    fault.happened = true;
    return true;
}

PFN_vkGetDeviceProcAddr getDeviceProcAddr = nullptr;

// Functions that libraries may call while they record. One that fails leaves the command buffer as
// Vulkan says.
PFN_vkBeginCommandBuffer nextBegin = nullptr;
PFN_vkEndCommandBuffer nextEnd = nullptr;
PFN_vkResetCommandBuffer nextResetBuffer = nullptr;
PFN_vkResetCommandPool nextResetPool = nullptr;

VKAPI_ATTR VkResult VKAPI_CALL begin(VkCommandBuffer commands, const VkCommandBufferBeginInfo* info) {
    return failsNow("vkBeginCommandBuffer") ? fault.result : nextBegin(commands, info);
}
VKAPI_ATTR VkResult VKAPI_CALL end(VkCommandBuffer commands) {
    const bool fails = failsNow("vkEndCommandBuffer");
    const VkResult result = nextEnd(commands);
    return fails ? fault.result : result;
}
VKAPI_ATTR VkResult VKAPI_CALL resetBuffer(VkCommandBuffer commands, VkCommandBufferResetFlags flags) {
    return failsNow("vkResetCommandBuffer") ? fault.result : nextResetBuffer(commands, flags);
}
VKAPI_ATTR VkResult VKAPI_CALL resetPool(VkDevice device, VkCommandPool pool, VkCommandPoolResetFlags flags) {
    return failsNow("vkResetCommandPool") ? fault.result : nextResetPool(device, pool, flags);
}

PFN_vkVoidFunction replace(const char* name, PFN_vkVoidFunction next) {
    const struct {
        const char* name;
        PFN_vkVoidFunction ours;
        PFN_vkVoidFunction* next;
    } rows[] = {{"vkBeginCommandBuffer", (PFN_vkVoidFunction)begin, (PFN_vkVoidFunction*)&nextBegin},
                {"vkEndCommandBuffer", (PFN_vkVoidFunction)end, (PFN_vkVoidFunction*)&nextEnd},
                {"vkResetCommandBuffer", (PFN_vkVoidFunction)resetBuffer, (PFN_vkVoidFunction*)&nextResetBuffer},
                {"vkResetCommandPool", (PFN_vkVoidFunction)resetPool, (PFN_vkVoidFunction*)&nextResetPool}};
    for (const auto& row : rows)
        if (!std::strcmp(row.name, name)) {
            *row.next = next;
            return row.ours;
        }
    return next;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
    return replace(name, getDeviceProcAddr(device, name));
}

AgaaVkFunction AGAA_CALL instanceProcAddr(void* instance, const char* name) {
    const PFN_vkVoidFunction next = vkGetInstanceProcAddr(static_cast<VkInstance>(instance), name);
    if (!std::strcmp(name, "vkGetDeviceProcAddr")) {
        getDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(next);
        return reinterpret_cast<AgaaVkFunction>(deviceProcAddr);
    }
    return reinterpret_cast<AgaaVkFunction>(replace(name, next));
}

void useFaults(ContextDescription& description) {
    description.vk.getProcAddr = instanceProcAddr;
}

void testFault(Test& test, const std::vector<VkResult>& results, AgaaResult code) {
    fault = {};
    Rig rig(test, {}, useFaults);
    fault.called.clear();
    const Image expected = rig.render();
    const std::vector<std::string> called = fault.called;
    if (called.empty())
        test.skip("the library calls no Vulkan function that can fail before the first command.");
    std::vector<std::string> tested;
    for (const std::string& function : called) {
        if (std::find(tested.begin(), tested.end(), function) != tested.end())
            continue;
        tested.push_back(function);
        for (const VkResult result : results) {
            fault = {function, result, false, {}};
            AgaaFrame frame = rig.nextFrame();
            const std::string what = function + " returns VkResult " + std::to_string(result) + " to " + rig.function();
            expectFrameRefused(rig, frame, {code, what, function}, expected);
            fault = {};
        }
    }
}

} // namespace

void addVkFailureCases(Suite& suite) {
    suite.add("agaaVkRecordFrame/AGAA_ERROR_OUT_OF_MEMORY", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}, AGAA_ERROR_OUT_OF_MEMORY);
    });
    suite.add("agaaVkRecordFrame/AGAA_ERROR_DEVICE", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_DEVICE_LOST, VK_ERROR_UNKNOWN}, AGAA_ERROR_DEVICE);
    });
}

} // namespace agaa::conformance
