// Functions of the graphics API fail one after the other while contexts and views are created or resized.
#include "cases.h"
#include "frame_rig.h"
#include "interposer.h"
#include "survived.h"

#include "hosts/gl_device.h"

#include <vulkan/vulkan.h>

namespace agaa::conformance {

namespace {

struct Fault {
    int64_t error; // 0: OpenGL creates no object and reports no error
    AgaaResult expected;
};

struct Faults {
    Test& test;
    std::vector<Fault> faults; // the nth fault is the element n % size
    bool hasHostText = false;  // programs contain text of the host
    bool isVulkan = test.device().backend() == Backend::Vulkan;
    std::unique_ptr<Interposer> api = makeInterposer(test.device());

    std::function<void(ContextDescription&)> chain() const {
        return [this](ContextDescription& d) { api->chainTo(d); };
    }
    void expectObjects(const std::map<std::string, int64_t>& before, const std::string& what) const {
        test.check(api->objects == before, what + ": there are " + objectsText(api->objects) + " where there were " +
                                               objectsText(before) + ".");
    }
    // Repeats the call while the nth function fails, for n from 1 until none fails. A failed call must leave no
    // objects. The last call must succeed.
    void forEach(const std::string& function, LogRecorder& log, const std::function<AgaaResult()>& call,
                 const std::function<void(const std::string&)>& after, const std::string& with = "") const {
        const std::map<std::string, int64_t> before = api->objects;
        Survived survived;
        for (uint32_t n = 1;; ++n) {
            const Fault& fault = faults[n % faults.size()];
            api->failAt(n, fault.error);
            const AgaaResult result = call();
            const std::string failed = api->failed();
            api->failAt(0, 0);
            if (failed.empty()) {
                test.result(result, AGAA_OK,
                            function + with + " after " + std::to_string(n - 1) + " calls that failed");
                test.check(n > 1, function + with + " calls no function that can fail.");
                survived.print(test, function + with);
                return;
            }
            const size_t failures = test.failures().size();
            const std::string what = function + with + ", where the function " + std::to_string(n) + ", " + failed +
                                     ", fails with the error " + std::to_string(fault.error);
            // OpenGL may report an error in a later call than the failed one.
            expectRefused(test, result, expected(fault, failed, result), log, function, what, isVulkan ? failed : "");
            expectObjects(before, what);
            if (!isVulkan)
                test.device().takeMessages(); // removes messages about objects without memory
            after(what);
            survived.count(test, failures);
        }
    }

private:
    // A driver that does not compile a program need not be out of memory. Text of the host is blamed first.
    AgaaResult expected(const Fault& fault, const std::string& failed, AgaaResult result) const {
        if (fault.error != 0 || (failed != "glCompileShader" && failed != "glLinkProgram"))
            return fault.expected;
        return hasHostText && result == AGAA_ERROR_INVALID_ARGUMENT ? result : AGAA_ERROR_DEVICE;
    }
};

void testContext(Test& test, const std::vector<Fault>& list) {
    const Faults faults{test, list};
    const std::string function = apiName(test.device(), "CreateContext");
    LogRecorder log;
    AgaaContext context = untouchedHandle<AgaaContext>();
    const auto create = [&] {
        ContextDescription description = test.device().description();
        description.desc.log = log.get();
        faults.api->chainTo(description);
        return test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
    };
    faults.forEach(function, log, create, [&](const std::string& what) {
        test.check(context == untouchedHandle<AgaaContext>(), what + ", changes outContext.");
    });
    if (context == untouchedHandle<AgaaContext>())
        return;
    test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
    faults.expectObjects({}, "agaaDestroyContext");
    expectNoMessages(test, function);
}

// The view has all kinds of objects: times, shadows, and a pass of each kind.
void testView(Test& test, const std::vector<Fault>& list) {
    const Faults faults{test, list};
    const std::string function = apiName(test.device(), "CreateView");
    ScopedContext context(test, faults.chain());
    ViewDescription description(&test.device());
    description.config.flags |= AGAA_CONFIG_TIMESTAMPS;
    description.facts.shadowMapCount = 1;
    AgaaView view = untouchedHandle<AgaaView>();
    const std::map<std::string, int64_t> before = faults.api->objects;
    faults.forEach(
        function, context.log,
        [&] { return test.device().createView(test.sdk, context.get(), &description.desc, &view); },
        [&](const std::string& what) { test.check(view == untouchedHandle<AgaaView>(), what + ", changes outView."); });
    if (view == untouchedHandle<AgaaView>())
        return;
    test.sdk.agaaDestroyView(view);
    faults.expectObjects(before, "agaaDestroyView");
    expectNoMessages(test, function);
}

// A frame shows the same image with and without the variant.
void testPrepare(Test& test, const std::vector<Fault>& list) {
    const Faults faults{test, list};
    Rig rig(test, {}, faults.chain());
    const Image image = rig.render();
    AgaaSceneFacts facts = rig.description().facts;
    facts.flags = 0;
    faults.forEach(
        "agaaPrepareVariants", rig.context.log, [&] { return test.sdk.agaaPrepareVariants(rig.view.get(), 1, &facts); },
        [&](const std::string& what) {
            expectNextFrame(rig, image, what);
            test.check(rig.statistics().variantCount == 1, what + ", prepares a variant.");
        });
    expectNextFrame(rig, image, "agaaPrepareVariants after failures");
}

void testResize(Test& test, const std::vector<Fault>& list) {
    const Faults faults{test, list};
    Rig rig(test, {}, faults.chain());
    const Image image = rig.render();
    // A frame takes most of the time, and Vulkan has many functions.
    const uint32_t stride = faults.isVulkan ? 8 : 1;
    uint32_t count = 0;
    faults.forEach(
        "agaaResizeView", rig.context.log, [&] { return test.sdk.agaaResizeView(rig.view.get(), 48, 40); },
        [&](const std::string& what) {
            if (count++ % stride == 0)
                expectNextFrame(rig, image, what);
        });
    test.result(test.sdk.agaaResizeView(rig.view.get(), 32, 24), AGAA_OK, "agaaResizeView back");
    rig.device().prepare(test.sdk, rig.view.get());
    expectNextFrame(rig, image, "agaaResizeView back");
}

// Every technique, in views of 16 x 16 pixels of one context. The errors alternate. The view that is created in the end
// shows the scene.
void testTechniques(Test& test, const std::vector<Fault>& list) {
    Faults faults{test, list};
    ScopedContext context(test, faults.chain());
    const Scene scene = smallScene(16, 16);
    for (const std::string& name : techniques(test)) {
        faults.hasHostText = hasCoverageSamples(name);
        ViewDescription description(&test.device());
        setTechnique(description, name, 4);
        description.desc.width = description.desc.height = 16;
        description.config.flags |= AGAA_CONFIG_TIMESTAMPS;
        AgaaView view = untouchedHandle<AgaaView>();
        const std::map<std::string, int64_t> before = faults.api->objects;
        faults.forEach(
            apiName(test.device(), "CreateView"), context.log,
            [&] { return test.device().createView(test.sdk, context.get(), &description.desc, &view); },
            [&](const std::string& what) {
                test.check(view == untouchedHandle<AgaaView>(), what + ", changes outView.");
            },
            " of \"" + name + "\"");
        if (view == untouchedHandle<AgaaView>())
            continue;
        expectNoMessages(test, "creating a view of " + name);
        test.device().setOutput(16, 16);
        test.device().prepare(test.sdk, view);
        AgaaFrame frame = pixelFrame(test.device(), description, 1);
        test.requireOk(test.device().record(test.sdk, view, frame, scene), "a frame of " + name + " after faults");
        const float back[] = {0.5f, 0.5f, 0.5f};
        expectColor(test, test.device().readOutput(), 16, {1, 1, 3, 15}, back, 0.01f, name + " after faults");
        test.device().forget(view);
        test.sdk.agaaDestroyView(view);
        faults.expectObjects(before, "agaaDestroyView of " + name);
    }
}

} // namespace

void addFaultCases(Suite& suite) {
    constexpr Fault deviceLost = {VK_ERROR_DEVICE_LOST, AGAA_ERROR_DEVICE};
    constexpr Fault outOfHostMemory = {VK_ERROR_OUT_OF_HOST_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};
    constexpr Fault outOfDeviceMemory = {VK_ERROR_OUT_OF_DEVICE_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};
    constexpr Fault failure = {GL_INVALID_OPERATION, AGAA_ERROR_DEVICE};
    constexpr Fault outOfMemory = {GL_OUT_OF_MEMORY, AGAA_ERROR_OUT_OF_MEMORY};
    using Run = void (*)(Test&, const std::vector<Fault>&);
    const auto add = [&](const std::string& name, Backend backend, Run run, const Fault& fault) {
        suite.add(name, {backend}, [=](Test& test) { run(test, {fault}); });
    };
    add("agaaPrepareVariants/AGAA_ERROR_DEVICE", Backend::Vulkan, testPrepare, deviceLost);
    add("agaaPrepareVariants/AGAA_ERROR_OUT_OF_MEMORY", Backend::Vulkan, testPrepare, outOfDeviceMemory);
    add("agaaPrepareVariants/AGAA_ERROR_OUT_OF_MEMORY/vulkan_host_memory", Backend::Vulkan, testPrepare,
        outOfHostMemory);
    add("agaaPrepareVariants/AGAA_ERROR_DEVICE/opengl", Backend::OpenGl, testPrepare, failure);
    add("agaaPrepareVariants/AGAA_ERROR_OUT_OF_MEMORY/opengl", Backend::OpenGl, testPrepare, outOfMemory);
    add("agaaPrepareVariants/AGAA_ERROR_OUT_OF_MEMORY/no_object", Backend::OpenGl, testPrepare,
        {0, AGAA_ERROR_OUT_OF_MEMORY});
    suite.add("agaaVkCreateView/AGAA_ERROR_OUT_OF_MEMORY/techniques", {Backend::Vulkan}, [=](Test& test) {
        testTechniques(test, {outOfHostMemory, outOfDeviceMemory, deviceLost});
    });
    suite.add("agaaGlCreateView/AGAA_ERROR_OUT_OF_MEMORY/techniques", {Backend::OpenGl},
              [=](Test& test) { testTechniques(test, {outOfMemory}); });
    suite.add("agaaGlCreateView/AGAA_ERROR_OUT_OF_MEMORY/no_object", {Backend::OpenGl}, [=](Test& test) {
        testTechniques(test, {{0, AGAA_ERROR_OUT_OF_MEMORY}});
    });
    struct Row {
        const char *vulkan, *openGl;
        Run run;
    };
    for (const Row& row :
         {Row{"agaaVkCreateContext", "agaaGlCreateContext", testContext},
          Row{"agaaVkCreateView", "agaaGlCreateView", testView}, Row{"agaaResizeView", "agaaResizeView", testResize}}) {
        const std::string vk = row.vulkan, gl = row.openGl;
        const bool isOne = vk == gl; // both APIs have the function
        add(vk + "/AGAA_ERROR_DEVICE", Backend::Vulkan, row.run, deviceLost);
        add(vk + "/AGAA_ERROR_OUT_OF_MEMORY" + (isOne ? "/vulkan" : ""), Backend::Vulkan, row.run, outOfDeviceMemory);
        add(vk + "/AGAA_ERROR_OUT_OF_MEMORY/vulkan_host_memory", Backend::Vulkan, row.run, outOfHostMemory);
        add(gl + "/AGAA_ERROR_DEVICE" + (isOne ? "/opengl" : ""), Backend::OpenGl, row.run, failure);
        add(gl + "/AGAA_ERROR_OUT_OF_MEMORY" + (isOne ? "/opengl" : ""), Backend::OpenGl, row.run, outOfMemory);
    }
}

} // namespace agaa::conformance
