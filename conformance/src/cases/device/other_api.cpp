// Handles of the other graphics API: functions refuse its contexts and views.
#include "cases.h"
#include "frame_rig.h"
#include "hosts/gl_device.h"

namespace agaa::conformance {

namespace {

constexpr AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT;

// Throws Skipped if there is no device.
std::unique_ptr<Device> otherDevice(Test& test) {
    return test.device().backend() == Backend::Vulkan ? makeOpenGlDevice("") : makeVulkanDevice(test.sdk, "");
}

// Calls functions of the test's API with a context of the other API.
struct Handles {
    const CurrentOpenGl current; // restores the context, which NVIDIA's driver loses with its Vulkan device
    const std::unique_ptr<Device> device;
    Test inner; // its failures become failures of the test
    std::unique_ptr<ScopedContext> context;

    explicit Handles(Test& test)
        : device(otherDevice(test)), inner(test.sdk, device.get()), context(std::make_unique<ScopedContext>(inner)) {}
};

void testContextCaps(Test& test) {
    Handles other(test);
    const std::string function =
        test.device().backend() == Backend::Vulkan ? "agaaVkGetContextCaps" : "agaaGlGetContextCaps";
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.maxImageSize = 77;
    expectRefused(test, test.device().getContextCaps(test.sdk, other.context->get(), &caps), invalid,
                  other.context->log, function, function + " with a context of the other API", "context");
    test.check(caps.maxImageSize == 77, function + " with a context of the other API changes outCaps.");
}

void testCreateView(Test& test) {
    Handles other(test);
    const std::string function = test.device().backend() == Backend::Vulkan ? "agaaVkCreateView" : "agaaGlCreateView";
    ViewDescription description(&test.device());
    AgaaView view = nullptr;
    expectRefused(test, test.device().createView(test.sdk, other.context->get(), &description.desc, &view), invalid,
                  other.context->log, function, function + " with a context of the other API", "context");
    test.check(!view, function + " with a context of the other API returns a view.");
}

} // namespace

void addOtherApiCases(Suite& suite) {
    const auto add = [&](const std::string& function, void (*run)(Test&)) {
        suite.add("agaaVk" + function + "/AGAA_ERROR_INVALID_ARGUMENT/opengl_context", {Backend::Vulkan}, run);
        suite.add("agaaGl" + function + "/AGAA_ERROR_INVALID_ARGUMENT/vulkan_context", {Backend::OpenGl}, run);
    };
    add("GetContextCaps", testContextCaps);
    add("CreateView", testCreateView);
}

} // namespace agaa::conformance
