// The command `sweep` of agaa-harness: techniques beside each other over scenes and backends; see docs/sweep.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace harness {

struct SweepArguments {
    std::vector<std::string> scenes; // or "scene@camera"; none: the usual ones
    std::vector<std::string> backends = {"vk"};
    std::string out = "sweep";
    std::string size; // empty: the usual one
    std::vector<std::string> plain; // scenes whose effects are also measured where nothing calls for them
    std::vector<std::string> rows; // none: all
    bool quick = false;
    bool noAblation = false;
    uint32_t jpegQuality = 0; // 0: PNG
    uint32_t rounds = 0; // 0: the usual number
};

void addSweepOptions(CLI::App& command, SweepArguments& arguments);
void runSweep(SweepArguments arguments, bool json);

} // namespace harness
