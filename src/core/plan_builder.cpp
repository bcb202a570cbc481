#include "core/plan_builder.h"

#include "core/checked.h"
#include "core/gpu_layout.h"
#include "core/validate.h"

#include <algorithm>
#include <array>
#include <bit>

namespace agaa {

PlanBuilder::PlanBuilder(const AgaaViewDesc& view, const AgaaDeviceCaps& caps,
                         uint32_t framesInFlight)
    : caps_(caps), framesInFlight_(framesInFlight) {
    plan.width = view.width;
    plan.height = view.height;
    plan.reversedZ = view.flags & AGAA_VIEW_REVERSED_Z;
    plan.composite = view.flags & AGAA_VIEW_COMPOSITE;
    plan.clipZFromMinusOne = view.flags & AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE;
    plan.aliases = !(caps.flags & AGAA_DEVICE_NO_ALIASING);
    plan.config = checkConfig(view.config);
    plan.aliases = plan.aliases && !(plan.config.flags & AGAA_CONFIG_READBACK);
    plan.facts = checkFacts(view.facts);
    readFunctions(view);
    plan.layout = reduceLayout(checkLayout(plan.config.layout), plan.facts.flags);
    plan.config.layout = nullptr; // the host's pointer does not outlive the call
    const Technique& technique = *findTechnique(plan.config.technique);
    plan.config.technique = technique.name; // static storage
    plan.technique = technique.name;
    if (!technique.multisampled)
        plan.config.samples = 1;
    plan.samples = plan.config.samples;
    if (technique.maxAggregates && plan.config.aggregates > technique.maxAggregates)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("AgaaConfig::aggregates is %u; \"%s\" takes %u at most.",
                                             plan.config.aggregates, technique.name,
                                             technique.maxAggregates));
    plan.aggregates =
        technique.maxAggregates ? std::min(plan.config.aggregates, plan.samples) : 0;
    dropUncalledFor(technique);
    chooseVisibilityTier();
    if (technique.maxAggregates)
        chooseGenerationTier(technique);
    checkTierOptions(technique);
    require(!counts() || caps_.flags & AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_ERROR_UNSUPPORTED,
            "AGAA_CONFIG_COUNTERS needs atomics in fragment shaders, which the device has not.");
    setConstants();
    frame_ = add({.name = "frame-constants",
                  .kind = ResourceKind::UploadBuffer,
                  .content = UploadContent::FrameConstants,
                  .format = Format::Buffer,
                  .bytes = sizeof(FrameConstants),
                  .copies = framesInFlight});
    lights_ = add({.name = "lights",
                   .kind = ResourceKind::UploadBuffer,
                   .content = UploadContent::Lights,
                   .format = Format::Buffer,
                   .bytes = lightBufferBytes(plan.facts.maxLights),
                   .copies = framesInFlight});
    if (counts()) {
        counters_ = add({.name = "counters",
                         .kind = ResourceKind::SmallBuffer,
                         .format = Format::Buffer,
                         .bytes = sizeof(CounterBuffer)});
        fill("clear counters", AGAA_STAGE_OTHER, counters_, AGAA_SEGMENT_PREPASS);
    }
}

// Functions of one view find their resources in the same set.
void PlanBuilder::takeSetLayout(uint64_t setLayout) {
    require(!setLayout || !plan.functionSetLayout || setLayout == plan.functionSetLayout,
            AGAA_ERROR_INVALID_ARGUMENT,
            "functions of the view have different set layouts; all find their resources in set 1.");
    if (setLayout)
        plan.functionSetLayout = setLayout;
}

