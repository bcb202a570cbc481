// G-buffer layouts and their packings: into attachments of a multisampled G-buffer, and into 32-bit words in which
// integer atomics sum the fragments of an aggregate.
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

// The position of a channel. If `bits` is 0, the channel is absent. src/shaders/common/stored.glsl describes the shader
// constant.
struct Field {
    uint32_t word = 0;  // or the attachment
    uint32_t shift = 0; // or the component
    uint32_t bits = 0;  // of one fragment's value
    bool isSigned = false;
    bool isUnfiltered = false;

    uint32_t constant() const {
        return word | shift << 8 | bits << 16 | uint32_t(isSigned) << 24 | uint32_t(isUnfiltered) << 25;
    }
};
using Fields = std::array<Field, ChannelCount>;

// An attribute that the host defines, AGAA_SEMANTIC_CUSTOM.
struct CustomAttribute {
    std::string name;
    AgaaLayoutAttribute attribute{}; // its name is null
};

// A validated layout. The index of an attribute is its semantic. Absent attributes have 0 channels.
struct Layout {
    std::array<AgaaLayoutAttribute, AGAA_SEMANTIC_CUSTOM> attributes{};
    std::vector<CustomAttribute> customs; // channels are numbered in this order
    bool hasSpecularLight = false;        // stored per sample, or the same for all materials

    const AgaaLayoutAttribute& operator[](AgaaSemantic semantic) const { return attributes[semantic]; }
    uint32_t customChannels() const;
    // Returns 1 + the channel, among custom ones, of AGAA_FILTER_CLASS; 0 if samples have no classes.
    uint32_t classChannel() const;
    // Returns the custom channels of AGAA_FILTER_NONE: bit i for channel i, and bit 8 + i if it is the first of its
    // attribute.
    uint32_t unfilteredChannels() const;
    bool has(AgaaSemantic semantic) const { return attributes[semantic].channels != 0; }
    bool foldsRoughness() const {
        return has(AGAA_SEMANTIC_ROUGHNESS) && attributes[AGAA_SEMANTIC_ROUGHNESS].encoding == AGAA_ENCODING_FOLDED;
    }
    bool specularIsYCbCr() const {
        return has(AGAA_SEMANTIC_SPECULAR) && attributes[AGAA_SEMANTIC_SPECULAR].encoding == AGAA_ENCODING_YCBCR;
    }
    float emissiveRange() const {
        return has(AGAA_SEMANTIC_EMISSIVE) ? attributes[AGAA_SEMANTIC_EMISSIVE].range : 1.0f;
    }
};

// Returns whether an aggregate has the value of one sample, not a sum.
inline bool isUnfiltered(const AgaaLayoutAttribute& a) {
    return a.filter == AGAA_FILTER_NONE || a.filter == AGAA_FILTER_CLASS;
}

// Returns the checked layout; for null that is "precise". Throws AGAA_ERROR_LAYOUT with the reason if it is not valid.
Layout checkLayout(const AgaaLayout* layout);
AgaaLayout builtinLayout(const char* name); // throws for unknown names
std::vector<const char*> layoutNames();
// Returns the layout without the attributes that the scene does not need. keepsRoughness: the technique stores widened
// lobes as roughness.
Layout reduceLayout(Layout layout, uint64_t factFlags, bool keepsRoughness = false);

// Returns the layout of aggregates that two geometry passes fill: without normals if those of the prepass are precise
// enough. The layout is reduced already.
Layout twoPassLayout(Layout layout, uint64_t factFlags);

// Sums of n fragments in 32-bit words. A field has bits + log2(n) bits, so that n values of full scale do not carry
// into the next field (hard case 36). A coverage mask of n bits is one more field. Values of n other than powers of two
// in [1, 32] throw AGAA_ERROR_OUT_OF_RANGE, because log2(n) bits are too few for their sums.
struct AggregatePacking {
    uint32_t words = 0;
    uint32_t unfilteredWords = 0; // bit w: word w is the largest value, not a sum
    uint32_t classWord = 0;       // 1 + the word of the class; 0 if there is none
    Fields fields;
    Field coverage; // bits == n
    uint32_t bytes() const { return 4 * words; }
};
AggregatePacking packAggregate(const Layout& layout, uint32_t samples);
// Packs one surface whose coverage and normal are stored separately.
AggregatePacking packMaterial(const Layout& layout);

struct GBufferPacking {
    std::vector<Format> attachments; // at most 4
    Fields fields;                   // NormalX and NormalY are the octahedral code
};
GBufferPacking packGBuffer(const Layout& layout);

// Sums of n fragments in UNORM attachments, by additive blending (AGAA figure 7). A sum has the bits of its channel at
// every n, because fragments add shares of their values (src/shaders/math/blended_sums.glsl). The coverage has 8 bits
// for each eight samples: the first eight share an attachment with attributes, the last attachment has the others.
// Unfiltered attributes, which are no sums, are left out.
struct BlendedPacking {
    std::vector<Format> attachments;
    Fields fields;
    Field coverage; // of the first eight samples
};
BlendedPacking packBlendedAggregate(const Layout& layout, uint32_t samples);
// The largest number of attachments that a draw of the host has.
inline constexpr uint32_t maxAttachments = 8;

} // namespace agaa
