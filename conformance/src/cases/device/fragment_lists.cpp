// "dcaa": lists of fragments, and contexts that cannot run it.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"

#include <vulkan/vulkan.h>

namespace agaa::conformance {

namespace {

constexpr uint64_t minCapacity = 65536; // fragments that the lists of a small view hold

Rig::ChangeView withCoverage(uint32_t tier, const std::function<void(AgaaDecoupledCoverage&)>& change) {
    return [tier, change](ViewDescription& description) {
        setTechnique(description, "dcaa", 4);
        description.config.generationTier = tier;
        if (tier == AGAA_TIER_MATERIAL_LISTS)
            description.desc.pNext = nullptr;
        change(description.coverage);
    };
}

// All settings show the small scene, in which no pixel shows more than two surfaces.
void testMerges(Test& test) {
    struct Settings {
        uint32_t merge;
        uint64_t flags;
        uint32_t tier = AGAA_TIER_FRAGMENT_LISTS;
    };
    for (const Settings& settings :
         {Settings{AGAA_MERGE_VISIBLE, 0}, Settings{AGAA_MERGE_PAPER, 0}, Settings{AGAA_MERGE_NONE, 0},
          Settings{AGAA_MERGE_VISIBLE, AGAA_COVERAGE_EXACT}, Settings{AGAA_MERGE_VISIBLE, 0, AGAA_TIER_MATERIAL_LISTS},
          Settings{AGAA_MERGE_VISIBLE, AGAA_COVERAGE_EXACT, AGAA_TIER_MATERIAL_LISTS}}) {
        Rig rig(test, withCoverage(settings.tier, [settings](AgaaDecoupledCoverage& c) {
                    c.merge = settings.merge, c.flags = settings.flags;
                }));
        const Image image = rig.render();
        const std::string what = "AgaaDecoupledCoverage::merge = " + std::to_string(settings.merge) +
                                 ", flags = " + std::to_string(settings.flags) + ", tier " +
                                 test.sdk.agaaTierName(settings.tier);
        const float second[] = {0.25f, 0.5f, 0.5f}, masked[] = {0.25f, 0.75f, 0.5f};
        expectColor(test, image, 32, {8, 12, 32, 24}, second, 0.01f, what + ": the second rectangle");
        expectColor(test, image, 32, {16, 0, 24, 12}, masked, 0.01f, what + ": the masked rectangle");
        const AgaaCounters c = rig.counters();
        test.check(c.lostFragments == 0 && c.lostSamples == 0, what + ": fragments or samples are lost.");
    }
}

// Returns layers that fill the view, from back to front. They have more fragments than the lists can hold.
Scene manyLayers() {
    Scene scene;
    Surface surface;
    for (int i = 0; i < 100; ++i) {
        surface.diffuse[0] = i == 99 ? 0.25f : 0.75f;
        addRectangle(scene, 32, 24, 0, 0, 32, 24, 12 - 0.1f * float(i), surface);
    }
    return scene;
}

struct Batches {
    Device& device;
    std::vector<uint32_t> numbers;
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<Batches*>(user);
        self.numbers.push_back(target->batch);
        return self.device.draw(*target);
    }
};

// Renders a frame. Its draw callbacks must be numbered from 0, and there must be at most maxBatches.
Image renderBatches(Rig& rig, uint32_t maxBatches, const std::string& what) {
    Batches batches{rig.device(), {}};
    const Image image = rig.render([&](AgaaFrame& frame) {
        frame.draw = Batches::draw;
        frame.drawUser = &batches;
    });
    rig.test.check(!batches.numbers.empty() && batches.numbers.size() <= maxBatches,
                   what + " draws the scene " + std::to_string(batches.numbers.size()) + " times.");
    for (size_t i = 0; i < batches.numbers.size(); ++i)
        rig.test.check(batches.numbers[i] == i, what + ": AgaaDrawTarget::batch is " +
                                                    std::to_string(batches.numbers[i]) + " in draw callback " +
                                                    std::to_string(i) + ".");
    return image;
}

void testBatches(Test& test) {
    Image small;
    for (const uint32_t maxBatches : {1u, 4u}) {
        Rig rig(test, withCoverage(AGAA_TIER_AUTO, [=](AgaaDecoupledCoverage& c) {
                    c.fragmentsPerPixel = 1;
                    c.maxBatches = maxBatches;
                }));
        const std::string what = "AgaaDecoupledCoverage::maxBatches = " + std::to_string(maxBatches);
        for (Vertex& vertex : rig.scene)
            vertex.isMasked = 0;
        const Image image = renderBatches(rig, maxBatches, what);
        if (maxBatches == 1)
            small = image;
        else
            expectSame(test, image, small, 32, what + ": a scene that the lists have room for");
        rig.scene = manyLayers();
        const Image layers = renderBatches(rig, maxBatches, what);
        const AgaaCounters c = rig.counters();
        test.check(c.fragments > minCapacity, what + ": AgaaCounters::fragments is " + std::to_string(c.fragments) +
                                                  " for 100 rectangles of 768 pixels.");
        const uint64_t lost = maxBatches == 1 ? c.fragments - minCapacity : 0;
        test.check(c.lostFragments == lost, what + ": AgaaCounters::lostFragments is " +
                                                std::to_string(c.lostFragments) + " in place of " +
                                                std::to_string(lost) + ".");
        test.check(maxBatches == 1 ? c.batches == 1 : c.batches >= 2 && c.batches <= maxBatches,
                   what + ": AgaaCounters::batches is " + std::to_string(c.batches) + ".");
        const float front[] = {0.25f, 0.5f, 0.5f};
        if (maxBatches > 1)
            expectColor(test, layers, 32, {0, 0, 32, 24}, front, 0.01f, what + ": the layer in front");
    }
}

// Tests each value of AgaaGlConstants, because the geometry shader reads the constants, too.
void testConstants(Test& test) {
    Image expected;
    for (const uint32_t constants : {AGAA_GL_CONSTANTS_BLOCK, AGAA_GL_CONSTANTS_UNIFORMS, AGAA_GL_CONSTANTS_TEXELS}) {
        const auto once = [](AgaaDecoupledCoverage& c) { c.maxBatches = 1; }; // so that the lists lose what has no room
        Rig rig(test, withCoverage(AGAA_TIER_AUTO, once), [=](ContextDescription& d) {
            d.gl.constants = constants;
            d.gl.bindings[AGAA_GL_BINDING_FRAME] = 12; // a unit that no other texture uses
        });
        const Image image = rig.render();
        if (constants == AGAA_GL_CONSTANTS_BLOCK)
            expected = image;
        else
            expectSame(test, image, expected, 32,
                       "\"dcaa\" with AgaaGlDeviceDesc::constants = " + std::to_string(constants));
        rig.scene = manyLayers();
        rig.render();
        const AgaaCounters c = rig.counters();
        test.check(c.lostFragments == c.fragments - minCapacity,
                   "\"dcaa\" with AgaaGlDeviceDesc::constants = " + std::to_string(constants) + " loses " +
                       std::to_string(c.lostFragments) + " of " + std::to_string(c.fragments) + " fragments.");
    }
}

// A device on which the host does not enable geometry shaders.
void testNoGeometryShaders(Test& test) {
    ContextDescription right = test.device().description();
    VkPhysicalDeviceFeatures2 features = *static_cast<const VkPhysicalDeviceFeatures2*>(right.vk.enabledFeatures);
    features.features.geometryShader = VK_FALSE;
    ScopedContext context(test, [&](ContextDescription& d) { d.vk.enabledFeatures = &features; });
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
    test.check(!(caps.flags & AGAA_DEVICE_GEOMETRY_SHADERS),
               "agaaVkGetContextCaps has the flag GEOMETRY_SHADERS where the host enables none.");
    ViewDescription description(&test.device());
    setTechnique(description, "dcaa", 4);
    description.desc.flags &= ~AGAA_VIEW_VERTEX_PULLING; // the device has no geometry shaders
    AgaaView view = nullptr;
    expectRefused(test, test.device().createView(test.sdk, context.get(), &description.desc, &view),
                  AGAA_ERROR_UNSUPPORTED, context.log, "agaaVkCreateView",
                  "agaaVkCreateView of \"dcaa\" without geometry shaders", "geometry shaders");
    test.check(!view, "agaaVkCreateView fails and returns a view.");
    description.desc.flags |= AGAA_VIEW_VERTEX_PULLING;
    const BareView pulled(test, context.get(), description); // the view is created
}

// Passes and targets state whether vertex shaders expand triangles. The images are the same.
void testPulling(Test& test) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getDeviceCaps(test.sdk, nullptr, &caps), "asking for the capabilities of the device");
    if (!(caps.flags & AGAA_DEVICE_GEOMETRY_SHADERS))
        test.skip("the device has no geometry shaders to compare with.");
    for (const auto& [technique, tier] : {std::pair{"dcaa", AGAA_TIER_FRAGMENT_LISTS},
                                          {"dcaa", AGAA_TIER_MATERIAL_LISTS},
                                          {"agaa", AGAA_TIER_FRAGMENTS}}) {
        const std::string what = std::string("AGAA_VIEW_VERTEX_PULLING with ") + test.sdk.agaaTierName(tier);
        Image expected;
        uint64_t fragments = 0;
        for (const bool pulls : {false, true}) {
            Rig rig(test, [&](ViewDescription& d) {
                setTechnique(d, "dcaa", 4); // this also chains sceneFetch
                d.technique = technique;
                d.config.technique = d.technique.c_str();
                d.config.generationTier = uint32_t(tier);
                if (tier == AGAA_TIER_MATERIAL_LISTS)
                    d.desc.pNext = nullptr;
                d.desc.flags = (d.desc.flags & ~AGAA_VIEW_VERTEX_PULLING) | (pulls ? AGAA_VIEW_VERTEX_PULLING : 0);
            });
            struct Draws {
                Device& device;
                std::vector<uint32_t> pulling;
                static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
                    auto& self = *static_cast<Draws*>(user);
                    self.pulling.push_back(target->state.vertexPulling);
                    return self.device.draw(*target);
                }
            } draws{rig.device(), {}};
            const Image image = rig.render([&](AgaaFrame& frame) {
                frame.draw = Draws::draw;
                frame.drawUser = &draws;
            });
            test.check(draws.pulling == std::vector<uint32_t>{pulls},
                       what + ": AgaaDrawState::vertexPulling of the target is wrong.");
            if (pulls) {
                expectSame(test, image, expected, 32, what);
                test.check(rig.counters().fragments == fragments, what + ": there are other fragments.");
            }
            expected = image;
            fragments = rig.counters().fragments;
            test.check(fragments > 0, what + ": there are no fragments.");
        }
    }
}

