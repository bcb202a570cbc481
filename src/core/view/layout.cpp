#include "core/view/layout.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/structs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string_view>

namespace agaa {

// A value of 0 in aggregateBits means as many bits as a 16-bit sum allows: 16 - log2(n).
static constexpr uint32_t bitsOfHalfWord = 0;

static AgaaLayout makeLayout(std::initializer_list<AgaaLayoutAttribute> attributes) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    for (const AgaaLayoutAttribute& attribute : attributes)
        layout.attributes[layout.attributeCount++] = attribute;
    return layout;
}

std::vector<const char*> layoutNames() { return {"precise", "paper16", "dcaa28"}; }

AgaaLayout builtinLayout(const char* name) {
    if (isSameName(name, "paper16"))
        return makeLayout({
            {AGAA_SEMANTIC_NORMAL, 3, 16, 16, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_DIFFUSE, 3, 8, 10, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_EMISSIVE, 1, 8, 8, 0, AGAA_ENCODING_UNORM, 16, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_SPECULAR, 3, 8, 16, 8, AGAA_ENCODING_YCBCR, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_ROUGHNESS, 1, 8, 0, 0, AGAA_ENCODING_FOLDED, 1, AGAA_FILTER_MEAN, nullptr, {}},
        });
    if (isSameName(name, "precise"))
        return makeLayout({
            {AGAA_SEMANTIC_DIFFUSE, 3, 16, bitsOfHalfWord, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_ROUGHNESS, 1, 16, 16, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_NORMAL, 3, 16, bitsOfHalfWord, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_SPECULAR, 3, 10, bitsOfHalfWord, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_EMISSIVE, 3, 16, 16, 0, AGAA_ENCODING_UNORM, 16, AGAA_FILTER_MEAN, nullptr, {}},
        });
    if (isSameName(name, "dcaa28"))
        return makeLayout({
            {AGAA_SEMANTIC_NORMAL, 3, 16, 16, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_DIFFUSE, 3, 8, 8, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_EMISSIVE, 1, 8, 8, 0, AGAA_ENCODING_UNORM, 16, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_SPECULAR, 3, 8, 8, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
            {AGAA_SEMANTIC_ROUGHNESS, 1, 8, 8, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, nullptr, {}},
        });
    fail(AGAA_ERROR_LAYOUT, format("no built-in layout is called \"%s\".", printable(name).c_str()));
}

static const char* semanticName(uint32_t semantic) {
    static constexpr const char* names[] = {
#define AGAA_ATTRIBUTE(semantic, name) #name,
#define AGAA_CHANNEL(index, name, field, source, attribute, member)
#include "shaders/tables/channels.inc"
    };
    static_assert(std::size(names) == AGAA_SEMANTIC_COUNT);
    return semantic < AGAA_SEMANTIC_COUNT ? names[semantic] : "unknown";
}

// Returns the bits of one fragment's value, if nothing is summed.
static uint32_t aggregateBitsOf(const AgaaLayoutAttribute& a) {
    if (a.filter == AGAA_FILTER_CLASS)
        return 8;
    return a.aggregateBits == bitsOfHalfWord ? 16 : a.aggregateBits;
}

static void checkAttribute(const AgaaLayoutAttribute& a) {
    const auto bad = [&](const char* what) {
        fail(AGAA_ERROR_LAYOUT, format("layout attribute %s: %s.", semanticName(a.semantic), what));
    };
    const bool isRoughness = a.semantic == AGAA_SEMANTIC_ROUGHNESS;
    const bool isEmissive = a.semantic == AGAA_SEMANTIC_EMISSIVE;
    const bool isCustom = a.semantic == AGAA_SEMANTIC_CUSTOM;
    if (isCustom ? a.channels < 1 || a.channels > 4
                 : !(a.channels == (isRoughness ? 1u : 3u) || (isEmissive && a.channels == 1)))
        bad("wrong number of channels");
    if (a.sampleBits != 8 && a.sampleBits != 10 && a.sampleBits != 16)
        bad("sampleBits is not 8, 10 or 16");
    if (a.semantic == AGAA_SEMANTIC_NORMAL && a.sampleBits == 10)
        bad("two octahedral components do not pack into 10-bit channels; use 8 or 16");
    if ((a.sampleBits == 10) && a.channels != 3)
        bad("10-bit channels come in threes");
    if (a.filter > (isCustom ? AGAA_FILTER_CLASS : AGAA_FILTER_MEAN))
        bad("its filter is not known; attributes that are not custom have filter 0");
    if (!isCustom && a.name)
        bad("only custom attributes have a name");
    const bool hasRange = isEmissive || (isCustom && a.filter != AGAA_FILTER_NORMAL);
    if (!(a.range >= 1e-6f && a.range <= 65504.0f) || (!hasRange && a.range != 1))
        bad("range must be 1, or [1e-6;65504] for emissive and for custom attributes that are no normals");
    if (a.filter == AGAA_FILTER_NORMAL && a.channels != 3)
        bad("a normal has three channels");
    if (a.filter == AGAA_FILTER_CLASS && (a.channels != 1 || a.range != 255))
        bad("a class has one channel and the range 255");
    if (a.filter == AGAA_FILTER_CLASS && a.aggregateBits != bitsOfHalfWord && a.aggregateBits != 8)
        bad("a class has 8 bits in an aggregate; aggregateBits is 0 or 8");
    if (a.filter == AGAA_FILTER_NONE && a.channels * aggregateBitsOf(a) > 32)
        bad("its channels do not fit the 32 bits that an unfiltered attribute has in an aggregate");
    if (a.encoding == AGAA_ENCODING_FOLDED) {
        if (!isRoughness)
            bad("only roughness can be folded into the normal");
        return;
    }
    if (a.encoding > AGAA_ENCODING_YCBCR)
        bad("its encoding is not known");
    if (a.encoding == AGAA_ENCODING_YCBCR) {
        if (a.semantic != AGAA_SEMANTIC_SPECULAR)
            bad("only specular can be encoded as luma and chroma");
        if (a.chromaBits < 6 || a.chromaBits > 16)
            bad("chromaBits is outside [6;16]");
    }
    if (a.aggregateBits != bitsOfHalfWord && (a.aggregateBits < 6 || a.aggregateBits > 16))
        bad("aggregateBits is neither 0 (fill 16-bit sums) nor in [6;16]");
}

// The list has all words that cannot name a member: keywords and reserved words of GLSL and macros of src/shaders/math.
static bool isWordOfGlsl(std::string_view name) {
    static constexpr std::string_view words[] = {
        "active",        "asm",       "atomic_uint", "attribute",  "bool",     "break",    "buffer",    "bvec2",
        "bvec3",         "bvec4",     "case",        "cast",       "centroid", "class",    "coherent",  "common",
        "const",         "continue",  "default",     "discard",    "do",       "double",   "dvec2",     "dvec3",
        "dvec4",         "else",      "enum",        "extern",     "external", "false",    "filter",    "fixed",
        "flat",          "float",     "for",         "fvec2",      "fvec3",    "fvec4",    "goto",      "half",
        "highp",         "hvec2",     "hvec3",       "hvec4",      "if",       "in",       "inline",    "inout",
        "input",         "int",       "interface",   "invariant",  "ivec2",    "ivec3",    "ivec4",     "layout",
        "long",          "lowp",      "mat2",        "mat3",       "mat4",     "mediump",  "namespace", "noinline",
        "noperspective", "out",       "output",      "partition",  "patch",    "precise",  "precision", "public",
        "readonly",      "resource",  "restrict",    "return",     "sample",   "shared",   "short",     "sizeof",
        "smooth",        "static",    "struct",      "subroutine", "superp",   "switch",   "template",  "this",
        "true",          "typedef",   "uint",        "uniform",    "union",    "unsigned", "using",     "uvec2",
        "uvec3",         "uvec4",     "varying",     "vec2",       "vec3",     "vec4",     "void",      "volatile",
        "while",         "writeonly", "real",        "rvec2",      "rvec3",    "rvec4",    "OUT",       "INOUT",
        "PRECISE"};
    return std::find(std::begin(words), std::end(words), name) != std::end(words);
}

static bool isIdentifier(std::string_view name) {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto isOther = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.size() <= 31 && isLetter(name[0]) && std::all_of(name.begin(), name.end(), isOther) &&
           name.find("__") == std::string_view::npos && !name.starts_with("gl_") && !name.starts_with("agaa") &&
           !name.starts_with("AGAA") && !isWordOfGlsl(name);
}

// Adds a custom attribute that checkAttribute() has accepted.
static void addCustom(Layout& layout, AgaaLayoutAttribute attribute) {
    static constexpr std::string_view members[] = {
        "position",  "geometricNormal", "alpha",    "alphaCutoff", "hasAlphaNear", "alphaNear",     "hasAlphaRows",
        "alphaRows", "primitiveSeed",   "draw",     "primitive",   "diffuse",      "specular",      "emissive",
        "normal",    "alpha2",          "normalDx", "normalDy",    "samples",      "normalSquares", "normalProducts"};
    require(attribute.name, AGAA_ERROR_LAYOUT, "a custom layout attribute has no name.");
    const std::string name(attribute.name, strnlen(attribute.name, 32));
    if (!isIdentifier(name))
        fail(AGAA_ERROR_LAYOUT,
             format("custom layout attribute \"%s\": a name has 1 to 31 letters, digits and single underscores, begins "
                    "with a letter, not with gl_, agaa or AGAA, and is no word of GLSL.",
                    printable(name.c_str()).c_str()));
    const bool isTaken = std::find(std::begin(members), std::end(members), name) != std::end(members) ||
                         std::any_of(layout.customs.begin(), layout.customs.end(),
                                     [&](const CustomAttribute& custom) { return custom.name == name; });
    if (isTaken)
        fail(AGAA_ERROR_LAYOUT, format("custom layout attribute \"%s\": the name is taken.", name.c_str()));
    if (attribute.filter == AGAA_FILTER_CLASS && layout.classChannel())
        fail(AGAA_ERROR_LAYOUT,
             format("custom layout attribute \"%s\": the layout has another class already.", name.c_str()));
    const uint32_t channels = attribute.channels + layout.customChannels();
    if (channels > AGAA_MAX_CUSTOM_CHANNELS)
        fail(AGAA_ERROR_LAYOUT,
             format("the custom attributes have %u channels; %d are the most.", channels, AGAA_MAX_CUSTOM_CHANNELS));
    attribute.name = nullptr; // the host's pointer does not outlive the call
    layout.customs.push_back({name, attribute});
}

Layout checkLayout(const AgaaLayout* pointer) {
    const AgaaLayout source = pointer ? readStruct(pointer) : builtinLayout("precise");
    checkReserved(source.reserved, "AgaaLayout::reserved");
    if (source.attributeCount < 2 || source.attributeCount > AGAA_MAX_LAYOUT_ATTRIBUTES)
        fail(AGAA_ERROR_LAYOUT, format("AgaaLayout::attributeCount is %u; it must be in [2, %d].",
                                       source.attributeCount, AGAA_MAX_LAYOUT_ATTRIBUTES));
    Layout layout;
    for (uint32_t i = 0; i < source.attributeCount; ++i) {
        const AgaaLayoutAttribute& attribute = source.attributes[i];
        checkReserved(attribute.reserved[0] | attribute.reserved[1], "AgaaLayoutAttribute::reserved");
        if (attribute.semantic >= AGAA_SEMANTIC_COUNT)
            fail(AGAA_ERROR_LAYOUT, "AgaaLayout has an attribute of unknown semantic.");
        if (attribute.semantic == AGAA_SEMANTIC_CUSTOM) {
            checkAttribute(attribute);
            addCustom(layout, attribute);
            continue;
        }
        if (layout.attributes[attribute.semantic].channels)
            fail(AGAA_ERROR_LAYOUT, format("AgaaLayout names %s twice.", semanticName(attribute.semantic)));
        checkAttribute(attribute);
        layout.attributes[attribute.semantic] = attribute;
    }
    if (!layout.has(AGAA_SEMANTIC_DIFFUSE) || !layout.has(AGAA_SEMANTIC_NORMAL))
        fail(AGAA_ERROR_LAYOUT, "AgaaLayout has no diffuse or no normal attribute.");
    if (layout.has(AGAA_SEMANTIC_SPECULAR) && !layout.has(AGAA_SEMANTIC_ROUGHNESS))
        fail(AGAA_ERROR_LAYOUT, "AgaaLayout has a specular but no roughness attribute, by which lobes are wide.");
    packGBuffer(layout); // throws if the samples do not fit the attachments
    return layout;
}

uint32_t Layout::customChannels() const {
    uint32_t channels = 0;
    for (const CustomAttribute& custom : customs)
        channels += custom.attribute.channels;
    return channels;
}

uint32_t Layout::classChannel() const {
    uint32_t channel = 0;
    for (const CustomAttribute& custom : customs) {
        if (custom.attribute.filter == AGAA_FILTER_CLASS)
            return channel + 1;
        channel += custom.attribute.channels;
    }
    return 0;
}

uint32_t Layout::unfilteredChannels() const {
    uint32_t mask = 0, channel = 0;
    for (const CustomAttribute& custom : customs) {
        const uint32_t end = channel + custom.attribute.channels;
        if (custom.attribute.filter == AGAA_FILTER_NONE)
            mask |= 1u << (8 + channel) | ((1u << end) - (1u << channel));
        channel = end;
    }
    return mask;
}

// Reduces three channels to one.
static void makeGrey(AgaaLayoutAttribute& attribute) {
    attribute.channels = 1;
    attribute.encoding = AGAA_ENCODING_UNORM;
    attribute.chromaBits = 0;
    attribute.sampleBits = attribute.sampleBits == 10 ? 16 : attribute.sampleBits; // 10 bits are for three channels
}

Layout reduceLayout(Layout layout, uint64_t factFlags, bool keepsRoughness) {
    const auto drop = [&](AgaaSemantic semantic) { layout.attributes[semantic] = {}; };
    layout.hasSpecularLight = factFlags & AGAA_FACT_SPECULAR && layout.has(AGAA_SEMANTIC_SPECULAR);
    if (!layout.hasSpecularLight || factFlags & AGAA_FACT_ONE_SPECULAR)
        drop(AGAA_SEMANTIC_SPECULAR);
    else if (factFlags & AGAA_FACT_GREY_SPECULAR)
        makeGrey(layout.attributes[AGAA_SEMANTIC_SPECULAR]);
    if (!layout.hasSpecularLight || (factFlags & AGAA_FACT_ONE_ROUGHNESS && !keepsRoughness))
        drop(AGAA_SEMANTIC_ROUGHNESS);
    if (!(factFlags & AGAA_FACT_EMISSIVE))
        drop(AGAA_SEMANTIC_EMISSIVE);
    require(!(factFlags & AGAA_FACT_NO_DIFFUSE) || layout[AGAA_SEMANTIC_EMISSIVE].channels != 1, AGAA_ERROR_LAYOUT,
            "AgaaLayout has emission of one channel, a factor of the diffuse albedo, which AGAA_FACT_NO_DIFFUSE leaves "
            "out.");
    if (factFlags & AGAA_FACT_NO_DIFFUSE)
        drop(AGAA_SEMANTIC_DIFFUSE);
    return layout;
}

Layout twoPassLayout(Layout layout, uint64_t factFlags) {
    // The normals of the prepass have 16 bits. Highlights and nearby lights would show their steps as stripes; diffuse
    // light from one direction is constant on a plane.
    constexpr uint64_t even = AGAA_FACT_PLANE_NORMALS | AGAA_FACT_NO_LOCAL_LIGHTS;
    if ((factFlags & even) == even && !layout.hasSpecularLight)
        layout.attributes[AGAA_SEMANTIC_NORMAL] = {};
    return layout;
}

// Calls visit(attribute, its first channel) for each attribute of the layout.
template <typename Visit> static void forEachAttribute(const Layout& layout, const Visit& visit) {
    static constexpr uint32_t semantics[] = {
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) AGAA_SEMANTIC_##attribute,
#include "shaders/tables/channels.inc"
    };
    const auto first = [](uint32_t semantic) {
        return uint32_t(std::find(std::begin(semantics), std::end(semantics), semantic) - std::begin(semantics));
    };
    for (uint32_t semantic = 0; semantic < AGAA_SEMANTIC_CUSTOM; ++semantic)
        if (layout.attributes[semantic].channels)
            visit(layout.attributes[semantic], first(semantic));
    uint32_t channel = first(AGAA_SEMANTIC_CUSTOM);
    for (const CustomAttribute& custom : layout.customs) {
        visit(custom.attribute, channel);
        channel += custom.attribute.channels;
    }
}

