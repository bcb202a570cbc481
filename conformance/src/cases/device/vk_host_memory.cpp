#include "vk_host_memory.h"

namespace agaa::conformance {

HostDeviceMemory::HostDeviceMemory(Test& test) : test_(test) {
    const AgaaVkDeviceDesc vk = test.device().description().vk;
    device_ = static_cast<VkDevice>(vk.device);
    vkGetPhysicalDeviceMemoryProperties(static_cast<VkPhysicalDevice>(vk.physicalDevice), &types_);
    const AgaaVkAllocator initial = AGAA_VK_ALLOCATOR_INIT;
    allocator_ = initial;
    allocator_.user = this;
    allocator_.allocate = [](void* user, const AgaaVkAllocationInfo* info, AgaaVkMemory* out) {
        return static_cast<HostDeviceMemory*>(user)->allocate(*info, *out);
    };
    allocator_.free = [](void* user, const AgaaVkMemory* memory) {
        static_cast<HostDeviceMemory*>(user)->release(*memory);
    };
}

void HostDeviceMemory::chainTo(ContextDescription& description) {
    allocator_.pNext = description.desc.pNext;
    description.desc.pNext = &allocator_;
}

uint64_t HostDeviceMemory::liveBytes() const {
    uint64_t bytes = 0;
    for (const auto& [allocation, block] : live_)
        bytes += block.size;
    return bytes;
}

void HostDeviceMemory::checkInfo(const AgaaVkAllocationInfo& info, const AgaaVkMemory& out) {
    const std::string what = "AgaaVkAllocationInfo";
    test_.check(info.size > 0, what + "::size is 0.");
    test_.check(info.alignment > 0 && !(info.alignment & (info.alignment - 1)),
                what + "::alignment is no power of two.");
    test_.check(info.memoryTypeBits && !(uint64_t(info.memoryTypeBits) >> types_.memoryTypeCount),
                what + "::memoryTypeBits names no type, or one that the device lacks.");
    test_.check(info.isImage <= 1, what + "::isImage is neither 0 nor 1.");
    test_.check(info.name && *info.name, what + "::name is null or empty.");
    for (const uint64_t reserved : info.reserved)
        test_.check(reserved == 0, what + "::reserved is not 0.");
    for (uint32_t i = 0; i < types_.memoryTypeCount; ++i)
        if (info.memoryTypeBits >> i & 1)
            test_.check((types_.memoryTypes[i].propertyFlags & info.requiredFlags) == info.requiredFlags,
                        what + "::memoryTypeBits allows a type that lacks requiredFlags.");
    test_.check(!out.memory && !out.offset && !out.mapped && !out.allocation && !out.reserved[0] && !out.reserved[1],
                "AgaaVkMemory is not cleared before the callback is called.");
}

uint32_t HostDeviceMemory::typeOf(const AgaaVkAllocationInfo& info) const {
    uint32_t first = VK_MAX_MEMORY_TYPES;
    for (uint32_t i = 0; i < types_.memoryTypeCount; ++i) {
        const VkMemoryPropertyFlags has = types_.memoryTypes[i].propertyFlags;
        if (!(info.memoryTypeBits >> i & 1) || (has & info.requiredFlags) != info.requiredFlags)
            continue;
        if ((has & info.preferredFlags) == info.preferredFlags)
            return i;
        first = std::min(first, i);
    }
    return first;
}

AgaaResult HostDeviceMemory::allocate(const AgaaVkAllocationInfo& info, AgaaVkMemory& out) {
    checkInfo(info, out);
    ++allocations;
    if (hasFailed || (failAt && --failAt == 0)) {
        hasFailed = true;
        return failure;
    }
    VkMemoryAllocateInfo native{};
    native.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    const uint64_t offset = info.alignment; // a nonzero offset, so that offsets matter
    native.allocationSize = info.size + offset;
    native.memoryTypeIndex = typeOf(info);
    Block block = {VK_NULL_HANDLE, info.size, (info.requiredFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0};
    void* begin = nullptr;
    if (native.memoryTypeIndex == VK_MAX_MEMORY_TYPES ||
        vkAllocateMemory(device_, &native, nullptr, &block.memory) != VK_SUCCESS ||
        (block.isMapped && vkMapMemory(device_, block.memory, 0, VK_WHOLE_SIZE, 0, &begin) != VK_SUCCESS)) {
        vkFreeMemory(device_, block.memory, nullptr);
        return AGAA_ERROR_OUT_OF_MEMORY;
    }
    out.memory = (uint64_t)block.memory;
    out.offset = offset;
    out.mapped = block.isMapped ? static_cast<char*>(begin) + offset : nullptr;
    out.allocation = reinterpret_cast<void*>(next_++);
    live_[out.allocation] = block;
    infos.push_back(info);
    infos.back().name = nullptr;
    if (corrupt)
        corrupt(info, out);
    return AGAA_OK;
}

void HostDeviceMemory::release(const AgaaVkMemory& memory) {
    const auto found = live_.find(memory.allocation);
    if (!test_.check(found != live_.end(),
                     "AgaaVkAllocator::free is called for memory that is not allocated, or twice."))
        return;
    vkFreeMemory(device_, found->second.memory, nullptr);
    live_.erase(found);
}

} // namespace agaa::conformance