void PlanBuilder::readFunctions(const AgaaViewDesc& view) {
    if (const AgaaShadowFunction* function = checkShadowFunction(view)) {
        plan.functionShadows = function->shadows;
        takeSetLayout(function->descriptorSetLayout);
        shadowFunction_ = function->glsl;
    }
    if (const AgaaGBufferFunction* function = checkGBufferFunction(view)) {
        takeSetLayout(function->descriptorSetLayout);
        plan.hostGBuffer = true;
        plan.depthBits = function->depthBits;
        if (const float* positions = function->samplePositions)
            plan.samplePositions.assign(positions, positions + 2 * plan.config.samples);
        gbufferFunction_ = function->glsl;
    }
    if (const AgaaFetchFunction* function = checkFetchFunction(view)) {
        require(!plan.hostGBuffer, AGAA_ERROR_INVALID_ARGUMENT,
                "the view has an AgaaGBufferFunction and an AgaaFetchFunction; materials come by one of them.");
        takeSetLayout(function->descriptorSetLayout);
        plan.maxDraws = function->maxDraws;
        plan.maxPrimitives = function->maxPrimitives;
        plan.someUnfetched = function->flags & AGAA_FETCH_NOT_ALL_DRAWS;
        plan.primitiveBits = uint32_t(std::bit_width(function->maxPrimitives - 1));
        fetchFunction_ = function->glsl;
    }
}

void PlanBuilder::chooseGenerationTier(const Technique& technique) {
    if (plan.hostGBuffer) {
        require(plan.config.generationTier == AGAA_TIER_AUTO || plan.config.generationTier == AGAA_TIER_GBUFFER,
                AGAA_ERROR_UNSUPPORTED,
                "generation cannot run: a G-buffer that the host draws leaves only the tier gbuffer.");
        plan.generationTier = AGAA_TIER_GBUFFER;
        note("generation: the host's multisampled G-buffer is aggregated by a compute pass.");
        return;
    }
    const uint32_t forced = plan.config.generationTier;
    const bool takesIds = technique.groupsSamples && plan.maxDraws > 0;
    require(!takesIds || !plan.someUnfetched || !hasFact(AGAA_FACT_CUSTOM_DEPTH), AGAA_ERROR_UNSUPPORTED,
            "materials that write depth or discard on their own (AGAA_FACT_CUSTOM_DEPTH) cannot be drawn a second time "
            "at equal depth, which AGAA_FETCH_NOT_ALL_DRAWS asks for.");
    if (forced == AGAA_TIER_IDS && !takesIds)
        fail(AGAA_ERROR_UNSUPPORTED, format("generation cannot run: %s.",
                                            technique.groupsSamples ? "the tier ids needs an AgaaFetchFunction"
                                                                    : "the tier ids is for \"agaa\""));
    if (takesIds && (forced == AGAA_TIER_IDS || forced == AGAA_TIER_AUTO)) {
        plan.generationTier = AGAA_TIER_IDS;
        note(plan.someUnfetched
                 ? "generation: materials are fetched by the ids that the first geometry pass leaves; draws that "
                   "cannot be fetched are drawn again, into a multisampled G-buffer."
                 : "generation: materials are fetched by the ids that the only geometry pass leaves.");
        return;
    }
    if (technique.groupsSamples && forced == AGAA_TIER_AUTO &&
        (plan.config.litShadows || plan.config.glossWeight > 0)) {
        plan.generationTier = AGAA_TIER_GBUFFER;
        note("generation: lit shadows and the weight of gloss want materials where samples are grouped, so that a "
             "multisampled G-buffer is aggregated by a compute pass.");
        return;
    }
    const GenerationChoice choice =
        chooseGeneration(caps_, plan.hwSamples, forced, hasFact(AGAA_FACT_CUSTOM_DEPTH));
    if (choice.tier == AGAA_TIER_AUTO)
        fail(AGAA_ERROR_UNSUPPORTED, "generation cannot run: " + choice.reason);
    plan.generationTier = choice.tier;
    plan.runnable = plan.runnable && choice.runnable;
    note("generation: " + choice.reason);
}

