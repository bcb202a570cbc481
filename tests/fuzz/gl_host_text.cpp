#include "gl_host_text.h"

#include "agaa_gl.h"
#include "gl/device.h"
#include "render/technique_config.h"

#include <vector>

namespace fuzz {

namespace {

struct Log {
    uint32_t errors = 0;
    std::string text;
};

void AGAA_CALL onMessage(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity != AGAA_SEVERITY_ERROR)
        return;
    ++static_cast<Log*>(user)->errors;
    static_cast<Log*>(user)->text = message;
}

std::string repeated(const std::string& part, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

// Depths are below the limit of the library, which the driver must survive, and above it.
std::vector<std::string> bodies() {
    const std::string megabyte(1 << 20, 'y');
    std::vector<std::string> list = {"x; /* no end",
                                     "x;\n#error " + megabyte + "\n",
                                     "x; // " + megabyte + "\n",
                                     "x \x01\x7f\xff",
                                     "x; } float " + megabyte + "() { return 1.0",
                                     "x;\n#include \"a\"\n",
                                     "x;\n" + repeated("#if 1\n", 400) + repeated("#endif\n", 399),
                                     "x; }\n#define A B\n#define B A\nfloat f() { return A"};
    for (const size_t depth : {480, 100000})
        for (const char* part : {"x + ", "- ", "abs(", "(", "x > 0.0 ? 1.0 : ", "x = "})
            list.push_back(repeated(part, depth / 4) + "x" +
                           repeated(")", std::string(part).ends_with('(') ? depth / 4 : 0));
    return list;
}

} // namespace

void checkGlHostText(const std::function<void(const std::string&)>& report) {
    const harness::gl::Device device(harness::RendererOptions{.validation = false}); // refused text is no finding
    Log log;
    AgaaLog sdkLog = AGAA_LOG_INIT;
    sdkLog.callback = onMessage;
    sdkLog.user = &log;
    AgaaGlDeviceDesc deviceDesc = AGAA_GL_DEVICE_DESC_INIT;
    deviceDesc.getProcAddr = harness::gl::Device::getProcAddr;
    AgaaContextDesc contextDesc = AGAA_CONTEXT_DESC_INIT;
    contextDesc.pNext = &deviceDesc;
    contextDesc.log = &sdkLog;
    AgaaContext context = nullptr;
    if (agaaGlCreateContext(AGAA_HEADER_VERSION, &contextDesc, &context) != AGAA_OK)
        return report("no context: " + log.text);
    harness::TechniqueConfig config;
    config.technique = "single";
    config.samples = 1;
    const AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    for (const std::string& body : bodies()) {
        const std::string text = "float agaaHostShadow(uint s, vec3 p) { float x = p.x; return " + body + "; }\n";
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = text.c_str();
        function.shadows = 1;
        AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
        desc.width = desc.height = 16;
        desc.config = &config;
        desc.facts = &facts;
        desc.pNext = &function;
        AgaaView view = nullptr;
        log = {};
        const AgaaResult result = agaaGlCreateView(context, &desc, &view);
        agaaDestroyView(view);
        const bool isControl = log.text.find_first_of("\n\r\x01\x7f") != std::string::npos;
        if (result == AGAA_OK
                ? log.errors != 0
                : result != AGAA_ERROR_INVALID_ARGUMENT || log.errors != 1 || isControl || !log.text.ends_with('.'))
            report(std::string(agaaResultName(result)) + " for a host's text: " + log.text);
    }
    if (agaaDestroyContext(context) != AGAA_OK)
        report("the context has views");
}

} // namespace fuzz
