// Contexts, views and frames on OpenGL, through the C++ header.
#include "agaa_gl.hpp"
#include "destroyed.h"
#include "egl_context.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

struct OpenGl : testing::Test {
    OpenGl() {
        destroyed::handles().clear();
        egl.gl().GenTextures(1, &output);
        egl.gl().BindTexture(GL_TEXTURE_2D, output);
        egl.gl().TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, 32, 32);
        viewDesc.width = viewDesc.height = 32;
        config.flags = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_CHECK_FACTS | AGAA_CONFIG_BREADCRUMBS;
        facts.maxLights = 2, facts.shadowMapCount = 0;
        viewDesc.config = &config, viewDesc.facts = &facts;
        agaa::bind(device.getProcAddr, device.getProcUser, loader);
        desc.log = sink.get();
        agaa::chain(desc, device, cache);
    }
    ~OpenGl() override {
        egl.gl().DeleteTextures(1, &output);
        EXPECT_EQ(egl.takeMessages(), "");
    }

    // Draws nothing.
    struct Draw {
        uint32_t calls = 0;
        AgaaResult result = AGAA_OK;
        AgaaResult operator()(const AgaaDrawTarget* target) noexcept {
            ++calls;
            return target->framebuffer == 0 ? AgaaResult(AGAA_ERROR_CALLBACK) : result;
        }
    };
    AgaaResult record(AgaaView view, uint64_t index, Draw& draw) {
        AgaaFrame frame = agaa::init<AgaaFrame>();
        AgaaGlFrame glFrame = agaa::init<AgaaGlFrame>();
        const std::vector<AgaaLight> lights(2, agaa::init<AgaaLight>());
        agaa::setLights(frame, lights);
        agaa::setShadows(frame, {});
        agaa::bind(frame.draw, frame.drawUser, draw);
        frame.frameIndex = index, frame.completedFrame = index - 1;
        frame.projection[0] = frame.projection[5] = 1;
        frame.projection[10] = -1.002f, frame.projection[11] = -1, frame.projection[14] = -0.2f;
        glFrame.outputTexture = output;
        const AgaaResult result = agaa::gl::recordFrame(view, frame, glFrame);
        egl.gl().Finish();
        return result;
    }

    agaa::test::EglContext egl;
    GLuint output = 0;
    struct Loader {
        uint32_t calls = 0;
        AgaaGlFunction operator()(const char* name) noexcept {
            ++calls;
            return agaa::test::EglContext::getProcAddr(nullptr, name);
        }
    } loader;
    struct Sink {
        std::string* lines;
        void operator()(AgaaSeverity severity, AgaaResult, std::string_view text) noexcept {
            if (severity == AGAA_SEVERITY_ERROR)
                (*lines += text) += '\n';
        }
    };
    std::string errors;
    agaa::LogSink<Sink> sink{Sink{&errors}};
    AgaaGlDeviceDesc device = agaa::init<AgaaGlDeviceDesc>();
    AgaaGlProgramCache cache = agaa::init<AgaaGlProgramCache>();
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaSceneFacts facts = agaa::init<AgaaSceneFacts>();
    AgaaViewDesc viewDesc = agaa::init<AgaaViewDesc>();
};

TEST_F(OpenGl, OwnersDestroyOnce) {
    std::vector<void*> expected;
    {
        agaa::Context context = agaa::gl::createContext(desc).value();
        EXPECT_GT(loader.calls, 100u);
        agaa::View view = agaa::gl::createView(context.get(), viewDesc).value();
        agaa::View moved = std::move(view);
        EXPECT_EQ(context.reset(), AGAA_ERROR_WRONG_ORDER);
        EXPECT_TRUE(context);
        EXPECT_EQ(errors.rfind("agaaDestroyContext: ", 0), 0u) << errors;
        EXPECT_TRUE(destroyed::handles().empty());
        expected.push_back(moved.get());
        moved = agaa::gl::createView(context.get(), viewDesc).value();
        EXPECT_EQ(destroyed::handles(), expected);
        expected.push_back(moved.get());
        expected.push_back(context.get());
    }
    EXPECT_EQ(destroyed::handles(), expected);
}

