// Packing: fields never overlap, sums never carry, sizes are those of the papers.
#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/view/layout.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <regex>

using namespace agaa;

namespace {

Layout builtin(const char* name) {
    const AgaaLayout layout = builtinLayout(name);
    return checkLayout(&layout);
}

AgaaLayoutAttribute& addCustom(AgaaLayout& layout, const char* name) {
    AgaaLayoutAttribute& a = layout.attributes[layout.attributeCount++];
    a = {AGAA_SEMANTIC_CUSTOM, 2, 16, 0, 0, AGAA_ENCODING_UNORM, 1, AGAA_FILTER_MEAN, name, {}};
    return a;
}

// Every field with its growth stays in its word and overlaps no other.
void expectSound(const AggregatePacking& packing, uint32_t samples) {
    const uint32_t growth = uint32_t(std::countr_zero(samples));
    std::vector<uint64_t> used(packing.words, 0);
    const auto claim = [&](const Field& field, uint32_t extra) {
        if (!field.bits)
            return;
        ASSERT_LT(field.word, packing.words);
        ASSERT_LE(field.shift + field.bits + extra, 32u);
        const uint64_t mask = ((UINT64_C(1) << (field.bits + extra)) - 1) << field.shift;
        EXPECT_EQ(used[field.word] & mask, 0u);
        used[field.word] |= mask;
        // n values of full scale fit the field.
        if (extra || samples == 1) {
            EXPECT_LE(uint64_t(samples) * ((UINT64_C(1) << field.bits) - 1), (UINT64_C(1) << (field.bits + extra)) - 1);
        }
    };
    for (const Field& field : packing.fields)
        claim(field, field.isUnfiltered ? 0 : growth);
    claim(packing.coverage, 0);
}

// Names of the members of a struct in a file below src/shaders.
std::vector<std::string> membersOf(const char* file, const std::string& structure) {
    const std::string text(embeddedGlsl(file));
    const size_t begin = text.find("struct " + structure + " {"), end = text.find("};", begin);
    EXPECT_NE(begin, std::string::npos) << structure;
    const std::string body = text.substr(begin, end - begin);
    static const std::regex declaration(R"(\n +(?:bool|u?int|float|vec[234]) ([^;]+);)"),
        name(R"(([A-Za-z]\w*)(?:\[\d+\])?)");
    std::vector<std::string> names;
    for (std::sregex_iterator at(body.begin(), body.end(), declaration), none; at != none; ++at) {
        const std::string list = (*at)[1];
        for (std::sregex_iterator one(list.begin(), list.end(), name); one != none; ++one)
            names.push_back((*one)[1]);
    }
    return names;
}

// Attributes of a host become members of these structs.
TEST(Layout, MembersOfShaderStructsAreTaken) {
    for (const auto& [file, structure, least] :
         {std::tuple{"host/surface.glsl", "AgaaSurfaceInput", 15u}, {"common/host_code.glsl", "AgaaMaterial", 6u}}) {
        const std::vector<std::string> names = membersOf(file, structure);
        EXPECT_GE(names.size(), least) << structure;
        for (const std::string& name : names) {
            AgaaLayout layout = builtinLayout("precise");
            addCustom(layout, name.c_str());
            EXPECT_THROW(checkLayout(&layout), Error) << structure << ' ' << name;
        }
    }
}

TEST(Layout, AggregateFieldsNeverOverlapOrCarry) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        AgaaLayout layout = builtinLayout(trial & 1 ? "paper16" : "precise");
        for (uint32_t i = 0; i < layout.attributeCount; ++i) {
            AgaaLayoutAttribute& a = layout.attributes[i];
            a.aggregateBits = random() % 4 ? 6 + random() % 11 : 0;
            if (a.encoding == AGAA_ENCODING_YCBCR)
                a.chromaBits = 6 + random() % 11;
        }
        for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
            expectSound(packAggregate(checkLayout(&layout), samples), samples);
    }
}

// 9 values of full scale do not fit log2(8) bits of growth.
TEST(Layout, RefusesNumbersOfSamplesWhoseSumsWouldCarry) {
    for (uint32_t samples : {0u, 3u, 6u, 9u, 12u, 31u, 33u, 64u})
        try {
            packAggregate(builtin("precise"), samples);
            ADD_FAILURE() << samples;
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_OUT_OF_RANGE) << samples;
            EXPECT_NE(error.message.find(" is " + std::to_string(samples) + ", not one of"), std::string::npos);
        }
}

