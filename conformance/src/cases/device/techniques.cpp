// Every technique runs on every device that satisfies AgaaVkRequirements or AgaaGlRequirements; "dcaa" also needs
// geometry shaders. The memory is the prediction of agaaQueryMemory.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_host_memory.h"

namespace agaa::conformance {

namespace {

std::string quoted(const std::string& technique) { return "\"" + technique + "\""; }

// All techniques show the colours of smallScene, with views of one context at the same time.
void testTechniques(Test& test) {
    ScopedContext context(test);
    const std::vector<std::string> names = techniques(test);
    test.check(names.size() >= 7, "agaaGetNames lists fewer than seven techniques.");
    std::vector<std::unique_ptr<ViewDescription>> descriptions;
    std::vector<std::unique_ptr<ScopedView>> views;
    for (const std::string& name : names) {
        descriptions.push_back(std::make_unique<ViewDescription>(&test.device()));
        setTechnique(*descriptions.back(), name, 4);
        views.push_back(std::make_unique<ScopedView>(test, context.get(), *descriptions.back()));
    }
    test.device().takeMessages();
    const Scene scene = smallScene(32, 24);
    // The areas exclude edges, which "fxaa" blurs.
    const float back[] = {0.5f, 0.5f, 0.5f}, second[] = {0.25f, 0.5f, 0.5f}, masked[] = {0.25f, 0.75f, 0.5f};
    for (uint64_t i = 1; i <= 2; ++i)
        for (size_t t = 0; t < names.size(); ++t) {
            AgaaFrame frame = pixelFrame(test.device(), *descriptions[t], i);
            test.device().fillOutput(0.0f);
            test.requireOk(test.device().record(test.sdk, views[t]->get(), frame, scene),
                           "a frame of " + quoted(names[t]));
            const Image image = test.device().readOutput();
            expectColor(test, image, 32, {1, 1, 7, 23}, back, 0.01f, quoted(names[t]) + ": the rectangle at the back");
            expectColor(test, image, 32, {10, 14, 31, 23}, second, 0.01f, quoted(names[t]) + ": the second rectangle");
            expectColor(test, image, 32, {18, 2, 22, 10}, masked, 0.01f, quoted(names[t]) + ": the masked rectangle");
            expectNoMessages(test, "a frame of " + quoted(names[t]));
        }
    for (const LogLine& line : context.log.lines)
        test.check(line.severity == AGAA_SEVERITY_INFO, "creating views and frames logs: " + line.text);
}

// Runs the techniques on a device with the optional features.
void testOptions(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    Test inner(test.sdk, device.get());
    try {
        testTechniques(inner);
        ScopedContext context(inner, [](ContextDescription& d) { d.vk.rendering = AGAA_VK_RENDERING_AUTO; });
        AgaaDeviceCaps deviceCaps = AGAA_DEVICE_CAPS_INIT, caps = AGAA_DEVICE_CAPS_INIT;
        inner.requireOk(device->getDeviceCaps(test.sdk, nullptr, &deviceCaps), "agaaVkGetDeviceCaps");
        inner.requireOk(device->getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
        inner.check(caps.flags == deviceCaps.flags, "a device with all options gives the context other flags (" +
                                                        std::to_string(caps.flags) + ") than agaaVkGetDeviceCaps (" +
                                                        std::to_string(deviceCaps.flags) + ").");
        ScopedContext unnamed(inner, [](ContextDescription& d) { d.vk.enabledFeatures = nullptr; });
        AgaaDeviceCaps unnamedCaps = AGAA_DEVICE_CAPS_INIT;
        inner.requireOk(device->getContextCaps(test.sdk, unnamed.get(), &unnamedCaps), "agaaVkGetContextCaps");
        inner.check(unnamedCaps.flags ==
                        (caps.flags & ~(AGAA_DEVICE_CONDITIONAL_RENDERING | AGAA_DEVICE_FRAMEBUFFER_FETCH)),
                    "enabledFeatures = null gives the context other flags.");
        inner.check(caps.subgroupSize == deviceCaps.subgroupSize && unnamedCaps.subgroupSize == 0,
                    "the context has other subgroups than agaaVkGetDeviceCaps, or has them with enabledFeatures = "
                    "null.");
        const bool isDynamic = caps.flags & AGAA_DEVICE_DYNAMIC_RENDERING;
        const auto ask = [](ContextDescription& d) { d.vk.rendering = AGAA_VK_RENDERING_DYNAMIC; };
        if (isDynamic)
            ScopedContext dynamic(inner, ask);
    } catch (const Aborted&) {
    }
    for (const std::string& failure : inner.failures())
        test.check(false, "with options: " + failure);
}

// Returns the VkRenderPass of the first draw pass, or 0.
uint64_t renderPassOf(Test& test, AgaaView view) {
    uint32_t count = 8;
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    const AgaaVkDrawPass initialNative = AGAA_VK_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(count, initial);
    std::vector<AgaaVkDrawPass> natives(count, initialNative);
    for (uint32_t i = 0; i < count; ++i)
        passes[i].pNext = &natives[i];
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    return natives[0].renderPass;
}

void testRenderings(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(device->getDeviceCaps(test.sdk, nullptr, &caps), "agaaVkGetDeviceCaps");
    if (!(caps.flags & AGAA_DEVICE_DYNAMIC_RENDERING))
        test.skip("the device has no dynamic rendering.");
    Test inner(test.sdk, device.get());
    try {
        Image images[2];
        for (const uint32_t rendering :
             {AGAA_VK_RENDERING_AUTO, AGAA_VK_RENDERING_DYNAMIC, AGAA_VK_RENDERING_RENDER_PASS}) {
            Rig rig(inner, {}, [=](ContextDescription& d) { d.vk.rendering = rendering; });
            const bool usesPass = rendering == AGAA_VK_RENDERING_RENDER_PASS;
            images[usesPass] = rig.render();
            inner.check((renderPassOf(inner, rig.view.get()) != 0) == usesPass,
                        "AgaaVkDeviceDesc::rendering = " + std::to_string(rendering) +
                            " selects the other way to render.");
        }
        expectSame(inner, images[0], images[1], 32, "the image with dynamic rendering in place of render passes");
    } catch (const Aborted&) {
    }
    for (const std::string& failure : inner.failures())
        test.check(false, failure);
}

// ---- memory ----------------------------------------------------------------------------------------

struct Prediction {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    std::vector<AgaaSurface> surfaces;
};

Prediction predict(Test& test, AgaaContext context, const ViewDescription& description) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context, &caps), "reading the capabilities of the context");
    Prediction p;
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, nullptr, &count, nullptr),
                   "agaaQueryMemory");
    p.surfaces.assign(count, initial);
    test.requireOk(test.sdk.agaaQueryMemory(&description.desc, &caps, nullptr, &p.report, &count, p.surfaces.data()),
                   "agaaQueryMemory");
    return p;
}