// Tests vertex pulling with each value of AgaaGlConstants, because the vertex shader reads the constants, too.
void testPullingConstants(Test& test) {
    Image expected;
    for (const uint32_t constants : {AGAA_GL_CONSTANTS_BLOCK, AGAA_GL_CONSTANTS_UNIFORMS, AGAA_GL_CONSTANTS_TEXELS})
        for (const uint32_t version : {450u, 330u}) {
            Rig rig(
                test,
                [](ViewDescription& d) {
                    setTechnique(d, "dcaa", 4);
                    d.desc.flags |= AGAA_VIEW_VERTEX_PULLING;
                },
                [=](ContextDescription& d) {
                    d.gl.constants = constants;
                    d.gl.glslVersion = version;
                    d.gl.bindings[AGAA_GL_BINDING_FRAME] = 12; // a unit that no other texture uses
                });
            const Image image = rig.render();
            if (expected.empty())
                expected = image;
            expectSame(test, image, expected, 32,
                       "AGAA_VIEW_VERTEX_PULLING with AgaaGlDeviceDesc::constants = " + std::to_string(constants) +
                           " and GLSL " + std::to_string(version));
        }
}

bool skipsBatches(Test& test, AgaaContext context) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context, &caps), "agaaVkGetContextCaps");
    return caps.flags & AGAA_DEVICE_CONDITIONAL_RENDERING;
}