// The class has a word for itself, with room for the number of its samples above it.
TEST(Layout, ClassesHaveAWordOfTheirOwn) {
    AgaaLayout layout = builtinLayout("precise");
    layout.attributeCount = 4; // no emission: attachments are four
    addCustom(layout, "wind").filter = AGAA_FILTER_NONE;
    AgaaLayoutAttribute& kind = addCustom(layout, "kind");
    kind.channels = 1;
    kind.sampleBits = 8;
    kind.aggregateBits = 0;
    kind.filter = AGAA_FILTER_CLASS;
    kind.range = 255;
    const Layout checked = checkLayout(&layout);
    EXPECT_EQ(checked.classChannel(), 3u);
    EXPECT_EQ(checked.customChannels(), 3u);
    EXPECT_EQ(checked.unfilteredChannels(), 0x103u);
    for (const uint32_t samples : {1u, 8u, 32u}) {
        const AggregatePacking packing = packAggregate(checked, samples);
        expectSound(packing, samples);
        const Field& field = packing.fields[ChannelCustom2];
        EXPECT_EQ(packing.classWord, field.word + 1);
        EXPECT_EQ(field.bits, 8u);
        EXPECT_EQ(field.shift, 0u);
        EXPECT_EQ(packing.unfilteredWords, 1u << field.word | 1u << packing.fields[ChannelCustom0].word);
    }
}

// The value of one sample is the largest word, so it has a word for itself, and its first channel the highest bits.
TEST(Layout, UnfilteredAttributesHaveWordsOfTheirOwn) {
    AgaaLayout layout = builtinLayout("precise");
    addCustom(layout, "part").filter = AGAA_FILTER_NONE;
    layout.attributes[4].channels = 1; // of emission: room in the attachments
    for (uint32_t samples : {1u, 8u, 32u}) {
        const AggregatePacking packing = packAggregate(checkLayout(&layout), samples);
        expectSound(packing, samples);
        const Field& first = packing.fields[ChannelCustom0];
        const Field& second = packing.fields[ChannelCustom1];
        EXPECT_EQ(packing.unfilteredWords, 1u << first.word);
        EXPECT_EQ(first.word, second.word);
        EXPECT_EQ(first.shift, 16u);
        EXPECT_EQ(second.shift, 0u);
        for (uint32_t channel = 0; channel < ChannelCustom0; ++channel)
            EXPECT_NE(packing.fields[channel].word, first.word) << channel;
        EXPECT_NE(packing.coverage.word, first.word);
    }
}

TEST(Layout, Paper16AggregatesTakeTwentyTwentyFourAndThirtyTwoBytes) {
    const Layout layout = builtin("paper16");
    EXPECT_EQ(packAggregate(layout, 8).bytes(), 20u);
    EXPECT_EQ(packAggregate(layout, 16).bytes(), 24u);
    EXPECT_EQ(packAggregate(layout, 32).bytes(), 32u);
}

TEST(Layout, Paper16SamplesTakeTwelveBytesBesideDepth) {
    uint32_t bytes = 0;
    for (Format format : packGBuffer(builtin("paper16")).attachments)
        bytes += bytesPerTexel(format);
    EXPECT_EQ(bytes, 12u);
}

TEST(Layout, PreciseKeepsElevenBitsOrMorePerFragmentAndChannel) {
    for (uint32_t samples : {1u, 2u, 4u, 8u, 16u, 32u})
        for (uint32_t channel = 0; channel < ChannelCustom0; ++channel)
            EXPECT_GE(packAggregate(builtin("precise"), samples).fields[channel].bits, 11u) << samples;
}

TEST(Layout, DropsWhatTheSceneDoesNotCallFor) {
    const Layout plain = reduceLayout(builtin("precise"), 0);
    EXPECT_FALSE(plain.has(AGAA_SEMANTIC_SPECULAR));
    EXPECT_FALSE(plain.has(AGAA_SEMANTIC_EMISSIVE));
    EXPECT_LT(packAggregate(plain, 8).bytes(), packAggregate(builtin("precise"), 8).bytes());
    // Roughness says how wide lobes are: without specular it is dropped, folded or not.
    Layout rough = builtin("paper16");
    rough.attributes[AGAA_SEMANTIC_SPECULAR] = {};
    EXPECT_FALSE(reduceLayout(rough, AGAA_FACT_ALL_SHADED).foldsRoughness());
}

// What facts save, in bytes of a sample and of an aggregate of eight.
TEST(Layout, FactsSaveBytes) {
    struct Row {
        uint64_t facts;
        uint32_t sampleBytes, aggregateBytes;
    };
    constexpr uint64_t all = AGAA_FACT_ALL_SHADED;
    for (const Row& row :
         {Row{all, 22, 36}, Row{all | AGAA_FACT_GREY_SPECULAR, 20, 32}, Row{all | AGAA_FACT_ONE_SPECULAR, 18, 28},
          Row{all | AGAA_FACT_ONE_ROUGHNESS, 20, 32}, Row{all | AGAA_FACT_NO_DIFFUSE, 16, 28},
          Row{all & ~AGAA_FACT_EMISSIVE, 16, 24}, Row{all & ~AGAA_FACT_SPECULAR, 16, 24}}) {
        const Layout layout = reduceLayout(builtin("precise"), row.facts);
        uint32_t bytes = 0;
        for (Format format : packGBuffer(layout).attachments)
            bytes += bytesPerTexel(format);
        EXPECT_EQ(bytes, row.sampleBytes) << row.facts;
        EXPECT_EQ(packAggregate(layout, 8).bytes(), row.aggregateBytes) << row.facts;
        EXPECT_EQ(layout.hasSpecularLight, (row.facts & AGAA_FACT_SPECULAR) != 0);
    }
    constexpr uint64_t flat = AGAA_FACT_PLANE_NORMALS | AGAA_FACT_NO_LOCAL_LIGHTS;
    const auto twoPass = [&](uint64_t facts) { return twoPassLayout(reduceLayout(builtin("precise"), facts), facts); };
    EXPECT_EQ(packAggregate(twoPass(flat), 8).bytes(), 8u);
    EXPECT_EQ(packAggregate(twoPass(0), 8).bytes(), 16u);
    EXPECT_EQ(packAggregate(twoPass(AGAA_FACT_PLANE_NORMALS), 8).bytes(), 16u)
        << "lights near planes need all bits of normals";
    EXPECT_EQ(packAggregate(twoPass(all | flat), 8).bytes(), 36u) << "and highlights";
    Layout kept = reduceLayout(builtin("precise"), all | AGAA_FACT_ONE_ROUGHNESS, true);
    EXPECT_TRUE(kept.has(AGAA_SEMANTIC_ROUGHNESS)) << "of techniques that store widened lobes";
    EXPECT_THROW(reduceLayout(builtin("paper16"), all | AGAA_FACT_NO_DIFFUSE), Error) << "emission is a factor of it";
}

