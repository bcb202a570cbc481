// G-buffer layouts and how they are packed: into attachments of a multisampled G-buffer, and into the
// 32-bit words that integer atomics sum fragments of an aggregate in.
#pragma once

#include "agaa_sdk.h"
#include "core/base/format.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace agaa {

// Channels that a shader reads and writes (src/shaders/tables/channels.inc).
enum Channel : uint32_t {
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) Channel##name = index,
#include "shaders/tables/channels.inc"
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) +1
    ChannelCount = 0
#include "shaders/tables/channels.inc"
};

// Where a channel lies. bits == 0: absent. The shader constant is described at src/shaders/common/stored.glsl.
struct Field {
    uint32_t word = 0;  // or attachment
    uint32_t shift = 0; // or component
    uint32_t bits = 0;  // of one fragment's value
    bool isSigned = false;
    bool isUnfiltered = false;

    uint32_t constant() const {
        return word | shift << 8 | bits << 16 | uint32_t(isSigned) << 24 | uint32_t(isUnfiltered) << 25;
    }
};
using Fields = std::array<Field, ChannelCount>;

// An attribute of the host's own, AGAA_SEMANTIC_CUSTOM.
struct CustomAttribute {
    std::string name;
    AgaaLayoutAttribute attribute{}; // its name is null
};

// A validated layout: attributes by semantic; absent ones have channels == 0.
struct Layout {
    std::array<AgaaLayoutAttribute, AGAA_SEMANTIC_CUSTOM> attributes{};
    std::vector<CustomAttribute> customs; // their channels come in sequence
    bool hasSpecularLight = false; // stored, or the same for all materials

    const AgaaLayoutAttribute& operator[](AgaaSemantic semantic) const {
        return attributes[semantic];
    }
    bool has(AgaaSemantic semantic) const { return attributes[semantic].channels != 0; }
    bool foldsRoughness() const {
        return has(AGAA_SEMANTIC_ROUGHNESS) &&
               attributes[AGAA_SEMANTIC_ROUGHNESS].encoding == AGAA_ENCODING_FOLDED;
    }
    bool specularIsYCbCr() const {
        return has(AGAA_SEMANTIC_SPECULAR) &&
               attributes[AGAA_SEMANTIC_SPECULAR].encoding == AGAA_ENCODING_YCBCR;
    }
    float emissiveRange() const {
        return has(AGAA_SEMANTIC_EMISSIVE) ? attributes[AGAA_SEMANTIC_EMISSIVE].range : 1.0f;
    }
};

// Throws AGAA_ERROR_LAYOUT with the reason where the layout is not valid. null: "precise".
Layout checkLayout(const AgaaLayout* layout);
AgaaLayout builtinLayout(const char* name); // throws for unknown names
std::vector<const char*> layoutNames();
// Without the attributes that the scene does not call for. keepsRoughness: the technique stores lobes that it widened.
Layout reduceLayout(Layout layout, uint64_t factFlags, bool keepsRoughness = false);

// Of aggregates of two geometry passes: without normals where those of the prepass are precise enough. layout: reduced.
Layout twoPassLayout(Layout layout, uint64_t factFlags);

// Sums of n fragments in 32-bit words. A field has bits + log2(n) bits, so that n values of full scale
// do not carry into the next (hard case 36); a coverage mask of n bits is one more field. Numbers that are no
// power of two, or above 32, throw AGAA_ERROR_OUT_OF_RANGE: log2(n) bits do not hold their sums.
struct AggregatePacking {
    uint32_t words = 0;
    uint32_t unfilteredWords = 0; // bit w: word w keeps the largest value
    Fields fields;
    Field coverage; // bits == n
    uint32_t bytes() const { return 4 * words; }
};
AggregatePacking packAggregate(const Layout& layout, uint32_t samples);
// The same of one surface whose coverage and normal are kept apart.
AggregatePacking packMaterial(const Layout& layout);

struct GBufferPacking {
    std::vector<Format> attachments; // at most 4
    Fields fields;                   // NormalX and NormalY hold the octahedral code
};
GBufferPacking packGBuffer(const Layout& layout);

// The paper's surfaces of one aggregate (figure 7), for native additive blending.
struct NativeSurface {
    std::string name;
    Format format;
};
std::vector<NativeSurface> packNativeAggregate(const Layout& layout);

} // namespace agaa
