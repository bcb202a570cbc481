// A plan: the resources and passes of a frame as a value. Executors run it, memory reports sum it, tests read it. It
// does not depend on a graphics API, and executors do not depend on techniques.
#pragma once

#include "agaa_sdk.h"
#include "core/base/format.h"
#include "core/view/resolved_view.h"
#include "shaders/tables/layouts.inc"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace agaa {

// Specialisation constants by name; see src/shaders/tables/constants.inc.
enum Constant : uint32_t {
#define AGAA_CONSTANT(id, name, value) name = id,
#include "shaders/tables/constants.inc"
#undef AGAA_CONSTANT
#define AGAA_CONSTANT(id, name, value) +1
    ConstantCount = 0
#include "shaders/tables/constants.inc"
#undef AGAA_CONSTANT
};
static_assert(
    [] {
        std::array<bool, ConstantCount> used{};
#define AGAA_CONSTANT(id, name, value) used[id] = true;
#include "shaders/tables/constants.inc"
#undef AGAA_CONSTANT
        return std::ranges::all_of(used, [](bool is) { return is; });
    }(),
    "ids count from 0, each once");
using Constants = std::array<uint32_t, ConstantCount>;

using ResourceId = uint32_t;
inline constexpr ResourceId noResource = ~0u;
inline constexpr uint32_t noCounter = ~0u;

enum class ResourceKind {
    Image,          // per pixel, unless it has a fixed size
    Buffer,         // per pixel
    SmallBuffer,    // device local; its size does not depend on the target
    UploadBuffer,   // written by the CPU, one per frame in flight
    ReadbackBuffer, // read by the CPU, one per frame in flight
    Output,         // images of the host that the frame writes
    ShadowMap,      // the host's, sampled with comparison
};

// The data that the executor writes into an upload buffer (src/core/frame/frame_data.h) when it records the segment
// that reads the buffer. Only one segment reads a buffer, because the device may run an earlier segment while the CPU
// writes.
enum class UploadContent { None, FrameConstants, Lights };

struct Resource {
    std::string name;
    ResourceKind kind = ResourceKind::Image;
    UploadContent content = UploadContent::None;
    Format format = Format::None;
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t samples = 1;
    uint32_t layers = 1;
    uint64_t bytes = 0;  // payload of one copy
    uint32_t copies = 1; // frames in flight, for uploads and read-back
    // ShadowMap: index among the frame's shadows. Output: 0 is the image; 1 and more are resolved outputs.
    uint32_t hostSlot = 0;
    uint32_t firstPass = 0; // lifetime, by index into Plan::passes
    uint32_t lastPass = 0;
    uint64_t segments = 0;     // of all passes that use it
    bool hasFixedSize = false; // Image: its size does not depend on the view
    bool isPersistent = false; // Buffer: its contents persist between frames; they are 0 before the first

    bool isPerPixel() const { return !hasFixedSize && (kind == ResourceKind::Image || kind == ResourceKind::Buffer); }
    bool isImported() const { return kind == ResourceKind::Output || kind == ResourceKind::ShadowMap; }
    bool operator==(const Resource&) const = default;
};

// Returns the element for the frame in this slot. copies: one for each frame in flight, or one that all frames share.
template <class Copy> Copy copyOfSlot(const std::vector<Copy>& copies, uint32_t slot) {
    return copies[copies.size() > 1 ? slot : 0];
}

enum class BindingType {
    UniformBuffer,
    StorageBuffer,
    Texture, // fetched by texel
    StorageImage,
    ShadowTexture, // 2D array, compared
};

// The filter of a Texture. It is clamped to the edge and has one level.
enum class Filter { Nearest, Linear };

struct Binding {
    uint32_t slot = 0;
    BindingType type = BindingType::Texture;
    ResourceId resource = noResource;
    bool writes = false;
    Filter filter = Filter::Nearest;
    bool operator==(const Binding&) const = default;
};

// The largest number of attachments of a draw with AgaaDrawState::readsAttachments.
inline constexpr uint32_t maxFetchedTargets = 8;

// The values are the indices of the parts in Pass::part.
enum class PassKind { HostDraw, Compute, Fill, Copy };

