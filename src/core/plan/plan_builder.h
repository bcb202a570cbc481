// What technique files write plans with: resources and passes by name, sizes checked.
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

    Plan finish(); // lifetimes, limits

    const ResolvedView& view() const { return plan.view; }
    const AgaaDeviceCaps& caps() const { return caps_; }
    bool counts() const { return plan.view.hasCounters(); }
    bool hasFact(uint64_t fact) const { return plan.view.facts.flags & fact; }
    // Plans that draw twice keep the first of equal depths by a stencil test, where the depth format has a stencil.
    bool wantsStencil() const { return !(plan.view.measurement.flags & AGAA_MEASURE_NO_STENCIL); }
    bool keepsFirst() const { return wantsStencil() && hasStencil(plan.depthFormat); }

    // One texel a pixel, or with atTargetRate the scaled, multisampled target.
    ResourceId image(std::string name, Format format, bool atTargetRate);
    // One texel a pixel in each layer. As a target of a draw, each layer is an attachment.
    ResourceId layeredImage(std::string name, Format format, uint32_t layers);
    // As many texels for views of any size.
    ResourceId squareImage(std::string name, Format format, uint32_t side);
    ResourceId pixelBuffer(std::string name, uint64_t bytesPerPixel);
    // A record for each tile of side x side pixels, row by row.
    ResourceId tileBuffer(std::string name, uint32_t side, uint64_t bytesPerTile);
    // A pool: as many records as the technique says.
    ResourceId itemBuffer(std::string name, uint64_t items, uint64_t bytesPerItem);
    ResourceId modelSurface(std::string name, Format format, uint32_t samples);

    // The depth target; needsStencil only where the plan tests it.
    ResourceId depth(bool needsStencil);

    Pass& hostDraw(std::string name, AgaaStage stage, AgaaDrawPassId drawPass, uint64_t segment);
    // A permutation of the shader. The plan sets the switches that the caller does not set.
    Pass& compute(std::string name, AgaaStage stage, const std::string& shader, uint64_t segment,
                  std::initializer_list<SwitchSetting> switches = {});
    // Constants of passes that are added later.
    Constants& passConstants() { return constants_; }
    // A bit for every pixel that one pass leaves to another (src/shaders/ids/deferred_pixels.glsl).
    ResourceId deferredPixels();
    void deferPixels(Pass& pass, ResourceId deferred);
    void consumeDeferred(Pass& pass, ResourceId deferred);

    // Each word of the buffer becomes the value.
    Pass& fill(std::string name, AgaaStage stage, ResourceId destination, uint64_t segment, uint32_t value = 0);

    void bind(Pass& pass, uint32_t slot, BindingType type, ResourceId resource,
              bool writes = false);
    ResourceId frameConstants(uint64_t segment);
    // Frame constants and, where counted, counters.
    void bindCommon(Pass& pass);
    // A pass that finds the lights that reach each tile, for passes that shade and are added later. bindDepth: binds the depth
    // of samples.
    void cullLights(const std::function<void(Pass&)>& bindDepth);
    // Lights, shadow maps and the host's shadow function of a pass that shades.
    void bindLighting(Pass& pass);
    // Compiles the pass with the host's function that reads samples of its own G-buffer.
    void bindHostGBuffer(Pass& pass);
    // Compiles the pass with the host's functions that fetch materials.
    void bindHostFetch(Pass& pass);
    ResourceId output(); // the host's image
    // What agaa_writeOutput() writes, and composites over: an image of the plan's, or with none the output.
    void bindOutput(Pass& pass, ResourceId image = noResource);
    void copyCounters();
    void effect(const char* name) { plan.effects.push_back(name); }
    void note(std::string text) { plan.notes.push_back(std::move(text)); }

    Plan plan;

private:
    bool isSwitchedOn(Switch which) const;
    bool variantHas(uint64_t fact) const { return plan.view.variantFacts.flags & fact; }
    uint32_t variantLitShadows() const; // of the shadows that the variant has
    void specialiseForVariant(); // that the variant has not
    uint32_t listLength() const; // of primitives that a group of lanes takes at a time
    void checkLimits() const;
    static void addHostCode(Pass& pass, const HostText& text, const char* origin);
    void bindShadows(Pass& pass);
    void listEffects(bool readsFolded); // whether the shading pass reads aggregates whose roughness is folded
    void findLifetimes();
    void keepAlive();
    uint32_t scaledWidth() const; // of the target
    uint32_t scaledHeight() const;
    ResourceId add(Resource resource);

    AgaaDeviceCaps caps_;
    Constants constants_{};
    std::array<ResourceId, 3> frames_; // frame constants by segment
    ResourceId lights_ = noResource;
    ResourceId lightMasks_ = noResource; // of tiles, where lights are culled
    ResourceId counters_ = noResource;
    ResourceId output_ = noResource;
    std::array<ResourceId, AGAA_MAX_SHADOW_MAPS> shadowMaps_;
    uint32_t framesInFlight_;
};

// Constants that all passes of a view share.
Constants constantsOf(const ResolvedView& view);

// Fields of a packing as specialisation constants from AGAA_FIELD_DIFFUSE_R or AGAA_SOURCE_DIFFUSE_R on.
void setFields(Constants& constants, Constant first, const Fields& fields);

} // namespace agaa
