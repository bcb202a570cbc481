// The viewer's state and its options, without a window and a device.
#include "app.h"
#include "viewer_arguments.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace viewer {
namespace {

// Returns the sentence of the error, or nothing.
template <class Action> std::string sentenceOf(const Action& action) {
    try {
        action();
    } catch (const harness::BadArgument& error) {
        return error.what();
    }
    return {};
}

ViewerState changedState() {
    ViewerState state = defaultState();
    state.options.set("--scene", "metal");
    state.options.set("--camera", "1,2,3.25,0,0.1,-1e-3,50");
    state.options.setAll("--tier", {"visibility=scaled-target", "generation=ids"});
    state.options.setFlag("--lit", true);
    state.other.set("--samples", "32");
    state.mode = Mode::Difference;
    state.compareWith = Other::Reference;
    state.split = 0.125;
    state.gain = 7.5;
    state.accumulatesReference = state.isFrozen = state.showsMagnifier = state.flies = state.playsFrames = true;
    state.referenceSamples = 99;
    state.followsWindow = false;
    state.texelSize = 3;
    state.goal = {true, 0.25, 3.5, 1e6, true};
    state.path.cameras = {"0,0,1,0,0,0,60", "0,0,2,0,0,0,60"};
    state.path.position = 1;
    state.path.isPlaying = state.path.loops = true;
    return state;
}

TEST(ViewerState, SavesAndLoadsEveryMember) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "agaa-viewer-state.json";
    for (const ViewerState& state : {ViewerState(), defaultState(), changedState()}) {
        writeState(file, state);
        EXPECT_TRUE(readState(file) == state) << state.toJson().dump(2);
    }
    std::filesystem::remove(file);
}

TEST(ViewerState, KeepsEveryOption) {
    OptionSet all;
    for (const OptionRow& row : optionRows())
        if (row.isFlag)
            all.setFlag(row.name, true);
        else
            all.setAll(row.name,
                       row.isRepeatable ? std::vector<std::string>{"a", "b=c"} : std::vector<std::string>{"7"});
    EXPECT_GT(optionRows().size(), 90u);
    EXPECT_TRUE(OptionSet::fromJson(all.toJson()) == all);
    EXPECT_EQ(all.toJson().size(), optionRows().size());
}

TEST(ViewerState, HasTheHarnessSettings) {
    OptionSet options;
    options.set("--technique", "dcaa");
    options.set("--samples", "64");
    options.setAll("--tier", {"generation=fragment-lists", "visibility=auto"});
    options.setAll("--without", {"specular", "shadows"});
    options.set("--jitter", "-0.25,0.5");
    options.set("--reversed-z", "0");
    options.setAll("--clear-coat", {"a", "b"});
    options.setFlag("--exact", true);
    const harness::RenderArguments arguments = options.parse();
    EXPECT_EQ(arguments.plan.technique, "dcaa");
    EXPECT_EQ(arguments.plan.samples, 64u);
    EXPECT_EQ(arguments.plan.tiers, (std::vector<std::string>{"generation=fragment-lists", "visibility=auto"}));
    EXPECT_EQ(arguments.without, (std::vector<std::string>{"specular", "shadows"}));
    EXPECT_EQ(arguments.jitter, "-0.25,0.5");
    EXPECT_FALSE(arguments.plan.reversedZ);
    EXPECT_EQ(arguments.clearCoat, (std::vector<std::string>{"a", "b"}));
    EXPECT_TRUE(arguments.plan.exact);
}

TEST(ViewerState, NumbersOfAFileAreTexts) {
    const OptionSet options = OptionSet::fromJson({{"--samples", 4}, {"--lit", false}, {"--k", 0.5}});
    EXPECT_EQ(options.get("--samples"), "4");
    EXPECT_FALSE(options.has("--lit"));
    EXPECT_EQ(options.parse().plan.k, 0.5);
}

TEST(ViewerState, NamesTheMistakeOfAFile) {
    const auto error = [](const nlohmann::json& members) {
        nlohmann::json object = {{"viewerState", 1}};
        object.update(members);
        return sentenceOf([&] { ViewerState::fromJson(object); });
    };
    EXPECT_NE(error({{"spilt", 0.5}}).find("unknown member \"spilt\""), std::string::npos);
    EXPECT_NE(error({{"split", 2}}).find("\"split\" with the value 2"), std::string::npos);
    EXPECT_NE(error({{"split", "left"}}).find("\"split\""), std::string::npos);
    EXPECT_NE(error({{"mode", "c"}}).find("a, b, split, difference"), std::string::npos);
    EXPECT_NE(error({{"texelSize", 1.5}}).find("whole number"), std::string::npos);
    EXPECT_NE(error({{"viewerState", 2}}).find("viewerState"), std::string::npos);
    EXPECT_NE(error({{"options", {{"--tecnique", "agaa"}}}}).find("--tecnique"), std::string::npos);
    EXPECT_NE(error({{"options", {{"--png", "a.png"}}}}).find("does not take the option --png"), std::string::npos);
    EXPECT_NE(error({{"options", {{"--lit", "yes"}}}}).find("--lit"), std::string::npos);
    EXPECT_NE(error({{"options", {{"--samples", nullptr}}}}).find("--samples"), std::string::npos);
    EXPECT_NE(error({{"options", 5}}).find("must be an object"), std::string::npos);
    EXPECT_NE(error({{"path", {{"cameras", {"1,2"}}}}}).find("--camera"), std::string::npos);
    EXPECT_NE(error({{"goal", {{"maxError", -1}}}}).find("maxError"), std::string::npos);
    EXPECT_EQ(error(nlohmann::json::object()), "");
}