// The number of workgroups of a compute pass.
enum class DispatchKind {
    Pixels,   // a group for each square of groupSide pixels
    Items,    // a group for each 64 items, in rows of groupsPerRow: row * groupsPerRow + column is the group
    Indirect, // three words that an earlier pass writes; 0 skips the pass
};
inline constexpr uint32_t itemsPerGroup = AGAA_ITEMS_PER_GROUP, groupsPerRow = AGAA_GROUPS_PER_ROW;

// The pixels of a frame, up to those of the view.
struct FrameExtent {
    uint32_t width = 0, height = 0;
    bool operator==(const FrameExtent&) const = default;
};

struct Dispatch {
    DispatchKind kind = DispatchKind::Pixels;
    uint32_t groupSide = 8; // 8 for a tile, a multiple of 8 for a region of tiles
    uint64_t items = 0;
    ResourceId arguments = noResource;
    uint64_t argumentsOffset = 0; // bytes, a multiple of 4
    bool operator==(const Dispatch&) const = default;
};

// The value that a prepass draw stores per sample.
enum class SampleContent { Normal, Id };

// The storage of fragments of AGAA_DRAW_PASS_FRAGMENTS.
enum class FragmentContent {
    Ids,       // a list for each pixel has their ids
    Materials, // the list has their attributes, too
    Merged,    // fragments are merged in the order of the draws
};

// The values to which a draw clears its targets.
struct ClearValues {
    std::array<std::array<float, 4>, maxAttachments> color{}; // by colour target
    float depth = 1;
    uint32_t stencil = 0;
};

// The part of a pass in which the host draws geometry.
struct DrawPart {
    AgaaDrawPassId id = AGAA_DRAW_PASS_VISIBILITY;
    AgaaDrawState state{};
    SampleContent sampleContent = SampleContent::Normal;
    FragmentContent fragmentContent = FragmentContent::Ids;
    std::vector<ResourceId> colorTargets;
    ResourceId depthTarget = noResource; // may be noResource
    uint32_t width = 0, height = 0;      // of the targets
    bool clearsColor = false;
    bool clearsDepth = false; // and clears the stencil
    ClearValues clear;
    std::vector<std::string> extensions; // GLSL extensions that the host's shaders need
    std::string text;                    // GLSL that defines agaa_emit() in place of the library's
    // GLSL for the host's geometry shader, or with state.vertexPulling or state.multicast for its vertex shader. It
    // reads the frame constants only.
    std::string expansionText;
};

// The part of a compute pass. A group has 64 invocations.
struct ComputePart {
    Dispatch dispatch;
    bool shadesAggregates = false; // from a buffer that an earlier pass wrote
    std::string shader;            // permutation in the library
    std::string file;              // of the shader, below src/shaders
    std::string defines;           // of the permutation
    bool fullSubgroups = false;    // all subgroups of a workgroup have AgaaDeviceCaps::subgroupSize lanes
    std::string text;              // GLSL in place of the library's shader; it is compiled with the view
    // GLSL of the host. If it is not empty, the pass is compiled with it.
    std::string hostCode;
    std::string hostCodeOrigin;     // the public members that hold the text, for messages
    std::string hostCodeExtensions; // lines that precede all other text
};

inline constexpr uint64_t noStamp = ~UINT64_C(0);

// The part of a pass that fills a buffer.
struct FillPart {
    ResourceId destination = noResource;
    uint32_t value = 0; // of each word
    uint64_t bytes = 0; // from the beginning, a multiple of 4; 0: all
    // The byte of the word that receives stampOf() the frame in place of the value, or noStamp. Without `bytes` only.
    uint64_t stampOffset = noStamp;
};

// The part of a pass that copies a buffer.
struct CopyPart {
    ResourceId source = noResource;
    ResourceId destination = noResource;
    uint64_t bytes = 0; // from the beginning; 0: all
};

struct Pass {
    std::string name;
    AgaaStage stage = AGAA_STAGE_OTHER;
    uint64_t segment = AGAA_SEGMENT_SHADING;
    std::vector<Binding> bindings;
    Constants constants{}; // of compute shaders; the host's shaders get some of them as macros
    std::variant<DrawPart, ComputePart, FillPart, CopyPart> part = ComputePart{};

