// Tiles in batches: nothing is lost if any division in the order of the tiles loses nothing.
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <vector>

namespace {

using Tiles = std::vector<uint32_t>; // fragments of each tile

// Returns a number below the bound.
uint32_t below(std::mt19937& random, uint32_t bound) {
    return std::uniform_int_distribution<uint32_t>(0, bound - 1)(random);
}

struct Division {
    std::vector<uint32_t> batches; // of each tile, from 1
    uint32_t count() const { return batches.empty() ? 0 : batches.back(); }
};

Division divide(const Tiles& tiles, uint32_t capacity) {
    Division division;
    math_f::agaa_TileBatch batch = {1, 0};
    for (const uint32_t fragments : tiles) {
        batch = math_f::agaa_batchOfNextTile(batch, fragments, capacity);
        division.batches.push_back(batch.number);
    }
    return division;
}

// The naive form: tiles whose first fragments are in the same interval share a batch.
Division divideByIntervals(const Tiles& tiles, uint32_t capacity) {
    const uint32_t fullest = *std::max_element(tiles.begin(), tiles.end());
    const uint32_t interval = std::max(capacity, fullest + 1) - fullest;
    Division division;
    uint32_t before = 0;
    for (const uint32_t fragments : tiles) {
        division.batches.push_back(1 + before / interval);
        before += fragments;
    }
    return division;
}

// Returns the fragments without room, if the last of `most` batches has the tiles of all further ones.
uint64_t lostOf(const Division& division, const Tiles& tiles, uint32_t capacity, uint32_t most) {
    std::map<uint32_t, uint64_t> sums;
    for (size_t i = 0; i < tiles.size(); ++i)
        sums[std::min(division.batches[i], most)] += tiles[i];
    uint64_t lost = 0;
    for (const auto& [batch, sum] : sums)
        lost += sum > capacity ? sum - capacity : 0;
    return lost;
}

// Oracle: the fewest groups of consecutive tiles that each have room, by dynamic programming. Tiles must have room.
uint32_t fewestGroups(const Tiles& tiles, uint32_t capacity) {
    std::vector<uint32_t> fewest(tiles.size() + 1, UINT32_MAX);
    fewest[0] = 0;
    for (size_t end = 1; end <= tiles.size(); ++end) {
        uint64_t sum = 0;
        for (size_t begin = end; begin-- > 0;) {
            sum += tiles[begin];
            if (sum > capacity)
                break;
            fewest[end] = std::min(fewest[end], fewest[begin] + 1);
        }
    }
    return fewest.back();
}

TEST(TileBatches, OneFullTileDoesNotShrinkAllBatches) {
    constexpr uint32_t room = 65536, draws = 16;
    Tiles tiles(3000, 100);
    tiles.insert(tiles.begin() + 1500, 60000);
    const Division division = divide(tiles, room);
    EXPECT_LE(division.count(), 7u);
    EXPECT_EQ(lostOf(division, tiles, room, draws - 1), 0u);
    EXPECT_EQ(lostOf(divideByIntervals(tiles, room), tiles, room, draws - 1), 216864u) << "the naive form loses";
}

TEST(TileBatches, AreTheFewestPossible) {
    std::mt19937 random(7);
    uint32_t naiveLosses = 0;
    for (int run = 0; run < 3000; ++run) {
        const uint32_t capacity = 1 + below(random, 5000);
        const double sparse = std::uniform_real_distribution<double>(0, 1)(random);
        const int power = 1 + int(below(random, 6)); // few full tiles among many others
        Tiles tiles(1 + below(random, 120));
        for (uint32_t& fragments : tiles) {
            const double share = std::pow(std::uniform_real_distribution<double>(0, 1)(random), power);
            const bool isEmpty = std::bernoulli_distribution(sparse)(random);
            fragments = isEmpty ? 0 : uint32_t(share * capacity + 0.5);
        }
        const Division division = divide(tiles, capacity);
        const uint32_t fewest = std::max(fewestGroups(tiles, capacity), 1u);
        ASSERT_EQ(division.count(), fewest);
        ASSERT_EQ(lostOf(division, tiles, capacity, fewest), 0u);
        ASSERT_TRUE(std::is_sorted(division.batches.begin(), division.batches.end()));
        naiveLosses += lostOf(divideByIntervals(tiles, capacity), tiles, capacity, fewest) > 0;
    }
    EXPECT_GT(naiveLosses, 1000u);
}

// The pass adds up the tiles of each lane and passes over them at once if all of them have room.
TEST(TileBatches, SumsOfTilesStandForTheTiles) {
    std::mt19937 random(9);
    for (int run = 0; run < 3000; ++run) {
        const uint32_t capacity = 1 + below(random, 1000);
        math_f::agaa_TileBatch whole = {1, below(random, 2 * capacity)}, each = whole;
        uint32_t sum = 0;
        Tiles tiles(below(random, 20));
        for (uint32_t& fragments : tiles)
            sum += fragments = below(random, capacity / 8 + 2);
        if (!math_f::agaa_batchHasRoom(whole, sum, capacity))
            continue;
        for (const uint32_t fragments : tiles)
            each = math_f::agaa_batchOfNextTile(each, fragments, capacity);
        EXPECT_EQ(each.number, whole.number);
        EXPECT_EQ(each.fragments, whole.fragments + sum);
    }
}

TEST(TileBatches, ATileWithoutRoomLosesOnlyItsOwnFragments) {
    constexpr uint32_t room = 100;
    const Tiles tiles = {40, 50, 0, 250, 0, 60, 30};
    const Division division = divide(tiles, room);
    EXPECT_EQ(division.count(), 3u);
    EXPECT_EQ(lostOf(division, tiles, room, 15), 150u);
    EXPECT_EQ(divide({250, 60}, room).batches, (std::vector<uint32_t>{1, 2})) << "no batch stays empty";
    EXPECT_GT(lostOf(divideByIntervals(tiles, room), tiles, room, 15), 150u) << "the naive form loses others";
}

TEST(TileBatches, LargeCountsDoNotWrap) {
    constexpr uint32_t most = UINT32_MAX;
    EXPECT_EQ(math_f::agaa_saturatingSum(most, 1), most);
    EXPECT_EQ(math_f::agaa_saturatingSum(0x80000000u, 0x80000001u), most);
    EXPECT_EQ(math_f::agaa_saturatingSum(3, 4), 7u);
    EXPECT_EQ(divide({most, 10, most - 3, 3, most}, 20).batches, (std::vector<uint32_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(divide({most - 3, 3, 1}, most).batches, (std::vector<uint32_t>{1, 1, 2}));
}

} // namespace
