// The targets that draw callbacks receive.
#include "cases.h"
#include "frame_rig.h"

#include <cmath>
#include <cstring>
#include <map>

namespace agaa::conformance {

namespace {

struct Call {
    std::string technique;
    AgaaDrawTarget target;
    std::vector<AgaaDrawPass> passes; // passes of the view, without their texts
    uint32_t width, height;
    std::vector<AgaaViewport> viewports;
};

struct Recorder {
    Device& device;
    std::vector<AgaaDrawTarget> targets;
    std::vector<std::vector<AgaaViewport>> viewports;
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<Recorder*>(user);
        self.targets.push_back(*target);
        self.viewports.emplace_back(target->viewports, target->viewports + target->viewportCount);
        return self.device.draw(*target);
    }
};

std::vector<Call> recordCalls(Test& test) {
    std::vector<Call> calls;
    for (const std::string& technique : techniques(test)) {
        Rig rig(test, [&](ViewDescription& description) { setTechnique(description, technique, 4); });
        Recorder recorder{rig.device(), {}, {}};
        rig.render([&](AgaaFrame& frame) {
            frame.draw = Recorder::draw;
            frame.drawUser = &recorder;
        });
        uint32_t count = 0;
        test.requireOk(test.sdk.agaaGetDrawPasses(rig.view.get(), &count, nullptr), "agaaGetDrawPasses");
        const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
        std::vector<AgaaDrawPass> passes(count, initial);
        test.requireOk(test.sdk.agaaGetDrawPasses(rig.view.get(), &count, passes.data()), "agaaGetDrawPasses");
        test.check(recorder.targets.size() == count, std::to_string(recorder.targets.size()) + " draw callbacks of \"" +
                                                         technique + "\" where there are " + std::to_string(count) +
                                                         " draw passes.");
        for (size_t i = 0; i < recorder.targets.size(); ++i)
            calls.push_back({technique, recorder.targets[i], passes, rig.description().desc.width,
                             rig.description().desc.height, recorder.viewports[i]});
    }
    return calls;
}

// Calls check() for each draw call of each technique. The calls are recorded once for all tests of a device.
void forCalls(Test& test, const std::function<void(const Call&, const std::string& what)>& check) {
    static std::map<Backend, std::vector<Call>> recorded;
    std::vector<Call>& calls = recorded[test.device().backend()];
    if (calls.empty())
        calls = recordCalls(test);
    for (const Call& call : calls)
        check(call, "the draw callback of pass " + std::to_string(call.target.pass) + " of \"" + call.technique + "\"");
}

const AgaaDrawPass* passOf(const Call& call) {
    for (const AgaaDrawPass& pass : call.passes)
        if (pass.pipelineKey == call.target.pipelineKey)
            return &pass;
    return nullptr;
}

void testPass(Test& test) {
    forCalls(test, [&](const Call& call, const std::string& what) {
        const AgaaDrawPass* pass = passOf(call);
        if (!test.check(pass, what + " receives a pipelineKey that agaaGetDrawPasses does not list."))
            return;
        test.check(call.target.pass == pass->pass, what + " receives the AgaaDrawPassId of another pass.");
        test.check(call.target.batch == 0, what + " receives a batch other than 0 in a pass that is drawn once.");
        test.check(!std::memcmp(&call.target.state, &pass->state, sizeof pass->state),
                   what + " receives another AgaaDrawState than AgaaDrawPass has.");
    });
}

void testSize(Test& test, bool isWidth) {
    forCalls(test, [&](const Call& call, const std::string& what) {
        const AgaaDrawTarget& t = call.target;
        const uint32_t got = isWidth ? t.width : t.height, scale = isWidth ? t.scaleX : t.scaleY;
        const uint32_t pixels = isWidth ? call.width : call.height;
        test.check(got == pixels * scale, what + " receives the " + (isWidth ? "width " : "height ") +
                                              std::to_string(got) + " for " + std::to_string(pixels) + " pixels of " +
                                              std::to_string(scale) + " texels.");
        const AgaaDrawPass* pass = passOf(call);
        test.check(pass && got == (isWidth ? pass->width : pass->height),
                   what + " receives another size than AgaaDrawPass has.");
    });
}

bool isWhole(const AgaaViewport& v, const AgaaDrawTarget& target) {
    return v.x == 0 && v.y == 0 && v.width == float(target.width) && v.height == float(target.height) &&
           v.scissorX == 0 && v.scissorY == 0 && v.scissorWidth == target.width && v.scissorHeight == target.height;
}

void testViewport(Test& test) {
    forCalls(test, [&](const Call& call, const std::string& what) {
        test.check(call.viewports.size() == 1, what + " receives several viewports.");
        test.check(isWhole(call.viewports.front(), call.target), what + " receives a viewport of another size.");
        test.check(call.target.reserved == 0, what + ": AgaaDrawTarget::reserved is not 0.");
    });
}

// A device with 4 samples makes 8, 16 and 32 of them in 2, 4 and 8 layers. A viewport leaves its layer by less than a
// pixel, and its scissor does not.
void testLayers(Test& test) {
    uint32_t tested = 0;
    for (const uint32_t samples : {2u, 4u, 8u, 16u, 32u}) {
        ScopedContext context(test);
        AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
        test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "the capabilities of the context");
        ViewDescription d(&test.device());
        setTechnique(d, "agaa", samples);
        d.config.visibilityTier = AGAA_TIER_LAYERS;
        AgaaTarget target = AGAA_TARGET_INIT;
        if (test.sdk.agaaQueryTarget(&d.desc, &caps, nullptr, &target) != AGAA_OK)
            continue;
        ++tested;
        Rig rig(test, [&](ViewDescription& description) {
            setTechnique(description, "agaa", samples);
            description.config.visibilityTier = AGAA_TIER_LAYERS;
        });
        Recorder recorder{rig.device(), {}, {}};
        rig.render([&](AgaaFrame& frame) {
            frame.draw = Recorder::draw;
            frame.drawUser = &recorder;
        });
        const std::string what = "a draw callback with " + std::to_string(samples) + " samples in layers";
        const uint32_t height = rig.description().desc.height;
        for (size_t i = 0; i < recorder.targets.size(); ++i) {
            const std::vector<AgaaViewport>& list = recorder.viewports[i];
            test.check(list.size() == target.layers && target.layers * target.samples == samples,
                       what + " receives " + std::to_string(list.size()) + " viewports.");
            test.check(recorder.targets[i].height == height * target.layers && target.scaleX == 1 && target.scaleY == 1,
                       what + " receives a target of another height than that of the layers.");
            for (size_t layer = 0; layer < list.size(); ++layer) {
                const AgaaViewport& v = list[layer];
                test.check(v.scissorX == 0 && v.scissorY == layer * height && v.scissorHeight == height &&
                               v.scissorWidth == recorder.targets[i].width,
                           what + " receives a scissor that is not its layer.");
                test.check(std::fabs(v.x) < 1 && std::fabs(v.y - float(v.scissorY)) < 1 &&
                               v.width == float(v.scissorWidth) && v.height == float(height),
                           what + " receives a viewport that leaves its layer by a pixel.");
            }
        }
        const AgaaCounters counters = rig.counters();
        test.check(counters.visible > 0 && counters.once == counters.visible, what + ": samples are not written once.");
        test.check(counters.misplaced == 0, what + ": fragments are misplaced.");
        rig.expectNoMessages(what);
    }
    if (!tested)
        test.skip("the device has no samples that layers multiply.");
}