TEST_F(OpenGl, FailuresOwnNothing) {
    EXPECT_EQ(agaa::gl::createContext(desc, 99u << 12).code(), AGAA_ERROR_VERSION);
    desc.framesInFlight = 99;
    EXPECT_EQ(agaa::gl::createContext(desc).code(), AGAA_ERROR_OUT_OF_RANGE);
    desc.framesInFlight = 1;
    const agaa::Context context = agaa::gl::createContext(desc).value();
    config.technique = "none";
    const agaa::Result<agaa::View> view = agaa::gl::createView(context.get(), viewDesc);
    EXPECT_EQ(view.code(), AGAA_ERROR_UNSUPPORTED);
    EXPECT_TRUE(destroyed::handles().empty());
    EXPECT_EQ(agaa::gl::getDeviceCaps(nullptr, nullptr, sink.get()).code(), AGAA_ERROR_INVALID_ARGUMENT);
}

TEST_F(OpenGl, ListsOfAView) {
    const agaa::Context context = agaa::gl::createContext(desc).value();
    const auto caps = agaa::gl::getContextCaps(context.get());
    ASSERT_TRUE(caps);
    EXPECT_FALSE(agaa::text(caps->deviceName).empty());
    EXPECT_EQ(agaa::gl::getDeviceCaps(device.getProcAddr, device.getProcUser)->maxImageSize, caps->maxImageSize);
    const agaa::View view = agaa::gl::createView(context.get(), viewDesc).value();

    const auto passes = agaa::getDrawPasses(view.get());
    const auto both = agaa::gl::getDrawPasses(view.get());
    ASSERT_TRUE(passes && both);
    ASSERT_EQ(passes->size(), 2u);
    ASSERT_EQ(both->size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ((*passes)[i].pipelineKey, (*both)[i].pass.pipelineKey);
        EXPECT_EQ((*both)[i].pass.pNext, nullptr);
        AgaaDrawPass pass[2] = {agaa::init<AgaaDrawPass>(), agaa::init<AgaaDrawPass>()};
        AgaaGlDrawPass gl[2] = {agaa::init<AgaaGlDrawPass>(), agaa::init<AgaaGlDrawPass>()};
        uint32_t count = 2;
        pass[0].pNext = &gl[0], pass[1].pNext = &gl[1];
        ASSERT_EQ(agaaGetDrawPasses(view.get(), &count, pass), AGAA_OK);
        EXPECT_EQ(std::memcmp(&(*both)[i].gl, &gl[i], sizeof gl[i]), 0);
        EXPECT_EQ((*both)[i].pass.glslDeclarations, pass[i].glslDeclarations);
    }
    const auto resources = agaa::getGlslResources(view.get(), 1);
    ASSERT_TRUE(resources);
    EXPECT_FALSE(resources->empty());
    EXPECT_EQ(agaa::text(resources->front().name).substr(0, 5), "agaa_");
    EXPECT_EQ(agaa::getGlslResources(view.get(), 9).code(), AGAA_ERROR_OUT_OF_RANGE);

    const auto depth = agaa::gl::getSurface(view.get(), "depth");
    ASSERT_TRUE(depth);
    EXPECT_TRUE(egl.gl().IsTexture(depth->gl.texture));
    EXPECT_EQ(depth->surface.pNext, nullptr);
    EXPECT_EQ(depth->surface.width, agaa::getSurface(view.get(), "depth")->width);
    EXPECT_EQ(agaa::gl::getSurface(view.get(), "none").code(), AGAA_ERROR_INVALID_ARGUMENT);
    const auto programs = agaa::gl::getProgramCache(context.get());
    ASSERT_TRUE(programs);
    EXPECT_GT(programs->size(), 1000u);
}