// What neither the scene nor the technique calls for.
void PlanBuilder::dropUncalledFor(const Technique& technique) {
    AgaaConfig& config = plan.config;
    if (!technique.groupsSamples) { // settings of "agaa" may stay where another is measured
        config.litShadows = 0;
        config.glossWeight = 0;
        config.flags &= ~AGAA_CONFIG_BUFFERED;
    }
    const uint32_t lit = config.litShadows & ((1u << plan.facts.shadowMapCount) - 1);
    if (lit != config.litShadows)
        note("lit aggregates: AgaaConfig::litShadows names shadows that AgaaSceneFacts does not declare; they are "
             "left out.");
    config.litShadows = lit;
}

// After the tier is known.
void PlanBuilder::checkTierOptions(const Technique& technique) const {
    const AgaaConfig& config = plan.config;
    const bool knowsMaterials = plan.generationTier == AGAA_TIER_IDS || plan.generationTier == AGAA_TIER_GBUFFER;
    const bool buffered = config.flags & AGAA_CONFIG_BUFFERED;
    require(config.glossWeight == 0 || knowsMaterials, AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::glossWeight needs the tier ids or gbuffer, which know materials when they group samples.");
    require(config.litShadows == 0 || (knowsMaterials && !buffered), AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::litShadows needs the tier ids or gbuffer without AGAA_CONFIG_BUFFERED, which know materials "
            "and shadows in one pass.");
    const uint32_t view = config.debugView;
    const bool ofAggregates = view == AGAA_DEBUG_VIEW_AGGREGATES || view == AGAA_DEBUG_VIEW_CLUSTERS ||
                              view == AGAA_DEBUG_VIEW_WIDENED;
    require(!ofAggregates || technique.maxAggregates, AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::debugView shows aggregates, of which this technique makes none.");
    require(view != AGAA_DEBUG_VIEW_WIDENED || !plan.layout.foldsRoughness(), AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::debugView shows widened lobes, which a layout with folded roughness cannot tell.");
    require(view != AGAA_DEBUG_VIEW_PRIMITIVES || (plan.generationTier == AGAA_TIER_IDS && !buffered),
            AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::debugView shows primitives, which only the tier ids without AGAA_CONFIG_BUFFERED counts.");
}

void PlanBuilder::chooseVisibilityTier() {
    if (!plan.samplePositions.empty()) {
        plan.visibilityTier = AGAA_TIER_NATIVE;
        plan.hwSamples = plan.samples;
        note("visibility: the host says where the samples of its G-buffer lie.");
        return;
    }
    const VisibilityChoice choice =
        chooseVisibility(caps_, plan.samples, plan.config.visibilityTier);
    if (choice.tier == AGAA_TIER_AUTO)
        fail(AGAA_ERROR_UNSUPPORTED, "visibility cannot run: " + choice.reason);
    plan.visibilityTier = choice.tier;
    plan.hwSamples = choice.hwSamples;
    plan.scaleX = choice.scaleX;
    plan.scaleY = choice.scaleY;
    note("visibility: " + choice.reason);
}

void setFields(Constants& constants, Constant first, const Fields& fields) {
    static_assert(AGAA_FIELD_EMISSIVE_B - AGAA_FIELD_DIFFUSE_R + 1 == ChannelCount);
    static_assert(AGAA_SOURCE_EMISSIVE_B - AGAA_SOURCE_DIFFUSE_R + 1 == ChannelCount);
    for (uint32_t i = 0; i < ChannelCount; ++i)
        constants[first + i] = fields[i].constant();
}

void PlanBuilder::setConstants() {
    const AgaaConfig& config = plan.config;
    Constants& c = constants_;
    c[AGAA_SAMPLES] = plan.samples;
    c[AGAA_HW_SAMPLES] = plan.hwSamples;
    c[AGAA_SCALE_X] = plan.scaleX;
    c[AGAA_SCALE_Y] = plan.scaleY;
    c[AGAA_AGGREGATES] = std::max(plan.aggregates, 1u);
    c[AGAA_BRDF] = config.brdf;
    c[AGAA_NDF] = config.ndf;
    c[AGAA_FILTER_DIFFUSE] = !(config.flags & AGAA_CONFIG_NO_DIFFUSE_FILTER);
    c[AGAA_SHADOW_MAPS] = plan.facts.shadowMapCount;
    // Eight taps at n = 8 are every sample of the pixel, so that visibility is exact; at higher n
    // eight of an aggregate's samples still span it.
    c[AGAA_SHADOW_TAPS] = config.shadowTaps ? config.shadowTaps : 8;
    c[AGAA_SHADOW_FILTER] = config.flags & AGAA_CONFIG_NO_SHADOW_FILTER      ? 0
                            : config.flags & AGAA_CONFIG_SHADOW_ALONG_DEPTH ? 2
                                                                            : 1;
    c[AGAA_COUNTERS] = counts();
    c[AGAA_SEEDS] = config.seeds;
    c[AGAA_EMISSIVE_CHANNELS] = plan.layout[AGAA_SEMANTIC_EMISSIVE].channels;
    c[AGAA_HAS_SPECULAR] = plan.layout.has(AGAA_SEMANTIC_SPECULAR);
    c[AGAA_HAS_AMBIENT] = hasFact(AGAA_FACT_AMBIENT);
    c[AGAA_SHADING_COST] = config.shadingCost;
    c[AGAA_GLOSS_WEIGHT] = config.glossWeight > 0 ? std::bit_cast<uint32_t>(config.glossWeight) : 0; // not -0
    c[AGAA_LIT_SHADOWS] = config.litShadows;
    c[AGAA_DEBUG_VIEW] = config.debugView;
    c[AGAA_GENERATION_TIER] = plan.generationTier;
}

ResourceId PlanBuilder::add(Resource resource) {
    plan.resources.push_back(std::move(resource));
    return ResourceId(plan.resources.size() - 1);
}

ResourceId PlanBuilder::image(std::string name, Format format, bool atTargetRate) {
    Resource r;
    r.name = std::move(name);
    r.format = format;
    r.width = atTargetRate ? uint32_t(std::min<uint64_t>(uint64_t(plan.width) * plan.scaleX, ~0u))
                           : plan.width;
    r.height = atTargetRate
                   ? uint32_t(std::min<uint64_t>(uint64_t(plan.height) * plan.scaleY, ~0u))
                   : plan.height;
    r.samples = atTargetRate ? plan.hwSamples : 1;
    r.bytes = checkedMultiply(checkedMultiply(uint64_t(r.width) * r.height, r.samples),
                              bytesPerTexel(format));
    return add(std::move(r));
}

ResourceId PlanBuilder::modelSurface(std::string name, Format format, uint32_t samples) {
    const ResourceId id = image(std::move(name), format, false);
    plan.resources[id].samples = samples;
    plan.resources[id].bytes = checkedMultiply(plan.resources[id].bytes, samples);
    return id;
}

ResourceId PlanBuilder::pixelBuffer(std::string name, uint64_t bytesPerPixel) {
    Resource r;
    r.name = std::move(name);
    r.kind = ResourceKind::Buffer;
    r.format = Format::Buffer;
    r.width = plan.width;
    r.height = plan.height;
    r.bytes = checkedMultiply(uint64_t(plan.width) * plan.height, bytesPerPixel);
    return add(std::move(r));
}

ResourceId PlanBuilder::depth(bool needsStencil) {
    const bool d24 = caps_.flags & AGAA_DEVICE_D24S8;
    const bool d32s8 = caps_.flags & AGAA_DEVICE_D32S8;
    if (plan.reversedZ) {
        plan.depthFormat = needsStencil && d32s8 ? Format::D32S8 : Format::D32;
        note(format("depth: %s, 4 bytes%s, because reversed z wants a float format.",
                    formatName(plan.depthFormat),
                    plan.depthFormat == Format::D32S8 ? " and 1 for stencil" : ""));
    } else if (d24) {
        plan.depthFormat = Format::D24S8;
        note("depth: D24_UNORM_S8_UINT, 4 bytes with stencil.");
    } else {
        plan.depthFormat = needsStencil && d32s8 ? Format::D32S8 : Format::D32;
        note(format("depth: %s, because the device has no D24_UNORM_S8_UINT.",
                    formatName(plan.depthFormat)));
    }
    plan.depthBits = plan.depthFormat == Format::D24S8 ? 24 : 0;
    return image("depth", plan.depthFormat, true);
}

Pass& PlanBuilder::hostDraw(std::string name, AgaaStage stage, AgaaDrawPassId drawPass,
                            uint64_t segment) {
    require(!plan.hostGBuffer, AGAA_ERROR_UNSUPPORTED,
            "AgaaGBufferFunction is for techniques that shade a G-buffer; this one draws.");
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    pass.kind = PassKind::HostDraw;
    pass.segment = segment;
    pass.drawPass = drawPass;
    pass.drawState.samples = plan.hwSamples;
    pass.drawState.colorWriteMask = 0xF;
    pass.constants = constants_;
    plan.passes.push_back(std::move(pass));
    bind(plan.passes.back(), host_slot::Frame, BindingType::UniformBuffer, frame_);
    return plan.passes.back();
}

// What a pass is compiled for, by letter in the names of permutations; see src/CMakeLists.txt.
struct Switch {
    char letter;
    const char* define;
    bool on;
};

Pass& PlanBuilder::compute(std::string name, AgaaStage stage, const std::string& shader,
                           const char* permutation, uint64_t segment) {
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    pass.file = "passes/" + shader + ".comp";
    pass.shader = shader + "_";
    const Switch switches[] = {{'m', "AGAA_MULTISAMPLED", plan.hwSamples > 1},
                               {'s', "AGAA_SHADOWS", plan.facts.shadowMapCount > 0},
                               {'c', "AGAA_COUNTING", counts()},
                               {'b', "AGAA_COMPOSITE", plan.composite},
                               {'a', "AGAA_SEVERAL", plan.aggregates > 1},
                               {'g', "AGAA_FROM_GBUFFER", plan.generationTier == AGAA_TIER_GBUFFER},
                               {'x', "AGAA_CLASSIFIED", false},
                               {'l', "AGAA_LIT", plan.config.litShadows != 0},
                               {'r', "AGAA_REPRESENTED", false}};
    for (const char* letter = permutation; *letter; ++letter) {
        const Switch& s = *std::find_if(std::begin(switches), std::end(switches),
                                        [&](const Switch& each) { return each.letter == *letter; });
        bool on = s.on;
        if (letter[1] == '0' || letter[1] == '1')
            on = *++letter == '1';
        pass.shader += s.letter;
        pass.shader += on ? '1' : '0';
        pass.defines += format("#define %s %d\n", s.define, on);
    }
    pass.segment = segment;
    pass.constants = constants_;
    plan.passes.push_back(std::move(pass));
    return plan.passes.back();
}

Pass& PlanBuilder::fill(std::string name, AgaaStage stage, ResourceId destination,
                        uint64_t segment) {
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    pass.kind = PassKind::Fill;
    pass.segment = segment;
    pass.destination = destination;
    plan.passes.push_back(std::move(pass));
    return plan.passes.back();
}

void PlanBuilder::bind(Pass& pass, uint32_t slot, BindingType type, ResourceId resource,
                       bool writes) {
    pass.bindings.push_back({slot, type, resource, writes});
}

void PlanBuilder::defaultSurface(float cosine, float distance, float material) {
    const auto set = [](float& value, float otherwise) { value = value > 0 ? value : otherwise; };
    set(plan.config.surfaceCosine, cosine);
    set(plan.config.surfaceDistance, distance);
    set(plan.config.surfaceMaterial, material);
}

void PlanBuilder::bindCommon(Pass& pass) {
    const bool host = pass.kind == PassKind::HostDraw;
    if (!host)
        bind(pass, slot::Frame, BindingType::UniformBuffer, frame_);
    if (counts())
        bind(pass, host ? uint32_t(host_slot::Counters) : uint32_t(slot::Counters),
             BindingType::StorageBuffer, counters_, true);
}

// Compilers count the lines of each text by themselves.
void PlanBuilder::addHostCode(Pass& pass, const std::string& text, const char* origin) {
    pass.hostCode += "#line 1\n" + text + "\n";
    pass.hostCodeOrigin += (pass.hostCodeOrigin.empty() ? "" : " with ") + std::string(origin);
}

void PlanBuilder::bindHostGBuffer(Pass& pass) {
    addHostCode(pass, gbufferFunction_, "AgaaGBufferFunction::glsl");
    pass.defines += "#define AGAA_HOST_GBUFFER 1\n";
}

void PlanBuilder::bindHostFetch(Pass& pass) {
    addHostCode(pass, fetchFunction_, "AgaaFetchFunction::glsl");
    // What a listed primitive takes of shared memory, and what else does.
    constexpr uint32_t listed = 80, others = 8192;
    const uint32_t room = (std::max(caps_.maxSharedBytes, others) - others) / listed;
    pass.defines += format("#define AGAA_HOST_FETCH 1\n#define AGAA_PRIMITIVE_BITS %uu\n"
                           "#define AGAA_CLIP_Z_FROM_MINUS_ONE %d\n#define AGAA_LIST_LENGTH %uu\n",
                           plan.primitiveBits, plan.clipZFromMinusOne, std::clamp(room / 32 * 32, 32u, 256u));
    if (plan.someUnfetched)
        pass.defines += "#define AGAA_SOME_UNFETCHED 1\n";
}

ResourceId PlanBuilder::output() {
    if (output_ == noResource)
        output_ = add({.name = "output", .kind = ResourceKind::Output, .width = plan.width,
                       .height = plan.height});
    return output_;
}

void PlanBuilder::bindOutput(Pass& pass, ResourceId image) {
    bind(pass, slot::Output, BindingType::StorageImage, image == noResource ? output() : image, true);
    if (plan.composite)
        bind(pass, slot::Below, BindingType::Texture, output());
}

void PlanBuilder::bindLighting(Pass& pass) {
    const bool host = pass.kind == PassKind::HostDraw;
    require(!host || plan.config.debugView == AGAA_DEBUG_VIEW_NONE, AGAA_ERROR_UNSUPPORTED,
            "AgaaConfig::debugView is for techniques that shade in the SDK's passes; this one shades in the host's.");
    bind(pass, host ? uint32_t(host_slot::Lights) : uint32_t(slot::Lights), BindingType::StorageBuffer,
         lights_);
    bindShadows(pass);
    listEffects();
}

// The shader names all four maps; slots without one of their own repeat another and are not read.
void PlanBuilder::bindShadows(Pass& pass) {
    std::array<ResourceId, AGAA_MAX_SHADOW_MAPS> maps;
    ResourceId any = noResource;
    maps.fill(noResource);
    for (uint32_t i = 0; i < plan.facts.shadowMapCount; ++i)
        if (!(plan.functionShadows >> i & 1))
            any = maps[i] =
                add({.name = format("shadow-map-%u", i), .kind = ResourceKind::ShadowMap, .hostSlot = i});
    const bool host = pass.kind == PassKind::HostDraw;
    const uint32_t first = host ? uint32_t(host_slot::Shadow0) : uint32_t(slot::Shadow0);
    for (uint32_t i = 0; any != noResource && i < AGAA_MAX_SHADOW_MAPS; ++i)
        bind(pass, first + i, BindingType::ShadowTexture, maps[i] != noResource ? maps[i] : any);
    if (!plan.functionShadows)
        return;
    require(!host, AGAA_ERROR_UNSUPPORTED,
            "AgaaShadowFunction is for techniques that shade in the SDK's passes; this one shades in the "
            "host's.");
    addHostCode(pass, shadowFunction_, "AgaaShadowFunction::glsl");
    pass.defines += format("#define AGAA_HOST_SHADOWS %uu\n#define AGAA_SHADOW_TEXTURES %d\n",
                           plan.functionShadows, any != noResource);
}

void PlanBuilder::listEffects() {
    if (plan.layout.has(AGAA_SEMANTIC_SPECULAR))
        effect("specular");
    if (plan.layout.has(AGAA_SEMANTIC_EMISSIVE))
        effect("emissive");
    if (hasFact(AGAA_FACT_AMBIENT))
        effect("ambient");
    if (hasFact(AGAA_FACT_ALPHA_MASKED))
        effect("alpha-mask");
    if (plan.facts.shadowMapCount)
        effect("shadows");
    if (plan.functionShadows)
        effect("shadow-function");
    if (plan.aggregates) {
        if (plan.facts.shadowMapCount && constants_[AGAA_SHADOW_FILTER])
            effect("shadow-filter");
        if (plan.config.litShadows)
            effect("lit-aggregates");
        if (constants_[AGAA_FILTER_DIFFUSE])
            effect("filtered-diffuse");
        if (constants_[AGAA_NDF] && plan.layout.has(AGAA_SEMANTIC_SPECULAR))
            effect("ndf-widening");
    }
}

void PlanBuilder::copyCounters() {
    if (!counts())
        return;
    const ResourceId readback = add({.name = "counters-readback",
                                     .kind = ResourceKind::ReadbackBuffer,
                                     .format = Format::Buffer,
                                     .bytes = sizeof(CounterBuffer),
                                     .copies = framesInFlight_});
    Pass pass;
    pass.name = "read counters";
    pass.kind = PassKind::Copy;
    pass.segment = AGAA_SEGMENT_SHADING;
    pass.source = counters_;
    pass.destination = readback;
    plan.passes.push_back(std::move(pass));
}

void PlanBuilder::findLifetimes() {
    for (Resource& resource : plan.resources) {
        resource.firstPass = ~0u;
        resource.lastPass = 0;
    }
    for (uint32_t i = 0; i < plan.passes.size(); ++i) {
        const auto use = [&](ResourceId id) {
            if (id == noResource)
                return;
            Resource& resource = plan.resources[id];
            resource.firstPass = std::min(resource.firstPass, i);
            resource.lastPass = std::max(resource.lastPass, i);
        };
        const Pass& pass = plan.passes[i];
        for (const Binding& binding : pass.bindings)
            use(binding.resource);
        for (ResourceId target : pass.colorTargets)
            use(target);
        use(pass.depthTarget);
        use(pass.source);
        use(pass.destination);
    }
    for (Resource& resource : plan.resources)
        if (resource.firstPass == ~0u) { // a model's surface that no pass of ours names
            resource.firstPass = 0;
            resource.lastPass = plan.passes.empty() ? 0 : uint32_t(plan.passes.size() - 1);
        }
}

void PlanBuilder::checkLimits() const {
    for (const Resource& r : plan.resources) {
        if (r.kind == ResourceKind::Image &&
            (r.width > caps_.maxImageSize || r.height > caps_.maxImageSize))
            fail(AGAA_ERROR_TOO_LARGE,
                 format("%s would be %ux%u texels; the device allows %u. Ask for fewer samples or a "
                        "smaller view.",
                        r.name.c_str(), r.width, r.height, caps_.maxImageSize));
        if (r.kind == ResourceKind::Buffer && r.bytes > caps_.maxStorageRange)
            fail(AGAA_ERROR_TOO_LARGE,
                 format("%s would take %llu bytes; the device allows %llu in one storage buffer. Ask "
                        "for fewer aggregates or a smaller view.",
                        r.name.c_str(), static_cast<unsigned long long>(r.bytes),
                        static_cast<unsigned long long>(caps_.maxStorageRange)));
    }
    plan.totalBytes(); // throws where the sum overflows
}

Plan PlanBuilder::finish() {
    findLifetimes();
    checkLimits();
    return std::move(plan);
}

} // namespace agaa
