// Passes that run several times.
#include "core/base/error.h"
#include "core/plan/plan_builder.h"
#include "plan_support.h"

#include <gtest/gtest.h>

#include <functional>

namespace agaa::test {
namespace {

struct Group {
    PlanBuilder& builder;
    ResourceId words;
};

// Two dispatches that run three times, until a word that the second one writes ends them. change: adds to the group.
Plan planOf(const std::function<void(const Group&)>& change = {}, bool writes = true) {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = view.height = 64;
    view.config = &config;
    view.facts = &facts;
    PlanBuilder b(resolveForDevice(resolveView(&view, techniques()), idealDevice(), techniques()), idealDevice(), 2);
    const ResourceId words = b.pixelBuffer("words", 4);
    b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
    const auto first = uint32_t(b.plan.passes.size());
    const auto dispatch = [&](const char* name, bool isWriter) {
        Pass& pass = b.compute(name, AGAA_STAGE_OTHER, "resolve", AGAA_SEGMENT_SHADING);
        b.bind(pass, slot::Aggregates, BindingType::StorageBuffer, words, isWriter);
    };
    dispatch("work", true);
    if (change)
        change({b, words});
    dispatch("decide", writes);
    b.plan.repeats.push_back({first, uint32_t(b.plan.passes.size() - 1), 3, words, 8});
    return b.finish();
}

TEST(Repeats, TheWordDecidesOnAllButTheFirstTurnAndTheLastPass) {
    const Plan plan = planOf();
    const std::vector<Step> steps = plan.steps();
    ASSERT_EQ(steps.size(), 1u + 3 * 2);
    for (const Step& step : steps) {
        SCOPED_TRACE(testing::Message() << plan.passes[step.pass].name << ' ' << step.batch);
        const bool isConditional = plan.passes[step.pass].name == "work" && step.batch > 0;
        EXPECT_EQ(step.predicateBuffer, isConditional ? plan.repeats[0].predicateBuffer : noResource);
        EXPECT_EQ(step.predicateOffset, isConditional ? 8u : 0u);
    }
}

// Fills, copies and clears would happen in turns that one executor skips and another one runs.
TEST(Repeats, GroupsThatEndHoldWhatCanBeSkipped) {
    const auto expectRefused = [](const std::function<Plan()>& make, const char* words) {
        try {
            make();
            ADD_FAILURE() << "accepted: " << words;
        } catch (const Error& error) {
            EXPECT_EQ(error.code, AGAA_ERROR_INTERNAL);
            EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
        }
    };
    const auto draw = [](bool clears) {
        return [clears](const Group& group) {
            Pass& pass = group.builder.hostDraw("draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_GBUFFER, AGAA_SEGMENT_SHADING);
            pass.draw().colorTargets = {group.builder.image("color", Format::RGBA8, false)};
            pass.draw().clearsColor = clears;
        };
    };
    EXPECT_EQ(planOf(draw(false)).passes.size(), 4u);
    expectRefused([&] { return planOf(draw(true)); }, "clears");
    expectRefused(
        [] {
            return planOf([](const Group& group) {
                group.builder.fill("fill", AGAA_STAGE_OTHER, group.words, AGAA_SEGMENT_SHADING);
            });
        },
        "fills");
    expectRefused([] { return planOf({}, false); }, "last pass");
}

} // namespace
} // namespace agaa::test
