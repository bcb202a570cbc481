// Two contexts on one Vulkan device, on two threads. A third and a fourth thread prepare variants of the views that are
// recorded, which agaaPrepareVariants allows. The host serialises only what Vulkan wants serialised: the queue.
#include "queries.h"

#include "agaa_vk.h"
#include "render/messages.h"
#include "render/technique_config.h"
#include "vk/device.h"
#include "vk/output_image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <mutex>
#include <stdexcept>

using namespace harness::vk;

namespace agaa::test {
namespace {

constexpr uint32_t width = 24, height = 16;

// The device and the queue that both threads share.
struct Shared {
    Device device{harness::RendererOptions{}};
    VkQueue queue = VK_NULL_HANDLE;
    std::mutex queueMutex;

    Shared() { vkGetDeviceQueue(device.get(), device.queueFamily(), 0, &queue); }
};

void AGAA_CALL appendError(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity == AGAA_SEVERITY_ERROR)
        static_cast<std::string*>(user)->append(message).append("\n");
}

AgaaResult AGAA_CALL drawNothing(void*, const AgaaDrawTarget*) { return AGAA_OK; }

class Host {
public:
    explicit Host(Shared& shared) : shared_(shared), output_(shared.device, width, height) {
        AgaaLog log = AGAA_LOG_INIT;
        log.callback = appendError;
        log.user = &errors_;
        AgaaVkDeviceDesc desc = AGAA_VK_DEVICE_DESC_INIT;
        const Device& device = shared.device;
        desc.instance = device.instance();
        desc.physicalDevice = device.physicalDevice();
        desc.device = device.get();
        desc.queueFamily = device.queueFamily();
        desc.apiVersion = device.apiVersion();
        desc.getProcAddr = Device::getProcAddr;
        desc.enabledExtensions = device.extensions().data();
        desc.enabledExtensionCount = uint32_t(device.extensions().size());
        desc.enabledFeatures = device.features();
        AgaaContextDesc common = AGAA_CONTEXT_DESC_INIT;
        common.pNext = &desc;
        common.log = &log;
        require(agaaVkCreateContext(AGAA_HEADER_VERSION, &common, &context_));
        VkCommandPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.queueFamilyIndex = device.queueFamily();
        pool_ = make<CommandPool>(device.get(), vkCreateCommandPool, pool, "create a command pool");
        VkFenceCreateInfo fence{};
        fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        fence_ = make<Fence>(device.get(), vkCreateFence, fence, "create a fence");
    }
    ~Host() { EXPECT_EQ(agaaDestroyContext(context_), AGAA_OK); }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    void runView(const char* technique, uint32_t samples) {
        harness::TechniqueConfig config;
        config.technique = technique;
        config.samples = samples;
        config.flags = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS;
        AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
        facts.shadowMapCount = 0;
        AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
        desc.width = width;
        desc.height = height;
        desc.config = &config;
        desc.facts = &facts;
        AgaaView view = nullptr;
        require(agaaVkCreateView(context_, &desc, &view));
        AgaaSceneFacts fewer[2] = {facts, facts};
        fewer[0].flags &= ~AGAA_FACT_SPECULAR;
        fewer[1].flags &= ~(AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT);
        AgaaResult prepared = AGAA_OK;
        std::thread preparing([&] { prepared = agaaPrepareVariants(view, 2, fewer); });
        try {
            for (uint64_t frame = 1; frame <= 3; ++frame)
                runFrame(view, frame);
        } catch (...) {
            preparing.join();
            agaaDestroyView(view);
            throw;
        }
        preparing.join();
        EXPECT_EQ(prepared, AGAA_OK);
        EXPECT_EQ(agaaResizeView(view, width - 3, height - 5), AGAA_OK);
        agaaDestroyView(view);
        EXPECT_EQ(errors_, "");
    }

private:
    void require(AgaaResult result) const {
        if (result != AGAA_OK)
            throw std::runtime_error(errors_.empty() ? agaaResultName(result) : errors_);
    }

    void runFrame(AgaaView view, uint64_t index) {
        VkCommandBufferAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        info.commandPool = pool_.get();
        info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        info.commandBufferCount = 1;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        check(vkAllocateCommandBuffers(shared_.device.get(), &info, &commands), "allocate a command buffer");
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        check(vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
        AgaaFrame frame = AGAA_FRAME_INIT;
        frame.frameIndex = index;
        frame.completedFrame = index - 1;
        for (int i = 0; i < 4; ++i)
            frame.view[5 * i] = 1;
        const float projection[16] = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1.001f, -1, 0, 0, -0.1f, 0};
        std::copy_n(projection, 16, frame.projection);
        frame.draw = drawNothing;
        AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
        vkFrame.commandBuffer = commands;
        vkFrame.outputImage = (uint64_t)output_.image();
        vkFrame.outputView = (uint64_t)output_.view();
        vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED;
        const AgaaResult recorded = agaaVkRecordFrame(view, &frame, &vkFrame);
        check(vkEndCommandBuffer(commands), "end a command buffer");
        require(recorded);
        VkSubmitInfo submit{};
        submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        {
            const std::lock_guard lock(shared_.queueMutex);
            check(vkQueueSubmit(shared_.queue, 1, &submit, fence_.get()), "submit commands");
        }
        const VkFence fence = fence_.get();
        check(vkWaitForFences(shared_.device.get(), 1, &fence, VK_TRUE, UINT64_MAX), "wait for commands");
        check(vkResetFences(shared_.device.get(), 1, &fence), "reset a fence");
        vkFreeCommandBuffers(shared_.device.get(), pool_.get(), 1, &commands);
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        require(agaaGetFrameStatistics(view, index, &statistics));
        EXPECT_EQ(statistics.frameIndex, index);
        EXPECT_EQ(statistics.counters.visible, 0u);
        AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
        require(agaaValidateFrame(view, index, &validation));
    }

    Shared& shared_;
    std::string errors_;
    OutputImage output_;
    CommandPool pool_;
    Fence fence_;
    AgaaContext context_ = nullptr;
};

TEST(SharedDevice, HasTwoContextsOnTwoThreads) {
    {
        Shared shared;
        const ConcurrentQueries queries;
        const auto run = [&shared](std::initializer_list<std::pair<const char*, uint32_t>> views) {
            Host host(shared);
            for (const auto& [technique, samples] : views)
                host.runView(technique, samples);
        };
        runTogether([&] { run({{"single", 1}, {"ssaa", 4}}); }, [&] { run({{"ssaa", 4}, {"fxaa", 1}}); });
        if (std::getenv("AGAA_ALL_TECHNIQUES"))
            runTogether([&] { run({{"agaa", 4}, {"sbaa", 4}}); }, [&] { run({{"adaptive", 4}, {"agaa", 4}}); });
        for (const harness::ApiMessage& message : shared.device.takeMessages())
            ADD_FAILURE() << message.id << ": " << message.text;
    }
    for (const harness::ApiMessage& message : harness::takeLeftoverMessages())
        ADD_FAILURE() << message.id << ": " << message.text;
}

} // namespace
} // namespace agaa::test
