// The headers of the structs that functions with a view take.
#include "cases.h"
#include "cases/core/header_check.h"
#include "frame_rig.h"

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

namespace {

constexpr size_t headerBytes = sizeof(AgaaStructHeader);

template <class T> T& as(void* structure) { return *static_cast<T*>(structure); }

template <class T> void copyMembers(void* structure, const T& from) {
    std::memcpy(static_cast<char*>(structure) + headerBytes, reinterpret_cast<const char*>(&from) + headerBytes,
                sizeof from - headerBytes);
}

// A view logs through its context. The messages of a call are copied to the log of the case.
template <class Call> AgaaResult logged(Rig& rig, const AgaaLog* log, const Call& call) {
    rig.context.log.lines.clear();
    const AgaaResult result = call();
    for (const LogLine& line : rig.context.log.lines)
        log->callback(log->user, line.severity, line.code, line.text.c_str());
    return result;
}

HeaderCase frameCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        AgaaFrame frame = rig.nextFrame();
        return logged(rig, log, [&] {
            return rig.record(frame,
                              [&](const RecordCall& record, AgaaView view, const AgaaFrame* f, const void* native) {
                                  copyMembers(structure, *f);
                                  return record(view, &as<AgaaFrame>(structure), native);
                              });
        });
    };
    return {"AgaaFrame", rig.function(), nullptr, call};
}

HeaderCase temporalFrameCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        AgaaFrame frame = rig.nextFrame();
        frame.pNext = structure;
        return logged(rig, log, [&] { return rig.record(frame); });
    };
    return {"AgaaTemporalFrame", rig.function(), nullptr, call, false, true, true};
}

template <class Native> HeaderCase nativeFrameCase(Rig& rig, const char* name) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        AgaaFrame frame = rig.nextFrame();
        return logged(rig, log, [&] {
            return rig.record(frame,
                              [&](const RecordCall& record, AgaaView view, const AgaaFrame* f, const void* native) {
                                  copyMembers(structure, *static_cast<const Native*>(native));
                                  return record(view, f, structure);
                              });
        });
    };
    return {name,    rig.function(),
            nullptr, call,
            false,   true,
            false,   rig.device().backend() == Backend::Vulkan ? "AgaaVkResolvedImages" : "AgaaGlResolvedTextures"};
}

// The struct is chained to the frame in place of the host's.
template <class NativeFrame, class Images> HeaderCase resolvedCase(Rig& rig, const char* name) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        AgaaFrame frame = rig.nextFrame();
        return logged(rig, log, [&] {
            return rig.record(frame,
                              [&](const RecordCall& record, AgaaView view, const AgaaFrame* f, const void* native) {
                                  NativeFrame copy = *static_cast<const NativeFrame*>(native);
                                  copyMembers(structure, *static_cast<const Images*>(copy.pNext));
                                  copy.pNext = structure;
                                  return record(view, f, &copy);
                              });
        });
    };
    return {name, rig.function(), nullptr, call, false, true, true};
}

template <class NativeFrame, class Images> void testResolvedHeader(Test& test, const char* name) {
    AgaaResolvedOutputs outputs = AGAA_RESOLVED_OUTPUTS_INIT;
    Rig rig(test, [&](ViewDescription& d) {
        setTechnique(d, "single", 4);
        outputs.pNext = d.desc.pNext;
        d.desc.pNext = &outputs;
    });
    rig.device().setResolvedOutputs(outputs.count);
    const Image expected = rig.render();
    testHeader(test, resolvedCase<NativeFrame, Images>(rig, name));
    expectNextFrame(rig, expected, "calls with wrong headers");
    rig.device().setResolvedOutputs(0);
}

// All elements get the bytes of the case's struct. The bytes of the first element are returned.
AgaaResult getPasses(Rig& rig, void* structure) {
    uint32_t count = 0;
    rig.test.requireOk(rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, nullptr), "agaaGetDrawPasses");
    const size_t stride = std::max<size_t>(as<AgaaStructHeader>(structure).structSize, 8);
    const size_t bytes = sizeof(AgaaDrawPass) + spareBytes;
    Bytes array((count - 1) * stride + bytes);
    for (uint32_t i = 0; i < count; ++i)
        std::memcpy(array.data() + i * stride, structure, i + 1 < count ? stride : bytes);
    const AgaaResult result =
        rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, reinterpret_cast<AgaaDrawPass*>(array.data()));
    std::memcpy(structure, array.data(), stride);
    return result;
}

HeaderCase passCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log, [&] { return getPasses(rig, structure); });
    };
    return {"AgaaDrawPass", "agaaGetDrawPasses", nullptr, call, true};
}

// The struct is chained to the last pass.
HeaderCase nativePassCase(Rig& rig, const char* name) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        uint32_t count = 0;
        rig.test.requireOk(rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, nullptr), "agaaGetDrawPasses");
        const AgaaDrawPass initial = AGAA_DRAW_PASS_INIT;
        std::vector<AgaaDrawPass> passes(count, initial);
        passes.back().pNext = structure;
        return logged(rig, log, [&] { return rig.test.sdk.agaaGetDrawPasses(rig.view.get(), &count, passes.data()); });
    };
    return {name, "agaaGetDrawPasses", nullptr, call, true, true, true};
}

