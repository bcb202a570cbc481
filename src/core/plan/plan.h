// A frame as a value: resources and passes. Executors run it, memory is accounted from it, tests read
// it. It knows no graphics API; executors know no technique.
#pragma once

#include "agaa_sdk.h"
#include "core/base/format.h"
#include "core/view/view_settings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
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
    Image,        // per pixel, unless it has a size of its own
    Buffer,       // per pixel
    SmallBuffer,  // device local, does not grow with the target
    UploadBuffer, // written by the CPU, one per frame in flight
    ReadbackBuffer, // read by the CPU, one per frame in flight
    Output,       // the host's image
    ShadowMap,    // the host's, sampled with comparison
};

// What the executor writes into an upload buffer each frame (src/core/frame/frame_data.h), when it records the segment that
// reads the buffer. Each is read in one segment only: the device may run an earlier one while the CPU writes for the next.
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
    uint64_t bytes = 0;      // payload of one copy
    uint32_t copies = 1;     // frames in flight for uploads and read-back
    uint32_t hostSlot = 0;   // ShadowMap: which of the frame's
    uint32_t firstPass = 0;  // lifetime, by index into Plan::passes
    uint32_t lastPass = 0;
    uint64_t segments = 0;   // of the passes that use it
    bool hasFixedSize = false;    // Image: that of the view does not matter
    bool isPersistent = false; // Buffer: keeps its contents from frame to frame, which are 0 before the first

    bool isPerPixel() const { return !hasFixedSize && (kind == ResourceKind::Image || kind == ResourceKind::Buffer); }
    bool isImported() const { return kind == ResourceKind::Output || kind == ResourceKind::ShadowMap; }
    bool operator==(const Resource&) const = default;
};

enum class BindingType {
    UniformBuffer,
    StorageBuffer,
    Texture,       // fetched by texel
    StorageImage,
    ShadowTexture, // 2D array, compared
};

// How a Texture is sampled: clamped to its edge, at one level.
enum class Filter { Nearest, Linear };

struct Binding {
    uint32_t slot = 0;
    BindingType type = BindingType::Texture;
    ResourceId resource = noResource;
    bool writes = false;
    Filter filter = Filter::Nearest;
    bool operator==(const Binding&) const = default;
};

// Attachments of a draw with AgaaDrawState::readsAttachments.
inline constexpr uint32_t maxFetchedTargets = 8;

enum class PassKind { HostDraw, Compute, Fill, Copy };

// How many groups a compute pass has.
enum class DispatchKind {
    Pixels,   // a group for each square of groupSide pixels
    Items,    // a group for each 64 items, in rows of groupsPerRow: row * groupsPerRow + column is the group
    Indirect, // three words of an earlier pass say it; 0 skips the pass
};
inline constexpr uint32_t itemsPerGroup = 64, groupsPerRow = 32768;

struct Dispatch {
    DispatchKind kind = DispatchKind::Pixels;
    uint32_t groupSide = 8; // 8 a tile; a multiple of it a region of tiles
    uint64_t items = 0;
    ResourceId arguments = noResource;
    uint64_t argumentsOffset = 0; // bytes, a multiple of 4
    bool operator==(const Dispatch&) const = default;
};

// The value that a prepass draw stores per sample.
enum class SampleContent { Normal, Id };

// How fragments of AGAA_DRAW_PASS_FRAGMENTS are stored.
enum class FragmentContent {
    Ids,       // a list of each pixel keeps their ids
    Materials, // the same, with their attributes
    Merged,    // merged at once, in the order of the draws
};

// Of the targets that a draw clears.
struct ClearValues {
    std::array<std::array<float, 4>, 4> color{};
    float depth = 1;
    uint32_t stencil = 0;
};

struct Pass {
    std::string name;
    AgaaStage stage = AGAA_STAGE_OTHER;
    PassKind kind = PassKind::Compute;
    uint64_t segment = AGAA_SEGMENT_SHADING;
    std::vector<Binding> bindings;
    std::vector<std::string> extensions; // that the pass relies on
    // GLSL in place of the library's: a compute shader that is compiled with the view, or of a HostDraw a text that
    // defines agaa_emit().
    std::string text;

