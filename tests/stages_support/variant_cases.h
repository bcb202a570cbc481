// Frames with fewer facts than their view: what they show, which variant they run with, and that nothing compiles while
// they are recorded. Each graphics API instantiates these.
#pragma once

#include "agreement.h"
#include "hard_case_test.h"
#include "host_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agaa::test {

inline AgaaSceneFacts sceneFacts(uint64_t flags, uint32_t shadows, uint32_t lights = 64) {
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = flags;
    facts.shadowMapCount = shadows;
    facts.maxLights = lights;
    return facts;
}

// Triangles whose materials have no effect beyond these.
inline std::vector<Triangle> trianglesWithin(uint64_t flags) {
    std::vector<Triangle> list = randomTriangles({.triangles = 150, .duplicates = 0.1f, .masked = 0.2f}, 61);
    for (Triangle& t : list) {
        if (!(flags & AGAA_FACT_SPECULAR)) {
            t.material.specular = glm::vec4(0);
            t.material.normal.w = 1;
        }
        if (!(flags & AGAA_FACT_EMISSIVE))
            t.material.emissive = glm::vec4(0);
    }
    return list;
}

// A view of a scene with a sun, half of whose light a shadow map lets through, and ambient light.
template <class Host> class FactsRig {
public:
    FactsRig(typename Host::Context& context, ViewSettings settings, const std::vector<Triangle>& triangles)
        : map_(Host::shadowMap(context, 0.5f)) {
        settings.config.flags |= AGAA_CONFIG_COUNTERS;
        if (settings.fetches())
            ids_.emplace(context, settings, Shot{.triangles = triangles});
        else
            own_.emplace(context, settings).setTriangles(triangles);
        light_.shadowMap = 0;
        second_.direction[0] = 0.6f;
        second_.direction[2] = -0.8f;
    }

    typename Host::View& view() { return ids_ ? ids_->view() : *own_; }
    AgaaResult prepare(const std::vector<AgaaSceneFacts>& facts) {
        return agaaPrepareVariants(view().get(), uint32_t(facts.size()), facts.data());
    }
    AgaaFrameStatistics statistics() { return view().statistics(); }

    // facts: of the frame, or null; shadows: of these.
    std::vector<float> show(const AgaaSceneFacts* facts, uint32_t shadows) {
        AgaaFrame frame = view().frame();
        addAmbient(frame);
        light_.shadowMap = shadows ? 0 : AGAA_NO_SHADOW;
        const AgaaLight lights[] = {light_, second_};
        frame.lights = lights;
        frame.lightCount = 2;
        frame.shadows = &shadow_;
        frame.shadowCount = shadows;
        frame.facts = facts;
        Host::run(view(), [&](typename Host::Frame& native) {
            if (ids_)
                ids_->bind(native);
            Host::setShadowMap(native, map_);
            EXPECT_EQ(Host::recordFrame(view().get(), &frame, &native), AGAA_OK);
        });
        return withoutAlpha(Host::rgba(view()));
    }
    std::vector<float> show(const AgaaSceneFacts& facts) { return show(&facts, facts.shadowMapCount); }

private:
    std::optional<typename Host::Ids> ids_;
    std::optional<typename Host::View> own_;
    typename Host::ShadowMap map_;
    AgaaShadow shadow_ = shadowAt(0.6f); // behind the map: all is in shadow
    AgaaLight light_ = sun(), second_ = sun();
};

inline double largestRelativeDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = a.size() == b.size() ? 0 : HUGE_VAL;
    for (size_t i = 0; i < a.size() && i < b.size(); ++i)
        largest = std::max(largest, std::abs(double(a[i]) - double(b[i])) / (1 + std::abs(double(b[i]))));
    return largest;
}

struct FactsWay {
    const char* technique;
    uint32_t n;
    uint32_t tier = AGAA_TIER_AUTO;
    uint64_t flags = 0;
    const char* preset = "";
};
inline ViewSettings settingsOf(const FactsWay& way) {
    ViewSettings settings;
    if (*way.preset) {
        EXPECT_EQ(settings.config.applyPreset(way.preset), AGAA_OK);
    }
    settings.config.technique = way.technique;
    settings.config.samples = way.n;
    settings.config.generationTier = way.tier;
    settings.config.flags |= way.flags;
    return settings;
}

