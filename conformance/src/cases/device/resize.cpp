// agaaResizeView on both APIs: a failed call changes nothing, and a successful call gives the same view as creation.
#include "cases.h"
#include "creation.h"
#include "frame_rig.h"
#include "host_memory.h"

#include <cstring>
#include <map>

namespace agaa::conformance {

namespace {

constexpr const char* resize = "agaaResizeView";

template <class T> std::string bytesOf(const T& value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

// The draw passes and the depth surface of a view, with handles.
template <class NativePass, class NativeSurface>
std::string viewBytes(Test& test, AgaaView view, const NativePass& initialPass, const NativeSurface& initialSurface) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, nullptr), "agaaGetDrawPasses");
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(count, initial);
    std::vector<NativePass> natives(count, initialPass);
    for (uint32_t i = 0; i < count; ++i)
        passes[i].pNext = &natives[i];
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    std::string bytes;
    for (uint32_t i = 0; i < count; ++i) {
        passes[i].pNext = nullptr;
        bytes += bytesOf(passes[i]) + bytesOf(natives[i]);
    }
    AgaaSurface surface = AGAA_SURFACE_INIT;
    NativeSurface native = initialSurface;
    surface.pNext = &native;
    test.requireOk(test.sdk.agaaGetSurface(view, "depth", &surface), "agaaGetSurface(\"depth\")");
    surface.pNext = nullptr;
    return bytes + bytesOf(surface) + bytesOf(native);
}

std::string viewBytes(Test& test, AgaaView view) {
    const AgaaVkDrawPass vkPass = AGAA_VK_DRAW_PASS_INIT;
    const AgaaVkSurface vkSurface = AGAA_VK_SURFACE_INIT;
    const AgaaGlDrawPass glPass = AGAA_GL_DRAW_PASS_INIT;
    const AgaaGlSurface glSurface = AGAA_GL_SURFACE_INIT;
    return test.device().backend() == Backend::Vulkan ? viewBytes(test, view, vkPass, vkSurface)
                                                      : viewBytes(test, view, glPass, glSurface);
}

struct Size {
    uint32_t width, height;
};

std::string callText(const Size& size) {
    return resize + ("(view, " + std::to_string(size.width)) + ", " + std::to_string(size.height) + ")";
}

void expectRefusals(Test& test, const std::vector<Size>& sizes, AgaaResult expected, const std::string& words) {
    Rig rig(test);
    const Image image = rig.render();
    const std::string before = viewBytes(test, rig.view.get());
    for (const Size& size : sizes) {
        const std::string what = callText(size);
        expectRefused(test, test.sdk.agaaResizeView(rig.view.get(), size.width, size.height), expected, rig.context.log,
                      resize, what, words);
        test.check(viewBytes(test, rig.view.get()) == before, what + " fails and changes draw passes or surfaces.");
        expectNextFrame(rig, image, what);
    }
}

void testTooLarge(Test& test) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    {
        ScopedContext context(test);
        test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps),
                       "reading the capabilities of the context");
    }
    const uint32_t most = caps.maxImageSize;
    expectRefusals(test, {{most + 1, 24}, {32, most + 1}, {0xFFFFFFFF, 1}, {1, 0xFFFFFFFF}, {0xFFFFFFFF, 0xFFFFFFFF}},
                   AGAA_ERROR_TOO_LARGE, "");
}

// The surfaces keep their contents: a frame continues after a call that fails between its segments.
void testSegments(Test& test) {
    Rig rig(test);
    const Image image = rig.render();
    for (const uint64_t first : {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION}) {
        AgaaFrame frame = rig.nextFrame();
        rig.device().fillOutput(0.0f);
        frame.segments = first;
        test.requireOk(rig.record(frame), rig.function() + " of the first segments");
        test.result(test.sdk.agaaResizeView(rig.view.get(), 0, 7), AGAA_ERROR_OUT_OF_RANGE, callText({0, 7}));
        frame.segments = AGAA_SEGMENT_ALL & ~first;
        test.requireOk(rig.record(frame), rig.function() + " of the last segments");
        expectSame(test, rig.device().readOutput(), image, rig.description().desc.width,
                   "the frame whose segments a failed agaaResizeView separates");
        rig.context.log.lines.clear();
    }
}

// ---- success ---------------------------------------------------------------------------------------

std::vector<AgaaDrawPass> passesOf(Test& test, AgaaView view) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, nullptr), "agaaGetDrawPasses");
    const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
    std::vector<AgaaDrawPass> passes(count, initial);
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    return passes;
}

// Pipeline keys stay equal, and the targets have the new size.
void expectResizedPasses(Test& test, const std::vector<AgaaDrawPass>& before, const std::vector<AgaaDrawPass>& after,
                         const Size& size, const std::string& what) {
    if (!test.check(after.size() == before.size(), what + " changes the number of draw passes."))
        return;
    for (size_t i = 0; i < after.size(); ++i) {
        const AgaaDrawPass& pass = after[i];
        test.check(pass.pipelineKey == before[i].pipelineKey, what + " changes pipeline keys.");
        test.check(pass.width == size.width * pass.scaleX && pass.height == size.height * pass.scaleY,
                   what + ": the target of draw pass " + std::to_string(i) + " has " + std::to_string(pass.width) +
                       "x" + std::to_string(pass.height) + " texels.");
    }
}