struct BadLayout {
    const char* what;
    void (*spoil)(AgaaLayout&);
};

TEST(Layout, WrongLayoutsAreRefusedWithAReason) {
    const BadLayout table[] = {
        {"twice", [](AgaaLayout& l) { l.attributes[1] = l.attributes[0]; }},
        {"semantic", [](AgaaLayout& l) { l.attributes[0].semantic = 9; }},
        {"channels", [](AgaaLayout& l) { l.attributes[0].channels = 2; }},
        {"sampleBits", [](AgaaLayout& l) { l.attributes[0].sampleBits = 12; }},
        {"aggregateBits", [](AgaaLayout& l) { l.attributes[0].aggregateBits = 17; }},
        {"no normal", [](AgaaLayout& l) { l.attributeCount = 1; }},
        {"range", [](AgaaLayout& l) { l.attributes[0].range = 0; }},
        {"encoding", [](AgaaLayout& l) { l.attributes[0].encoding = 7; }},
        {"folded", [](AgaaLayout& l) { l.attributes[0].encoding = AGAA_ENCODING_FOLDED; }},
        {"count", [](AgaaLayout& l) { l.attributeCount = AGAA_MAX_LAYOUT_ATTRIBUTES + 1; }},
        {"filter", [](AgaaLayout& l) { l.attributes[0].filter = AGAA_FILTER_NONE; }},
        {"name", [](AgaaLayout& l) { l.attributes[0].name = "albedo"; }},
        {"custom without a name", [](AgaaLayout& l) { addCustom(l, nullptr); }},
        {"custom of a member's name", [](AgaaLayout& l) { addCustom(l, "normal"); }},
        {"custom of a prefix", [](AgaaLayout& l) { addCustom(l, "agaa_wind"); }},
        {"custom of a macro's prefix", [](AgaaLayout& l) { addCustom(l, "AGAA_SAMPLES"); }},
        {"custom of a keyword", [](AgaaLayout& l) { addCustom(l, "sample"); }},
        {"custom of a macro", [](AgaaLayout& l) { addCustom(l, "rvec3"); }},
        {"custom of no identifier", [](AgaaLayout& l) { addCustom(l, "wind;"); }},
        {"custom of two underscores", [](AgaaLayout& l) { addCustom(l, "wind__x"); }},
        {"custom of 32 letters", [](AgaaLayout& l) { addCustom(l, "abcdefghijklmnopqrstuvwxyzabcdef"); }},
        {"custom of five channels", [](AgaaLayout& l) { addCustom(l, "wind").channels = 5; }},
        {"custom normal of two channels", [](AgaaLayout& l) { addCustom(l, "wind").filter = AGAA_FILTER_NORMAL; }},
        {"custom of an unknown filter", [](AgaaLayout& l) { addCustom(l, "wind").filter = AGAA_FILTER_CLASS + 1; }},
        {"custom of 48 bits unfiltered",
         [](AgaaLayout& l) {
             AgaaLayoutAttribute& a = addCustom(l, "wind");
             a.channels = 3;
             a.filter = AGAA_FILTER_NONE;
         }},
        {"custom twice",
         [](AgaaLayout& l) {
             addCustom(l, "wind");
             addCustom(l, "wind");
         }},
        {"custom of nine channels",
         [](AgaaLayout& l) {
             l.attributeCount = 4; // room for them in the attachments
             for (const char* name : {"a", "b", "c"})
                 addCustom(l, name).channels = 3;
         }},
        {"custom beyond four attachments",
         [](AgaaLayout& l) {
             addCustom(l, "a").channels = 4;
             addCustom(l, "b").channels = 4;
         }},
    };
    for (const BadLayout& row : table) {
        AgaaLayout layout = builtinLayout("precise");
        row.spoil(layout);
        try {
            checkLayout(&layout);
            ADD_FAILURE() << row.what << " was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_LAYOUT) << row.what;
            EXPECT_FALSE(error.message.empty());
        }
    }
}

} // namespace