    PassKind kind() const { return PassKind(part.index()); }
    // The part of a pass of that kind. The functions throw std::bad_variant_access for other kinds.
    DrawPart& draw() { return std::get<DrawPart>(part); }
    const DrawPart& draw() const { return std::get<DrawPart>(part); }
    ComputePart& compute() { return std::get<ComputePart>(part); }
    const ComputePart& compute() const { return std::get<ComputePart>(part); }
    FillPart& fill() { return std::get<FillPart>(part); }
    const FillPart& fill() const { return std::get<FillPart>(part); }
    const CopyPart& copy() const { return std::get<CopyPart>(part); }
};

// A range of passes that is repeated. Indirect passes dispatch no groups in iterations without work, which ends a
// repetition early.
struct Repeat {
    uint32_t firstPass = 0, lastPass = 0;
    uint32_t times = 1;
    // A word of this buffer is 0 in iterations with work, and not 0 in all others. Executors that can read it may end
    // the repetition, or run only the last pass of an iteration without work. The word is 0 when the range begins, and
    // after the first iteration only the last pass changes it. The range has only dispatches and draws that do not
    // clear, because nothing else can be skipped. Draws read the word in the first iteration, too, so that one
    // recording serves all iterations.
    ResourceId predicateBuffer = noResource;
    uint64_t predicateOffset = 0; // bytes
};

// One execution of a pass. batch: the iteration of its range, from 0.
struct Step {
    uint32_t pass = 0;
    uint32_t batch = 0;
    bool isFirst = true, isLast = true; // among the steps of the pass
    // The step has no work if this word of a buffer is not 0. The first iteration always has work.
    ResourceId predicateBuffer = noResource;
    uint64_t predicateOffset = 0; // bytes
    bool hasPredicate() const { return predicateBuffer != noResource; }
};

// A frame of a view on a device.
struct Plan {
    ResolvedView view;
    std::vector<std::string> notes;    // why tiers and formats were chosen
    std::vector<std::string> effects;  // effects that the frame uses
    bool aliases = true;               // resources of disjoint lifetimes may share memory
    Format depthFormat = Format::None; // of depths at the target's rate; None if no pass reads them
    std::vector<Resource> resources;
    std::vector<Pass> passes;
    std::vector<Repeat> repeats; // in the order of passes; they do not overlap, and each lies in one segment
    // Counters of the newest finished frame whose low words are frame constants (feedback0 to feedback2): values of
    // Counter, or noCounter. They are 0 before the first frame has finished and without AGAA_CONFIG_COUNTERS.
    std::array<uint32_t, 3> feedback{noCounter, noCounter, noCounter};
    // The read-back buffer that receives stampOf() each frame that the device executes, and the byte of the stamp;
    // noResource if neither counters, nor times, nor persistent buffers need it.
    ResourceId stamps = noResource;
    uint64_t stampOffset = 0;
    // The read-back buffer with a BreadcrumbBuffer, which the CPU reads at any time; noResource without
    // AGAA_CONFIG_BREADCRUMBS.
    ResourceId breadcrumbs = noResource;
    uint32_t bytesPerAggregate = 0;
    uint64_t fragmentCapacity = 0;      // of the lists of all pixels together
    uint32_t payloadWords = 0;          // of a fragment, in addition to id, next fragment and coverage
    ResourceId listCounts = noResource; // read-back buffer with the words before AGAA_LIST_HEADS of a finished frame
    bool runnable = true;               // false: the plan is a model that is priced and never run

    uint32_t depthBits() const; // of a fixed-point depth buffer; 0: it has floats
    uint64_t bytesOf(const CopyPart& copy) const;
    uint64_t totalBytes() const; // per-pixel payload
    uint64_t constantBytes() const;
    uint64_t peakBytes() const; // per-pixel payload with disjoint lifetimes aliased
    double bytesPerPixel() const { return double(totalBytes()) / (double(view.width) * view.height); }
    uint32_t geometryPasses() const;
    std::vector<Step> steps() const; // in the order in which they run
    // Returns workgroups across and down, of dispatches that are not indirect.
    std::pair<uint32_t, uint32_t> groups(const Dispatch& dispatch, FrameExtent extent) const;
    FrameExtent extent() const { return {view.width, view.height}; }
    ResourceId surface(const char* surfaceName) const; // per pixel; throws Error if there is none
};

// Throws Error if a repetition with a predicate has passes that executors cannot skip.
void checkRepeats(const Plan& plan);

std::string planToJson(const Plan& plan);

} // namespace agaa
