// The order of rendering, and errors of devices, with a renderer that has no device.
#include "app.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace viewer {
namespace {

using namespace harness;

// Counts what the fake renderers did. Tests set `isLost`.
struct Log {
    std::atomic<int> devices = 0, loads = 0, frames = 0;
    std::atomic<bool> isLost = false;
};

class FakeRenderer : public Renderer {
public:
    explicit FakeRenderer(Log& log) : log_(log) {
        ++log_.devices;
        std::snprintf(caps_.deviceName, sizeof caps_.deviceName, "none");
    }
    const AgaaDeviceCaps& caps() const override { return caps_; }
    void load(const Scene&) override { ++log_.loads; }
    RenderResult render(const RenderSettings& settings) override {
        ++log_.frames;
        if (log_.isLost)
            throw std::runtime_error("The device is lost.");
        RenderResult result;
        const float value = std::string_view(settings.config.technique) == "ssaa" ? 0.5f : 0.25f;
        result.image = {settings.width, settings.height,
                        std::vector<float>(3 * size_t(settings.width) * settings.height, value)};
        result.frameMs = {1};
        result.statistics = {AgaaFrameStatistics AGAA_FRAME_STATISTICS_INIT};
        return result;
    }
    std::vector<ApiMessage> takeMessages() override { return {}; }

private:
    Log& log_;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
};

RendererFactory factoryOf(Log& log) {
    return [&log](const DeviceArguments&) { return std::make_unique<FakeRenderer>(log); };
}

ViewRequest someRequest() {
    ViewRequest request;
    request.a.set("--scene", "hard-stripes");
    request.a.set("--size", "8x4");
    request.measuredFrames = 3;
    return request;
}

// Steps until nothing is left to do. Returns the newest snapshot.
std::shared_ptr<const Snapshot> finish(RenderSession& session, const ViewRequest& request) {
    std::shared_ptr<const Snapshot> newest;
    for (int i = 0; i < 100; ++i) {
        const std::shared_ptr<const Snapshot> next = session.step(request);
        if (!next)
            return newest;
        newest = next;
    }
    ADD_FAILURE() << "The session does not come to an end.";
    return newest;
}

TEST(RenderSession, RendersMeasuresAndRests) {
    Log log;
    RenderSession session(factoryOf(log));
    const auto first = session.step(someRequest());
    ASSERT_TRUE(first && first->a.image);
    EXPECT_TRUE(first->isComplete);
    const auto last = finish(session, someRequest());
    EXPECT_EQ(last->error, "");
    EXPECT_EQ(last->a.figures.timedFrames, 3u);
    EXPECT_TRUE(last->a.figures.counters);
    EXPECT_EQ(last->frames, 4u);
    EXPECT_EQ(log.frames, 5); // the image, counters, three measured frames
    EXPECT_EQ(session.step(someRequest()), nullptr);
}

TEST(RenderSession, KeepsTheSceneTheDeviceAndTheReference) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    request.wantsReference = true;
    request.referenceSamples = 4;
    const auto first = finish(session, request);
    EXPECT_TRUE(first->isReferenceDone);
    ASSERT_TRUE(first->a.error);
    EXPECT_GT(first->a.error->mseTm, 0);
    request.a.set("--technique", "ssaa");
    const auto second = finish(session, request);
    EXPECT_EQ(second->reference, first->reference);
    ASSERT_TRUE(second->a.error);
    EXPECT_EQ(second->a.error->mseTm, 0);
    EXPECT_EQ(log.loads, 1);
    EXPECT_EQ(log.devices, 1);
    request.a.set("--camera", "0,0,3,0,0,0,40");
    EXPECT_NE(finish(session, request)->reference, first->reference);
    request.a.set("--scene", "hard-empty");
    finish(session, request);
    EXPECT_EQ(log.loads, 2);
    request.a.set("--backend", "gl");
    finish(session, request);
    EXPECT_EQ(log.devices, 2);
}

TEST(RenderSession, RendersTheOtherViewWithoutTheFirst) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    const auto first = finish(session, request);
    request.b = request.a;
    request.b->set("--technique", "ssaa");
    const auto both = finish(session, request);
    ASSERT_TRUE(both->b.image);
    EXPECT_EQ(both->a.image, first->a.image);
    EXPECT_NE(both->a.image->rgb, both->b.image->rgb);
}

TEST(RenderSession, ReportsWrongSettingsOnce) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    finish(session, request);
    request.a.set("--ndf", "leen");
    const auto wrong = finish(session, request);
    EXPECT_EQ(wrong->error, "--ndf is \"leen\"; it can be none, toksvig, lean, sggx.");
    EXPECT_EQ(wrong->exitStatus, 2);
    EXPECT_FALSE(wrong->hasFailedDevice);
    EXPECT_TRUE(wrong->a.image); // the last image stays
    request.a.set("--ndf", "lean");
    EXPECT_EQ(finish(session, request)->error, "");
}

