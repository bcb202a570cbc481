// What plans can say and executors do, by plans made for it. Each graphics API instantiates these.
#pragma once

#include "plan_view.h"
#include "view_settings.h"

#include "core/plan/techniques/aggregation.h"
#include "core/plan/techniques/gbuffer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace agaa::test {

constexpr uint32_t planWidth = 48, planHeight = 32, planPixels = planWidth * planHeight;

// A compute pass of this body, with what all of them declare.
inline Pass& planPass(PlanBuilder& b, const char* name, const std::string& declarations, const std::string& body) {
    Pass& pass = b.compute(name, AGAA_STAGE_OTHER, "resolve", AGAA_SEGMENT_SHADING);
    pass.compute().text = "#version 450\nlayout(local_size_x = 64) in;\n#include \"common/bindings.glsl\"\n"
                          "#include \"common/constants.glsl\"\n#include \"common/frame.glsl\"\n" +
                          declarations +
                          "void main() {\n    uint item = (gl_WorkGroupID.y * 32768u + gl_WorkGroupID.x) * 64u + "
                          "gl_LocalInvocationIndex;\n" +
                          body + "}\n";
    b.bindCommon(pass);
    return pass;
}

inline void dispatchItems(Pass& pass, uint64_t items) {
    pass.compute().dispatch = {.kind = DispatchKind::Items, .items = items};
}

constexpr const char* wordsText = "layout(std430, AGAA_BINDING_AGGREGATES) buffer Words { uint words[]; };\n";
constexpr const char* argumentsText =
    "layout(std430, AGAA_BINDING_FRAGMENTS) buffer Arguments { uint arguments[]; };\n";

// Shows color, a GLSL vec3 of `item`, a pixel.
inline Pass& showPixels(PlanBuilder& b, const std::string& declarations, const std::string& color) {
    Pass& pass = planPass(b, "show", declarations + "layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D image;\n",
                          "    if (item < 1536u)\n        imageStore(image, ivec2(item % 48u, item / 48u), vec4(" +
                              color + ", 1.0));\n");
    dispatchItems(pass, planPixels);
    b.bind(pass, slot::Output, BindingType::StorageImage, b.output(), true);
    return pass;
}

inline void bindWords(PlanBuilder& b, Pass& pass, ResourceId words, bool writes = false) {
    b.bind(pass, slot::Aggregates, BindingType::StorageBuffer, words, writes);
}

