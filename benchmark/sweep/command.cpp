#include "sweep/command.h"

#include "build_name.h"

#include "cli/commands.h"
#include "scene/builtin.h"
#include "sweep/scene_sweep.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

namespace harness {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

// Written beside and moved, so that a sweep that is killed leaves a whole file.
void writeJson(const fs::path& path, const json& value) {
    const fs::path part = path.string() + ".part";
    {
        std::ofstream out(part);
        out << value.dump(1) << '\n';
        if (!out)
            throw std::runtime_error("The file " + path.string() + " cannot be written.");
    }
    fs::rename(part, path);
}

// What was measured before with the same arguments.
json readResults(const fs::path& path, const json& fresh) {
    std::ifstream in(path);
    if (!in)
        return fresh;
    const json old = json::parse(in, nullptr, false);
    if (old.is_discarded() || !old.is_object())
        throw std::runtime_error("The file " + path.string() + " is not that of a sweep; take another folder.");
    if (old.value("schema", json()) != fresh["schema"])
        throw std::runtime_error("The file " + path.string() +
                                 " is of another version of the sample engine; take another folder.");
    for (const char* key : {"quick", "rounds", "size", "rows", "ablation"})
        if (old.value(key, json()) != fresh[key])
            throw std::runtime_error("The file " + path.string() +
                                     " is of a sweep with other arguments; take another folder.");
    return old;
}

struct Task {
    std::string backend;
    std::string scene;
    std::string camera;
    bool isPlain = false; // without what effects are for

    std::string name() const { return fs::path(scene).stem().string() + (isPlain ? "-plain" : ""); }
};

json& backendOf(json& results, const std::string& name) {
    for (json& backend : results["backends"])
        if (backend["backend"] == name)
            return backend;
    results["backends"].push_back({{"backend", name}, {"scenes", json::array()}});
    return results["backends"].back();
}

bool isDone(json& results, const Task& task) {
    for (const json& scene : backendOf(results, task.backend)["scenes"])
        if (scene.value("name", "") == task.name()) {
            if (scene.value("camera", "") != task.camera)
                throw std::runtime_error("The sweep holds " + task.name() +
                                         " as another camera sees it; take another folder.");
            return true;
        }
    return false;
}

// "scene" or "scene@ex,ey,ez,tx,ty,tz,fov".
Task parseTask(const std::string& backend, const std::string& text, bool isPlain = false) {
    const size_t at = text.rfind('@');
    if (at == std::string::npos || fs::exists(text)) // paths may hold one
        return {backend, text, "", isPlain};
    return {backend, text.substr(0, at), text.substr(at + 1), isPlain};
}

const char* passTimes(uint32_t source) {
    return source == AGAA_TIME_DEVICE ? "device" : source == AGAA_TIME_CPU_FINISH ? "cpu-finish" : "none";
}

class Sweep {
public:
    Sweep(const SweepArguments& arguments) : arguments_(arguments), out_(arguments.out) {
        fs::create_directories(out_ / "images");
        rows_ = arguments.rows.empty() ? sweepRows(arguments.quick) : namedSweepRows(arguments.rows);
        results_ = readResults(out_ / "results.json", {{"schema", 3},
                                                       {"quick", arguments.quick},
                                                       {"rounds", options({}).rounds},
                                                       {"size", arguments.size},
                                                       {"rows", arguments.rows},
                                                       {"ablation", !arguments.noAblation},
                                                       {"backends", json::array()}});
        for (const std::string& scene : arguments.scenes)
            for (const std::string& backend : arguments.backends)
                tasks_.push_back(parseTask(backend, scene));
        for (const std::string& scene : arguments.plain)
            for (const std::string& backend : arguments.backends)
                tasks_.push_back(parseTask(backend, scene, true));
    }

