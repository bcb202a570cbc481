// Vulkan objects of a plan's resources. Per-pixel resources of disjoint lifetimes share memory.
#pragma once

#include "core/plan/plan.h"
#include "vk/context.h"

#include <cstddef>
#include <span>
#include <vector>

namespace agaa::vk {

// Returns whether the samples of a depth image lie where draws set them.
bool hasSetLocations(const Plan& plan, const Resource& resource);

struct GpuResource {
    VkImage image = VK_NULL_HANDLE;
    std::vector<VkImageView> layerViews;    // one per layer, for attachments
    VkImageView fetchView = VK_NULL_HANDLE; // all layers; depth formats: depth aspect only
    std::vector<VkBuffer> buffers;          // one per copy
    std::vector<void*> mapped;              // one per copy; uploads and read-back only
};

class ViewResources {
public:
    ViewResources(const Context& context, const Plan& plan);
    ~ViewResources();
    ViewResources(const ViewResources&) = delete;
    ViewResources& operator=(const ViewResources&) = delete;

    const GpuResource& operator[](ResourceId id) const { return resources_[id]; }
    VkBuffer buffer(ResourceId id, uint32_t slot) const;
    std::byte* mapped(ResourceId id, uint32_t slot) const; // upload and read-back buffers only

    // The locations of the samples of a texel, if draws set them; null otherwise.
    const VkSampleLocationsInfoEXT* sampleLocations() const { return locations_.empty() ? nullptr : &locationsInfo_; }

    uint64_t payloadBytes() const { return payloadBytes_; } // per-pixel surfaces as created
    uint64_t driverBytes() const { return driverBytes_; }   // as the driver requires
    uint64_t peakBytes() const { return peakBytes_; }       // as allocated

private:
    struct Request; // one image or buffer that needs memory
    void create(const Plan& plan, std::vector<Request>& requests);
    void createImage(const Plan& plan, ResourceId id, std::vector<Request>& requests);
    void createBuffers(const Plan& plan, ResourceId id, std::vector<Request>& requests);
    void allocateShared(std::vector<Request>& requests, bool alias);
    void allocateBuffer(const Request& request);
    void createViews(const Plan& plan);
    void allocateArena(std::span<const uint32_t> types, std::span<const Request* const> members, bool alias);
    struct Block {
        VkDeviceMemory memory = VK_NULL_HANDLE;
        uint64_t offset = 0;
        void* mapped = nullptr; // null unless the memory is host-visible
        bool isBest = true;     // the memory has the best of the allowed types
    };
    struct BlockRequest {
        uint64_t size, alignment;
        VkMemoryPropertyFlags required, preferred;
        bool isImage;
        const char* name;
    };
    Block allocateBlock(const BlockRequest& wanted, std::span<const uint32_t> types);
    Block allocateFromHost(const BlockRequest& wanted, std::span<const uint32_t> types);
    void* map(VkDeviceMemory memory) const;
    std::vector<uint32_t> memoryTypes(uint32_t allowed, VkMemoryPropertyFlags wanted,
                                      VkMemoryPropertyFlags preferred) const;
    struct Allocation {
        VkDeviceMemory memory;
        uint32_t type;
    };
    Allocation allocate(uint64_t size, std::span<const uint32_t> types);
    VkDeviceMemory allocate(uint64_t size, uint32_t type);
    void destroy();

    const Context& context_;
    std::vector<GpuResource> resources_;
    std::vector<VkSampleLocationEXT> locations_;
    VkSampleLocationsInfoEXT locationsInfo_{};
    std::vector<VkDeviceMemory> memory_;
    std::vector<AgaaVkMemory> hostMemory_;
    uint64_t payloadBytes_ = 0;
    uint64_t driverBytes_ = 0;
    uint64_t peakBytes_ = 0;
};

} // namespace agaa::vk
