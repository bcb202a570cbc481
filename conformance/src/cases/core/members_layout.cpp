// Members of AgaaLayout and AgaaLayoutAttribute.
#include "cases.h"
#include "members.h"

#include <array>

namespace agaa::conformance {

namespace {

AgaaLayoutAttribute attribute(uint32_t semantic, uint32_t channels, uint32_t bits = 8, const char* name = nullptr) {
    AgaaLayoutAttribute a = AGAA_LAYOUT_ATTRIBUTE_INIT;
    a.semantic = semantic;
    a.channels = channels;
    a.sampleBits = bits;
    a.name = name;
    return a;
}

void setLayout(ViewParts& parts, std::initializer_list<AgaaLayoutAttribute> attributes) {
    const AgaaLayout initial = AGAA_LAYOUT_INIT;
    parts.layout = initial;
    for (const AgaaLayoutAttribute& a : attributes)
        parts.layout.attributes[parts.layout.attributeCount++] = a;
    parts.useLayout();
}

// Attributes 0 to 4: diffuse, normal, specular, roughness, emissive.
void simpleLayout(ViewParts& parts) {
    setLayout(parts, {attribute(AGAA_SEMANTIC_DIFFUSE, 3), attribute(AGAA_SEMANTIC_NORMAL, 3),
                      attribute(AGAA_SEMANTIC_SPECULAR, 3), attribute(AGAA_SEMANTIC_ROUGHNESS, 1),
                      attribute(AGAA_SEMANTIC_EMISSIVE, 3)});
}

// The same layout with one custom attribute after the others.
void customLayout(ViewParts& parts) {
    simpleLayout(parts);
    parts.layout.attributes[parts.layout.attributeCount++] = attribute(AGAA_SEMANTIC_CUSTOM, 3, 8, "wetness");
}

template <uint32_t i, auto member> void set(ViewParts& parts, double x) {
    auto& value = parts.layout.attributes[i].*member;
    value = std::remove_reference_t<decltype(value)>(x);
}

using Attribute = AgaaLayoutAttribute;

// In a layout, only reserved members fail with AGAA_ERROR_OUT_OF_RANGE.
void addAttribute(Suite& suite, MemberRow row) {
    row.error = AGAA_ERROR_LAYOUT;
    addMember(suite, row);
}

// An attribute of each semantic beside diffuse and normal.
void setSemantic(ViewParts& parts, double x) {
    const uint32_t semantic = whole(x);
    if (semantic == AGAA_SEMANTIC_DIFFUSE || semantic == AGAA_SEMANTIC_NORMAL)
        return; // diffuse and normal exist already
    parts.layout.attributes[3] = attribute(semantic, 3, 8, semantic == AGAA_SEMANTIC_CUSTOM ? "wetness" : nullptr);
    parts.layout.attributeCount = 4;
}

void roughLayout(ViewParts& parts) {
    setLayout(parts, {attribute(AGAA_SEMANTIC_DIFFUSE, 3), attribute(AGAA_SEMANTIC_NORMAL, 3),
                      attribute(AGAA_SEMANTIC_ROUGHNESS, 1)});
}

void ycbcrLayout(ViewParts& parts) {
    simpleLayout(parts);
    parts.layout.attributes[2].encoding = AGAA_ENCODING_YCBCR;
    parts.layout.attributes[2].chromaBits = 8;
}

// The encoding that the attribute of each row of the enumeration allows.
void setEncoding(ViewParts& parts, double x) {
    parts.layout.attributes[whole(x) == AGAA_ENCODING_FOLDED ? 3 : 2].encoding = whole(x);
    parts.layout.attributes[2].chromaBits = 8;
}

// Attributes of one channel up to 12; more do not fit four attachments.
void setCount(ViewParts& parts, double x) {
    static const char* const names[] = {"c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7"};
    setLayout(parts, {attribute(AGAA_SEMANTIC_DIFFUSE, 3), attribute(AGAA_SEMANTIC_NORMAL, 3),
                      attribute(AGAA_SEMANTIC_ROUGHNESS, 1), attribute(AGAA_SEMANTIC_EMISSIVE, 1)});
    for (uint32_t i = 0; i < 8; ++i)
        parts.layout.attributes[4 + i] = attribute(AGAA_SEMANTIC_CUSTOM, 1, 8, names[i]);
    parts.layout.attributeCount = whole(x);
}

void addAttributes(Suite& suite) {
    addAttribute(suite, {"AgaaLayoutAttribute.semantic/enum",
                         "AgaaLayoutAttribute::semantic",
                         setSemantic,
                         {AGAA_SEMANTIC_DIFFUSE, AGAA_SEMANTIC_NORMAL, AGAA_SEMANTIC_EMISSIVE, AGAA_SEMANTIC_CUSTOM,
                          AGAA_SEMANTIC_SPECULAR},
                         largeNumbers({}),
                         roughLayout,
                         {AGAA_SEMANTIC_COUNT}});
    addAttribute(suite, {"AgaaLayoutAttribute.sampleBits/range",
                         "AgaaLayoutAttribute::sampleBits",
                         set<0, &Attribute::sampleBits>,
                         {8, 10, 16},
                         largeNumbers({0, 1, 7, 9, 11, 15, 17, 32}),
                         simpleLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.sampleBits/range/normal",
                         "AgaaLayoutAttribute::sampleBits",
                         set<1, &Attribute::sampleBits>,
                         {8, 16},
                         {0, 9, 32},
                         simpleLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.aggregateBits/range",
                         "AgaaLayoutAttribute::aggregateBits",
                         set<0, &Attribute::aggregateBits>,
                         {0, 6, 7, 15, 16},
                         largeNumbers({1, 5, 17, 32}),
                         simpleLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.chromaBits/range",
                         "AgaaLayoutAttribute::chromaBits",
                         set<2, &Attribute::chromaBits>,
                         {6, 7, 15, 16},
                         largeNumbers({0, 1, 5, 17, 32}),
                         ycbcrLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.encoding/enum",
                         "AgaaLayoutAttribute::encoding",
                         setEncoding,
                         {AGAA_ENCODING_UNORM, AGAA_ENCODING_YCBCR, AGAA_ENCODING_FOLDED},
                         largeNumbers({}),
                         simpleLayout,
                         {AGAA_ENCODING_FOLDED + 1}});
    addAttribute(suite, {"AgaaLayoutAttribute.range/range",
                         "AgaaLayoutAttribute::range",
                         set<4, &Attribute::range>,
                         {1e-6f, 1, 65504},
                         notNumbers({below(1e-6f), 0, -1, above(65504), 3e38}),
                         simpleLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.range/range/diffuse",
                         "AgaaLayoutAttribute::range",
                         set<0, &Attribute::range>,
                         {1},
                         notNumbers({0, -1, below(1), above(1)}),
                         simpleLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.range/range/custom",
                         "AgaaLayoutAttribute::range",
                         set<5, &Attribute::range>,
                         {1e-6f, 1, 65504},
                         notNumbers({below(1e-6f), 0, -1, above(65504), 3e38}),
                         customLayout});
    addAttribute(suite, {"AgaaLayoutAttribute.filter/enum",
                         "AgaaLayoutAttribute::filter",
                         set<5, &Attribute::filter>,
                         {AGAA_FILTER_MEAN, AGAA_FILTER_NORMAL, AGAA_FILTER_NONE},
                         largeNumbers({}),
                         [](ViewParts& parts) {
                             customLayout(parts);
                             parts.layout.attributes[5].aggregateBits = 8; // 24 bits of an unfiltered attribute
                         },
                         {AGAA_FILTER_CLASS + 1}}); // testClasses() has the rules of a class
    addAttribute(suite, {"AgaaLayoutAttribute.filter/enum/diffuse",
                         "AgaaLayoutAttribute::filter",
                         set<0, &Attribute::filter>,
                         {0},
                         largeNumbers({AGAA_FILTER_NORMAL, AGAA_FILTER_NONE, AGAA_FILTER_CLASS}),
                         simpleLayout});
    const auto setReserved = [](ViewParts& parts, double x) {
        parts.layout.attributes[1].reserved[x < 0] = uint64_t(std::fabs(x));
    };
    addMember(suite, {"AgaaLayoutAttribute.reserved/zero",
                      "AgaaLayoutAttribute::reserved",
                      setReserved,
                      {0},
                      {0x1p62, -0x1p62},
                      simpleLayout,
                      {1, -1}});
}

// Tests names of custom attributes. A layout with an invalid name fails; the code may vary.
void testNames(Test& test) {
    for (const char* name : {"a", "wetness", "Wetness2", "wet_ness", "abcdefghijklmnopqrstuvwxyz01234"}) {
        ViewParts parts(test.sdk, nullptr);
        customLayout(parts);
        parts.layout.attributes[5].name = name;
        expectAccepted(test, parts, std::string("a custom attribute \"") + name + '"');
    }
    for (const char* name :
         {"", "2wet", "_wet", "wet__ness", "gl_wet", "agaaWet", "AGAA_WET", "wet-ness", "wet ness",
          "abcdefghijklmnopqrstuvwxyz012345", "float", "vec3", "diffuse", "normal", "samples", "w\xC3\xA4t"}) {
        ViewParts parts(test.sdk, nullptr);
        customLayout(parts);
        parts.layout.attributes[5].name = name;
        expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, std::string("a custom attribute \"") + name + '"');
    }
}

// Tests channels and the dependencies on other attributes. All other members have separate tests.
void testAttributeMembers(Test& test) {
    struct Row {
        const char* what;
        uint32_t attribute, channels;
    };
    for (const Row& row : {Row{"DIFFUSE with 1 channel", 0, 1}, Row{"DIFFUSE with 4 channels", 0, 4},
                           Row{"NORMAL with 2 channels", 1, 2}, Row{"SPECULAR with 1 channel", 2, 1},
                           Row{"ROUGHNESS with 3 channels", 3, 3}, Row{"EMISSIVE with 2 channels", 4, 2},
                           Row{"CUSTOM with 0 channels", 5, 0}, Row{"CUSTOM with 5 channels", 5, 5}}) {
        ViewParts parts(test.sdk, nullptr);
        customLayout(parts);
        parts.layout.attributes[row.attribute].channels = row.channels;
        expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, row.what);
    }
    ViewParts parts(test.sdk, nullptr);
    customLayout(parts);
    parts.layout.attributes[5].name = nullptr;
    expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, "CUSTOM without a name");
    ViewParts named(test.sdk, nullptr);
    simpleLayout(named);
    named.layout.attributes[0].name = "albedo";
    expectViewRefused(test, named, AGAA_ERROR_LAYOUT, "DIFFUSE with a name");
}

