// What the tests of states share.
#pragma once

#include "egl_context.h"
#include "scramble.h"

#include <gtest/gtest.h>

namespace agaa::test {

// More than a frame touches, with gaps and a unit that no context has.
inline gl::StateScope testScope() {
    gl::StateScope scope;
    scope.textureUnits = {0, 1, 2, 3, 7, 16, 31, 100000};
    scope.uniformBindings = {0, 1, 5, 9};
    scope.storageBindings = {0, 2, 3, 7};
    scope.imageUnits = {0, 1, 2, 7};
    return scope;
}

inline std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + '\n';
    return text;
}

// Runs in a context of the core profile and in one of the compatibility profile.
class BothProfiles : public testing::TestWithParam<bool> {
protected:
    BothProfiles() : context(EglContextDesc{.compatibility = GetParam()}) {}
    void TearDown() override { EXPECT_EQ(context.takeMessages(), ""); }

    const GladGLContext& gl() const { return context.gl(); }
    std::vector<StateText> read() const { return readState(gl(), testScope(), GetParam()); }

    EglContext context;
};

inline std::string profileName(const testing::TestParamInfo<bool>& info) {
    return info.param ? "Compatibility" : "Core";
}

} // namespace agaa::test