HeaderCase surfaceCase(Rig& rig, const char* nativeName) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log, [&] {
            return rig.test.sdk.agaaGetSurface(rig.view.get(), "depth", &as<AgaaSurface>(structure));
        });
    };
    return {"AgaaSurface", "agaaGetSurface", nullptr, call, true, true, false, nativeName};
}

HeaderCase nativeSurfaceCase(Rig& rig, const char* name) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        AgaaSurface surface = AGAA_SURFACE_INIT;
        surface.pNext = structure;
        return logged(rig, log, [&] { return rig.test.sdk.agaaGetSurface(rig.view.get(), "depth", &surface); });
    };
    return {name, "agaaGetSurface", nullptr, call, true, true, true};
}

HeaderCase statisticsCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log, [&] {
            return rig.test.sdk.agaaGetFrameStatistics(rig.view.get(), rig.recorded,
                                                       &as<AgaaFrameStatistics>(structure));
        });
    };
    return {"AgaaFrameStatistics", "agaaGetFrameStatistics", nullptr, call, true};
}

HeaderCase validationCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log, [&] {
            return rig.test.sdk.agaaValidateFrame(rig.view.get(), rig.recorded, &as<AgaaFrameValidation>(structure));
        });
    };
    return {"AgaaFrameValidation", "agaaValidateFrame", nullptr, call, true};
}

HeaderCase factsCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log, [&] {
            return rig.test.sdk.agaaGetFactReport(rig.view.get(), rig.recorded, &as<AgaaFactReport>(structure));
        });
    };
    return {"AgaaFactReport", "agaaGetFactReport", nullptr, call, true};
}

HeaderCase crumbsCase(Rig& rig) {
    const auto call = [&rig](Test&, void* structure, const AgaaLog* log) {
        return logged(rig, log,
                      [&] { return rig.test.sdk.agaaGetBreadcrumbs(rig.view.get(), &as<AgaaBreadcrumbs>(structure)); });
    };
    return {"AgaaBreadcrumbs", "agaaGetBreadcrumbs", nullptr, call, true};
}

// "single" has the fewest pipelines.
void add(Suite& suite, const char* name, const std::vector<Backend>& backends,
         const std::function<HeaderCase(Rig&)>& makeCase, const char* technique = "single") {
    suite.add(std::string(name), backends, [makeCase, technique](Test& test) {
        Rig rig(test, [technique](ViewDescription& d) {
            setTechnique(d, technique, 4);
            d.config.flags |= AGAA_CONFIG_CHECK_FACTS | AGAA_CONFIG_BREADCRUMBS;
        });
        const Image expected = rig.render();
        testHeader(test, makeCase(rig));
        expectNextFrame(rig, expected, "calls with wrong headers");
    });
}

} // namespace

void addFrameHeaderCases(Suite& suite) {
    const std::vector<Backend> vk = {Backend::Vulkan}, gl = {Backend::OpenGl},
                               both = {Backend::Vulkan, Backend::OpenGl};
    add(suite, "AgaaFrame/header", both, frameCase);
    add(suite, "AgaaTemporalFrame/header", both, temporalFrameCase, "taa");
    add(suite, "AgaaDrawPass/header", both, passCase, "agaa"); // it has multiple draw passes
    add(suite, "AgaaFrameStatistics/header", both, statisticsCase);
    add(suite, "AgaaFrameValidation/header", both, validationCase);
    add(suite, "AgaaFactReport/header", both, factsCase);
    add(suite, "AgaaBreadcrumbs/header", both, crumbsCase);
    add(suite, "AgaaVkFrame/header", vk, [](Rig& rig) { return nativeFrameCase<AgaaVkFrame>(rig, "AgaaVkFrame"); });
    add(suite, "AgaaGlFrame/header", gl, [](Rig& rig) { return nativeFrameCase<AgaaGlFrame>(rig, "AgaaGlFrame"); });
    add(
        suite, "AgaaVkDrawPass/header", vk, [](Rig& rig) { return nativePassCase(rig, "AgaaVkDrawPass"); }, "agaa");
    add(
        suite, "AgaaGlDrawPass/header", gl, [](Rig& rig) { return nativePassCase(rig, "AgaaGlDrawPass"); }, "agaa");
    suite.add("AgaaVkResolvedImages/header", vk,
              [](Test& test) { testResolvedHeader<AgaaVkFrame, AgaaVkResolvedImages>(test, "AgaaVkResolvedImages"); });
    suite.add("AgaaGlResolvedTextures/header", gl, [](Test& test) {
        testResolvedHeader<AgaaGlFrame, AgaaGlResolvedTextures>(test, "AgaaGlResolvedTextures");
    });
    add(suite, "AgaaVkSurface/header", vk, [](Rig& rig) { return nativeSurfaceCase(rig, "AgaaVkSurface"); });
    add(suite, "AgaaGlSurface/header", gl, [](Rig& rig) { return nativeSurfaceCase(rig, "AgaaGlSurface"); });
    add(suite, "AgaaSurface/header/agaaGetSurface", both, [](Rig& rig) {
        return surfaceCase(rig, rig.device().backend() == Backend::Vulkan ? "AgaaVkSurface" : "AgaaGlSurface");
    });
}

} // namespace agaa::conformance
