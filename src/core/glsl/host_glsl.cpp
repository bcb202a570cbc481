#include "core/glsl/host_glsl.h"

#include "core/base/error.h"
#include "core/base/glsl_number.h"
#include "core/frame/frame_data.h"
#include "core/glsl/expression_depth.h"
#include "core/glsl/glsl_text.h"
#include "core/plan/gpu_layout.h"
#include "core/plan/plan_builder.h"
#include "core/plan/sample_patterns.h"
#include "core/view/custom_glsl.h"
#include "core/view/facts.h"
#include "core/view/shading_glsl.h"

#include <algorithm>
#include <set>

namespace agaa {

namespace {

void define(std::string& out, const char* name, uint32_t value) { out += format("#define %s %uu\n", name, value); }

// Some compilers reject the suffix `u` in preprocessor conditions. Switches have none.
void defineSwitch(std::string& out, const char* name, uint32_t value) { out += format("#define %s %u\n", name, value); }

// Returns the macros with the position of each channel in an aggregate.
std::string fields(const Constants& constants) {
    std::string out;
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) define(out, #field, constants[field]);
#include "shaders/tables/channels.inc"
    return out;
}

bool mergesInOrder(const Pass& pass) { return pass.draw().fragmentContent == FragmentContent::Merged; }
bool mergesInTargets(const Pass& pass) { return mergesInOrder(pass) && pass.draw().state.readsAttachments; }

// Declares attachments that the shader reads and writes. They form one array of words, attachment by attachment.
std::string fetchedTargets(const Pass& pass, const HostDialect& dialect) {
    const uint32_t attachments = pass.draw().state.colorAttachmentCount;
    std::string out, fetch = "    uvec4 held;\n", store;
    if (!dialect.openGl)
        out +=
            format("layout(input_attachment_index = 0, set = %u, binding = %u) uniform usubpassInput agaa_held[%u];\n",
                   dialect.descriptorSet, fetchedTargetsSlot, attachments);
    for (uint32_t i = 0; i < attachments; ++i) {
        out += format("layout(location = %u) %s uvec4 agaa_target%u;\n", i, dialect.openGl ? "inout" : "out", i);
        fetch += dialect.openGl ? format("    held = agaa_target%u;\n", i)
                                : format("    held = subpassLoad(agaa_held[%u]);\n", i);
        const uint32_t w = 4 * i;
        for (uint32_t c = 0; c < 4; ++c)
            fetch += format("    agaa_targetWords[%u] = held.%c;\n", w + c, "xyzw"[c]);
        store += format("    agaa_target%u = uvec4(agaa_targetWords[%u], agaa_targetWords[%u], agaa_targetWords[%u], "
                        "agaa_targetWords[%u]);\n",
                        i, w, w + 1, w + 2, w + 3);
    }
    return out + format("uint agaa_targetWords[%u];\n", 4 * attachments) + "void agaa_fetchTargets() {\n" + fetch +
           "}\nvoid agaa_storeTargets() {\n" + store + "}\n";
}

std::string outputs(const Pass& pass, const HostDialect& dialect) {
    std::string out;
    for (size_t i = 0; i < pass.draw().colorTargets.size() && !mergesInTargets(pass); ++i)
        out += dialect.hostOutputs ? format("vec4 agaa_out%zu;\n", i)
                                   : format("layout(location = %zu) out vec4 agaa_out%zu;\n", i, i);
    return out;
}

// Returns the macros with the binding of each resource in the host's set or binding points.
std::string bindingDefines(const HostDialect& dialect) {
    std::string out;
    for (const BindingRow& row : hostBindingTable)
        out += dialect.openGl ? format("#define AGAA_BINDING_%s binding = %u\n", row.macro, dialect.bindings[row.slot])
                              : format("#define AGAA_BINDING_%s set = %u, binding = %u\n", row.macro,
                                       dialect.descriptorSet, row.slot);
#define AGAA_HOST_ALIAS(macro, name, ofMacro, of) out += "#define AGAA_BINDING_" #macro " AGAA_BINDING_" #ofMacro "\n";
#include "shaders/tables/bindings.inc"
    return out;
}

// Members of agaa_Stored, by channel.
constexpr const char* channelMembers[ChannelCount] = {
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) #member,
#include "shaders/tables/channels.inc"
};

std::string storeAttachments(const Pass& pass) {
    std::string out = "void agaa_store(agaa_Stored v) {\n";
    for (size_t i = 0; i < pass.draw().colorTargets.size(); ++i) {
        std::string components[4] = {"0.0", "0.0", "0.0", "0.0"};
        for (uint32_t channel = 0; channel < ChannelCount; ++channel) {
            const uint32_t source = pass.constants[AGAA_SOURCE_DIFFUSE_R + channel];
            if (source >> 16 && (source & 0xFF) == i)
                components[source >> 8 & 0xFF] = format("agaa_sourceOf(v.%s, %uu)", channelMembers[channel], source);
        }
        out += format("    agaa_out%zu = vec4(%s, %s, %s, %s);\n", i, components[0].c_str(), components[1].c_str(),
                      components[2].c_str(), components[3].c_str());
    }
    return out + "}\n";
}

bool blendsAggregates(const Pass& pass) {
    return pass.draw().id == AGAA_DRAW_PASS_AGGREGATE && !pass.draw().colorTargets.empty();
}

// Returns the function that writes a fragment's share of each channel to the attachments. A field has the attachment in
// place of the word and the component in place of the shift. The last attachment has the coverage of samples beyond the
// first eight.
std::string blendAttachments(const Plan& plan, const Pass& pass) {
    const size_t targets = pass.draw().colorTargets.size();
    std::vector<std::array<std::string, 4>> components(targets, {"0.0", "0.0", "0.0", "0.0"});
    const auto put = [&](uint32_t field, const std::string& value) {
        components.at(field & 0xFF).at(field >> 8 & 0xFF) = value;
    };
    for (uint32_t channel = 0; channel < ChannelCount; ++channel)
        if (const uint32_t field = pass.constants[AGAA_FIELD_DIFFUSE_R + channel]; field >> 16)
            put(field, format("agaa_blendedValue(v.%s, count, %uu, %uu, %s)", channelMembers[channel],
                              plan.view.samples, field >> 16 & 0xFF, field >> 24 & 1 ? "true" : "false"));
    put(pass.constants[AGAA_FIELD_COVERAGE], "agaa_blendedMask(mask, 0u)");
    for (uint32_t part = 1; part < plan.view.samples / 8; ++part)
        put(uint32_t(targets - 1) | (part - 1) << 8, format("agaa_blendedMask(mask, %uu)", part));
    std::string out = "void agaa_blend(agaa_Stored v, uint count, uint mask) {\n";
    for (size_t i = 0; i < targets; ++i)
        out += format("    agaa_out%zu = vec4(%s, %s, %s, %s);\n", i, components[i][0].c_str(),
                      components[i][1].c_str(), components[i][2].c_str(), components[i][3].c_str());
    return out + "}\n";
}

std::string lightingDefines(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    if (dialect.constants != AGAA_GL_CONSTANTS_BLOCK)
        fail(AGAA_ERROR_UNSUPPORTED,
             format("\"%s\", which shades in the host's shaders, needs AGAA_GL_CONSTANTS_BLOCK.",
                    plan.view.config.technique));
    std::string out;
    const Constants& c = pass.constants;
    define(out, "AGAA_BRDF", c[AGAA_BRDF]);
    define(out, "AGAA_NDF", c[AGAA_NDF]);
    define(out, "AGAA_FILTER_DIFFUSE", c[AGAA_FILTER_DIFFUSE]);
    define(out, "AGAA_SHADOW_FILTER", c[AGAA_SHADOW_FILTER]);
    define(out, "AGAA_LIGHT_DIRECTIONS", c[AGAA_LIGHT_DIRECTIONS]);
    define(out, "AGAA_HAS_SPECULAR", c[AGAA_HAS_SPECULAR]);
    define(out, "AGAA_HAS_AMBIENT", c[AGAA_HAS_AMBIENT]);
    define(out, "AGAA_SHADOW_MAPS", c[AGAA_SHADOW_MAPS]);
    define(out, "AGAA_SHADING_COST", c[AGAA_SHADING_COST]);
    define(out, "AGAA_LIGHT_WORDS", 0);
    defineSwitch(out, "AGAA_SHADOWS", plan.view.facts.shadowMapCount > 0);
    if (!dialect.storageImages)
        return out;
    // If there are no storage blocks, lights are in a uniform block. OpenGL guarantees this size only.
    constexpr uint64_t maxBlockBytes = 16384;
    if (lightBufferBytes(plan.view.facts.maxLights) > maxBlockBytes)
        fail(AGAA_ERROR_UNSUPPORTED,
             format("forward shading without storage blocks takes %u lights; AgaaSceneFacts::maxLights is "
                    "%u.",
                    uint32_t((maxBlockBytes - lightBufferBytes(1)) / sizeof(GpuLight) + 1), plan.view.facts.maxLights));
    out += "#define AGAA_LIGHT_BLOCK layout(std140, AGAA_BINDING_LIGHTS) uniform\n";
    defineSwitch(out, "AGAA_LIGHT_COUNT", std::max(plan.view.facts.maxLights, 1u));
    return out;
}

// Returns whether the pass writes the classes of samples beside their normals.
bool writesClasses(const Plan& plan, const Pass& pass) {
    const std::vector<ResourceId>& targets = pass.draw().colorTargets;
    return pass.draw().id == AGAA_DRAW_PASS_VISIBILITY && pass.draw().sampleContent == SampleContent::Normal &&
           !targets.empty() && plan.resources[targets[0]].format == Format::RGBA8;
}

bool needsMaterial(const Plan& plan, const Pass& pass) {
    if (pass.draw().id == AGAA_DRAW_PASS_FRAGMENTS)
        return pass.draw().fragmentContent != FragmentContent::Ids;
    return pass.draw().id != AGAA_DRAW_PASS_VISIBILITY || writesClasses(plan, pass);
}

// Returns the macros of passes that pack attributes (aggregate/packing.glsl).
std::string packing(const Constants& c) {
    std::string out;
    define(out, "AGAA_MAX_WORDS", c[AGAA_WORDS]);
    define(out, "AGAA_UNFILTERED_WORDS", c[AGAA_UNFILTERED_WORDS]);
    define(out, "AGAA_CLASS_WORD", c[AGAA_CLASS_WORD]);
    define(out, "AGAA_FOLDED_ROUGHNESS", c[AGAA_FOLDED_ROUGHNESS]);
    define(out, "AGAA_YCBCR_SPECULAR", c[AGAA_YCBCR_SPECULAR]);
    return out;
}

// Returns the macros of facts that the pass reads. Facts that it does not read do not change its key.
std::string facts(const Pass& pass) {
    const Constants& c = pass.constants;
    const uint64_t ofLights = AGAA_FACT_NO_LOCAL_LIGHTS;
    const uint64_t read = c[AGAA_CHECK_FACTS]                        ? ~UINT64_C(0)
                          : pass.draw().id == AGAA_DRAW_PASS_FORWARD ? commonValues
                                                                     : commonValues & ~ofLights;
    const auto valueIf = [&](uint64_t fact, Constant value) {
        return c[AGAA_CHECK_FACTS] || c[AGAA_FACTS] & fact ? c[value] : 0u;
    };
    std::string out;
    define(out, "AGAA_FACTS", uint32_t(c[AGAA_FACTS] & read));
    define(out, "AGAA_ONE_ALPHA2", valueIf(AGAA_FACT_ONE_ROUGHNESS, AGAA_ONE_ALPHA2));
    define(out, "AGAA_ONE_SPECULAR", valueIf(AGAA_FACT_ONE_SPECULAR, AGAA_ONE_SPECULAR));
    defineSwitch(out, "AGAA_CHECK_FACTS", c[AGAA_CHECK_FACTS]);
    return out;
}

// Returns the text of the host that shades in the forward pass.
std::string shadingText(const ViewSettings& view) {
    if (!view.shadingFunction)
        return {};
    const std::string& text = view.shadingFunction->glsl;
    if (expressionDepth(text) > maxExpressionDepth)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("AgaaShadingFunction::glsl is nested more than %zu levels deep.", maxExpressionDepth));
    return "#line 1\n" + text + "\n";
}

