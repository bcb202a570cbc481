// The exit statuses and error messages of the command-line programs.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace harness {

// Returns false if help was asked for, which is printed then. Throws BadArgument.
bool parseArguments(CLI::App& app, int argc, char** argv);

// Runs a program and returns its exit status: 2 after BadArgument, 1 after another exception or if the graphics API
// reported messages when devices were destroyed, for example about leaked objects. Prints them on stderr.
int runProgram(const char* name, const std::function<void()>& run);

} // namespace harness
