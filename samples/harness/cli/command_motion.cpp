// motion: views of a moving scene beside each other, against a reference of each frame.
#include "cli/commands.h"
#include "cli/plan_options.h"
#include "render/fragment_capacity.h"
#include "render/motion_error.h"
#include "render/quantiles.h"
#include "render/reference.h"
#include "render/view_key.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <deque>
#include <filesystem>
#include <iostream>
#include <map>

namespace harness {

using nlohmann::json;

namespace {

struct Row {
    Row(std::string options, const PlanArguments& plan, std::optional<uint32_t> since)
        : options(std::move(options)), configuration(plan), meter(since) {}

    std::string options;
    Configuration configuration;
    RenderSettings settings;
    MotionErrorMeter meter;
    std::vector<double> frameMs;
    double bytesPerPixel = 0;
};

// Parses the options of a row. All rows have the base's scene, size and device.
PlanArguments parseRow(const std::string& options, const PlanArguments& base) {
    PlanArguments plan;
    CLI::App app;
    addPlanOptions(app, plan);
    addShadingOptions(app, plan);
    try {
        app.parse(options);
    } catch (const CLI::ParseError& error) {
        throw BadArgument("--row \"" + options + "\": " + error.what());
    }
    for (const char* option : {"--size", "--brdf"})
        if (app.count(option) > 0)
            throw BadArgument("--row \"" + options + "\": all rows and the reference have the same " + (option + 2) +
                              ".");
    plan.size = base.size;
    return plan;
}

// Throws if two rows would share a view of the SDK, and with it their history.
void requireOwnViews(const std::deque<Row>& rows) {
    std::map<std::string, std::string> known; // options by key
    for (const Row& row : rows) {
        AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
        desc.config = &row.settings.config;
        desc.facts = &row.settings.facts;
        desc.flags = row.settings.vertexPulling ? AGAA_VIEW_VERTEX_PULLING : 0;
        const auto [other, isNew] = known.emplace(viewKey(desc), row.options);
        if (!isNew)
            throw BadArgument("--row \"" + row.options + "\" has the view of --row \"" + other->second +
                              "\"; rows must differ in more than their jitter.");
    }
}

class MotionRun {
public:
    explicit MotionRun(const MotionArguments& arguments) : arguments_(arguments) {
        scene_ = loadSceneArgument(arguments.base.scene);
        const Scene still = scene_; // some motions add an object
        for (const std::string& options : arguments.rows) {
            RenderArguments view = arguments.base;
            view.plan = parseRow(options, arguments.base.plan);
            Row& row = rows_.emplace_back(options, view.plan, since());
            row.settings = renderSettings(view, row.configuration, still);
        }
        const std::shared_ptr<const Motion> motion = sceneMotion(arguments.motion, scene_, rows_.front().settings);
        reference_ = renderSettings(arguments.base, Configuration(arguments.base.plan), still);
        reference_.config = TechniqueConfig(); // the configuration above is gone
        reference_.facts = sceneFacts(scene_, reference_.lights);
        reference_.motion = motion;
        for (Row& row : rows_) {
            row.settings.facts = sceneFacts(scene_, row.settings.lights);
            row.settings.motion = motion;
            row.settings.frames = 1;
        }
        requireOwnViews(rows_);
        DeviceArguments device = arguments.base.device;
        device.noValidation = true; // drivers are measured, not the layers above them
        device.keptViews = uint32_t(rows_.size()) + 2;
        renderer_ = makeRenderer(device);
        renderer_->load(scene_);
        for (Row& row : rows_)
            if (row.configuration.fitsFragmentCapacity)
                fitFragmentCapacity(*renderer_, row.settings);
    }

