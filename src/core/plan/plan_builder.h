// The interface with which technique files add resources and passes to a plan. Sizes are checked for overflow.
#pragma once

#include "core/plan/bindings.h"
#include "core/plan/permutations.h"
#include "core/plan/plan.h"
#include "core/view/resolved_view.h"

#include <functional>
#include <initializer_list>

namespace agaa {

class PlanBuilder {
public:
    PlanBuilder(ResolvedView view, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

    Plan finish(); // computes lifetimes and checks limits

    const ResolvedView& view() const { return plan.view; }
    const AgaaDeviceCaps& caps() const { return caps_; }
    bool counts() const { return plan.view.hasCounters(); }
    bool hasFact(uint64_t fact) const { return plan.view.facts.flags & fact; }
    // Plans that draw twice keep the first of equal depths by a stencil test, if the depth format has a stencil.
    bool wantsStencil() const { return !(plan.view.measurement.flags & AGAA_MEASURE_NO_STENCIL); }
    bool keepsFirst() const { return wantsStencil() && hasStencil(plan.depthFormat); }

    // Adds an image with one texel per pixel, or with atTargetRate at the size and samples of the target.
    ResourceId image(std::string name, Format format, bool atTargetRate);
    // Adds an image with one texel per pixel in each layer. If a draw has it as target, each layer is an attachment.
    ResourceId layeredImage(std::string name, Format format, uint32_t layers);
    // Adds an image whose size does not depend on the view.
    ResourceId squareImage(std::string name, Format format, uint32_t side);
    ResourceId pixelBuffer(std::string name, uint64_t bytesPerPixel);
    // Adds a buffer with a record for each tile of side x side pixels, row by row.
    ResourceId tileBuffer(std::string name, uint32_t side, uint64_t bytesPerTile);
    // Adds a buffer of a given number of records.
    ResourceId itemBuffer(std::string name, uint64_t items, uint64_t bytesPerItem);
    ResourceId multisampledImage(std::string name, Format format, uint32_t samples);

    // Adds the depth target and chooses its format. needsStencil: the plan tests the stencil. samples: of a texel, by
    // default those of the target.
    ResourceId depth(bool needsStencil, uint32_t samples = 0);

    Pass& hostDraw(std::string name, AgaaStage stage, AgaaDrawPassId drawPass, uint64_t segment);
    // Adds a permutation of the shader. The view determines the switches that the caller does not set.
    Pass& compute(std::string name, AgaaStage stage, const std::string& shader, uint64_t segment,
                  std::initializer_list<SwitchSetting> switches = {});
    // The constants of all passes that are added later.
    Constants& passConstants() { return constants_; }
    // Adds a bit mask of the pixels that one pass defers to a later one (src/shaders/ids/deferred_pixels.glsl).
    ResourceId deferredPixels();
    void deferPixels(Pass& pass, ResourceId deferred);
    void consumeDeferred(Pass& pass, ResourceId deferred);

    // Adds a pass that sets each word of the buffer to the value.
    Pass& fill(std::string name, AgaaStage stage, ResourceId destination, uint64_t segment, uint32_t value = 0);

    void bind(Pass& pass, uint32_t slot, BindingType type, ResourceId resource, bool writes = false);
    ResourceId frameConstants(uint64_t segment);
    // Binds the frame constants and, with AGAA_CONFIG_COUNTERS, the counters.
    void bindCommon(Pass& pass);
    // Adds a pass that lists the lights that reach each tile, for shading passes that are added later. bindDepth binds
    // the depth of samples.
    void cullLights(const std::function<void(Pass&)>& bindDepth);
    // Lets shading passes that are added later, and define AGAA_FINDS_LIGHTS, cull the lights of each tile.
    void cullLightsWhereShaded();
    // Binds lights and the masks of those that reach each tile.
    void bindLights(Pass& pass);
    // Binds lights, shadow maps and the host's shadow function to a pass that shades.
    void bindLighting(Pass& pass);
    // Compiles the pass with the host's function that reads samples of the host's G-buffer.
    void bindHostGBuffer(Pass& pass);
    // Compiles the pass with the host's functions that fetch materials.
    void bindHostFetch(Pass& pass);
    ResourceId output();                       // the host's image
    ResourceId resolvedOutput(uint32_t index); // the host's image for a value of AgaaResolvedOutputs
    // Returns the image that the technique's passes complete: the output, or one that is accumulated.
    ResourceId techniqueImage();
    // Binds the image that agaa_writeOutput() writes, by default techniqueImage(), and with AGAA_VIEW_COMPOSITE the
    // background.
    void bindOutput(Pass& pass, ResourceId image = noResource);
    // Adds the last pass: it lets the CPU read the counters and see that the device executed the frame.
    void copyCounters();
    void addBreadcrumbs();
    CopyPart& copy(const std::string& name, ResourceId source, ResourceId destination, uint64_t segment);
    // Adds Plan::listCounts, in the segment of the last pass.
    void readListCounts(ResourceId lists);
    void effect(const char* name) { plan.effects.emplace_back(name); }
    void note(std::string text) { plan.notes.push_back(std::move(text)); }

    Plan plan;
    // Passes after those of the technique read the depth at the target's rate, and the attachments of a G-buffer that
    // has all draws.
    ResourceId sceneDepth = noResource; // noResource: the technique has none
    // Depths and ids of samples, which compute passes found; noResource: the host's draw wrote images.
    ResourceId visibleSamples = noResource;
    std::vector<ResourceId> sceneAttachments;
    // Binds the materials of samples to a pass that reads them (src/shaders/gbuffer/gbuffer.glsl). Empty: the technique
    // keeps none.
    std::function<void(Pass&)> bindSceneSamples;
    ResourceId resolvedSums = noResource; // of shading events (core/plan/resolved_outputs.h)

private:
    bool isSwitchedOn(Switch which) const;
    bool variantHas(uint64_t fact) const { return plan.view.variantFacts.flags & fact; }
    uint32_t variantLitShadows() const; // among the shadows of the variant
    void stampFrame();
    void placeOutput();
    void specialiseForVariant(); // disables effects that the variant lacks
    uint32_t listLength() const; // primitives that a workgroup processes at a time
    void checkLimits() const;
    static void addHostCode(Pass& pass, const HostText& text, const char* origin);
    void bindShadows(Pass& pass);
    void listEffects(bool readsFolded); // readsFolded: the shading pass reads aggregates with folded roughness
    void findLifetimes();
    void keepAlive();
    uint32_t scaledWidth() const; // of the target
    uint32_t scaledHeight() const;
    ResourceId add(Resource resource);

    AgaaDeviceCaps caps_;
    Constants constants_{};
    std::array<ResourceId, 3> frames_; // frame constants by segment
    ResourceId lights_ = noResource;
    bool cullsLights_ = false;
    ResourceId lightMasks_ = noResource; // of tiles, if a pass culls lights
    ResourceId counters_ = noResource;
    ResourceId output_ = noResource;
    ResourceId image_ = noResource; // if frames are accumulated
    std::array<ResourceId, AGAA_MAX_SHADOW_MAPS> shadowMaps_;
    uint32_t framesInFlight_;
};

// Returns the constants that all passes of a view share.
Constants constantsOf(const ResolvedView& view);

// Writes the fields of a packing as specialisation constants. first: AGAA_FIELD_DIFFUSE_R or AGAA_SOURCE_DIFFUSE_R.
void setFields(Constants& constants, Constant first, const Fields& fields);

} // namespace agaa
