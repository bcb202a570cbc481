// Products of settings, of which each graphics API renders every second one.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <string_view>

namespace agaa::test {

// Returns 0 for one half of the tests and 1 for the other one.
inline size_t halfOfTest() {
    const std::string_view name = testing::UnitTest::GetInstance()->current_test_info()->name();
    return std::accumulate(name.begin(), name.end(), size_t(0)) % 2;
}

// Returns whether the tests of Host render setting number `index` of a product. The other graphics API, which has the
// same shaders, renders the rest. With AGAA_ALL_SETTINGS in the environment each graphics API renders all of them. With
// AGAA_ALTERNATING_SETTINGS it renders the settings of the other one in half of the tests: for suites that the other
// one does not run.
template <class Host> bool rendersSetting(size_t index) {
    static const bool rendersAll = std::getenv("AGAA_ALL_SETTINGS") != nullptr;
    static const bool alternates = std::getenv("AGAA_ALTERNATING_SETTINGS") != nullptr;
    return rendersAll || (index + (alternates ? halfOfTest() : 0)) % 2 == Host::settingShare;
}

// Counts the settings of a test.
template <class Host> class SettingCounter {
public:
    // Returns whether this graphics API renders the next setting.
    bool rendersNext() { return rendersSetting<Host>(setting_++); }

private:
    size_t setting_ = 0;
};

} // namespace agaa::test
