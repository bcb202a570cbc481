// The guard brings back what scramblers have set, row by row of the table.
#include "gl/state_table.h"
#include "scramblers.h"
#include "support.h"

#include <set>

namespace agaa::test {
namespace {

class GuardTest : public BothProfiles {};

TEST(StateTableTest, namesEachRowOnceAProfile) {
    for (const gl::StateProfile profile : {gl::StateProfile::Core, gl::StateProfile::Compatibility}) {
        std::set<std::pair<std::string, gl::StateArray>> names;
        for (const gl::StateRow& row : gl::stateTable())
            if (row.profile == gl::StateProfile::Any || row.profile == profile) {
                EXPECT_TRUE(names.emplace(row.name, row.array).second) << row.name;
            }
    }
}

TEST(StateTableTest, describesValuesOfKnownTypes) {
    for (const gl::StateRow& row : gl::stateTable()) {
        EXPECT_FALSE(row.layout.empty()) << row.name;
        EXPECT_EQ(row.layout.find_first_not_of("beiulfo"), std::string_view::npos) << row.name;
        EXPECT_NE(std::string(row.description), "") << row.name;
    }
}

TEST(StateTableTest, hasAScramblerForEachRow) {
    for (const gl::StateRow& row : gl::stateTable())
        EXPECT_NE(scramblerOf(row), nullptr) << row.name;
}

// Scrambling one row must be seen in that row and in no other, but for those that OpenGL itself
// couples.
bool coupled(const std::string& scrambled, const std::string& changed) {
    return changed == scrambled.substr(0, scrambled.find(',')) ||
           (scrambled == "GL_VERTEX_ARRAY_BINDING" && changed == "GL_ELEMENT_ARRAY_BUFFER_BINDING");
}

TEST_P(GuardTest, readsWhatWasSetAndNothingElse) {
    HostObjects objects(gl());
    gl::StateGuard guard(gl(), testScope(), GetParam());
    gl().BindVertexArray(objects.vertexArrays[0]); // core contexts have no index buffer without one
    const auto initial = read();
    guard.capture();
    size_t i = 0;
    for (const gl::StateRow& row : gl::stateTable()) {
        if (!guard.context().has(row))
            continue;
        for (const uint32_t element : guard.context().elements(row.array)) {
            bool seen = false;
            for (uint32_t seed = 0; seed < 8; ++seed) {
                ASSERT_TRUE(scrambleRow(guard.context(), objects, seed, row, element));
                const auto scrambled = read();
                for (size_t k = 0; k < initial.size(); ++k) {
                    if (initial[k] == scrambled[k])
                        continue;
                    seen = seen || k == i;
                    EXPECT_TRUE(k == i || coupled(row.name, initial[k].name))
                        << row.name << " changed " << initial[k].name << " to " << scrambled[k].value;
                }
                guard.restore();
            }
            EXPECT_TRUE(seen) << initial[i].name << " stayed " << initial[i].value;
            ++i;
        }
    }
    EXPECT_EQ(joined(differences(initial, read())), "");
}

TEST_P(GuardTest, restoresScrambledStates) {
    HostObjects objects(gl());
    gl::StateGuard guard(gl(), testScope(), GetParam());
    for (uint32_t seed = 0; seed < 64; ++seed) {
        scrambleState(guard.context(), objects, seed);
        const auto before = read();
        guard.capture();
        EXPECT_EQ(joined(differences(before, read())), "") << "capture changed states, seed " << seed;
        scrambleState(guard.context(), objects, seed ^ 1u);
        scrambleState(guard.context(), objects, seed + 1000);
        guard.restore();
        EXPECT_EQ(joined(differences(before, read())), "") << "seed " << seed;
        guard.restore(); // before a draw callback and at the end of the frame
        EXPECT_EQ(joined(differences(before, read())), "") << "seed " << seed;
        ASSERT_EQ(context.takeMessages(), "") << "seed " << seed;
    }
}

TEST_P(GuardTest, restoresInitialState) {
    const auto before = read();
    HostObjects objects(gl());
    gl::StateGuard guard(gl(), testScope(), GetParam());
    EXPECT_EQ(joined(differences(before, read())), "") << "making a guard changes states";
    guard.capture();
    for (uint32_t seed = 0; seed < 8; ++seed) {
        scrambleState(guard.context(), objects, seed);
        guard.restore();
        EXPECT_EQ(joined(differences(before, read())), "") << "seed " << seed;
    }
}

TEST_P(GuardTest, scramblesEveryRowOtherwiseWithTheNextSeed) {
    HostObjects objects(gl());
    gl::StateGuard guard(gl(), testScope(), GetParam());
    std::set<std::string> same;
    for (const StateText& state : read())
        same.insert(state.name);
    for (uint32_t seed = 0; seed < 16; seed += 2) {
        scrambleState(guard.context(), objects, seed);
        const auto even = read();
        scrambleState(guard.context(), objects, seed + 1);
        const auto odd = read();
        for (size_t i = 0; i < even.size(); ++i)
            if (even[i] != odd[i])
                same.erase(even[i].name);
    }
    for (const std::string& name : same)
        ADD_FAILURE() << name << " is the same with all seeds";
}

// The clamp has three names: OpenGL 4.6 and both extensions.
TEST_P(GuardTest, restoresTheClampOfDepthOffsets) {
    if (!gl().ARB_polygon_offset_clamp || !gl().EXT_polygon_offset_clamp)
        GTEST_SKIP() << "the context has no clamp";
    GladGLContext arb = gl(), ext = gl(), none = gl();
    ext.ARB_polygon_offset_clamp = none.ARB_polygon_offset_clamp = 0;
    arb.EXT_polygon_offset_clamp = none.EXT_polygon_offset_clamp = 0;
    arb.VERSION_4_6 = ext.VERSION_4_6 = none.VERSION_4_6 = 0;
    ext.PolygonOffsetClamp = none.PolygonOffsetClamp = nullptr;
    arb.PolygonOffsetClampEXT = none.PolygonOffsetClampEXT = nullptr;
    for (const GladGLContext* table : {&arb, &ext, &none}) {
        gl().PolygonOffsetClamp(2.0f, 3.0f, 0.25f);
        gl::StateGuard guard(*table, testScope(), GetParam());
        guard.capture();
        gl().PolygonOffset(0.0f, 0.0f);
        guard.restore();
        GLfloat factor = 0, clamp = 0;
        gl().GetFloatv(GL_POLYGON_OFFSET_FACTOR, &factor);
        gl().GetFloatv(GL_POLYGON_OFFSET_CLAMP, &clamp);
        EXPECT_EQ(factor, 2.0f);
        EXPECT_EQ(clamp, table == &none ? 0.0f : 0.25f);
    }
}

TEST_P(GuardTest, leavesPendingErrorsAlone) {
    gl::StateGuard guard(gl(), testScope(), GetParam());
    gl().Enable(GL_TEXTURE0);
    guard.capture();
    guard.restore();
    EXPECT_EQ(gl().GetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_NE(context.takeMessages(), "");
}

INSTANTIATE_TEST_SUITE_P(gl, GuardTest, testing::Bool(), profileName);

} // namespace
} // namespace agaa::test
