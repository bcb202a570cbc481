#include "sweep/command.h"

#include "build_name.h"

#include "cli/commands.h"
#include "scene/builtin.h"
#include "sweep/scene_sweep.h"

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

// Replaces the file atomically, so that an interrupted sweep leaves a complete one.
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

// Returns the results of an earlier run, or `fresh` if there is none. Throws if that run had other arguments.
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
    bool isPlain = false; // a scene that needs no effect

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

// Parses "scene" or "scene@ex,ey,ez,tx,ty,tz,fov".
Task parseTask(const std::string& backend, const std::string& text, bool isPlain = false) {
    const size_t at = text.rfind('@');
    if (at == std::string::npos || fs::exists(text)) // a path may contain an "@"
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
            if (tasks_[i].name() != referenceScene_) {
                references_ = {};
                referenceScene_ = tasks_[i].name();
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
        // Mesa keeps the sampler state of an earlier program at the bindings of texel buffers. If it changed, Mesa
        // recompiles passes that read materials from such buffers.
        options.untimedFrames = task.backend == "gl" ? 1 : 0;
        return options;
    }

    void measure(const Task& task, size_t index) {
        RenderArguments a;
        a.device.backend = task.backend;
        a.device.noValidation = true; // the drivers are measured, not the layers above them
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
        SceneSweep sweep(*renderer, scene, settings, options(task), rows, references_, out_ / "images",
                         task.backend + "-" + name, [&](const std::string& step, uint32_t done, uint32_t total) {
                             reportProgress(task, name, step, double(index) + double(done) / total);
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

    // Records the device and driver of a backend. Throws if the results have others: their times are compared.
    void claimDevice(const std::string& name, const AgaaDeviceCaps& caps) {
        json& backend = backendOf(results_, name);
        for (const auto& [key, current] : {std::pair{"device", caps.deviceName}, {"driver", caps.driverName}}) {
            const std::string kept = backend.emplace(key, current).first.value();
            if (kept != current)
                throw std::runtime_error("The sweep holds " + name + " of the " + key + " \"" + kept +
                                         "\", and this is \"" + current + "\"; take another folder.");
        }
    }

    // done: completed tasks, with the fraction of the current one.
    void reportProgress(const Task& task, const std::string& name, const std::string& step, double done) const {
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
        const double measured = done - double(skipped_);
        std::fprintf(stderr, "%s %s: %s", task.backend.c_str(), name.c_str(), step.c_str());
        if (measured > 0.05)
            std::fprintf(stderr, ", %.0f s left", elapsed * (double(tasks_.size()) - done) / measured);
        std::fprintf(stderr, "\n");
    }

    const SweepArguments& arguments_;
    fs::path out_;
    std::vector<SweepRow> rows_;
    json results_;
    std::vector<Task> tasks_;
    SceneReferences references_; // reference images of referenceScene_
    std::string referenceScene_; // the name of the scene that was measured last
    size_t skipped_ = 0;
    std::chrono::steady_clock::time_point begin_;
};

void writeReport(const fs::path& out) {
    const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
    const std::string script = (prefix / "share/agaa/report/sweep_report.py").string();
    const std::string command =
        "python3 '" + script + "' '" + (out / "results.json").string() + "' '" + (out / "report.html").string() + "'";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("The page was not written; results.json is whole. The command was: " + command);
}

// Adds the names of the scenes to `names`, which identify results and images. Throws if a name is taken or a scene is
// unknown.
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