static AggregatePacking pack(const Layout& layout, uint32_t samples, bool hasCoverage) {
    const uint32_t growth = uint32_t(std::countr_zero(samples));
    AggregatePacking packing;
    struct Piece {
        uint32_t bits; // in the word, including log2(n) bits of growth
        Field* field;
    };
    std::vector<Piece> pieces;
    forEachAttribute(layout, [&](const AgaaLayoutAttribute& a, uint32_t first) {
        if (a.encoding == AGAA_ENCODING_FOLDED || isUnfiltered(a))
            return;
        for (uint32_t i = 0; i < a.channels; ++i) {
            const bool isChroma = a.encoding == AGAA_ENCODING_YCBCR && i > 0;
            const uint32_t bits = isChroma                            ? a.chromaBits
                                  : a.aggregateBits == bitsOfHalfWord ? 16 - growth
                                                                      : a.aggregateBits;
            Field& field = packing.fields[first + i];
            field.bits = bits;
            field.isSigned = a.semantic == AGAA_SEMANTIC_NORMAL || a.filter == AGAA_FILTER_NORMAL;
            pieces.push_back({bits + growth, &field});
        }
    });
    if (hasCoverage) {
        packing.coverage.bits = samples;
        pieces.push_back({samples, &packing.coverage});
    }
    // First fit, longest first. The pieces are few, so that a better packing would not save a word.
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.bits > b.bits; });
    std::vector<uint32_t> used;
    for (const Piece& piece : pieces) {
        auto word = std::find_if(used.begin(), used.end(), [&](uint32_t bits) { return bits + piece.bits <= 32; });
        if (word == used.end())
            word = used.insert(used.end(), 0);
        piece.field->word = uint32_t(word - used.begin());
        piece.field->shift = *word;
        *word += piece.bits;
    }
    packing.words = uint32_t(used.size());
    // An unfiltered attribute gets a word, of which the largest value is kept. Channel 0 has the highest bits.
    forEachAttribute(layout, [&](const AgaaLayoutAttribute& a, uint32_t first) {
        if (!isUnfiltered(a))
            return;
        const uint32_t bits = aggregateBitsOf(a);
        for (uint32_t i = 0; i < a.channels; ++i)
            packing.fields[first + i] = {packing.words, (a.channels - 1 - i) * bits, bits, false, true};
        packing.unfilteredWords |= 1u << packing.words++;
        if (a.filter == AGAA_FILTER_CLASS)
            packing.classWord = packing.words;
    });
    return packing;
}