TEST(RenderSession, ReportsAMissingFile) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    request.a.set("--scene", "missing.glb");
    const auto missing = finish(session, request);
    EXPECT_NE(missing->error.find("missing.glb"), std::string::npos);
    EXPECT_EQ(missing->exitStatus, 1);
    EXPECT_FALSE(missing->hasFailedDevice);
    EXPECT_EQ(log.devices, 0);
}

TEST(RenderSession, LoadsTheSceneAgainAfterAnErrorInAnother) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    finish(session, request);
    ViewRequest wrong = request;
    wrong.a.set("--scene", "hard-empty");
    wrong.a.set("--fragments-per-pixel", "auto");
    wrong.a.set("--technique", "dcaa");
    wrong.a.set("--samples", "64");
    log.isLost = true; // a frame that determines the capacity fails before the view is ready
    EXPECT_EQ(finish(session, wrong)->error, "The device is lost.");
    EXPECT_EQ(log.loads, 2);
    log.isLost = false;
    EXPECT_EQ(finish(session, request)->error, "");
    EXPECT_EQ(log.loads, 3);
}

TEST(RenderSession, StartsAgainAfterALostDevice) {
    Log log;
    RenderSession session(factoryOf(log));
    ViewRequest request = someRequest();
    finish(session, request);
    log.isLost = true;
    request.a.set("--samples", "4");
    const auto lost = finish(session, request);
    EXPECT_EQ(lost->error, "The device is lost.");
    EXPECT_EQ(lost->exitStatus, 1);
    EXPECT_TRUE(lost->hasFailedDevice);
    const int frames = log.frames;
    EXPECT_EQ(session.step(request), nullptr); // not tried again
    EXPECT_EQ(log.frames, frames);
    log.isLost = false;
    ++request.restarts;
    const auto again = finish(session, request);
    EXPECT_EQ(again->error, "");
    EXPECT_EQ(log.devices, 2);
    EXPECT_TRUE(again->isComplete);
}

// Updates until the condition holds. Returns false after `most` updates.
template <class Condition> bool waitFor(App& app, const Condition& condition, int most = 2000) {
    for (int i = 0; i < most; ++i) {
        app.update();
        if (condition())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

TEST(App, RendersNothingWithoutPixels) {
    Log log;
    App app(
        defaultState(), [] {}, factoryOf(log));
    app.selectScene("hard-stripes");
    app.setViewSize(0, 0);
    EXPECT_FALSE(waitFor(
        app, [&] { return log.devices > 0 || app.width() > 0; }, 50));
    app.setViewSize(16, 8);
    EXPECT_TRUE(waitFor(app, [&] { return app.isSettled(); }));
    EXPECT_EQ(app.width(), 16u);
    EXPECT_EQ(app.state.options.get("--size"), "16x8");
}

TEST(App, AFrozenImageStays) {
    Log log;
    App app(
        defaultState(), [] {}, factoryOf(log));
    app.selectScene("hard-stripes");
    app.setViewSize(16, 8);
    ASSERT_TRUE(waitFor(app, [&] { return app.isSettled(); }));
    app.state.isFrozen = true;
    const harness::Image* image = app.imageA();
    app.selectTechnique("ssaa");
    EXPECT_FALSE(waitFor(
        app, [&] { return app.imageA() != image; }, 50));
    app.state.isFrozen = false;
    EXPECT_TRUE(waitFor(app, [&] { return app.isSettled() && app.imageA() != image; }));
}

TEST(App, PlaysEachCameraOfAPath) {
    Log log;
    ViewerState state = defaultState();
    state.options.set("--scene", "hard-stripes");
    state.path.cameras = {"0,0,1,0,0,0,60", "0,0,2,0,0,0,60", "0,0,3,0,0,0,60"};
    state.path.isPlaying = true;
    App app(
        state, [] {}, factoryOf(log));
    app.setViewSize(16, 8);
    ASSERT_TRUE(waitFor(app, [&] { return !app.state.path.isPlaying && app.isSettled(); }));
    EXPECT_EQ(app.state.options.get("--camera"), state.path.cameras.back());
    EXPECT_GE(app.shown().frames, 3u);
}

TEST(App, OpensAStateByItsName) {
    Log log;
    App app(
        defaultState(), [] {}, factoryOf(log));
    app.open("missing.json");
    EXPECT_NE(app.error().find("missing.json"), std::string::npos);
    app.dismiss();
    EXPECT_EQ(app.error(), "");
}

} // namespace
} // namespace viewer