TEST_F(OpenGl, Frames) {
    desc.framesInFlight = 1;
    const agaa::Context context = agaa::gl::createContext(desc).value();
    const agaa::View view = agaa::gl::createView(context.get(), viewDesc).value();
    EXPECT_EQ(agaa::getFrameStatistics(view.get(), 0).code(), AGAA_NOT_READY);
    EXPECT_EQ(agaa::validateFrame(view.get(), 0).code(), AGAA_NOT_READY);
    EXPECT_EQ(agaa::getFactReport(view.get(), 0).code(), AGAA_NOT_READY);
    EXPECT_EQ(agaa::getBreadcrumbs(view.get()).code(), AGAA_NOT_READY);
    AgaaFrameStatistics statistics = agaa::init<AgaaFrameStatistics>();
    EXPECT_EQ(agaa::getFrameStatistics(view.get(), 0, statistics), AGAA_NOT_READY);
    EXPECT_EQ(statistics.geometryPasses, 2u);

    Draw draw;
    EXPECT_EQ(record(view.get(), 1, draw), AGAA_OK);
    EXPECT_EQ(draw.calls, 2u);
    EXPECT_EQ(agaa::getFrameStatistics(view.get(), 1)->frameIndex, 1u);
    EXPECT_EQ(agaa::validateFrame(view.get(), 1)->visible, 0u);
    EXPECT_EQ(agaa::getFactReport(view.get(), 1)->lightCount, 2u);
    EXPECT_EQ(agaa::getBreadcrumbs(view.get())->ended.frameIndex, 1u);
    draw.result = AGAA_ERROR_CALLBACK;
    EXPECT_EQ(record(view.get(), 2, draw), AGAA_ERROR_CALLBACK);

    AgaaSceneFacts fewer[2] = {facts, facts};
    fewer[1].maxLights = 0;
    EXPECT_EQ(agaa::prepareVariants(view.get(), fewer), AGAA_OK);
    fewer[0].maxLights = 99;
    EXPECT_EQ(agaa::prepareVariants(view.get(), fewer), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaa::resizeView(view.get(), 16, 16), AGAA_OK);
    EXPECT_EQ(agaa::resizeView(view.get(), 0, 16), AGAA_ERROR_OUT_OF_RANGE);
}

// Structs of OpenGL and of frames, of which the library accepts in a chain those that compile.
TEST_F(OpenGl, Chains) {
    const agaa::Context context = agaa::gl::createContext(desc).value();
    const agaa::View view = agaa::gl::createView(context.get(), viewDesc).value();
    const auto isKnown = [](AgaaResult result) { return result != AGAA_ERROR_UNKNOWN_STRUCT; };
    const auto check = [&](auto next, const char* name) {
        using T = decltype(next);
        AgaaSurface surface = agaa::init<AgaaSurface>();
        surface.pNext = &next;
        EXPECT_EQ(isKnown(agaaGetSurface(view.get(), "depth", &surface)), (agaa::isChainable<AgaaSurface, T>)) << name;
        AgaaDrawPass passes[2] = {agaa::init<AgaaDrawPass>(), agaa::init<AgaaDrawPass>()};
        uint32_t count = 2;
        passes[0].pNext = &next;
        EXPECT_EQ(isKnown(agaaGetDrawPasses(view.get(), &count, passes)), (agaa::isChainable<AgaaDrawPass, T>)) << name;
        AgaaFrame frame = agaa::init<AgaaFrame>();
        AgaaGlFrame glFrame = agaa::init<AgaaGlFrame>();
        frame.pNext = &next;
        EXPECT_EQ(isKnown(agaa::gl::recordFrame(view.get(), frame, glFrame)), (agaa::isChainable<AgaaFrame, T>))
            << name;
        frame.pNext = nullptr, glFrame.pNext = &next;
        EXPECT_EQ(isKnown(agaa::gl::recordFrame(view.get(), frame, glFrame)), (agaa::isChainable<AgaaGlFrame, T>))
            << name;
    };
#define AGAA_STRUCT(name, type, size) check(agaa::init<Agaa##name>(), #name);
#define AGAA_GL_STRUCT AGAA_STRUCT
#include "core/base/structs.inc"
}

} // namespace
