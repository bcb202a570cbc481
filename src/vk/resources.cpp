#include "vk/resources.h"

#include "core/base/callbacks.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/plan/access.h"
#include "core/plan/arena.h"
#include "core/plan/sample_patterns.h"
#include "vk/formats.h"

#include <algorithm>
#include <exception>
#include <map>

namespace agaa::vk {

struct ViewResources::Request {
    ResourceId resource;
    uint32_t copy; // buffers only
    VkImage image;
    VkBuffer buffer;
    VkMemoryRequirements requirements;
    uint32_t firstPass, lastPass;
    ResourceKind kind;
};

bool hasSetLocations(const Plan& plan, const Resource& resource) {
    return plan.view.placesSamples && resource.samples > 1 && (aspects(resource.format) & VK_IMAGE_ASPECT_DEPTH_BIT);
}

ViewResources::ViewResources(const Context& context, const Plan& plan) : context_(context) {
    if (plan.view.placesSamples) {
        for (const SamplePosition& at : texelPositions(plan.view))
            locations_.push_back({at.x, at.y});
        locationsInfo_.sType = VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT;
        locationsInfo_.sampleLocationsPerPixel = VkSampleCountFlagBits(plan.view.hwSamples);
        locationsInfo_.sampleLocationGridSize = {1, 1};
        locationsInfo_.sampleLocationsCount = uint32_t(locations_.size());
        locationsInfo_.pSampleLocations = locations_.data();
    }
    try {
        std::vector<Request> requests;
        create(plan, requests);
        allocateShared(requests, plan.aliases);
        for (const Request& request : requests)
            if (request.kind != ResourceKind::Image && request.kind != ResourceKind::Buffer)
                allocateBuffer(request);
        createViews(plan);
    } catch (...) {
        destroy();
        throw;
    }
}

ViewResources::~ViewResources() { destroy(); }

void ViewResources::destroy() {
    const DeviceTable& vk = context_.vk;
    for (GpuResource& resource : resources_) {
        for (VkImageView view : resource.layerViews)
            vk.DestroyImageView(context_.device, view, nullptr);
        vk.DestroyImageView(context_.device, resource.fetchView, nullptr);
        vk.DestroyImage(context_.device, resource.image, nullptr);
        for (VkBuffer buffer : resource.buffers)
            vk.DestroyBuffer(context_.device, buffer, nullptr);
    }
    for (VkDeviceMemory memory : memory_)
        vk.FreeMemory(context_.device, memory, nullptr);
    for (const AgaaVkMemory& memory : hostMemory_)
        contained([&] { return context_.hostMemory->free(context_.hostMemory->user, &memory), AGAA_OK; });
    resources_.clear();
    memory_.clear();
    hostMemory_.clear();
}

void ViewResources::create(const Plan& plan, std::vector<Request>& requests) {
    resources_.resize(plan.resources.size());
    for (ResourceId id = 0; id < plan.resources.size(); ++id) {
        const Resource& resource = plan.resources[id];
        if (resource.isImported())
            continue;
        if (resource.kind == ResourceKind::Image)
            createImage(plan, id, requests);
        else
            createBuffers(plan, id, requests);
    }
}

// The usage of a resource follows from the accesses of the passes.
static VkImageUsageFlags imageUsage(Use use) {
    switch (use) {
    case Use::ImageWrite:
        return VK_IMAGE_USAGE_STORAGE_BIT;
    case Use::Color:
        return VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    case Use::FetchedColor:
        return VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT;
    case Use::Depth: // hosts may read depth between segments
        return VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    default:
        return VK_IMAGE_USAGE_SAMPLED_BIT;
    }
}

static VkBufferUsageFlags bufferUsage(Use use) {
    switch (use) {
    case Use::Uniform:
        return VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    case Use::CopyTo:
        return VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    case Use::CopyFrom:
        return VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    case Use::Indirect:
        return VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
    case Use::Condition:
        return VK_BUFFER_USAGE_CONDITIONAL_RENDERING_BIT_EXT;
    default:
        return VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    }
}

template <typename Flags> static Flags usageOf(const Plan& plan, ResourceId id, Flags (*flagsOf)(Use), Flags readback) {
    Flags usage = plan.view.config.flags & AGAA_CONFIG_READBACK ? readback : 0;
    for (const Pass& pass : plan.passes)
        for (const Access& access : accessesOf(pass))
            usage |= access.resource == id ? flagsOf(access.use) : 0;
    return usage;
}

void ViewResources::createImage(const Plan& plan, ResourceId id, std::vector<Request>& requests) {
    const Resource& resource = plan.resources[id];
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = vkFormat(resource.format);
    info.extent = {resource.width, resource.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = resource.layers;
    info.samples = VkSampleCountFlagBits(resource.samples);
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usageOf(plan, id, imageUsage, VkImageUsageFlags(VK_IMAGE_USAGE_TRANSFER_SRC_BIT));
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    if (hasSetLocations(plan, resource))
        info.flags = VK_IMAGE_CREATE_SAMPLE_LOCATIONS_COMPATIBLE_DEPTH_BIT_EXT;
    VkImageFormatProperties limits{};
    const VkResult has = context_.instanceFunctions.GetPhysicalDeviceImageFormatProperties(
        context_.physicalDevice, info.format, info.imageType, info.tiling, info.usage, info.flags, &limits);
    if (has == VK_ERROR_FORMAT_NOT_SUPPORTED || (has == VK_SUCCESS && !(limits.sampleCounts & info.samples)))
        fail(AGAA_ERROR_UNSUPPORTED, format("the device has no images for %s (%s, %u samples).", resource.name.c_str(),
                                            formatName(resource.format), resource.samples));
    check(has, "vkGetPhysicalDeviceImageFormatProperties");
    if (resource.bytes > limits.maxResourceSize)
        fail(AGAA_ERROR_TOO_LARGE, format("%s takes %llu bytes; the device allows images of %llu.",
                                          resource.name.c_str(), static_cast<unsigned long long>(resource.bytes),
                                          static_cast<unsigned long long>(limits.maxResourceSize)));
    VkImage image = VK_NULL_HANDLE;
    check(context_.vk.CreateImage(context_.device, &info, nullptr, &image), "vkCreateImage");
    resources_[id].image = image;
    context_.name(VK_OBJECT_TYPE_IMAGE, (uint64_t)image, "agaa " + resource.name);
    if (resource.isPerPixel())
        payloadBytes_ += uint64_t(info.extent.width) * info.extent.height * info.arrayLayers * info.samples *
                         bytesPerTexel(resource.format);
    Request request{id, 0, image, VK_NULL_HANDLE, {}, resource.firstPass, resource.lastPass, resource.kind};
    context_.vk.GetImageMemoryRequirements(context_.device, image, &request.requirements);
    requests.push_back(request);
}

void ViewResources::createBuffers(const Plan& plan, ResourceId id, std::vector<Request>& requests) {
    const Resource& resource = plan.resources[id];
    for (uint32_t copy = 0; copy < resource.copies; ++copy) {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = resource.bytes;
        info.usage = usageOf(plan, id, bufferUsage, VkBufferUsageFlags(VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        if (resource.isPersistent || id == plan.breadcrumbs) // cleared before the first frame; written between passes
            info.usage |= VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        for (const Repeat& repeat : plan.repeats)
            if (repeat.predicateBuffer == id && context_.conditionalRendering)
                info.usage |= bufferUsage(Use::Condition);
        if (!info.usage) // the light buffer of a plan without lighting
            info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
        VkBuffer buffer = VK_NULL_HANDLE;
        check(context_.vk.CreateBuffer(context_.device, &info, nullptr, &buffer), "vkCreateBuffer");
        resources_[id].buffers.push_back(buffer);
        context_.name(VK_OBJECT_TYPE_BUFFER, (uint64_t)buffer, "agaa " + resource.name);
        if (resource.isPerPixel())
            payloadBytes_ += info.size;
        Request request{id, copy, VK_NULL_HANDLE, buffer, {}, resource.firstPass, resource.lastPass, resource.kind};
        context_.vk.GetBufferMemoryRequirements(context_.device, buffer, &request.requirements);
        requests.push_back(request);
    }
}

// Returns the allowed memory types, best first. Throws if there is none. Skips protected, lazily allocated and
// device-coherent types.
std::vector<uint32_t> ViewResources::memoryTypes(uint32_t allowed, VkMemoryPropertyFlags wanted,
                                                 VkMemoryPropertyFlags preferred) const {
    constexpr VkMemoryPropertyFlags plain = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                            VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    std::vector<uint32_t> types;
    for (VkMemoryPropertyFlags flags : {wanted | preferred, wanted})
        for (uint32_t type = 0; type < context_.memory.memoryTypeCount; ++type) {
            const VkMemoryPropertyFlags has = context_.memory.memoryTypes[type].propertyFlags;
            if ((allowed >> type & 1) && (has & flags) == flags && !(has & ~plain) &&
                std::find(types.begin(), types.end(), type) == types.end())
                types.push_back(type);
        }
    require(!types.empty(), AGAA_ERROR_OUT_OF_MEMORY, "the device has no memory type for a surface.");
    return types;
}

// Allocates from the first type with enough memory. If none has enough, throws the error of the first type.
ViewResources::Allocation ViewResources::allocate(uint64_t size, std::span<const uint32_t> types) {
    std::exception_ptr first;
    for (const uint32_t type : types)
        try {
            return {allocate(size, type), type};
        } catch (const Error& error) {
            if (error.code != AGAA_ERROR_OUT_OF_MEMORY && error.code != AGAA_ERROR_TOO_LARGE)
                throw;
            if (!first)
                first = std::current_exception();
        }
    std::rethrow_exception(first);
}

VkDeviceMemory ViewResources::allocate(uint64_t size, uint32_t type) {
    const uint64_t heap = context_.memory.memoryHeaps[context_.memory.memoryTypes[type].heapIndex].size;
    if (size > heap || size > context_.maxAllocation)
        fail(AGAA_ERROR_TOO_LARGE,
             format("the surfaces need %llu bytes at once; the device allows %llu.",
                    static_cast<unsigned long long>(size),
                    static_cast<unsigned long long>(std::min<uint64_t>(heap, context_.maxAllocation))));
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = size;
    info.memoryTypeIndex = type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(context_.vk.AllocateMemory(context_.device, &info, nullptr, &memory), "vkAllocateMemory");
    memory_.push_back(memory);
    context_.name(VK_OBJECT_TYPE_DEVICE_MEMORY, (uint64_t)memory, "agaa surfaces");
    return memory;
}

// Allocates one arena for all resources with the same best memory type, in a type that all of them allow. Resources
// with disjoint lifetimes share memory in the arena.
void ViewResources::allocateShared(std::vector<Request>& requests, bool alias) {
    struct Arena {
        std::vector<uint32_t> types;
        std::vector<const Request*> members;
    };
    std::map<uint32_t, Arena> arenas;
    for (const Request& request : requests)
        if (request.kind == ResourceKind::Image || request.kind == ResourceKind::Buffer) {
            const std::vector<uint32_t> types =
                memoryTypes(request.requirements.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
            Arena& arena = arenas[types.front()];
            if (arena.members.empty())
                arena.types = types;
            std::erase_if(arena.types,
                          [&](uint32_t type) { return std::find(types.begin(), types.end(), type) == types.end(); });
            arena.members.push_back(&request);
            const uint64_t alignment = std::max<uint64_t>(request.requirements.alignment, context_.granularity);
            driverBytes_ = checkedAdd(driverBytes_, alignUp(request.requirements.size, alignment));
        }
    for (const auto& [best, arena] : arenas)
        allocateArena(arena.types, arena.members, alias);
}

// If the arena exceeds the device's maximum allocation, allocates two arenas with half the members each.
void ViewResources::allocateArena(std::span<const uint32_t> types, std::span<const Request* const> members,
                                  bool alias) {
    std::vector<ArenaBlock> blocks;
    for (const Request* member : members) {
        const uint64_t alignment = std::max<uint64_t>(member->requirements.alignment, context_.granularity);
        const uint64_t bytes = member->requirements.size;
        blocks.push_back({members.size() > 1 ? alignUp(bytes, alignment) : bytes, alignment,
                          alias ? member->firstPass : 0, alias ? member->lastPass : ~0u, 0});
    }
    const uint64_t size = placeBlocks(blocks);
    if (size > context_.maxAllocation && members.size() > 1) {
        allocateArena(types, members.first(members.size() / 2), alias);
        allocateArena(types, members.subspan(members.size() / 2), alias);
        return;
    }
    uint64_t alignment = 1;
    bool hasImages = true;
    for (size_t i = 0; i < members.size(); ++i) {
        alignment = std::max(alignment, blocks[i].alignment);
        hasImages = hasImages && members[i]->image;
    }
    const Block arena =
        allocateBlock({size, alignment, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, hasImages, "agaa surfaces"}, types);
    if (!arena.isBest)
        context_.log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                           format("%llu bytes of surfaces are not in the device's best memory, which has no room for "
                                  "them; frames may take longer.",
                                  static_cast<unsigned long long>(size)));
    peakBytes_ = checkedAdd(peakBytes_, size);
    for (size_t i = 0; i < members.size(); ++i) {
        const uint64_t offset = arena.offset + blocks[i].offset;
        if (members[i]->image)
            check(context_.vk.BindImageMemory(context_.device, members[i]->image, arena.memory, offset),
                  "vkBindImageMemory");
        else
            check(context_.vk.BindBufferMemory(context_.device, members[i]->buffer, arena.memory, offset),
                  "vkBindBufferMemory");
    }
}

void ViewResources::allocateBuffer(const Request& request) {
    constexpr VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkMemoryPropertyFlags required = request.kind == ResourceKind::SmallBuffer ? 0 : host;
    const VkMemoryPropertyFlags preferred = request.kind == ResourceKind::ReadbackBuffer
                                                ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    // On some devices only a small part of device-local memory is host-visible, and other programs may have filled it.
    const Block block = allocateBlock(
        {request.requirements.size, request.requirements.alignment, required, preferred, false, "agaa buffer"},
        memoryTypes(request.requirements.memoryTypeBits, required, preferred));
    check(context_.vk.BindBufferMemory(context_.device, request.buffer, block.memory, block.offset),
          "vkBindBufferMemory");
    if (required)
        resources_[request.resource].mapped.push_back(block.mapped);
}

ViewResources::Block ViewResources::allocateBlock(const BlockRequest& wanted, std::span<const uint32_t> types) {
    if (context_.hostMemory)
        return allocateFromHost(wanted, types);
    const Allocation allocation = allocate(wanted.size, types);
    return {allocation.memory, 0, wanted.required ? map(allocation.memory) : nullptr, allocation.type == types.front()};
}

ViewResources::Block ViewResources::allocateFromHost(const BlockRequest& wanted, std::span<const uint32_t> types) {
    AgaaVkAllocationInfo info{};
    info.size = wanted.size;
    info.alignment = wanted.alignment;
    for (const uint32_t type : types)
        info.memoryTypeBits |= 1u << type;
    info.requiredFlags = wanted.required;
    info.preferredFlags = wanted.preferred;
    info.isImage = wanted.isImage;
    info.name = wanted.name;
    AgaaVkMemory memory{};
    hostMemory_.reserve(hostMemory_.size() + 1); // so that push_back() cannot throw after the allocation
    const AgaaResult result =
        contained([&] { return context_.hostMemory->allocate(context_.hostMemory->user, &info, &memory); });
    require(result == AGAA_OK, AGAA_ERROR_OUT_OF_MEMORY, "the host's AgaaVkAllocator has no memory for a surface.");
    hostMemory_.push_back(memory);
    require(memory.memory && memory.offset % info.alignment == 0, AGAA_ERROR_CALLBACK,
            "the host's AgaaVkAllocator returned no memory, or an offset that is not aligned.");
    require(!wanted.required || memory.mapped, AGAA_ERROR_CALLBACK,
            "the host's AgaaVkAllocator returned memory that is not mapped.");
    for (const uint64_t reserved : memory.reserved)
        require(reserved == 0, AGAA_ERROR_CALLBACK,
                "the host's AgaaVkAllocator set a reserved member of AgaaVkMemory.");
    return {(VkDeviceMemory)memory.memory, memory.offset, memory.mapped, true};
}

void* ViewResources::map(VkDeviceMemory memory) const {
    void* pointer = nullptr;
    check(context_.vk.MapMemory(context_.device, memory, 0, VK_WHOLE_SIZE, 0, &pointer), "vkMapMemory");
    return pointer;
}

void ViewResources::createViews(const Plan& plan) {
    for (ResourceId id = 0; id < plan.resources.size(); ++id) {
        const Resource& resource = plan.resources[id];
        if (resource.kind != ResourceKind::Image)
            continue;
        const auto view = [&](VkImageAspectFlags aspect, uint32_t layer, uint32_t layers) {
            VkImageViewCreateInfo info{};
            info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
            info.image = resources_[id].image;
            info.viewType = layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
            info.format = vkFormat(resource.format);
            info.subresourceRange = {aspect, 0, 1, layer, layers};
            VkImageView handle = VK_NULL_HANDLE;
            check(context_.vk.CreateImageView(context_.device, &info, nullptr, &handle), "vkCreateImageView");
            context_.name(VK_OBJECT_TYPE_IMAGE_VIEW, (uint64_t)handle, "agaa " + resource.name);
            return handle;
        };
        const bool depth = isDepth(resource.format);
        resources_[id].layerViews.reserve(resource.layers); // so that push_back() cannot throw after the creation
        for (uint32_t layer = 0; layer < resource.layers; ++layer)
            resources_[id].layerViews.push_back(view(aspects(resource.format), layer, 1));
        resources_[id].fetchView =
            view(depth ? VkImageAspectFlags(VK_IMAGE_ASPECT_DEPTH_BIT) : VkImageAspectFlags(VK_IMAGE_ASPECT_COLOR_BIT),
                 0, resource.layers);
    }
}

VkBuffer ViewResources::buffer(ResourceId id, uint32_t slot) const { return copyOfSlot(resources_[id].buffers, slot); }

std::byte* ViewResources::mapped(ResourceId id, uint32_t slot) const {
    return static_cast<std::byte*>(copyOfSlot(resources_[id].mapped, slot));
}

} // namespace agaa::vk
