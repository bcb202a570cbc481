// Accumulation over frames: "taa", and other techniques with AGAA_CONFIG_ACCUMULATE. Each graphics API instantiates
// these.
#pragma once

#include "filter_cases.h"
#include "view_bench.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace agaa::test {

// Frames of 48 x 32 pixels of rectangles that emit light. Rectangles are in pixels.
inline ViewSettings historySettings(const char* technique = "taa") {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.facts.shadowMapCount = 0;
    settings.config.temporal.currentShare = 0.001f;
    settings.config.temporal.clipDeviations = 0;
    settings.projection = pixelOrthographic(48, 32, 10);
    return settings;
}

inline Material emitting(const glm::vec3& light) {
    Material material;
    material.emissive = glm::vec4(light, 0);
    return material;
}

inline void addBox(std::vector<Triangle>& list, float left, float right, float depth, const glm::vec3& light) {
    for (const Triangle& t : rectangle(left, -10, right, 42, depth, emitting(light)))
        list.push_back(t);
}

// A camera that moved by `moved` pixels to the right since the previous frame.
inline AgaaTemporalFrame cameraMove(const ViewSettings& settings, float moved = 0) {
    AgaaTemporalFrame history = AGAA_TEMPORAL_FRAME_INIT;
    history.resets = 0;
    history.toPreviousView[12] = moved;
    std::copy_n(&settings.projection[0][0], 16, history.previousProjection);
    return history;
}

// Renders frames of one view, each with its own triangles and history.
template <class Host> class HistoryBench {
public:
    HistoryBench(typename Host::Context& context, const ViewSettings& settings, const std::vector<Triangle>& triangles)
        : history_(AGAA_TEMPORAL_FRAME_INIT), bench_(context, settings, shot(triangles)) {
        bench_.setTriangles(triangles);
    }

    std::vector<float> next(const AgaaTemporalFrame& history) {
        history_ = history;
        return bench_.rgb();
    }
    std::vector<float> next(const AgaaTemporalFrame& history, const std::vector<Triangle>& triangles) {
        bench_.setTriangles(triangles);
        return next(history);
    }

private:
    Shot shot(const std::vector<Triangle>& triangles) {
        return {.triangles = triangles, .lights = {}, .change = [this](AgaaFrame& frame) { frame.pNext = &history_; }};
    }

    AgaaTemporalFrame history_;
    ViewBench<Host> bench_;
};