    json run() {
        begin_ = std::chrono::steady_clock::now();
        for (size_t i = 0; i < tasks_.size(); ++i) {
            if (isDone(results_, tasks_[i])) {
                ++skipped_;
                continue;
            }
            if (tasks_[i].name() != referencesOf_) {
                references_ = {};
                referencesOf_ = tasks_[i].name();
            }
            measure(tasks_[i], i);
            writeJson(out_ / "results.json", results_);
        }
        return results_;
    }

private:
    SweepOptions options(const Task& task) const {
        SweepOptions options = sweepOptions(arguments_.quick, task.isPlain, arguments_.rounds);
        options.jpegQuality = arguments_.jpegQuality;
        options.effectsOfRows = !arguments_.rows.empty() && !task.isPlain;
        options.ablation = !arguments_.noAblation;
        // Mesa leaves what another program had for a sampler in the places of texel buffers, and compiles a pass that
        // reads materials from such anew for it.
        options.untimedFrames = task.backend == "gl" ? 1 : 0;
        return options;
    }

    void measure(const Task& task, size_t index) {
        RenderArguments a;
        a.device.backend = task.backend;
        a.device.noValidation = true; // measured are drivers, not the layers above them
        a.device.keptViews = 64;
        a.scene = task.scene;
        a.camera = task.camera;
        a.plan.size = arguments_.size;
        const Configuration configuration(a.plan);
        Scene scene = loadSceneArgument(a.scene);
        if (task.isPlain) {
            a.without = {"specular", "emissive", "ambient", "shadows"};
            for (Material& material : scene.materials)
                material.normalTexture = -1;
        }
        const RenderSettings settings = renderSettings(a, configuration, scene);
        const auto renderer = makeRenderer(a.device);
        claimDevice(task.backend, renderer->caps());
        renderer->load(scene);
        const std::string name = task.name();
        const std::vector<SweepRow> rows = task.isPlain ? namedSweepRows({"agaa-8-2"}) : rows_;
        SceneSweep sweep(*renderer, scene, settings, options(task), rows, references_,
                         out_ / "images", task.backend + "-" + name,
                         [&](const std::string& step, uint32_t done, uint32_t of) {
                             tell(task, name, step, double(index) + double(done) / of);
                         });
        json result = sweep.run();
        result["name"] = name;
        result["build"] = AGAA_BUILD_NAME;
        result["camera"] = task.camera;
        result["plain"] = task.isPlain;
        json& backend = backendOf(results_, task.backend);
        backend["passTimes"] = passTimes(sweep.timeSource());
        backend["scenes"].push_back(std::move(result));
    }

    // Times of a backend are compared with each other: all are of one device and driver.
    void claimDevice(const std::string& name, const AgaaDeviceCaps& caps) {
        json& backend = backendOf(results_, name);
        for (const auto& [key, here] : {std::pair{"device", caps.deviceName}, {"driver", caps.driverName}}) {
            const std::string kept = backend.emplace(key, here).first.value();
            if (kept != here)
                throw std::runtime_error("The sweep holds " + name + " of the " + key + " \"" + kept +
                                         "\", and this is \"" + here + "\"; take another folder.");
        }
    }

    void tell(const Task& task, const std::string& name, const std::string& step, double done) const {
        const double elapsed =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
        const double worked = done - double(skipped_);
        std::fprintf(stderr, "%s %s: %s", task.backend.c_str(), name.c_str(), step.c_str());
        if (worked > 0.05)
            std::fprintf(stderr, ", %.0f s left", elapsed * (double(tasks_.size()) - done) / worked);
        std::fprintf(stderr, "\n");
    }

