// Contexts, views and frames on Vulkan, through the C++ header.
#include "agaa_vk.hpp"
#include "destroyed.h"
#include "vk_device.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

// Memory of the host, by two callbacks with one object.
struct Memory {
    VkDevice device{};
    int64_t blocks = 0, allocations = 0;
    AgaaResult operator()(const AgaaVkAllocationInfo* info, AgaaVkMemory* memory) noexcept {
        VkMemoryAllocateInfo allocateInfo{};
        allocateInfo.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        allocateInfo.allocationSize = info->size;
        while ((info->memoryTypeBits >> allocateInfo.memoryTypeIndex & 1) == 0)
            ++allocateInfo.memoryTypeIndex;
        VkDeviceMemory made{};
        if (vkAllocateMemory(device, &allocateInfo, nullptr, &made) != VK_SUCCESS)
            return AGAA_ERROR_OUT_OF_MEMORY;
        if ((info->requiredFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0 &&
            vkMapMemory(device, made, 0, VK_WHOLE_SIZE, 0, &memory->mapped) != VK_SUCCESS)
            return AGAA_ERROR_OUT_OF_MEMORY;
        memory->memory = (uint64_t)made;
        ++blocks, ++allocations;
        return AGAA_OK;
    }
    void operator()(const AgaaVkMemory* memory) noexcept {
        vkFreeMemory(device, (VkDeviceMemory)memory->memory, nullptr);
        --blocks;
    }
};

struct Vulkan : testing::Test {
    Vulkan() {
        destroyed::handles().clear();
        memory.device = host.device;
        agaa::bind(allocator.allocate, allocator.user, memory);
        agaa::bind(allocator.free, allocator.user, memory);
        device.instance = host.instance, device.physicalDevice = host.physicalDevice, device.device = host.device;
        device.getProcAddr = getProcAddr;
        device.apiVersion = VK_API_VERSION_1_2;
        agaa::chain(desc, device, allocator);
        facts.shadowMapCount = 0;
        viewDesc.width = viewDesc.height = 32;
        viewDesc.config = &config, viewDesc.facts = &facts;
    }
    static AgaaVkFunction getProcAddr(void* instance, const char* name) {
        return vkGetInstanceProcAddr(static_cast<VkInstance>(instance), name);
    }

