// Shaders that are built into the library decompress, and tell which constants they read.
#include "core/base/embedded.h"
#include "core/plan/permutations.h"
#include "core/plan/plan.h"

#include <gtest/gtest.h>

#include <set>

using namespace agaa;

namespace {

// Names of all permutations of a pass that the library has.
std::vector<std::string> permutationsOf(const std::string& shader) {
    const std::span<const Switch> switches = passSwitches(shader);
    std::vector<std::string> names;
    for (uint32_t bits = 0; bits < 1u << switches.size(); ++bits) {
        std::string name = shader + '_';
        for (size_t i = 0; i < switches.size(); ++i)
            name += {switchLetter(switches[i]), char('0' + (bits >> i & 1u))};
        if (hasSpirv(name))
            names.push_back(name);
    }
    return names;
}

TEST(Embedded, EveryModuleIsItsOwn) {
    constexpr uint32_t magic = 0x07230203;
    std::set<std::vector<uint32_t>> modules;
    size_t count = 0;
    for (const char* shader : {"definition", "gather", "shade_aggregates", "aggregate_gbuffer", "shade_surfaces"})
        for (const std::string& name : permutationsOf(shader)) {
            const std::vector<uint32_t> words = embeddedSpirv(name);
            ASSERT_GT(words.size(), 5u) << name;
            EXPECT_EQ(words[0], magic) << name;
            size_t at = 5;
            while (at < words.size() && words[at] >> 16 > 0)
                at += words[at] >> 16;
            EXPECT_EQ(at, words.size()) << name << ": instructions do not end with the module.";
            modules.insert(words);
            ++count;
        }
    EXPECT_GT(count, 100u);
    EXPECT_EQ(modules.size(), count);
}

TEST(Embedded, ModulesTellWhichConstantsTheyRead) {
    for (const std::string& name : permutationsOf("shade_aggregates")) {
        EXPECT_TRUE(readsConstant(name, AGAA_WORDS)) << name;
        EXPECT_TRUE(readsConstant(name, AGAA_BRDF)) << name;
    }
    for (const std::string& name : permutationsOf("gather")) {
        EXPECT_TRUE(readsConstant(name, AGAA_WORDS)) << name;
        EXPECT_FALSE(readsConstant(name, AGAA_BRDF)) << name;
    }
    EXPECT_FALSE(readsConstant(permutationsOf("gather").front(), ConstantCount));
    EXPECT_FALSE(readsConstant(permutationsOf("gather").front(), 0xFFFFFFFF));
}

TEST(Embedded, UnknownNamesHaveNothing) {
    for (const char* name : {"", "gather", "gather_", "no pass"}) {
        EXPECT_FALSE(hasSpirv(name)) << name;
        EXPECT_TRUE(embeddedSpirv(name).empty()) << name;
        EXPECT_FALSE(readsConstant(name, AGAA_WORDS)) << name;
    }
}

} // namespace
