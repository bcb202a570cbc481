// A frame as a value: resources and passes. Executors run it, memory is accounted from it, tests read
// it. It knows no graphics API; executors know no technique.
#pragma once

#include "agaa_sdk.h"
#include "core/format.h"
#include "core/view_settings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace agaa {

// Specialisation constants by name; see src/shaders/passes/constants.inc.
enum Constant : uint32_t {
#define AGAA_CONSTANT(id, name, value) name = id,
#include "shaders/passes/constants.inc"
#undef AGAA_CONSTANT
#define AGAA_CONSTANT(id, name, value) +1
    ConstantCount = 0
#include "shaders/passes/constants.inc"
#undef AGAA_CONSTANT
};
static_assert(
    [] {
        std::array<bool, ConstantCount> used{};
#define AGAA_CONSTANT(id, name, value) used[id] = true;
#include "shaders/passes/constants.inc"
#undef AGAA_CONSTANT
        return std::ranges::all_of(used, [](bool is) { return is; });
    }(),
    "ids count from 0, each once");
using Constants = std::array<uint32_t, ConstantCount>;

using ResourceId = uint32_t;
inline constexpr ResourceId noResource = ~0u;

enum class ResourceKind {
    Image,        // per pixel
    Buffer,       // per pixel
    SmallBuffer,  // device local, does not grow with the target
    UploadBuffer, // written by the CPU, one per frame in flight
    ReadbackBuffer, // read by the CPU, one per frame in flight
    Output,       // the host's image
    ShadowMap,    // the host's, sampled with comparison
};

// What the executor writes into an upload buffer each frame (src/core/frame_data.h), when it records the segment that
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

    bool isPerPixel() const { return kind == ResourceKind::Image || kind == ResourceKind::Buffer; }
    bool isHosts() const { return kind == ResourceKind::Output || kind == ResourceKind::ShadowMap; }
};

enum class BindingType {
    UniformBuffer,
    StorageBuffer,
    Texture,       // fetched by texel
    StorageImage,
    ShadowTexture, // 2D array, compared
};

struct Binding {
    uint32_t slot = 0;
    BindingType type = BindingType::Texture;
    ResourceId resource = noResource;
    bool writes = false;
};

enum class PassKind { HostDraw, Compute, Fill, Copy };

struct Pass {
    std::string name;
    AgaaStage stage = AGAA_STAGE_OTHER;
    PassKind kind = PassKind::Compute;
    uint64_t segment = AGAA_SEGMENT_SHADING;
    std::vector<Binding> bindings;
    std::vector<std::string> extensions; // that the pass relies on

    // Compute: 8 x 8 invocations a group.
    uint32_t groupSide = 8; // pixels across and down that a group takes
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
    std::vector<ResourceId> colorTargets;
    ResourceId depthTarget = noResource;
    bool clearsColor = false; // to 0
    bool clearsDepth = false; // to far, stencil to 0

    // Fill (with zero), Copy
    ResourceId source = noResource;
    ResourceId destination = noResource;
};

// config and depthBits are those that run.
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
    uint32_t bytesPerAggregate = 0;
    bool runnable = true; // false: a model to be priced, not to be run

    uint64_t totalBytes() const;    // per-pixel payload
    uint64_t constantBytes() const;
    uint64_t peakBytes() const;     // per-pixel payload with disjoint lifetimes aliased
    double bytesPerPixel() const { return double(totalBytes()) / (double(width) * height); }
    uint32_t geometryPasses() const;
    ResourceId surface(const char* surfaceName) const; // per pixel; throws where there is none
};

// Offsets for blocks of given size, alignment and lifetime so that blocks of disjoint lifetimes may
// share memory; returns the height of the arena.
struct ArenaBlock {
    uint64_t size = 0;
    uint64_t alignment = 1;
    uint32_t firstPass = 0;
    uint32_t lastPass = 0;
    uint64_t offset = 0; // out
};
uint64_t placeBlocks(std::vector<ArenaBlock>& blocks);

std::string planToJson(const Plan& plan);

} // namespace agaa
