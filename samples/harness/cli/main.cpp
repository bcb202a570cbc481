// agaa-harness: the sample engine's command line.
#include "cli/commands.h"
#include "cli/plan_options.h"
#include "cli/program.h"
#include "cli/render_options.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#ifdef _WIN32
#include <process.h>
#include <windows.h>
#else
#include <unistd.h>
#endif

using namespace harness;

namespace {

void addGoalOptions(CLI::App& app, ChooseArguments& a) {
    app.add_option("--max-error", a.maxError, "largest error by that of single, 0 to 1");
    app.add_option("--max-mse", a.maxMse, "largest mean square error after tone mapping");
    app.add_option("--scene-share", a.sceneShare, "of the table's scenes in which the error limits hold, 0 to 1");
    app.add_option("--max-ms", a.maxMs, "milliseconds of geometry passes and SDK passes");
    app.add_option("--max-bytes", a.maxBytes, "of the view's per-pixel surfaces");
    app.add_option("--prefer", a.prefer, "what is least within the limits: time or error");
    app.add_flag("--one-geometry-pass", a.oneGeometryPass, "no settings that draw the scene more than once");
    app.add_flag("--no-fetch", a.noFetch, "without an AgaaFetchFunction");
    app.add_option("--measured", a.measured,
                   "JSON file of benchmark/calibrate.py: choose among its settings, by its errors and times");
    app.add_flag("--predict-others", a.predictOthers,
                 "choose among all settings of the table, with errors predicted from those of --measured");
    app.add_flag("--observe", a.observe, "render frames of --technique, or of single, and choose by what they show");
}

void addHardScenesOptions(CLI::App& app, HardScenesArguments& a) {
    addDeviceOptions(app, a.device);
    app.get_option("--backend")->description("vk or gl; both without it");
    app.add_option("--scene", a.scenes, "a frame that --list names; repeatable")->allow_extra_args(false);
    app.add_option("--technique", a.techniques, "repeatable")->allow_extra_args(false);
    app.add_option("--samples", a.samples, "n; repeatable")->allow_extra_args(false);
    app.add_option("--aggregates", a.aggregates, "c or S; repeatable")->allow_extra_args(false);
    app.add_option("--spp", a.spp, "samples per pixel of references, at most")->check(CLI::Range(2u, 65536u));
    app.add_option("--covering", a.covering, "number of configurations for each pair of a technique and a scene")
        ->check(CLI::Range(1u, 1000u));
    app.add_option("--part", a.part, "K/N: the K-th of N parts of the configurations of each scene");
    app.add_flag("--list", a.list, "list the frames and their bounds");
}

void addMotionOptions(CLI::App& app, MotionArguments& a) {
    addDeviceOptions(app, a.base.device);
    app.add_option("--scene", a.base.scene, "a built-in scene, blades-N, .gltf or .glb");
    app.add_option("--camera", a.base.camera, "ex,ey,ez,tx,ty,tz,fovDegrees");
    app.add_option("--size", a.base.plan.size, "WxH");
    addMotionOption(app, a.motion);
    app.add_option("--row", a.rows, "a view: options of render, such as \"--technique taa\"; repeatable")
        ->required()
        ->allow_extra_args(false);
    app.add_option("--frames", a.frames)->check(CLI::Range(10u, 10000u));
    app.add_option("--spp", a.spp, "samples per pixel of the references")->check(CLI::Range(2u, 65536u));
    app.add_option("--images", a.images, "folder for the frames of each row and of the references");
}

std::filesystem::path thisProgram() {
#ifdef _WIN32
    wchar_t path[4096];
    return std::filesystem::path(path, path + GetModuleFileNameW(nullptr, path, 4096));
#else
    return std::filesystem::read_symlink("/proc/self/exe");
#endif
}

// Replaces this process by the agaa-sweep beside it. arguments: null-terminated, as of main(); the first one is
// replaced.
[[noreturn]] void execSweep(char** arguments) {
    const std::string program =
        thisProgram().replace_filename("agaa-sweep").replace_extension(thisProgram().extension()).string();
    std::string name = "agaa-sweep";
    arguments[0] = name.data();
    execv(program.c_str(), arguments);
    throw std::runtime_error("The command sweep needs the program " + program +
                             ", which cannot be run: " + std::strerror(errno) + ".");
}

void run(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "sweep")
        execSweep(argv + 1);
    CLI::App app("AGAA SDK sample engine");
    app.require_subcommand(1);
    bool json = false;
    const auto command = [&](const char* name, const char* description) {
        CLI::App* sub = app.add_subcommand(name, description);
        sub->add_flag("--json", json, "one JSON object on stdout and nothing else");
        return sub;
    };

