// AgaaGlDeviceDesc and agaaGlCreateContext.
#include "cases.h"
#include "creation.h"

#include "cases/core/header_check.h"
#include "cases/core/structs.h"
#include "hosts/gl_device.h"

#include <cstring>

namespace agaa::conformance {

namespace {

AgaaResult AGAA_CALL keepState(void*) { return AGAA_OK; }

} // namespace

std::vector<ContextRow> wrongOpenGlContexts() {
    std::vector<ContextRow> rows;
    const auto add = [&](const std::string& what, AgaaResult expected, const char* words, ChangeContext change) {
        rows.push_back({what, expected, words, std::move(change)});
    };
    constexpr AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT, range = AGAA_ERROR_OUT_OF_RANGE;
    using D = ContextDescription;
    add("AgaaGlDeviceDesc::getProcAddr = null", invalid, "getProcAddr", [](D& d) { d.gl.getProcAddr = nullptr; });
    add("AGAA_GL_STATE_CALLBACKS without popState", invalid, "popState", [](D& d) {
        d.gl.statePolicy = AGAA_GL_STATE_CALLBACKS;
        d.gl.pushState = keepState;
    });
    add("AGAA_GL_STATE_CALLBACKS without pushState", invalid, "pushState", [](D& d) {
        d.gl.statePolicy = AGAA_GL_STATE_CALLBACKS;
        d.gl.popState = keepState;
    });
    const auto equal = [&](const std::string& what, uint32_t a, uint32_t b, uint32_t storage, uint32_t constants) {
        add("equal bindings of " + what, invalid, "bindings", [=](D& d) {
            d.gl.storage = storage;
            d.gl.constants = constants;
            d.gl.bindings[a] = d.gl.bindings[b];
        });
    };
    equal("two texture units", AGAA_GL_BINDING_SHADOW3, AGAA_GL_BINDING_METADATA, 0, 0);
    equal("two storage buffers", AGAA_GL_BINDING_COUNTERS, AGAA_GL_BINDING_AGGREGATES, 0, 0);
    equal("a written and a read storage buffer", AGAA_GL_BINDING_LIGHTS, AGAA_GL_BINDING_FRAGMENTS, 0, 0);
    equal("two image units", AGAA_GL_BINDING_COUNTERS, AGAA_GL_BINDING_AGGREGATES, AGAA_GL_STORAGE_IMAGES, 0);
    equal("two uniform buffers", AGAA_GL_BINDING_LIGHTS, AGAA_GL_BINDING_FRAME, AGAA_GL_STORAGE_IMAGES, 0);
    equal("the texels of the frame and a texture unit", AGAA_GL_BINDING_FRAME, AGAA_GL_BINDING_SHADOW1, 0,
          AGAA_GL_CONSTANTS_TEXELS);
    for (const uint32_t version : {0u, 320u, 331u, 420u + 5, 470u, 0xFFFFFFFFu})
        add("AgaaGlDeviceDesc::glslVersion = " + std::to_string(version), range, "glslVersion",
            [=](D& d) { d.gl.glslVersion = version; });
    for (const uint32_t value : {3u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
        const std::string text = std::to_string(value);
        add("AgaaGlDeviceDesc::storage = " + text, range, "storage", [=](D& d) { d.gl.storage = value; });
        add("AgaaGlDeviceDesc::outputs = " + text, range, "outputs", [=](D& d) { d.gl.outputs = value; });
        add("AgaaGlDeviceDesc::statePolicy = " + text, range, "statePolicy", [=](D& d) { d.gl.statePolicy = value; });
        add("AgaaGlDeviceDesc::constants = " + text, range, "constants", [=](D& d) { d.gl.constants = value; });
    }
    // Storage and outputs accept 0 and 1.
    add("AgaaGlDeviceDesc::storage = 2", range, "storage", [](D& d) { d.gl.storage = 2; });
    add("AgaaGlDeviceDesc::outputs = 2", range, "outputs", [](D& d) { d.gl.outputs = 2; });
    GLint imageUnits = 0;
    glGetIntegerv(GL_MAX_IMAGE_UNITS, &imageUnits);
    add("an image unit beyond GL_MAX_IMAGE_UNITS", range, "AGAA_GL_BINDING_COUNTERS", [=](D& d) {
        d.gl.storage = AGAA_GL_STORAGE_IMAGES;
        d.gl.bindings[AGAA_GL_BINDING_COUNTERS] = uint32_t(imageUnits);
    });
    add("AgaaGlDeviceDesc::bindings[AGAA_GL_BINDING_COUNT] = 9", range, "bindings",
        [](D& d) { d.gl.bindings[AGAA_GL_BINDING_COUNT] = 9; });
    for (uint32_t i = 0; i < AGAA_GL_MAX_BINDINGS; ++i)
        add("AgaaGlDeviceDesc::bindings[" + std::to_string(i) + "] = 0xFFFFFFF0", range, "bindings",
            [=](D& d) { d.gl.bindings[i] = 0xFFFFFFF0; });
    return rows;
}

namespace {

struct Value {
    uint32_t value;
    ChangeContext needs; // other members that the value needs; may be empty
};

// Creates contexts, and views with their shaders, with each value. Other values are refused.
void testMember(Test& test, const std::string& member, const std::vector<Value>& accepted,
                const std::function<void(AgaaGlDeviceDesc&, uint32_t)>& set) {
    for (const Value& v : accepted) {
        const auto change = [&](ContextDescription& d) {
            if (v.needs)
                v.needs(d);
            set(d.gl, v.value);
        };
        const std::string what = "AgaaGlDeviceDesc::" + member + " = " + std::to_string(v.value);
        expectContextAccepted(test, what, change);
        ScopedContext context(test, change);
        ViewDescription description(&test.device());
        AgaaView view = nullptr;
        if (test.result(test.device().createView(test.sdk, context.get(), &description.desc, &view), AGAA_OK,
                        "agaaGlCreateView with " + what))
            test.sdk.agaaDestroyView(view);
    }
    for (const ContextRow& row : wrongOpenGlContexts())
        if (row.words == member)
            expectContextRefused(test, row);
}

void useCallbacks(ContextDescription& d) {
    d.gl.pushState = keepState;
    d.gl.popState = keepState;
}
void useSeparateUnit(ContextDescription& d) { d.gl.bindings[AGAA_GL_BINDING_FRAME] = 12; }

// "msaa" needs a block. All other techniques accept each value of AgaaGlConstants.
void testConstants(Test& test) {
    for (const uint32_t constants : {AGAA_GL_CONSTANTS_BLOCK, AGAA_GL_CONSTANTS_UNIFORMS, AGAA_GL_CONSTANTS_TEXELS}) {
        ScopedContext context(test, [&](ContextDescription& d) {
            useSeparateUnit(d);
            d.gl.constants = constants;
        });
        for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                      "sbaa", "agaa", "dcaa", "sgbc", "adaptive"}) {
            const std::string what = "agaaGlCreateView of \"" + std::string(technique) +
                                     "\" with AgaaGlDeviceDesc::constants = " + std::to_string(constants);
            ViewDescription description(&test.device());
            description.setTechnique(technique, 4);
            AgaaView view = nullptr;
            const AgaaResult result = test.device().createView(test.sdk, context.get(), &description.desc, &view);
            if (constants != AGAA_GL_CONSTANTS_BLOCK && !std::strcmp(technique, "msaa"))
                expectRefused(test, result, AGAA_ERROR_UNSUPPORTED, context.log, "agaaGlCreateView", what,
                              "AGAA_GL_CONSTANTS_BLOCK");
            else
                test.result(result, AGAA_OK, what);
            if (view)
                test.sdk.agaaDestroyView(view);
        }
    }
}

void testDeviceHeader(Test& test) {
    HeaderCase c = {"AgaaGlDeviceDesc", "agaaGlCreateContext",
                    [](Test& inner, void* structure) {
                        const AgaaGlDeviceDesc right = inner.device().description().gl;
                        constexpr size_t header = sizeof(AgaaStructHeader);
                        std::memcpy(static_cast<char*>(structure) + header,
                                    reinterpret_cast<const char*>(&right) + header, sizeof right - header);
                    },
                    [](Test& inner, void* structure, const AgaaLog* log) {
                        AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
                        desc.log = log;
                        desc.pNext = structure;
                        AgaaContext context = nullptr;
                        const AgaaResult result = inner.sdk.agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &context);
                        if (result == AGAA_OK)
                            inner.sdk.agaaDestroyContext(context);
                        return result;
                    }};
    c.isChained = true;
    testHeader(test, c);
}

} // namespace

