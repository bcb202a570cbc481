// Whole frames, recorded in a context in any state by a host that leaves it in any other.
#include "frame_host.h"

#include "core/base/error.h"

#include <cstdlib>
#include <memory>
#include <set>

namespace agaa::test {
namespace {

struct FrameCase {
    const char* name;
    FrameSettings settings;
};

void PrintTo(const FrameCase& value, std::ostream* out) { *out << value.name; }

const FrameCase kCases[] = {
    {"Single", {.technique = "single", .samples = 1}},
    {"Ssaa", {.technique = "ssaa"}},
    {"SsaaComposite", {.technique = "ssaa", .composite = true}},
    {"Fxaa", {.technique = "fxaa", .samples = 1}},
    {"FxaaComposite", {.technique = "fxaa", .samples = 1, .composite = true}},
    {"SimpleComplex", {.technique = "simple_complex"}},
    {"Adaptive", {.technique = "adaptive", .samples = 9}},
    {"Msaa", {.technique = "msaa"}},
    {"MsaaImages", {.technique = "msaa", .storageImages = true}},
    {"Sbaa", {.technique = "sbaa"}},
    {"Agaa", {}},
    {"AgaaScaled", {.samples = 8}},
    {"AgaaComposite", {.composite = true}},
    {"AgaaImages", {.storageImages = true}},
    {"AgaaUniforms", {.storageImages = true, .constants = AGAA_GL_CONSTANTS_UNIFORMS}},
    {"AgaaTexels", {.storageImages = true, .constants = AGAA_GL_CONSTANTS_TEXELS}},
    {"AgaaPostDepth", {.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS}},
    {"AgaaPerSample", {.generationTier = AGAA_TIER_PER_SAMPLE}},
    {"AgaaGbuffer", {.generationTier = AGAA_TIER_GBUFFER}},
    {"AgaaIds", {.samples = 8, .generationTier = AGAA_TIER_IDS, .fetches = true}},
    {"AgaaIdsBuffered", {.generationTier = AGAA_TIER_IDS, .flags = AGAA_CONFIG_BUFFERED, .fetches = true}},
    {"AgaaIdsUnfetched", {.generationTier = AGAA_TIER_IDS, .fetches = true, .fetchFlags = AGAA_FETCH_NOT_ALL_DRAWS}},
};

class FrameTest : public testing::TestWithParam<std::tuple<bool, FrameCase>> {
protected:
    FrameTest()
        : compatibility(std::get<0>(GetParam())), settings(std::get<1>(GetParam()).settings),
          context(EglContextDesc{.compatibility = compatibility}), objects(context.gl()), others(context.gl()),
          touched(context.gl(), touchedScope(settings), compatibility),
          watched(context.gl(), watchedScope(), compatibility) {}
    void TearDown() override { EXPECT_EQ(context.takeMessages(), ""); }

    bool start(AgaaGlStatePolicy policy) {
        host.emplace(context, settings, policy);
        const AgaaResult result = host->createView();
        if (result == AGAA_ERROR_UNSUPPORTED && settings.generationTier != AGAA_TIER_AUTO)
            return false;
        EXPECT_EQ(result, AGAA_OK);
        host->afterDraw = [this](uint32_t draw) {
            scrambleState(touched, others, draw + 31);
            return draw == failing ? AGAA_ERROR_DEVICE : AGAA_OK;
        };
        return result == AGAA_OK;
    }

    // The state on entry, scrambled.
    std::vector<StateText> scrambled(uint32_t seed) {
        host->clearOutput();
        scrambleState(watched, objects, seed);
        host->bindFetched();
        return host->read();
    }
    // Expects draw callbacks to find this state, but for the declared bindings.
    void expectInCallbacks(const std::vector<StateText>& entry) {
        host->beforeDraw = [this, entry] {
            const auto found = host->read();
            for (size_t i = 0; i < entry.size(); ++i)
                if (!isDeclared(entry[i].name)) {
                    EXPECT_EQ(found[i].value, entry[i].value) << entry[i].name << ", in the callback";
                }
        };
    }
    bool isDeclared(const std::string& name) const {
        const auto at = [&](const char* row, uint32_t place) {
            return name.starts_with(row) && name.ends_with(format("[%u]", place));
        };
        const char* storage = settings.storageImages ? "GL_IMAGE_BINDING_NAME" : "GL_SHADER_STORAGE_BUFFER_BINDING";
        for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i)
            if (at("GL_TEXTURE_BINDING", kShadowUnit + i) || at("GL_SAMPLER", kShadowUnit + i))
                return true;
        const char* lights = settings.storageImages ? "GL_UNIFORM_BUFFER_BINDING" : "GL_SHADER_STORAGE_BUFFER_BINDING";
        return at(lights, kLightsBinding) || at("GL_UNIFORM_BUFFER_BINDING", kFrameBinding) ||
               at("GL_TEXTURE_BINDING", kFrameUnit) || at("GL_SAMPLER", kFrameUnit) ||
               at("GL_TEXTURE_BINDING", kMetadataUnit) || at("GL_SAMPLER", kMetadataUnit) ||
               at(storage, kAggregatesBinding) || at(storage, kCountersBinding);
    }
    void expectState(const std::vector<StateText>& entry, const char* when) {
        EXPECT_EQ(joined(differences(entry, host->read())), "") << when;
        EXPECT_EQ(context.takeMessages(), "") << when;
    }

