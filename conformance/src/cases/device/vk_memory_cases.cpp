// Device memory from the host: AgaaVkAllocator.
#include "cases.h"
#include "frame_rig.h"
#include "vk_host_memory.h"
#include "vk_interposer.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr const char* createView = "agaaVkCreateView";

// A context with device memory from the test.
struct HostContext {
    HostDeviceMemory memory;
    ScopedContext context;
    explicit HostContext(Test& test) : memory(test), context(test, [&](ContextDescription& d) { memory.chainTo(d); }) {}
};

// The SDK holds every block exactly as long as the view exists.
void testBalance(Test& test, const std::function<void(HostDeviceMemory&)>& check = {}) {
    HostDeviceMemory memory(test);
    VulkanInterposer vulkan;
    Image sdkImage, hostImage;
    {
        Rig rig(test);
        sdkImage = rig.render();
    }
    {
        Rig rig(test, {}, [&](ContextDescription& d) {
            memory.chainTo(d);
            d.vk.getProcAddr = VulkanInterposer::getProcAddr;
        });
        test.check(memory.live() > 0, "a view takes no memory of AgaaVkAllocator.");
        hostImage = rig.render();
        expectSame(test, hostImage, sdkImage, rig.description().desc.width, "the image with memory of the host");
        const size_t before = memory.live();
        const uint32_t allocations = memory.allocations;
        test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 16, 16), "agaaResizeView");
        test.check(memory.allocations > allocations, "agaaResizeView takes no memory of AgaaVkAllocator.");
        test.check(memory.live() == memory.allocations - allocations, "agaaResizeView leaves " +
                                                                          std::to_string(memory.live()) +
                                                                          " blocks of " + std::to_string(before) + ".");
        test.check(!vulkan.objects.count("DeviceMemory"),
                   "the SDK calls vkAllocateMemory although there is an AgaaVkAllocator.");
        if (check)
            check(memory);
    }
    test.check(memory.live() == 0, std::to_string(memory.live()) + " blocks are not freed with view and context.");
    test.check(vulkan.objects.empty(), "a context leaves " + objectsText(vulkan.objects) + ".");
    expectNoMessages(test, "memory of AgaaVkAllocator");
}

// `mapped` is needed only if HOST_VISIBLE is required. HostDeviceMemory returns null for all other blocks.
void testMapped(Test& test) {
    testBalance(test, [&](HostDeviceMemory& memory) {
        uint32_t mapped = 0, unmapped = 0;
        for (const AgaaVkAllocationInfo& info : memory.infos)
            ++(info.requiredFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT ? mapped : unmapped);
        test.check(mapped > 0 && unmapped > 0, "the test has no memory that is mapped, or none that is not.");
    });
}

// ---- failures --------------------------------------------------------------------------------------

// Repeats a call while the k-th allocation fails, for k from 1 until none fails.
void forEachFailure(Test& test, HostDeviceMemory& memory, const std::string& what,
                    const std::function<AgaaResult()>& call,
                    const std::function<void(AgaaResult, const std::string&)>& onFailure) {
    for (uint32_t k = 1;; ++k) {
        memory.failAt = k;
        memory.hasFailed = false;
        const AgaaResult result = call();
        const bool failed = memory.hasFailed;
        memory.failAt = 0;
        memory.hasFailed = false;
        if (!failed) {
            test.result(result, AGAA_OK, what + " after " + std::to_string(k - 1) + " calls that failed");
            test.check(k > 1, what + " allocates nothing.");
            return;
        }
        onFailure(result, what + ", where allocation " + std::to_string(k) + " fails");
    }
}

// The callback may return any value other than AGAA_OK.
void testCreateFails(Test& test) {
    for (const AgaaResult failure :
         {AgaaResult(AGAA_ERROR_OUT_OF_MEMORY), AgaaResult(AGAA_ERROR_DEVICE), AgaaResult(1)}) {
        HostContext host(test);
        host.memory.failure = failure;
        ViewDescription description(&test.device());
        AgaaView view = untouchedHandle<AgaaView>();
        forEachFailure(
            test, host.memory, createView,
            [&] { return test.device().createView(test.sdk, host.context.get(), &description.desc, &view); },
            [&](AgaaResult result, const std::string& what) {
                expectRefused(test, result, AGAA_ERROR_OUT_OF_MEMORY, host.context.log, createView, what,
                              "AgaaVkAllocator");
                test.check(host.memory.live() == 0, what + ", keeps memory.");
                test.check(view == untouchedHandle<AgaaView>(), what + ", changes outView.");
            });
        test.sdk.agaaDestroyView(view);
        test.check(host.memory.live() == 0, "agaaDestroyView keeps memory.");
    }
    expectNoMessages(test, createView);
}

void testResizeFails(Test& test) {
    HostDeviceMemory memory(test);
    Rig rig(test, {}, [&](ContextDescription& d) { memory.chainTo(d); });
    const Image image = rig.render();
    const size_t before = memory.live();
    forEachFailure(
        test, memory, "agaaResizeView", [&] { return test.sdk.agaaResizeView(rig.view.get(), 64, 48); },
        [&](AgaaResult result, const std::string& what) {
            expectRefused(test, result, AGAA_ERROR_OUT_OF_MEMORY, rig.context.log, "agaaResizeView", what,
                          "AgaaVkAllocator");
            test.check(memory.live() == before, what + ", keeps or frees memory.");
            expectNextFrame(rig, image, what);
        });
}

// ---- memory that is not valid ----------------------------------------------------------------------