// Tests an attribute with AGAA_FILTER_CLASS.
void testClasses(Test& test) {
    struct Row {
        const char* what;
        uint32_t channels, sampleBits, aggregateBits;
        float range;
        bool isSecond, isAccepted;
    };
    for (const Row& row : {Row{"a class", 1, 8, 8, 255, false, true},
                           {"a class with aggregateBits of 0", 1, 8, 0, 255, false, true},
                           {"a class with 2 channels", 2, 8, 8, 255, false, false},
                           {"a class with sampleBits of 16", 1, 16, 8, 255, false, true},
                           {"a class with aggregateBits of 16", 1, 8, 16, 255, false, false},
                           {"a class with range 1", 1, 8, 8, 1, false, false},
                           {"two classes", 1, 8, 8, 255, true, false}}) {
        ViewParts parts(test.sdk, nullptr);
        simpleLayout(parts);
        AgaaLayoutAttribute kind = AGAA_LAYOUT_ATTRIBUTE_INIT;
        kind.semantic = AGAA_SEMANTIC_CUSTOM;
        kind.channels = row.channels;
        kind.sampleBits = row.sampleBits;
        kind.aggregateBits = row.aggregateBits;
        kind.filter = AGAA_FILTER_CLASS;
        kind.range = row.range;
        for (const char* name : {"kind", "sort"}) {
            kind.name = name;
            if (!row.isSecond && parts.layout.attributeCount > 5)
                break;
            parts.layout.attributes[parts.layout.attributeCount++] = kind;
        }
        if (row.isAccepted)
            expectAccepted(test, parts, row.what);
        else
            expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, row.what, "class");
    }
}

