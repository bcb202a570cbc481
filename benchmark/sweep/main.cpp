// agaa-sweep: the command line of a sweep; docs/sweep.md describes its files.
#include "cli/program.h"
#include "sweep/command.h"

using namespace harness;

namespace {

void addOptions(CLI::App& app, SweepArguments& arguments, bool& json) {
    app.add_option("--scene", arguments.scenes,
                   "built-in scenes, .gltf or .glb; @ex,ey,ez,tx,ty,tz,fovDegrees after it sets the camera");
    app.add_option("--plain", arguments.plain,
                   "also measure what effects cost in a scene that needs none: this scene without highlights, "
                   "emission, ambient light, shadows and normal maps; repeatable");
    app.add_option("--backend", arguments.backends, "vk, gl");
    app.add_option("--out", arguments.out, "folder; a sweep in it is continued");
    app.add_option("--size", arguments.size, "WxH");
    app.add_option("--row", arguments.rows, "only these rows of a full sweep, such as agaa-8-2; repeatable");
    app.add_option("--rounds", arguments.rounds, "frames of each row, in alternating order: 7; 101 suits a GPU")
        ->check(CLI::Range(1u, 10000u));
    app.add_flag("--no-ablation", arguments.noAblation, "do not measure what each effect costs and removes");
    app.add_option("--jpeg", arguments.jpegQuality, "images as JPEG of this quality, 1 to 100, not as PNG")
        ->check(CLI::Range(1u, 100u));
    app.add_flag("--quick", arguments.quick, "two scenes, few rows, 320x180: minutes, not hours");
    app.add_flag("--json", json, "one JSON object on stdout and nothing else");
}

void run(int argc, char** argv) {
    CLI::App app("AGAA SDK sweep: measures techniques and writes results.json and report.html", "agaa-sweep");
    SweepArguments arguments;
    bool json = false;
    addOptions(app, arguments, json);
    if (parseArguments(app, argc, argv))
        runSweep(arguments, json);
}

} // namespace

int main(int argc, char** argv) {
    return runProgram("agaa-sweep", [=] { run(argc, argv); });
}