// Every predicted surface exists as described.
void checkSurfaces(Test& test, AgaaView view, const Prediction& p, const std::string& what) {
    for (const AgaaSurface& expected : p.surfaces) {
        if (!expected.isPerPixel)
            continue;
        AgaaSurface got = AGAA_SURFACE_INIT;
        const std::string name = what + ": the surface " + expected.name;
        if (!test.result(test.sdk.agaaGetSurface(view, expected.name, &got), AGAA_OK, "agaaGetSurface of " + name))
            continue;
        test.check(got.bytes == expected.bytes && got.width == expected.width && got.height == expected.height &&
                       got.samples == expected.samples && !std::string(got.format).compare(expected.format),
                   name + " is not as agaaQueryMemory describes it.");
    }
}

using Variant = std::pair<const char*, std::function<void(ViewDescription&)>>;
const std::vector<Variant>& variants() {
    static const std::vector<Variant> all = {
        {"", [](ViewDescription&) {}},
        {" of 31 x 7 pixels", [](ViewDescription& d) { d.desc.width = 31, d.desc.height = 7; }},
        {" with n = 8", [](ViewDescription& d) { d.config.samples = samplesOf(d.config.technique, 8); }},
        {" without counters", [](ViewDescription& d) { d.config.flags = 0; }},
        {" with READBACK and times",
         [](ViewDescription& d) { d.config.flags |= AGAA_CONFIG_READBACK | AGAA_CONFIG_TIMESTAMPS; }},
        {" for diffuse materials", [](ViewDescription& d) { d.facts.flags = AGAA_FACT_AMBIENT; }}};
    return all;
}

void testMemory(Test& test) {
    const bool isVulkan = test.device().backend() == Backend::Vulkan;
    std::unique_ptr<HostDeviceMemory> memory;
    if (isVulkan)
        memory = std::make_unique<HostDeviceMemory>(test);
    ScopedContext context(test, [&](ContextDescription& d) {
        if (isVulkan)
            memory->chainTo(d);
    });
    for (const std::string& name : techniques(test))
        for (const auto& [text, change] : variants()) {
            const std::string what = quoted(name) + text;
            ViewDescription description(&test.device());
            setTechnique(description, name, 4);
            change(description);
            const Prediction p = predict(test, context.get(), description);
            AgaaView view = nullptr;
            test.requireOk(test.device().createView(test.sdk, context.get(), &description.desc, &view),
                           "a view of " + what);
            AgaaFrameStatistics s = AGAA_FRAME_STATISTICS_INIT;
            test.result(test.sdk.agaaGetFrameStatistics(view, 0, &s), AGAA_NOT_READY,
                        "agaaGetFrameStatistics of " + what);
            test.check(s.payloadBytes == p.report.totalBytes,
                       what + ": agaaQueryMemory predicts " + std::to_string(p.report.totalBytes) +
                           " bytes, and surfaces of " + std::to_string(s.payloadBytes) + " bytes are created.");
            checkSurfaces(test, view, p, what);
            if (isVulkan) {
                // Predictions exclude the padding of drivers.
                test.check(s.driverBytes >= s.payloadBytes, what + ": driverBytes is below payloadBytes.");
                test.check(memory->liveBytes() >= p.report.peakBytes + p.report.constantBytes,
                           what + ": AgaaVkAllocator gives " + std::to_string(memory->liveBytes()) +
                               " bytes, which do not hold what agaaQueryMemory predicts.");
                test.check(memory->liveBytes() >= s.peakBytes, what + ": peakBytes is more than what was allocated.");
                if (description.config.flags & AGAA_CONFIG_READBACK)
                    test.check(s.peakBytes >= s.driverBytes, what + ": surfaces share memory.");
            } else
                test.check(s.driverBytes == 0 && s.peakBytes == s.payloadBytes,
                           what + ": driverBytes or peakBytes is wrong.");
            test.sdk.agaaDestroyView(view);
            if (isVulkan)
                test.check(memory->live() == 0, what + ": memory is not freed.");
        }
}

} // namespace

void addTechniqueCases(Suite& suite) {
    suite.both("general/techniques", testTechniques);
    suite.add("general/techniques/options", {Backend::Vulkan}, testOptions);
    suite.add("AgaaVkDeviceDesc.rendering/enum/dynamic", {Backend::Vulkan}, testRenderings);
    suite.both("general/predicted_memory", testMemory);
}

} // namespace agaa::conformance