// Tests the member also if another member is wrong.
void testReservedMembers(Test& test) {
    for (uint32_t i = 0; i < 5; ++i) {
        ViewParts parts(test.sdk, nullptr);
        simpleLayout(parts);
        parts.layout.attributes[i].reserved[1] = 1;
        expectViewRefused(test, parts, AGAA_ERROR_OUT_OF_RANGE,
                          "AgaaLayoutAttribute::reserved of attribute " + std::to_string(i), "reserved");
    }
    ViewParts parts(test.sdk, nullptr);
    simpleLayout(parts);
    parts.layout.reserved = 1;
    parts.layout.attributeCount = 0;
    expectViewRefused(test, parts, AGAA_ERROR_OUT_OF_RANGE, "AgaaLayout::reserved of an empty layout", "reserved");
}

// Emission of one channel is a factor of the diffuse albedo.
void testNoDiffuse(Test& test) {
    for (const uint32_t channels : {1u, 3u}) {
        ViewParts parts(test.sdk, nullptr);
        simpleLayout(parts);
        parts.layout.attributes[4].channels = channels;
        parts.facts.flags |= AGAA_FACT_NO_DIFFUSE;
        if (channels == 3)
            expectAccepted(test, parts, "AGAA_FACT_NO_DIFFUSE and emission of three channels");
        else
            expectViewRefused(test, parts, AGAA_ERROR_LAYOUT, "AGAA_FACT_NO_DIFFUSE and emission of one channel");
        parts.facts.flags &= ~AGAA_FACT_EMISSIVE;
        expectAccepted(test, parts, "AGAA_FACT_NO_DIFFUSE without AGAA_FACT_EMISSIVE");
    }
}

} // namespace

void addLayoutMemberCases(Suite& suite) {
    addAttributes(suite);
    addAttribute(suite, {"AgaaLayout.attributeCount/range",
                         "AgaaLayout::attributeCount",
                         setCount,
                         {2, 3, 12},
                         largeNumbers({0, 1}),
                         nullptr,
                         {AGAA_MAX_LAYOUT_ATTRIBUTES + 1}});
    addMember(suite, {"AgaaLayout.reserved/zero",
                      "AgaaLayout::reserved",
                      [](ViewParts& p, double x) { p.layout.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      simpleLayout,
                      {1}});
    suite.core("AgaaLayoutAttribute.name/AGAA_ERROR_LAYOUT", testNames);
    suite.core("AgaaLayout/AGAA_ERROR_LAYOUT", testAttributeMembers);
    suite.core("AGAA_FILTER_CLASS/AGAA_ERROR_LAYOUT", testClasses);
    suite.core("AgaaLayout/AGAA_ERROR_OUT_OF_RANGE", testReservedMembers);
    suite.core("AGAA_FACT_NO_DIFFUSE/AGAA_ERROR_LAYOUT", testNoDiffuse);
}

} // namespace agaa::conformance
