// The command-line options of a view's configuration.
#pragma once

#include "cli/arguments.h"

#include <CLI/CLI.hpp>

namespace harness {

void addPlanOptions(CLI::App& app, PlanArguments& arguments);
// Must be called after addPlanOptions().
void addShadingOptions(CLI::App& app, PlanArguments& arguments);

} // namespace harness