// A group whose word ends it after three turns of six. Its draw and its first dispatch would count further turns. Shows
// how often the draw, the first dispatch and the last pass ran.
inline void buildEndingGroup(PlanBuilder& b) {
    const ResourceId words = b.pixelBuffer("words", 4);
    b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
    const auto first = uint32_t(b.plan.passes.size());
    Pass& draw = b.hostDraw("draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_GBUFFER, AGAA_SEGMENT_SHADING);
    b.bindCommon(draw);
    draw.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
    draw.draw().text = "layout(std430, AGAA_BINDING_FRAGMENTS) buffer Words { uint words[]; };\n"
                       "void agaa_emit(AgaaSurfaceInput s) {\n    if (agaa_hostPixel() == uvec2(0u))\n"
                       "        atomicAdd(words[0], 1u);\n}\n";
    b.bind(draw, host_slot::Fragments, BindingType::StorageBuffer, words, true);
    Pass& work = planPass(b, "work", wordsText, "    if (item == 0u)\n        ++words[1];\n");
    dispatchItems(work, 1);
    bindWords(b, work, words, true);
    Pass& decide =
        planPass(b, "decide", wordsText,
                 "    if (item != 0u)\n        return;\n    ++words[2];\n    words[3] = words[2] < 3u ? 0u : 1u;\n");
    dispatchItems(decide, 1);
    bindWords(b, decide, words, true);
    b.plan.repeats.push_back({first, first + 2, 6, words, 12});
    bindWords(b, showPixels(b, wordsText, "vec3(words[0], words[1], words[2])"), words);
}

template <class Host> class PlanCases : public testing::Test {
protected:
    // The images of so many frames, RGBA.
    std::vector<std::vector<float>> render(void (*build)(PlanBuilder&), uint32_t frames = 1,
                                           const std::vector<Triangle>& triangles = {},
                                           const char* technique = "single", uint32_t samples = 1) {
        ViewSettings settings;
        settings.width = planWidth;
        settings.height = planHeight;
        settings.config.technique = technique;
        settings.config.samples = samples;
        settings.config.flags = AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS;
        settings.facts.shadowMapCount = 0;
        settings.projection = pixelOrthographic(planWidth, planHeight, 10);
        settings.build = build;
        typename Host::View view(context, settings);
        view.setTriangles(triangles);
        std::vector<std::vector<float>> images;
        for (uint32_t i = 0; i < frames; ++i) {
            view.render(view.frame());
            images.push_back(Host::rgba(view));
        }
        batches = view.batches;
        states = view.states;
        if (validates) {
            EXPECT_EQ(agaaValidateFrame(view.get(), frames, &validation), AGAA_OK);
        }
        return images;
    }

    typename Host::Context context;
    std::vector<uint32_t> batches;     // of the draw callbacks
    std::vector<AgaaDrawState> states; // the same
    bool validates = false;
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT; // of the last frame
};
TYPED_TEST_SUITE_P(PlanCases);

// More groups than a row has.
constexpr uint64_t manyItems = uint64_t(itemsPerGroup) * groupsPerRow + 200;

TYPED_TEST_P(PlanCases, ItemsAreDispatchedInRows) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.itemBuffer("words", manyItems, 4);
        b.fill("fill", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING, 7);
        const std::string count = std::to_string(manyItems) + "u";
        Pass& number =
            planPass(b, "number", wordsText, "    if (item < " + count + ")\n        words[item] += item;\n");
        dispatchItems(number, manyItems);
        bindWords(b, number, words, true);
        Pass& show = showPixels(b, wordsText, "vec3(words[item], words[" + count + " - 1u - item], 0.0)");
        bindWords(b, show, words);
    };
    const auto images = this->render(build);
    for (uint32_t i = 0; i < planPixels; ++i) {
        ASSERT_EQ(images[0][4 * i], float(i + 7)) << i;
        ASSERT_EQ(images[0][4 * i + 1], float(manyItems - 1 - i + 7)) << i;
    }
}

TYPED_TEST_P(PlanCases, AnEarlierPassSaysHowManyGroups) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.itemBuffer("words", planPixels, 4);
        const ResourceId arguments = b.itemBuffer("arguments", 8, 4);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
        Pass& say =
            planPass(b, "say", argumentsText,
                     "    if (item < 8u)\n        arguments[item] = uint[](9u, 9u, 9u, 9u, 3u, 1u, 1u, 9u)[item];\n");
        dispatchItems(say, 8);
        b.bind(say, slot::Fragments, BindingType::StorageBuffer, arguments, true);
        Pass& mark = planPass(b, "mark", wordsText, "    words[item] = item + 1u;\n");
        mark.compute().dispatch = {.kind = DispatchKind::Indirect, .arguments = arguments, .argumentsOffset = 16};
        bindWords(b, mark, words, true);
        bindWords(b, showPixels(b, wordsText, "vec3(words[item])"), words);
    };
    const auto images = this->render(build);
    for (uint32_t i = 0; i < planPixels; ++i)
        ASSERT_EQ(images[0][4 * i], i < 3 * itemsPerGroup ? float(i + 1) : 0.0f) << i;
}

// A group of passes runs five times; what is left to do ends after three.
TYPED_TEST_P(PlanCases, GroupsRepeatUntilABufferEndsThem) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.itemBuffer("words", 4, 4);
        const ResourceId arguments = b.itemBuffer("arguments", 3, 4);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
        b.fill("one group", AGAA_STAGE_OTHER, arguments, AGAA_SEGMENT_SHADING, 1);
        const auto first = uint32_t(b.plan.passes.size());
        Pass& work = planPass(b, "work", wordsText, "    if (item == 0u)\n        ++words[0];\n");
        work.compute().dispatch = {.kind = DispatchKind::Indirect, .arguments = arguments};
        bindWords(b, work, words, true);
        Pass& decide = planPass(b, "decide", std::string(wordsText) + argumentsText,
                                "    if (item != 0u)\n        return;\n    ++words[1];\n"
                                "    if (words[0] == 3u)\n        arguments[0] = 0u;\n");
        dispatchItems(decide, 1);
        bindWords(b, decide, words, true);
        b.bind(decide, slot::Fragments, BindingType::StorageBuffer, arguments, true);
        b.plan.repeats.push_back({first, first + 1, 5});
        bindWords(b, showPixels(b, wordsText, "vec3(words[0], words[1], 0.0)"), words);
    };
    const auto images = this->render(build);
    EXPECT_EQ(images[0][0], 3.0f);
    EXPECT_EQ(images[0][1], 5.0f);
}

