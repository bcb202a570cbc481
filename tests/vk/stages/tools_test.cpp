// What tools see of a frame: the labels of its passes, and after a loss the pass that the device did not finish.
#include "dispatch_hook.h"
#include "show.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace agaa::test {
namespace {

// Sets the hook for the lifetime of an object.
struct ScopedHook {
    explicit ScopedHook(std::function<void(VkCommandBuffer)> before) { DispatchHook::before = std::move(before); }
    ~ScopedHook() { DispatchHook::before = nullptr; }
};

// Reports to a test what the messenger of VK_EXT_debug_utils receives.
class LabelMessenger {
public:
    LabelMessenger() {
        VkDebugUtilsMessengerCreateInfoEXT info{};
        info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
        info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
        info.pfnUserCallback = onMessage;
        info.pUserData = this;
        const auto create = function<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT");
        EXPECT_EQ(create(sharedDevice().instance(), &info, nullptr, &messenger_), VK_SUCCESS);
    }
    ~LabelMessenger() {
        function<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(sharedDevice().instance(),
                                                                                         messenger_, nullptr);
    }
    LabelMessenger(const LabelMessenger&) = delete;
    LabelMessenger& operator=(const LabelMessenger&) = delete;

    std::vector<std::vector<std::string>> labels; // of the command buffer, by message, the innermost first

private:
    template <class F> static F function(const char* name) {
        return reinterpret_cast<F>(vkGetInstanceProcAddr(sharedDevice().instance(), name));
    }
    static VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                    VkDebugUtilsMessageTypeFlagsEXT,
                                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
        auto& labels = static_cast<LabelMessenger*>(user)->labels.emplace_back();
        for (uint32_t i = 0; i < data->cmdBufLabelCount; ++i)
            labels.emplace_back(data->pCmdBufLabels[i].pLabelName);
        return VK_FALSE;
    }
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

struct ToolBench {
    explicit ToolBench(uint64_t flags) {
        settings.config.flags |= flags;
        settings.facts.shadowMapCount = 0;
        view.emplace(context, settings);
        view->setTriangles(randomTriangles({.triangles = 8}, 3));
    }
    AgaaResult record(VkCommandBuffer commands) {
        AgaaFrame frame = view->frame();
        setLight(frame, light);
        const AgaaVkFrame vk = view->vkFrame(commands);
        return agaaVkRecordFrame(view->get(), &frame, &vk);
    }

    StageContext context{{.getProcAddr = DispatchHook::procAddr}};
    ViewSettings settings;
    AgaaLight light = sun();
    std::optional<StageView> view;
};

// An error in each dispatch makes the validation layer report the labels around it.
TEST(VkTools, TheMessengerNamesThePassOfAnError) {
    ASSERT_TRUE(sharedDevice().hasValidation());
    ToolBench bench(0);
    LabelMessenger messenger;
    const ScopedHook hook([](VkCommandBuffer commands) { vkCmdSetDepthBounds(commands, 2, 3); });
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    EXPECT_EQ(bench.record(commands), AGAA_OK);
    sharedDevice().discardCommands(commands);
    sharedDevice().takeMessages();
    std::vector<std::string> expected, reported;
    for (const agaa::Step& step : bench.view->plan().steps()) {
        const agaa::Pass& pass = bench.view->plan().passes[step.pass];
        if (pass.kind() == agaa::PassKind::Compute && pass.compute().dispatch.kind != agaa::DispatchKind::Indirect)
            expected.push_back("agaa " + pass.name);
    }
    for (const std::vector<std::string>& labels : messenger.labels) {
        ASSERT_FALSE(labels.empty());
        if (reported.empty() || reported.back() != labels[0]) // a dispatch may have several messages
            reported.push_back(labels[0]);
    }
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(reported, expected);
}

// The device waits within a pass until the host sets an event, as a device that hangs would.
TEST(VkTools, BreadcrumbsNameThePassThatHangs) {
    ToolBench bench(AGAA_CONFIG_BREADCRUMBS);
    AgaaBreadcrumbs crumbs = AGAA_BREADCRUMBS_INIT;
    EXPECT_EQ(agaaGetBreadcrumbs(bench.view->get(), &crumbs), AGAA_NOT_READY);
    const VkDevice device = sharedDevice().get();
    VkEventCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_EVENT_CREATE_INFO;
    VkEvent event = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreateEvent(device, &info, nullptr, &event), VK_SUCCESS);
    const auto& passes = bench.view->plan().passes;
    const auto isDispatched = [](const agaa::Pass& pass) { return pass.kind() == agaa::PassKind::Compute; };
    const auto hanging = uint32_t(std::ranges::find_if(passes, isDispatched) - passes.begin());
    ASSERT_GT(hanging, 0u);
    ASSERT_LT(hanging + 1, passes.size());
    uint32_t dispatches = 0;
    const ScopedHook hook([&](VkCommandBuffer commands) {
        if (dispatches++ == 0)
            vkCmdWaitEvents(commands, 1, &event, VK_PIPELINE_STAGE_HOST_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
                            nullptr, 0, nullptr, 0, nullptr);
    });
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    ASSERT_EQ(bench.record(commands), AGAA_OK);
    std::thread submission([&] { sharedDevice().submitAndWait(commands); });
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    do {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        crumbs = AGAA_BREADCRUMBS_INIT;
    } while ((agaaGetBreadcrumbs(bench.view->get(), &crumbs) != AGAA_OK || crumbs.begun.pass != hanging) &&
             std::chrono::steady_clock::now() < end);
    EXPECT_EQ(crumbs.begun.pass, hanging);
    EXPECT_EQ(crumbs.begun.name, passes[hanging].name);
    EXPECT_EQ(crumbs.begun.frameIndex, bench.view->frameIndex());
    EXPECT_EQ(crumbs.ended.pass, hanging - 1);
    EXPECT_EQ(crumbs.ended.name, passes[hanging - 1].name);
    EXPECT_EQ(vkSetEvent(device, event), VK_SUCCESS);
    submission.join();
    vkDestroyEvent(device, event, nullptr);
    EXPECT_EQ(agaaGetBreadcrumbs(bench.view->get(), &crumbs), AGAA_OK);
    EXPECT_EQ(crumbs.begun.pass, passes.size() - 1);
    EXPECT_EQ(crumbs.ended.pass, passes.size() - 1);
}

} // namespace
} // namespace agaa::test