void addOpenGlContextCases(Suite& suite) {
    const auto gl = [&](const char* name, std::function<void(Test&)> run) {
        suite.add(name, {Backend::OpenGl}, std::move(run));
    };
    gl("AgaaGlDeviceDesc/header", testDeviceHeader);
    gl("AgaaGlDeviceDesc.glslVersion/range", [](Test& test) {
        testMember(test, "glslVersion",
                   {{330, {}}, {400, {}}, {410, {}}, {420, {}}, {430, {}}, {440, {}}, {450, {}}, {460, {}}},
                   [](AgaaGlDeviceDesc& d, uint32_t value) { d.glslVersion = value; });
    });
    gl("AgaaGlDeviceDesc.storage/enum", [](Test& test) {
        testMember(test, "storage", {{AGAA_GL_STORAGE_BUFFERS, {}}, {AGAA_GL_STORAGE_IMAGES, {}}},
                   [](AgaaGlDeviceDesc& d, uint32_t value) { d.storage = value; });
    });
    gl("AgaaGlDeviceDesc.outputs/enum", [](Test& test) {
        testMember(test, "outputs", {{AGAA_GL_OUTPUTS_SDK, {}}, {AGAA_GL_OUTPUTS_HOST, {}}},
                   [](AgaaGlDeviceDesc& d, uint32_t value) { d.outputs = value; });
    });
    gl("AgaaGlDeviceDesc.statePolicy/enum", [](Test& test) {
        testMember(test, "statePolicy",
                   {{AGAA_GL_STATE_RESTORE, {}}, {AGAA_GL_STATE_CALLBACKS, useCallbacks}, {AGAA_GL_STATE_NONE, {}}},
                   [](AgaaGlDeviceDesc& d, uint32_t value) { d.statePolicy = value; });
    });
    gl("AgaaGlDeviceDesc.constants/enum", [](Test& test) {
        testMember(test, "constants",
                   {{AGAA_GL_CONSTANTS_BLOCK, {}},
                    {AGAA_GL_CONSTANTS_UNIFORMS, {}},
                    {AGAA_GL_CONSTANTS_TEXELS, useSeparateUnit}},
                   [](AgaaGlDeviceDesc& d, uint32_t value) { d.constants = value; });
    });
    gl("AgaaGlConstants/AGAA_ERROR_UNSUPPORTED", testConstants);
}

} // namespace agaa::conformance