// The device skips batches if the host enables the feature. The images must not change.
void testConditionalRendering(Test& test) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    Test inner(test.sdk, device.get());
    try {
        VkPhysicalDeviceFeatures2 features =
            *static_cast<const VkPhysicalDeviceFeatures2*>(device->description().vk.enabledFeatures);
        features.pNext = nullptr;
        const auto inBatches =
            withCoverage(AGAA_TIER_AUTO, [](AgaaDecoupledCoverage& c) { c.fragmentsPerPixel = 1, c.maxBatches = 8; });
        Rig all(inner, inBatches, [&](ContextDescription&d) { d.vk.enabledFeatures = &features; }),
            needed(inner, inBatches);
        if (!skipsBatches(inner, needed.context.get()))
            test.skip("the device has no VK_EXT_conditional_rendering.");
        inner.check(
            !skipsBatches(inner, all.context.get()),
            "agaaVkGetContextCaps has the flag CONDITIONAL_RENDERING where the host does not enable the feature.");
        for (const bool isFull : {false, true}) {
            if (isFull)
                all.scene = needed.scene = manyLayers();
            const std::string scene = isFull ? "a scene that needs batches" : "a scene that needs one batch";
            expectSame(inner, needed.render(), all.render(), 32, "AGAA_DEVICE_CONDITIONAL_RENDERING: " + scene);
        }
        needed.expectNoMessages("AGAA_DEVICE_CONDITIONAL_RENDERING");
    } catch (const Aborted&) {
    }
    for (const std::string& failure : inner.failures())
        test.check(false, failure);
}

} // namespace

void addFragmentListCases(Suite& suite) {
    suite.both("AgaaDecoupledCoverage.merge/images", testMerges);
    suite.both("AgaaDecoupledCoverage.maxBatches/draws", testBatches);
    suite.add("AgaaGlDeviceDesc.constants/enum/dcaa", {Backend::OpenGl}, testConstants);
    suite.both("AGAA_VIEW_VERTEX_PULLING/images", testPulling);
    suite.add("AGAA_VIEW_VERTEX_PULLING/constants", {Backend::OpenGl}, testPullingConstants);
    suite.add("AGAA_DEVICE_GEOMETRY_SHADERS/AGAA_ERROR_UNSUPPORTED", {Backend::Vulkan}, testNoGeometryShaders);
    suite.add("AGAA_DEVICE_CONDITIONAL_RENDERING/images", {Backend::Vulkan}, testConditionalRendering);
}

} // namespace agaa::conformance
