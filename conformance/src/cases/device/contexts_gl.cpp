// AgaaGlDeviceDesc and agaaGlCreateContext.
#include "cases.h"
#include "creation.h"

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
    for (uint32_t i = 0; i < AGAA_GL_MAX_BINDINGS; ++i)
        add("AgaaGlDeviceDesc::bindings[" + std::to_string(i) + "] = 0xFFFFFFF0", range, "bindings",
            [=](D& d) { d.gl.bindings[i] = 0xFFFFFFF0; });
    return rows;
}

} // namespace agaa::conformance
