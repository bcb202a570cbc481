// Runs a sweep: measures rows of techniques over scenes and backends, and writes results.json and report.html.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace harness {

struct SweepArguments {
    std::vector<std::string> scenes; // or "scene@camera"; none: the default scenes
    std::vector<std::string> backends = {"vk"};
    std::string out = "sweep";
    std::string size;               // empty: the default size
    std::vector<std::string> plain; // scenes whose effects are also measured without anything that needs them
    std::vector<std::string> rows;  // none: all rows
    bool quick = false;
    bool noAblation = false;
    uint32_t jpegQuality = 0; // [1, 100]; 0: PNG
    uint32_t rounds = 0;      // 0: the default number
};

// Runs a sweep, or continues one of the same arguments in `out`. Prints the paths of the results to stdout, as text or
// as JSON. Throws BadArgument for a wrong argument.
void runSweep(SweepArguments arguments, bool json);

} // namespace harness
