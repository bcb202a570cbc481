// Products of settings, of which each graphics API renders every second one.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace agaa::test {

// Returns whether the tests of Host render setting number `index` of a product. The other graphics API, which has the
// same shaders, renders the rest. With AGAA_ALL_SETTINGS in the environment each graphics API renders all of them.
template <class Host> bool rendersSetting(size_t index) {
    static const bool rendersAll = std::getenv("AGAA_ALL_SETTINGS") != nullptr;
    return rendersAll || index % 2 == Host::settingShare;
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