TYPED_TEST_P(PlanCases, AWordEndsGroups) {
    const auto images = this->render(buildEndingGroup, 2, rectangle(0, 0, planWidth, planHeight, 5, Material{}));
    const uint32_t drawn = TypeParam::skips(this->context) ? 3 : 6;
    for (const std::vector<float>& image : images) {
        EXPECT_EQ(image[0], float(drawn));
        EXPECT_EQ(image[1], float(drawn));
        // The last pass writes the word, so devices never skip it.
        EXPECT_EQ(image[2], TypeParam::endsRepetitions ? 3.0f : 6.0f);
    }
}

// One pass that ends its own repetition, and shows how often it ran.
TYPED_TEST_P(PlanCases, PassesEndThemselves) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.itemBuffer("words", 1, 4);
        const ResourceId arguments = b.itemBuffer("arguments", 3, 4);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
        b.fill("one group", AGAA_STAGE_OTHER, arguments, AGAA_SEGMENT_SHADING, 1);
        const auto first = uint32_t(b.plan.passes.size());
        Pass& before = planPass(b, "before", wordsText, "    if (item == 0u)\n        ++words[0];\n");
        dispatchItems(before, 1);
        bindWords(b, before, words, true);
        Pass& work = planPass(
            b, "work",
            std::string(wordsText) + argumentsText + "layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D image;\n",
            "    if (item != 0u)\n        return;\n    if (words[0] == 3u)\n        arguments[0] = 0u;\n"
            "    imageStore(image, ivec2(0), vec4(words[0]));\n");
        work.compute().dispatch = {.kind = DispatchKind::Indirect, .arguments = arguments};
        bindWords(b, work, words);
        b.bind(work, slot::Fragments, BindingType::StorageBuffer, arguments, true);
        b.bind(work, slot::Output, BindingType::StorageImage, b.output(), true);
        b.plan.repeats.push_back({first, first + 1, 5});
    };
    EXPECT_EQ(this->render(build)[0][0], 3.0f);
}

TYPED_TEST_P(PlanCases, BuffersOutliveFrames) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.tileBuffer("words", 16, 4);
        b.plan.resources[words].isPersistent = true;
        Pass& count = planPass(b, "count", wordsText, "    if (item < 6u)\n        words[item] += item + 1u;\n");
        dispatchItems(count, 6); // 48 x 32 pixels have six tiles of 16
        bindWords(b, count, words, true);
        bindWords(b, showPixels(b, wordsText, "vec3(words[item % 6u])"), words);
    };
    const auto images = this->render(build, 4);
    for (uint32_t frame = 0; frame < 4; ++frame)
        for (uint32_t i = 0; i < 6; ++i)
            EXPECT_EQ(images[frame][4 * i], float((frame + 1) * (i + 1))) << frame << ' ' << i;
}

// The constants of a frame hold a counter of the newest finished one.
TYPED_TEST_P(PlanCases, CountersComeBackInConstants) {
    const auto build = [](PlanBuilder& b) {
        b.plan.feedback[1] = AGAA_COUNT_EVENTS;
        Pass& count = planPass(b, "count", "layout(std430, AGAA_BINDING_COUNTERS) buffer Counts { uint counts[]; };\n",
                               "    if (item == 0u)\n        counts[" + std::to_string(2 * AGAA_COUNT_EVENTS) +
                                   "] = agaa_frame.feedback1 + 2u;\n");
        dispatchItems(count, 1);
        showPixels(b, "", "vec3(agaa_frame.feedback0, agaa_frame.feedback1, agaa_frame.feedback2)");
        b.copyCounters();
    };
    const auto images = this->render(build, 3);
    for (uint32_t frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(images[frame][0], 0.0f);
        EXPECT_EQ(images[frame][1], float(2 * frame));
        EXPECT_EQ(images[frame][2], 0.0f);
    }
}

