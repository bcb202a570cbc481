#include "core/plan/resolved_outputs.h"

#include "core/base/error.h"
#include "core/base/glsl_number.h"
#include "core/view/custom_glsl.h"

#include <algorithm>
#include <array>

namespace agaa {

bool resolvesSurfaces(const PlanBuilder& b) {
    return std::ranges::any_of(b.view().resolvedOutputs, &ResolvedOutput::isOfSurfaces);
}

namespace {

bool hasDepths(const PlanBuilder& b) {
    return b.sceneDepth != noResource || b.visibleSamples != noResource || b.view().hostGBuffer;
}

// Depths that a buffer has need no other source.
bool readsSamples(const PlanBuilder& b) { return b.view().hostGBuffer || (resolvesSurfaces(b) && b.bindSceneSamples); }
bool readsSums(const PlanBuilder& b) { return !readsSamples(b) && (resolvesSurfaces(b) || !hasDepths(b)); }

// The words of a pixel (src/shaders/common/resolved_values.glsl) and the text that adds to them and reads them.
struct Values {
    uint32_t words = 1;
    std::string add, addDepths, summedDepths, images, store;

    uint32_t take(uint32_t count) {
        words += count;
        return words - count;
    }
};

// Codes of values that are not averaged fit a word. Samples of more bits lose some, as in aggregates.
uint32_t codeBits(const AgaaLayoutAttribute& attribute) {
    return std::min(attribute.sampleBits, 32 / attribute.channels);
}

// Expressions of the channels of a texel. Those that a value lacks are 0, and alpha is 1.
struct Texel {
    std::array<std::string, 4> channels = {"0.0", "0.0", "0.0", "1.0"};
    uint32_t count = 0;