    // Compute: 64 invocations a group.
    Dispatch dispatch;
    bool shadesAggregates = false; // of a buffer that an earlier pass wrote
    std::string shader; // permutation in the library
    std::string hostCode; // GLSL of the host's: the pass is compiled with it, from these:
    std::string hostCodeOrigin; // the members that the text came in
    std::string hostCodeExtensions; // what goes before all else for it
    std::string file;     // below src/shaders
    std::string defines;  // of the permutation
    Constants constants{};

    // HostDraw
    AgaaDrawPassId drawPass = AGAA_DRAW_PASS_VISIBILITY;
    AgaaDrawState drawState{};
    SampleContent sampleContent = SampleContent::Normal;
    FragmentContent fragmentContent = FragmentContent::Ids;
    std::vector<ResourceId> colorTargets;
    ResourceId depthTarget = noResource; // or none
    bool clearsColor = false;
    bool clearsDepth = false; // and the stencil
    ClearValues clear;
    // GLSL for the host's geometry shader, or with drawState.vertexPulling for its vertex shader. It reads the frame constants
    // alone.
    std::string expansionText;
    uint32_t width = 0, height = 0; // of the targets

    // Fill, Copy
    ResourceId source = noResource;
    ResourceId destination = noResource;
    uint32_t fillValue = 0; // of each word
    uint64_t fillBytes = 0; // from the beginning, a multiple of 4; 0: all
};

// Passes that run several times, one after the other. Indirect passes of a group that has nothing left to do dispatch no
// groups: that is how a buffer ends a repetition early.
struct Repeat {
    uint32_t firstPass = 0, lastPass = 0;
    uint32_t times = 1;
    // A word of this buffer is 0 from the turn on that has nothing to do. Executors that can read it may end the repetition
    // there, or run only the last pass of such a turn. After the first turn the last pass alone changes the word. The group
    // draws without clearing, and dispatches: nothing else can be skipped.
    ResourceId predicateBuffer = noResource;
    uint64_t predicateOffset = 0; // bytes
};

// A pass as it runs. batch: of the repetitions of its group, from 0.
struct Step {
    uint32_t pass = 0;
    uint32_t batch = 0;
    bool isFirst = true, isLast = true; // of the pass's steps
    // The step has nothing to do where this word of a buffer is 0.
    ResourceId predicateBuffer = noResource;
    uint64_t predicateOffset = 0; // bytes
};

// config, layout and depthBits are those that run.
struct Plan : ViewSettings {
    Plan() = default;
    explicit Plan(ViewSettings settings) : ViewSettings(std::move(settings)) {}

    uint32_t hwSamples = 1;
    uint32_t scaleX = 1;
    uint32_t scaleY = 1;
    AgaaTier visibilityTier = AGAA_TIER_NATIVE;
    AgaaTier generationTier = AGAA_TIER_AUTO;
    std::vector<std::string> notes; // why a tier or a format was chosen
    std::vector<std::string> effects; // that run
    bool aliases = true; // resources of disjoint lifetimes may share memory
    Format depthFormat = Format::None; // of the target; None where the host draws
    std::vector<Resource> resources;
    std::vector<Pass> passes;
    std::vector<Repeat> repeats; // in the order of passes; they do not overlap, and each lies in one segment
    // Counters whose low words of the newest finished frame are in the frame constants (members feedback0 to feedback2):
    // indices of Counter, or noCounter. The words are 0 before a frame has finished, and without AGAA_CONFIG_COUNTERS.
    std::array<uint32_t, 3> feedback{noCounter, noCounter, noCounter};
    uint32_t bytesPerAggregate = 0;
    uint64_t fragmentCapacity = 0; // fragments that lists of all pixels have room for
    uint32_t payloadWords = 0;    // of each, beside id, next fragment and coverage
    bool runnable = true; // false: a model to be priced, not to be run

    uint64_t totalBytes() const;    // per-pixel payload
    uint64_t constantBytes() const;
    uint64_t peakBytes() const;     // per-pixel payload with disjoint lifetimes aliased
    double bytesPerPixel() const { return double(totalBytes()) / (double(width) * height); }
    uint32_t geometryPasses() const;
    std::vector<Step> steps() const; // in the order in which they run
    std::pair<uint32_t, uint32_t> groups(const Dispatch& dispatch) const; // across and down; not of indirect ones
    ResourceId surface(const char* surfaceName) const; // per pixel; throws where there is none
};

// Fails where a repetition that a word ends holds what an executor could not skip.
void checkRepeats(const Plan& plan);

std::string planToJson(const Plan& plan);

} // namespace agaa