    const SweepArguments& arguments_;
    fs::path out_;
    std::vector<SweepRow> rows_;
    json results_;
    std::vector<Task> tasks_;
    SceneReferences references_; // of the scene that was measured last
    std::string referencesOf_; // its name
    size_t skipped_ = 0;
    std::chrono::steady_clock::time_point begin_;
};

void writeReport(const fs::path& out) {
    const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
    const std::string script = (prefix / "share/agaa/report/sweep_report.py").string();
    const std::string command = "python3 '" + script + "' '" + (out / "results.json").string() + "' '" +
                                (out / "report.html").string() + "'";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("The page was not written; results.json is whole. The command was: " + command);
}

// names: by which results and images are told apart; those of earlier options stay.
void checkScenes(const std::string& option, const std::vector<std::string>& scenes, bool arePlain,
                 std::set<std::string>& names) {
    for (const std::string& text : scenes) {
        const Task task = parseTask("", text, arePlain);
        if (!names.insert(task.name()).second)
            throw BadArgument(option + " names a second scene called \"" + task.name() +
                              "\"; sweep them into two folders.");
        if (!task.camera.empty())
            parseCamera(task.camera);
        if (!makeBuiltinScene(task.scene) && !fs::exists(task.scene))
            throw BadArgument(option + " names \"" + task.scene + "\", which is neither built in nor a file.");
    }
}

void setDefaults(SweepArguments& arguments) {
    if (arguments.scenes.empty())
        arguments.scenes = arguments.quick ? std::vector<std::string>{"bamboo", "metal"}
                                           : std::vector<std::string>{"bamboo", "foliage", "furball", "metal", "city"};
    if (arguments.size.empty())
        arguments.size = arguments.quick ? "320x180" : "640x360";
}

} // namespace

void addSweepOptions(CLI::App& command, SweepArguments& arguments) {
    command.add_option("--scene", arguments.scenes,
                      "built-in scenes, .gltf or .glb; @ex,ey,ez,tx,ty,tz,fovDegrees after it sets the camera");
    command.add_option("--plain", arguments.plain,
                      "also what effects cost where nothing calls for them: such a scene without highlights, emission, "
                      "ambient light, shadows and normal maps; repeatable");
    command.add_option("--backend", arguments.backends, "vk, gl");
    command.add_option("--out", arguments.out, "folder; a sweep that it holds is gone on with");
    command.add_option("--size", arguments.size, "WxH");
    command.add_option("--row", arguments.rows, "only these of a full sweep, such as agaa-8-2; repeatable");
    command.add_option("--rounds", arguments.rounds, "frames of each row, which take turns: 7; 101 suits a GPU")
        ->check(CLI::Range(1u, 10000u));
    command.add_flag("--no-ablation", arguments.noAblation, "not what each effect costs and removes");
    command.add_option("--jpeg", arguments.jpegQuality, "images as JPEG of this quality, 1 to 100, not as PNG")
        ->check(CLI::Range(1u, 100u));
    command.add_flag("--quick", arguments.quick, "two scenes, few rows, 320x180: minutes, not hours");
}

void runSweep(SweepArguments arguments, bool asJson) {
    setDefaults(arguments);
    for (const std::string& backend : arguments.backends)
        requireBackend(backend);
    parseSize(arguments.size);
    try {
        namedSweepRows(arguments.rows);
    } catch (const std::invalid_argument& error) {
        throw BadArgument(std::string("--row: ") + error.what());
    }
    if (arguments.out.find('\'') != std::string::npos)
        throw BadArgument("--out must not hold a quotation mark.");
    if (arguments.noAblation && !arguments.plain.empty())
        throw BadArgument("--plain is for the ablation, which --no-ablation leaves out.");
    std::set<std::string> names;
    checkScenes("--scene", arguments.scenes, false, names);
    checkScenes("--plain", arguments.plain, true, names);
    const json results = Sweep(arguments).run();
    writeReport(arguments.out);
    if (asJson)
        std::cout << json{{"results", (fs::path(arguments.out) / "results.json").string()},
                          {"report", (fs::path(arguments.out) / "report.html").string()}}
                         .dump(2)
                  << '\n';
    else
        std::printf("Wrote %s/report.html\n", arguments.out.c_str());
}

} // namespace harness