// Frames have the positions of the view's samples only. OpenGL does not guarantee these; they place cut-outs.
std::string ownSamplePositions(const Plan& plan, const Pass& pass) {
    if (pass.draw().state.samples == plan.view.hwSamples)
        return {};
    std::string list;
    for (const SamplePosition& at : standardPositions(pass.draw().state.samples))
        list += format("%svec2(%s, %s)", list.empty() ? "" : ", ", glslNumber(at.x).c_str(), glslNumber(at.y).c_str());
    return "#define AGAA_OWN_SAMPLE_POSITIONS " + list + "\n";
}

std::string defines(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    std::string out;
    const Constants& c = pass.constants;
    defineSwitch(out, "AGAA_STORAGE_IMAGES", dialect.storageImages);
    defineSwitch(out, "AGAA_FRAME_CONSTANTS", dialect.constants);
    if (dialect.constants == AGAA_GL_CONSTANTS_UNIFORMS)
        defineSwitch(out, "AGAA_CONSTANT_VECTORS", constantVectors(plan));
    // Helper invocations never store anything. The macro only saves work.
    out += dialect.glslVersion >= 450 ? "#define AGAA_HELPER gl_HelperInvocation\n" : "#define AGAA_HELPER false\n";
    defineSwitch(out, "AGAA_PASS", pass.draw().id);
    defineSwitch(out, "AGAA_NEEDS_MATERIAL", needsMaterial(plan, pass));
    defineSwitch(out, "AGAA_SAMPLES", plan.view.samples);
    defineSwitch(out, "AGAA_HW_SAMPLES", pass.draw().state.samples);
    out += ownSamplePositions(plan, pass);
    define(out, "AGAA_SCALE_X", plan.view.scaleX);
    define(out, "AGAA_SCALE_Y", plan.view.scaleY);
    for (const auto& [name, constant] :
         {std::pair{"AGAA_LAYERS", AGAA_LAYERS}, {"AGAA_LAYER_X", AGAA_LAYER_X}, {"AGAA_LAYER_Y", AGAA_LAYER_Y}})
        define(out, name, c[constant]);
    defineSwitch(out, "AGAA_COUNTING", c[AGAA_COUNTERS]);
    define(out, "AGAA_EMISSIVE_CHANNELS", c[AGAA_EMISSIVE_CHANNELS]);
    out += "#define AGAA_EMISSIVE_RANGE " + glslNumber(plan.view.layout.emissiveRange()) + "\n";
    defineSwitch(out, "AGAA_FAR_DEPTH", c[AGAA_FAR_DEPTH]);
    out += facts(pass);
    defineSwitch(out, "AGAA_SHOWS_FACTS", c[AGAA_DEBUG_VIEW] == AGAA_DEBUG_VIEW_FACTS);
    if (pass.draw().id == AGAA_DRAW_PASS_AGGREGATE) {
        out += format("#define AGAA_TARGET_TEXTURE %s\n", plan.view.hwSamples > 1 ? "sampler2DMS" : "sampler2D");
        defineSwitch(out, "AGAA_AGGREGATES", std::max(plan.view.aggregates, 1u));
        defineSwitch(out, "AGAA_PER_SAMPLE", pass.draw().state.sampleShading);
        defineSwitch(out, "AGAA_POST_DEPTH_COVERAGE",
                     std::ranges::count(pass.draw().extensions, "ARB_post_depth_coverage") != 0);
        defineSwitch(out, "AGAA_FIRST_SAMPLE_ROUTING",
                     (plan.view.measurement.flags & AGAA_MEASURE_FIRST_SAMPLE_ROUTING) != 0);
        defineSwitch(out, "AGAA_WORDS", c[AGAA_WORDS]);
        defineSwitch(out, "AGAA_STRIDE", c[AGAA_STRIDE]);
        defineSwitch(out, "AGAA_SPREAD_WORDS", c[AGAA_SPREAD_WORDS]);
        defineSwitch(out, "AGAA_DEPTH_WORDS", c[AGAA_DEPTH_WORDS]);
        defineSwitch(out, "AGAA_REPRESENTED",
                     c[AGAA_STRIDE] != c[AGAA_WORDS] + c[AGAA_SPREAD_WORDS] + c[AGAA_DEPTH_WORDS]);
        const auto isNormals = [](const Binding& binding) { return binding.slot == host_slot::Normals; };
        defineSwitch(out, "AGAA_CHECKS_FAR_PLANE", std::any_of(pass.bindings.begin(), pass.bindings.end(), isNormals));
        define(out, "AGAA_FIELD_COVERAGE", c[AGAA_FIELD_COVERAGE]);
        out += packing(c);
        const std::array<uint32_t, 4>& masks = dialect.colorSampleMasks;
        if (blendsAggregates(pass))
            out += format("#define AGAA_ROUTES uvec4(%uu, %uu, %uu, %uu)\n", masks[0], masks[1], masks[2], masks[3]);
    }
    const bool hasCorners = pass.draw().id == AGAA_DRAW_PASS_FRAGMENTS;
    defineSwitch(out, "AGAA_HAS_CORNERS", hasCorners);
    if (hasCorners) {
        defineSwitch(out, "AGAA_CLIP_Z_FROM_MINUS_ONE", plan.view.clipZFromMinusOne);
        define(out, "AGAA_PAYLOAD_WORDS", plan.payloadWords);
        defineSwitch(out, "AGAA_TABLE_SIZE", c[AGAA_TABLE_SIZE]);
        defineSwitch(out, "AGAA_HAS_BATCHES", plan.view.coverage.maxBatches > 1);
        defineSwitch(out, "AGAA_DRAW_ORDER", (plan.view.coverage.flags & AGAA_COVERAGE_DRAW_ORDER) != 0);
        defineSwitch(out, "AGAA_HAS_DEPTH_PREPASS", (plan.view.coverage.flags & AGAA_COVERAGE_DEPTH_PREPASS) != 0);
    }
    if (hasCorners && needsMaterial(plan, pass)) {
        defineSwitch(out, "AGAA_WORDS", c[AGAA_WORDS]);
        define(out, "AGAA_HAS_SPECULAR", c[AGAA_HAS_SPECULAR]);
        define(out, "AGAA_NDF", c[AGAA_NDF]);
        defineSwitch(out, "AGAA_SPREAD_WORDS", c[AGAA_SPREAD_WORDS]);
        out += packing(c);
    }
    if (mergesInOrder(pass)) {
        defineSwitch(out, "AGAA_IN_TARGETS", mergesInTargets(pass));
        define(out, "AGAA_AGGREGATES", plan.view.aggregates);
        define(out, "AGAA_STRIDE", c[AGAA_STRIDE]);
        define(out, "AGAA_MERGE_RULE", c[AGAA_MERGE_RULE]);
        define(out, "AGAA_UNFILTERED_CHANNELS", c[AGAA_UNFILTERED_CHANNELS]);
        define(out, "AGAA_CLASS_CHANNEL", c[AGAA_CLASS_CHANNEL]);
    }
    defineSwitch(out, "AGAA_FIRST_PASS", pass.draw().clearsDepth);
    if (pass.draw().id == AGAA_DRAW_PASS_GBUFFER)
        define(out, "AGAA_SOURCE_NORMAL_X", c[AGAA_SOURCE_NORMAL_X]);
    out += customGlsl(plan.view.layout);
    const bool writesIds = pass.draw().sampleContent == SampleContent::Id;
    defineSwitch(out, "AGAA_WRITES_IDS", writesIds);
    if (writesIds || (hasCorners && plan.view.maxDraws)) {
        defineSwitch(out, "AGAA_SOME_UNFETCHED", plan.view.someUnfetched);
        define(out, "AGAA_MAX_DRAWS", plan.view.maxDraws);
        define(out, "AGAA_MAX_PRIMITIVES", plan.view.maxPrimitives);
        define(out, "AGAA_PRIMITIVE_BITS", plan.view.primitiveBits);
    }
    if (pass.draw().id == AGAA_DRAW_PASS_VISIBILITY) {
        defineSwitch(out, "AGAA_WRITES_NORMALS", !pass.draw().colorTargets.empty() && !writesIds);
        defineSwitch(out, "AGAA_WRITES_CLASSES", writesClasses(plan, pass));
        if (writesClasses(plan, pass))
            define(out, "AGAA_CLASS_CHANNEL", c[AGAA_CLASS_CHANNEL]);
    }
    if (pass.draw().id == AGAA_DRAW_PASS_FORWARD)
        out += lightingDefines(plan, pass, dialect) + shadingFunctionGlsl(plan.view);
    return out;
}

} // namespace

