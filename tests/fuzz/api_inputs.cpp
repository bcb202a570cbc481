#include "api_inputs.h"

#include "core/plan/planner.h"

#include <cmath>

namespace fuzz {

const char* Memory::text(const std::string& value) {
    std::byte* block = keep(value.size() + 1);
    std::memcpy(block, value.c_str(), value.size() + 1);
    return reinterpret_cast<const char*>(block);
}

const float* Memory::numbers(size_t count, bool areValid) {
    auto* list = reinterpret_cast<float*>(keep(std::max<size_t>(count, 1) * sizeof(float)));
    for (size_t i = 0; i < count; ++i)
        list[i] = areValid ? float(choices_.below(256)) / 256 : choices_.number();
    return list;
}

const char* anyName(Choices& choices, Memory& memory, std::initializer_list<const char*> names) {
    if (!choices.oneIn(40))
        return *(names.begin() + choices.below(names.size()));
    static const char* const parts[] = {"",     "x\n",  "\x01",     "%s%n",      "\xff\xfe",
                                        "\"}]", "\x7f", "\u2028\r", "agaa agaa", "\t*/"};
    std::string text;
    do
        text += choices.of(parts);
    while (choices.oneIn(2) && text.size() < 300);
    return choices.oneIn(8) ? nullptr : memory.text(text);
}

namespace {

AgaaLayout anyLayout(Choices& choices, Memory& memory) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout(choices.oneIn(2) ? "paper16" : "precise", &layout);
    if (choices.oneIn(4)) { // for AgaaTemporal::motion
        AgaaLayoutAttribute& velocity = layout.attributes[layout.attributeCount++];
        velocity = AGAA_LAYOUT_ATTRIBUTE_INIT;
        velocity.semantic = AGAA_SEMANTIC_CUSTOM;
        velocity.channels = 2;
        velocity.sampleBits = 16;
        velocity.range = 1;
        velocity.name = memory.text("velocity");
    }
    while (choices.oneIn(3)) {
        AgaaLayoutAttribute& attribute = layout.attributes[choices.below(AGAA_MAX_LAYOUT_ATTRIBUTES)];
        if (choices.oneIn(2) && layout.attributeCount < AGAA_MAX_LAYOUT_ATTRIBUTES) {
            AgaaLayoutAttribute& added = layout.attributes[layout.attributeCount++];
            added = AGAA_LAYOUT_ATTRIBUTE_INIT;
            added.semantic = AGAA_SEMANTIC_CUSTOM;
            added.channels = uint32_t(choices.oneIn(20) ? choices.below(6) : 1 + choices.below(4));
            added.sampleBits = choices.oneIn(2) ? 8 : 16;
            added.filter = uint32_t(choices.below(3));
            added.channels = added.filter == AGAA_FILTER_NORMAL && !choices.oneIn(20) ? 3 : added.channels;
            static const char* const wrong[] = {"",    "gl_x",  "a__b",     "float",
                                                "w\n", "agaaX", "diffuse",  "_",
                                                "1a",  "a-b",   "\xc3\xa9", "abcdefghijklmnopqrstuvwxyzabcdef"};
            added.name = choices.oneIn(10) ? memory.text(choices.of(wrong))
                                           : memory.text("member" + std::to_string(choices.below(13)));
        } else {
            const uint32_t word = choices.word();
            std::memcpy(reinterpret_cast<std::byte*>(&attribute) + 4 * choices.below(8), &word, 4);
        }
        if (choices.oneIn(40))
            layout.attributeCount = choices.word();
    }
    return layout;
}

AgaaDecoupledCoverage* anyCoverage(Choices& choices, Memory& memory, uint32_t samples) {
    AgaaDecoupledCoverage value = AGAA_DECOUPLED_COVERAGE_INIT;
    value.merge = uint32_t(choices.below(choices.oneIn(30) ? 5 : 3));
    value.fragmentsPerPixel = choices.oneIn(20) ? choices.number() : float(1 + choices.below(256));
    value.maxBatches = uint32_t(choices.oneIn(2) ? 1 : choices.below(18));
    value.flags = choices.oneIn(4) ? choices.oneIn(10) ? choices.bits() : choices.below(4) : 0;
    if (choices.oneIn(3))
        value.samplePositions = memory.numbers(2 * size_t(std::min(samples, 128u)), !choices.oneIn(4));
    value.tableSize = choices.oneIn(3) ? choices.word() : 0;
    value.reserved = choices.oneIn(100);
    return memory.copy(value, 0, 0, 1);
}

AgaaTemporal* anyTemporal(Choices& choices, Memory& memory) {
    AgaaTemporal value = AGAA_TEMPORAL_INIT;
    if (choices.oneIn(2))
        value.motion = anyName(choices, memory, {"velocity", "velocity", "member0", "diffuse"});
    value.flags = choices.oneIn(10) ? choices.bits() : choices.below(4);
    return memory.copy(value, offsetof(AgaaTemporal, currentShare), sizeof(AgaaTemporal), 5);
}

const char* anyExtensions(Choices& choices, Memory& memory) {
    static const char* const lines[] = {"#extension GL_EXT_nonuniform_qualifier : enable\n",
                                        "\n",
                                        "#extension  GL_X :require",
                                        "#define A\n",
                                        "#extension GL_X : enable \\\n",
                                        "#extension\n",
                                        "#extension GL_X : enable // */\n",
                                        " \t\r\n"};
    if (!choices.oneIn(4))
        return nullptr;
    std::string text;
    while (choices.oneIn(2) && text.size() < 2000)
        text += choices.of(lines);
    if (choices.oneIn(10))
        text += "#extension " + std::string(1000, 'a') + " : enable";
    return memory.text(text);
}

const void* anyFunctions(Choices& choices, Memory& memory, uint32_t samples, uint32_t shadowMaps) {
    const void* chain = nullptr;
    if (choices.oneIn(3)) {
        AgaaFetchFunction value = AGAA_FETCH_FUNCTION_INIT;
        value.pNext = chain;
        value.glsl = choices.oneIn(20) ? nullptr : memory.text("void agaaHostMaterial() {}");
        value.maxDraws = choices.oneIn(10) ? choices.word() : uint32_t(1 + choices.below(5000));
        value.maxPrimitives = choices.oneIn(10) ? choices.word() : uint32_t(1 + choices.below(5000));
        value.flags = choices.oneIn(3) ? AGAA_FETCH_NOT_ALL_DRAWS : choices.oneIn(50) ? choices.bits() : 0;
        value.descriptorSetLayout = choices.below(2);
        value.glslExtensions = anyExtensions(choices, memory);
        chain = memory.copy(value, 0, 0, 1);
    }
    if (choices.oneIn(chain ? 50 : 8)) {
        AgaaGBufferFunction value = AGAA_GBUFFER_FUNCTION_INIT;
        value.pNext = chain;
        value.glsl = choices.oneIn(20) ? nullptr : memory.text("bool agaaHostSample() {}");
        if (choices.oneIn(2))
            value.samplePositions = memory.numbers(2 * size_t(std::min(samples, 128u)), !choices.oneIn(4));
        static const uint32_t bits[] = {0, 0, 16, 24, 32, 1};
        value.depthBits = choices.of(bits);
        value.reserved = choices.oneIn(100);
        value.descriptorSetLayout = choices.below(2);
        value.glslExtensions = anyExtensions(choices, memory);
        chain = memory.copy(value, 0, 0, 1);
    }
    if (choices.oneIn(6)) {
        AgaaShadowFunction value = AGAA_SHADOW_FUNCTION_INIT;
        value.pNext = chain;
        value.glsl = memory.text("float agaaHostShadow() { return 1; }");
        value.shadows = choices.oneIn(4) ? choices.word() : (1u << (shadowMaps % 8)) - 1;
        value.footprints = choices.oneIn(4) ? value.shadows & choices.below(16) : 0;
        value.descriptorSetLayout = choices.below(2);
        value.glslExtensions = anyExtensions(choices, memory);
        chain = memory.copy(value, 0, 0, 1);
    }
    if (choices.oneIn(6)) {
        AgaaShadingFunction value = AGAA_SHADING_FUNCTION_INIT;
        value.pNext = chain;
        value.glsl = memory.text("vec3 agaaShade(AgaaSurface s) { return s.diffuse; }");
        value.level = choices.oneIn(8) ? choices.word() : choices.below(2);
        value.descriptorSetLayout = choices.below(2);
        value.glslExtensions = anyExtensions(choices, memory);
        chain = memory.copy(value, 0, 0, 1);
    }
    if (choices.oneIn(6)) {
        AgaaResolvedOutputs value = AGAA_RESOLVED_OUTPUTS_INIT;
        value.pNext = chain;
        value.count = choices.oneIn(8) ? choices.word() : 1 + choices.below(AGAA_MAX_RESOLVED_OUTPUTS);
        for (AgaaResolvedOutput& output : value.outputs) {
            output.value = choices.oneIn(16) ? choices.word() : 1 + choices.below(5);
            if (output.value == AGAA_RESOLVED_CUSTOM || choices.oneIn(16))
                output.attribute = memory.text(choices.oneIn(4) ? "no" : "velocity");
        }
        chain = memory.copy(value, 0, 0, 1);
    }
    return chain;
}

void AGAA_CALL onMessage(void* user, uint32_t severity, AgaaResult code, const char* message) {
    auto& messages = *static_cast<Messages*>(user);
    if (severity != AGAA_SEVERITY_ERROR)
        return;
    ++messages.errors;
    messages.code = code;
    messages.text = message;
}

} // namespace

