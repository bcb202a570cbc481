// An AgaaVkAllocator of the suite: it checks the requests of the SDK, fails on demand, and counts.
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

    uint32_t failAt = 0; // index from now on of the first allocation that fails; later ones fail, too; 0: none
    AgaaResult failure = AGAA_ERROR_OUT_OF_MEMORY; // result of a failing allocation
    bool hasFailed = false;
    std::function<void(const AgaaVkAllocationInfo&, AgaaVkMemory&)> corrupt; // changes the returned memory

    size_t live() const { return live_.size(); }
    uint64_t liveBytes() const; // requested bytes that are not freed
    uint32_t allocations = 0;
    std::vector<AgaaVkAllocationInfo> infos; // requests of all successful allocations, without names

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
    std::map<void*, Block> live_; // key: AgaaVkMemory::allocation
    uintptr_t next_ = 1;
};

} // namespace agaa::conformance
