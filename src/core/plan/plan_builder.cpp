#include "core/plan/plan_builder.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/plan/access.h"
#include "core/plan/gpu_layout.h"
#include "core/view/custom_glsl.h"
#include "core/view/lanes.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>
#include <array>
#include <bit>

namespace agaa {

PlanBuilder::PlanBuilder(ResolvedView view, const AgaaDeviceCaps& caps, uint32_t framesInFlight)
    : caps_(caps), constants_(constantsOf(view)), framesInFlight_(framesInFlight) {
    shadowMaps_.fill(noResource);
    frames_.fill(noResource);
    plan.view = std::move(view);
    plan.notes = std::move(plan.view.notes);
    plan.runnable = !plan.view.isModel();
    plan.aliases = !(caps.flags & AGAA_DEVICE_NO_ALIASING) && !(plan.view.config.flags & AGAA_CONFIG_READBACK);
    lights_ = add({.name = "lights",
                   .kind = ResourceKind::UploadBuffer,
                   .content = UploadContent::Lights,
                   .format = Format::Buffer,
                   .bytes = lightBufferBytes(plan.view.facts.maxLights),
                   .copies = framesInFlight});
    if (counts()) {
        counters_ = add({.name = "counters",
                         .kind = ResourceKind::SmallBuffer,
                         .format = Format::Buffer,
                         .bytes = sizeof(CounterBuffer)});
        fill("clear counters", AGAA_STAGE_OTHER, counters_, AGAA_SEGMENT_PREPASS).fill().stampOffset =
            offsetof(CounterBuffer, stamp);
    }
}

void setFields(Constants& constants, Constant first, const Fields& fields) {
    static_assert(uint32_t(AGAA_SOURCE_DIFFUSE_R) == uint32_t(AGAA_FIELD_DIFFUSE_R) + uint32_t(ChannelCount),
                  "ranges of constants.inc");
    for (uint32_t i = 0; i < ChannelCount; ++i)
        constants[first + i] = fields[i].constant();
}

ResourceId PlanBuilder::add(Resource resource) {
    plan.resources.push_back(std::move(resource));
    return ResourceId(plan.resources.size() - 1);
}

ResourceId PlanBuilder::image(std::string name, Format format, bool atTargetRate) {
    Resource r;
    r.name = std::move(name);
    r.format = format;
    r.width = atTargetRate ? scaledWidth() : plan.view.width;
    r.height = atTargetRate ? scaledHeight() : plan.view.height;
    r.samples = atTargetRate ? plan.view.hwSamples : 1;
    r.bytes = checkedMultiply(checkedMultiply(uint64_t(r.width) * r.height, r.samples), bytesPerTexel(format));
    return add(std::move(r));
}

ResourceId PlanBuilder::multisampledImage(std::string name, Format format, uint32_t samples) {
    const ResourceId id = image(std::move(name), format, false);
    plan.resources[id].samples = samples;
    plan.resources[id].bytes = checkedMultiply(plan.resources[id].bytes, samples);
    return id;
}

ResourceId PlanBuilder::layeredImage(std::string name, Format format, uint32_t layers) {
    const ResourceId id = image(std::move(name), format, false);
    plan.resources[id].layers = layers;
    plan.resources[id].bytes = checkedMultiply(plan.resources[id].bytes, layers);
    return id;
}

ResourceId PlanBuilder::squareImage(std::string name, Format format, uint32_t side) {
    return add({.name = std::move(name),
                .kind = ResourceKind::Image,
                .format = format,
                .width = side,
                .height = side,
                .bytes = uint64_t(side) * side * bytesPerTexel(format),
                .hasFixedSize = true});
}

ResourceId PlanBuilder::pixelBuffer(std::string name, uint64_t bytesPerPixel) {
    Resource r;
    r.name = std::move(name);
    r.kind = ResourceKind::Buffer;
    r.format = Format::Buffer;
    r.width = plan.view.width;
    r.height = plan.view.height;
    r.bytes = checkedMultiply(uint64_t(plan.view.width) * plan.view.height, bytesPerPixel);
    return add(std::move(r));
}

ResourceId PlanBuilder::depth(bool needsStencil, uint32_t samples) {
    const bool d24 = caps_.flags & AGAA_DEVICE_D24S8;
    const bool d32s8 = caps_.flags & AGAA_DEVICE_D32S8;
    if (plan.view.reversedZ) {
        plan.depthFormat = needsStencil && d32s8 ? Format::D32S8 : Format::D32;
        note(format("depth: %s, 4 bytes%s, because reversed z wants a float format.", formatName(plan.depthFormat),
                    plan.depthFormat == Format::D32S8 ? " and 1 for stencil" : ""));
    } else if (d24) {
        plan.depthFormat = Format::D24S8;
        note("depth: D24_UNORM_S8_UINT, 4 bytes with stencil.");
    } else {
        plan.depthFormat = needsStencil && d32s8 ? Format::D32S8 : Format::D32;
        note(format("depth: %s, because the device has no D24_UNORM_S8_UINT.", formatName(plan.depthFormat)));
    }
    if (samples)
        return multisampledImage("depth", plan.depthFormat, samples);
    return sceneDepth = image("depth", plan.depthFormat, true);
}

Pass& PlanBuilder::hostDraw(std::string name, AgaaStage stage, AgaaDrawPassId drawPass, uint64_t segment) {
    require(!plan.view.hostGBuffer, AGAA_ERROR_UNSUPPORTED,
            "AgaaGBufferFunction is for techniques that shade a G-buffer; this one draws.");
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    pass.segment = segment;
    auto& draw = pass.part.emplace<DrawPart>();
    draw.id = drawPass;
    draw.state.samples = plan.view.hwSamples;
    draw.state.colorWriteMask = 0xF;
    draw.state.sampleLocations = plan.view.placesSamples;
    if (plan.view.visibilityTier == AGAA_TIER_NV_MULTICAST) {
        draw.state.multicast = plan.view.layers;
        draw.extensions.push_back("NV_viewport_array2");
        draw.expansionText =
            format("void agaa_multicast() { gl_ViewportMask[0] = 0x%X; }\n", (1u << plan.view.layers) - 1);
    }
    draw.clear.depth = plan.view.reversedZ ? 0.0f : 1.0f;
    draw.width = scaledWidth();
    draw.height = scaledHeight();
    pass.constants = constants_;
    plan.passes.push_back(std::move(pass));
    bind(plan.passes.back(), host_slot::Frame, BindingType::UniformBuffer, frameConstants(segment));
    return plan.passes.back();
}

bool PlanBuilder::isSwitchedOn(Switch which) const {
    switch (which) {
    case Switch::Multisampled:
        return plan.view.hwSamples > 1 && visibleSamples == noResource;
    case Switch::Expanded:
        return visibleSamples != noResource;
    case Switch::Shadows:
        return plan.view.variantFacts.shadowMapCount > 0;
    case Switch::Counting:
        return counts();
    case Switch::Composite:
        return plan.view.composite;
    case Switch::MultipleAggregates:
        return plan.view.aggregates > 1;
    case Switch::FromGBuffer:
        return plan.view.readsGBuffer();
    case Switch::Lit:
        return variantLitShadows() != 0;
    case Switch::SampleLanes:
        return hasSampleLanes(plan.view.lanes);
    case Switch::Subgroups:
        return plan.view.lanes == AGAA_LANES_SAMPLE_SUBGROUP;
    case Switch::Classified:
    case Switch::Represented:
    case Switch::InTargets:
    case Switch::SharedSurfaces:
    case Switch::Motion:
        break; // the caller of compute() sets them
    }
    return false;
}

Pass& PlanBuilder::compute(std::string name, AgaaStage stage, const std::string& shader, uint64_t segment,
                           std::initializer_list<SwitchSetting> switches) {
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    auto& program = pass.part.emplace<ComputePart>();
    program.file = passFile(shader);
    program.shader = shader + "_";
    for (const Switch which : passSwitches(shader)) {
        const auto set = std::ranges::find(switches, which, &SwitchSetting::which);
        const bool isOn = set == switches.end() ? isSwitchedOn(which) : set->isOn;
        program.shader += switchLetter(which);
        program.shader += isOn ? '1' : '0';
        program.defines += format("#define %s %d\n", switchMacro(which), isOn);
        program.fullSubgroups |= which == Switch::Subgroups && isOn;
    }
    pass.segment = segment;
    pass.constants = constants_;
    plan.passes.push_back(std::move(pass));
    return plan.passes.back();
}

Pass& PlanBuilder::fill(std::string name, AgaaStage stage, ResourceId destination, uint64_t segment, uint32_t value) {
    Pass pass;
    pass.name = std::move(name);
    pass.stage = stage;
    pass.segment = segment;
    pass.part = FillPart{.destination = destination, .value = value};
    plan.passes.push_back(std::move(pass));
    return plan.passes.back();
}

ResourceId PlanBuilder::tileBuffer(std::string name, uint32_t side, uint64_t bytesPerTile) {
    const auto tiles = [&](uint32_t pixels) { return (uint64_t(pixels) + side - 1) / side; };
    return itemBuffer(std::move(name), checkedMultiply(tiles(plan.view.width), tiles(plan.view.height)), bytesPerTile);
}

ResourceId PlanBuilder::itemBuffer(std::string name, uint64_t items, uint64_t bytesPerItem) {
    return add({.name = std::move(name),
                .kind = ResourceKind::Buffer,
                .format = Format::Buffer,
                .width = plan.view.width,
                .height = plan.view.height,
                .bytes = checkedMultiply(items, bytesPerItem)});
}

uint32_t PlanBuilder::scaledWidth() const {
    return uint32_t(std::min<uint64_t>(uint64_t(plan.view.width) * plan.view.scaleX, ~0u));
}
uint32_t PlanBuilder::scaledHeight() const {
    return uint32_t(std::min<uint64_t>(uint64_t(plan.view.height) * plan.view.scaleY * plan.view.layers, ~0u));
}

ResourceId PlanBuilder::deferredPixels() { return tileBuffer("deferred-pixels", 8, 8); }

// Each workgroup covers side x side tiles of 8x8 pixels.
static void setRegionSide(Pass& pass, uint32_t side) {
    pass.compute().dispatch.groupSide = 8 * side;
    pass.compute().defines += format("#define AGAA_REGION_SIDE %uu\n", side);
}

void PlanBuilder::deferPixels(Pass& pass, ResourceId deferred) {
    bind(pass, slot::Deferred, BindingType::StorageBuffer, deferred, true);
    setRegionSide(pass, 2);
}

// Software rasterisers of Mesa end all loops of an invocation after 65535 iterations in total. With many samples a
// workgroup covers fewer pixels, which are enough to keep its lanes busy.
void PlanBuilder::consumeDeferred(Pass& pass, ResourceId deferred) {
    bind(pass, slot::Deferred, BindingType::StorageBuffer, deferred);
    setRegionSide(pass, plan.view.samples > 8 ? 1 : 2);
}

void PlanBuilder::bind(Pass& pass, uint32_t slot, BindingType type, ResourceId resource, bool writes) {
    const bool isTaken =
        std::any_of(pass.bindings.begin(), pass.bindings.end(), [&](const Binding& b) { return b.slot == slot; });
    if (isTaken)
        fail(AGAA_ERROR_INTERNAL, format("pass \"%s\" binds two resources to slot %u.", pass.name.c_str(), slot));
    pass.bindings.push_back({slot, type, resource, writes});
}

// Each segment has a buffer. A later segment brings other values (ambient, background) while an earlier one may still
// run.
ResourceId PlanBuilder::frameConstants(uint64_t segment) {
    const char* const names[] = {"frame-constants-prepass", "frame-constants-generation", "frame-constants-shading"};
    const size_t index = size_t(std::countr_zero(segment));
    if (frames_[index] == noResource)
        frames_[index] = add({.name = names[index],
                              .kind = ResourceKind::UploadBuffer,
                              .content = UploadContent::FrameConstants,
                              .format = Format::Buffer,
                              .bytes = sizeof(FrameConstants),
                              .copies = framesInFlight_});
    return frames_[index];
}

void PlanBuilder::bindCommon(Pass& pass) {
    const bool host = pass.kind() == PassKind::HostDraw;
    if (!host)
        bind(pass, slot::Frame, BindingType::UniformBuffer, frameConstants(pass.segment));
    if (counts())
        bind(pass, host ? uint32_t(host_slot::Counters) : uint32_t(slot::Counters), BindingType::StorageBuffer,
             counters_, true);
}

// Each text starts at line 1, so that messages of compilers refer to the host's lines.
void PlanBuilder::addHostCode(Pass& pass, const HostText& text, const char* origin) {
    ComputePart& program = pass.compute();
    program.hostCode += "#line 1\n" + text.glsl + "\n";
    program.hostCodeOrigin += (program.hostCodeOrigin.empty() ? "" : " with ") + std::string(origin) + "::glsl";
    if (text.extensions.empty())
        return;
    program.hostCodeExtensions += "#line 1\n" + text.extensions + "\n#line 100000\n";
    program.hostCodeOrigin += " and ::glslExtensions";
}

void PlanBuilder::bindHostGBuffer(Pass& pass) {
    addHostCode(pass, plan.view.gbufferFunction, "AgaaGBufferFunction");
    pass.compute().defines += "#define AGAA_HOST_GBUFFER 1\n" + customGlsl(plan.view.layout);
}

// GPUs hide the latency of fetches by workgroups that share their memory. Lists are short there: one primitive per lane
// at most. The limit is computed, not measured.
uint32_t PlanBuilder::listLength() const {
    // Bytes of shared memory by the rules of std430, besides the list.
    constexpr uint32_t otherBytes = 8704;
    // A listed primitive has 28 bytes and its material: 92 bytes and the custom attributes.
    uint64_t material = 92;
    for (const CustomAttribute& custom : plan.view.layout.customs) {
        const uint32_t channels = custom.attribute.channels;
        material = alignUp(material, channels == 1 ? 4 : channels == 2 ? 8 : 16) + 4 * channels;
    }
    const auto listed = uint32_t(28 + alignUp(material, 16));
    const uint32_t unlisted = otherBytes + laneBytes(plan.view.lanes, plan.view.samples);
    const uint32_t maxListed = (std::max(caps_.maxSharedBytes, unlisted) - unlisted) / listed;
    return std::clamp(maxListed / 32 * 32, 32u, caps_.flags & AGAA_DEVICE_SOFTWARE ? 256u : 64u);
}

void PlanBuilder::bindHostFetch(Pass& pass) {
    addHostCode(pass, plan.view.fetchFunction, "AgaaFetchFunction");
    pass.compute().defines += format("#define AGAA_HOST_FETCH 1\n#define AGAA_PRIMITIVE_BITS %uu\n"
                                     "#define AGAA_CLIP_Z_FROM_MINUS_ONE %d\n#define AGAA_LIST_LENGTH %uu\n",
                                     plan.view.primitiveBits, plan.view.clipZFromMinusOne, listLength());
    pass.compute().defines += customGlsl(plan.view.layout);
    if (plan.view.someUnfetched)
        pass.compute().defines += "#define AGAA_SOME_UNFETCHED 1\n";
    if (plan.view.maxTriangles)
        pass.compute().defines += "#define AGAA_EXPANDS_TRIANGLES 1\n";
}

ResourceId PlanBuilder::output() {
    if (output_ == noResource)
        output_ =
            add({.name = "output", .kind = ResourceKind::Output, .width = plan.view.width, .height = plan.view.height});
    return output_;
}

ResourceId PlanBuilder::resolvedOutput(uint32_t index) {
    return add({.name = format("resolved-output-%u", index),
                .kind = ResourceKind::Output,
                .width = plan.view.width,
                .height = plan.view.height,
                .hostSlot = index + 1});
}

ResourceId PlanBuilder::techniqueImage() {
    if (!plan.view.accumulates())
        return output();
    if (image_ == noResource)
        image_ = image("frame", Format::RGBA16F, false);
    return image_;
}

void PlanBuilder::bindOutput(Pass& pass, ResourceId image) {
    bind(pass, slot::Output, BindingType::StorageImage, image == noResource ? techniqueImage() : image, true);
    if (plan.view.composite)
        bind(pass, slot::Background, BindingType::Texture, output());
}

CopyPart& PlanBuilder::copy(const std::string& name, ResourceId source, ResourceId destination, uint64_t segment) {
    Pass pass;
    pass.name = name;
    pass.segment = segment;
    pass.part = CopyPart{.source = source, .destination = destination};
    plan.passes.push_back(std::move(pass));
    return std::get<CopyPart>(plan.passes.back().part);
}

void PlanBuilder::readListCounts(ResourceId lists) {
    constexpr uint64_t bytes = 4 * AGAA_LIST_HEADS;
    plan.listCounts = add({.name = "list-counts",
                           .kind = ResourceKind::ReadbackBuffer,
                           .format = Format::Buffer,
                           .bytes = bytes,
                           .copies = framesInFlight_});
    copy("read list counts", lists, plan.listCounts, plan.passes.back().segment).bytes = bytes;
}

void PlanBuilder::copyCounters() {
    if (!counts()) {
        stampFrame();
        return;
    }
    const ResourceId readback = add({.name = "counters-readback",
                                     .kind = ResourceKind::ReadbackBuffer,
                                     .format = Format::Buffer,
                                     .bytes = sizeof(CounterBuffer),
                                     .copies = framesInFlight_});
    copy("read counters", counters_, readback, AGAA_SEGMENT_SHADING);
    plan.stamps = readback;
    plan.stampOffset = offsetof(CounterBuffer, stamp);
}

// Marks executed frames in plans without counters.
void PlanBuilder::stampFrame() {
    const bool isTimed = plan.view.config.flags & AGAA_CONFIG_TIMESTAMPS;
    if (!isTimed && plan.listCounts == noResource && std::ranges::none_of(plan.resources, &Resource::isPersistent))
        return;
    plan.stamps = add({.name = "frame-stamp",
                       .kind = ResourceKind::ReadbackBuffer,
                       .format = Format::Buffer,
                       .bytes = sizeof(uint32_t),
                       .copies = framesInFlight_});
    fill("stamp frame", AGAA_STAGE_OTHER, plan.stamps, AGAA_SEGMENT_SHADING).fill().stampOffset = 0;
}

void PlanBuilder::addBreadcrumbs() {
    if (plan.view.config.flags & AGAA_CONFIG_BREADCRUMBS)
        plan.breadcrumbs = add({.name = "breadcrumbs",
                                .kind = ResourceKind::ReadbackBuffer,
                                .format = Format::Buffer,
                                .bytes = sizeof(BreadcrumbBuffer)});
}

void PlanBuilder::findLifetimes() {
    for (Resource& resource : plan.resources) {
        resource.firstPass = ~0u;
        resource.lastPass = 0;
    }
    for (uint32_t i = 0; i < plan.passes.size(); ++i) {
        const auto use = [&](ResourceId id) {
            Resource& resource = plan.resources[id];
            resource.firstPass = std::min(resource.firstPass, i);
            resource.lastPass = std::max(resource.lastPass, i);
            resource.segments |= plan.passes[i].segment;
        };
        for (const Access& access : accessesOf(plan.passes[i]))
            use(access.resource);
    }
    for (Resource& resource : plan.resources)
        if (resource.firstPass == ~0u) { // a surface of a model, which no pass uses
            resource.firstPass = 0;
            resource.lastPass = plan.passes.empty() ? 0 : uint32_t(plan.passes.size() - 1);
        }
    keepAlive();
}

// Extends lifetimes. A resource of a repeated range lives as long as the range, and a persistent one always.
void PlanBuilder::keepAlive() {
    for (Resource& resource : plan.resources) {
        if (resource.isImported()) // executors acquire and release imported resources at their first and last use
            continue;
        for (const Repeat& repeat : plan.repeats)
            if (resource.firstPass <= repeat.lastPass && resource.lastPass >= repeat.firstPass) {
                resource.firstPass = std::min(resource.firstPass, repeat.firstPass);
                resource.lastPass = std::max(resource.lastPass, repeat.lastPass);
            }
        if (resource.isPersistent) {
            resource.firstPass = 0;
            resource.lastPass = uint32_t(plan.passes.size() - 1);
        }
    }
}

void PlanBuilder::checkLimits() const {
    // Statistics have an entry for each pass.
    if (plan.passes.size() > AGAA_MAX_PASSES)
        fail(AGAA_ERROR_INTERNAL, format("the plan has %zu passes; AgaaFrameStatistics::passes holds %d.",
                                         plan.passes.size(), AGAA_MAX_PASSES));
    // This also limits targets and outputs of the host, which are not resources of the plan.
    const uint64_t width = uint64_t(plan.view.width) * plan.view.scaleX,
                   height = uint64_t(plan.view.height) * plan.view.scaleY * plan.view.layers;
    if (std::max(width, height) > caps_.maxImageSize)
        fail(AGAA_ERROR_TOO_LARGE,
             format(
                 "the target would be %llux%llu texels; the device allows %u. Ask for fewer samples or a smaller view.",
                 static_cast<unsigned long long>(width), static_cast<unsigned long long>(height), caps_.maxImageSize));
    for (const Resource& r : plan.resources) {
        if (r.kind == ResourceKind::Image && (r.width > caps_.maxImageSize || r.height > caps_.maxImageSize))
            fail(AGAA_ERROR_TOO_LARGE,
                 format("%s would be %ux%u texels; the device allows %u. Ask for fewer samples or a "
                        "smaller view.",
                        r.name.c_str(), r.width, r.height, caps_.maxImageSize));
        if (r.kind == ResourceKind::Buffer && r.bytes > caps_.maxStorageRange)
            fail(AGAA_ERROR_TOO_LARGE,
                 format("%s would take %llu bytes; the device allows %llu in one storage buffer. Ask "
                        "for fewer samples or aggregates, or a smaller view.",
                        r.name.c_str(), static_cast<unsigned long long>(r.bytes),
                        static_cast<unsigned long long>(caps_.maxStorageRange)));
    }
    plan.totalBytes(); // throws Error if the sum overflows
}

// Passes know whether they write the host's output, in which the frame has a place.
void PlanBuilder::placeOutput() {
    for (Pass& pass : plan.passes)
        if (pass.kind() == PassKind::Compute)
            pass.constants[AGAA_PLACES_OUTPUT] = std::ranges::any_of(pass.bindings, [&](const Binding& binding) {
                return binding.writes && plan.resources[binding.resource].kind == ResourceKind::Output;
            });
}

Plan PlanBuilder::finish() {
    placeOutput();
    specialiseForVariant();
    findLifetimes();
    checkLimits();
    checkRepeats(plan);
    return std::move(plan);
}

} // namespace agaa
