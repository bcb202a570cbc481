// agaaResizeView if AUTO selects another tier at the new size, on a device with small storage buffers.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

#include <cstring>

namespace agaa::conformance {

namespace {

// The aggregates of a view of 32 x 24 pixels fit a storage buffer, but those of larger views do not.
uint32_t shortRange(Test& test, const ViewDescription& description) {
    ScopedContext context(test);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    uint32_t count = 64;
    std::vector<AgaaSurface> surfaces(count, initial);
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, nullptr, &count, surfaces.data()),
                   "agaaQueryMemory");
    for (const AgaaSurface& surface : surfaces)
        if (!std::strcmp(surface.name, "aggregates"))
            return uint32_t(surface.bytes);
    test.skip("AUTO keeps no aggregates in memory on this device.");
}

struct ShortDevice {
    VulkanInterposer vulkan;
    ShortDevice(Test& test, const ViewDescription& description) {
        const uint32_t range = shortRange(test, description);
        vulkan.changeProperties = [=](VkPhysicalDeviceProperties& p) { p.limits.maxStorageBufferRange = range; };
    }
    static void use(ContextDescription& d) { d.vk.getProcAddr = VulkanInterposer::getProcAddr; }
};

std::vector<uint64_t> keysOf(Test& test, AgaaView view) {
    uint32_t count = 8;
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(count, initial);
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    std::vector<uint64_t> keys;
    for (uint32_t i = 0; i < count; ++i)
        keys.push_back(passes[i].pipelineKey);
    return keys;
}

// The view works with the other tier, and again with the first one.
void testOtherTier(Test& test) {
    const ViewDescription description(&test.device());
    ShortDevice device(test, description);
    Rig rig(test, {}, ShortDevice::use);
    const Image image = rig.render();
    const std::vector<uint64_t> keys = keysOf(test, rig.view.get());
    test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 64, 48), "agaaResizeView to a size that needs another tier");
    test.check(keysOf(test, rig.view.get()) != keys, "AUTO selects the same tier although the aggregates do not fit.");
    rig.device().prepare(test.sdk, rig.view.get());
    rig.device().setOutput(64, 48);
    ViewDescription larger(&rig.device());
    larger.desc.width = 64;
    larger.desc.height = 48;
    const Scene small = rig.scene;
    rig.scene = smallScene(64, 48);
    AgaaFrame frame = pixelFrame(rig.device(), larger, rig.recorded + 1);
    test.requireOk(rig.record(frame), "a frame with another tier");
    const float masked[] = {0.25f, 0.75f, 0.5f};
    expectColor(test, rig.device().readOutput(), 64, {32, 0, 48, 24}, masked, 0.01f,
                "the masked rectangle with another tier");
    test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 32, 24), "agaaResizeView back");
    test.check(keysOf(test, rig.view.get()) == keys, "the first size has other keys than at first.");
    rig.device().setOutput(32, 24);
    rig.scene = small;
    expectNextFrame(rig, image, "agaaResizeView back");
}

// ---- a text that the passes of one tier compile, and those of another do not ------------------------

struct ShadowView : ViewParts {
    std::string text;
    ShadowView(Test& test, const std::string& word) : ViewParts(test.sdk, &test.device()) {
        text =
            std::string("float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }\n#define ") + word + " )\n";
        facts.shadowMapCount = 1;
        shadow.glsl = text.c_str();
        chain(shadow);
    }
};

// Words that passes may use after the function of the host.
constexpr const char* words[] = {"samples", "left",  "group", "base",     "best",    "masks",
                                 "mask",    "sum",   "next",  "farthest", "members", "reach",
                                 "depth",   "first", "other", "taken",    "covered", "weight"};

void testText(Test& test) {
    const ViewDescription description(&test.device());
    ShortDevice device(test, ShadowView(test, "unused_word"));
    ScopedContext context(test, ShortDevice::use);
    for (const char* word : words) {
        ShadowView parts(test, word);
        AgaaView view = nullptr, larger = nullptr;
        const AgaaResult small = test.device().createView(test.sdk, context.get(), &parts.desc, &view);
        parts.desc.width = 64;
        parts.desc.height = 48;
        const AgaaResult large =
            small ? small : test.device().createView(test.sdk, context.get(), &parts.desc, &larger);
        if (!large && larger)
            test.sdk.agaaDestroyView(larger);
        context.log.lines.clear();
        const bool isFound = small == AGAA_OK && large == AGAA_ERROR_INVALID_ARGUMENT;
        if (isFound) {
            const std::map<std::string, int64_t> before = device.vulkan.objects;
            const std::vector<uint64_t> keys = keysOf(test, view);
            expectRefused(
                test, test.sdk.agaaResizeView(view, 64, 48), AGAA_ERROR_INVALID_ARGUMENT, context.log, "agaaResizeView",
                "agaaResizeView where a text does not compile in the passes of another tier", "AgaaShadowFunction");
            test.check(device.vulkan.objects == before && keysOf(test, view) == keys,
                       "agaaResizeView fails because of a text, and changes the view.");
        }
        if (view)
            test.sdk.agaaDestroyView(view);
        if (isFound)
            return;
    }
    test.skip("the suite has no text that the passes of one tier compile, and those of another do not.");
}

} // namespace

void addVulkanTierCases(Suite& suite) {
    suite.add("agaaResizeView/other_tier", {Backend::Vulkan}, testOtherTier);
    suite.add("agaaResizeView/AGAA_ERROR_INVALID_ARGUMENT/text", {Backend::Vulkan}, testText);
}

} // namespace agaa::conformance