// A target without depth, cleared to a colour, drawn twice as batches and read through both samplers.
TYPED_TEST_P(PlanCases, DrawsWithoutDepthAreClearedToColours) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId color = b.image("color", Format::RGBA16, false);
        const auto first = uint32_t(b.plan.passes.size());
        Pass& draw = b.hostDraw("draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_GBUFFER, AGAA_SEGMENT_SHADING);
        b.bindCommon(draw);
        draw.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
        draw.draw().state.colorAttachmentCount = 1;
        draw.draw().colorTargets = {color};
        draw.draw().clearsColor = true;
        draw.draw().clear.color[0] = {0.25f, 0.5f, 0.75f, 1.0f};
        setFields(draw.constants, AGAA_SOURCE_DIFFUSE_R, packGBuffer(b.plan.view.layout).fields);
        b.plan.repeats.push_back({first, first, 2});
        const std::string textures = "layout(AGAA_BINDING_GBUFFER0) uniform sampler2D nearest;\n"
                                     "layout(AGAA_BINDING_GBUFFER1) uniform sampler2D linear;\n";
        // On the border between two texels the linear sampler mixes them.
        const std::string at = "vec2(float(item % 48u), float(item / 48u) + 0.5) / vec2(48.0, 32.0)";
        Pass& show = showPixels(b, textures,
                                "vec3(textureLod(nearest, " + at +
                                    " + vec2(0.1 / 48.0, 0.0), 0.0).rg, "
                                    "textureLod(linear, " +
                                    at + ", 0.0).r)");
        b.bind(show, slot::GBuffer0, BindingType::Texture, color);
        b.bind(show, slot::GBuffer1, BindingType::Texture, color);
        show.bindings.back().filter = Filter::Linear;
    };
    Material material;
    material.diffuse = {0.75f, 0.125f, 0.5f, 1.0f};
    const auto images = this->render(build, 1, rectangle(0, 0, planWidth / 2, planHeight, 5, material));
    EXPECT_EQ(this->batches, TypeParam::isCalledOnce ? (std::vector<uint32_t>{0}) : (std::vector<uint32_t>{0, 1}));
    for (uint32_t i = 0; i < planPixels; ++i) {
        const uint32_t x = i % planWidth;
        const bool drawn = x < planWidth / 2;
        ASSERT_NEAR(images[0][4 * i], drawn ? 0.75f : 0.25f, 1e-3f) << i;
        ASSERT_NEAR(images[0][4 * i + 1], drawn ? 0.125f : 0.5f, 1e-3f) << i;
        ASSERT_NEAR(images[0][4 * i + 2], x == planWidth / 2 ? 0.5f : drawn ? 0.75f : 0.25f, 3e-3f) << i;
    }
}