    void push_back(std::string channel) { channels[count++] = std::move(channel); }
};
Texel one(const char* channel) {
    Texel texel;
    texel.push_back(channel);
    return texel;
}

// Adds the words of a custom attribute.
Texel addAttribute(Values& values, const ResolvedOutput& output) {
    const AgaaLayoutAttribute& a = output.attribute;
    const std::string range = glslNumber(a.range);
    Texel texel;
    const auto read = [&](const std::string& value) {
        texel.push_back(format("%s * %s", value.c_str(), range.c_str()));
    };
    if (!isUnfiltered(a)) {
        const uint32_t word = values.take(a.channels);
        for (uint32_t i = 0; i < a.channels; ++i) {
            values.add += format("agaa_addToSum(%uu, agaa_sumTerm((samples) * (custom)[%u])); ", word + i,
                                 output.firstChannel + i);
            read(format("agaa_resolvedMean(%uu)", word + i));
        }
        return texel;
    }
    // Channel 0 decides first.
    const uint32_t word = values.take(1), bits = codeBits(a);
    std::string code;
    for (uint32_t i = 0; i < a.channels; ++i) {
        const uint32_t shift = bits * (a.channels - 1 - i);
        code +=
            format("%sagaa_quantise((custom)[%u], %uu) << %u", i ? " | " : "", output.firstChannel + i, bits, shift);
        read(format("agaa_resolvedCode(%uu, %uu, %uu)", word, shift, bits));
    }
    values.add += format("agaa_raiseSum(%uu, %s); ", word, code.c_str());
    return texel;
}

Texel addNormal(Values& values) {
    const uint32_t word = values.take(3);
    Texel texel;
    for (uint32_t i = 0; i < 3; ++i) {
        values.add += format("agaa_addToSum(%uu, agaa_sumTerm((samples) * (normal).%c)); ", word + i, "xyz"[i]);
        texel.push_back(format("agaa_resolvedMean(%uu)", word + i));
    }
    return texel;
}

Texel texelOf(Values& values, const ResolvedOutput& output) {
    switch (output.value) {
    case AGAA_RESOLVED_NEAREST_DEPTH:
        return one("agaa_nearestDepth");
    case AGAA_RESOLVED_MEAN_DEPTH:
        return one("agaa_meanDepth");
    case AGAA_RESOLVED_NORMAL:
        return addNormal(values);
    case AGAA_RESOLVED_COVERAGE:
        return one("agaa_resolvedCoverage()");
    default:
        return addAttribute(values, output);
    }
}

void addDepths(Values& values) {
    const uint32_t word = values.take(2);
    values.addDepths = format("agaa_addToSum(%uu, agaa_depthSumTerm((samples) * (depth))); agaa_raiseSum(%uu, "
                              "agaa_nearness(depth)); ",
                              word, word + 1);
    values.summedDepths = format("agaa_sums[%u], agaa_meanOfDepthTerms(agaa_sums[%u], agaa_sums[0])", word + 1, word);
}

Values valuesOf(const PlanBuilder& b) {
    Values values;
    const std::vector<ResolvedOutput>& outputs = b.view().resolvedOutputs;
    for (size_t i = 0; i < outputs.size(); ++i) {
        const std::array<std::string, 4> rgba = texelOf(values, outputs[i]).channels;
        values.images += format("layout(AGAA_BINDING_RESOLVED%zu) writeonly uniform image2D agaa_resolved%zu; ", i, i);
        values.store += format("imageStore(agaa_resolved%zu, at, vec4(%s, %s, %s, %s)); ", i, rgba[0].c_str(),
                               rgba[1].c_str(), rgba[2].c_str(), rgba[3].c_str());
    }
    if (!hasDepths(b) && std::ranges::any_of(outputs, &ResolvedOutput::isDepth))
        addDepths(values);
    return values;
}

std::string definesOf(const Values& values) {
    return format("#define AGAA_RESOLVED_WORDS %uu\n", values.words) +
           "#define AGAA_ADD_VALUES(samples, normal, custom) " + values.add +
           "\n#define AGAA_ADD_DEPTHS(samples, depth) " + values.addDepths + "\n";
}

// Passes of the library that contain text of the plan are compiled with the view.
void compileWithView(Pass& pass) {
    ComputePart& program = pass.compute();
    if (program.hostCode.empty() && program.text.empty())
        program.text = "#include \"" + program.file + "\"\n";
}

ResourceId sumsOf(PlanBuilder& b, const Values& values) {
    if (b.resolvedSums == noResource)
        b.resolvedSums = b.pixelBuffer("resolved-sums", 4 * values.words);
    return b.resolvedSums;
}

// The sums are 0 before the first pass that adds to them. A range that is repeated is not divided.
void clearSums(PlanBuilder& b) {
    std::vector<Pass>& passes = b.plan.passes;
    const auto adds = [&](const Pass& pass) {
        return std::ranges::any_of(pass.bindings, [&](const Binding& x) { return x.resource == b.resolvedSums; });
    };
    auto first = uint32_t(std::ranges::find_if(passes, adds) - passes.begin());
    for (const Repeat& repeat : b.plan.repeats)
        if (first >= repeat.firstPass && first <= repeat.lastPass)
            first = repeat.firstPass;
    b.fill("clear sums of outputs", AGAA_STAGE_OTHER, b.resolvedSums, passes[first].segment);
    std::ranges::rotate(passes.begin() + first, passes.end() - 1, passes.end());
    for (Repeat& repeat : b.plan.repeats)
        if (repeat.firstPass >= first) {
            ++repeat.firstPass;
            ++repeat.lastPass;
        }
}

} // namespace

void sumEvents(PlanBuilder& b, Pass& pass) {
    if (b.view().resolvedOutputs.empty() || !readsSums(b))
        return;
    const Values values = valuesOf(b);
    std::string& defines = pass.compute().defines;
    defines += "#define AGAA_RESOLVES_EVENTS 1\n" + definesOf(values);
    const uint32_t channels = b.view().layout.customChannels();
    if (std::ranges::any_of(b.view().resolvedOutputs, resolvesCustom) &&
        !b.view().shadingFunction) // which defines it, too
        defines += format("#define AGAA_SHADES_CUSTOM %u\n", channels);
    b.bind(pass, slot::ResolvedSums, BindingType::StorageBuffer, sumsOf(b, values), true);
    compileWithView(pass);
}

void resolveOutputs(PlanBuilder& b) {
    if (b.view().resolvedOutputs.empty())
        return;
    b.effect("resolved-outputs");
    const Values values = valuesOf(b);
    if (readsSums(b))
        clearSums(b);
    Pass& pass = b.compute("resolve outputs", AGAA_STAGE_OTHER, "resolve_outputs", AGAA_SEGMENT_SHADING);
    b.bind(pass, slot::Frame, BindingType::UniformBuffer, b.frameConstants(AGAA_SEGMENT_SHADING));
    if (readsSamples(b))
        b.bindSceneSamples(pass);
    else if (b.visibleSamples != noResource)
        b.bind(pass, slot::Visible, BindingType::StorageBuffer, b.visibleSamples);
    else if (b.sceneDepth != noResource)
        b.bind(pass, slot::Depth, BindingType::Texture, b.sceneDepth);
    if (readsSums(b))
        b.bind(pass, slot::ResolvedSums, BindingType::StorageBuffer, sumsOf(b, values));
    for (uint32_t i = 0; i < b.view().resolvedOutputs.size(); ++i)
        b.bind(pass, slot::Resolved0 + i, BindingType::StorageImage, b.resolvedOutput(i), true);
    std::string& defines = pass.compute().defines;
    defines += definesOf(values) + "#define AGAA_RESOLVED_IMAGES " + values.images +
               "\n#define AGAA_STORE_VALUES(at) " + values.store +
               format("\n#define AGAA_RESOLVES_SAMPLES %d\n#define AGAA_RESOLVES_SUMS %d\n"
                      "#define AGAA_RESOLVES_DEPTHS %d\n",
                      readsSamples(b), readsSums(b), hasDepths(b));
    if (!values.summedDepths.empty())
        defines += "#define AGAA_SUMMED_DEPTHS " + values.summedDepths + "\n";
    compileWithView(pass);
}

} // namespace agaa