// A resized view shows the same image as a view that was created with the size. The host keeps its pipelines. The size
// is no multiple of a tile.
void testSuccess(Test& test) {
    constexpr Size size = {37, 50};
    const std::vector<std::string> names = techniques(test);
    for (const std::string& name : names) {
        const auto use = [&](ViewDescription& d) {
            setTechnique(d, name, 4);
            d.desc.width = size.width;
            d.desc.height = size.height;
        };
        const auto useSmall = [&](ViewDescription& d) {
            use(d);
            d.desc.width = 8;
            d.desc.height = 40;
        };
        Image expected;
        {
            Rig rig(test, use);
            expected = rig.render();
        }
        Rig rig(test, useSmall);
        rig.render();
        const std::vector<AgaaDrawPass> passes = passesOf(test, rig.view.get());
        test.requireOk(test.sdk.agaaResizeView(rig.view.get(), size.width, size.height), resize);
        rig.expectNoErrors(resize);
        expectResizedPasses(test, passes, passesOf(test, rig.view.get()), size, "\"" + name + "\": agaaResizeView");
        rig.device().setOutput(size.width, size.height);
        ViewDescription description(&rig.device());
        use(description);
        AgaaFrame frame = pixelFrame(rig.device(), description, rig.recorded + 1);
        rig.scene = smallScene(size.width, size.height);
        test.requireOk(rig.record(frame), rig.function() + " after agaaResizeView");
        expectSame(test, rig.device().readOutput(), expected, size.width,
                   "\"" + name + "\": the image after agaaResizeView");
        rig.expectNoMessages("\"" + name + "\": a frame after agaaResizeView");
    }
}

// Frame indices continue, and statistics of earlier frames are lost.
void testStatistics(Test& test) {
    Rig rig(test);
    rig.render();
    rig.render();
    test.requireOk(test.sdk.agaaResizeView(rig.view.get(), 32, 24), resize);
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    test.result(test.sdk.agaaGetFrameStatistics(rig.view.get(), rig.recorded, &statistics), AGAA_NOT_READY,
                "agaaGetFrameStatistics after agaaResizeView");
    AgaaFrame frame = rig.nextFrame();
    frame.frameIndex = 2;
    frame.completedFrame = 1;
    test.result(rig.record(frame), AGAA_ERROR_WRONG_ORDER, "a frame index of before agaaResizeView");
    rig.context.log.lines.clear();
    rig.render();
    test.check(rig.statistics().frameIndex == 3, "statistics after agaaResizeView are of another frame.");
}

// ---- host memory -----------------------------------------------------------------------------------

struct CountedMemory {
    uint32_t failAt = 0; // index of the failing allocation from now on; 0: none
    std::map<void*, size_t> blocks;

    static void* AGAA_CALL allocate(void* user, size_t size, size_t alignment) {
        auto& self = *static_cast<CountedMemory*>(user);
        if (self.failAt && --self.failAt == 0)
            return nullptr;
        void* memory = allocateHostMemory(size, alignment);
        self.blocks[memory] = size;
        return memory;
    }
    static void AGAA_CALL release(void* user, void* memory) {
        static_cast<CountedMemory*>(user)->blocks.erase(memory);
        freeHostMemory(memory);
    }
};

void testHostMemory(Test& test) {
    CountedMemory memory;
    Rig rig(test, {}, [&](ContextDescription& d) {
        d.desc.allocate = CountedMemory::allocate;
        d.desc.free = CountedMemory::release;
        d.desc.allocateUser = &memory;
    });
    const Image image = rig.render();
    const std::string before = viewBytes(test, rig.view.get());
    const auto blocks = memory.blocks;
    for (uint32_t n = 1;; ++n) {
        memory.failAt = n;
        const AgaaResult result = test.sdk.agaaResizeView(rig.view.get(), 48, 40);
        if (memory.failAt) {
            memory.failAt = 0;
            test.result(result, AGAA_OK, std::string(resize) + " after allocations that failed");
            test.check(n > 1, "agaaResizeView makes no allocation by AgaaContextDesc::allocate.");
            test.check(memory.blocks.size() == blocks.size(), "agaaResizeView keeps host memory of the size before.");
            return;
        }
        const std::string what = resize + (", where allocation " + std::to_string(n)) + " of host memory fails";
        expectRefused(test, result, AGAA_ERROR_OUT_OF_MEMORY, rig.context.log, resize, what);
        test.check(memory.blocks == blocks, what + ", keeps or frees host memory.");
        test.check(viewBytes(test, rig.view.get()) == before, what + ", changes draw passes or surfaces.");
        expectNextFrame(rig, image, what);
    }
}

} // namespace

void addResizeCases(Suite& suite) {
    suite.both("agaaResizeView/AGAA_ERROR_OUT_OF_RANGE", [](Test& test) {
        expectRefusals(test, {{0, 24}, {32, 0}, {0, 0}, {0, 0xFFFFFFFF}}, AGAA_ERROR_OUT_OF_RANGE, "");
    });
    suite.both("agaaResizeView/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        test.result(test.sdk.agaaResizeView(nullptr, 32, 24), AGAA_ERROR_INVALID_ARGUMENT,
                    "agaaResizeView with view = null");
    });
    suite.both("agaaResizeView/AGAA_ERROR_TOO_LARGE", testTooLarge);
    suite.both("agaaResizeView/AGAA_ERROR_OUT_OF_MEMORY", testHostMemory);
    suite.both("agaaResizeView/contents_are_kept", testSegments);
    suite.both("agaaResizeView/is_as_created", testSuccess);
    suite.both("agaaResizeView/statistics", testStatistics);
}

} // namespace agaa::conformance