    DeviceArguments capsDevice{"vk"};
    CLI::App* caps = command("caps", "how techniques would run on a device, and why");
    addDeviceOptions(*caps, capsDevice);

    PlanArguments memoryPlan;
    DeviceArguments memoryDevice;
    CLI::App* memory = command("memory", "bytes of a view; needs no GPU");
    addPlanOptions(*memory, memoryPlan);
    addShadingOptions(*memory, memoryPlan);
    memory->add_option("--backend", memoryDevice.backend, "ask this device instead of a model");

    RenderArguments planArguments;
    planArguments.device.backend.clear();
    CLI::App* plan = command("plan", "resources and passes of a frame; needs no GPU");
    addRenderOptions(*plan, planArguments);

    RenderArguments priceArguments;
    priceArguments.device.backend.clear();
    std::string priceTimes;
    CLI::App* price = command("price", "what effects and steps of n and c would cost; needs no GPU");
    addRenderOptions(*price, priceArguments);
    price->add_option("--times", priceTimes, "JSON file of measured times: {device, effects: {name: {ratio}}}");

    RenderArguments chooseArguments;
    chooseArguments.device.backend.clear();
    chooseArguments.plan.technique = "single";
    chooseArguments.plan.samples = 1;
    ChooseArguments limits;
    CLI::App* choose = command("choose", "settings for a limit of the error, the time or the memory");
    addRenderOptions(*choose, chooseArguments);
    addGoalOptions(*choose, limits);

    CLI::App* scenes = command("scenes", "the built-in scenes");

    RenderArguments renderArguments;
    CLI::App* render = command("render", "render a scene through the SDK");
    addRenderCommandOptions(*render, renderArguments);

    RenderArguments referenceArguments;
    CLI::App* reference = command("reference", "a jittered, accumulated reference image");
    addRenderOptions(*reference, referenceArguments);
    addEnvironmentOptions(*reference, referenceArguments);
    reference
        ->add_option("--footprint", referenceArguments.footprint,
                     "what textures are filtered over: a pixel, as in all techniques, or one of the samples")
        ->check(CLI::IsMember({"pixel", "sample"}));
    reference->add_option("--spp", referenceArguments.spp, "samples per pixel")->check(CLI::Range(2u, 65536u));

    MotionArguments motionArguments;
    CLI::App* motion = command("motion", "errors over the frames of a moving scene, and times, of several views");
    addMotionOptions(*motion, motionArguments);

    CompareArguments compareArguments;
    CLI::App* compare = command("compare", "error between two EXR images");
    compare->add_option("reference", compareArguments.reference)->required();
    compare->add_option("test", compareArguments.test)->required();
    compare->add_option("--difference", compareArguments.difference, "PNG of |a-b|");
    compare->add_option("--gain", compareArguments.gain, "of the difference image");

    HardScenesArguments hardArguments;
    CLI::App* hardScenes = command("hard-scenes", "numerically hard scenes in every technique, with bounds");
    addHardScenesOptions(*hardScenes, hardArguments);

    app.add_subcommand("sweep", "runs agaa-sweep: techniques beside each other, as results.json and report.html");

    if (!parseArguments(app, argc, argv))
        return;
    if (*caps)
        runCaps(capsDevice, json);
    else if (*memory)
        runMemory(memoryPlan, memoryDevice, json);
    else if (*plan)
        runPlan(planArguments, plan->count("--scene") > 0, json);
    else if (*price)
        runPrice(priceArguments, priceTimes, price->count("--scene") > 0, json);
    else if (*choose)
        runChoose(chooseArguments, limits, choose->count("--scene") > 0, json);
    else if (*scenes)
        runScenes(json);
    else if (*render)
        runRender(renderArguments, json);
    else if (*motion)
        runMotion(motionArguments, json);
    else if (*reference)
        runReference(referenceArguments, json);
    else if (*hardScenes)
        runHardScenes(hardArguments, json);
    else
        runCompare(compareArguments, json);
}

} // namespace

int main(int argc, char** argv) {
    return runProgram("agaa-harness", [=] { run(argc, argv); });
}