// A draw without any target stores into a buffer.
TYPED_TEST_P(PlanCases, DrawsWithoutTargetsStore) {
    const auto build = [](PlanBuilder& b) {
        Aggregation sums;
        sums.layout = b.plan.view.layout;
        sums.packing = packAggregate(sums.layout, 1);
        sums.stride = sums.packing.words;
        const ResourceId words = b.pixelBuffer("words", 4 * sums.stride);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
        Pass& draw = b.hostDraw("draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_AGGREGATE, AGAA_SEGMENT_SHADING);
        b.bindCommon(draw);
        draw.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
        b.bind(draw, host_slot::Aggregates, BindingType::StorageBuffer, words, true);
        setRecord(draw, sums);
        const Field& coverage = sums.packing.coverage;
        const std::string word =
            "words[item * " + std::to_string(sums.stride) + "u + " + std::to_string(coverage.word) + "u]";
        bindWords(b,
                  showPixels(b, wordsText, "vec3(float(" + word + " >> " + std::to_string(coverage.shift) + "u & 1u))"),
                  words);
    };
    const auto images = this->render(build, 1, rectangle(0, 0, planWidth / 2, planHeight, 5, Material{}));
    EXPECT_EQ(this->batches, std::vector<uint32_t>{0});
    for (uint32_t i = 0; i < planPixels; ++i)
        ASSERT_EQ(images[0][4 * i], i % planWidth < planWidth / 2 ? 1.0f : 0.0f) << i;
}

// A draw with text and a geometry stage of the plan's own, which moves the rectangle to the right by 16 pixels, counts
// fragments in a buffer of its own.
TYPED_TEST_P(PlanCases, DrawsHaveTextAndBuffersOfTheirOwn) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.pixelBuffer("words", 4);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING, 5);
        Pass& draw = b.hostDraw("draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_GBUFFER, AGAA_SEGMENT_SHADING);
        b.bindCommon(draw);
        draw.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
        draw.draw().text = "layout(std430, AGAA_BINDING_FRAGMENTS) buffer Words { uint words[]; };\n"
                           "void agaa_emit(AgaaSurfaceInput s) {\n    uvec2 pixel = agaa_hostPixel();\n"
                           "    atomicAdd(words[pixel.y * agaa_frame.size.x + pixel.x], uint(s.diffuse.x * 8.0));\n}\n";
        draw.draw().expansionText =
            "vec4 agaa_place(vec4 clip) {\n"
            "    return clip + vec4(32.0 / float(agaa_frame.size.x) * clip.w, 0.0, 0.0, 0.0);\n}\n";
        b.bind(draw, host_slot::Fragments, BindingType::StorageBuffer, words, true);
        bindWords(b, showPixels(b, wordsText, "vec3(words[item])"), words);
    };
    Material material;
    material.diffuse = {0.5f, 0.5f, 0.5f, 1.0f};
    std::vector<Triangle> twice = rectangle(0, 0, planWidth / 2, planHeight, 5, material);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 2);
    const auto images = this->render(build, 1, twice);
    for (uint32_t i = 0; i < planPixels; ++i) {
        const uint32_t x = i % planWidth;
        ASSERT_EQ(images[0][4 * i], x >= 16 && x < 40 ? 13.0f : 5.0f) << i;
    }
}

// A draw asks its host for conservative rasterisation, and the next one does not. Hosts of these tests draw without it,
// as devices do that have none.
TYPED_TEST_P(PlanCases, DrawsAskForConservativeRasterisation) {
    const auto build = [](PlanBuilder& b) {
        const ResourceId words = b.pixelBuffer("words", 4);
        b.fill("clear", AGAA_STAGE_OTHER, words, AGAA_SEGMENT_SHADING);
        for (const uint32_t conservative : {1u, 0u}) {
            Pass& draw = b.hostDraw(conservative ? "overestimate" : "draw", AGAA_STAGE_OTHER, AGAA_DRAW_PASS_GBUFFER,
                                    AGAA_SEGMENT_SHADING);
            b.bindCommon(draw);
            draw.draw().state.depthCompare = AGAA_COMPARE_ALWAYS;
            draw.draw().state.conservative = conservative;
            draw.draw().text = "layout(std430, AGAA_BINDING_FRAGMENTS) buffer Words { uint words[]; };\n"
                               "void agaa_emit(AgaaSurfaceInput s) {\n    uvec2 pixel = agaa_hostPixel();\n"
                               "    atomicAdd(words[pixel.y * agaa_frame.size.x + pixel.x], 1u);\n}\n";
            b.bind(draw, host_slot::Fragments, BindingType::StorageBuffer, words, true);
        }
        bindWords(b, showPixels(b, wordsText, "vec3(words[item])"), words);
    };
    const auto images = this->render(build, 1, rectangle(0, 0, planWidth / 2, planHeight, 5, Material{}));
    ASSERT_EQ(this->states.size(), 2u);
    EXPECT_EQ(this->states[0].conservative, 1u);
    EXPECT_EQ(this->states[1].conservative, 0u);
    EXPECT_EQ(images[0][0], 2.0f) << "both draws reach the first pixel";
}

