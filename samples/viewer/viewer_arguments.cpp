#include "viewer_arguments.h"

#include "cli/program.h"
#include "cli/render_options.h"

namespace viewer {

namespace {

// Removes the options that mean something else for the viewer, or nothing.
void removeForeign(CLI::App& app) {
    std::vector<CLI::Option*> foreign = {app.get_option("--frames")};
    for (CLI::Option* option : app.get_options())
        if (option->get_name() != "--help" && !findOption(option->get_name()))
            foreign.push_back(option);
    for (CLI::Option* option : foreign)
        app.remove_option(option);
}

} // namespace

std::optional<ViewerArguments> parseViewerArguments(int argc, char** argv) {
    ViewerArguments arguments;
    harness::RenderArguments checked;
    std::string window;
    CLI::App app("A window on the sample engine. It also takes the options of agaa-harness render, as below.");
    harness::addRenderCommandOptions(app, checked);
    removeForeign(app);
    app.add_option("file", arguments.scene, "a built-in scene, .gltf or .glb, or a state (.json)");
    app.add_option("--state", arguments.state, "begin with this state");
    app.add_option("--frames", arguments.frames, "end after so many frames")->check(CLI::Range(1u, 1000000u));
    app.add_option("--screenshot", arguments.screenshot, "write the view as PNG at the end");
    app.add_option("--window-screenshot", arguments.windowScreenshot, "write the whole window as PNG at the end");
    CLI::Option* saved = app.add_option("--save-state", arguments.savedState, "write the state here at the end");
    app.add_option("--window", window, "WxH of the window");
    app.add_option("--trace", arguments.trace, "for tests: write the state and the places of buttons after changes");
    if (!harness::parseArguments(app, argc, argv))
        return std::nullopt;
    if (!window.empty()) {
        try {
            arguments.window = harness::parseSize(window);
        } catch (const harness::BadArgument&) {
            throw harness::BadArgument("--window is \"" + window + "\"; it is written WxH, both at least 1.");
        }
    }
    arguments.savesState = saved->count() > 0;
    if (arguments.scene.ends_with(".json"))
        arguments.state = std::exchange(arguments.scene, "");
    for (const OptionRow& row : optionRows()) {
        if (row.name == "--frames" || app.count(row.name) == 0)
            continue;
        if (row.isFlag)
            arguments.options.setFlag(row.name, true);
        else
            arguments.options.setAll(row.name, app.get_option(row.name)->results());
    }
    return arguments;
}

ViewerState initialState(const ViewerArguments& arguments) {
    ViewerState state = arguments.state.empty() ? defaultState() : readState(arguments.state);
    if (!arguments.scene.empty())
        state.options.set("--scene", arguments.scene);
    for (const OptionRow& row : optionRows()) {
        if (!arguments.options.has(row.name))
            continue;
        if (row.isFlag)
            state.options.setFlag(row.name, true);
        else
            state.options.setAll(row.name, arguments.options.all(row.name));
    }
    if (arguments.options.has("--size"))
        state.followsWindow = false;
    return state;
}

} // namespace viewer