TEST(ViewerState, NamesAFileThatCannotBeRead) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "agaa-viewer-broken.json";
    EXPECT_NE(sentenceOf([&] { readState(file.string() + ".missing"); }).find("cannot be read"), std::string::npos);
    std::ofstream(file) << "{\"viewerState\": 1,";
    EXPECT_NE(sentenceOf([&] { readState(file); }).find("is not JSON"), std::string::npos);
    std::filesystem::remove(file);
}

TEST(ViewerOptions, ErrorsAreThoseOfTheHarness) {
    const auto error = [](const char* name, const char* value) {
        return sentenceOf([&] {
            OptionSet options;
            options.set(name, value);
            harness::Configuration configuration(options.parse().plan);
        });
    };
    EXPECT_EQ(error("--ndf", "leen"), "--ndf is \"leen\"; it can be none, toksvig, lean, sggx.");
    EXPECT_EQ(error("--size", "0x0"), "--size is \"0x0\"; it is written WxH, both at least 1.");
    EXPECT_NE(error("--samples", "three").find("--samples"), std::string::npos);
}

TEST(ViewerOptions, TheOtherViewHasTheSameScene) {
    ViewerState state = changedState();
    state.other.set("--scene", "city");
    const OptionSet other = state.otherOptions();
    EXPECT_EQ(other.get("--scene"), "metal");
    EXPECT_EQ(other.get("--camera"), state.options.get("--camera"));
    EXPECT_EQ(other.get("--technique"), "ssaa");
    EXPECT_EQ(other.get("--samples"), "32");
    EXPECT_FALSE(other.has("--lit"));
    EXPECT_FALSE(other.has("--tier"));
    state.options.set("--backend", "gl");
    EXPECT_EQ(state.otherOptions().get("--backend"), "gl");
    state.other.set("--backend", "vk");
    EXPECT_EQ(state.otherOptions().get("--backend"), "vk");
}

TEST(ViewerOptions, APresetReplacesWhatItDecides) {
    OptionSet options;
    options.set("--technique", "agaa");
    options.set("--samples", "4");
    options.setFlag("--lit", true);
    options.set("--tier", "generation=ids");
    setPreset(options, "balanced");
    EXPECT_EQ(options.parse().plan.preset, "balanced");
    EXPECT_EQ(options.get("--samples"), "4");
    EXPECT_EQ(options.get("--tier"), "generation=ids");
    setTechnique(options, "msaa");
    EXPECT_EQ(options.parse().plan.technique, "msaa");
}

TEST(ViewerArguments, MixScriptAndSettings) {
    const char* words[] = {"agaa-viewer",  "metal", "--frames", "3",     "--technique", "ssaa",           "--lit",
                           "--screenshot", "a.png", "--size",   "64x32", "--tier",      "visibility=auto"};
    const auto arguments = parseViewerArguments(int(std::size(words)), const_cast<char**>(words));
    ASSERT_TRUE(arguments);
    EXPECT_EQ(arguments->frames, 3u);
    EXPECT_EQ(arguments->screenshot, "a.png");
    const ViewerState state = initialState(*arguments);
    EXPECT_EQ(state.options.get("--scene"), "metal");
    EXPECT_EQ(state.options.get("--technique"), "ssaa");
    EXPECT_EQ(state.options.get("--tier"), "visibility=auto");
    EXPECT_TRUE(state.options.has("--lit"));
    EXPECT_TRUE(state.options.has("--no-validation"));
    EXPECT_FALSE(state.options.has("--frames"));
    EXPECT_FALSE(state.followsWindow);
}

TEST(ViewerArguments, RefuseAnUnknownOption) {
    const char* words[] = {"agaa-viewer", "--tecnique", "ssaa"};
    EXPECT_NE(sentenceOf([&] { parseViewerArguments(3, const_cast<char**>(words)); }), "");
    const char* png[] = {"agaa-viewer", "--png", "a.png"};
    EXPECT_NE(sentenceOf([&] { parseViewerArguments(3, const_cast<char**>(png)); }).find("--png"), std::string::npos);
}

} // namespace
} // namespace viewer