AggregatePacking packAggregate(const Layout& layout, uint32_t samples) {
    checkSampleCount(samples, "the number of samples in an aggregate");
    return pack(layout, samples, true);
}

AggregatePacking packMaterial(const Layout& layout) {
    Layout others = layout;
    others.attributes[AGAA_SEMANTIC_NORMAL] = {};
    return pack(others, 1, false);
}

static Format attachmentFormat(uint32_t bits, uint32_t components) {
    if (bits == 10)
        return Format::RGB10A2;
    const bool wide = bits == 16;
    switch (components) {
    case 1:
        return wide ? Format::R16 : Format::R8;
    case 2:
        return wide ? Format::RG16 : Format::RG8;
    default:
        return wide ? Format::RGBA16 : Format::RGBA8;
    }
}

GBufferPacking packGBuffer(const Layout& layout) {
    GBufferPacking packing;
    for (uint32_t bits : {16u, 8u, 10u}) {
        const uint32_t capacity = bits == 10 ? 3 : 4;
        uint32_t component = capacity; // next free one of the last attachment
        const auto close = [&] {
            if (!packing.attachments.empty() && component < capacity && packing.attachments.back() == Format::None)
                packing.attachments.back() = attachmentFormat(bits, component);
        };
        forEachAttribute(layout, [&](const AgaaLayoutAttribute& a, uint32_t first) {
            if (a.sampleBits != bits)
                return;
            const uint32_t channels = a.semantic == AGAA_SEMANTIC_NORMAL ? 2 : a.channels;
            for (uint32_t i = 0; i < channels; ++i) {
                if (component == capacity) {
                    packing.attachments.push_back(Format::None);
                    component = 0;
                }
                packing.fields[first + i] = {uint32_t(packing.attachments.size() - 1), component, bits,
                                             a.filter == AGAA_FILTER_NORMAL, false};
                if (++component == capacity)
                    packing.attachments.back() = attachmentFormat(bits, capacity);
            }
        });
        close();
    }
    if (packing.attachments.size() > 4)
        fail(AGAA_ERROR_LAYOUT,
             format("the layout needs %zu colour attachments; 4 are the most.", packing.attachments.size()));
    return packing;
}

