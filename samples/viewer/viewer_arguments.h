// The command line of agaa-viewer: files and scripts of its own, and the options of `agaa-harness render`.
#pragma once

#include "viewer_state.h"

namespace viewer {

struct ViewerArguments {
    std::string scene;                           // empty: that of the options
    std::string state;                           // a file to begin with; empty: none
    uint32_t frames = 0;                         // ends after so many frames; 0: a person ends the viewer
    std::string screenshot, windowScreenshot;    // PNG files, written at the end
    std::string savedState = "agaa-viewer.json"; // the file that Ctrl+S writes
    bool savesState = false;                     // at the end, too
    std::string trace; // a file for tests: the state and the places of buttons, after each change
    harness::Size window = {1280, 800};
    OptionSet options;
};

// Returns nothing if help was asked for, which is printed then. Throws BadArgument.
std::optional<ViewerArguments> parseViewerArguments(int argc, char** argv);

// Returns the state of the file, or the default, with the options of the command line. Throws BadArgument.
ViewerState initialState(const ViewerArguments& arguments);

} // namespace viewer