ViewInput::ViewInput(Choices& choices) : memory(choices) {
    constexpr size_t header = sizeof(AgaaStructHeader);
    AgaaConfig configValue = AGAA_CONFIG_INIT;
    static const uint32_t counts[] = {1, 2, 4, 8, 8, 16, 32}, coverageCounts[] = {32, 64, 128, 9};
    configValue.technique = anyName(choices, memory,
                                    {"single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa", "agaa",
                                     "adaptive", "dcaa", "sgbc", "Simple-Complex", "smaa", "taa", "visibility"});
    const std::string_view name = configValue.technique ? configValue.technique : "";
    const bool isCoverage = name == "dcaa" || name == "sgbc";
    configValue.samples = choices.oneIn(12)                 ? choices.word()
                          : isCoverage != choices.oneIn(12) ? choices.of(coverageCounts)
                                                            : choices.of(counts);
    configValue.aggregates = uint32_t(1 + choices.below(4));
    if (choices.oneIn(6))
        configValue.generationTier = uint32_t(choices.oneIn(10) ? choices.word() : 16 + choices.below(10));
    if (choices.oneIn(5))
        configValue.flags = choices.oneIn(10) ? choices.bits() : choices.below(128);
    configValue.ndf = uint32_t(choices.below(4));
    // A layout is a long struct: most views have the library's.
    if (choices.oneIn(3)) {
        const AgaaLayout layout = anyLayout(choices, memory);
        configValue.layout = memory.copy(layout, header, header + 8, 20);
    }
    config = memory.copy(configValue, offsetof(AgaaConfig, brdf), sizeof(AgaaConfig), 7);

    aggregation = memory.copy(AgaaAggregation AGAA_AGGREGATION_INIT, header, sizeof(AgaaAggregation), 5);
    AgaaMeasurement measurementValue = AGAA_MEASUREMENT_INIT;
    measurementValue.diffuseFilter = uint32_t(choices.below(3));
    measurement = memory.copy(measurementValue, header, sizeof(AgaaMeasurement), 7);
    if (choices.oneIn(2)) {
        AgaaAdaptiveSampling* adaptive =
            memory.copy(AgaaAdaptiveSampling AGAA_ADAPTIVE_SAMPLING_INIT, header, sizeof(AgaaAdaptiveSampling), 5);
        AgaaStructHeader* chain[] = {
            reinterpret_cast<AgaaStructHeader*>(aggregation), reinterpret_cast<AgaaStructHeader*>(measurement),
            reinterpret_cast<AgaaStructHeader*>(adaptive),
            reinterpret_cast<AgaaStructHeader*>(anyCoverage(choices, memory, configValue.samples)),
            reinterpret_cast<AgaaStructHeader*>(anyTemporal(choices, memory))};
        auto* last = reinterpret_cast<AgaaStructHeader*>(config);
        for (AgaaStructHeader* next : chain)
            if (choices.oneIn(2)) {
                last->pNext = next;
                last = next;
            }
        if (choices.oneIn(50)) // a struct twice, or a chain that does not end
            last->pNext = choices.of(chain);
    }

    AgaaSceneFacts factsValue = AGAA_SCENE_FACTS_INIT;
    if (choices.oneIn(2))
        factsValue.flags = choices.oneIn(20) ? choices.bits() : choices.bits(2) & 0xFF1F;
    factsValue.maxLights = choices.oneIn(20) ? choices.word() : uint32_t(choices.below(100));
    factsValue.shadowMapCount = uint32_t(choices.below(choices.oneIn(20) ? 9 : 5));
    AgaaSceneFacts* facts = memory.copy(factsValue, offsetof(AgaaSceneFacts, alpha2), sizeof(AgaaSceneFacts), 20);

    AgaaViewDesc viewValue = AGAA_VIEW_DESC_INIT;
    viewValue.width = choices.oneIn(20) ? choices.word() : uint32_t(1 + choices.below(4096));
    viewValue.height = choices.oneIn(20) ? choices.word() : uint32_t(1 + choices.below(4096));
    viewValue.config = choices.oneIn(200) ? nullptr : config;
    viewValue.facts = choices.oneIn(10) ? nullptr : facts;
    viewValue.pNext = anyFunctions(choices, memory, configValue.samples, factsValue.shadowMapCount);
    if (choices.oneIn(2))
        viewValue.flags = choices.oneIn(20) ? choices.bits() : choices.below(16);
    view = memory.copy(viewValue, 0, 0, 1);

    if (choices.oneIn(2)) {
        caps = memory.copy(agaa::idealDevice(), offsetof(AgaaDeviceCaps, sampleCounts), sizeof(AgaaDeviceCaps), 3);
        for (char* name : {caps->deviceName, caps->driverName})
            if (caps->structSize >= sizeof *caps && choices.oneIn(8)) // a name without an end
                std::fill_n(name, sizeof caps->deviceName, choices.oneIn(2) ? 'n' : '\n');
    }
}

Messages::Messages() {
    log.callback = onMessage;
    log.user = this;
}

void checkResult(const char* function, AgaaResult result, const Messages& messages, bool isOutputChanged) {
    const std::string name = agaaResultName(result);
    const std::string call = function + (" returned " + name);
    if (result >= 0)
        countAccepted();
    if (name == "unknown result" || result == AGAA_ERROR_INTERNAL)
        report(call + ": " + messages.text);
    if (result >= 0 ? messages.errors != 0 : messages.errors != 1)
        report(call + " with " + std::to_string(messages.errors) + " messages: " + messages.text);
    if (result < 0 && isOutputChanged)
        report(call + " and changed its output");
    if (result >= 0 || messages.errors != 1)
        return;
    if (messages.code != result || !messages.text.starts_with(function) || !messages.text.ends_with('.'))
        report(call + " with the message \"" + messages.text + "\"");
    checkLine(call, messages.text);
}

} // namespace fuzz
