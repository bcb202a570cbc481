// AgaaResolvedOutputs: values of whole pixels, and images that frames refuse.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "vk_interposer.h"

#include "cases/core/structs.h"

#include <algorithm>
#include <cmath>

namespace agaa::conformance {

namespace {

AgaaResolvedOutputs outputsOf(std::initializer_list<AgaaResolvedValue> values) {
    AgaaResolvedOutputs outputs = AGAA_RESOLVED_OUTPUTS_INIT;
    outputs.count = 0;
    for (const AgaaResolvedValue value : values)
        outputs.outputs[outputs.count++] = {uint32_t(value), 0, nullptr};
    return outputs;
}

// Chains the struct of the graphics API with `change` applied, in place of the host's.
RecordHook changed(const std::function<void(AgaaVkResolvedImages&)>& vk,
                   const std::function<void(AgaaGlResolvedTextures&)>& gl) {
    return [vk, gl](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
        if (static_cast<const AgaaStructHeader*>(native)->sType == AGAA_STRUCTURE_TYPE_VK_FRAME) {
            AgaaVkFrame copy = *static_cast<const AgaaVkFrame*>(native);
            AgaaVkResolvedImages images = *static_cast<const AgaaVkResolvedImages*>(copy.pNext);
            vk(images);
            copy.pNext = &images;
            return call(view, frame, &copy);
        }
        AgaaGlFrame copy = *static_cast<const AgaaGlFrame*>(native);
        AgaaGlResolvedTextures textures = *static_cast<const AgaaGlResolvedTextures*>(copy.pNext);
        gl(textures);
        copy.pNext = &textures;
        return call(view, frame, &copy);
    };
}

RecordHook withoutImages() {
    return [](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
        if (static_cast<const AgaaStructHeader*>(native)->sType == AGAA_STRUCTURE_TYPE_VK_FRAME) {
            AgaaVkFrame copy = *static_cast<const AgaaVkFrame*>(native);
            copy.pNext = nullptr;
            return call(view, frame, &copy);
        }
        AgaaGlFrame copy = *static_cast<const AgaaGlFrame*>(native);
        copy.pNext = nullptr;
        return call(view, frame, &copy);
    };
}

// A view of two outputs, and the host's images for them.
struct ResolvedRig : Rig {
    ResolvedRig(Test& rigTest, AgaaResolvedOutputs& outputs, const std::string& technique = "agaa")
        : Rig(rigTest, [&](ViewDescription& d) {
              setTechnique(d, technique, 4);
              outputs.pNext = d.desc.pNext;
              d.desc.pNext = &outputs;
          }) {
        device().setResolvedOutputs(outputs.count);
    }
    ~ResolvedRig() { device().setResolvedOutputs(0); }
};

// The rectangles of smallScene() end at whole pixels, so that a pixel shows one of them or the background.
void testValues(Test& test) {
    for (const std::string& technique : techniques(test)) {
        AgaaResolvedOutputs outputs = outputsOf(
            {AGAA_RESOLVED_NEAREST_DEPTH, AGAA_RESOLVED_MEAN_DEPTH, AGAA_RESOLVED_COVERAGE, AGAA_RESOLVED_NORMAL});
        ResolvedRig rig(test, outputs, technique);
        const Image image = rig.render();
        std::vector<Image> values;
        for (uint32_t i = 0; i < outputs.count; ++i)
            values.push_back(rig.device().readResolvedOutput(i));
        size_t shown = 0, background = 0;
        for (size_t i = 0; i < image.size(); i += 4) {
            const float nearest = values[0][i], mean = values[1][i], coverage = values[2][i];
            const bool isShown = coverage == 1;
            shown += isShown;
            background += !isShown;
            const std::string what = "pixel " + std::to_string(i / 4) + " of \"" + technique + "\"";
            test.check(coverage == 0 || coverage == 1, what + ": the coverage is neither 0 nor 1.");
            test.check(std::abs(nearest - mean) < 1e-6f, what + ": the depths of one plane differ.");
            test.check(isShown ? nearest > 0 && nearest < 1 : nearest == 1, what + ": the depth is not that shown.");
            const float length = std::hypot(values[3][i], values[3][i + 1], values[3][i + 2]);
            test.check(std::abs(length - (isShown ? 1.0f : 0.0f)) < 2e-3f,
                       what + ": the length of the normal is " + std::to_string(length) + ".");
        }
        test.check(shown > 0, "\"" + technique + "\" shows no geometry.");
        test.check(background > 0 || shown == image.size() / 4, "pixels are lost.");
        rig.expectNoMessages("resolved outputs of \"" + technique + "\"");
    }
}

struct Refused {
    AgaaResult code;
    const char* what;
    const char* words;
    RecordHook hook;
};

void testRefused(Test& test, const std::vector<Refused>& rows) {
    AgaaResolvedOutputs outputs = outputsOf({AGAA_RESOLVED_NEAREST_DEPTH, AGAA_RESOLVED_COVERAGE});
    ResolvedRig rig(test, outputs);
    const Image expected = rig.render();
    for (const Refused& row : rows) {
        AgaaFrame frame = rig.nextFrame();
        expectFrameRefused(rig, frame, {row.code, rig.function() + " with " + row.what, row.words}, expected, row.hook);
    }
}

void testInvalid(Test& test) {
    testRefused(test, {{AGAA_ERROR_INVALID_ARGUMENT, "no images for outputs", "AgaaResolvedOutputs", withoutImages()},
                       {AGAA_ERROR_INVALID_ARGUMENT, "an output without image", "",
                        changed([](AgaaVkResolvedImages& x) { x.images[1] = 0; },
                                [](AgaaGlResolvedTextures& x) { x.textures[1] = 0; })},
                       {AGAA_ERROR_INVALID_ARGUMENT, "an image twice", "twice",
                        changed([](AgaaVkResolvedImages& x) { x.images[1] = x.images[0]; },
                                [](AgaaGlResolvedTextures& x) { x.textures[1] = x.textures[0]; })}});
}

void testLayouts(Test& test) {
    const auto noTextures = [](AgaaGlResolvedTextures&) {};
    testRefused(test, {{AGAA_ERROR_OUT_OF_RANGE, "layoutsOut = UNDEFINED", "layoutsOut",
                        changed([](AgaaVkResolvedImages& x) { x.layoutsOut[1] = 0; }, noTextures)},
                       {AGAA_ERROR_OUT_OF_RANGE, "layoutsOut = PREINITIALIZED", "layoutsOut",
                        changed([](AgaaVkResolvedImages& x) { x.layoutsOut[0] = 8; }, noTextures)}});
}

// Sizes that the host says its images have are checked.
void testTold(Test& test) {
    const auto noTextures = [](AgaaGlResolvedTextures&) {};
    const auto sized = [&](uint32_t width, uint32_t height) {
        return changed(
            [=](AgaaVkResolvedImages& x) {
                x.width = width;
                x.height = height;
            },
            noTextures);
    };
    testRefused(test, {{AGAA_ERROR_OUT_OF_RANGE, "images of width 1", "width", sized(1, 0)},
                       {AGAA_ERROR_OUT_OF_RANGE, "images of height 1", "height", sized(0, 1)}});
}

void testFormats(Test& test) {
    constexpr uint32_t rgba8Uint = 41, d32 = 126, bc1 = 131; // of VkFormat
    std::vector<Refused> rows;
    for (const uint32_t texels : {rgba8Uint, d32, bc1, 0x7FFFFFFFu})
        rows.push_back(
            {AGAA_ERROR_UNSUPPORTED, "a format of no floats", "formats[1]",
             changed([=](AgaaVkResolvedImages& x) { x.formats[1] = texels; }, [](AgaaGlResolvedTextures&) {})});
    testRefused(test, rows);
}

// A device that lets a shader have few images refuses the view.
void testFewImages(Test& test) {
    VulkanInterposer vulkan;
    vulkan.changeProperties = [](VkPhysicalDeviceProperties& p) { p.limits.maxPerStageDescriptorStorageImages = 2; };
    AgaaResolvedOutputs outputs =
        outputsOf({AGAA_RESOLVED_NEAREST_DEPTH, AGAA_RESOLVED_COVERAGE, AGAA_RESOLVED_MEAN_DEPTH});
    ScopedContext context(test, [](ContextDescription& d) { d.vk.getProcAddr = VulkanInterposer::getProcAddr; });
    for (const uint32_t count : {2u, 3u}) {
        outputs.count = count;
        ViewDescription d(&test.device());
        outputs.pNext = d.desc.pNext;
        d.desc.pNext = &outputs;
        AgaaView view = nullptr;
        const AgaaResult result = test.device().createView(test.sdk, context.get(), &d.desc, &view);
        if (count == 2)
            test.requireOk(result, "agaaVkCreateView with two outputs");
        else
            test.check(result == AGAA_ERROR_UNSUPPORTED, "three outputs on a device of two images are accepted.");
        test.sdk.agaaDestroyView(view);
    }
}

void testReserved(Test& test) {
    if (!isSameVersion(test))
        test.skip("a later library may give the member a meaning.");
    testRefused(test, {{AGAA_ERROR_OUT_OF_RANGE, "AgaaGlResolvedTextures::reserved = 1", "reserved",
                        changed([](AgaaVkResolvedImages&) {}, [](AgaaGlResolvedTextures& x) { x.reserved[1] = 1; })}});
}

} // namespace

void addResolvedOutputCases(Suite& suite) {
    const std::vector<Backend> vk = {Backend::Vulkan}, gl = {Backend::OpenGl},
                               both = {Backend::Vulkan, Backend::OpenGl};
    suite.add("general/resolved_outputs_of_whole_pixels", both, testValues);
    addRecordCase(suite, "AGAA_ERROR_INVALID_ARGUMENT/resolved_outputs", testInvalid);
    suite.add("AgaaVkResolvedImages.layoutsOut/AGAA_ERROR_OUT_OF_RANGE", vk, testLayouts);
    suite.add("AgaaVkResolvedImages/AGAA_ERROR_OUT_OF_RANGE", vk, testTold);
    suite.add("AgaaVkResolvedImages/AGAA_ERROR_UNSUPPORTED", vk, testFormats);
    suite.add("AgaaResolvedOutputs/AGAA_ERROR_UNSUPPORTED", vk, testFewImages);
    suite.add("AgaaGlResolvedTextures.reserved/zero", gl, testReserved);
}

} // namespace agaa::conformance
