// Functions of the graphics API fail one after the other while a frame is recorded.
#include "cases.h"
#include "frame_rig.h"
#include "host_memory.h"
#include "survived.h"
#include "vk_interposer.h"

namespace agaa::conformance {

namespace {

// A view of 16 x 16 pixels.
Rig::ChangeView smallView(const std::string& technique, uint64_t flags = 0) {
    return [=](ViewDescription& description) {
        setTechnique(description, technique, 4);
        description.desc.width = description.desc.height = 16;
        description.config.flags |= flags;
    };
}

void testFault(Test& test, const std::vector<VkResult>& errors, AgaaResult code) {
    Survived all;
    for (const std::string& technique : techniques(test)) {
        VulkanInterposer api;
        Rig rig(test, smallView(technique), [&](ContextDescription& description) { api.chainTo(description); });
        rig.render();
        api.called.clear();
        const Image expected = rig.render();
        const std::vector<std::string> called = api.called;
        Survived survived;
        for (uint32_t n = 1; n <= called.size(); ++n)
            for (const VkResult error : errors) {
                const size_t failures = test.failures().size();
                const std::string& function = called[n - 1];
                const std::string what = "agaaVkRecordFrame of \"" + technique + "\", where the function " +
                                         std::to_string(n) + ", " + function + ", returns " + std::to_string(error);
                const RecordHook hook = [&](const RecordCall& call, AgaaView view, const AgaaFrame* frame,
                                            const void* native) {
                    api.failAt(n, error);
                    const AgaaResult result = call(view, frame, native);
                    test.check(api.failed() == function, what + ": the function is not called.");
                    api.failAt(0, VK_SUCCESS);
                    return result;
                };
                AgaaFrame frame = rig.nextFrame();
                expectFrameRefused(rig, frame, {code, what, function}, expected, hook);
                survived.count(test, failures);
                all.count(test, failures);
            }
        survived.print(test, "agaaVkRecordFrame of \"" + technique + "\"");
    }
    if (!all.injected())
        test.skip("the library calls no Vulkan function that can fail before the first command.");
}

// Host memory of AgaaContextDesc, counted.
struct CountedMemory {
    uint32_t calls = 0;
    static void* AGAA_CALL allocate(void* user, size_t size, size_t alignment) {
        ++static_cast<CountedMemory*>(user)->calls;
        return allocateHostMemory(size, alignment);
    }
    static void AGAA_CALL release(void*, void* memory) { freeHostMemory(memory); }
    void use(ContextDescription& description) {
        description.desc.allocate = allocate;
        description.desc.free = release;
        description.desc.allocateUser = this;
    }
};

// Inline recording on Vulkan and frames on OpenGL call no function that creates, allocates or compiles, so that none
// can fail after the first command.
void testNoAllocation(Test& test) {
    for (const std::string& technique : techniques(test)) {
        CountedMemory memory;
        const std::unique_ptr<Interposer> api = makeInterposer(test.device());
        Rig rig(test, smallView(technique, AGAA_CONFIG_TIMESTAMPS), [&](ContextDescription& description) {
            description.vk.recording = AGAA_VK_RECORDING_INLINE;
            memory.use(description);
            api->chainTo(description);
        });
        api->called.clear();
        const uint32_t calls = memory.calls;
        const std::map<std::string, int64_t> objects = api->objects;
        for (int i = 0; i < 3; ++i)
            rig.render();
        for (const std::string& function : api->called)
            test.check(false, "a frame of \"" + technique + "\" calls " + function + ", which can fail.");
        test.check(memory.calls == calls, "a frame of \"" + technique + "\" calls AgaaContextDesc::allocate.");
        test.check(api->objects == objects, "a frame of \"" + technique + "\" leaves " + objectsText(api->objects) +
                                                " where there were " + objectsText(objects) + ".");
    }
}

} // namespace

void addFrameFaultCases(Suite& suite) {
    suite.add("agaaVkRecordFrame/AGAA_ERROR_OUT_OF_MEMORY", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY}, AGAA_ERROR_OUT_OF_MEMORY);
    });
    suite.add("agaaVkRecordFrame/AGAA_ERROR_DEVICE", {Backend::Vulkan}, [](Test& test) {
        testFault(test, {VK_ERROR_DEVICE_LOST, VK_ERROR_UNKNOWN}, AGAA_ERROR_DEVICE);
    });
    addRecordCase(suite, "no_allocation", testNoAllocation);
}

} // namespace agaa::conformance