    cpp_header::VkHost host;
    Memory memory;
    AgaaVkAllocator allocator = agaa::init<AgaaVkAllocator>();
    AgaaVkDeviceDesc device = agaa::init<AgaaVkDeviceDesc>();
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaSceneFacts facts = agaa::init<AgaaSceneFacts>();
    AgaaViewDesc viewDesc = agaa::init<AgaaViewDesc>();
};

TEST_F(Vulkan, OwnersDestroyOnce) {
    std::vector<void*> expected;
    {
        agaa::Context context = agaa::vk::createContext(desc).value();
        agaa::View view = agaa::vk::createView(context.get(), viewDesc).value();
        EXPECT_GT(memory.blocks, 0);
        EXPECT_EQ(context.reset(), AGAA_ERROR_WRONG_ORDER);
        const agaa::View moved = std::move(view);
        expected = {moved.get(), context.get()};
    }
    EXPECT_EQ(destroyed::handles(), expected);
    EXPECT_EQ(memory.blocks, 0);
    EXPECT_GT(memory.allocations, 0);
}

TEST_F(Vulkan, FailuresOwnNothing) {
    EXPECT_EQ(agaa::vk::createContext(desc, 99u << 12).code(), AGAA_ERROR_VERSION);
    const agaa::Context context = agaa::vk::createContext(desc).value();
    config.technique = "none";
    EXPECT_EQ(agaa::vk::createView(context.get(), viewDesc).code(), AGAA_ERROR_UNSUPPORTED);
    device.device = nullptr;
    EXPECT_EQ(agaa::vk::createContext(desc).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_TRUE(destroyed::handles().empty());
}

TEST_F(Vulkan, ListsOfAView) {
    const agaa::Context context = agaa::vk::createContext(desc).value();
    EXPECT_EQ(agaa::vk::getContextCaps(context.get())->maxImageSize,
              agaa::vk::getDeviceCaps(host.instance, host.physicalDevice, getProcAddr)->maxImageSize);
    const agaa::View view = agaa::vk::createView(context.get(), viewDesc).value();
    const auto passes = agaa::getDrawPasses(view.get());
    const auto both = agaa::vk::getDrawPasses(view.get());
    ASSERT_TRUE(passes && both);
    ASSERT_EQ(both->size(), passes->size());
    for (size_t i = 0; i < both->size(); ++i) {
        EXPECT_EQ((*both)[i].pass.pipelineKey, (*passes)[i].pipelineKey);
        EXPECT_EQ((*both)[i].pass.pNext, nullptr);
        EXPECT_NE((*both)[i].vk.descriptorSetLayout, 0u);
        EXPECT_NE((*both)[i].vk.depthStencilFormat, uint32_t(VK_FORMAT_UNDEFINED));
    }
    const auto depth = agaa::vk::getSurface(view.get(), "depth");
    ASSERT_TRUE(depth);
    EXPECT_NE(depth->vk.image, 0u);
    EXPECT_EQ(depth->vk.format, (*both)[0].vk.depthStencilFormat);
    EXPECT_EQ(depth->surface.pNext, nullptr);
    EXPECT_EQ(agaa::vk::getSurface(view.get(), "none").code(), AGAA_ERROR_INVALID_ARGUMENT);
}

TEST_F(Vulkan, Frames) {
    const agaa::Context context = agaa::vk::createContext(desc).value();
    const agaa::View view = agaa::vk::createView(context.get(), viewDesc).value();
    uint32_t calls = 0;
    auto draw = [&](const AgaaDrawTarget* target) noexcept {
        calls += target->commandBuffer != nullptr;
        return calls < 2 ? AgaaResult(AGAA_OK) : AgaaResult(AGAA_NOT_READY);
    };
    AgaaFrame frame = agaa::init<AgaaFrame>();
    AgaaVkFrame vkFrame = agaa::init<AgaaVkFrame>();
    agaa::bind(frame.draw, frame.drawUser, draw);
    frame.frameIndex = 1;
    frame.segments = AGAA_SEGMENT_PREPASS; // the later ones need an output
    frame.projection[0] = frame.projection[5] = 1;
    frame.projection[10] = -1.002f, frame.projection[11] = -1, frame.projection[14] = -0.2f;
    EXPECT_EQ(agaa::vk::recordFrame(view.get(), frame, vkFrame), AGAA_ERROR_INVALID_ARGUMENT);
    vkFrame.commandBuffer = host.commandBuffer;
    EXPECT_EQ(agaa::vk::recordFrame(view.get(), frame, vkFrame), AGAA_OK);
    EXPECT_EQ(calls, 1u);
    frame.frameIndex = 2;
    EXPECT_EQ(agaa::vk::recordFrame(view.get(), frame, vkFrame), AGAA_ERROR_CALLBACK);
}

TEST_F(Vulkan, Chains) {
    const agaa::Context context = agaa::vk::createContext(desc).value();
    const agaa::View view = agaa::vk::createView(context.get(), viewDesc).value();
    const auto isKnown = [](AgaaResult result) { return result != AGAA_ERROR_UNKNOWN_STRUCT; };
    const auto check = [&](auto next, const char* name) {
        using T = decltype(next);
        AgaaSurface surface = agaa::init<AgaaSurface>();
        surface.pNext = &next;
        EXPECT_EQ(isKnown(agaaGetSurface(view.get(), "depth", &surface)), (agaa::isChainable<AgaaSurface, T>)) << name;
        AgaaDrawPass passes[2] = {agaa::init<AgaaDrawPass>(), agaa::init<AgaaDrawPass>()};
        uint32_t count = 2;
        passes[0].pNext = &next;
        EXPECT_EQ(isKnown(agaaGetDrawPasses(view.get(), &count, passes)), (agaa::isChainable<AgaaDrawPass, T>)) << name;
        AgaaVkFrame vkFrame = agaa::init<AgaaVkFrame>();
        vkFrame.pNext = &next;
        EXPECT_EQ(isKnown(agaa::vk::recordFrame(view.get(), agaa::init<AgaaFrame>(), vkFrame)),
                  (agaa::isChainable<AgaaVkFrame, T>))
            << name;
    };
#define AGAA_STRUCT(name, type, size) check(agaa::init<Agaa##name>(), #name);
#define AGAA_VK_STRUCT AGAA_STRUCT
#include "core/base/structs.inc"
}

} // namespace