std::string hostExtensions(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    std::string out;
    if (pass.draw().id == AGAA_DRAW_PASS_FORWARD && plan.view.shadingFunction &&
        !plan.view.shadingFunction->extensions.empty())
        out = plan.view.shadingFunction->extensions + "\n";
    const auto extension = [&](const char* name) { out += format("#extension GL_%s : require\n", name); };
    // Older versions need extensions.
    if (dialect.glslVersion < 400) {
        extension("ARB_gpu_shader5");
        extension("ARB_sample_shading");
    }
    if (dialect.glslVersion < 410) // for locations between stages
        extension("ARB_separate_shader_objects");
    if (dialect.glslVersion < 420) {
        extension("ARB_shading_language_420pack");
        extension("ARB_shader_image_load_store");
    }
    if (dialect.glslVersion < 430 && !dialect.storageImages)
        extension("ARB_shader_storage_buffer_object");
    for (const std::string& name : pass.draw().extensions)
        extension(name.c_str());
    if (dialect.openGl && pass.draw().state.readsAttachments)
        extension("EXT_shader_framebuffer_fetch");
    return out;
}

std::string hostDeclarations(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    std::set<std::string> seen;
    std::string out = "#ifndef AGAA_ALPHA_MASKED\n#define AGAA_ALPHA_MASKED 0\n#endif\n";
    out += defines(plan, pass, dialect) + bindingDefines(dialect) + outputs(pass, dialect);
    for (const char* path :
         {"common/frame.glsl", "math/sanitise.glsl", "math/alpha_coverage.glsl", "math/encoding.glsl", "math/ndf.glsl",
          "math/depth.glsl", "math/metadata.glsl", "math/sbaa_records.glsl", "common/stored.glsl",
          "common/scene_facts.glsl", "host/surface.glsl", "host/counters.glsl", "host/placement.glsl"})
        appendGlsl(out, path, seen);
    if (!pass.draw().text.empty())
        return out + pass.draw().text;
    switch (pass.draw().id) {
    case AGAA_DRAW_PASS_VISIBILITY:
        appendGlsl(out, "host/ids.glsl", seen);
        appendGlsl(out, "host/visibility.glsl", seen);
        break;
    case AGAA_DRAW_PASS_FRAGMENTS:
        appendGlsl(out, "host/ids.glsl", seen);
        if (needsMaterial(plan, pass)) {
            out += fields(pass.constants);
            appendGlsl(out, "host/fragment_payload.glsl", seen);
        }
        if (mergesInTargets(pass))
            out += fetchedTargets(pass, dialect);
        appendGlsl(out, mergesInOrder(pass) ? "host/merge_in_order.glsl" : "host/fragments.glsl", seen);
        break;
    case AGAA_DRAW_PASS_GBUFFER:
        out += storeAttachments(pass);
        appendGlsl(out, "host/gbuffer.glsl", seen);
        break;
    case AGAA_DRAW_PASS_FORWARD:
        appendGlsl(out, "host/far_plane.glsl", seen);
        appendGlsl(out, "host/forward.glsl", seen, shadingText(plan.view));
        break;
    case AGAA_DRAW_PASS_AGGREGATE:
        appendGlsl(out, "host/far_plane.glsl", seen);
        if (blendsAggregates(pass)) {
            for (const char* path :
                 {"aggregate/aggregate_input.glsl", "math/blended_sums.glsl", "host/visible_samples.glsl"})
                appendGlsl(out, path, seen);
            out += blendAttachments(plan, pass);
            appendGlsl(out, "host/blend_aggregate.glsl", seen);
            break;
        }
        out += fields(pass.constants);
        appendGlsl(out, "aggregate/packing.glsl", seen);
        appendGlsl(out, "host/accumulate_aggregate.glsl", seen);
        break;
    default:
        fail(AGAA_ERROR_INTERNAL, "a draw pass of unknown kind.");
    }
    return out;
}

