// Random numbers of the tests that merge fragments.
#pragma once

#include <cstdint>
#include <random>

struct FragmentRandom {
    std::mt19937 engine;
    float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); }
    uint32_t below(uint32_t n) { return uint32_t(std::uniform_int_distribution<uint32_t>(0, n - 1)(engine)); }
};