// Returns the bits of the channel that stores a value of so many bits: 8, 10 or 16. Ten are for three channels.
static uint32_t channelBits(uint32_t bits, uint32_t channels) {
    return bits <= 8 ? 8 : bits <= 10 && channels == 3 ? 10 : 16;
}

BlendedPacking packBlendedAggregate(const Layout& layout, uint32_t samples) {
    checkSampleCount(samples, "the number of samples in an aggregate");
    BlendedPacking packing;
    for (const uint32_t bits : {16u, 10u, 8u}) {
        const uint32_t capacity = bits == 10 ? 3 : 4;
        uint32_t component = capacity; // next free one of the last attachment
        const auto add = [&](Field& field) {
            if (component == capacity) {
                packing.attachments.push_back(Format::None);
                component = 0;
            }
            field.word = uint32_t(packing.attachments.size() - 1);
            field.shift = component++;
            field.bits = bits;
            packing.attachments.back() = attachmentFormat(bits, component);
        };
        forEachAttribute(layout, [&](const AgaaLayoutAttribute& a, uint32_t first) {
            if (a.encoding == AGAA_ENCODING_FOLDED || isUnfiltered(a))
                return;
            for (uint32_t i = 0; i < a.channels; ++i) {
                const bool isYCbCr = a.encoding == AGAA_ENCODING_YCBCR;
                const uint32_t stored = isYCbCr && i > 0 ? a.chromaBits : aggregateBitsOf(a);
                if (channelBits(stored, isYCbCr ? 1 : a.channels) != bits)
                    continue;
                Field& field = packing.fields[first + i];
                field.isSigned = a.semantic == AGAA_SEMANTIC_NORMAL || a.filter == AGAA_FILTER_NORMAL;
                add(field);
            }
        });
        if (bits == 8)
            add(packing.coverage);
    }
    if (samples > 8)
        packing.attachments.push_back(attachmentFormat(8, samples / 8 - 1));
    return packing;
}

} // namespace agaa