struct CorruptMemory {
    const char* what;
    const char* words;
    void (*change)(const AgaaVkAllocationInfo&, AgaaVkMemory&);
};

const std::vector<CorruptMemory>& corruptMemory() {
    static const std::vector<CorruptMemory> rows = {
        {"no memory", "memory", [](const AgaaVkAllocationInfo&, AgaaVkMemory& m) { m.memory = 0; }},
        {"an offset that is not aligned", "offset",
         [](const AgaaVkAllocationInfo& i, AgaaVkMemory& m) { m.offset += i.alignment > 1 ? i.alignment / 2 : 0; }},
        {"memory that is not mapped", "mapped",
         [](const AgaaVkAllocationInfo&, AgaaVkMemory& m) { m.mapped = nullptr; }},
        {"a reserved member that is not 0", "reserved",
         [](const AgaaVkAllocationInfo&, AgaaVkMemory& m) { m.reserved[0] = 1; }},
        {"a last reserved member that is not 0", "reserved",
         [](const AgaaVkAllocationInfo&, AgaaVkMemory& m) { m.reserved[1] = UINT64_C(1) << 63; }}};
    return rows;
}

// Makes the k-th allocation invalid, for each k to which the row applies, and calls the function. Returns after the
// last k.
void forEachCorruption(Test& test, HostDeviceMemory& memory, const CorruptMemory& row, const std::string& function,
                       LogRecorder& log, const std::function<AgaaResult()>& call,
                       const std::function<void(const std::string&)>& after) {
    uint32_t found = 0;
    for (uint32_t k = 0;; ++k) {
        uint32_t number = 0;
        bool isCorrupt = false;
        memory.corrupt = [&](const AgaaVkAllocationInfo& info, AgaaVkMemory& out) {
            if (number++ != k)
                return;
            AgaaVkMemory changed = out;
            row.change(info, changed);
            const bool needsMapping = info.requiredFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
            isCorrupt = std::memcmp(&changed, &out, sizeof out) != 0 && (changed.mapped == out.mapped || needsMapping);
            if (isCorrupt)
                out = changed;
        };
        const AgaaResult result = call();
        memory.corrupt = nullptr;
        if (!isCorrupt) {
            if (!test.result(result, AGAA_OK, function + " with valid memory") || number <= k)
                break;
            continue;
        }
        ++found;
        const std::string what = function + ", where allocation " + std::to_string(k + 1) + " is " + row.what;
        expectRefused(test, result, AGAA_ERROR_CALLBACK, log, function, what, row.words);
        after(what);
    }
    test.check(found > 0, function + ": no allocation can be " + row.what + ".");
}

void testCreateWithCorruptMemory(Test& test, const std::string& words) {
    for (const CorruptMemory& row : corruptMemory()) {
        if (!words.empty() && words != row.words)
            continue;
        HostContext host(test);
        ViewDescription description(&test.device());
        const auto create = [&] {
            AgaaView view = nullptr;
            const AgaaResult result = test.device().createView(test.sdk, host.context.get(), &description.desc, &view);
            if (result == AGAA_OK)
                test.sdk.agaaDestroyView(view);
            return result;
        };
        forEachCorruption(test, host.memory, row, createView, host.context.log, create, [&](const std::string& what) {
            test.check(host.memory.live() == 0, what + ": memory is not freed.");
        });
    }
    expectNoMessages(test, createView);
}

void testResizeWithCorruptMemory(Test& test) {
    for (const CorruptMemory& row : corruptMemory()) {
        HostDeviceMemory memory(test);
        Rig rig(test, {}, [&](ContextDescription& d) { memory.chainTo(d); });
        const Image image = rig.render();
        const size_t before = memory.live();
        const auto resize = [&] {
            const AgaaResult result = test.sdk.agaaResizeView(rig.view.get(), 64, 48);
            memory.corrupt = nullptr;
            if (result == AGAA_OK)
                test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 32, 24), "agaaResizeView back");
            return result;
        };
        forEachCorruption(test, memory, row, "agaaResizeView", rig.context.log, resize, [&](const std::string& what) {
            test.check(memory.live() == before, what + ", keeps or frees memory.");
            expectNextFrame(rig, image, what);
        });
    }
}

} // namespace

void addVulkanMemoryCases(Suite& suite) {
    const auto vk = [&](const char* name, std::function<void(Test&)> run) {
        suite.add(name, {Backend::Vulkan}, std::move(run));
    };
    vk("AgaaVkAllocator/balance", [](Test& test) { testBalance(test); });
    vk("AgaaVkAllocationInfo.reserved/zero", [](Test& test) { testBalance(test); }); // the allocator checks them
    vk("AgaaVkMemory.mapped/null", [](Test& test) {
        testMapped(test);
        testCreateWithCorruptMemory(test, "mapped");
    });
    vk("AgaaVkMemory.reserved/zero", [](Test& test) { testCreateWithCorruptMemory(test, "reserved"); });
    vk("agaaVkCreateView/AGAA_ERROR_CALLBACK", [](Test& test) { testCreateWithCorruptMemory(test, ""); });
    vk("agaaResizeView/AGAA_ERROR_CALLBACK", testResizeWithCorruptMemory);
    vk("agaaVkCreateView/AGAA_ERROR_OUT_OF_MEMORY/AgaaVkAllocator", testCreateFails);
    vk("agaaResizeView/AGAA_ERROR_OUT_OF_MEMORY/AgaaVkAllocator", testResizeFails);
}

} // namespace agaa::conformance