void testHeaderOf(Test& test) {
    const bool isVk = test.device().backend() == Backend::Vulkan;
    forCalls(test, [&](const Call& call, const std::string& what) {
        const AgaaDrawTarget& t = call.target;
        test.check(t.sType == AGAA_STRUCTURE_TYPE_DRAW_TARGET, what + " receives another sType.");
        const bool isKnown = isSameVersion(test) ? t.structSize == sizeof t : t.structSize >= sizeof t;
        test.check(isKnown, what + " receives the structSize " + std::to_string(t.structSize) + ".");
        test.check(t.pNext == nullptr, what + " receives a chain.");
        test.check((t.commandBuffer != nullptr) == isVk && (t.descriptorSet != 0) == isVk,
                   what + " receives a command buffer or a descriptor set where it must not, or none.");
        test.check((t.framebuffer != 0) == !isVk, what + " receives a framebuffer where it must not, or none.");
        test.check(t.constants == nullptr && t.constantCount == 0, what + " receives constants.");
    });
}

} // namespace

void addDrawTargetCases(Suite& suite) {
    suite.both("AgaaDrawTarget.pass/enum", testPass);
    suite.both("AgaaDrawTarget.width/range", [](Test& test) { testSize(test, true); });
    suite.both("AgaaDrawTarget.height/range", [](Test& test) { testSize(test, false); });
    suite.both("AgaaDrawTarget.viewportCount/range", testViewport);
    suite.both("AgaaDrawTarget.reserved/zero", testViewport);
    suite.both("AGAA_TIER_LAYERS/viewports", testLayers);
    suite.both("AgaaDrawTarget/header", testHeaderOf);
}

} // namespace agaa::conformance
