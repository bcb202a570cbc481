// agaaGetDrawPasses and its descriptions.
#include "cases.h"
#include "pass_list.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace agaa::conformance {

namespace {

const AgaaDrawPass initialPass = AGAA_DRAW_PASS_INIT;

void testCount(Test& test) {
    Rig rig(test);
    uint32_t count = 77;
    test.requireOk(test.sdk.agaaGetDrawPasses(rig.view.get(), &count, nullptr), "agaaGetDrawPasses with passes = null");
    rig.render();
    test.check(count == rig.statistics().geometryPasses, std::to_string(count) +
                                                             " draw passes, where the statistics have " +
                                                             std::to_string(rig.statistics().geometryPasses) + ".");
    std::vector<AgaaDrawPass> passes(count + 3, initialPass);
    uint32_t length = count + 3;
    test.requireOk(test.sdk.agaaGetDrawPasses(rig.view.get(), &length, passes.data()),
                   "agaaGetDrawPasses with a longer array than needed");
    test.check(length == count,
               "agaaGetDrawPasses with a longer array returns " + std::to_string(length) + " in count.");
    for (uint32_t i = count; i < passes.size(); ++i)
        test.check(!std::memcmp(&passes[i], &initialPass, sizeof initialPass),
                   "agaaGetDrawPasses writes beyond the number of passes.");
}

void testStates(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        for (const AgaaDrawPass& pass : list.passes) {
            const AgaaDrawState& state = pass.state;
            const std::string what = passText(technique, pass);
            test.check(state.depthCompare <= AGAA_COMPARE_ALWAYS, what + " has an unknown depthCompare.");
            // The first pass finds the nearest fragment. The depth of the view grows with the distance from the eye.
            if (pass.pass == AGAA_DRAW_PASS_FRAGMENTS) // the lists keep all fragments
                test.check(state.depthCompare == AGAA_COMPARE_ALWAYS, what + " has another depthCompare than ALWAYS.");
            else if (&pass == &list.passes.front())
                test.check(state.depthCompare == AGAA_COMPARE_LESS, what + " has another depthCompare than LESS.");
            else
                test.check(state.depthCompare != AGAA_COMPARE_GREATER, what + " has the depthCompare GREATER.");
        }
    });
}

void testReversed(Test& test) {
    const ScopedContext context(test);
    ViewDescription description(&test.device());
    description.desc.flags |= AGAA_VIEW_REVERSED_Z;
    visitView(test, context, description, [&](const ViewDescription&, const PassList& list, const std::string&) {
        test.check(list.passes.front().state.depthCompare == AGAA_COMPARE_GREATER,
                   "the first draw pass of a view with AGAA_VIEW_REVERSED_Z has another "
                   "depthCompare than GREATER.");
    });
}

void testStateRanges(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        for (const AgaaDrawPass& pass : list.passes) {
            const AgaaDrawState& s = pass.state;
            const std::string what = passText(technique, pass);
            test.check(s.colorWriteMask <= 15,
                       what + " has the colorWriteMask " + std::to_string(s.colorWriteMask) + ".");
            test.check(!s.colorAttachmentCount || s.colorWriteMask, what + " has attachments and writes none.");
            test.check(s.colorAttachmentCount <= 8, what + " has more than 8 attachments.");
            for (const uint32_t flag :
                 {s.depthWrite, s.stencilTest, s.stencilTestMasked, s.sampleShading, s.keepFirst, s.conservative,
                  s.vertexPulling, s.readsAttachments, s.additive, s.sampleLocations})
                test.check(flag <= 1, what + " has a flag that is neither 0 nor 1.");
            test.check(s.samples && !(s.samples & (s.samples - 1)),
                       what + " has a number of samples that is no power of 2.");
            test.check(!s.additive || (s.colorAttachmentCount && !s.keepFirst),
                       what + " blends additively without attachments, or with keepFirst.");
            test.check(s.colorSamples < s.samples && !(s.colorSamples & (s.colorSamples - 1)),
                       what + " has colorSamples " + std::to_string(s.colorSamples) + " of " +
                           std::to_string(s.samples) + " samples.");
            test.check(s.multicast == 0, what + " has layers, which its tier has not.");
            test.check(!s.colorSamples || (s.colorAttachmentCount && !s.sampleShading),
                       what + " has colorSamples without attachments, or with sample shading.");
        }
    });
}

void testReserved(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        for (const AgaaVkDrawPass& pass : list.vk)
            test.check(pass.reserved == 0, "AgaaVkDrawPass::reserved of " + technique + " is not 0.");
    });
}

void testIds(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        test.check(!list.passes.empty(), technique + " has no draw pass.");
        std::set<uint64_t> keys;
        for (const AgaaDrawPass& pass : list.passes) {
            const std::string what = passText(technique, pass);
            test.check(pass.pass >= AGAA_DRAW_PASS_VISIBILITY && pass.pass <= AGAA_DRAW_PASS_FRAGMENTS,
                       what + " has an unknown pass.");
            test.check(pass.name && pass.glslExtensions && pass.glslDeclarations, what + " lacks a name or a text.");
            const bool expands = pass.pass == AGAA_DRAW_PASS_FRAGMENTS, pulls = pass.state.vertexPulling;
            test.check((pass.glslGeometry != nullptr) == (expands && !pulls),
                       what + (pass.glslGeometry ? " has" : " lacks") + " a text for a geometry shader.");
            test.check((pass.glslVertex != nullptr) == pulls,
                       what + (pass.glslVertex ? " has" : " lacks") + " a text for a vertex shader.");
            test.check(expands || !pulls, what + " expands triangles, and is not of fragments.");
            test.check(keys.insert(pass.pipelineKey).second, what + " has the pipelineKey of another pass.");
        }
    });
}