    bool compatibility;
    FrameSettings settings;
    EglContext context;
    HostObjects objects, others;
    gl::StateContext touched, watched;
    std::optional<FrameHost> host;
    uint32_t failing = ~0u; // draw callback
};

TEST_P(FrameTest, restoresTheStateAndDrawsTheSame) {
    if (!start(AGAA_GL_STATE_RESTORE))
        GTEST_SKIP() << "the device has not this tier";
    host->clearOutput();
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::vector<float> expected = host->picture();
    EXPECT_GT(std::set<float>(expected.begin(), expected.end()).size(), 4u) << "nothing was drawn";
    for (uint32_t seed = 0; seed < 6; ++seed) {
        const auto entry = scrambled(seed);
        expectInCallbacks(entry);
        ASSERT_EQ(host->record(), AGAA_OK) << joined(host->log);
        expectState(entry, "after the frame");
        host->readStatistics();
        expectState(entry, "after reading statistics");
        EXPECT_EQ(host->picture(), expected) << "the host's state shows in the picture, seed " << seed;
    }
    EXPECT_EQ(joined(host->log), "");
}

TEST_P(FrameTest, makesAndDestroysWithoutATrace) {
    scrambleState(watched, objects, 5);
    const auto entry = readState(context.gl(), watchedScope(), compatibility);
    if (!start(AGAA_GL_STATE_RESTORE))
        GTEST_SKIP() << "the device has not this tier";
    expectState(entry, "after making the view");
    host.reset();
    EXPECT_EQ(joined(differences(entry, readState(context.gl(), watchedScope(), compatibility))), "");
}

TEST_P(FrameTest, restoresTheStateWhenACallbackFails) {
    if (!start(AGAA_GL_STATE_RESTORE))
        GTEST_SKIP() << "the device has not this tier";
    ASSERT_EQ(host->record(), AGAA_OK);
    const auto draws = static_cast<uint32_t>(std::count(host->calls.begin(), host->calls.end(), 'd'));
    for (failing = 0; failing < draws; ++failing) {
        const auto entry = scrambled(failing + 7);
        expectInCallbacks(entry);
        EXPECT_EQ(host->record(), AGAA_ERROR_CALLBACK);
        expectState(entry, "after the failure");
    }
}

TEST_P(FrameTest, changesNothingWhenAFrameIsRefused) {
    for (const AgaaGlStatePolicy policy : {AGAA_GL_STATE_RESTORE, AGAA_GL_STATE_CALLBACKS, AGAA_GL_STATE_NONE}) {
        if (!start(policy))
            GTEST_SKIP() << "the device has not this tier";
        const auto entry = scrambled(11);
        AgaaFrame frame = host->frame();
        frame.completedFrame = frame.frameIndex;
        EXPECT_EQ(host->record(frame, host->output), AGAA_ERROR_OUT_OF_RANGE);
        EXPECT_EQ(host->record(host->frame(), 0), AGAA_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(host->record(host->frame(), objects.textures[0]), AGAA_ERROR_OUT_OF_RANGE);
        expectState(entry, "after frames that were refused");
        EXPECT_EQ(host->record(host->frame(), objects.arrays[0]), AGAA_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(context.gl().GetError(), GLenum{GL_NO_ERROR});
        context.takeMessages(); // the driver may tell of the wrong target
        expectState(entry, "after a texture of another target");
        EXPECT_EQ(host->calls, "");
        host.reset();
    }
}

TEST_P(FrameTest, restoresTheStateOfEachSegment) {
    if (!start(AGAA_GL_STATE_RESTORE))
        GTEST_SKIP() << "the device has not this tier";
    host->clearOutput();
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::vector<float> expected = host->picture();
    uint32_t seed = 20;
    for (const uint64_t segment : {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING}) {
        const auto entry = scrambled(seed++);
        expectInCallbacks(entry);
        ASSERT_EQ(host->record(host->frame(segment), host->output), AGAA_OK) << joined(host->log);
        expectState(entry, "after a segment");
    }
    EXPECT_EQ(host->picture(), expected);
}

// Targets that the list of states does not have: frames must not touch them, with shadows or without.
TEST_P(FrameTest, leavesTexturesOfOtherTargetsBound) {
    if (!start(AGAA_GL_STATE_NONE))
        GTEST_SKIP() << "the device has not this tier";
    const GladGLContext& gl = context.gl();
    struct Target {
        GLenum target, binding;
        GLuint texture;
    };
    Target targets[] = {{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, 0},
                        {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, 0}};
    constexpr GLuint units = 32;
    for (Target& each : targets) {
        gl.CreateTextures(each.target, 1, &each.texture);
        for (GLuint unit = 0; unit < units; ++unit)
            gl.BindTextureUnit(unit, each.texture);
    }
    const auto expectBound = [&](const char* when) {
        for (const Target& each : targets)
            for (GLuint unit = 0; unit < units; ++unit) {
                GLint bound = 0;
                gl.GetIntegeri_v(each.binding, unit, &bound);
                EXPECT_EQ(GLuint(bound), each.texture) << "unit " << unit << ", " << when;
            }
    };
    host->beforeDraw = [&] { expectBound("in the callback"); };
    host->afterDraw = nullptr;
    ASSERT_EQ(host->record(), AGAA_OK);
    expectBound("after a frame with a shadow map");
    AgaaFrame frame = host->frame();
    AgaaLight sun = *frame.lights;
    sun.shadowMap = AGAA_NO_SHADOW;
    frame.lights = &sun;
    frame.shadowCount = 0;
    ASSERT_EQ(host->record(frame, host->output), AGAA_OK) << joined(host->log);
    expectBound("after a frame without");
    for (const Target& each : targets)
        gl.DeleteTextures(1, &each.texture);
}

// A host that saves on the first push of a frame and restores that at each pop.
TEST_P(FrameTest, callsPushAndPopInTurns) {
    if (!start(AGAA_GL_STATE_CALLBACKS))
        GTEST_SKIP() << "the device has not this tier";
    gl::StateGuard saved(context.gl(), watchedScope(), compatibility);
    host->onPush = [&] {
        if (host->calls == "p")
            saved.capture();
        scrambleState(touched, others, 3); // between push and pop any state is the SDK's to leave
    };
    host->onPop = [&] { saved.restore(); };
    host->clearOutput();
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::vector<float> expected = host->picture();
    const auto draws = static_cast<uint32_t>(std::count(host->calls.begin(), host->calls.end(), 'd'));
    std::string calls = "p";
    for (uint32_t i = 0; i < draws; ++i)
        calls += "odp";
    EXPECT_EQ(host->calls, calls + "o");
    for (uint32_t seed = 40; seed < 43; ++seed) {
        const auto entry = scrambled(seed);
        expectInCallbacks(entry);
        ASSERT_EQ(host->record(), AGAA_OK);
        expectState(entry, "after the frame");
        EXPECT_EQ(host->picture(), expected);
    }
    for (failing = 0; failing < draws; ++failing) {
        scrambled(failing);
        host->beforeDraw = nullptr;
        EXPECT_EQ(host->record(), AGAA_ERROR_CALLBACK);
        // The host is told of no work after its own failure: it drew last, in its own state.
        EXPECT_EQ(std::count(host->calls.begin(), host->calls.end(), 'p'),
                  std::count(host->calls.begin(), host->calls.end(), 'o'))
            << host->calls;
    }
}

// A host with a stack of states, whose draws leave nothing behind.
TEST_P(FrameTest, leavesNothingToAHostThatPushesAndPops) {
    if (!start(AGAA_GL_STATE_CALLBACKS))
        GTEST_SKIP() << "the device has not this tier";
    std::vector<std::unique_ptr<gl::StateGuard>> stack;
    const auto push = [&] {
        stack.push_back(std::make_unique<gl::StateGuard>(context.gl(), watchedScope(), compatibility));
        stack.back()->capture();
    };
    const auto pop = [&] {
        stack.back()->restore();
        stack.pop_back();
    };
    host->onPush = [&] {
        push();
        scrambleState(touched, others, 3);
    };
    host->onPop = pop;
    std::vector<StateText> entry;
    const auto scramble = [&](uint32_t seed) {
        entry = scrambled(seed);
        expectInCallbacks(entry);
        host->beforeDraw = [push, expect = host->beforeDraw] {
            expect();
            push();
        };
        host->afterDraw = [&](uint32_t draw) {
            pop();
            return draw == failing ? AGAA_ERROR_DEVICE : AGAA_OK;
        };
    };
    scramble(60);
    ASSERT_EQ(host->record(), AGAA_OK);
    expectState(entry, "after the frame");
    const auto draws = static_cast<uint32_t>(std::count(host->calls.begin(), host->calls.end(), 'd'));
    for (failing = 0; failing < draws; ++failing) {
        scramble(61 + failing);
        EXPECT_EQ(host->record(), AGAA_ERROR_CALLBACK);
        expectState(entry, "after the failure");
        EXPECT_TRUE(stack.empty());
    }
}

TEST_P(FrameTest, tellsOfPushesAndPopsThatFail) {
    if (!start(AGAA_GL_STATE_CALLBACKS))
        GTEST_SKIP() << "the device has not this tier";
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::string calls = host->calls;
    for (size_t call = 0; call < calls.size(); ++call) {
        if (calls[call] == 'd')
            continue;
        host->failingCall = call;
        host->log.clear();
        EXPECT_EQ(host->record(), AGAA_ERROR_CALLBACK) << calls << " at " << call;
        EXPECT_EQ(host->log.size(), 1u) << joined(host->log);
        EXPECT_EQ(host->calls.size(), call + 1) << host->calls;
    }
    host->failingCall = ~size_t{0};
    EXPECT_EQ(host->record(), AGAA_OK);
}

TEST_P(FrameTest, aSegmentThatCouldNotBeginIsRecordedAgain) {
    if (!start(AGAA_GL_STATE_CALLBACKS))
        GTEST_SKIP() << "the device has not this tier";
    ASSERT_EQ(host->record(host->frame(AGAA_SEGMENT_PREPASS), host->output), AGAA_OK);
    const AgaaFrame rest = host->frame(AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING);
    host->failingCall = host->calls.size();
    EXPECT_EQ(host->record(rest, host->output), AGAA_ERROR_CALLBACK);
    host->failingCall = ~size_t{0};
    EXPECT_EQ(host->record(rest, host->output), AGAA_OK) << joined(host->log);
    host->readStatistics();
}

TEST_P(FrameTest, drawsTheSameWithoutSaving) {
    if (!start(AGAA_GL_STATE_NONE))
        GTEST_SKIP() << "the device has not this tier";
    host->clearOutput();
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::vector<float> expected = host->picture();
    for (uint32_t seed = 50; seed < 53; ++seed) {
        scrambled(seed);
        ASSERT_EQ(host->record(), AGAA_OK);
        EXPECT_EQ(context.takeMessages(), "");
        EXPECT_EQ(host->calls.find_first_not_of('d'), std::string::npos) << host->calls;
        EXPECT_EQ(host->picture(), expected);
    }
}

// Software devices clear by the API, and GPUs fill by a shader.
class FilledFrameTest : public FrameTest {
protected:
    static inline const GladGLContext* driver = nullptr;
    static inline uint32_t fills = 0; // dispatches of the shader that fills
    static void GLAD_API_PTR countFill(GLuint x, GLuint y, GLuint z) {
        ++fills;
        driver->DispatchCompute(x, y, z);
    }
};

TEST_P(FilledFrameTest, byAShaderLeavesTheSameStateAndPicture) {
    driver = &context.gl();
    GladGLContext counting = *driver;
    counting.DispatchCompute = countFill;
    ASSERT_TRUE(start(AGAA_GL_STATE_RESTORE));
    host->clearOutput();
    ASSERT_EQ(host->record(), AGAA_OK);
    const std::vector<float> expected = host->picture();
    host->fillByShader(counting);
    for (uint32_t seed = 70; seed < 72; ++seed) {
        fills = 0;
        const auto entry = scrambled(seed);
        expectInCallbacks(entry);
        ASSERT_EQ(host->record(), AGAA_OK) << joined(host->log);
        EXPECT_GT(fills, 0u);
        expectState(entry, "after a frame that fills by the shader");
        EXPECT_EQ(host->picture(), expected) << seed;
    }
    host.reset(); // before the functions that its context calls
}

INSTANTIATE_TEST_SUITE_P(gl, FilledFrameTest, testing::Combine(testing::Bool(), testing::Values(FrameCase{"Agaa", {}})),
                         [](const auto& info) { return std::get<0>(info.param) ? "Compatibility" : "Core"; });

// Cases have the profiles in turn. With AGAA_ALL_SETTINGS in the environment each case has both.
std::vector<std::tuple<bool, FrameCase>> casesOfProfiles() {
    std::vector<std::tuple<bool, FrameCase>> cases;
    for (size_t i = 0; i < std::size(kCases); ++i)
        for (const bool compatibility : {false, true})
            if (std::getenv("AGAA_ALL_SETTINGS") || compatibility == (i % 2 != 0))
                cases.emplace_back(compatibility, kCases[i]);
    return cases;
}

INSTANTIATE_TEST_SUITE_P(gl, FrameTest, testing::ValuesIn(casesOfProfiles()), [](const auto& info) {
    return std::string(std::get<1>(info.param).name) + (std::get<0>(info.param) ? "Compatibility" : "Core");
});

} // namespace
} // namespace agaa::test
