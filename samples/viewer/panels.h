// The panels of the window. Each draws one part of it with Dear ImGui and changes the application's state.
#pragma once

#include "app.h"
#include "viewer_arguments.h"
#include "window.h"

#include <map>

namespace viewer {

// State of the panels that is not part of the viewer's state.
struct Ui {
    bool showsPanels = true;
    bool showsHelp = false;
    bool asksForFile = false; // "open…" was chosen
    bool draggedSplit = false;
    bool isEntered = false; // Enter was pressed
    std::string file;       // text of "open…"
    std::string search;     // in the table of options
    std::string savedState;
    std::map<std::string, std::string> edited; // texts of options that are being edited
    bool editsOther = false;                   // the settings panel shows B
    // Centres of buttons and of the image in the window, for tests.
    std::map<std::string, std::pair<int, int>> places;

    // Keeps the place of the newest widget.
    void mark(const std::string& name);
};

constexpr float panelWidth = 400;

void drawMenu(App& app, Ui& ui, Window& window);
void drawSidePanel(App& app, Ui& ui, float top);
void drawSettings(App& app, Ui& ui);
void drawOptions(App& app, Ui& ui);
void drawCompare(App& app, Ui& ui);
void drawCamera(App& app, Ui& ui);
void drawGoal(App& app, Ui& ui);
void drawFigures(App& app);
// Draws the image into the rest of the window and tells the application its size.
void drawView(App& app, Ui& ui, void* texture, float left, float top);
void drawMagnifier(const App& app, uint32_t x, uint32_t y);
void drawHelp(Ui& ui);

// Handles the keys that no text field takes.
void handleKeys(App& app, Ui& ui, Window& window, float seconds);
// Returns whether a key that moves the camera is held.
bool movesByKeys(const App& app, const Window& window);

// Widgets that several panels have.
// A text field of an option, which changes the option when Enter is pressed or the field is left.
void optionText(Ui& ui, OptionSet& options, const OptionRow& row);
// A list of names for an option. Returns true and sets `chosen` if one was selected.
bool optionCombo(Ui& ui, const char* label, const std::string& current, const std::vector<std::string>& names,
                 std::string& chosen);

} // namespace viewer