void testStages(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        uint32_t last = AGAA_STAGE_PREPASS;
        for (const AgaaDrawPass& pass : list.passes) {
            test.check(pass.stage <= AGAA_STAGE_OTHER, passText(technique, pass) + " has an unknown stage.");
            test.check(pass.stage >= last, passText(technique, pass) + " has an earlier stage than the pass before.");
            last = pass.stage;
        }
    });
}

// Tests depth and colour of the pass. The pass FRAGMENTS has neither, and one sample per pixel for every n.
bool hasAttachments(const AgaaDrawPass& pass) { return pass.pass != AGAA_DRAW_PASS_FRAGMENTS; }

// Tests the target: the size is pixels times the scale, and the texels of a pixel have n samples.
void testTargets(Test& test) {
    forTechniques(test, [&](const ViewDescription& description, const PassList& list, const std::string& technique) {
        const AgaaViewDesc& desc = description.desc;
        for (const AgaaDrawPass& pass : list.passes) {
            const std::string what = passText(technique, pass);
            test.check(pass.width == desc.width * pass.scaleX && pass.height == desc.height * pass.scaleY,
                       what + " has another size than the pixels times the scale.");
            const uint32_t promised = hasAttachments(pass) ? desc.config->samples : 1;
            test.check(pass.scaleX * pass.scaleY * pass.state.samples == promised,
                       what + " has another number of samples per pixel than the view.");
        }
    });
}

// Equal views have equal keys. Settings that change shaders change keys.
void testKeys(Test& test) {
    const ScopedContext context(test);
    const auto keysOf = [&](const char* technique) {
        ViewDescription description(&test.device());
        setTechnique(description, technique, 4);
        std::vector<uint64_t> keys;
        visitView(test, context, description, [&](const ViewDescription&, const PassList& list, const std::string&) {
            for (const AgaaDrawPass& pass : list.passes)
                keys.push_back(pass.pipelineKey);
        });
        return keys;
    };
    const auto first = keysOf("agaa"), second = keysOf("agaa"), others = keysOf("msaa");
    if (unsupportedReason(test, "dcaa").empty())
        for (const uint64_t key : keysOf("dcaa"))
            test.check(std::find(first.begin(), first.end(), key) == first.end(),
                       "\"agaa\" and \"dcaa\" have a pipelineKey in common.");
    test.check(first == second, "two equal views have different pipelineKeys.");
    for (const uint64_t key : others)
        test.check(std::find(first.begin(), first.end(), key) == first.end(),
                   "\"agaa\" and \"msaa\" have a pipelineKey in common.");
}

void testVkNative(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        for (size_t i = 0; i < list.passes.size(); ++i) {
            const std::string what = passText(technique, list.passes[i]);
            for (uint32_t k = 0; k < list.passes[i].state.colorAttachmentCount; ++k)
                test.check(list.vk[i].colorFormats[k] != 0, what + " has an attachment without a format.");
            test.check(list.vk[i].descriptorSetLayout != 0, what + " has no descriptorSetLayout.");
            test.check((list.vk[i].depthStencilFormat != 0) == hasAttachments(list.passes[i]),
                       what + " has a depthStencilFormat without depth, or none.");
        }
    });
}

void testGlNative(Test& test) {
    forTechniques(test, [&](const ViewDescription&, const PassList& list, const std::string& technique) {
        for (size_t i = 0; i < list.passes.size(); ++i) {
            const std::string what = passText(technique, list.passes[i]);
            for (uint32_t k = 0; k < list.passes[i].state.colorAttachmentCount; ++k)
                test.check(list.gl[i].colorFormats[k] != 0, what + " has an attachment without a format.");
            test.check(list.gl[i].framebuffer != 0, what + " has no framebuffer.");
            test.check((list.gl[i].depthStencilFormat != 0) == hasAttachments(list.passes[i]),
                       what + " has a depthStencilFormat without depth, or none.");
        }
    });
}

} // namespace

void addDrawPassCases(Suite& suite) {
    suite.both("agaaGetDrawPasses/passes.null", testCount);
    suite.both("AgaaDrawState.depthCompare/enum", testStates);
    suite.both("AgaaDrawState.depthCompare/enum/reversed", testReversed);
    suite.both("AgaaDrawState.colorWriteMask/range", testStateRanges);
    suite.add("AgaaVkDrawPass.reserved/zero", {Backend::Vulkan}, testReserved);
    suite.both("AgaaDrawPass.pass/enum", testIds);
    suite.both("AgaaDrawPass.stage/enum", testStages);
    suite.both("general/draw_passes_fit_the_view", testTargets);
    suite.both("general/pipeline_keys_differ_by_shaders", testKeys);
    suite.add("general/vulkan_draw_passes_have_handles", {Backend::Vulkan}, testVkNative);
    suite.add("general/opengl_draw_passes_have_objects", {Backend::OpenGl}, testGlNative);
}

} // namespace agaa::conformance