inline float largestColumnDifference(const std::vector<float>& a, const std::vector<float>& b, uint32_t first = 0,
                                     uint32_t last = 47) {
    float largest = 0;
    for (uint32_t y = 0; y < 32; ++y)
        for (size_t i = 3 * (size_t(y) * 48 + first); i < 3 * (size_t(y) * 48 + last + 1); ++i)
            largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

template <class Host> class HistoryCases : public testing::Test {
protected:
    using Bench = HistoryBench<Host>;
    std::vector<float> single(const std::vector<Triangle>& triangles) {
        return show(context, historySettings("single"), {.triangles = triangles, .lights = {}}).rgb;
    }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(HistoryCases);

// The known answer: the mean of all frames. Images of 16 bits are off by 2^-11 in each frame at most.
TYPED_TEST_P(HistoryCases, AStillImageIsTheMeanOfItsFrames) {
    const ViewSettings settings = historySettings();
    std::vector<Triangle> walls[6];
    for (int i = 0; i < 6; ++i)
        addBox(walls[i], -10, 58, 5, glm::vec3(0.1f + 0.2f * float(i), 0.5f, 1.0f - 0.1f * float(i)));
    typename TestFixture::Bench bench(this->context, settings, walls[0]);
    std::vector<float> mean(3 * 48 * 32, 0.0f), found;
    for (int i = 0; i < 6; ++i) {
        const std::vector<float> frame = this->single(walls[i]);
        for (size_t k = 0; k < mean.size(); ++k)
            mean[k] += (frame[k] - mean[k]) / float(i + 1);
        found = bench.next(cameraMove(settings), walls[i]);
    }
    EXPECT_LT(largestColumnDifference(found, mean), 2e-3f);
}

TYPED_TEST_P(HistoryCases, SharesOfFramesDecay) {
    ViewSettings settings = historySettings();
    settings.config.temporal.currentShare = 0.5f;
    std::vector<Triangle> dark, bright;
    addBox(dark, -10, 58, 5, glm::vec3(0));
    addBox(bright, -10, 58, 5, glm::vec3(1));
    typename TestFixture::Bench bench(this->context, settings, bright);
    bench.next(cameraMove(settings), bright);
    float expected = 1;
    for (int i = 0; i < 4; ++i) {
        const std::vector<float> found = bench.next(cameraMove(settings), dark);
        expected *= 0.5f;
        EXPECT_NEAR(found[0], expected, 1e-3f);
    }
    // The previous frame alone.
    settings.config.temporal.flags = AGAA_TEMPORAL_LAST_FRAME_ONLY;
    typename TestFixture::Bench pair(this->context, settings, bright);
    pair.next(cameraMove(settings), bright);
    EXPECT_NEAR(pair.next(cameraMove(settings), dark)[0], 0.5f, 1e-3f);
    EXPECT_NEAR(pair.next(cameraMove(settings), dark)[0], 0.0f, 1e-3f);
}

TYPED_TEST_P(HistoryCases, ResetsForgetEarlierFrames) {
    const ViewSettings settings = historySettings();
    std::vector<Triangle> dark, bright;
    addBox(dark, -10, 58, 5, glm::vec3(0.25f));
    addBox(bright, -10, 58, 5, glm::vec3(1));
    typename TestFixture::Bench bench(this->context, settings, bright);
    const std::vector<float> first = bench.next(cameraMove(settings), bright);
    EXPECT_LT(largestColumnDifference(first, this->single(bright)), 1e-3f) << "a view has no history at first";
    const std::vector<float> after = bench.next(AGAA_TEMPORAL_FRAME_INIT, dark);
    EXPECT_LT(largestColumnDifference(after, this->single(dark)), 1e-3f);
    EXPECT_GT(largestColumnDifference(bench.next(cameraMove(settings), bright), this->single(bright)), 0.3f);
}

inline std::vector<float> meanOf(const std::vector<float>& a, const std::vector<float>& b) {
    std::vector<float> mean(a.size());
    for (size_t i = 0; i < a.size(); ++i)
        mean[i] = 0.5f * (a[i] + b[i]);
    return mean;
}

// Stripes of unequal widths move by whole pixels and become darker: the image is the mean of both lights, where both
// frames saw it.
TYPED_TEST_P(HistoryCases, HistoryFollowsTheCamera) {
    const ViewSettings settings = historySettings();
    const auto stripes = [](float moved, float light) {
        std::vector<Triangle> list;
        for (int i = -4; i < 16; ++i)
            addBox(list, float(5 * i + i % 3) - moved, float(5 * (i + 1) + (i + 1) % 3) - moved, 5,
                   light * glm::vec3(i & 1 ? 0.8f : 0.1f, 0.3f, 0.1f * float(i & 7)));
        return list;
    };
    const std::vector<float> expected = meanOf(this->single(stripes(3, 1)), this->single(stripes(3, 0.5f)));
    for (const bool isTold : {true, false}) {
        typename TestFixture::Bench bench(this->context, settings, stripes(0, 1));
        bench.next(cameraMove(settings));
        const std::vector<float> found = bench.next(cameraMove(settings, isTold ? 3.0f : 0.0f), stripes(3, 0.5f));
        const float difference = largestColumnDifference(found, expected, 0, 42);
        if (isTold) {
            EXPECT_LT(difference, 2e-3f);
        } else {
            EXPECT_GT(difference, 0.2f);
        }
    }
}

// A jittered camera that stands still looks history up in the same pixels: the image is the mean of both frames. The
// triangles move as the projection would move them.
TYPED_TEST_P(HistoryCases, JitterIsNoMotion) {
    const ViewSettings settings = historySettings();
    const auto scene = [](glm::vec2 moved) {
        std::vector<Triangle> list;
        addBox(list, -10, 58, 8, glm::vec3(0.1f));
        for (const Triangle& t : rectangle(20 + moved.x, 10 + moved.y, 58, 42, 7, emitting(glm::vec3(1))))
            list.push_back(t);
        return list;
    };
    const glm::vec2 offset(0.4f, -0.3f);
    const std::vector<float> expected = meanOf(this->single(scene({0, 0})), this->single(scene(offset)));
    for (const bool isTold : {true, false}) {
        AgaaTemporalFrame history = AGAA_TEMPORAL_FRAME_INIT;
        bool isMoved = false;
        ViewBench<TypeParam> bench(this->context, settings,
                                   {.triangles = scene({0, 0}), .lights = {}, .change = [&](AgaaFrame& frame) {
                                        frame.pNext = &history;
                                        if (isMoved) {
                                            frame.projection[12] += 2 * offset.x / 48;
                                            frame.projection[13] += 2 * offset.y / 32;
                                        }
                                    }});
        bench.setTriangles(scene({0, 0}));
        bench.rgb();
        history = cameraMove(settings);
        history.jitter[0] = isTold ? offset.x : -offset.x;
        history.jitter[1] = isTold ? offset.y : -offset.y;
        isMoved = true;
        bench.setTriangles(scene(offset));
        const float difference = largestColumnDifference(bench.rgb(), expected);
        if (isTold) {
            EXPECT_LT(difference, 2e-3f);
        } else {
            EXPECT_GT(difference, 0.05f);
        }
    }
}

inline std::vector<Triangle> movedEdge(float slope, bool isTransposed, float offset) {
    std::vector<Triangle> list = slopedEdge(slope, isTransposed);
    for (Triangle& t : list)
        for (glm::vec3& corner : t.position)
            corner += glm::vec3(offset, offset, 0);
    return list;
}

// SMAA T2x: the shares of both frames are those of the line that the jitter moved. Their mean is nearer to the line
// than that of frames that take the moved line for the line.
TYPED_TEST_P(HistoryCases, SmaaOfTwoFramesKnowsTheirJitter) {
    ViewSettings settings = filterSettings("smaa");
    settings.config.flags |= AGAA_CONFIG_ACCUMULATE;
    settings.config.temporal.flags = AGAA_TEMPORAL_LAST_FRAME_ONLY;
    settings.config.temporal.clipDeviations = 0;
    glm::dvec3 sums(0);
    for (const bool isTransposed : {false, true})
        for (const float slope : {0.3f, 0.23f, -0.14f, 0.93f, -0.93f}) {
            AgaaTemporalFrame history = AGAA_TEMPORAL_FRAME_INIT;
            float offset = 0.25f;
            const auto frame = [&](AgaaFrame& f) {
                f.pNext = &history;
                f.projection[12] += 2 * offset / 48;
                f.projection[13] += 2 * offset / 32;
            };
            const auto first = movedEdge(slope, isTransposed, offset);
            ViewBench<TypeParam> bench(this->context, settings, {.triangles = first, .lights = {}, .change = frame});
            std::vector<float> told;
            for (const float jitter : {0.25f, -0.25f}) {
                offset = jitter;
                history = cameraMove(settings);
                history.jitter[0] = history.jitter[1] = jitter;
                bench.setTriangles(movedEdge(slope, isTransposed, jitter));
                told = bench.rgb();
            }
            const auto oneFrame = [&](float moved) {
                return show(this->context, filterSettings("smaa"),
                            {.triangles = movedEdge(slope, isTransposed, moved), .lights = {}})
                    .rgb;
            };
            const double error = coverageError(told, slope, isTransposed),
                         ofMean = coverageError(meanOf(oneFrame(0.25f), oneFrame(-0.25f)), slope, isTransposed),
                         ofOne = coverageError(oneFrame(0), slope, isTransposed);
            std::printf("slope %5.2f%s: error of coverage %.3f, without the jitter %.3f, of one frame %.3f\n",
                        double(slope), isTransposed ? " transposed" : "", error, ofMean, ofOne);
            EXPECT_LT(error, ofMean + 0.008) << slope;
            sums += glm::dvec3(error, ofMean, ofOne);
        }
    EXPECT_LT(sums.x, 0.5 * sums.y);
    EXPECT_LT(sums.x, 1.2 * sums.z);
}

// A near box goes away. What it hid has no history; with any tolerance of distances, its ghost would remain.
TYPED_TEST_P(HistoryCases, DisoccludedPixelsHaveNoGhosts) {
    for (const bool toleratesAll : {false, true}) {
        ViewSettings settings = historySettings();
        settings.config.temporal.depthTolerance = toleratesAll ? 1e6f : 0.05f;
        std::vector<Triangle> wall, both;
        addBox(wall, -10, 58, 8, glm::vec3(0.2f));
        both = wall;
        addBox(both, 16, 32, 3, glm::vec3(1));
        typename TestFixture::Bench bench(this->context, settings, both);
        bench.next(cameraMove(settings));
        const std::vector<float> found = bench.next(cameraMove(settings), wall);
        const float ghost = largestColumnDifference(found, this->single(wall), 18, 29);
        if (toleratesAll) {
            EXPECT_GT(ghost, 0.3f);
        } else {
            EXPECT_LT(ghost, 1e-3f);
        }
    }
}

// A material that is not finite for one frame: its pixels stay finite, later frames forget it, and pixels that show
// none of it are those of a finite one.
TYPED_TEST_P(HistoryCases, BadValuesStayInTheirPixelsAndPass) {
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    ViewSettings settings = historySettings();
    settings.config.temporal.currentShare = 0.5f;
    const auto scene = [](float value) {
        std::vector<Triangle> list;
        addBox(list, -10, 58, 8, glm::vec3(0.4f));
        addBox(list, 20, 28, 5, glm::vec3(value, 0.5f, 0.25f));
        return list;
    };
    const auto framesAfter = [&](float value) {
        typename TestFixture::Bench bench(this->context, settings, scene(0.5f));
        std::vector<std::vector<float>> frames;
        for (int i = 0; i < 12; ++i)
            frames.push_back(bench.next(cameraMove(settings), scene(i == 1 ? value : 0.5f)));
        return frames;
    };
    const auto good = framesAfter(0.5f);
    for (const float value : {nan, infinity, -infinity, 1e30f}) {
        const auto bad = framesAfter(value);
        for (size_t i = 0; i < bad.size(); ++i) {
            EXPECT_TRUE(std::all_of(bad[i].begin(), bad[i].end(), [](float v) { return std::isfinite(v) && v >= 0; }))
                << value << ", frame " << i;
            // The cubic lookup of the history reads two pixels more.
            EXPECT_EQ(largestColumnDifference(bad[i], good[i], 0, 17), 0) << value << ", frame " << i;
            EXPECT_EQ(largestColumnDifference(bad[i], good[i], 30, 47), 0) << value << ", frame " << i;
        }
        // The largest emission is 16; half of it remains after each frame.
        EXPECT_LT(largestColumnDifference(bad.back(), good.back()), 16.0f / 1024) << value;
    }
}

// Around an even colour no other colour is likely.
TYPED_TEST_P(HistoryCases, HistoryIsClippedToTheColoursAround) {
    ViewSettings settings = historySettings();
    settings.config.temporal.clipDeviations = 1;
    std::vector<Triangle> red, green;
    addBox(red, -10, 58, 5, glm::vec3(1, 0, 0));
    addBox(green, -10, 58, 5, glm::vec3(0, 0.5f, 0));
    typename TestFixture::Bench bench(this->context, settings, red);
    bench.next(cameraMove(settings));
    EXPECT_LT(largestColumnDifference(bench.next(cameraMove(settings), green), this->single(green)), 2e-3f);
}

// A box of stripes moves by four pixels before a wall that stands still.
TYPED_TEST_P(HistoryCases, HistoryFollowsMotionVectors) {
    const AgaaLayout layout = layoutWithVelocity();
    ViewSettings settings = historySettings();
    settings.config.layout = &layout;
    settings.config.temporal.motion = "velocity";
    settings.surface = "if (position.z > -4.0) s.velocity = (32768.0 + 32767.0 * vec2(-4.0 / 48.0, 0.0)) / 65535.0; "
                       "else s.velocity = vec2(0.0);";
    const auto scene = [](float moved, float light) {
        std::vector<Triangle> list;
        addBox(list, -10, 58, 8, glm::vec3(0.2f, 0.9f, 0.2f));
        for (int i = 0; i < 5; ++i)
            addBox(list, 6 + moved + 4 * float(i), 10 + moved + 4 * float(i), 3,
                   light * glm::vec3(0.2f * float(i), 0.1f, 0.5f));
        return list;
    };
    const std::vector<float> expected = meanOf(this->single(scene(4, 1)), this->single(scene(4, 0.5f)));
    typename TestFixture::Bench bench(this->context, settings, scene(0, 1));
    bench.next(cameraMove(settings));
    const std::vector<float> found = bench.next(cameraMove(settings), scene(4, 0.5f));
    EXPECT_LT(largestColumnDifference(found, expected, 12, 27), 2e-3f);
    settings.config.temporal.motion = nullptr;
    typename TestFixture::Bench untold(this->context, settings, scene(0, 1));
    untold.next(cameraMove(settings));
    EXPECT_GT(largestColumnDifference(untold.next(cameraMove(settings), scene(4, 0.5f)), expected, 12, 27), 0.1f);
}

// Any technique with a depth buffer: equal frames have the image of one, within two roundings of 16 bits at the largest
// emission, 16.
TYPED_TEST_P(HistoryCases, OtherTechniquesAccumulate) {
    const std::vector<Triangle> triangles = randomTriangles({.triangles = 60, .masked = 0.3f}, 12);
    for (const char* technique : {"agaa", "msaa", "smaa"}) {
        SCOPED_TRACE(technique);
        ViewSettings settings = historySettings(technique);
        settings.projection = perspective(60, 1.5f, 0.1f, 100);
        const std::vector<float> expected = show(this->context, settings, {.triangles = triangles, .lights = {}}).rgb;
        settings.config.flags |= AGAA_CONFIG_ACCUMULATE;
        typename TestFixture::Bench bench(this->context, settings, triangles);
        bench.next(cameraMove(settings));
        EXPECT_LT(largestColumnDifference(bench.next(cameraMove(settings)), expected), 0.016f);
    }
}

TYPED_TEST_P(HistoryCases, ViewsWithoutDepthAreRefused) {
    ViewSettings settings = historySettings("dcaa");
    settings.config.samples = 64;
    settings.config.generationTier = AGAA_TIER_MATERIAL_LISTS;
    settings.config.flags |= AGAA_CONFIG_ACCUMULATE;
    expectRefused(this->context, settings, AGAA_ERROR_UNSUPPORTED, "dcaa");
    settings.config.coverage.flags = AGAA_COVERAGE_DEPTH_PREPASS;
    expectRefused(this->context, settings, AGAA_ERROR_UNSUPPORTED, "the depth prepass of dcaa");
    settings = historySettings("taa");
    settings.config.temporal.motion = "nothing";
    expectRefused(this->context, settings, AGAA_ERROR_LAYOUT, "an unknown attribute");
}

REGISTER_TYPED_TEST_SUITE_P(HistoryCases, AStillImageIsTheMeanOfItsFrames, SharesOfFramesDecay,
                            ResetsForgetEarlierFrames, HistoryFollowsTheCamera, JitterIsNoMotion,
                            SmaaOfTwoFramesKnowsTheirJitter, BadValuesStayInTheirPixelsAndPass,
                            DisoccludedPixelsHaveNoGhosts, HistoryIsClippedToTheColoursAround,
                            HistoryFollowsMotionVectors, OtherTechniquesAccumulate, ViewsWithoutDepthAreRefused);

} // namespace agaa::test