    json run() {
        for (uint32_t frame = 0; frame < arguments_.frames; ++frame) {
            measureFrame(frame);
            std::fprintf(stderr, "%s: frame %u of %u\n", arguments_.motion.c_str(), frame + 1, arguments_.frames);
        }
        json rows = json::array();
        for (const Row& row : rows_)
            rows.push_back(rowJson(row));
        const double frames = arguments_.frames;
        return {{"device", renderer_->caps().deviceName},
                {"driver", renderer_->caps().driverName},
                {"backend", arguments_.base.device.backend},
                {"scene", arguments_.base.scene},
                {"motion", arguments_.motion},
                {"size", arguments_.base.plan.size},
                {"frames", arguments_.frames},
                {"spp", arguments_.spp},
                {"referenceMseTm", noise_ / frames},
                {"disoccluded", disoccluded_ / frames},
                {"rows", rows}};
    }

private:
    std::optional<uint32_t> since() const {
        return arguments_.motion == "light" ? std::optional(switchedOnFrame - 1) : std::nullopt;
    }

    void measureFrame(uint32_t frame) {
        RenderSettings settings = reference_;
        settings.firstFrame = frame;
        const MotionImage motion = renderMotion(*renderer_, settings);
        disocclusion_.add(motion);
        disoccluded_ += disocclusion_.share();
        settings.config = TechniqueConfig();
        settings.ditherFrame = 1 + frame; // references that share random numbers would seem to have a bias
        const Reference reference = renderReference(*renderer_, settings, arguments_.spp);
        noise_ += reference.splitHalfMseTm;
        writeFrame("reference", frame, reference.image);
        for (size_t i = 0; i < rows_.size(); ++i) {
            const size_t at = frame % 2 ? rows_.size() - 1 - i : i;
            Row& row = rows_[at];
            row.settings.firstFrame = frame;
            const RenderResult result = renderer_->render(row.settings);
            row.frameMs.push_back(result.frameMs.back());
            row.bytesPerPixel = result.memory.bytesPerPixel;
            row.meter.add(result.image, reference.image, motion, disocclusion_);
            writeFrame("row" + std::to_string(at), frame, result.image);
        }
    }

    void writeFrame(const std::string& name, uint32_t frame, const Image& image) const {
        if (arguments_.images.empty())
            return;
        const std::filesystem::path folder = std::filesystem::path(arguments_.images) / name;
        std::filesystem::create_directories(folder);
        writePng(folder / (std::to_string(1000 + frame).substr(1) + ".png"), image);
    }

    json rowJson(const Row& row) const {
        const MotionError error = row.meter.result();
        json out = {{"options", row.options},
                    {"frameMs", quantile(row.frameMs, 0.5)},
                    {"bytesPerPixel", row.bytesPerPixel},
                    {"error", error.error},
                    {"flicker", error.flicker},
                    {"ghosting", nullptr},
                    {"sharpness", error.sharpness},
                    {"errors", error.frames}};
        if (error.ghosting)
            out["ghosting"] = *error.ghosting;
        if (since())
            out["response"] = error.response;
        return out;
    }

    const MotionArguments& arguments_;
    Scene scene_;
    std::deque<Row> rows_; // a Configuration does not move
    RenderSettings reference_;
    std::unique_ptr<Renderer> renderer_;
    Disocclusion disocclusion_;
    double noise_ = 0, disoccluded_ = 0; // sums over frames
};

} // namespace

void runMotion(const MotionArguments& arguments, bool asJson) {
    requireBackend(arguments.base.device.backend);
    if (arguments.motion == "light" && arguments.frames <= switchedOnFrame)
        throw BadArgument("--frames must be more than " + std::to_string(switchedOnFrame) +
                          ", because the light is dark before.");
    const json out = MotionRun(arguments).run();
    if (asJson) {
        std::cout << out.dump(2) << '\n';
        return;
    }
    std::printf("%s, %s, %s: %.1f %% of the pixels show surfaces that were hidden within 8 frames\n",
                arguments.base.scene.c_str(), arguments.motion.c_str(), out["device"].get<std::string>().c_str(),
                100 * out["disoccluded"].get<double>());
    std::printf("%10s %10s %10s %10s %10s  view\n", "error", "flicker", "ghosting", "sharpness", "ms");
    for (const json& row : out["rows"])
        std::printf("%10.3g %10.3g %10.3g %10.3f %10.1f  %s\n", row["error"].get<double>(),
                    row["flicker"].get<double>(), row["ghosting"].is_null() ? 0 : row["ghosting"].get<double>(),
                    row["sharpness"].get<double>(), row["frameMs"].get<double>(),
                    row["options"].get<std::string>().c_str());
}

} // namespace harness
