// The command-line options of commands that render, which other programs have, too.
#pragma once

#include "cli/commands.h"

#include <CLI/CLI.hpp>

namespace harness {

void addDeviceOptions(CLI::App& app, DeviceArguments& arguments);
void addRenderOptions(CLI::App& app, RenderArguments& arguments); // those of devices, plans and shading, too
void addEnvironmentOptions(CLI::App& app, RenderArguments& arguments);
void addMotionOption(CLI::App& app, std::string& motion);
// Adds all options of the command `render` but --json.
void addRenderCommandOptions(CLI::App& app, RenderArguments& arguments);

} // namespace harness