static std::string expansion(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    if (pass.draw().expansionText.empty())
        return {};
    std::set<std::string> seen;
    std::string out = defines(plan, pass, dialect) + bindingDefines(dialect);
    appendGlsl(out, "common/frame.glsl", seen);
    appendGlslText(out, pass.draw().expansionText, seen);
    return out;
}

static bool expandsInVertexShader(const Pass& pass) {
    return pass.draw().state.vertexPulling || pass.draw().state.multicast;
}

std::string hostGeometry(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    return expandsInVertexShader(pass) ? std::string() : expansion(plan, pass, dialect);
}

std::string hostVertex(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    return expandsInVertexShader(pass) ? expansion(plan, pass, dialect) : std::string();
}

uint64_t hostPassKey(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    // The key is FNV-1a over all inputs of the host's shaders and pipelines.
    uint64_t key = 1469598103934665603ull;
    const auto mix = [&](const void* data, size_t size) {
        for (size_t i = 0; i < size; ++i)
            key = (key ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211ull;
    };
    const auto mixValue = [&](auto value) { mix(&value, sizeof value); };
    mixValue(uint32_t(pass.draw().id));
    mix(&pass.draw().state, sizeof pass.draw().state);
    const std::string text =
        hostExtensions(plan, pass, dialect) + hostDeclarations(plan, pass, dialect) + expansion(plan, pass, dialect);
    mix(text.data(), text.size());
    for (ResourceId target : pass.draw().colorTargets)
        mixValue(uint32_t(plan.resources[target].format));
    mixValue(pass.draw().depthTarget != noResource ? uint32_t(plan.resources[pass.draw().depthTarget].format) : 0u);
    return key;
}

static HostPass makeHostPass(const Plan& plan, const Pass& pass, const HostDialect& dialect) {
    HostDialect anySet = dialect;
    anySet.descriptorSet = 0; // the set number belongs to the host's pipeline layout, not to the key
    HostPass out;
    out.pipelineKey = hostPassKey(plan, pass, anySet);
    out.extensions = hostExtensions(plan, pass, dialect);
    out.declarations = hostDeclarations(plan, pass, dialect);
    out.geometry = hostGeometry(plan, pass, dialect);
    out.vertex = hostVertex(plan, pass, dialect);
    out.colors = colorAttachments(plan, pass);
    if (pass.draw().id == AGAA_DRAW_PASS_FORWARD && plan.view.shadingFunction) {
        out.functionOrigin = "AgaaShadingFunction::glsl";
        out.functionCheck = format("#version %u\n", dialect.glslVersion) + out.extensions + out.declarations +
                            "void main() { agaa_emit(agaa_surfaceInput()); }\n";
    }
    if (pass.draw().depthTarget != noResource)
        out.depthFormat = plan.resources[pass.draw().depthTarget].format;
    return out;
}

std::vector<HostPass> makeHostPasses(const Plan& plan, const HostDialect& dialect) {
    std::vector<HostPass> list(plan.passes.size());
    for (size_t i = 0; i < list.size(); ++i)
        if (plan.passes[i].kind() == PassKind::HostDraw)
            list[i] = makeHostPass(plan, plan.passes[i], dialect);
    return list;
}

} // namespace agaa
