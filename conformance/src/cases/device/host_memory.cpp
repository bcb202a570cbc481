// Host memory of AgaaContextDesc. Every allocation is freed once. If the host returns null, the call fails and leaks
// nothing.
#include "cases.h"

#include "cases/core/structs.h"
#include "cases/core/view_parts.h"
#include "host_memory.h"

#include <algorithm>
#include <map>

namespace agaa::conformance {

namespace {

struct HostMemory {
    uint32_t calls = 0, failing = ~0u; // index of the call that returns null
    std::map<void*, size_t> blocks;
    std::vector<std::string> errors;

    static void* AGAA_CALL allocate(void* user, size_t size, size_t alignment) {
        auto& self = *static_cast<HostMemory*>(user);
        if (!alignment || alignment & (alignment - 1))
            self.errors.push_back("asks for an alignment of " + std::to_string(alignment) + ".");
        if (self.calls++ == self.failing)
            return nullptr;
        void* memory = allocateHostMemory(size, alignment);
        self.blocks[memory] = size;
        return memory;
    }
    static void AGAA_CALL release(void* user, void* memory) {
        auto& self = *static_cast<HostMemory*>(user);
        if (memory && !self.blocks.erase(memory))
            self.errors.push_back("frees memory that was not allocated or is freed already.");
        freeHostMemory(memory);
    }
    bool contains(const void* handle) const {
        const auto address = uintptr_t(handle);
        return std::ranges::any_of(blocks, [&](const auto& block) {
            const auto begin = uintptr_t(block.first);
            return begin <= address && address < begin + block.second;
        });
    }
    void use(ContextDescription& description) {
        description.desc.allocate = allocate;
        description.desc.free = release;
        description.desc.allocateUser = this;
    }
};

void checkMemory(Test& test, const HostMemory& memory, const std::string& what) {
    for (const std::string& error : memory.errors)
        test.check(false, what + ": the library " + error);
    test.check(memory.blocks.empty(),
               what + ": " + std::to_string(memory.blocks.size()) + " allocations are not freed.");
}

std::string createFunction(Test& test, const char* what) {
    return (test.device().backend() == Backend::Vulkan ? "agaaVkCreate" : "agaaGlCreate") + std::string(what);
}

// A context and a view lie in memory of the host. Their allocations fail one after the other.
void testFailures(Test& test) {
    HostMemory counted;
    {
        ScopedContext context(test, [&](ContextDescription& description) { counted.use(description); });
        ViewDescription description(&test.device());
        ScopedView view(test, context.get(), description);
        test.check(counted.contains(context.get()), "the context is not in memory of AgaaContextDesc::allocate.");
        test.check(counted.contains(view.get()), "the view is not in memory of AgaaContextDesc::allocate.");
    }
    checkMemory(test, counted, "a context and a view");
    for (uint32_t i = 0; i < counted.calls; ++i) {
        HostMemory memory;
        memory.failing = i;
        LogRecorder log;
        ContextDescription description = test.device().description();
        description.desc.log = log.get();
        memory.use(description);
        AgaaContext context = nullptr;
        const std::string what = " where allocation " + std::to_string(i) + " fails";
        AgaaResult result = test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context);
        if (memory.calls > i) {
            const std::string function = createFunction(test, "Context");
            expectRefused(test, result, AGAA_ERROR_OUT_OF_MEMORY, log, function, function + what);
            test.check(!context, function + what + " fails and returns a context.");
            checkMemory(test, memory, function + what);
            continue;
        }
        test.requireOk(result, "creating a context");
        ViewDescription parts(&test.device());
        AgaaView view = nullptr;
        log.lines.clear();
        const std::string function = createFunction(test, "View");
        result = test.device().createView(test.sdk, context, &parts.desc, &view);
        expectRefused(test, result, AGAA_ERROR_OUT_OF_MEMORY, log, function, function + what);
        test.check(!view, function + what + " fails and returns a view.");
        if (!view && test.result(test.device().createView(test.sdk, context, &parts.desc, &view), AGAA_OK,
                                 function + " after one" + what))
            test.sdk.agaaDestroyView(view);
        test.result(test.sdk.agaaDestroyContext(context), AGAA_OK, "agaaDestroyContext");
        checkMemory(test, memory, function + what);
    }
}

} // namespace

void addHostMemoryCases(Suite& suite) { suite.both("conventions/AGAA_ERROR_OUT_OF_MEMORY", testFailures); }

} // namespace agaa::conformance
