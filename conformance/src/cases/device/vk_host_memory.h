// An AgaaVkAllocator of the suite: it checks what the SDK asks for, fails when it is told to, and counts.
#pragma once

#include "creation.h"

#include <vulkan/vulkan.h>

#include <map>

namespace agaa::conformance {

class HostDeviceMemory {
public:
    explicit HostDeviceMemory(Test& test);
    HostDeviceMemory(const HostDeviceMemory&) = delete;
    HostDeviceMemory& operator=(const HostDeviceMemory&) = delete;

    // Chains the allocator to the description.
    void chainTo(ContextDescription& description);
    const AgaaVkAllocator* get() const { return &allocator_; }

    uint32_t failAt = 0; // the nth allocation from now on fails, and all later ones; 0: none
    AgaaResult failure = AGAA_ERROR_OUT_OF_MEMORY; // that allocate returns then
    bool hasFailed = false;
    std::function<void(const AgaaVkAllocationInfo&, AgaaVkMemory&)> spoil; // what is returned

    size_t live() const { return live_.size(); }
    uint64_t liveBytes() const; // that were asked for
    uint32_t allocations = 0;
    std::vector<AgaaVkAllocationInfo> infos; // of all successful allocations; names are not kept

private:
    struct Block {
        VkDeviceMemory memory;
        uint64_t size;
        bool isMapped;
    };
    AgaaResult allocate(const AgaaVkAllocationInfo& info, AgaaVkMemory& out);
    void checkInfo(const AgaaVkAllocationInfo& info, const AgaaVkMemory& out);
    void release(const AgaaVkMemory& memory);
    uint32_t typeOf(const AgaaVkAllocationInfo& info) const;

    Test& test_;
    VkDevice device_;
    VkPhysicalDeviceMemoryProperties types_;
    AgaaVkAllocator allocator_;
    std::map<void*, Block> live_; // by AgaaVkMemory::allocation
    uintptr_t next_ = 1;
};

} // namespace agaa::conformance
