// agaaGetGlslResources: what the GLSL of a draw pass declares.
#include "cases.h"
#include "frame_rig.h"
#include "pass_list.h"

#include <cstring>
#include <set>

namespace agaa::conformance {

namespace {

AgaaGlslResource filled() {
    AgaaGlslResource resource;
    std::memset(&resource, 0x5A, sizeof resource);
    return resource;
}

bool isUntouched(const AgaaGlslResource& resource) {
    const AgaaGlslResource other = filled();
    return !std::memcmp(&resource, &other, sizeof other);
}

std::vector<AgaaGlslResource> resourcesOf(Test& test, AgaaView view, uint32_t pass) {
    uint32_t count = 77;
    test.requireOk(test.sdk.agaaGetGlslResources(view, pass, &count, nullptr),
                   "agaaGetGlslResources with resources = null");
    std::vector<AgaaGlslResource> list(count + 2, filled());
    uint32_t length = count + 2;
    test.requireOk(test.sdk.agaaGetGlslResources(view, pass, &length, list.data()),
                   "agaaGetGlslResources with a longer array than needed");
    test.check(length == count, "agaaGetGlslResources with a longer array returns another count.");
    for (uint32_t i = count; i < list.size(); ++i)
        test.check(isUntouched(list[i]), "agaaGetGlslResources writes beyond the number of resources.");
    list.resize(count);
    return list;
}

using VisitResource =
    std::function<void(const AgaaDrawPass& pass, const AgaaGlslResource& resource, const std::string& what)>;

// Runs over the resources of one view per technique that the device supports.
void forResources(Test& test, const VisitResource& visit) {
    const ScopedContext context(test);
    for (const char* technique : {"agaa", "msaa", "dcaa"}) {
        if (!unsupportedReason(test, technique).empty())
            continue;
        ViewDescription description(&test.device());
        setTechnique(description, technique, 4);
        const BareView view(test, context.get(), description);
        const PassList list(test, view.get());
        for (uint32_t pass = 0; pass < list.passes.size(); ++pass) {
            const auto resources = resourcesOf(test, view.get(), pass);
            test.check(!resources.empty(), passText(technique, list.passes[pass]) + " has no resources.");
            for (const AgaaGlslResource& resource : resources)
                visit(list.passes[pass], resource, passText(technique, list.passes[pass]) + ": " + resource.name);
        }
    }
}

void testKinds(Test& test) {
    forResources(test, [&](const AgaaDrawPass&, const AgaaGlslResource& resource, const std::string& what) {
        test.check(resource.kind >= AGAA_GLSL_RESOURCE_UNIFORM && resource.kind <= AGAA_GLSL_RESOURCE_INPUT_ATTACHMENT,
                   what + " has an unknown kind.");
        test.check(resource.kind != AGAA_GLSL_RESOURCE_UNIFORM || !resource.binding,
                   what + " is a plain uniform with a binding.");
    });
}

// The texts of a resource's stages name it, and the others do not declare it.
void testStages(Test& test) {
    forResources(test, [&](const AgaaDrawPass& pass, const AgaaGlslResource& resource, const std::string& what) {
        const struct {
            uint32_t stage;
            const char* text;
        } rows[] = {{AGAA_GLSL_STAGE_FRAGMENT, pass.glslDeclarations},
                    {AGAA_GLSL_STAGE_GEOMETRY, pass.glslGeometry},
                    {AGAA_GLSL_STAGE_VERTEX, pass.glslVertex}};
        uint32_t known = 0;
        for (const auto& row : rows) {
            known |= row.stage;
            if (resource.stages & row.stage)
                test.check(row.text && std::strstr(row.text, resource.name), what + " is in no text of its stages.");
        }
        test.check(resource.stages && !(resource.stages & ~known), what + " has no known stage.");
    });
}

void testNames(Test& test) {
    std::set<std::string> frames;
    forResources(test, [&](const AgaaDrawPass&, const AgaaGlslResource& resource, const std::string& what) {
        test.check(std::memchr(resource.name, 0, sizeof resource.name) != nullptr, what + " has a name without end.");
        test.check(!std::strncmp(resource.name, "agaa_", 5), what + " has a name that does not begin with agaa_.");
        frames.insert(resource.name);
    });
    test.check(frames.count("agaa_FrameBlock") || frames.count("agaa_constantTexels") || frames.count("agaa_constants"),
               "no draw pass lists the constants of the frame.");
}

void testReservedAndCount(Test& test) {
    forResources(test, [&](const AgaaDrawPass&, const AgaaGlslResource& resource, const std::string& what) {
        for (const uint32_t word : resource.reserved)
            test.check(word == 0, what + ": AgaaGlslResource::reserved is not 0.");
        test.check(resource.count >= 1, what + " has the count 0.");
    });
}

// Two resources of a kind that share a binding would be one.
void testBindings(Test& test) {
    std::set<std::string> seen;
    forResources(test, [&](const AgaaDrawPass& pass, const AgaaGlslResource& resource, const std::string& what) {
        if (resource.kind == AGAA_GLSL_RESOURCE_UNIFORM)
            return;
        const bool isVk = test.device().backend() == Backend::Vulkan;
        test.check(isVk || resource.set == 0, what + " has a descriptor set on OpenGL.");
        const std::string place = std::to_string(pass.pipelineKey) + ' ' +
                                  (isVk ? std::string() : std::to_string(resource.kind)) + ' ' +
                                  std::to_string(resource.set) + ' ' + std::to_string(resource.binding);
        test.check(seen.insert(place).second, what + " has the binding of another resource.");
    });
}

struct Arguments {
    AgaaView view;
    uint32_t pass = 0;
    uint32_t length = 0;
    uint32_t* count = &length;
};

struct WrongCall {
    std::string what;
    AgaaResult code;
    std::function<void(Arguments&)> corrupt;
};

const std::vector<WrongCall>& wrongCalls() {
    static const std::vector<WrongCall> calls = {
        {"a null view", AGAA_ERROR_INVALID_ARGUMENT, [](Arguments& a) { a.view = nullptr; }},
        {"count = null", AGAA_ERROR_INVALID_ARGUMENT, [](Arguments& a) { a.count = nullptr; }},
        {"the pass 99", AGAA_ERROR_OUT_OF_RANGE, [](Arguments& a) { a.pass = 99; }},
        {"the pass 0xFFFFFFFF", AGAA_ERROR_OUT_OF_RANGE, [](Arguments& a) { a.pass = 0xFFFFFFFF; }},
        {"count = 0", AGAA_ERROR_BUFFER_TOO_SMALL, [](Arguments& a) { a.length = 0; }},
        {"one element less than there are resources", AGAA_ERROR_BUFFER_TOO_SMALL, [](Arguments& a) { --a.length; }}};
    return calls;
}

// Runs the calls that fail with `code`; AGAA_OK selects all calls.
void testCalls(Test& test, AgaaResult code) {
    ScopedContext context(test);
    ViewDescription description(&test.device());
    setTechnique(description, "agaa", 4);
    const BareView view(test, context.get(), description);
    const uint32_t available = uint32_t(resourcesOf(test, view.get(), 0).size());
    for (const WrongCall& call : wrongCalls()) {
        if (code != AGAA_OK && call.code != code)
            continue;
        Arguments a{.view = view.get(), .length = available};
        call.corrupt(a);
        const uint32_t length = a.length;
        std::vector<AgaaGlslResource> list(available, filled());
        context.log.lines.clear();
        const AgaaResult result = test.sdk.agaaGetGlslResources(a.view, a.pass, a.count, list.data());
        const std::string what = "agaaGetGlslResources with " + call.what;
        if (a.view)
            expectRefused(test, result, call.code, context.log, "agaaGetGlslResources", what);
        else
            test.result(result, call.code, what);
        test.check(a.length == length, what + " fails and changes count.");
        for (const AgaaGlslResource& resource : list)
            test.check(isUntouched(resource), what + " fails and changes resources.");
    }
}

} // namespace

void addGlslResourceCases(Suite& suite) {
    const struct {
        const char* name;
        AgaaResult code;
    } rows[] = {{"AGAA_ERROR_INVALID_ARGUMENT", AGAA_ERROR_INVALID_ARGUMENT},
                {"AGAA_ERROR_OUT_OF_RANGE", AGAA_ERROR_OUT_OF_RANGE},
                {"AGAA_ERROR_BUFFER_TOO_SMALL", AGAA_ERROR_BUFFER_TOO_SMALL},
                {"count.unchanged", AGAA_OK},
                {"resources.unchanged", AGAA_OK}};
    for (const auto& row : rows)
        suite.both(std::string("agaaGetGlslResources/") + row.name,
                   [code = row.code](Test& test) { testCalls(test, code); });
    suite.both("agaaGetGlslResources/resources.null", [](Test& test) { forResources(test, [](const auto&...) {}); });
    suite.both("AgaaGlslResource.kind/enum", testKinds);
    suite.both("AgaaGlslResource.stages/enum", testStages);
    suite.both("AgaaGlslResource.name/prefix", testNames);
    suite.both("AgaaGlslResource.reserved/zero", testReservedAndCount);
    suite.both("AgaaGlslResource.binding/unique", testBindings);
}

} // namespace agaa::conformance