template <class Host> class VariantCases : public testing::Test {
protected:
    using Rig = FactsRig<Host>;

    // Frames of these facts: equal with and without a variant of their own, and like those of a view that announces no
    // more.
    void expectEqualImages(const FactsWay& way, const std::vector<AgaaSceneFacts>& list, double bound = 0) {
        SCOPED_TRACE(std::string(way.technique) + " " + agaaTierName(way.tier) + " " + way.preset);
        const ViewSettings settings = settingsOf(way);
        double largest = 0, least = HUGE_VAL;
        for (const AgaaSceneFacts& facts : list) {
            SCOPED_TRACE(facts.flags);
            const std::vector<Triangle> triangles = settleTies(trianglesWithin(facts.flags), context.caps());
            Rig prepared(context, settings, triangles);
            const std::vector<float> unprepared = prepared.show(facts);
            EXPECT_EQ(prepared.statistics().variantFlags, settings.facts.flags);
            EXPECT_EQ(prepared.statistics().variantCount, 1u);
            const uint32_t before = prepared.statistics().compiledPipelines;
            ASSERT_EQ(prepared.prepare({facts}), AGAA_OK);
            const std::vector<float> own = prepared.show(facts);
            const AgaaFrameStatistics ran = prepared.statistics();
            EXPECT_EQ(ran.variantFlags, facts.flags);
            EXPECT_EQ(ran.variantShadowMaps, facts.shadowMapCount);
            EXPECT_EQ(ran.variantCount, 2u);
            EXPECT_GT(ran.compiledPipelines, before);
            SCOPED_TRACE("the view's own variant leaves the effects out");
            expectSameImage(own, unprepared, context.caps());
            ViewSettings fewer = settings;
            fewer.facts = facts;
            largest = std::max(largest, largestRelativeDifference(
                                            own, Rig(context, fewer, triangles).show(nullptr, facts.shadowMapCount)));
            EXPECT_GT(sumOf(own), 0);
            least = std::min(least, largestRelativeDifference(own, prepared.show(nullptr, 1)));
        }
        std::printf("%s %s: views of fewer facts differ by %.2g, frames of all facts by %.2g\n", way.technique,
                    agaaTierName(way.tier), largest, least);
        EXPECT_LE(largest, isInOrder(context.caps()) ? bound : std::max(bound, 2e-5));
        EXPECT_GT(least, 0.05) << "what is left out would show";
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(VariantCases);

inline const std::vector<AgaaSceneFacts> fewerFacts = {
    sceneFacts(AGAA_FACT_ALPHA_MASKED, 0), sceneFacts(AGAA_FACT_ALPHA_MASKED | AGAA_FACT_SPECULAR, 1),
    sceneFacts(AGAA_FACT_ALPHA_MASKED | AGAA_FACT_EMISSIVE | AGAA_FACT_AMBIENT, 0)};

// Samples are stored alike, whatever else the layout has.
TYPED_TEST_P(VariantCases, SamplesShowTheEffectsOfTheFrame) {
    this->expectEqualImages({"ssaa", 4}, fewerFacts);
    for (size_t setting = 0;
         const FactsWay& way : {FactsWay{"single", 1}, {"fxaa", 1}, {"simple_complex", 4}, {"adaptive", 4}})
        if (rendersSetting<TypeParam>(setting++))
            this->expectEqualImages(way, {fewerFacts[0]});
}

TYPED_TEST_P(VariantCases, AggregatesShowTheEffectsOfTheFrame) {
    const FactsWay ways[] = {{"agaa", 4, AGAA_TIER_GBUFFER}, // four samples compile sooner than eight
                             {"agaa", 4, AGAA_TIER_PER_SAMPLE},     {"agaa", 4, AGAA_TIER_GBUFFER, 0, "accurate"},
                             {"agaa", 64, AGAA_TIER_FRAGMENTS},     {"sbaa", 4},
                             {"dcaa", 32, AGAA_TIER_MATERIAL_LISTS}};
    for (const FactsWay& way : ways)
        if (rendersSetting<TypeParam>(size_t(&way - ways)))
            this->expectEqualImages(way, {fewerFacts[0]});
    // Views that announce no specular light weigh no gloss when they group samples.
    this->expectEqualImages({"agaa", 8, AGAA_TIER_IDS, 0, "accurate"}, {fewerFacts[0]}, 0.05);
}

// What a frame's surfaces have beyond its facts is not shown either.
TYPED_TEST_P(VariantCases, SurfacesMayHaveMore) {
    FactsRig<TypeParam> rig(this->context, settingsOf({"ssaa", 4}), trianglesWithin(AGAA_FACT_ALL_SHADED));
    FactsRig<TypeParam> plain(this->context, settingsOf({"ssaa", 4}), trianglesWithin(0));
    for (const AgaaSceneFacts& facts : fewerFacts)
        if (!(facts.flags & (AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE))) {
            const std::vector<float> expected = plain.show(facts);
            expectSameImage(rig.show(facts), expected, this->context.caps());
            ASSERT_EQ(rig.prepare({facts}), AGAA_OK);
            expectSameImage(rig.show(facts), expected, this->context.caps());
        }
}

// After preparation nothing is compiled, whatever the facts of frames.
TYPED_TEST_P(VariantCases, FactsChangeEachFrameWithoutCompiling) {
    for (const FactsWay& way : {FactsWay{"ssaa", 4}, {"agaa", 8, AGAA_TIER_GBUFFER}}) {
        FactsRig<TypeParam> rig(this->context, settingsOf(way), trianglesWithin(AGAA_FACT_ALL_SHADED));
        std::vector<AgaaSceneFacts> list = fewerFacts;
        list.push_back(sceneFacts(AGAA_FACT_ALL_SHADED, 1));
        list.push_back(sceneFacts(AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT, 1)); // which has no variant of its own
        const std::vector<AgaaSceneFacts> prepared = fewerFacts;
        ASSERT_EQ(rig.prepare(prepared), AGAA_OK);
        std::vector<std::vector<float>> expected;
        for (const AgaaSceneFacts& facts : list)
            expected.push_back(rig.show(facts));
        const AgaaFrameStatistics before = rig.statistics();
        for (uint32_t frame = 0; frame < 100; ++frame) {
            const size_t which = (frame * 7) % list.size();
            ASSERT_EQ(rig.show(list[which]), expected[which]) << frame;
            const AgaaFrameStatistics after = rig.statistics();
            ASSERT_EQ(after.compiledPipelines, before.compiledPipelines) << frame;
            ASSERT_EQ(after.variantFlags, which < prepared.size() ? prepared[which].flags : AGAA_FACT_ALL_SHADED)
                << frame;
        }
        ASSERT_EQ(rig.prepare(prepared), AGAA_OK);
        EXPECT_EQ(rig.statistics().compiledPipelines, before.compiledPipelines) << "variants that are prepared already";
        EXPECT_EQ(rig.statistics().variantCount, 1 + uint32_t(prepared.size()));
        EXPECT_GT(before.compileMilliseconds, 0);
    }
}

TYPED_TEST_P(VariantCases, EqualVariantsSharePipelines) {
    FactsRig<TypeParam> rig(this->context, settingsOf({"ssaa", 4}), trianglesWithin(0));
    const uint32_t before = rig.statistics().compiledPipelines;
    EXPECT_EQ(before, 2u) << "cull lights, shade samples";
    ASSERT_EQ(rig.prepare({sceneFacts(AGAA_FACT_ALL_SHADED & ~AGAA_FACT_ALPHA_MASKED, 1),
                           sceneFacts(AGAA_FACT_ALL_SHADED, 1, 0)}),
              AGAA_OK);
    EXPECT_EQ(rig.statistics().compiledPipelines, before) << "masks and lights change no compute pass";
    EXPECT_EQ(rig.statistics().variantCount, 1u);
    ASSERT_EQ(rig.prepare({sceneFacts(0, 0)}), AGAA_OK);
    EXPECT_EQ(rig.statistics().compiledPipelines, before + 1) << "lights are culled as ever";
    EXPECT_EQ(rig.statistics().variantCount, 2u);
}

// The host's shaders are those of the view's facts.
TYPED_TEST_P(VariantCases, ForwardShadingShowsTheViewsEffects) {
    FactsRig<TypeParam> rig(this->context, settingsOf({"msaa", 4}), trianglesWithin(AGAA_FACT_ALL_SHADED));
    const uint32_t before = rig.statistics().compiledPipelines;
    ASSERT_EQ(rig.prepare({sceneFacts(0, 1)}), AGAA_OK);
    EXPECT_EQ(rig.statistics().compiledPipelines, before);
    const std::vector<float> all = rig.show(nullptr, 1);
    EXPECT_EQ(rig.show(sceneFacts(0, 1)), all);
}

TYPED_TEST_P(VariantCases, SegmentsHaveTheSameFactsAndVariant) {
    using Frame = typename TypeParam::Frame;
    BenchOf<TypeParam> bench;
    const AgaaSceneFacts fewer = sceneFacts(0, 1), all = bench.view.settings().facts;
    AgaaFrame whole = bench.frame();
    whole.facts = &fewer;
    bench.render(whole);
    const std::vector<float> expected = bench.image();
    bench.run([&](Frame& native) {
        AgaaFrame frame = bench.frame();
        frame.facts = &fewer;
        frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
        ASSERT_EQ(bench.record(frame, native), AGAA_OK);
        // A variant that is complete only now does not run the rest of the frame.
        ASSERT_EQ(agaaPrepareVariants(bench.view.get(), 1, &fewer), AGAA_OK);
        frame.segments = AGAA_SEGMENT_SHADING;
        for (const AgaaSceneFacts* other : {&all, static_cast<const AgaaSceneFacts*>(nullptr)}) {
            frame.facts = other;
            EXPECT_EQ(bench.record(frame, native), AGAA_ERROR_OUT_OF_RANGE);
            expectOneSentence(bench.context.lines, AGAA_ERROR_OUT_OF_RANGE, "other facts");
        }
        frame.facts = &fewer;
        EXPECT_EQ(bench.record(frame, native), AGAA_OK);
    });
    EXPECT_EQ(bench.image(), expected);
    EXPECT_EQ(bench.view.statistics().variantFlags, all.flags);
    AgaaFrame next = bench.frame();
    next.facts = &fewer;
    bench.render(next);
    EXPECT_EQ(bench.view.statistics().variantFlags, AGAA_FACT_ALPHA_MASKED);
}

// A frame that fails to begin leaves the frame before it, which goes on, its variant. If passes of the failed frame
// have run, its surfaces hold theirs, and the frame before it cannot go on.
TYPED_TEST_P(VariantCases, FailedFramesChangeNoVariant) {
    using Frame = typename TypeParam::Frame;
    BenchOf<TypeParam> bench;
    const AgaaSceneFacts fewer = sceneFacts(0, 1);
    ASSERT_EQ(agaaPrepareVariants(bench.view.get(), 1, &fewer), AGAA_OK);
    bench.run([&](Frame& native) {
        AgaaFrame frame = bench.frame();
        frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
        ASSERT_EQ(bench.record(frame, native), AGAA_OK);
        AgaaFrame next = bench.frame();
        next.frameIndex = frame.frameIndex + 1;
        next.facts = &fewer;
        bench.view.drawResults[AGAA_DRAW_PASS_VISIBILITY] = -77;
        EXPECT_EQ(bench.record(next, native), AGAA_ERROR_CALLBACK);
        bench.view.drawResults.clear();
        frame.segments = AGAA_SEGMENT_SHADING;
        if (!TypeParam::runsAtOnce) {
            EXPECT_EQ(bench.record(frame, native), AGAA_OK);
            return;
        }
        EXPECT_EQ(bench.record(frame, native), AGAA_ERROR_WRONG_ORDER);
        next.facts = nullptr;
        EXPECT_EQ(bench.record(next, native), AGAA_OK);
    });
    EXPECT_EQ(bench.view.statistics().variantFlags, bench.view.settings().facts.flags);
}

TYPED_TEST_P(VariantCases, ResizedViewsKeepTheirVariants) {
    FactsRig<TypeParam> rig(this->context, settingsOf({"ssaa", 4}), trianglesWithin(0));
    const AgaaSceneFacts fewer = sceneFacts(AGAA_FACT_ALPHA_MASKED, 0);
    ASSERT_EQ(rig.prepare({fewer}), AGAA_OK);
    const std::vector<float> expected = rig.show(fewer);
    EXPECT_EQ(agaaResizeView(rig.view().get(), 1u << 20, 5), AGAA_ERROR_TOO_LARGE);
    EXPECT_EQ(rig.show(fewer), expected);
    const ViewSettings& settings = rig.view().settings();
    ASSERT_EQ(agaaResizeView(rig.view().get(), settings.width, settings.height), AGAA_OK);
    EXPECT_EQ(rig.show(fewer), expected);
    const AgaaFrameStatistics statistics = rig.statistics();
    EXPECT_EQ(statistics.variantCount, 2u);
    EXPECT_EQ(statistics.variantFlags, fewer.flags);
    EXPECT_EQ(statistics.compiledPipelines, 3u);
}

REGISTER_TYPED_TEST_SUITE_P(VariantCases, SamplesShowTheEffectsOfTheFrame, AggregatesShowTheEffectsOfTheFrame,
                            SurfacesMayHaveMore, FactsChangeEachFrameWithoutCompiling, EqualVariantsSharePipelines,
                            ForwardShadingShowsTheViewsEffects, SegmentsHaveTheSameFactsAndVariant,
                            FailedFramesChangeNoVariant, ResizedViewsKeepTheirVariants);

} // namespace agaa::test