// Masks of 128 samples: locations, events and the report of invalid pixels.
TYPED_TEST_P(PlanCases, MasksHaveRoomFor128Samples) {
    const auto build = [](PlanBuilder& b) {
        Pass& shade = planPass(
            b, "shade",
            "#define AGAA_COUNTING 1\n#define AGAA_EVENT_WORDS 4\n#define AGAA_MAX_EVENTS 4u\n"
            "#include \"common/target.glsl\"\n#include \"common/counters.glsl\"\n"
            "#include \"common/events.glsl\"\n"
            "vec3 agaa_shadeEvent(uint lane, uint which) {\n"
            "    return vec3(lane, which & 127u, which >> 7u);\n}\n",
            "    agaa_countBegin();\n"
            "    uvec2 pixel = uvec2(item % 48u, item / 48u);\n"
            "    agaa_PixelWork work = agaa_pixelWork(1u, 128u, 3u);\n"
            "    work.events[1] = 1u << (item & 31u);\n    work.events[3] = 0x80000001u;\n"
            "    agaa_writeOutput(pixel, agaa_shadeWork(work) + vec3(0.0, 0.0, agaa_eventsOf(work)), AGAA_SAMPLES);\n"
            "    if (item == 49u)\n"
            "        agaa_reportPixel(pixel, uvec4(1u, 2u, 3u, 4u), uvec4(5u, 6u, 7u, 8u), uvec4(9u, 10u, 11u, 12u));\n"
            "    agaa_countEnd();\n");
        dispatchItems(shade, planPixels);
        b.bindOutput(shade);
        b.copyCounters();
    };
    this->validates = true;
    const auto images = this->render(build);
    const AgaaInvalidPixel expected = {1, 1, {1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {0, 0}};
    EXPECT_EQ(this->validation.invalidPixels, 1u);
    EXPECT_EQ(std::memcmp(&this->validation.pixels[0], &expected, sizeof expected), 0);
    for (uint32_t i = 0; i < planPixels; ++i) {
        ASSERT_EQ(images[0][4 * i], float(4 * (i % 64))) << i;
        ASSERT_EQ(images[0][4 * i + 1], float(0 + 32 + i % 32 + 96 + 127)) << i;
        ASSERT_EQ(images[0][4 * i + 2], float(4 + 4)) << i;
    }
}

// What a new technique takes (docs/extending.md): a G-buffer, of which one sample of each pixel is shown.
TYPED_TEST_P(PlanCases, ATechniqueIsAFileAndAShader) {
    const auto build = [](PlanBuilder& b) {
        const GBuffer gbuffer = makeGBuffer(b);
        Pass& shade = planPass(b, "shade one sample",
                               "#include \"common/target.glsl\"\n#include \"gbuffer/gbuffer.glsl\"\n"
                               "layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D image;\n",
                               "    if (item >= 1536u)\n        return;\n"
                               "    uvec2 pixel = uvec2(item % 48u, item / 48u);\n"
                               "    uint i = item * 2654435761u >> 16u & 3u;\n"
                               "    vec3 color = agaa_fetchSample(pixel, i) ? agaa_fetchedDiffuse() : vec3(0.25);\n"
                               "    imageStore(image, ivec2(pixel), vec4(color, 1.0));\n");
        dispatchItems(shade, planPixels);
        gbuffer.bind(b, shade);
        b.bind(shade, slot::Output, BindingType::StorageImage, b.output(), true);
        b.copyCounters();
    };
    Material material;
    material.diffuse = {0.75f, 0.125f, 0.5f, 1.0f};
    const auto images = this->render(build, 1, rectangle(0, 0, 24.5f, planHeight, 5, material), "ssaa", 4);
    uint32_t drawn = 0; // of the column that the edge halves
    for (uint32_t i = 0; i < planPixels; ++i) {
        const uint32_t x = i % planWidth;
        const bool isDrawn = images[0][4 * i] > 0.5f;
        ASSERT_NEAR(images[0][4 * i], isDrawn ? 0.75f : 0.25f, 1e-3f) << i;
        ASSERT_TRUE(x == 24 || isDrawn == (x < 24)) << i;
        drawn += x == 24 && isDrawn;
    }
    EXPECT_GT(drawn, planHeight / 4);
    EXPECT_LT(drawn, planHeight * 3 / 4);
}

REGISTER_TYPED_TEST_SUITE_P(PlanCases, ItemsAreDispatchedInRows, AnEarlierPassSaysHowManyGroups,
                            GroupsRepeatUntilABufferEndsThem, BuffersOutliveFrames, CountersComeBackInConstants,
                            DrawsWithoutDepthAreClearedToColours, DrawsWithoutTargetsStore, ATechniqueIsAFileAndAShader,
                            PassesEndThemselves, AWordEndsGroups, DrawsHaveTextAndBuffersOfTheirOwn,
                            DrawsAskForConservativeRasterisation, MasksHaveRoomFor128Samples);

} // namespace agaa::test
