// Functions of Vulkan that fail while contexts and views are created or resized: each in turn.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

namespace agaa::conformance {

namespace {

void interpose(ContextDescription& d) { d.vk.getProcAddr = VulkanInterposer::getProcAddr; }

struct Fault {
    VkResult error;
    AgaaResult expected;
};
constexpr Fault deviceLost = {VK_ERROR_DEVICE_LOST, AGAA_ERROR_DEVICE};
constexpr Fault outOfHostMemory = {VK_ERROR_OUT_OF_HOST_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};
constexpr Fault outOfDeviceMemory = {VK_ERROR_OUT_OF_DEVICE_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};

// Calls while the nth function fails, for every n, until none fails. The objects that exist must be those of before.
void forEachFunction(Test& test, VulkanInterposer& vulkan, const Fault& fault, const std::string& function, LogRecorder& log,
                     const std::function<AgaaResult(LogRecorder&)>& call, const std::function<void(const std::string&)>& after) {
    const std::map<std::string, int64_t> before = vulkan.objects;
    for (uint32_t n = 1;; ++n) {
        vulkan.failAt(n, fault.error);
        const AgaaResult result = call(log);
        const std::string failed = vulkan.failed();
        vulkan.failAt(0, VK_SUCCESS);
        if (failed.empty()) {
            test.result(result, AGAA_OK, function + " after " + std::to_string(n - 1) + " calls that failed");
            test.check(n > 1, function + " calls no function that can fail.");
            return;
        }
        const std::string what = function + ", where the function " + std::to_string(n) + ", " + failed + ", returns " +
                                 std::to_string(fault.error);
        expectRefused(test, result, fault.expected, log, function, what, failed);
        test.check(vulkan.objects == before, what + ": there are " + objectsText(vulkan.objects) + " where there were " +
                                                 objectsText(before) + ".");
        after(what);
    }
}

void testContext(Test& test, const Fault& fault) {
    VulkanInterposer vulkan;
    LogRecorder log;
    AgaaContext context = untouchedHandle<AgaaContext>();
    const auto create = [&](LogRecorder& to) {
        ContextDescription description = test.device().description();
        description.desc.log = to.get();
        interpose(description);
        return test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
    };
    forEachFunction(test, vulkan, fault, "agaaVkCreateContext", log, create, [&](const std::string& what) {
        test.check(context == untouchedHandle<AgaaContext>(), what + ", changes outContext.");
    });
    if (context == untouchedHandle<AgaaContext>())
        return;
    test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
    test.check(vulkan.objects.empty(), "a context leaves " + objectsText(vulkan.objects) + ".");
    expectNoMessages(test, "agaaVkCreateContext");
}

// Of all sorts of objects: with times, shadows, and a pass of each kind.
void describe(ViewDescription& d) {
    d.config.flags |= AGAA_CONFIG_TIMESTAMPS;
    d.facts.shadowMapCount = 1;
}

void testView(Test& test, const Fault& fault) {
    VulkanInterposer vulkan;
    OwnContext context(test, interpose);
    ViewDescription description(&test.device());
    describe(description);
    AgaaView view = untouchedHandle<AgaaView>();
    const std::map<std::string, int64_t> before = vulkan.objects;
    forEachFunction(
        test, vulkan, fault, "agaaVkCreateView", context.log,
        [&](LogRecorder&) { return test.device().createView(test.sdk, context.get(), &description.desc, &view); },
        [&](const std::string& what) { test.check(view == untouchedHandle<AgaaView>(), what + ", changes outView."); });
    if (view == untouchedHandle<AgaaView>())
        return;
    test.sdk.agaaDestroyView(view);
    test.check(vulkan.objects == before, "agaaDestroyView leaves " + objectsText(vulkan.objects) + " where there were " +
                                             objectsText(before) + ".");
    expectNoMessages(test, "agaaVkCreateView");
}

// The device has no images any more of the formats that the view has.
void testFormats(Test& test) {
    VulkanInterposer vulkan;
    Rig rig(test, {}, interpose);
    const Image image = rig.render();
    const std::map<std::string, int64_t> before = vulkan.objects;
    vulkan.hasImageFormats = false;
    expectRefused(test, test.sdk.agaaResizeView(rig.view.get(), 48, 40), AGAA_ERROR_UNSUPPORTED, rig.context.log,
                  "agaaResizeView", "agaaResizeView on a device without images");
    test.check(vulkan.objects == before, "agaaResizeView fails and leaves " + objectsText(vulkan.objects) + ".");
    expectNextFrame(rig, image, "agaaResizeView on a device without images");
    vulkan.hasImageFormats = true;
    test.result(test.sdk.agaaResizeView(rig.view.get(), 48, 40), AGAA_OK, "agaaResizeView after one that failed");
}

void testResize(Test& test, const Fault& fault) {
    VulkanInterposer vulkan;
    Rig rig(test, {}, interpose);
    const Image image = rig.render();
    uint32_t count = 0;
    forEachFunction(
        test, vulkan, fault, "agaaResizeView", rig.context.log,
        [&](LogRecorder&) { return test.sdk.agaaResizeView(rig.view.get(), 48, 40); },
        [&](const std::string& what) {
            if (count++ % 8 == 0) // a frame takes longer than all else
                expectNextFrame(rig, image, what);
        });
    test.result(test.sdk.agaaResizeView(rig.view.get(), 32, 24), AGAA_OK, "agaaResizeView back");
    rig.device().prepare(test.sdk, rig.view.get());
    expectNextFrame(rig, image, "agaaResizeView back");
}

} // namespace

void addVulkanFaultCases(Suite& suite) {
    const auto vk = [&](const std::string& name, void (*run)(Test&, const Fault&), const Fault& fault) {
        suite.add(name, {Backend::Vulkan}, [run, fault](Test& test) { run(test, fault); });
    };
    suite.add("agaaResizeView/AGAA_ERROR_UNSUPPORTED", {Backend::Vulkan}, testFormats);
    struct Row {
        const char* function;
        void (*run)(Test&, const Fault&);
    };
    for (const Row& row : {Row{"agaaVkCreateContext", testContext}, Row{"agaaVkCreateView", testView},
                           Row{"agaaResizeView", testResize}}) {
        const std::string function = row.function, variant = function == "agaaResizeView" ? "/vulkan" : "";
        vk(function + "/AGAA_ERROR_DEVICE", row.run, deviceLost);
        vk(function + "/AGAA_ERROR_OUT_OF_MEMORY" + variant, row.run, outOfDeviceMemory);
        vk(function + "/AGAA_ERROR_OUT_OF_MEMORY/vulkan_host_memory", row.run, outOfHostMemory);
    }
}

} // namespace agaa::conformance
